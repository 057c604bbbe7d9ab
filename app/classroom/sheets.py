"""Answers that pupils gave to a lesson in a file of their own, as a file and as the text of a QR code.

Both have the same sheet; `app/export/live/static/answers.js` writes them. The text is shorter: it rounds
predictions, and cuts the last line. Nothing in either is trusted.

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
from ..words import say
from .answers import Answer, AnyContent, Line, Points, Prediction, Refused, Vote
from .room import Room

MARK = "SR1"
"""First letters of a text."""

MAX_LENGTH = 20_000
"""Letters of a file: even if each is escaped, the message is within the server's limit."""

_CHANGED = str.maketrans("YZ", "ZY")
_ENDS = 192, 64
"""A byte of a place at the high and at the low end of the frame."""


class StepAnswer(Struct, frozen=True, forbid_unknown_fields=True):
    """The answers to one step; see `Sheet` in `answers.js`."""

    choice: Annotated[int, Meta(ge=0, le=4)] | None = None
    line: Annotated[str, Meta(max_length=600)] = ""
    places: Points | None = None
    reached: bool = False


class Sheet(Struct, frozen=True, forbid_unknown_fields=True):
    """The answers of one pupil to a lesson.

    Attributes:
        lesson: see `app.lessons.lesson_code`.
        id: random, made by the pupil's browser.
        turn: counts that browser's sheets.
        name: as typed, or empty.
        steps: the answers to each step.
    """

    format: Literal["softrod-answers"]
    version: Literal[1]
    lesson: Annotated[str, Meta(pattern="^[0-9a-f]{8}$")]
    id: Annotated[str, Meta(pattern="^[0-9a-f]{10}$")]
    turn: Annotated[int, Meta(ge=0, le=1_000_000)]
    name: Annotated[str, Meta(max_length=100)]
    steps: Annotated[tuple[StepAnswer, ...], Meta(min_length=1, max_length=20)]


class Imported(NamedTuple):
    """The result of importing a sheet.

    Attributes:
        name: of the seat that has its answers.
        new, known: how many answers are new, and how many the class had already or has a later one for.
        reached: numbers of the steps, from 1, whose goals were reached according to the sheet.
    """

    name: str
    new: int
    known: int
    reached: tuple[int, ...]


_decoder = msgspec.json.Decoder(Sheet)


def import_sheet(room: Room, text: str) -> Imported:
    """Give a class the answers of a sheet; each counts once, as a late one.

    Args:
        room: of the class.
        text: of a file, or of a QR code, as somebody brought it.

    Raises:
        Refused: it is no sheet of this class's lessons; nothing is changed.
    """
    text = text.strip()
    is_file = text.startswith("{")
    if is_file:
        try:
            sheet = _decoder.decode(text[: MAX_LENGTH + 1])
        except (msgspec.DecodeError, UnicodeError):
            raise Refused(say("class-refuse-no-file")) from None
        number, scene = _scene_of(room, sheet.lesson)
    else:
        data = _bytes_of(text)
        number, scene = _scene_of(room, data[:4].hex())
        sheet = _unpacked(data, scene)
    first = next(i for i, stop in enumerate(room.stops) if stop.scene == number)
    lesson = scene.lesson
    if lesson is None or len(sheet.steps) != len(lesson.steps):
        raise Refused(say("class-refuse-other-steps"))
    answers = [
        Answer(
            # The same answer has the same id whenever it is imported.
            id=hashlib.sha256(f"{sheet.id} {first + i} {content!r}".encode()).hexdigest()[:16],
            # A file is more precise than a code of the same turn.
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
        raise Refused(say("class-refuse-empty"))
    seat, new = room.import_answers(f"file {sheet.id}", sheet.name, answers)
    reached = tuple(i for i, step in enumerate(sheet.steps, start=1) if step.reached)
    return Imported(seat.name, new, len(answers) - new, reached)


def _contents(step: StepAnswer) -> list[AnyContent]:
    choice = [] if step.choice is None else [Vote(step.choice)]
    places = [] if step.places is None else [Prediction(step.places)]
    return [*choice, *places, *([Line(step.line)] if step.line.strip() else [])]


def _scene_of(room: Room, code: str) -> tuple[int, sim.Scene]:
    """Return the number of the scene whose lesson has a code, and the scene."""
    for number, scene in enumerate(room.scenes):
        if scene.lesson is not None and lesson_code(scene) == code:
            return number, scene
    raise Refused(say("class-refuse-other-lesson"))


def _bytes_of(text: str) -> bytes:
    """Decode a text, and check and remove its checksum."""
    letters = text.upper()
    if not letters.startswith(MARK) or len(letters) > 200:
        raise Refused(say("class-refuse-no-code"))
    # A scanner that emulates an English keyboard swaps Y and Z on a computer set to a German one.
    for body in (letters[len(MARK) :], letters[len(MARK) :].translate(_CHANGED)):
        try:
            data = base64.b32decode(body + "=" * (-len(body) % 8))
        except (binascii.Error, ValueError):
            raise Refused(say("class-refuse-misread")) from None
        if len(data) >= 15 and binascii.crc_hqx(data[:-2], 0xFFFF) == int.from_bytes(data[-2:], "big"):
            return data[:-2]
    raise Refused(say("class-refuse-misread"))


class _Reader:
    """Reads bytes from the front."""

    def __init__(self, data: bytes) -> None:
        self._data = data

    def __bool__(self) -> bool:
        return bool(self._data)

    def take(self, count: int) -> bytes:
        if count > len(self._data):
            raise Refused(say("class-refuse-misread"))
        taken, self._data = self._data[:count], self._data[count:]
        return taken

    def number(self) -> int:
        return self.take(1)[0]


def _unpacked(data: bytes, scene: sim.Scene) -> Sheet:
    """Decode a sheet; places are in the scene's units."""
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
                raise Refused(say("class-refuse-misread"))
            if tag & 1:
                given[tag >> 1]["places"] = _places(content, scene)
            else:
                given[tag >> 1]["line"] = content.decode()
        sheet = {"lesson": lesson, "id": id, "turn": turn, "name": name, "steps": given}
        return msgspec.convert({"format": "softrod-answers", "version": 1, **sheet}, Sheet)
    except (UnicodeError, msgspec.ValidationError):
        raise Refused(say("class-refuse-misread")) from None


def _places(content: bytes, scene: sim.Scene) -> tuple[tuple[float, float], ...]:
    """Decode places, in the scene's units."""
    xmin, ymin, xmax, ymax = scene.view.frame
    high, low = _ENDS

    def place(byte: int, begin: float, end: float) -> float:
        return begin + (end - begin) * (byte - low) / (high - low)

    pairs = zip(content[::2], content[1::2], strict=False)
    return tuple((place(x, xmin, xmax), place(y, ymin, ymax)) for x, y in pairs)
