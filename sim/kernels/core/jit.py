"""How softrod's kernels are compiled, and where the machine code is kept.

numba keeps machine code on disk, but it looks only at the file of the function itself: an edited callee in
another file would go unnoticed. So the kernels of a module have a folder that is named by a hash of the
sources of that module, of all modules that it imports kernels from, and of the versions of numba and LLVM. An
edit gives new folders to the modules that it can change, and to no others. Within its folder, numba looks at
the path of the file and at the processor, too.
"""

from __future__ import annotations

import hashlib
import re
import shutil
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite.binding
import numba
import platformdirs
from numba.core.compiler import Compiler

_SOURCES = Path(__file__).parents[1]
_IMPORT = re.compile(r"^from (\.{1,2})(\w[\w.]*) import ", re.MULTILINE)
_KEPT_DAYS = 30
"""Days after which machine code that nobody used is removed."""

_OPTIONS = {
    "nogil": True,
    "no_cfunc_wrapper": True,  # nobody calls one from C: less to compile
    # A division by zero gives an infinity, which the guard catches, instead of a test at every division.
    "error_model": "numpy",
    # No reference counting: a kernel allocates nothing, and its caller holds all its arrays.
    "_nrt": False,
}


def _modules_behind(name: str) -> set[str]:
    """A kernel module, as in `forces.chain`, and all kernel modules that it imports, directly or not."""
    found: set[str] = set()
    # Where a table keeps what is in no kernel's imports, but in its machine code.
    waiting = [name, "core.jit", "core.table", "core.tables"]
    while waiting:
        module = waiting.pop()
        if module not in found:
            found.add(module)
            text = (_SOURCES / f"{module.replace('.', '/')}.py").read_text(encoding="utf-8")
            folder = module.partition(".")[0]
            waiting += [
                f"{folder}.{name}" if len(dots) == 1 else name for dots, name in _IMPORT.findall(text)
            ]
    return found


def module_of(function: Callable[..., Any]) -> str:
    """The kernel module of a function, as in `forces.chain`."""
    return ".".join(function.__module__.split(".")[-2:])


@cache
def source_hash(module: str) -> str:
    """A hash that changes whenever the machine code of a module's kernels could."""
    digest = hashlib.sha256(f"{numba.__version__} {llvmlite.binding.llvm_version_info}".encode())
    for name in sorted(_modules_behind(module)):
        digest.update(name.encode())
        digest.update((_SOURCES / f"{name.replace('.', '/')}.py").read_bytes())
    return digest.hexdigest()[:16]


@cache
def cache_root() -> Path | None:
    """The folder that all machine code is kept in, or None where nothing can be written."""
    root = platformdirs.user_cache_path("softrod", appauthor=False) / "kernels"
    try:
        root.mkdir(parents=True, exist_ok=True)
        oldest = time.time() - 86400.0 * _KEPT_DAYS
        for old in root.iterdir():
            if old.stat().st_mtime < oldest:
                shutil.rmtree(old, ignore_errors=True)
    except OSError:
        return None
    return root


@cache
def cache_folder(module: str) -> Path | None:
    """The folder for the machine code of a module's kernels, or None where nothing can be written."""
    root = cache_root()
    if root is None:
        return None
    folder = root / f"{module}-{source_hash(module)}"
    try:
        folder.mkdir(exist_ok=True)
        folder.touch()  # it is in use
    except OSError:
        return None
    return folder


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


class _Noalias(Compiler):
    """Compiles a function whose arrays share no memory, as C's `restrict` says."""

    def define_pipelines(self) -> Any:
        self.state.flags.noalias = True
        return super().define_pipelines()


def kernel(
    *, internal: bool = False, noalias: bool = False, **options: Any
) -> Callable[[Callable[..., Any]], Any]:
    """Compile a kernel: no Python objects, GIL released, machine code kept on disk.

    IEEE double arithmetic, in the order written, unless `fastmath` is `FUSED` or `FAST`: a run is the same
    bit for bit every time on one machine. Only other kernels can call one that is `internal`, or whose name
    starts with an underscore.

    Of one that is `noalias`, nothing that is written through one array argument may be read or written
    through another. Its loops then need not look whether they may be vectorised, which for a dozen short
    arrays takes longer than the loops.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        # What only other kernels call needs no way in from Python.
        options["no_cpython_wrapper"] = internal or function.__name__.startswith("_")
        if noalias:
            options["pipeline_class"] = _Noalias
        folder = cache_folder(module_of(function))
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
