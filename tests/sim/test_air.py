"""Air friction: the same in all directions, by the tutorial's axes, or in proportion to the speed."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Mass, Scene, Simulation
from sim.analysis.tuning import tuning
from sim.edit.terrain import on_terrain
from sim.scene.makers import fine_rope
from sim.scene.surroundings import Wind
from sim.scene.types import AirLaw, Method
from sim.settings import CHOICES, apply_assignments, set_choice, setting_of, settings_of
from sim.store.files import decode_link, decode_scene, encode_scene
from sim.store.link import pack_scene
from tests.sim.arrays import Arrays
from tests.sim.builders import built
from tests.sim.changes import by

LAWS: tuple[AirLaw, ...] = get_args(AirLaw)
METHODS: tuple[Method, ...] = get_args(Method)
WAYS = np.exp(2j * math.pi * np.arange(8) / 8.0)
"""Along both axes, and between them."""
FAST, FRICTION, HEAVY = 1000.0, 0.002, 1.5
"""The speed, px/s, of masses of so many kg that are thrown through air of this friction."""
AT = {"tolerance": 1e-4, "dt": 5e-4}


def thrown(law: AirLaw, method: Method = "auto", friction: float = FRICTION, **fields: Any) -> Scene:
    """A mass thrown out of the origin in each of eight ways, nothing but air around them."""
    masses = tuple(
        Mass(position=(0.0, 0.0), velocity=(FAST * way.real, FAST * way.imag), mass=HEAVY) for way in WAYS
    )
    return by(Scene(name="thrown", masses=masses, air_friction=friction, air_law=law, **fields), method, **AT)


def after(scene: Scene, seconds: float = 1.0) -> Simulation:
    """The simulation of a scene after a while, with its energy balance."""
    simulation = Simulation(scene)
    simulation.track_energy(True)
    simulation.advance(seconds)
    return simulation


def slowed(friction: float, seconds: float = 1.0) -> tuple[float, float]:
    """How far a mass is by quadratic friction, px, and how fast, px/s."""
    growth = 1.0 + friction * FAST * seconds / HEAVY
    return HEAVY / friction * math.log(growth), FAST / growth


# ------------------------------------------------------------------------- closed forms
@pytest.mark.parametrize("method", METHODS)
def test_air_brakes_alike_in_all_directions(method: Method) -> None:
    first_order = method in ("symplectic_euler", "stable_spring")
    simulation = after(thrown("isotropic", method))
    far, fast = slowed(FRICTION)
    along = (simulation.positions @ (1.0, 1j)) / WAYS
    assert np.ptp(along.real) <= 1e-9
    assert np.abs(along.imag).max() <= 1e-9
    assert along.real == pytest.approx(far, rel=1e-3 if first_order else 1e-6)
    assert np.hypot(*simulation.velocities.T) == pytest.approx(fast, rel=1e-3 if first_order else 1e-6)
    balance = simulation.energy()
    lost = 0.5 * HEAVY * len(WAYS) * (fast**2 - FAST**2)
    assert balance.air == pytest.approx(lost, rel=3e-3 if first_order else 1e-5)
    assert abs(balance.residual) <= (3e-3 if first_order else 1e-5) * -lost


@pytest.mark.parametrize("method", METHODS)
def test_linear_air_takes_the_same_part_of_any_speed(method: Method) -> None:
    first_order, friction = method in ("symplectic_euler", "stable_spring"), 1.2
    simulation = after(thrown("linear", method, friction))
    left = math.exp(-friction / HEAVY)
    far, rel = HEAVY * FAST / friction * (1.0 - left), 1e-3 if first_order else 1e-6
    assert (simulation.positions @ (1.0, 1j)) / WAYS == pytest.approx(far, rel=rel)
    assert (simulation.velocities @ (1.0, 1j)) / WAYS == pytest.approx(FAST * left, rel=rel)
    lost = 0.5 * HEAVY * len(WAYS) * FAST**2 * (left**2 - 1.0)
    assert simulation.energy().air == pytest.approx(lost, rel=3 * rel)
    assert abs(simulation.energy().residual) <= 3 * rel * -lost


def test_the_tutorials_air_brakes_each_axis_by_itself() -> None:
    places = after(thrown("tutorial")).positions @ (1.0, 1j)
    far, _ = slowed(FRICTION)
    # Between the axes, each component begins with less, and loses less.
    growth = 1.0 + FRICTION * FAST * math.sqrt(0.5) / HEAVY
    between = math.sqrt(2.0) * HEAVY / FRICTION * math.log(growth)
    assert np.abs(places[::2]) == pytest.approx(far, rel=1e-6)
    assert np.abs(places[1::2]) == pytest.approx(between, rel=1e-6)
    assert between > 1.08 * far


@pytest.mark.parametrize("law", LAWS)
def test_a_mass_falls_at_last_at_the_speed_at_which_air_bears_it(law: AirLaw) -> None:
    friction = 1.0 if law == "linear" else 0.01
    pull = 500.0 * np.array((0.6, 0.8))
    scene = Scene(
        name="falls", masses=(Mass(position=(0.0, 0.0), mass=2.0),), gravity=(pull[0], pull[1]),
        air_friction=friction, air_law=law,
    )  # fmt: skip
    last = {
        "isotropic": math.sqrt(2.0 * 500.0 / friction) * np.array((0.6, 0.8)),
        "tutorial": np.sqrt(2.0 * pull / friction),
        "linear": 2.0 * pull / friction,
    }[law]
    assert after(by(scene, "auto", tolerance=1e-3), 30.0).velocities[0] == pytest.approx(last, rel=1e-4)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("method", ["rk4", "generalized_alpha", "adams"])
def test_steady_wind_is_air_seen_from_a_frame_that_moves(law: AirLaw, method: Method) -> None:
    friction, wind = (1.2 if law == "linear" else FRICTION), np.array((300.0, -80.0))
    still = thrown(law, method, friction)
    carried = tuple(
        replace(m, velocity=(m.velocity[0] + wind[0], m.velocity[1] + wind[1])) for m in still.masses
    )
    blown = replace(still, masses=carried, wind=Wind(velocity=(wind[0], wind[1])))
    one, other = after(still), after(blown)
    assert np.abs(one.positions + wind - other.positions).max() <= 1e-3
    assert abs(other.energy().residual) <= 1e-5 * abs(other.energy().kinetic)


# ------------------------------------------------------------------------- derivatives
SPEEDS = [(0.0, 0.0), (300.0, 0.0), (0.0, -200.0), (-120.0, 50.0)]


@pytest.mark.parametrize("wind", [None, Wind(velocity=(40.0, -9.0))])
@pytest.mark.parametrize("law", LAWS)
def test_the_derivative_by_velocity_is_that_of_the_force(law: AirLaw, wind: Wind | None) -> None:
    masses = tuple(Mass(position=(9.0 * i, 0.0), velocity=v, mass=HEAVY) for i, v in enumerate(SPEEDS))
    arrays = Arrays(Scene(name="loose", masses=masses, air_friction=0.2, air_law=law, wind=wind))
    expected = np.zeros((8, 8))
    for i, velocity in enumerate(SPEEDS):
        u = np.array(velocity) - (wind.velocity if wind else 0.0)
        speed = float(np.hypot(*u))
        block = {
            "isotropic": speed * np.eye(2) + (np.outer(u, u) / speed if speed else 0.0),
            "tutorial": 2.0 * np.diag(abs(u)),
            "linear": np.eye(2),
        }[law]
        expected[np.ix_((i, 4 + i), (i, 4 + i))] = -0.2 * block / HEAVY
    product = np.array([arrays.resistance(row, 1.0, np.zeros(8)) for row in np.eye(8)]).T
    assert product == pytest.approx(expected, rel=1e-12, abs=1e-12)
    g = 3.0
    assert arrays.matrix_of(g * g, g) == pytest.approx(g * g * np.eye(8) - g * expected, rel=1e-9, abs=1e-9)


# ------------------------------------------------------------------------- small vibrations, and large steps
def test_only_linear_air_damps_small_vibrations() -> None:
    ends: list[tuple[float, float]] = [(0.0, 0.0), (100.0, 0.0)]
    for law, ratio in (
        ("isotropic", 0.0),
        ("tutorial", 0.0),
        ("linear", 2.0 / (2.0 * math.sqrt(400.0 * 4.0))),
    ):
        scene = built(ends, mass=4.0, stiffness=400.0, rest_length=100.0, held=(0,), air_friction=2.0)
        found = tuning(replace(scene, air_law=law)).slowest
        assert found is not None
        assert found.damping_ratio == pytest.approx(ratio, rel=1e-6, abs=1e-9)


def test_linear_air_limits_the_step_of_explicit_methods() -> None:
    # Symplectic Euler multiplies the speed of a loose mass by 1 - c h / m.
    scene = by(thrown("linear", friction=1.0), "symplectic_euler", dt=1e-3)
    assert Simulation(scene).stability().limit > 1.0
    stiff = replace(scene, air_friction=900.0)
    assert Simulation(stiff).stability().limit == pytest.approx(2.0 * HEAVY / 900.0, rel=0.01)


# ------------------------------------------------------------------------- files
def old_file(**fields: Any) -> bytes:
    """A file of format 3, unless the fields say otherwise."""
    raw = json.loads(encode_scene(thrown("isotropic")))
    del raw["air_law"]
    return json.dumps({**raw, "format": 3, **fields}).encode()


@pytest.mark.parametrize("version", [1, 2, 3])
def test_older_files_keep_the_tutorials_law(version: int, tmp_path: Path) -> None:
    scene = decode_scene(old_file(format=version, force_law="conservative"), "file")
    assert scene == replace(thrown("tutorial"))
    # Also those in which a step of a lesson, or a log, brings the air.
    assert decode_scene(old_file(format=version, air_friction=0), "file").air_law == "tutorial"
    assert decode_scene(encode_scene(scene), "again") == scene
    assert decode_link(pack_scene(scene)) == scene


def test_new_files_say_their_law() -> None:
    for law in LAWS:
        scene = thrown(law)
        assert json.loads(encode_scene(scene))["air_law"] == law
        assert decode_link(pack_scene(scene)) == scene
    assert decode_scene(old_file(format=4), "file").air_law == "isotropic"
    with pytest.raises(sim.SceneError, match="air_law"):
        decode_scene(old_file(format=4, air_law="cubic"), "file")


def test_only_the_tutorials_scenes_have_its_law() -> None:
    assert sim.rope().air_law == fine_rope(9).air_law == "tutorial"
    assert sim.tree().air_law == sim.cloth().air_law == "isotropic"
    for info in sim.list_scenes():
        if info.built_in:
            law = "tutorial" if info.name.startswith(("tutorial-", "study-")) else "isotropic"
            assert sim.load_scene(info.name).air_law == law, info.name


def test_a_race_has_the_air_of_its_terrain() -> None:
    assert on_terrain(sim.tree(), sim.rope()).air_law == "tutorial"


# ------------------------------------------------------------------------- settings
def test_the_friction_of_linear_air_has_its_own_unit_and_range() -> None:
    assert setting_of(thrown("isotropic"), "air_friction").unit == "kg/px"
    linear = setting_of(thrown("linear"), "air_friction")
    assert (linear.unit, linear.slider[1]) == ("kg/s", 25.0)
    assert linear in settings_of(thrown("linear"))
    changed = apply_assignments(thrown("isotropic"), ("air_law=linear", "air_friction=3"))
    assert changed == thrown("linear", friction=3.0)


def test_another_law_brakes_as_strongly_at_a_typical_speed() -> None:
    scene = thrown("isotropic", gravity=(0.0, 2000.0))
    linear = set_choice(scene, "air_law", "linear")
    assert linear.air_friction == FRICTION * 1000.0  # 300 px down are 1095 px/s
    assert set_choice(linear, "air_law", "tutorial") == replace(scene, air_law="tutorial")
    assert set_choice(thrown("isotropic"), "air_law", "linear").air_friction == FRICTION * 100.0
    # In metres, and as far as it goes.
    small = replace(scene.view, unit="m", frame=(0.0, 0.0, 2.0, 2.0))
    small = replace(scene, gravity=(0.0, 9.81), air_friction=0.1, view=small)
    assert set_choice(small, "air_law", "linear").air_friction == 0.1
    assert set_choice(replace(scene, air_friction=20.0), "air_law", "linear").air_friction == 1000.0


def test_the_law_is_shown_where_there_is_air() -> None:
    choice = CHOICES["air_law"]
    assert choice.applies(thrown("linear", friction=0.0))
    assert choice.shown(thrown("linear"))
    assert not choice.shown(thrown("linear", friction=0.0))
