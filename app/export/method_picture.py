"""The computing time of methods over their errors, as a picture in a page, in the page's colours."""

from __future__ import annotations

import html
import io
import re

from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from sim.analysis.advice import Advice
from sim.solve.registry import METHODS

from ..words import say
from ..words.settings import options_of

SIZE = 3.3, 4.2
"""Width and height, inches; the page makes it as wide as there is room."""

_TEXT, _GRID = "#010203", "#040506"
"""What stands for the page's colours, which are others in the dark."""


def methods_svg(advice: Advice) -> str:
    """An `svg` element with a line for each method, of the settings that none of its others beats."""
    figure = Figure(SIZE, layout="constrained")
    FigureCanvasSVG(figure)
    axes = figure.add_subplot()
    labels = options_of("method")
    for name, method in METHODS.items():
        points = advice.front(name)
        color, marker = method.look
        axes.loglog(
            [one.error for one in points],
            [1e3 * one.seconds for one in points],
            color=_TEXT if color == "black" else color,
            marker=marker,
            markersize=5.0,
            linewidth=1.4,
            label=labels[name],
        )
    axes.set_xlabel(say("solver-figure.error"), color=_TEXT, fontsize=9.0)
    axes.set_ylabel(say("solver-figure.time"), color=_TEXT, fontsize=9.0)
    axes.tick_params(which="both", color=_GRID, labelcolor=_TEXT, labelsize=9.0)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter("{x:g}")
    axes.grid(color=_GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    for spine in axes.spines.values():
        spine.set_color(_GRID)
    figure.legend(loc="outside lower center", ncols=2, frameon=False, fontsize=9.0, labelcolor=_TEXT)
    file = io.StringIO()
    figure.savefig(file, format="svg", transparent=True, metadata={"Date": None})
    text = file.getvalue()
    label = html.escape(say("solver-figure"), quote=True)
    drawing = re.sub(r' width="\S+" height="\S+"', "", text[text.index("<svg") :], count=1)
    drawing = drawing.replace("<svg ", f'<svg role="img" aria-label="{label}" style="width: 100%" ', 1)
    return drawing.replace(_TEXT, "currentColor").replace(_GRID, "var(--softrod-line)")
