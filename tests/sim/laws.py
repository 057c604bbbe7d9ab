"""The equations of motion under every force law, written down once more: the reference for all methods.

A vector is a complex number, x + iy: a factor of i turns it by a right angle, and the angle from spring A to
spring B is the argument of conj(A) B. Nothing is shared with the solver.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

import numpy as np
from msgspec import UnsetType
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from sim import Beat, JointMuscle, Scene, SpringMuscle
from sim.model.system import joint_stiffness
from sim.scene.types import Circle

Complexes = NDArray[np.complex128]
Points = NDArray[np.float64]
Muscle = SpringMuscle | JointMuscle | UnsetType
Path = Callable[[float], tuple[complex, complex]]
"""Time to (position, velocity)."""


def wrapped(angle: float) -> float:
    """The angle, radians, in [-pi, pi]."""
    return math.remainder(angle, 2.0 * math.pi)


def circle_path(center: complex, circle: Circle) -> Path:
    """The motion of an anchor, as the docstring of `sim.scene.Circle` has it."""

    def at(t: float) -> tuple[complex, complex]:
        turn = 2.0 * math.pi * circle.frequency
        fade = math.exp(-t / circle.ramp)
        phase, rate = turn * (t - circle.ramp * (1.0 - fade)), turn * (1.0 - fade)
        position = center + circle.radius * complex(math.sin(phase), 1.0 - math.cos(phase))
        return position, circle.radius * rate * complex(math.cos(phase), math.sin(phase))

    return at


def by_muscle(beat: Beat | UnsetType, muscle: Muscle, t: float) -> float:
    """The amplitude of a muscle times its wave, as the docstring of `sim.scene.parts.Muscle` has it."""
    if not (beat and muscle):
        return 0.0
    turns = muscle.per_beat * (beat.frequency * t + beat.phase / 360.0) + muscle.phase / 360.0
    up = math.sin(2.0 * math.pi * turns)
    return muscle.amplitude * (up if muscle.wave == "sine" else math.exp(4.0 * up - 4.0))


JOINTS: dict[str, Callable[[float], tuple[float, float]]] = {
    "tutorial": lambda off: (math.sin(off), 1.0 - math.cos(off)),
    "conservative": lambda off: (math.sin(off), 1.0 - math.cos(off)),
    "angle": lambda off: (off, 0.5 * off * off),
}
"""(torque, energy) of a joint by its deflection, radians, over its stiffness and both lengths."""


class Laws:
    """A scene's equations.

    Args:
        scene: the scene.
        paths: of held masses that move, by mass, beside those that the scene has on circles.
        growth: of the rest lengths, as held keys make them grow, 1/s.
        turn: of the rest angles likewise, degrees/s.
    """

    def __init__(
        self, scene: Scene, paths: dict[int, Path] | None = None, growth: float = 0.0, turn: float = 0.0
    ) -> None:
        self.scene = scene
        circles = {
            a.mass: circle_path(complex(*scene.masses[a.mass].position), a.circle)
            for a in scene.anchors
            if a.circle is not None
        }
        self.paths = {**circles, **(paths or {})}
        self.held = [anchor.mass for anchor in scene.anchors]
        self.mass = np.array([mass.mass for mass in scene.masses])
        self.growth, self.turn = growth, turn
        self._strength = joint_stiffness(scene)
        self.at(0.0)

    def at(self, t: float) -> None:
        """Set the rest lengths and rest angles to those of a time."""
        scale, beat = self.scene.rest_length_scale * math.exp(self.growth * t), self.scene.beat
        self.rest_lengths = [
            spring.rest_length * scale * (1.0 + by_muscle(beat, spring.muscle, t))
            for spring in self.scene.linear_springs
        ]
        self.rest_angles = [
            math.radians(joint.rest_angle + self.turn * t + by_muscle(beat, joint.muscle, t))
            for joint in self.scene.angular_springs
        ]

    def joint(self, j: int, a: complex, b: complex) -> tuple[float, float]:
        """(torque, energy) of a joint whose springs have the vectors a and b; without its damping."""
        off = wrapped(cmath.phase(a.conjugate() * b) - self.rest_angles[j])
        size = self._strength[j] * abs(a) * abs(b)
        torque, energy = JOINTS[self.scene.force_law](off)
        return size * torque, size * energy

    def forces(self, positions: Complexes, speeds: Complexes) -> Complexes:
        """What springs and joints do to each mass."""
        scene = self.scene
        force = np.zeros(len(positions), complex)

        def pull(spring: int, tension: complex) -> None:
            force[scene.linear_springs[spring].b] += tension
            force[scene.linear_springs[spring].a] -= tension

        vectors = [complex(positions[s.b] - positions[s.a]) for s in scene.linear_springs]
        rates = [complex(speeds[s.b] - speeds[s.a]) for s in scene.linear_springs]
        for i, (spring, vector, rate) in enumerate(zip(scene.linear_springs, vectors, rates, strict=True)):
            unit = vector / abs(vector)
            stretch = abs(vector) - self.rest_lengths[i]
            stretching = (unit.conjugate() * rate).real
            pull(i, -(spring.stiffness * stretch + spring.damping * stretching) * unit)
        for j, joint in enumerate(scene.angular_springs):
            a, b = vectors[joint.a], vectors[joint.b]
            torque, energy = self.joint(j, a, b)
            turning = (rates[joint.b] / b).imag - (rates[joint.a] / a).imag
            torque += joint.damping * abs(a) * abs(b) * turning
            draw = 0.0 if scene.force_law == "tutorial" else energy
            pull(joint.a, (1j * torque - draw) * a / abs(a) ** 2)
            pull(joint.b, (-1j * torque - draw) * b / abs(b) ** 2)
        return force

    def accelerations(self, positions: Complexes, speeds: Complexes) -> Complexes:
        """With gravity and air; zero where a mass is held."""
        drag = {
            "isotropic": abs(speeds) * speeds,
            "tutorial": speeds.real * abs(speeds.real) + 1j * (speeds.imag * abs(speeds.imag)),
            "linear": speeds,
        }[self.scene.air_law]
        pull = (self.forces(positions, speeds) - self.scene.air_friction * drag) / self.mass
        pull += complex(*self.scene.gravity)
        pull[self.held] = 0.0
        return pull

    def potential(self, positions: Complexes) -> float:
        """Energy of springs, joints and the height of free masses; the tutorial's law has none."""
        scene = self.scene
        vectors = [complex(positions[s.b] - positions[s.a]) for s in scene.linear_springs]
        energy = sum(
            0.5 * s.stiffness * (abs(vector) - rest) ** 2
            for s, vector, rest in zip(scene.linear_springs, vectors, self.rest_lengths, strict=True)
        )
        for j, joint in enumerate(scene.angular_springs):
            energy += self.joint(j, vectors[joint.a], vectors[joint.b])[1]
        free = np.delete(np.arange(len(positions)), self.held)
        weight = (complex(*scene.gravity).conjugate() * positions[free]).real * self.mass[free]
        return energy - float(weight.sum())

    def put_held(self, t: float, positions: Complexes, speeds: Complexes) -> None:
        """Put the held masses where they are at a time."""
        for mass in self.held:
            speeds[mass] = 0.0
            if mass in self.paths:
                positions[mass], speeds[mass] = self.paths[mass](t)

    def solution(self, times: list[float], tolerance: float = 1e-12) -> list[Points]:
        """(n, 2) positions at ascending times, all but exact: DOP853 of SciPy."""
        n = len(self.scene.masses)
        positions = np.array([complex(*mass.position) for mass in self.scene.masses])
        speeds = np.array([complex(*mass.velocity) for mass in self.scene.masses])

        def slope(t: float, state: Points) -> Points:
            both = state.view(complex)
            at, moving = both[:n].copy(), both[n:].copy()
            self.put_held(t, at, moving)
            self.at(t)
            change = np.concatenate((moving, self.accelerations(at, moving)))
            change[self.held] = 0.0
            return change.view(float)

        start = np.concatenate((positions, speeds)).view(float)
        run = solve_ivp(
            slope, (0.0, times[-1]), start, "DOP853", t_eval=times, rtol=10.0 * tolerance, atol=tolerance
        )
        assert run.success
        found = []
        for t, state in zip(run.t, run.y.T, strict=True):
            both = np.ascontiguousarray(state).view(complex)
            at, moving = both[:n].copy(), both[n:].copy()
            self.put_held(t, at, moving)
            found.append(points(at))
        return found


def points(vectors: Complexes) -> Points:
    """(n, 2) of complex numbers."""
    return np.column_stack((vectors.real, vectors.imag))


def complexes(pairs: Points) -> Complexes:
    """Complex numbers of (n, 2)."""
    return pairs[:, 0] + 1j * pairs[:, 1]
