"""The colours of a page, and which of its controls look otherwise than viser draws them."""

from __future__ import annotations

from ..drawing.colors import Palette


def colors_css(colors: Palette, dark: bool) -> str:
    """The styles' variables in a palette's colours.

    Args:
        colors: the palette.
        dark: whether the page is dark.
    """
    root = {
        "text": colors.css("text"),
        "line": colors.css("grid_major"),
        "grid": colors.css("grid"),
        "brand": colors.css("driven"),
        "on-brand": "#0b1020" if dark else "#ffffff",
        "paper": colors.css("paper"),
        "key": "#1a2230" if dark else "#f6f8fb",
        "warn": "#ff922b" if dark else "#c2410c",
    }
    return f":root{{{';'.join(f'--softrod-{name}:{value}' for name, value in root.items())}}}"
