"""`softrod sweep`: what is varied, the loop, the files and the plot."""

from __future__ import annotations

import io
import math
from pathlib import Path

import msgspec
import numpy as np
import pytest
from rich.console import Console

import sim
from sim.errors import InputError
from sim.store.files import encode_scene
from studies.commands import workers_for
from studies.sweep.grid import make_grid, parse_axis
from studies.sweep.journal import Journal
from studies.sweep.measures import GAVE_UP, MEASURES, parse_measures
from studies.sweep.plot import COLOURS, plot
from studies.sweep.runs import Row, reference_of, run, run_reference, run_several
from studies.sweep.sweep import MAX_TOGETHER, Sweep, sweep
from tests.app.command import refused, softrod_here
from tests.studies.sweeping import ROPE, numbers_of, rows_of, swept


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
        (("--vary", "method=velocity_verlet,rk4", "--vary", "tolerance=1"), "--vary tolerance: the method"),
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
    measure = () if "--measure" in words else ("--measure", "sag")
    refused(
        softrod_here(capsys, "sweep", "tutorial-3.3", *words, *measure, "--out", tmp_path / "out"), fragment
    )
    assert not (tmp_path / "out" / "table.csv").exists() or "--cluster" in words


def test_something_has_to_be_measured() -> None:
    with pytest.raises(InputError, match="--measure: name at least one of sag"):
        parse_measures(())
    assert parse_measures(("sag", "survived", "sag")) == ("sag", "survived")


def test_the_help_has_every_measure(capsys: pytest.CaptureFixture[str]) -> None:
    from app.cli.main import main

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
    monkeypatch.setattr("studies.sweep.sweep.MAX_TOGETHER", 2)
    vary = ("gravity=100..900:9",)
    status, here, text = swept(tmp_path, ROPE, vary, ("sag",), interrupt_at=4, ahead=1)
    assert (status, here.asked.count("run")) == (130, 4)
    assert "Interrupted: 4 of 9 runs are done; the same command goes on." in text
    assert [row["gravity [px/s²]"] for row in rows_of(tmp_path)] == ["100", "200", "300", "400"]
    status, here, text = swept(tmp_path, ROPE, vary, ("sag",))
    assert (status, here.asked.count("run")) == (0, 5)
    assert "9 of 9 runs are done" in text
    status, here, _ = swept(tmp_path, ROPE, vary, ("sag",))
    assert (status, here.asked) == (0, [])


def test_with_one_process_each_run_is_kept_before_the_next(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[float] = []

    def interrupted(*arguments):
        if len(done) == 3:
            raise KeyboardInterrupt
        done.append(0.0)
        return run_several(*arguments)

    monkeypatch.setattr("studies.sweep.sweep.run_several", interrupted)
    grid, measures = make_grid(ROPE, ("method=auto",), ("gravity=100..900:9",)), parse_measures(("sag",))
    console = Console(file=io.StringIO())
    assert sweep(grid, measures, 0.1, workers_for(1, None), tmp_path, console) == 130
    assert numbers_of(tmp_path) == [0, 1, 2]
    monkeypatch.setattr("studies.sweep.sweep.run_several", run_several)
    assert sweep(grid, measures, 0.1, workers_for(1, None), tmp_path, console) == 0
    assert len(numbers_of(tmp_path)) == 9


def test_runs_that_need_no_simulation_are_done_side_by_side(tmp_path: Path) -> None:
    vary = ("gravity=100..900:50", "dt=1e-3,2e-3", "method=rk4,auto")
    measures = ("sag", "period", "stretch")
    _, here, _ = swept(tmp_path, ROPE, vary, measures, duration=0.3)
    assert (here.asked.count("run"), here.calls) == (
        200,
        100 + math.ceil(100 / MAX_TOGETHER),
    )  # `auto` singly
    _, here, _ = swept(tmp_path / "fixed", ROPE, vary[:2], measures, duration=0.3)
    assert (here.asked.count("run"), here.calls) == (100, math.ceil(100 / MAX_TOGETHER))
    # Each as if it were alone, to the last bit.
    rows = rows_of(tmp_path / "fixed")
    for row in (rows[0], rows[57], rows[99]):
        changes = (f"gravity={row['gravity [px/s²]']}", f"dt={row['dt [s]']}")
        alone = run(encode_scene(ROPE), changes, 0.3, measures)
        assert tuple(float(row[key]) for key in ("sag [px]", "period [s]", "stretch") if row[key]) == tuple(
            value for value in alone.values if value is not None
        )


def test_what_runs_away_beside_others_has_no_measures() -> None:
    changes = [
        ("gravity=100",),
        ("gravity=100", "dt=0.5"),
        ("linear_stiffness=1e6", "dt=0.005"),
        ("gravity=200",),
    ]
    rows = run_several(encode_scene(ROPE), changes, 1.0, ("sag", "survived"), [None] * 4)
    assert [row.values[1] for row in rows] == [True, False, False, True]
    assert rows[1].values[0] is rows[2].values[0] is None
    assert rows == [run(encode_scene(ROPE), each, 1.0, ("sag", "survived")) for each in changes]


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
    header = Sweep(make_grid(ROPE, (), ("gravity=1,2",)), ("sag", "survived"), 1.0).header
    with pytest.raises(InputError, match="this is not the file of a sweep"):
        Journal(tmp_path, header)


@pytest.mark.parametrize(("part", "instead"), [('"run":1', '"run":2'), ('"values":[', '"values":[1.0,')])
def test_rows_of_other_runs_are_refused(tmp_path: Path, part: str, instead: str) -> None:
    swept(tmp_path, ROPE, ("gravity=1,2",), ("sag",))
    path = tmp_path / "sweep.jsonl"
    path.write_text(path.read_text().replace(part, instead))
    before = path.read_bytes()
    with pytest.raises(InputError, match=r"sweep\.jsonl: line [23] is not of a run of this sweep"):
        swept(tmp_path, ROPE, ("gravity=1,2",), ("sag",))
    assert path.read_bytes() == before


def test_a_run_that_would_never_end_is_given_up(tmp_path: Path) -> None:
    """The others are done, and the table says which one it was."""
    hopeless = sim.rope(5, 100.0, direction=(1.0, 0.5), driven=None, stiffness=1e15)
    swept(tmp_path, hopeless, ("method=adams,stable_spring",), ("sag", "error"), duration=0.01)
    first, second = rows_of(tmp_path)
    assert (first["survived"], first["sag [px]"], first["error [px]"]) == ("gave up", "", "")
    assert second["survived"] == "yes"
    assert float(second["sag [px]"]) >= 0.0
    figure = plot(
        make_grid(ROPE, (), ("gravity=1,2",)), ("survived",), {0: Row((GAVE_UP,), ""), 1: Row((True,), "")}
    )
    assert np.asarray(figure.axes[0].lines[0].get_ydata()).tolist() == [0.0, 1.0]


def test_a_near_exact_run_that_would_never_end_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("studies.sweep.runs.MAX_ATTEMPTS", 100.0)
    assert run_reference(*reference_of(ROPE, 0.05, 0.1)) is None


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


def test_a_number_that_only_some_methods_have_is_left_out_of_the_others_runs() -> None:
    grid = make_grid(sim.load_scene("rope"), (), ["method=auto,rk4", "tolerance=1,.01", "gravity=0,900"])
    of_auto, of_rk4 = grid.points[0], grid.points[-1]
    assert grid.assignments(of_auto) == ("method=auto", "tolerance=1", "gravity=0")
    assert grid.assignments(of_rk4) == ("method=rk4", "gravity=900")
    assert grid.scene_at(of_rk4).integrator.method == "rk4"
    # One that nothing has a use for is refused, as ever.
    for vary in (["method=rk4,velocity_verlet", "tolerance=1,.01"], ["tolerance=1,.01"]):
        grid = make_grid(sim.load_scene("tutorial-3.3"), ["method=rk4"] * (len(vary) == 1), vary)
        with pytest.raises(InputError, match="has a fixed step, so it takes no tolerance"):
            grid.scene_at(grid.points[0])
