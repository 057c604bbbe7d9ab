"""`softrod bench peers`: its scenes, their references, who is compared, and what is measured and written."""

from __future__ import annotations

import importlib.util
import io
import itertools
import math
from collections.abc import Callable
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import msgspec
import numpy as np
import pytest
from rich.console import Console

import sim
from app.cli import main as cli
from studies.bench.heap import heap
from studies.compare import heaps, references
from studies.compare import peers_report as report
from studies.compare.contenders import ENGINES
from studies.compare.engines import c_loop, jax_loops, lanes, softrod
from studies.compare.figures import front, peers_figures
from studies.compare.measure import Contender, Timing, against, ladder, measure
from studies.compare.peers import bench_peers, contenders_of
from studies.compare.runs import SECONDS, SOFTROD, Failed, Floats, Point, Runner, run
from studies.compare.scenes import HEAPS, MANY, PATHS, NamedScene, ropes
from studies.reporting.report import markdown
from tests.amount import NIGHT
from tests.studies.results import read_table


@pytest.mark.parametrize("name", PATHS)
def test_a_reference_is_that_of_its_scene(name: str) -> None:
    found = references.reference(name)
    assert found.shape == (len(PATHS[name].make().masses), 2)
    assert np.isfinite(found).all()


def test_a_reference_is_what_is_computed() -> None:
    assert np.abs(references.compute(PATHS["rope-12"].make()) - references.reference("rope-12")).max() < 1e-8


def test_softrod_agrees_with_the_references() -> None:
    for name, allowed in (("rope-12", 1e-6), ("net-100-soft", 1e-5)):
        exact = sim.Integrator(method="adams", dt=1.0, tolerance=1e-7)
        simulation = sim.Simulation(msgspec.structs.replace(PATHS[name].make(), integrator=exact))
        simulation.step()
        assert np.abs(simulation.positions - references.reference(name)).max() < allowed


def test_another_scene_has_no_reference(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(PATHS, "rope-12", PATHS["rope-100"])
    with pytest.raises(sim.InputError, match="rope-12: its reference is of another scene"):
        references.reference("rope-12")


def test_many_ropes_are_alike_but_for_their_numbers() -> None:
    first, last = ropes(3)[0], ropes(3)[-1]
    assert len(first.masses) == len(last.masses) == 12
    assert first.linear_springs[0].stiffness < last.linear_springs[0].stiffness
    assert first.masses[-1].position != last.masses[-1].position


def test_a_heap_is_judged_by_its_positions() -> None:
    scene = heap(2)
    judge, point = heaps.judge_heap(scene), Point("heap-120", "who", "how", "", 1.0)
    apart = np.array([mass.position for mass in scene.masses])
    judge(point, np.array([apart, apart]))
    assert (point.overlap, point.inside, point.speed) == (0.0, 0, 0.0)
    # One into the other: at the left, up to one spring of the other's.
    into = apart.copy()
    into[12:] += apart[:12].mean(0) - apart[12:].mean(0) + (20.0, 0.0)
    judge(point, np.array([apart] * 3 + [into, into + np.array((0.0, 0.5))]))
    assert 3.0 < point.overlap <= 4.0
    assert 0 < point.inside < 12
    assert point.speed == pytest.approx(0.5 * 60.0)
    with pytest.raises(ArithmeticError, match="ran away"):
        judge(point, np.array([apart, apart + 1e6]))


# ------------------------------------------------------------------------- who is compared
def settings_of(contender: Contender) -> list[float]:
    """All settings, if none of them is exact enough."""
    settings = contender.settings()
    found = [next(settings)]
    try:
        while True:
            found.append(settings.send(Point("", "", "", "", 0.0, seconds=0.0, error=math.inf)))
    except StopIteration:
        return found


@pytest.mark.parametrize("name", [name for name, engine in ENGINES.items() if engine.paths])
def test_who_is_compared_comes_near_the_reference(name: str) -> None:
    engine = ENGINES[name]
    if lacking := engine.missing():
        assert name not in ("softrod", "SciPy", "C loop"), lacking
        pytest.skip(lacking)
    if name in ("JAX", "diffrax") and not NIGHT:
        pytest.skip("XLA compiles for long")
    right = references.reference("rope-12")
    for contender in contenders_of(engine, "rope-12"):
        if not any(word in contender.method for word in ("pins", "rigid")):  # these are another rope
            runner = contender.make(settings_of(contender)[:6][-1])
            for _ in range(2):
                runner.restart()
                runner.advance()
                assert np.hypot(*(runner.positions() - right).T).max() < 3.0, contender.method


@pytest.mark.parametrize("name", ["softrod", "Box2D", "Chipmunk"])
def test_who_has_contact_makes_heaps_of_the_same_rings(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if lacking := ENGINES[name].missing():
        pytest.skip(lacking)
    small = heap(2)
    monkeypatch.setitem(HEAPS, "heap-120", NamedScene("heap-120", "Small heap", lambda: small))
    for contender in contenders_of(ENGINES[name], "heap-120"):
        runner = contender.make(settings_of(contender)[-1])
        runner.restart()
        at = np.array([mass.position for mass in small.masses])
        assert runner.positions() == pytest.approx(at, abs=0.02)
        for _ in range(60):
            runner.advance()
        fallen = runner.positions()
        assert fallen[:, 1].mean() > at[:, 1].mean() + 3.0
        assert fallen[:, 1].max() < 3.0


def test_many_ropes_move_alike_however_they_are_computed() -> None:
    all_ropes = lanes.Lanes(ropes(lanes.LANES))
    ends: dict[str, Floats] = {}
    for what, runner in {
        "one by one": lanes.OneByOne(all_ropes, 1920.0),
        "eights": lanes.Eights(all_ropes, 1920.0, True),
        "eights, Euler": lanes.Eights(all_ropes, 7680.0, False),
        "array": lanes.AllInOne(all_ropes, 960.0),
    }.items():
        runner.restart()
        runner.advance()
        ends[what] = runner.end
    assert np.abs(ends["eights"] - ends["one by one"]).max() < 1e-6
    assert 1e-3 < np.abs(ends["eights, Euler"] - ends["one by one"]).max() < 0.2
    assert np.abs(ends["array"] - ends["one by one"]).max() < 0.2
    simulation = sim.Simulation(ropes(lanes.LANES)[5])
    simulation.advance(SECONDS)
    assert np.abs(ends["array"][5] - simulation.positions).max() < 0.2


class Late:
    """What a compiled function of JAX returns before it has computed."""

    def __init__(self, value: Floats) -> None:
        self._value, self.waited = value, 0

    def block_until_ready(self) -> Late:
        self.waited += 1
        return self

    def __array__(self, *_: object, **__: object) -> Floats:
        return self._value


@pytest.mark.parametrize(
    ("module", "contenders", "shape"),
    [
        (jax_loops, lambda: jax_loops.jax_paths(PATHS["rope-12"].make()), (12, 2)),
        (lanes, lambda: lanes.by_jax(ropes(lanes.LANES)), (2, 12, lanes.LANES)),
    ],
    ids=["a rope", "many ropes"],
)
def test_what_is_timed_of_jax_is_the_computing(
    module: ModuleType, contenders: Callable[[], list[Contender]], shape: tuple[int, ...],
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    late = Late(np.zeros(shape))
    jax = SimpleNamespace(jit=lambda _: lambda *_: late, numpy=np)
    monkeypatch.setattr(module, "jax_in_double", lambda: jax)
    for contender in contenders():
        runner = contender.make(next(contender.settings()))
        runner.restart()
        before = late.waited
        runner.advance()
        assert late.waited == before + 1, contender.method


# ------------------------------------------------------------------------- measuring
class Pretended(Runner):
    """Ends so far off as its setting says; cannot do settings below 1."""

    def __init__(self, right: Floats, value: float) -> None:
        self._right, self._value = right, value

    def advance(self) -> None:
        if self._value < 1.0:
            raise Failed("two\nlines")

    def positions(self) -> Floats:
        return self._right + np.array((self._value, 0.0))


def pretended(values: tuple[float, ...]) -> list[Point]:
    right = np.zeros((3, 2))
    who = Contender("who", "how", ladder(values), lambda v: f"at {v:g}", lambda v: Pretended(right, v))
    *_, (points, _) = measure("rope-12", [who], against(right[None]), Timing(lambda point: 3))
    return points


def test_the_loop_in_c_leaves_the_arithmetic_of_others_alone() -> None:
    c_loop.library()
    least = np.finfo(float).tiny
    assert 0.5 * least > 0.0


def test_what_one_clock_does_not_see_another_does() -> None:
    """Processor time lags behind what another thread computes, and wall time does not count two threads."""

    def clock(rate: float) -> Callable[[], float]:
        return lambda: rate * next(ticks)

    runner = Pretended(np.zeros((3, 2)), 1.0)
    for rates in ((0.1, 2.0), (2.0, 0.1)):
        ticks = itertools.count()
        seconds = run(runner, [clock(rate) for rate in rates]).seconds
        assert seconds == pytest.approx(2.0 * 2.0)  # two readings later, by the faster one


def test_settings_are_tried_and_timed_again() -> None:
    points = pretended((100.0, 2.0, 0.5))
    assert [p.error for p in points] == [100.0, 2.0, math.inf]
    assert [p.runs for p in points] == [3, 3, 0]
    assert [p.failure for p in points] == ["", "", "two lines"]
    assert points[0].setting == "at 100"


def test_settings_finer_than_fine_are_not_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("studies.compare.measure.FINE", 5.0)
    assert len(pretended((100.0, 2.0, 1.0))) == 2


# ------------------------------------------------------------------------- the report
def some_points() -> list[Point]:
    def point(scene: str, engine: str, method: str, value: float, ms: float, **found: float) -> Point:
        made = Point(scene, engine, method, f"at {value:g}", value, 1e-3 * ms, runs=1)
        for key, number in found.items():
            setattr(made, key, number)
        return made

    return [
        *(
            point("rope-12", SOFTROD, "auto", error, 0.1 / error, error=2.0 * error)
            for error in report.ERRORS
        ),
        point("rope-12", SOFTROD, "velocity_verlet", 500.0, 0.5, error=0.05),
        point("rope-12", "Box2D", "springs", 960.0, 3.0, error=0.5),
        point("rope-12", "Box2D", "springs", 480.0, 4.0, error=0.7),
        point("heap-120", "Box2D", "rigid welds", 240.0, 5.0, overlap=0.5, inside=3.0, speed=0.25),
        point(MANY, "NumPy", "all", 240.0, 120.0, error=0.04),
    ]


def test_the_report_says_who_is_how_fast_within_an_error() -> None:
    page = markdown(report.sections(some_points(), ["Box2D is missing."], "Interrupted."))
    for text in (
        "Box2D is missing.", "Interrupted.", "(ropes.png)",
        "| Rope of 12 masses | 1.00 (0.2) | 0.500 | – |",
        "| Box2D | 3.00 (springs, at 960) | 3.00 (springs, at 960) | not reached | not reached |",
        "| softrod's best | 0.500 (Velocity Verlet, at 500) |",
        "| Box2D | rigid welds | at 240 | 5.00 | 0.50 | 3 | 0.2 |",
        "| NumPy | all | at 240 | 120 | 0.04 |",
    ):  # fmt: skip
        assert text in page


def test_figures_show_every_group_and_what_nothing_beats() -> None:
    assert [figure.name for figure in peers_figures(some_points())] == ["ropes", MANY, "heaps"]
    of_box2d = [p for p in some_points() if p.engine == "Box2D" and p.scene == "rope-12"]
    assert [p.value for p in front(of_box2d)] == [960.0]


def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let softrod try few settings."""
    monkeypatch.setattr(softrod, "TOLERANCES", (1.0, 0.1))
    monkeypatch.setattr(softrod, "BEYOND", (1.5,))
    monkeypatch.setattr(softrod, "UNLIMITED_RATES", (240.0,))


def test_who_is_missing_is_named_and_the_others_are_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    few(monkeypatch)
    there = importlib.util.find_spec

    def none_of_the_extra(name: str) -> Any:
        absent = ("pyb2d3", "pymunk", "mujoco", "jax", "diffrax", "sksundae")
        return None if name in absent else there(name)

    monkeypatch.setattr(importlib.util, "find_spec", none_of_the_extra)
    text, asked = io.StringIO(), "softrod,Box2D,Chipmunk,MuJoCo,JAX,diffrax,CVODE"
    console = Console(file=text, width=200)
    assert bench_peers("rope-12", asked, False, 1, tmp_path, console) == 0
    said = text.getvalue()
    for sentence in (
        "Box2D is missing: pyb2d3 is not installed", "Chipmunk is missing: pymunk is not installed",
        "MuJoCo is missing: mujoco is not installed", "JAX is missing: jax is not installed",
        "diffrax is missing: jax and diffrax are not installed",
        "CVODE is missing: scikit-sundae is not installed",
    ):  # fmt: skip
        assert f"{sentence} (`uv sync --extra peers`)." in said
        assert sentence in (tmp_path / "peers.md").read_text()
    rows = read_table(tmp_path / "peers.csv.gz")
    assert {row["engine"] for row in rows} == {"softrod"}
    assert all(math.isfinite(float(row["error"])) for row in rows if not row["failure"])
    assert (tmp_path / "ropes.png").exists()


def test_what_is_done_is_kept_when_it_is_interrupted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    few(monkeypatch)

    def interrupted(name: str) -> Floats:
        raise KeyboardInterrupt

    monkeypatch.setattr("studies.compare.peers.reference", interrupted)
    console = Console(file=io.StringIO())
    assert bench_peers("rope-12", "softrod", False, 1, tmp_path, console) == 130
    assert "Interrupted after 0 of 1 scenes." in (tmp_path / "peers.md").read_text()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("peers", "--scenes", "rope-13"), "--scenes: 'rope-13' is not one of rope-12,"),
        (("peers", "--engines", "box2d"), "--engines: 'box2d' is not one of softrod,"),
        (("kernels", "--quick"), "--scenes, --engines, --quick and --out belong to softrod bench peers"),
    ],
)
def test_what_makes_no_sense_is_refused(
    words: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        cli.main(["bench", *words])
    assert ended.value.code != 0
    assert said in capsys.readouterr().err
