"""The scenes of the validation. Masses of 1 kg are 1 px apart, unless noted otherwise."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

import sim
from sim import Anchor, AngularSpring, Integrator, LinearSpring, Mass, Pose, Scene
from sim.scene.types import ForceLaw

Point = tuple[float, float]


def chain(
    positions: Sequence[Point],
    *,
    stiffness: float,
    held: Sequence[int],
    angular_stiffness: float | None = None,
    rest_angle: float = 0.0,
    rest_length: float = 1.0,
    masses: Sequence[float] | None = None,
    gravity: float = 0.0,
    damping: float = 0.0,
    law: ForceLaw = "conservative",
    integrator: Integrator | None = None,
) -> Scene:
    """Return a chain through some positions, with equal springs; gravity is along +y.

    Args:
        angular_stiffness: None for no joints.
        rest_angle: of every joint, degrees.
        masses: kg each; None for 1 kg each.
    """
    n = len(positions)
    joints = range(n - 2 if angular_stiffness is not None else 0)
    return sim.validate(
        Scene(
            name="study",
            masses=tuple(
                Mass(position=position, mass=mass)
                for position, mass in zip(positions, masses or [1.0] * n, strict=True)
            ),
            linear_springs=tuple(
                LinearSpring(a=i, b=i + 1, stiffness=stiffness, damping=damping, rest_length=rest_length)
                for i in range(n - 1)
            ),
            angular_springs=tuple(
                AngularSpring(a=j, b=j + 1, stiffness=angular_stiffness or 0.0, rest_angle=rest_angle)
                for j in joints
            ),
            anchors=tuple(Anchor(mass=i) for i in held),
            gravity=(0.0, gravity),
            force_law=law,
            integrator=integrator or Integrator(),
        )
    )


def straight(segments: int) -> list[Point]:
    """Return the positions of masses 0..N along x."""
    return [(float(i), 0.0) for i in range(segments + 1)]


def beam_length(segments: int) -> float:
    """Return the length of the beam that a chain of N springs models if its first two masses are held.

    It is clamped in the middle between those two: N - 1/2 spacings.
    """
    return segments - 0.5


def cantilever(segments: int, weight: float = 0.0, tip: float = 0.0, law: ForceLaw = "conservative") -> Scene:
    """Return a chain as a beam that is clamped horizontally at one end.

    EI = K h³ = 1. The last mass is half a mass, since it stands for half a spacing of the beam. Springs are
    so stiff that they stretch by a millionth.

    Args:
        segments: N, springs; masses 0 and 1 are held.
        weight: Gamma = w L³ / EI.
        tip: P L² / EI, a load at the end; the weight of the other masses is then negligible.
        law: the force law.
    """
    length = beam_length(segments)
    gravity = (weight / length + tip) / length**2
    masses = [1.0] * segments + [0.5]
    if tip:
        masses, gravity = [1e-6] * segments + [1e4], 1e-4 * gravity
    return chain(
        straight(segments),
        stiffness=max(1e5, 1e6 * gravity * sum(masses[2:])),
        angular_stiffness=1.0,
        held=(0, 1),
        masses=masses,
        gravity=gravity,
        law=law,
    )


def hanging_rope(segments: int) -> Scene:
    """Return a rope without bending stiffness that hangs from mass 0, in 1 px/s²; its last mass is half."""
    return chain(
        [(0.0, float(i)) for i in range(segments + 1)],
        stiffness=1e6 * segments,
        held=(0,),
        masses=[1.0] * segments + [0.5],
        gravity=1.0,
    )


def sagging_rope(segments: int, length: float) -> Scene:
    """Return a rope without bending stiffness between two points of the same height, in the shape of a V.

    Args:
        segments: N, even; the length of the rope is N px, its weight per length 1.
        length: of the rope, in spans.
    """
    span = segments / length
    across = span / segments
    down = (1.0 - across**2) ** 0.5
    positions = [(i * across, down * min(i, segments - i)) for i in range(segments + 1)]
    return chain(positions, stiffness=1e7 * segments, held=(0, segments), gravity=1.0)


def rolled(segments: int) -> Scene:
    """Return a straight chain whose joints have a rest angle of 360°/N; masses 0 and 1 are held."""
    return chain(
        straight(segments), stiffness=1e3, angular_stiffness=1.0, rest_angle=360.0 / segments, held=(0, 1)
    )


def at(scene: Scene, pose: Pose) -> Scene:
    """Return the scene, started from a pose."""
    return replace(scene, pose=pose)
