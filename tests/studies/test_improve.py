"""`softrod improve`: goals, ranges, the search, and what it leaves in its folder."""

from __future__ import annotations

import math
import re
from pathlib import Path

import msgspec
import numpy as np
import pytest

import sim
from sim.errors import InputError
from sim.scene.lesson import Goal as LessonGoal
from sim.scene.lesson import Lesson, Step
from sim.store.files import encode_scene
from studies.improve.goals import GoalMeter, parse_goal
from studies.improve.improve import OptimizationProblem, SearchResult
from studies.improve.ranges import Range
from studies.improve.search import Search
from studies.improve.trials import trial
from tests.amount import NIGHT
from tests.app.command import refused, softrod_here
from tests.sim.builders import spinning
from tests.studies.improving import SWINGS, improved, problem_of, rows_by_number


@pytest.fixture(autouse=True)
def undrawn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out the figure, which takes longer than a search does."""
    monkeypatch.setattr("studies.improve.improve.draw", lambda *_: None)


def values_of(scene: sim.Scene, goal: str, duration: float = 4.0, settings: tuple[str, ...] = ()) -> tuple:
    """Result, score and end of one run."""
    found, scene = parse_goal(goal, scene)
    return trial(encode_scene(scene), settings, duration, found).values


@pytest.mark.parametrize(("goal", "looks"), [("max mass1.x", 0), ("max mean mass1.x", 61)])
def test_nobody_looks_in_between_where_only_the_end_counts(
    goal: str, looks: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[float] = []
    look = GoalMeter.look
    monkeypatch.setattr(GoalMeter, "look", lambda meter: (seen.append(0.0), look(meter)))
    found, scene = parse_goal(goal, sim.load_scene("pendulum"))
    scene = sim.set_value(scene, "dt", 1e-3)
    result, _, ended = trial(encode_scene(scene), (), 0.48, found).values
    assert isinstance(result, float) and ended == ""
    assert len(seen) == looks


def best_of(found: SearchResult) -> tuple[float, float]:
    """The first setting and the result of the best run."""
    best = found.best
    assert best is not None and best.result is not None
    return float(best.point[0]), best.result


# ------------------------------------------------------------------------- known optima
def test_the_damping_with_which_a_mass_is_calm_soonest_is_found(tmp_path: Path) -> None:
    """It is the one whose first overshoot just stays in the range: exp(-pi z / sqrt(1 - z²)) is the part of
    the first displacement that counts as calm."""
    part = 0.05
    logarithm = -math.log(part)
    best = 20.0 * logarithm / math.hypot(math.pi, logarithm)
    goal = "reach 99.5..100.5 mass1.x for 2"
    _, _, _, found = improved(tmp_path, problem_of(SWINGS, ("linear_damping=5..50",), goal, 3.0, 80))
    damping, moment = best_of(found)
    assert damping == pytest.approx(best, rel=0.01)
    # When displaced by x0 and let go: x = x0 exp(-g t) (cos w t + g / w sin w t).
    g, w = 0.5 * damping, math.sqrt(100.0 - 0.25 * damping**2)
    at = math.exp(-g * moment) * (math.cos(w * moment) + g / w * math.sin(w * moment))
    assert at == pytest.approx(part, abs=2e-3)
    start = found.trials[0]
    assert start.result is None and start.score is not None and start.score > moment


def test_the_damping_with_the_least_mean_energy_is_found(tmp_path: Path) -> None:
    """The integral of the energy is (1 + 2 z²) / (2 z w) times the first, least for z = 1 / sqrt(2)."""
    problem = problem_of(SWINGS, ("linear_damping=2..60",), "min mean energy.total")
    status, _, text, found = improved(tmp_path, problem)
    damping, mean = best_of(found)
    assert status == 0
    assert damping == pytest.approx(20.0 / math.sqrt(2.0), rel=0.01)
    assert mean == pytest.approx(5000.0 * 2.0 / (2.0 * math.sqrt(0.5) * 10.0) / 4.0, rel=0.01)
    assert f"mean of energy.total: {mean:.6g} kg px²/s²; " in text


def test_the_length_of_a_pendulum_for_a_period_is_found(tmp_path: Path) -> None:
    pendulum = msgspec.structs.replace(
        SWINGS,
        masses=(SWINGS.masses[0], sim.Mass(position=(4.0, 100.0), mass=1.0)),
        linear_springs=(sim.LinearSpring(a=0, b=1, stiffness=1e4, damping=100.0, rest_length=100.0),),
        gravity=(0.0, 1000.0),
    )
    problem = problem_of(pendulum, ("rest_length_scale=0.3..3",), "near 2.5 period mass1.x", 10.0)
    _, _, _, found = improved(tmp_path, problem)
    scale, period = best_of(found)
    length = 100.0 * scale + 1000.0 / 1e4  # drawn out by its weight
    assert period == pytest.approx(2.5, rel=2e-3)
    assert length == pytest.approx(1000.0 * (2.5 / (2.0 * math.pi)) ** 2, rel=5e-3)


def test_a_search_of_several_settings_leaves_a_local_optimum() -> None:
    """Rastrigin's function has one at every tenth of the square, the least at its centre."""
    search, best = Search((0.93, 0.08), 6, 3), math.inf
    for _ in range(250):
        places = 10.0 * (np.array(search.ask()) - 0.5)
        scores = 20.0 + (places**2 - 10.0 * np.cos(2.0 * math.pi * places)).sum(1)
        search.tell(scores.tolist())
        best = min(best, float(scores.min()))
        assert np.abs(places).max() <= 5.0
    assert best < 1e-3


@pytest.mark.skipif(not NIGHT, reason="200 runs of 10 s, by night")
def test_200_runs_more_than_double_the_way_of_the_walker(tmp_path: Path) -> None:
    walker = sim.load_scene("walker")
    ranges = "stride=0.05..0.4", "legs=40..150", "wall_friction=0.2..2"
    _, _, _, found = improved(tmp_path, problem_of(walker, ranges, "max mass0.x", 10.0, 200))
    first, best = found.trials[0].result, best_of(found)[1]
    assert first is not None
    start = walker.masses[0].position[0]
    assert best - start > 2.0 * (first - start)


def test_whole_numbers_are_computed_once(tmp_path: Path) -> None:
    rope = sim.rope(5, 40.0, integrator=sim.Integrator(method="rk4", dt=1e-3), gravity=(0.0, 1000.0))
    problem = problem_of(rope, ("masses=3..8",), "max largest spring0.length", 0.2, 40)
    _, here, _, found = improved(tmp_path, problem)
    assert len(found.trials) == 40
    assert here.asked.count("trial") <= 12
    assert {float(each.point[0]) for each in found.trials.values()} <= {3.0, 4.0, 5.0, 6.0, 7.0, 8.0}
    assert found.scene is not None and len(found.scene.masses) == best_of(found)[0]


# ------------------------------------------------------------------------- goals
@pytest.mark.parametrize(
    ("goal", "read"),
    [
        ("max mass1.x", lambda time, x: x[-1]),
        ("min mean mass1.x", lambda time, x: np.trapezoid(x, time) / time[-1]),
        ("max largest mass1.x", lambda time, x: x.max()),
        ("max smallest mass1.x", lambda time, x: x.min()),
        ("near 90 smallest mass1.x", lambda time, x: x.min()),
        ("max mass1.x - mass0.x", lambda time, x: x[-1]),
        ("min mean (mass1.x - mass0.x)", lambda time, x: np.trapezoid(x, time) / time[-1]),
        ("max smallest abs (mass1.x)", lambda time, x: x.min()),
        ("near 1 period mass1.x", lambda time, x: 2.0 * math.pi / math.sqrt(100.0 - 0.25)),
    ],
)
def test_results_are_what_a_recording_says(goal: str, read) -> None:
    result, score, ended = values_of(SWINGS, goal)
    recording = sim.Simulation(SWINGS).record(4.0, "mass1.x")
    expected = float(read(recording.time, recording["mass1.x"]))
    assert result == pytest.approx(expected, rel=1e-4 if "period" in goal else 1e-12)
    target = float(goal.split()[1]) if goal.startswith("near") else 0.0
    sizes = {"max": -result, "min": result, "nea": abs(result - target)}
    assert (score, ended) == (sizes[goal[:3]], "")


@pytest.mark.parametrize(("of", "right"), [("", 573.0), ("mean ", 286.5), ("largest ", 573.0)])
def test_an_angle_goes_on_beyond_half_a_turn(of: str, right: float) -> None:
    goal, scene = parse_goal(f"max {of}spring0.direction", spinning(5.0))
    simulation = sim.Simulation(scene)
    meter = GoalMeter(goal, simulation)
    for _ in range(120):
        meter.look()
        simulation.step(80)
    meter.look()
    assert not meter.needs_end_only
    assert meter.result()[0] == pytest.approx(right, rel=5e-3)


def test_a_range_that_is_not_reached_is_the_worse_the_farther_it_is() -> None:
    goals = ("..90.5 mass1.x for 0.1", "..90.5 mass1.x for 1", "..89 mass1.x for 1", "..50 mass1.x for 1")
    found = [values_of(SWINGS, f"reach {goal}") for goal in goals]
    assert all(result is None and ended == "" for result, _, ended in found)
    scores = [score for _, score, _ in found]
    assert scores == sorted(scores) and len(set(scores)) == 4
    soon, _, _ = values_of(SWINGS, "reach ..100 mass1.x")
    w = math.sqrt(100.0 - 0.25)
    assert soon == pytest.approx((math.pi - math.atan2(w, 0.5)) / w, abs=1e-4)
    assert values_of(SWINGS, "reach 100.. mass1.x")[0] == 0.0


def test_the_goal_of_a_lesson_is_one() -> None:
    goal = LessonGoal(quantity="mass1.x", high=100.5, low=99.5, seconds=1.0)
    swing = LessonGoal(quantity="mass1.x", of="period", low=0.6, high=0.65)
    steps = (
        Step(title="one", do="Look.", settings=("linear_damping=14",)),
        Step(title="two", do="Look.", goal=goal),
        Step(title="three", do="Look.", goal=swing, settings=("linear_damping=0.5",)),
    )
    scene = msgspec.structs.replace(SWINGS, lesson=Lesson(steps=steps))
    calm = values_of(scene, "step 2", settings=())
    assert calm == values_of(SWINGS, "reach 99.5..100.5 mass1.x for 1", settings=("linear_damping=14",))
    result, _, _ = values_of(scene, "step 3")
    assert isinstance(result, float) and 1.0 < result < 3.0  # a period is known after two cycles
    for text, sentence in (
        ("step 1", "has no goal"),
        ("step 4", "are 1..3"),
        ("step x", "no such step"),
    ):
        with pytest.raises(InputError, match=f"--goal {text}: .*{sentence}"):
            parse_goal(text, scene)


@pytest.mark.parametrize(
    ("settings", "ended"),
    [
        (("method=symplectic_euler", "dt=0.5", "linear_stiffness=1e4"), "ran away"),
        (("strength=500",), "broke"),
        ((), "no reading"),
    ],
)
def test_what_runs_away_or_breaks_counts_as_worst(settings: tuple[str, ...], ended: str) -> None:
    weak = msgspec.structs.replace(SWINGS.linear_springs[0], strength=1e6)
    scene = msgspec.structs.replace(SWINGS, linear_springs=(weak,)) if ended == "broke" else SWINGS
    goal = "near 1 period mass1.y" if ended == "no reading" else "max mass1.x"
    assert values_of(scene, goal, settings=settings) == (None, None, ended)


def test_a_search_goes_round_what_counts_as_worst_and_says_so(tmp_path: Path) -> None:
    weak = msgspec.structs.replace(SWINGS.linear_springs[0], strength=1200.0)
    scene = msgspec.structs.replace(SWINGS, linear_springs=(weak,))
    # It is drawn out by 10 px: with more than 120 kg/s² the spring breaks at once.
    problem = problem_of(scene, ("linear_stiffness=20..2000",), "min period mass1.x", runs=80)
    status, _, text, found = improved(tmp_path, problem)
    stiffness, _ = best_of(found)
    broken = [each for each in found.trials.values() if each.ended == "broke"]
    assert status == 0 and broken
    assert all(float(each.point[0]) > 119.0 for each in broken)
    assert stiffness == pytest.approx(120.0, rel=0.01)
    assert f"Of 80 runs these count as worst: {len(broken)} broke" in text


def test_a_range_that_no_run_reaches_is_come_near_to(tmp_path: Path) -> None:
    problem = problem_of(SWINGS, ("linear_damping=2..100",), "reach ..50 mass1.x", 1.0, 20)
    status, _, text, found = improved(tmp_path, problem)
    assert found.best is not None
    assert (status, found.best.result) == (0, None)
    assert "mass1.x stays in its range: not reached in any run, and this is the nearest" in text
    # The less it is damped, the nearer it swings.
    assert found.best.point[0] == min((each.point[0] for n, each in found.trials.items() if n), key=float)


def test_without_any_result_it_says_so(tmp_path: Path) -> None:
    problem = problem_of(SWINGS, ("linear_damping=1..10",), "min period mass1.y", 0.2, 10)
    status, _, text, found = improved(tmp_path, problem)
    assert (status, found.best) == (1, None)
    assert "10 no reading" in text and "No run came to a result" in text
    assert not (tmp_path / "best.json").exists()


# ------------------------------------------------------------------------- ranges
def test_ranges_are_searched_by_ratios_where_both_ends_are_above_0() -> None:
    ratios, differences = Range("a", 1e3, 1e5), Range("a", -10.0, 30.0)
    assert [ratios.at(0.0), float(ratios.at(0.5)), ratios.at(1.0)] == ["1000", pytest.approx(1e4), "100000"]
    assert [differences.at(0.0), differences.at(0.5), differences.at(1.0)] == ["-10", "10", "30"]
    for each in (ratios, differences):
        assert each.place(float(each.at(0.3))) == pytest.approx(0.3)
        assert each.place(1e6) is None
    assert Range("a", 3.0, 12.0, integer=True).at(0.5) == "6"


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ((), "--vary: name at least one setting"),
        (("--vary", "linear_damping"), "--vary linear_damping: KEY=A..B is expected"),
        (("--vary", "linear_damping=1..2:3"), "from 1 to 2:3 are not two finite numbers"),
        (("--vary", "linear_damping=nan..2"), "from nan to 2 are not two finite numbers"),
        (("--vary", "linear_damping=2..1"), "2 is not below 1"),
        (("--vary", "gravity=0..1e9"), "--vary gravity: 1e+09 is not in the range -1e+06..1e+06 px/s²"),
        (("--vary", "weight=1..2"), "--vary weight: there is no such setting"),
        (("--vary", "method=auto..rk4"), "method is a name and has no range; softrod sweep compares"),
        (("--vary", "masses=3..4.5"), "--vary masses: 4.5 is not a whole number"),
        (("--vary", "gravity=0..1", "--vary", "gravity=0..1"), "--vary gravity: it is varied twice"),
        (("--vary", "gravity=0..1", "--set", "gravity=1"), "--set gravity: it is varied as well"),
        (("--goal", "most mass1.x"), '--goal most mass1.x: "max QUANTITY", "min QUANTITY"'),
        (("--goal", "max mass99.x"), "--goal max mass99.x: mass99.x: mass 99 does not exist (0..1"),
        (("--goal", "max mean"), "--goal max mean: 'mean' is not a quantity"),
        (("--goal", "max sum mass1.x"), '--goal max sum mass1.x: "max QUANTITY"'),
        (("--goal", "near mass1.x"), "--goal near mass1.x: 'mass1.x' is not a finite number"),
        (("--goal", "near inf mass1.x"), "'inf' is not a finite number"),
        (("--goal", "reach 1 mass1.x"), "LOW..HIGH, LOW.. or ..HIGH is expected after reach"),
        (("--goal", "reach 2..1 mass1.x"), "2 is above 1"),
        (("--goal", "reach 1..2 mean mass1.x"), '"max QUANTITY"'),
        (("--goal", "reach 1..2 mass1.x for 11"), "a run has only 10 s; --for says how many"),
        (("--goal", "reach 1..2 mass1.x for nan"), "'nan' is not a finite number"),
        (
            ("--goal", "step 1"),
            "there is no such step; the scene 'tutorial-3.3' has no lesson",
        ),
        (("--for", "nan"), "--for: nan is not in the range 0.001..10000 s"),
        (("--runs", "5"), "--runs: 5 is not in the range 10..100000"),
        (("--population", "1"), "--population: 1 is not in the range 4..1000"),
        (("--seed", "-1"), "--seed: -1 is not in the range 0..4294967295"),
        (("--cluster", "x", "--jobs", "2"), "--jobs: how many compute"),
    ],
)
def test_the_command_refuses_before_it_computes(
    words: tuple[str, ...], sentence: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    vary = () if not words or "--vary" in words else ("--vary", "gravity=0..1")
    goal = () if "--goal" in words else ("--goal", "max mass1.x")
    refused(
        softrod_here(capsys, "improve", "tutorial-3.3", *vary, *goal, *words, "--out", tmp_path / "out"),
        sentence,
    )
    assert not (tmp_path / "out").exists()


# ------------------------------------------------------------------------- its folder
@pytest.fixture
def problem() -> OptimizationProblem:
    return problem_of(
        SWINGS, ("linear_damping=2..60", "linear_stiffness=50..150"), "min mean energy.total", 1.0, 40
    )


def test_the_best_is_there_as_a_file_and_as_a_link(
    tmp_path: Path, problem: OptimizationProblem, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.undo()
    _, _, text, found = improved(tmp_path, problem)
    assert found.best is not None
    link = (tmp_path / "link.txt").read_text().strip()
    assert link in text
    for name in (tmp_path / "best.json", link):
        scene = sim.load_scene(str(name))
        result = trial(encode_scene(scene), (), problem.duration, problem.goal).values[0]
        assert (scene, result) == (found.scene, found.best.result)
    assert min(each.score for each in found.trials.values() if each.score) == found.best.score
    lines = (tmp_path / "table.csv").read_text().splitlines()
    assert lines[0] == (
        "run,linear_damping [kg/s],linear_stiffness [kg/s²],mean of energy.total [kg px²/s²],counts as worst"
    )
    assert len(lines) == 41
    assert lines[1].startswith("0,1,100,")
    assert (tmp_path / "progress.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("after", [0, 17])
def test_after_an_interruption_it_goes_on_as_if_there_had_been_none(
    tmp_path: Path, problem: OptimizationProblem, after: int
) -> None:
    improved(tmp_path / "whole", problem)
    status, here, text, _ = improved(tmp_path / "out", problem, interrupt_at=after)
    assert (status, here.asked.count("trial")) == (130, after)
    assert "Interrupted" in text and "Traceback" not in text
    status, here, _, _ = improved(tmp_path / "out", problem)
    # What was submitted before Ctrl-C and not yet taken back is done again.
    done = len(rows_by_number(tmp_path / "whole"))
    assert status == 0 and here.asked.count("trial") <= done
    assert rows_by_number(tmp_path / "out") == rows_by_number(tmp_path / "whole")
    for name in ("table.csv", "best.json", "link.txt"):
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()
    _, here, _, _ = improved(tmp_path / "out", problem)
    assert here.asked == []


def test_a_torn_line_is_done_again_and_more_runs_follow(tmp_path: Path, problem: OptimizationProblem) -> None:
    improved(tmp_path / "whole", problem)
    fewer = OptimizationProblem(**{**vars(problem), "runs": 15})
    improved(tmp_path / "out", fewer)
    path = tmp_path / "out" / "improve.jsonl"
    path.write_bytes(path.read_bytes()[:-9])
    _, here, _, _ = improved(tmp_path / "out", problem)
    assert here.asked.count("trial") == 26
    assert rows_by_number(tmp_path / "out") == rows_by_number(tmp_path / "whole")
    # Fewer again: what is there stays, and the best is that of these.
    _, here, _, found = improved(tmp_path / "out", fewer)
    assert (here.asked, len(found.trials), len(rows_by_number(tmp_path / "out"))) == ([], 15, 40)


def test_another_search_is_refused(tmp_path: Path, problem: OptimizationProblem) -> None:
    fewer = OptimizationProblem(**{**vars(problem), "runs": 10})
    improved(tmp_path, fewer)
    before = (tmp_path / "improve.jsonl").read_bytes()
    goal = parse_goal("max mass1.x", SWINGS)[0]
    for change, option in (({"seed": 2}, "--seed"), ({"goal": goal}, "--goal"), ({"duration": 2.0}, "--for")):
        with pytest.raises(InputError, match=f"the search that is there has another {option}; give the same"):
            improved(tmp_path, OptimizationProblem(**{**vars(fewer), **change}))
    assert (tmp_path / "improve.jsonl").read_bytes() == before


def test_a_run_of_another_place_is_refused(tmp_path: Path, problem: OptimizationProblem) -> None:
    """As by another release of the search, whose next places would be of no use."""
    improved(tmp_path, problem)
    path = tmp_path / "improve.jsonl"
    lines = path.read_text().splitlines(keepends=True)
    damping = rows_by_number(tmp_path)[7][0]
    path.write_text("".join(line.replace(f'"{damping}"', '"7.5"') for line in lines))
    with pytest.raises(InputError, match=r"run 7 has other settings than this search asks for, since it was"):
        improved(tmp_path, problem)


def test_another_seed_goes_another_way(tmp_path: Path, problem: OptimizationProblem) -> None:
    improved(tmp_path / "one", problem)
    improved(tmp_path / "two", OptimizationProblem(**{**vars(problem), "seed": 2}))
    one, two = rows_by_number(tmp_path / "one"), rows_by_number(tmp_path / "two")
    assert one[0] == two[0] and one[1] != two[1]


@pytest.mark.parametrize(
    ("goal", "said"),
    [
        ("mxa energy.kinetic", "'mxa' is none of max, min, near, reach, step (did you mean 'max'?)"),
        (
            "min smalest energy.kinetic",
            "'smalest' is none of mean, largest, smallest, period (did you mean 'smallest'?)",
        ),
        ("energy.kinetic", '"max QUANTITY", "min QUANTITY"'),
    ],
)
def test_a_word_that_is_misspelt_is_named_with_what_is_like_it(goal: str, said: str) -> None:
    with pytest.raises(InputError, match=re.escape(said)):
        parse_goal(goal, sim.load_scene("rope"))
