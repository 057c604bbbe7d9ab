"""`softrod sweep` by several processes and by a cluster, some of which are ended in the middle."""

from __future__ import annotations

import signal
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

import sim
from tests.amount import NIGHT
from tests.studies.others import Cluster, cluster, disturbed, disturbed_today
from tests.studies.sweeping import numbers_of, rows_of, swept

SETTINGS, VARY = ("method=rk4", "dt=2e-5", "masses=8"), ("gravity=200..2000:4", "rest_angle=-20,20,50")
MEASURES, DURATION = ("sag", "energy_residual", "stretch", "error"), 0.4
"""A sweep of 12 runs that takes so long that one can get in between."""


def command(out: Path, *more: str) -> list[str]:
    options = [f"--{name}={text}" for name, texts in (("set", SETTINGS), ("vary", VARY)) for text in texts]
    options += [*(f"--measure={name}" for name in MEASURES), f"--duration={DURATION}", *more]
    return [sys.executable, "-m", "app", "sweep", "tutorial-3.3", *options, f"--out={out}"]


def swept_here(out: Path) -> None:
    """What the same command does in this process."""
    scene = sim.load_scene("tutorial-3.3")
    status, *_ = swept(out, scene, VARY, MEASURES, DURATION, settings=SETTINGS)
    assert status == 0


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The table of the sweep that nothing disturbs."""
    out = tmp_path_factory.mktemp("undisturbed")
    swept_here(out)
    return (out / "table.csv").read_bytes()


# ------------------------------------------------------------------------- processes
@disturbed_today("sweep")
def test_a_sweep_that_was_interrupted_ends_with_the_same_table(undisturbed: bytes, tmp_path: Path) -> None:
    out = tmp_path / "out"
    # What a shell runs in the background ignores Ctrl-C, and so do its children.
    heeding = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
    words, rows = command(out, "--jobs", "2"), out / "sweep.jsonl"
    status, said = disturbed(words, rows, 1, lambda it: it.send_signal(signal.SIGINT), preexec_fn=heeding)
    assert status == 130, said
    assert "Traceback" not in said
    before = numbers_of(out)
    assert 1 <= len(before) < 12
    assert len(rows_of(out)) == len(before)
    swept_here(out)
    assert numbers_of(out)[: len(before)] == before
    assert sorted(numbers_of(out)) == list(range(12))
    assert (out / "table.csv").read_bytes() == undisturbed
    assert undisturbed.count(b"\n") == 13


# ------------------------------------------------------------------------- a cluster
def swept_by(cluster: Cluster, out: Path, rows: int, doomed: subprocess.Popen[str]) -> tuple[int, str]:
    """The exit status of a sweep during which a process is ended, after so many rows, and what it said."""

    def end(_: subprocess.Popen[str]) -> None:
        assert doomed.poll() is None
        doomed.kill()
        assert len(numbers_of(out)) < 12

    return disturbed(command(out, "--cluster", cluster.address), out / "sweep.jsonl", rows, end)


@disturbed_today("sweep by a cluster")
def test_a_sweep_bears_the_loss_of_its_scheduler_and_by_night_of_a_worker(
    undisturbed: bytes, tmp_path: Path
) -> None:
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
    if NIGHT:
        with cluster(tmp_path / "second") as second, second.another_worker():
            status, said = swept_by(second, out, len(before) + 2, second.worker)
        assert status == 0, said
    else:
        swept_here(out)
    assert numbers_of(out)[: len(before)] == before
    assert sorted(numbers_of(out)) == list(range(12))
    assert (out / "table.csv").read_bytes() == undisturbed
