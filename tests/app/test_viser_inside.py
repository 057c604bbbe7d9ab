"""What `app.viser_inside` uses is as it was; where one of these fails, viser has become another one."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Iterator

import msgspec
import numpy as np
import pytest
import viser
import viser._messages
import zstandard
from viser.infra._async_message_buffer import AsyncMessageBuffer

from app import viser_inside as viser_inside
from app.gate.gate import GatedServer
from app.viser_inside import SoftrodMessage
from studies.bench.client import Page
from tests.app.hostile import eventually, served


@pytest.fixture(scope="module")
def server() -> Iterator[GatedServer]:
    with served() as server:
        yield server


def test_the_version_is_the_one_that_it_was_written_for() -> None:
    assert viser.__version__ == viser_inside.VERSION


def test_viser_leads_what_a_page_says_to_who_listens() -> None:
    message = viser._messages.Message.deserialize(
        msgspec.msgpack.encode({"type": "SoftrodMessage", "text": "{}"})
    )
    assert message == SoftrodMessage("{}")


def test_numbers_travel_beside_the_text_and_the_last_of_a_key_counts() -> None:
    numbers, buffers = np.array([1.0, 2.0], np.float32), []
    fields = SoftrodMessage("{}", numbers).as_serializable_dict(buffers)
    assert fields == {
        "type": "SoftrodMessage",
        "text": "{}",
        "numbers": {"__binary_index": 0, "dtype": "<f4"},
    }
    assert bytes(buffers[0]) == numbers.tobytes()
    assert SoftrodMessage("a", key="k").redundancy_key() == SoftrodMessage("b", key="k").redundancy_key()


def test_a_page_is_heard_told_and_known_by_its_connection(server: GatedServer) -> None:
    heard: list[str] = []
    server.on_client_connect(lambda client: viser_inside.listen(client, heard.append))
    with Page(server.get_port()) as page:
        client = eventually(lambda: next(iter(server.get_clients().values()), None))
        assert viser_inside.connections(server)[client.client_id].request.path == "/"
        page.send({"type": "SoftrodMessage", "text": "hello"})
        eventually(lambda: heard == ["hello"])
        viser_inside.send(client, SoftrodMessage("good day"))
        page.wait_for(lambda message: message.get("text") == "good day")
        slider = client.gui.add_slider("Length", 0.0, 1.0, 0.1, 0.5)
        tab = client.gui.add_tab_group().add_tab("Tab")
        uuid = viser_inside.element_id(slider)
        assert viser_inside.input_handle(client, uuid) is slider
        assert viser_inside.input_handle(server, uuid) is None
        page.wait_for(lambda message: viser_inside.element_id(tab) in str(message))


def test_a_batch_of_no_messages_is_one_for_viser() -> None:
    data = viser_inside.no_messages()
    size, packed = (int.from_bytes(data[at : at + 8], "little") for at in (0, 8))
    inner = zstandard.decompress(data[16 : 16 + packed])
    assert len(inner) == size
    assert msgspec.msgpack.decode(inner)["messages"] == []


def test_a_message_is_sent_that_comes_just_as_the_event_loop_falls_asleep() -> None:
    sent: list[str] = []

    async def take() -> None:
        queue = AsyncMessageBuffer(asyncio.get_running_loop(), persistent_messages=False)
        bell, texts = queue.message_event, iter(["first", "second"])

        def loop_of_bell() -> asyncio.AbstractEventLoop:
            # Between a look at the event and the sleep until it is set, another thread puts a message there.
            for text in texts:
                put = threading.Thread(target=queue.push, args=(SoftrodMessage(text, key=text),))
                put.start()
                put.join()
                break
            return asyncio.get_running_loop()

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(bell, "_get_loop", loop_of_bell)
            async for window in queue.window_generator(0):
                sent.extend(message.text for message in window if isinstance(message, SoftrodMessage))
                if len(sent) == 2:
                    break

    asyncio.run(asyncio.wait_for(take(), 10.0))
    assert sent == ["first", "second"]


def test_the_script_of_the_page_is_found() -> None:
    script = viser_inside.page_script()
    assert script.startswith("<script data-p=")
    assert script.endswith("</script>")
    assert 'document.querySelector("script[data-p]")' in script
