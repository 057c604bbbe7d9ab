"""A picture as a PNG."""

from __future__ import annotations

import io

from .clip import Shot
from .painter import Painter
from .window import Window


def png(shot: Shot, size: tuple[int, int], dark: bool = False) -> bytes:
    """A picture of a moment, with the body where it has left the scene's frame a little.

    Args:
        shot: the moment.
        size: width and height, pixels, 16..4096 each.
        dark: whether on dark paper.
    """
    painter = Painter(shot.scene, size, dark)
    window = Window.fit(painter.sketch, shot.scene.view.frame, size, shot.picture.positions)
    out = io.BytesIO()
    Painter(shot.scene, size, dark, window=window).paint(shot.picture).save(out, "PNG", optimize=True)
    return out.getvalue()
