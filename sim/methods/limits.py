"""Stability limits of methods with a fixed step, from the stiffness and damping of small motions.

The linearised motion is M a = -K x - C v. k and c are these matrices in coordinates in which the mass matrix
is the unit matrix, projected on a few motions. Each method has its own rule for the largest stable step.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..kernels.core.tables import Tableau

Floats = NDArray[np.float64]
"""An array of floats of any shape."""

_GROWTH = 0.5
"""Growth rate of a motion, 1/s, that does not count as unstable: with some Runge-Kutta methods, such as those
of order 2, undamped motions grow very slowly at any step."""


@dataclass(frozen=True)
class StabilityLimit:
    """The rule by which a method's limit follows from k and c.

    Attributes:
        damping: weight of dt c relative to dt² k, exactly or approximately, in the rule.
        solve: takes k (n, n), 1/s², and c (n, n), 1/s. Returns the limit, s, which is infinite if there is
            none, and the motion (n,) that sets it.
    """

    damping: float
    solve: Callable[[Floats, Floats], tuple[float, Floats]]


def flip(weight: float) -> StabilityLimit:
    """The rule of methods that become unstable at an eigenvalue -1, where (dt² k + weight dt c) y = 4 y."""

    def solve(k: Floats, c: Floats) -> tuple[float, Floats]:
        # With s = 1/dt it is s² y = s (weight c / 4) y + (k / 4) y, the eigenvalues of a companion matrix.
        n = len(k)
        companion = np.block([[np.zeros((n, n)), np.eye(n)], [k / 4.0, weight * c / 4.0]])
        values, vectors = np.linalg.eig(companion)
        real = np.where(np.abs(np.imag(values)) <= 1e-6 * np.abs(values), np.real(values), 0.0)
        best = int(np.argmax(real))
        # Below this, nothing pulls: any step is stable.
        if not real[best] > 1e-5:
            return np.inf, np.zeros(n)
        return 1.0 / float(real[best]), np.real(vectors[:n, best])

    return StabilityLimit(weight, solve)


def runge_kutta(table: Tableau) -> StabilityLimit:
    """The rule of explicit Runge-Kutta methods: |R(dt lambda)| <= 1 where (lambda² + lambda c + k) y = 0."""
    terms = stability_polynomial(table)

    def solve(k: Floats, c: Floats) -> tuple[float, Floats]:
        n = len(k)
        values, vectors = np.linalg.eig(np.block([[np.zeros((n, n)), np.eye(n)], [-k, -c]]))
        # Motions that grow by themselves, as in a buckling rod, do not limit the step.
        values = np.minimum(np.real(values), 0.0) + 1j * np.imag(values)
        sizes = np.abs(values)
        if not sizes.max() > 1e-5:
            return np.inf, np.zeros(n)
        best, limit = -1, np.inf
        # The border of stability is about equally far from zero in all directions, so slow motions do not
        # matter.
        for i in np.flatnonzero(sizes > 0.5 * sizes.max()).tolist():
            size = float(sizes[i])
            direction = terms * (values[i] / size) ** np.arange(len(terms))
            step, lenient = (_last_crossing(direction, growth / size) / size for growth in (0.0, _GROWTH))
            step = step if step > 0.5 * lenient else lenient
            if step < limit:
                best, limit = i, step
        mode = vectors[:n, best] if best >= 0 else np.zeros(n)
        return limit, np.real(mode) + np.imag(mode)

    return StabilityLimit(2.0, solve)


def stability_polynomial(table: Tableau) -> Floats:
    """(stages + 1,) coefficients of R(z) = 1 + sum z^k b A^(k-1) 1 of an explicit method, constant first."""
    stages = table.stages
    a, b = table.a[:stages, :stages], table.a[stages, :stages]
    terms, power = [1.0], np.ones(stages)
    for _ in range(stages):
        terms.append(float(b @ power))
        power = a @ power
    return np.array(terms)


def _last_crossing(terms: NDArray[np.complex128], growth: float) -> float:
    """The largest h > 0 at which a polynomial p with p(0) = 1 has |p(h)|² = 1 + 2 growth h.

    It is 0 if |p| is larger everywhere.
    """
    size = np.polynomial.polynomial.polymul(terms, terms.conj()).real
    size[1] -= 2.0 * growth
    # The roots of |p(h)|² - 1 - 2 growth h but for h = 0.
    roots = np.polynomial.polynomial.polyroots(size[1:])
    real = roots.real[(np.abs(roots.imag) <= 1e-6 * np.abs(roots)) & (roots.real > 0.0)]
    return float(real.max()) if real.size else 0.0
