"""A lesson on one side of paper, for its teacher: what is asked, run, told and tried in each step."""

from __future__ import annotations

import html
from pathlib import Path

import sim
from sim.errors import InputError
from sim.scene.lesson import Step
from sim.scene.types import shown_name
from sim.settings import scene_of_step

from ..bundle import compact_style
from ..lessons import goal_text, reading_text, run_text
from ..stage.looks import style_rules
from .html_file import document

MINUTES_ASKED, MINUTES_TRIED = 8, 5
"""Of a class for a step with a question, and for one without: some six for the question, two for a try."""


def sheet_html(scene: sim.Scene) -> bytes:
    """The sheet as an HTML file that is printed on one side of A4, in UTF-8.

    Raises:
        InputError: the scene has no lesson, or a step of it cannot begin.
    """
    if scene.lesson is None:
        raise InputError(f"{scene.name} has no lesson, so there is nothing for a teacher's sheet")
    steps = scene.lesson.steps
    minutes = sum(MINUTES_ASKED if step.question or step.predict else MINUTES_TRIED for step in steps)
    parts = [_step(number, step, scene) for number, step in enumerate(steps)]
    title = html.escape(shown_name(scene))
    body = f"""<header><h1>{title}</h1>
<p>{html.escape(scene.description)} Some {minutes} minutes. You need a computer with a projector, and a phone,
tablet or computer for each pupil or two. Begin with <code>softrod class {html.escape(scene.name)}</code>;
<i>Next</i> leads from phase to phase.</p>
<p>Ask: all answer unseen. Do not tell what is right. Below 35 % right teach it again; up to 70 % let them
talk in pairs and ask again. Run it, reveal, have them write one line why; then they try, and hand in.</p>
</header>
<main>{"".join(parts)}</main>"""
    style = "\n".join(
        (style_rules("[data-dark]*"), compact_style(Path(__file__).parent / "static" / "sheet.css"))
    )
    return document(f"{shown_name(scene)}: for the teacher", body, [style], [], {})


def _step(number: int, step: Step, scene: sim.Scene) -> str:
    begins = scene_of_step(scene, number)
    rows: list[tuple[str, str]] = []
    if (question := step.question) is not None:
        choices = "".join(
            f"<li{' class=right' if i == question.answer else ''}>{html.escape(choice)}</li>"
            for i, choice in enumerate(question.choices)
        )
        rows.append(("Ask", f"{html.escape(question.text)}<ol>{choices}</ol>"))
    if step.predict is not None:
        rows.append(("Predict", f"Each drags the pale body to where it will be after {step.predict:g} s."))
    if step.run:
        rows.append(("Run", html.escape(run_text(step.run, begins))))
    if question is not None:
        rows.append(("Reveal", html.escape(question.because)))
    rows.append(("Try", html.escape(step.do)))
    if step.watch:
        rows.append(("Watch", html.escape(step.watch)))
    if step.goal is not None:
        rows.append(("Goal", html.escape(f"{goal_text(step.goal, begins)}.")))
    if step.collect is not None:
        rows.append(("Collect", html.escape(f"The {reading_text(step.collect, begins)}.")))
    listed = "".join(f"<dt>{word}</dt><dd>{text}</dd>" for word, text in rows)
    return f"<section><h2>{number + 1} {html.escape(step.title)}</h2><dl>{listed}</dl></section>"
