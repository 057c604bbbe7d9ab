"""Which controls a page has: by its address, by its scene; what is left out is not made."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

import sim
from app.pages.sandbox.features import CONTROLS
from app.ui import controls
from app.ui.controls import ALL, Controls, of_query, of_scene
from sim.errors import InputError, SceneError
from sim.settings import setting_keys, settings_of
from sim.store.files import decode_scene, encode_scene
from tests.app.command import Softrod
from tests.app.hostile import Sandbox, answer


def with_controls(*names: str, scene: str = "tutorial-3.3") -> sim.Scene:
    found = sim.load_scene(scene)
    return msgspec.structs.replace(found, view=msgspec.structs.replace(found.view, controls=names))


def test_an_address_names_controls() -> None:
    assert of_query("controls=play,rest_angle%2Ckeys,,play", CONTROLS) == Controls(
        ("play", "rest_angle", "keys")
    )
    assert of_query("controls=", CONTROLS) == Controls(())
    assert of_query("", CONTROLS) is None
    assert of_query("websocket=ws://evil.example", CONTROLS) is None


def test_a_scene_names_controls() -> None:
    assert of_scene(sim.load_scene("ring"), CONTROLS) is ALL
    scene = with_controls("play", "gravity")
    assert of_scene(scene, CONTROLS) == Controls(("play", "gravity"))
    assert decode_scene(encode_scene(scene), "x") == scene


@pytest.mark.parametrize("name", ["foo", "Play", "bodies[1].foo", "method", "play "])
def test_what_is_no_control_is_one_sentence(name: str) -> None:
    with pytest.raises(InputError, match=r"there is no control called .*; there are play, ") as caught:
        of_scene(with_controls("play", name), CONTROLS)
    assert "\n" not in str(caught.value)
    assert str(caught.value).startswith("view.controls: ")
    with pytest.raises(InputError, match=r"^the address, controls: there is no control called 'foo'"):
        of_query("controls=foo", CONTROLS)


def test_every_setting_of_every_preset_can_be_named() -> None:
    keys = setting_keys()
    assert not keys & set(CONTROLS)
    for info in sim.list_scenes():
        scene = sim.load_scene(info.name)
        of_scene(scene, CONTROLS)
        named = controls.checked(tuple(setting.key for setting in settings_of(scene)), info.name, CONTROLS)
        assert named.named_settings(settings_of(scene)) == settings_of(scene)


def test_what_a_list_says() -> None:
    some = Controls(("play", "gravity", "rest_angle", "view"))
    assert "play" in some
    assert "body" not in some
    assert some.in_play_tab
    applicable = settings_of(sim.load_scene("tutorial-3.3"))
    named = some.named_settings(applicable)
    assert named is not None
    assert [setting.key for setting in named] == ["gravity", "rest_angle"]
    assert ALL.named_settings(applicable) is None
    assert all(part in ALL for part in CONTROLS)
    assert not Controls(("play",)).in_play_tab
    assert Controls(("body",)).in_play_tab
    assert not Controls(("view", "help")).in_play_tab


@pytest.mark.parametrize("names", [[1], "play", [""], ["x" * 81], ["play"] * 101])
def test_a_file_s_list_is_held_to_its_type(names: object) -> None:
    fields = msgspec.json.decode(encode_scene(sim.load_scene("ring")))
    fields["view"]["controls"] = names
    with pytest.raises(SceneError, match=r"^x: view\.controls"):
        decode_scene(msgspec.json.encode(fields), "x")


def test_softrod_check_knows_them(tmp_path: Path, softrod: Softrod) -> None:
    path = tmp_path / "lesson.json"
    for name, status in (("keys", 0), ("kees", 1)):
        sim.save_scene(with_controls("play", name), path)
        checked = softrod("check", path)
        assert checked.returncode == status
    assert checked.stderr.startswith(f"softrod: {path}: view.controls: there is no control called 'kees'")


# ------------------------------------------------------------------------- the gate
@pytest.fixture(scope="module")
def sandbox() -> Iterator[Sandbox]:
    sandbox = Sandbox()
    yield sandbox
    sandbox.close()


@pytest.mark.parametrize(
    ("target", "status"),
    [
        ("/?controls=play,rest_angle", 200),
        ("/?controls=play%2Cbodies[1].pressure", 200),
        ("/?controls=", 200),
        ("/?controls=play&websocket=ws://evil.example", 307),
        ("/?websocket=ws://evil.example&controls=play", 307),
        ("/?controls=play;x", 307),
        ("/?controls=<script>", 307),
        ("/?controls=" + "x" * 2001, 307),
        ("/?Controls=play", 307),
        ("/package.json?controls=play", 307),
        ("//evil.example/?controls=play", 307),
    ],
)
def test_the_gate_takes_that_query_alone(sandbox: Sandbox, target: str, status: int) -> None:
    assert answer(sandbox.port, [("Host", f"127.0.0.1:{sandbox.port}")], target)[0] == status


def test_the_gate_tells_with_which_query_a_page_connected(sandbox: Sandbox) -> None:
    user = sandbox.user()
    assert sandbox.server.gate.visit(user.client.client_id).query == ""
    assert sandbox.server.gate.visit(12345).query == ""
