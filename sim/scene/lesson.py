"""Lessons: a scene with steps to follow beside the body.

A step asks first and shows afterwards: people who have predicted what will happen learn markedly more from
seeing it (Crouch, Fagen, Callan and Mazur 2004, American Journal of Physics 72, 835).
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


MAX_PULLS = 20
"""Masses that a run moves, and that it leads."""

MAX_MUSCLES = 200
"""Muscles that a run changes."""


class Question(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A question with answers to choose from.

    Attributes:
        text: the question, at most 600 characters.
        choices: 2..5 answers, at most 160 characters each.
        answer: index of the right one.
        because: why it is right; shown once one has been chosen.
    """

    text: Sentence
    choices: Annotated[tuple[Line, ...], Meta(min_length=2, max_length=5)]
    answer: Annotated[int, Meta(ge=0, le=4)]
    because: Sentence


class Reading(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Something that is read off a run.

    Attributes:
        quantity: its name, such as "mass1.y", see `sim.motion.quantities`.
        of: its present value, or the period of its swings, s.
    """

    quantity: Line
    of: Literal["value", "period"] = "value"


class Goal(Reading, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What is to be reached: a reading from `low` to `high`, for `seconds` in one go.

    Attributes:
        low, high: the range, in the unit of the reading; at least one of them, None for no bound.
        seconds: simulated time for which it stays there, at most ten minutes.
    """

    low: float | None = None
    high: float | None = None
    seconds: Annotated[float, Meta(ge=0.0, le=600.0)] = 0.0


class Pull(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A mass that is moved before a run begins, and let go as it does.

    Attributes:
        mass: its index.
        by: how far, along x and y, px.
    """

    mass: Index
    by: Vector


class Lead(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A mass that is led while a run goes on, as an anchor that moves.

    Attributes:
        mass: its index.
        circle: on which it is led, from where it is as the run begins.
    """

    mass: Index
    circle: Circle


class RunMuscle(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The muscle that a joint has in a run.

    Attributes:
        joint: its index.
        muscle: it, or None if the joint has none.
    """

    joint: Index
    muscle: JointMuscle | None


class StepRun(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What is shown once a step has asked: the case that its question is about.

    Attributes:
        settings: what it changes of that with which the step begins, as `--set` has it, at most 10.
        pulls: masses that are moved first, at most 20.
        leads: masses that are led, at most 20.
        muscles: of joints that have another one than as the step begins, or none, at most 200.
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
        watch: what to look at meanwhile; may be empty.
        settings: what the step begins with, as `--set` has it: ``("gravity=0", "method=rk4")``. What other
            steps set stays as it was, so a step names everything that the lesson changes.
        run: what happens once the question has been answered, or in a class when all see it run; without it,
            that with which the step begins.
        controls: keys of settings and choices, as in `settings`, whose sliders and lists stand below the
            text; at most 6.
        plots: of quantities, below those: ``("joint0.angle", "mass1.x, mass3.x", "joint0.rate over
            joint0.angle")``, at most 4.
        arrows: which are to be on; None leaves them as they are.
        ghost: a second body to compare with: the name of a method, or "reference" for a near-exact solution;
            None for none.
        predict: simulated time, s, after which the body is asked to be where a class has predicted it: each
            pupil drags it there before it moves. None to ask for no such prediction.
        goal: what is to be reached with the body, or None.
        collect: what a class hands in a reading of, each pupil one; None for nothing.
    """

    title: Line
    question: Question | None = None
    do: Sentence
    watch: Annotated[str, Meta(max_length=600)] = ""
    settings: tuple[Assignment, ...] = ()
    run: StepRun | msgspec.UnsetType = msgspec.UNSET
    controls: Annotated[tuple[Line, ...], Meta(max_length=6)] = ()
    plots: Annotated[tuple[Line, ...], Meta(max_length=4)] | None = None
    arrows: tuple[Literal["forces", "velocities", "torques"], ...] | None = None
    ghost: Line | None = None
    predict: Annotated[float, Meta(gt=0.0, le=600.0)] | None = None
    goal: Goal | None = None
    collect: Reading | None = None


class Lesson(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The steps of a lesson, 1..20 of them."""

    steps: Annotated[tuple[Step, ...], Meta(min_length=1, max_length=20)]


def texts_of(step: Step) -> tuple[str, ...]:
    """Everything that can be read in a step."""
    question = step.question
    asked = (question.text, *question.choices, question.because) if question else ()
    readings = [reading.quantity for reading in (step.goal, step.collect) if reading is not None]
    changed = step.run.settings if step.run else ()
    named = (*step.settings, *changed, *step.controls, *(step.plots or ()), step.ghost or "", *readings)
    return (step.title, step.do, step.watch, *asked, *named)
