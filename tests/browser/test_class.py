"""One lesson of a class, from its command's server to the zip: a teacher, a wall and a pupil.

`tests/app/test_roles.py` and `test_room.py` have what several pupils do to each other.
"""

from __future__ import annotations

import re
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import msgspec
import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

import sim
from app.classroom import kept
from app.classroom.answers import Line, Phase, Prediction, Vote, Work
from app.classroom.live import Class
from app.export.live.live import live_html
from app.features.classroom.roles import desk_address, seat_address, wall_address
from app.session.session import Session
from app.words import PSEUDO
from sim.scene.lesson import Goal, Lesson, Question, Reading, Step
from tests.amount import part_of
from tests.app.classrooms import Teacher
from tests.app.test_room import an_answer
from tests.browser.between_frames import FRAME_LOCK
from tests.browser.classrooms import HEIGHTS, LETTERS, serving_class
from tests.browser.driver import LIMIT, rough_context, until
from tests.browser.layout import TOUCHED
from tests.browser.test_pseudo import faults
from tests.browser.wires import Wire

expect.set_options(timeout=LIMIT * 1e3)

CONTRAST = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
HURRIED = "window.__softrodHurry = 4"
"""Has a page lose its patience sooner; `tests/page` tests the times."""
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
        plots=("mass1.y",),
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
    classroom: Class
    pages: list[Page] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)

    @property
    def base(self) -> str:
        return f"http://127.0.0.1:{self.port}/"

    def open(self, address: str, size: tuple[int, int], touch: bool = False, script: str = "") -> Page:
        context = rough_context(
            self.browser,
            viewport={"width": size[0], "height": size[1]},
            has_touch=touch,
            reduced_motion="reduce",
        )
        context.add_init_script(script)
        page = context.new_page()
        page.set_default_timeout(LIMIT * 1e3)
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.goto(address)
        self.pages.append(page)
        return page

    def go(self, desk: Page, phase: Phase, round: int = 0) -> None:
        """Go on, and wait until the class is there."""
        desk.locator("[data-focus=next]").click()
        until(
            desk,
            lambda: (self.classroom.room.phase, self.classroom.room.round) == (phase, round),
            f"to {phase}",
        )

    def led(self) -> Callable[[Phase], None]:
        """A teacher without a page; returns what takes the class to a phase."""
        with FRAME_LOCK:
            teacher = Teacher(self.classroom, Session(a_lesson()))

        def go(phase: Phase) -> None:
            with FRAME_LOCK:
                self.classroom.room.go(0, phase)
                teacher.frame()
                teacher.frame()

        return go

    def stands_out(self, name: str) -> None:
        """Look whether the class's texts do."""
        for page in self.pages:
            shown = set(page.locator(".softrod-class").all_inner_texts())
            judged = [one for one in page.evaluate(CONTRAST) if any(one["text"] in text for text in shown)]
            assert judged, name
            assert not [one for one in judged if one["ratio"] < one["needed"]], name


@pytest.fixture
def school(browser: Browser, tmp_path: Path) -> Iterator[School]:
    with serving_class(a_lesson(), tmp_path) as (port, classroom):
        made = School(browser, port, classroom)
        yield made
        for page in made.pages:
            page.context.close()
        assert not made.errors


def test_a_lesson_from_the_door_to_the_zip(school: School) -> None:
    """By keys alone on the pupil's side, whose connection is lost meanwhile."""
    classroom, room = school.classroom, school.classroom.room
    desk = school.open(desk_address(school.base, classroom), LAPTOP)
    wall = school.open(wall_address(school.base, room.code), WALL)
    wire = Wire(school.port)
    pupil = school.open(seat_address(f"http://127.0.0.1:{wire.port}/", room.code), LAPTOP, script=HURRIED)
    keys, task = pupil.keyboard, pupil.locator(".softrod-task")
    expect(desk.locator(".softrod-desk-code")).to_have_text(room.code)
    expect(wall.locator(".softrod-wall-code")).to_have_text(room.code)
    expect(task).to_have_text("You are in. It begins soon.")
    name = pupil.locator(".softrod-seat-name").inner_text()
    with FRAME_LOCK:
        absent = room.enter("a" * 32)  # has a seat, and no page
    pupil.get_by_role("button", name="Hand up").press("Enter")
    expect(desk.locator(".softrod-desk-hands")).to_have_text(name)
    expect(desk.locator(".softrod-desk-hands path")).to_be_visible()
    desk.get_by_role("button", name="Lower hands").click()
    until(desk, lambda: not any(seat.hand for seat in room.seats.values()), "the hand is down")
    pupil.evaluate("document.activeElement.blur()")
    school.stands_out("lobby")
    school.go(desk, Phase.SHOW)
    expect(task).to_have_text("Look to the front.")

    # The focus is at the question, and what is to be done has been said.
    school.go(desk, Phase.ASK)
    with FRAME_LOCK:
        room.take(absent.number, an_answer(1, Vote(0)))
    expect(pupil.locator("[data-focus=question]")).to_be_focused()
    expect(pupil.locator(".softrod-tell", has_text="Move the pale body")).to_have_count(1)
    pupil.locator(".softrod-own-prediction circle").focus()
    for _ in range(3):
        keys.press("ArrowDown")
    pupil.locator("[data-focus=predict]").press("Enter")
    pupil.locator("[data-focus=choice0]").press("Enter")
    until(desk, lambda: room.given(0, 0, Prediction) and room.bars(0, 0) == [2, 0], "it is answered")
    # Another answer is given without a connection; the page is reloaded, and it counts all the same.
    wire.mute = True
    expect(pupil.locator("html")).to_have_attribute("data-softrod-away", "")
    pupil.locator("[data-focus=choice1]").click()
    expect(pupil.locator(".softrod-waiting")).to_be_visible()
    wire.mute = False
    pupil.reload()
    until(pupil, lambda: room.bars(0, 0) == [1, 1], "the late answer has come")
    expect(pupil.locator(".softrod-seat-name")).to_have_text(name)
    expect(pupil.locator("[data-focus=choice1]")).to_have_attribute("aria-pressed", "true")
    expect(pupil.locator(".softrod-waiting")).to_have_count(0)
    expect(wall.locator(".softrod-wall-count")).to_have_text("1 of 1 has answered")
    assert wall.locator(".softrod-bars b").count() == 0
    assert wall.locator(".softrod-predictions path").count() == 0
    school.stands_out("ask")
    expect(desk.locator(".softrod-desk-advice")).to_have_text(
        "50 % right: let them talk in pairs, then ask again."
    )
    # The teacher alone sees who chose and predicted what, in a small picture of the body.
    expect(desk.locator(".softrod-tiles")).to_contain_text("at 240")
    dots = desk.locator(".softrod-tiles .softrod-poster-dots")
    expect(dots).to_have_attribute("d", re.compile(r"^M\d+ \d+h0$"))
    expect(desk.locator(".softrod-desk-progress")).to_contain_text(re.compile("Phase 2 of 8.*0 min so far"))
    school.go(desk, Phase.RESULTS)
    expect(desk.locator("[data-focus=advice]")).to_have_text("Ask again")
    expect(wall.locator(".softrod-bars b")).to_have_text(["1", "1"])
    expect(wall.locator(".softrod-predictions path")).to_have_count(1)
    assert wall.locator("[data-right]").count() == 0
    assert name not in wall.locator("body").inner_text()
    school.stands_out("results")

    # The class is split, so it is asked again.
    school.go(desk, Phase.ASK, 1)
    pupil.locator("[data-focus=choice1]").press("Enter")
    until(pupil, lambda: room.bars(0, 1) == [0, 1], "the second vote counts")
    school.go(desk, Phase.RESULTS, 1)
    assert wall.locator("[data-right]").count() == 0

    # One run, the same everywhere, which stands at the moment that was predicted; and again, slowly.
    school.go(desk, Phase.RUN)

    def stands() -> bool:
        front = classroom.shared_view
        return front is not None and not front.playing and front.picture.time >= 0.5

    until(desk, stands, "it stands at the moment that was predicted")
    assert classroom.shared_view is not None
    there = classroom.shared_view.picture.positions.astype(np.float32).ravel().tolist()
    shown = "[...window.__softrod.shown().frame.positions]"
    for page in (wall, pupil):
        until(page, lambda page=page: page.evaluate(shown) == there, "it shows the moment, bit for bit")
    school.stands_out("run")
    desk.get_by_role("button", name="Again, slowly").click()
    until(
        desk,
        lambda: (
            classroom.shared_view and classroom.shared_view.playing and classroom.shared_view.speed == 0.25
        ),
        "it goes slowly",
    )
    expect(wall.locator(".softrod-predictions path")).to_have_count(1)

    # The reveal: what is right, and a dot for the prediction.
    school.go(desk, Phase.REVEAL)
    expect(wall.locator("[data-right]")).to_contain_text("at 240")
    expect(wall.locator(".softrod-wall-number")).to_have_text("at 240")
    expect(wall.locator(".softrod-reveal circle")).to_have_count(1)
    expect(wall.locator(".softrod-reveal-far")).to_contain_text("lower")
    expect(pupil.locator(".softrod-verdict")).to_contain_text("The right answer: at 240")
    assert name not in wall.locator("body").inner_text()
    school.stands_out("reveal")

    school.go(desk, Phase.EXPLAIN)
    pupil.get_by_label("Because").fill('<img src=x onerror="alert(1)"> energy')
    keys.press("Enter")
    until(pupil, lambda: len(room.given(0, 0, Line)) == 1, "the line is there")
    expect(desk.locator(".softrod-lines").first).to_contain_text("\u2068<img")  # with its own direction
    desk.get_by_role("button", name="Show this line on the wall").click()

    # Each one has a body of their own; one looks at the teacher's and at its own again; then all have to.
    school.go(desk, Phase.TRY)
    expect(wall.locator("blockquote")).to_have_text('<img src=x onerror="alert(1)"> energy')
    expect(wall.locator("blockquote")).to_have_attribute("dir", "auto")
    expect(pupil.locator(".softrod-goal")).to_contain_text("Reached")
    expect(desk.locator(".softrod-tiles svg.softrod-poster path")).to_have_count(2)
    expect(wall.locator(".softrod-counts li").first).to_be_visible()
    school.stands_out("try")
    pupil.get_by_role("button", name="Look at the teacher's").press("Enter")
    expect(task).to_have_text("This is your teacher's body. Yours waits.")
    expect(desk.locator(".softrod-tiles")).to_contain_text("looks at yours")
    pupil.get_by_role("button", name="Back to my own body").press("Enter")
    expect(task).to_have_text("Try it: this body is yours.")
    gather = desk.get_by_role("button", name="All look at mine")
    gather.click()
    expect(task).to_contain_text("Look to the front")
    gather.click()
    expect(task).to_have_text("Try it: this body is yours.")

    # One body goes on the wall, and another device takes its seat over.
    desk.get_by_role("button", name=name).click()
    desk.get_by_role("button", name="Put on the wall").click()
    expect(pupil.locator(".softrod-on-wall")).to_have_text("Yours is on the wall now.")
    desk.locator(".softrod-desk-seat").get_by_role("button", name="Move to another device").click()
    seat = next(seat for seat in room.seats.values() if seat.name == name)
    until(desk, lambda: bool(seat.move), "it has two digits")
    digits = seat.move
    pupil.context.clear_cookies()
    pupil.evaluate("localStorage.clear()")
    pupil.reload()
    pupil.get_by_text("This seat").click()
    pupil.get_by_label("I had a seat").fill(digits)
    keys.press("Enter")
    expect(pupil.locator(".softrod-seat-name")).to_have_text(name)
    assert len(room.seats) == 2
    desk.locator("[data-focus=allSeats]").click()

    # A later page of the browser has the seat; the earlier one gives its connection up, until it is wanted.
    later = pupil.context.new_page()
    later.goto(pupil.url)
    expect(later.locator(".softrod-seat-name")).to_have_text(name)
    expect(task).to_have_text("Another page of this browser has your seat now.")
    until(desk, lambda: wire.open == 1, "its connection is closed")
    pupil.get_by_role("button", name="Come back here").press("Enter")
    expect(pupil.locator(".softrod-seat-name")).to_have_text(name)
    later.close()

    # A picture of what was handed in, for the wall; its pupil reads that it is there.
    school.go(desk, Phase.COLLECT)
    expect(pupil.locator("[data-focus=handin]")).to_be_enabled()
    pupil.locator("[data-focus=handin]").press("Enter")
    expect(pupil.locator(".softrod-handed")).to_contain_text("Handed in")
    until(pupil, lambda: room.given(0, 0, Work)[0][1].reached is True, "the goal is judged")
    desk.get_by_text("Handed in: 1").click()
    desk.get_by_role("button", name=f"Show the body of {name} on the wall").click()
    expect(pupil.locator(".softrod-on-wall")).to_be_visible()
    expect(desk.locator(".softrod-lines svg.softrod-poster path")).to_have_attribute(
        "d", re.compile(r"M\d+ \d+L\d+ \d+")
    )
    school.stands_out("collect")

    with desk.expect_download() as download:
        desk.get_by_label("More", exact=True).click()
        desk.get_by_role("button", name="Save all as a zip").click()
    with zipfile.ZipFile(download.value.path()) as file:  # `tests/app/test_takeaway.py` has what is in it
        assert "answers.csv" in file.namelist()
    desk.once("dialog", lambda dialog: dialog.accept())
    desk.get_by_role("button", name="End", exact=True).click()
    expect(pupil.locator(".softrod-seat h1")).to_have_text("The class is over.")
    assert not list(kept.classes_folder().iterdir())
    wire.close()


@pytest.mark.parametrize("tag", part_of(("en", "de", "fr", "es", "tr", "ar"), 6))
def test_the_desk_s_head_has_room_and_words_do_nothing_where_letters_are_no_keys(
    school: School, tag: str
) -> None:
    address = desk_address(school.base, school.classroom).replace("?", f"?lang={tag}&")
    off = "localStorage.setItem('softrod-access', JSON.stringify({ letters: 'never' }))"
    desk = school.open(address, (1280, 720), script=off)
    expect(desk.locator(".softrod-desk-code")).to_have_text(school.classroom.room.code)
    beyond = "(part) => part.scrollWidth - part.clientWidth"
    assert desk.locator(".softrod-desk").evaluate(beyond) == 0
    expect(desk.locator(".softrod-loading")).to_have_count(0)
    desk.evaluate("document.activeElement.blur()")
    before = desk.locator(".softrod-desk").inner_text(), school.classroom.room.phase
    desk.keyboard.type(15 * "pack my box with five dozen liquor jugs, 0 or 10. Then go on: quit? ")
    desk.wait_for_timeout(200)
    assert (desk.locator(".softrod-desk").inner_text(), school.classroom.room.phase) == before
    assert desk.locator("dialog[open]").count() == 0


def test_on_a_phone_a_pupil_comes_in_by_letters_and_answers_by_touch(school: School) -> None:
    room, go = school.classroom.room, school.led()
    phone = school.open(f"{school.base}?room=QQQQ", PHONE, touch=True)
    expect(phone.locator(".softrod-warning")).to_contain_text("no class QQQQ")
    phone.get_by_label("The four letters").fill(room.code.lower())
    phone.get_by_role("button", name="Come in").tap()
    expect(phone.locator(".softrod-task")).to_have_text("You are in. It begins soon.")
    go(Phase.ASK)
    grip = phone.locator(".softrod-own-prediction circle")
    predict = phone.locator("[data-focus=predict]")
    expect(grip).to_have_count(1)
    finger = phone.context.new_cdp_session(phone)

    def is_dragged() -> bool:
        """Once the view has made room for the card."""
        box = grip.bounding_box()
        assert box is not None
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        for kind, down in (
            ("touchStart", 0),
            *(("touchMove", 10 * i) for i in range(1, 7)),
            ("touchEnd", 60),
        ):
            points = [] if kind == "touchEnd" else [{"x": x, "y": y + down}]
            finger.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        after = grip.bounding_box()
        assert after is not None
        # A browser that takes a drag for a scroll cancels it after some 15 px.
        return predict.is_enabled() and after["y"] - box["y"] > 50.0

    until(phone, is_dragged, "the pale body is dragged")
    phone.wait_for_timeout(600)  # a tap right after a drag may be taken for half of a double one
    predict.tap()
    phone.get_by_role("button", name="at 240").tap()
    until(phone, lambda: room.given(0, 0, Prediction) and room.bars(0, 0) == [0, 1], "both have come")
    school.stands_out("ask")
    # The sliders of the step stand below the card.
    go(Phase.TRY)
    expect(phone.locator(".softrod-goal")).to_be_visible()
    expect(phone.get_by_text("Stretching stiffness", exact=True)).to_be_visible()
    # A plot says what it shows where it is tapped.
    phone.locator(".chart canvas").tap()
    expect(phone.locator(".chart .reading")).to_contain_text("At ")
    go(Phase.COLLECT)
    phone.locator("[data-focus=handin]").tap()
    expect(phone.locator(".softrod-handed")).to_contain_text("Handed in")


def test_a_pupil_s_body_goes_on_without_a_network_and_is_the_server_s_again(school: School) -> None:
    room = school.classroom.room
    with FRAME_LOCK:
        teacher = Teacher(school.classroom, Session(a_lesson()))
    wire = Wire(school.port)
    address = seat_address(f"http://127.0.0.1:{wire.port}/", room.code)
    phone = school.open(address, PHONE, touch=True, script=HURRIED)
    expect(phone.locator(".softrod-task")).to_have_text("You are in. It begins soon.")
    with FRAME_LOCK:
        room.go(0, Phase.TRY)
        teacher.frame()
    time = "window.__softrod.shown().frame?.time ?? 0"
    until(phone, lambda: phone.evaluate(time) > 0.2, "it moves")
    wire.mute = True
    expect(phone.locator("#banner")).to_contain_text("your body goes on here")
    before = phone.evaluate(time)
    until(phone, lambda: phone.evaluate(time) > before + 0.3, "it goes on")
    place = phone.evaluate("[...window.__softrod.shown().frame.positions]")
    assert abs(place[2] - 300.0) < 5.0, "as before: it swings up and down"
    assert 190.0 < place[3] < 290.0
    # What it does now is not handed in; sliders and buttons act on it.
    phone.locator("[data-focus=play]").tap()
    stands = phone.evaluate(time)
    phone.locator("[data-focus=play]").tap()
    until(phone, lambda: phone.evaluate(time) > stands, "it plays on")
    wire.mute = False
    expect(phone.locator("#banner")).to_be_empty()
    expect(phone.locator(".softrod-task")).to_have_text("Try it: this body is yours.")
    later = phone.evaluate(time)
    until(phone, lambda: phone.evaluate(time) > later, "the server's body is shown, and moves")
    wire.close()


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
    page.get_by_role("button", name="Check my answer").click()
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

    desk = school.open(desk_address(school.base, school.classroom), LAPTOP)
    desk.get_by_label("More", exact=True).click()
    desk.get_by_text("Answers from files").click()
    box = desk.locator(".softrod-brought")
    box.get_by_label("Or the text").fill(f"{text[:9]}{'A' if text[9] != 'A' else 'B'}{text[10:]} {text}")
    desk.keyboard.press("Enter")
    expect(box.locator("li")).to_have_count(2)
    expect(box.locator("li").first).to_contain_text("Zoë: 3 answers")
    expect(box.locator("li").last).to_contain_text("scan it again")
    box.get_by_label("Their files").set_input_files([saved])
    expect(box.locator("li").first).to_contain_text("1 answer, 2 had been brought before")
    room = school.classroom.room
    [(_, prediction)] = room.given(0, 0, Prediction)
    assert prediction.points[1][1] == pytest.approx(predicted)
    assert [content for _, content in room.given(0, 0, Vote)] == [Vote(1)]
    assert [content for _, content in room.given(0, 0, Line)] == [Line("<b>Energy</b> stays")]


def test_the_pages_of_one_class_have_their_own_languages(school: School) -> None:
    room, base = school.classroom.room, f"{school.base}?room={school.classroom.room.code}"

    def go(phase: Phase) -> None:
        with FRAME_LOCK:
            room.go(0, phase)

    wall = school.open(f"{base}&as=wall&lang=de", WALL)
    expect(wall.locator(".softrod-wall-address")).to_contain_text("Scannen, oder 127.0.0.1")
    pupil = school.open(f"{base}&lang=de", PHONE)
    expect(pupil.locator(".softrod-task")).to_have_text("Du bist dabei. Gleich geht es los.")
    expect(wall.get_by_text("1 ist da", exact=True)).to_be_visible()
    go(Phase.ASK)
    expect(wall.locator(".softrod-wall-count")).to_have_text("0 von 1 haben geantwortet")
    pupil.locator("[data-focus=choice1]").click()
    expect(wall.locator(".softrod-wall-count")).to_have_text("1 von 1 hat geantwortet")
    go(Phase.REVEAL)
    verdict = "Du hast gewählt: at 240. Die richtige Antwort: at 240. Energy."
    expect(pupil.locator(".softrod-verdict")).to_have_text(verdict)


def test_the_pages_of_a_class_say_all_by_messages_and_have_room(school: School) -> None:
    """In pseudo-English."""
    classroom = school.classroom
    addresses = {
        "desk": desk_address(school.base, classroom),
        "wall": wall_address(school.base, classroom.room.code),
        "pupil": seat_address(school.base, classroom.room.code),
    }
    opened = {
        name: school.open(address.replace("?", f"?lang={PSEUDO}&"), PHONE if name == "pupil" else LAPTOP)
        for name, address in addresses.items()
    }
    for page in opened.values():
        page.locator(".softrod-class >> visible=true").first.wait_for()
    lesson = {"Where does it stop first?", "at 220", "at 240", "Energy.", "It falls", "Double the stiffness."}
    for phase in Phase:
        with FRAME_LOCK:
            classroom.room.go(0, phase)
        for name, page in opened.items():
            for size in TOUCHED:
                if name == "wall" and size[0] < LAPTOP[0]:
                    continue
                page.set_viewport_size({"width": size[0], "height": size[1]})
                # A seat's name is English.
                found = {one for one in faults(page) if one[2] not in lesson and one[3] != "softrod-tile"}
                assert found == set(), (phase, name, size)


def test_a_prediction_is_made_by_taps_alone(school: School) -> None:
    """Without being asked for; what a pupil's body does by taps is, on the pupil's page."""
    room, go = school.classroom.room, school.led()
    phone = school.open(seat_address(school.base, room.code), PHONE, touch=True)
    expect(phone.locator(".softrod-task")).to_have_text("You are in. It begins soon.")
    phone.get_by_role("button", name="Tap instead of drag").tap()
    go(Phase.ASK)
    grip, predict = phone.locator(".softrod-own-prediction circle"), phone.locator("[data-focus=predict]")
    expect(predict).to_be_disabled()
    note = phone.locator(".softrod-taps")

    def middle() -> tuple[float, float]:
        box = grip.bounding_box()
        assert box is not None
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def is_moved() -> bool:
        """Once the view has made room for the card."""
        x, y = middle()
        phone.touchscreen.tap(x, y)
        if not note.is_visible():
            return False
        expect(note).to_contain_text("Picked up: mass 1")
        phone.touchscreen.tap(x + 10.0, y + 60.0)
        phone.wait_for_timeout(500)
        if note.is_visible():  # the card is there by now
            phone.keyboard.press("Escape")
            return False
        return predict.is_enabled() and middle()[1] > y + 40.0

    until(phone, is_moved, "the pale body is where it was tapped to")
    expect(predict).to_be_enabled()
    go(Phase.TRY)
    canvas = phone.locator("canvas")
    expect(canvas).to_be_visible()
    places = "[...window.__softrod.shown().body.positions]"
    phone.get_by_role("button", name="Pause").tap()
    phone.get_by_role("button", name="Play").wait_for()
    where = """() => {
      const picture = window.__softrod.shown(), { plan, place: on, body } = picture;
      const { left, top } = picture.canvas.getBoundingClientRect();
      const at = (i, sign) => ((body.positions[2 + i] - (i ? plan.y : plan.x)) * plan.scale * sign * on.step);
      return [left + on.x + at(0, 1), top + on.y - at(1, plan.flip)];
    }"""
    # The last pictures of a body that has stopped come a little later.
    until(
        phone,
        lambda: phone.evaluate(where) == (phone.wait_for_timeout(150), phone.evaluate(where))[1],
        "still",
    )
    before = phone.evaluate(places)
    x, y = phone.evaluate(where)
    phone.touchscreen.tap(x, y)
    expect(note).to_contain_text("Picked up: mass 1")
    phone.touchscreen.tap(x + 40.0, y)
    until(phone, lambda: phone.evaluate(where)[0] == pytest.approx(x + 40.0, abs=3.0), "the mass is, too")
    assert phone.evaluate(places)[2] > before[2]


@pytest.mark.parametrize("size", [LAPTOP, WALL])
def test_the_wall_shows_all_of_a_run_in_letters_for_the_last_row(
    school: School, size: tuple[int, int]
) -> None:
    room, go = school.classroom.room, school.led()
    wall = school.open(wall_address(school.base, room.code), size)
    side = wall.locator(".softrod-wall-side")
    plot = side.locator(".chart canvas")
    letters = "getComputedStyle(document.querySelector('.softrod-wall-side')).fontSize"
    for phase in (Phase.ASK, Phase.RESULTS, Phase.RUN, Phase.REVEAL, Phase.EXPLAIN, Phase.TRY):
        go(phase)
        expect(wall.locator("html")).to_have_attribute("data-softrod-phase", phase.value)
        assert float(wall.evaluate(letters).removesuffix("px")) >= size[1] / 28, phase
        if phase is Phase.RUN:
            box = plot.bounding_box()
            assert box is not None
            assert box["height"] >= size[1] / 5 - 1.0
            assert box["y"] + box["height"] <= size[1]
            # Words that need more room take it from the letters, not from the plot.
            wall.locator(".chart figcaption").evaluate("one => (one.textContent = 'More words. '.repeat(20))")
            seen = "one => one.getBoundingClientRect().bottom <= innerHeight"
            until(wall, partial(plot.evaluate, seen), "all of the plot is seen")
        assert side.evaluate("one => one.scrollHeight <= one.clientHeight"), phase
    go(Phase.COLLECT)
    with FRAME_LOCK:
        for number in (1, 2):
            room.take(room.enter(f"{number:032x}").number, an_answer(number, Work(found=2.0, setting=number)))
    assert side.locator(".softrod-class-plot").evaluate(LETTERS) >= 1 / 36


def test_the_reveal_has_a_strip_of_its_own_beside_the_body(school: School) -> None:
    room, alone = school.classroom.room, a_lesson()
    # Another body stands where the dots would be.
    wide = msgspec.structs.replace(alone, masses=(*alone.masses, sim.Mass(position=(560.0, 200.0))))
    room.choose((wide,))
    go = school.led()
    with FRAME_LOCK:
        seats = [room.enter(f"{i:032x}") for i in range(12)]
    go(Phase.ASK)
    with FRAME_LOCK:
        for i, seat in enumerate(seats):
            places = ((300.0, 100.0), (300.0, 240.0 + i), (560.0, 200.0))
            room.take(seat.number, an_answer(i, Prediction(places)))
    wall = school.open(wall_address(school.base, room.code), LAPTOP)
    go(Phase.RESULTS)
    # The body is seen between the rings.
    expect(wall.locator(".softrod-many path")).to_have_count(12)
    assert wall.locator(".softrod-many path").first.evaluate("one => getComputedStyle(one).fill") == "none"
    go(Phase.REVEAL)
    expect(wall.locator(".softrod-reveal circle")).to_have_count(12)
    beside = """() => {
      const picture = window.__softrod.shown(), { plan, frame, place: on } = picture;
      const end = (r, i) => on.x + ((frame.positions[2 * i] - plan.x) * plan.scale + r) * on.step;
      const box = (one) => one.getBoundingClientRect();
      const marks = [...document.querySelectorAll(".softrod-reveal :is(circle, text)")].map(box);
      const { right, bottom } = box(picture.canvas);
      return Math.min(...marks.map((one) => one.left)) > Math.max(...plan.radius.map(end)) &&
        marks.every((one) => one.right <= right && one.bottom <= bottom);
    }"""
    until(wall, lambda: wall.evaluate(beside), "dots and texts are beside the body")
    # Each a pixel below the one before.
    heights = wall.locator(".softrod-reveal circle").evaluate_all(HEIGHTS)
    assert np.diff(heights) == pytest.approx((heights[-1] - heights[0]) / 11)
    assert heights[-1] > heights[0]


def test_a_prediction_that_was_moved_is_handed_in_as_the_answers_are_shown(school: School) -> None:
    room, go = school.classroom.room, school.led()
    pupil = school.open(seat_address(school.base, room.code), LAPTOP)
    go(Phase.ASK)
    pupil.locator(".softrod-own-prediction circle").focus()
    pupil.keyboard.press("ArrowDown")
    expect(pupil.locator("[data-focus=predict]")).to_be_enabled()
    go(Phase.RESULTS)
    handed = pupil.locator(".softrod-handed")
    expect(handed).to_have_count(2)
    assert (
        handed.last.inner_text()
        == "The answers are shown: your prediction was handed in as you had moved it."
    )
    until(pupil, lambda: len(room.given(0, 0, Prediction)) == 1, "it is there")
    [(_, prediction)] = room.given(0, 0, Prediction)
    lower = prediction.points[1][1] - school.classroom.scene(0).masses[1].position[1]
    assert lower > 0.0
    assert handed.first.inner_text() == f"Handed in: {lower:.3g}\u00a0px lower."


def test_a_pupil_reads_what_was_predicted_while_it_is_moved_again_and_when_all_see_it(school: School) -> None:
    room, go = school.classroom.room, school.led()
    pupil = school.open(seat_address(school.base, room.code), LAPTOP)
    go(Phase.ASK)
    grip, made = pupil.locator(".softrod-own-prediction circle"), pupil.locator("[data-focus=predict]")
    grip.focus()
    pupil.keyboard.press("ArrowDown")
    made.click()
    until(pupil, lambda: "Your prediction is in" in made.inner_text(), "it is handed in")
    place = made.inner_text().partition(": ")[2]
    assert pupil.locator(".softrod-handed").count() == 0
    grip.focus()
    pupil.keyboard.press("ArrowDown")
    handed = pupil.locator(".softrod-handed")
    expect(handed).to_have_text(f"Handed in: {place}.")
    pupil.reload()
    for phase in (Phase.RESULTS, Phase.RUN, Phase.REVEAL):
        go(phase)
        until(pupil, lambda: handed.count() == 1, f"it is told in {phase}")
        assert handed.inner_text() == f"Handed in: {place}."


def test_a_pupil_reads_the_description_of_the_body_too(school: School) -> None:
    room, go = school.classroom.room, school.led()
    pupil = school.open(seat_address(school.base, room.code), PHONE)
    go(Phase.TRY)
    expect(pupil.locator(".softrod-task")).to_have_text("Try it: this body is yours.")
    pupil.keyboard.press("Shift+D")
    card = pupil.locator(".softrod-described")
    expect(card).to_contain_text("A chain of")
    stage = pupil.locator("#stage").bounding_box()
    box = card.bounding_box()
    assert stage and box
    assert stage["y"] <= box["y"] and box["y"] + box["height"] <= stage["y"] + stage["height"], (
        "over the body"
    )
    pupil.keyboard.press("Escape")
    expect(card).to_be_hidden()
    pupil.keyboard.press("Shift+D")
    card.get_by_role("button").click()
    expect(card).to_be_hidden()


def test_in_the_smallest_window_a_pupil_scrolls_to_the_body_and_reads_its_description(school: School) -> None:
    room, go = school.classroom.room, school.led()
    pupil = school.open(seat_address(school.base, room.code), (342, 192))
    go(Phase.TRY)
    expect(pupil.locator(".softrod-task")).to_have_text("Try it: this body is yours.")
    pupil.locator(".softrod-phases button").nth(
        1
    ).click()  # Reset; it has the focus, and the card is remade as it moves
    pupil.evaluate("scrollTo(0, 0)")
    for _ in range(5):
        pupil.wait_for_timeout(100)
        assert pupil.evaluate("scrollY") == 0
    pupil.evaluate("document.querySelector('.softrod-seat').scrollIntoView()")
    pupil.keyboard.press("Shift+D")
    card = pupil.locator(".softrod-described")
    expect(card).to_contain_text("A chain of")
    inside = """(one) => {
      const { top, bottom, left, width } = one.getBoundingClientRect();
      const at = document.elementFromPoint(left + width / 2, bottom - 4);
      return top >= 0 && bottom <= innerHeight && one.contains(at);
    }"""
    assert card.evaluate(inside), "it is in the window, over all else"
    card.evaluate("(one) => (one.scrollTop = 1e6)")
    pupil.keyboard.press("Shift+D")
    until(pupil, lambda: card.evaluate("(one) => one.scrollTop") == 0, "a new one begins at its beginning")


def test_a_description_is_asked_for_without_a_keyboard(school: School) -> None:
    room, go = school.classroom.room, school.led()
    phone = school.open(seat_address(school.base, room.code), PHONE, touch=True)
    go(Phase.TRY)
    phone.get_by_text("This seat").tap()
    phone.get_by_role("button", name="Describe the body").tap()
    expect(phone.locator(".softrod-described")).to_contain_text("A chain of")
