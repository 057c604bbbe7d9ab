"""Messages to a page about what is measured on its canvas."""

from __future__ import annotations

from ...wire.messages import Event, Numbers, State
from ...wire.sections import Section


class Tools(State, frozen=True, kw_only=True):
    """What is measured on the canvas.

    Attributes:
        traced: masses whose paths are drawn.
        seconds: length of a path in simulated time, s.
        chosen: the mass that was clicked last, or -1.
        coordinates: whether a label shows position and speed of a mass.
        strobe: simulated s between two images of the stroboscope; 0 while it is off.
    """

    traced: tuple[int, ...] = ()
    seconds: int = 5
    chosen: int = -1
    coordinates: bool = False
    strobe: float = 0.0


class PutBack(Event, frozen=True, kw_only=True):
    """Another scene was opened: the instruments on the canvas go back into the box."""


class Arrows(Numbers, frozen=True, kw_only=True):
    """Forces, velocities and torques; empty while no arrows are shown."""

    sections = (
        Section(
            "head",
            numbers={
                "generation": "of the body",
                "time": "simulated seconds",
                "step": "every how manyth mass has an arrow; held ones always have",
                "joint_step": "every how manyth joint",
            },
        ),
        Section("least", "negligible force, speed and torque"),
        Section("held", "masses that are held"),
        Section("forces", "x and y of each"),
        Section("velocities", "x and y of each"),
        Section("torques", "one each"),
    )
