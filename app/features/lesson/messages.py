"""Messages about the lesson of a page's scene."""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from sim.scene.lesson import Question

from ...wire.messages import FromPage, State, StepNumber


class BeginStep(FromPage, frozen=True):
    """The page goes to a step of the scene's lesson.

    Attributes:
        how: "wait": it begins, and the body waits if there is a question. "run": it begins with the case that
            is asked about, and runs. "on": the page goes on in the middle of it, as after a reload.
    """

    step: StepNumber
    how: Literal["run", "wait", "on"] = "wait"


class LessonStep(Struct, frozen=True):
    """What the script shows of a step, see `sim.scene.lesson.Step`."""

    title: str
    do: str
    watch: str
    question: Question | None
    run: bool
    """Whether another case is run than the one with which it begins."""


class Lesson(State, frozen=True, kw_only=True):
    """The scene's lesson, which may be anyone's: the script shows it as text only.

    Attributes:
        name: by which the page knows the lesson again, in any language.
        steps: in the language of the page.
    """

    name: str
    steps: tuple[LessonStep, ...]
