"""How much of each slow vibration is in a motion, and how a body is put into one.

About the pose at rest r, small vibrations have angular frequencies w_i and shapes s_i with s_iᵀ M s_j = 0 for
i ≠ j, where M is the diagonal matrix of the masses. A displacement d from r has the amplitude
q_i = s_iᵀ M d / (s_iᵀ M s_i) of shape i, and a velocity u has the rate u_i in the same way. The vibration
has the energy ½ (s_iᵀ M s_i) (u_i² + w_i² q_i²).

Motions of a part as a whole that nothing resists, such as those of a body that flies, are taken out first:
displacements are measured in a frame that goes along. A part that floats has the frame that comes nearest to
its masses in the mean, weighted by their masses (Eckart, "Some studies concerning rotating axes and
polyatomic molecules", 1935; Kabsch 1976 for how it is found).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..engine.tables import Floats, Indices
from ..errors import InputError
from ..forces.all import TERMS
from ..forces.reference import Physics
from ..model.state import start_of
from ..model.system import build_system, for_analysis
from ..motion.moment import Moment
from ..scene.columns import ends
from ..scene.types import Scene
from ..scene.validate import validate
from .decay import Decay
from .equilibrium import StaticModel
from .tuning import Dampers, vibrations_at_rest
from .vibrations import MAX_MASSES, NOTHING, Vibrations

MAX_TOUCHING = 200
"""Largest number of masses of a body with contact, whose rest may take long to find."""
_TRIAL = 1e-4
"""Size of a displacement by which stiffness against a motion as a whole is found, in lengths of a spring."""
_STANDS = 0.2
"""Amplitude, as a part of the largest, below which a place on a spring can be a node."""
_SWINGS = 0.4
"""And from which on a mass can be an antinode."""
_ROUNDED = 1e-6
"""Part of the largest amplitude, or of a spring, that may be rounding."""
_TOUCHING = tuple(term.name for term in TERMS if term.touches)
"""Terms whose energy is that of what is pressed together."""


@dataclass(frozen=True)
class Marks:
    """Where a shape stands still, and where it swings most.

    Attributes:
        nodes: of each node a spring and how far along it the node is, 0..1.
        antinodes: masses.
    """

    nodes: tuple[tuple[int, float], ...]
    antinodes: tuple[int, ...]


@dataclass(frozen=True)
class Excitation:
    """How much of each mode is in a motion.

    Attributes:
        amplitudes: (k,) present displacement in each mode, of the mass that its shape moves most, px.
        rates: (k,) the same of the velocity, px/s.
        energies: (k,) of each mode, kg px²/s².
        whole: kinetic energy of motions of parts as a whole that nothing resists, kg px²/s².
        others: energy above that at rest which is in none of them, kg px²/s²: of faster modes, and what a
            large motion has beyond small ones. It may be below zero, where the body is softer far from rest.
        touching: energy of that in walls and in contact, kg px²/s².
        frames: (P, 4) how each part lies: cosine and sine of the angle by which it is turned from the pose at
            rest, and by how much it is moved then, px.
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
        scene: a valid scene of at most 1000 masses. Its pose, if it has one, is where rest is looked for.
        count: number of modes at most, from 1.

    Attributes:
        scene: in the pose at rest, see `sim.tuning`.
        rest: (n, 2) that pose, px.
        omega: (k,) angular frequencies, rad/s, the slowest first; k may be less than the count, or 0.
        shapes: (k, n, 2) amplitude of each mass relative to the largest. They are orthogonal by the masses.
        masses: (k,) modal masses s_iᵀ M s_i, kg.
        damping_ratios: (k,) see `sim.Vibration`.
        part: (n,) the part that each mass belongs to; parts are what springs that are not broken connect.

    Raises:
        SceneError: the scene is not valid.
        InputError: it has more than 1000 masses, or 200 where they can touch each other, or it moves away
            from its pose by itself.
    """

    def __init__(self, scene: Scene, count: int) -> None:
        scene = validate(scene)
        if len(scene.masses) > MAX_MASSES:
            raise InputError(f"modes: {len(scene.masses)} masses are more than {MAX_MASSES}")
        if len(scene.masses) > MAX_TOUCHING and scene.contact is not None:
            raise InputError(
                f"modes: a body with contact may have {MAX_TOUCHING} masses, this has {len(scene.masses)}"
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
        loads = np.array([mass.force or (0.0, 0.0) for mass in self.scene.masses]) @ (1.0, 1.0j)
        self._weight = free * (self._mass * complex(*self.scene.gravity) + loads)
        x = self._state.x + 1j * self._state.y
        self.rest = x[self._here].view(np.float64).reshape(-1, 2)
        self._at_rest = sum(self._physics.energies(x).values()) + self._pull(x)
        self.part, self._movable = self._parts()

    @property
    def frequencies(self) -> Floats:
        """(k,) Hz."""
        return self.omega / math.tau

    @cached_property
    def damping_ratios(self) -> Floats:
        """See above."""
        dampers = Dampers(self.scene)
        decay = Decay(dampers, Vibrations(self.omega, self.shapes), self._mass)
        return decay.rates(dampers.numbers.damping, dampers.numbers.joint_damping) / self.omega

    @property
    def size(self) -> float:
        """Diagonal of what the body takes at rest, px."""
        return float(np.hypot(*np.ptp(self.rest, axis=0)))

    def excitation(self, positions: Floats, velocities: Floats) -> Excitation:
        """How much of each mode is in a motion.

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

    def amplitude_of(self, mode: int, energy: float) -> float:
        """The amplitude of a mode that has an energy in kg px²/s², px."""
        return float(np.sqrt(2.0 * energy / self.masses[mode]) / self.omega[mode])

    def put(self, moment: Moment, mode: int, amplitude: float) -> Moment:
        """A moment with another amplitude of a mode; all that is in other modes stays.

        What is lacking is added as velocity, in the sense in which the mode moves, so that nothing is
        strained that a large shape would strain. A displacement that is too large becomes the amplitude.

        Args:
            moment: of the scene that the modes are of.
            mode: which, from 0.
            amplitude: of the mass that its shape moves most, 0 px or more.

        Raises:
            InputError: there is no such mode, or the amplitude is not finite or below zero.
        """
        if not 0 <= mode < self.omega.size:
            raise InputError(f"modes: there is no mode {mode}; there are {self.omega.size}")
        if not 0.0 <= amplitude < np.inf:
            raise InputError(f"modes: an amplitude of {amplitude} is not in the range 0.. px")
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
        """How the held masses drive a mode best that move together, as if the ground shook: so, nothing is
        strained but what swings.

        Of all small motions of the ground, shifts and turns, it is that with which they do most work on the
        mode for the distance that the body would move in the mean, if it were rigid.

        Args:
            mode: which, from 0.

        Returns:
            the masses (a,); how they move (a, 2), if the farthest mass of a rigid body would move by 1; and
            the force on the mode when that is 1 px, kg/s². None where no held mass feels the mode.
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
        """Where a mode's shape stands still, and where it swings most.

        A node is where the shape along a spring changes its side. Springs that hold a held mass have none.
        """
        a, b = (each.astype(np.int64) for each in ends(self.scene.linear_springs))
        shape = self.shapes[mode]
        size = np.hypot(*shape.T)
        largest = float(size.max())
        largest_beside = np.zeros(len(size))
        for one, other in ((a, b), (b, a)):
            np.maximum.at(largest_beside, one, size[other])
        # Of equals beside each other, the first one is told.
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
        # One at a mass is told of the spring that begins there.
        inside = (along > -_ROUNDED) & (along < 1.0 - _ROUNDED)
        turns = (one * shape[b]).sum(1) <= _ROUNDED * largest**2
        moves = np.maximum(size[a], size[b]) > _ROUNDED * largest
        found = np.flatnonzero(inside & turns & moves & (least < _STANDS * largest) & ~held)
        nodes = [(s, round(max(float(along[s]), 0.0), 4)) for s in found.tolist()]
        return Marks(tuple(nodes), tuple(antinodes))

    # --------------------------------------------------------------------- inside
    def _pull(self, x: np.ndarray) -> float:
        """Energy of gravity and constant forces at positions x, kg px²/s², counted from (0, 0)."""
        return -float((self._weight.conj() * x[self._here]).real.sum())

    def _parts(self) -> tuple[Indices, list[tuple[Indices, str, Floats]]]:
        """The part of each mass; and of those that can move as a whole their masses, how they can, and about
        where, px, or in which directions."""
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
        """(c, c) the stiffness of a part against some of its motions, 1/s²."""
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
        """Displacements and velocities in the frames that go along with the parts, these frames, see
        `Excitation`, and the kinetic energy of their motion."""
        d, u = positions - self.rest, np.array(velocities)
        frames = np.tile((1.0, 0.0, 0.0, 0.0), (int(self.part.max(initial=0)) + 1, 1))
        whole = 0.0
        for members, how, about in self._movable:
            weight = self._mass[members]
            total = weight.sum()
            frame = frames[self.part[members[0]]]
            if how == "slides":
                # About: the directions, of unit length.
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
    """Shapes that are orthogonal by the masses, each relative to its largest amplitude.

    Those of equal frequencies, and those of a law without an energy, are found as they come.
    """
    if not len(shapes):
        return shapes
    root = np.sqrt(mass)[:, None]
    flat = (root * shapes).reshape(len(shapes), -1)
    q, r = np.linalg.qr(flat.T)
    found = (q * np.where(np.diag(r) < 0.0, -1.0, 1.0)).T.reshape(shapes.shape) / root
    return found / np.hypot(found[..., 0], found[..., 1]).max(1)[:, None, None]
