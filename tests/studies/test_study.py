"""`softrod study`: the equations of the other solvers, how settings are tried, and what is written."""

from __future__ import annotations

import csv
import importlib
import io
import math
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

import sim
from app.cli import main as cli
from sim.errors import InputError
from sim.model.system import build_system
from sim.scene.types import Circle
from sim.solve.registry import METHODS
from studies.bench.growth import rod
from studies.commands import BENCHES, COMMANDS
from studies.compare import study as command
from studies.compare import study_report as report
from studies.compare.engines import softrod, solvers
from studies.compare.engines.softrod import run_at
from studies.compare.engines.solvers import SolverRun
from studies.compare.equations import Equations
from studies.compare.figures import front, study_figures
from studies.compare.random_bodies import random_body
from studies.compare.references import agreed_reference, path_by
from studies.compare.results import SOLVERS, SceneResults, Study
from studies.compare.runs import SOFTROD, Failed, Point, auto_at, best, distance, run
from studies.compare.study import explore, parse_errors, parse_integrators, repeats, study, study_scenes
from studies.compare.study_report import points_csv, targets
from studies.reporting.report import markdown
from tests.amount import part_of
from tests.app.command import refused, softrod_here
from tests.studies.results import read_table, some_body

ROPE = sim.rope(masses=4, length=90.0, direction=(1.0, 0.0), circle=Circle(radius=20.0, frequency=2.0))
BODIES = [
    pytest.param(ROPE, id="rope on a circle"),
    *(pytest.param(random_body(seed), id=random_body(seed).name) for seed in (5, 6, 29, 14, 7)),
]


# ------------------------------------------------------------------------- equations
@pytest.mark.parametrize("scene", BODIES)
def test_the_jacobian_is_that_of_the_equations_in_every_layout(scene: sim.Scene) -> None:
    equations = Equations(scene)
    size, f = equations.start.size, equations.derivative()
    y = equations.start + np.random.default_rng(1).normal(size=size)
    expected = np.empty((size, size))
    for k, shift in enumerate(1e-4 * np.eye(size)):
        expected[:, k] = (f(0.3, y + shift) - f(0.3, y - shift)) / 2e-4
    dense = np.zeros((size, size))
    equations.jacobian_into("dense")(0.3, y, dense.reshape(-1))
    assert np.abs(dense - expected).max() <= 1e-8 * np.abs(expected).max()
    banded = np.zeros((equations.below + equations.above + 1, size))
    equations.jacobian_into("banded")(0.3, y, banded.reshape(-1))
    row, first = equations.pattern()
    sparse = np.zeros(row.size)
    equations.jacobian_into("sparse")(0.3, y, sparse)
    unpacked = np.zeros((2, size, size))
    for j in range(size):
        low, high = max(0, j - equations.above), min(size, j + equations.below + 1)
        unpacked[0, low:high, j] = banded[equations.above + low - j : equations.above + high - j, j]
        unpacked[1, row[first[j] : first[j + 1]], j] = sparse[first[j] : first[j + 1]]
    assert np.array_equal(unpacked[0], dense)
    assert np.array_equal(unpacked[1], dense)


def test_a_chain_has_a_narrow_band() -> None:
    equations = Equations(sim.load_scene("study-w4"))
    assert (equations.below, equations.above) == (11, 9)
    # A ring in its own order would have a block in the far corner.
    ring = Equations(sim.load_scene("study-ring"))
    assert ring.below < 30


@pytest.mark.parametrize("scene", part_of(BODIES[:3], 3))
@pytest.mark.parametrize("name", SOLVERS)
def test_other_solvers_agree_with_softrod(name: str, scene: sim.Scene) -> None:
    engine, method = SOLVERS[name]
    if engine == "CVODE" and not solvers.has_cvode():
        pytest.skip("scikit-sundae is not installed")
    right = path_by(scene, "adams", 1e-8)
    equations = Equations(scene)
    framed = run(SolverRun(equations, engine, method, 1e-4, 60))
    whole = run(SolverRun(equations, engine, method, 1e-4))
    assert right is not None
    assert framed.path is not None, framed.failure
    assert whole.path is not None
    assert framed.path.shape == right.shape
    assert distance(framed.path, right) < 0.2
    assert distance(whole.path[-1], right[-1]) < 0.2
    assert whole.seconds > 0.0


def test_a_solver_is_ready_before_its_clock_starts() -> None:
    """In a process of its own, where nothing is imported yet."""
    script = (
        "import sim\n"
        "from studies.compare.engines.solvers import SolverRun\n"
        "from studies.compare.equations import Equations\n"
        "from studies.compare.runs import run\n"
        "equations = Equations(sim.load_scene('tutorial-3.3'))\n"
        "for name in ('LSODA', 'RK45'):\n"
        "    contender = SolverRun(equations, 'SciPy', name, 1.0)\n"
        "    first, second = run(contender), run(contender)\n"
        "    assert first.path is not None and first.seconds < 20.0 * second.seconds + 0.05, name\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True, cwd=Path(__file__).parents[2])


def test_a_solver_that_takes_too_long_or_fails_is_no_error() -> None:
    equations = Equations(ROPE)
    slow = SolverRun(equations, "SciPy", "DOP853", 1e-6, patience=1e-4)
    assert "not done after 0.0001 s" in run(slow).failure

    def broken(*_: object) -> None:
        raise ValueError("two\nlines")

    contender = SolverRun(equations, "SciPy", "DOP853", 1e-6)
    contender.solve = broken  # type: ignore[assignment]
    failed = run(contender)
    assert (failed.path, failed.failure) == (None, "two lines")


# ------------------------------------------------------------------------- softrod's methods
def test_a_contender_does_the_same_every_time_and_frames_make_no_difference_to_fixed_steps() -> None:
    contender = run_at(ROPE, "velocity_verlet", 1e-3)
    once, again = run(contender), run(contender)
    framed = run(run_at(ROPE, "velocity_verlet", 1e-3, 60))
    assert once.path is not None
    assert again.path is not None
    assert framed.path is not None
    assert np.array_equal(once.path, again.path)
    assert len(framed.path) == 60
    assert distance(framed.path[-1], once.path[-1]) < 1e-9


def test_what_runs_away_has_failed() -> None:
    trial = run(run_at(sim.load_scene("study-w3"), "symplectic_euler", 1.0 / 60.0))
    assert trial.path is None
    assert trial.failure


def test_attempts_are_counted_over_all_frames(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = run_at(ROPE, "auto", 1e-6, 60)
    assert run(whole).path is not None
    monkeypatch.setattr(softrod, "MAX_ATTEMPTS", 100)
    assert run(whole).failure == "not done after 100 steps"


def test_runs_of_very_many_fixed_steps_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(Failed, match="more than 300000 steps"):
        run_at(ROPE, "velocity_verlet", 1.0 / 300_060.0)
    monkeypatch.setattr(softrod, "MAX_STEPS", 240)
    assert run(run_at(ROPE, "velocity_verlet", 1.0 / 240.0)).path is not None
    monkeypatch.setattr(command, "repeats", lambda seconds: 1)
    points = measured(ROPE, ("velocity_verlet",), (1e-9,)).points
    for point in points:
        assert (point.failure == "more than 240 steps") == (point.value < 1.0 / 241.0)
    assert [point.failure for point in points].count("") == 2


def test_the_reference_says_how_sure_it_is() -> None:
    found = agreed_reference(ROPE, (1e-4, 1e-9), 1e-7)
    assert found.doubt < 1e-6
    assert agreed_reference(ROPE, (1e-2,), 1e-7).doubt > found.doubt


# ------------------------------------------------------------------------- trying settings
def measured(scene: sim.Scene, integrators: tuple[str, ...], errors: tuple[float, ...]) -> SceneResults:
    *_, (results, _) = explore(scene, "name", integrators, errors)
    assert results is not None
    return results


def test_settings_are_tried_until_they_are_good_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(command, "repeats", lambda seconds: 2)
    results = measured(ROPE, ("auto", "symplectic_euler", "scipy_lsoda"), (3.0, 0.05))
    assert results.complete
    for name in ("auto", "symplectic_euler", "scipy_lsoda"):
        found = best(results.of((name,)), 0.05)
        assert found is not None, name
        assert found.runs == 2
    # Hindsight's step is the longest that will do, within a few per cent.
    steps = results.of(("symplectic_euler",))
    good, bad = ([p.value for p in steps if (p.error <= 0.05) == wanted] for wanted in (True, False))
    longest = max(good)
    assert min(value for value in bad if value > longest) < 1.1 * longest
    # `auto` gets the error itself.
    auto = auto_at(results.points, 0.05)
    assert auto is not None
    assert math.isfinite(auto.framed_seconds)
    assert auto.framed_error <= 0.1


def test_too_slow_settings_are_not_refined(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(softrod, "LONGEST", 0.0)
    monkeypatch.setattr(command, "repeats", lambda seconds: 1)
    results = measured(ROPE, ("rk4",), (1.0, 1e-6))
    assert [point.failure for point in results.points].count("") == 1


def test_what_is_short_is_repeated_more_often() -> None:
    counts = [repeats(seconds) for seconds in (1e-4, 0.05, 0.3, 2.0)]
    assert counts == sorted(counts, reverse=True)
    assert counts[-1] == 1


# ------------------------------------------------------------------------- the report
def point_of(scene: str, name: str, value: float, error: float, seconds: float, failure: str = "") -> Point:
    engine, method = SOLVERS.get(name, (SOFTROD, name))
    return Point(scene, engine, method, f"{value:g}", value, seconds, error, error, runs=1, failure=failure)


def some_study() -> Study:
    def point(name: str, value: float, error: float, seconds: float, failure: str = "") -> Point:
        made = point_of("study-w1", name, value, error, seconds, failure)
        if name == "auto":
            made.framed_seconds, made.framed_error = 2.0 * seconds, error
        return made

    points = [
        point("auto", 0.1, 0.05, 1e-4),
        point("auto", 1e-6, 5e-7, 1e-3),
        point("symplectic_euler", 1e-3, 0.09, 7e-4),
        point("symplectic_euler", 5e-4, 0.04, 1.4e-3),
        point("symplectic_euler", 1e-2, math.inf, 1e-4, "speed out of range"),
        point("scipy_bdf", 1.0, 0.02, 2e-3),
    ]
    results = SceneResults("study-w1", 1e-9, points, complete=True)
    return Study((1.0, 0.1, 1e-6), [results], [some_body(0, 0.05), some_body(1, 2.0)])


def test_a_doubtful_reference_meets_no_target() -> None:
    doubtful = some_study()
    doubtful.scenes[0].doubt = 0.05
    found = [target for target in targets(doubtful) if target.what.startswith("study-w1")]
    assert len(found) == 3
    assert {(target.found, target.met) for target in found} == {("below the doubt", False)}


def test_targets_are_judged() -> None:
    found = {target.what: target for target in targets(some_study())}
    euler = found["study-w1: tutorial Euler, best step / auto"]
    assert (euler.found, euler.met) == ("7×", True)
    coarse = found["study-w1: best other solver at 0.1 px / auto"]
    assert (coarse.found, coarse.met) == ("20×", False)
    assert found["study-w1: best other solver at 1e-06 px / auto"].found == "never reached"
    assert not found["2 random bodies, one call: end within the tolerance"].met
    assert not found["2 random bodies, one call: end beyond ten times the tolerance"].met
    assert found["2 random bodies, 60 calls: end within the tolerance"].met
    # However fast: who is beyond the error has missed.
    late = some_study()
    late.scenes[0].points[0].error = 0.11
    missed = next(t for t in targets(late) if "Euler" in t.what)
    assert not missed.met
    assert "0.11 px off" in missed.found


def test_the_page_has_what_was_found() -> None:
    page = markdown(report.sections(some_study(), "Interrupted."))
    assert "Interrupted." in page
    assert "(work-precision.png)" in page
    assert "| Symplectic Euler | 0.700 (dt 1 ms) | 0.700 (dt 1 ms) | not reached | speed out of range" in page
    assert "- Missed: study-w1: best other solver at 0.1 px / auto: 20× (target ≥ 30×)" in page
    doubtful = some_study()
    doubtful.scenes[0].doubt = 1e-6
    assert "below the doubt" in markdown(report.sections(doubtful, ""))


def test_the_page_on_performance_has_the_short_tables_of_the_report() -> None:
    root = Path(__file__).parents[2]
    page = (root / "docs" / "study" / "study.md").read_text().partition("## In short")[2].partition("## ")[0]
    tables = [line for line in page.splitlines() if line.startswith("|")]
    assert len(tables) == 2 * (2 + len(study_scenes()))
    performance = (root / "docs" / "performance.md").read_text().splitlines()
    assert [line for line in performance if line in tables] == tables


def test_csv_has_all_digits() -> None:
    rows = list(csv.DictReader(io.StringIO(points_csv(some_study()))))
    assert len(rows) == 6
    assert set(rows[0]) >= {"scene", "integrator", "value", "end_error", "path_error", "seconds", "failure"}
    assert float(rows[1]["end_error"]) == 5e-7
    assert rows[4]["failure"] == "speed out of range"
    bodies = list(csv.DictReader(io.StringIO(report.bodies_csv(some_study()))))
    assert [float(row["error"]) for row in bodies] == [0.05, 2.0]


def test_figures_show_what_nothing_beats() -> None:
    euler = some_study().scenes[0].of(("symplectic_euler",))
    assert [p.value for p in front(euler)] == [1e-3, 5e-4]
    assert [figure.name for figure in study_figures(some_study())] == ["work-precision", "bodies"]
    assert not list(study_figures(Study((1.0,))))


def test_a_small_run_writes_everything(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(command, "repeats", lambda seconds: 1)
    text = io.StringIO()
    console = Console(file=text, width=200)
    status = study([("rope", ROPE)], ("auto", "scipy_lsoda"), (1.0, 0.1), 1, tmp_path / "new", console)
    assert status == 0
    assert "targets met" in text.getvalue()
    assert {path.name for path in (tmp_path / "new").iterdir()} == {
        "study.md", "study.csv.gz", "bodies.csv.gz", "work-precision.png", "bodies.png",
    }  # fmt: skip


def test_what_is_done_is_kept_when_it_is_interrupted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    restart = softrod.SoftrodRun.restart
    calls = []

    def interrupted(self: softrod.SoftrodRun) -> None:
        calls.append(self)
        if len(calls) == 8:
            raise KeyboardInterrupt
        restart(self)

    monkeypatch.setattr(softrod.SoftrodRun, "restart", interrupted)
    text = io.StringIO()
    scenes = [("one", ROPE), ("two", ROPE)]
    assert study(scenes, ("auto",), (1.0, 0.1), 0, tmp_path, Console(file=text, width=120)) == 130
    assert "Interrupted after 0 of 2 scenes" in text.getvalue()
    assert len(read_table(tmp_path / "study.csv.gz")) > 1
    page = (tmp_path / "study.md").read_text()
    assert "Interrupted" in page
    assert "Not complete." in page


# ------------------------------------------------------------------------- the command
@pytest.mark.parametrize(
    ("words", "fragment"),
    [
        (("--errors", "1,nan"), "--errors: 'nan' is not in the range"),
        (("--errors", "0"), "--errors: '0' is not in the range"),
        (("--errors", ""), "--errors: '' is not in the range"),
        (("--integrators", "auto,eulr"), "--integrators: 'eulr' is not one of auto, "),
        (("--random", "-1"), "--random: -1 is not in the range"),
        (("no-such",), "there is no scene called 'no-such'"),
        ((), "the folder cannot be made"),
    ],
)
def test_the_command_refuses_before_it_computes(
    words: tuple[str, ...], fragment: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    refused(softrod_here(capsys, "study", *words, "--out", tmp_path / "no" / "such"), fragment)


def test_lists_are_read() -> None:
    assert parse_errors("0.1, 1,1e-3,1") == (1.0, 0.1, 1e-3)
    assert parse_integrators("rk4, auto,rk4") == ("rk4", "auto")
    assert set(parse_integrators("")) >= {*METHODS, "scipy_rk45", "scipy_lsoda"}
    assert study_scenes()[:5] == [f"study-w{i}" for i in range(1, 6)]
    assert len(study_scenes()) == 8


def test_cvode_that_is_not_installed_is_said_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(solvers, "has_cvode", lambda: False)
    assert not [name for name in parse_integrators("") if name.startswith("cvode")]
    with pytest.raises(InputError, match="uv sync --extra compare"):
        parse_integrators("cvode_bdf")
    assert "CVODE is missing" in markdown(report.sections(Study((1.0,)), ""))


def test_nothing_that_runs_a_page_loads_the_studies_and_what_only_they_need() -> None:
    seen = "print({name for name in sys.modules if name.startswith(('studies', 'matplotlib', 'scipy.int'))})"
    script = f"import sys, app.cli.main, app.server.serve; {seen}"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"
    root = Path(__file__).parents[2]
    for path in (*root.glob("sim/**/*.py"), *root.glob("app/**/*.py")):
        imports = re.findall(r"^ *(?:from|import) studies.*", path.read_text(encoding="utf-8"), re.MULTILINE)
        lazily = (
            ["        from studies.commands import COMMANDS"] if path.parts[-2:] == ("cli", "main.py") else []
        )
        assert imports == lazily, path


def test_the_command_line_has_every_study() -> None:
    assert tuple(COMMANDS) == cli.STUDIES


@pytest.mark.parametrize("name", BENCHES)
def test_every_benchmark_is_where_the_command_looks_for_it(name: str) -> None:
    assert callable(getattr(importlib.import_module(f"studies.bench.{BENCHES[name]}"), f"bench_{name}"))


def test_the_rods_of_the_benchmark_are_alike_but_for_their_path() -> None:
    chain, general = (sim.validate(rod(6, chain)) for chain in (True, False))
    assert build_system(chain).body.chain
    assert not build_system(general).body.chain
    ends = [sim.Simulation(scene, dt=1e-4, integrator="velocity_verlet") for scene in (chain, general)]
    for simulation in ends:
        simulation.step(1000)
    assert np.abs(ends[0].positions - ends[1].positions).max() < 1e-6
    assert np.abs(ends[0].positions - [m.position for m in chain.masses]).max() > 1.0


def test_a_scene_of_one_s_own_is_told_what_to_take() -> None:
    points = [
        point_of("mine", *setting)
        for setting in (
            ("auto", 1.0, 0.4, 1e-3),
            ("auto", 0.01, 0.005, 3e-3),
            ("velocity_verlet", 0.002, 0.03, 1.05e-3),
            ("rk4", 0.001, 0.004, 9e-3),
        )
    ]
    found = Study((1.0, 0.01, 1e-6), [SceneResults("mine", 1e-9, points, True)])
    assert report.advice(found) == [
        "mine, to 1 px: take Auto at 1 px, which ends 0.4 px off; Velocity Verlet at 2 ms is as fast and "
        "ends 0.03 px off.",
        "mine, to 0.01 px: take Auto at 0.01 px, which ends 0.005 px off; Runge-Kutta 4 at 1 ms takes 3 "
        "times as long and ends 0.004 px off.",
        "mine, to 1e-06 px: none of the settings that were tried comes as near.",
    ]
    assert report.summary(found) == ""
    text = markdown(report.sections(found, ""))
    assert "targets met" not in text
    assert "- mine, to 1 px: take Auto at 1 px" in text


def test_a_scene_of_one_s_own_has_no_targets() -> None:
    points = [point_of("mine", name, 0.1, 0.05, 1e-3) for name in ("auto", "scipy_rk45")]
    found = Study((0.1, 1e-6), [SceneResults("mine", 1e-9, points, True)])
    assert not targets(found)
    assert targets(Study((0.1,), [SceneResults("study-mine", 1e-9, points, True)]))


def test_a_step_that_explodes_does_not_end_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    # However long that took.
    monkeypatch.setattr(softrod, "LONGEST", -1.0)
    scene = sim.rope(4, stiffness=20_000.0)
    *_, (results, _) = explore(scene, "rope", ["symplectic_euler"], (1.0,))
    assert results is not None
    *failed, last = results.points
    assert failed
    assert all(point.failure for point in failed)
    assert not last.failure
