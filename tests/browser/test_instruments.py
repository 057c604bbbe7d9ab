"""What is measured on the canvas: arrows, traces, coordinates, and the box of instruments."""

from __future__ import annotations

import re

import numpy as np
from playwright.sync_api import Locator

import sim
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, Point


def middle(element: Locator) -> Point:
    box = element.bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def named(desk: Desk, kind: str) -> str:
    """What an instrument on the canvas says that it reads; empty if it is in the box."""
    found = desk.page.locator(f".softrod-instrument[aria-label^={kind}]")
    return (found.get_attribute("aria-label") or "") if found.count() else ""


def numbers(text: str) -> list[float]:
    return [float(part) for part in re.findall(r"-?\d+\.\d+", text.replace("−", "-"))]


def grips(desk: Desk, kind: str) -> Locator:
    return desk.page.locator(f".softrod-instrument[aria-label^={kind}] .softrod-grip")


def drag(desk: Desk, start: Point, end: Point) -> None:
    """By the mouse, at once."""
    desk.page.mouse.move(*start)
    desk.page.mouse.down()
    desk.page.mouse.move(*end, steps=3)
    desk.page.mouse.up()


def tool(desk: Desk, name: str) -> Locator:
    return desk.page.locator(".softrod-box-tools button").filter(has_text=name)


def arrow_tips(desk: Desk, kind: str) -> list[str]:
    """The outlines of a kind of arrows over the body."""
    paths = desk.page.locator(f".softrod-arrow.softrod-{kind}").all()
    return [path.get_attribute("d") or "" for path in paths]


def test_a_ruler_is_dragged_out_measures_two_masses_and_is_thrown_back(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    desk.page.locator(".softrod-box-lid").click()
    drag(desk, middle(tool(desk, "Ruler")), (300.0, 200.0))
    assert "Ruler" in named(desk, "Ruler")
    one, two = grips(desk, "Ruler").nth(0), grips(desk, "Ruler").nth(1)
    # A grip is 24 px beyond its end; the end goes onto the mass from 10 px away.
    (x, y), first = desk.place(2), middle(one)
    drag(desk, first, (x - 24.0 + 8.0, y + 6.0))
    assert "At mass 2" in (one.get_attribute("aria-label") or "")
    (x, y), (gx, gy) = desk.place(9), middle(two)
    (ax, ay) = desk.place(2)
    way = np.array((gx - ax, gy - ay)) / np.hypot(gx - ax, gy - ay)
    drag(desk, (gx, gy), (x + 24.0 * way[0] + 5.0, y + 24.0 * way[1] + 5.0))
    assert "At mass 9" in (two.get_attribute("aria-label") or "")

    def is_right() -> bool:
        dx, dy = desk.simulation.positions[9] - desk.simulation.positions[2]
        return np.allclose(numbers(named(desk, "Ruler")), (np.hypot(dx, dy), dx, dy), atol=0.06)

    desk.until(is_right, "it reads the distance of the masses")
    # It follows them, does not take them from the pointer, and stays where it is in the scene.
    desk.tell(commands.SetValue("rest_angle", 25.0), commands.DoSteps(60))
    desk.until(is_right, "it follows the masses")
    x, y = desk.place(9)
    desk.page.mouse.move(x, y)
    desk.page.mouse.down()
    desk.page.mouse.move(x + 6.0, y)
    desk.until(lambda: desk.session.hands.masses == (9,), "the mass under its end is taken hold of")
    desk.page.mouse.up()
    desk.until(lambda: not desk.session.hands.masses, "and let go")
    desk.page.reload()
    desk.page.wait_for_function("window.__softrod?.fitted() > 0")
    desk.until(lambda: named(desk, "Ruler"), "it is there again after a reload")
    desk.page.locator(".softrod-box-lid").click()
    body = grips(desk, "Ruler").locator("xpath=../*[contains(@class, 'softrod-instrument-body')]").first
    desk.rest(2)
    drag(desk, middle(body), middle(tool(desk, "Ruler")))
    desk.until(lambda: not named(desk, "Ruler"), "it is back in the box")


def test_a_light_gate_times_a_pendulum_between_frames(open_page: OpenPage) -> None:
    desk = open_page("pendulum")
    desk.button("Instruments").click()
    tool(desk, "Light gate").click()
    pivot = desk.place(0)
    # Upright below the pivot, as far as the pendulum reaches and beyond.
    for grip, y in ((1, pivot[1] + 420.0), (0, pivot[1] + 40.0)):
        drag(desk, middle(grips(desk, "Light").nth(grip)), (pivot[0], y))
    desk.until(lambda: "Δt" in named(desk, "Light"), "it has crossed twice")
    desk.tell(commands.Play(False))
    time, interval, *_ = numbers(named(desk, "Light"))
    scene = sim.load_scene("pendulum")
    swing = sim.Simulation(scene).record(time + 1.0, "mass1.x")
    offset = swing["mass1.x"] - scene.masses[0].position[0]
    at = np.flatnonzero(np.diff(np.sign(offset)))
    crossed = swing.time[at] + np.diff(swing.time)[at] * offset[at] / (offset[at] - offset[at + 1])
    nearest = int(np.abs(crossed - time).argmin())
    # The gate stands a pixel or so beside the pivot, and the second crossing comes from the other side.
    assert abs(crossed[nearest] - time) < 0.01
    assert abs(np.diff(crossed)[nearest - 1] - interval) < 0.02
    tool(desk, "Light gate").click()
    assert not named(desk, "Light")


def test_a_finger_drags_a_ruler_out_of_the_box_and_moves_its_end(open_page: OpenPage) -> None:
    desk = open_page(size=(390, 844), phone=True)
    touch = desk.context.new_cdp_session(desk.page)

    def send(kind: str, *points: Point) -> None:
        places = [{"x": x, "y": y} for x, y in points]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": places})

    def swipe(start: Point, end: Point) -> None:
        send("touchStart", start)
        for part in (0.3, 0.7, 1.0):
            send("touchMove", (start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])))
        send("touchEnd")

    desk.page.locator(".softrod-box-lid").tap()
    camera = desk.camera()
    swipe(middle(tool(desk, "Ruler")), (190.0, 220.0))
    desk.until(lambda: named(desk, "Ruler"), "it is on the canvas")
    before = numbers(named(desk, "Ruler"))[0]
    x, y = middle(grips(desk, "Ruler").nth(1))
    swipe((x + 6.0, y + 6.0), (x + 46.0, y + 6.0))
    desk.until(lambda: numbers(named(desk, "Ruler"))[0] > before + 10.0, "its end goes with the finger")
    assert desk.camera().same(camera), "and the view does not"


def test_arrows_are_at_their_masses_and_gone_with_their_switch(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.SetValue("rest_angle", 25.0), commands.DoSteps(60), commands.Play(False))
    desk.show("Measure")
    assert not desk.page.locator(".softrod-arrows").count()
    for name in ("Forces", "Torques"):
        desk.control(name).click()
    desk.until(lambda: len("".join(arrow_tips(desk, "torques"))) > 100, "there are arrows")
    forces = desk.simulation.loads.forces
    largest = np.hypot(*forces.T).max()
    words = desk.page.locator(".softrod-arrow-words.softrod-forces")

    def is_right() -> bool:
        unit = float((words.text_content() or "").split()[1])
        path = arrow_tips(desk, "forces")[1]
        mass = int(np.argmax(np.abs(forces[1:]).max(axis=1))) + 1
        x, y = desk.place(mass)
        starts = re.findall(r"M(-?[\d.]+) (-?[\d.]+)L", path)
        near = [float(np.hypot(float(px) - x, float(py) - y)) for px, py in starts]
        return 0.3 <= largest / unit <= 1.0 and min(near, default=99.0) < 1.0

    desk.until(is_right, "the largest force has an arrow that begins at its mass, in a scale that suits it")
    assert "kg px/s²" in (words.text_content() or "")
    for name in ("Forces", "Torques"):
        desk.control(name).click()
    desk.until(lambda: not desk.page.locator(".softrod-arrows").count(), "they are gone")


def test_a_clicked_mass_is_traced_and_read_out(open_page: OpenPage) -> None:
    desk = open_page()
    desk.tell(commands.Play(False))
    desk.show("Measure")
    desk.page.mouse.click(*desk.place(11))
    desk.control("Trace the chosen mass").click()
    desk.control("Coordinates").click()
    label = desk.page.locator(".softrod-coordinates text").first
    x, y = desk.simulation.positions[11]
    desk.until(lambda: label.text_content() == f"mass 11: {x:.1f}, {y:.1f} px", "its place is told")
    desk.tell(commands.SetValue("rest_angle", 30.0), commands.Play(True))
    line = (
        "() => [...document.querySelectorAll('.softrod-trace path')].map((p) => p.getAttribute('d')).join('')"
    )
    desk.until(lambda: len(desk.page.evaluate(line)) > 100, "it leaves a line")
    desk.tell(commands.Reset(), commands.Play(False))
    desk.until(lambda: len(desk.page.evaluate(line)) < 60, "which is gone after a reset")
    desk.button("Clear the traces").click()
    desk.until(lambda: not desk.page.locator(".softrod-trace").count(), "and no mass is traced any more")


def test_the_stroboscope_leaves_images_on_the_canvas_and_in_print(open_page: OpenPage) -> None:
    desk = open_page("pendulum")
    desk.show("Measure")
    desk.choose("Stroboscope", "every 0.1 s")
    images = desk.page.locator(".softrod-strobe > g > g")
    desk.until(lambda: images.count() > 5, "there are some")
    desk.tell(commands.Play(False))
    desk.rest(3)
    rings = [images.nth(i).locator(".softrod-strobe-masses") for i in range(images.count())]
    # The box of each goes from the pivot to the swinging mass.
    x, y = desk.place(0)
    for ring in rings[::3]:
        box = ring.bounding_box()
        assert box is not None
        assert box["x"] - 2.0 < x < box["x"] + box["width"] + 2.0
        assert box["y"] - 2.0 < y < box["y"] + 25.0
    desk.page.emulate_media(media="print")
    assert images.first.is_visible()
    desk.page.emulate_media(media="screen")
    count = images.count()
    desk.tell(commands.GoBack(0.5))
    desk.until(lambda: images.count() <= count - 4, "later ones are gone")
    desk.choose("Stroboscope", "off")
    desk.until(lambda: not images.count(), "all are gone")
