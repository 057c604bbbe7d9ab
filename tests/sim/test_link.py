"""Scenes as links: exact round trips, and what broken and forged links get to hear."""

from __future__ import annotations

import base64
import contextlib
import json
import zlib
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim.errors import SceneError
from sim.store import link
from sim.store.files import MAX_FILE_BYTES, decode_link, encode_scene
from sim.store.link import MAX_LINK, link_data, pack_scene, unpack
from tests.sim.checks import refusal
from tests.sim.fuzzing import wild_scene

PRESETS = [info.name for info in sim.list_scenes() if info.built_in]
EVIL = "</script><img src=x onerror=alert(1)>\x00\u2028"


def packed(data: bytes) -> str:
    """What stands after the # of a link that holds some bytes."""
    return "1." + base64.urlsafe_b64encode(zlib.compress(data)).decode().rstrip("=")


def refused(data: str) -> str:
    """The sentence for a link that is none."""
    return refusal(SceneError, decode_link, data)


@pytest.mark.parametrize(
    "mailed",
    [
        "<http://a.org/s#{0}>",
        "http://a.org/s#{0}.",
        "http://a.org/s#{0})",
        "http://a.org/s%23{0}",
        "https://mail.example/?url=http%3A%2F%2Fa.org%2Fs%23{0}",
        "http://a.org/s#{1}=\r\n{2}",
        "http://a.org/s#{1}\n   {2}\n",
        "http://a.org/s#{1}\u200b{2}",
    ],
)
def test_a_link_that_went_through_the_mail_is_read(mailed: str) -> None:
    scene = sim.load_scene("rope")
    data = pack_scene(scene)
    assert sim.load_scene(mailed.format(data, data[:76], data[76:])) == scene


@pytest.mark.parametrize("preset", PRESETS)
def test_a_preset_comes_back_and_is_short(preset: str) -> None:
    scene = sim.load_scene(preset)
    data = pack_scene(scene)
    assert decode_link(data) == scene
    assert len(data) < (4000 if scene.lesson else 1100)  # a lesson's text may be eight steps long
    posed = replace(scene, pose=sim.Simulation(scene, wait=False).pose())
    assert decode_link(pack_scene(posed)) == posed


@given(st.integers(0, 2**32 - 1), st.text(max_size=60), st.text(max_size=200))
@example(0, "x", EVIL)
def test_every_scene_comes_back(seed: int, title: str, description: str) -> None:
    scene = wild_scene(np.random.default_rng(seed))
    scene = replace(scene, title=title, description=description)
    try:
        sim.validate(scene)
    except SceneError as error:
        with pytest.raises(SceneError, match=r".+") as caught:
            pack_scene(scene)
        assert str(caught.value) == str(error)
        return
    again = decode_link(pack_scene(scene))
    assert again == scene
    assert encode_scene(again) == encode_scene(scene)  # to the sign of every zero


def test_a_link_is_taken_wherever_a_scene_s_name_is() -> None:
    scene = sim.set_value(sim.load_scene("ring"), "gravity", 321.0)
    data = pack_scene(scene)
    for address in ("http://127.0.0.1:8080/s", "https://school.example/s?controls=play"):
        assert sim.load_scene(f"{address}#{data}") == scene
    for text in ("ring", "folder/a#b.json", f"s#{data}", "ftp://x/s#1.a", ""):
        assert link_data(text) is None


@given(st.integers(2, 500), st.sampled_from("AZaz09-_"))
def test_a_changed_letter_is_noticed(at: int, letter: str) -> None:
    scene = sim.load_scene("tutorial-3.3")
    data = pack_scene(scene)
    at = 2 + at % (len(data) - 2)
    changed = data[:at] + letter + data[at + 1 :]
    # Some bits at the end of what is packed, and of the last letter, count for nothing.
    if changed != data and len(data) - at > 12:
        assert refused(changed).startswith("the link is broken")
    elif changed != data:
        with contextlib.suppress(SceneError):
            assert unpack(changed, MAX_FILE_BYTES) == unpack(data, MAX_FILE_BYTES)


@given(st.integers(0, 500))
def test_a_shortened_link_is_noticed(length: int) -> None:
    data = pack_scene(sim.load_scene("tutorial-3.3"))
    assert refused(data[: length % len(data)]).startswith("the link is broken")


@given(st.text(max_size=100))
@example("1.")
@example("1.AAAA")
@example("0.AAAA")
@example("1." + "é" * 8)
@example("1.a\n")
@example("javascript:alert(1)")
def test_nonsense_is_one_sentence(data: str) -> None:
    assert refused(data).startswith("the link")


def test_a_newer_link_says_so() -> None:
    data = pack_scene(sim.load_scene("ring"))
    assert "format 2, newer than 1" in refused(f"2.{data[2:]}")


def test_what_unpacks_to_too_much_is_not_unpacked() -> None:
    bomb = packed(b" " * (MAX_FILE_BYTES + 1))
    assert len(bomb) < MAX_LINK
    assert f"more than the {MAX_FILE_BYTES} bytes" in refused(bomb)
    assert "characters, more than" in refused("1." + "A" * MAX_LINK)


def test_a_scene_that_is_too_large_for_a_link_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(link, "MAX_LINK", 100)
    with pytest.raises(SceneError, match="more than the 100 allowed; send the scene as a file"):
        pack_scene(sim.load_scene("ring"))


def forged(**changes: Any) -> str:
    fields = json.loads(encode_scene(sim.load_scene("tutorial-3.3")))
    return packed(json.dumps({**fields, **changes}).encode())


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (packed(b""), "the file is empty"),
        (packed(b"[]"), "a JSON object"),
        (packed(b"[" * 100_000), "not a JSON file"),
        (packed(b"\xff\xfe"), "the file is empty"),
        (packed(b'{"format": 3, "name": "x"} more'), "not a JSON file"),
        (packed(zlib.compress(b"{}")), "not a JSON file"),
        (forged(format=99), "version 99 is newer"),
        (forged(air_friction=float("nan")), "NaN is no number that JSON has"),
        (forged(air_friction=-1), "air_friction"),
        (forged(more=1), "more"),
        (forged(name="x" * 1000), "name"),
        (forged(bodies=[{"recipe": "rope", "masses": 10**9}]), "masses"),
        (packed(b'{"format": 3, "name": "x"}')[:-2] + "AA", "broken"),
        ("1." + base64.urlsafe_b64encode(zlib.compress(b"{}") + b"more").decode().rstrip("="), "broken"),
    ],
)
def test_a_forged_link_is_held_to_what_a_file_is(data: str, said: str) -> None:
    sentence = refused(data)
    assert sentence.startswith("the link")
    assert said in sentence


def test_letters_of_another_alphabet_are_refused() -> None:
    with pytest.raises(SceneError):
        unpack("1.+/+/", 100)
