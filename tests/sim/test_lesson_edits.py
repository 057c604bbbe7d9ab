"""A lesson is made: steps come, go, change places, and begin as the sliders stand."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import UNSET
from msgspec.structs import replace

import sim
from sim.edit import lesson as edits
from sim.edit.edit import Selection, inverse
from sim.edit.muscles import move_muscles
from sim.errors import SceneError
from sim.scene.lesson import Goal, Lesson, Pull, Question, Reading, Step
from sim.settings import apply_assignments, scene_of_run, scene_of_step, setting_of, settings_of
from sim.store.files import decode_scene, encode_scene
from tests.sim.checks import refusal

ROPE = sim.load_scene("rope")
QUESTION = Question(text="?", choices=("a", "b"), answer=1, because="so")


def asking(**changes: Any) -> dict[str, Question]:
    return {"question": replace(QUESTION, **changes)}


def aiming(quantity: str = "mass1.y", **rest: Any) -> dict[str, Goal]:
    return {"goal": Goal(quantity=quantity, **rest)}


def steps(scene: sim.Scene) -> tuple[Step, ...]:
    return scene.lesson.steps if scene.lesson is not None else ()


def titles(scene: sim.Scene) -> list[str]:
    return [step.title for step in steps(scene)]


def with_steps(*names: str, scene: sim.Scene = ROPE) -> sim.Scene:
    for i, name in enumerate(names):
        scene = edits.add_step(scene, i).scene
        scene = edits.change_step(scene, i, "title", title=name).scene
    return scene


def test_the_first_step_begins_a_lesson_of_a_scene_of_its_own() -> None:
    edit = edits.add_step(ROPE, 0)
    scene = sim.validate(edit.scene)
    assert (scene.name, scene.title) == ("my lesson", "")
    assert titles(scene) == ["Step 1"]
    assert inverse(edit, ROPE).scene is ROPE
    nothing_else = {"name": ROPE.name, "title": ROPE.title, "lesson": None}
    assert replace(scene, **nothing_else) == ROPE
    # A scene of one's own keeps its name.
    mine = replace(ROPE, name="mine", title="Mine")
    assert edits.add_step(mine, 0).scene.title == "Mine"
    # With its last step the lesson goes.
    assert edits.remove_step(scene, 0).scene.lesson is None
    assert edits.remove_lesson(with_steps("A", "B")).scene.lesson is None
    assert edits.remove_lesson(ROPE).scene is ROPE


ACTS = st.lists(
    st.tuples(st.sampled_from(("add", "copy", "remove", "move")), st.integers(0, 9), st.integers(0, 9)),
    max_size=30,
)


@given(ACTS)
def test_steps_are_ordered_as_a_list_would_be(acts: list[tuple[str, int, int]]) -> None:
    scene, wanted = with_steps("a", "b", "c"), ["a", "b", "c"]
    for number, (act, at, to) in enumerate(acts):
        before, known = scene, list(wanted)
        try:
            if act == "add":
                edit = edits.add_step(scene, at)
                name = f"new {number}"
                scene = edits.change_step(edit.scene, at, "title", title=name).scene
                wanted.insert(at, name)
            elif act == "copy":
                edit = edits.copy_step(scene, at)
                scene = edit.scene
                wanted.insert(at + 1, wanted[at])
            elif act == "remove":
                edit = edits.remove_step(scene, at)
                scene = edit.scene
                del wanted[at]
            else:
                edit = edits.move_step(scene, at, to)
                scene = edit.scene
                wanted.insert(to, wanted.pop(at))
        except SceneError as error:
            assert str(error).startswith("lesson.steps: ")
            outside = max(at, to if act == "move" else 0) >= len(known) + (act == "add")
            assert outside or len(known) == 20
            assert scene is before
            wanted = known
        else:
            assert inverse(edit, before).scene is before
        assert titles(scene) == wanted
        sim.validate(scene)


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"title": ""}, "title: it must not be empty"),
        ({"title": "x" * 161}, "title: 161 characters are more than 160"),
        ({"do": ""}, "do: it must not be empty"),
        ({"watch": "\ud800"}, ": it has characters that cannot be written to a file"),
        ({"predict": 0.0}, "predict: 0 is not above 0 and at most 600"),
        ({"predict": float("nan")}, "predict: nan is not a finite number"),
        ({"predict": 601.0}, "predict: 601 is not above 0 and at most 600"),
        (asking(choices=("a",)), "question.choices: a question has 2 to 5"),
        (asking(choices=("a", "")), "question.choices[1]: it must not be empty"),
        (asking(answer=2), "question.answer: choice 2 does not exist (0..1)"),
        (asking(because=""), "question.because: it must not be empty"),
        (aiming(), "goal: it needs low, high or both"),
        (aiming(low=2.0, high=1.0), "goal: low 2 is above high 1"),
        (aiming("mass99.y", low=2.0), "goal.quantity: mass99.y: mass 99 does not exist"),
        (aiming(low=2.0, seconds=601.0), "goal.seconds: 601 is not in the range 0..600"),
        (aiming(low=float("inf")), "goal.low: inf is not a finite number"),
        ({"collect": Reading(quantity="hope")}, "collect.quantity: 'hope' is not a quantity"),
        ({"controls": ("gravity", "gravty")}, "controls[1]: gravty: there is no such setting"),
        ({"controls": ("gravity",) * 7}, "controls: 7 entries are more than 6"),
    ],
)  # fmt: skip
def test_what_a_step_cannot_have_is_refused_in_one_sentence_that_names_the_field(
    changes: dict[str, Any], why: str
) -> None:
    scene = with_steps("A", "B")
    said = refusal(SceneError, edits.change_step, scene, 1, "it", **changes)
    dot = "" if why.startswith(":") else "."
    assert said.startswith(f"lesson.steps[1]{dot}{why}")


def test_a_step_has_all_that_the_format_has() -> None:
    scene = with_steps("A", "B")
    everything: dict[str, Any] = {
        "title": "T", "question": QUESTION, "do": "D", "watch": "W", "controls": ("gravity", "method"),
        "plots": ("mass1.x over mass1.y",), "arrows": ("forces",), "ghost": "reference", "predict": 1.5,
        "goal": Goal(quantity="mass1.y", of="period", low=1.0, high=2.0, seconds=3.0),
        "collect": Reading(quantity="joint0.angle"),
    }  # fmt: skip
    for field, value in everything.items():
        edit = edits.change_step(scene, 1, field, **{field: value})
        assert edit.label == f"{field} of step 2"
        scene = edit.scene
    assert {field: getattr(steps(scene)[1], field) for field in everything} == everything
    assert steps(scene)[0] == steps(with_steps("A", "B"))[0]
    assert decode_scene(encode_scene(scene), "x") == scene
    assert edits.change_step(scene, 1, "title", title="T").scene is scene
    with pytest.raises(SceneError, match=r"^lesson\.steps: step 2 does not exist \(0\.\.1\)$"):
        edits.change_step(scene, 2, "title", title="T")


def test_a_step_begins_as_the_sliders_stand_whatever_comes_before_it_and_however_the_scene_is_saved() -> None:
    opened = with_steps("A", "B", "C")
    at_two = apply_assignments(opened, ("gravity=300", "method=rk4"))
    two = edits.begin_as(opened, 1, at_two, opened).scene
    # Then another slider is moved for the third step.
    at_three = apply_assignments(replace(at_two, lesson=two.lesson), ("air_friction=0.02",))
    three = edits.begin_as(two, 2, at_three, opened).scene
    wanted = (
        (1500.0, opened.integrator.method, opened.air_friction),
        (300.0, "rk4", opened.air_friction),
        (300.0, "rk4", 0.02),
    )
    # Saved with the sliders as they stood first or last, and gone through in any order.
    for saved in (three, replace(at_three, lesson=three.lesson)):
        scene = saved
        for number in (0, 1, 2, 0, 2, 1, 0):
            scene = scene_of_step(scene, number)
            assert (scene.gravity[1], scene.integrator.method, scene.air_friction) == wanted[number]
    # As it is already: nothing changes.
    assert edits.begin_as(three, 2, at_three, opened).scene is three


def test_a_method_without_a_tolerance_gets_none_from_another_step() -> None:
    opened = with_steps("A", "B")
    euler = apply_assignments(opened, ("method=symplectic_euler",))
    one = edits.begin_as(opened, 0, euler, opened).scene
    adaptive = apply_assignments(replace(opened, lesson=one.lesson), ("method=auto", "tolerance=0.5"))
    two = edits.begin_as(one, 1, adaptive, opened).scene
    assert scene_of_step(two, 0).integrator.method == "symplectic_euler"
    assert scene_of_step(two, 1).integrator.tolerance == 0.5
    assert scene_of_step(scene_of_step(two, 1), 0).integrator.method == "symplectic_euler"


@pytest.mark.parametrize(
    "name", ["tutorial-3.3", "rope", "flag-pole", "water-balloon", "bridge", "lesson-hooke"]
)
def test_whatever_sliders_a_scene_has_a_step_can_begin_with_them(name: str) -> None:
    opened = edits.add_step(sim.load_scene(name), 0).scene
    now = opened
    for setting in settings_of(opened):
        if setting.key not in ("template", "method", "tolerance") and not setting.integer:
            value = setting.read(now)
            near = value + 0.1 * (setting.slider[1] - setting.slider[0])
            now = sim.set_value(now, setting.key, near if near <= setting.high else setting.low)
    made = edits.begin_as(opened, 0, now, opened).scene
    begun = scene_of_step(made, 0)
    for setting in settings_of(now):
        assert setting.read(begun) == pytest.approx(setting.read(now), rel=1e-9, abs=1e-9), setting.key


def test_a_step_runs_the_case_that_is_there_now() -> None:
    scene = with_steps("A", "B")
    one = edits.change_step(scene, 1, "settings", settings=("gravity=7",)).scene
    now = apply_assignments(scene_of_step(one, 1), ("gravity=9", "air_friction=1"))
    places = sim.Simulation(now).positions.copy()
    places[4] += (12.34, -5.0)
    places[6] += (0.1, 0.2)  # as a hand has not quite led it back
    ran = edits.run_as(one, 1, now, places, ROPE).scene
    run = steps(ran)[1].run
    assert run
    assert set(run.settings) == {"gravity=9.0", "air_friction=1.0"}
    assert run.pulls == (Pull(mass=4, by=(12.3, -5.0)),)
    # What the run changes, no step has from another.
    air = f"air_friction={setting_of(ROPE, 'air_friction').read(ROPE)}"
    assert {air, f"gravity={ROPE.gravity[1]}"} <= set(steps(ran)[0].settings)
    assert steps(ran)[1].settings == ("gravity=7", air)
    begun = sim.Simulation(scene_of_run(ran, 1))
    assert begun.scene.gravity == (0.0, 9.0)
    assert abs(begun.positions[4] - places[4]).max() < 0.06
    # It can be said by a link and a file, and goes with its step.
    assert decode_scene(encode_scene(ran), "x") == ran
    assert steps(edits.copy_step(ran, 1).scene)[2].run == run
    assert steps(edits.change_step(ran, 1, "run", run=UNSET).scene)[1].run is UNSET


def test_a_run_has_the_muscles_that_were_changed() -> None:
    worm = replace(sim.load_scene("worm"), lesson=Lesson(steps=(Step(title="A", do="B"),)))
    places = sim.Simulation(worm).positions
    moved = move_muscles(worm, Selection(joints=frozenset({3})), 0.25, 0.0, -5.0).scene
    run = steps(edits.run_as(worm, 0, moved, places, worm).scene)[0].run
    assert run
    assert [one.joint for one in run.muscles] == [3]
    assert run.muscles[0].muscle == moved.angular_springs[3].muscle
    # A number of the recipe changes them all, and stands for that.
    waves = apply_assignments(worm, ("waves=1",))
    run = steps(edits.run_as(worm, 0, waves, sim.Simulation(waves).positions, worm).scene)[0].run
    assert run
    assert (run.settings, run.muscles) == (("waves=1.0",), ())


def test_a_run_that_differs_in_nothing_or_too_much_is_refused() -> None:
    scene = with_steps("A")
    places = sim.Simulation(scene_of_step(scene, 0)).positions
    with pytest.raises(SceneError, match=r"^lesson\.steps\[0\]\.run: all is as it is when the step begins"):
        edits.run_as(scene, 0, scene, places, scene)
    cloth = with_steps("A", scene=sim.load_scene("cloth"))
    with pytest.raises(SceneError, match=r"^lesson\.steps\[0\]\.run\.pulls: \d+ masses are elsewhere"):
        edits.run_as(cloth, 0, cloth, sim.Simulation(cloth).positions + 3.0, cloth)
