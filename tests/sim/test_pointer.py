"""What the pointer does: moving and leading held masses, grabbing free ones."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, InputError, Integrator, Simulation
from sim.scene.types import ForceLaw, Method
from sim.solve.registry import METHODS
from tests.sim.builders import askew, chain, row, tutorial_rope, undisturbed
from tests.sim.changes import apart, by, step_all
from tests.sim.checks import refusal
from tests.sim.inside import same_state


# ------------------------------------------------------------------------- pointer and grabs
def test_move_acts_before_the_forces_of_the_next_step() -> None:
    scene = chain(row(2), stiffness=100.0, held=(0,), dt=0.01)
    simulation = Simulation(scene)
    simulation.move(0, (-5.0, 0.0))
    assert simulation.positions.tolist() == [[-5.0, 0.0], [10.0, 0.0]]
    simulation.step()
    # The spring is 5 px too long in that very step: v = -100 * 5 * 0.01.
    assert simulation.velocities[1] == pytest.approx([-5.0, 0.0])
    assert tuple(simulation.positions[0]) == (-5.0, 0.0)
    assert not simulation.velocities[0].any()
    simulation.step()
    assert tuple(simulation.positions[0]) == (-5.0, 0.0)


def test_lead_goes_in_a_straight_line_and_arrives_with_the_last_step() -> None:
    simulation = Simulation(sim.load_scene("tutorial-3.1"))
    simulation.lead(0, (400.3, 25.7))
    simulation.step(8)
    assert tuple(simulation.positions[0]) == (400.3, 25.7)
    # On the way: the same call, cut into pieces that aim at the points of the line.
    start, end = np.array([300.0, 125.0]), np.array([400.3, 25.7])
    free = chain([(0.0, 0.0), (10.0, 0.0)], stiffness=100.0, damping=2.0, held=(0,), dt=0.01)
    line, pieces = Simulation(free), Simulation(free)
    line.lead(0, (end[0] - start[0], end[1] - start[1]))
    line.step(10)
    for i in range(1, 11):
        x, y = (end - start) * i / 10
        pieces.move(0, (x, y))
        pieces.step()
    assert apart(line, pieces) <= 1e-12
    assert np.abs(line.velocities - pieces.velocities).max() <= 1e-12


@pytest.mark.parametrize("law", ["tutorial", "conservative"])
@pytest.mark.parametrize("method", METHODS)
def test_what_is_led_arrives_and_stays_there(method: Method, law: ForceLaw) -> None:
    scene = replace(askew(), bodies=(), anchors=(Anchor(mass=0), Anchor(mass=11)), force_law=law)
    simulation = Simulation(by(scene, method, dt=5e-4))
    far = simulation.positions[11]
    simulation.step(4)
    # Held at both ends, and in the middle by a hand.
    simulation.grab(5)
    assert not simulation.velocities[5].any()
    for to in ((330.1, 140.7), (331.3, 139.9)):
        simulation.lead(0, to)
        simulation.lead(5, (320.3, 260.1))
        for steps in (6, 5, 5):
            assert simulation.step(steps) == steps
            assert simulation.positions[[0, 5]].tolist() == [[*to], [320.3, 260.1]]
        assert not simulation.velocities[[0, 5, 11]].any()
    assert np.array_equal(simulation.positions[11], far)
    # What is let go of starts from rest.
    simulation.release(5)
    assert not simulation.velocities[5].any()
    simulation.step(5)
    assert tuple(simulation.positions[0]) == to
    assert simulation.velocities[5].any()
    with pytest.raises(InputError, match="not held"):
        simulation.move(5, (0.0, 0.0))


@pytest.mark.parametrize("masses", [30, 250])
def test_a_hand_does_not_let_a_long_rope_slip(masses: int) -> None:
    # So long that `auto` has more methods to choose from, and each of them holds what is held.
    simulation = Simulation(sim.rope(masses=masses, direction=(1.0, 0.1)))
    simulation.step(20)
    simulation.grab(masses // 2)
    position = simulation.positions[masses // 2]
    for _ in range(4):
        simulation.step(40)
        assert np.array_equal(simulation.positions[masses // 2], position)
        assert tuple(simulation.positions[0]) == (300.0, 150.0)


def test_the_last_of_several_targets_counts(rope: Simulation) -> None:
    rope.lead(0, (1.0, 1.0))
    rope.move(0, (305.0, 175.0))
    rope.step(3)
    assert tuple(rope.positions[0]) == (305.0, 175.0)
    rope.lead(0, (1.0, 1.0))
    rope.lead(0, (306.0, 176.0))
    rope.step(3)
    assert tuple(rope.positions[0]) == (306.0, 176.0)


def test_a_lead_starts_where_a_move_has_put_the_mass() -> None:
    simulation = Simulation(sim.load_scene("tutorial-3.3"))
    simulation.move(0, (250.0, 170.0))
    simulation.lead(0, (250.0, 180.0))
    one_by_one = Simulation(sim.load_scene("tutorial-3.3"))
    for i in range(1, 11):
        one_by_one.move(0, (250.0, 170.0 + i))
        one_by_one.step()
    simulation.step(10)
    assert apart(simulation, one_by_one) <= 1e-9


@pytest.mark.parametrize(
    "to", [(math.nan, 0.0), (0.0, math.inf), (-math.inf, 0.0), (1.1e6, 0.0), (0.0, -1.1e6)]
)
def test_places_out_of_range_are_refused(rope: Simulation, to: tuple[float, float]) -> None:
    before = rope.positions
    for act in (rope.move, rope.lead):
        assert "within" in refusal(InputError, act, 0, to)
    other = Simulation(askew())
    rope.step()
    other.step()
    assert same_state(rope, other)
    assert not np.array_equal(rope.positions, before)


def test_only_held_masses_that_exist_are_moved(rope: Simulation) -> None:
    for act in (rope.move, rope.lead):
        assert "mass 5 is not held" in refusal(InputError, act, 5, (0.0, 0.0))
        for mass in (-1, 12, True, 1.0):
            assert "does not exist" in refusal(InputError, act, mass, (0.0, 0.0))
    for act, mass in ((rope.grab, 12), (rope.release, -1)):
        assert "does not exist" in refusal(InputError, act, mass)


@pytest.mark.parametrize("law", ["tutorial", "conservative"])
@pytest.mark.parametrize("method", METHODS)
def test_a_mass_let_go_on_its_way_is_at_rest_at_once(method: Method, law: ForceLaw) -> None:
    scene = replace(askew(), force_law=law, integrator=Integrator(method=method, dt=1e-5))
    simulation, other = Simulation(scene), Simulation(scene)
    for body in (simulation, other):
        body.grab(5)
        x, y = body.positions[5]
        body.lead(5, (float(x) + 1.0, float(y)))
        body.step(50)
    simulation.release(5)
    assert not simulation.velocities[5].any()
    # As it would be if it had first been held for a while.
    other.move(5, tuple(other.positions[5].tolist()))
    other.release(5)
    step_all(50, simulation, other)
    assert same_state(simulation, other)


def test_releasing_forgets_the_target_and_leaves_anchors_held(rope: Simulation) -> None:
    rope.grab(5)
    rope.lead(5, (0.0, 0.0))
    rope.release(5)
    rope.grab(0)
    rope.release(0)
    anchor = rope.positions[0]
    rope.step(10)
    assert same_state(rope, undisturbed(10))
    assert np.array_equal(rope.positions[0], anchor)


def test_the_scene_does_not_show_grabs_and_reset_ends_them(rope: Simulation) -> None:
    rope.grab(5)
    assert rope.scene == askew()
    rope.reset()
    rope.step(30)
    assert same_state(rope, undisturbed(30))


def test_a_body_that_is_held_everywhere_only_follows_the_pointer_and_keys() -> None:
    scene = tutorial_rope(masses=4, held=(0, 1, 2, 3))
    simulation = Simulation(scene)
    start = simulation.positions
    simulation.keys = {"up", "right"}
    simulation.lead(2, (0.0, 1.0))
    assert simulation.step(10) == 10
    assert tuple(simulation.positions[2]) == (0.0, 1.0)
    assert np.array_equal(simulation.positions[[0, 1, 3]], start[[0, 1, 3]])
    assert simulation.time == pytest.approx(0.025)
    assert simulation.rest_length_scale == pytest.approx(1.002**10)
    assert simulation.rest_angles == pytest.approx([1.0, 1.0])


@pytest.mark.parametrize("dt", [0.001, 0.0037, 0.008817065458705083, 0.0123])
@pytest.mark.parametrize("edge", [(0.0, 1e6), (-1e6, 1e6), (1e6, -3.3)])
def test_a_mass_may_be_led_to_the_very_edge(dt: float, edge: tuple[float, float]) -> None:
    scene = by(chain(row(1)), "auto", dt=dt, tolerance=1.0)
    simulation = Simulation(scene)
    simulation.grab(0)
    # Not a rounding error beyond it, which would be out of range.
    simulation.lead(0, edge)
    assert simulation.step(20) == 20
    assert simulation.divergence is None
    assert tuple(simulation.positions[0]) == edge


def test_what_is_let_go_at_the_edge_does_not_pass_it() -> None:
    # Friction that turns within a step moves the mass once more, after the method has corrected its step.
    scene = replace(
        chain(row(1), held=()), gravity=(55.0, 0.0), air_friction=27.0,
        integrator=Integrator(method="adams", dt=0.0078125, tolerance=4.0),
    )  # fmt: skip
    simulation = Simulation(scene)
    simulation.grab(0)
    simulation.lead(0, (-1e6, 0.0))
    simulation.step(20)
    simulation.release(0)
    simulation.step(20)
    assert simulation.positions[0, 0] >= -1e6
