"""Programs in C, compiled and run."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest


def compiler() -> str:
    """A compiler of C; `tests/run.sh` installs one where there is none."""
    found = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if found is None:
        pytest.fail("there is no C compiler: install gcc")
    return found


SANITIZED = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
"""With these a program ends where it reads or writes what is not there, or does what C does not define."""


def compiled(*sources: Path | str, program: Path | None = None) -> Path:
    """The program made of source files, with options among them; a warning of the compiler is a failure."""
    program = program or Path(sources[0]).with_suffix("")
    flags = ["-std=c99", "-O2", "-Wall", "-Wextra", "-pedantic-errors", "-Werror"]
    words = [compiler(), *flags, *map(str, sources), "-o", str(program), "-lm"]
    run = subprocess.run(words, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return program
