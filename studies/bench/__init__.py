"""Benchmarks: what is compared runs side by side in one go, interleaved, and ratios are printed.

The machine is noisy, so the minimum of the repeats counts. Absolute times say something only of the
machine they were measured on.
"""

from __future__ import annotations

import time
from collections.abc import Callable


def fastest(contenders: dict[str, Callable[[], None]], repeats: int) -> dict[str, float]:
    """The shortest time of each, in seconds, over interleaved repeats; one run before that does not count."""
    for run in contenders.values():
        run()
    best = dict.fromkeys(contenders, float("inf"))
    for _ in range(repeats):
        for name, run in contenders.items():
            began = time.perf_counter()
            run()
            best[name] = min(best[name], time.perf_counter() - began)
    return best
