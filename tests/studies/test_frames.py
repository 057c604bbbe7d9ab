"""The benchmark of frames: the rods that it leads in a circle, and what it makes of them."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest
from rich.console import Console

import sim
from studies.bench import frames
from studies.bench.frames import REFERENCE, TOLERANCE, errors, led_rod, run_frames


def test_the_rod_is_the_same_in_more_pieces() -> None:
    # Standing still, so that how finely it is cut is all there is between the two.
    coarse, fine = (
        msgspec.structs.replace(
            scene,
            bodies=(),
            anchors=(msgspec.structs.replace(scene.anchors[0], circle=None),),
            gravity=(0.0, 20.0),
        )
        for scene in (led_rod(34, *REFERENCE), led_rod(67, *REFERENCE))
    )
    assert sum(m.mass for m in coarse.masses) == pytest.approx(sum(m.mass for m in fine.masses))
    tips = []
    for scene in (coarse, fine):
        simulation = sim.Simulation(scene)
        simulation.step(30)
        tips.append(simulation.positions[-1])
        assert np.abs(tips[-1] - (400.0, 100.0)).max() > 3.0
    assert np.abs(tips[0] - tips[1]).max() < 1.5


def test_frames_keep_to_the_tolerance() -> None:
    run = run_frames(sim.Simulation(led_rod(12, "auto", TOLERANCE)))
    right = run_frames(sim.Simulation(led_rod(12, *REFERENCE)))
    off = errors(run.path, right.path)
    assert off.shape == run.seconds.shape == (frames.FRAMES,)
    assert off.max() <= TOLERANCE
    assert off.max() > 0.0
    assert run.steps > frames.FRAMES
    # Led on a circle of 400 px across, twice round.
    assert np.ptp(run.path[:, 0, 1]) == pytest.approx(400.0, rel=0.05)


def test_the_table_has_a_row_for_each_size(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(frames, "SIZES", (3, 5))
    console = Console(record=True, width=160)
    frames.bench_frames(console, 1)
    circle, torn = (table.splitlines() for table in console.export_text().split("\n\n"))
    for lines in (circle, torn):
        assert [line.split()[0] for line in lines[2:]] == ["3", "5"]
    assert all(0.0 <= float(line.split()[-1]) <= TOLERANCE for line in circle[2:])
    # Short ones are led at once.
    assert all(line.split()[-1] == "0" for line in torn[2:])


def test_how_far_a_clock_is_behind() -> None:
    frame = 1.0 / frames.FRAMES
    assert frames.behind(np.full(60, 0.9 * frame)) == 0.0
    late = np.array([0.5, 2.0, 1.5, 0.2, 0.2, 1.1]) * frame
    assert frames.behind(late) == pytest.approx(1.5 * frame)


def test_a_rod_is_torn_as_far_as_its_hand_comes() -> None:
    run = run_frames(sim.Simulation(frames.rod(60, sim.Integrator(dt=1.0 / 60.0))), frames.tear)
    anchor = run.path[:, 0, 0] - 100.0
    assert 30.0 < anchor.max() < frames.TORN
    assert (np.diff(anchor) < 0.0).any()
