"""Breaks the code in 120 places, and counts what the tests of a day and of a night find.

    uv run python -m tests.mutants [--only PATTERN] [--left] [--near] [--night] [--jobs N] [--root DIR]

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
import json
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue

from tests.mutants_bench import Bench, Row

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
Found = dict[str, list[str]]
"""When each row was found, "day", only at "night" or never (""), and by which test; by the row's name."""


def read_rows() -> list[Row]:
    """The table."""
    table = tomllib.loads(ROWS.read_text(encoding="utf-8"))
    return [
        Row(area, **{**row, "tests": tuple(row["tests"])}) for area, rows in table.items() for row in rows
    ]


def files_of(root: Path, folder: str, night: bool) -> list[str]:
    """The files of tests in a folder; at night, those that then test more than by day."""
    files = [file for end in ("test_*.py", "*.test.mjs") for file in (root / "tests" / folder).glob(end)]
    some = (file for file in files if not night or "tests.amount" in file.read_text(encoding="utf-8"))
    return sorted(file.relative_to(root).as_posix() for file in some)


def find_near(bench: Bench, row: Row, known: list[str], night: bool) -> str:
    """The test that finds a row: the one that did last time, or one next to it; empty if none does."""
    there = {name for folder in AREAS[row.area] for name in files_of(bench.root, folder, night)}
    here = [name for name in (f"tests/{name}" for name in row.tests) if name in there]
    with bench.breaking([row]):
        for some in (known[1:] if known[0] == when_of(night) else [], here):
            if failed := bench.failing(some, night):
                return failed[0]
    return ""


def find_anywhere(bench: Bench, rows: Sequence[Row], night: bool) -> Iterator[tuple[Row, str]]:
    """Those of some rows that any test finds, and that test."""
    left = list(rows)
    for folder in ("page", "sim", "app", "studies", "browser"):
        some = [row for row in left if folder in AREAS[row.area]]
        with bench.breaking(some):
            failed = bench.failing(files_of(bench.root, folder, night), night, every=True) if some else []
        if failed and (green := set(failed) - bench.red(failed, night)):
            for row in some:
                with bench.breaking([row]):
                    if alone := bench.failing(sorted(green), night):
                        left.remove(row)
                        yield row, alone[0]


def when_of(night: bool) -> str:
    """A time as it is kept."""
    return "night" if night else "day"


class Count:
    """What is found, row after row.

    Args:
        rows: what is looked for.
        known: what has found each last time.
        benches: where rows are broken, several at once.
        keep: whether it is kept what finds them.
    """

    def __init__(self, rows: Sequence[Row], known: Found, benches: Sequence[Bench], keep: bool) -> None:
        self.rows, self.found = rows, Found()
        self._known, self._keep, self._began = known, keep, time.monotonic()
        self._first, self._jobs, self._free = benches[0], len(benches), SimpleQueue[Bench]()
        for bench in benches:
            self._free.put(bench)

    def look(self, night: bool, near_only: bool) -> None:
        """Look for all that is not found yet."""

        def near(row: Row) -> None:
            bench = self._free.get()
            try:
                if by := find_near(bench, row, self._known.get(row.breaks, [""]), night):
                    self.note(row, when_of(night), by)
            finally:
                self._free.put(bench)

        again = self.left
        while again:
            with ThreadPoolExecutor(self._jobs) as pool:
                list(pool.map(near, again))
            found = {row: self.found[row.breaks][1] for row in again if row.breaks in self.found}
            red = self._first.red(list(found.values()), night)
            again = [row for row, by in found.items() if by in red]
            for row in again:
                del self.found[row.breaks]
        for row, by in () if near_only else find_anywhere(self._first, self.left, night):
            self.note(row, when_of(night), by)

    @property
    def left(self) -> list[Row]:
        """What is not found yet."""
        return [row for row in self.rows if row.breaks not in self.found]

    def note(self, row: Row, when: str, by: str) -> None:
        """Say and keep what has found a row."""
        self.found[row.breaks] = [when, by]
        print(f"{time.monotonic() - self._began:6.0f} s  {row.breaks}: {when or 'nobody'} {by}", flush=True)
        if self._keep:
            every = {**self._known, **self.found}
            kept = {row.breaks: every[row.breaks] for row in read_rows() if row.breaks in every}
            lines = (f"  {json.dumps(name)}: {json.dumps(found)}" for name, found in kept.items())
            KNOWN.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")

    def summary(self) -> str:
        """How many rows of each area were found by whom, those that nobody found, and the shares."""
        lines = [f"{'':<12}{'rows':>6}{'day':>6}{'night':>7}{'nobody':>8}"]
        for area in (*AREAS, "all"):
            if some := [self.found[row.breaks][0] for row in self.rows if area in (row.area, "all")]:
                by = "".join(
                    f"{some.count(when):>{width}}" for when, width in (("day", 6), ("night", 7), ("", 8))
                )
                lines.append(f"{area:<12}{len(some):>6}{by}")
        lines += [f"nobody: {row.breaks} ({row.file})" for row in self.rows if not self.found[row.breaks][0]]
        day, night = (
            [self.found[row.breaks][0] for row in self.rows].count(when) for when in ("day", "night")
        )
        share = (
            f"found by day {day / len(self.rows):.1%}, by day or night {(day + night) / len(self.rows):.1%}"
        )
        return "\n".join((*lines, share))


def main() -> int:
    """1 where a row is stale, or found by nobody."""
    options = argparse.ArgumentParser(
        "python -m tests.mutants", description=(__doc__ or "").partition("\n")[0]
    )
    options.add_argument("--only", default="", metavar="PATTERN", help="rows whose area, name or file has it")
    options.add_argument("--left", action="store_true", help="rows that nobody has found last time")
    options.add_argument("--near", action="store_true", help="only by the tests next to them")
    options.add_argument("--night", action="store_true", help="what a day does not find, at night")
    options.add_argument("--jobs", type=int, default=1, metavar="N", help="how many at once")
    options.add_argument("--root", type=Path, default=HERE.parent, metavar="DIR", help="another checkout")
    given = options.parse_args()
    root, known = given.root.resolve(), Found()
    if KNOWN.is_file():
        known = json.loads(KNOWN.read_text(encoding="utf-8"))
    rows = [row for row in read_rows() if given.only in f"{row.area} {row.breaks} {row.file}"]
    rows = [row for row in rows if not (given.left and known.get(row.breaks, [""])[0])]
    if stale := [sentence for row in rows if (sentence := row.stale(root))]:
        print(*stale, sep="\n", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory(prefix="softrod-mutants-") as name:
        benches = [Bench(Path(name) / str(number), root) for number in range(given.jobs)]
        count = Count(rows, known, benches, keep=root == HERE.parent)
        for night in (False, True)[: 1 + given.night]:
            count.look(night, given.near)
    for row in count.left:
        count.note(row, "", "")
    print(count.summary())
    return int(any(not found[0] for found in count.found.values()))


if __name__ == "__main__":
    sys.exit(main())
