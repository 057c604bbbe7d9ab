"""Stability limits of fixed-step methods, from the stiffness and damping of small motions.

The linearised motion is M a = -K x - C v. k and c are these matrices in mass-normalised coordinates,
projected on a few motions. Each method has its own rule for the largest stable step.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..engine.tables import Tableau

Floats = NDArray[np.float64]
"""An array of floats of any shape."""

# Unless noted, doubling or halving one of these numbers fails no test.
_GROWTH = 0.5
"""Growth rate of a motion, 1/s, that is tolerated: with some Runge-Kutta methods, such as those of order 2,
undamped motions grow very slowly at any step. At 0, `test_a_row_brings_its_own_limit` fails."""

_GROWS = 1.001
"""Modulus of an eigenvalue of a step above which the step is unstable. At 1, `test_limit_of_a_row` fails."""
_NEAR = 2e-3
"""Relative accuracy of the limit, and distance from it at which the eigenvalues are checked."""
_MOTIONS = 12
"""Number of motions considered, fastest first, where the eigenvalues of the whole step decide."""
_SHORTER = 0.9
"""Ratio of successive step lengths tried until one is stable, or until one is not."""
_SHORTEST = 0.05
"""Smallest step tried, as a fraction of the limit from real eigenvalues; the inverse bounds the largest."""


@dataclass(frozen=True)
class StabilityLimit:
    """The rule that gives a method's limit from k and c.

    Attributes:
        damping: weight of dt c relative to dt² k, exactly or approximately, in the rule.
        solve: takes k (n, n), 1/s², and c (n, n), 1/s. Returns the limit, s, infinite if there is none, and
            the motion (n,) that sets it, which may be complex: its real and imaginary parts then alternate.
    """

    damping: float
    solve: Callable[[Floats, Floats], tuple[float, Floats]]


def period_doubling_limit(weight: float, step: Callable[[Floats, Floats], Floats]) -> StabilityLimit:
    """Return the rule for methods that become unstable at an eigenvalue -1, where (dt² k + weight dt c) y = 4
    y.

    This is exact where k and c are symmetric. Damping in a moving body, friction and the tutorial's law make
    them unsymmetric. A pair of complex eigenvalues may then leave the unit circle near -1, so the eigenvalues
    of the whole step decide. Only those with a negative real part count: motions resolved with more than four
    steps per period grow at their own physical rate. Where the fast vibrations are physically unstable too,
    twice their growth is allowed.

    Args:
        weight: see above.
        step: the matrix of a step as a function of dt² k and dt c.
    """

    def solve(k: Floats, c: Floats) -> tuple[float, Floats]:
        # With s = 1/dt, s² y = s (weight c / 4) y + (k / 4) y gives the eigenvalues of a companion matrix.
        n = len(k)
        companion = np.block([[np.zeros((n, n)), np.eye(n)], [k / 4.0, weight * c / 4.0]])
        values, vectors = np.linalg.eig(companion)
        best = int(np.argmax(np.real(values)))
        # Below this there is no restoring force: any step is stable.
        if not np.real(values[best]) > 1e-5:
            return np.inf, np.zeros(n)
        limit = 1.0 / float(np.real(values[best]))
        flips = abs(np.imag(values[best])) <= 1e-6 * abs(values[best])
        single = np.real(vectors[:n, best])
        # Slower motions leave the unit circle later, so the first few candidates suffice.
        first = vectors[:n, np.argsort(-np.real(values))[:_MOTIONS]]
        basis, sizes, _ = np.linalg.svd(np.hstack([np.real(first), np.imag(first)]), full_matrices=False)
        basis = basis[:, sizes > 1e-6 * sizes[0]]
        k, c, own = basis.T @ k @ basis, basis.T @ c @ basis, 0.0

        def grows(h: float) -> bool:
            return _fastest(np.linalg.eigvals(step(h * h * k, h * c))) > _GROWS * np.exp(2.0 * own * h)

        below, above = (1.0 - _NEAR) * limit, (1.0 + _NEAR) * limit
        if flips and not grows(below):
            return limit, single
        own = _own_growth(k, c)
        while grows(below) and below > _SHORTEST * limit:
            below, above = _SHORTER * below, below
        while not grows(above):
            below, above = above, above / _SHORTER
            if above > limit / _SHORTEST:
                return np.inf, np.zeros(n)
        while above > (1.0 + _NEAR) * below:
            middle = float(np.sqrt(below * above))
            below, above = (below, middle) if grows(middle) else (middle, above)
        values, vectors = np.linalg.eig(step(above * above * k, above * c))
        worst = int(np.argmax(np.where(np.real(values) < 0.0, np.abs(values), 0.0)))
        return float(np.sqrt(below * above)), basis @ vectors[: len(k), worst]

    return StabilityLimit(weight, solve)


def euler_step(k: Floats, c: Floats) -> Floats:
    """Return the matrix of a step of symplectic Euler on (x, dt v), from dt² k and dt c."""
    eye = np.eye(len(k))
    return np.block([[eye - k, eye - c], [-k, eye - c]])


def verlet_step(k: Floats, c: Floats) -> Floats:
    """Return the matrix of a step of velocity Verlet on (x, dt v, dt² a): a is for v + dt a."""
    eye, zero = np.eye(len(k)), np.zeros_like(k)
    place = np.hstack([eye, eye, 0.5 * eye])
    force = -k @ place - c @ np.hstack([zero, eye, eye])
    return np.vstack([place, np.hstack([zero, eye, 0.5 * eye]) + 0.5 * force, force])


def undamped_step(k: Floats, c: Floats) -> Floats:
    """Return `euler_step` of the same motion without damping."""
    return euler_step(k, np.zeros_like(c))


def _fastest(values: NDArray[np.inexact]) -> float:
    """Return the largest modulus of the eigenvalues of a step with a negative real part."""
    return float(np.abs(values[np.real(values) < 0.0]).max(initial=0.0))


def _own_growth(k: Floats, c: Floats) -> float:
    """Return the rate, 1/s, at which the fast vibrations grow physically, independent of the step."""
    n = len(k)
    values = np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [-k, -c]]))
    fast = (np.abs(values) > 0.5 * np.abs(values).max()) & (np.imag(values) != 0.0)
    return float(np.real(values[fast]).max(initial=0.0))


def runge_kutta(table: Tableau) -> StabilityLimit:
    """Return the rule of explicit Runge-Kutta methods: |R(dt lambda)| <= 1 where (lambda² + lambda c + k) y =
    0."""
    terms = stability_polynomial(table)

    def solve(k: Floats, c: Floats) -> tuple[float, Floats]:
        n = len(k)
        values, vectors = np.linalg.eig(np.block([[np.zeros((n, n)), np.eye(n)], [-k, -c]]))
        # Physically growing motions, as in a buckling rod, do not limit the step.
        values = np.minimum(np.real(values), 0.0) + 1j * np.imag(values)
        sizes = np.abs(values)
        if not sizes.max() > 1e-5:
            return np.inf, np.zeros(n)
        best, limit = -1, np.inf
        # The stability boundary is about equally far from zero in all directions, so slow motions do not
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
    """Return the (stages + 1,) coefficients of R(z) = 1 + sum z^k b A^(k-1) 1 of an explicit method, constant
    first."""
    stages = table.stages
    a, b = table.a[:stages, :stages], table.a[stages, :stages]
    terms, power = [1.0], np.ones(stages)
    for _ in range(stages):
        terms.append(float(b @ power))
        power = a @ power
    return np.array(terms)


def _last_crossing(terms: NDArray[np.complex128], growth: float) -> float:
    """Return the largest h > 0 at which a polynomial p with p(0) = 1 has |p(h)|² = 1 + 2 growth h.

    It is 0 if |p| is larger everywhere.
    """
    size = np.polynomial.polynomial.polymul(terms, terms.conj()).real
    size[1] -= 2.0 * growth
    # The roots of |p(h)|² - 1 - 2 growth h other than h = 0.
    roots = np.polynomial.polynomial.polyroots(size[1:])
    real = roots.real[(np.abs(roots.imag) <= 1e-6 * np.abs(roots)) & (roots.real > 0.0)]
    return float(real.max()) if real.size else 0.0
