"""Where in a JSON file something stands, for error messages."""

from __future__ import annotations

import json
import re

_SPACE = re.compile(r"[ \t\n\r]*")
_STEP = re.compile(r"(\w+)|\[(\d+)\]")
_DECODER = json.JSONDecoder()


def line_and_column(data: bytes, at: int) -> str:
    """In words, the place of a byte."""
    before = data[:at].decode("utf-8", "replace")
    return f"line {before.count(chr(10)) + 1}, column {len(before) - before.rfind(chr(10))}"


def place_of(data: bytes, path: str) -> str:
    """In words, the place of the value at a path such as `masses[2].position[0]`, or of the last value on the
    way there that the file has; empty if the file has not even the first.

    Args:
        data: a file that is JSON.
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
        return ""  # Python reads JSON less freely than msgspec
    if found == begin:
        return ""
    return f"line {text.count(chr(10), 0, found) + 1}, column {found - text.rfind(chr(10), 0, found)}"


def _skip(text: str, at: int) -> int:
    match = _SPACE.match(text, at)
    return match.end() if match else at


def _after(text: str, at: int) -> int:
    """Where the value at a place, and what parts it from the next, end."""
    end = _skip(text, _DECODER.raw_decode(text, at)[1])
    return _skip(text, end + 1) if text[end] == "," else end


def _member(text: str, at: int, name: str) -> int:
    """Where an object's member has its value, the last of that name; -1 if it has none."""
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
    """Where an array has an item; -1 if it has none."""
    at = _skip(text, at + 1) if text[at] == "[" else len(text)
    for _ in range(index):
        if at >= len(text) or text[at] == "]":
            return -1
        at = _after(text, at)
    return at if at < len(text) and text[at] != "]" else -1
