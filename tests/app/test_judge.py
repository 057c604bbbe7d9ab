"""Goals are judged from the run, and again from its log; a log that no pupil can have made is refused."""

from __future__ import annotations

import random

import msgspec
import numpy as np
import pytest

import sim
from app.classroom.answers import Doubt
from app.classroom.judge import GoalWatch, Meter, judge
from app.session.log import Set, decode_log, digest_of
from app.session.record import Recorder
from app.session.session import Session
from sim.scene.lesson import Goal, Reading, Step
from tests.sim.builders import spinning

STIFFNESS, MASS = 40.0, 1.0
PERIOD = 2.0 * np.pi * np.sqrt(MASS / STIFFNESS)


def a_scene() -> sim.Scene:
    """A mass on a spring, without friction, that hangs from an anchor."""
    return sim.Scene(
        name="swing",
        masses=(sim.Mass(position=(300.0, 100.0)), sim.Mass(position=(300.0, 200.0), mass=MASS)),
        linear_springs=(sim.LinearSpring(a=0, b=1, stiffness=STIFFNESS, damping=0.0, rest_length=100.0),),
        anchors=(sim.Anchor(mass=0),),
        gravity=(0.0, 400.0),
        air_friction=0.0,
        integrator=sim.Integrator(method="rk4", dt=1.0 / 480.0),
    )


def run(
    scene: sim.Scene, seconds: float = 4.0, stiffness: float | None = None
) -> tuple[sim.Simulation, bytes]:
    """A run as a page records it."""
    simulation = sim.Simulation(scene)
    recorder = Recorder(simulation)
    if stiffness is not None:
        recorder.do(Set(key="linear_stiffness", value=stiffness))
    for _ in range(round(60 * seconds)):
        recorder.step(8)
    return simulation, recorder.file()


def a_step(goal: Goal | None = None, collect: Reading | None = None) -> Step:
    return Step(title="t", do="d", controls=("linear_stiffness",), goal=goal, collect=collect)


def test_a_period_is_read_off_the_run_and_off_its_log() -> None:
    collect = Reading(quantity="mass1.y", of="period")
    goal = Goal(quantity="mass1.y", of="period", low=PERIOD - 1e-3, high=PERIOD + 1e-3)
    simulation, data = run(a_scene())
    verdict = judge(decode_log(data, "log"), a_scene(), a_step(goal, collect))
    assert (verdict.refused, verdict.reached) == ("", True)
    assert verdict.found == pytest.approx(PERIOD, abs=1e-4)
    assert verdict.steps == simulation.step_count
    # With another stiffness, which the step's slider gives, it is another period.
    _, data = run(a_scene(), stiffness=2 * STIFFNESS)
    verdict = judge(decode_log(data, "log"), a_scene(), a_step(goal, collect))
    assert (verdict.refused, verdict.reached) == ("", False)
    assert verdict.found == pytest.approx(PERIOD / np.sqrt(2.0), abs=1e-3)


def test_a_goal_for_an_angle_goes_on_beyond_half_a_turn() -> None:
    scene = spinning(5.0)
    watch = GoalWatch(
        Goal(quantity="spring0.direction", of="value", low=395.0, high=405.0, seconds=0.0), scene
    )
    simulation = sim.Simulation(scene)
    seen = []
    for _ in range(90):
        watch.look(simulation)
        seen.append(watch.value)
        simulation.step(80)
    assert watch.reached
    assert seen == pytest.approx(np.degrees(5.0) * np.arange(90) / 60.0, abs=1.5)
    simulation.reset()
    watch.look(simulation)
    assert watch.value == pytest.approx(0.0, abs=0.1)


def test_a_formula_is_a_goal_and_has_no_reading_where_it_has_no_value() -> None:
    scene = a_scene()
    watch = GoalWatch(Goal(quantity="(mass1.y - mass0.y)^2 / 1 [px^2]", low=0.0), scene)
    assert watch.look(sim.Simulation(scene))
    watch = GoalWatch(Goal(quantity="mass1.y / (mass0.x - mass0.x)", low=-1e300), scene)
    assert not watch.look(sim.Simulation(scene))
    assert watch.value is None


def test_a_goal_is_held_without_a_break() -> None:
    scene = a_scene()
    goal = Goal(quantity="mass1.y", low=205.0, seconds=0.5)
    simulation = sim.Simulation(scene)
    watch = GoalWatch(goal, scene)
    # It swings from 200 to 220: below 205 for a third of its period.
    held = []
    for _ in range(1000):
        simulation.step(1)
        watch.look(simulation)
        held.append(watch.held)
    assert not np.isnan(held).any()
    assert watch.reached == (PERIOD * 2.0 / 3.0 >= 0.5)
    assert max(held) == pytest.approx(PERIOD * 2.0 / 3.0, abs=0.01)
    never = GoalWatch(Goal(quantity="mass1.y", low=205.0, seconds=0.7), scene)
    simulation.reset()
    for _ in range(2000):
        simulation.step(1)
        never.look(simulation)
    assert not never.reached


def test_what_does_not_swing_has_no_period() -> None:
    scene = msgspec.structs.replace(a_scene(), gravity=(0.0, 0.0))
    simulation = sim.Simulation(scene)
    meter = Meter(Reading(quantity="mass1.y", of="period"), scene)
    for _ in range(500):
        simulation.step(1)
        assert meter.take(simulation) is None


GOAL = a_step(Goal(quantity="mass1.y", low=260.0))
"""What no honest run reaches: the mass goes down to 220 with the stiffness that it has."""
NEVER = Doubt("class-doubt-never")


def lines_of(data: bytes) -> list[dict]:
    return [msgspec.json.decode(line) for line in data.splitlines()]


def forged(data: bytes, dice: random.Random) -> bytes:
    """A log that says something that its pupil could not do."""
    header, *entries = lines_of(data)
    scene = header["scene"]
    where = dice.randrange(len(entries))
    kind = dice.randrange(8)
    if kind == 0:
        scene["gravity"] = [0.0, dice.uniform(2000.0, 9000.0)]
    elif kind == 1:
        scene["masses"][1]["position"] = [300.0, dice.uniform(265.0, 500.0)]
    elif kind == 2:
        scene["linear_springs"][0]["rest_length"] = dice.uniform(200.0, 300.0)
    elif kind == 3:
        entries.insert(where, {"do": "set", "key": "gravity", "value": dice.uniform(2000.0, 5000.0)})
    elif kind == 4:
        places = [[300.0, 100.0], [300.0, dice.uniform(265.0, 500.0)]]
        pose = {"positions": places, "velocities": [[0.0, 0.0], [0.0, dice.uniform(-9.0, 9.0)]]}
        entries.insert(where, {"do": "restore", "pose": pose, "time": 0.0, "step": 0})
        entries = [entry for entry in entries if entry["do"] != "check"] if dice.random() < 0.5 else entries
    elif kind == 5:
        other = {
            **scene,
            "masses": [scene["masses"][0], {**scene["masses"][1], "mass": dice.uniform(5.0, 9.0)}],
        }
        pose = {"positions": [[300.0, 100.0], [300.0, 200.0]], "velocities": [[0.0, 0.0], [0.0, 0.0]]}
        entries.insert(where, {"do": "restore", "pose": pose, "time": 0.0, "step": 0, "scene": other})
    elif kind == 6:
        scene["anchors"] = []
    else:
        check = next(entry for entry in entries if entry["do"] == "check")
        check["digest"] = f"{dice.getrandbits(128):032x}"
    return b"\n".join(map(msgspec.json.encode, (header, *entries)))


def test_of_a_hundred_forged_logs_none_is_accepted() -> None:
    _, data = run(a_scene(), 3.0)
    honest = judge(decode_log(data, "log"), a_scene(), GOAL)
    assert (honest.refused, honest.reached) == ("", False)
    dice = random.Random(1)
    for _ in range(100):
        made = forged(data, dice)
        verdict = judge(decode_log(made, "log"), a_scene(), GOAL)
        assert verdict.refused
        assert not verdict.reached


def test_going_back_in_time_is_what_a_pupil_can_do() -> None:
    scene = a_scene()
    simulation = sim.Simulation(scene)
    recorder = Recorder(simulation)
    for _ in range(60):
        recorder.step(8)
    before = simulation.capture()
    for _ in range(60):
        recorder.step(8)
    recorder.restore(before)
    for _ in range(60):
        recorder.step(8)
    assert (
        judge(decode_log(recorder.file(), "log"), scene, a_step(Goal(quantity="mass1.y", low=205.0))).refused
        == ""
    )


def test_a_run_goes_on_after_its_page_was_reloaded() -> None:
    scene = a_scene()
    first = Session(scene, wait=True)
    first.do_steps(60)
    kept = first.keepsake()
    after = Session(scene, wait=True)
    after.resume(kept, None)
    after.do_steps(60)
    record = decode_log(after.recorder.file(), "log")
    assert judge(record, scene, GOAL, after.recorder.visited).refused == ""
    # What the server has not seen there was never there.
    first.do_steps(1)
    for been in ((), (digest_of(first.simulation),)):
        assert judge(record, scene, GOAL, been).refused == NEVER


def test_a_run_goes_on_when_its_kernels_are_ready(monkeypatch: pytest.MonkeyPatch) -> None:
    """As after a restart of the server: the log begins where NumPy has led the body."""
    simulation = sim.Simulation(a_scene())
    with monkeypatch.context() as patch:
        patch.setattr(sim.Simulation, "complete", False)
        recorder = Recorder(simulation)
        recorder.step(60)
    recorder.step(60)
    recorder.step(60)
    record = decode_log(recorder.file(), "log")
    assert judge(record, a_scene(), GOAL, recorder.visited).refused == ""
    assert judge(record, a_scene(), GOAL).refused == NEVER
