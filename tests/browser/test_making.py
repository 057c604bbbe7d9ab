"""A lesson is made in the page, from "Make a lesson" to a page that shows it as a pupil sees it."""

from __future__ import annotations

from playwright.sync_api import Locator, expect

from app.session.plots import PlotSpec
from sim.scene.lesson import Goal, Question, Step
from tests.app.inside import sandboxes
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk

EVIL = "<img src=x onerror='window.evil = 1'>"

TO_THE_END = "field => field.scrollIntoView({ block: 'end' })"
"""Scrolls what is below a field out of sight."""


def form_of(desk: Desk) -> Locator:
    return desk.page.get_by_role("complementary", name="Make a lesson")


def steps(desk: Desk) -> tuple[Step, ...]:
    lesson = desk.session.scene.lesson
    return lesson.steps if lesson is not None else ()


def titles(desk: Desk) -> list[str]:
    return [step.title for step in steps(desk)]


def listed(desk: Desk) -> list[str]:
    """The steps in the form's list."""
    return desk.page.locator(".softrod-making-title").all_inner_texts()


def press(desk: Desk, name: str) -> None:
    form_of(desk).get_by_role("button", name=name, exact=True).click()


def field(desk: Desk, name: str) -> Locator:
    return form_of(desk).get_by_label(name, exact=True)


def sentences(desk: Desk) -> list[str]:
    """What the form says was refused."""
    return [text for text in form_of(desk).locator(".softrod-refused").all_inner_texts() if text]


def write(desk: Desk, name: str, text: str) -> None:
    """Write into a field, and leave it."""
    field(desk, name).fill(text)
    field(desk, name).press("Tab")


def begin(desk: Desk) -> None:
    """Open the form, and begin a lesson."""
    desk.show("Share")
    desk.button("Make a lesson").click()
    form_of(desk).wait_for()
    press(desk, "Add the first step")
    desk.until(lambda: titles(desk) == ["Step 1"], "there is a step")


def test_a_step_is_written_ordered_tried_and_seen_as_pupils_see_it(open_page: OpenPage) -> None:
    """`tests/app/test_making.py` has what the form makes of what is written, what it refuses, and undo."""
    desk = open_page("rope", size=(1280, 720))
    desk.page.keyboard.press("g")  # a plot that a step can have; the page turns to it
    desk.page.locator(".softrod-chart").wait_for()
    begin(desk)
    write_a_step(desk)
    order(desk)
    attempt(desk)
    see_as_phone(desk)
    press(desk, "Done")
    desk.until(lambda: not form_of(desk).is_visible(), "the form goes")
    desk.until(lambda: "1 of 2" in desk.page.locator(".softrod-lesson").inner_text(), "there is its lesson")
    assert desk.page.evaluate("window.evil") is None
    assert not desk.notices()


def test_a_formula_is_plotted_and_then_a_goal(open_page: OpenPage) -> None:
    desk = open_page("rope", size=(1280, 480))
    desk.show("Measure")
    formula, said = "mass1.y - mass0.y", desk.page.locator(".softrod-panel .softrod-refused")
    desk.control("Formula").evaluate(TO_THE_END)
    desk.control("Formula").fill("mass1.y - mass0.vy")
    desk.until(lambda: "cannot be subtracted: their units differ." in said.inner_text(), "it says why not")
    expect(said).to_be_in_viewport(ratio=0.9)
    desk.control("Formula").fill(formula)
    desk.until(lambda: not said.is_visible(), "it is one")
    desk.button("New plot").click()
    desk.until(lambda: PlotSpec((formula,)) in desk.tab.probe().plots, "it is plotted")
    begin(desk)
    field(desk, "A goal to reach").check()
    field(desk, "Goal: part").select_option(formula)
    assert not field(desk, "Goal: quantity").is_visible()
    write(desk, "from", "300")
    desk.until(lambda: steps(desk)[0].goal == Goal(quantity=formula, low=300.0), "it is the goal")
    field(desk, "Goal: part").select_option("mass1")
    goal = Goal(quantity="mass1.y", low=300.0)
    desk.until(lambda: steps(desk)[0].goal == goal, "and a quantity again")
    assert not sentences(desk)


def test_a_german_form_shows_german_numbers_and_names_and_what_it_refuses(open_page: OpenPage) -> None:
    desk = open_page("rope", size=(1280, 560), path="/?lang=de")
    desk.show("Teilen")
    desk.button("Lektion erstellen").click()
    form = desk.page.locator(".softrod-making")
    form.get_by_role("button", name="Ersten Schritt hinzufügen").click()
    form.get_by_label("Ein Ziel, das zu erreichen ist").check()
    part = form.get_by_label("Ziel: Teil")
    part.select_option(label="Körper")
    assert part.input_value() == "body"
    low, high = form.get_by_label("von", exact=True), form.get_by_label("bis", exact=True)
    low.fill("3100.5")
    low.press("Tab")
    desk.until(lambda: low.input_value() == "3100,5", "it is shown with a comma")
    assert steps(desk)[0].goal == Goal(quantity="body.y", low=3100.5)
    # Next to its field, and not below what can be seen.
    high.evaluate(TO_THE_END)
    high.fill("1")
    high.press("Enter")
    refused = form.locator("[data-field=goal].softrod-refused")
    expect(refused).to_contain_text("3100,5")
    expect(refused).to_be_in_viewport(ratio=0.9)


def write_a_step(desk: Desk) -> None:
    write(desk, "Title", f"Weigh it {EVIL}")
    desk.until(lambda: listed(desk) == [f"1. Weigh it {EVIL}"], "the list has its title, as text")
    # What is wrong stays where it is, with a sentence beside it, and is not in the lesson.
    write(desk, "What to do", "")
    desk.until(lambda: sentences(desk) == ["It must not be empty."], "it is refused")
    assert steps(desk)[0].do
    write(desk, "What to do", "Drag the slider.")
    desk.until(lambda: steps(desk)[0].do == "Drag the slider." and not sentences(desk), "it is taken")
    field(desk, "Ask a question first").check()
    desk.page.keyboard.type("Where will it hang?")
    for i, choice in enumerate(("higher", "lower")):
        write(desk, f"Answer {i + 1}", choice)
    field(desk, "Answer 2 is right").check()
    write(desk, "Why that is right", "It is heavier.")
    question = Question(
        text="Where will it hang?", choices=("higher", "lower"), answer=1, because="It is heavier."
    )
    desk.until(lambda: steps(desk)[0].question == question and not sentences(desk), "it asks")
    press(desk, "Plots as they are open now")
    desk.until(lambda: steps(desk)[0].plots == ("joint0.angle",), "it has the plot")
    replace = form_of(desk).get_by_role("button", name="Replace them by the plots that are open now")
    expect(replace).to_be_disabled()  # they are the same
    form_of(desk).locator("summary").click()
    field(desk, "Gravity").check()
    desk.until(lambda: steps(desk)[0].controls == ("gravity",), "pupils get a slider")
    field(desk, "A goal to reach").check()
    write(desk, "from", "deep")
    desk.until(lambda: any("“deep” is not a number" in text for text in sentences(desk)), "it is no number")
    field(desk, "Goal: part").select_option("mass1")
    write(desk, "from", "300")
    goal = Goal(quantity="mass1.y", low=300.0)
    desk.until(lambda: steps(desk)[0].goal == goal and not sentences(desk), "it has its goal")


def order(desk: Desk) -> None:
    """By keys, by a button, and back."""
    press(desk, "Add a step")
    desk.until(lambda: field(desk, "Title").input_value() == "Step 2", "it is the one that is chosen")
    desk.page.locator(".softrod-making-title").nth(1).focus()
    desk.page.keyboard.press("Alt+ArrowUp")
    desk.until(lambda: titles(desk)[0] == "Step 2" and listed(desk)[0] == "1. Step 2", "it goes up")
    focused = "document.activeElement.textContent"
    desk.until(lambda: desk.page.evaluate(focused) == "1. Step 2", "and has the focus")
    press(desk, "Move down")
    desk.until(lambda: titles(desk)[1] == "Step 2" and listed(desk)[1] == "2. Step 2", "it goes down")
    # Up and down without Alt choose, and do not change the body.
    desk.page.locator(".softrod-making-title").nth(1).focus()
    desk.page.keyboard.press("ArrowUp")
    desk.until(lambda: field(desk, "Title").input_value().startswith("Weigh it"), "the first one is chosen")
    assert desk.simulation.rest_length_scale == 1.0


def attempt(desk: Desk) -> None:
    before = desk.session.scene
    press(desk, "Try this step")
    card = desk.page.locator(".softrod-lesson")
    desk.until(lambda: "Where will it hang?" in card.inner_text(), "it asks")
    desk.until(lambda: not desk.session.playing and desk.simulation.time == 0.0, "the body waits")
    assert not form_of(desk).is_visible()
    card.get_by_role("button", name="lower").click()
    desk.until(lambda: desk.slider_value("Gravity") == 1500.0, "there is its slider")
    desk.button("Back to the form").click()
    form_of(desk).wait_for()
    desk.until(lambda: desk.session.scene == before, "all is as before")
    desk.until(lambda: field(desk, "Title").input_value().startswith("Weigh it"), "so is the form")


def see_as_phone(desk: Desk) -> None:
    """The lesson as a link holds it, in a small window of its own."""
    with desk.context.expect_page() as opened:
        press(desk, "See as phone")
    page = opened.value
    page.locator(".softrod-lesson").wait_for()
    assert page.evaluate("[innerWidth, innerHeight]") == [390, 844]
    assert f"Weigh it {EVIL}" in page.locator(".softrod-lesson").inner_text()
    assert page.evaluate("window.evil") is None
    shown = [session.scene for tab in sandboxes(desk.served.ticker).values() if (session := tab.session)]
    assert [scene.lesson for scene in shown] == [desk.session.scene.lesson] * 2
    page.close()


def test_on_a_phone_a_lesson_is_made_below_the_body(open_page: OpenPage) -> None:
    desk = open_page("rope", size=(390, 844), phone=True)
    begin(desk)
    desk.until(lambda: desk.at(desk.simulation.positions)[:, 1].max() < 300.0, "the body is above the form")
    form_of(desk).get_by_role("button", name="Add a step", exact=True).tap()
    desk.until(lambda: len(listed(desk)) == 2, "there are two steps")
    box = form_of(desk)
    sizes = box.get_by_role("button").evaluate_all(
        "all => all.filter(one => one.checkVisibility()).map(one => one.getBoundingClientRect())"
        ".map(({ height, right }) => [height, right])"
    )
    assert len(sizes) > 5
    assert min(height for height, _ in sizes) >= 40.0, "a finger can press it"
    assert max(right for _, right in sizes) <= 390.0
    assert box.locator(".softrod-making-body").evaluate("it => it.scrollWidth <= it.clientWidth")
    # Folded it leaves the panel free.
    press(desk, "Hide")
    desk.button("Download as a file").tap()
    press(desk, "Show")
    desk.until(lambda: field(desk, "Title").is_visible(), "it is back")
    # It outlives a reload, with the lesson.
    desk.until(desk.is_kept, "the browser keeps it")
    desk.open()
    desk.until(lambda: listed(desk) == ["1. Step 1", "2. Step 2"], "it is there again")
