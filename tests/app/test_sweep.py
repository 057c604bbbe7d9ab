"""`softrod sweep`: what is varied, what is measured, the loop, and the files."""

from __future__ import annotations

import concurrent.futures
import csv
import io
import math
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import msgspec
import numpy as np
import pytest
from rich.console import Console

import sim
from app.sweep.folder import Folder, Line, make_plan
from app.sweep.grid import make_grid, parse_axis
from app.sweep.measures import MEASURES, parse_measures, period
from app.sweep.plot import COLOURS, plot
from app.sweep.runs import Row, reference_of, run, run_reference
from app.sweep.sweep import sweep
from app.sweep.workers import Workers
from sim.errors import InputError
from sim.scene.files import encode_scene

ROPE = sim.rope(
    5,
    100.0,
    direction=(1.0, 0.5),
    driven=None,
    damping=10.0,
    integrator=sim.Integrator(method="rk4", dt=1e-3),
)

GRID = (
    *("--set", "method=rk4", "--set", "dt=2e-5", "--set", "masses=8"),
    *("--vary", "gravity=200..2000:4", "--vary", "rest_angle=-20,0,20,30,40,50"),
    *("--measure", "sag", "--measure", "energy_residual", "--measure", "stretch", "--measure", "error"),
    *("--duration", "1"),
)
"""A sweep of 24 runs that takes so long that one can get in between."""

PATIENCE = 300.0
"""Seconds after which a process that should have done something has failed, however busy the machine is."""


def command(out: Path, *more: str) -> list[str]:
    return [sys.executable, "-m", "app", "sweep", "tutorial-3.3", *GRID, *more, "--out", str(out)]


def rows_of(out: Path) -> list[dict[str, str]]:
    with (out / "table.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def numbers_of(out: Path) -> list[int]:
    """The numbers of the runs that are kept, in the order in which they were."""
    lines = (out / "sweep.jsonl").read_bytes().splitlines()[1:]
    return [msgspec.json.decode(line, type=Line).run for line in lines]


def wait_for_rows(out: Path, count: int, process: subprocess.Popen[str]) -> None:
    """Wait until so many runs are done, while others are not."""
    path, patience = out / "sweep.jsonl", time.monotonic() + PATIENCE
    while not path.exists() or path.read_bytes().count(b"\n") <= count:
        assert process.poll() is None, "it ended before anything could be done to it"
        assert time.monotonic() < patience
        time.sleep(0.005)


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


class Here(concurrent.futures.Executor):
    """Computes in this process, and notes what it was asked for."""

    def __init__(self, interrupt_at: int | None = None) -> None:
        self.asked: list[str] = []
        self._interrupt_at = interrupt_at

    def submit(self, call, /, *arguments, **named):
        if call is run and self.asked.count("run") == self._interrupt_at:
            raise KeyboardInterrupt
        self.asked.append(call.__name__)
        future = concurrent.futures.Future()
        try:
            future.set_result(call(*arguments, **named))
        except Exception as error:
            future.set_exception(error)
        return future

    @contextmanager
    def __call__(self) -> Iterator[Workers]:
        yield Workers(self)


def swept(
    out: Path,
    scene: sim.Scene,
    vary: Sequence[str],
    measures: Sequence[str],
    duration: float = 0.2,
    **options,
) -> tuple[int, Here, str]:
    """The exit status of a sweep in this process, what was asked for, and what was printed."""
    here, text = Here(options.pop("interrupt_at", None)), io.StringIO()
    grid = make_grid(scene, options.pop("settings", ()), vary)
    status = sweep(grid, parse_measures(measures), duration, here, out, Console(file=text, width=200))
    return status, here, text.getvalue()


# ------------------------------------------------------------------------- what is varied
@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("gravity=0..2000:5", ("0", "500", "1000", "1500", "2000")),
        ("gravity=1..-1:3", ("1", "0", "-1")),
        ("dt=1e-4..1e-2:3:log", ("0.0001", "0.001", "0.01")),
        ("method=auto, rk4", ("auto", "rk4")),
        ("tolerance=1e-3,0.1", ("0.001", "0.1")),
        ("x=0.1..0.3:2", ("0.1", "0.3")),
    ],
)
def test_values_are_read(text: str, values: tuple[str, ...]) -> None:
    axis = parse_axis(text)
    if axis.logarithmic:
        assert [float(v) for v in axis.values] == pytest.approx([float(v) for v in values], rel=1e-15)
    else:
        assert axis.values == values
    assert axis.logarithmic == text.endswith(":log")


def test_ends_and_values_are_exact() -> None:
    numbers = parse_axis("dt=0.0003..0.007:7:log").numbers
    assert numbers is not None
    assert (numbers[0], numbers[-1]) == (0.0003, 0.007)
    ratios = np.diff(np.log(numbers))
    assert np.ptp(ratios) < 1e-12


@pytest.mark.parametrize(
    ("words", "fragment"),
    [
        ((), "--vary: name at least one setting"),
        (("--vary", "gravity"), "--vary gravity: KEY=A..B:N,"),
        (("--vary", "gravity=0..1"), "--vary gravity=0..1: KEY=A..B:N,"),
        (("--vary", "gravity=0..1:3:lin"), "KEY=A..B:N:log"),
        (("--vary", "gravity=0..nan:3"), "from 0 to nan are not two finite numbers"),
        (("--vary", "gravity=0..1:1"), "1 of values is not in the range 2..10000"),
        (("--vary", "gravity=0..1:x"), "x of values is not in the range"),
        (("--vary", "dt=0..1:3:log"), "equal ratios need two numbers above 0"),
        (("--vary", "gravity=1,inf"), "inf is not a finite number"),
        (("--vary", "gravity=1,,2"), "KEY=VALUE,VALUE"),
        (("--vary", "gravity=1,1.0"), "1 comes twice"),
        (("--vary", "gravity=1", "--vary", "gravity=2"), "--vary gravity: it is varied twice"),
        (("--set", "gravity=1", "--vary", "gravity=2"), "--set gravity: it is varied as well"),
        (("--vary", "gravity=1,1e99"), "--vary gravity: 1e+99 is not in the range -1e+06..1e+06 px/s²"),
        (("--vary", "gravity=1,much"), "--vary gravity=much: KEY=VALUE with a finite number"),
        (("--vary", "method=auto,eulr"), "--vary method: 'eulr' is not one of auto, "),
        (("--vary", "weight=1"), "--vary weight: there is no such setting"),
        (("--set", "dt=9", "--vary", "gravity=1"), "--set dt: 9 is not in the range 1e-06..1 s"),
        (("--vary", "masses=3..6:3"), "--vary masses: 4.5 is not a whole number"),
        (("--vary", "method=auto,rk4", "--vary", "tolerance=1"), "--vary tolerance: the scene"),
        (("--vary", "gravity=0..1:999", "--vary", "rest_angle=0..1:999"), "998001 runs are more than"),
        (("--vary", "gravity=1", "--measure", "weight"), "--measure: 'weight' is not one of sag, period"),
        (("--vary", "gravity=1", "--duration", "nan"), "--duration: nan is not in the range 0.001..10000 s"),
        (("--vary", "gravity=1", "--jobs", "0"), "--jobs: 0 is not in the range 1..1000"),
        (("--vary", "gravity=1", "--cluster", "x", "--jobs", "2"), "--jobs: how many compute"),
        (
            ("--vary", "gravity=1", "--cluster", "nonsense://x"),
            "--cluster nonsense://x: no scheduler answers",
        ),
    ],
)
def test_the_command_refuses_before_it_computes(
    words: tuple[str, ...], fragment: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    from app.cli import main

    measure = () if "--measure" in words else ("--measure", "sag")
    with pytest.raises(SystemExit) as ended:
        main(["sweep", "tutorial-3.3", *words, *measure, "--out", str(tmp_path / "out")])
    assert ended.value.code == 1
    error = capsys.readouterr().err
    assert fragment in error
    assert error.count("\n") == 1
    assert not (tmp_path / "out" / "table.csv").exists() or "--cluster" in words


def test_something_has_to_be_measured() -> None:
    with pytest.raises(InputError, match="--measure: name at least one of sag"):
        parse_measures(())
    assert parse_measures(("sag", "survived", "sag")) == ("sag", "survived")


def test_the_help_has_every_measure(capsys: pytest.CaptureFixture[str]) -> None:
    from app.cli import main

    with pytest.raises(SystemExit):
        main(["sweep", "--help"])
    text = " ".join(capsys.readouterr().out.replace("│", " ").split())
    page = (Path(__file__).parents[2] / "docs" / "command-line.md").read_text()
    for name, measure in MEASURES.items():
        assert f"{name}: {measure.summary[:20]}" in text
        assert f"| `{name}` |" in page


def test_the_last_axis_is_the_fastest_and_names_come_first() -> None:
    grid = make_grid(ROPE, ("tolerance=0.5",), ("method=auto,adams",))
    assert grid.assignments(("adams",)) == ("method=adams", "tolerance=0.5")
    assert grid.scene_at(("adams",)).integrator.tolerance == 0.5
    points = make_grid(ROPE, (), ("gravity=1,2", "dt=0.1,0.2")).points
    assert points == [("1", "0.1"), ("1", "0.2"), ("2", "0.1"), ("2", "0.2")]


# ------------------------------------------------------------------------- what is measured
def pendulum(degrees: float, length: float = 100.0) -> sim.Scene:
    """A mass on a spring that is nearly a rod, under a gravity of 1000."""
    angle = math.radians(degrees)
    return sim.rope(
        2,
        length,
        direction=(math.sin(angle), math.cos(angle)),
        driven=None,
        stiffness=1e9,
        damping=0.0,
        joints=False,
        gravity=(0.0, 1000.0),
        air_friction=0.0,
        integrator=sim.Integrator(method="rodas5p", tolerance=1e-6),
    )


@pytest.mark.parametrize("degrees", [5.0, 90.0])
def test_the_period_of_a_pendulum(degrees: float) -> None:
    from scipy.special import ellipk

    row = run(encode_scene(pendulum(degrees)), (), 6.0, ("period",))
    exact = 4.0 * math.sqrt(100.0 / 1000.0) * float(ellipk(math.sin(math.radians(degrees) / 2.0) ** 2))
    assert row.values[0] == pytest.approx(exact, rel=2e-6)


def test_periods_of_damped_and_of_no_swings() -> None:
    t = np.linspace(0.0, 5.0, 601)
    z = np.exp((-0.2 + 2j * np.pi / 0.7) * t)
    speed = z * (-0.2 + 2j * np.pi / 0.7)
    one = np.array((0.6, -0.8))
    found = period(t, 300.0 + np.outer(np.real(z), one), np.outer(np.real(speed), one))
    assert found == pytest.approx(0.7, rel=2e-3)
    # A ripple on the swing is none of its own.
    ripple, its_speed = 0.02 * np.sin(60.0 * t), 1.2 * np.cos(60.0 * t)
    pure = np.exp(2j * np.pi / 0.7 * t)
    swing, speed = np.imag(pure) + ripple, 2.0 * np.pi / 0.7 * np.real(pure) + its_speed
    assert period(t, np.outer(swing, one), np.outer(speed, one)) == pytest.approx(0.7, rel=1e-2)
    creep = np.column_stack((np.exp(-t), 0.0 * t))
    assert period(t, creep, -creep) is None
    assert period(t, 0.0 * creep, 0.0 * creep) is None
    assert period(t[:3], creep[:3], creep[:3]) is None


def test_the_sag_is_that_of_the_equilibrium() -> None:
    scene = sim.rope(
        6, 100.0, direction=(1.0, 0.0), held=(0, 5), driven=None, damping=200.0, angular_damping=50.0,
        air_friction=0.1, integrator=sim.Integrator(method="rodas5p", tolerance=1e-6),
    )  # fmt: skip
    rest = np.array(sim.equilibrium(scene).positions) - [mass.position for mass in scene.masses]
    row = run(encode_scene(scene), (), 20.0, ("sag", "survived"))
    assert rest[:, 1].max() > 1.0
    assert row.values == (pytest.approx(rest[:, 1].max(), rel=1e-4), True)
    # Along gravity, wherever that points; and nowhere where there is none.
    up = run(encode_scene(scene), ("gravity=-2000",), 20.0, ("sag",))
    assert up.values == (pytest.approx(rest[:, 1].max(), rel=1e-4),)
    assert run(encode_scene(scene), ("gravity=0",), 0.1, ("sag",)).values == (None,)


def test_the_stretch_is_the_largest_of_all_looks() -> None:
    weight = sim.rope(
        2, 100.0, joints=False, driven=None, damping=0.0, stiffness=1000.0, gravity=(0.0, 5000.0),
        air_friction=0.0, integrator=sim.Integrator(method="rk4", dt=1e-3),
    )  # fmt: skip
    # It falls to twice the distance at which it would rest, 5000 / 1000 px, and comes back.
    period = 2.0 * math.pi / math.sqrt(1000.0)
    assert run(encode_scene(weight), (), period, ("stretch",)).values[0] == pytest.approx(0.1, rel=2e-2)


def test_the_energy_residual_is_relative_and_none_at_rest() -> None:
    coarse, fine = (
        run(encode_scene(ROPE), ("method=velocity_verlet", f"dt={dt}"), 0.5, ("energy_residual",)).values[0]
        for dt in (1e-3, 2.5e-4)
    )
    assert coarse is not None and fine is not None
    assert 0.0 < fine < coarse < 0.01
    assert coarse / fine == pytest.approx(16.0, rel=0.3)
    assert run(encode_scene(ROPE), ("gravity=0",), 0.1, ("energy_residual", "period")).values == (None, None)


@pytest.mark.parametrize(("method", "order"), [("symplectic_euler", 1), ("velocity_verlet", 2), ("rk4", 4)])
def test_the_error_falls_with_the_step_at_the_order_of_the_method(
    method: str, order: int, tmp_path: Path
) -> None:
    steps = (1e-3, 5e-4, 2.5e-4)
    vary = ("dt=" + ",".join(map(str, steps)),)
    status, here, _ = swept(tmp_path, ROPE, vary, ("error",), settings=(f"method={method}",))
    assert status == 0
    errors = [float(row["error [px]"]) for row in rows_of(tmp_path)]
    assert math.log2(errors[0] / errors[-1]) / 2.0 == pytest.approx(order, abs=0.25)
    assert here.asked == ["run_reference", "run", "run", "run"]


def test_near_exact_runs_are_shared_where_only_the_solver_varies(tmp_path: Path) -> None:
    vary = ("method=rk4,adams", "gravity=500,1000", "dt=1e-3,5e-4")
    _, here, _ = swept(tmp_path, ROPE, vary, ("error",))
    assert (here.asked.count("run_reference"), here.asked.count("run")) == (2, 8)
    # However the product of steps and step is rounded: 7 times 0.1 s is not quite 0.7 s.
    ends = {reference_of(sim.set_value(ROPE, "dt", dt), 0.7, 0.1) for dt in (0.1, 0.7)}
    assert len({end.data for end in ends}) == len(ends) == 1
    # A step that does not fit into the duration has an end, and a near-exact run, of its own.
    _, here, _ = swept(tmp_path / "new", ROPE, ("dt=1e-3,3e-3",), ("error",))
    assert here.asked.count("run_reference") == 2
    assert all(float(row["error [px]"]) < 0.1 for row in rows_of(tmp_path / "new"))


def test_a_run_that_runs_away_is_a_row(tmp_path: Path) -> None:
    vary = ("linear_stiffness=1e4,1e9", "method=rk4,rodas5p")
    status, _, _ = swept(tmp_path, ROPE, vary, ("sag", "stretch", "error", "energy_residual", "period"))
    assert status == 0
    rows = rows_of(tmp_path)
    assert [row["survived"] for row in rows] == ["yes", "yes", "no", "yes"]
    assert list(rows[2].values()) == ["1000000000", "rk4", "", "", "", "", "", "no"]
    assert rows[3]["sag [px]"] and rows[3]["error [px]"]


def test_a_near_exact_run_that_fails_leaves_an_empty_cell(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(data: bytes, end: float) -> None:
        return None

    failing.__name__ = run_reference.__name__
    monkeypatch.setattr("app.sweep.sweep.run_reference", failing)
    swept(tmp_path, ROPE, ("gravity=1,2",), ("error", "sag"))
    assert [(row["error [px]"], row["survived"]) for row in rows_of(tmp_path)] == [("", "yes")] * 2


# ------------------------------------------------------------------------- files
def test_the_table_has_units_and_all_digits(tmp_path: Path) -> None:
    scene = msgspec.structs.replace(ROPE, view=sim.View(unit="mm"))
    swept(tmp_path, scene, ("gravity=100..300:3", "force_law=tutorial,angle"), ("sag", "stretch"))
    rows = rows_of(tmp_path)
    assert list(rows[0]) == ["gravity [mm/s²]", "force_law", "sag [mm]", "stretch", "survived"]
    values = [(row["gravity [mm/s²]"], row["force_law"]) for row in rows]
    assert values == [(g, law) for g in ("100", "200", "300") for law in ("tutorial", "angle")]
    exact = run(encode_scene(scene), ("force_law=angle", "gravity=300"), 0.2, ("sag", "stretch"))
    assert (float(rows[5]["sag [mm]"]), float(rows[5]["stretch"])) == exact.values
    assert (tmp_path / "plot.png").read_bytes().startswith(b"\x89PNG")


def test_what_is_done_is_kept_and_the_same_call_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.sweep.sweep.AHEAD", 1)
    vary = ("gravity=100..900:9",)
    status, here, text = swept(tmp_path, ROPE, vary, ("sag",), interrupt_at=4)
    assert (status, here.asked.count("run")) == (130, 4)
    assert "Interrupted: 4 of 9 runs are done; the same command goes on." in text
    assert [row["gravity [px/s²]"] for row in rows_of(tmp_path)] == ["100", "200", "300", "400"]
    status, here, text = swept(tmp_path, ROPE, vary, ("sag",))
    assert (status, here.asked.count("run")) == (0, 5)
    assert "9 of 9 runs are done" in text
    status, here, _ = swept(tmp_path, ROPE, vary, ("sag",))
    assert (status, here.asked) == (0, [])


def test_a_torn_line_is_done_again(tmp_path: Path) -> None:
    vary = ("gravity=100..400:4",)
    swept(tmp_path, ROPE, vary, ("sag",))
    whole, path = (tmp_path / "table.csv").read_bytes(), tmp_path / "sweep.jsonl"
    path.write_bytes(path.read_bytes()[:-7])
    _, here, _ = swept(tmp_path, ROPE, vary, ("sag",))
    assert here.asked == ["run"]
    assert (tmp_path / "table.csv").read_bytes() == whole
    assert sorted(numbers_of(tmp_path)) == [0, 1, 2, 3]


@pytest.mark.parametrize(
    ("change", "fragment"),
    [
        ({"vary": ("gravity=100,201",)}, "another --vary;"),
        ({"measures": ("stretch",)}, "another --measure;"),
        ({"duration": 0.3}, "another --duration;"),
        ({"settings": ("dt=2e-3",)}, "another --set;"),
        ({"scene": sim.rope(4)}, "another SCENE;"),
    ],
)
def test_other_options_are_refused(tmp_path: Path, change: dict, fragment: str) -> None:
    same = {"scene": ROPE, "vary": ("gravity=100,200",), "measures": ("sag",), "duration": 0.2}
    swept(tmp_path, **same)
    before = (tmp_path / "sweep.jsonl").read_bytes()
    with pytest.raises(InputError, match=fragment) as refused:
        swept(tmp_path, **{**same, **change})
    assert "\n" not in str(refused.value)
    assert (tmp_path / "sweep.jsonl").read_bytes() == before


def test_a_file_that_is_no_sweep_is_refused(tmp_path: Path) -> None:
    (tmp_path / "sweep.jsonl").write_text("nonsense\n")
    plan = make_plan(make_grid(ROPE, (), ("gravity=1,2",)), ("sag", "survived"), 1.0)
    with pytest.raises(InputError, match="this is not the file of a sweep"):
        Folder(tmp_path, plan)


def test_rows_of_different_machines_are_pointed_out(tmp_path: Path) -> None:
    _, _, text = swept(tmp_path, ROPE, ("gravity=1,2",), ("sag",))
    assert "different machines" not in text
    path = tmp_path / "sweep.jsonl"
    plan, first, _ = path.read_text().splitlines()
    path.write_text(f"{plan}\n{first.replace('softrod ', 'softrod 0.0.')}\n")
    _, _, text = swept(tmp_path, ROPE, ("gravity=1,2",), ("sag",))
    assert "different machines or versions" in text


# ------------------------------------------------------------------------- the plot
@pytest.mark.parametrize(
    ("vary", "pictures", "lines"),
    [
        (("gravity=1,2,3",), 2, 1),
        (("gravity=1,2,3", "method=rk4,auto"), 2, 2),
        (("method=rk4,auto", "gravity=1..9:9"), 4, 0),  # two maps, each with the bar of its colours
        (("dt=1e-4..1e-2:3:log", "gravity=1,2", "method=rk4,auto"), 4, 2),
    ],
)
def test_plots_have_a_picture_for_each_measure_and_further_value(
    vary: tuple[str, ...], pictures: int, lines: int
) -> None:
    grid = make_grid(ROPE, (), vary)
    rows = {n: Row((1.0 + n, None if n else 2.0, True), "") for n in range(len(grid.points) - 1)}
    figure = plot(grid, ("sag", "period", "survived"), rows)
    assert len(figure.axes) == pictures
    assert len(figure.axes[0].lines) == lines
    assert (figure.axes[0].get_xscale() == "log") == ("log" in vary[0])
    assert len(COLOURS) == 8


# ------------------------------------------------------------------------- processes
def test_a_sweep_that_was_interrupted_ends_with_the_same_table(undisturbed: bytes, tmp_path: Path) -> None:
    out = tmp_path / "out"
    process = subprocess.Popen(
        command(out, "--jobs", "2"), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    try:
        wait_for_rows(out, 4, process)
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=PATIENCE)
    finally:
        process.kill()
    assert process.returncode == 130, said
    assert "Traceback" not in said
    before = numbers_of(out)
    assert 4 <= len(before) < 24
    assert len(rows_of(out)) == len(before)
    done = subprocess.run(command(out, "--jobs", "2"), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert numbers_of(out)[: len(before)] == before
    assert sorted(numbers_of(out)) == list(range(24))
    assert (out / "table.csv").read_bytes() == undisturbed
    assert undisturbed.count(b"\n") == 25


# ------------------------------------------------------------------------- a cluster
@contextmanager
def started(*words: str | Path) -> Iterator[subprocess.Popen[str]]:
    """A process of Dask, which is ended with this context."""
    dask = Path(sys.executable).with_name("dask")
    process = subprocess.Popen(
        [str(dask), *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, text=True
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def test_a_cluster_that_loses_a_worker_gives_the_same_table(undisturbed: bytes, tmp_path: Path) -> None:
    where, out = tmp_path / "scheduler.json", tmp_path / "out"
    to_it = ("--scheduler-file", where, "--no-dashboard")
    worker = ("worker", *to_it, "--nthreads", "1", "--no-nanny", "--host", "127.0.0.1")
    with started("scheduler", *to_it, "--host", "127.0.0.1", "--port", "0"), started(*worker) as doomed:
        patience = time.monotonic() + PATIENCE
        while not where.exists() and time.monotonic() < patience:
            time.sleep(0.01)
        address = msgspec.json.decode(where.read_bytes())["address"]
        with started(*worker):
            process = subprocess.Popen(
                command(out, "--cluster", address),
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
            )
            try:
                wait_for_rows(out, 4, process)
                assert doomed.poll() is None
                doomed.kill()
                assert len(numbers_of(out)) < 24
                said, _ = process.communicate(timeout=PATIENCE)
            finally:
                process.kill()
    assert process.returncode == 0, said
    assert sorted(numbers_of(out)) == list(range(24))
    assert (out / "table.csv").read_bytes() == undisturbed
