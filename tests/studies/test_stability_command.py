"""`softrod stability`: what a cell is judged by, what the command writes, and what it refuses."""

from __future__ import annotations

import io
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

import sim
from sim.motion.stability import largest_step
from sim.solve.registry import METHODS
from studies.stability import stability as command
from studies.stability.axes import AXES, extent, in_cell, released, rope_of
from studies.stability.hard_case_report import hard_case_report
from studies.stability.map import (
    ACCURATE,
    DAMPED_WRONGLY,
    SAMPLES,
    UNKNOWN,
    UNSTABLE,
    Map,
    ReferenceMotion,
    borders,
    compute,
    track_of,
)
from studies.stability.stability import as_csv, stability
from tests.app.command import refused, softrod_here
from tests.studies.results import read_table

QUIET = Console(file=io.StringIO())
EXPLICIT = ["symplectic_euler", "velocity_verlet", "rk4"]


@pytest.fixture(scope="module")
def moving() -> sim.Scene:
    return released(sim.load_scene("tutorial-3.1"))


def chart(x: str, y: str, ranges: tuple[tuple[float, float], tuple[float, float]], size: int) -> Map:
    return Map(AXES[x], AXES[y], AXES[x].values(ranges[0], size), AXES[y].values(ranges[1], size), 0.0025)


# ------------------------------------------------------------------------- cells
def test_a_body_that_cannot_move_is_let_go(moving: sim.Scene) -> None:
    assert [anchor.mass for anchor in moving.anchors] == [0]
    other = sim.load_scene("tutorial-3.3")
    assert released(other) is other


def test_cells_have_the_numbers_of_their_place(moving: sim.Scene) -> None:
    scene = in_cell(
        moving, {"stiffness": 321.0, "damping": 3.0, "angular_stiffness": 77.0, "mass_ratio": 5.0}
    )
    assert {s.stiffness for s in scene.linear_springs} == {321.0}
    assert {s.damping for s in scene.linear_springs} == {3.0}
    assert {j.stiffness for j in scene.angular_springs} == {77.0}
    assert [m.mass for m in scene.masses] == [1.0, 0.2, 1.0]
    speeds = [math.hypot(*m.velocity) for m in scene.masses]
    assert speeds == pytest.approx([extent(scene)] * 3)
    longer = in_cell(moving, {"masses": 9.0, "mass_ratio": 2.0})
    assert [m.mass for m in longer.masses] == [1.0, 0.5] * 4 + [1.0]
    assert extent(longer) == pytest.approx(extent(moving))


def test_a_straight_chain_has_a_recipe(moving: sim.Scene) -> None:
    recipe = rope_of(moving)
    assert recipe is not None
    assert (recipe.masses, recipe.length, recipe.held) == (3, 350.0, (0,))
    assert rope_of(sim.load_scene("ring")) is None


@pytest.mark.parametrize("method", EXPLICIT)
def test_the_border_of_the_map_is_the_analytic_limit(moving: sim.Scene, method: str) -> None:
    """The heart of it: where simulations break is where theory says, within the width of a cell."""
    scene = in_cell(moving, {"stiffness": 1e6})
    limit = largest_step(scene, method)
    reference = ReferenceMotion(scene, 0.5)
    for part, ending in ((0.97, ACCURATE), (1.08, UNSTABLE)):
        assert reference.judge(track_of(scene, method, part * limit, 0.5))[0] == ending


def test_maps_have_the_border_where_the_limit_is(moving: sim.Scene) -> None:
    made = chart("dt", "stiffness", ((2e-4, 2e-2), (1e5, 1e6)), 12)
    heard: list[tuple[int, int]] = []
    compute(moving, made, ["symplectic_euler", "rk4"], 0.2, lambda done, of, what: heard.append((done, of)))
    assert heard[-1][0] == heard[-1][1]
    assert made.complete
    for method in ("symplectic_euler", "rk4"):
        found = borders(made, method)
        assert found.size == 12
        assert np.abs(np.log(found)).max() < math.log(100.0) / 11
    # And it is that of the method: Runge and Kutta's goes farther.
    assert (made.limits["rk4"] > 1.2 * made.limits["symplectic_euler"]).all()


def test_a_map_that_is_interrupted_keeps_the_cells_that_are_done(moving: sim.Scene) -> None:
    def stop(done: int, of: int, what: str) -> None:
        if what == "rk4":
            raise KeyboardInterrupt

    made = chart("dt", "stiffness", ((2e-3, 2e-2), (1e5, 1e6)), 4)
    with pytest.raises(KeyboardInterrupt):
        compute(moving, made, ["rk4"], 0.05, stop)
    assert (made.endings["rk4"] != UNKNOWN).sum() == 1


def test_endings_are_told_apart(moving: sim.Scene) -> None:
    scene = in_cell(moving, {})
    reference = ReferenceMotion(scene, 0.2)
    track = track_of(scene, "rk4", 1e-4, 0.2)
    ending, error = reference.judge(track)
    assert ending == ACCURATE
    assert error < 1e-4
    size = extent(scene)
    for shift, expected in ((0.009, ACCURATE), (0.011, DAMPED_WRONGLY)):
        off = track.positions.copy()
        off[7, 2, 0] += shift * size  # at one look, one mass
        assert reference.judge(replace(track, positions=off)) == (
            expected,
            pytest.approx(shift, rel=0.02),
        )
    fast = track.velocities.copy()
    fast[3] *= 30.0
    assert reference.judge(replace(track, velocities=fast))[0] == UNSTABLE
    gone = track.positions.copy()
    gone[-1] = np.nan
    assert reference.judge(replace(track, positions=gone))[0] == UNSTABLE


def test_a_track_ends_where_the_body_runs_away() -> None:
    scene = sim.rope(7, direction=(1.0, 0.5), driven=None)
    gone = np.isnan(track_of(scene, "symplectic_euler", 0.2, 40 * 0.2).positions)
    first = int(gone.any((1, 2)).argmax())
    assert gone.any()
    assert not gone[:first].any()
    assert gone[first:].all()


def test_a_track_is_looked_at_at_even_times() -> None:
    track = track_of(sim.rope(3), "rk4", 0.01, 1.0)
    assert track.times == pytest.approx(np.arange(1, SAMPLES + 1) / SAMPLES)
    simulation = sim.Simulation(sim.rope(3), dt=0.01, integrator="rk4")
    simulation.step(100)
    assert track.positions[-1] == pytest.approx(simulation.positions, abs=1e-9)
    # A step that is too long for that is looked at again and again.
    assert track_of(sim.rope(3), "rk4", 0.1, 0.2).times.tolist() == [0.1] * 14 + [0.2] * 6


def test_a_stable_spring_sags_instead_of_breaking(moving: sim.Scene) -> None:
    made = chart("dt", "stiffness", ((2e-3, 5e-2), (1e5, 1e6)), 6)
    compute(moving, made, ["stable_spring", "symplectic_euler"], 0.5)
    endings = made.endings["stable_spring"]
    assert (endings != UNSTABLE).all()
    assert (endings == DAMPED_WRONGLY).any()
    assert (made.endings["symplectic_euler"][:, 2:] == UNSTABLE).all()


# ------------------------------------------------------------------------- the command
def test_it_writes_a_report(tmp_path: Path) -> None:
    scene = sim.load_scene("tutorial-3.1")
    out = tmp_path / "map"
    status = stability(scene, ("mass_ratio", "dt"), (None, (1e-3, 1e-2)), 4, ["rk4"], 0.1, out, QUIET)
    assert status == 0
    assert {p.name for p in out.iterdir()} == {"stability.csv.gz", "stability.md", "mass_ratio-dt.png"}
    rows = read_table(out / "stability.csv.gz")
    assert len(rows) == 16
    assert {row["rk4"] for row in rows} <= {"accurate", "damped wrongly", "unstable"}
    assert {float(row["y_value"]) for row in rows} == {1e-3, 2.15443e-3, 4.64159e-3, 1e-2}
    assert all(float(row["rk4_limit"]) > 0.0 for row in rows)
    page = (out / "stability.md").read_text()
    assert "![" in page
    assert "All masses of tutorial-3.1 are held" in page
    assert "cores; Python" in page


def test_without_axes_it_draws_what_the_scene_has(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    drawn: list[str] = []

    def note(scene: sim.Scene, made: Map, *rest: object) -> None:
        drawn.append(made.name)

    monkeypatch.setattr(command, "compute", note)
    for name, count in (("tutorial-3.1", 5), ("ring", 4)):
        drawn.clear()
        stability(sim.load_scene(name), None, (None, None), 4, [], 0.1, tmp_path, QUIET)
        assert len(drawn) == count


def test_an_interruption_keeps_what_is_done(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def half(scene: sim.Scene, made: Map, methods: list[str], *rest: object) -> None:
        made.endings["rk4"] = np.full(made.shape, UNKNOWN)
        made.errors["rk4"], made.limits["rk4"] = np.full((2, *made.shape), np.nan)
        made.endings["rk4"][0, 0] = ACCURATE
        raise KeyboardInterrupt

    monkeypatch.setattr(command, "compute", half)
    scene = sim.load_scene("tutorial-3.1")
    assert stability(scene, None, (None, None), 3, ["rk4"], 0.1, tmp_path, QUIET) == 130
    assert "Interrupted" in (tmp_path / "stability.md").read_text()
    rows = read_table(tmp_path / "stability.csv.gz")
    assert [row["rk4"] for row in rows] == ["accurate"] + [""] * 8
    assert (tmp_path / "dt-stiffness.png").exists()


def test_a_table_without_maps_has_its_heading() -> None:
    assert as_csv([]) == "x,y,x_value,y_value\n"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--x", "dt"], "--x and --y belong together"),
        (["--x", "size", "--y", "dt"], "--x: 'size' is not one of dt, stiffness"),
        (["--x", "dt", "--y", "dt"], "a map needs two numbers"),
        (["--x-range", "1,2"], "--x-range and --y-range need --x and --y"),
        (["--x", "dt", "--y", "damping", "--x-range", "1e-3"], "two finite numbers with a comma"),
        (["--x", "dt", "--y", "damping", "--x-range", "nan,1"], "two finite numbers with a comma"),
        (["--x", "dt", "--y", "damping", "--x-range", "0,1"], "two ascending numbers within 1e-06..1 s"),
        (["--x", "dt", "--y", "damping", "--y-range", "9,3"], "range of damping: 9,3"),
        (["--size", "1"], "--size: 1 is not in the range 2..512"),
        (["--duration", "nan"], "--duration: nan is not in the range"),
        (["--integrators", "rk4,auto"], "'auto' is not one of symplectic_euler"),
        (["ring", "--x", "masses", "--y", "dt"], "masses: the scene 'ring' is not one straight rope"),
    ],
)
def test_what_it_refuses(
    words: list[str], sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    refused(softrod_here(capsys, "stability", *words, "--out", tmp_path / "out"), sentence)
    assert not (tmp_path / "out").exists()


# ------------------------------------------------------------------------- hard cases
def test_hard_cases_are_reported(tmp_path: Path) -> None:
    assert hard_case_report(tmp_path, QUIET, ("plain", "masses 1:1000", "folded by 180 degrees")) == 0
    rows = read_table(tmp_path / "hard-cases.csv.gz")
    found = {(row["case"], row["method"]): row for row in rows}
    assert len(found) == 3 * len(METHODS)
    assert float(found["plain", "rk4"]["error_in_tolerances"]) < 0.1
    assert float(found["plain", "symplectic_euler"]["error_in_tolerances"]) > 5.0
    assert float(found["folded by 180 degrees", "rk4"]["error_in_tolerances"]) > 50.0
    assert float(found["folded by 180 degrees", "auto"]["error_in_tolerances"]) < 2.0
    assert float(found["masses 1:1000", "rk4"]["gave_up_at"]) < 0.1
    assert found["masses 1:1000", "auto"]["gave_up_at"] == ""
    page = (tmp_path / "hard-cases.md").read_text()
    assert "| masses 1:1000 | yes |" in page
    assert "auto 3 of 3, symplectic_euler 2 of 3" in page
