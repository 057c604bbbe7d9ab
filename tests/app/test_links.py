"""Links that a page makes and opens, without a browser; and `softrod link`."""

from __future__ import annotations

import re
import threading
from pathlib import Path
from typing import Any

import msgspec
import pytest

import sim
from app.features.files.messages import Link, Share
from app.features.files.sharing import Sharing
from app.gate import address
from app.gate.address import address_for_others, public_address
from app.pages.sandbox.features import CONTROLS
from app.session import commands
from app.session.notices import Notice
from app.ui import controls
from app.ui.controls import Controls
from app.ui.kept.keeping import ChunkAssembler
from app.ui.opening import asked_scene
from app.wire.from_page import Part
from app.wire.messages import Ask, read
from sim.errors import SceneError
from sim.store.files import decode_link, save_user_scene
from sim.store.link import pack_scene
from sim.store.shared import shared_folder, shared_scene
from tests.app.command import Softrod, refused
from tests.app.hostile import Sandbox, answer
from tests.app.letters import Letters
from tests.app.pages import SessionPage
from tests.app.panels import page_of

PAGE = "http://127.0.0.1:8080/"


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A data folder of the test's own."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    if tmp_path not in shared_folder().parents:
        pytest.skip("this platform keeps data elsewhere than XDG_DATA_HOME says")


class Page(SessionPage):
    """A session with its links."""

    def __init__(self, name: str) -> None:
        super().__init__(sim.load_scene(name))
        self.letters, self.notices = Letters(), list[Notice]()
        self.sharing = Sharing(page_of(self.session, None, self.letters, self.notices.append), self.open)

    def open(self, scene: sim.Scene) -> None:
        """Open a scene."""
        self.session.post(commands.Open(scene))

    def link(self, pose: bool = False, **wishes: Any) -> Link:
        """What comes back when a link is asked for."""
        ask = Share(pose=pose, page=PAGE, **wishes)
        asking = threading.Thread(target=self.sharing.share, args=(ask,))
        asking.start()
        while asking.is_alive():
            self.session.drain()
            asking.join(0.001)
        return self.letters.last(Link)


def test_a_link_has_the_scene_as_it_is_now() -> None:
    page = Page("tutorial-3.3")
    page.frames(30, commands.SetValue("gravity", 321.0))
    plain, posed = page.link(pose=False), page.link(pose=True)
    scene = decode_link(plain.link.removeprefix(f"{PAGE}s#"))
    assert scene == page.session.scene
    assert plain.qr.startswith("data:image/svg+xml")
    there = decode_link(posed.link.removeprefix(f"{PAGE}s#"))
    assert (sim.Simulation(there).positions == page.simulation.positions).all()


def test_a_long_link_has_no_qr_code() -> None:
    assert not Page("tree").link(pose=True).qr


def test_a_preset_s_short_address_is_its_name(home: None) -> None:
    letter = Page("lesson-hooke").link(short=True)
    assert letter.link == f"{PAGE}?scene=lesson-hooke"
    assert letter.qr.startswith("data:image/svg+xml")
    assert not shared_folder().exists()


def test_any_other_scene_s_short_address_is_a_code_that_outlives_the_server(home: None) -> None:
    page = Page("ring")
    page.frames(1, commands.SetValue("gravity", 321.0))
    link = page.link(short=True).link
    assert page.link(short=True).link == link
    match = re.fullmatch(rf"{re.escape(PAGE)}\?(s=\w{{4}})", link)
    assert match is not None
    assert asked_scene(match[1]) == page.session.scene
    assert asked_scene(match[1].lower()) == page.session.scene
    assert page.link(pose=True, short=True).link != link


def test_an_address_says_which_controls_a_phone_gets(home: None) -> None:
    page = Page("tutorial-3.3")
    short = page.link(short=True, controls="sliders").link
    assert short == f"{PAGE}?scene=tutorial-3.3&controls=play,rest_angle,angular_stiffness"
    assert controls.of_query(short.partition("?")[2], CONTROLS) == Controls(
        ("play", "rest_angle", "angular_stiffness")
    )
    long = page.link(controls="play").link
    assert long.startswith(f"{PAGE}s?controls=play#1.")


@pytest.mark.parametrize(
    ("query", "said"),
    [
        ("scene=nothing", "there is no preset called 'nothing'"),
        ("scene=..%2F..%2Fetc%2Fpasswd", "there is no preset called '../../etc/passwd'"),
        ("scene=mine", "there is no preset called 'mine'"),
        ("scene=", "there is no preset called ''"),
        ("s=ZZZZ", "no scene is kept under 'ZZZZ' here"),
        ("s=../scenes/mine", "no scene is kept under '../SCENES/MINE' here"),
        ("s=", "no scene is kept under '' here"),
    ],
)
def test_an_address_without_a_scene_is_one_sentence(home: None, query: str, said: str) -> None:
    save_user_scene(sim.rope(), "mine")  # its owner's own, which no address opens
    with pytest.raises(SceneError) as caught:
        asked_scene(query)
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_other_addresses_ask_for_no_scene() -> None:
    assert asked_scene("") is None
    assert asked_scene("controls=play") is None
    assert asked_scene("scene=ring&websocket=ws://evil.example") is None
    assert asked_scene("scene=ring&scene=rod") is None
    assert asked_scene("scene=Lesson-Hooke") == sim.load_scene("lesson-hooke")


def test_others_get_an_address_that_they_can_reach(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(address, "local_addresses", lambda: ["192.168.1.7"])
    here = "http://127.0.0.1:8080/"
    assert address_for_others(here, "127.0.0.1", 8080, None) == here
    assert address_for_others(here, "0.0.0.0", 8080, None) == "http://192.168.1.7:8080/"
    assert address_for_others("http://localhost:9000/", "0.0.0.0", 8080, None) == "http://192.168.1.7:8080/"
    # Reached by an address that others can use, it is that.
    assert address_for_others("http://10.0.0.4:8080/", "0.0.0.0", 8080, None) == "http://10.0.0.4:8080/"
    public = public_address("https://school.example/lab/")
    assert address_for_others(here, "127.0.0.1", 8080, public) == "https://school.example/lab/"
    monkeypatch.setattr(address, "local_addresses", list)
    assert address_for_others(here, "0.0.0.0", 8080, None) == here


def test_a_link_opens_and_a_bad_one_is_one_sentence() -> None:
    page = Page("ring")
    rope = sim.load_scene("tutorial-3.3")
    page.sharing.open(pack_scene(rope)[:-5])
    page.frames(1)
    (notice,) = page.notices
    assert (notice.kind, notice.title) == ("error", "That link cannot be opened")
    assert "broken" in notice.text
    assert page.session.scene.name == "ring"
    page.sharing.open(pack_scene(rope))
    page.frames(1)
    assert page.session.scene == rope


@pytest.mark.parametrize(
    "message",
    [
        "", "{}", "{", '{"do":"share"}', '{"do":"format"}', "[]",
        '{"do":"share","pose":1,"page":"http://x/"}',
        '{"do":"share","pose":true,"page":"javascript:alert(1)"}',
        '{"do":"share","pose":true,"page":"http://x/\\"><script>"}',
        '{"do":"share","pose":true,"page":"http://x/","more":1}',
        '{"do":"share","pose":true,"page":"http://' + "x" * 2000 + '/"}',
        "{" * 900 + "}", '{"do":"share","pose":true,"page":"http://x/"};', "[" * 100_000, "{\ud800}}",
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_not_answered(message: str) -> None:
    assert read(message) is None


def test_what_the_page_asks_for_is_understood() -> None:
    message = '{"do":"share","pose":true,"page":"http://[::1]:8080/lab/"}'
    assert read(message) == Share(pose=True, page="http://[::1]:8080/lab/")
    assert issubclass(Share, Ask)


def test_parts_are_put_together_in_their_order() -> None:
    part = read('{"do":"part","kind":"link","number":1,"of":2,"letters":"1.ab<>%"}')
    assert part == Part("link", 1, 2, "1.ab<>%")
    assert read('{"do":"part","kind":"link","number":1,"of":2,"letters":"a b"}') is None
    assert read('{"do":"part","kind":"rm -r","number":1,"of":1,"letters":"a"}') is None
    parts = ChunkAssembler()
    assert parts.add(1, 2, "a") is None
    assert parts.add(1, 2, "b") is None  # begun anew
    assert parts.add(2, 2, "c") == "bc"
    assert parts.add(2, 2, "c") is None
    assert parts.add(3, 2, "c") is None


def test_the_gate_serves_a_page_for_links() -> None:
    sandbox = Sandbox()
    try:
        host = [("Host", f"127.0.0.1:{sandbox.port}")]
        assert answer(sandbox.port, host, "/s/")[0] == 404
        assert answer(sandbox.port, host, "/s?websocket=ws://evil.example")[0] == 307
    finally:
        sandbox.close()


def test_the_command_prints_a_link_that_every_command_takes(softrod: Softrod) -> None:
    out = softrod("link", "ring", "--set", "gravity=321", "--address", "http://10.0.0.4:8080/").stdout
    link = out.strip()
    assert link.startswith("http://10.0.0.4:8080/s#1.")
    assert sim.load_scene(link) == sim.set_value(sim.load_scene("ring"), "gravity", 321.0)
    assert softrod("link", link, "--address", "http://10.0.0.4:8080").stdout == out
    assert len(softrod("link", "ring", "--qr").stdout.splitlines()) > 20


def test_the_command_prints_a_short_address(softrod: Softrod, home: None) -> None:
    where = ("--address", "https://school.example/lab/", "--short")
    assert softrod("link", "ring", *where).stdout == "https://school.example/lab/?scene=ring\n"
    out = softrod("link", "ring", "--set", "gravity=321", *where).stdout
    code = out.strip().removeprefix("https://school.example/lab/?s=")
    assert shared_scene(code) == sim.set_value(sim.load_scene("ring"), "gravity", 321.0)
    assert len(softrod("link", "study-cloth", "--short", "--qr").stdout.splitlines()) > 10


def test_the_command_keeps_a_pose_where_it_is_told_to(softrod: Softrod, tmp_path: Path) -> None:
    simulation = sim.Simulation(sim.load_scene("ring"))
    simulation.step(50)
    posed = msgspec.structs.replace(simulation.scene, pose=simulation.pose())
    sim.save_scene(posed, tmp_path / "posed.json")
    path = str(tmp_path / "posed.json")
    assert sim.load_scene(softrod("link", path).stdout.strip()).pose is None
    assert sim.load_scene(softrod("link", path, "--pose").stdout.strip()) == posed


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("link", "http://x/s#1.AAAA"), "the link is broken"),
        (("link", "http://x:8080/s"), "the link http://x:8080/s has no # with a scene after it"),
        (("link", "ring", "--address", "nowhere"), "--address: 'nowhere'"),
        (("link", "study-cloth", "--address", "http://" + "x" * 3000, "--qr"), "too long for a QR code"),
    ],
)
def test_a_command_that_cannot_be_done_says_why(softrod: Softrod, words: tuple[str, ...], said: str) -> None:
    refused(softrod(*words), said)
