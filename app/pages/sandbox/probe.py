"""The inner state of a page for tests, which use nothing else of it, so that the rest may change."""

from __future__ import annotations

from dataclasses import dataclass

from ...session.plots import PlotSpec
from ...stage.sketch import Floats, Mapping
from ...ui.kept.keeper import KeptState
from ...ui.kept.keeping import Looks
from ...wire.to_page import PageState


@dataclass(frozen=True)
class Probe:
    """A page at a moment.

    Attributes:
        generation: of the body that is shown; -1 if it has to be built.
        state, hud: the last state and head-up display that were sent.
        looks: how it looks.
        controls: names of its controls; None for all.
        plots: the open plots.
        plots_seen: its user looks at them, as far as the server knows.
        kept: the state that was saved last; None before that.
        saved: that state as the browser was sent it; empty before that.
        owned: it is the page of this computer's owner.
        requests: number of its requests that wait for the ticker.
        nodes: names of viser's nodes, such as `/body/masses`.
        mapping: converts between the scene and the page's world.
        drawn: (n, 2) positions of the masses in its world in the last picture; read-only.
    """

    generation: int
    state: PageState | None
    hud: str
    looks: Looks
    controls: tuple[str, ...] | None
    plots: tuple[PlotSpec, ...]
    plots_seen: bool
    kept: KeptState | None
    saved: str
    owned: bool
    requests: int
    nodes: tuple[str, ...]
    mapping: Mapping
    drawn: Floats | None
