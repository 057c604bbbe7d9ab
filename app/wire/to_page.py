"""Messages to a page's script that belong to no feature."""

from __future__ import annotations

from typing import Literal

from .messages import CommandName, Event, Numbers, State
from .sections import Section


# ------------------------------------------------------------------------- states
class PageState(State, frozen=True, kw_only=True, omit_defaults=True):
    """The state of the session and of the page.

    Attributes:
        page: id of the connection.
        scene: number of the opened scene.
        title: the scene's title.
        width, height: size of the scene's frame, in the page's world.
        view: left, right, low and high end of the body's first motion, in the page's world; empty while they
            are not known.
        unit: unit of lengths.
        joint: index of the joint that is read out; -1 for none.
        playing: the clock runs, or will as soon as a heavy step is done.
        rest: the body stands while the clock runs, so that no frames are sent.
        scrubbed: a moment of the past is shown.
        start, end: of the past that can be shown, s; the end only while a moment of it is shown.
        speed: simulated seconds per second.
        offer: going back to before an explosion is offered.
        future: what happened before the user went back is shown.
        follow: the driven mass follows the pointer.
        arrows: the arrow keys that do anything, such as "left", which are the buttons of the arrow pad.
        broken: number of broken springs.
        controls: names of the page's controls.
        gizmos, meter: switches of the View menu.
        measuring: id of the Measure tab; empty without one.
        lesson: a step of the scene's lesson has begun; None without a lesson.
    """

    page: str
    scene: int
    title: str
    width: float
    height: float
    view: tuple[float, ...] = ()
    unit: str
    joint: int = -1
    playing: bool = False
    rest: bool = False
    scrubbed: bool = False
    start: float = 0.0
    end: float = 0.0
    speed: float = 1.0
    offer: bool = False
    future: bool = False
    follow: bool = False
    arrows: tuple[str, ...] = ()
    broken: int = 0
    controls: tuple[str, ...] = ()
    gizmos: bool = False
    meter: bool = False
    measuring: str = ""
    lesson: bool | None = None


class Hud(State, frozen=True, kw_only=True):
    """The head-up display over the canvas, HTML."""

    html: str


class Keepsake(State, frozen=True, kw_only=True):
    """The state that the browser stores and returns after a reload or an outage, see `keeping`: JSON."""

    kept: str


# ------------------------------------------------------------------------- numbers
class Plan(Numbers, frozen=True, kw_only=True):
    """The parts and the surroundings of a body."""

    sections = (
        Section(
            "head",
            numbers={
                "generation": "which body this is; frames carry the same number",
                "scale": "from px to the page's world",
                "x": "the middle of the scene's frame, px",
                "y": "the middle of the scene's frame, px",
                "flip": "-1 where y grows downwards",
                "many?": "whether there are so many masses that they are drawn with less",
                "bars?": "whether springs are bars instead of coils",
                "slices": "triangles of a wedge",
                "driven": "the mass that the pointer drives, or -1",
            },
        ),
        Section("radius", "of each mass, in the world"),
        Section("springs", "two masses each"),
        Section("rest_length", "px, one for each spring"),
        Section("thickness", "amplitude of the coil or width of the bar, in the world"),
        Section("full_strain", "relative stretch at which each spring has its full colour; or one for all"),
        Section("joints", "spring a, spring b, the mass at the tip, and whether b leaves it (1) or not (-1)"),
        Section("rest_angle", "degrees"),
        Section("pinned", "the held masses that have a support"),
        Section("mass_colors", "three a mass: of rim, fill and shine"),
        Section("strain_colors", "a table, from full compression to full stretch"),
        Section("turn_colors", "a table, from the full negative deviation to the full positive one"),
        Section("ink_colors", "of pins, ring, ghost and the mark of springs that have yielded"),
        Section("walls", "of each a point of the surface, px, and the unit vector to the free side"),
        Section("belts", "of each wall px/s to the right of its normal on the screen; nothing if none runs"),
        Section("rails", "of each a point, px, and a unit vector across it"),
        Section("fillings", "of each whether it is a gas, how many masses its loop has, and which"),
        Section(
            "wind", "velocity, px/s; of each wave of its gusts wave vector, amplitude and phase; or nothing"
        ),
        Section(
            "contact_of",
            numbers={"contact": "px, the distance at which contact begins; 0 where there is none"},
        ),
        Section("ropes", "the springs that only pull"),
        Section("buffers", "the springs that only push"),
        Section(
            "stops", "of each joint that acts on one side which it is, and 1 above or -1 below its rest angle"
        ),
        Section("loads", "of each constant force which mass it acts on, and its arrow, in the world"),
        Section(
            "muscles",
            "frequency, Hz, and phase of the beat, and of each muscle what swing.js says; or nothing",
        ),
        Section("muscle_colors", "a table, from a muscle at its longest to one at its shortest"),
        Section(
            "resists",
            numbers={
                "medium?": "whether the body is in a medium",
                "ground?": "whether it lies on the ground, seen from above",
            },
        ),
        Section(
            "motors",
            "of each its joint, the sign of its speed, its keys: 0 Left and Right, 1 Up and Down, -1 none",
        ),
        Section("pushes", "of each force that keys work its mass, its arrow, in the world, and its keys"),
    )


class SecondPlan(Numbers, frozen=True, kw_only=True):
    """The plan of a second body; the positions of its masses are in the frames."""


_MOMENT = {
    "time": "simulated seconds",
    "length_scale": "factor of all rest lengths",
    "angle_shift": "degrees added to all rest angles",
    "time_rest": "what a time in single precision lacks, s",
}


class Frame(Numbers, frozen=True, kw_only=True):
    """The positions of the masses.

    Attributes:
        wall: time at which it was made, s of a monotonic clock.
    """

    wall: float

    sections = (
        Section("moment", numbers={"generation": "of the body", **_MOMENT}),
        Section("positions", "px, x and y of each mass"),
        Section("ghost", "px, of a second body with the same plan"),
        Section("second_moment", "of a second body with a plan of its own: " + ", ".join(_MOMENT)),
        Section("second_positions", "px, x and y of each of its masses"),
        Section("efforts", "of Left and Right, of Up and Down: from -1 to 1; nothing where none was held"),
        Section("second_efforts", "as `efforts`, of a second body with a plan of its own"),
    )


class Damage(Numbers, frozen=True, kw_only=True):
    """Yielded and broken springs; sent only when that changes."""

    sections = (
        Section("head", numbers={"generation": "of the body"}),
        Section("broken", "the springs that are broken"),
        Section("set_length", "px by which each rest length has moved for good; empty if none has"),
        Section("set_angle", "degrees by which each rest angle has moved for good; empty if none has"),
        Section("ghost_broken", "the broken springs of a second body with the same plan"),
        Section("second_broken", "as `broken`, of a second body with a plan of its own"),
        Section("second_set_length", "as `set_length`, of that"),
        Section("second_set_angle", "as `set_angle`, of that"),
    )


# ------------------------------------------------------------------------- events
class ControlLook(Event, frozen=True, kw_only=True, omit_defaults=True):
    """What viser's messages lack of a control of the panel.

    Attributes:
        id: of the control.
        unit: of its number.
        low, high: the numbers that its box allows; None for no bound.
        logarithmic: equal steps of its slider are equal factors.
        own: the scene's own value, which a double click on the slider restores; None without one.
        place: "card" for a button with a note below its label; "beside" for one that stands beside the card
            above it, as an icon; "below" for what stands below its neighbours on a phone.
        note: what a button does, where its label is something else.
        picture: name of a preset's small picture, in place of a button's icon.
    """

    id: str
    unit: str = ""
    low: float | None = None
    high: float | None = None
    logarithmic: bool = False
    own: float | None = None
    place: Literal["", "card", "beside", "below"] = ""
    note: str = ""
    picture: str = ""


class Run(Event, frozen=True, kw_only=True):
    """Execute a command of the page's script, see `app.ui.commands`."""

    command: CommandName


class Resumed(Event, frozen=True, kw_only=True):
    """The server has received the saved state."""
