"""A lesson is made in the page: what its form says is the lesson, or is refused beside its field."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
import pytest

import sim
from app.classroom.live import Classes
from app.features.making import messages as asks
from app.features.making.maker import LessonMaker, Measured, describe_settings
from app.features.making.messages import LessonForm, LessonOffers, LessonTaken
from app.lessons import check_lesson, run_text
from app.session import commands
from app.session.notices import Notice
from app.session.plots import parse_plot, plot_text
from app.wire.messages import read
from app.words import languages, speaking
from app.words.english import of, sentence, step_of
from sim.scene.lesson import Goal, Lesson, Question, Reading, Step
from sim.settings import scene_of_step
from sim.store.files import decode_link, decode_scene, encode_scene
from sim.store.link import link_data, pack_scene
from sim.text import Text
from tests.app.letters import Letters
from tests.app.pages import SessionPage
from tests.app.panels import page_of

MEASURED = Measured(
    ("joint0", "mass3", "ghost"), ("mass3.y, mass5.y", "mass3.x over mass3.y"), frozenset({"forces"})
)
MAX_IN_A_MESSENGER = 8000
"""Characters of a link that messengers let pass."""


class Form:
    """A form without a browser."""

    def __init__(self, name: str = "rope") -> None:
        self.page, self.letters, self.notices = SessionPage(sim.load_scene(name)), Letters(), list[Notice]()
        self.seen = page_of(self.page.session, None, self.letters, self.notices.append)
        self.maker = LessonMaker(self.seen, lambda: MEASURED)
        self.say(asks.MakeLesson(True))

    def say(self, *said: asks.Prepare) -> None:
        """Say something as the page does, and let a frame pass."""
        for one in said:
            assert read(msgspec.json.encode(one).decode()) == one
            self.maker.do(one)
            self.page.frames(1)
            self.maker.tell()

    def undo(self, *more: commands.Command) -> None:
        self.page.frames(1, *(more or (commands.Undo(),)))

    @property
    def scene(self) -> sim.Scene:
        return self.page.session.scene

    @property
    def steps(self) -> tuple[Step, ...]:
        return self.scene.lesson.steps if self.scene.lesson is not None else ()

    @property
    def taken(self) -> LessonTaken:
        return self.letters.last(LessonTaken)


def change(step: int, **changes: Any) -> asks.ChangeStep:
    return asks.ChangeStep(step, asks.StepChanges(**changes))


def asked(text: str, choices: tuple[str, ...] = ("a", "b"), answer: int = 0, because: str = "c") -> Any:
    return asks.QuestionDraft(text, choices, answer, because)


def aimed(name: str, low: float | None, high: float | None = None, seconds: float = 0.0) -> asks.GoalDraft:
    return asks.GoalDraft(name, "value", low, high, seconds)


def made() -> Form:
    """A lesson of two steps that has everything."""
    form = Form()
    form.say(
        asks.AddStep(0),
        change(0, title="Weigh it", predict=1.5, controls=("gravity", "method"), ghost="reference"),
        change(0, question=asked("Where will it hang?", ("higher", "lower"), 1, "It is heavier.")),
        asks.TakeInStep(0, "plots"),
        asks.TakeInStep(0, "arrows"),
        asks.AddStep(1),
        change(1, title="Reach it", do="Make it hang deeper.", watch="The lowest mass."),
        change(1, goal=aimed("mass5.y", 100.0, seconds=2.0), collect=asks.ReadingDraft("mass5.y", "period")),
    )
    form.page.frames(1, commands.SetValue("gravity", 700.0))
    form.say(asks.TakeInStep(1, "settings"))
    return form


def test_a_step_runs_the_case_that_was_made_beside_the_form() -> None:
    form = Form("tutorial-3.3")
    form.say(asks.AddStep(0), asks.TakeInStep(0, "run"))
    assert (form.taken.part, form.taken.field) == ("run", "run")
    assert form.taken.refused == "All is as it is when the step begins; change a number or drag a mass first."
    form.page.frames(1, commands.Play(False), commands.Reset(), commands.SetValue("gravity", 700.0))
    x, y = form.page.simulation.positions[11]
    form.page.frames(1, commands.DragStart(11, x, y), commands.Point(x + 40.0, y), commands.DragEnd())
    form.say(asks.TakeInStep(0, "run"))
    run = form.steps[0].run
    assert run
    assert run.settings == ("gravity=700.0",)
    assert [pull.mass for pull in run.pulls] == [11]
    assert form.letters.last(LessonForm).runs[0].startswith("Gravity 700.0 px/s²; mass 11 is pulled ")
    form.say(asks.LeadInStep(0, 3, 20.0, 0.7))
    led = form.steps[0].run
    assert led
    assert (led.pulls, [(lead.mass, lead.circle.radius) for lead in led.leads]) == (run.pulls, [(3, 20.0)])
    assert (
        form.letters.last(LessonForm)
        .runs[0]
        .endswith("mass 3 is led round a circle of 20 px, 0.7 times a second.")
    )
    form.say(asks.TakeInStep(0, "run"))
    kept = form.steps[0].run
    assert kept
    assert kept.leads == led.leads, "what is led is not read off the body"
    for mass, radius, said in ((40, 5.0, "Mass 40 does not exist"), (3, -1.0, "-1 is not in 0..10000")):
        form.say(asks.LeadInStep(0, mass, radius, 1.0))
        assert said in form.taken.refused
    form.say(asks.LeadInStep(0, 3, 0.0, 1.0))
    assert form.steps[0].run == run
    form.say(change(0, run=None))
    assert not form.steps[0].run
    form.undo()
    assert form.steps[0].run == run


def test_the_form_makes_a_lesson_that_has_everything() -> None:
    form = made()
    assert form.steps == (
        Step(
            title="Weigh it", do="Let it run, and watch.", settings=("gravity=1500.0",),
            question=Question(
                text="Where will it hang?", choices=("higher", "lower"), answer=1, because="It is heavier."
            ),
            controls=("gravity", "method"), plots=MEASURED.plots, arrows=("forces",), ghost="reference",
            predict=1.5,
        ),
        Step(
            title="Reach it", do="Make it hang deeper.", watch="The lowest mass.",
            settings=("gravity=700.0",), goal=Goal(quantity="mass5.y", low=100.0, seconds=2.0),
            collect=Reading(quantity="mass5.y", of="period"),
        ),
    )  # fmt: skip
    told = form.letters.last(LessonForm)
    begins = ("Gravity 1500 px/s²", "Gravity 700 px/s²")
    plots = ("y of mass 3, y of mass 5; x of mass 3 over y of mass 3", "")
    assert told == LessonForm(open=True, steps=form.steps, begins=begins, runs=("", ""), plots=plots)
    assert not form.taken.refused
    assert not form.notices
    check_lesson(form.scene)


def test_it_is_saved_linked_exported_and_held_as_a_class(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    scene = made().scene
    assert decode_scene(encode_scene(scene), "x") == scene
    link = f"http://127.0.0.1:8080/s#{pack_scene(scene)}"
    assert len(link) < MAX_IN_A_MESSENGER
    assert decode_link(link_data(link) or "") == scene
    path = tmp_path / "lesson.json"
    sim.save_scene(scene, path)
    classes = Classes()
    room = classes.begin([sim.load_scene(path)]).room
    assert [stop.step for stop in room.stops] == [0, 1]
    assert scene_of_step(scene, 1).gravity == (0.0, 700.0)


def test_a_link_holds_the_longest_lesson_that_there_is() -> None:
    scene = made().scene
    assert scene.lesson is not None
    long = "".join(chr(97 + (7 * i * i + i // 3) % 26) for i in range(600))
    step = msgspec.structs.replace(scene.lesson.steps[0], do=long, watch=long[::-1])
    scene = msgspec.structs.replace(scene, lesson=Lesson(steps=(step,) * 20))
    assert decode_link(pack_scene(scene)) == scene


@pytest.mark.parametrize(
    ("changes", "field", "refused"),
    [
        ({"title": ""}, "title", "It must not be empty."),
        ({"do": "x" * 601}, "do", "601 characters are more than 600."),
        ({"question": asked("")}, "question.text", "It must not be empty."),
        ({"question": asked("?", ("a", ""))}, "question.choices[1]", "It must not be empty."),
        (
            {"question": asked("?", ("a",))},
            "question.choices",
            "A question has 2 to 5 answers to choose from.",
        ),
        ({"question": asked("?", answer=3)}, "question.answer", "Choice 3 does not exist (0..1)."),
        ({"predict": -1.0}, "predict", "-1 is not above 0 and at most 600."),
        ({"goal": aimed("mass5.y", None)}, "goal", "It needs low, high or both."),
        ({"goal": aimed("mass5.y", 3.0, 2.0)}, "goal", "Low 3 is above high 2."),
        ({"goal": aimed("mass99.y", 3.0)}, "goal.quantity", "mass99.y: mass 99 does not exist (0..11)."),
        ({"collect": asks.ReadingDraft("hope", "value")}, "collect.quantity", "'hope' is not a quantity"),
        ({"controls": ("gravty",)}, "controls[0]", "Gravty: there is no such setting"),
    ],
)
def test_what_is_wrong_is_said_beside_its_field_and_changes_nothing(
    changes: dict[str, Any], field: str, refused: str
) -> None:
    form = Form()
    form.say(asks.AddStep(0))
    before = form.steps
    form.say(change(0, **changes))
    assert (form.taken.step, form.taken.field) == (0, field)
    assert form.taken.refused.startswith(refused)
    assert "\n" not in form.taken.refused
    assert form.steps == before
    assert not form.page.session.notices
    # What is right afterwards takes the sentence away.
    form.say(change(0, title="T"))
    assert (form.taken.part, form.taken.refused) == ("title", "")


@pytest.mark.parametrize("tag", languages())
def test_a_refusal_is_beside_its_field_in_every_language(tag: str) -> None:
    with speaking(tag):
        form = Form()
        form.say(asks.AddStep(0), change(0, question=asked("?", ("a", ""))))
        assert form.taken.field == "question.choices[1]"
        assert "lesson" not in form.taken.refused
        empty = Text("{where}: it must not be empty", where="")
        assert form.taken.refused == sentence(of(empty).lstrip(" \u202f:"))


def test_undo_takes_back_what_was_done_to_the_lesson() -> None:
    form = Form()
    opened = form.scene
    versions = form.page.session.versions
    form.say(asks.AddStep(0), change(0, title="T"), change(0, title="Ti"), asks.AddStep(1))
    assert versions.undoable == "step 2 added"
    form.undo()
    # What is written in one go is one step.
    assert versions.undoable == "title of step 1"
    form.undo()
    assert [step.title for step in form.steps] == ["Step 1"]
    form.undo()
    assert form.scene is opened
    form.undo(*(commands.Redo(),) * 3)
    assert [step.title for step in form.steps] == ["Ti", "Step 2"]
    form.say(asks.MoveStep(1, 0), asks.CopyStep(0), asks.RemoveStep(2))
    assert [step.title for step in form.steps] == ["Step 2", "Step 2"]
    form.say(asks.DropLesson())
    assert form.scene.lesson is None
    form.undo()
    assert len(form.steps) == 2
    for name in ("question", "predict", "goal", "collect", "plots", "arrows"):
        form.say(change(0, **{name: None}))
        assert not form.taken.refused


def test_the_body_moves_on_while_its_lesson_is_written() -> None:
    form = Form()
    form.page.frames(20)
    time, rows = form.page.simulation.time, form.page.simulation.positions.copy()
    form.say(asks.AddStep(0), change(0, title="T"))
    assert form.page.simulation.time > time > 0.0
    assert (form.page.simulation.positions != rows).any()
    assert form.page.session.openings == 0


def test_a_step_is_tried_and_all_comes_back() -> None:
    form = made()
    session = form.page.session
    assert form.seen.makes_lesson
    assert not form.seen.has_lesson
    form.page.frames(10)
    before, time, undoable = form.scene, session.simulation.time, session.versions.undoable
    steps = len(session.versions)
    form.say(asks.TryStep(1))
    assert form.seen.has_lesson, "it is shown as a pupil sees it"
    assert not session.lesson_begun, "the page is to begin it"
    assert form.letters.last(LessonForm).trying == 1
    assert session.simulation.time < time
    form.page.frames(5, commands.SetValue("gravity", 0.0))
    form.say(asks.EndTrying())
    assert not form.seen.has_lesson
    assert form.letters.last(LessonForm).trying == -1
    assert form.scene == before
    assert session.simulation.time == pytest.approx(time, abs=0.1)
    assert (session.versions.undoable, len(session.versions)) == (undoable, steps)
    form.undo()
    assert form.scene.lesson != before.lesson
    # With the form closed the lesson is there.
    form.say(asks.MakeLesson(False))
    assert form.seen.has_lesson
    assert not form.letters.last(LessonForm).open


def test_a_step_that_cannot_begin_is_not_tried() -> None:
    form = Form()
    form.say(asks.AddStep(0))
    scene = form.scene
    assert scene.lesson is not None
    step = msgspec.structs.replace(scene.lesson.steps[0], settings=("gravty=1",))
    form.page.frames(1, commands.Open(msgspec.structs.replace(scene, lesson=Lesson(steps=(step,)))))
    form.say(asks.TryStep(0))
    assert form.taken.field == "settings[0]"
    assert "there is no such setting" in form.taken.refused
    assert form.letters.last(LessonForm).trying == -1


def test_the_form_offers_the_formulas_that_are_plotted(monkeypatch: pytest.MonkeyPatch) -> None:
    formula = "atan2(mass1.y, mass1.x)"
    plots = (f"mass0.x, {formula} over mass0.y", f"{formula}, mass99.x - mass0.x")
    monkeypatch.setitem(globals(), "MEASURED", MEASURED._replace(plots=plots))
    form = Form()
    assert tuple(form.letters.last(LessonOffers).parts) == ("joint0", "mass3", formula)
    form.say(asks.AddStep(0))
    drafts = (formula, "mass0.x + mass0.vx")
    for draft in drafts:
        goal = asks.GoalDraft(quantity=draft, of="value", low=1.0, high=None, seconds=0.0)
        form.say(asks.ChangeStep(0, changes=asks.StepChanges(goal=goal)))
    assert form.steps[0].goal == Goal(quantity=formula, low=1.0)
    assert form.taken.field == "goal.quantity"
    assert "cannot be added: their units differ" in form.taken.refused


def test_what_a_step_reads_and_plots_is_said_in_the_page_s_language() -> None:
    form = made()
    form.say(change(1, collect=asks.ReadingDraft("spring4.wrapped_direction", "value")))
    with speaking("de"):
        german = LessonMaker(page_of(form.page.session, None, form.letters), lambda: MEASURED)
        german.do(asks.MakeLesson(True))
        german.tell()
    offers, told = form.letters.last(LessonOffers), form.letters.last(LessonForm)
    assert offers.parts == {
        "joint0": "Gelenk 0", "mass3": "Masse 3", "mass5": "Masse 5", "spring4": "Feder 4"
    }  # fmt: skip
    springs, masses = offers.quantities["spring"], offers.quantities["mass"]
    assert springs["elongation"] == "Dehnung (px)"
    assert springs["wrapped_direction"] == "Richtung von -180° bis 180° (°)"
    assert masses["momentum_x"].startswith("Impuls x (")
    assert told.plots[0] == "y von Masse 3, y von Masse 5; x von Masse 3 über y von Masse 3"
    assert form.steps[0].plots == MEASURED.plots, "what is stored are the names"


def test_a_number_stands_before_its_unit_in_arabic() -> None:
    scene = sim.load_scene("lesson-hooke")
    assert scene.lesson is not None
    run = next(step.run for step in scene.lesson.steps if step.run and step.run.settings)
    with speaking("ar"):
        for said in (describe_settings(scene, ("gravity=2000",)), run_text(run, scene)):
            assert "\u20662000 px/s²\u2069" in said


def test_the_form_offers_what_there_is_now() -> None:
    form = Form()
    offers = form.letters.last(LessonOffers)
    assert tuple(offers.parts) == ("joint0", "mass3"), "nobody can aim at a ghost"
    assert offers.quantities["mass"]["vy"] == "vy (px/s)"
    assert offers.quantities["stability"]["dt_over_limit"] == "dt over limit"
    assert (offers.plots, offers.arrows, offers.settings) == (MEASURED.plots, ("forces",), "")
    assert {"gravity", "method", "force_law"} <= {control.key for control in offers.controls}
    assert all(plot_text(parse_plot(text)) == text for text in MEASURED.plots)
    form.page.frames(30, commands.SetValue("gravity", 20.0), commands.SetChoice("method", "rk4"))
    form.maker.tell()
    assert form.letters.last(LessonOffers).settings == "Integrator: Runge-Kutta 4, Gravity 20 px/s²"
    assert describe_settings(form.scene, ("hope=1", "gravity=many")) == "gravity many, hope 1"
    assert describe_settings(form.scene, ("gravity=1", "method=rk4")) == describe_settings(
        form.scene, ("method=rk4", "gravity=1")
    )


@pytest.mark.parametrize(
    "said",
    [
        '{"do":"addStep","at":-1}',
        '{"do":"addStep","at":100}',
        '{"do":"changeStep","step":0,"changes":{"settings":"gravity=1"}}',
        '{"do":"changeStep","step":0,"changes":{"title":1}}',
        '{"do":"changeStep","step":0,"changes":{"title":null}}',
        '{"do":"changeStep","step":0,"changes":{"predict":1e999}}',
        '{"do":"changeStep","step":0,"changes":{"predict":NaN}}',
        '{"do":"changeStep","step":0,"changes":{"collect":{"quantity":"mass0.y","of":"hope"}}}',
        '{"do":"takeInStep","step":0,"what":"everything"}',
        '{"do":"makeLesson"}',
        '{"do":"ofStep","step":0}',
        '{"do":"prepare"}',
    ],
)
def test_no_nonsense_is_heard(said: str) -> None:
    assert read(said) is None


def test_steps_that_are_not_there_change_nothing() -> None:
    form = Form()
    form.say(asks.AddStep(0))
    before = form.steps
    for said in (
        asks.AddStep(9), asks.CopyStep(9), asks.RemoveStep(9), asks.MoveStep(0, 9),
        change(9, title="T"), asks.TakeInStep(9, "settings"),
        change(9, goal=None), asks.TryStep(9), asks.EndTrying(), change(0, ghost="hope"), change(0),
    ):  # fmt: skip
        form.say(said)
    assert form.steps == before
    assert form.seen.makes_lesson


def test_a_form_in_another_language_leaves_what_nobody_changed_as_it_was_written() -> None:
    with speaking("de"):
        form = Form("lesson-hooke")
        before, shown = form.steps, form.letters.last(LessonForm).steps
        assert shown == tuple(map(step_of, before)) != before
        question = shown[0].question
        assert question is not None
        form.say(
            change(0, do=shown[0].do, title="Mein Titel"),
            change(0, question=asked(question.text, question.choices, question.answer, "Darum.")),
        )
    step, asked_before = form.steps[0], before[0].question
    assert asked_before is not None
    assert (step.title, step.do) == ("Mein Titel", before[0].do)
    assert step.question == msgspec.structs.replace(asked_before, because="Darum.")
