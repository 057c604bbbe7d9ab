"""What a page says of the lesson that is being made, and is told of it."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta, Struct

from sim.scene.lesson import Step

from ...wire.messages import Event, FromPage, LongText, Number, QuantityName, State, StepNumber


class Prepare(FromPage, frozen=True):
    """Something about the lesson that is being made; for pages that may edit, and are in no class."""


class MakeLesson(Prepare, frozen=True):
    """The form of the lesson is to be open, or not."""

    on: bool


class AddStep(Prepare, frozen=True):
    """A new step, which is to have that number, counted from 0."""

    at: StepNumber


class OfStep(Prepare, frozen=True):
    """Something about one step."""

    step: StepNumber


class CopyStep(OfStep, frozen=True):
    """A copy of the step is to come after it."""


class RemoveStep(OfStep, frozen=True):
    """The step is to go; with the last one, the lesson goes."""


class MoveStep(OfStep, frozen=True):
    """The step is to have another place."""

    to: StepNumber


class WriteStep(OfStep, frozen=True):
    """A text of the step."""

    field: Literal["title", "do", "watch"]
    text: LongText


class AskInStep(OfStep, frozen=True):
    """The question of the step."""

    text: LongText
    choices: Annotated[tuple[LongText, ...], Meta(max_length=10)]
    answer: Annotated[int, Meta(ge=0, le=9)]
    because: LongText


class PredictInStep(OfStep, frozen=True):
    """The time after which the body's place is asked for, s."""

    seconds: Number


class AimInStep(OfStep, frozen=True):
    """The goal of the step, see `sim.scene.lesson.Goal`."""

    quantity: QuantityName
    of: Literal["value", "period"]
    low: Number | None
    high: Number | None
    seconds: Number


class CollectInStep(OfStep, frozen=True):
    """What is handed in of the step."""

    quantity: QuantityName
    of: Literal["value", "period"]


class OfferInStep(OfStep, frozen=True):
    """The sliders and lists that stand below the step, by their keys."""

    controls: Annotated[tuple[QuantityName, ...], Meta(max_length=40)]


class CompareInStep(OfStep, frozen=True):
    """The method of the second body, "reference", or "" for none."""

    ghost: Annotated[str, Meta(max_length=40)]


class TakeInStep(OfStep, frozen=True):
    """The step is to have the settings, the plots or the arrows as they are now."""

    what: Literal["settings", "plots", "arrows"]


class DropFromStep(OfStep, frozen=True):
    """The step is to have no such thing any more; without arrows of its own it leaves them as they are."""

    what: Literal["question", "predict", "goal", "collect", "plots", "arrows"]


class TryStep(OfStep, frozen=True):
    """The step is to begin as a pupil sees it."""


class EndTrying(Prepare, frozen=True):
    """The page goes back to where a step was tried from."""


class DropLesson(Prepare, frozen=True):
    """The lesson is to go."""


class LessonForm(State, frozen=True, kw_only=True):
    """The lesson that is being made, which the page shows as a form.

    Attributes:
        open: whether it is to be shown.
        trying: the step that is tried; -1 for none.
        steps: of the lesson, which may be anyone's: the script shows them as text only.
        begins: what each of them sets, in words; empty for nothing.
    """

    open: bool = False
    trying: int = -1
    steps: tuple[Step, ...] = ()
    begins: tuple[str, ...] = ()


class LessonControl(Struct, frozen=True):
    """A slider or a list that a step can have."""

    key: str
    label: str


class LessonOffers(State, frozen=True, kw_only=True):
    """What a step of the lesson can have, as things are now.

    Attributes:
        parts: that can be measured: what is at the mass that was clicked last, and what there is one of.
        quantities: of each kind of part, with their units.
        controls: that the scene has a use for.
        methods: of a second body, by their names for people.
        settings: what is set otherwise than the steps, or the scene as it was opened, have it; in words.
        plots, arrows: that are open, and on.
    """

    parts: tuple[str, ...]
    quantities: dict[str, dict[str, str]]
    controls: tuple[LessonControl, ...]
    methods: dict[str, str]
    settings: str
    plots: tuple[str, ...]
    arrows: tuple[str, ...]


class LessonTaken(Event, frozen=True, kw_only=True):
    """What was done of the lesson that is being made.

    Attributes:
        step: at which.
        part: of the step: what was to be changed.
        field: what was refused, as in "question.choices[1]"; empty if nothing was.
        refused: a sentence that says why, or nothing.
    """

    step: int
    part: str
    field: str
    refused: str
