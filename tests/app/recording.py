"""Sessions that do a bit of everything, and logs done again, for the tests of logs and of what is past."""

from __future__ import annotations

import json

import msgspec
import numpy as np

import sim
from app.session import commands
from app.session.log import decode_log
from app.session.replay import Player
from tests.app.pages import SessionPage, answered


def log_of(page: SessionPage) -> bytes:
    """The log of a page until now."""
    return answered(page.session, page.session.log_file)


def busy_page(scene: sim.Scene, play_on: bool = True) -> SessionPage:
    """A page whose user drags, presses keys, moves sliders, looks back and goes on, for some seconds."""
    page = SessionPage(scene)
    page.frames(10)
    x, y = page.simulation.positions[0]
    page.frames(1, commands.DragStart(0, x, y))
    for i in range(12):
        page.frames(2, commands.Point(x + 4.0 * i, y - 2.0 * i))
    page.frames(5, commands.DragEnd())
    for _ in range(20):
        page.frames(1, commands.HoldKeys(frozenset({"up", "right"})))
    page.frames(3, commands.HoldKeys(frozenset()))
    page.frames(20, commands.SetValue("gravity", 600.0))
    last = len(scene.masses) - 1
    x, y = page.simulation.positions[last]
    page.frames(8, commands.DragStart(last, x, y), commands.Point(x + 20.0, y - 30.0))
    page.frames(10, commands.DragEnd())
    page.frames(2, commands.DoSteps(5))
    for back in (0.2, 0.6, 0.1):
        page.frames(1, commands.GoBack(back))
    page.frames(1, commands.SetValue("linear_damping", 60.0))
    if play_on:
        page.frames(60, commands.Play(True), commands.Speed(0.5))
    return page


def replayed(data: bytes) -> Player:
    """The log done again to its end."""
    recorded = decode_log(data, "log")
    player = Player(recorded, sim.Simulation(recorded.scene))
    while not player.ended:
        player.do()
    return player


def agrees(page: SessionPage) -> Player:
    """Whether a page's log leads to where the page is, to the last bit; the replay."""
    player = replayed(log_of(page))
    assert player.agrees, player.verdict
    shown = page.simulation
    assert np.array_equal(player.simulation.positions, shown.positions)
    assert np.array_equal(player.simulation.velocities, shown.velocities)
    assert player.simulation.time == shown.time
    assert player.simulation.scene == shown.scene
    return player


def lines_of(data: bytes) -> list[dict[str, object]]:
    return [json.loads(line) for line in data.splitlines()]


def joined(lines: list[dict[str, object]]) -> bytes:
    return b"\n".join(map(msgspec.json.encode, lines))


def perturbed(data: bytes) -> bytes:
    """The log as another machine might have written it: its second check is off by a little."""
    lines = lines_of(data)
    check = [line for line in lines if line.get("do") == "check"][1]
    check["digest"] = "0" * 32
    at = check["at"]
    assert isinstance(at, list)
    at[3][0] += 0.125
    lines[0]["machine"] = {"kind": "abacus", "cpu": "beads", "numba": "1"}
    return joined(lines)
