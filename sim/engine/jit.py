"""How softrod's kernels are compiled; `kept` has where their machine code is kept."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba
from numba.core.compiler import Compiler

from .kept import keep

_OPTIONS = {
    "nogil": True,
    "no_cfunc_wrapper": True,  # no kernel is called from C, so there is less to compile
    # A division by zero gives an infinity, which the guard catches; there is no test at every division.
    "error_model": "numpy",
    # No reference counting: a kernel allocates nothing, and its caller holds all its arrays.
    "_nrt": False,
    # Said of every kernel, since numba otherwise takes these two over from the caller that is compiled first,
    # so that the bits of a run would depend on the order in which kernels are compiled.
    "fastmath": False,
    "forceinline": False,
}
"""Options of numba for all kernels, unless they say otherwise."""


FUSED = {"contract"}
"""Fast-math flags of the tutorial's step: a multiplication and an addition may be fused into one instruction,
which rounds once instead of twice."""

FAST = {"contract", "reassoc", "nsz", "arcp", "afn"}
"""Fast-math flags of kernels whose operations may also be reordered. NaN and infinities keep their meaning,
because guards and error estimates depend on them."""


class _Noalias(Compiler):
    """Compiles a function whose arrays share no memory, as C's `restrict` says."""

    def define_pipelines(self) -> Any:
        self.state.flags.noalias = True
        return super().define_pipelines()


def kernel(
    *, internal: bool = False, noalias: bool = False, kept: bool = True, **options: Any
) -> Callable[[Callable[..., Any]], Any]:
    """A decorator that compiles a kernel: no Python objects, GIL released, machine code cached on disk.

    Arithmetic is IEEE double precision in the order written, unless `fastmath` is `FUSED` or `FAST`. On one
    machine every run gives the same bits.

    Args:
        internal: whether only other kernels call it; so it is for every name that starts with an underscore.
        noalias: promises that nothing that is written through one array argument is read or written through
            another. Loops then need no run-time checks before their vectorised versions, which for a dozen
            short arrays take longer than the loops.
        kept: whether its machine code is kept on the disk by itself, too, and not only in that of its
            callers; that of a function made by another one cannot be.
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
