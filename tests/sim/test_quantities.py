"""What can be measured of a body, recordings of it, and what is read off curves, against closed forms."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import InputError, Simulation, quantity
from sim.analysis.swings import swings
from sim.forces.reference import Physics
from sim.motion.energy import ENERGY_FIELDS
from sim.settings import scene_of_run
from tests.sim.bodies import tangle
from tests.sim.builders import built, chain, rod
from tests.sim.changes import by, with_joints
from tests.sim.checks import known, refusal


def read(simulation: Simulation, name: str) -> float:
    return quantity(name, simulation.scene).read(simulation)


def oscillator(damping: float = 0.0, stiffness: float = 100.0) -> Simulation:
    """A mass of 2 kg on a horizontal spring, 5 px beyond its rest length of 50 px."""
    scene = chain(
        [(0.0, 0.0), (55.0, 0.0)], stiffness=stiffness, damping=damping, rest_length=50.0, held=(0,), mass=2.0
    )
    return Simulation(by(scene, "rk4", dt=1e-3))


def pendulum(degrees: float = 3.0) -> Simulation:
    """Two springs that are nearly rods, of which the first is held and hangs down: joint0 swings."""
    angle = math.radians(degrees)
    ends = [(0.0, 0.0), (0.0, 100.0), (100.0 * math.sin(angle), 100.0 + 100.0 * math.cos(angle))]
    scene = chain(ends, stiffness=1e8, rest_length=100.0, held=(0, 1), gravity=(0.0, 1000.0))
    joint = sim.AngularSpring(a=0, b=1, stiffness=0.0)
    tight = sim.Integrator(method="rodas5p", tolerance=1e-6, dt=1e-3)
    return Simulation(replace(scene, angular_springs=(joint,), integrator=tight))


# ------------------------------------------------------------------------- angles beyond half a turn
def simple_pendulum(degrees: float) -> Simulation:
    """A mass 1 m below an anchor, in metres, let go so far from there."""
    angle = math.radians(degrees)
    scene = chain(
        [(0.0, 0.0), (math.sin(angle), math.cos(angle))], stiffness=1e5, rest_length=1.0, held=(0,),
        gravity=(0.0, 9.8),
    )  # fmt: skip
    return Simulation(by(scene, "rk4", dt=1e-3))


@pytest.mark.parametrize(("degrees", "period"), [(100.0, 2.4732), (120.0, 2.7555), (150.0, 3.5369)])
def test_a_pendulum_that_swings_beyond_half_a_turn_has_its_period_and_reach(
    degrees: float, period: float
) -> None:
    recording = simple_pendulum(degrees).record(12.0, "spring0.direction", "spring0.wrapped_direction")
    found = known(swings(recording.time, recording["spring0.direction"]))
    assert found.period == pytest.approx(period, abs=1e-3)
    assert recording["spring0.direction"].max() == pytest.approx(90.0 + degrees, abs=0.2)
    assert recording["spring0.direction"].min() == pytest.approx(90.0 - degrees, abs=0.2)
    assert np.abs(recording["spring0.wrapped_direction"]).max() <= 180.0


@pytest.mark.parametrize("every", [1, 700])
def test_a_joint_that_spins_counts_its_turns_however_seldom_it_is_noted(every: int) -> None:
    # The second spring turns at 10 rad/s, without weight.
    moving = [(0.0, 0.0), (0.0, 0.0), (0.0, 1000.0)]
    places = [(0.0, 0.0), (100.0, 0.0), (200.0, 0.0)]
    scene = built(
        places, velocities=moving, stiffness=1e7, rest_length=100.0, held=(0, 1), joint={"stiffness": 0.0}
    )
    simulation = Simulation(by(scene, "rk4", dt=1e-4))
    angles = simulation.record(2.1, "joint0.angle", every=every)
    right = math.degrees(10.0) * angles.time
    assert angles["joint0.angle"] == pytest.approx(right, rel=1e-3, abs=1e-2)
    assert angles["joint0.angle"][-1] == pytest.approx(1203.2, abs=2.0)


# ------------------------------------------------------------------------- what is read
@pytest.mark.parametrize("seed", [1, 2])
def test_forces_and_torques_are_those_that_move_the_masses(seed: int) -> None:
    scene = tangle(seed)
    simulation = Simulation(with_joints(scene, damping=lambda j, _: 3.0 + j))
    simulation.step(20)
    x, forces = simulation.positions @ (1.0, 1j), np.zeros(len(scene.masses), complex)
    for s, spring in enumerate(scene.linear_springs):
        along = x[spring.b] - x[spring.a]
        assert read(simulation, f"spring{s}.length") == pytest.approx(abs(along))
        pull = read(simulation, f"spring{s}.force") * along / abs(along)
        forces[spring.a] += pull
        forces[spring.b] -= pull
    for j, joint in enumerate(scene.angular_springs):
        for s, sign in ((joint.a, 1j), (joint.b, -1j)):
            spring = scene.linear_springs[s]
            along = x[spring.b] - x[spring.a]
            push = sign * read(simulation, f"joint{j}.torque") * along / abs(along) ** 2
            forces[spring.a] -= push
            forces[spring.b] += push
    system, state = simulation.tables
    wanted = Physics(system.body, state).forces(state.x + 1j * state.y, state.vx + 1j * state.vy)
    assert forces == pytest.approx(wanted[system.mass_index], rel=1e-9, abs=1e-6)


def test_masses_and_rates_are_what_the_simulation_says() -> None:
    simulation = Simulation(tangle(3))
    simulation.step(50)
    for i, ((x, y), (vx, vy)) in enumerate(
        zip(simulation.positions.tolist(), simulation.velocities.tolist(), strict=True)
    ):
        found = [read(simulation, f"mass{i}.{what}") for what in ("x", "y", "vx", "vy", "speed")]
        assert found == [x, y, vx, vy, pytest.approx(math.hypot(vx, vy))]
    before, dt = simulation.angles, 1e-4
    simulation.step(1)
    rates = [read(simulation, f"joint{j}.rate") for j in range(len(before))]  # with which it has come here
    change = (simulation.angles - before + 180.0) % 360.0 - 180.0
    assert change / dt == pytest.approx(rates, rel=0.01, abs=1.0)


def test_what_has_yielded_and_broken_is_read_as_it_is_now() -> None:
    scene = chain([(0.0, 0.0), (-50.0, 0.0), (50.0, 0.0)], stiffness=100.0, rest_length=50.0, held=(1, 2))
    soft, weak = scene.linear_springs
    springs = (replace(soft, yield_force=800.0), replace(weak, a=0, strength=500.0))
    scene = replace(scene, linear_springs=springs, integrator=sim.Integrator(method="rk4", dt=1e-3))
    simulation = Simulation(scene)
    simulation.lead(1, (-70.0, 0.0))
    simulation.lead(2, (70.0, 0.0))
    simulation.step(10)
    damage = known(simulation.damage)
    assert damage.broken == (1,)
    assert read(simulation, "spring1.force") == 0.0
    elongation, moved = read(simulation, "spring0.elongation"), damage.set_lengths[0]
    assert moved > 5.0
    assert elongation == pytest.approx(read(simulation, "spring0.length") - 50.0 - moved)
    assert read(simulation, "spring0.force") == pytest.approx(100.0 * elongation)


def test_keys_that_change_rest_lengths_and_angles_are_in_what_is_read() -> None:
    simulation = Simulation(sim.load_scene("tutorial-3.3"))
    simulation.keys = {"up", "right"}
    simulation.step(100)
    rest = simulation.rest_length_scale * simulation.scene.linear_springs[3].rest_length
    length, elongation = (read(simulation, f"spring3.{what}") for what in ("length", "elongation"))
    assert simulation.rest_length_scale > 1.1
    assert length - elongation == pytest.approx(rest)
    assert read(simulation, "joint3.rest_angle") == simulation.rest_angles[3] == pytest.approx(10.0)


def test_every_entry_of_the_balance_is_there_and_the_meter() -> None:
    simulation = oscillator(damping=3.0)
    simulation.energy()
    simulation.step(100)
    balance = simulation.energy()
    for name in ("total", *ENERGY_FIELDS):
        assert read(simulation, f"energy.{name}") == getattr(balance, name)
    ratios = [read(simulation, "stability.dt_over_limit") for _ in range(5)]
    assert ratios[-1] == pytest.approx(1e-3 / simulation.stability().limit, rel=1e-3)
    free = by(simulation.scene, "auto")
    assert read(Simulation(free), "stability.dt_over_limit") == 0.0


def test_units_are_the_scene_s() -> None:
    scene = replace(rod(5), view=sim.View(unit="mm"))
    assert {name: quantity(name, scene).unit for name in UNITS} == UNITS
    # In metres, those that have a name are called by it.
    metres = replace(scene, view=sim.View(unit="m"))
    named = {"joint0.torque": "N m", "spring0.force": "N", "energy.kinetic": "J", "mass0.x": "m"}
    assert {name: quantity(name, metres).unit for name in named} == named


UNITS = {
    "joint0.angle": "°", "joint0.rate": "°/s", "joint0.torque": "kg mm²/s²", "spring0.force": "kg mm/s²",
    "mass0.x": "mm", "mass0.speed": "mm/s", "energy.kinetic": "kg mm²/s²", "stability.dt_over_limit": "",
}  # fmt: skip


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("joint3.angle", "joint3.angle: joint 3 does not exist (0..2)"),
        ("mass99.x", "mass99.x: mass 99 does not exist (0..4)"),
        (
            "joint0.angel",
            "'joint0.angel' is not a quantity: joint has angle, rate, rest_angle, torque, wrapped_angle",
        ),
        ("mass.x", "'mass.x' is not a quantity: mass needs a number"),
        ("energy1.total", "'energy1.total' is not a quantity: energy has no number"),
        ("angle", "begins with one of joint0, spring0, mass0, body, energy, stability, and then a point"),
        ("angle(3)", "'angle' is not a function: there are abs, atan2, cos, sin, sqrt"),
        ("joint-1.angle", "begins with one of"),
        ("joint٣.angle", "begins with one of"),
        ("joint0.angle\n", "begins with one of"),
        ("", "begins with one of"),
    ],
)
def test_what_does_not_exist_is_named_in_one_sentence(name: str, sentence: str) -> None:
    assert sentence in refusal(InputError, quantity, name, rod(5))


def test_a_scene_without_joints_says_so() -> None:
    with pytest.raises(InputError, match=r"joint 0 does not exist \(the scene has no joints\)"):
        quantity("joint0.angle", sim.rope(3, joints=False))


# ------------------------------------------------------------------------- recordings
def test_a_recording_of_a_pendulum() -> None:
    recording = pendulum().record(2.0, "joint0.angle", "joint0.rate", every=10)
    assert recording.time == pytest.approx(0.01 * np.arange(201))
    swing = math.sqrt(1000.0 / 100.0)  # of small angles; that of 3° is 1.7e-4 slower
    assert recording["joint0.angle"] == pytest.approx(-3.0 * np.cos(swing * recording.time), abs=3e-3)
    assert recording["joint0.rate"] == pytest.approx(3.0 * swing * np.sin(swing * recording.time), abs=2e-2)
    assert swings(recording.time, recording["joint0.angle"]) is None  # one cycle is too few


def test_the_energies_of_a_recording_add_up() -> None:
    parts = [f"energy.{name}" for name in ENERGY_FIELDS[:7]]
    recording = oscillator(damping=2.0).record(2.0, *parts, "energy.total", "energy.damping", every=50)
    assert sum(recording[name] for name in parts) == pytest.approx(recording["energy.total"])
    # 100 kg/s² and 5 px; what is missing went into damping.
    assert recording["energy.linear"][0] == pytest.approx(0.5 * 100.0 * 25.0)
    assert recording["energy.total"] - recording["energy.damping"] == pytest.approx(1250.0, rel=1e-6)
    assert recording["energy.damping"][-1] < -500.0


def test_a_recording_is_the_same_each_time_and_does_not_touch_the_motion() -> None:
    names = "mass8.x", "joint3.torque", "energy.residual", "stability.dt_over_limit"
    one, other, plain = (Simulation(sim.load_scene("tutorial-3.3")) for _ in range(3))
    first, second = (simulation.record(0.5, *names, every=7) for simulation in (one, other))
    assert [first[name].tolist() for name in names] == [second[name].tolist() for name in names]
    plain.step(200)
    assert one.step_count == 200
    assert np.array_equal(one.positions, plain.positions)
    assert first.time.tolist() == [pytest.approx(0.0175 * i) for i in range(29)]
    # It goes on where the simulation is.
    assert one.record(0.1, "mass0.x", every=20).time == pytest.approx([0.5, 0.55, 0.6])


def test_a_recording_ends_where_the_body_runs_away() -> None:
    simulation = oscillator(stiffness=1e9)
    recording = simulation.record(1.0, "spring0.length")
    assert simulation.divergence is not None
    assert 1 <= len(recording) < 1000
    assert np.isfinite(recording["spring0.length"]).all()


def test_a_table_has_units_and_reads_back_exactly(tmp_path: Path) -> None:
    path = tmp_path / "swing.csv"
    recording = pendulum().record(0.3, "joint0.angle", "joint0.torque", "stability.dt_over_limit", every=100)
    recording.to_csv(path)
    with path.open(newline="") as file:
        header, *rows = csv.reader(file)
    assert header == [
        "time [s]", "joint0.angle [deg]", "joint0.torque [kg px^2/s^2]", "stability.dt_over_limit",
    ]  # fmt: skip
    columns = np.array(rows, float).T
    assert columns[0].tolist() == recording.time.tolist()
    assert columns[1].tolist() == recording["joint0.angle"].tolist()
    table = np.genfromtxt(path, delimiter=",", names=True, encoding="utf-8")
    assert table["joint0angle_deg"].tolist() == recording["joint0.angle"].tolist()


def test_what_cannot_be_recorded_is_refused_before_anything_moves(tmp_path: Path) -> None:
    simulation = pendulum()
    for seconds, names, every, sentence in (
        (1.0, (), 1, "at least one quantity"),
        (1.0, ("joint9.angle",), 1, "joint 9 does not exist"),
        (math.nan, ("mass0.x",), 1, "not in the range"),
        (-1.0, ("mass0.x",), 1, "not in the range"),
        (1.0, ("mass0.x",), 0, "whole number from 1"),
        (1.0, ("mass0.x",), 1.5, "whole number from 1"),
    ):
        assert sentence in refusal(InputError, simulation.record, seconds, *names, every=every)
    assert simulation.step_count == 0
    recording = simulation.record(0.01, "mass0.x")
    said = refusal(InputError, recording.__getitem__, "mass1.x")
    assert "'mass1.x' was not recorded, but mass0.x" in said
    nowhere = tmp_path / "no" / "folder.csv"
    assert "the file cannot be written" in refusal(InputError, recording.to_csv, nowhere)


# ------------------------------------------------------------------------- period, amplitude, damping
def test_the_period_of_a_mass_on_a_spring() -> None:
    recording = oscillator().record(10.0, "spring0.elongation", every=16)  # as coarse as the page's frames
    found = known(swings(recording.time, recording["spring0.elongation"]))
    assert found.period == pytest.approx(2.0 * math.pi / math.sqrt(50.0), rel=1e-5)
    assert found.amplitude == pytest.approx(5.0, rel=1e-3)
    assert found.centre == pytest.approx(0.0, abs=1e-3)
    assert (found.decrement, found.loss) == (None, 0.0)


@pytest.mark.parametrize("damping", [0.4, 2.0, 5.0])
def test_the_damping_of_a_mass_on_a_spring_is_read_off(damping: float) -> None:
    decay = damping / (2.0 * 2.0)
    swing = math.sqrt(50.0 - decay**2)
    recording = oscillator(damping).record(6.0, "mass1.x", every=16)
    found = known(swings(recording.time, recording["mass1.x"]))
    assert found.period == pytest.approx(2.0 * math.pi / swing, rel=2e-3)
    assert found.centre == pytest.approx(50.0, abs=0.01)
    assert found.decrement == pytest.approx(decay * found.period, rel=0.01)
    assert found.loss == pytest.approx(1.0 - math.exp(-decay * found.period), rel=0.01)


def test_ripples_noise_and_a_late_begin_do_not_matter() -> None:
    t = np.linspace(0.0, 9.0, 541)
    swing = np.cos(2.0 * math.pi * t / 1.3)
    noise = np.random.default_rng(1).normal(0.0, 0.003, t.size)
    for curve in (swing + 0.01 * np.sin(60.0 * t), swing + noise, np.where(t < 2.0, 1.0, swing)):
        found = known(swings(t, 300.0 + 2.0 * curve))
        assert found.period == pytest.approx(1.3, rel=0.01)
        assert found.amplitude == pytest.approx(2.0, rel=0.02)


def test_what_does_not_swing_has_no_period() -> None:
    t = np.linspace(0.0, 9.0, 541)
    noise = np.random.default_rng(1).normal(0.0, 1.0, t.size)
    for curve in (t, np.exp(-t), 0.0 * t + 3.0, 1e6 + 1e-6 * np.sin(9.0 * t), noise, np.sin(t * t)):
        assert swings(t, curve) is None
    assert swings(t[:0], t[:0]) is None
    assert swings(t[:40], np.sin(t[:40] * 9.0)) is None


def test_the_time_step_of_a_body_that_exploded_is_beyond_its_limit() -> None:
    simulation = Simulation(scene_of_run(sim.load_scene("lesson-explosion"), 0))
    simulation.advance(2.0)
    assert simulation.divergence is not None
    assert read(simulation, "stability.dt_over_limit") > 1.0
