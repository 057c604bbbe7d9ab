"""Lessons between the page and the session, without a browser."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest

import sim
from app.cli.main import Check
from app.features.lesson.messages import BeginStep, LessonStep
from app.features.lesson.messages import Lesson as LessonState
from app.features.lesson.panel import LessonPanel
from app.lessons import check_lesson, goal_text, lesson_code, quantity_text, read_masses, run_text
from app.session import commands
from app.session.log import decode_log
from app.session.notices import Notice
from app.session.plots import PlotSpec
from app.wire.messages import read
from app.words import speaking
from sim.edit.build import add_mass
from sim.edit.lesson import add_step
from sim.scene.lesson import Goal, Lead, Lesson, Pull, Question, Reading, Step, StepRun
from sim.scene.parts import Circle
from sim.settings import CHOICES, scene_of_run, scene_of_step, setting_of
from sim.store.files import built_in_folder, decode_scene, encode_scene, list_scenes
from tests.amount import part_of
from tests.app.letters import Letters
from tests.app.pages import SessionPage
from tests.app.panels import Client, page_of
from tests.app.whole import WholePage

FORMULA = "atan2(mass1.y - mass0.y, spring0.length)"

LESSONS = sorted(path.stem for path in (built_in_folder() / "lessons").glob("*.json"))
QUESTION = Question(text="?", choices=("a", "b"), answer=1, because="so")


def with_lesson(*steps: Step) -> sim.Scene:
    return msgspec.structs.replace(sim.load_scene("tutorial-3.3"), lesson=Lesson(steps=steps))


def test_a_message_begins_a_step_and_nonsense_does_not() -> None:
    for how in ("run", "wait", "on"):
        assert read(f'{{"do":"beginStep","step":12,"how":"{how}"}}') == BeginStep(12, how)
    nonsense_said = (
        '"step":-1',
        '"step":123',
        '"step":1.5',
        '"step":"1"',
        '"step":1,"how":"walk"',
        '"how":"on"',
    )
    for nonsense in nonsense_said:
        assert read(f'{{"do":"beginStep",{nonsense}}}') is None


def test_a_lesson_is_saved_and_a_scene_without_one_does_not_mention_it() -> None:
    scene = with_lesson(Step(title="A", do="B", question=QUESTION, settings=("gravity=0",)))
    assert decode_scene(encode_scene(scene), "a") == scene
    assert b"lesson" not in encode_scene(sim.load_scene("ring"))


def test_steps_set_what_they_name() -> None:
    scene = with_lesson(
        Step(title="A", do="B"), Step(title="A", do="B", settings=("gravity=7", "method=rk4"))
    )
    assert scene_of_step(scene, 0) == scene
    second = scene_of_step(scene, 1)
    assert second.gravity == (0.0, 7.0)
    assert second.integrator.method == "rk4"
    with pytest.raises(sim.SettingError, match=r"^lesson\.steps: step 2 does not exist$"):
        scene_of_step(scene, 2)


def test_a_run_changes_what_the_step_sets_and_moves_masses_before_it_lets_them_go() -> None:
    pulls = (Pull(mass=3, by=(5.0, -7.0)), Pull(mass=1, by=(0.0, 2.0)))
    run = StepRun(settings=("gravity=9", "dt=0.001"), pulls=pulls)
    scene = with_lesson(
        Step(title="A", do="B", settings=("gravity=7", "air_friction=1"), run=run), Step(title="C", do="D")
    )
    begins, runs = scene_of_step(scene, 0), scene_of_run(scene, 0)
    assert (begins.gravity, runs.gravity) == ((0.0, 7.0), (0.0, 9.0))
    assert (begins.integrator.dt != 0.001, runs.integrator.dt) == (True, 0.001)
    one, other = (sim.Simulation(at) for at in (begins, runs))
    moved = other.positions - one.positions
    assert moved[3] == pytest.approx((5.0, -7.0))
    assert moved[1] == pytest.approx((0.0, 2.0))
    assert not np.delete(moved, (1, 3), axis=0).any()
    assert runs.linear_springs == begins.linear_springs, "springs are stretched, not longer"
    assert scene_of_run(scene, 1) == scene_of_step(scene, 1)
    assert decode_scene(encode_scene(scene), "a") == scene


def test_a_run_leads_masses_round_circles_as_anchors_go() -> None:
    circle = Circle(radius=20.0, frequency=0.7)
    scene = with_lesson(
        Step(title="A", do="B", run=StepRun(leads=(Lead(mass=0, circle=circle), Lead(mass=5, circle=circle))))
    )
    begins, runs = scene_of_step(scene, 0), scene_of_run(scene, 0)
    assert {anchor.mass: anchor.circle for anchor in runs.anchors} == {0: circle, 5: circle}
    one, other = sim.Simulation(runs), sim.Simulation(begins)
    for simulation in (one, other):
        simulation.advance(0.7)
    t = 0.7
    phase = 2.0 * math.pi * 0.7 * (t - 0.1 * (1.0 - math.exp(-t / 0.1)))
    start = begins.masses[5].position
    there = (start[0] + 20.0 * math.sin(phase), start[1] + 20.0 * (1.0 - math.cos(phase)))
    assert one.positions[5] == pytest.approx(there, abs=0.2)
    assert np.abs(one.positions - other.positions).max() > 10.0
    assert decode_scene(encode_scene(scene), "a") == scene


@pytest.mark.parametrize(
    ("run", "said"),
    [
        (StepRun(), "it needs settings, pulls, leads or muscles"),
        (StepRun(leads=(Lead(mass=40, circle=Circle(radius=5.0)),)), "leads[0].mass: mass 40 does not exist"),
        (StepRun(leads=(Lead(mass=2, circle=Circle(radius=5.0)),) * 2), "leads[1].mass: mass 2 is led twice"),
        (StepRun(pulls=(Pull(mass=40, by=(1.0, 0.0)),)), "pulls[0].mass: mass 40 does not exist"),
        (StepRun(pulls=(Pull(mass=2, by=(1.0, 0.0)),) * 2), "pulls[1].mass: mass 2 is pulled twice"),
        (StepRun(pulls=(Pull(mass=2, by=(math.nan, 0.0)),)), "pulls[0].by"),
        (StepRun(pulls=(Pull(mass=2, by=(2e6, 0.0)),)), "pulls[0].by"),
        (StepRun(settings=("gravity=1", "gravty=2")), "settings[1]: gravty: there is no such setting"),
    ],
)
def test_a_run_that_cannot_be_is_refused(run: StepRun, said: str) -> None:
    with pytest.raises((sim.SceneError, sim.SettingError)) as refused:
        scene = with_lesson(Step(title="A", do="B", run=run))
        sim.validate(scene)
        scene_of_run(scene, 0)
    assert "lesson.steps[0].run" in str(refused.value)
    assert said in str(refused.value)


def test_a_step_waits_as_it_begins_and_runs_what_it_asked_about() -> None:
    run = StepRun(settings=("gravity=9",))
    page = SessionPage(
        with_lesson(Step(title="A", do="B", question=QUESTION, settings=("gravity=7",), run=run))
    )
    panel = lesson_panel(page, [])
    panel.begin(BeginStep(0, "wait"))
    page.frames(1)
    assert (page.session.scene.gravity, page.session.playing) == ((0.0, 7.0), False)
    panel.begin(BeginStep(0, "run"))
    page.frames(2)
    assert (page.session.scene.gravity, page.session.playing) == ((0.0, 9.0), True)
    page.frames(1, commands.Reset())
    assert page.session.scene.gravity == (0.0, 9.0), "from the beginning of what was asked"


def test_what_is_wrong_with_a_lesson_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    question = msgspec.structs.replace(QUESTION, answer=2)
    with pytest.raises(sim.SceneError, match=r"^lesson\.steps\[0\]\.question\.answer: choice 2 "):
        sim.validate(with_lesson(Step(title="A", do="B", question=question)))
    with pytest.raises(sim.SceneError, match=r"^lesson\.steps"):
        sim.validate(msgspec.structs.replace(sim.load_scene("ring"), lesson=Lesson(steps=())))
    path = tmp_path / "lesson.json"
    sim.save_scene(with_lesson(Step(title="A", do="B", settings=("gravity=0", "gravty=1"))), path)
    assert Check((path,)).run() == 1
    assert f"{path}: lesson.steps[0].settings[1]: gravty: there is no such setting" in capsys.readouterr().err


def test_a_plot_that_cannot_be_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "lesson.json"
    for text, said in (
        ("joint0.angle, joint99.angle", "joint99.angle: joint 99 does not exist (0..9)"),
        ("joint0.rate over time", "'time' is not a quantity"),
        ("mass0.x, mass0.y, mass1.x, mass1.y, mass2.x, mass2.y", "a plot has room for 5 quantities"),
        ("joint0.angle,", "'' is not a quantity"),
    ):
        sim.save_scene(with_lesson(Step(title="A", do="B"), Step(title="A", do="B", plots=(text,))), path)
        assert Check((path,)).run() == 1
        assert f"{path}: lesson.steps[1].plots[0]: {said}" in capsys.readouterr().err
    sim.save_scene(
        with_lesson(Step(title="A", do="B", plots=("mass1.x, ghost.distance",), arrows=("forces",))), path
    )
    assert Check((path,)).run() == 0
    with pytest.raises(sim.SceneError, match=r"^x: lesson\.steps\[0\]\.arrows\[0\]"):
        decode_scene(path.read_bytes().replace(b'"forces"', b'"force"'), "x")


def lesson_panel(page: SessionPage, told: list[Notice], letters: Letters | None = None) -> LessonPanel:
    client: Any = Client()
    tab = client.gui.add_tab_group().add_tab("Lesson")
    return LessonPanel(page_of(page.session, client, letters, told.append), tab)


def test_the_page_is_told_what_it_shows_of_a_lesson() -> None:
    page, letters = (
        SessionPage(with_lesson(Step(title="A", do="B", question=QUESTION, settings=("gravity=0",)))),
        Letters(),
    )
    panel = lesson_panel(page, [], letters)
    panel.build()
    panel.build()
    name = f"{page.session.scene.name}.{lesson_code(page.session.scene)}"
    # The settings are the server's.
    assert letters.sent == [LessonState(name=name, steps=(LessonStep("A", "B", "", QUESTION, run=False),))]


def test_a_step_has_its_sliders_plots_and_ghost_and_the_next_one_its_own() -> None:
    steps = (
        Step(
            title="A",
            do="B",
            question=QUESTION,
            controls=("gravity",),
            plots=("joint0.rate over joint0.angle",),
            ghost="rk4",
        ),
        Step(title="A", do="B", controls=("angular_stiffness",)),
    )
    page, told = SessionPage(with_lesson(*steps)), []
    panel = lesson_panel(page, told)
    panel.begin(BeginStep(0))
    page.frames(1)
    panel.build()
    assert not page.session.playing
    assert panel.controls == ("gravity",)
    assert panel.plots.specs == (PlotSpec(("joint0.rate",), "joint0.angle"),)
    assert page.session.ghost is not None
    assert page.session.ghost.method == "rk4"
    panel.begin(BeginStep(1))
    page.frames(1)
    panel.build()
    assert (panel.controls, panel.plots.specs, page.session.ghost) == (("angular_stiffness",), (), None)
    # What has been answered need not wait.
    panel.begin(BeginStep(0, "run"))
    page.frames(1)
    assert page.session.playing
    # A page that goes on in the middle of a step does not begin it anew.
    time = page.simulation.time
    panel.begin(BeginStep(1, "on"))
    page.frames(1)
    assert page.simulation.time > time
    assert panel.controls == ("angular_stiffness",)
    panel.begin(BeginStep(7))  # a page can send anything
    assert panel.step == steps[1]
    assert not told


def test_nothing_is_to_be_undone_of_a_lesson_that_has_just_been_opened() -> None:
    lesson = with_lesson(Step(title="A", do="B", settings=("gravity=0",)), Step(title="C", do="D"))
    page = SessionPage(lesson)
    panel, versions = lesson_panel(page, []), page.session.versions
    panel.begin(BeginStep(0))
    page.frames(1)
    assert page.session.scene.gravity == (0.0, 0.0)
    assert not versions.undoable
    panel.begin(BeginStep(1))
    page.frames(1)
    assert versions.undoable
    # Opened in the place of another scene, the lesson is one step with its beginning.
    page.frames(1, commands.Open(sim.load_scene("ring")))
    ring = page.simulation.capture().scene
    page.frames(1, commands.Open(lesson))
    panel.begin(BeginStep(0))
    page.frames(1)
    page.frames(1, commands.Undo())
    assert page.simulation.capture().scene is ring
    page.frames(1, commands.Redo())
    assert page.session.scene.gravity == (0.0, 0.0)


def test_what_a_step_cannot_have_is_told_by_check(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "lesson.json"
    for step, said in (
        (
            Step(title="A", do="B", controls=("gravity", "gravty")),
            "controls[1]: gravty: there is no such setting",
        ),
        (
            Step(title="A", do="B", controls=("wind_speed",)),
            "controls[0]: wind_speed: the scene 'tutorial-3.3' has",
        ),
        (Step(title="A", do="B", ghost="leapfrog"), "ghost: 'leapfrog' is not one of reference, "),
    ):
        sim.save_scene(with_lesson(Step(title="A", do="B"), step), path)
        assert Check((path,)).run() == 1
        assert f"{path}: lesson.steps[1].{said}" in capsys.readouterr().err
    sim.save_scene(with_lesson(Step(title="A", do="B", controls=("gravity",), ghost="reference")), path)
    assert Check((path,)).run() == 0


def test_a_step_begins_when_a_scene_is_opened_and_not_when_it_goes_on() -> None:
    scene = with_lesson(Step(title="A", do="B"))
    page = SessionPage(scene)
    assert not page.session.lesson_begun
    lesson_panel(page, []).begin(BeginStep(0))
    page.frames(5)
    assert page.session.lesson_begun
    kept, log = page.session.keepsake(), page.session.recorder.file()
    page.frames(1, commands.Open(scene))
    assert not page.session.lesson_begun
    for command in (commands.Resume(kept), commands.Replay(decode_log(log, "log")), commands.Undo()):
        page.frames(1, commands.Open(sim.load_scene("ring")))
        page.frames(1, command)
        assert page.session.scene.lesson == scene.lesson
        assert page.session.lesson_begun
        page.frames(1, commands.Open(scene))


def test_leaving_a_question_lets_the_next_scene_run() -> None:
    page = SessionPage("lesson-hooke")
    panel = lesson_panel(page, [])
    lesson = page.session.scene.lesson
    assert lesson is not None
    asks = next(i for i, step in enumerate(lesson.steps) if step.question is not None)
    panel.begin(BeginStep(asks))
    page.frames(5)
    assert not page.session.playing
    page.frames(5, commands.Open(sim.load_scene("ring")))
    assert page.session.playing
    # A user's own pause stays.
    page.frames(5, commands.Play(False), commands.Open(sim.load_scene("box")))
    assert not page.session.playing
    # So does that of a step whose question was answered, and which was paused then.
    page.frames(1, commands.Open(sim.load_scene("lesson-hooke")))
    panel.begin(BeginStep(asks))
    page.frames(5, commands.Play(True), commands.Play(False), commands.Open(sim.load_scene("ring")))
    assert not page.session.playing


def test_a_step_of_a_lesson_that_was_made_since_begins_with_the_body_as_it_is() -> None:
    page, told = SessionPage("rope"), []
    panel = lesson_panel(page, told)
    page.frames(1, commands.Change(lambda moment, _: add_mass(moment.scene, (9.0, 9.0))))
    page.frames(1, commands.Change(lambda moment, _: add_step(moment.scene, 0)))
    masses = len(page.session.scene.masses)
    panel.begin(BeginStep(0))
    page.frames(1)
    assert not told
    assert page.session.lesson_begun
    assert len(page.session.scene.masses) == masses == len(sim.load_scene("rope").masses) + 1


@pytest.mark.parametrize("name", part_of(LESSONS, 3))
def test_every_step_of_a_lesson_begins_with_its_sliders_and_plots(name: str) -> None:
    page = WholePage(name)
    lesson = page.scene.lesson
    assert lesson is not None
    for i, step in enumerate(lesson.steps):
        page.shown(BeginStep(i, "run"))
        wanted = [
            CHOICES[key].label if key in CHOICES else setting_of(page.scene, key).label
            for key in step.controls
        ]
        shown = [one for one in page.gui.there if one.is_shown and one.is_in(page.gui["Lesson"])]
        shown.sort(key=lambda one: one.order)
        titles = [i for i, one in enumerate(shown) if "softrod-plot-title" in str(one.content)]
        assert len(titles) == len(step.plots or ())
        labels = [(i, one.label) for i, one in enumerate(shown) if one.kind in ("slider", "dropdown")]
        first = min(titles, default=len(shown))
        assert [label for i, label in labels if i < first] == wanted
        assert [label for i, label in labels if i > first] == ["Analysis"] * len(titles)
        assert page.session.playing and page.simulation.time > 0.0
    assert not page.notices


def test_a_step_begins_without_what_the_run_before_it_pulled_or_led() -> None:
    pull, lead = Pull(mass=3, by=(0.0, 40.0)), Lead(mass=5, circle=Circle(radius=5.0))
    scene = with_lesson(
        Step(title="A", do="B", run=StepRun(pulls=(pull,), leads=(lead,))), Step(title="C", do="D")
    )
    page = WholePage()
    page.shown(commands.Open(scene))
    page.shown(BeginStep(0, "run"))
    assert page.scene.pose is not None
    kept = page.session.keepsake()
    page.shown(BeginStep(1, "run"))
    assert page.scene == scene
    again = WholePage()
    again.shown(commands.Resume(bytes(kept)))
    again.shown(BeginStep(1, "run"))
    assert again.scene == scene


def test_a_lesson_takes_away_with_it_what_it_showed() -> None:
    page = WholePage()
    page.shown(commands.Open(sim.load_scene("lesson-laws")))
    page.shown(BeginStep(0))
    assert (page.gui["Forces"].value, page.gui["Torques"].value) == (False, True), "the step's own arrows"
    page.shown(commands.Open(sim.load_scene("lesson-chaos")))
    page.shown(BeginStep(1))
    assert page.session.ghost is not None, "the second step of another lesson has a ghost"
    page.shown(commands.Open(sim.load_scene("rod")))
    assert page.session.ghost is None
    assert "Lesson" not in page.gui
    assert (page.gui["Forces"].value, page.gui["Torques"].value) == (False, False)


def test_formulas_in_a_step_are_named_as_they_are_and_read_their_masses() -> None:
    scene = sim.rope(6)
    step = Step(
        title="t", do="d", plots=(f"{FORMULA}, body[3,4].x over mass99.x",),
        collect=Reading(quantity="body.x"),
    )  # fmt: skip
    assert read_masses(step, scene) == (0, 1, 3, 4)
    words = {
        FORMULA: FORMULA, "body.angular_momentum": "angular momentum of the body", "mass1.y": "y of mass 1",
        "body[3,4].x": "body[3,4].x", "energy.kinetic": "kinetic", "spring2.length": "length of spring 2",
    }  # fmt: skip
    assert {name: quantity_text(name) for name in words} == words
    with speaking("de"):
        assert quantity_text("body.angular_momentum") == "Drehimpuls des Körpers"
    assert goal_text(Goal(quantity=FORMULA, of="period", low=1.0), scene) == (
        f"period of {FORMULA}: at least 1 s"
    )
    goal = Goal(quantity=FORMULA, low=1.0, high=2.0)
    assert goal_text(goal, scene) == f"{FORMULA}: 1 to 2 °"
    check_lesson(with_lesson(msgspec.structs.replace(step, plots=(FORMULA,), goal=goal)))
    wrong = msgspec.structs.replace(step, plots=("mass0.x + 1",))
    with pytest.raises(sim.InputError, match=r"^lesson\.steps\[0\]\.plots\[0\]: .* cannot be added"):
        check_lesson(with_lesson(wrong))


@pytest.mark.parametrize(
    ("tag", "said"),
    [
        ("en", "period of the body: at most 2 s, for 0.5 s; "
         "mass 1 is pulled 3 px right and 4 px up and let go."),
        ("de", "Periodendauer des Körpers: höchstens 2 s, 0,5 s lang; "
         "Masse 1 wird 3 px nach rechts und 4 px nach oben gezogen und losgelassen."),
    ],
)  # fmt: skip
def test_goals_and_runs_are_said_in_the_language_of_the_page(tag: str, said: str) -> None:
    scene = sim.rope(6)
    goal = Goal(quantity="body.y", of="period", high=2.0, seconds=0.5)
    run = StepRun(pulls=(Pull(mass=1, by=(3.0, -4.0)),))
    with speaking(tag):
        assert f"{goal_text(goal, scene)}; {run_text(run, scene)}" == said


def test_texts_of_presets_name_what_a_finger_can_press_before_a_key() -> None:
    """Phones have no keys; where there are both, the button comes first."""
    key = re.compile(r"\b(?<!, or )(?<!, or the )(?:[Pp]ress|[Kk]ey|with) (?:[A-Z]|Space|Esc|Enter|Tab)\b")
    for info in list_scenes():
        scene = sim.load_scene(info.name)
        steps = scene.lesson.steps if scene.lesson is not None else ()
        for text in (scene.description, *(text for step in steps for text in (step.do, step.watch))):
            assert not key.search(text), (info.name, text)
