"""Tables as text: comma-separated values, or with semicolons where the comma is the decimal sign."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""First characters of texts that spreadsheets take for formulas."""


def csv_text(
    rows: Iterable[Iterable[object]], decimal_comma: bool = False, digits: Callable[[float], str] = repr
) -> str:
    """Return rows as CSV; None leaves its cell empty.

    A text that a spreadsheet would take for a formula gets a leading apostrophe, since it may come from
    anyone.

    Args:
        rows: cells; other texts and whole numbers are written as they are.
        decimal_comma: whether numbers have a decimal comma, as spreadsheets in many countries expect. Cells
            are then separated by semicolons.
        digits: formats a number; by default with as many digits as needed to read it back exactly.
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
