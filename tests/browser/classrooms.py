"""A server with a class, and scripts that measure its wall."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

import sim
from app.classroom import kept
from app.classroom.live import Class, Classes
from app.server.serve import serving
from sim.compiling.compiler import ENTRY_POINTS

HEIGHTS = "dots => dots.map((dot) => Number(dot.getAttribute('cy')))"
"""How far down the dots of a reveal are."""

LETTERS = """plot => Math.min(...[...plot.querySelectorAll("text")].map((text) =>
  parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a / innerHeight))"""
"""The smallest letters of a class's plot, by the height of the window."""


@contextmanager
def serving_class(lesson: sim.Scene, folder: Path) -> Iterator[tuple[int, Class]]:
    """Serve a class with a lesson until the end; give the port, and the class.

    Args:
        lesson: its only scene.
        folder: of the class's files.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kept, "classes_folder", lambda: folder)
        classes = Classes()
        classroom = classes.begin((lesson,))
        with serving(sim.load_scene("rope"), "127.0.0.1", 0, classes=classes) as (server, _, compiler):
            compiler.want(ENTRY_POINTS)
            compiler.start()
            compiler.wait()
            yield server.get_port(), classroom
