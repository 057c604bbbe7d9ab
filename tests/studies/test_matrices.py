"""The benchmark of matrices: what it counts, and the bodies that it counts it of."""

from __future__ import annotations

import pytest
from rich.console import Console

import sim
from sim.model.sparsity import fill, new_matrix
from sim.model.system import build_system
from studies.bench import matrices


def filled(scene: sim.Scene) -> tuple[int, int]:
    system = build_system(scene)
    return fill(system.body, new_matrix(system.body, system.held))


def test_the_bodies_have_what_they_should() -> None:
    cloth = matrices.cloth(5)
    assert len(cloth.masses) == 25
    assert len(cloth.linear_springs) == 2 * 5 * 4
    assert len(cloth.angular_springs) == 2 * 5 * 3
    girder = matrices.girder(4)
    assert len(girder.linear_springs) == 6 + 4 + 3
    assert len(girder.angular_springs) == 4
    for scene in (cloth, girder):
        simulation = sim.Simulation(scene)
        # All joints are at rest: their springs are in line.
        assert abs(simulation.angles).max() < 1e-9


def test_a_band_holds_all_blocks_and_more_of_what_is_no_chain() -> None:
    chain = sim.load_scene("study-w4")
    assert filled(chain) == (matrices.in_a_band(chain),) * 2
    for scene in (matrices.cloth(10), matrices.girder(20)):
        blocks, factors = filled(scene)
        assert blocks < factors < matrices.in_a_band(scene)


def test_a_row_for_each_body(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(matrices, "SIDES", (4,))
    monkeypatch.setattr(matrices, "PRESETS", ("ring",))
    console = Console(record=True, width=160)
    matrices.bench_matrices(console, 1)
    rows = [line.split() for line in console.export_text().splitlines()[2:]]
    assert [row[0] for row in rows] == ["ring", "girder-50", "cloth-4x4"]
    for _, masses, blocks, factors, _, _, band, _ in rows:
        assert int(masses) < int(blocks) <= int(factors) <= int(band)
