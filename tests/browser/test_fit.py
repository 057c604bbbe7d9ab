"""A table of what was measured is opened, seen over the body, and fitted."""

from __future__ import annotations

import numpy as np
import pytest

import sim
from app.features.fit.panel import DRAWS
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk
from tests.browser.looks import assert_shown
from tests.sim.measured import measure

DROP = """([name, text]) => {
  const files = new DataTransfer();
  files.items.add(new File([text], name));
  const dropped = new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true });
  document.body.dispatchEvent(dropped);
}"""


def drop(desk: Desk, name: str, text: str) -> None:
    """Let a file fall onto the page."""
    desk.page.evaluate(DROP, [name, text])


def test_a_table_is_dropped_seen_over_the_body_and_fitted_as_one_step_of_undo(open_page: OpenPage) -> None:
    """A pendulum under a weaker gravity, with y upwards as Tracker has it."""
    desk = open_page("pendulum")
    desk.tell(commands.Play(False), commands.Reset())
    hidden = sim.set_value(sim.load_scene("pendulum"), "gravity", 800.0)
    data = measure(hidden, ["mass1.x", "mass1.y"], 0.6, 0.005, np.random.default_rng(1))
    x, y = (column.values for column in data.columns)
    rows = (f"{t:.4f}\t{a:.3f}\t{-b:.3f}" for t, a, b in zip(data.time, x, y, strict=True))
    drop(desk, "swing.txt", "mass A\t\t\nt\tx\ty\n" + "\n".join(rows))
    assert desk.control("mass A x").input_value() == "mass1.x"
    assert desk.control("mass A y").input_value() == "-mass1.y"
    link = desk.page.get_by_role("link", name="Measure in a video")
    # It is relative to the page's own address, so that it holds behind a prefix, too.
    assert link.evaluate("a => [a.getAttribute('href'), a.target]") == ["video", "_blank"]
    desk.until(lambda: len(points(desk)) == data.time.size, "a point for each row")
    # The first row is where the mass is.
    where = points(desk)[0]
    assert np.hypot(*(np.array(where) - desk.place(1))) < 4.0
    for name, on in (("Stretching stiffness", False), ("Stretching damping", False), ("Gravity", True)):
        switch = desk.page.get_by_role("switch", name=name, exact=True)
        switch.check() if on else switch.uncheck()
    before = desk.session.scene
    desk.button("Fit").click()
    desk.until(lambda: desk.session.scene != before, "the scene is fitted")
    assert desk.session.scene.gravity[1] == pytest.approx(800.0, rel=5e-3)
    found = desk.page.locator(".softrod-table", has_text="gravity")
    desk.until(lambda: found.count() == 1 and "±" in found.inner_text(), "the interval is there")
    assert_shown(desk)
    # Pale bodies that go with the table about as well lie close to the fitted one.
    desk.until(lambda: len(ends(desk)) == DRAWS, "the bodies")
    assert np.hypot(*(np.array(ends(desk)) - desk.place(1)).T).max() < 4.0
    first = ends(desk)[0]
    desk.tell(commands.DoSteps(round(0.3 / desk.session.simulation.dt)))
    desk.until(lambda: np.hypot(*(np.array(ends(desk)[0]) - first)) > 10.0, "they move along")
    desk.wait_drawn()
    assert np.hypot(*(np.array(ends(desk)) - desk.place(1)).T).max() < 8.0
    desk.tell(commands.Undo())
    assert desk.session.scene.gravity == before.gravity
    desk.button("Forget the table").click()
    desk.until(lambda: not points(desk) and not ends(desk), "the points and the bodies are gone")

    # What is not right is said, and changes nothing.
    drop(desk, "bad.csv", "t,x\n0,1\n1,inf\n")
    assert "bad.csv, line 3, column 'x': 'inf' is not a finite number" in desk.notice("That did not work")


def ends(desk: Desk) -> list[tuple[float, float]]:
    """Where the second masses of the pale bodies are, px of the window: each is a line with a mass at either
    end."""
    text = desk.page.evaluate("document.querySelector('.softrod-measured-fan')?.getAttribute('d') ?? ''")
    both = (each.split("L")[1].split() for each in text.split("M")[1:])
    return [(float(x), float(y)) for x, y in both]


def points(desk: Desk) -> list[tuple[float, float]]:
    """Where measured places are drawn, px of the window."""
    text = desk.page.evaluate("document.querySelector('.softrod-measured-all')?.getAttribute('d') ?? ''")
    found = []
    for each in text.split("M")[1:]:
        x, rest = each.split(" ", 1)
        found.append((float(x) + 2.0, float(rest.split("a")[0])))
    return found
