"""A picture as a PNG."""

from __future__ import annotations

import io

from .clip import ClipFrame
from .painter import Painter
from .window import Window


def png(frame: ClipFrame, size: tuple[int, int], dark: bool = False) -> bytes:
    """A picture of a moment, with the body where it has left the scene's frame a little.

    Args:
        frame: the moment.
        size: width and height, pixels, 16..4096 each.
        dark: whether on dark paper.
    """
    painter = Painter(frame.scene, size, dark)
    window = Window.fit(painter.sketch, frame.scene.view.frame, size, frame.picture.positions)
    out = io.BytesIO()
    Painter(frame.scene, size, dark, window=window).paint(frame.picture).save(out, "PNG", optimize=True)
    return out.getvalue()
