"""Persistent storage of the kernels' machine code.

numba's own cache depends on the path of a kernel's file, so a new environment would recompile everything; and
it checks only that file, so an edit of a callee in another file would go unnoticed. This cache depends on
content. Each kernel module has a folder whose name contains a hash of everything that its machine code
depends on: the sources of the module and of all modules that it imports kernels from, and the versions of
Python, numba and LLVM. An edit changes the folders of the modules that it can affect, and no others. A file
in the folder is the machine code of one kernel, for one list of argument types and one processor. All
environments of a user therefore share what any of them has compiled, wherever they are.

The stored code is executed, so it is in a folder of the user's own, to which nobody else can write.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import re
import shutil
import stat
import sys
import tempfile
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite
import llvmlite.binding
import numba
import platformdirs
from numba.core.caching import _Cache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps
from numba.core.sigutils import normalize_signature

_SOURCES = Path(__file__).parents[1]
"""The folder of the package with the kernels."""
_FOLDERS = ("engine", "forces", "solve")
"""Its subfolders with kernel modules."""
_IMPORT = re.compile(r"^from (\.+)(\w[\w.]*) import ", re.MULTILINE)
"""Matches an import of one kernel module by another."""
_LAYOUT = re.compile(
    r"^class \w+\((?:Table|Record)\):\n(?:(?: .*)?\n)*|^TERMS = .*\n|^_FIELDS = {\n(?: .*\n)*", re.MULTILINE
)
"""Matches the declaration of a table, and the source of the table of all terms."""
_KEPT_DAYS = 30
"""Days after which unused machine code is removed. Doubled, `test_what_nobody_used_for_a_month_is_removed`
fails."""


def _modules_behind(name: str) -> set[str]:
    """Return a kernel module, such as `forces.chain`, and all kernel modules that it depends on."""
    found: set[str] = set()
    # The layout of the tables is part of every kernel's machine code, even where it is not imported.
    waiting = [name, "engine.jit", "engine.table", "engine.tables"]
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


def _module_of(function: Callable[..., Any]) -> str:
    """Return the kernel module of a function, such as `forces.chain`."""
    return function.__module__.partition(".")[2]


def _compiler() -> str:
    """Describe the compiler, with everything except the processor that can change its machine code."""
    versions = (sys.implementation.cache_tag, numba.__version__, llvmlite.__version__)
    # Intel's library of vector functions is used where it is installed.
    uses_svml = numba.config.USING_SVML  # type: ignore[attr-defined]
    return f"{versions} {llvmlite.binding.llvm_version_info} {uses_svml}"


@cache
def source_hash(module: str) -> str:
    """Return a hash that changes whenever the machine code of a module's kernels may change."""
    digest = hashlib.sha256(_compiler().encode())
    for name in sorted(_modules_behind(module)):
        digest.update(name.encode())
        digest.update((_SOURCES / f"{name.replace('.', '/')}.py").read_bytes())
    for page in sorted((_SOURCES / "forces").rglob("*.py")):
        digest.update("".join(_LAYOUT.findall(page.read_text(encoding="utf-8"))).encode())
    return digest.hexdigest()[:16]


def _root() -> Path:
    return platformdirs.user_cache_path("softrod", appauthor=False) / "kernels"


def trouble() -> str:
    """Return why nothing can be stored, in words; empty if it can."""
    root = _root()
    try:
        root.parent.mkdir(parents=True, exist_ok=True)
        root.mkdir(mode=0o700, exist_ok=True)
        found = root.stat()
    except OSError:
        return f"the folder {root.parent} cannot be written"
    if not os.access(root, os.W_OK):
        return f"the folder {root} cannot be written"
    if hasattr(os, "geteuid"):  # on Windows, a user's folders are private
        if found.st_uid != os.geteuid():
            return f"the folder {root} is another user's"
        if found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
            return f"others can write into the folder {root}"
    return ""


@cache
def cache_root() -> Path | None:
    """Return the folder of all cached machine code, or None where nothing can be stored."""
    if trouble():
        return None
    root = _root()
    oldest = time.time() - 86400.0 * _KEPT_DAYS
    for old in root.iterdir():
        # Another process may be removing it at the same time.
        with contextlib.suppress(OSError):
            if old.stat().st_mtime < oldest:
                shutil.rmtree(old, ignore_errors=True)
    return root


@cache
def cache_folder(module: str) -> Path | None:
    """Return the folder for the machine code of a module's kernels, or None where nothing can be stored."""
    root = cache_root()
    if root is None:
        return None
    folder = root / f"{module}-{source_hash(module)}"
    try:
        folder.mkdir(exist_ok=True)
        folder.touch()  # marks it as used
    except OSError:
        return None
    return folder


def keep(kernel: Any) -> None:
    """Let the machine code of a kernel be stored and found again.

    Args:
        kernel: numba's dispatcher. Its function must not be created by another function, whose variables are
            not part of the key.
    """
    folder = cache_folder(_module_of(kernel.py_func))
    if folder is not None:
        kernel._cache = _Kept(kernel.py_func, folder)


def file_of(kernel: Any, signature: tuple[numba.types.Type, ...]) -> Path | None:
    """Return the file of a kernel's machine code, which may not exist; None where nothing can be stored.

    Args:
        kernel: numba's dispatcher.
        signature: the types of its arguments.
    """
    kept = kernel._cache
    return kept.file(signature, kernel.targetctx.codegen()) if isinstance(kept, _Kept) else None


class _Kept(_Cache):
    """The machine code of one kernel, in a file for each list of argument types and each processor.

    A file is written under a temporary name and then renamed, so that several processes compiling the same
    kernel may all write it, and none reads an incomplete file.
    """

    def __init__(self, function: Callable[..., Any], folder: Path) -> None:
        code = function.__code__
        self._name = function.__name__
        self._key = f"{code.co_qualname} {code.co_firstlineno}"
        self._folder = folder

    @property
    def cache_path(self) -> Any:
        return str(self._folder)

    def enable(self) -> None:
        pass  # it is always enabled

    def disable(self) -> None:
        raise NotImplementedError

    def flush(self) -> None:
        raise NotImplementedError

    def file(self, types: Any, codegen: Any) -> Path:
        # The types' names are unique; the tuple names the processor.
        key = f"{self._key} {[str(one) for one in types]} {codegen.magic_tuple()}"
        return self._folder / f"{self._name}-{hashlib.sha256(key.encode()).hexdigest()[:16]}.nbc"

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        target_context.refresh()
        try:
            content = pickle.loads(self.file(_types(sig), target_context.codegen()).read_bytes())
        except Exception:
            # Never compiled, or lost by the disk because it was written last: recompile and write again.
            return None
        return CompileResult._rebuild(target_context, *content)

    def save_overload(self, sig: Any, data: Any) -> None:
        if data.lifted or data.library.has_dynamic_globals:
            return  # it contains addresses of this process
        content = dumps(data._reduce())
        with contextlib.suppress(OSError):  # the disk is full: compile again another time
            self._folder.mkdir(exist_ok=True)
            with tempfile.NamedTemporaryFile(dir=self._folder, delete=False) as written:
                try:
                    written.write(content)
                    written.close()
                    Path(written.name).replace(self.file(_types(sig), data.codegen))
                except BaseException:
                    Path(written.name).unlink(missing_ok=True)
                    raise


def _types(signature: Any) -> tuple[numba.types.Type, ...]:
    """Return the argument types of a signature in any of numba's forms."""
    return normalize_signature(signature)[0]
