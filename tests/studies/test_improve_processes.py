"""`softrod improve` by several processes and by a cluster, some of which are ended in the middle."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import psutil
import pytest

import sim
from tests.studies.improving import improved, problem_of, rows_by_number
from tests.studies.others import cluster, disturbed, disturbed_today

SETTINGS, VARY = ("method=rk4", "dt=2e-5", "masses=8"), ("gravity=200..2000", "rest_angle=-20..50")
GOAL, DURATION, RUNS, SEED = "min mean mass7.y", 0.4, 16, 7
"""A search that takes so long that one can get in between."""

FILES = ("table.csv", "best.json", "link.txt", "progress.png")


def command(out: Path, *more: str) -> list[str]:
    options = [f"--{name}={text}" for name, texts in (("set", SETTINGS), ("vary", VARY)) for text in texts]
    options += [f"--goal={GOAL}", f"--for={DURATION}", f"--runs={RUNS}", f"--seed={SEED}", *more]
    return [sys.executable, "-m", "app", "improve", "tutorial-3.3", *options, f"--out={out}"]


def improved_here(out: Path) -> None:
    """What the same command does in this process."""
    scene = sim.load_scene("tutorial-3.3")
    status, *_ = improved(out, problem_of(scene, VARY, GOAL, DURATION, RUNS, SEED, SETTINGS))
    assert status == 0


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What is left if nothing disturbs it."""
    out = tmp_path_factory.mktemp("undisturbed")
    improved_here(out)
    return out


def assert_same(out: Path, other: Path) -> None:
    """Bit for bit the same runs, and the same best."""
    assert rows_by_number(out) == rows_by_number(other)
    for name in FILES:
        assert (out / name).read_bytes() == (other / name).read_bytes(), name


@disturbed_today("search")
def test_a_worker_that_is_killed_loses_nothing(undisturbed: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"

    def kill_a_worker(process: subprocess.Popen[str]) -> None:
        children = psutil.Process(process.pid).children()
        next(child for child in children if "spawn_main" in " ".join(child.cmdline())).kill()

    status, said = disturbed(command(out, "--jobs", "2"), out / "improve.jsonl", 7, kill_a_worker)
    assert status == 1, said
    assert "softrod: improve: a worker was lost" in said
    assert "what is done is kept, and the same command goes on" in said
    assert "Traceback" not in said
    before, whole = rows_by_number(out), rows_by_number(undisturbed)
    assert 7 <= len(before) < RUNS
    assert before.items() <= whole.items()
    assert (out / "best.json").exists()
    lines = (out / "improve.jsonl").read_bytes()
    improved_here(out)
    assert (out / "improve.jsonl").read_bytes().startswith(lines)
    assert_same(out, undisturbed)


@disturbed_today("search by a cluster")
def test_a_cluster_finds_the_same_though_a_worker_is_lost(undisturbed: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with cluster(tmp_path / "cluster") as there, there.another_worker():

        def lose_a_worker(_: subprocess.Popen[str]) -> None:
            there.worker.kill()
            assert len(rows_by_number(out)) < RUNS

        words = command(out, "--cluster", there.address)
        status, said = disturbed(words, out / "improve.jsonl", 4, lose_a_worker)
    assert status == 0, said
    assert_same(out, undisturbed)
    assert "softrod: " not in said
