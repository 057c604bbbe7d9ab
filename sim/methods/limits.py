"""The stability limits of methods with a fixed step, from the stiffness and damping of small motions.

Linearised, M a = -K x - C v. In coordinates in which the mass matrix is one, and projected on a few motions:
k and c. Each method has a rule of its own for the largest stable step that follows from them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..kernels.core.tables import Tableau

Floats = NDArray[np.float64]

_GROWTH = 0.5
"""Growth of a motion, 1/s, that nobody would call unstable: methods such as Runge-Kutta's of second order let
every undamped motion grow by next to nothing, whatever the step."""


@dataclass(frozen=True)
class StabilityLimit:
    """How the limit of a method follows from k and c.

    Attributes:
        damping: weight of dt c beside dt² k in what is most of the limit.
        solve: from (n, n) k, 1/s², and c, 1/s: the limit, s, infinite where there is none; and the motion
            that sets it, (n,).
    """

    damping: float
    solve: Callable[[Floats, Floats], tuple[float, Floats]]


def flip(weight: float) -> StabilityLimit:
    """Of methods whose limit is an eigenvalue -1, where (dt² k + weight dt c) y = 4 y."""

    def solve(k: Floats, c: Floats) -> tuple[float, Floats]:
        # With s = 1/dt it is s² y = s (weight c / 4) y + (k / 4) y, the eigenvalues of a companion matrix.
        n = len(k)
        companion = np.block([[np.zeros((n, n)), np.eye(n)], [k / 4.0, weight * c / 4.0]])
        values, vectors = np.linalg.eig(companion)
        real = np.where(np.abs(np.imag(values)) <= 1e-6 * np.abs(values), np.real(values), 0.0)
        best = int(np.argmax(real))
        # Below this, nothing pulls: the step could be a day.
        if not real[best] > 1e-5:
            return np.inf, np.zeros(n)
        return 1.0 / float(real[best]), np.real(vectors[:n, best])

    return StabilityLimit(weight, solve)


def runge_kutta(table: Tableau) -> StabilityLimit:
    """Of explicit Runge-Kutta methods: |R(dt lambda)| <= 1 where (lambda² + lambda c + k) y = 0."""
    terms = stability_polynomial(table)

    def solve(k: Floats, c: Floats) -> tuple[float, Floats]:
        n = len(k)
        values, vectors = np.linalg.eig(np.block([[np.zeros((n, n)), np.eye(n)], [-k, -c]]))
        # What grows of itself, as a rod that buckles, is no matter of the step.
        values = np.minimum(np.real(values), 0.0) + 1j * np.imag(values)
        sizes = np.abs(values)
        if not sizes.max() > 1e-5:
            return np.inf, np.zeros(n)
        best, limit = -1, np.inf
        # The border is nearly as far from zero in all directions, so that slow motions cannot set the limit.
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
    """(stages + 1,) R(z) = 1 + sum z^k b A^(k-1) 1 of an explicit Runge-Kutta method, constant first."""
    stages = table.stages
    a, b = table.a[:stages, :stages], table.a[stages, :stages]
    terms, power = [1.0], np.ones(stages)
    for _ in range(stages):
        terms.append(float(b @ power))
        power = a @ power
    return np.array(terms)


def _last_crossing(terms: NDArray[np.complex128], growth: float) -> float:
    """The largest h > 0 at which a polynomial of h with p(0) = 1 has the size exp(growth h), or nearly so."""
    size = np.polynomial.polynomial.polymul(terms, terms.conj()).real
    size[1] -= 2.0 * growth
    roots = np.polynomial.polynomial.polyroots(size[1:])  # of |p(h)|² - 1 - 2 growth h, which is zero at zero
    real = roots.real[(np.abs(roots.imag) <= 1e-6 * np.abs(roots)) & (roots.real > 0.0)]
    return float(real.max()) if real.size else np.inf
