"""What pupils give while their connections are cut, their pages reloaded and the server started anew."""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from studies.bench.classroom import Host, Storm, a_lesson, survive
from tests.amount import NIGHT, at_night

STORM = Storm(pupils=3, there=(0.4, 0.9), away=(0.1, 0.3), asked=1.0, seed=3, masses=4)
if NIGHT:
    STORM = Storm(pupils=3, there=(0.8, 2.0), away=(0.1, 0.8), asked=4.0, seed=3, masses=6)


@at_night
def test_in_a_storm_every_answer_counts_exactly_once(tmp_path: Path) -> None:
    # In a thread of its own: where browser tests run in the same process, this one has a loop already.
    with Host(a_lesson(STORM.masses), tmp_path) as host, ThreadPoolExecutor(1) as thread:
        outcome = thread.submit(asyncio.run, survive(host, STORM)).result()
    assert (outcome.twice, outcome.lost) == (0, 0)
    assert outcome.once == outcome.given - outcome.replaced > 0
    assert outcome.cuts > 0
    assert outcome.reloads > 0
    assert outcome.delays, "something waited for the network"
