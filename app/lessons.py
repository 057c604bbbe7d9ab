"""Lessons: a check that every step can begin, for `softrod check`; their codes; goals in words."""

from __future__ import annotations

import contextlib
import hashlib
import re
from collections.abc import Iterator

import msgspec

import sim
from sim.errors import InputError
from sim.motion.quantities import quantity
from sim.scene.lesson import Goal, Reading, Step, StepRun
from sim.settings import CHOICES, scene_of_run, scene_of_step, setting_of
from sim.solve.registry import METHODS
from sim.text import Text

from .session.ghost import REFERENCE
from .session.plots import Plot, parse_plot
from .words import decimal, joined, number, say, upright
from .words.keys import Key
from .words.quantities import quantity_of
from .words.settings import label_of, label_of_choice, options_of

MAX_TOLD = 3
"""Pulls of a run that are told one by one."""

_NAME = re.compile(r"(?:(mass|spring|joint)(\d+)|[a-z]+)\.([a-z_]+)", re.ASCII)
"""The name of a quantity: what it is of, with its number, and what it is."""

_WORDS: dict[str, Key] = {
    "elongation": "reading-stretch",
    "force": "reading-force",
    "length": "reading-length",
    "angle": "reading-angle",
    "torque": "reading-torque",
    "speed": "reading-speed",
    "vx": "reading-vx",
    "vy": "reading-vy",
    "momentum_x": "reading-momentum-x",
    "momentum_y": "reading-momentum-y",
    "distance": "reading-distance",
    "dt_over_limit": "reading-time-step",
}
"""What quantities are called for pupils; all others as in the Measure tab."""


def check_lesson(scene: sim.Scene) -> None:
    """Check what each step sets, shows and plots, one after the other.

    Raises:
        SettingError: something cannot be set, or has no slider; names the field.
        InputError: something cannot be plotted, compared or measured; names the field.
    """
    for at, step in enumerate(scene.lesson.steps if scene.lesson else ()):
        place = f"lesson.steps[{at}]"
        scene_of_run(scene, at)
        scene = scene_of_step(scene, at)
        for i, key in enumerate(step.controls):
            if key not in CHOICES or not CHOICES[key].applies(scene):
                with _at(f"{place}.controls[{i}]"):
                    setting_of(scene, key)
        if step.ghost is not None and step.ghost not in (REFERENCE, *METHODS):
            known = ", ".join((REFERENCE, *METHODS))
            raise InputError(f"{place}.ghost: {step.ghost!r} is not one of {known}")
        for i, text in enumerate(step.plots or ()):
            with _at(f"{place}.plots[{i}]"):
                Plot(parse_plot(text), scene)
        for field, reading in (("goal", step.goal), ("collect", step.collect)):
            if reading is not None:
                with _at(f"{place}.{field}.quantity"):
                    quantity(reading.quantity, scene)


@contextlib.contextmanager
def _at(place: str) -> Iterator[None]:
    """Have errors name the field."""
    try:
        yield
    except (sim.SettingError, InputError) as error:
        raise type(error)(Text("{place}: {error}", place=place, error=str(error))) from None


def lesson_code(scene: sim.Scene) -> str:
    """Eight hexadecimal digits that link answers to the lesson of a scene.

    They depend on questions, choices, predictions and the number of masses. The rest of a lesson may be
    corrected without losing its answers.
    """
    steps = scene.lesson.steps if scene.lesson is not None else ()
    asked = [
        (step.question.text, step.question.choices, step.predict) if step.question else ("", (), step.predict)
        for step in steps
    ]
    return hashlib.sha256(msgspec.json.encode((len(scene.masses), asked))).hexdigest()[:8]


def read_masses(step: Step, scene: sim.Scene) -> tuple[int, ...]:
    """The masses that a step reads: those of its plots, of its goal, and of what it collects.

    Of a joint they are the ends of its springs that it does not share, of a spring both ends, of a formula
    those of its quantities.
    """
    names = [name for text in step.plots or () for name in (*parse_plot(text).names, parse_plot(text).over)]
    names += [reading.quantity for reading in (step.goal, step.collect) if reading is not None]
    found: set[int] = set()
    springs = scene.linear_springs
    for each in (each for name in names for each in _measured(name, scene)):
        if each.kind.of in ("mass", "body"):
            found.update(each.indices)
        elif each.kind.of == "spring":
            found |= {springs[each.index].a, springs[each.index].b}
        elif each.kind.of == "joint":
            joint = scene.angular_springs[each.index]
            one, other = ({springs[s].a, springs[s].b} for s in (joint.a, joint.b))
            found |= one ^ other
    return tuple(sorted(found))


def _measured(name: str, scene: sim.Scene) -> tuple[sim.Quantity, ...]:
    """What is measured for a quantity; nothing if the scene does not have it."""
    try:
        return quantity(name, scene).measured
    except InputError:
        return ()


def quantity_text(name: str) -> str:
    """A quantity in words, as in "stretch of spring 0"."""
    return reading_text(Reading(quantity=name))


def plot_in_words(text: str) -> str:
    """A plot in words, as in "x of mass 1, x of mass 3 over y of mass 1"."""
    spec = parse_plot(text)
    names = joined(map(quantity_text, spec.names))
    return say("measure-title-over", quantity=names, over=quantity_text(spec.over)) if spec.over else names


def reading_text(reading: Reading, scene: sim.Scene | None = None) -> str:
    """A reading in words, as in "stretch of spring 0" or "period of mass 1"."""
    name = _NAME.fullmatch(reading.quantity)
    if name is None:
        period = reading.of == "period"
        return say("reading-period", what=reading.quantity) if period else reading.quantity
    of = reading.quantity.partition(".")[0].rstrip("0123456789")
    what = say(_WORDS[name[3]]) if name[3] in _WORDS else quantity_of(of, name[3]).replace("_", " ")
    owner = "body" if reading.quantity.startswith("body.") else name[1]
    if not owner:
        return say("reading-period", what=what) if reading.of == "period" else what
    if reading.of == "period":
        return say("reading-period-of", owner=owner, number=name[2] or "")
    return say("reading-of", what=what, owner=owner, number=name[2] or "")


def reading_unit(reading: Reading, scene: sim.Scene) -> str:
    """The unit of a reading; empty for one that the scene does not have."""
    try:
        return "s" if reading.of == "period" else quantity(reading.quantity, scene).unit
    except InputError:
        return ""


def goal_text(goal: Goal, scene: sim.Scene) -> str:
    """A goal in words, as in "period of mass1.y: 1.98 to 2.02 s"."""
    unit, text = reading_unit(goal, scene), reading_text(goal, scene)
    low, high = ("" if bound is None else number(bound, 6) for bound in (goal.low, goal.high))
    if low and high:
        said = say("goal-between", reading=text, low=low, high=f"{high} {unit}".rstrip())
    elif low:
        said = say("goal-least", reading=text, low=f"{low} {unit}".rstrip())
    else:
        said = say("goal-most", reading=text, high=f"{high} {unit}".rstrip())
    return say("goal-held", goal=said, seconds=number(goal.seconds, 6)) if goal.seconds else said


def run_text(run: StepRun, scene: sim.Scene) -> str:
    """A run in words, as in "Gravity 2000 px/s²; mass 1 is pulled 150 px down and let go"."""
    said = []
    for assignment in run.settings:
        key, _, value = assignment.partition("=")
        if key in CHOICES:
            choice = options_of(key).get(value, value)
            said.append(say("run-choice", choice=label_of_choice(key), option=choice))
            continue
        try:
            setting = setting_of(scene, key)
        except sim.SettingError:
            said.append(assignment)
        else:
            unit = setting.unit.replace("px", scene.view.unit)
            said.append(f"{label_of(setting)} {upright(f'{decimal(value)} {unit}'.rstrip())}")
    few = run.pulls if len(run.pulls) <= MAX_TOLD else ()
    if len(run.pulls) > len(few):
        said.append(say("run-many", count=len(run.pulls)))
    said += (say("run-pull", mass=str(pull.mass), way=_way(pull.by, scene)) for pull in few)
    for circle in dict.fromkeys(one.circle for one in run.leads):
        led = [str(one.mass) for one in run.leads if one.circle == circle]
        radius = f"{number(circle.radius, 6)} {scene.view.unit}"
        times = number(circle.frequency, 6)
        said.append(say("run-led", count=len(led), masses=joined(led), radius=radius, times=times))
    resting = [str(one.joint) for one in run.muscles if not (one.muscle and one.muscle.amplitude)]
    if resting:
        said.append(say("run-rests", count=len(resting), joints=joined(resting)))
    if moving := len(run.muscles) - len(resting):
        said.append(say("run-muscles", count=moving))
    return f"{joined(said, 'language-semicolon')}."


def _way(by: tuple[float, float], scene: sim.Scene) -> str:
    """How far something is pulled, as in "150 px down"."""
    across, down = by[0], by[1] if scene.view.y_down else -by[1]

    def length(by: float) -> str:
        size = str(round(abs(by))) if abs(by) >= 1.0 else number(abs(by), 6)
        return f"{size} {scene.view.unit}"

    one = say("run-way.right" if across > 0.0 else "run-way.left", length=length(across))
    other = say("run-way.down" if down > 0.0 else "run-way.up", length=length(down))
    return say("run-ways", one=one, other=other) if across and down else one if across else other
