"""The form in which a lesson is made: what is typed is a step of undo, or is refused beside its field."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import sim
from sim.edit import lesson
from sim.edit.edit import Edit
from sim.errors import InputError, SceneError, SettingError
from sim.methods.registry import METHODS
from sim.motion.quantities import KINDS, PARTS, unit_in
from sim.scene.lesson import Goal, Question, Reading, Step
from sim.settings import CHOICES, scene_of_step, settings_of

from ...session import commands
from ...session.ghost import REFERENCE
from ...session.notices import Notice
from ...session.versions import Versions
from ...ui.page import Page
from . import messages as asks
from .messages import LessonControl, LessonForm, LessonOffers, LessonTaken

OFFERED_EVERY = 0.25
"""Seconds between two looks at what a step could have."""

WRITING = 10.0
"""Seconds between two changes of one text, at most, that are one step of undo."""

LABELS = {"title": "title", "do": "task", "watch": "what to watch"}
"""What undo calls the texts of a step."""

ARROWS = ("forces", "velocities", "torques")

_REFUSAL = r"(?:lesson\.steps(?:\[\d+\])?\.?([\w.\[\]]*): )?(.*)"
"""The field of a step, and what is wrong with it."""

MakeEdit = Callable[[sim.Scene], Edit]


class Measured(NamedTuple):
    """What is measured on a page.

    Attributes:
        parts: that are offered in the Measure tab.
        plots: that are open there, by what names them.
        arrows: kinds of those that are on.
    """

    parts: tuple[str, ...]
    plots: tuple[str, ...]
    arrows: frozenset[str]


class LessonMaker:
    """One page's form of the scene's lesson; all of it is the ticker's.

    Args:
        page: whose scene it is.
        measured: what is measured there now.

    Attributes:
        is_told: whether the page has been told of the form.
    """

    def __init__(self, page: Page, measured: Callable[[], Measured]) -> None:
        self._page, self._session, self._mail = page, page.session, page.mail
        self._measured = measured
        self._open = self.is_told = False
        self._trying = -1
        self._before: tuple[bytes, Versions] | None = None  # what was there before a step was tried
        self._steps: tuple[Step, ...] = ()
        self._begins: tuple[str, ...] = ()
        self._due = 0.0

    def do(self, ask: asks.Prepare) -> None:
        """Do what the form asks for."""
        scene = self._session.scene
        match ask:
            case asks.MakeLesson(on):
                self._show(on)
            case asks.TryStep(step):
                self._try(step)
            case asks.EndTrying():
                self._end_trying()
            case asks.AddStep(at):
                self._change(ask, lambda now: lesson.add_step(now, at))
            case asks.CopyStep(step):
                self._change(ask, lambda now: lesson.copy_step(now, step))
            case asks.RemoveStep(step):
                self._change(ask, lambda now: lesson.remove_step(now, step))
            case asks.MoveStep(step, to):
                self._change(ask, lambda now: lesson.move_step(now, step, to))
            case asks.DropLesson():
                self._change(ask, lesson.remove_lesson)
            case asks.TakeInStep(step, "settings"):
                opened = self._session.opened
                self._change(ask, lambda now: lesson.begin_as(now, step, scene, opened), "settings")
            case asks.OfStep():
                self._change_step(ask)
            case _:
                pass

    def tell(self) -> None:
        """Tell the page what is in the form, and what could be."""
        scene = self._session.scene
        steps = scene.lesson.steps if scene.lesson is not None and self._open else ()
        if steps is not self._steps:
            self._steps, self._begins = steps, tuple(in_words(scene, step.settings) for step in steps)
        self._mail.send(LessonForm(open=self._open, trying=self._trying, steps=steps, begins=self._begins))
        if self._page.makes_lesson and self._session.now() >= self._due:
            self._due = self._session.now() + OFFERED_EVERY
            self._mail.send(self._offers())

    # --------------------------------------------------------------------- inside
    def _show(self, on: bool) -> None:
        """Have the form open or closed."""
        if on and self._trying >= 0:
            self._end_trying()
        self._open, self._trying, self._before = on, -1, None
        self.is_told = True
        self._rearrange()

    def _rearrange(self) -> None:
        """Show the lesson's own tab, or no longer: the form takes its place."""
        self._page.makes_lesson = self._open and self._trying < 0
        self._session.generation += 1

    def _try(self, step: int) -> None:
        """Begin a step as a pupil sees it; all that was there comes back afterwards."""
        session, scene = self._session, self._session.scene
        steps = scene.lesson.steps if scene.lesson is not None else ()
        if step >= len(steps) or self._trying >= 0 or not self._open:
            return
        try:
            scene_of_step(scene, step)
        except SettingError as error:
            self._taken(asks.TryStep(step), "settings", error)
            return
        self._before = session.keepsake(), session.versions.copy()
        self._trying = step
        self._rearrange()
        session.post(commands.Open(scene))

    def _end_trying(self) -> None:
        if self._before is not None:
            self._session.post(commands.Resume(*self._before))
        self._trying, self._before = -1, None
        self._rearrange()

    def _change_step(self, ask: asks.OfStep) -> None:
        """Change what is in a step."""
        match ask:
            case asks.WriteStep(_, field, text):
                self._set(
                    ask, {"title": "title", "do": "task", "watch": "what to watch"}[field], {field: text}
                )
            case asks.AskInStep(_, text, choices, answer, because):
                question = Question(text=text, choices=choices, answer=answer, because=because)
                self._set(ask, "question", {"question": question})
            case asks.PredictInStep(_, seconds):
                self._set(ask, "prediction", {"predict": seconds})
            case asks.AimInStep(_, name, of, low, high, seconds):
                goal = Goal(quantity=name, of=of, low=low, high=high, seconds=seconds)
                self._set(ask, "goal", {"goal": goal})
            case asks.CollectInStep(_, name, of):
                self._set(ask, "what is handed in", {"collect": Reading(quantity=name, of=of)})
            case asks.OfferInStep(_, controls):
                self._set(ask, "sliders", {"controls": controls})
            case asks.CompareInStep(_, ghost):
                if ghost in ("", REFERENCE, *METHODS):
                    self._set(ask, "second body", {"ghost": ghost or None})
            case asks.TakeInStep(_, "plots"):
                self._set(ask, "plots", {"plots": self._measured().plots})
            case asks.TakeInStep():
                arrows = tuple(kind for kind in ARROWS if kind in self._measured().arrows)
                self._set(ask, "arrows", {"arrows": arrows})
            case asks.DropFromStep(_, what):
                self._set(ask, what, {what: None})
            case _:
                pass

    def _set(self, ask: asks.OfStep, label: str, changes: dict[str, object]) -> None:
        """Change fields of a step; what is written in one go is one step of undo."""
        part = next(iter(changes))
        make = partial(lesson.change_step, number=ask.step, label=label, **changes)
        key = "" if isinstance(ask, (asks.TakeInStep, asks.DropFromStep)) else f"lesson.{ask.step}.{part}"
        self._change(ask, make, part, key)

    def _change(self, ask: asks.Prepare, make: MakeEdit, part: str = "", key: str = "") -> None:
        """Change the lesson, or say beside the field why not."""
        try:
            make(self._session.scene)
        except (SceneError, InputError, SettingError) as error:
            self._taken(ask, part, error)
            return
        self._session.post(commands.Change(lambda moment, _: make(moment.scene), key, WRITING))
        self._taken(ask, part)

    def _taken(self, ask: asks.Prepare, part: str, error: Exception | None = None) -> None:
        step = ask.step if isinstance(ask, asks.OfStep) else -1
        field, sentence = "", ""
        if error is not None:
            match = re.fullmatch(
                r"(?:lesson\.steps(?:\[\d+\])?\.?([\w.\[\]]*): )?(.*)", str(error), re.DOTALL
            )
            assert match is not None, "it takes any text"
            field = match[1] or part
            sentence = re.sub(r"^[a-z]+ ", lambda first: first[0].capitalize(), f"{match[2]}.")  # no name
            if not part:
                self._page.notify(Notice("error", "That cannot be done", sentence))
        self._mail.send(LessonTaken(step=step, part=part, field=field, refused=sentence))

    def _offers(self) -> LessonOffers:
        session, measured = self._session, self._measured()
        length = session.scene.view.unit
        scene = session.scene
        choices = [(key, choice.label) for key, choice in CHOICES.items() if choice.applies(scene)]
        sliders = [(setting.key, setting.label) for setting in settings_of(scene)]
        wanted = lesson.settings_to_set(scene, scene, session.opened)
        return LessonOffers(
            parts=tuple(part for part in measured.parts if part.rstrip("0123456789") in PARTS),
            quantities={
                of: {kind.what: unit_in(kind.unit, length) for kind in KINDS.values() if kind.of == of}
                for of in PARTS
            },
            controls=tuple(LessonControl(*each) for each in (*sliders, *choices)),
            methods={REFERENCE: "Reference", **{name: method.label for name, method in METHODS.items()}},
            settings=in_words(scene, tuple(f"{key}={value}" for key, value in wanted.items())),
            plots=measured.plots,
            arrows=tuple(kind for kind in ARROWS if kind in measured.arrows),
        )


def in_words(scene: sim.Scene, settings: tuple[str, ...]) -> str:
    """What a step sets, as in "Integrator: RK4, Gravity 980 px/s²", in the order of the panel."""
    known = {setting.key: setting for setting in settings_of(scene)}
    order = [*CHOICES, *known]
    values = {key: value for key, _, value in (each.partition("=") for each in settings)}
    words = []
    for key in sorted(values, key=lambda key: order.index(key) if key in order else len(order)):
        value = values[key]
        if key in CHOICES:
            words.append(f"{CHOICES[key].label}: {CHOICES[key].options.get(value, value)}")
        elif key in known and math.isfinite(number := _number(value)):
            unit = known[key].unit.replace("px", scene.view.unit)
            words.append(f"{known[key].label} {number:.6g} {unit}".rstrip())
        else:
            words.append(f"{key} {value}")
    return ", ".join(words)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan
