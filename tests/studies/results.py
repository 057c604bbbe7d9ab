"""Results that nobody measured, for what is made of them; and tables of results, read back."""

from __future__ import annotations

import csv
import gzip
from pathlib import Path

from studies.compare.random_study import BodyResult


def some_body(
    seed: int, error: float, left_out: str = "", doubt: float = 1e-8, growth: float = 2.0
) -> BodyResult:
    """What came of a random body: an error, px, in one call, and twice that at 1 px."""
    others = (2.0 * error, 0.01, 2e-3, 1e-5)
    return BodyResult(seed, "chain", "tutorial", 5, growth, doubt, left_out, error, 0.01, 1e-3, 2e-3, others)


def read_table(path: Path) -> list[dict[str, str]]:
    """The rows of a table that a study wrote."""
    with gzip.open(path, "rt", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))
