"""Whether a device can take part in a class: the page that says so, and what keeps WebSockets out."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import pytest
from playwright.sync_api import Browser, Page, expect

import sim
from app.classroom import kept
from app.classroom.live import Class, Classes
from app.features.classroom.roles import desk_address, seat_address
from app.pages.check.page import check_address
from app.server.serve import serving
from tests.amount import at_night
from tests.browser.driver import LIMIT, until
from tests.browser.wires import Wire, wire

expect.set_options(timeout=LIMIT * 1e3)

PHONE = (390, 844)
OLD = """
  delete Array.prototype.at;
  Object.defineProperty(HTMLScriptElement.prototype, "noModule", { value: undefined });
  delete HTMLScriptElement.prototype.noModule;
"""
"""Has a browser lack what one of 2016 lacked."""
HURRIED = "window.__softrodHurry = 4"
"""Has the pages lose their patience sooner; `tests/page` tests the times."""


@dataclass
class Place:
    """A class, and a device that reaches it by a wire."""

    browser: Browser
    classroom: Class
    between: Wire

    @property
    def base(self) -> str:
        return f"http://127.0.0.1:{self.between.port}/"

    @property
    def check(self) -> str:
        return check_address(self.base, self.classroom.room.code)

    def device(self, script: str = "", size: tuple[int, int] = PHONE) -> Page:
        context = self.browser.new_context(viewport={"width": size[0], "height": size[1]})
        page = context.new_page()
        page.set_default_timeout(LIMIT * 1e3)
        if script:
            page.add_init_script(script)
        return page


@pytest.fixture
def place(browser: Browser, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    monkeypatch.setattr(kept, "classes_folder", lambda: tmp_path)
    classes = Classes()
    classroom = classes.begin((sim.load_scene("lesson-hooke"),))
    with ExitStack() as stack:
        server, _, _ = stack.enter_context(serving(sim.load_scene("ring"), "127.0.0.1", 0, classes=classes))
        between = stack.enter_context(wire(server.get_port()))
        yield Place(browser, classroom, between)


def found(page: Page, mark: str) -> list[str]:
    """What the page has marked so."""
    return page.locator(f"#found .{mark}").all_inner_texts()


def verdict(page: Page) -> str:
    """What it says in the end."""
    said = page.locator("#verdict")
    until(page, lambda: said.get_attribute("class"), "it comes to an end")
    return said.inner_text()


def test_a_device_that_can_take_part_says_so_and_the_teacher_reads_it(place: Place) -> None:
    desk = place.device(size=(1280, 720))
    desk.goto(desk_address(place.base, place.classroom))
    expect(desk.get_by_text("the network keeps devices apart")).to_be_visible()
    expect(desk.get_by_role("img", name=f"QR code of {place.check}")).to_be_visible()
    phone = place.device()
    asked: list[str] = []
    phone.on("request", lambda request: asked.append(request.url))
    phone.goto(place.check)
    assert "a class works from here" in verdict(phone).lower()
    assert not found(phone, "bad")
    lines = "\n".join(found(phone, "good"))
    for part in (
        "This page came", "Its scripts come", "live connection",
        "can show", "stores answers", "clock agrees",
    ):  # fmt: skip
        assert part in lines
    # How fast it is is the machine's.
    lines += "\n".join(found(phone, "fair"))
    assert "round trip takes" in lines
    assert "a second" in lines
    # It has nothing of the large page.
    assert {url.removeprefix(place.base).rpartition("/")[2].partition("?")[0] for url in asked} <= {
        "check", "check.js", "main.js", "reach", "icon.svg", "favicon.ico",
    }  # fmt: skip
    (tried,) = place.classroom.checks
    assert tried.works
    assert tried.rate > 0
    assert 0 <= tried.trip < 5000
    expect(desk.get_by_text(f"{tried.trip} ms, {tried.rate} pictures a second")).to_be_visible()
    # A device that only tries has no seat.
    assert not place.classroom.room.seats
    desk.context.close()
    phone.context.close()


@pytest.mark.parametrize("upgrades", ["refused", pytest.param("swallowed", marks=at_night)])
def test_where_websockets_are_kept_out_the_pages_say_so(
    place: Place, upgrades: Literal["refused", "swallowed"]
) -> None:
    place.between.upgrades = upgrades
    phone = place.device(HURRIED)
    phone.goto(place.check)
    assert "does not work" in verdict(phone)
    (why,) = found(phone, "bad")
    assert "lets none through" in why
    assert "hotspot" in why
    assert not place.classroom.checks
    # A pupil's page does not wait for ever, either.
    phone.goto(seat_address(place.base, place.classroom.room.code))
    expect(phone.get_by_text("blocks WebSockets")).to_be_visible()
    # And it comes in as soon as it can.
    place.between.upgrades = "led"
    until(phone, lambda: place.classroom.room.seats, "it has a seat", limit=LIMIT)
    expect(phone.get_by_text("blocks WebSockets")).to_be_hidden()
    phone.context.close()


def test_an_old_browser_with_a_private_window_and_a_wrong_clock_is_told(place: Place) -> None:
    script = """
      Object.defineProperty(window, "localStorage", { get() { throw new Error("forbidden"); } });
      const RealDate = Date;
      window.Date = function (...given) {
        return given.length ? new RealDate(...given) : new RealDate(RealDate.now() + 6e5);
      };
    """
    phone = place.device(OLD + script)
    phone.goto(place.check)
    assert "does not work" in verdict(phone)
    assert "too old" in "".join(found(phone, "bad"))
    doubts = "".join(found(phone, "fair"))
    assert "private window" in doubts
    assert "differ by 10 minutes" in doubts
    # The rest was looked at nevertheless.
    assert "live connection" in "".join(found(phone, "good"))
    until(phone, lambda: place.classroom.checks, "the teacher is told")
    assert not place.classroom.checks[0].works
    phone.goto(f"{place.check}&lang=de")
    assert "geht eine Klasse nicht" in verdict(phone)
    assert "um 10 Minuten" in "".join(found(phone, "fair"))
    phone.context.close()


def test_without_its_script_the_page_says_so(place: Place) -> None:
    phone = place.device()
    phone.route("**/check.js", lambda route: route.abort())
    phone.goto(place.check)
    expect(phone.get_by_text("Its script did not come")).to_be_visible()
    phone.context.close()
