"""Results that nobody measured, for what is made of them."""

from __future__ import annotations

from app.studies.random_study import BodyResult


def some_body(seed: int, error: float, left_out: str = "", doubt: float = 1e-8) -> BodyResult:
    """What came of a random body: an error, px, in one call, and twice that at 1 px."""
    others = (2.0 * error, 0.01, 2e-3, 1e-5)
    return BodyResult(seed, "chain", "tutorial", 5, 2.0, doubt, left_out, error, 0.01, 1e-3, 2e-3, others)
