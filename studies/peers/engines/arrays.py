"""NumPy, for many ropes in one array."""

from __future__ import annotations

from ..runs import Ladder
from ..scenes import MANY

NAME = "NumPy"


def missing() -> str:
    """See `engines`."""
    return ""


def ladders(name: str) -> list[Ladder]:
    """See `engines`."""
    from . import many

    return many.ladders_of_numpy() if name == MANY else []
