"""What the numbers of a scene mean for its motion: frequencies, sag, damping, and the time steps it bears."""

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
from ..scene.types import Scene, is_loaded
from ..scene.validate import validate
from ..solve.registry import METHODS
from ..solve.stability_limits import period_doubling_limit, undamped_step
from .decay import TENTH, Decay
from .equilibrium import loaded_equilibrium
from .vibrations import MAX_MASSES, Vibrations, free_vibrations

_UPDATES = 4
"""Updates of the estimate of the fastest vibration."""
_CREEP = 1e-3
"""Speed at which friction is looked at, as a part of the smallest slip speed."""
MAX_VIBRATIONS = 100
"""How many vibrations are looked at, the slowest first."""
_LOOKS = (24, MAX_VIBRATIONS)
"""How many are found at a time until one of them is elastic; of a small body all."""
_SMALL = 120
"""Number of ways to move of a small body."""


@dataclass(frozen=True)
class Vibration:
    """A small vibration of the whole body.

    Attributes:
        frequency: without damping, Hz.
        damping_ratio: 1 where it is critically damped: the rate at which its amplitude falls over its angular
            frequency. Where damping couples it with others the rate is that of its energy, see
            `sim.analysis.decay`; of the fastest vibration it is that of the vibration by itself. Air
            friction, which vanishes with the amplitude, is not in it; friction on walls is as at a creep.
        shape: (n, 2) amplitude of each mass relative to the largest; the sign is arbitrary.
    """

    frequency: float
    damping_ratio: float
    shape: Floats

    @property
    def period(self) -> float:
        """s."""
        return 1.0 / self.frequency

    @property
    def calm_after(self) -> float:
        """s, in which the amplitude falls to a tenth; infinite without damping."""
        rate = math.tau * self.frequency * self.damping_ratio
        return TENTH / rate if rate > 0.0 else math.inf


class UncoupledOscillators(NamedTuple):
    """What each spring, or each joint, would do if there were no others.

    Attributes:
        frequency: (k,) Hz, of the masses at its ends; 0 where none of them is free.
        damping_ratio: (k,) 1 where it is critically damped; infinite where it is damped without stiffness.
        stable_step: (k,) s, the largest stable time step of symplectic Euler; infinite where there is none.
    """

    frequency: Floats
    damping_ratio: Floats
    stable_step: Floats


@dataclass(frozen=True)
class Tuning:
    """What `tuning` found.

    Attributes:
        slowest, fastest: of the vibrations about the pose at rest; None where there is none.
        elastic: the slowest of those that springs or joints hold by more than half, so that it is no swing
            under gravity; None where there is none among the slowest hundred.
        sag: px by which the mass that sinks most sinks in the direction of gravity (without gravity: of all
            constant forces together), from where the scene puts it to its place at rest; None where nothing
            pulls it, or where it comes to no rest.
        sag_mass: which mass that is.
        stable_steps: s, the largest stable time step of each method that has one, about the scene's start;
            infinite where nothing limits it.
        springs, joints: each alone.
        notes: why something is missing, and what would break or yield in the pose at rest, which these
            numbers leave out; one sentence each, without a full stop.
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
    """What a scene's stiffnesses, dampings and masses mean for its motion.

    The vibrations are those about the pose at rest, see `sim.equilibrium`; where gravity makes the body fall,
    about its pose without gravity, and where there is none, about the scene's start. The slowest comes from
    all of them (`sim.vibrations`), for at most 1000 masses; motions that nothing resists, such as those of a
    free body as a whole, are no vibrations. The fastest is found by Arnoldi's method, within a per cent.

    A spring alone has the square of the angular frequency stiffness / mu, where mu = m1 m2 / (m1 + m2) is the
    reduced mass of its ends (m1, if the other one is held), and a joint alone is that of two springs in line
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
        """Those of a scene."""
        springs, joints = scene.linear_springs, scene.angular_springs
        of_joints = np.array(joint_stiffness(scene), float)
        return Numbers(
            column(springs, "stiffness"), column(springs, "damping"), of_joints, column(joints, "damping")
        )


def inverse_reduced_masses(scene: Scene) -> tuple[Floats, Floats]:
    """1 / the reduced mass of each spring (S,), and of each joint (J,), 1/kg.

    It is 0 where all masses are held, and of what is broken.

    The stiffness times it is the square of the angular frequency of that part alone, 1/s².
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
    """The springs that are broken at the scene's start, and the joints that hold one of them."""
    damage = damage_of(scene)
    broken = np.array(damage.broken if damage is not None else (), np.int64)
    return broken, np.flatnonzero(np.isin(np.stack(ends(scene.angular_springs), 1), broken).any(1))


def vibrations_at_rest(scene: Scene, count: int) -> tuple[Scene, Vibrations]:
    """A scene in the pose that `tuning` takes, and its slowest vibrations there, or all if they are fewer.

    Raises:
        InputError: as `vibrations`, but of the count.
    """
    resting, _, _ = at_rest(scene, [])
    freedoms = _freedoms(scene)
    if not freedoms:
        return resting, Vibrations(np.zeros(0), np.zeros((0, len(scene.masses), 2)))
    return resting, free_vibrations(resting, min(count, freedoms))


class Dampers:
    """What damps small vibrations about a scene's start.

    Args:
        scene: a valid scene.
    """

    def __init__(self, scene: Scene) -> None:
        exact = for_analysis(scene)
        self._system, self._state = start_of(exact, build_system(exact))
        self._physics = Physics(self._system.body, self._state)
        # Its drag grows with the square of the speed: of small vibrations it takes nothing.
        del self._physics.terms[AIR.name]
        # What does not change with the velocity here damps nothing, and need not be looked at again.
        x = self._state.x + 1j * self._state.y
        v = np.random.default_rng(1).uniform(-1.0, 1.0, (2, x.size)).T.copy().view(complex)[:, 0]
        for name, term in list(self._physics.terms.items()):
            if np.array_equal(term.forces(x, v), term.forces(x, -v)):
                del self._physics.terms[name]
        # Those whose damping is asked for.
        body, state = self._system.body, self._state
        self._springs, self._joints = SpringsReference(body, state), JointsReference(body, state)
        self._physics.terms |= {"linear": self._springs, "angular": self._joints}
        self._mass = np.array([[m.mass] for m in scene.masses])
        self.numbers = Numbers.of(scene)
        self._broken, self._loose = broken_parts(scene)
        # Friction is in proportion to speeds only far below those at which things slip.
        slips = [wall.slip_speed for wall in scene.walls]
        slips += [part.slip_speed for part in (scene.contact, scene.ground) if part]
        self._creep = _CREEP * min(slips, default=1.0 / _CREEP)

    def ratio(
        self, omega: float, shape: Floats, springs: Floats | None = None, joints: Floats | None = None
    ) -> float:
        """The damping ratio of a vibration: what damping takes at the velocity `shape`, as a part of what it
        would take if all of the vibration were damped critically.

        Args:
            omega: angular frequency, rad/s.
            shape: (n, 2) amplitude of each mass.
            springs, joints: their dampings, kg/s, in the order of the scene; None for no damping.
        """
        # Of nothing but rounding it may be below zero.
        power = max(0.0, float((shape * self.drag(shape, springs, joints)).sum()))
        return power / (2.0 * omega * float((self._mass * shape**2).sum()))

    def drag(self, shape: Floats, springs: Floats | None = None, joints: Floats | None = None) -> Floats:
        """(n, 2) the forces against the velocities `shape`, kg/s times these; arguments as in `ratio`."""
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
        """What holds a vibration; arguments as in `ratio`."""
        unit, around = 2.0 / omega, self.ratio(omega, shape)
        return Hold(
            self.ratio(omega, shape, springs=unit * self.numbers.stiffness) - around,
            self.ratio(omega, shape, joints=unit * self.numbers.joint_stiffness) - around,
            around,
        )


class Hold(NamedTuple):
    """What holds and damps a vibration.

    Attributes:
        springs, joints: the part of its stiffness that is of springs, and of joints; it is their damping
            ratio, were each of them damped critically for it.
        around: damping ratio by what is neither.
    """

    springs: float
    joints: float
    around: float

    @property
    def is_elastic(self) -> bool:
        """Whether springs or joints hold it by more than half and may damp it critically."""
        return max(self.springs, self.joints) > 0.5 and self.around < 1.0


# ------------------------------------------------------------------------- inside
def _freedoms(scene: Scene) -> int:
    return 2 * (len(scene.masses) - len({anchor.mass for anchor in scene.anchors}))


def at_rest(scene: Scene, notes: list[str]) -> tuple[Scene, float | None, int | None]:
    """The scene in the pose at rest, if there is one, how far it sinks, and which mass sinks most.

    Args:
        scene: a valid scene.
        notes: is told why something is missing.

    Returns:
        The scene in the pose that vibrations are about, see `tuning`; the sag, px, and its mass, or None.
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
                what = "gravity" if any(scene.gravity) else "its loads"
                notes.append(f"the vibrations are those of the body without {what}")
            except InputError:
                pose = None
    if pose is None:
        notes.append("the vibrations are those about the start")
        return scene, None, None
    resting = msgspec.structs.replace(scene, pose=pose)
    if down is None:
        return _weightless(resting) if sinks else resting, None, None
    moved = (np.array(pose.positions) - np.array([m.position for m in scene.masses])) @ down
    most = int(np.argmax(moved))
    return resting, float(moved[most]), most


def pull_direction(scene: Scene) -> Floats | None:
    """(2,) the direction of gravity or, without it, of all loads together; None where nothing pulls it."""
    pull = np.array(scene.gravity)
    if not pull.any():
        held = {anchor.mass for anchor in scene.anchors}
        loads = [mass.force for i, mass in enumerate(scene.masses) if mass.force and i not in held]
        pull = np.sum([(0.0, 0.0), *loads], axis=0)
    size = float(np.hypot(*pull))
    return pull / size if size > 0.0 else None


def _weightless(scene: Scene) -> Scene:
    masses = scene.masses
    if is_loaded(scene):
        masses = tuple(msgspec.structs.replace(mass, force=msgspec.UNSET) for mass in masses)
    return msgspec.structs.replace(scene, gravity=(0.0, 0.0), masses=masses)


def _of(error: InputError) -> str:
    """The sentence of an error without the name of what it came from."""
    return str(error).partition(": ")[2] or str(error)


def _slowest(scene: Scene, notes: list[str]) -> tuple[Vibration | None, Vibration | None]:
    """The slowest vibration, and the slowest elastic one."""
    if len(scene.masses) > MAX_MASSES:
        notes.append(f"the slowest vibrations are found for at most {MAX_MASSES} masses")
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
    """The slowest vibrations about a scene's start, and which of them is the slowest elastic one, see
    `Tuning`; None if none of the slowest hundred is.

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
    """Each alone, with k and c as in `sim.solve.stability_limits`: its limit is where dt² k + 2 dt c = 4."""
    k, c = stiffness * softness, damping * softness
    omega = np.sqrt(k)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(c > 0.0, c / (2.0 * omega), 0.0)
        step = 4.0 / (c + np.sqrt(c * c + 4.0 * k))
    return UncoupledOscillators(omega / math.tau, ratio, step)
