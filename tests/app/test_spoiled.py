"""Every reader of a text, given what real programs make of one: it is read, or refused in one sentence."""

from __future__ import annotations

import base64
import gzip
import random
import re
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec
import pytest

import sim
from app.pages.sandbox import features  # noqa: F401  with all their messages
from app.session import keepsakes, log
from app.ui.kept import keeping
from app.wire.messages import read
from sim.edit import copying
from sim.errors import InputError, SceneError
from sim.store.files import decode_link, decode_scene
from sim.store.link import pack_scene

NUMBERS = (
    "NaN", "Infinity", "-Infinity", "1e999", "1" + "0" * 400, "1e-400", "18446744073709551616", "01", "0x10",
    "1_000", "1.", "+1", ".5", "1,5", "null", "true", '"5"', "[]", "{}",
)  # fmt: skip
"""What programs write for a number, some of them wrongly."""

SWAPPED = ("\n\r", "\n\u2028", " \u00a0", '"\u201c', "\"'", ".,")
"""A letter, and what programs make of it."""

NOT_SAID = re.compile(r"\n|`\$|Expected|`(int|float|str|array|object)`|codec|recursion|Traceback|\d{50}")
"""What no sentence may have: the insides of a library, or pages of digits."""


def spoiled(data: bytes, chance: random.Random) -> Iterator[bytes]:
    """A text as editors, mail programs, spreadsheets, web pages and failing disks leave it."""
    text = data.decode()
    for encoding in ("utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-7"):
        yield text.encode(encoding)
    yield from (b"", b" \r\n", b"\0" * 4096, data + b"\0" * 512, data + data, gzip.compress(data))
    yield from (b"[" * 100_000, b'{"a":' * 100_000, b'"\\ud800"', b'"\xff"')
    yield b"<!DOCTYPE html><html><body>" + data + b"</body></html>"
    yield b"```json\n" + data + b"\n```"
    yield from (
        text.replace(a, b).encode() for a, b in ("\n\r", "\n\u2028", " \u00a0", '"\u201c', "\"'", ".,")
    )
    yield text.replace("\n", "\r\n").encode()
    yield text.replace("]", ",]").encode()
    yield b"// saved by hand\n" + data
    numbers, keys = list(re.finditer(r"-?\d+(\.\d+)?", text)), list(re.finditer(r'"\w+"', text))
    for number in NUMBERS:
        for found in chance.sample(numbers, min(3, len(numbers))):
            yield (text[: found.start()] + number + text[found.end() :]).encode()
    for found in chance.sample(keys, min(12, len(keys))):
        for other in ('"x\\ny"', '"\\u0000"', chance.choice(keys)[0]):
            yield (text[: found.start()] + other + text[found.end() :]).encode()
    for _ in range(30):
        low, high = sorted(chance.sample(range(len(data) + 1), 2))
        yield from (data[:low], data[:low] + data[high:], data[high:] + data[:low])
        yield data[:low] + bytes([chance.randrange(256)]) + data[low + 1 :]


def a_run() -> sim.Simulation:
    simulation = sim.Simulation(sim.load_scene("pendulum"), wait=False)
    simulation.step(3)
    return simulation


def a_log() -> bytes:
    simulation = a_run()
    entries = (
        log.Grab(mass=1), log.Lead(mass=1, to=(100.0, 100.0)), log.Step(n=1, times=5), log.Release(mass=1),
        log.Set(key="gravity", value=50.0), log.check_of(simulation),
        log.restore_entry(simulation.capture(), with_scene=True),
    )  # fmt: skip
    return b"\n".join([log.encode_header(simulation.scene), *map(msgspec.json.encode, entries)])


def a_keepsake() -> bytes:
    simulation = a_run()
    return keepsakes.encode(simulation.capture(), keepsakes.Choices(), simulation.scene, simulation.scene)


def a_fragment() -> bytes:
    scene = sim.load_scene("bridge")
    return copying.encode(copying.copy(scene, range(4), [mass.position for mass in scene.masses])).encode()


def packed(data: bytes) -> bytes:
    return base64.b64encode(zlib.compress(data))


def text(data: bytes) -> str:
    return data.decode("utf-8", "replace")


BUILT_IN = Path(sim.__file__).parent.parent / "presets"
READERS: dict[str, tuple[Callable[[], bytes], Callable[[bytes], object]]] = {
    "a scene": ((BUILT_IN / "pendulum.json").read_bytes, lambda data: decode_scene(data, "a.json")),
    "a scene with surroundings": (
        (BUILT_IN / "box.json").read_bytes,
        lambda data: decode_scene(data, "a.json"),
    ),
    "a lesson": (
        (BUILT_IN / "lessons" / "lesson-hooke.json").read_bytes,
        lambda data: decode_scene(data, "a.json"),
    ),
    "a log": (a_log, lambda data: log.decode_log(data, "a.log")),
    "a keepsake": (a_keepsake, keepsakes.decode),
    "a fragment": (a_fragment, lambda data: copying.decode(text(data))),
    "a link": (
        lambda: pack_scene(sim.load_scene("bridge")).encode(),
        lambda data: decode_link(text(data)),
    ),
    "what a page keeps": (
        lambda: keeping.encode(a_keepsake(), keeping.DEFAULT_LOOKS),
        lambda data: keeping.decode(text(packed(data))),
    ),
    "what a page keeps, packed": (
        lambda: packed(keeping.encode(a_keepsake(), keeping.DEFAULT_LOOKS)),
        lambda data: keeping.decode(text(data)),
    ),
    "a message": (
        lambda: b'{"do": "putMode", "mode": 1, "part": 0.5}\n',
        lambda data: read(text(data)),
    ),
}


@pytest.mark.parametrize("name", READERS)
def test_a_spoiled_text_is_read_or_refused_in_a_sentence(name: str) -> None:
    make, read = READERS[name]
    data = make()
    assert read(data) is not None
    for spoilt in spoiled(data, random.Random(1)):
        try:
            read(spoilt)
        except (SceneError, InputError) as error:
            sentence = str(error)
            assert not NOT_SAID.search(sentence), (spoilt[:100], sentence)
            assert len(sentence) < 400, sentence
