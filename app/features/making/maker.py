"""The form in which a lesson is made: each change is a step of undo, or is refused with a sentence."""

from __future__ import annotations

import contextlib
import math
import re
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from msgspec import UNSET, structs

import sim
from sim.edit import lesson
from sim.edit.edit import Edit
from sim.edit.texts import question_with_texts
from sim.errors import InputError, SceneError, SettingError
from sim.motion.quantities import KINDS, PARTS, quantity, unit_in
from sim.scene.lesson import Goal, Question, Reading
from sim.settings import CHOICES, scene_of_step, settings_of
from sim.solve.registry import METHODS

from ...lessons import plot_in_words, run_text
from ...session import commands
from ...session.ghost import REFERENCE
from ...session.notices import Notice
from ...session.plots import parse_plot
from ...session.versions import Versions
from ...ui.page import Page
from ...words import joined, number, say, upright
from ...words.english import of, sentence, step_of, without_field, written
from ...words.quantities import part_called, quantity_of
from ...words.settings import label_of, label_of_choice, options_of
from . import messages as asks
from .messages import LessonControl, LessonForm, LessonOffers, LessonTaken

OFFERS_EVERY = 0.25
"""Seconds between two updates of what can be chosen for a step."""

MERGE_WITHIN = 10.0
"""Seconds within which changes of one field are one step of undo."""

LABELS = {
    "title": "title",
    "do": "task",
    "watch": "what to watch",
    "question": "question",
    "predict": "prediction",
    "goal": "goal",
    "collect": "what is handed in",
    "controls": "sliders",
    "plots": "plots",
    "arrows": "arrows",
    "ghost": "second body",
    "run": "run",
}
"""The fields of a step, as the undo button names them."""

ARROWS = ("forces", "velocities", "torques")

_DRAFTS = {"question": Question, "goal": Goal, "collect": Reading}
"""Fields that arrive as drafts, which may be invalid, and what is made of them."""

_FIELD = re.compile(r"lesson\.steps(?:\[\d+\])?\.?([\w.\[\]]*)(?=: )")
"""The field of a step, before what is wrong with it."""

MakeEdit = Callable[[sim.Scene], Edit]


class Measured(NamedTuple):
    """What is measured on a page.

    Attributes:
        parts: the parts in the list of the Measure tab.
        plots: names of the open plots.
        arrows: the kinds of arrows that are on.
    """

    parts: tuple[str, ...]
    plots: tuple[str, ...]
    arrows: frozenset[str]


class LessonMaker:
    """One page's form of the scene's lesson. All methods are for the ticker's thread.

    Args:
        page: the page.
        measured: returns what is measured there now.

    Attributes:
        is_told: whether the page knows of the form.
    """

    def __init__(self, page: Page, measured: Callable[[], Measured]) -> None:
        self._page, self._session, self._mail = page, page.session, page.mail
        self._measured = measured
        self._open = self.is_told = False
        self._trying = -1
        self._before: tuple[bytes, Versions] | None = None  # the page before a step was tried
        self._steps = self._shown = ()  # of the scene, and with their texts as the page reads them
        self._begins: tuple[str, ...] = ()
        self._runs: tuple[str, ...] = ()
        self._plots: tuple[str, ...] = ()
        self._due = 0.0

    def do(self, ask: asks.Prepare) -> None:
        """Carry out a message of the form."""
        session = self._session
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
            case asks.ChangeStep():
                self._set(ask)
            case asks.TakeInStep(step, "settings"):
                scene, opened = session.scene, session.opened
                self._change(ask, lambda now: lesson.begin_as(now, step, scene, opened), "settings")
            case asks.TakeInStep(step, "run"):
                scene, opened, positions = session.scene, session.opened, session.simulation.positions
                self._change(ask, lambda now: lesson.run_as(now, step, scene, positions, opened), "run")
            case asks.LeadInStep(step, mass, radius, frequency):
                self._change(ask, lambda now: lesson.lead_in_run(now, step, mass, radius, frequency), "run")
            case asks.TakeInStep(step, "plots"):
                self._change_step(ask, {"plots": self._measured().plots})
            case asks.TakeInStep(step):
                self._change_step(ask, {"arrows": self._arrows})
            case _:
                pass

    def tell(self) -> None:
        """Send the form, and from time to time what can be chosen in it."""
        scene = self._session.scene
        steps = scene.lesson.steps if scene.lesson is not None and self._open else ()
        if steps is not self._steps:
            self._steps = steps
            self._begins = tuple(describe_settings(scene, step.settings) for step in steps)
            self._shown = tuple(map(step_of, steps))
            self._runs = tuple(run_text(step.run, scene) if step.run else "" for step in steps)
            self._plots = tuple(
                joined(map(plot_in_words, step.plots or ()), "language-semicolon") for step in steps
            )
        self._mail.send(
            LessonForm(
                open=self._open,
                trying=self._trying,
                steps=self._shown,
                begins=self._begins,
                runs=self._runs,
                plots=self._plots,
            )
        )
        if self._page.makes_lesson and self._session.now() >= self._due:
            self._due = self._session.now() + OFFERS_EVERY
            self._mail.send(self._offers())

    # --------------------------------------------------------------------- inside
    def _show(self, on: bool) -> None:
        """Open or close the form."""
        if on and self._trying >= 0:
            self._end_trying()
        self._open, self._trying, self._before = on, -1, None
        self.is_told = True
        self._rearrange()

    def _rearrange(self) -> None:
        """Hide the lesson's own tab while the form is shown, and rebuild the panel."""
        self._page.makes_lesson = self._open and self._trying < 0
        self._session.generation += 1

    def _try(self, step: int) -> None:
        """Begin a step as a pupil sees it; `_end_trying` restores the page."""
        session, scene = self._session, self._session.scene
        steps = scene.lesson.steps if scene.lesson is not None else ()
        if step >= len(steps) or self._trying >= 0 or not self._open:
            return
        try:
            scene_of_step(scene, step)
        except SettingError as error:
            self._report(asks.TryStep(step), "settings", error)
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

    def _set(self, ask: asks.ChangeStep) -> None:
        """Set the fields that a message names."""
        changes = {name: value for name in LABELS if (value := getattr(ask.changes, name)) is not UNSET}
        for name in _DRAFTS.keys() & changes.keys():
            if changes[name] is not None:
                changes[name] = _DRAFTS[name](**structs.asdict(changes[name]))
        own = partial(written, scene=self._session.scene)
        changes |= {name: own(changes[name]) for name in ("title", "do", "watch") if name in changes}
        if isinstance(question := changes.get("question"), Question):
            changes["question"] = question_with_texts(question, own)
        if "ghost" in changes:
            if changes["ghost"] not in ("", REFERENCE, *METHODS):
                return
            changes["ghost"] = changes["ghost"] or None
        if "run" in changes:
            changes["run"] = UNSET
        if changes:
            self._change_step(ask, changes, f"lesson.{ask.step}.{next(iter(changes))}")

    def _change_step(self, ask: asks.OfStep, changes: dict[str, object], key: str = "") -> None:
        part = next(iter(changes))
        make = partial(lesson.change_step, number=ask.step, label=LABELS[part], **changes)
        self._change(ask, make, part, key)

    def _change(self, ask: asks.Prepare, make: MakeEdit, part: str = "", key: str = "") -> None:
        """Change the lesson, or report why that is impossible."""
        try:
            make(self._session.scene)
        except (SceneError, InputError, SettingError) as error:
            self._report(ask, part, error)
            return
        self._session.post(commands.Change(lambda moment, _: make(moment.scene), key, MERGE_WITHIN))
        self._report(ask, part)

    def _report(self, ask: asks.Prepare, part: str, error: Exception | None = None) -> None:
        """Report a change to the page: to the form, and if no field is concerned by a notice, too."""
        step = ask.step if isinstance(ask, asks.OfStep) else -1
        field, refused = "", ""
        if error is not None:
            text = str(error)
            found = _FIELD.match(text)
            field = (found and found[1]) or part
            refused = sentence(without_field(text, found[0]) if found else of(text))
            if not part:
                self._page.notify(Notice("error", say("making-not-done"), refused))
        self._mail.send(LessonTaken(step=step, part=part, field=field, refused=refused))

    @property
    def _arrows(self) -> tuple[str, ...]:
        """The kinds of arrows that are on, in their usual order."""
        on = self._measured().arrows
        return tuple(kind for kind in ARROWS if kind in on)

    def _offers(self) -> LessonOffers:
        scene, measured = self._session.scene, self._measured()
        choices = [(key, label_of_choice(key)) for key, choice in CHOICES.items() if choice.applies(scene)]
        sliders = [(setting.key, label_of(setting)) for setting in settings_of(scene)]
        wanted = lesson.settings_to_set(scene, scene, self._session.opened)
        readings = [one.quantity for step in self._steps for one in (step.goal, step.collect) if one]
        parts = (
            *filter(_is_part, measured.parts),
            *(part for part, _, _ in (name.rpartition(".") for name in readings) if _is_part(part)),
            *_formulas(measured.plots, scene),
        )
        return LessonOffers(
            parts={part: part_called(part) for part in parts},
            quantities={
                of: {
                    kind.what: _with_unit(quantity_of(of, kind.what), unit_in(kind.unit, scene.view.unit))
                    for kind in KINDS.values()
                    if kind.of == of
                }
                for of in PARTS
            },
            controls=tuple(LessonControl(*each) for each in (*sliders, *choices)),
            methods={REFERENCE: say("making-ghost.reference"), **options_of("method")},
            settings=describe_settings(scene, tuple(f"{key}={value}" for key, value in wanted.items())),
            plots=measured.plots,
            arrows=self._arrows,
        )


def _is_part(part: str) -> bool:
    """Return whether a part of a body is measured, and no second body or formula."""
    return part.rstrip("0123456789") in PARTS


def _with_unit(what: str, unit: str) -> str:
    what = what.replace("_", " ")
    return f"{what} ({unit})" if unit else what


def _formulas(plots: tuple[str, ...], scene: sim.Scene) -> list[str]:
    """Return the formulas in some plots."""
    found = []
    for name in dict.fromkeys(name for text in plots for name in parse_plot(text).names):
        with contextlib.suppress(InputError):
            if quantity(name, scene).formula is not None:
                found.append(name)
    return found


def describe_settings(scene: sim.Scene, settings: tuple[str, ...]) -> str:
    """Describe settings in the order of the panel, as in "Integrator: RK4, Gravity 980 px/s²"."""
    known = {setting.key: setting for setting in settings_of(scene)}
    order = [*CHOICES, *known]
    values = {key: value for key, _, value in (each.partition("=") for each in settings)}
    words = []
    for key in sorted(values, key=lambda key: order.index(key) if key in order else len(order)):
        value = values[key]
        if key in CHOICES:
            words.append(f"{label_of_choice(key)}: {options_of(key).get(value, value)}")
        elif key in known and math.isfinite(size := _number(value)):
            unit = known[key].unit.replace("px", scene.view.unit)
            said = f"{number(size, 6)} {unit}".rstrip()
            words.append(f"{label_of(known[key])} {upright(said)}")
        else:
            words.append(f"{key} {value}")
    return joined(words)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan
