"""The largest stable time step of a method, estimated from the forces alone.

Linearised about the present state, the motion is M a = -K x - C v. The stability limit depends on the method:

- A step of symplectic Euler has an eigenvalue -1, the border of stability, exactly when some w has
  (dt² K + 2 dt C) w = 4 M w. So the largest stable step is the one at which the largest eigenvalue of
  M^-1 (dt² K + 2 dt C) is 4; for one damped mode that is the textbook omega dt < 2 (sqrt(1 + zeta²) - zeta).
- Velocity Verlet as implemented here uses v + dt a for the velocities in the new forces. At an eigenvalue -1,
  v is zero and a is -4 x / dt², which gives (dt² K + 4 dt C) w = 4 M w: Euler's limit without damping, and a
  lower one with it, omega dt < 2 (sqrt(1 + 4 zeta²) - 2 zeta). No other eigenvalue leaves the circle before.
- Both hold where K and C are symmetric. The damping of a body that turns, friction, and the tutorial's law
  make them unsymmetric. Two equal frequencies, as regular bodies have, are then a pair of complex
  eigenvalues, and the eigenvalues of the whole step decide, see `sim.solve.stability_limits`.
- Explicit methods soften walls and contact by the step, see `forces.touch.push`. So K and C are
  those at the limit itself, which is found by iteration.
- Runge-Kutta 4 multiplies a motion exp(lambda t) by its stability polynomial R(dt lambda): a step is stable
  while |R| <= 1 for all lambda of lambda² + lambda M^-1 C + M^-1 K; without damping, omega dt < sqrt(8).
- Generalized-alpha is stable with any step in linear theory (Chung & Hulbert 1993): it has no limit. How far
  its steps can be trusted is a question of nonlinearity, of how far springs turn in a step.
- The stable spring is symplectic Euler with the tables that `clamp_stiffness` makes for the step, and has the
  limit of symplectic Euler for that body. The springs' contributions to dt² K and to dt C are then at most M,
  and so are the joints', as long as springs that share a joint keep the proportions of their rest lengths.
  So hardly any body has a limit.

A rope that is slack, a stop that is not reached (see `sim.forces.one_sided`) and a motor that is not at its
speed yet count as if they were about to be, so that a step bears them when they are.

What is left out: the change of K and C in the course of a step, and whatever a step does that is not small.
Damage that is done later is not known either.

K w and C w are differences of two evaluations of the forces of `sim.forces.reference`. So any topology and
law will do, and no matrix is built: K and C are projected on a Krylov space (Arnoldi), and the small
problem that is left is solved as a quadratic eigenvalue problem in 1/dt, or in lambda.
"""

from __future__ import annotations

import dataclasses
import math
from collections import deque
from collections.abc import Callable, Generator
from dataclasses import dataclass
from functools import partial

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..engine.numerics.waves import EFFORTS, SINCE
from ..engine.tables import Floats, State
from ..forces.all import TERMS
from ..forces.muscles import efforts
from ..forces.reference import Physics, Vectors
from ..forces.term import Reference
from ..model.stable_spring import clamp_stiffness
from ..model.state import new_state, start_of, update_rest_state
from ..model.system import System, build_system
from ..scene.types import Scene
from ..solve.registry import METHODS
from ..solve.stability_limits import StabilityLimit

Cause = str
"""What limits the time step: an entry of `CAUSES`."""

_CAUSES = [term.causes or (term.name, term.name) for term in TERMS]
"""What the stiffness and the damping of each term of `sim.forces.all` are called."""

CAUSES = tuple(dict.fromkeys(cause for causes in _CAUSES for cause in causes))
"""All that can."""

_COPIED = (
    "q", "v", "controls", "clock", "steer", "inverse_mass", "set_length", "set_angle", "hardened", "broken",
    "wall_stretch", "wall_place", "wall_time", "wall_slides", "contact_start", "contact_mass",
    "contact_stretch",
)  # fmt: skip
"""What a look takes over from the state; the rest follows from it."""
# Unless noted, doubling or halving one of these numbers fails no test.
_FIRST_SIZE = 40
"""Dimension of the Krylov space in the first update."""
_FIRST_PASSES = 5
"""Largest number of times that the first update makes it: its matrix depends on the limit that is sought. At
1, `test_the_first_estimate_is_as_good_as_later_ones` fails."""
_SOFTENED_PASSES = 20
"""Largest number of times that an update makes it where walls and contact soften with the step: its matrix
depends on the limit that is sought. At 5,
`test_the_first_look_at_what_lies_on_a_wall_finds_what_later_ones_do` fails."""
_SLOWEST = 0.97
"""Ratio of the changes of the limit in two such passes, up to which it is extrapolated. At 0,
`test_the_first_look_at_what_lies_on_a_wall_finds_what_later_ones_do` fails."""
_SETTLED = 1e-3
"""Relative change of the limit at which they end."""
_SIZE = 12
"""Its dimension in later updates, which start from the stiffest motion found before."""
_ENDLESS = 1.0
"""Limit, s, beyond which a body whose walls and contact soften with the step counts as having none."""
_MOMENTS = 8
"""Moments of a beat at which a body with muscles is looked at."""
_NOISE = 1e-3
"""Size of the noise that is added to that motion, relative to it. Without it,
`test_the_meter_sees_when_another_body_gets_stiffer` fails."""


@dataclass(frozen=True)
class StabilityEstimate:
    """What `StabilityMeter.update` found.

    Attributes:
        limit: largest stable time step, s; infinite where there is none.
        cause: what determines it, or None where there is no limit.
    """

    limit: float
    cause: Cause | None


LimitEstimate = Generator[None, None, StabilityEstimate]
"""Finds an estimate in parts: it yields between two of them, and returns the estimate."""


def finished(look: LimitEstimate) -> StabilityEstimate:
    """What a look finds, all parts at once."""
    while True:
        try:
            next(look)
        except StopIteration as end:
            return end.value


class StabilityMeter:
    """Estimates the stability limit of a moving body under a method.

    The estimate concerns small motions about the present state; where there are muscles, at the worst moment
    of their beat. It approaches the true limit from above and is within a per cent of it. It is infinite
    where nothing pulls, and for methods that have no limit: those that choose their steps, and
    generalized-alpha.

    Args:
        system: the tables; those of `clamp_stiffness` for the stable spring.
        method: name of the method, or a rule instead.
        like: a meter of the same body with other numbers, from whose motion and limit it begins.

    Attributes:
        system: the tables.
        motion: (2, n) the motion that sets the limit, in the order of the slots, of any size; where it is a
            complex one, that part of it which is largest.
    """

    def __init__(
        self, system: System, method: str | StabilityLimit, like: StabilityMeter | None = None
    ) -> None:
        self.system = system
        self._rule = METHODS[method].limit if isinstance(method, str) else method
        self._probe = new_state(system)
        n = system.body.masses
        self._here = slice(1, n + 1)  # the slots of the masses
        # Alternating signs are close to the stiffest mode of a chain, and no mode is orthogonal to noise.
        noise = np.random.default_rng(1).normal(size=(2, n))
        self._noise = noise / float(np.sqrt((noise * noise).sum()))
        self._start = like._start if like else noise + 3.0 * (-1.0) ** np.arange(n)
        self._limit = like._limit if like else 0.0
        environment = system.body.environment
        yields = bool(environment.touches)
        self._softens = environment.step > 0.0 and yields
        self.motion = np.zeros((2, n))
        # By moment of the beat, what was found there and the motion that set it; and the moment that is next.
        self._moments: dict[int, tuple[StabilityEstimate, Floats]] = {}
        self._next = 0

    def update(self, state: State) -> StabilityEstimate:
        """The limit at the state in `state` (which is only read).

        Masses whose `inverse_mass` is zero count as held.
        """
        return finished(self.look(state))

    def look(self, state: State) -> LimitEstimate:
        """As `update`, in parts, each of some evaluations of the forces. It is about the state as it is when
        the first part begins; one look must be over before the next begins.
        """
        if self._rule is None:
            return StabilityEstimate(np.inf, None)
        for field in _COPIED:
            getattr(self._probe, field)[:] = getattr(state, field)
        if not self.system.body.muscles.present:
            return (yield from self._look_at_probe())
        return (yield from self._look_at_beat())

    def _look_at_beat(self) -> LimitEstimate:
        """The least of the limits that the body has as its muscles are at each moment of a beat.

        The first look is at all of these moments, each later one at the next of them.
        """
        effort = efforts(self._probe.steer, float(self._probe.clock[0]))
        for k in (self._next,) if self._moments else range(_MOMENTS):
            # What keys work stays as it is, whatever the clock.
            self._probe.steer[EFFORTS:SINCE], self._probe.steer[SINCE] = effort, math.inf
            self._probe.clock[0] = k / _MOMENTS * self.system.body.muscles.period
            estimate = yield from self._look_at_probe()
            self._moments[k], self._next = (estimate, self.motion), (k + 1) % _MOMENTS
        least, self.motion = min(self._moments.values(), key=lambda moment: moment[0].limit)
        return least

    def _look_at_probe(self) -> LimitEstimate:
        """As `look`, at the state of the probe."""
        body, probe = self.system.body, self._probe
        free = probe.inverse_mass[self._here] > 0.0
        update_rest_state(body, probe)
        physics = self._physics(self._limit)
        # Coordinates q = sqrt(M) w, in which K and C of a conservative law are symmetric.
        root = np.where(free, np.sqrt(self.system.inverse_mass), 0.0)
        passes, size = (1, _SIZE) if self._limit else (_FIRST_PASSES, _FIRST_SIZE)
        last = 0.0  # change of the limit in the pass before
        for _ in range(_SOFTENED_PASSES if self._softens else passes):
            before = self._limit
            if self._softens:
                physics = self._physics(before)
            limit, mode = yield from self._estimate(physics, root, min(size, 2 * int(free.sum())))
            if limit == np.inf:
                return StabilityEstimate(np.inf, None)
            if self._softens and limit > _ENDLESS:
                self._limit = 0.0
                return StabilityEstimate(np.inf, None)
            self._limit, self._start = limit, mode
            if abs(limit - before) <= _SETTLED * limit:
                break
            change, rate = limit - before, (limit - before) / last if last else 0.0
            last = change if before else 0.0
            if self._softens and 0.0 < rate < _SLOWEST:
                # It is the limit for a step that is as long as the limit. Where passes approach that ever
                # more slowly, go to where they would end (Aitken).
                self._limit, last = max(limit + change * rate / (1.0 - rate), 0.3 * limit), 0.0
        self.motion = _largest_part(self._start) * root
        return StabilityEstimate(self._limit, self._cause(physics, self._start * root, self._limit))

    def _physics(self, step: float) -> Physics:
        """The forces of the probe, with ropes taut, stops reached and motors at their speeds.

        Walls and contact that soften do so for a step (s), 0 for the scene's.
        """
        body = self.system.body
        if self._softens and step:
            body = body.replaced(environment=body.environment.replaced(step=step))
        physics = Physics(body, self._probe)
        physics.brace(self._flat(self._probe.q))
        return physics

    def _estimate(
        self, physics: Physics, root: Floats, size: int
    ) -> Generator[None, None, tuple[float, Floats]]:
        """The limit and the motion that sets it, (2, n), from a Krylov space with at most `size` dimensions.

        The space is that of dt² K + weight dt C with the last limit as dt.
        """
        assert self._rule is not None
        weight, scale = self._rule.damping, self._limit or 1e-3
        # Each row is a vector of the space, and K and C times it.
        basis, k_basis, c_basis = (np.empty((size, self._start.size)) for _ in range(3))
        known = 0
        # Noise, for the motion found before may be that of another body than the one that is stiffest now.
        start = self._start / max(float(np.sqrt((np.abs(self._start) ** 2).sum())), 1e-300)
        # A complex motion spans two dimensions, and the space grows from both.
        parts = [start.real, start.imag] if np.iscomplexobj(start) else [start]
        starts = (self._on_rails((part + _NOISE * self._noise) * (root > 0.0)) for part in parts)
        coming = deque(start.ravel() for start in starts)
        while coming and known < size:
            q, others = coming.popleft(), basis[:known]
            for _ in range(2):  # twice makes it orthogonal up to rounding
                q = q - (others @ q) @ others
            norm = float(np.sqrt(q @ q))
            if not 1e-12 < norm < np.inf:
                continue
            basis[known] = q / norm
            w = basis[known].reshape(2, -1) * root
            k_basis[known] = self._on_rails(self._by_positions(physics, w) * root).ravel()
            yield
            c_basis[known] = self._on_rails(self._by_velocities(physics, w) * root).ravel()
            q = scale * scale * k_basis[known] + weight * scale * c_basis[known]
            coming.append(q / max(float(np.sqrt(q @ q)), 1e-300))
            known += 1
            yield
        if not known:
            return np.inf, self._start
        flat = basis[:known]
        k, c = flat @ k_basis[:known].T, flat @ c_basis[:known].T
        if not (np.isfinite(k).all() and np.isfinite(c).all()):
            return np.inf, self._start
        limit, mode = self._rule.solve(k, c)
        return limit, (mode @ flat).reshape(2, -1)

    def _by_positions(self, physics: Physics | Reference, w: Floats) -> Floats:
        """K w, as a difference quotient of forces."""
        x, v = self._flat(self._probe.q), self._flat(self._probe.v)
        return self._difference(lambda step: physics.forces(x + step, v), w)

    def _by_velocities(self, physics: Physics | Reference, w: Floats) -> Floats:
        """C w, as a difference quotient of forces."""
        body, environment = self.system.body, self.system.body.environment
        if not (body.damped or body.joint_damped or environment.air.friction or environment.present):
            return np.zeros_like(w)
        x, v = self._flat(self._probe.q), self._flat(self._probe.v)
        return self._difference(lambda step: physics.forces(x, v + step), w)

    def _difference(self, forces: Callable[[Vectors], Vectors], w: Floats) -> Floats:
        """Minus the derivative of forces along w; (2, n), as w is."""
        # Small compared with the springs, large compared with the rounding of coordinates.
        size = 1e-6 * (1.0 + float(np.abs(self._probe.q).max()))
        step = size / max(float(np.abs(w).max()), 1e-300)
        along = np.zeros(self._probe.slots, complex)
        along[self._here] = step * (w[0] + 1j * w[1])
        change = ((forces(-along) - forces(along)) / (2.0 * step))[self._here]
        return np.array([change.real, change.imag])

    def _on_rails(self, w: Floats) -> Floats:
        """A motion, (2, n), without what is across rails."""
        rails = self.system.body.environment.rails
        if not rails.slot.size:
            return w
        kept, on, way = w.copy(), rails.slot - 1, rails.way.T
        kept[:, on] = way * (way * w[:, on]).sum(0)
        return kept

    def _flat(self, flat: Floats) -> Vectors:
        """A flat vector as complex numbers, one for each slot."""
        return flat[: self._probe.slots] + 1j * flat[self._probe.slots :]

    def _cause(self, physics: Physics, w: Floats, limit: float) -> Cause:
        """Which property contributes most to the stiffest motion, (2, n), which may be complex."""
        assert self._rule is not None
        rate = self._rule.damping * limit

        def along(change: Callable[[Floats], Floats]) -> float:
            return sum(float((part * change(part)).sum()) for part in (w.real, w.imag) if part.any())

        def parts_of(forces: Reference) -> tuple[float, float]:
            """What stiffness and damping contribute."""
            stiffness = along(partial(self._by_positions, forces))
            return limit * limit * stiffness, rate * along(partial(self._by_velocities, forces))

        parts = dict.fromkeys(CAUSES, 0.0)
        for causes, reference in zip(_CAUSES, physics.terms.values(), strict=True):
            for cause, part in zip(causes, parts_of(reference), strict=True):
                parts[cause] += part
        return max(parts, key=lambda cause: parts[cause])


def _largest_part(mode: NDArray[np.complex128] | Floats) -> Floats:
    """The real part of a motion, turned in the complex plane so that it is as large as can be."""
    return (
        np.real(mode * np.exp(-0.5j * np.angle((mode * mode).sum())))
        if np.iscomplexobj(mode)
        else np.real(mode)
    )


def quick_limit(system: System) -> float:
    """A quick lower bound of the stability limit of symplectic Euler and Verlet, s.

    It is 2 / omega, where omega² is bounded by the row sums of M^-1 K (Gershgorin). It is for a straight body
    without damping whose springs have their rest lengths. Infinite where nothing pulls.
    """
    fastest = float(_row_sums(system, system.body.stiffness, system.body.joint_stiffness).max())
    return 2.0 / np.sqrt(fastest) if fastest > 0.0 else np.inf


def damped_limit(system: System, surroundings: bool = True) -> float:
    """Like `quick_limit`, for velocity Verlet with damping: the smallest root of dt² k + 4 dt c = 4, s.

    Args:
        system: the tables.
        surroundings: whether what acts besides springs and joints counts, too.
    """
    body = system.body
    k = _row_sums(system, body.stiffness, body.joint_stiffness)
    c = _row_sums(system, body.damping, body.torque_damping[1 : body.joints + 1])
    free = np.where(system.held, 0.0, system.inverse_mass)
    for term in (TERMS[index] for index in body.environment.acting) if surroundings else ():
        if term.bounds is not None:
            stiffness, damping = term.bounds(body)
            k, c = k + stiffness * free, c + damping * free
    with np.errstate(divide="ignore"):
        return float((2.0 / (c + np.sqrt(c * c + k))).min())


def _row_sums(system: System, of_spring: Floats, of_joint: Floats) -> Floats:
    """(n,) upper bounds of the row sums of M^-1 K, 1/s², or of M^-1 C, 1/s."""
    body = system.body
    sums = np.zeros(body.masses + 1)
    for ends in (body.spring_a, body.spring_b):
        sums += np.bincount(ends, 2.0 * of_spring[: body.springs], sums.size)
        # A joint of two springs in line bends by x1 - 2 x2 + x3.
        for spring in (body.joint_a, body.joint_b):
            sums += np.bincount(ends[spring], 4.0 * of_joint, sums.size)
    return sums[1:] * np.where(system.held, 0.0, system.inverse_mass)


def largest_step(scene: Scene, method: str) -> float:
    """The largest stable step at a scene's start of a method with a fixed step, s; infinite if there is no
    limit.

    The stable spring's body depends on the step: dt² K and dt C grow with it until every spring is limited.
    So there is one step up to which it is stable. Steps of more than a second count as no limit.
    """
    if method != "stable_spring":
        return limit_at_start(scene, method).limit
    system = build_system(_by(scene, method))

    def is_stable(dt: float) -> bool:
        body = clamp_stiffness(system.body, system.inverse_mass, system.held, dt)
        softened = dataclasses.replace(system, body=body)
        return meter_at_start(scene, method, system=softened)[1].limit > dt

    low, high = 1e-6, 1.0
    if is_stable(high):
        return np.inf
    while high > 1.001 * low:
        middle = (low * high) ** 0.5
        low, high = (middle, high) if is_stable(middle) else (low, middle)
    return low


def limit_at_start(scene: Scene, method: str) -> StabilityEstimate:
    """The limit of a method, but the stable spring, at a scene's start, whatever the scene's own method."""
    return meter_at_start(scene, method)[1]


def _by(scene: Scene, method: str) -> Scene:
    integrator = msgspec.structs.replace(scene.integrator, method=method)
    return msgspec.structs.replace(scene, integrator=integrator)


def meter_at_start(
    scene: Scene, method: str, like: StabilityMeter | None = None, system: System | None = None
) -> tuple[StabilityMeter, StabilityEstimate]:
    """As `limit_at_start`, with the meter that found it.

    Args:
        scene: the scene.
        method: the method.
        like: a meter of the same scene with other numbers: it is much faster to begin there.
    """
    system, state = start_of(scene, system or build_system(_by(scene, method)))
    meter = StabilityMeter(system, method, like)
    meter.update(state)
    return meter, meter.update(state)
