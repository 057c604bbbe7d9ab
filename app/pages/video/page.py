"""The page on which a video becomes a table: the video stays in the browser, and nothing is sent."""

from __future__ import annotations

from pathlib import Path

from ...stage.looks import BY_SYSTEM, style_rules


def video_page(folder: str) -> str:
    """The page's text.

    Args:
        folder: where the page's scripts are, with a slash at its end.
    """
    text = (Path(__file__).parent / "video.html").read_text(encoding="utf-8")
    return text.replace("{looks}", style_rules(BY_SYSTEM)).replace("{folder}", folder)
