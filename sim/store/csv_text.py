"""Tables as text: comma-separated values, or with semicolons where the comma is the decimal sign."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""How texts begin that spreadsheets take for formulas."""


def csv_text(
    rows: Iterable[Iterable[object]], decimal_comma: bool = False, digits: Callable[[float], str] = repr
) -> str:
    """Rows as CSV; None leaves its place empty.

    A text that a spreadsheet would take for a formula gets an apostrophe before it, since it may be anyone's.

    Args:
        rows: cells; other texts and whole numbers are written as they are.
        decimal_comma: whether numbers have a comma, as spreadsheets of many countries read them. Semicolons
            then stand between the cells.
        digits: writes a number; unless given, with as many digits as it takes to read it back exactly.
    """

    def cell(value: object) -> object:
        if isinstance(value, str) and value.startswith(_FORMULA):
            return f"'{value}"
        if not isinstance(value, float):
            return value
        text = digits(float(value))
        return text.replace(".", ",") if decimal_comma else text

    text = io.StringIO()
    writer = csv.writer(text, delimiter=";" if decimal_comma else ",", lineterminator="\n")
    writer.writerows(map(cell, row) for row in rows)
    return text.getvalue()
