"""What is sent to a page of forces, velocities and torques, and when."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pytest

import sim
from app.features.instruments.arrows import KINDS, MAX_ARROWS, Arrows, encode, negligible
from app.features.instruments.messages import PutBack, Tools
from app.features.instruments.panel import MAX_TRACES, ORDER, ToolsPanel
from app.features.lesson.messages import BeginStep
from app.session import commands
from app.session.session import Session
from app.wire.from_page import Perform
from sim.scene.lesson import Lesson, Step
from tests.app.letters import Letters
from tests.app.pages import SessionPage
from tests.app.panels import Client, page_of
from tests.app.whole import WholePage

ALL = frozenset(KINDS)


def sections(data: np.ndarray) -> list[np.ndarray]:
    """As plan.js reads them."""
    found, at = [], 0
    while at < len(data):
        length = int(data[at])
        found.append(data[at + 1 : at + 1 + length])
        at += 1 + length
    return found


class Wire:
    """The arrows of a page, and what its script is sent."""

    def __init__(self) -> None:
        self.letters = Letters()
        self.arrows = Arrows(self.letters)

    @property
    def numbers(self) -> np.ndarray:
        return self.letters.sent[-1].numbers

    def sent(self) -> list[np.ndarray]:
        return sections(self.numbers)

    def draw(self, page: SessionPage, kinds: frozenset[str], now: float = 0.0, exactly: bool = True) -> bool:
        """Whether something was sent."""
        before = len(self.letters.sent)
        self.arrows.draw(page.session, kinds, 3, now, exactly)
        return len(self.letters.sent) > before


def test_the_numbers_are_those_of_the_solver() -> None:
    page, wire = SessionPage(), Wire()
    page.frames(20)
    assert wire.draw(page, ALL)
    head, _, held, forces, velocities, torques = wire.sent()
    simulation = page.simulation
    assert head[:4].tolist() == [3.0, np.float32(simulation.time), 1.0, 1.0]
    assert held.tolist() == [0.0]
    assert forces.reshape(-1, 2) == pytest.approx(simulation.loads.forces, rel=1e-6, abs=1e-3)
    assert velocities.reshape(-1, 2) == pytest.approx(simulation.velocities, rel=1e-6, abs=1e-6)
    assert torques == pytest.approx(simulation.loads.torques, rel=1e-6, abs=1e-3)


def test_nothing_is_sent_while_no_switch_is_on_and_only_what_is_asked_for() -> None:
    page, wire = SessionPage("ring"), Wire()
    assert not wire.draw(page, frozenset())
    assert wire.draw(page, frozenset({"velocities"}))
    assert [len(section) for section in wire.sent()[3:]] == [0, 32]
    assert wire.draw(page, frozenset())
    assert len(wire.numbers) == 0, "and nothing is left of them"
    assert not wire.draw(page, frozenset())


def test_they_are_right_when_paused_and_after_going_back_in_time() -> None:
    page, wire = SessionPage(), Wire()
    page.frames(10)
    page.frames(30, commands.SetValue("gravity", 0.0))
    then = page.simulation.loads.forces
    page.frames(30, commands.SetValue("rest_angle", 20.0))
    page.frames(1, commands.Play(False))
    wire.draw(page, ALL)
    assert not wire.draw(page, ALL), "it stands"
    time = page.simulation.time
    page.frames(1, commands.GoTo(time - 30 / 60))
    assert wire.draw(page, ALL)
    assert wire.sent()[3].reshape(-1, 2) == pytest.approx(then, rel=0.2, abs=0.05 * np.abs(then).max())
    assert wire.sent()[3].reshape(-1, 2) == pytest.approx(page.simulation.loads.forces, rel=1e-6, abs=1e-3)
    page.frames(1, commands.SetValue("gravity", 500.0))
    assert wire.draw(page, ALL), "another setting, at the same moment"


def test_a_body_in_motion_is_told_of_thirty_times_a_second_and_one_at_rest_no_more() -> None:
    page, wire = SessionPage(), Wire()
    page.session.post(commands.SetValue("rest_angle", 10.0))
    count = 0
    for frame in range(60):
        page.frames(1)
        count += wire.draw(page, ALL, frame / 60, exactly=False)
    assert 28 <= count <= 31
    page, wire = SessionPage(), Wire()
    page.frames(900)
    wire.draw(page, ALL, 0.0, exactly=False)
    page.frames(2)
    assert not wire.draw(page, ALL, 1.0, exactly=False)


def test_of_a_thousand_masses_some_have_arrows_and_the_held_ones_in_any_case() -> None:
    scene = sim.cloth(columns=40, rows=25)
    page, wire = SessionPage(scene), Wire()
    assert wire.draw(page, ALL)
    head, _, held, forces, _, torques = wire.sent()
    step = int(head[2])
    assert step == 5
    chosen = [*range(0, 1000, step), *(int(m) for m in held if m % step)]
    assert len(forces) == 2 * len(chosen) <= 2 * (MAX_ARROWS + len(held))
    assert {anchor.mass for anchor in scene.anchors} == set(held.astype(int)) <= set(chosen)
    assert forces.reshape(-1, 2) == pytest.approx(page.simulation.loads.forces[chosen], rel=1e-5, abs=0.1)
    assert len(torques) <= MAX_ARROWS
    assert len(wire.numbers) < 4 * MAX_ARROWS + 500


def test_the_mass_in_hand_counts_as_held() -> None:
    page, wire = SessionPage(), Wire()
    page.frames(2, commands.DragStart(5, 300.0, 300.0))
    wire.draw(page, ALL)
    assert wire.sent()[2].tolist() == [0.0, 5.0]


@pytest.mark.parametrize("name", [info.name for info in sim.list_scenes() if info.built_in])
def test_what_is_next_to_nothing_is_small_and_positive(name: str) -> None:
    scene = sim.load_scene(name)
    least = negligible(scene)
    assert all(0.0 < part < 1e9 for part in least)
    simulation = sim.Simulation(scene)
    simulation.step(20)
    if np.hypot(*scene.gravity) > 0.0:
        assert least[0] < np.abs(simulation.loads.forces).max()


def test_every_number_of_a_body_without_joints_and_springs_can_be_sent() -> None:
    data = encode(1, 0.0, (1.0, 1.0, 1.0), [0], [np.zeros((1, 2)), np.zeros(0), np.zeros(0)])
    assert [len(section) for section in sections(data)] == [4, 3, 1, 2]


class Panel:
    """The switches of a page, and what its script is sent."""

    def __init__(self, session: Session) -> None:
        self.client: Any = Client()
        self.letters = Letters()
        self.panel = ToolsPanel(page_of(session, self.client, self.letters))
        self.panel.build()

    @property
    def are_on(self) -> list[bool]:
        return [self.client.gui[label].value for label in ("Forces", "Velocities", "Torques")]

    @property
    def traced(self) -> tuple[int, ...]:
        return self.letters.last(Tools).traced


def test_arrows_are_taken_away_with_their_switches_and_come_back_with_new_ones() -> None:
    session = SessionPage("ring").session
    one = Panel(session)
    one.panel.show_arrows({"forces", "torques"})
    assert one.are_on == [True, False, True]
    one.panel.draw(1, 0.0, exactly=True)
    assert len(one.letters.sent[-1].numbers)
    kinds = one.panel.leave()
    assert not len(one.letters.sent[-1].numbers)
    other = Panel(session)
    other.panel.show_arrows(kinds)
    assert other.are_on == [True, False, True]


def test_the_switches_stand_below_the_plots_however_many_pages_there_were() -> None:
    orders = [control.order for control in Panel(SessionPage("ring").session).client.gui.there]
    assert len(orders) == 8
    assert min(orders) >= ORDER


def test_the_page_is_told_which_masses_are_traced() -> None:
    page = Panel(SessionPage("ring").session)
    assert page.letters.last(Tools) == Tools()
    page.panel.trace(True)
    assert page.traced == (), "no mass is chosen"
    for mass in (3, 99, 5, 3):
        page.panel.choose(mass)
        page.panel.trace(True)
    assert page.traced == (5, 3)
    page.panel.trace(False)
    assert page.traced == (5,)
    for mass in range(MAX_TRACES + 2):
        page.panel.choose(mass)
        page.panel.trace(True)
    assert page.traced == tuple(range(2, 10))
    page.client.gui["Length of a trace"].enter("10 s")
    page.panel.clear_traces()
    assert page.letters.last(Tools) == Tools(seconds=10, chosen=9)


def test_the_stroboscope_has_an_interval_and_bears_any_text() -> None:
    page = WholePage("rod")
    for label, interval in (("every 0.05 s", 0.05), ("every 1 s", 1.0), ("<b>", 0.0), ("off", 0.0)):
        page.enter("Stroboscope", label)
        page.frames(1)
        assert page.client.mail.last(Tools).strobe == interval


def test_another_scene_begins_without_plots_arrows_and_instruments_and_a_lesson_with_its_own() -> None:
    step = Step(title="A", do="B", plots=("body.y",))
    lesson = msgspec.structs.replace(sim.load_scene("rod"), name="lesson", lesson=Lesson(steps=(step,)))
    page = WholePage("ring")

    def put_up() -> None:
        page.frames(2, Perform("plot"))
        page.gui["Forces"].enter(True)
        page.enter("Stroboscope", "every 0.1 s")

    def shown() -> tuple[int, object, float, int]:
        mail, tab = page.client.mail, page.tab.probe()
        back = [one for one in mail.sent if isinstance(one, PutBack)]
        return len(tab.plots), page.gui["Forces"].value, mail.last(Tools).strobe, len(back)

    put_up()
    assert shown() == (1, True, 0.1, 0)
    ring = msgspec.structs.replace(sim.load_scene("ring"), gravity=(0.0, 9.0))
    page.shown(commands.Reset(), commands.SetValue("gravity", 3.0), commands.Undo(), commands.Open(ring))
    assert shown() == (1, True, 0.1, 0)
    page.shown(commands.Open(sim.load_scene("rod")))
    assert shown() == (0, False, 0.0, 1)
    put_up()
    page.shown(commands.Open(lesson))
    page.shown(BeginStep(0))
    assert shown() == (0, False, 0.0, 2)
    assert "y of the body" in page.gui.text("Lesson")
    page.shown(commands.Open(ring))
    assert shown() == (0, False, 0.0, 3), "nor does what stood beside the lesson before come back"
