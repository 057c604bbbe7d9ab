"""Numbers that are found from what was measured, against the hidden ones that made it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest
from msgspec import UNSET
from msgspec.structs import replace

import sim
from sim.design.combinations import candidates
from sim.design.fit import effective_sample_fraction
from sim.design.measurements import Column, Measurement, parse_measurements
from sim.design.parameters import Parameter
from sim.design.residuals import Problem
from sim.scene.parts import Motor
from sim.scene.surroundings import Wall
from sim.settings import set_value
from tests.amount import NIGHT, part_of
from tests.sim.checks import known, refusal
from tests.sim.indistinguishable import KINDS, bending_that_never_moves, weightless
from tests.sim.measured import any_case, measure, spring_pendulum, swing
from tests.sim.test_motors import crank


def random(seed: int = 1) -> np.random.Generator:
    return np.random.default_rng(seed)


def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    """300 rods, ropes, spring pendulums and pendulums by night; by day a few, of which a 99.9 % interval, 1.7
    times as wide, holds it."""
    cases = part_of(range(300), 100)
    inside: list[bool] = []
    for seed in cases:
        case = any_case(seed)
        found = sim.fit(case.guess, case.data, case.vary)
        for name, truth in case.truth.items():
            each = found.values[name]
            inside.append(each.low <= truth <= each.high)
            if each.known:
                middle = math.log(each.high * each.low) / 2.0
                assert abs(math.log(truth) - middle) < 1.0 * math.log(each.high / each.low), (seed, name)
    if NIGHT:
        assert 0.93 <= np.mean(inside) <= 0.97


@pytest.mark.parametrize("case", part_of(range(2 * len(KINDS)), 8))
def test_what_cannot_be_told_is_named_with_what_is_known_of_it(case: int) -> None:
    """Twice each kind by night, by day three: the sentence is the right one, and its intervals, half as wide
    again, hold the truth."""
    kind = KINDS[case % len(KINDS)]
    given = kind(random(case))
    found = sim.fit(given.guess, given.data, given.vary)
    number = r"(-?[\d.e+-]+?)(?: ± ([\d.e+-]+)| \((\S+) to (\S+)\))?"
    sentence, *others = found.sentences
    # Where gravity is sought and only angles are given, the lengths are named as well.
    assert len(others) <= ("gravity" in given.vary)
    assert all(other.startswith("Angles tell gravity over length") for other in others)
    parts = re.fullmatch(re.escape(given.said).replace(r"\{\}", number), sentence)
    assert parts, (kind.__name__, sentence)
    for truth, (value, by, low, high) in zip(given.truth, batched(parts.groups(), 4), strict=True):
        if by or low:
            wide = 1.5 * (float(by) if by else 0.5 * (float(high) - float(low)))
            assert abs(float(value) - truth) < wide < 0.2 * abs(truth) + 0.01, (kind.__name__, sentence)
        else:
            assert "at least" in sentence
            assert float(value) < truth
    named = sentence.split(":")[0]
    for name, each in found.values.items():
        assert each.known == (name not in named)


def batched(values: Sequence[str], size: int) -> Iterator[Sequence[str]]:
    return (values[i : i + size] for i in range(0, len(values), size))


def pendulum_in_metres(length: float, degrees: float) -> Measurement:
    """Places of a pendulum under 1000 px/s², one px of which is 1/400 m, with noise of half a millimetre."""
    data = measure(swing(400.0 * length, degrees), ["mass1.x", "mass1.y"], 4.0, 0.0, random())
    draw = random(2)
    columns = (
        Column(each.name, "m", each.values / 400.0 + 5e-4 * draw.standard_normal(each.values.size))
        for each in data.columns
    )
    return Measurement("swing.csv", data.time, tuple(columns))


@pytest.mark.parametrize("degrees", [25.0, 60.0])
def test_a_length_that_is_not_the_scenes_is_told_with_what_gravity_stands_for(degrees: float) -> None:
    found = sim.fit(swing(), pendulum_in_metres(0.5, degrees), ["gravity", "start", "origin"], scale=400.0)
    (told,) = [each for each in found.sentences if "circle" in each]
    number = r"([\d.]+)"
    parts = re.fullmatch(
        rf"swing\.csv: mass 1 was measured on a circle with a radius of {number} px \({number} m\), and the "
        rf"scene's is {number} px\. The gravity that is found stands for gravity over length: at {number} "
        rf"px it would be {number} times as large\. Vary spring0\.rest_length, too, or give it {number} px "
        r"in the scene\.",
        told,
    )
    assert parts, told
    radius, metres, own, _, times, _ = map(float, parts.groups())
    assert radius == pytest.approx(200.0, rel=0.02)
    assert metres == pytest.approx(0.5, rel=0.02)
    assert own == pytest.approx(250.0, rel=0.02)
    assert found.values["gravity"].value * times == pytest.approx(1000.0, rel=0.05)
    assert re.search(r"px/s² \(\d[\d.]* ± [\d.]+ m/s²\)", found.values["gravity"].text)


def test_the_right_length_is_not_worth_a_word() -> None:
    found = sim.fit(swing(), pendulum_in_metres(0.625, 40.0), ["gravity", "start", "origin"], scale=400.0)
    assert not found.sentences
    assert found.values["gravity"].value == pytest.approx(1000.0, rel=0.01)


def test_angles_alone_tell_whose_length_it_is() -> None:
    data = measure(swing(), ["spring0.direction"], 2.0, 0.003, random())
    found = sim.fit(sim.set_value(swing(), "gravity", 900.0), data, ["gravity"])
    assert found.sentences == (
        "Angles tell gravity over length, and no length: this gravity belongs to spring0 of 250 px.",
    )


@pytest.mark.parametrize(("begins", "is_absolute"), [(2e6, False), (36000.0, True)])
def test_a_clock_that_is_far_from_the_start_needs_the_start(begins: float, is_absolute: bool) -> None:
    data = measure(swing(), ["mass1.x", "mass1.y"], 1.0, 0.003, random())
    late = Measurement("late.csv", data.time + begins, data.columns, is_absolute)
    with pytest.raises(sim.InputError, match=r"late\.csv: its clock begins at .* vary start"):
        sim.fit(swing(), late, ["gravity"])
    found = sim.fit(swing(), late, ["gravity", "start"])
    assert found.values["gravity"].value == pytest.approx(1000.0, rel=0.02)


def test_runs_side_by_side_are_fitted_together(tmp_path: Path) -> None:
    one, other = (
        measure(swing(degrees=degrees), ["mass1.x"], seconds, 0.003, random(seed))
        for degrees, seconds, seed in ((40.0, 2.0, 1), (25.0, 1.0, 2))
    )
    rows = [
        f"{t},{x}," + (f"{other.time[i]},{other.columns[0].values[i]}" if i < other.time.size else ",")
        for i, (t, x) in enumerate(zip(one.time, one.columns[0].values, strict=True))
    ]
    (tmp_path / "runs.csv").write_text("t,mass1.x,t,mass1.x\n" + "\n".join(rows))
    found = sim.fit(swing(), tmp_path / "runs.csv", ["gravity", "start"])
    assert [each.file for each in found.series] == ["runs.csv, run 1", "runs.csv, run 2"]
    assert found.values["gravity"].value == pytest.approx(1000.0, rel=0.02)


def test_an_angle_that_was_measured_a_turn_further_is_the_same() -> None:
    data = measure(swing(), ["spring0.direction"], 0.5, 0.0, random())
    (angle,) = data.columns
    turned = Column(angle.name, angle.unit, angle.values + 360.0 * (np.arange(angle.values.size) % 2))
    problem = Problem(swing(), [Measurement(data.name, data.time, (turned,))], ["gravity"], None, None)
    assert np.abs(problem.residuals(problem.first(), [np.ones(1)])).max() < 1e-6


@pytest.mark.parametrize("case", part_of(range(8), 8))
def test_what_brakes_may_be_one_or_the_other(case: int) -> None:
    """Two swings with much noise do not tell whether a spring or the air brakes them: what is said of each
    holds the truth, also where the best fit has nothing of the air."""
    draw = random(case)
    damping, air = draw.uniform(0.4, 0.7), draw.uniform(1.5e-3, 2.5e-3)
    hidden = replace(weightless(spring_pendulum(damping=damping)), air_friction=air)
    guess = replace(weightless(spring_pendulum(damping=0.5)), air_friction=2e-3)
    found = sim.fit(guess, measure(hidden, ["mass1.y"], 1.2, 0.03, draw), ["linear_damping", "air_friction"])
    for name, truth in (("linear_damping", damping), ("air_friction", air)):
        each = found.values[name]
        assert each.low / 1.2 < truth < 1.2 * each.high
        assert each.high < 10.0 * truth


def test_a_number_of_which_the_data_say_nothing_is_named_with_what_it_is_at_most() -> None:
    data = measure(weightless(spring_pendulum()), ["mass1.y"], 3.0, 0.01, random())
    found = sim.fit(
        weightless(spring_pendulum()), data, ["linear_stiffness", "linear_damping", "air_friction"]
    )
    air, damping = found.values["air_friction"], found.values["linear_damping"]
    assert found.sentences == (f"The data hardly tell air_friction: it is {air.text}.",)
    assert not air.known
    assert 1e-5 < air.high < 1e-2
    assert air.text.startswith("at most ")
    assert damping.known
    assert 0.2 < damping.low < 0.3 < damping.high < 0.4


def test_what_the_data_do_not_tell_stays_as_it_is() -> None:
    """Whichever start the search ends from."""
    given = bending_that_never_moves(random())
    found = sim.fit(given.guess, given.data, given.vary)
    assert found.values["angular_stiffness"].value == pytest.approx(3e3, rel=1e-6)


@pytest.mark.parametrize("seed", range(20))
def test_along_a_combination_its_value_stays(seed: int) -> None:
    """Of unknowns of all sorts; its gradient is the one that was asked for."""
    draw = random(seed)
    units = [("kg", True), ("kg", True), ("kg/s²", True), ("px", False), ("px/s", False)]
    parameters = [
        Parameter(f"p{i}", unit, 1.0, 1e-9, 1e9, logarithmic, 1.0 if logarithmic else 50.0)
        for i, (unit, logarithmic) in enumerate(units)
    ]
    u = draw.uniform(-1.0, 1.0, 5)
    weights = draw.uniform(0.2, 2.0, 5) * draw.choice([-1.0, 1.0], 5) * (draw.random(5) < 0.7)
    if np.count_nonzero(weights) < 2:
        weights[:2] = 1.0, -2.0
    for each in candidates(weights, parameters, u):
        step = 1e-6 * np.eye(5)
        slopes = np.array([each.value(u + by) - each.value(u - by) for by in step])
        # Factors and powers that are nearly round are taken for these.
        assert slopes @ weights / np.linalg.norm(slopes) / np.linalg.norm(weights) == pytest.approx(
            math.copysign(1.0, slopes @ weights), abs=0.02
        )
        assert [i for i in range(5) if slopes[i]] == each.which == np.flatnonzero(weights).tolist()
        first, last = each.which[0], each.which[-1]
        moved = u + 0.3 * (np.arange(5) == first)
        kept = each.kept(moved, u, last)
        if kept is not None:
            moved[last] = kept
            assert each.value(moved) == pytest.approx(each.value(u), rel=1e-9)


def test_combinations_read_as_people_write_them() -> None:
    names = ("k0", "k1", "m0", "m1", "x", "vx")
    units = ("kg/s²", "kg/s²", "kg", "kg", "px", "px/s")
    parameters = [
        Parameter(name, unit, 1.0, 1e-9, 1e9, name not in ("x", "vx"))
        for name, unit in zip(names, units, strict=True)
    ]

    def read(*weights: float) -> list[str]:
        return [each.text for each in candidates(np.array(weights), parameters, np.zeros(6))]

    assert read(1.0, 0.0, -1.0, 0.0, 0.0, 0.0) == ["k0 / m0"]
    assert read(1.0, 1.0, 0.0, 0.0, 0.0, 0.0) == ["k0 k1", "k0 + k1", "1 / (1 / k0 + 1 / k1)"]
    assert read(1.0, 0.0, -0.5, -0.5, 0.0, 0.0) == [
        "k0 / m0^0.5 / m1^0.5", "k0 / (m0 + m1)", "k0 / (1 / (1 / m0 + 1 / m1))",
    ]  # fmt: skip
    assert read(0.0, 0.0, 0.0, 0.0, 1.0, -0.25) == ["x - 0.25 vx"]
    assert read(-0.2, 0.0, 0.0, 0.0, 1.0, 0.0) == ["x - 0.2 k0", "x + 0.2 / k0"]


# ------------------------------------------------------------------------- how measurements are given
def exported(scene: sim.Scene, seconds: float, noise: float, seed: int = 1) -> str:
    """What Tracker has of mass 1, in centimetres of 4 px, with its origin elsewhere, y upwards, and gaps."""
    data = measure(scene, ["mass1.x", "mass1.y"], seconds, 0.0, random())
    draw, lines = random(seed), ["mass A", "t\tx (cm)\ty (cm)"]
    for k, (time, x, y) in enumerate(
        zip(data.time, data.columns[0].values, data.columns[1].values, strict=True)
    ):
        across, up = (
            f"{each + noise * draw.standard_normal():.4E}".replace(".", ",")
            for each in (x / 4.0 + 7.0, -y / 4.0 + 3.0)
        )
        lines.append(f"{time + 1.5:.4f}".replace(".", ",") + f"\t{across}\t{'' if k % 7 == 3 else up}")
    return "\n".join(lines)


def test_a_table_of_tracker_gives_gravity_scale_origin_and_start() -> None:
    """Of a pendulum whose length is known, everything else follows from how it swings."""
    (data,) = parse_measurements(exported(swing(), 1.6, 0.05).encode(), "tracker.txt")
    guess = swing(degrees=35.0)
    found = sim.fit(guess, data, ["gravity", "start", "origin"], scale=400.0)
    values = found.values
    assert [*values] == ["gravity", "origin_x", "origin_y", "mass1.x", "mass1.vx", "mass1.y", "mass1.vy"]
    truth = {"gravity": 1000.0, "origin_x": 0.07, "origin_y": 0.03, "mass1.x": 160.697, "mass1.y": 191.511}
    for name, value in truth.items():
        each, wide = values[name], 0.7 * (values[name].high - values[name].low)
        assert each.low - wide < value < each.high + wide, name
        assert each.high - each.low < 0.2 * abs(value)
    assert known(found.scene.pose).positions[1] == pytest.approx((160.697, 191.511), abs=3.0)
    assert [each.unit for each in found.series] == ["cm", "cm"]
    assert [each.noise for each in found.series] == pytest.approx([0.05, 0.05], rel=0.4)
    why = "tracker.txt, column 'mass A x': it is in cm, but the scene in px"
    assert why in refusal(sim.InputError, sim.fit, guess, data, ["gravity"])


def test_a_length_scale_is_found() -> None:
    data = measure(spring_pendulum(), ["mass1.y"], 1.5, 0.01, random())
    there = (Column("mass1.y", "cm", data.columns[0].values / 4.0),)
    found = sim.fit(spring_pendulum(), Measurement("cm.csv", data.time, there), ["length_scale"])
    assert found.values["length_scale"].unit == "px/m"
    assert found.values["length_scale"].value == pytest.approx(400.0, rel=2e-3)


def test_several_files_are_of_one_body_and_have_a_start_each() -> None:
    tables = []
    for name, degrees in (("one.csv", 25.0), ("two.csv", -50.0)):
        each = measure(swing(degrees=degrees), ["mass1.x", "mass1.y"], 0.8, 0.01, random())
        tables.append(Measurement(name, each.time, each.columns))
    found = sim.fit(set_value(swing(), "gravity", 900.0), tables, ["gravity", "start"])
    assert found.values["gravity"].value == pytest.approx(1000.0, rel=5e-3)
    for name, degrees in (("one", 25.0), ("two", -50.0)):
        there = 250.0 * math.sin(math.radians(degrees))
        assert found.values[f"mass1.x of {name}.csv"].value == pytest.approx(there, abs=2.0)
    assert [each.file for each in found.series] == ["one.csv", "one.csv", "two.csv", "two.csv"]


def test_columns_of_different_kinds_count_by_their_noise() -> None:
    """A force with much noise must not spoil what a place with little says."""
    place = measure(spring_pendulum(), ["mass1.y"], 1.5, 0.002, random())
    force = measure(spring_pendulum(), ["spring0.force"], 1.5, 0.5, random())
    both = Measurement("both.csv", place.time, (*place.columns, *force.columns))
    guess = set_value(spring_pendulum(), "linear_stiffness", 110.0)
    vary = ["linear_stiffness", "linear_damping"]
    one, two = sim.fit(guess, place, vary), sim.fit(guess, both, vary)
    for name in vary:
        assert two.values[name].value == pytest.approx(one.values[name].value, rel=1e-3)
    assert two.series[1].noise > 100.0 * two.series[0].noise


def test_an_acceleration_such_as_a_phone_measures_gives_the_stiffness_over_the_mass() -> None:
    data = measure(weightless(spring_pendulum()), ["mass1.ay"], 1.5, 0.02, random())
    found = sim.fit(weightless(spring_pendulum(stiffness=70.0)), data, ["linear_stiffness", "mass1.vy"])
    assert found.values["linear_stiffness"].value == pytest.approx(80.0, rel=1e-2)
    assert found.values["mass1.vy"].low < 0.0 < found.values["mass1.vy"].high


# ------------------------------------------------------------------------- what intervals mean
def test_residuals_that_hang_together_count_as_fewer() -> None:
    """An autoregressive series of 4000 with the correlation 0.8 counts as 4000 / 9."""
    draw, series = random().standard_normal(4000), np.zeros(4000)
    for k in range(1, 4000):
        series[k] = 0.8 * series[k - 1] + draw[k]
    assert effective_sample_fraction(series) == pytest.approx(1.0 / 9.0, rel=0.2)
    series[::5] = np.nan
    assert effective_sample_fraction(series) == pytest.approx(1.0 / 9.0, rel=0.25)
    assert effective_sample_fraction(draw) == 1.0


def test_a_scene_that_lacks_something_is_told_and_widens_the_intervals() -> None:
    """The air is in what was measured, but not in what is sought."""
    airy = replace(swing(), air_friction=2e-4)
    data = measure(airy, ["mass1.x"], 2.0, 0.005, random())
    lacking = sim.fit(swing(), data, ["gravity"])
    whole = sim.fit(replace(swing(), air_friction=1e-4), data, ["gravity", "air_friction"])
    assert "is no mere noise" in lacking.sentences[0]
    assert not whole.sentences
    width = {fit: fit.values["gravity"].high - fit.values["gravity"].low for fit in (lacking, whole)}
    assert width[lacking] > 4.0 * width[whole]


def test_draws_scatter_as_the_intervals_say() -> None:
    data = measure(spring_pendulum(), ["mass1.y"], 2.0, 0.03, random())
    found = sim.fit(spring_pendulum(), data, ["linear_stiffness", "linear_damping"])
    drawn = [scene.linear_springs[0].stiffness for scene in found.draws(400)]
    each = found.values["linear_stiffness"]
    assert 2.0 * np.std(drawn) == pytest.approx(0.5 * (each.high - each.low), rel=0.12)
    assert found.draws(2, seed=3) == found.draws(2, seed=3)
    with pytest.raises(sim.InputError, match="draws: -1 is not in the range"):
        found.draws(-1)


def test_a_far_start_does_not_mistake_one_swing_for_the_next() -> None:
    """Three times the stiffness: after 4 s the guess is five swings ahead."""
    data = measure(spring_pendulum(), ["mass1.y"], 4.0, 0.01, random())
    found = sim.fit(spring_pendulum(stiffness=240.0), data, ["linear_stiffness"])
    assert found.values["linear_stiffness"].value == pytest.approx(80.0, rel=2e-3)
    assert found.values["linear_stiffness"].before == 240.0


def test_methods_with_steps_of_their_own_fit_what_they_made() -> None:
    """A table of times between the steps; the tutorial's Euler has the period that it has."""
    euler = replace(spring_pendulum(), integrator=sim.Integrator(method="symplectic_euler", dt=0.02))
    run = sim.Simulation(euler).record(1.0, "mass1.y")
    data = Measurement("euler.csv", run.time, (Column("mass1.y", "px", run["mass1.y"]),))
    found = sim.fit(set_value(euler, "linear_stiffness", 100.0), data, ["linear_stiffness"])
    assert found.values["linear_stiffness"].value == pytest.approx(80.0, rel=1e-6)


# ------------------------------------------------------------------------- what is refused
@pytest.mark.parametrize(
    ("vary", "said"),
    [
        ([], "vary: name from 1 to 6 numbers that are sought, not 0"),
        (["gravity"] * 2, "vary: gravity is named twice"),
        (["gravity", "start", "origin", "mass1.x", "mass1.y", "mass1.vx", "mass1.vy"], "not 7"),
        (["sideways"], "vary: sideways: there is no such setting"),
        (["angular_stiffness"], "vary: angular_stiffness: the scene 'swing' has no use for it"),
        (["dt"], "vary: dt cannot be fitted"),
        (["mass0.vx"], "vary: mass0.vx: mass 0 is held"),
        (["mass7.vx"], "mass7.vx: mass 7 does not exist"),
        (["spring3.stiffness"], r"vary: spring3.stiffness: spring 3 does not exist \(0..0\)"),
        (["spring0.colour"], "vary: spring0.colour: of a spring there are stiffness, damping, rest_length"),
        (["spring0.strength"], "vary: spring0.strength: spring 0 has none"),
    ],
)
def test_what_cannot_be_sought_is_refused(vary: list[str], said: str) -> None:
    data = measure(swing(), ["mass1.x"], 0.5, 0.0, random())
    with pytest.raises(sim.InputError, match=said):
        sim.fit(swing(), data, vary)


def test_what_cannot_be_compared_is_refused() -> None:
    data = measure(swing(), ["mass1.x"], 0.5, 0.0, random())
    few = Measurement("few.csv", data.time[:2], (Column("mass1.x", "px", data.columns[0].values[:2]),))
    early = Measurement("early.csv", data.time - 1.0, data.columns)
    late = Measurement("late.csv", data.time * 1e5, data.columns)
    euler = replace(swing(), integrator=sim.Integrator(method="symplectic_euler"))
    gravity: list[str] = ["gravity"]
    for scene, table, vary, named, why in (
        (swing(), few, [*gravity, "air_friction"], {}, "few.csv: 2 numbers are too few to tell 2 unknown"),
        (swing(), early, gravity, {}, "early.csv: the time begins at -1 s"),
        (swing(), data, gravity, {"scale": math.nan}, "scale: nan is not a positive number"),
        (swing(), "nowhere.csv", gravity, {}, "nowhere.csv: it cannot be read"),
        (euler, late, gravity, {}, "steps, more than 200000"),
    ):
        assert why in refusal(sim.InputError, sim.fit, scene, table, vary, **named)


@pytest.mark.parametrize("scale", [1.0, 30.0, 1000.0])
def test_an_interval_is_as_wide_at_any_scale(scale: float) -> None:
    """The stiffness is known by the period alone, whatever the unit of the places is."""
    rng, time = random(), np.arange(0.0, 5.0, 0.05)
    k, c = 20.0, 0.3
    measured = 0.05 * np.exp(-0.5 * c * time) * np.cos(math.sqrt(k - 0.25 * c * c) * time)
    column = Column("Weg", "m", measured + 3e-4 * rng.standard_normal(time.size))
    data = Measurement("a.csv", time, (column,))
    scene = spring_pendulum(1.0, k, c)
    vary = ["spring0.stiffness", "spring0.damping", "start", "origin"]
    found = sim.fit(scene, data, vary, {"Weg": "mass1.y"}, scale).values["spring0.stiffness"]
    assert found.high - found.low == pytest.approx(0.0273, rel=0.1)
    assert found.low < k < found.high


def test_places_that_hardly_move_and_one_number_for_springs_that_differ_are_doubted() -> None:
    scene = sim.load_scene("lesson-hooke")
    time = np.arange(0.0, 2.0, 0.05)
    column = Column("y", "m", 0.05 * np.cos(math.sqrt(20.0) * time))
    data = Measurement("a.csv", time, (column,))
    said = sim.fit(scene, data, ["linear_stiffness", "start", "origin"], {"y": "mass1.y"}, 1.0).sentences
    assert any("y moves by 0.1 px, in a body of " in one and "is the scale right?" in one for one in said)
    assert any(one.startswith("linear_stiffness is that of parts which differ") for one in said)


def test_the_torque_of_a_motor_is_found() -> None:
    """The start is slow, where the whole torque acts, and the end is not, where slip and speed matter."""
    motor = Motor(speed=720.0, torque=1e5, slip=200.0)
    data = measure(crank(motor), ["mass2.x", "mass2.y"], 1.0, 0.003, random())
    found = sim.fit(crank(replace(motor, torque=7e4)), data, ["joint0.motor.torque", "joint0.motor.speed"])
    torque = found.values["joint0.motor.torque"]
    assert torque.known and torque.low < 1e5 < torque.high < 1.01 * torque.low
    assert torque.unit == "kg px²/s²"
    assert found.values["joint0.motor.speed"].low < 720.0 < found.values["joint0.motor.speed"].high
    with pytest.raises(sim.InputError, match=r"joint0\.motor\.torque: joint 0 has none"):
        still = replace(crank(motor).angular_springs[0], motor=UNSET)
        sim.fit(replace(crank(motor), angular_springs=(still,)), data, ["joint0.motor.torque"])


def test_both_frictions_of_a_wall_are_found() -> None:
    """A block on a belt sticks until static friction gives way, and slips by that of sliding."""
    scene = sim.load_scene("stick-slip")
    data = measure(scene, ["mass1.x"], 2.5, 0.003, random())
    guess = set_value(set_value(scene, "wall_friction", 0.25), "static_friction", 0.7)
    found = sim.fit(guess, data, ["wall_friction", "static_friction"])
    for name, truth in (("wall_friction", 0.3), ("static_friction", 0.9)):
        each = found.values[name]
        assert each.known and each.low < truth < each.high < 1.02 * each.low, each


def test_what_few_independent_numbers_leave_within_a_factor_of_hundreds_is_not_known() -> None:
    """A block slides in air which the scene lacks: 61 numbers count as one."""
    wall = Wall(
        point=(0.0, 0.0), normal=(0.3, -1.0), friction=0.3, static_friction=0.5, tangential_hardness=1e5
    )  # fmt: skip
    slide = sim.Scene(
        name="slide", masses=(sim.Mass(position=(0.0, -1.0), velocity=(900.0, 270.0)),),
        gravity=(0.0, 1000.0), walls=(wall,),
    )  # fmt: skip
    data = measure(replace(slide, air_friction=5e-3), ["mass0.x"], 2.0, 0.003, random())
    found = sim.fit(slide, data, ["wall_friction", "static_friction"])
    friction, static = found.values["wall_friction"], found.values["static_friction"]
    assert not friction.known and friction.low < 0.03 and friction.high > 30.0
    assert "The data do not tell wall_friction: whatever it is, the fit is as good." in found.sentences
    assert not static.known and static.value == pytest.approx(0.5)
