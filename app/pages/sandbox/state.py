"""The state of a page that its script has to know."""

from __future__ import annotations

import math

from sim.scene.types import keys_of

from ...session.framing import Bounds
from ...stage.sketch import world_size
from ...ui.page import Page
from ...wire.to_page import PageState
from ...words.english import name_of
from .features import CONTROLS
from .page_panel import PagePanel


def page_state(
    page: Page,
    panel: PagePanel,
    number: str,
    playing: bool,
    at_rest: bool,
    broken: int,
    bounds: Bounds | None,
) -> PageState:
    """Collect the state of a page.

    Args:
        page: the page.
        panel: its panel.
        number: the id of its connection.
        playing: the clock runs, or will as soon as a heavy step is done.
        at_rest: the body stands while the clock runs.
        broken: number of broken springs.
        bounds: (2, 2) px, of the body's motion; None while they are not known.
    """
    session = page.session
    history, scrubbed = session.history, session.history.scrubbed
    width, height = world_size(session.scene)
    return PageState(
        page=number,
        scene=session.openings,
        title=name_of(session.scene),
        width=width,
        height=height,
        view=() if bounds is None else page.mapping.box(bounds),
        unit=session.scene.view.unit,
        joint=session.joint if session.scene.angular_springs else -1,
        playing=playing,
        rest=at_rest and playing,
        scrubbed=scrubbed,
        # In steps of half a second while time passes, so that it seldom changes.
        start=history.start if scrubbed else math.floor(2.0 * history.start) / 2.0,
        end=history.end if scrubbed else 0.0,
        speed=session.pacer.speed,
        offer=session.offer_back,
        future=session.abandoned_future is not None,
        follow=session.follow,
        arrows=keys_of(session.scene) if "keys" in page.controls else (),
        broken=broken,
        controls=tuple(name for name in CONTROLS if name in page.controls),
        gizmos=page.looks.gizmos,
        meter=page.looks.meter,
        measuring=panel.measure_tab,
        lesson=session.lesson_begun if panel.has_lesson else None,
    )
