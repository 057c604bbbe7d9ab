"""The plots of a body in a class: a pupil's own, or the one that all look at."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from sim.errors import InputError
from sim.scene.types import Scene

from ..session.plots import Plot, parse_plot
from ..session.session import Session


class Plotted:
    """The plots of one body, which follow its session.

    Attributes:
        opening: number of the opened scene; -1 before the first.
        plots: of it.
        time: simulated seconds of the last sample.
    """

    def __init__(self) -> None:
        self.opening = -1
        self.plots: tuple[Plot, ...] = ()
        self.time = -1.0
        self._specs: tuple[str, ...] = ()

    def follow(self, session: Session, specs: tuple[str, ...]) -> None:
        """Take a sample of each plot.

        Args:
            session: of the body.
            specs: names of the plots, see `parse_plot`; those that the scene does not have are left out.
        """
        if (session.openings, specs) != (self.opening, self._specs):
            self.opening, self._specs, self.time = session.openings, specs, -1.0
            self.plots = tuple(_plots(specs, session.scene))
        self.time = session.simulation.time
        for plot in self.plots:
            plot.sample(session)

    @property
    def values(self) -> NDArray[np.float64]:
        """What the plots show now: of each its quantities, and the one on the horizontal axis."""
        rows = [
            plot.rows[-1][1:] if len(plot.rows) else np.full(len(plot.quantities), math.nan)
            for plot in self.plots
        ]
        return np.concatenate(rows) if rows else np.zeros(0)


def _plots(specs: tuple[str, ...], scene: Scene) -> list[Plot]:
    plots = []
    for text in specs:
        try:
            plots.append(Plot(parse_plot(text), scene))
        except InputError:
            continue  # the teacher's body may have other parts than the step's
    return plots
