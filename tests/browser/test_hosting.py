"""The page behind a proxy: by TLS, in a folder of another site, at the end of a tunnel."""

from __future__ import annotations

import re
import ssl
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, Route

import sim
from app.classroom import kept
from app.classroom.live import Classes
from app.features.classroom.roles import desk_address, seat_address, wall_address
from app.pages.check.page import check_address
from app.server.serve import serving
from sim.compiling.compiler import ENTRY_POINTS
from sim.store.link import pack_scene
from tests.browser.conftest import DESKTOP
from tests.browser.driver import LIMIT, Desk, Served, rough_context, until
from tests.browser.wires import certified, self_signed, wire
from tests.proxies import FOLDERS, Proxy


@pytest.fixture(scope="module")
def signed(tmp_path_factory: pytest.TempPathFactory) -> ssl.SSLContext:
    """TLS for this machine."""
    return self_signed(tmp_path_factory.mktemp("tls"))


def begin(rest: ExitStack, browser: Browser, tls: ssl.SSLContext, folder: str, known: bool) -> Desk:
    """A page by https, in a folder, whose server may know of that or not."""
    listener = rest.enter_context(wire(0, tls, folder))
    url = f"https://localhost:{listener.port}{folder}"
    server, ticker, compiler = rest.enter_context(
        serving(sim.load_scene("tutorial-3.3"), "127.0.0.1", 0, public_url=url if known else None)
    )
    compiler.want(ENTRY_POINTS)
    compiler.start()
    compiler.wait()
    listener.to = server.get_port()
    context = rough_context(
        browser, viewport={"width": DESKTOP[0], "height": DESKTOP[1]}, ignore_https_errors=True
    )
    rest.callback(context.close)
    return Desk(Served(url, ticker), context)


@pytest.fixture
def rest() -> Iterator[ExitStack]:
    """What ends with the test."""
    with ExitStack() as stack:
        yield stack


def test_the_page_works_by_tls_in_a_folder(rest: ExitStack, browser: Browser, signed: ssl.SSLContext) -> None:
    desk = begin(rest, browser, signed, "/lab/", known=True)
    desk.open("")
    desk.until(lambda: desk.simulation.time > 0.2, "the body moves")
    start = desk.place(0)
    desk.drag(start, (start[0] + 90.0, start[1] + 20.0))
    desk.until(lambda: desk.simulation.positions[0, 0] > 340.0, "a drag works")
    # viser would have added the address of its WebSocket, and a reload would be turned away.
    assert desk.page.evaluate("location.pathname + location.search.replace(/^.fixedDpr=\\d/, '')") == "/lab/"
    gallery = desk.gallery()
    picture = gallery.locator(".softrod-card img").first
    desk.until(lambda: picture.evaluate("image => image.naturalWidth") > 0, "its pictures are there, too")
    desk.page.keyboard.press("Escape")
    # A link that holds a scene, in the same folder.
    desk.open("s#" + pack_scene(sim.load_scene("ring")))
    desk.until(lambda: desk.session.scene.name == "ring", "the scene of the link is there")
    assert desk.page.evaluate("location.pathname") == "/lab/"
    assert not desk.errors


def test_a_page_that_is_refused_says_what_to_do(
    rest: ExitStack, browser: Browser, signed: ssl.SSLContext
) -> None:
    desk = begin(rest, browser, signed, "/lab/", known=False)
    desk.page.goto(desk.served.url)
    site = desk.served.url.removesuffix("/lab/")
    desk.page.get_by_text(f"start softrod with --public-url {site}/").wait_for()


def test_a_class_behind_nginx_needs_nothing_from_outside_and_tells_no_secret(
    rest: ExitStack, browser: Browser, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Both servers of `docs/hosting/nginx.conf` run, in a network without a way out."""
    monkeypatch.setattr(kept, "classes_folder", lambda: tmp_path / "classes")
    proxy = Proxy("nginx", tmp_path, *certified(tmp_path))
    rooms, ports = [], []
    for folder in FOLDERS:
        classes = Classes()
        rooms.append(classes.begin((sim.load_scene("lesson-hooke"),)))
        server, *_ = rest.enter_context(
            serving(sim.rope(), "127.0.0.1", 0, public_url=proxy.url(folder), classes=classes)
        )
        ports.append(server.get_port())
    rest.enter_context(proxy.leading(*ports))
    context = rough_context(
        browser, viewport={"width": DESKTOP[0], "height": DESKTOP[1]}, ignore_https_errors=True
    )
    rest.callback(context.close)
    outside: list[str] = []

    def only_here(route: Route) -> None:
        if route.request.url.startswith((proxy.url("/"), "data:", "blob:")):
            route.continue_()
        else:
            outside.append(route.request.url)
            route.abort()

    context.route("**/*", only_here)
    sockets: list[str] = []
    errors: list[str] = []

    def opened(address: str) -> Page:
        page = context.new_page()
        page.on("websocket", lambda socket: sockets.append(socket.url))
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(address)
        return page

    here, there = rooms
    base = proxy.url(FOLDERS[1])
    teacher = opened(desk_address(base, there))
    until(teacher, lambda: there.teachers == 1, "the teacher leads", limit=LIMIT)
    assert there.room.key not in teacher.url
    teacher.close()
    wall = opened(wall_address(base, there.room.code))
    wall.get_by_role("img", name=f"QR code of {seat_address(base, there.room.code)}").wait_for()
    wall.close()
    seat = opened(seat_address(base, there.room.code))
    until(seat, lambda: 1 in there.pupils, "a pupil is there", limit=LIMIT)
    first = there.pupils[1]
    seat.reload()
    until(seat, lambda: there.pupils.get(1) not in (None, first), "the pupil is back", limit=LIMIT)
    seat.goto(check_address(base, there.room.code))
    seat.get_by_text("a class works from here").wait_for()
    assert len(there.room.seats) == 1
    assert not here.room.seats
    assert not outside
    assert {re.split("(?:at|line)/", socket)[0].replace("wss:", "https:") for socket in sockets} == {base}
    assert not errors
    # The proxy's owner reads which rooms there are, and no secret: neither in addresses nor as Referer.
    log = proxy.access_log()
    assert f"room={there.room.code}&as=desk" in log
    assert there.room.key not in log
    assert "teacher" not in log
    visitor = seat.evaluate("localStorage.getItem('softrod-visitor')")
    assert len(visitor) == 32
    assert visitor not in log
