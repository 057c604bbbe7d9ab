"""One lesson of a class, from its command's server to the zip: a teacher, a wall and four pupils."""

from __future__ import annotations

import csv
import io
import re
import zipfile
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

import sim
from app.classroom import kept
from app.classroom.live import Class, Classes
from app.classroom.room import Ghost, Line, Phase, Vote, Work
from app.export.live.live import live_html
from app.page.classroom.roles import desk_address, seat_address, wall_address
from app.server.serve import serving
from sim.scene.lesson import Goal, Lesson, Question, Reading, Step
from tests.amount import NIGHT
from tests.browser.driver import ARTIFACTS, LIMIT, rough_context, until
from tests.browser.wires import Wire

expect.set_options(timeout=LIMIT * 1e3)

CONTRAST = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
PHONE, LAPTOP, WALL = (390, 844), (1280, 720), (1920, 1080)


def a_lesson() -> sim.Scene:
    """A mass on a spring, and one step that asks, predicts, has a goal and collects."""
    question = Question(
        text="Where does it stop first?", choices=("at 220", "at 240"), answer=1, because="Energy."
    )
    step = Step(
        title="It falls",
        do="Double the stiffness.",
        question=question,
        predict=0.5,
        controls=("linear_stiffness",),
        goal=Goal(quantity="mass1.y", low=200.0, seconds=0.1),
        collect=Reading(quantity="mass1.y"),
    )
    return sim.Scene(
        name="swing",
        masses=(sim.Mass(position=(300.0, 100.0)), sim.Mass(position=(300.0, 200.0))),
        linear_springs=(sim.LinearSpring(a=0, b=1, stiffness=20.0, damping=0.0, rest_length=100.0),),
        anchors=(sim.Anchor(mass=0),),
        gravity=(0.0, 400.0),
        air_friction=0.0,
        lesson=Lesson(steps=(step,)),
    )


@dataclass
class School:
    """A server with a class, and its pages."""

    browser: Browser
    port: int
    klass: Class
    pages: list[Page] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)

    @property
    def base(self) -> str:
        return f"http://127.0.0.1:{self.port}/"

    def open(self, address: str, size: tuple[int, int], touch: bool = False) -> Page:
        context = rough_context(
            self.browser,
            viewport={"width": size[0], "height": size[1]},
            has_touch=touch,
            reduced_motion="reduce",
        )
        page = context.new_page()
        page.set_default_timeout(LIMIT * 1e3)
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.goto(address)
        self.pages.append(page)
        return page

    def go(self, desk: Page, phase: Phase, round: int = 0) -> None:
        """Go on, and wait until the class is there."""
        desk.locator("[data-focus=next]").click()
        until(desk, lambda: (self.klass.room.phase, self.klass.room.round) == (phase, round), f"to {phase}")

    def shoot(self, name: str) -> None:
        """Look whether the class's texts stand out, and by night keep pictures of all pages."""
        if NIGHT:
            ARTIFACTS.mkdir(exist_ok=True)
            for i, page in enumerate(self.pages):
                page.screenshot(path=ARTIFACTS / f"class-{name}-{i}.png")
        for page in self.pages[:3]:  # the teacher's, the wall, a pupil's: the others are like that
            shown = set(page.locator(".softrod-class").all_inner_texts())
            judged = [one for one in page.evaluate(CONTRAST) if any(one["text"] in text for text in shown)]
            assert judged, name
            assert not [one for one in judged if one["ratio"] < one["needed"]], name


@pytest.fixture
def school(browser: Browser, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[School]:
    monkeypatch.setattr(kept, "classes_folder", lambda: tmp_path)
    classes = Classes()
    klass = classes.begin((a_lesson(),))
    with ExitStack() as stack:
        server, _, compiler = stack.enter_context(
            serving(sim.load_scene("rope"), "127.0.0.1", 0, classes=classes)
        )
        compiler.start()
        compiler.wait()
        made = School(browser, server.get_port(), klass)
        yield made
        for page in made.pages:
            page.context.close()
        assert not made.errors


def test_a_lesson_from_the_door_to_the_zip(school: School) -> None:
    room = school.klass.room
    desk = school.open(desk_address(school.base, school.klass), LAPTOP)
    wall = school.open(wall_address(school.base, room.code), WALL)
    expect(desk.locator(".softrod-desk-code")).to_have_text(room.code)
    expect(wall.locator(".softrod-wall-code")).to_have_text(room.code)

    # Two come in by touch, of whom one types the letters; one by keys; one will lose its connection.
    wire = Wire(school.port)
    first = school.open(seat_address(school.base, room.code), PHONE, touch=True)
    second = school.open(f"{school.base}?room=QQQQ", PHONE, touch=True)
    expect(second.locator(".softrod-warning")).to_contain_text("no class QQQQ")
    second.get_by_label("The four letters").fill(room.code.lower())
    second.get_by_role("button", name="Come in").tap()
    keys = school.open(seat_address(school.base, room.code), LAPTOP)
    lost = school.open(seat_address(f"http://127.0.0.1:{wire.port}/", room.code), PHONE)
    pupils = (first, second, keys, lost)
    for page in pupils:
        expect(page.locator(".softrod-task")).to_have_text("You are in. It begins soon.")
    expect(wall.locator(".softrod-wall-head h1")).to_have_text("4 are here")
    names = [page.locator(".softrod-seat-name").inner_text() for page in pupils]
    assert len(set(names)) == 4
    first.get_by_role("button", name="Hand up").tap()
    expect(desk.locator(".softrod-desk-hands")).to_have_text(names[0])
    expect(desk.locator(".softrod-desk-hands path")).to_be_visible()
    school.shoot("lobby")

    school.go(desk, Phase.SHOW)
    for page in pupils:
        expect(page.locator(".softrod-task")).to_have_text("Look to the front.")

    # Each one predicts, unseen.
    school.go(desk, Phase.ASK)
    for page in (first, second):
        grip = page.locator(".softrod-own-ghost circle")
        expect(grip).to_have_count(1)
        box = grip.bounding_box()
        assert box is not None
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.mouse.down()
        page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2 + 30.0, steps=4)
        page.mouse.up()
        page.get_by_role("button", name="It will be there").tap()
        page.get_by_role("button", name="at 240").tap()
    # The focus is at the question, and what is to be done has been said.
    expect(keys.locator("[data-focus=question]")).to_be_focused()
    expect(keys.locator(".softrod-unseen")).to_contain_text("Drag the pale body")
    keys.locator(".softrod-own-ghost circle").focus()
    for _ in range(3):
        keys.keyboard.press("ArrowDown")
    keys.locator("[data-focus=predict]").focus()
    keys.keyboard.press("Enter")
    keys.locator("[data-focus=choice0]").focus()
    keys.keyboard.press("Enter")
    until(
        desk, lambda: len(room.given(0, 0, Ghost)) == len(room.given(0, 0, Vote)) == 3, "three have answered"
    )

    # The fourth answers while it has no connection, is reloaded, and is counted all the same.
    wire.mute = True
    expect(lost.locator("html")).to_have_attribute("data-softrod-away", "")
    lost.locator("[data-focus=choice0]").click()
    expect(lost.locator(".softrod-waiting")).to_be_visible()
    wire.mute = False
    lost.reload()
    until(lost, lambda: sum(room.bars(0, 0)) == 4, "the lost one's answer has come")
    expect(lost.locator(".softrod-seat-name")).to_have_text(names[3])
    expect(lost.locator("[data-focus=choice0]")).to_have_attribute("aria-pressed", "true")
    expect(lost.locator(".softrod-waiting")).to_have_count(0)
    expect(wall.locator(".softrod-wall-head h1")).to_have_text("4 of 4 have answered")
    assert wall.locator(".softrod-bars b").count() == 0
    assert wall.locator(".softrod-ghosts path").count() == 0
    school.shoot("ask")

    expect(desk.locator(".softrod-desk-advice")).to_have_text(
        "50 % right: let them talk in pairs, then ask again."
    )
    school.go(desk, Phase.RESULTS)
    expect(desk.locator("[data-focus=advice]")).to_have_text("Ask again")
    expect(wall.locator(".softrod-bars b")).to_have_text(["2", "2"])
    expect(wall.locator(".softrod-ghosts path")).to_have_count(3)
    assert wall.locator("[data-right]").count() == 0
    text = wall.locator("body").inner_text()
    assert not any(name in text for name in names)
    school.shoot("results")

    # One run, the same everywhere, which stands at the moment that was predicted.
    school.go(desk, Phase.RUN)

    def stands() -> bool:
        front = school.klass.front
        return front is not None and not front.playing and front.picture.time >= 0.5

    until(desk, stands, "it stands at the moment that was predicted")

    def shown() -> list[float]:
        """Where all pages show the masses, once that is the same everywhere: bit for bit as on the server."""
        front = school.klass.front
        assert front is not None
        there = front.picture.positions.astype(np.float32).ravel().tolist()
        places = "[...window.__softrod.shown().frame.positions]"
        for page in (wall, *pupils):
            until(page, lambda page=page: page.evaluate(places) == there, "it shows the moment")
        return there

    stood = shown()
    school.shoot("run")

    # Again, slowly, with the predictions; it stands at the same moment, the same.
    desk.get_by_role("button", name="Again, slowly").click()

    def goes_slowly() -> bool:
        front = school.klass.front
        return front is not None and front.playing and front.speed == 0.25 and 0.0 < front.picture.time < 0.5

    until(desk, goes_slowly, "it goes slowly")
    expect(wall.locator(".softrod-ghosts path")).to_have_count(3)
    until(desk, stands, "it stands at the same moment")
    assert shown() == stood

    school.go(desk, Phase.EXPLAIN)
    keys.get_by_label("Because").fill('<img src=x onerror="alert(1)"> energy')
    keys.keyboard.press("Enter")
    until(keys, lambda: len(room.given(0, 0, Line)) == 1, "the line is there")
    desk.get_by_role("button", name="Show this line on the wall").click()
    school.go(desk, Phase.ASK, 1)
    first.get_by_role("button", name="at 240").tap()
    until(first, lambda: room.bars(0, 1) == [0, 1], "the second vote counts")
    school.go(desk, Phase.RESULTS, 1)
    expect(wall.locator("blockquote")).to_have_text('<img src=x onerror="alert(1)"> energy')
    expect(wall.locator("[data-right]")).to_contain_text("at 240")

    # Each one has a body of their own, and hands in a run of it.
    school.go(desk, Phase.TRY)
    expect(first.locator(".softrod-goal")).to_contain_text("Reached")
    expect(desk.locator(".softrod-tiles svg.softrod-poster path")).to_have_count(4)
    # On a phone the sliders of the step stand below the card.
    expect(first.locator("#softrod-class-place .softrod-goal")).to_be_visible()
    expect(first.get_by_text("Linear stiffness", exact=True)).to_be_visible()
    expect(wall.locator(".softrod-counts li")).to_have_count(4)
    school.shoot("try")

    # One looks at the teacher's body, and at its own again; then all have to.
    keys.get_by_role("button", name="Look at the teacher's").click()
    expect(keys.locator(".softrod-task")).to_have_text("This is your teacher's body. Yours waits.")
    expect(desk.locator(".softrod-tiles")).to_contain_text("looks at yours")
    keys.get_by_role("button", name="Back to my own body").click()
    expect(keys.locator(".softrod-task")).to_have_text("Try it: this body is yours.")
    gather = desk.get_by_role("button", name="All look at mine")
    gather.click()
    expect(first.locator(".softrod-task")).to_contain_text("Look to the front")
    gather.click()
    expect(first.locator(".softrod-task")).to_have_text("Try it: this body is yours.")

    # One body goes on the wall, and another device takes its seat over.
    desk.get_by_role("button", name=names[2]).click()
    desk.get_by_role("button", name="Put on the wall").click()
    expect(keys.locator(".softrod-on-wall")).to_have_text("Yours is on the wall now.")
    desk.locator(".softrod-desk-seat").get_by_role("button", name="Move to another device").click()
    seat = next(seat for seat in room.seats.values() if seat.name == names[2])
    until(desk, lambda: bool(seat.move), "it has two digits")
    digits = seat.move
    keys.context.clear_cookies()
    keys.evaluate("localStorage.clear()")
    keys.reload()
    keys.get_by_text("This seat").click()
    keys.get_by_label("I had a seat").fill(digits)
    keys.keyboard.press("Enter")
    expect(keys.locator(".softrod-seat-name")).to_have_text(names[2])
    assert len(room.seats) == 4
    desk.locator("[data-focus=back]").click()
    school.go(desk, Phase.COLLECT)
    first.locator("[data-focus=handin]").tap()
    expect(first.locator(".softrod-verdict").last).to_contain_text("Handed in")
    until(first, lambda: room.given(0, 0, Work)[0].content.reached is True, "the goal is judged")  # type: ignore[union-attr]
    # A picture of what was handed in, for the wall; its pupil reads that it is there.
    desk.get_by_text("Handed in: 1").click()
    desk.get_by_role("button", name=f"Show the body of {names[0]} on the wall").click()
    expect(first.locator(".softrod-on-wall")).to_be_visible()
    expect(desk.locator(".softrod-lines svg.softrod-poster path")).to_have_attribute(
        "d", re.compile(r"M\d+ \d+L\d+ \d+")
    )
    school.shoot("collect")

    with desk.expect_download() as download:
        desk.get_by_text("Door, names, saving, end").click()
        desk.get_by_role("button", name="Save all as a zip").click()
    with zipfile.ZipFile(download.value.path()) as file:
        answers = list(csv.DictReader(io.StringIO(file.read("answers.csv").decode("utf-8-sig"))))
        logs, pictures = (
            [name for name in file.namelist() if name.startswith(folder)] for folder in ("logs/", "pictures/")
        )
    assert [row["kind"] for row in answers].count("vote") == 5
    assert {row["name"] for row in answers} == set(names)
    assert len(logs) == len(pictures) == 1

    desk.once("dialog", lambda dialog: dialog.accept())
    desk.get_by_role("button", name="End", exact=True).click()
    for page in pupils:
        expect(page.locator(".softrod-seat h1")).to_have_text("The class is over.")
    assert not list(kept.classes_folder().iterdir())
    wire.close()


def test_a_page_without_the_secret_is_no_teachers(school: School) -> None:
    address = desk_address(school.base, school.klass)
    page = school.open(address[:-1] + ("A" if address[-1] != "A" else "B"), LAPTOP)
    seat = school.open(seat_address(school.base, school.klass.room.code), PHONE)
    expect(seat.locator(".softrod-task")).to_have_text("You are in. It begins soon.")
    page.wait_for_timeout(500)
    assert page.locator(".softrod-desk").count() == 0
    assert school.klass.teachers == 0


def test_answers_from_the_lessons_file_by_code_and_as_a_file(
    school: School, browser: Browser, tmp_path: Path
) -> None:
    """A pupil without the class's network has the lesson as one file; the teacher brings what it gave."""
    path = tmp_path / "swing.html"
    path.write_bytes(live_html(sim.Simulation(a_lesson()).capture())[0])
    context = browser.new_context(viewport={"width": PHONE[0], "height": PHONE[1]}, offline=True)
    page = context.new_page()
    page.on("pageerror", lambda error: school.errors.append(str(error)))
    page.goto(path.as_uri())

    # It waits for the prediction, which is dragged while time stands, and for the answer.
    time = "__softrod.now().body.time"
    there = """() => {
      const { body } = __softrod.now(), { plan } = __softrod, on = __softrod.place();
      const { left, top } = document.querySelector("canvas").getBoundingClientRect();
      const { x, y, scale, flip } = plan();
      const [right, up] = [(body.positions[2] - x) * scale, (body.positions[3] - y) * scale * flip];
      return [left + on.x + on.step * right, top + on.y - on.step * up];
    }"""
    until(page, lambda: page.evaluate("Boolean(window.__softrod)"), "the file is there")
    x, y = page.evaluate(there)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y + 30.0, steps=3)
    dragged = until(page, lambda: (now := page.evaluate(there))[1] > y + 25.0 and now, "it is dragged")
    assert dragged[0] == pytest.approx(x, abs=2.0)
    page.mouse.up()
    predicted = page.evaluate("__softrod.now().body.positions[3]")
    page.get_by_role("button", name="It will be there").click()
    assert page.evaluate(time) == 0.0
    page.get_by_role("button", name="at 240").click()
    until(page, lambda: page.evaluate(time) >= 0.5, "it stands at the moment that was predicted")
    page.get_by_role("button", name="Play").wait_for()
    assert page.evaluate(time) < 1.0
    page.get_by_role("button", name="Play").click()
    expect(page.locator(".softrod-goal")).to_contain_text("Reached")
    page.get_by_label("In your own words").fill("<b>Energy</b> stays")
    page.get_by_role("button", name="What is right?").click()
    expect(page.locator(".softrod-verdict")).to_have_text("That is right. Energy.")
    # All of it is there again after a reload.
    page.reload()
    expect(page.locator(".softrod-verdict")).to_have_text("That is right. Energy.")
    page.get_by_text("Hand in your answers").click()
    page.get_by_label("Your name").fill("Zoë")
    code = page.locator("#answers code")
    expect(code).to_have_text(re.compile(r"^SR1[A-Z2-7]{20,147}$"))
    text = code.inner_text()
    with page.expect_download() as saving:
        page.get_by_role("button", name="Save answers").click()
    saved = tmp_path / saving.value.suggested_filename
    saving.value.save_as(saved)
    assert saved.name == "answers-Zoë.json"
    context.close()

    desk = school.open(desk_address(school.base, school.klass), LAPTOP)
    desk.get_by_text("Answers from files").click()
    box = desk.locator(".softrod-brought")
    box.get_by_label("Or the text").fill(f"{text[:-1]}{'A' if text[-1] != 'A' else 'B'} {text}")
    desk.keyboard.press("Enter")
    expect(box.locator("li")).to_have_count(2)
    expect(box.locator("li").first).to_contain_text("Zoë: 3 answers")
    expect(box.locator("li").last).to_contain_text("scan it again")
    box.get_by_label("Their files").set_input_files([saved])
    expect(box.locator("li").first).to_contain_text("1 answer, 2 had been brought before")
    room = school.klass.room
    [ghost] = room.given(0, 0, Ghost)
    assert isinstance(ghost.content, Ghost)
    assert ghost.content.points[1][1] == pytest.approx(predicted)
    assert [answer.content for answer in room.given(0, 0, Vote)] == [Vote(1)]
    assert [answer.content for answer in room.given(0, 0, Line)] == [Line("<b>Energy</b> stays")]
    ARTIFACTS.mkdir(exist_ok=True)
    desk.screenshot(path=ARTIFACTS / "class-brought.png")
