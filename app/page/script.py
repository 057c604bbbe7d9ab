"""What is told to the page's script (in `static`), and the messages that it sends.

viser puts the content of an HTML element into the page as it is: what comes from users is escaped.
"""

from __future__ import annotations

import html
import math
import re
from dataclasses import dataclass
from typing import Literal

from sim.scene.types import shown_name

from ..drawing.sketch import WORLD_SIZE, Mapping
from ..session import commands
from ..session.commands import Command
from ..session.session import Session

_KEYS = {"U": "up", "D": "down", "L": "left", "R": "right"}
_NUMBER = r"-?\d{1,7}(?:\.\d{1,6})?"
_MESSAGE = re.compile(
    rf"\d{{1,15}}\|(?:keys\|([UDLR]{{0,4}})|at\|((?:\d:{_NUMBER},{_NUMBER};){{1,10}})|do\|([a-z]{{1,10}})"
    rf"|go\|({_NUMBER})|speed\|({_NUMBER})"
    rf"|grab\|(\d)\|(\d{{1,6}})\|({_NUMBER}),({_NUMBER})|drop\|(\d)|pick\|(\d{{1,6}})"
    r"|lesson\|(\d{1,2})\|(run|wait|on))"
)
_PART = re.compile(r"\d{1,15}\|(resume|link|paste)\|(\d{1,2})/(\d{1,2})\|([\x21-\x7e]{0,48000})")

ONCE: dict[str, Command] = {
    "play": commands.Play(),
    "pause": commands.Play(False),
    "run": commands.Play(True),
    "step": commands.DoSteps(1),
    "steps": commands.DoSteps(10),
    "reset": commands.Reset(),
    "back": commands.GoBack(),
    "second": commands.GoBack(1.0),
    "forward": commands.GoForward(),
    "before": commands.BackBeforeDivergence(),
    "forget": commands.ForgetFuture(),
    "visit": commands.Visit(),
}
"""Commands that the script sends by a word; those in `_ASKED` are no commands, but words besides."""


def style_html(sliders: list[tuple[str, str]], outlined: list[str], beside: str = "") -> str:
    """The styles of controls, which go by the ids that viser gives them.

    Args:
        sliders: ids of sliders, each with that of the number box that stands in place of the slider's own.
        outlined: ids of buttons that are drawn as an outline.
        beside: id of a button that stands beside the control before it, as its icon.
    """
    rows = ",".join(f'div:has(>[id="{slider}"])' for slider, _ in sliders)
    boxes = ",".join(f'.mantine-NumberInput-root:has([id="{box}"])' for _, box in sliders)
    own = ",".join(f'div:has(>[id="{slider}"])>.mantine-InputWrapper-root' for slider, _ in sliders)
    rules = ""
    if sliders:
        rules = f"{own}{{display:none}}"
        rules += f"{rows}{{padding-right:5.6em}}{boxes}{{width:5.2em;margin:-1.75em 0 0 auto;z-index:4}}"
    if outlined:
        buttons = ",".join(f'button[id="{button}"]' for button in outlined)
        rules += f":is({buttons}){{background:transparent;color:var(--softrod-text);"
        rules += "border:1px solid var(--softrod-text)}"
        # The library's own colour of the text under the pointer is that of a filled button.
        rules += f":is({buttons}):hover{{background:var(--softrod-key);color:var(--softrod-text)}}"
        rules += f":is({buttons}):disabled{{opacity:0.45}}"
    if beside:
        rules += f'div:has(+div>[id="{beside}"]){{padding-right:46px!important}}'
        rules += f'div:has(>[id="{beside}"]){{width:30px;margin:-34px 10px 0 auto!important}}'
        rules += f'[id="{beside}"]{{width:30px;height:26px!important;padding:0;font-size:0}}'
        rules += f'[id="{beside}"] .mantine-Button-section{{margin:0!important;font-size:14px}}'
        rules += f'[id="{beside}"] svg{{left:0!important}}'
    return f"<style>/* softrod */{rules}</style>"


def told(
    channel: str,
    scene: str,
    session: Session,
    playing: bool,
    at_rest: bool,
    broken: int,
    measures: int,
    pictures: int,
) -> dict[str, object]:
    """What the script has to know.

    Args:
        channel: id of the hidden text element that it sends through.
        scene: another text for every scene, or for every time that it is to be fitted to the window.
        session: whose history and switches they are.
        playing: whether the clock runs, or will as soon as a heavy step is done.
        at_rest: whether the body stands while the clock runs, so that no pictures come.
        broken: how many springs are broken.
        measures: how often the Measure tab was to be shown.
        pictures: how many pictures of the page were asked for.
    """
    frame, history = session.scene.view.frame, session.history
    size = WORLD_SIZE / max(frame[2] - frame[0], frame[3] - frame[1])
    scrubbed = history.scrubbed
    return {
        "channel": channel,
        "scene": scene,
        "title": shown_name(session.scene),
        "width": (frame[2] - frame[0]) * size,
        "height": (frame[3] - frame[1]) * size,
        "follow": int(session.follow),
        "joint": session.joint if session.scene.angular_springs else -1,
        "unit": session.scene.view.unit,
        "playing": int(playing),
        "rest": int(at_rest),
        "scrubbed": int(scrubbed),
        # Coarse while time passes, so that this seldom changes.
        "start": history.start if scrubbed else math.floor(2.0 * history.start) / 2.0,
        "end": history.end if scrubbed else "",
        "speed": session.pacer.speed,
        "offer": int(session.offer_back),
        "future": int(session.old_future is not None),
        **({"broken": broken} if broken else {}),
        **({"measures": measures} if measures else {}),
        **({"picture": pictures} if pictures else {}),
        **({"lesson": int(session.lesson_begun)} if session.scene.lesson else {}),
    }


def told_html(told: dict[str, object]) -> str:
    """The hidden element whose attributes the script reads."""
    attributes = " ".join(f'data-{name}="{html.escape(str(value))}"' for name, value in told.items())
    return f'<div id="softrod-state" hidden {attributes}></div>'


@dataclass(frozen=True)
class Pick:
    """A mass was clicked."""

    mass: int


@dataclass(frozen=True)
class Switch:
    """The switch that has the driven mass follow the pointer was pressed."""


@dataclass(frozen=True)
class PlotAngle:
    """The angle of the joint that is read out is to be plotted."""


@dataclass(frozen=True)
class Look:
    """In which tab somebody sees plots; empty for none."""

    tab: Literal["measure", "lesson", ""]


@dataclass(frozen=True)
class View:
    """A switch of the View menu: "dark", "gizmos", "meter"."""

    what: str
    on: bool


@dataclass(frozen=True)
class ShowHelp:
    """The help is to be shown."""


@dataclass(frozen=True)
class Begin:
    """The page goes to a step of the scene's lesson.

    Attributes:
        step: which.
        how: "run" or "wait": it begins; the body waits if there is a question. "on": the page goes on in the
            middle of it, as after a reload.
    """

    step: int
    how: Literal["run", "wait", "on"] = "wait"


Word = Switch | PlotAngle | Look | View | ShowHelp

_ASKED: dict[str, Word] = {
    "follow": Switch(),
    "plot": PlotAngle(),
    "look": Look("measure"),
    "lesson": Look("lesson"),
    "away": Look(""),
    "help": ShowHelp(),
    "dark": View("dark", True),
    "light": View("dark", False),
    "gizmos": View("gizmos", True),
    "nogizmos": View("gizmos", False),
    "meter": View("meter", True),
    "nometer": View("meter", False),
}


def parse(message: object, mapping: Mapping) -> Command | Word | Pick | Begin | None:
    """What a message of the script asks for, or None for nonsense.

    Args:
        message: the value of the hidden text element, which any client can set to anything.
        mapping: from the page's world to px.
    """
    match = _MESSAGE.fullmatch(message) if isinstance(message, str) else None
    if match is None:
        return None
    keys, places, word, time, speed, hand, mass, grab_x, grab_y, empty, picked, step, how = match.groups()
    if keys is not None:
        return commands.HoldKeys(frozenset(_KEYS[key] for key in keys))
    if word is not None:
        return _ASKED.get(word) or ONCE.get(word)
    if time is not None:
        return commands.GoTo(float(time))
    if speed is not None:
        return commands.Speed(float(speed))
    if empty is not None:
        return commands.DragEnd(int(empty))
    if picked is not None:
        return Pick(int(picked))
    if step is not None:
        return Begin(int(step), how)  # type: ignore[arg-type]
    if mass is not None:
        point = mapping.to_scene(float(grab_x), float(grab_y))
        return commands.DragStart(int(mass), *point, int(hand)) if all(map(math.isfinite, point)) else None
    points = [_point_of(place, mapping) for place in places[:-1].split(";")]
    if not all(math.isfinite(point.x) and math.isfinite(point.y) for point in points):
        return None
    return points[0] if len(points) == 1 else commands.Points(tuple(points))


def _point_of(place: str, mapping: Mapping) -> commands.Point:
    """A hand and its place, as in "0:1.5,-0.5"."""
    hand, x, y = re.split("[:,]", place)
    return commands.Point(*mapping.to_scene(float(x), float(y)), int(hand))


@dataclass(frozen=True)
class Part:
    """A part of what is too long for one message: a keepsake ("resume"), a link, or what is pasted.

    Attributes:
        number, of: from 1; how many parts there are.
        letters: neither spaces nor line breaks are among them.
    """

    kind: str
    number: int
    of: int
    letters: str


def parse_part(message: object) -> Part | None:
    """The part in a message of the script; None for nonsense."""
    match = _PART.fullmatch(message) if isinstance(message, str) else None
    return Part(match[1], int(match[2]), int(match[3]), match[4]) if match else None
