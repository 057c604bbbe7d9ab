"""Answers that pupils gave to a lesson in a file of their own, as a file and as the text of a QR code.

Both hold the same sheet; `app/export/live/static/answers.js` writes them. The text is shorter: it rounds what
was predicted, and cuts the last line. Nothing in either is trusted.

The text is "SR1" and then bytes in base 32 (RFC 4648, without padding):

====================  =======================================================================
4, 5, 1 bytes         the lesson's code; the sheet's id; its turn
1, (n + 1) // 2       the number of steps n; four bits a step, the first step in the low ones:
                      the choice counted from 1, 0 for none, and 8 more where the goal was reached
1, k                  the number of bytes of the name; the name in UTF-8
1, 1, k               any number of times: the step's number, times 2, and 1 more for places;
                      the number of bytes; a line in UTF-8, or x and y of each mass, a byte each:
                      64 at the low end of the scene's frame, 192 at the high one
2 bytes               a check of all before it: CRC-16/CCITT
====================  =======================================================================
"""

from __future__ import annotations

import base64
import binascii
import hashlib
from typing import Annotated, Literal, NamedTuple

import msgspec
from msgspec import Meta, Struct

import sim

from ..lessons import lesson_code
from .room import Answer, Coordinate, Ghost, Line, Refused, Room, Vote

MARK = "SR1"
"""What a text begins with."""

LARGEST = 20_000
"""Letters of a file, at most: however they are written in a message, the server takes it."""

_NO_TEXT = "That is no code of answers: it begins with SR1 and has letters and digits."
_NO_FILE = "That file has no answers to a lesson."
_MISREAD = "The code was read with a wrong letter: scan it again."
_CHANGED = str.maketrans("YZ", "ZY")
_ENDS = 192, 64
"""A byte of a place at the high and at the low end of the frame."""


Places = Annotated[tuple[tuple[Coordinate, Coordinate], ...], Meta(min_length=1, max_length=2000)]


class StepAnswer(Struct, frozen=True, forbid_unknown_fields=True):
    """What a sheet has of one step; see `Sheet` in `answers.js`."""

    choice: Annotated[int, Meta(ge=0, le=4)] | None = None
    line: Annotated[str, Meta(max_length=600)] = ""
    places: Places | None = None
    reached: bool = False


class Sheet(Struct, frozen=True, forbid_unknown_fields=True):
    """The answers of one pupil to a lesson.

    Attributes:
        lesson: see `app.lessons.lesson_code`.
        id: drawn by lot in the pupil's browser.
        turn: counts that browser's sheets.
        name: that was typed, or empty.
        steps: what was answered at each.
    """

    format: Literal["softrod-answers"]
    version: Literal[1]
    lesson: Annotated[str, Meta(pattern="^[0-9a-f]{8}$")]
    id: Annotated[str, Meta(pattern="^[0-9a-f]{10}$")]
    turn: Annotated[int, Meta(ge=0, le=1_000_000)]
    name: Annotated[str, Meta(max_length=100)]
    steps: Annotated[tuple[StepAnswer, ...], Meta(min_length=1, max_length=20)]


class Taken(NamedTuple):
    """What a class has taken of a sheet.

    Attributes:
        name: of the seat that has its answers.
        new, known: how many answers count from now on, and how many the class had or has a later one for.
        reached: numbers of the steps, from 1, whose goals its file says were reached.
    """

    name: str
    new: int
    known: int
    reached: tuple[int, ...]


_decoder = msgspec.json.Decoder(Sheet)


def take(room: Room, text: str) -> Taken:
    """Have a class take a sheet; each of its answers counts once, as one that came late.

    Args:
        room: of the class.
        text: of a file, or of a QR code, as somebody brought it.

    Raises:
        Refused: it is no sheet of this class's; then nothing is changed.
    """
    text = text.strip()
    is_file = text.startswith("{")
    if is_file:
        try:
            sheet = _decoder.decode(text[: LARGEST + 1])
        except (msgspec.DecodeError, UnicodeError):
            raise Refused(_NO_FILE) from None
        number, scene = _scene_of(room, sheet.lesson)
    else:
        data = _bytes_of(text)
        number, scene = _scene_of(room, data[:4].hex())
        sheet = _unpacked(data, scene)
    first = next(i for i, stop in enumerate(room.stops) if stop.scene == number)
    lesson = scene.lesson
    if lesson is None or len(sheet.steps) != len(lesson.steps):
        raise Refused("These answers are to a lesson with another number of steps.")
    answers = [
        Answer(
            # The same answer has the same id, however often it is brought.
            id=hashlib.sha256(f"{sheet.id} {first + i} {content!r}".encode()).hexdigest()[:16],
            # A file has more than a code of the same turn.
            turn=2 * min(sheet.turn, 255) + is_file,
            seat=0,
            twin=0,
            stop=first + i,
            round=0,
            content=content,
        )
        for i, step in enumerate(sheet.steps)
        for content in _contents(step)
    ]
    if not answers:
        raise Refused("There is no answer in it yet.")
    seat, new = room.take_brought(f"file {sheet.id}", sheet.name, answers)
    reached = tuple(i for i, step in enumerate(sheet.steps, start=1) if step.reached)
    return Taken(seat.name, new, len(answers) - new, reached)


def _contents(step: StepAnswer) -> list[Vote | Ghost | Line]:
    given: list[Vote | Ghost | Line] = []
    if step.choice is not None:
        given.append(Vote(step.choice))
    if step.places is not None:
        given.append(Ghost(step.places))
    if step.line.strip():
        given.append(Line(step.line))
    return given


def _scene_of(room: Room, code: str) -> tuple[int, sim.Scene]:
    """The scene of a class whose lesson has a code, and its number."""
    for number, scene in enumerate(room.scenes):
        if scene.lesson is not None and lesson_code(scene) == code:
            return number, scene
    raise Refused("These answers are to another lesson than this class's.")


def _bytes_of(text: str) -> bytes:
    """What a text has been made of, without its check."""
    letters = text.upper()
    if not letters.startswith(MARK) or len(letters) > 200:
        raise Refused(_NO_TEXT)
    # A scanner that types for an English keyboard has Y and Z change places on a German one.
    for body in (letters[len(MARK) :], letters[len(MARK) :].translate(_CHANGED)):
        try:
            data = base64.b32decode(body + "=" * (-len(body) % 8))
        except (binascii.Error, ValueError):
            raise Refused(_MISREAD) from None
        if len(data) >= 15 and binascii.crc_hqx(data[:-2], 0xFFFF) == int.from_bytes(data[-2:], "big"):
            return data[:-2]
    raise Refused(_MISREAD)


class _Reader:
    """Takes bytes off the front of some."""

    def __init__(self, data: bytes) -> None:
        self._data = data

    def __bool__(self) -> bool:
        return bool(self._data)

    def take(self, count: int) -> bytes:
        if count > len(self._data):
            raise Refused(_MISREAD)
        taken, self._data = self._data[:count], self._data[count:]
        return taken

    def number(self) -> int:
        return self.take(1)[0]


def _unpacked(data: bytes, scene: sim.Scene) -> Sheet:
    """The sheet in some bytes; places are of the scene."""
    reader = _Reader(data)
    lesson, id, turn, count = reader.take(4).hex(), reader.take(5).hex(), reader.number(), reader.number()
    nibbles = [half for byte in reader.take((count + 1) // 2) for half in (byte & 15, byte >> 4)][:count]
    given: list[dict[str, object]] = [
        {"choice": (nibble & 7) - 1 if nibble & 7 else None, "reached": nibble >= 8} for nibble in nibbles
    ]
    try:
        name = reader.take(reader.number()).decode()
        while reader:
            tag = reader.number()
            content = reader.take(reader.number())
            if tag >> 1 >= count:
                raise Refused(_MISREAD)
            if tag & 1:
                given[tag >> 1]["places"] = _places(content, scene)
            else:
                given[tag >> 1]["line"] = content.decode()
        sheet = {"lesson": lesson, "id": id, "turn": turn, "name": name, "steps": given}
        return msgspec.convert({"format": "softrod-answers", "version": 1, **sheet}, Sheet)
    except (UnicodeError, msgspec.ValidationError):
        raise Refused(_MISREAD) from None


def _places(content: bytes, scene: sim.Scene) -> tuple[tuple[float, float], ...]:
    """Places in the scene's units."""
    xmin, ymin, xmax, ymax = scene.view.frame
    high, low = _ENDS

    def place(byte: int, begin: float, end: float) -> float:
        return begin + (end - begin) * (byte - low) / (high - low)

    pairs = zip(content[::2], content[1::2], strict=False)
    return tuple((place(x, xmin, xmax), place(y, ymin, ymax)) for x, y in pairs)
