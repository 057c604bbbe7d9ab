"""How softrod's kernels are compiled, and where the machine code is kept.

numba keeps machine code on disk, but it looks only at the file of the function itself: an edited callee
in another file would go unnoticed. So the folder is named by a hash of the source of all kernels, of
numba's version and of the processor; a new hash gets a new folder, and old folders are removed.
"""

from __future__ import annotations

import hashlib
import shutil
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite.binding
import numba
import platformdirs
from numba.core.compiler import Compiler

_SOURCES = Path(__file__).parent
_KEPT_FOLDERS = 3
"""How many folders of machine code are kept: enough to go back and forth between two versions."""


_OPTIONS = {
    "nogil": True,
    "no_cfunc_wrapper": True,  # nobody calls one from C: less to compile
    # A division by zero gives an infinity, which the guard catches, instead of a test at every division.
    "error_model": "numpy",
    # No reference counting: a kernel allocates nothing, and its caller holds all its arrays. Counting each
    # access to an array in a tuple, atomically, takes three quarters of the time of a short body's step.
    "_nrt": False,
}


def source_hash() -> str:
    """A hash that changes whenever the machine code could."""
    digest = hashlib.sha256()
    for path in sorted(_SOURCES.glob("*.py")):
        digest.update(path.name.encode())
        digest.update(path.read_bytes())
    for part in (numba.__version__, llvmlite.binding.get_host_cpu_name(), numba.config.CPU_NAME or ""):  # type: ignore[attr-defined]
        digest.update(str(part).encode())
    return digest.hexdigest()[:20]


@cache
def cache_folder() -> Path | None:
    """The folder for the machine code of these very kernels, or None where nothing can be written."""
    root = platformdirs.user_cache_path("softrod", appauthor=False) / "kernels"
    folder = root / source_hash()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        folder.touch()  # the newest is the one used last
        for old in sorted(root.iterdir(), key=lambda path: path.stat().st_mtime)[:-_KEPT_FOLDERS]:
            shutil.rmtree(old, ignore_errors=True)
    except OSError:
        return None
    return folder


def is_cached() -> bool:
    """Whether machine code for these kernels is on the disk already, so that a start is quick."""
    folder = cache_folder()
    return folder is not None and next(folder.glob("**/*.nbc"), None) is not None


# Vectorised loops do one vector at a time. LLVM otherwise does up to four, in loops that a short body's are
# too short for: a rope of a dozen masses is 5 to 10 % faster so, a long one no slower, and a tenth less is
# compiled. LLVM has this for a whole process only.
llvmlite.binding.set_option("softrod", "-force-vector-interleave=1")

FUSED = {"contract"}
"""For the tutorial's step: a product and the sum that it is part of may be one instruction, which rounds once
instead of twice."""

FAST = {"contract", "reassoc", "nsz", "arcp", "afn"}
"""For kernels that need not do the arithmetic as it is written: sums may be fused and reordered, too.
NaN and infinities keep their meaning, since guards and error estimates go by them."""


class _Apart(Compiler):
    """Compiles a function whose arrays share no memory, as C's `restrict` says."""

    def define_pipelines(self) -> Any:
        self.state.flags.noalias = True
        return super().define_pipelines()


def kernel(
    *, inner: bool = False, apart: bool = False, **options: Any
) -> Callable[[Callable[..., Any]], Any]:
    """Compile a kernel: no Python objects, GIL released, machine code kept on disk.

    IEEE double arithmetic, in the order written, unless `fastmath` is `FUSED` or `FAST`: a run is the same
    bit for bit every time on one machine. Only other kernels can call one that is `inner`, or whose name
    starts with an underscore.

    Of one that is `apart`, nothing that is written through one array may be read or written through
    another. Its loops then need not look whether they may be vectorised, which for a dozen short arrays takes
    longer than the loops.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        # What only other kernels call needs no way in from Python: taking a hundred arrays out of their
        # tuples is half a second to compile.
        options["no_cpython_wrapper"] = inner or function.__name__.startswith("_")
        if apart:
            options["pipeline_class"] = _Apart
        folder = cache_folder()
        if folder is None:
            return numba.njit(**_OPTIONS, **options)(function)
        # The folder is read when the function is decorated; numba has no argument for it, and other
        # users of numba in this process keep the folder they have.
        before = numba.config.CACHE_DIR  # type: ignore[attr-defined]
        numba.config.CACHE_DIR = str(folder)  # type: ignore[attr-defined]
        try:
            return numba.njit(**_OPTIONS, cache=True, **options)(function)
        finally:
            numba.config.CACHE_DIR = before  # type: ignore[attr-defined]

    return decorate
