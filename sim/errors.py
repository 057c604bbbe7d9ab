"""Errors for what a user can get wrong. Each message is one clear sentence."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

_LONGEST = 60
"""Letters of a name that is compared with others, at most."""


class SceneError(ValueError):
    """A scene or a scene file is not valid. The message names the field and what is allowed."""


class SettingError(ValueError):
    """A setting (a slider's name and value) is not valid for the scene."""


class InputError(ValueError):
    """A call or an input log asks for something that the simulation cannot do."""


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return a question in brackets, after a space, with the known name that is most like an unknown one;
    nothing if none is."""
    alike = difflib.get_close_matches(name, known, 1) if len(name) <= _LONGEST else []
    return f" (did you mean {alike[0]!r}?)" if alike else ""
