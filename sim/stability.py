"""How large a time step a method bears, estimated from the forces alone.

Linearised about the present state, M a = -K x - C v. What a step makes of that differs by method:

- A step of symplectic Euler has an eigenvalue -1, the border of stability, exactly when some w has
  (dt² K + 2 dt C) w = 4 M w. So the largest stable step is the one at which the largest eigenvalue of
  M^-1 (dt² K + 2 dt C) is 4; for one damped mode that is the textbook omega dt < 2 (sqrt(1 + zeta²) - zeta).
- Velocity Verlet as it is done here takes v + dt a for the velocities in the new forces. At an eigenvalue -1,
  v is zero and a is -4 x / dt², which gives (dt² K + 4 dt C) w = 4 M w: Euler's limit without damping, and a
  lower one with it, omega dt < 2 (sqrt(1 + 4 zeta²) - 2 zeta). No other eigenvalue leaves the circle before.
- Runge-Kutta 4 multiplies a motion exp(lambda t) by its stability polynomial R(dt lambda): a step is stable
  while |R| <= 1 for all lambda of lambda² + lambda M^-1 C + M^-1 K; without damping, omega dt < sqrt(8).
- Generalized-alpha bears any step in linear theory (Chung & Hulbert 1993): it has no limit. How far it can be
  trusted is a question of nonlinearity, of how far springs turn in a step.
- The stable spring is symplectic Euler on the tables that `weaken` makes for its step, and has that limit, of
  that body. The springs' part of dt² K is then M at most, and that of dt C, too; the joints' likewise while
  springs that are joined have the proportions of their rest lengths. So hardly any body has a limit.

K w and C w are differences of two evaluations of the kernels' forces, so any topology and law will do, and no
matrix is built: K and C are projected on a Krylov space (Arnoldi), and the small problem that is left is
solved as a quadratic eigenvalue problem in 1/dt, or in lambda.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from .kernels.controls import refresh
from .kernels.forces import spring_forces
from .kernels.tables import Floats, Live, Tableau
from .methods import METHODS
from .scene import Scene
from .system import System, build_system, new_live, new_work
from .weaken import weakened

Cause = Literal["linear stiffness", "angular stiffness", "linear damping", "air friction"]

_FIRST_SIZE, _SIZE = 40, 12
"""Dimension of the Krylov space at first, and later, when it starts from the stiffest motion found before."""


@dataclass(frozen=True)
class StabilityEstimate:
    """What `StabilityMeter.update` found.

    Attributes:
        limit: largest stable time step, s; infinite where nothing pulls.
        cause: what sets it, or None where nothing does.
    """

    limit: float
    cause: Cause | None


class StabilityMeter:
    """Follows the stability limit of a moving body under a method.

    The estimate concerns small motions about the present state. It approaches the true limit from above
    and is within a per cent of it. It is infinite where nothing pulls, and for methods that have no limit:
    those that choose their steps, and generalized-alpha.

    Args:
        system: the tables; under the stable spring, the weakened ones.
        method: as scenes have it.
    """

    def __init__(self, system: System, method: str) -> None:
        self._system = system
        self._law = _LIMITS.get(METHODS[method].kind) if not METHODS[method].adaptive else None
        self._table = METHODS[method].table
        self._probe = new_live(system)
        self._work = new_work(system)
        n = system.body.masses
        self._here = slice(1, n + 1)  # the places of the masses
        # Alternating signs are close to the stiffest mode of a chain, and no mode is orthogonal to noise.
        noise = np.random.default_rng(1).normal(size=(2, n))
        self._start = noise + 3.0 * (-1.0) ** np.arange(n)
        self._limit = 0.0

    def update(self, live: Live, air_friction: float) -> StabilityEstimate:
        """The limit at the state in `live` (which is only read).

        Args:
            live: the state; masses whose `dt_mass` is zero count as held.
            air_friction: kg/px.
        """
        if self._law is None:
            return StabilityEstimate(np.inf, None)
        body, probe = self._system.body, self._probe
        n = body.masses
        here = self._here
        weight = self._law.damping
        free = live.dt_mass[here] > 0.0
        for field in ("x", "y", "vx", "vy", "controls"):
            getattr(probe, field)[:] = getattr(live, field)
        refresh(body, probe)
        air = 2.0 * air_friction * np.abs(np.array([live.vx[here], live.vy[here]]))
        # In coordinates q = sqrt(M) w, in which K and C of a conservative law are symmetric.
        root = np.where(free, np.sqrt(self._system.inverse_mass), 0.0)
        size = min(_SIZE if self._limit else _FIRST_SIZE, 2 * int(free.sum()))
        basis, k_basis, c_basis = [], [], []
        q = self._start * free
        scale = self._limit or 1e-3
        for _ in range(size):
            for _ in range(2):  # twice is enough to be orthogonal to rounding
                for other in basis:
                    q = q - (other * q).sum() * other
            norm = float(np.sqrt((q * q).sum()))
            if not 1e-12 < norm < np.inf:
                break
            basis.append(q / norm)
            w = basis[-1] * root
            k_basis.append(self._product(live, w, velocities=False) * root)
            c_basis.append((self._product(live, w, velocities=True) + air * w) * root)
            q = scale * scale * k_basis[-1] + weight * scale * c_basis[-1]
            q = q / max(float(np.sqrt((q * q).sum())), 1e-300)
        if not basis:
            return StabilityEstimate(np.inf, None)
        flat = np.array(basis).reshape(len(basis), -1)
        k = flat @ np.array(k_basis).reshape(len(basis), -1).T
        c = flat @ np.array(c_basis).reshape(len(basis), -1).T
        if not (np.isfinite(k).all() and np.isfinite(c).all()):
            return StabilityEstimate(np.inf, None)
        limit, mode = self._law.solve(k, c, self._table)
        if limit == np.inf:
            return StabilityEstimate(np.inf, None)
        self._limit = limit
        self._start = (mode @ flat).reshape(2, n)
        return StabilityEstimate(limit, self._cause(live, self._start * root, limit, air))

    def _product(self, live: Live, w: Floats, velocities: bool) -> Floats:
        """K w, or C w without the air, as a difference of forces. The springs' damping is linear in v."""
        body, probe, work, here = self._system.body, self._probe, self._work, self._here
        if velocities and not (body.damped or body.twisted):
            return np.zeros_like(w)
        fields = (probe.vx, probe.vy) if velocities else (probe.x, probe.y)
        origin = (live.vx[here], live.vy[here]) if velocities else (live.x[here], live.y[here])
        # Small beside the springs, large beside the rounding of coordinates.
        size = 1e-6 * (1.0 + float(max(np.abs(live.x[here]).max(), np.abs(live.y[here]).max())))
        step = size / max(float(np.abs(w).max()), 1e-300)
        ends = []
        for sign in (1.0, -1.0):
            for field, start, direction in zip(fields, origin, w, strict=True):
                field[here] = start + sign * step * direction
            spring_forces(body, probe, work, probe.x, probe.y, probe.vx, probe.vy)
            ends.append(np.array([work.fx[here], work.fy[here]]))
        for field, start in zip(fields, origin, strict=True):
            field[here] = start
        return (ends[1] - ends[0]) / (2.0 * step)

    def _cause(self, live: Live, w: Floats, limit: float, air: Floats) -> Cause:
        """Which law contributes most to the stiffest motion."""
        assert self._law is not None
        probe, rate = self._probe, self._law.damping * limit
        whole = float((w * self._product(live, w, velocities=False)).sum())
        probe.couple_cos[:] = 0.0
        probe.couple_sin[:] = 0.0
        linear = float((w * self._product(live, w, velocities=False)).sum())
        parts: dict[Cause, float] = {
            "linear stiffness": limit * limit * linear,
            "angular stiffness": limit * limit * (whole - linear),
            "linear damping": rate * float((w * self._product(live, w, velocities=True)).sum()),
            "air friction": rate * float((w * air * w).sum()),
        }
        return max(parts, key=lambda cause: parts[cause])


def quick_limit(system: System) -> float:
    """A step (s) that symplectic Euler and Verlet nearly bear, at the cost of one look at each spring.

    It is 2 / omega with a bound of omega² by the rows of M^-1 K (Gershgorin), of a body without damping that
    is as long as its springs at rest and straight. Infinite where nothing pulls.
    """
    body = system.body
    pulls = np.zeros(body.masses + 1)
    stiffness = body.stiffness[: body.springs]
    for ends in (body.spring_a, body.spring_b):
        pulls += np.bincount(ends, 2.0 * stiffness, pulls.size)
        # A joint of two springs in line bends by x1 - 2 x2 + x3.
        for spring in (body.joint_a, body.joint_b):
            pulls += np.bincount(ends[spring], 4.0 * body.joint_stiffness, pulls.size)
    fastest = float((pulls[1:] * np.where(system.held, 0.0, system.inverse_mass)).max())
    return 2.0 / np.sqrt(fastest) if fastest > 0.0 else np.inf


def _flip(weight: float) -> Callable[[Floats, Floats, object], tuple[float, Floats]]:
    """For methods whose limit is an eigenvalue -1, where (dt² k + weight dt c) y = 4 y."""

    def solve(k: Floats, c: Floats, _: object) -> tuple[float, Floats]:
        """The smallest such dt > 0, and that y; infinite where there is none.

        With s = 1/dt it is s² y = s (weight c / 4) y + (k / 4) y, the eigenvalues of a companion matrix.
        """
        n = len(k)
        companion = np.block([[np.zeros((n, n)), np.eye(n)], [k / 4.0, weight * c / 4.0]])
        values, vectors = np.linalg.eig(companion)
        real = np.where(np.abs(np.imag(values)) <= 1e-6 * np.abs(values), np.real(values), 0.0)
        best = int(np.argmax(real))
        # Below this, nothing pulls: the step could be a day.
        if not real[best] > 1e-5:
            return np.inf, np.zeros(n)
        return 1.0 / float(real[best]), np.real(vectors[:n, best])

    return solve


def _polynomial(k: Floats, c: Floats, table: object) -> tuple[float, Floats]:
    """The largest dt with |R(dt lambda)| <= 1 for all lambda of (lambda² + lambda c + k) y = 0, and the y."""
    assert isinstance(table, Tableau)
    n = len(k)
    values, vectors = np.linalg.eig(np.block([[np.zeros((n, n)), np.eye(n)], [-k, -c]]))
    # What grows of itself, as a rod that buckles, is no matter of the step.
    values = np.minimum(np.real(values), 0.0) + 1j * np.imag(values)
    sizes = np.abs(values)
    if not sizes.max() > 1e-5:
        return np.inf, np.zeros(n)
    terms = stability_polynomial(table)
    best, limit = -1, np.inf
    # The border is nearly as far from zero in all directions, so that slow motions cannot set the limit.
    for i in np.flatnonzero(sizes > 0.5 * sizes.max()).tolist():
        step = _last_crossing(terms * (values[i] / sizes[i]) ** np.arange(len(terms))) / float(sizes[i])
        if step < limit:
            best, limit = i, step
    mode = vectors[:n, best] if best >= 0 else np.zeros(n)
    return limit, np.real(mode) + np.imag(mode)


def _last_crossing(terms: Floats) -> float:
    """The largest h > 0 at which a polynomial of h with complex coefficients and p(0) = 1 has the size 1."""
    size = np.polynomial.polynomial.polymul(terms, terms.conj()).real
    roots = np.polynomial.polynomial.polyroots(size[1:])  # of |p(h)|² - 1, which is zero at zero
    real = roots.real[(np.abs(roots.imag) <= 1e-6 * np.abs(roots)) & (roots.real > 0.0)]
    return float(real.max()) if real.size else np.inf


def stability_polynomial(table: Tableau) -> Floats:
    """(stages + 1,) R(z) = 1 + sum z^k b A^(k-1) 1 of an explicit Runge-Kutta method, constant first."""
    stages = table.stages
    a, b = table.a[:stages, :stages], table.a[stages, :stages]
    terms, power = [1.0], np.ones(stages)
    for _ in range(stages):
        terms.append(float(b @ power))
        power = a @ power
    return np.array(terms)


@dataclass(frozen=True)
class _Limit:
    """How the limit of a kind of method follows from K and C.

    Attributes:
        damping: weight of dt C beside dt² K in what is most of the limit.
        solve: from the projected K and C and the method's table, the limit, s, and the motion that sets it.
    """

    damping: float
    solve: Callable[[Floats, Floats, object], tuple[float, Floats]]


_LIMITS = {
    "euler": _Limit(2.0, _flip(2.0)),
    "verlet": _Limit(4.0, _flip(4.0)),
    "explicit": _Limit(2.0, _polynomial),
}
"""By the kind of method; no other has a limit."""


def largest_step(scene: Scene, method: str) -> float:
    """The largest stable step of a method with a fixed step about a scene's start, s; infinite where none is.

    The stable spring's body depends on the step: dt² K and dt C grow with it, until every spring is as stiff
    as the step bears. So there is one step up to which it is stable; at most a second is asked for.
    """
    system = build_system(scene)
    if method != "stable_spring":
        return _limit_of(scene, system, method)

    def bears(dt: float) -> bool:
        body = weakened(system.body, system.inverse_mass, system.held, dt)
        return _limit_of(scene, dataclasses.replace(system, body=body), method) > dt

    low, high = 1e-6, 1.0
    if bears(high):
        return np.inf
    while high > 1.001 * low:
        middle = (low * high) ** 0.5
        low, high = (middle, high) if bears(middle) else (low, middle)
    return low


def _limit_of(scene: Scene, system: System, method: str) -> float:
    live = start_of(scene, system)
    meter = StabilityMeter(system, method)
    meter.update(live, scene.air_friction)
    return meter.update(live, scene.air_friction).limit


def start_of(scene: Scene, system: System) -> Live:
    """The state at a scene's start, with what springs and masses are there."""
    live = new_live(system)
    live.controls[0] = scene.rest_length_scale
    refresh(system.body, live)
    here = slice(1, system.body.masses + 1)
    for field, row in zip((live.x, live.y, live.vx, live.vy), system.start, strict=True):
        field[here] = row
    # Only whether it is zero counts for the estimate.
    live.dt_mass[here] = np.where(system.held, 0.0, system.inverse_mass)
    return live
