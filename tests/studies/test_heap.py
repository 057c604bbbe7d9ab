"""The benchmark of heaps: the scene, and what is measured of it."""

from __future__ import annotations

import io

import msgspec
import pytest
from rich.console import Console

from sim.scene.validate import validate
from studies.bench import heap as bench


def test_a_heap_has_as_many_rings_as_it_should_and_none_overlap() -> None:
    scene = validate(bench.heap(84))
    assert len(scene.masses) == 84 * 12
    assert all(mass.position[1] < 0.0 for mass in scene.masses)
    at = [scene.masses[12 * i].position for i in range(84)]
    assert len({(round(x / 30.0), round(y / 32.0)) for x, y in at}) == 84


def test_what_is_measured_is_printed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench, "RINGS", (2,))
    monkeypatch.setattr(bench, "FRAMES", 15)
    console = Console(file=io.StringIO(), width=100)
    bench.bench_heap(console, 1)
    assert isinstance(console.file, io.StringIO)
    rows = console.file.getvalue().splitlines()[-len(bench.METHODS) :]
    assert [float(row.split()[0]) for row in rows] == [24.0] * 3
    assert all(float(row.split()[-3]) > 0.0 and float(row.split()[-1]) > 0.0 for row in rows)


def test_every_frame_is_timed() -> None:
    scene = msgspec.structs.replace(bench.heap(1), integrator=bench.METHODS["Euler, 0.26 ms"])
    best, tried, speed = bench.times(scene, 5, 2)
    assert len(best) == 5
    assert min(best) > 0.0
    assert tried == 5 * 64
    assert speed == pytest.approx(1000.0 * 5.0 / 60.0, rel=0.01)  # it still falls
