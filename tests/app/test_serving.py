"""The served page without a browser: what goes over the wire, tabs that come and go, hostile values."""

from __future__ import annotations

import base64
import gc
import io
import time
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest import mock

import msgspec
import numpy as np
import pytest
import viser
from rich.console import Console

import sim
from app.features.gallery.messages import OpenScene
from app.pages.sandbox.tab import Tab
from app.server import serve as serve_module
from app.server.serve import print_addresses, serving, start_compiling
from app.server.ticker import Ticker
from app.session import commands
from app.session.commands import DragStart, Open
from app.session.plots import PlotSpec
from app.session.session import Session
from app.ui import owner
from app.ui.kept import keeper, keeping
from app.wire.from_page import Part, Perform
from app.wire.messages import FromPage
from sim.compiling.compiler import ENTRY_POINTS, EntryPoint
from sim.store.link import pack_scene
from studies.bench.client import FRAME_PLACES, Page, is_frame
from tests.app.hostile import eventually, served
from tests.app.inside import sandboxes


class Stage:
    """A server, and pages that connect to it."""

    def __init__(self, server: viser.ViserServer, ticker: Ticker) -> None:
        self.server, self.ticker = server, ticker

    @contextmanager
    def opened(self) -> Iterator[tuple[Page, Tab]]:
        """A page, and its tab once its session has begun."""
        known = set(self.ticker.tabs)

        def found() -> Tab | None:
            fresh = [tab for number, tab in sandboxes(self.ticker).items() if number not in known]
            began = fresh and fresh[0].session is not None and fresh[0].probe().generation >= 0
            return fresh[0] if began else None

        with Page(self.server.get_port()) as page:
            yield page, eventually(found)


@pytest.fixture(scope="module")
def stage() -> Iterator[Stage]:
    with serving(sim.load_scene("tutorial-3.3"), "127.0.0.1", 0) as (server, ticker, compiler):
        compiler.want(ENTRY_POINTS)
        compiler.start()
        compiler.wait()
        yield Stage(server, ticker)


@pytest.fixture(autouse=True)
def nobody_is_left(stage: Stage) -> Iterator[None]:
    yield
    eventually(lambda: not stage.ticker.tabs)


def session_of(tab: Tab) -> Session:
    assert tab.session is not None
    return tab.session


def nodes(messages: list[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    return {m["name"]: m for m in messages if "name" in m and "props" in m}


def sliders(page: Page) -> dict[str, dict[str, Any]]:
    """The sliders that a page has, whose clock stands, by their names on the wire."""
    there: dict[str, dict[str, Any]] = {}
    while messages := page.receive(0.3):
        for message in messages:
            if message["type"] == "GuiSliderMessage":
                there[message["uuid"]] = message
            elif message["type"] == "GuiRemoveMessage":
                there.pop(message["uuid"], None)
    return there


def say(page: Page, *messages: FromPage | str) -> None:
    """Send what the page's script would, or any text."""
    for message in messages:
        text = message if isinstance(message, str) else msgspec.json.encode(message).decode()
        page.send({"type": "SoftrodMessage", "text": text})


def pause(page: Page, tab: Tab) -> None:
    say(page, Perform("pause"))
    eventually(lambda: not session_of(tab).playing)


def test_one_node_per_kind(stage: Stage) -> None:
    """However many masses: paper, springs, wedges, ring and masses; a gizmo per held mass, if asked for."""
    with stage.opened() as (page, tab):
        body = {"/body/springs", "/body/wedges", "/body/ring", "/body/masses"}
        eventually(lambda: set(tab.probe().nodes) == body)
        tab.hear(Perform("gizmos"))
        eventually(lambda: set(tab.probe().nodes) == {*body, "/gizmos/0"})
        page.read_for(0.1)


def test_a_scene_pays_only_for_what_it_has(stage: Stage) -> None:
    with stage.opened() as (page, tab):
        bare = sim.rope(masses=5, joints=False, driven=None, held=())
        session_of(tab).post(Open(bare))
        session_of(tab).post(commands.Play(False))
        eventually(lambda: session_of(tab).generation == 1 and tab.probe().generation == 1)
        assert set(tab.probe().nodes) == {"/body/springs", "/body/masses"}
        labels = {slider["props"]["label"] for slider in sliders(page).values()}
        assert "Bending stiffness" not in labels
        assert "Stretching stiffness" in labels


def test_masses_on_the_wire_are_where_the_solver_has_them(stage: Stage) -> None:
    with stage.opened() as (page, tab):
        pause(page, tab)
        frames: list[np.ndarray] = []
        deadline = time.monotonic() + 0.5
        while time.monotonic() < deadline:
            frames += [m["numbers"] for m in page.receive(0.1) if is_frame(m)]
        positions = session_of(tab).simulation.positions
        assert frames[-1][FRAME_PLACES : FRAME_PLACES + positions.size] == pytest.approx(
            positions.ravel(), abs=1e-3
        )


def kept_letters(session: Session, plots: tuple[PlotSpec, ...] = ()) -> str:
    """What a page's script gives back of what it kept of a session."""
    kept = keeping.encode(session.keepsake(), keeping.Looks(dark=True), plots)
    return base64.b64encode(zlib.compress(kept)).decode()


def test_a_link_goes_before_what_the_page_kept(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    letters, link = kept_letters(Session(sim.load_scene("rod"))), pack_scene(sim.load_scene("box"))
    with stage.opened() as (page, tab):
        with monkeypatch.context() as patch:
            patch.setattr(Tab, "frame", lambda *_: False)  # the ticker is late
            say(page, Part("resume", 1, 1, letters), Part("link", 1, 1, link))
            eventually(lambda: tab.probe().requests == 2)
        eventually(lambda: tab.probe().looks.dark)  # the page looks as it did
        eventually(lambda: session_of(tab).scene.name == "box")
        eventually(lambda: not session_of(tab).waiting)
        assert session_of(tab).scene.name == "box"


def test_what_the_page_kept_brings_its_plots_whenever_it_comes(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    letters = kept_letters(Session(sim.load_scene("rod")), (PlotSpec(("joint0.angle",)),))
    with stage.opened() as (_, tab):
        in_the_middle_of_a_frame(tab, lambda: tab.hear(Part("resume", 1, 1, letters)), monkeypatch)
        eventually(lambda: tab.probe().looks.dark and session_of(tab).scene.name == "rod")
        eventually(lambda: tab.probe().plots == (PlotSpec(("joint0.angle",)),))


def test_what_the_page_gives_back_is_not_lost_with_a_panel(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    letters = kept_letters(Session(sim.load_scene("rod")))
    with stage.opened() as (page, tab):

        def resume() -> None:
            # The frame goes on with another panel, and forgets what was asked by the controls of this one.
            session_of(tab).post(Open(sim.load_scene("lesson-hooke")))
            session_of(tab).drain()
            tab.hear(Part("resume", 1, 1, letters))

        in_the_middle_of_a_frame(tab, resume, monkeypatch)
        eventually(lambda: tab.probe().looks.dark and session_of(tab).scene.name == "rod")
        page.read_for(0.1)


def in_the_middle_of_a_frame(tab: Tab, act: Callable[[], None], monkeypatch: pytest.MonkeyPatch) -> None:
    """Have something done in the next frame of a tab, after the ticker has looked at what was asked for."""
    tick, acted = Session.tick, []

    def tick_then_act(session: Session, *given: float) -> None:
        tick(session, *given)
        if session is tab.session and not acted:
            acted.append(act())

    monkeypatch.setattr(Session, "tick", tick_then_act)


class Sluggish:
    """A processor of which a keepsake takes half a second."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.used = 0.0
        monkeypatch.setattr(keeper.time, "thread_time", self)

    def __call__(self) -> float:
        self.used += 0.5  # that alone would put the next keepsake off by 500 s
        return self.used


def test_however_long_a_keepsake_took_another_one_comes_in_time(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    with stage.opened() as (page, _):
        monkeypatch.setattr(keeper, "MAX_INTERVAL", 0.1)
        processor = Sluggish(monkeypatch)
        eventually(lambda: processor.used >= 3.0)
        page.read_for(0.1)


def test_another_scene_is_kept_at_once_however_long_the_last_keepsake_took(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    with stage.opened() as (page, tab):
        monkeypatch.setattr(keeper, "MAX_INTERVAL", 1e9)
        processor = Sluggish(monkeypatch)
        eventually(lambda: processor.used)
        say(page, OpenScene("box"))
        eventually(lambda: session_of(tab).scene.name == "box")
        eventually(lambda: is_kept(tab))


def is_kept(tab: Tab) -> bool:
    """Whether the browser was told to keep the session as it is."""
    kept = tab.probe().kept
    return kept is not None and kept.revision == session_of(tab).revision


def test_nothing_is_sent_while_paused(stage: Stage) -> None:
    with stage.opened() as (page, tab):
        page.read_for(1.0)
        pause(page, tab)
        eventually(lambda: is_kept(tab) and page.read_for(0.1) is None)
        page.read_for(0.5)
        before = page.messages
        page.read_for(1.5)
        assert page.messages == before
        say(page, Perform("play"))
        page.read_for(0.5)
        assert page.messages > before


def test_nothing_is_sent_at_rest(stage: Stage) -> None:
    """The hanging rope swings out; then the clock runs on, and the wire is silent."""
    with stage.opened() as (page, tab):
        session = session_of(tab)
        still = sim.set_value(sim.rope(gravity=(0.0, 0.0)), "linear_damping", 200.0)
        session.post(Open(still))
        eventually(lambda: session.generation == 1)
        page.read_for(2.0)
        before, steps = page.messages, session.simulation.step_count
        page.read_for(1.5)
        assert session.simulation.step_count > steps
        assert page.messages == before
        assert "at rest" in tab.probe().hud


def test_pages_have_simulations_of_their_own(stage: Stage) -> None:
    with stage.opened() as (one, first), stage.opened() as (other, second):
        assert first is not second
        pause(one, first)
        assert session_of(second).playing
        say(other, Perform("play"))
        other.read_for(0.5)
        assert not session_of(first).playing


def test_a_page_that_goes_in_the_middle_of_a_drag_is_forgotten(stage: Stage) -> None:
    with stage.opened() as (stays, first):
        known = set(stage.ticker.tabs)
        with stage.opened() as (_, second):
            session_of(second).post(DragStart(3, 300.0, 250.0))
            eventually(lambda: session_of(second).hands.masses == (3,))
        eventually(lambda: set(stage.ticker.tabs) == known)
        steps = session_of(first).simulation.step_count
        eventually(lambda: session_of(first).simulation.step_count > steps)
        stays.read_for(0.1)


def test_nothing_is_computed_for_nobody(stage: Stage) -> None:
    with stage.opened() as (page, tab):
        session = session_of(tab)
        page.read_for(0.2)
    eventually(lambda: not stage.ticker.tabs)
    steps = session.simulation.step_count
    used = time.thread_time_ns()
    time.sleep(0.5)
    assert session.simulation.step_count == steps
    assert stage.ticker.asleep
    assert time.thread_time_ns() >= used


FORGED = (
    '{"do":"at","hands":[[0,NaN,0]]}',
    '{"do":"at","hands":[[0,1e400,2]]}',
    '{"do":"keys","held":["ZZ"]}',
    '{"do":"perform","command":"shutdown"}',
    "[" * 5000,
    "x" * 5000,
    '{"do":"at","hands":[[0,' + "9" * 40 + ",0]]}",
)


def test_forged_messages_change_nothing(stage: Stage) -> None:
    with stage.opened() as (page, tab):
        pause(page, tab)
        before = session_of(tab).simulation.positions
        say(page, *FORGED)
        page.read_for(0.3)
        assert np.array_equal(session_of(tab).simulation.positions, before)
        say(page, Perform("play"))
        eventually(lambda: session_of(tab).playing)


def test_a_forged_slider_is_clamped(stage: Stage) -> None:
    with stage.opened() as (page, tab):
        pause(page, tab)
        there = sliders(page)
        assert len(there) > 5
        for value in (1e9, -1e9, 1e308):
            for uuid in there:
                page.send({"type": "GuiUpdateMessage", "uuid": uuid, "updates": {"value": value}})
            page.read_for(1.0)
            scene = session_of(tab).scene
            assert sim.validate(scene) is scene
        say(page, Perform("play"))
        eventually(lambda: stage.ticker.tabs)


def test_a_defect_in_one_tab_leaves_the_others_alone(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    with stage.opened() as (one, first), stage.opened() as (other, second):
        monkeypatch.setattr(first, "frame", mock.Mock(side_effect=RuntimeError("a defect")))
        eventually(lambda: first not in stage.ticker.tabs.values())
        one.wait_for(lambda m: m.get("props", {}).get("title") == "This page has stopped")
        steps = session_of(second).simulation.step_count
        eventually(lambda: session_of(second).simulation.step_count > steps)
        other.read_for(0.05)


def _pretend_nothing_is_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    """Until the patch is undone, no kernel counts as ready."""
    monkeypatch.setattr(EntryPoint, "ready", property(lambda _: False))


@contextmanager
def uncompiled(name: str) -> Iterator[tuple[Page, Ticker]]:
    """A page of a server that does not compile."""
    with (
        serving(sim.load_scene(name), "127.0.0.1", 0) as (server, ticker, _),
        Page(server.get_port()) as page,
    ):
        yield page, ticker


def test_before_anything_is_compiled_every_preset_moves(monkeypatch: pytest.MonkeyPatch) -> None:
    _pretend_nothing_is_compiled(monkeypatch)
    for name in ("tutorial-3.3", "ring", "study-w5"):
        with uncompiled(name) as (page, ticker):
            page.wait_for(lambda m: m.get("name") == "/body/masses" and "props" in m)
            page.wait_for(lambda m: "moves by NumPy" in str(m))
            (tab,) = sandboxes(ticker).values()
            eventually(lambda tab=tab: session_of(tab).simulation.step_count > 0)
            assert session_of(tab).simulation.plain


def test_when_its_method_is_compiled_the_body_goes_on_with_it(monkeypatch: pytest.MonkeyPatch) -> None:
    for point in ENTRY_POINTS.values():
        point.load()
    _pretend_nothing_is_compiled(monkeypatch)
    with uncompiled("ring") as (page, ticker):
        page.wait_for(lambda m: m.get("type") == "GuiTabGroupMessage")
        (tab,) = sandboxes(ticker).values()
        eventually(lambda: tab.session is not None)
        session = session_of(tab)
        session.post(commands.SetValue("linear_stiffness", 12345.0))
        session.post(commands.FollowEnergy(True))
        session.post(commands.Compare("rodas4", ""))
        page.wait_for(lambda m: "is followed when it is compiled" in str(m))
        page.wait_for(lambda m: "comes when it is compiled" in str(m))
        eventually(lambda: session.simulation.step_count > 10)
        steps, before = session.simulation.step_count, session.simulation.positions
        monkeypatch.undo()
        eventually(lambda: not session.simulation.plain)
        assert session.simulation.step_count >= steps
        # A frame or two of motion, and not a start anew.
        assert np.abs(session.simulation.positions - before).max() < 100.0
        page.wait_for(lambda m: "residual" in str(m))
        page.wait_for(lambda m: "largest distance" in str(m))
        assert session.ghost is not None
        assert not session.ghost.is_compiling
        assert max(s.stiffness for s in session.scene.linear_springs) == 12345.0


def test_the_address_for_others_never_has_the_owner_s_key(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    shown: list[str] = []
    monkeypatch.setattr(serve_module, "print_qr_code", shown.append)
    for names, public in ((("laptop.local",), None), ((), "https://school.example/lab/")):
        text = io.StringIO()
        with served(extra_hosts=names, public_url=public) as server:
            address = print_addresses(server, "127.0.0.1", public, True, Console(file=text, width=200))
        own = f"http://127.0.0.1:{server.get_port()}/"
        assert address == f"{own}#owner={owner.key()}"
        assert f"softrod is at {address}" in text.getvalue()
        assert shown.pop() == (public or own)


def test_what_stays_until_the_end_is_none_of_the_garbage_collectors_business(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = sim.load_scene("tutorial-3.3")
    before = gc.get_freeze_count()
    try:
        with serving(scene, "127.0.0.1", 0) as (_, ticker, compiler):
            monkeypatch.setattr(compiler, "start", lambda: None)
            start_compiling(scene, ticker, compiler)
            assert eventually(lambda: gc.get_freeze_count() > before)
    finally:
        gc.unfreeze()
