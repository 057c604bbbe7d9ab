"""The figures of `softrod validate`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from sim.scene.types import Method

from ..reporting.figures import BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, new_figure, tidy
from ..reporting.report import Figure as Section
from . import exact, motion, statics
from .results import fitted_slope

if TYPE_CHECKING:
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

SHAPES = (1.0, 3.0, 10.0, 30.0, 100.0, 1000.0)
"""Gamma of the cantilevers that are drawn."""


def _plain(axis: Axis, ticks: Sequence[float]) -> None:
    """Put ticks at these values of a logarithmic axis, as plain numbers."""
    axis.set_ticks(ticks, labels=[f"{tick:g}" for tick in ticks])
    axis.set_ticks([], minor=True)


def master_curve() -> Figure:
    """Draw H / W of heavy cantilevers over Gamma, and its error."""
    figure, (top, bottom) = new_figure(7.0, 6.6, rows=2, sharex=True, height_ratios=(3, 2))
    weights = np.geomspace(0.1, 1000.0, 81)
    exact_ratios = np.array([statics.exact_drop_over_reach(float(w)) for w in weights])
    top.loglog(weights, exact_ratios, color=BLACK, lw=1.4, label="exact elastica")
    for n, color, marker, size in ((12, ORANGE, "o", 8.0), (50, BLUE, "x", 6.5)):
        style = {"color": color, "mfc": "none", "mew": 1.6, "ms": size, "ls": "none", "marker": marker}
        ratios = [statics.drop_over_reach(n, load) for load in statics.LOADS]
        top.loglog(statics.LOADS, ratios, label=f"softrod, N = {n}", **style)
        errors = [_percent_off(n, load) for load in statics.LOADS]
        bottom.loglog(statics.LOADS, errors, **style)
        bottom.loglog(weights, [_percent_off(n, float(w)) for w in weights], color=color, lw=0.9)
    top.set_ylabel("drop / reach of the free end, H / W")
    top.legend(frameon=False)
    bottom.set_ylabel("error of H / W, % (size)")
    bottom.set_xlabel("weight against stiffness, Γ = w L³ / EI")
    bottom.set_ylim(3e-4, 50.0)
    for side, x, y in (("right", 8.3, 1.2e-3), ("left", 345.0, 0.06)):
        bottom.text(x, y, "changes sign", color=GREY, fontsize=9, ha=side)
    _plain(bottom.xaxis, (0.1, 1.0, 10.0, 100.0, 1000.0))
    _plain(top.yaxis, (0.01, 0.1, 1.0, 10.0))
    _plain(bottom.yaxis, (0.001, 0.01, 0.1, 1.0, 10.0))
    for axes in (top, bottom):
        tidy(axes)
    return figure


def _percent_off(segments: int, weight: float) -> float:
    """Return the size of the relative error of H / W, per cent."""
    return 100.0 * abs(
        statics.drop_over_reach(segments, weight) / statics.exact_drop_over_reach(weight) - 1.0
    )


def convergence() -> Figure:
    """Draw errors over the number of springs, and over the time step."""
    figure, (left, right) = new_figure(9.8, 4.8, columns=2)
    sag, tension = statics.errors_of_catenary(1.25)
    lines: tuple[tuple[str, statics.Errors, str, str], ...] = (
        ("catenary, sag", sag, PURPLE, "v"),
        ("cantilever, H / W at Γ = 1", statics.errors_of_cantilever(1.0), BLUE, "o"),
        ("hanging rope, ω₁", statics.errors_of_rope(0), GREEN, "D"),
        ("catenary, tension", tension, BLACK, "x"),
        ("load at the tip, H / L", statics.errors_of_tip(1.0), SKY, "s"),
        ("beam, ω₁", statics.errors_of_beam(), ORANGE, "^"),
    )
    for label, (sizes, errors), color, marker in lines:
        left.loglog(1.0 / np.array(sizes), np.abs(errors), **_line(color, marker), label=label)
    left.plot([30.0, 60.0], [2.2e-3, 0.55e-3], color=GREY, lw=1.2, ls="--")
    left.text(44.0, 1.2e-3, "slope −2", color=GREY, fontsize=9)
    left.set_xlabel("springs per length, L / h")
    left.set_ylabel("relative error (size)")
    left.set_ylim(2.5e-6, 6e-3)
    _plain(left.xaxis, (10.0, 20.0, 50.0, 100.0))
    methods: tuple[tuple[str, Method, str, str], ...] = (
        ("symplectic Euler, stable spring", "symplectic_euler", ORANGE, "o"),
        ("generalized-alpha", "generalized_alpha", GREEN, "^"),
        ("velocity Verlet", "velocity_verlet", BLUE, "s"),
        ("Runge-Kutta 4", "rk4", PURPLE, "D"),
    )
    for label, method, color, marker in methods:
        errors = [motion.oscillator_error(method, dt) for dt in motion.STEPS]
        slope = fitted_slope(motion.STEPS, errors)
        label = f"{label}: slope {slope:.2f}"
        right.loglog(1000.0 * np.array(motion.STEPS), errors, **_line(color, marker), label=label)
    right.set_xlabel("time step, ms")
    right.set_ylabel("error of the damped oscillator, px")
    right.set_ylim(3e-11, 3.0)
    _plain(right.xaxis, (1.25, 2.5, 5.0, 10.0))
    left.legend(frameon=False, fontsize=8.5, loc="lower left")
    right.legend(frameon=False, fontsize=8.5, loc="lower right")
    for axes in (left, right):
        tidy(axes)
    return figure


def _line(color: str, marker: str) -> dict[str, Any]:
    """Return the style of points on a line."""
    return {"color": color, "marker": marker, "ms": 5.5, "lw": 1.0, "mfc": "none"}


def shapes() -> Figure:
    """Draw heavy cantilevers at rest."""
    figure, axes = new_figure(7.2, 6.8)
    for i, weight in enumerate(SHAPES):
        first = i == 0
        curve = exact.elastica(weight)
        axes.plot(curve.x, curve.y, color=GREY, lw=1.3, label="exact elastica" if first else None)
        x, y = statics.resting_shape(12, weight).T
        label = "softrod, N = 12" if first else None
        axes.plot(x[2:], y[2:], "o", color=BLUE, ms=4.8, mfc="none", mew=1.2, label=label)
        if first:
            axes.plot(x[:2], y[:2], "s", color=BLACK, ms=5.5, label="its two held masses", zorder=3)
        end = (float(curve.x[-1]), float(curve.y[-1]))
        axes.annotate(f"Γ = {weight:g}", end, (8, -5), textcoords="offset points", fontsize=9.5)
    axes.set_aspect("equal")
    axes.set_xlim(-0.1, 1.12)
    axes.set_ylim(1.04, -0.06)
    axes.set_xlabel("x / L")
    axes.set_ylabel("y / L, downwards")
    axes.legend(frameon=False, loc="lower right")
    tidy(axes)
    return figure


FIGURES = (
    Section(
        "master-curve",
        "Heavy cantilevers: drop over reach of the free end, and its error, over Γ = w L³ / EI.",
        master_curve,
    ),
    Section(
        "shapes", "Heavy cantilevers at rest: the exact elastica, and softrod with twelve springs.", shapes
    ),
    Section("convergence", "Errors over the number of springs, and over the time step.", convergence),
)
"""The figures of the report."""
