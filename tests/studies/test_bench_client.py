"""The benchmarks' page without a browser speaks as the real one does, and gets scenes that it can have."""

from __future__ import annotations

from pathlib import Path

import sim
from app.features.hands import messages as hands
from app.server.serve import serving
from app.wire import from_page
from studies.bench import tabs
from studies.bench.client import FRAME_PLACES, Page, is_frame, saying, state_of


def test_a_page_without_a_browser_leads_a_body_and_stops_it() -> None:
    with serving(sim.load_scene("tutorial-3.3"), "127.0.0.1", 0) as (server, _, compiler):
        compiler.start()
        compiler.wait()
        with Page(server.get_port()) as page:
            page.wait_for(state_of)  # before that, nobody listens
            before = page.wait_for(is_frame)["numbers"][FRAME_PLACES]
            page.send(saying(from_page.Perform("follow")))
            page.wait_for(lambda message: (state := state_of(message)) is not None and state.get("follow"))
            page.send(saying(hands.At(((0, 0.5, 1.0),))))
            page.wait_for(lambda message: is_frame(message) and message["numbers"][FRAME_PLACES] != before)
            page.send(saying(from_page.Perform("pause")))
            page.wait_for(
                lambda message: (state := state_of(message)) is not None and not state.get("playing")
            )


def test_the_largest_cloth_next_to_a_rope_fits_into_a_file(tmp_path: Path) -> None:
    sim.save_scene(tabs.cloth(max(tabs.CLOTHS)), tmp_path / "cloth.json")
