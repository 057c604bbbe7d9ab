"""`softrod sweep` by several processes and by a cluster, some of which are ended in the middle."""

from __future__ import annotations

import signal
import subprocess
import sys
from functools import cache, partial
from pathlib import Path

import pytest

from tests.studies.others import PATIENCE, Cluster, cluster, wait_for_rows
from tests.studies.sweeping import numbers_of, rows_of

GRID = (
    *("--set", "method=rk4", "--set", "dt=2e-5", "--set", "masses=8"),
    *("--vary", "gravity=200..2000:4", "--vary", "rest_angle=-20,20,50"),
    *("--measure", "sag", "--measure", "energy_residual", "--measure", "stretch", "--measure", "error"),
    *("--duration", "0.4"),
)
"""A sweep of 12 runs that takes so long that one can get in between."""


def command(out: Path, *more: str) -> list[str]:
    return [sys.executable, "-m", "app", "sweep", "tutorial-3.3", *GRID, *more, "--out", str(out)]


@cache
def table_of_one_process(folder: Path) -> bytes:
    """What the sweep gives that nothing disturbs, computed by one process."""
    out = folder / "undisturbed"
    done = subprocess.run(command(out, "--jobs", "1"), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return (out / "table.csv").read_bytes()


@pytest.fixture
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    return table_of_one_process(tmp_path_factory.getbasetemp())


# ------------------------------------------------------------------------- processes
def test_a_sweep_that_was_interrupted_ends_with_the_same_table(undisturbed: bytes, tmp_path: Path) -> None:
    out = tmp_path / "out"
    process = subprocess.Popen(
        command(out, "--jobs", "2"),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        # What a shell runs in the background ignores Ctrl-C, and so do its children.
        preexec_fn=partial(signal.signal, signal.SIGINT, signal.SIG_DFL),
    )
    try:
        wait_for_rows(out / "sweep.jsonl", 1, process)
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
    assert process.returncode == 130, said
    assert "Traceback" not in said
    before = numbers_of(out)
    assert 1 <= len(before) < 12
    assert len(rows_of(out)) == len(before)
    done = subprocess.run(command(out, "--jobs", "2"), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert numbers_of(out)[: len(before)] == before
    assert sorted(numbers_of(out)) == list(range(12))
    assert (out / "table.csv").read_bytes() == undisturbed
    assert undisturbed.count(b"\n") == 13


# ------------------------------------------------------------------------- a cluster
def swept_by(cluster: Cluster, out: Path, rows: int, doomed: subprocess.Popen[str]) -> tuple[int, str]:
    """The exit status of a sweep during which a process is ended, after so many rows, and what it said."""
    process = subprocess.Popen(
        command(out, "--cluster", cluster.address),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    try:
        wait_for_rows(out / "sweep.jsonl", rows, process)
        assert doomed.poll() is None
        doomed.kill()
        assert len(numbers_of(out)) < 12
        said, _ = process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
    return process.returncode, said


def test_a_sweep_bears_the_loss_of_its_scheduler_and_of_a_worker(undisturbed: bytes, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with cluster(tmp_path / "first") as first:
        status, said = swept_by(first, out, 2, first.scheduler)
    assert status == 1, said
    sentence = said.split("softrod: ")[-1]
    assert "the connection to the scheduler is lost" in sentence
    assert "the same command goes on" in sentence
    assert "Traceback" not in said
    before = numbers_of(out)
    assert 2 <= len(before) < 12
    assert len(rows_of(out)) == len(before)
    with cluster(tmp_path / "second") as second, second.another_worker():
        status, said = swept_by(second, out, len(before) + 2, second.worker)
    assert status == 0, said
    assert numbers_of(out)[: len(before)] == before
    assert sorted(numbers_of(out)) == list(range(12))
    assert (out / "table.csv").read_bytes() == undisturbed
