"""The effect of a scene's parameters on its motion: frequencies, sag, damping and stable time steps."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import msgspec
import numpy as np

from ..engine.tables import Floats, Indices
from ..errors import InputError
from ..forces.air import AIR
from ..forces.joints import JointsReference
from ..forces.reference import Physics
from ..forces.springs import SpringsReference
from ..model.stable_spring import joint_softness, softening_note
from ..model.state import start_of
from ..model.system import build_system, damage_of, for_analysis, joint_stiffness
from ..motion.stability import StabilityMeter, limit_at_start
from ..scene.columns import column, ends
from ..scene.parts import constant_force
from ..scene.types import Scene, is_loaded
from ..scene.validate import validate
from ..solve.registry import METHODS
from ..solve.stability_limits import period_doubling_limit, undamped_step
from ..text import Text
from .decay import TENTH, Decay
from .equilibrium import loaded_equilibrium
from .vibrations import MAX_MASSES, Vibrations, free_vibrations

# Unless noted, doubling or halving one of these numbers fails no test.
_UPDATES = 4
"""Number of updates of the estimate of the fastest vibration."""
_CREEP = 1e-3
"""Speed at which friction is evaluated, relative to the smallest slip speed."""
MAX_VIBRATIONS = 100
"""Maximum number of vibrations examined, slowest first."""
_LOOKS = (24, MAX_VIBRATIONS)
"""Numbers of vibrations found in turn until one of them is elastic; for a small body, all are found."""
_SMALL = 120
"""Number of degrees of freedom below which a body is small."""


@dataclass(frozen=True)
class Vibration:
    """A small vibration of the whole body.

    Attributes:
        frequency: without damping, Hz.
        damping_ratio: the decay rate of its amplitude divided by its angular frequency; 1 at critical
            damping. Where damping couples it with others, the rate is that of its energy, see
            `sim.analysis.decay`; for the fastest vibration, coupling is ignored. Air friction is
            included under the linear law only, since under others it vanishes with the amplitude; friction
            on walls is that of a creeping motion.
        shape: (n, 2) amplitude of each mass relative to the largest; the sign is arbitrary.
    """

    frequency: float
    damping_ratio: float
    shape: Floats

    @property
    def period(self) -> float:
        """The period, s."""
        return 1.0 / self.frequency

    @property
    def calm_after(self) -> float:
        """The time, s, in which the amplitude falls to a tenth; infinite without damping."""
        rate = math.tau * self.frequency * self.damping_ratio
        return TENTH / rate if rate > 0.0 else math.inf


class UncoupledOscillators(NamedTuple):
    """Each spring, or each joint, as an oscillator without the others.

    Attributes:
        frequency: (k,) Hz, with the masses at its ends; 0 where none of them is free.
        damping_ratio: (k,) 1 at critical damping; infinite for damping without stiffness.
        stable_step: (k,) s, the largest stable time step of symplectic Euler; infinite where unlimited.
    """

    frequency: Floats
    damping_ratio: Floats
    stable_step: Floats


@dataclass(frozen=True)
class Tuning:
    """The result of `tuning`.

    Attributes:
        slowest, fastest: of the vibrations about the pose at rest; None where there is none.
        elastic: the slowest vibration in which springs or joints provide more than half of the stiffness, so
            that it is no swing under gravity; None where there is none among the slowest hundred.
        sag: largest displacement of a mass, px, from the scene's start to rest, in the direction of gravity
            (without gravity: of the sum of all constant forces); None where there is no pull or no rest.
        sag_mass: the mass that sinks most.
        stable_steps: s, the largest stable time step of each method that has one, about the scene's start;
            infinite where unlimited.
        springs, joints: each as an uncoupled oscillator.
        notes: why something is missing, and what would break or yield in the pose at rest, which these
            numbers ignore; one sentence each, without a full stop.
    """

    slowest: Vibration | None
    elastic: Vibration | None
    fastest: Vibration | None
    sag: float | None
    sag_mass: int | None
    stable_steps: dict[str, float]
    springs: UncoupledOscillators
    joints: UncoupledOscillators
    notes: tuple[str, ...]


def tuning(scene: Scene) -> Tuning:
    """Find the effect of a scene's stiffnesses, dampings and masses on its motion.

    The vibrations are those about the pose at rest, see `sim.equilibrium`; where gravity makes the body fall,
    about its pose without gravity, and where there is none, about the scene's start. The slowest is found
    with `sim.vibrations`, for at most 1000 masses; unresisted motions, such as those of a free body as a
    whole, do not count as vibrations. The fastest is found by Arnoldi's method, to within one per cent.

    An uncoupled spring has the squared angular frequency stiffness / mu, where mu = m1 m2 / (m1 + m2) is the
    reduced mass of its ends (m1, if the other one is held); an uncoupled joint is that of two springs in line
    at their rest lengths. Their steps are those of `sim.motion.stability`.

    Args:
        scene: a valid scene. Its pose, if it has one, is its start.

    Raises:
        SceneError: the scene is not valid.
    """
    scene = validate(scene)
    notes: list[str] = []
    resting, sag, sag_mass = at_rest(scene, notes)
    if note := softening_note(scene):
        notes.append(note)
    slowest = elastic = fastest = None
    if _freedoms(scene):
        slowest, elastic = _slowest(resting, notes)
        fastest = _fastest(resting)
    methods = [name for name, method in METHODS.items() if method.limit and name != "stable_spring"]
    steps = {name: limit_at_start(scene, name).limit for name in methods}
    (springs, joints), numbers = inverse_reduced_masses(scene), Numbers.of(scene)
    return Tuning(
        slowest=slowest,
        elastic=elastic,
        fastest=fastest,
        sag=sag,
        sag_mass=sag_mass,
        stable_steps=steps,
        springs=_alone(numbers.stiffness, numbers.damping, springs),
        joints=_alone(numbers.joint_stiffness, numbers.joint_damping, joints),
        notes=tuple(notes),
    )


class Numbers(NamedTuple):
    """Stiffness, kg/s², and damping, kg/s, of springs (S,) and joints (J,), in the order of the scene."""

    stiffness: Floats
    damping: Floats
    joint_stiffness: Floats
    joint_damping: Floats

    @staticmethod
    def of(scene: Scene) -> Numbers:
        """Return the numbers of a scene."""
        springs, joints = scene.linear_springs, scene.angular_springs
        of_joints = np.array(joint_stiffness(scene), float)
        return Numbers(
            column(springs, "stiffness"), column(springs, "damping"), of_joints, column(joints, "damping")
        )


def inverse_reduced_masses(scene: Scene) -> tuple[Floats, Floats]:
    """Return the inverse reduced mass of each spring (S,) and of each joint (J,), 1/kg.

    It is 0 where all masses are held, and for broken parts.

    Multiplied by the stiffness, it gives the squared angular frequency of the uncoupled part, 1/s².
    """
    system = build_system(scene)
    body = system.body
    free = np.concatenate(([0.0], np.where(system.held, 0.0, system.inverse_mass)))
    springs = np.zeros(body.springs)
    springs[system.spring_order] = free[body.spring_a] + free[body.spring_b]
    joints = joint_softness(body, free)[system.joint_order]
    broken, loose = broken_parts(scene)
    springs[broken] = joints[loose] = 0.0
    return springs, joints


def broken_parts(scene: Scene) -> tuple[Indices, Indices]:
    """Return the springs that are broken at the scene's start, and the joints attached to one of them."""
    damage = damage_of(scene)
    broken = np.array(damage.broken if damage is not None else (), np.int64)
    return broken, np.flatnonzero(np.isin(np.stack(ends(scene.angular_springs), 1), broken).any(1))


def vibrations_at_rest(scene: Scene, count: int) -> tuple[Scene, Vibrations]:
    """Return a scene in the pose that `tuning` uses, and up to `count` of its slowest vibrations there.

    Raises:
        InputError: as `vibrations`, except for the count.
    """
    resting, _, _ = at_rest(scene, [])
    freedoms = _freedoms(scene)
    if not freedoms:
        return resting, Vibrations(np.zeros(0), np.zeros((0, len(scene.masses), 2)))
    return resting, free_vibrations(resting, min(count, freedoms))


class Dampers:
    """Everything that damps small vibrations about a scene's start.

    Args:
        scene: a valid scene.
    """

    def __init__(self, scene: Scene) -> None:
        exact = for_analysis(scene)
        self._system, self._state = start_of(exact, build_system(exact))
        self._physics = Physics(self._system.body, self._state)
        if scene.air_law != "linear":  # drag grows with the square of the speed, and damps no small vibration
            del self._physics.terms[AIR.name]
        # Terms that do not depend on the velocity here damp nothing and can be left out.
        x = self._state.x + 1j * self._state.y
        v = np.random.default_rng(1).uniform(-1.0, 1.0, (2, x.size)).T.copy().view(complex)[:, 0]
        for name, term in list(self._physics.terms.items()):
            if np.array_equal(term.forces(x, v), term.forces(x, -v)):
                del self._physics.terms[name]
        # The springs and joints, whose dampings are arguments.
        body, state = self._system.body, self._state
        self._springs, self._joints = SpringsReference(body, state), JointsReference(body, state)
        self._physics.terms |= {"linear": self._springs, "angular": self._joints}
        self._mass = np.array([[m.mass] for m in scene.masses])
        self.numbers = Numbers.of(scene)
        self._broken, self._loose = broken_parts(scene)
        # Friction is proportional to the speed only far below the slip speeds.
        slips = [wall.slip_speed for wall in scene.walls]
        slips += [part.slip_speed for part in (scene.contact, scene.ground) if part]
        self._creep = _CREEP * min(slips, default=1.0 / _CREEP)

    def ratio(
        self, omega: float, shape: Floats, springs: Floats | None = None, joints: Floats | None = None
    ) -> float:
        """Return the damping ratio of a vibration: the power of damping at the velocity `shape`, relative to
        that if the whole vibration were critically damped.

        Args:
            omega: angular frequency, rad/s.
            shape: (n, 2) amplitude of each mass.
            springs, joints: their dampings, kg/s, in the order of the scene; None for no damping.
        """
        # Rounding may make it negative where nothing damps.
        power = max(0.0, float((shape * self.drag(shape, springs, joints)).sum()))
        return power / (2.0 * omega * float((self._mass * shape**2).sum()))

    def drag(self, shape: Floats, springs: Floats | None = None, joints: Floats | None = None) -> Floats:
        """Return (n, 2) forces opposing the velocities `shape`, kg/s times these; arguments as in `ratio`."""
        system, state, physics = self._system, self._state, self._physics
        body = system.body
        springs, joints = (
            np.zeros(count) if each is None else each.copy()
            for count, each in ((body.springs, springs), (body.joints, joints))
        )
        springs[self._broken] = joints[self._loose] = 0.0
        of_joints = np.zeros(body.joints)
        of_joints[system.joint_order] = joints
        self._springs.damping, self._joints.damping = springs[system.spring_order], of_joints
        w = np.zeros(state.slots, complex)
        w[system.mass_index] = shape[:, 0] + 1j * shape[:, 1]
        x = state.x + 1j * state.y
        slow = self._creep / max(float(np.abs(w).max()), 1e-300)
        v = (slow * w).astype(complex)
        change = (physics.forces(x, -v) - physics.forces(x, v)) / (2.0 * slow)
        return change[system.mass_index].view(np.float64).reshape(-1, 2)

    def hold(self, omega: float, shape: Floats) -> Hold:
        """Find what stiffens and damps a vibration; arguments as in `ratio`."""
        unit, around = 2.0 / omega, self.ratio(omega, shape)
        return Hold(
            self.ratio(omega, shape, springs=unit * self.numbers.stiffness) - around,
            self.ratio(omega, shape, joints=unit * self.numbers.joint_stiffness) - around,
            around,
        )


class Hold(NamedTuple):
    """The shares of springs and joints in a vibration's stiffness, and its damping by anything else.

    Attributes:
        springs, joints: fraction of its stiffness from springs and from joints; it is the damping ratio that
            they would give if each of them were critically damped for this vibration.
        around: damping ratio due to anything else.
    """

    springs: float
    joints: float
    around: float

    @property
    def is_elastic(self) -> bool:
        """Whether springs or joints provide more than half of the stiffness and can damp it critically."""
        return max(self.springs, self.joints) > 0.5 and self.around < 1.0


# ------------------------------------------------------------------------- inside
def _freedoms(scene: Scene) -> int:
    return 2 * (len(scene.masses) - len({anchor.mass for anchor in scene.anchors}))


def at_rest(scene: Scene, notes: list[str]) -> tuple[Scene, float | None, int | None]:
    """Return the scene in its pose at rest, if there is one, its sag, and the mass that sinks most.

    Args:
        scene: a valid scene.
        notes: list to which reasons for missing results are appended.

    Returns:
        The scene in the pose about which it vibrates, see `tuning`; the sag, px, and its mass, or None.
    """
    down = pull_direction(scene) if _freedoms(scene) > 0 else None
    pose, sinks = None, down is not None
    try:
        pose, overloads = loaded_equilibrium(scene)
        notes.extend(overloads)
    except InputError as error:
        notes.append(_of(error))
        if sinks:
            down = None
            try:
                pose, _ = loaded_equilibrium(_weightless(scene))
                notes.append(
                    Text("the vibrations are those of the body without gravity")
                    if any(scene.gravity)
                    else Text("the vibrations are those of the body without its loads")
                )
            except InputError:
                pose = None
    if pose is None:
        notes.append(Text("the vibrations are those about the start"))
        return scene, None, None
    resting = msgspec.structs.replace(scene, pose=pose)
    if down is None:
        return _weightless(resting) if sinks else resting, None, None
    moved = (np.array(pose.positions) - np.array([m.position for m in scene.masses])) @ down
    most = int(np.argmax(moved))
    return resting, float(moved[most]), most


def pull_direction(scene: Scene) -> Floats | None:
    """Return the (2,) direction of gravity or, without it, of the sum of all loads; None without any pull."""
    pull = np.array(scene.gravity)
    if not pull.any():
        held = {anchor.mass for anchor in scene.anchors}
        forces = map(constant_force, scene.masses)
        loads = [force for i, force in enumerate(forces) if force and i not in held]
        pull = np.sum([(0.0, 0.0), *loads], axis=0)
    size = float(np.hypot(*pull))
    return pull / size if size > 0.0 else None


def _weightless(scene: Scene) -> Scene:
    masses = scene.masses
    if is_loaded(scene):
        masses = tuple(msgspec.structs.replace(mass, force=msgspec.UNSET) for mass in masses)
    return msgspec.structs.replace(scene, gravity=(0.0, 0.0), masses=masses)


def _of(error: InputError) -> str:
    """Return the message of an error without the name of its source."""
    said = str(error)
    inner = said.parts.get("error") if isinstance(said, Text) else None
    return inner if isinstance(inner, str) else said


def _slowest(scene: Scene, notes: list[str]) -> tuple[Vibration | None, Vibration | None]:
    """Find the slowest vibration and the slowest elastic one."""
    if len(scene.masses) > MAX_MASSES:
        notes.append(Text("the slowest vibrations are found for at most {most} masses", most=MAX_MASSES))
        return None, None
    dampers = Dampers(scene)
    try:
        found, elastic = elastic_vibration(scene, dampers)
    except InputError as error:
        notes.append(_of(error))
        return None, None
    if not found.omega.size:
        return None, None
    decay = Decay(dampers, found, column(scene.masses, "mass"))
    damping = decay.between(dampers.numbers.damping, dampers.numbers.joint_damping)

    def vibration(index: int) -> Vibration:
        omega = float(found.omega[index])
        return Vibration(omega / math.tau, decay.rate(damping, index) / omega, found.shapes[index])

    return vibration(0), None if elastic is None else vibration(elastic)


def elastic_vibration(scene: Scene, dampers: Dampers) -> tuple[Vibrations, int | None]:
    """Find the slowest vibrations about a scene's start and the index of the slowest elastic one, see
    `Tuning`; None if none of the slowest hundred is elastic.

    Args:
        scene: a valid scene of at most 1000 masses with a free one.
        dampers: its dampers.

    Raises:
        InputError: as `free_vibrations`.
    """
    freedoms, looked, found = _freedoms(scene), 0, Vibrations(np.zeros(0), np.zeros((0, 0, 2)))
    for count in (freedoms,) if freedoms < _SMALL else _LOOKS:
        found = free_vibrations(scene, min(count, freedoms))
        for i in range(looked, len(found.omega)):
            if dampers.hold(float(found.omega[i]), found.shapes[i]).is_elastic:
                return found, i
        looked = len(found.omega)
        if looked < count:
            break
    return found, None


def _fastest(scene: Scene) -> Vibration | None:
    exact = for_analysis(scene)
    system, state = start_of(exact, build_system(exact))
    state.vx[:] = state.vy[:] = 0.0
    meter = StabilityMeter(
        system, period_doubling_limit(0.0, undamped_step)
    )  # 2 / the largest angular frequency
    limit = min(meter.update(state).limit for _ in range(_UPDATES))
    if not math.isfinite(limit):
        return None
    omega = 2.0 / limit
    shape = np.zeros((len(scene.masses), 2))
    shape[system.mass_order] = meter.motion.T
    shape /= np.abs(shape).max()
    dampers = Dampers(scene)
    ratio = dampers.ratio(omega, shape, dampers.numbers.damping, dampers.numbers.joint_damping)
    return Vibration(omega / math.tau, ratio, shape)


def _alone(stiffness: Floats, damping: Floats, softness: Floats) -> UncoupledOscillators:
    """Return the uncoupled oscillators; with k and c as in `sim.solve.stability_limits`, the limit is where
    dt² k + 2 dt c = 4."""
    k, c = stiffness * softness, damping * softness
    omega = np.sqrt(k)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(c > 0.0, c / (2.0 * omega), 0.0)
        step = 4.0 / (c + np.sqrt(c * c + 4.0 * k))
    return UncoupledOscillators(omega / math.tau, ratio, step)
