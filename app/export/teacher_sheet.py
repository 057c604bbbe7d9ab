"""A lesson on one side of paper, for its teacher: what is asked, run, told and tried in each step."""

from __future__ import annotations

import html
import math
import re
import shlex
from pathlib import Path

import sim
from sim.errors import InputError
from sim.scene.lesson import Step
from sim.settings import scene_of_step

from ..bundle import compact_style
from ..lessons import goal_text, reading_text, run_text
from ..stage.looks import style_rules
from ..words import decimal, say
from ..words.english import name_of, of, step_of
from .html_file import document, said

_TAG = re.compile(r"<[^>]*>")

MINUTES_ASKED, MINUTES_TRIED = 8, 5
"""Of a class for a step with a question, and for one without: some six for the question, two for a try."""


LARGEST, SMALLEST = 10.0, 8.0
"""Size of the letters, points. They are smaller where more are to fit on the side, as in longer languages."""

ON_A_SIDE = 2800
"""Letters of a lesson that fit in the largest size."""


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
    title = html.escape(name_of(scene))
    command = f"<code>softrod class {html.escape(shlex.quote(scene.name))}</code>"
    following = f"<i>{said('live-sheet-next')}</i>"
    needs = say("live-sheet-needs", minutes=minutes, command=command, next=following)
    body = f"""<header><h1>{title}</h1>
<p>{html.escape(of(scene.description))} {needs}</p>
<p>{said("live-sheet-how")}</p>
</header>
<main>{"".join(parts)}</main>"""
    letters = len(html.unescape(_TAG.sub("", body)))
    size = max(SMALLEST, min(LARGEST, LARGEST * math.sqrt(ON_A_SIDE / letters)))
    style = "\n".join(
        (
            style_rules("[data-dark]*"),
            compact_style(Path(__file__).parent / "static" / "sheet.css"),
            f"html {{ font-size: {size:.2f}pt }}",
        )
    )
    return document(say("live-sheet-title", lesson=name_of(scene)), body, [style], [], {})


def _step(number: int, step: Step, scene: sim.Scene) -> str:
    begins, step = scene_of_step(scene, number), step_of(step)
    rows: list[tuple[str, str]] = []
    if (question := step.question) is not None:
        choices = "".join(
            f"<li{' class=right' if i == question.answer else ''}>{html.escape(choice)}</li>"
            for i, choice in enumerate(question.choices)
        )
        rows.append((said("live-sheet-ask"), f"{html.escape(question.text)}<ol>{choices}</ol>"))
    if step.predict is not None:
        told = say("live-sheet-predict.text", time=decimal(f"{step.predict:g}"))
        rows.append((said("live-sheet-predict"), html.escape(told)))
    if step.run:
        rows.append((said("live-sheet-run"), html.escape(run_text(step.run, begins))))
    if question is not None:
        rows.append((said("live-sheet-reveal"), html.escape(question.because)))
    rows.append((said("live-sheet-try"), html.escape(step.do)))
    if step.watch:
        rows.append((said("live-sheet-watch"), html.escape(step.watch)))
    if step.goal is not None:
        told = say("live-sheet-goal.text", goal=goal_text(step.goal, begins))
        rows.append((said("live-sheet-goal"), html.escape(told)))
    if step.collect is not None:
        told = say("live-sheet-collect.text", reading=reading_text(step.collect, begins))
        rows.append((said("live-sheet-collect"), html.escape(told)))
    listed = "".join(f"<dt>{word}</dt><dd>{text}</dd>" for word, text in rows)
    return f"<section><h2>{number + 1} {html.escape(step.title)}</h2><dl>{listed}</dl></section>"
