"""Tables that are opened in a page, without a browser."""

from __future__ import annotations

import time

from app.wire.from_page import Part
from tests.app.test_requests import packed
from tests.app.whole import WholePage


def test_of_several_runs_in_a_table_one_is_chosen() -> None:
    page = WholePage("pendulum")
    rows = "t,mass1.x,t,mass1.x\n0,400,0,300\n0.1,410,0.2,310\n0.2,420,,\n"
    page.shown(Part("file", 1, 1, packed("runs.csv", rows.encode())))
    end = time.monotonic() + 30.0
    while "Run" not in page.gui and time.monotonic() < end:  # another thread reads it
        page.shown()
    assert page.gui["Run"].options == ("run 1", "run 2")

    def points() -> list[float]:
        (told,) = [one for one in page.client.mail.sent if '"measured"' in getattr(one, "text", "")][-1:]
        return told.numbers.reshape(-1, 3)[:, 1].tolist()

    assert points() == [400.0, 410.0, 420.0]
    page.enter("Run", "run 2")
    assert points() == [300.0, 310.0]
    page.enter("Forget the table")
    assert "Run" not in page.gui
