"""What a page may say: every honest message gets through, no hostile one reaches viser."""

import gc
import math
import os
from collections.abc import Callable, Iterator
from typing import Any

import pytest
import viser

from app import viser_inside as viser_inside
from app.gate.messages import (
    BEAT,
    MAX_FRAME_BYTES,
    MAX_MESSAGE_BYTES,
    PAGE_MESSAGES,
    BeatMessage,
    PageMessage,
    SoftrodMessage,
    write,
)
from tests.app.hostile import CAMERA, Sandbox, User, eventually, pack
from tests.app.inside import uuid_of, viser_messages, wire_field_names

VECTOR = [0.5, 1, 2.5]


@pytest.fixture(scope="module")
def server() -> Iterator[Sandbox]:
    sandbox = Sandbox()
    # The collections below, which bring errors of forgotten tasks to light, need not go through all of numba.
    gc.freeze()
    yield sandbox
    gc.unfreeze()
    sandbox.close()


@pytest.fixture
def sandbox(server: Sandbox) -> Iterator[Sandbox]:
    """The server of this module, as a new one."""
    yield server
    server.clear()


def trigger(user: User) -> dict[str, Any]:
    return {"type": "CommandTriggerMessage", "uuid": uuid_of(user.command)}


def gizmo(user: User) -> dict[str, Any]:
    return {
        "type": "TransformControlsUpdateMessage",
        "name": "/gizmo",
        "wxyz": [1, 0, 0, 0],
        "position": VECTOR,
        "owner": user.owner(),
    }


def gizmo_end(user: User, end: str) -> dict[str, Any]:
    return {"type": f"TransformControlsDrag{end}Message", "name": "/gizmo", "owner": user.owner()}


CLIENT = object()
"""Stands for the id of the client, which a press gives."""

HONEST: dict[str, tuple[Callable[[User], dict[str, Any]], tuple[str, Any]]] = {
    "text": (lambda user: user.update(user.text, "nan"), ("text", "nan")),
    "number": (lambda user: user.update(user.number, 7), ("number", 7.0)),
    "slider": (lambda user: user.update(user.slider, 2.5), ("slider", 2.5)),
    "checkbox": (lambda user: user.update(user.checkbox, True), ("checkbox", True)),
    "gizmo": (gizmo, ("gizmo", (0.5, 1.0, 2.5))),
    "gizmo start": (lambda user: gizmo_end(user, "Start"), ("gizmo", (0.0, 0.0, 0.0))),
    "gizmo end": (lambda user: gizmo_end(user, "End"), ("gizmo", (0.0, 0.0, 0.0))),
    "button": (lambda user: user.update(user.button, True), ("button", CLIENT)),
    "command": (trigger, ("command", CLIENT)),
}


@pytest.mark.parametrize("name", HONEST)
def test_what_the_page_sends_reaches_its_callback(sandbox: Sandbox, name: str) -> None:
    message, (element, value) = HONEST[name]
    user = sandbox.user()
    user.page.send(message(user))
    assert user.next_event() == (element, user.client.client_id if value is CLIENT else value)
    assert not sandbox.server.gate.refused


def test_the_camera_is_followed(sandbox: Sandbox) -> None:
    user = sandbox.user()
    user.page.send({**CAMERA, "position": VECTOR})
    eventually(lambda: list(user.client.camera.position) == VECTOR)


@pytest.mark.parametrize(
    "message",
    [kind for kind in PAGE_MESSAGES if kind not in (BeatMessage, SoftrodMessage)],
    ids=lambda message: message.__name__,
)
def test_messages_have_the_fields_of_visers_own(message: type[PageMessage]) -> None:
    assert message.__struct_fields__ == wire_field_names(getattr(viser_messages, message.__name__))


def test_what_the_script_says_is_read_as_it_was_checked() -> None:
    assert wire_field_names(viser_inside.SoftrodMessage) == (*SoftrodMessage.__struct_fields__, "numbers")
    message = viser_messages.Message.deserialize(write(SoftrodMessage(text="{}")))
    assert isinstance(message, viser_inside.SoftrodMessage)
    assert message.text == "{}"


def update_with(**attributes: Any) -> Callable[[User], dict[str, Any]]:
    return lambda user: {
        "type": "GuiUpdateMessage",
        "uuid": uuid_of(user.slider),
        "updates": attributes,
    }


def sets(element: str, value: Any) -> Callable[[User], dict[str, Any]]:
    return lambda user: user.update(getattr(user, element), value)


NAN, INF = math.nan, math.inf
HOSTILE: dict[str, tuple[str, Callable[[User], Any]]] = {
    "callbacks": ("content", update_with(update_cb=[])),
    "value and callbacks": ("content", update_with(value=1.0, update_cb=[])),
    "removed": ("content", update_with(removed=True)),
    "props": ("content", update_with(props=None)),
    "class": ("content", update_with(__class__=1)),
    "limits": ("content", update_with(max=1e9)),
    "no value": ("content", update_with()),
    "unknown element": (
        "handle",
        lambda user: {"type": "GuiUpdateMessage", "uuid": "x", "updates": {"value": 1}},
    ),
    "element by number": ("content", lambda user: {**user.update(user.slider, 1.0), "uuid": 7}),
    "NaN in a slider": ("content", sets("slider", NAN)),
    "infinity in a slider": ("content", sets("slider", INF)),
    "NaN in a vector": ("content", sets("vector", [0, NAN, 0])),
    "minus infinity in a vector": ("content", sets("vector", [0, 0, -INF])),
    "NaN by name": ("handle", sets("slider", "nan")),
    "infinity by a large number": ("handle", sets("number", "1e999")),
    "NaN by name in a vector": ("content", sets("vector", ["nan", "inf", 0])),
    "text for a checkbox": ("handle", sets("checkbox", "x")),
    "flag for a number": ("handle", sets("number", True)),
    "number for a text": ("handle", sets("text", 1)),
    "vector": ("content", sets("vector", VECTOR)),
    "long vector": ("content", sets("vector", [0.0] * 60)),
    "endless vector": ("content", sets("vector", [0] * 5000)),
    "bytes": ("content", sets("text", b"x")),
    "nothing": ("content", sets("text", None)),
    "nested": ("content", sets("vector", [[0, 0], 0, 0])),
    "upload": ("type", lambda user: {"type": "FileTransferStartUpload", "size_bytes": 10}),
    "part of an upload": ("type", lambda user: {"type": "FileTransferPart", "content": b"x"}),
    "NaN in a camera": ("content", lambda user: {**CAMERA, "fov": NAN}),
    "infinity in a camera": ("content", lambda user: {**CAMERA, "position": [0, INF, 0]}),
    "short camera": ("content", lambda user: {**CAMERA, "position": [0, 1]}),
    "camera of texts": ("content", lambda user: {**CAMERA, "position": ["0", "1", "2"]}),
    "camera with more": ("content", lambda user: {**CAMERA, "camera_cb": []}),
    "infinity in a gizmo": ("content", lambda user: {**gizmo(user), "position": [0, 0, INF]}),
    "NaN in a gizmo": ("content", lambda user: {**gizmo(user), "wxyz": [NAN, 0, 0, 0]}),
    "button that is held": (
        "type",
        lambda user: {"type": "GuiButtonHoldMessage", "uuid": uuid_of(user.button), "frequency": 20},
    ),
    "click on the scene": ("type", lambda user: {"type": "ScenePointerMessage", "event_type": "click"}),
    "click on a node": ("type", lambda user: {"type": "SceneNodeClickMessage", "name": "/ball"}),
    "drag of a node": ("type", lambda user: {"type": "SceneNodeDragMessage", "phase": "start"}),
    "share": ("type", lambda user: {"type": "ShareUrlRequest"}),
    "share end": ("type", lambda user: {"type": "ShareUrlDisconnect"}),
    "form": ("type", lambda user: {"type": "GuiFormDirtyMessage", "uuid": "x"}),
    "script": ("type", lambda user: {"type": "RunJavascriptMessage", "source": "alert(1)"}),
    "render": ("type", lambda user: {"type": "GetRenderResponseMessage", "payload": b"", "render_uuid": ""}),
    "node update": ("type", lambda user: {"type": "SceneNodeUpdateMessage", "name": "/ball", "updates": {}}),
    "made-up type": ("type", lambda user: {"type": "Nonsense"}),
    "internal type": ("type", lambda user: {"type": "PageMessage"}),
    "no type": ("content", lambda user: {"uuid": "x"}),
    "type by number": ("content", lambda user: {"type": 3}),
    "list": ("content", lambda user: [1, 2, 3]),
    "long text": ("size", sets("text", "x" * MAX_MESSAGE_BYTES)),
    "long name": ("content", lambda user: {**trigger(user), "uuid": "x" * 256}),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_message_is_dropped(
    sandbox: Sandbox, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    shared: list[object] = []
    monkeypatch.setattr(viser.ViserServer, "request_share_url", lambda self: shared.append(self))
    reason, message = HOSTILE[name]
    hostile, honest = sandbox.user(), sandbox.user()
    hostile.page.send(message(hostile))
    assert sandbox.refuses(reason)
    # Nothing reached a callback, which would come before the ping's; and the tab itself goes on.
    assert hostile.is_quiet()
    assert honest.is_quiet()
    assert (hostile.slider.value, hostile.slider.max) == (5.0, 10.0)
    assert list(hostile.client.camera.position) == CAMERA["position"]
    assert not shared
    gc.collect()
    assert not caplog.records
    # An honest move is still heard, once.
    hostile.page.send(hostile.update(hostile.slider, 6.0))
    assert hostile.next_event() == ("slider", 6.0)
    assert hostile.is_quiet()


RAW: dict[str, tuple[str, bytes | str]] = {
    "text": ("text", '{"type": "ShareUrlRequest"}'),
    "empty": ("content", b""),
    "noise": ("content", os.urandom(200)),
    "cut short": ("content", pack(CAMERA)[:-3]),
    "run on": ("content", pack(CAMERA) + b"\0"),
    "invalid UTF-8": ("content", b"\x81\xa4type\xa2\xff\xfe"),
    "deep": ("content", b"\x82\xa4type\xb0GuiUpdateMessage\xa7updates" + b"\x91" * 50_000),
    "deep before its type": ("content", b"\x82\xa1x" + b"\x91" * 50_000),
    "array said to be huge": ("content", b"\xdd\xff\xff\xff\xff"),
    "text said to be huge": ("content", b"\x81\xa4type\xdb\xff\xff\xff\xff"),
    "two types": ("content", b"\x82\xa4type\xa5Thing\xa4type\xafShareUrlRequest"),
    "type hidden behind another": (
        "content",
        b"\x83\xa4type\xb5CommandTriggerMessage\xa4uuid\xa1x\xa4type\xafShareUrlRequest",
    ),
}


@pytest.mark.parametrize("name", RAW)
def test_bytes_that_make_no_sense_are_dropped(
    sandbox: Sandbox, caplog: pytest.LogCaptureFixture, name: str
) -> None:
    reason, data = RAW[name]
    hostile, honest = sandbox.user(), sandbox.user()
    hostile.page.send_raw(data)
    eventually(sandbox.server.gate.refused.total)
    assert set(sandbox.server.gate.refused) <= {reason, "type"}
    assert hostile.is_quiet()
    assert honest.is_quiet()
    gc.collect()
    assert not caplog.records


def test_viser_reads_what_was_checked_not_what_was_sent(
    sandbox: Sandbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    user = sandbox.user()
    read: list[bytes] = []
    deserialize = viser_messages.Message.deserialize
    monkeypatch.setattr(
        viser_messages.Message,
        "deserialize",
        staticmethod(lambda data: (read.append(data), deserialize(data))[1]),
    )
    honest = trigger(user)
    # A map with one key twice, its type last, and a length in a longer form than needed.
    odd = b"\xde\x00\x03\xa4uuid\xa1x\xa4uuid" + pack(honest["uuid"]) + b"\xa4type" + pack(honest["type"])
    user.page.send_raw(odd)
    assert user.next_event() == ("command", user.client.client_id)
    assert read == [pack(honest)]


def test_a_giant_frame_costs_only_its_own_connection(sandbox: Sandbox) -> None:
    hostile, honest = sandbox.user(), sandbox.user()
    hostile.page.send_raw(bytes(MAX_FRAME_BYTES + 1))
    assert hostile.page.is_cut()
    assert honest.works()


def test_another_tabs_handles_are_out_of_reach(sandbox: Sandbox) -> None:
    hostile, victim = sandbox.user(), sandbox.user()
    forged = [builder(victim) for builder, _ in HONEST.values()]
    hostile.page.send(*forged)
    assert hostile.is_quiet()
    assert victim.is_quiet()
    assert (victim.number.value, tuple(victim.gizmo.position)) == (1.5, (0.0, 0.0, 0.0))


def test_shared_handles_are_within_reach_of_all(sandbox: Sandbox) -> None:
    shared = sandbox.server.gui.add_number("shared", 1.0)
    first, second = sandbox.user(), sandbox.user()
    first.page.send(first.update(shared, 2.0))
    eventually(lambda: shared.value == 2.0)
    second.page.send(second.update(shared, 3.0))
    eventually(lambda: shared.value == 3.0)


def test_a_page_that_has_not_reported_its_camera_harms_nobody(sandbox: Sandbox) -> None:
    honest = sandbox.user()
    early = sandbox.page()
    early.send(honest.update(honest.slider, 1.0), trigger(honest))
    eventually(lambda: sandbox.server.gate.refused["handle"] == 1)
    assert honest.is_quiet()


def test_a_page_that_asks_for_a_sign_of_life_gets_one(sandbox: Sandbox) -> None:
    user = sandbox.user()
    assert user.works()
    before = user.page.signs
    user.page.send({"type": "BeatMessage"})
    eventually(lambda: user.page.signs == before + 1)
    assert pack({"type": "BeatMessage"}) == BEAT
    assert not sandbox.server.gate.refused
    assert user.works()
    user.page.send({"type": "BeatMessage", "more": 1})
    assert sandbox.refuses("content")
