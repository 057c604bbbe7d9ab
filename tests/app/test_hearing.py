"""Which values of a plot are heard, and between which bounds."""

from __future__ import annotations

import numpy as np
import pytest

import sim
from app.features.hands.messages import Pick
from app.features.measure.hearing import NOTES, melody
from app.features.measure.messages import Melody, Tones
from app.session import commands
from app.session.plots import Plot, PlotSpec
from app.wire.from_page import Perform
from tests.app.whole import WholePage


def plot_of(names: tuple[str, ...], rows: np.ndarray, over: str = "", scene: str = "rod") -> Plot:
    """A plot with given rows: times, then a value of each quantity."""
    plot = Plot(PlotSpec(names, over), sim.load_scene(scene))
    for row in rows.tolist():
        plot.append(row)
    plot.shown = float(rows[-1, 0])
    return plot


def test_lines_of_one_axis_share_its_bounds_and_what_grows_downwards_is_high_below() -> None:
    time = np.linspace(0.0, 10.0, 601)
    rows = np.column_stack((time, np.sin(time), 5.0 + np.cos(time)))
    heard = melody(plot_of(("mass1.x", "mass2.x"), rows), 20.0, "a")
    assert (heard.plot, heard.way, len(heard.lines)) == ("a", "time", 2)
    assert len(heard.moments) == len(heard.lines[0].values) == NOTES
    for line in heard.lines:
        assert (line.bottom, line.top) == pytest.approx((-1.0, 6.0), abs=1e-3)
    for value, moment in zip(heard.lines[0].values, heard.moments, strict=True):
        assert value == pytest.approx(np.sin(moment), abs=0.02)
    # In this scene y grows downwards, and so does the curve.
    (line,) = melody(plot_of(("mass1.y",), rows[:, :2]), 20.0, "a").lines
    assert line.bottom > line.top


def test_an_angle_goes_round_if_it_passes_more_than_a_turn_or_jumps() -> None:
    time = np.linspace(0.0, 10.0, 601)

    def turns(name: str, values: np.ndarray) -> bool:
        return melody(plot_of((name,), np.column_stack((time, values))), 20.0, "a").lines[0].turns

    assert not turns("joint0.angle", 30.0 * np.sin(time))
    assert turns("joint0.angle", 100.0 * time)
    assert turns("joint0.wrapped_angle", np.mod(60.0 * time, 360.0) - 180.0)
    assert not turns("mass1.x", 100.0 * time)
    jumping = np.mod(60.0 * time, 360.0) - 180.0
    (line,) = melody(plot_of(("joint0.wrapped_angle",), np.column_stack((time, jumping))), 20.0, "a").lines
    assert set(line.values) <= {float(f"{value:.6g}") for value in jumping}


def test_gaps_a_plot_without_values_and_one_over_another_quantity() -> None:
    rows = np.array([[0.0, 1.0, 5.0], [1.0, np.nan, 6.0], [2.0, 3.0, 9.0]])
    heard = melody(plot_of(("mass1.x",), rows, over="mass1.vx"), 20.0, "a")
    assert heard.way == "path"
    assert [line.values for line in heard.lines] == [(1.0, None, 3.0), (5.0, 6.0, 9.0)]
    assert [(line.bottom, line.top) for line in heard.lines] == [(1.0, 3.0), (5.0, 9.0)]
    empty = Plot(PlotSpec(("mass1.x",)), sim.load_scene("rod"))
    assert melody(empty, 10.0, "a").lines == ()


def test_a_key_plays_the_plots_in_turn_also_of_a_paused_body_and_hears_one_live() -> None:
    page = WholePage("rod")
    page.frames(2, Perform("hear"))
    assert page.client.mail.last(Melody).plot == ""  # there is none
    page.frames(2, Perform("plot"))
    page.frames(60)
    page.frames(3, commands.Play(False), Perform("hear"))
    first = page.client.mail.last(Melody)
    assert first.plot
    assert first.lines[0].name == "joint0.angle"
    assert first.lines[0].values[-1] == pytest.approx(page.simulation.angles[0], rel=1e-4)
    page.shown(Pick(3))
    page.enter("New plot")

    def heard() -> tuple[str, int, int]:
        told = page.client.mail.last(Melody)
        return told.lines[0].name, told.number, told.count

    page.frames(2, Perform("hear"))
    assert heard() == ("mass3.x", 2, 2)
    page.frames(620)
    page.frames(2, Perform("hear"))  # later, the same again
    assert heard() == ("mass3.x", 2, 2)
    page.frames(240)  # it was played, and talked about
    page.frames(2, Perform("hear"))
    assert heard() == ("joint0.angle", 1, 2)
    [one for one in page.gui.there if one.kind == "button_group"][-1].enter("Hear")
    page.frames(5)
    assert heard() == ("mass3.x", 2, 2)
    page.frames(620)
    page.frames(2, Perform("hear"))  # that which a button played
    assert heard() == ("mass3.x", 2, 2)
    page.frames(2, Perform("hear"))

    page.frames(2, commands.Play(True), Perform("hearLive"))
    page.frames(10)
    told = page.client.mail.last(Tones)
    assert told.plot == page.client.mail.last(Melody).plot
    assert told.lines[0].values[0] == pytest.approx(page.simulation.angles[0], rel=1e-4)
    assert told.time == page.simulation.time
    page.frames(2, Perform("hearLive"))
    assert page.client.mail.last(Tones).plot == ""


def test_a_spectrum_is_heard_from_its_lowest_frequency() -> None:
    page = WholePage("pendulum")
    page.enter("New plot")
    page.frames(300)
    page.enter("Analysis", "spectrum")
    page.frames(2, Perform("hear"))
    heard = page.client.mail.last(Melody)
    assert heard.way == "frequency"
    assert heard.moments[0] == 0.0
    assert len(heard.moments) == len(heard.lines[0].values) <= NOTES
    assert heard.lines[0].bottom == 0.0
    top = max(value for value in heard.lines[0].values if value is not None)
    assert heard.lines[0].top == pytest.approx(top, rel=1e-4)


def test_only_one_plot_is_heard_while_the_body_moves() -> None:
    page = WholePage("rod")
    page.frames(2, Perform("plot"))
    page.enter("New plot")
    switches = [one for one in page.gui.there if one.kind == "checkbox" and "Hear while" in one.label]
    assert len(switches) == 2
    switches[0].enter(True)
    page.frames(5)
    switches[1].enter(True)
    page.frames(5)
    assert [one.value for one in switches] == [False, True]
    page.client.mail.sent.clear()
    buttons = [one for one in page.gui.there if one.kind == "button_group"]
    buttons[-1].enter("Remove")
    page.frames(5)
    assert page.client.mail.last(Tones).plot == ""
