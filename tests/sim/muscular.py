"""Bodies with muscles."""

from __future__ import annotations

import msgspec

from sim import Beat, JointMuscle, Scene, SpringMuscle

REPLACE = msgspec.structs.replace


def with_muscles(scene: Scene, stretch: float = 0.08, turn: float = 8.0) -> Scene:
    """The scene with a muscle in every spring and every joint: sines and pulses of many phases.

    Args:
        scene: a scene of masses and springs.
        stretch: amplitude of springs, as a fraction.
        turn: of joints, degrees.
    """
    return REPLACE(
        scene,
        bodies=(),
        beat=Beat(frequency=1.7, phase=40.0),
        linear_springs=tuple(
            REPLACE(
                spring,
                muscle=SpringMuscle(
                    amplitude=stretch if s % 3 else -stretch,
                    phase=50.0 * s % 360.0,
                    wave="pulse" if s % 4 == 1 else "sine",
                    per_beat=1 + s % 2,
                ),
            )
            for s, spring in enumerate(scene.linear_springs)
        ),
        angular_springs=tuple(
            REPLACE(joint, muscle=JointMuscle(amplitude=turn, phase=35.0 * j % 360.0, wave="sine"))
            for j, joint in enumerate(scene.angular_springs)
        ),
    )
