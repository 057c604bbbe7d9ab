"""Compiles entry points and caches the machine code: `python -m sim.compiling.precompile all`, or names.

Without arguments it is a helper of `compiler.Compiler`: it reads names from standard input, one per line, and
prints each when it is done.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable

from .compiler import ENTRY_POINTS


def precompile(names: Iterable[str]) -> None:
    """Compile entry points one by one, and print the name of each when its machine code is kept."""
    for name in names:
        ENTRY_POINTS[name].load()
        print(name, flush=True)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        precompile(ENTRY_POINTS if sys.argv[1:] == ["all"] else sys.argv[1:])
    else:
        if hasattr(os, "nice"):
            os.nice(5)  # the page has priority
        precompile(line.strip() for line in sys.stdin)
