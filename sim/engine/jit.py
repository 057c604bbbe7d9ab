"""Compilation of softrod's kernels; `kept` stores their machine code."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba
from numba.core.compiler import Compiler

from .kept import keep

_OPTIONS = {
    "nogil": True,
    "no_cfunc_wrapper": True,  # no kernel is called from C, so there is less to compile
    # A division by zero gives an infinity, which the guard catches, instead of a test at every division.
    "error_model": "numpy",
    # No reference counting: a kernel allocates nothing, and its caller keeps all its arrays alive.
    "_nrt": False,
    # Set for every kernel, since numba otherwise inherits these two from the caller that is compiled first,
    # and the bits of a run would depend on the order in which kernels are compiled.
    "fastmath": False,
    "forceinline": False,
}
"""Default numba options of all kernels."""


FUSED = {"contract"}
"""Fast-math flags of the tutorial's step: a multiplication and an addition may be fused into one instruction,
which rounds once instead of twice."""

FAST = {"contract", "reassoc", "nsz", "arcp", "afn"}
"""Fast-math flags of kernels whose operations may also be reordered. NaN and infinities keep their meaning,
since guards and error estimates depend on them."""


class _Noalias(Compiler):
    """Compiles a function whose arrays share no memory, like C's `restrict`."""

    def define_pipelines(self) -> Any:
        self.state.flags.noalias = True
        return super().define_pipelines()


def kernel(
    *, internal: bool = False, noalias: bool = False, kept: bool = True, **options: Any
) -> Callable[[Callable[..., Any]], Any]:
    """Return a decorator that compiles a kernel: no Python objects, GIL released, machine code cached on
    disk.

    Arithmetic is IEEE double precision in the order written, unless `fastmath` is `FUSED` or `FAST`. On a
    given machine every run gives the same bits.

    Args:
        internal: whether only other kernels call it; implied by a name with a leading underscore.
        noalias: promises that memory written through one array argument is not read or written through
            another. Loops then need no run-time checks before their vectorised versions, which for a dozen
            short arrays take longer than the loops.
        kept: whether its machine code is also cached by itself, not only as part of its callers'; impossible
            for functions created by other functions.
        options: further options of `numba.njit`.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        # A kernel that only other kernels call needs no wrapper for Python.
        options["no_cpython_wrapper"] = internal or function.__name__.startswith("_")
        if noalias:
            options["pipeline_class"] = _Noalias
        dispatcher = numba.njit(**_OPTIONS | options)(function)
        if kept:
            keep(dispatcher)
        return dispatcher

    return decorate
