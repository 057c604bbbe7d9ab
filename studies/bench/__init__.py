"""Benchmarks: what is compared runs in turns in one process, and ratios are printed.

The machine is noisy, so the shortest of the repeats counts. Absolute times apply only to the machine on which
they were measured.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping


def fastest(
    contenders: Mapping[str, Callable[[], object]],
    repeats: int,
    clock: Callable[[], float] = time.perf_counter,
) -> dict[str, float]:
    """Return the shortest time of each contender, s.

    Args:
        contenders: run in turns; one run of each before that does not count.
        repeats: turns.
        clock: wall time or processor time.
    """
    for run in contenders.values():
        run()
    best = dict.fromkeys(contenders, float("inf"))
    for _ in range(repeats):
        for name, run in contenders.items():
            began = clock()
            run()
            best[name] = min(best[name], clock() - began)
    return best
