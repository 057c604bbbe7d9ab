"""Tables that are opened in a page, without a browser."""

from __future__ import annotations

import threading
import time
from typing import Any

import pytest

import sim
from app.features.fit import panel
from app.wire.from_page import Part
from app.words.spoken import speaking
from sim.errors import InputError
from sim.text import Text
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


def test_how_far_a_fit_has_come_is_said_in_the_language_of_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    over = threading.Event()

    def fit(*given: Any) -> None:
        given[-1](Text("where to begin"))
        over.wait(30.0)
        raise InputError("it is over")

    monkeypatch.setattr(sim, "fit", fit)
    monkeypatch.setattr(panel, "is_ready", lambda _: True)
    told = ""
    try:
        with speaking("de"):
            page = WholePage("pendulum")
            page.shown(Part("file", 1, 1, packed("run.csv", b"t,mass1.x\n0,400\n0.1,410\n0.2,420\n")))
            end = time.monotonic() + 30.0
            while "Anpassen" not in page.gui and time.monotonic() < end:  # another thread reads it
                page.shown()
            page.enter("Längenmaßstab", True)
            page.enter("Anpassen")
            while "wo zu beginnen ist" not in told and time.monotonic() < end:
                page.shown()
                told = " ".join(str(one.content) for one in page.gui.there if one.kind == "html")
    finally:
        over.set()
    assert "wo zu beginnen ist" in told
