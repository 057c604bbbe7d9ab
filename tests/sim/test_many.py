"""`run_many` against a `Simulation` of each scene."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim import InputError, Integrator, Run, Scene, SceneError, Simulation
from sim.model.system import build_system
from sim.motion.many import is_laned
from sim.motion.stability import damped_limit
from sim.scene.types import Circle
from tests.amount import examples
from tests.sim.builders import built, row, tutorial_rope
from tests.sim.changes import by, pairs, with_joints, with_masses, with_springs
from tests.sim.checks import known, refusal
from tests.sim.fuzzing import wild_scene

LANED = ("symplectic_euler", "velocity_verlet", "rk4")
STEPS = 24


def varied(scene: Scene, rng: np.random.Generator) -> Scene:
    """A scene of the same shape with other numbers in all its parts."""

    def other(number: float) -> float:
        return number * float(rng.uniform(0.5, 1.0))

    scene = with_masses(
        scene,
        mass=lambda _, m: min(2.0 * m.mass, 1e6),
        velocity=lambda _, m: (other(m.velocity[0]), other(m.velocity[1])),
        force=lambda i, m: (5.0, -3.0) if i % 3 == 0 else m.force,
    )
    scene = with_springs(
        scene, stiffness=lambda _, s: other(s.stiffness), damping=lambda _, s: other(s.damping)
    )
    scene = with_joints(
        scene, stiffness=lambda _, j: other(j.stiffness), rest_angle=lambda _, j: other(j.rest_angle)
    )
    around = {"gravity": (other(100.0), -30.0), "air_friction": other(0.01)}
    return replace(scene, **around, rest_length_scale=other(1.2))


def one_by_one(scene: Scene, seconds: float, every: int | None = None) -> Run:
    """The same by a `Simulation`."""
    simulation = Simulation(scene)
    steps = int(seconds / simulation.dt + 1e-9)
    rows = [(0.0, simulation.positions, simulation.velocities)] if every else []
    for _ in range(steps // every if every else 0):
        if every is not None and simulation.step(every) == every:
            rows.append((simulation.time, simulation.positions, simulation.velocities))
    simulation.step(steps - simulation.step_count)
    times, positions, velocities = zip(*rows, strict=True) if rows else ((), (), ())
    return Run(
        simulation.time,
        simulation.positions,
        simulation.velocities,
        simulation.divergence,
        *map(np.array, (times, positions, velocities)),
    )


def last_digits_changed(scene: Scene) -> Scene:
    """The scene with other last digits in its positions."""
    off = 1.0 + 2.0**-48 * np.random.default_rng(1).choice((-1.0, 1.0), (len(scene.masses), 2))
    return with_masses(scene, position=list(pairs(off * [mass.position for mass in scene.masses])))


def same(one: Run, other: Run) -> bool:
    """Whether two runs are the same to the last bit."""
    arrays = [np.array_equal(getattr(one, f), getattr(other, f)) for f in Run.__slots__ if f != "divergence"]
    return all(arrays) and one.divergence == other.divergence


@settings(max_examples=examples(60))
@given(st.integers(0, 2**32 - 1), st.sampled_from(LANED), st.integers(1, 11))
def test_bodies_side_by_side_do_what_a_simulation_of_each_does(seed: int, method: Any, count: int) -> None:
    rng = np.random.default_rng(seed)
    scene = wild_scene(rng)
    try:
        sim.validate(scene)
    except SceneError:
        assume(False)
    limit = damped_limit(build_system(scene))
    dt = 0.2 * limit if math.isfinite(limit) else 1e-3
    assume(dt >= 1e-6)
    scene = by(scene, method, dt=min(dt, 0.01))
    scenes = [scene, *(varied(scene, rng) for _ in range(count - 1))]
    assume(is_laned(scene))
    dt = scene.integrator.dt
    found = sim.run_many(scenes, STEPS * dt, every=7)
    for one, run in zip(scenes, found, strict=True):
        expected, shaken = (one_by_one(each, STEPS * dt, every=7) for each in (one, last_digits_changed(one)))
        assert run.divergence == expected.divergence
        far, fast = np.abs(expected.sample_positions).max(), np.abs(expected.sample_velocities).max()
        if shaken.sample_times.size != expected.sample_times.size:
            continue  # rounding decides when it runs away
        for names, size in (("positions", far), ("velocities", far / dt + fast)):
            for name in (names, f"sample_{names}"):
                # Some bodies amplify what is rounded, as where a spring shrinks to nothing and turns round.
                grown = np.abs(getattr(shaken, name) - getattr(expected, name)).max()
                off = np.abs(getattr(run, name) - getattr(expected, name)).max()
                assert off <= 1e-12 * size + 1000.0 * grown
        assert np.abs(run.sample_times - expected.sample_times).max() <= 1e-12
        assert run.time == pytest.approx(expected.time, abs=1e-12)


@pytest.mark.parametrize("method", LANED)
def test_what_a_body_does_depends_on_none_beside_it(method: Any) -> None:
    rng = np.random.default_rng(5)
    rope = tutorial_rope(integrator=Integrator(method=method), angular_damping=2.0)
    scenes = [rope, *(varied(rope, rng) for _ in range(20))]
    together = sim.run_many(scenes, 0.5, every=20)
    for i in (0, 7, 8, 20):
        assert same(sim.run_many([scenes[i]], 0.5, every=20)[0], together[i])


ALONE: dict[str, Scene] = {
    "auto": sim.rope(),
    "walls": sim.jelly(integrator=Integrator(method="velocity_verlet", dt=1e-3)),
    "wind": sim.load_scene("flag-pole"),
    "circle": tutorial_rope(circle=Circle(radius=20.0, frequency=1.0)),
    "stable spring": tutorial_rope(integrator=Integrator(method="stable_spring")),
    "muscles": by(sim.worm(), "symplectic_euler", dt=1e-3),
    "breaking": with_springs(tutorial_rope(gravity=(0.0, 3000.0)), strength=4000.0),
    "all held": tutorial_rope(held=tuple(range(12))),
}


@pytest.mark.parametrize("name", ALONE)
def test_what_is_not_known_side_by_side_is_simulated_and_gets_the_same_bits(name: str) -> None:
    scene = ALONE[name]
    assert not is_laned(scene)
    between = 5
    ropes = [tutorial_rope(), tutorial_rope(stiffness=8000.0)]
    assert all(map(is_laned, ropes))
    seconds = 30 * scene.integrator.dt
    runs = sim.run_many([ropes[0], scene, ropes[1]], seconds, every=between)
    assert same(runs[1], one_by_one(scene, seconds, every=between))
    for rope, run in ((ropes[0], runs[0]), (ropes[1], runs[2])):
        assert np.abs(run.positions - one_by_one(rope, seconds).positions).max() < 1e-9


def test_a_body_that_runs_away_says_why_and_the_others_go_on() -> None:
    ropes = [tutorial_rope(stiffness=k, gravity=(0.0, 1000.0)) for k in (1e4, 1e9, 2e4)]
    runs = sim.run_many(ropes, 1.0, every=40)
    assert [run.divergence is None for run in runs] == [True, False, True]
    assert same(runs[1], one_by_one(ropes[1], 1.0, every=40))
    assert np.isfinite(runs[1].positions).all()
    assert [run.time for run in (runs[0], runs[2])] == [1.0, 1.0]
    assert len(runs[0].sample_times) == 11 > len(runs[1].sample_times)


def test_a_body_that_is_too_fast_says_so_however_near_it_is() -> None:
    fast = built([(0.0, 0.0)], velocities=[(2e6, 0.0)], integrator=Integrator(method="rk4", dt=0.01))
    (run,) = sim.run_many([fast], 0.1)
    assert run.divergence is not None
    assert known(run.divergence).quantity == "speed"


def test_scenes_of_many_shapes_come_back_in_their_order() -> None:
    sizes = [3, 12, 5, 12, 3, 40]
    runs = sim.run_many([tutorial_rope(masses=n) for n in sizes], 0.1)
    assert [len(run.positions) for run in runs] == sizes
    assert all(len(run.sample_times) == 0 for run in runs)


def test_masses_that_nothing_joins_fall_side_by_side() -> None:
    fields: dict[str, Any] = {"gravity": (0.0, 100.0), "integrator": Integrator(method="rk4")}
    loose = built(row(3, 100.0), [], velocities=[(10.0, 0.0)] * 3, **fields)
    assert is_laned(loose)
    (run,) = sim.run_many([loose], 2.0)
    assert run.positions == pytest.approx(np.array([(100.0 * i + 20.0, 200.0) for i in range(3)]))


def test_no_scenes_no_runs_and_no_time_leaves_the_start() -> None:
    assert sim.run_many([], 1.0) == []
    rope = tutorial_rope()
    (run,) = sim.run_many([rope], 0.0, every=3)
    assert np.array_equal(run.positions, [mass.position for mass in rope.masses])
    assert run.sample_times.tolist() == [0.0]


def test_what_cannot_be_run_is_refused() -> None:
    rope = tutorial_rope()
    for seconds in (-1.0, math.nan, math.inf):
        said = refusal(InputError, sim.run_many, [rope], seconds)
        assert re.fullmatch(r"run_many: .* is not in the range 0\.\.1e\+09 s", said)
    for every in (0, -3, 2.5):
        said = refusal(InputError, sim.run_many, [rope], 1.0, every)
        assert re.fullmatch(r"run_many: every is .*, but must be a whole number from 1", said)
    wrong = replace(rope, gravity=(0.0, math.nan))
    assert refusal(SceneError, sim.run_many, [rope, wrong], 1.0).startswith("scenes[1]: gravity")
    twice = replace(rope, bodies=(), linear_springs=(*rope.linear_springs, rope.linear_springs[0]))
    assert refusal(SceneError, sim.run_many, [twice], 1.0).startswith("scenes[0]: linear_springs[11]")
