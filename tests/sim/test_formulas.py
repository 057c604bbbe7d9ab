"""Formulas of quantities: their values and units, what is refused, and quantities of the whole body."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim import InputError, Simulation, quantity
from sim.design.matching import matched
from sim.design.measurements import parse_measurements
from sim.motion.dimensions import IN_ASCII, Dimension, dimension_of, read_unit
from sim.motion.formulas import MAX_DEPTH, MAX_LENGTH
from sim.motion.quantities import KINDS
from sim.scene.parts import Circle
from tests.sim.bodies import tangle
from tests.sim.builders import chain, rod, spinning
from tests.sim.changes import by
from tests.sim.checks import refusal

SCENE = tangle(3)


def moved(scene: sim.Scene = SCENE, steps: int = 50) -> Simulation:
    simulation = Simulation(scene)
    simulation.step(steps)
    return simulation


BODY = moved()


def read(name: str, simulation: Simulation = BODY) -> float:
    return quantity(name, simulation.scene).read(simulation)


# ------------------------------------------------------------------------- the whole body
def moment(m: np.ndarray, x: np.ndarray, v: np.ndarray) -> float:
    return float((m * (x[:, 0] * v[:, 1] - x[:, 1] * v[:, 0])).sum())


def sums(simulation: Simulation, masses: list[int]) -> dict[str, float]:
    """The same in plain NumPy, from positions and velocities of the scene's masses."""
    m = np.array([simulation.scene.masses[i].mass for i in masses])
    x, v = simulation.positions[masses], simulation.velocities[masses]
    centre, mean = (m @ x) / m.sum(), (m @ v) / m.sum()
    spin = moment(m, x - centre, v - mean)
    return {
        "mass": float(m.sum()), "x": centre[0], "y": centre[1], "vx": mean[0], "vy": mean[1],
        "momentum_x": float(m @ v[:, 0]), "momentum_y": float(m @ v[:, 1]), "angular_momentum": spin,
        "angular_momentum_about_origin": moment(m, x, v),
    }  # fmt: skip


def test_the_body_s_quantities_are_sums_over_its_masses() -> None:
    whole = list(range(len(SCENE.masses)))
    for name, masses in (("body", whole), ("body[1,2..4,4]", [1, 2, 3, 4]), ("body[ 3 ]", [3])):
        for what, value in sums(BODY, masses).items():
            assert read(f"{name}.{what}") == pytest.approx(value, rel=1e-12, abs=1e-9), (name, what)
    assert {what for of, what in KINDS if of == "body"} == set(sums(BODY, whole))
    m, v = SCENE.masses[5].mass, BODY.velocities[5]
    assert [read(f"mass5.{of}") for of in ("mass", "momentum_x", "momentum_y")] == [m, *(m * v)]
    assert quantity("body[1, 2..4].x", SCENE).name == "body[1,2..4].x"


def test_without_outer_forces_both_momenta_stay() -> None:
    free = replace(
        SCENE, anchors=(), gravity=(0.0, 0.0), air_friction=0.0,
        integrator=sim.Integrator(method="velocity_verlet", dt=1e-4),
    )  # fmt: skip
    names = ("body.momentum_x", "body.momentum_y", "body.angular_momentum_about_origin")
    spin = ("body.angular_momentum", "body.mass")
    run = Simulation(free).record(0.2, *names, *spin, "energy.kinetic", every=100)
    size = np.abs(run["energy.kinetic"]).max()
    assert np.ptp(run["energy.kinetic"]) > 1e-3 * size, "it moves"
    scale = math.sqrt(2.0 * size * run["body.mass"][0])
    for name in names[:2]:
        assert np.ptp(run[name]) < 1e-9 * scale
    for name in (names[2], spin[0]):
        assert np.ptp(run[name]) < 1e-9 * scale * 1e3


def test_a_held_mass_has_the_momentum_of_its_hand() -> None:
    scene = chain([(0.0, 0.0), (50.0, 0.0)], stiffness=100.0, rest_length=50.0, held=(0,), mass=2.0)
    still = moved(scene, 100)
    assert read("mass0.momentum_x", still) == 0.0
    led = (replace(scene.anchors[0], circle=Circle(radius=10.0, frequency=1.0)),)
    turning = moved(replace(scene, anchors=led), 100)
    assert read("mass0.momentum_x", turning) == 2.0 * turning.velocities[0, 0] != 0.0
    assert read("body.momentum_x", turning) == pytest.approx(2.0 * turning.velocities[:, 0].sum())


# ------------------------------------------------------------------------- values and units
def values() -> dict[str, tuple[float, str]]:
    (x0, y0), (x1, y1) = BODY.positions[:2]
    (u0, w0), _ = BODY.velocities[:2]
    angle, rate, torque = (read(f"joint0.{of}") for of in ("angle", "rate", "torque"))
    m1 = SCENE.masses[1].mass
    return {
        "mass1.y - mass0.y": (y1 - y0, "px"),
        "mass1.y-mass0.y+mass1.y": (y1 - y0 + y1, "px"),
        "energy.kinetic / mass1.mass": (BODY.energy().kinetic / m1, "px²/s²"),
        "sqrt(mass0.vx^2 + mass0.vy^2)": (math.hypot(u0, w0), "px/s"),
        "(mass0.vx^2+mass0.vy^2)^(1/2)": (math.hypot(u0, w0), "px/s"),
        "-mass0.x^2": (-(x0**2), "px²"),
        "(-mass0.x)^-2": (x0**-2, "1/px²"),
        "abs(-mass0.x)": (abs(x0), "px"),
        "mass1.x / mass0.x * 2": (x1 / x0 * 2.0, ""),
        "mass1.x / (mass0.x * 2)": (x1 / (x0 * 2.0), ""),
        "mass0.x + 5 [px]": (x0 + 5.0, "px"),
        "mass0.vy + 1.5e1 [px/s^2] * 2 [s]": (w0 + 30.0, "px/s"),
        "mass0.vx * 1 [s/px]": (u0, ""),
        "atan2(mass1.y - mass0.y, mass1.x - mass0.x)": (math.degrees(math.atan2(y1 - y0, x1 - x0)), "°"),
        "sin(joint0.angle)": (math.sin(math.radians(angle)), ""),
        "cos(joint0.angle + 1 [rad])": (math.cos(math.radians(angle) + 1.0), ""),
        "joint0.torque * joint0.rate / 1 [rad]": (torque * math.radians(rate), "kg px²/s³"),
        "joint0.rate * mass1.mass": (rate * m1, "kg °/s"),
        "sqrt(mass1.mass) / mass0.x": (math.sqrt(m1) / x0, "kg^0.5/px"),
        "1 / (mass1.mass * mass0.x)": (1.0 / (m1 * x0), "1/(kg px)"),
        "2^-1 * mass0.x": (x0 / 2.0, "px"),
        "body[0,1].x - mass0.x": (read("body[0,1].x") - x0, "px"),
        "stability.dt_over_limit * 100": (100.0 * read("stability.dt_over_limit"), ""),
    }


def test_formulas_have_the_values_and_units_of_what_they_say() -> None:
    for text, (value, unit) in values().items():
        found = quantity(text, SCENE)
        assert found.name == text
        assert found.unit == unit, text
        assert found.read(BODY) == pytest.approx(value, rel=1e-8 if "stab" in text else 1e-12), text


def test_in_metres_forces_and_energies_are_in_n_and_j() -> None:
    scene = replace(SCENE, view=sim.View(unit="m"))
    assert quantity("mass0.mass * mass0.ax", scene).unit == "N"
    assert quantity("spring0.force * spring0.elongation", scene).unit == "J"
    assert quantity("spring0.force + 3 [N] + 1 [J/m]", scene).unit == "N"
    assert quantity("joint0.torque * joint0.rate", scene).unit == "kg m² °/s³"


def test_units_of_all_quantities_are_read_and_written_alike() -> None:
    for kind in KINDS.values():
        assert dimension_of(kind.unit).unit == kind.unit
    for powers in ((2, -2, 0, 1), (-1, 3, 4, -18), (0, 0, -2, 0), (18, 5, 6, 8)):
        unit = Dimension(*powers).unit.format(unit="mm")
        for text in (unit, unit.translate(IN_ASCII)):
            assert read_unit(text, "mm") == (1.0, powers)


def test_brackets_spaces_and_single_names() -> None:
    assert quantity(" ( (mass0.x) ) ", SCENE) == quantity("mass0.x", SCENE)
    assert quantity("mass1.x   -  mass0.x", SCENE).name == "mass1.x - mass0.x"


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("mass0.x + mass0.vx", "'mass0.x' (px) and 'mass0.vx' (px/s) cannot be added: their units differ"),
        (
            "mass0.x * 2 - mass0.y^2",
            "'mass0.x * 2' (px) and 'mass0.y^2' (px²) cannot be subtracted: their units differ",
        ),
        (
            "mass0.x + 5",
            "'5' (a pure number) cannot be added: their units differ; a number has a unit as in 5 [px]",
        ),
        (
            "sin(30)*mass0.x",
            "sin is of an angle, and not of '30' (a pure number); a number is one as in 30 [°]",
        ),
        ("sin(mass0.x)", "sin is of an angle, and not of 'mass0.x' (px)"),
        ("atan2(mass0.x, 2)", "the same unit, and not of 'mass0.x' (px) and '2' (a pure number)"),
        ("atan2(mass0.x)", "atan2 is of two values, and not of 1"),
        ("abs(mass0.x, mass0.x)", "abs is of one value, and not of 2"),
        ("mass0.x^mass0.x", "the exponent 'mass0.x' is not a pure number without a quantity"),
        ("mass0.x^0.3", "the exponent '0.3' is not a multiple of 1/2"),
        ("mass0.x^(1/0)", "the exponent '(1/0)' is not a multiple of 1/2"),
        ("mass0.x^1e300", "is not a multiple of 1/2 up to 99"),
        ("mass0.x^9 * mass0.x", "'mass0.x^9 * mass0.x' has a unit with a power beyond 9"),
        ("sqrt(sqrt(mass0.x))", "'sqrt(sqrt(mass0.x))' has a unit with a power that is no multiple of 1/2"),
        ("2 + 3", "'2 + 3': a formula has at least one quantity"),
        ("9,81*mass0.x", "'9,81' has a comma: in a formula a number is written with a point, as 9.81"),
        ("mass0.x + 12,5 [px]", "'12,5' has a comma: in a formula a number is written with a point"),
        ("abs(2,5*mass0.x)", "'2,5' has a comma: in a formula a number is written with a point"),
        ("atan2(1,5)", "'atan2(1,5)': a formula has at least one quantity"),
        ("mass0.x, mass0.y", "',' is not expected after 'mass0.x'"),
        ("2 mass0.x", "'mass0.x' is not expected after '2'"),
        ("* mass0.x", "'*' is not expected at the beginning"),
        ("mass0.x +", "'mass0.x +': something is missing at the end"),
        ("(mass0.x", "'(mass0.x': something is missing at the end"),
        ("mass0.x)", "')' is not expected after 'mass0.x'"),
        ("mass0.x + 1 [furlong]", "'furlong' is not a unit made of kg, px, s, °, deg, rad, as px/s^2 is"),
        ("mass0.x + 1 []", "'' is not a unit"),
        ("mass0.x ** 2", "'*' is not expected after 'mass0.x *'"),
        ("tan(joint0.angle)", "'tan' is not a function: there are abs, atan2, cos, sin, sqrt"),
        ("mass0.x + mass99.x", "mass99.x: mass 99 does not exist"),
        ("mass0.x + pi", "'pi' is not a quantity: it begins with one of"),
        ("mass0.x; 1 + 1", "';' has no place in a formula"),
        ("mass0.x + 1e999", "1e999 is not a finite number"),
        ("-" * (MAX_DEPTH + 1) + "mass0.x", f"there are more than {MAX_DEPTH} brackets, signs or exponents"),
        ("(" * 99 + "mass0.x" + ")" * 94, f"there are more than {MAX_DEPTH} brackets, signs or exponents"),
        ("mass0.x + " * 20 + "1", f"named in at most {MAX_LENGTH} letters, and not in 201"),
        ("body3.x", "'body3.x' is not a quantity: body has no number"),
        ("mass[1,2].x", "'mass[1,2].x' is not a quantity: mass needs a number"),
        ("energy[1].kinetic", "'energy[1].kinetic' is not a quantity: energy has no number"),
        ("body[3..1].x", "'body[3..1].x' is not a quantity: 3..1 goes backwards"),
        ("body[1,,2].x", "'body[1,,2].x' is not a quantity: masses are named as in body[2,5..7]"),
        ("body[0..99].x", "body[0..99].x: mass 99 does not exist (0.."),
    ],
)
def test_what_is_no_formula_is_refused_in_one_sentence(text: str, sentence: str) -> None:
    assert sentence in refusal(InputError, quantity, text, SCENE)


# ------------------------------------------------------------------------- gaps, angles, energies
def test_where_there_is_no_value_a_table_has_an_empty_cell(tmp_path: Path) -> None:
    run = moved(steps=0).record(
        0.01, "1 / (mass0.x - mass0.x)", "sqrt(-mass0.mass)", "atan2(mass0.x, mass0.y)"
    )
    assert np.isnan(run["1 / (mass0.x - mass0.x)"]).all()
    run.to_csv(tmp_path / "a.csv")
    with (tmp_path / "a.csv").open(newline="") as file:
        header, first, *_ = csv.reader(file)
    assert header == [
        "time [s]", "1 / (mass0.x - mass0.x) [1/px]", "sqrt(-mass0.mass) [kg^0.5]",
        "atan2(mass0.x, mass0.y) [deg]",
    ]  # fmt: skip
    assert first[1:3] == ["", ""]
    assert math.isfinite(float(first[3]))
    assert math.isnan(read("1e300^2 * mass0.x"))


def test_sums_of_angles_go_on_beyond_half_a_turn_and_nothing_else() -> None:
    names = ("spring0.direction", "90 [deg] - spring0.direction", "spring0.direction / 2")
    run = Simulation(spinning(9.0)).record(1.0, *names, every=50)
    turned = run["spring0.direction"]
    assert np.ptp(turned) > 400.0
    assert run[names[1]] == pytest.approx(90.0 - turned)
    assert run[names[2]] == pytest.approx(((turned + 180.0) % 360.0 - 180.0) / 2.0)
    for text in ("joint0.angle - joint1.angle", "-joint0.angle", "joint0.angle + joint1.rest_angle"):
        assert quantity(text, rod(5)).unwrapped
    for text in ("joint0.angle + joint1.angle / 2", "joint0.rest_angle + 1 [°]", "2 * joint0.angle"):
        assert not quantity(text, rod(5)).unwrapped


def test_formulas_say_what_is_measured_for_them() -> None:
    found = quantity("energy.kinetic / mass1.mass + 0 * energy.kinetic / mass1.mass", SCENE)
    assert [each.name for each in found.measured] == ["energy.kinetic", "mass1.mass"]
    assert found.is_of("energy") and found.is_of("mass") and not found.is_of("spring")
    assert quantity("mass1.x", SCENE).measured == (quantity("mass1.x", SCENE),)


# ------------------------------------------------------------------------- fits
@pytest.mark.parametrize("comma", [False, True])
def test_a_table_of_formulas_comes_back_bit_for_bit(comma: bool, tmp_path: Path) -> None:
    names = (
        "mass1.x - mass0.x", "-mass1.y", "sqrt(mass1.vx^2 + mass1.vy^2)", "mass1.x / mass2.x", "body[0,2].x",
        "atan2(mass1.y, mass1.x)", "sin(joint0.angle)", "mass1.mass * mass1.ax^2", "mass1.vy + 3 [px/s]",
    )  # fmt: skip
    scene = by(SCENE, "rk4", dt=1e-3)
    recording = Simulation(replace(scene, anchors=())).record(0.05, *names)
    recording.to_csv(tmp_path / "own.csv", comma)
    (found,) = sim.read_measurements(tmp_path / "own.csv")
    matches = matched(found, replace(scene, anchors=()))
    assert [match.text for match in matches] == list(names)
    for match in matches:
        column = recording[match.text]
        assert (match.column.values == match.sign * recording[match.text] * match.sign).all()
        assert np.isfinite(column).all()
        assert match.unit.factor == 1.0
        assert match.scale == 1.0


def test_a_stiffness_is_fitted_to_a_formula_and_one_without_a_value_is_refused() -> None:
    ends = [(0.0, 0.0), (55.0, 0.0)]
    scene = by(chain(ends, stiffness=100.0, rest_length=50.0, held=(0,)), "rk4", dt=5e-3)
    true = replace(scene, linear_springs=(replace(scene.linear_springs[0], stiffness=130.0),))
    text = "(mass1.x - mass0.x)^2 / 2"
    run = Simulation(true).record(0.5, text, every=5)
    rows = "".join(f"{t},{x}\n" for t, x in zip(run.time, run[text], strict=True))
    (table,) = parse_measurements(f"t,d (px^2)\n{rows}".encode(), "a.csv")
    found = sim.fit(scene, table, ["spring0.stiffness"], {"d": text})
    assert found.values["spring0.stiffness"].value == pytest.approx(130.0, rel=1e-4)
    said = refusal(InputError, sim.fit, scene, table, ["spring0.stiffness"], {"d": f"{text} / 0"})
    assert said == "fit: the scene runs away, or a formula has no value, within the time that was measured"
    assert "'m' is not a unit of it" in refusal(
        InputError, matched, parse_measurements(b"t,d (m)\n0,1\n1,2\n", "a.csv")[0], scene, {"d": text}
    )


# ------------------------------------------------------------------------- any text
WORDS = st.sampled_from(
    [
        "mass0.x", "mass1.vy", "joint0.angle", "energy.kinetic", "body.mass", "body[0..2].x", "body[",
        "spring0.", "sqrt", "abs", "sin", "cos", "atan2", "(", ")", "+", "-", "*", "/", "^", ",", " ", "0",
        "1", "2", "0.5", "1e300", "1e-300", "[px]", "[px/s]", "[", "]", "[rad]", ".", "..", "9", "__class__",
        "eval", "²", "\n",
    ]
)  # fmt: skip
TEXTS = st.lists(WORDS, max_size=30).map("".join) | st.text(max_size=MAX_LENGTH + 5)


@st.composite
def formulas(draw: st.DrawFn, depth: int = 4) -> str:
    """Formulas that are well formed but for their units."""
    if depth == 0 or draw(st.integers(0, 3)) == 0:
        return draw(st.sampled_from(["mass0.x", "mass1.x", "joint0.angle", "2", "3 [px]", "body.vx", "0"]))
    kind = draw(st.sampled_from(["+", "-", "*", "/", "^", "f", "(", "neg"]))
    one = draw(formulas(depth - 1))
    if kind == "f":
        return f"{draw(st.sampled_from(['abs', 'sqrt', 'sin', 'cos']))}({one})"
    if kind == "neg":
        return f"-{one}"
    if kind == "^":
        return f"({one})^{draw(st.sampled_from(['2', '-1', '0.5', '(1/2)', '-3', '9']))}"
    return f"({one})" if kind == "(" else f"{one} {kind} {draw(formulas(depth - 1))}"


@given(TEXTS | formulas())
@example("(" * 200)
@example("-" * 200)
@example("mass0.x^" + "2^" * 90)
@example("1+" * 96 + "mass0.x")
@example("+".join(["mass0.x"] * 25))
@example("sqrt(" * 33 + "mass0.x")
@example("1e300*1e300*mass0.x")
@example("0*" * 96 + "mass0.x")
def test_any_text_is_a_quantity_with_a_value_or_refused_in_one_sentence(text: str) -> None:
    try:
        found = quantity(text, SCENE)
    except InputError as error:
        said = str(error)
        assert said
        assert "\n" not in said
        assert len(said) < 800
        return
    value = found.read(BODY)
    assert type(value) is float
    assert not math.isinf(value)
    assert quantity(found.name, SCENE) == found
    assert len(found.name) <= MAX_LENGTH
    assert "{" not in found.unit
    assert read_unit(found.unit, "px")[1] == found.dimension if found.unit else True
