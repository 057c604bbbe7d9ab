"""Lessons: a scene with steps to follow beside the body.

A step asks first and shows afterwards: people who have predicted an outcome learn markedly more from seeing
it (Crouch, Fagen, Callan and Mazur 2004, American Journal of Physics 72, 835).
"""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from .numbers import Index, Vector
from .parts import Circle, JointMuscle

Sentence = Annotated[str, Meta(min_length=1, max_length=600)]
Line = Annotated[str, Meta(min_length=1, max_length=160)]
Assignment = Annotated[str, Meta(min_length=3, max_length=100)]
QuantityName = Annotated[str, Meta(min_length=1, max_length=200)]


MAX_PULLS = 20
"""Maximum number of masses that a run displaces, and of masses that it guides."""

MAX_MUSCLES = 200
"""Maximum number of muscles that a run changes."""


class Question(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A multiple-choice question.

    Attributes:
        text: the question, at most 600 characters.
        choices: 2..5 answers, at most 160 characters each.
        answer: index of the correct one.
        because: why it is correct; shown once one has been chosen.
    """

    text: Sentence
    choices: Annotated[tuple[Line, ...], Meta(min_length=2, max_length=5)]
    answer: Annotated[int, Meta(ge=0, le=4)]
    because: Sentence


class Reading(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A value read from a run.

    Attributes:
        quantity: its name, such as "mass1.y", or a formula, see `sim.motion.quantities`.
        of: its current value, or the period of its oscillation, s.
    """

    quantity: QuantityName
    of: Literal["value", "period"] = "value"


class Goal(Reading, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A goal to be reached: a reading from `low` to `high`, for `seconds` without interruption.

    Attributes:
        low, high: the range, in the unit of the reading; at least one of them, None for no bound.
        seconds: simulated time for which it must stay there, at most ten minutes.
    """

    low: float | None = None
    high: float | None = None
    seconds: Annotated[float, Meta(ge=0.0, le=600.0)] = 0.0


class Pull(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A mass that is displaced before a run begins and released as it does.

    Attributes:
        mass: its index.
        by: its displacement along x and y, px.
    """

    mass: Index
    by: Vector


class Lead(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A mass that is guided during a run, like a moving anchor.

    Attributes:
        mass: its index.
        circle: its path, from its position at the start of the run.
    """

    mass: Index
    circle: Circle


class RunMuscle(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A joint's muscle during a run.

    Attributes:
        joint: its index.
        muscle: the muscle, or None if the joint has none.
    """

    joint: Index
    muscle: JointMuscle | None


class StepRun(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What is shown after a step's question: the case that it is about.

    Attributes:
        settings: changes to the settings of the step, in the syntax of `--set`, at most 10.
        pulls: masses that are displaced first, at most 20.
        leads: masses that are guided, at most 20.
        muscles: of joints whose muscle differs from that in the step, or that have none, at most 200.
    """

    settings: Annotated[tuple[Assignment, ...], Meta(max_length=10)] = ()
    pulls: Annotated[tuple[Pull, ...], Meta(max_length=MAX_PULLS)] = ()
    leads: Annotated[tuple[Lead, ...], Meta(max_length=MAX_PULLS)] = ()
    muscles: Annotated[tuple[RunMuscle, ...], Meta(max_length=MAX_MUSCLES)] = ()


class Step(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One step of a lesson.

    Attributes:
        title: at most 160 characters.
        question: asked before anything is done, or None.
        do: what to do.
        watch: what to watch meanwhile; may be empty.
        settings: initial settings of the step, in the syntax of `--set`: ``("gravity=0", "method=rk4")``.
            Settings of other steps remain in effect, so a step names everything that the lesson changes.
        run: what happens once the question has been answered, or in a class when all see it run; without it,
            the initial settings of the step.
        controls: keys of settings and choices, as in `settings`, whose sliders and lists are shown below the
            text; at most 6.
        plots: of quantities, below those: ``("joint0.angle", "mass1.x, mass3.x", "joint0.rate over
            joint0.angle")``, at most 4.
        arrows: the arrows to be switched on; None leaves them unchanged.
        ghost: a second body for comparison: the name of a method, or "reference" for a near-exact solution;
            None for none.
        predict: simulated time, s, at which a class predicts the position of the body: each pupil drags it
            there before it moves. None for no such prediction.
        goal: a goal to be reached with the body, or None.
        collect: a reading that each pupil of a class submits; None for nothing.
    """

    title: Line
    question: Question | None = None
    do: Sentence
    watch: Annotated[str, Meta(max_length=600)] = ""
    settings: tuple[Assignment, ...] = ()
    run: StepRun | msgspec.UnsetType = msgspec.UNSET
    controls: Annotated[tuple[Line, ...], Meta(max_length=6)] = ()
    plots: Annotated[tuple[Sentence, ...], Meta(max_length=4)] | None = None
    arrows: tuple[Literal["forces", "velocities", "torques"], ...] | None = None
    ghost: Line | None = None
    predict: Annotated[float, Meta(gt=0.0, le=600.0)] | None = None
    goal: Goal | None = None
    collect: Reading | None = None


class Lesson(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The steps of a lesson, 1..20 of them."""

    steps: Annotated[tuple[Step, ...], Meta(min_length=1, max_length=20)]


def texts_of(step: Step) -> tuple[str, ...]:
    """Return all texts that can be read in a step."""
    question = step.question
    asked = (question.text, *question.choices, question.because) if question else ()
    readings = [reading.quantity for reading in (step.goal, step.collect) if reading is not None]
    changed = step.run.settings if step.run else ()
    named = (*step.settings, *changed, *step.controls, *(step.plots or ()), step.ghost or "", *readings)
    return (step.title, step.do, step.watch, *asked, *named)
