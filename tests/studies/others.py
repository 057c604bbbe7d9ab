"""Other processes that compute: a cluster, and a command that is waited for."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import msgspec
import pytest

from tests.amount import part_of

DISTURBED = part_of(("sweep", "search by a cluster", "sweep by a cluster", "search"), 4)
"""What is disturbed, which takes several processes: one a day."""


def disturbed_today(what: str) -> pytest.MarkDecorator:
    """For a test that disturbs one of them."""
    return pytest.mark.skipif(what not in DISTURBED, reason="it is another's turn today")


PATIENCE = 300.0
"""Seconds after which a process that should have done something has failed, however busy the machine is."""


def wait_for_rows(path: Path, count: int, process: subprocess.Popen[str]) -> None:
    """Wait until so many runs are done, while others are not."""
    patience = time.monotonic() + PATIENCE
    while not path.exists() or path.read_bytes().count(b"\n") <= count:
        assert process.poll() is None, "it ended before anything could be done to it"
        assert time.monotonic() < patience
        time.sleep(0.005)


def disturbed(
    words: Sequence[str],
    rows: Path,
    count: int,
    disturb: Callable[[subprocess.Popen[str]], None],
    **more: Any,
) -> tuple[int, str]:
    """The exit status of a command to which something is done after so many runs, and what it said."""
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)
    try:
        wait_for_rows(rows, count, process)
        disturb(process)
        said, _ = process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
    return process.returncode, said


class Cluster(NamedTuple):
    """A scheduler, one of its workers, and a way to start more."""

    address: str
    scheduler: subprocess.Popen[str]
    worker: subprocess.Popen[str]
    another_worker: Callable[[], AbstractContextManager[subprocess.Popen[str]]]


@contextmanager
def started(*words: str | Path) -> Iterator[subprocess.Popen[str]]:
    """A process of Dask, which is ended with this context."""
    dask = Path(sys.executable).with_name("dask")
    process = subprocess.Popen(
        [str(dask), *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, text=True
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@contextmanager
def cluster(folder: Path) -> Iterator[Cluster]:
    """A scheduler and a worker of it."""
    folder.mkdir()
    where = folder / "scheduler.json"
    to_it = ("--scheduler-file", where, "--no-dashboard")
    worker = ("worker", *to_it, "--nthreads", "1", "--no-nanny", "--host", "127.0.0.1")
    with (
        started("scheduler", *to_it, "--host", "127.0.0.1", "--port", "0") as scheduler,
        started(*worker) as first,
    ):
        patience = time.monotonic() + PATIENCE
        # The file is there before it is whole.
        while not (where.exists() and where.read_bytes().rstrip().endswith(b"}")):
            assert time.monotonic() < patience, "there is no scheduler"
            time.sleep(0.01)
        address = msgspec.json.decode(where.read_bytes())["address"]
        yield Cluster(address, scheduler, first, lambda: started(*worker))
