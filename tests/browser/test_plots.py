"""The Measure tab in a real browser: a plot that runs with the body, reads values, and is a table."""

from __future__ import annotations

import csv
import json
from typing import Any

import numpy as np
import pytest

from app.session import commands
from app.session.plots import PlotSpec
from tests.amount import part_of
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, box_of

ANGLE = PlotSpec(("joint0.angle",))


CHARTS = """() => JSON.stringify(window.__softrod.charts().map((chart) => ({
  data: chart.props.data.map((column) => [...column]),
  range: chart.ranges[0],
})))"""

CUT = """() => {
  const chart = document.querySelector(".softrod-chart").getBoundingClientRect();
  return [...document.querySelectorAll(".softrod-chart text")].filter((text) => {
    const { left, right, top, bottom } = text.getBoundingClientRect();
    const isWithin = left > chart.left - 1 && right < chart.right + 1;
    return !isWithin || top < chart.top - 1 || bottom > chart.bottom + 1;
  }).map((text) => text.textContent);
}"""
"""Texts of a chart that reach beyond it."""

KEPT = "Object.values(sessionStorage).join()"
"""What the tab keeps."""


def charts(desk: Desk) -> list[dict[str, Any]]:
    """What the charts in the page have: their data, and the range of what is upwards."""
    return json.loads(desk.page.evaluate(CHARTS))


def test_a_plot_runs_with_the_body_goes_back_and_is_a_table(open_page: OpenPage) -> None:
    desk = open_page("rod")
    assert not charts(desk)
    desk.page.keyboard.press("g")
    desk.until(lambda: desk.button("New plot").count(), "the tab is shown")
    desk.until(lambda: charts(desk) and len(charts(desk)[0]["data"][0]) > 30, "the plot runs")
    desk.until(lambda: "period" in desk.page.locator(".softrod-reading").inner_text(), "a period is read off")
    desk.tell(commands.Play(False))
    time = desk.simulation.time
    desk.until(lambda: abs(charts(desk)[0]["data"][0][-1] - time) < 1e-2, "it ends at the present time")
    chart = charts(desk)[0]
    assert abs(chart["data"][1][-1] - desk.simulation.angles[0]) < 1e-2
    low, high = chart["range"]
    assert low < min(chart["data"][1]) < max(chart["data"][1]) < high
    assert not desk.page.evaluate(CUT)

    # The pointer over it reads values.
    read = desk.page.locator(".softrod-plot-values")
    desk.page.locator(".softrod-chart").scroll_into_view_if_needed()
    over = box_of(desk.page.locator(".softrod-chart"))
    desk.page.mouse.move(over["x"] + 0.5 * over["width"], over["y"] + 60.0)
    desk.until(lambda: "joint0.angle, °: " in read.inner_text(), "the values are read")

    # Also where all is larger, for a projector: the line stands at the pointer.
    larger = "document.documentElement.style.setProperty('--softrod-larger', '1.25')"
    desk.page.evaluate(larger)
    desk.page.locator(".softrod-chart").scroll_into_view_if_needed()
    desk.pause(0.1)
    chart_box = box_of(desk.page.locator(".softrod-chart"))
    desk.page.mouse.move(chart_box["x"] + 0.5 * chart_box["width"], chart_box["y"] + 60.0)
    mark, svg = desk.page.locator(".softrod-chart-mark"), desk.page.locator(".softrod-chart")
    middle = f"M{0.5 * float((svg.get_attribute('viewBox') or '').split()[2]):.0f}"
    desk.until(lambda: (mark.get_attribute("d") or "").startswith(middle[:-1]), "it stands in the middle")
    desk.page.evaluate(larger.replace("1.25", "1"))
    desk.pause(0.1)
    over = box_of(desk.page.locator(".softrod-chart"))

    # Back in time the curve is pale from where the body is; values are read there, too.
    desk.tell(commands.GoBack(0.5))
    shown = desk.simulation.time

    def is_pale_from_there() -> bool:
        at, until, whole = charts(desk)[0]["data"]
        known = [t for t, value in zip(at, until, strict=True) if value is not None]
        if not whole:
            return False
        return None not in whole and abs(at[-1] - time) < 1e-2 and abs(known[-1] - shown) < 1e-2

    desk.until(is_pale_from_there, "it is pale ahead")
    desk.page.mouse.move(over["x"] + 0.95 * over["width"], over["y"] + 60.0)
    desk.until(lambda: "joint0.angle, °: " in read.inner_text(), "the values are read there")

    with desk.page.expect_download() as download:
        desk.button("CSV").click()
    with download.value.path().open(newline="") as file:
        header, *rows = csv.reader(file)
    assert header == ["time [s]", "joint0.angle [deg]"]
    assert np.array(rows, float)[-1, 0] == time

    # While nobody sees it, it is not sent.
    desk.show("Play")
    desk.until(lambda: not desk.tab.probe().plots_seen, "the page says that it is not seen")
    desk.show("Measure")
    desk.until(lambda: desk.tab.probe().plots_seen, "and that it is")

    # After a reload the plot is there again, and tables have decimal commas as before.
    desk.control("Decimal commas").check()
    desk.until(
        lambda: (kept := desk.tab.probe().kept) and kept.looks.commas and kept.plots == (ANGLE,),
        "the browser is told to keep both",
    )
    desk.until(lambda: '"commas":true' in desk.page.evaluate(KEPT), "and does")
    desk.open()
    desk.until(lambda: desk.tab.probe().plots == (ANGLE,), "the plot is back")
    desk.show("Measure")
    desk.until(lambda: desk.control("Decimal commas").is_checked(), "and so are the commas")
    with desk.page.expect_download() as download:
        desk.button("CSV").click()
    with download.value.path().open(newline="") as file:
        header, *rows = csv.reader(file, delimiter=";")
    assert header == ["time [s]", "joint0.angle [deg]"]
    assert all("," in cell and "." not in cell for row in rows[1:3] for cell in row)
    desk.button("Remove").click()
    desk.until(lambda: not charts(desk) and not desk.tab.probe().plots, "it is gone")


def test_a_part_of_a_plot_is_fitted_and_has_a_spectrum(open_page: OpenPage) -> None:
    desk = open_page("rod")
    desk.page.keyboard.press("g")
    desk.until(lambda: charts(desk) and len(charts(desk)[0]["data"][0]) > 30, "the plot runs")
    desk.until(lambda: desk.simulation.time > 4.0, "it swings")
    desk.tell(commands.Play(False))
    desk.page.locator(".softrod-chart").scroll_into_view_if_needed()
    over = box_of(desk.page.locator(".softrod-chart"))
    left, right, y = over["x"] + 0.4 * over["width"], over["x"] + 0.9 * over["width"], over["y"] + 60.0
    desk.page.mouse.move(left, y)
    desk.page.mouse.down()
    desk.page.mouse.move(right, y, steps=4)
    desk.page.mouse.up()
    time = desk.simulation.time
    desk.until(lambda: charts(desk)[0]["data"][0][-1] < time - 0.2, "that part alone is sent")
    first, *_, last = charts(desk)[0]["data"][0]
    desk.choose("Analysis", "decaying sine")
    reading = desk.page.locator(".softrod-reading")
    desk.until(lambda: "decay rate" in reading.inner_text(), "it is fitted")
    at, *lines = charts(desk)[0]["data"]
    assert (at[0], at[-1]) == (first, last), "the part is in view as before"
    assert max(abs(a - b) for a, b in zip(lines[0], lines[-1], strict=True)) < 0.5
    desk.choose("Analysis", "spectrum")
    desk.page.get_by_role("img", name="amplitude spectrum of joint0.angle").wait_for()
    assert not charts(desk)
    desk.choose("Analysis", "none")
    desk.until(lambda: charts(desk), "the curve is back")
    desk.page.locator(".softrod-chart").dblclick()
    desk.until(lambda: charts(desk)[0]["data"][0][-1] > time - 0.05, "a double click shows all")


def test_a_plot_over_another_quantity_reads_values_under_the_pointer(open_page: OpenPage) -> None:
    """`tests/app/test_plots.py` has what is offered, of which mass."""
    desk = open_page("rod")
    desk.show("Measure")
    desk.choose("Quantity", "rate")
    desk.choose("Over", "joint0.angle")
    desk.button("New plot").click()
    phase = desk.page.get_by_role("img", name="joint0.rate over joint0.angle")
    phase.wait_for()
    desk.page.locator(".softrod-plot-title").last.scroll_into_view_if_needed()
    box = desk.until(phase.bounding_box, "it has its place")
    assert box is not None
    desk.page.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 0.4 * box["height"])
    read = desk.page.locator(".softrod-phase-values")
    desk.until(lambda: read.is_visible() and "joint0.angle, °: " in read.inner_text(), "it reads")
    desk.page.mouse.move(5.0, 5.0)
    desk.until(lambda: not read.is_visible(), "and stops")


@pytest.mark.parametrize("phone", part_of((False, True), 2))
def test_the_measure_tab_is_found_in_whatever_language_its_name_is(open_page: OpenPage, phone: bool) -> None:
    desk = open_page(size=(390, 844), phone=True) if phone else open_page()
    translate = """() => {
      const tabs = [...document.querySelectorAll("[role=tab]")];
      const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      for (let text = walk.nextNode(); text; text = walk.nextNode()) {
        if (tabs.some(tab => tab.contains(text))) text.data = `${text.data}en`;
      }
      return tabs.map(tab => tab.innerText);
    }"""
    assert "Measureen" in desk.page.evaluate(translate)
    desk.page.keyboard.press("g")
    desk.page.locator(".softrod-chart").wait_for()
