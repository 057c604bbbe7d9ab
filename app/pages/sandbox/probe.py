"""What a test may know of a page's inside: it asks for nothing else, so that the inside may change."""

from __future__ import annotations

from dataclasses import dataclass

from ...session.plots import PlotSpec
from ...stage.sketch import Floats, Mapping
from ...ui.kept.keeper import KeptState
from ...ui.kept.keeping import Looks
from ...wire.to_page import PageState


@dataclass(frozen=True)
class Probe:
    """A page at a moment; nothing in it changes.

    Attributes:
        generation: of the body that its panel is for; -1 while there is none, or it is to be made anew.
        state, hud: what its script was told last of the page, and of the head-up display.
        looks: how it looks.
        controls: names of those that it has; None for all.
        plots: those that are open.
        plots_seen: whether its user looks at them, as far as the server knows.
        kept: what the browser was told to keep last; None if nothing was.
        owned: whether it is the page of this computer's owner.
        requests: how many of its requests wait for the ticker.
        nodes: names of what there is to be drawn, as `/body/masses`.
        mapping: from the scene to the page's world and back.
        drawn: (n, 2) where the masses are in its world, in the picture that was sent last; read-only.
    """

    generation: int
    state: PageState | None
    hud: str
    looks: Looks
    controls: tuple[str, ...] | None
    plots: tuple[PlotSpec, ...]
    plots_seen: bool
    kept: KeptState | None
    owned: bool
    requests: int
    nodes: tuple[str, ...]
    mapping: Mapping
    drawn: Floats | None
