"""Tables as text: comma-separated values, or with semicolons where the comma is the decimal sign."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable


def csv_text(
    rows: Iterable[Iterable[object]], decimal_comma: bool = False, digits: Callable[[float], str] = repr
) -> str:
    """Rows as CSV; None leaves its place empty.

    Args:
        rows: cells; texts and whole numbers are written as they are.
        decimal_comma: whether numbers have a comma, as spreadsheets of many countries read them. Semicolons
            then stand between the cells.
        digits: writes a number; unless given, with as many digits as it takes to read it back exactly.
    """

    def cell(value: object) -> object:
        if not isinstance(value, float):
            return value
        text = digits(float(value))
        return text.replace(".", ",") if decimal_comma else text

    text = io.StringIO()
    writer = csv.writer(text, delimiter=";" if decimal_comma else ",", lineterminator="\n")
    writer.writerows(map(cell, row) for row in rows)
    return text.getvalue()
