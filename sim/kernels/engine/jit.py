"""How softrod's kernels are compiled, and where the machine code is cached.

numba caches machine code on disk, but checks only the file of the function itself: an edit of a callee in
another file would go unnoticed. So each kernel module has a cache folder whose name contains a hash of the
sources of that module, the sources of all modules that it imports kernels from, and the versions of numba and
LLVM. An edit changes the folders of the modules that it can affect, and no others. Within the folder, numba
also checks the path of the file and the processor.
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

_SOURCES = Path(__file__).parents[2]
"""The folder of the solver."""
_FOLDERS = ("kernels", "forces")
"""The folders in it that have kernel modules."""
_IMPORT = re.compile(r"^from (\.+)(\w[\w.]*) import ", re.MULTILINE)
"""Matches an import of one module by another."""
_LAYOUT = re.compile(r"^class \w+\((?:Table|Record)\):\n(?:(?: .*)?\n)*", re.MULTILINE)
"""Matches the declaration of a table."""
_KEPT_DAYS = 30
"""Days after which unused machine code is removed."""

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


def _modules_behind(name: str) -> set[str]:
    """A kernel module, such as `forces.chain`, and all kernel modules that it imports, directly or not."""
    found: set[str] = set()
    # The layout of the tables is part of every kernel's machine code, even where it is not imported.
    waiting = [name, "kernels.engine.jit", "kernels.engine.table", "kernels.core.tables"]
    while waiting:
        module = waiting.pop()
        if module not in found:
            found.add(module)
            text = (_SOURCES / f"{module.replace('.', '/')}.py").read_text(encoding="utf-8")
            for dots, name in _IMPORT.findall(text):
                imported = ".".join((*module.split(".")[: -len(dots)], name))
                if imported.partition(".")[0] in _FOLDERS:
                    waiting.append(imported)
    return found


def module_of(function: Callable[..., Any]) -> str:
    """The kernel module of a function, such as `forces.chain`."""
    return function.__module__.partition(".")[2]


@cache
def source_hash(module: str) -> str:
    """A hash that changes whenever the machine code of a module's kernels may change."""
    digest = hashlib.sha256(f"{numba.__version__} {llvmlite.binding.llvm_version_info}".encode())
    for name in sorted(_modules_behind(module)):
        digest.update(name.encode())
        digest.update((_SOURCES / f"{name.replace('.', '/')}.py").read_bytes())
    for page in sorted((_SOURCES / "forces").glob("*.py")):
        digest.update("".join(_LAYOUT.findall(page.read_text(encoding="utf-8"))).encode())
    return digest.hexdigest()[:16]


@cache
def cache_root() -> Path | None:
    """The folder of all cached machine code, or None where nothing can be written."""
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
        folder = cache_folder(module_of(function))
        if folder is None or not kept:
            return numba.njit(**_OPTIONS | options)(function)
        # The folder is read when the function is decorated; numba has no argument for it, and other
        # users of numba in this process keep the folder they have.
        before = numba.config.CACHE_DIR  # type: ignore[attr-defined]
        numba.config.CACHE_DIR = str(folder)  # type: ignore[attr-defined]
        try:
            return numba.njit(cache=True, **_OPTIONS | options)(function)
        finally:
            numba.config.CACHE_DIR = before  # type: ignore[attr-defined]

    return decorate
