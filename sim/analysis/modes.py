"""The share of each slow vibration in a motion, and how to excite one.

About the pose at rest r, small vibrations have angular frequencies w_i and shapes s_i with s_iᵀ M s_j = 0 for
i ≠ j, where M is the diagonal mass matrix. A displacement d from r has the amplitude
q_i = s_iᵀ M d / (s_iᵀ M s_i) of shape i, and a velocity u has the rate u_i in the same way. The vibration
has the energy ½ (s_iᵀ M s_i) (u_i² + w_i² q_i²).

Unresisted rigid motions of a part, such as those of a flying body, are removed first by measuring
displacements in a frame that moves with the part. For a floating part this is the frame that best fits its
masses in the mass-weighted least-squares sense (Eckart, "Some studies concerning rotating axes and polyatomic
molecules", 1935; Kabsch 1976 for how it is found).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..engine.tables import Floats, Indices
from ..errors import InputError, of_field
from ..forces.all import TERMS
from ..forces.rails import ways_of
from ..forces.reference import Physics
from ..model.state import start_of
from ..model.system import build_system, for_analysis
from ..motion.moment import Moment
from ..scene.columns import ends
from ..scene.parts import constant_force
from ..scene.types import Scene
from ..scene.validate import validate
from ..text import Text
from .decay import Decay
from .equilibrium import StaticModel
from .tuning import Dampers, vibrations_at_rest
from .vibrations import MAX_MASSES, NOTHING, Vibrations

MAX_TOUCHING = 200
"""Largest number of masses of a body with contact, whose equilibrium may take long to find."""
# Unless noted, doubling or halving one of these numbers fails no test.
_PARALLEL = 1e-9
"""Sine of the angle between two rails up to which a body slides along both."""
_TRIAL = 1e-4
"""Size of the trial displacement for finding the stiffness against a rigid motion, in spring lengths."""
_STANDS = 0.2
"""Amplitude, relative to the largest, below which a point on a spring can be a node."""
_SWINGS = 0.4
"""Amplitude, relative to the largest, from which a mass can be an antinode."""
_ROUNDED = 1e-6
"""Part of the largest amplitude, or of a spring, that may be due to rounding."""
_TOUCHING = tuple(term.name for term in TERMS if term.touches)
"""Terms whose energy is that of compression at contacts and walls."""


@dataclass(frozen=True)
class Marks:
    """The nodes and antinodes of a shape.

    Attributes:
        nodes: for each node, a spring and the node's position along it, 0..1.
        antinodes: masses.
    """

    nodes: tuple[tuple[int, float], ...]
    antinodes: tuple[int, ...]


@dataclass(frozen=True)
class Excitation:
    """The share of each mode in a motion.

    Attributes:
        amplitudes: (k,) current displacement in each mode, of the mass that its shape moves most, px.
        rates: (k,) the corresponding velocity, px/s.
        energies: (k,) of each mode, kg px²/s².
        whole: kinetic energy of the unresisted rigid motions of parts, kg px²/s².
        others: remaining energy above that at rest, kg px²/s²: of faster modes, and the nonlinear part of a
            large motion. It may be negative where the body is softer far from rest.
        touching: energy of compressed walls and contacts, kg px²/s².
        frames: (P, 4) placement of each part: cosine and sine of its rotation from the pose at rest, and the
            translation that follows, px.
    """

    amplitudes: Floats
    rates: Floats
    energies: Floats
    whole: float
    others: float
    touching: float
    frames: Floats


class Modes:
    """The slow vibrations of a body about its pose at rest.

    Args:
        scene: a valid scene of at most 1000 masses. The search for rest starts from its pose, if it has one.
        count: maximum number of modes, from 1.

    Attributes:
        scene: in the pose at rest, see `sim.tuning`.
        rest: (n, 2) that pose, px.
        omega: (k,) angular frequencies, rad/s, the slowest first; k may be less than the count, or 0.
        shapes: (k, n, 2) amplitude of each mass relative to the largest. They are mass-orthogonal.
        masses: (k,) modal masses s_iᵀ M s_i, kg.
        damping_ratios: (k,) see `sim.Vibration`.
        part: (n,) the part that each mass belongs to; parts are masses connected by intact springs.

    Raises:
        SceneError: the scene is not valid.
        InputError: it has more than 1000 masses, or 200 where they can touch each other, or it leaves its
            pose by itself.
    """

    def __init__(self, scene: Scene, count: int) -> None:
        scene = validate(scene)
        if len(scene.masses) > MAX_MASSES:
            raise InputError(
                of_field(
                    "modes",
                    Text("{count} masses are more than {most}", count=len(scene.masses), most=MAX_MASSES),
                )
            )
        if len(scene.masses) > MAX_TOUCHING and scene.contact is not None:
            raise InputError(
                of_field(
                    "modes",
                    Text(
                        "a body with contact may have {most} masses, this has {count}",
                        most=MAX_TOUCHING,
                        count=len(scene.masses),
                    ),
                )
            )
        self.scene, found = vibrations_at_rest(scene, count)
        masses = len(scene.masses)
        self._mass = np.array([mass.mass for mass in scene.masses])
        self.omega = found.omega
        self.shapes = _orthogonal(found.shapes.reshape(-1, masses, 2), self._mass)
        self.masses = (self._mass[:, None] * self.shapes**2).sum((1, 2))
        exact = for_analysis(self.scene)
        self._system, self._state = start_of(exact, build_system(exact))
        self._here = self._system.mass_index
        self._physics = Physics(self._system.body, self._state)
        free = self._state.inverse_mass[self._here] > 0.0
        loads = np.array([constant_force(mass) or (0.0, 0.0) for mass in self.scene.masses]) @ (1.0, 1.0j)
        self._weight = free * (self._mass * complex(*self.scene.gravity) + loads)
        x = self._state.x + 1j * self._state.y
        self.rest = x[self._here].view(np.float64).reshape(-1, 2)
        self._at_rest = sum(self._physics.energies(x).values()) + self._pull(x)
        self.part, self._movable = self._parts()

    @property
    def frequencies(self) -> Floats:
        """(k,) frequencies, Hz."""
        return self.omega / math.tau

    @cached_property
    def damping_ratios(self) -> Floats:
        """(k,) damping ratios, see `sim.Vibration`."""
        dampers = Dampers(self.scene)
        decay = Decay(dampers, Vibrations(self.omega, self.shapes), self._mass)
        return decay.rates(dampers.numbers.damping, dampers.numbers.joint_damping) / self.omega

    @property
    def size(self) -> float:
        """The diagonal of the bounding box at rest, px."""
        return float(np.hypot(*np.ptp(self.rest, axis=0)))

    def excitation(self, positions: Floats, velocities: Floats) -> Excitation:
        """Find the share of each mode in a motion.

        Args:
            positions: (n, 2) px.
            velocities: (n, 2) px/s; zero where a mass is held.
        """
        d, u, frames, whole = self._local(positions, velocities)
        weighted = self._mass[:, None] * self.shapes
        q, rate = ((weighted * each).sum((1, 2)) / self.masses for each in (d, u))
        energies = 0.5 * self.masses * (rate**2 + (self.omega * q) ** 2)
        kinetic = 0.5 * float((self._mass[:, None] * velocities**2).sum())
        x = np.zeros(self._state.slots, complex)
        x[self._here] = positions[:, 0] + 1j * positions[:, 1]
        strained = self._physics.energies(x)
        above = kinetic + sum(strained.values()) + self._pull(x) - self._at_rest
        touching = sum(strained[name] for name in _TOUCHING)
        return Excitation(q, rate, energies, whole, above - whole - float(energies.sum()), touching, frames)

    def away(self, positions: Floats) -> Floats:
        """Return how far each mass is from its place at rest, px, in frames moving with the parts.

        Args:
            positions: (n, 2) px.
        """
        displacements, *_ = self._local(positions, np.zeros_like(positions))
        return np.hypot(*displacements.T)

    def amplitude_of(self, mode: int, energy: float) -> float:
        """Return the amplitude, px, of a mode with an energy in kg px²/s²."""
        return float(np.sqrt(2.0 * energy / self.masses[mode]) / self.omega[mode])

    def put(self, moment: Moment, mode: int, amplitude: float) -> Moment:
        """Return a moment with another amplitude of a mode; all other modes are unchanged.

        The missing energy is added as velocity, in the mode's current direction of motion, to avoid the
        strains of a large displacement. A displacement beyond the amplitude is reduced to it.

        Args:
            moment: a moment of the modes' scene.
            mode: index of the mode.
            amplitude: of the mass that its shape moves most, 0 px or more.

        Raises:
            InputError: there is no such mode, or the amplitude is not finite or is negative.
        """
        if not 0 <= mode < self.omega.size:
            raise InputError(
                of_field(
                    "modes",
                    Text("there is no mode {mode}; there are {count}", mode=mode, count=self.omega.size),
                )
            )
        if not 0.0 <= amplitude < np.inf:
            raise InputError(
                of_field(
                    "modes",
                    Text("an amplitude of {amplitude} is not in the range 0.. px", amplitude=amplitude),
                )
            )
        now = self.excitation(moment.positions, moment.velocities)
        q, rate = float(now.amplitudes[mode]), float(now.rates[mode])
        to = float(np.clip(q, -amplitude, amplitude))
        speed = float(self.omega[mode] * np.sqrt(amplitude**2 - to**2))
        turn = (now.frames[:, 0] + 1j * now.frames[:, 1])[self.part]
        shape = turn * (self.shapes[mode] @ (1.0, 1.0j))
        dx, dv = (to - q) * shape, ((-speed if rate < 0.0 else speed) - rate) * shape
        rows = moment.rows + np.array([dx.real, dx.imag, dv.real, dv.imag])
        return Moment(
            moment.scene,
            moment.rest_length_scale,
            moment.rest_angle_shift,
            rows,
            moment.time,
            moment.step_count,
            moment.damage,
            moment.grips,
        )

    def supports(self, mode: int) -> tuple[Indices, Floats, float] | None:
        """Find the rigid motion of the held masses, as if the ground shook, that drives a mode best.

        Only the vibration is strained in this way. Of all small motions of the ground, translations and
        rotations, it is the one that does most work on the mode relative to the root-mean-square displacement
        of the body, if it were rigid.

        Args:
            mode: index of the mode.

        Returns:
            the masses (a,); their motions (a, 2), when the farthest mass of a rigid body would move by 1; and
            the force on the mode when that is 1 px, kg/s². None where no held mass couples to the mode.
        """
        held = np.array(sorted({anchor.mass for anchor in self.scene.anchors if anchor.circle is None}), int)
        if not held.size:
            return None
        x = self._state.x + 1j * self._state.y
        step = np.zeros_like(x)
        step[self._here] = _TRIAL * max(self.size, 1e-3) / len(self.part) * (self.shapes[mode] @ (1.0, 1.0j))
        still = np.zeros_like(x)
        change = self._physics.forces(x + step, still) - self._physics.forces(x - step, still)
        felt = change[self._here][held] / (2.0 * np.abs(step).max())
        arm = (self.rest - self.rest.mean(0)) @ (1.0, 1.0j)
        reach = float(np.sqrt((np.abs(arm) ** 2).mean()))
        ways = [np.ones_like(arm), 1j * np.ones_like(arm)]
        if reach > 0.0:
            ways.append(1j * arm / reach)
        work = [float((felt.conj() * way[held]).real.sum()) for way in ways]
        moved = np.array(work) @ np.array(ways)
        farthest = float(np.abs(moved).max())
        stiffness = float(self.masses[mode] * self.omega[mode] ** 2)
        if not farthest > 1e-9 * stiffness:
            return None
        moved = (moved / farthest)[held]
        size = float((felt.conj() * moved).real.sum())
        return held, np.column_stack((moved.real, moved.imag)), size

    def marks(self, mode: int) -> Marks:
        """Find the nodes and antinodes of a mode's shape.

        A node is where the shape changes sign along a spring. Springs attached to a held mass have none.
        """
        a, b = (each.astype(np.int64) for each in ends(self.scene.linear_springs))
        shape = self.shapes[mode]
        size = np.hypot(*shape.T)
        largest = float(size.max())
        largest_beside = np.zeros(len(size))
        for one, other in ((a, b), (b, a)):
            np.maximum.at(largest_beside, one, size[other])
        # Of equal neighbours, only the first is reported.
        tops = np.flatnonzero((size >= (1.0 - _ROUNDED) * largest_beside) & (size >= _SWINGS * largest))
        near = {*zip(a.tolist(), b.tolist(), strict=True), *zip(b.tolist(), a.tolist(), strict=True)}
        antinodes: list[int] = []
        for mass in tops.tolist():
            if not any((mass, other) in near for other in antinodes):
                antinodes.append(mass)
        one, way = shape[a], shape[b] - shape[a]
        length = (way**2).sum(1)
        along = -(one * way).sum(1) / np.where(length > 0.0, length, 1.0)
        least = np.hypot(*(one + along[:, None] * way).T)
        held = np.isin(np.stack((a, b), 1), [anchor.mass for anchor in self.scene.anchors]).any(1)
        # A node at a mass is reported for the spring that begins there.
        inside = (along > -_ROUNDED) & (along < 1.0 - _ROUNDED)
        turns = (one * shape[b]).sum(1) <= _ROUNDED * largest**2
        moves = np.maximum(size[a], size[b]) > _ROUNDED * largest
        found = np.flatnonzero(inside & turns & moves & (least < _STANDS * largest) & ~held)
        nodes = [(s, round(max(float(along[s]), 0.0), 4)) for s in found.tolist()]
        return Marks(tuple(nodes), tuple(antinodes))

    # --------------------------------------------------------------------- inside
    def _pull(self, x: np.ndarray) -> float:
        """Return the energy of gravity and constant forces at positions x, kg px²/s², relative to (0, 0)."""
        return -float((self._weight.conj() * x[self._here]).real.sum())

    def _parts(self) -> tuple[Indices, list[tuple[Indices, str, Floats]]]:
        """Return the part of each mass; and for each part that can move rigidly its masses, how it can move,
        and the pivot or centre, px, or the directions."""
        body = StaticModel(self.scene, balanced=False)
        of_slot = body.parts()[self._here]
        names, part = np.unique(of_slot, return_inverse=True)
        held = np.zeros(len(part), bool)
        held[[anchor.mass for anchor in self.scene.anchors]] = True
        movable: list[tuple[Indices, str, Floats]] = []
        for number in range(len(names)):
            members = np.flatnonzero(part == number)
            pins = members[held[members]]
            if pins.size > 1:
                continue
            weight = self._mass[members, None]
            middle = (weight * self.rest[members]).sum(0) / weight.sum()
            pivot = self.rest[pins[0]] if pins.size else middle
            arm = self.rest[members] - pivot
            turn = np.column_stack((-arm[:, 1], arm[:, 0]))
            rails = [way for slot, way in ways_of(body.tables).items() if slot in self._here[members]]
            if rails:
                (x, y), turned = rails[0], max(abs(rails[0][0] * v - rails[0][1] * u) for u, v in rails)
                if not pins.size and turned < _PARALLEL:
                    along = np.tile((x, y), (len(members), 1)) / np.sqrt(weight.sum())
                    if self._stiffness(body, members, [along])[0, 0] < NOTHING:
                        movable.append((members, "slides", np.array([(x, y)])))
                continue
            motions = [turn] if pins.size else [turn, np.tile((1.0, 0.0), (len(members), 1))]
            motions += [] if pins.size else [np.tile((0.0, 1.0), (len(members), 1))]
            basis = [m / np.sqrt((weight * m**2).sum()) for m in motions if (weight * m**2).sum() > 0.0]
            stiffness = self._stiffness(body, members, basis)
            softest, ways = np.linalg.eigh(stiffness) if basis else (np.zeros(0), np.zeros((0, 0)))
            if pins.size:
                if basis and softest[0] < NOTHING:
                    movable.append((members, "turns", pivot))
            elif basis and (softest < NOTHING).all():
                movable.append((members, "floats", middle))
            else:
                across = stiffness[-2:, -2:]
                softest, ways = np.linalg.eigh(across)
                if (free := softest < NOTHING).any():
                    movable.append((members, "slides", ways[:, free].T))
        return part.astype(np.int64), movable

    def _stiffness(self, body: StaticModel, members: Indices, basis: list[Floats]) -> Floats:
        """Return the (c, c) stiffness of a part against some of its motions, 1/s²."""
        slots = self._here[members]
        step = _TRIAL * body.typical
        columns = []
        for motion in basis:
            move = np.zeros(2 * body.slots)
            size = step / max(float(np.abs(motion).max()), 1e-300)
            move[slots], move[body.slots + slots] = size * motion.T
            a = (body.accelerations(body.start + move) - body.accelerations(body.start - move)) / (2.0 * size)
            columns.append(np.column_stack((a[slots], a[body.slots + slots])))
        weight = self._mass[members, None]
        found = -np.array([[float((weight * u * a).sum()) for a in columns] for u in basis])
        return 0.5 * (found + found.T)

    def _local(self, positions: Floats, velocities: Floats) -> tuple[Floats, Floats, Floats, float]:
        """Return the displacements and velocities in frames moving with the parts, these frames, see
        `Excitation`, and the kinetic energy of their motion."""
        d, u = positions - self.rest, np.array(velocities)
        frames = np.tile((1.0, 0.0, 0.0, 0.0), (int(self.part.max(initial=0)) + 1, 1))
        whole = 0.0
        for members, how, about in self._movable:
            weight = self._mass[members]
            total = weight.sum()
            frame = frames[self.part[members[0]]]
            if how == "slides":
                # Here `about` holds the directions, of unit length.
                shift = (weight @ d[members] / total) @ about.T @ about
                speed = (weight @ u[members] / total) @ about.T @ about
                d[members] -= shift
                u[members] -= speed
                frame[2:] = shift
                whole += 0.5 * float(total * (speed**2).sum())
                continue
            z, w = positions[members] @ (1.0, 1.0j), velocities[members] @ (1.0, 1.0j)
            arm = (self.rest[members] - about) @ (1.0, 1.0j)
            middle = weight @ z / total if how == "floats" else complex(*about)
            speed = weight @ w / total if how == "floats" else 0.0
            way = z - middle
            fit = complex((weight * arm.conj()) @ way)
            turn = fit / abs(fit) if abs(fit) > 0.0 else 1.0
            inertia = float(weight @ np.abs(way) ** 2)
            spin = float(((weight * way.conj()) * (w - speed)).sum().imag) / inertia if inertia > 0.0 else 0.0
            away = way / turn - arm
            rate = (w - speed - 1j * spin * way) / turn
            d[members] = np.column_stack((away.real, away.imag))
            u[members] = np.column_stack((rate.real, rate.imag))
            moved = middle - turn * complex(*about)
            frame[:] = turn.real, turn.imag, moved.real, moved.imag
            whole += 0.5 * float(total * abs(speed) ** 2 + inertia * spin**2)
        return d, u, frames, whole


def _orthogonal(shapes: Floats, mass: Floats) -> Floats:
    """Return mass-orthogonal shapes, each scaled to its largest amplitude.

    Shapes of equal frequencies, and those of a law without an energy, need not be orthogonal as found.
    """
    if not len(shapes):
        return shapes
    root = np.sqrt(mass)[:, None]
    flat = (root * shapes).reshape(len(shapes), -1)
    q, r = np.linalg.qr(flat.T)
    found = (q * np.where(np.diag(r) < 0.0, -1.0, 1.0)).T.reshape(shapes.shape) / root
    return found / np.hypot(found[..., 0], found[..., 1]).max(1)[:, None, None]
