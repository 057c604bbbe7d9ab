"""Positions in JSON files, for error messages, and the possible encodings of text files."""

from __future__ import annotations

import codecs
import json
import math
import re
from typing import Any

import msgspec

from ..scene.sentences import in_words, sentence
from ..text import Text

_SPACE = re.compile(r"[ \t\n\r]*")
_STEP = re.compile(r"(\w+)|\[(\d+)\]")
_DECODER = json.JSONDecoder()
_STRING = rb'"[^"\\]*(?:\\.[^"\\]*)*"'
_KEY_OR_BRACE = re.compile(rb"(%b)\s*:|%b|[{}]" % (_STRING, _STRING), re.DOTALL)
_STRING_OR_NUMBER = re.compile(rb"%b|(-?\d[\d.eE+-]*)" % _STRING, re.DOTALL)

_MARKS = (
    (codecs.BOM_UTF8, "UTF-8"),
    (codecs.BOM_UTF32_LE, "UTF-32-LE"),  # starts with the next mark
    (codecs.BOM_UTF16_LE, "UTF-16-LE"),
    (codecs.BOM_UTF32_BE, "UTF-32-BE"),
    (codecs.BOM_UTF16_BE, "UTF-16-BE"),
)
"""Byte order marks with which some programs begin a text file, and the encodings that they indicate."""


def as_utf8(data: bytes) -> bytes:
    """Return a text file's bytes in UTF-8 without a byte order mark, by which UTF-16 and UTF-32 are
    recognised.

    Raises:
        UnicodeError: the file is in another encoding; the message says what to do.
    """
    mark, encoding = next(((mark, name) for mark, name in _MARKS if data.startswith(mark)), (b"", "UTF-8"))
    text = data.removeprefix(mark)
    try:
        decoded = text.decode(encoding)
    except UnicodeDecodeError as error:
        line = text[: error.start].decode(encoding, "replace").count("\n") + 1
        raise UnicodeError(
            Text(
                "line {line}: the text is not in {encoding}; save the file with the encoding UTF-8",
                line=line,
                encoding=encoding,
            )
        ) from None
    return text if encoding == "UTF-8" else decoded.encode("utf-8", "surrogatepass")


def repeated_key(data: bytes) -> tuple[str, str] | None:
    """Return a repeated key in an object and, in words, the place of the second one; None if there is none.

    Args:
        data: a JSON file.
    """
    objects: list[set[str]] = []
    for found in _KEY_OR_BRACE.finditer(data):
        if found[0] == b"{":
            objects.append(set())
        elif found[0] == b"}":
            objects.pop()
        elif (key := found[1]) is not None:
            name = json.loads(key) if b"\\" in key else key[1:-1].decode()
            if name in objects[-1]:
                return name, line_and_column(data, found.start())
            objects[-1].add(name)
    return None


def infinite_number(data: bytes) -> tuple[str, str] | None:
    """Return the first number too large for a double, such as 1e999, and its place in words; None if none.

    Args:
        data: a file, which need not be JSON.
    """
    for found in _STRING_OR_NUMBER.finditer(data):
        if found[1] is not None and _is_infinite(found[1]):
            return found[1].decode(), line_and_column(data, found.start())
    return None


def _is_infinite(number: bytes) -> bool:
    try:
        return math.isinf(float(number))
    except ValueError:
        return False


def line_and_column(data: bytes, at: int) -> str:
    """Describe the place of a byte in words."""
    before = data[:at].decode("utf-8", "replace")
    return _place(before.count("\n") + 1, len(before) - before.rfind("\n"))


def _place(line: int, column: int) -> Text:
    return Text("line {line}, column {column}", line=line, column=column)


def place_of(data: bytes, path: str) -> str:
    """Describe the place of the value at a path such as `masses[2].position[0]`, or of the last value along
    the path that the file has; empty if the file does not even have the first.

    Args:
        data: a JSON file.
        path: names and indices.
    """
    text = data.decode("utf-8", "replace")
    begin = at = found = _skip(text, 0)
    try:
        for name, index in _STEP.findall(path):
            at = _member(text, at, name) if name else _item(text, at, int(index))
            if at < 0:
                break
            found = at
    except (ValueError, IndexError, RecursionError):
        return ""  # Python's JSON parser is stricter than msgspec
    if found == begin:
        return ""
    return _place(text.count("\n", 0, found) + 1, found - text.rfind("\n", 0, found))


def _skip(text: str, at: int) -> int:
    match = _SPACE.match(text, at)
    return match.end() if match else at


def _after(text: str, at: int) -> int:
    """Return where the value at a place and the separator after it end."""
    end = _skip(text, _DECODER.raw_decode(text, at)[1])
    return _skip(text, end + 1) if text[end] == "," else end


def _member(text: str, at: int, name: str) -> int:
    """Return where the value of an object's last member of a name starts; -1 if there is none."""
    found = -1
    at = _skip(text, at + 1) if text[at] == "{" else len(text)
    while at < len(text) and text[at] == '"':
        key, at = _DECODER.raw_decode(text, at)
        at = _skip(text, _skip(text, at) + 1)
        if key == name:
            found = at
        at = _after(text, at)
    return found


def _item(text: str, at: int, index: int) -> int:
    """Return where an item of an array starts; -1 if there is none."""
    at = _skip(text, at + 1) if text[at] == "[" else len(text)
    for _ in range(index):
        if at >= len(text) or text[at] == "]":
            return -1
        at = _after(text, at)
    return at if at < len(text) and text[at] != "]" else -1


def too_large(number: tuple[str, str]) -> Text:
    """Return the sentence for a number that `infinite_number` found."""
    return Text("{number} is too large for a number ({place})", number=number[0][:40], place=number[1])


def sentence_of_json(error: Exception, data: bytes, kind: Any) -> str:
    """Return the sentence for JSON that is not a `kind`; for any other error, the error's own."""
    if isinstance(error, msgspec.ValidationError):
        if number := infinite_number(data):
            return too_large(number)
        try:
            return sentence(error, msgspec.json.decode(data), kind)
        except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as later:  # not JSON further on
            error = later
    return Text("the text is not in UTF-8") if isinstance(error, UnicodeDecodeError) else in_words(str(error))
