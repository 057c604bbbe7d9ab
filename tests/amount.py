"""How much is tested of what could be tested for hours: by day a part, each day another, and by night all.

So a whole run by day stays within minutes. What breaks is found within as many days as there are parts, and
by night at once.

`tests/run.sh --night` sets `SOFTROD_NIGHT`; `SOFTROD_DAY=20000` runs what a certain day did.
"""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from typing import TypeVar

import pytest

T = TypeVar("T")

NIGHT = bool(os.environ.get("SOFTROD_NIGHT"))
"""Whether everything is to be tested, however long it takes."""

# In the environment, so that all processes of a run take the same day, midnight or not.
_TODAY = int(os.environ.setdefault("SOFTROD_DAY", str(int(time.time() // 86400))))


at_night = pytest.mark.skipif(not NIGHT, reason="by night")
"""For a test that takes tens of seconds."""


def has_its_turn(number: int) -> bool:
    """Whether a test of that number in its file runs today, where a fifth does by day; by night all do."""
    return NIGHT or (number + _TODAY) % 5 == 0


def examples(by_night: int) -> int:
    """How many random examples a property gets; hypothesis draws others in every run."""
    return by_night if NIGHT else max(by_night // 4, 5)


def part_of(cases: Sequence[T], parts: int) -> Sequence[T]:
    """All cases by night; by day one of so many equal parts, each day the next.

    A case has the same number whenever it runs: a test that fails says which, and it fails by night as well.
    """
    return cases if NIGHT else cases[_TODAY % parts :: parts]
