"""Messages about the lesson that is being edited in a page."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import UNSET, Meta, Struct, UnsetType

from sim.scene.lesson import Step

from ...wire.messages import Event, FromPage, LongText, Number, QuantityName, State, StepNumber


class Prepare(FromPage, frozen=True):
    """A change of the lesson in the form; for pages that may edit and are not in a class."""


class MakeLesson(Prepare, frozen=True):
    """Open or close the form of the lesson."""

    on: bool


class AddStep(Prepare, frozen=True):
    """Insert a step at a position, counted from 0."""

    at: StepNumber


class OfStep(Prepare, frozen=True):
    """A change of one step."""

    step: StepNumber


class CopyStep(OfStep, frozen=True):
    """Insert a copy after a step."""


class RemoveStep(OfStep, frozen=True):
    """Remove a step; with the last one, the lesson."""


class MoveStep(OfStep, frozen=True):
    """Move a step to another position."""

    to: StepNumber


class QuestionDraft(Struct, frozen=True, forbid_unknown_fields=True):
    """A question as it is written, see `sim.scene.lesson.Question`."""

    text: LongText
    choices: Annotated[tuple[LongText, ...], Meta(max_length=10)]
    answer: Annotated[int, Meta(ge=0, le=9)]
    because: LongText


class ReadingDraft(Struct, frozen=True, forbid_unknown_fields=True):
    """A reading as it is chosen, see `sim.scene.lesson.Reading`."""

    quantity: QuantityName
    of: Literal["value", "period"]


class GoalDraft(ReadingDraft, frozen=True, forbid_unknown_fields=True):
    """A goal as it is written, see `sim.scene.lesson.Goal`."""

    low: Number | None
    high: Number | None
    seconds: Number


class StepChanges(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, omit_defaults=True):
    """New values of fields of a step, see `sim.scene.lesson.Step`; null removes one.

    Attributes:
        ghost: a method, "reference", or "" for none.
    """

    title: LongText | UnsetType = UNSET
    do: LongText | UnsetType = UNSET
    watch: LongText | UnsetType = UNSET
    question: QuestionDraft | UnsetType | None = UNSET
    predict: Number | UnsetType | None = UNSET
    goal: GoalDraft | UnsetType | None = UNSET
    collect: ReadingDraft | UnsetType | None = UNSET
    controls: Annotated[tuple[QuantityName, ...], Meta(max_length=40)] | UnsetType = UNSET
    plots: UnsetType | None = UNSET
    arrows: UnsetType | None = UNSET
    run: UnsetType | None = UNSET
    ghost: Annotated[str, Meta(max_length=40)] | UnsetType = UNSET


class ChangeStep(OfStep, frozen=True):
    """Change fields of a step."""

    changes: StepChanges


class TakeInStep(OfStep, frozen=True):
    """Give a step the present settings, plots or arrows, or have it run the body as it is now."""

    what: Literal["settings", "run", "plots", "arrows"]


class LeadInStep(OfStep, frozen=True):
    """Have the run of a step lead a mass round a circle; none for a radius of 0."""

    mass: Annotated[int, Meta(ge=0, le=1_000_000)]
    radius: Number
    frequency: Number


class TryStep(OfStep, frozen=True):
    """Begin a step as a pupil sees it."""


class EndTrying(Prepare, frozen=True):
    """Return from a step that was begun by `TryStep`."""


class DropLesson(Prepare, frozen=True):
    """Remove the lesson."""


class LessonForm(State, frozen=True, kw_only=True):
    """The lesson that is being edited.

    Attributes:
        open: whether the form is shown.
        trying: the step that is tried; -1 for none.
        steps: of the lesson. Their texts may be anyone's: the script shows them as plain text.
        begins, runs, plots: the settings of each step, what its run changes and pulls, and its plots, in
            words.
    """

    open: bool = False
    trying: int = -1
    steps: tuple[Step, ...] = ()
    begins: tuple[str, ...] = ()
    runs: tuple[str, ...] = ()
    plots: tuple[str, ...] = ()


class LessonControl(Struct, frozen=True):
    """A slider or a list that a step can offer."""

    key: str
    label: str


class LessonOffers(State, frozen=True, kw_only=True):
    """What the user can choose for a step at present.

    Attributes:
        parts: what measurable parts are called: those at the mass that was clicked last, those that exist
            once, and those that the lesson reads; and the formulas in the open plots.
        quantities: what the quantities of each kind of part are called, with their units.
        controls: those that apply to the scene.
        methods: labels of the methods of a second body.
        settings: the settings that `TakeInStep` would store, in words.
        plots, arrows: open plots, and kinds of arrows that are on.
    """

    parts: dict[str, str]
    quantities: dict[str, dict[str, str]]
    controls: tuple[LessonControl, ...]
    methods: dict[str, str]
    settings: str
    plots: tuple[str, ...]
    arrows: tuple[str, ...]


class LessonTaken(Event, frozen=True, kw_only=True):
    """The result of a change of the lesson.

    Attributes:
        step: number of the step; -1 for the whole lesson.
        part: field of the step.
        field: the invalid field, as in "question.choices[1]"; empty if the change was made.
        refused: a sentence that says why it was not made; else empty.
    """

    step: int
    part: str
    field: str
    refused: str
