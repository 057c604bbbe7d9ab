"""What kernels tell LLVM about vectors reaches the machine code."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import llvmlite.binding
import numba
import numpy as np
import pytest

from sim.kernels.lanes import eight_at_a_time, gather_as_it_pays

AMD = llvmlite.binding.get_host_cpu_name().startswith("znver")


def _gathered(values: Any, places: Any) -> float:
    eight_at_a_time()
    found = 0.0
    for i in range(places.size):
        found += values[places[i]]
    return found


def _gathered_as_it_pays(values: Any, places: Any) -> float:
    eight_at_a_time()
    gather_as_it_pays()
    found = 0.0
    for i in range(places.size):
        found += values[places[i]]
    return found


def _machine_code(function: Callable[..., float]) -> str:
    """Compiled and tried."""
    compiled: Any = numba.njit(fastmath=True)(function)
    assert compiled(np.arange(100.0), np.arange(4, 100, dtype=np.uint64)[::-1].copy()) == 99 * 50 - 6
    (code,) = compiled.inspect_asm().values()
    return code


@pytest.mark.skipif(not AMD, reason="a processor whose gathers pay")
def test_amd_loads_one_by_one() -> None:
    assert "vgather" in _machine_code(_gathered)
    assert "vgather" not in _machine_code(_gathered_as_it_pays)


@pytest.mark.skipif(AMD, reason="a processor whose gathers do not pay")
def test_others_do_as_llvm_thinks_best() -> None:
    assert ("vgather" in _machine_code(_gathered)) == ("vgather" in _machine_code(_gathered_as_it_pays))
