"""Whole tasks by what a screen reader has alone: lessons, a class, a live file, and a body that is built.

By day one lesson is begun; by night all of it is done.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser

import sim
from app.export.live.live import live_html
from app.features.classroom.roles import desk_address, seat_address
from app.session import commands
from sim.analysis.modes import Modes
from sim.scene.lesson import Step
from sim.store.files import built_in_folder
from tests.amount import NIGHT, at_night, part_of
from tests.browser.classrooms import serving_class
from tests.browser.conftest import OpenPage, Visits
from tests.browser.driver import rough_context
from tests.browser.ear import Ear, Node

LESSONS = sorted(path.stem for path in (built_in_folder() / "lessons").glob("*.json"))
LAPTOP = (1280, 720)
NUMBER = r"[−-]?\d[\d,.]*(?:e-?\d+)?"


def steps_of(name: str) -> tuple[Step, ...]:
    lesson = sim.load_scene(name).lesson
    assert lesson is not None
    return lesson.steps


def card(root: Node) -> Node | None:
    """The card of a lesson."""
    return root.find("region", "Lesson")


def number(text: str) -> float:
    """A number as it is said."""
    return float(text.replace(",", "").replace("−", "-"))


def focus_says(ear: Ear, words: str) -> None:
    """Wait until some words have the focus, from where a screen reader reads on."""
    ear.until(lambda root: words in ear.focused_in(root).text, f"the focus is at {words!r}")


# ------------------------------------------------------------------------- lessons
def asks(ear: Ear, step: Step) -> None:
    """Read a step's question, and answer it."""
    question = step.question
    assert question is not None
    group = ear.find("group", question.text)
    assert [button.name for button in group.all("button")] == list(question.choices)
    assert not any(step.do in node.text for node in ear.look().all("paragraph")), "what to do comes later"
    ear.press("button", question.choices[0], within=card)


def told(ear: Ear, step: Step) -> None:
    """Ask what is right: it has the focus, and says why."""
    question = step.question
    assert question is not None
    ear.press("button", "Check my answer")
    right = (
        "That is right." if question.answer == 0 else f"The answer is: {question.choices[question.answer]}."
    )
    ear.until(
        lambda root: f"{right} {question.because}" in ear.focused_in(root).text, f"{right} has the focus"
    )


def reads_plots(ear: Ear, count: int) -> None:
    """Read so many plots: their values now and their ranges, or that they stay as they are."""
    words = re.compile(r": now .*(?:lowest|from) | all the time", re.S)

    def plots(root: Node) -> list[str]:
        found = [image.name for image in root.all("image") if words.search(image.name)]
        return found if len(found) >= count else []

    for said in ear.until(plots, f"{count} plots are read") if count else ():
        found = re.search(rf"now ({NUMBER}).*?(?:lowest|from) ({NUMBER}).*?(?:highest|to) ({NUMBER})", said)
        if found is None:
            assert "all the time" in said
            continue
        now, low, high = map(number, found.groups())
        assert low <= now <= high, said


def reads_numbers(ear: Ear) -> None:
    """Open the table of the first plot, again until there is something in it."""

    def rows(root: Node) -> list[list[str]]:
        table = root.find("table")
        found = [[cell.text for cell in row.all("cell")] for row in table.all("row")][1:] if table else []
        if len(found) < 2:
            ear.press("DisclosureTriangle", "Numbers")
        return found if len(found) >= 2 else []

    found = ear.until(rows, "the numbers of the plot")
    assert len(found) <= 21
    times = [number(row[0]) for row in found]
    assert times == sorted(times)
    assert all(re.fullmatch(NUMBER, cell) for row in found for cell in row if cell)


def goes_through(ear: Ear, steps: tuple[Step, ...], live: bool = False) -> None:
    """Do a lesson; by day begin it."""
    for i, step in enumerate(steps):
        ear.until(
            lambda root, step=step: root.find("heading", step.title), f"the step {step.title!r} is there"
        )
        if step.question is not None:
            asks(ear, step)
            if live and step.predict:
                predicts(ear)
            ear.hears("Running")
            ear.until(
                lambda root, step=step: step.do in ear.focused_in(root).text, "what to do has the focus"
            )
        else:
            ear.until(lambda root, step=step: step.do in root.text, "it says what to do")
        if step.watch:
            assert step.watch in ear.look().text
        reads_plots(ear, len(step.plots or ()))
        for figure in ear.look().all("figure"):
            named, texts = figure.all("image")[0].name, figure.all("StaticText")
            assert not any(named.startswith(text.name) for text in texts), "its legend is not read beside it"
        if i == 0 and step.plots and " over " not in step.plots[0]:
            reads_numbers(ear)
        if step.question is not None:
            told(ear, step)
        if not NIGHT:
            return
        last = i + 1 == len(steps)
        ear.press("button", "Back to step 1" if last else "Next step")
        following = steps[0 if last else i + 1].title
        ear.until(
            lambda root, title=following: ear.focused_in(root).name == title, "the next step has the focus"
        )


def predicts(ear: Ear) -> None:
    """Move a mass of a live file by keys to where it will be."""
    ear.tab_to("application", back=True)
    ear.hears("Arrows choose, Space takes hold")
    ear.key("ArrowRight", "Space")
    ear.hears("in hand. Arrows move it")
    ear.key("ArrowDown")
    ear.hears("x ")
    ear.key("Space")
    ear.hears("let go")
    ear.press("button", "It will be there")


@pytest.mark.parametrize("name", part_of(LESSONS, len(LESSONS)))
def test_a_lesson_is_done_by_ear(open_page: OpenPage, name: str) -> None:
    ear = Ear(open_page(name).page)
    page = ear.look()
    title = next(node.name for node in page.all("heading") if node.states["level"] == 1)
    assert page.name == f"{title} · softrod"
    goes_through(ear, steps_of(name))


@at_night
def test_a_dialog_of_a_menu_gives_the_focus_back_by_ear(open_page: OpenPage) -> None:
    ear = Ear(open_page("rope").page)
    ear.tab_to("button", "View")
    ear.key("Enter")
    ear.until(lambda root: ear.focused_in(root).role.startswith("menuitem"), "the menu is open")
    for _ in range(30):
        if ear.focused.name.startswith("Access and language"):
            break
        ear.key("ArrowDown")
    ear.key("Enter")
    ear.find("dialog", "Access and language")
    ear.key("Escape")
    focus_says(ear, "View")


def finds(ear: Ear, text: str) -> None:
    """Find something by its name, and take what comes first."""
    ear.key("Control+k")
    ear.find("combobox", "Find anything")
    ear.type(text)
    ear.until(lambda root: root.find("option", re.compile(f"^{text}")), f"{text!r} is found")
    ear.key("Enter")


@at_night
def test_what_find_anything_opens_has_the_focus_and_gives_it_back_by_ear(open_page: OpenPage) -> None:
    ear = Ear(open_page("rope").page)
    ear.tab_to("button", "View")
    ear.key("Enter")
    ear.until(lambda root: ear.focused_in(root).role.startswith("menuitem"), "the menu is open")
    finds(ear, "Access and language")
    dialog = ear.find("dialog", "Access and language")
    assert any(node.states.get("focused") for node in dialog)
    for name in ("Language", "Sound"):  # of itself alone, not beside it, too
        assert name not in [node.name for node in dialog.all("StaticText")]
    assert dialog.find("checkbox", "Sound").about.startswith("Of plots")  # type: ignore[union-attr]
    ear.key("Escape")
    focus_says(ear, "View")
    ear.tab_to("application", back=True)
    finds(ear, "Air friction")
    ear.until(lambda root: ear.focused_in(root).name == "Air friction", "the slider has the focus")
    assert ear.focused.role == "slider"


@at_night
def test_what_is_begun_and_given_up_and_a_plot_and_a_scene_are_said_by_ear(open_page: OpenPage) -> None:
    desk = open_page("rope")
    ear = Ear(desk.page)
    desk.tell(commands.Play(False))
    ear.tab_to("application", back=True)
    ear.key("ArrowRight", "Space")
    ear.hears("mass 1 in hand")
    ear.key("Escape")
    ear.hears("mass 1 let go")
    ear.key("e", "Enter")
    ear.hears("A spring begins at mass 1")
    ear.key("Escape")
    ear.hears("The spring is given up")
    ear.key("x")
    ear.hears("Cross at ")
    ear.key("Escape")
    ear.hears("The cross is gone")
    ear.key("p")
    ear.hears("1 mass pinned")
    ear.key("p")
    ear.hears("1 mass let go")
    ear.key("e", "g")
    ear.hears("New plot: joint")
    finds(ear, "Pendulum")
    ear.hears("Pendulum is open")
    ear.key("g")
    # The name of what closes it is no part of it.
    assert ear.hears("Nothing to plot") == "Nothing to plot. This scene has no joints."


@at_night
@pytest.mark.parametrize("name", ["lesson-hooke", "lesson-worm"])
def test_a_lesson_in_a_live_file_is_done_by_ear(visit: Visits, tmp_path: Path, name: str) -> None:
    file = tmp_path / "live.html"
    file.write_bytes(live_html(sim.Simulation(sim.load_scene(name)).capture())[0])
    ear = Ear(visit(file.as_uri(), bypass_csp=True))
    goes_through(ear, steps_of(name), live=True)
    for slider in ear.look().all("slider"):
        assert re.fullmatch(rf"{NUMBER}\D*", ear.value(slider)), "it says its number, not its place"


# ------------------------------------------------------------------------- a class
@pytest.fixture
def room(browser: Browser, tmp_path: Path) -> Iterator[tuple[Ear, Ear]]:
    """A class of the first lesson: its teacher's page, and a pupil's."""
    with ExitStack() as stack:
        port, classroom = stack.enter_context(serving_class(sim.load_scene("lesson-hooke"), tmp_path))
        base = f"http://127.0.0.1:{port}/"
        ears: list[Ear] = []
        for address in (desk_address(base, classroom), seat_address(base, classroom.room.code)):
            context = stack.enter_context(
                rough_context(browser, viewport={"width": LAPTOP[0], "height": LAPTOP[1]})
            )
            page = context.new_page()
            page.goto(address)
            ears.append(Ear(page))
        yield ears[0], ears[1]


@at_night
def test_a_step_of_a_class_is_done_by_ear(room: tuple[Ear, Ear]) -> None:
    teacher, pupil = room
    step = steps_of("lesson-hooke")[0]
    question = step.question
    assert question is not None
    pupil.until(lambda root: "You are in." in root.text, "the pupil is in")

    def go_on(phase: str) -> None:
        """Press the teacher's button that leads on; what it leads to is said."""
        teacher.press("button", re.compile(f"^Next: {phase}"))

    go_on("Look at me")
    pupil.hears("Look to the front.")
    go_on("Ask")
    pupil.hears("choose an answer")
    focus_says(pupil, question.text.split(".")[-1].strip())
    pupil.key("d")
    pupil.hears(" wide and ")
    pupil.tab_to("button", re.compile("^Mass 1 of your prediction"))
    pupil.key(*["ArrowDown"] * 5)
    assert "lower" in pupil.hears("Mass 1: ")
    pupil.press("button", re.compile("^(Hand in|It will be there)"))
    pupil.press("button", question.choices[1])
    pupil.hears("You can still change it.")
    teacher.until(lambda root: "1 of 1" in root.text, "it is counted")
    go_on("Show answers")
    pupil.hears("You chose: " + question.choices[1])
    go_on("Run it")
    pupil.key("d")
    pupil.hears("Look to the front.")
    go_on("Reveal")
    assert question.because.split(".")[0] in pupil.hears("The right answer: ")
    go_on("Explain")
    pupil.hears("Why?")
    pupil.focus(pupil.find("textbox", "Because"))
    pupil.type("Twice the weight.")
    pupil.press("button", "Send")
    teacher.until(lambda root: "Twice the weight." in root.text, "the line is there")
    go_on("Let them try")
    pupil.hears("Try it: this body is yours.")
    pupil.focus(pupil.find("slider", "Gravity"))
    pupil.key("ArrowRight", "ArrowRight")
    assert pupil.value(pupil.find("slider", "Gravity")).endswith("px/s²")
    pupil.focus(pupil.find("application"))
    pupil.key("ArrowRight", "d")
    pupil.hears("Mass 1, ")
    reads_plots(pupil, 1)
    go_on("Collect")
    pupil.press("button", re.compile("^Hand in "))
    pupil.hears("Handed in: ")
    teacher.until(lambda root: root.find("image", re.compile("1 point")), "its point is in the plot")


# ------------------------------------------------------------------------- building and measuring
def chooses(ear: Ear, mass: int, last: int) -> str:
    """Choose a mass by the arrows; returns what is said of it."""
    for _ in range(last + 2):
        ear.key("ArrowRight")
        told = ear.hears("mass ")
        if told.startswith(f"mass {mass}, "):
            return told
    raise AssertionError(f"mass {mass} is not reached")


def builds_triangle(ear: Ear) -> None:
    """From one held mass to a triangle that hangs by two corners, by keys, while the clock stands."""
    ear.press("button", "Pause")
    ear.hears("Paused")
    ear.key("x")
    assert "x 300, y 160 px: mass 0" in ear.hears("Cross at ")
    for keys, place in (
        (["ArrowLeft"] * 5 + ["ArrowDown"] * 2, "x 200, y 200 px"),
        (["ArrowRight"] * 10, "x 400, y 200 px"),
        (["ArrowLeft"] * 5 + ["ArrowDown"] * 5, "x 300, y 300 px"),
    ):
        ear.key(*keys)
        ear.hears(place)
        ear.key("Enter")
        ear.hears("mass added")
    ear.key("Escape")
    ear.find("application", "Body of 4 masses")
    # Without the one that was there, they have the numbers from 0 to 2.
    chooses(ear, 0, 3)
    ear.key("Delete")
    ear.hears("1 mass removed")
    springs = "A spring begins at mass 0", *["1 spring added"] * 3
    for mass, said in zip((0, 1, 2, 0), springs, strict=True):
        chooses(ear, mass, 2)
        ear.key("Enter")
        ear.hears(said)
    ear.key("Escape")
    for mass in (0, 1):
        chooses(ear, mass, 2)
        ear.key("p")
        ear.hears("1 mass pinned")
    ear.key("Escape")
    ear.hears("Nothing selected")


@at_night
def test_a_triangle_is_built_by_ear(open_page: OpenPage) -> None:
    desk = open_page("empty")
    builds_triangle(Ear(desk.page))
    scene = desk.session.scene
    assert [mass.position for mass in scene.masses] == [(200.0, 200.0), (400.0, 200.0), (300.0, 300.0)]
    assert [{spring.a, spring.b} for spring in scene.linear_springs] == [{0, 1}, {1, 2}, {0, 2}]
    assert {anchor.mass for anchor in scene.anchors} == {0, 1}


@at_night
def test_a_triangle_is_measured_by_ear(open_page: OpenPage) -> None:
    desk = open_page("empty")
    ear = Ear(desk.page)
    builds_triangle(ear)

    # Places and lengths.
    ear.key("s")
    ear.hears("Select")
    assert "x 300, y 300 px" in chooses(ear, 2, 2)
    ear.key("Enter")
    ear.hears("mass 2 selected")
    assert ear.find("spinbutton", "Start x").value == "300"
    ear.key("d")
    assert "x = 300 px, y = 300 px" in ear.hears("Mass 2, ")
    ear.key("Shift+ArrowRight")
    ear.hears("spring 1 selected")
    ear.key("d")
    assert "It is 141 px long" in ear.hears("Spring 1 joins masses 1 and 2.")

    # The angle at the lowest mass, by a joint that is taken away again.
    ear.key("k", "Enter")
    ear.hears("1 joint added")
    ear.key("s")
    for _ in range(3):
        ear.key("Shift+ArrowRight")
        if "joint" in ear.hears(" selected"):
            break
    ear.key("d")
    assert re.search(r"Its angle is [−-]?90°", ear.hears("Joint 0 "))
    ear.key("Control+z")
    ear.hears("Undone: 1 joint added")

    # Softer springs without damping, and then it swings.
    ear.key("Control+a")
    ear.hears("3 masses, 3 springs selected")
    for name, typed in (("Stiffness", "200"), ("Damping", "0")):
        ear.focus(ear.find("spinbutton", name))
        ear.key("Control+a")
        ear.type(typed)
        ear.key("Enter")
        ear.until(lambda root, name=name, typed=typed: root.find("spinbutton", name).value == typed, name)  # type: ignore[union-attr]
    ear.press("button", "Done")
    ear.hears("Tools closed")
    ear.press("tab", "Measure")
    ear.focus(ear.find("textbox", "Formula"))
    ear.type("mass2.y")
    ear.press("button", "New plot")
    ear.press("button", "Play")
    ear.hears("Running")
    reads_plots(ear, 1)
    read = re.compile(rf"mass2\.y: period ({NUMBER}) s")
    period = ear.until(lambda root: read.search(root.text), "its period is read", limit=30.0)
    # Of its two vibrations, up and down and to and fro, it does the first.
    periods = 2.0 * np.pi / Modes(desk.session.scene, 2).omega
    assert np.abs(periods / number(period[1]) - 1.0).min() < 0.02
