"""Hands that lead bodies of many stiff springs no faster than these can follow."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from sim import Simulation
from sim.motion.hands import LONGEST_PART, Hand
from sim.scene.types import ForceLaw
from sim.solve.registry import METHODS
from tests.amount import examples
from tests.sim.builders import led_rod, rod
from tests.sim.changes import by, step_all
from tests.sim.inside import same_state

WAVE = 300.0 / 11.0 * 100.0
"""px/s: how fast a pull goes through the tutorial's rope, in however many pieces."""

coordinates = st.floats(-1e6, 1e6)


# ------------------------------------------------------------------------------------------ the hand alone


@settings(max_examples=examples(15))
@given(
    x=coordinates,
    y=coordinates,
    gx=coordinates,
    gy=coordinates,
    fastest=st.floats(1e3, 1e6),
    frame=st.floats(1e-3, 0.5),
)
def test_a_hand_comes_to_its_goal_and_never_beyond(
    x: float, y: float, gx: float, gy: float, fastest: float, frame: float
) -> None:
    hand = Hand(x, y, 0.0, 0.0, fastest)
    hand.goal = gx, gy
    way = hand.distance
    needed = way / fastest + 40.0 / 30.0
    parts = math.ceil(frame / LONGEST_PART)
    nearest, steps = way, 0
    while not hand.is_there and steps < 20000:
        motion = hand.next_motion(frame / parts)
        assert np.isfinite(motion).all()
        assert math.hypot(motion.vx, motion.vy) <= 1.01 * fastest
        hand.go_on(motion, frame / parts)
        assert hand.distance <= nearest * (1.0 + 1e-9) + 1e-9
        nearest = hand.distance
        steps += 1
        if steps * frame / parts > 2.0 * needed:
            break
    # To the last digit of a coordinate, which may be 1e6.
    assert hand.distance <= 1e-9 + 1e-9 * way or steps == 20000


def test_a_hand_moves_without_a_jerk_wherever_the_pointer_jumps() -> None:
    rng = np.random.default_rng(1)
    hand = Hand(0.0, 0.0, 0.0, 0.0, 900.0)
    before = np.zeros(6)
    for i in range(300):
        if i % 7 == 0:
            hand.goal = tuple(rng.normal(0.0, 400.0, 2).tolist())
        motion = np.array(hand.next_motion(1.0 / 60.0))
        # Velocity and acceleration go on from where the last part left them.
        assert motion[:4] == pytest.approx(before[:4], rel=1e-9, abs=1e-6)
        hand.go_on(hand.next_motion(1.0 / 60.0), 1.0 / 60.0)
        v, a, j = motion[:2], motion[2:4], motion[4:]
        before = np.concatenate((v + (a + j / 120.0) / 60.0, a + j / 60.0, j))
        assert np.hypot(*before[2:4]) < 2.0 * 30.0 * 900.0


# ----------------------------------------------------------------------------------------------- bodies


def test_only_long_stiff_rods_limit_the_speed_of_a_hand() -> None:
    rate_limited = {
        entry.name
        for entry in sim.list_scenes()
        if Simulation(sim.load_scene(entry.name), integrator="auto").rate_limited
    }
    # The lessons' rods are struck or let go; no hand leads them.
    assert rate_limited == {"study-w4", "lesson-cantilever", "lesson-rod-sound", "lesson-spectrum"}
    assert not Simulation(sim.rope(250), integrator="auto").rate_limited
    for masses, rate_limited in ((12, False), (30, False), (40, True), (1000, True)):
        assert Simulation(rod(masses)).rate_limited is rate_limited
    for method, info in METHODS.items():
        # A fixed step takes as long for anything.
        assert Simulation(rod(100), integrator=method).rate_limited is info.adaptive


def test_other_bodies_are_led_at_once() -> None:
    one, other = (Simulation(rod(12)) for _ in range(2))
    one.follow(0, (400.0, 50.0))
    other.lead(0, (400.0, 50.0))
    assert not one.behind
    step_all(7, one, other)
    assert same_state(one, other)


@pytest.mark.parametrize("law", ["tutorial", "conservative"])
@pytest.mark.parametrize("far", [500.0, 1e5])
@pytest.mark.parametrize("masses", [100, 1000, 3000])
def test_an_anchor_torn_away_costs_no_more_than_a_calm_one(masses: int, far: float, law: ForceLaw) -> None:
    simulation = Simulation(rod(masses, law=law))
    simulation.step(140)
    x, y = simulation.positions[0]
    costs, fastest = [], 0.0
    for frame in range(40):
        simulation.follow(0, (x + far * (frame // 6 % 2), y - far * (frame // 9 % 2)))
        before, done = simulation.positions[0], simulation.work
        assert simulation.step(7) == 7
        costs.append(simulation.work - done)
        fastest = max(fastest, float(np.hypot(*(simulation.positions[0] - before))) / (7 * simulation.dt))
    # Steps of Verlet, or what costs as much; a calm frame takes 190. Now and then a frame tries steps again,
    # for rounding decides on which side of the tolerance the first trials are.
    *_, next_most, most = sorted(costs)
    assert next_most <= 1000
    assert most <= 1500
    assert 0.2 * WAVE < fastest <= 0.35 * WAVE
    assert simulation.behind[0] > 100.0
    stretched = np.hypot(*np.diff(simulation.positions, axis=0).T).sum()
    assert 250.0 < stretched < 450.0


def test_it_comes_to_its_goal_and_stays() -> None:
    simulation = Simulation(rod(100))
    simulation.follow(0, (350.0, 60.0))
    behind = [simulation.behind[0]]
    for _ in range(120):
        simulation.step(7)
        behind.append(simulation.behind.get(0, 0.0))
    assert behind[0] == pytest.approx(math.hypot(250.0, 40.0))
    assert (np.diff(behind) <= 0.0).all()
    assert not simulation.behind
    assert tuple(simulation.positions[0]) == (350.0, 60.0)
    assert not simulation.velocities[0].any()
    simulation.step(7)
    assert tuple(simulation.positions[0]) == (350.0, 60.0)


def test_one_long_call_leads_as_far_as_many_short_ones() -> None:
    one = Simulation(by(rod(60), "auto", dt=1.0))
    many = Simulation(rod(60))
    for simulation in (one, many):
        simulation.follow(0, (300.0, 100.0))
    one.step(1)
    for _ in range(50):
        many.step(8)
    assert one.positions[0] == pytest.approx(many.positions[0], abs=1e-3)
    assert one.positions == pytest.approx(many.positions, abs=0.5)


def test_a_hand_waits_when_attempts_run_out() -> None:
    late, whole = Simulation(rod(100)), Simulation(rod(100))
    for simulation in (late, whole):
        simulation.follow(0, (300.0, 100.0))
    calls = 0
    while late.time < 0.35:
        late.step(7, attempts=3)
        calls += 1
    assert calls > 25
    # Where it would be at that time, whatever it was cut into.
    whole.step(round(late.time / whole.dt))
    way = float(np.hypot(*(late.positions[0] - whole.positions[0])))
    assert way < 0.02 * 200.0 + 900.0 * abs(late.time - whole.time)


def test_the_balance_of_a_gentle_hand_closes() -> None:
    laws: tuple[ForceLaw, ...] = ("tutorial", "conservative")
    for law in laws:
        scene = by(rod(60, law=law), tolerance=1e-3)
        simulation = Simulation(scene)
        simulation.energy()
        for frame in range(60):
            simulation.follow(0, (100.0 + 300.0 * (frame // 20 % 2), 100.0))
            simulation.step(7)
        balance = simulation.energy()
        assert balance.anchors > 1e5
        assert abs(balance.residual) < 1e-3 * balance.anchors


def test_a_moving_mass_is_stopped_gently() -> None:
    simulation = Simulation(rod(100))
    simulation.step(120)
    simulation.stats()
    speed = float(np.hypot(*simulation.velocities[50]))
    position = simulation.positions[50]
    simulation.grab(50)
    assert speed > 300.0
    for _ in range(10):
        simulation.step(7)
    assert 1.0 < float(np.hypot(*(simulation.positions[50] - position))) < speed / 10.0
    for _ in range(60):
        simulation.step(7)
    assert simulation.positions[50] == pytest.approx(position, abs=1e-9)
    assert not simulation.behind
    simulation.release(50)
    assert not simulation.velocities[50].any()
    simulation.step(40)
    assert simulation.positions[50] != pytest.approx(position, abs=1.0)


def test_what_lets_go_leaves_an_anchor_to_come_and_a_free_mass_where_it_is() -> None:
    simulation = Simulation(rod(60))
    for mass in (0, 59):
        simulation.grab(mass)
        simulation.follow(mass, (250.0, 150.0))
    simulation.step(20)
    assert set(simulation.behind) == {0, 59}
    for mass in (0, 59):
        simulation.release(mass)
    assert set(simulation.behind) == {0}
    simulation.step(800)
    assert tuple(simulation.positions[0]) == (250.0, 150.0)


def test_a_slider_and_another_body_take_the_hand_over_and_a_reset_does_not() -> None:
    simulation = Simulation(rod(60))
    simulation.follow(0, (400.0, 100.0))
    simulation.step(20)
    other = Simulation(rod(60))
    other.take_state(simulation)
    assert other.behind == simulation.behind != {}
    simulation.replace(sim.set_value(simulation.scene, "gravity", 500.0))
    assert other.behind == simulation.behind
    step_all(40, simulation, other)
    assert simulation.positions[0] == pytest.approx(other.positions[0])
    simulation.reset()
    assert not simulation.behind
    x, y = simulation.positions[0]
    other.move(0, (x, y))
    assert not other.behind
    for body in (simulation, other):
        body.step(10)
        assert tuple(body.positions[0]) == (x, y)
        assert not body.velocities[0].any()


def test_an_anchor_on_a_circle_goes_on_round() -> None:
    simulation = Simulation(led_rod(60))
    assert simulation.rate_limited
    simulation.follow(0, (150.0, 100.0))
    assert not simulation.behind
    simulation.step()
    assert simulation.positions[0] == pytest.approx((150.0, 100.0))


def test_a_hand_goes_only_to_places_that_a_scene_may_have() -> None:
    simulation = Simulation(rod(60))
    for to in ((math.nan, 0.0), (0.0, 2e6)):
        with pytest.raises(sim.InputError, match="is not within"):
            simulation.follow(0, to)
    with pytest.raises(sim.InputError, match="mass 7 is not held"):
        simulation.follow(7, (0.0, 0.0))
    assert not simulation.behind
