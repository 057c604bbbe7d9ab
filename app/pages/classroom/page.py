"""The page of a class, as it is sent to a pupil's browser or to the wall's: one script, and no viser."""

from __future__ import annotations

import json
from pathlib import Path

from ...bundle import compact_style, without_is
from ...stage.looks import style_rules
from ...stage.shapes import meshes
from ...stage.sketch import COILS

_APP = Path(__file__).parents[2]
_SHEETS = (
    "ui/dialogs.css",
    "ui/described.css",
    "ui/hands/taps.css",
    "features/classroom/classroom.css",
    "pages/classroom/class.css",
)
_NEVER = "[data-dark]*"
"""Selects dark paper, which these pages do not have."""


def class_page(folder: str) -> str:
    """The page's text.

    Args:
        folder: where the page's scripts and fonts are, with a slash at its end.
    """
    text = (Path(__file__).parent / "class.html").read_text(encoding="utf-8")
    faces = (_APP / "ui" / "fonts" / "fonts.css").read_text(encoding="utf-8")
    style = "\n".join(
        (
            faces.replace('url("', f'url("{folder}ui/fonts/'),
            style_rules(_NEVER),
            without_is(compact_style(*(_APP / name for name in _SHEETS))),
        )
    )
    shapes = {
        "meshes": {
            name: [line.round(4).ravel().tolist() for line in mesh.outlines]
            for name, mesh in meshes().items()
        },
        "coils": COILS,
    }
    data = json.dumps(shapes, separators=(",", ":"), allow_nan=False)
    return text.replace("{style}", style).replace("{shapes}", data).replace("{folder}", folder)
