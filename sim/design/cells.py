"""Numbers in the cells of a table, as people and programs in many countries write them."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterable

GAPS = frozenset(
    ("", "-", "--", "---", "—", "nan", "na", "n/a", "n.a.", "#n/a", "#nv", "#n/d", "#nd", "null", "none")
)
"""Cells for missing values, in lower case; "#NV" and the like come from spreadsheets."""

_SIGNS = str.maketrans({**dict.fromkeys("\u2010\u2011\u2012\u2013\u2212\ufe63\uff0d", "-"), "\uff0b": "+"})
"""Signs that word processors, web pages and spreadsheets use instead of the ASCII ones."""
_PLAIN = re.compile(r"[-+]?(?:\d+(?:([.,])\d*)?|([.,])\d+)([eE][-+]?\d{1,6})?", re.ASCII)
_GROUPED = re.compile(
    r"[-+]?[1-9]\d{0,2}(?P<group>[.,'\u2019 \u00a0\u202f\u2009])\d{3}(?:(?P=group)\d{3})*"
    r"(?:(?P<decimal>[.,])\d*)?(?:[eE][-+]?\d{1,6})?",
    re.ASCII,
)
_INFINITE = re.compile(r"[-+]?(?:inf(?:inity)?|∞)", re.IGNORECASE)
_MAX_LETTERS = 80
"""Largest number of characters of a cell that a message quotes."""


def is_gap(cell: str) -> bool:
    """Return whether a cell marks a missing value."""
    return not cell[:1].isdigit() and cell.translate(_SIGNS).strip().lower() in GAPS


def is_number(cell: str) -> bool:
    """Return whether a cell is a number or an infinity, with either decimal sign."""
    if _PLAIN.fullmatch(cell):
        return True
    text = cell.translate(_SIGNS)
    return bool(_PLAIN.fullmatch(text) or _is_grouped(text) or _INFINITE.fullmatch(text))


def _is_grouped(text: str) -> bool:
    match = _GROUPED.fullmatch(text)
    return match is not None and match["group"] != match["decimal"]


def decimal_signs(cell: str) -> str:
    """Return the decimal signs that a number may have: one; both for one like "1.250", which may be slightly
    more than one or more than a thousand; or none if it has none."""
    text = cell.translate(_SIGNS)
    plain = _PLAIN.fullmatch(text)
    sign = (plain[1] or plain[2] or "") if plain else ""
    match = _GROUPED.fullmatch(text)
    if match is None or match["group"] == match["decimal"]:
        return sign
    if match["decimal"]:
        return match["decimal"]
    if match["group"] not in ".,":
        return ""
    other = "," if match["group"] == "." else "."
    return sign + other if sign and not (plain and plain[3]) else sign or other


def value_of(cell: str, decimal: str) -> float:
    """Return the value of a number with a decimal sign; NaN if it is none, infinite if it is too large.

    Args:
        cell: see `is_number`.
        decimal: "." or ",".
    """
    text = cell.translate(_SIGNS)
    plain = _PLAIN.fullmatch(text)
    if plain and (plain[1] or plain[2] or decimal) == decimal:
        return float(text.replace(",", "."))
    match = _GROUPED.fullmatch(text)
    if match and match["group"] != decimal and (match["decimal"] or decimal) == decimal:
        return float(text.replace(match["group"], "").replace(",", "."))
    return math.inf if _INFINITE.fullmatch(text) else math.nan


def printable(text: str) -> str:
    """Return a short one-line text without characters that control a terminal or the writing direction."""
    kept = "".join(" " if char.isspace() else char for char in text if char.isspace() or _is_seen(char))
    kept = " ".join(kept.split())
    return kept if len(kept) <= _MAX_LETTERS else f"{kept[: _MAX_LETTERS - 1]}…"


def _is_seen(char: str) -> bool:
    return unicodedata.category(char) not in ("Cc", "Cf", "Co", "Cs", "Cn")


def known_signs(
    cells: Iterable[tuple[int, str]],
) -> tuple[dict[str, tuple[int, str]], tuple[int, str] | None]:
    """Return the decimal signs that numbers have for certain, each with the first line and cell that has it,
    and the first ambiguous number."""
    certain: dict[str, tuple[int, str]] = {}
    unclear: tuple[int, str] | None = None
    for line, cell in cells:
        signs = decimal_signs(cell)
        if len(signs) == 1:
            certain.setdefault(signs, (line, cell))
            if len(certain) == 2:
                break
        elif signs and unclear is None:
            unclear = (line, cell)
    return certain, unclear
