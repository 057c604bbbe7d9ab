"""What a page plots, without a browser: sampling, going back in time, what is sent, and the table."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Iterator
from unittest.mock import MagicMock

import msgspec
import numpy as np
import pytest
import viser
from PIL import Image

import sim
from app.export.plot_picture import plot_png, spectrum_png
from app.features.hands.messages import Pick
from app.features.measure import analysis, plots
from app.features.measure.messages import InView
from app.features.measure.panel import MeasurePanel
from app.features.measure.phase import phase_svg
from app.features.measure.plot_list import ADD
from app.session import commands
from app.session.notices import Notice
from app.session.plots import MAX_PLOTS, Plot, PlotSpec, curve, parse_plot
from app.stage.colors import palette
from app.words import say
from sim.errors import InputError
from tests.app.inside import first_plot, press, uuid_of
from tests.app.pages import SessionPage
from tests.app.panels import Noted, page_of
from tests.app.recording import agrees
from tests.app.whole import WholePage
from tests.sim.builders import spinning


class PlotPage(SessionPage):
    """A session with a plot of its last mass, which is sampled after every frame."""

    def __init__(self, *names: str, over: str = "", scene: sim.Scene | None = None) -> None:
        super().__init__(scene or sim.load_scene("tutorial-3.3"))
        self.plot = Plot(PlotSpec(names or ("mass11.y",), over), self.session.scene)

    def frames(self, count: int, *posts: commands.Command) -> None:
        for command in posts:
            self.session.post(command)
        for _ in range(count):
            super().frames(1)
            self.plot.sample(self.session)


@pytest.fixture
def page() -> PlotPage:
    return PlotPage()


def test_there_is_a_row_for_each_frame_in_which_time_passed(page: PlotPage) -> None:
    page.frames(30)
    rows = page.plot.rows
    assert len(rows) == 30
    assert rows[-1].tolist() == [page.simulation.time, page.simulation.positions[11, 1]]
    assert (np.diff(rows[:, 0]) > 0.0).all()
    page.frames(10, commands.Play(False))
    assert len(page.plot.rows) == 30
    page.frames(1, commands.DoSteps(1))
    assert len(page.plot.rows) == 31


def test_an_angle_goes_on_beyond_half_a_turn_and_begins_anew_with_a_reset() -> None:
    page = PlotPage("spring0.direction", scene=spinning(9.0))
    page.frames(60)
    assert np.ptp(page.plot.rows[:, 1]) == pytest.approx(math.degrees(9.0), rel=0.05)
    page.frames(2, commands.Reset())
    assert abs(page.plot.rows[0, 1]) <= 180.0


def test_back_in_time_what_is_ahead_stays_until_something_else_comes(page: PlotPage) -> None:
    page.frames(60)
    before = page.plot.rows.copy()
    page.frames(3, commands.GoBack(0.5))
    shown = page.simulation.time
    assert np.array_equal(page.plot.rows, before)
    assert page.plot.shown == shown < before[-1, 0]
    values, past = curve(page.plot, 10.0, 200)
    assert values.shape[1] == len(before)
    assert past == int((before[:, 0] <= shown).sum()) < len(before)
    assert len(page.plot.window(10.0)) == past, "what is read off ends there"
    page.frames(1, commands.GoForward())
    assert curve(page.plot, 10.0, 200).past == past + 1
    # Half of the time may be ahead, and of a short time all is near.
    rows, there = page.plot.view(0.4)
    assert rows[there - 1, 0] == page.plot.shown
    assert rows[-1, 0] == pytest.approx(page.plot.shown + 0.2, abs=0.02)
    assert rows[0, 0] == pytest.approx(page.plot.shown - 0.2, abs=0.02)
    page.frames(1, commands.GoBack())
    page.frames(5, commands.SetValue("gravity", 100.0), commands.Play(True))
    rows = page.plot.rows
    assert (np.diff(rows[:, 0]) > 0.0).all()
    assert rows[-1, 0] == page.simulation.time < before[-1, 0]
    kept = int((before[:, 0] <= shown).sum())
    assert np.array_equal(rows[:kept], before[:kept])
    assert len(rows) <= kept + 5


@pytest.mark.parametrize("command", [commands.Reset(), commands.Open(sim.load_scene("tutorial-3.3"))])
def test_a_reset_and_another_scene_begin_anew(page: PlotPage, command: commands.Command) -> None:
    page.frames(60)
    page.frames(2, command)
    assert len(page.plot.rows) <= 2
    assert page.plot.rows[-1, 0] == page.simulation.time


def test_what_is_sent_has_every_peak_and_is_little(page: PlotPage) -> None:
    page.frames(1)
    time = np.arange(3000) / 60.0 + 1.0
    values = np.sin(time) + np.where(np.arange(3000) % 997 == 500, 3.0, 0.0)
    for row in zip(time, values, strict=True):
        page.plot.append(row)
    page.plot.shown = float(time[-1])
    drawn = curve(page.plot, 40.0, 100).values
    inside = time > time[-1] - 40.0
    assert len(drawn[0]) <= 2 * 101 + 2
    assert drawn[1].max() == pytest.approx(values[inside].max(), abs=1e-3)
    assert drawn[1].min() == pytest.approx(values[inside].min(), abs=1e-3)
    assert (drawn[1] > 1.5).sum() == (values[inside] > 1.5).sum() > 1
    smooth = drawn[1] < 1.5
    assert np.sin(drawn[0][smooth]) == pytest.approx(drawn[1, smooth], abs=0.01)
    # A frame later the same moments are sent, but for the ends.
    page.plot.append((float(time[-1]) + 1.0 / 60.0, 0.0))
    page.plot.shown += 1.0 / 60.0
    again = curve(page.plot, 40.0, 100).values
    assert len(set(drawn[0]) & set(again[0])) > len(drawn[0]) - 6


def test_the_curve_over_another_quantity_goes_through_moments_that_follow_each_other() -> None:
    page = PlotPage("mass11.vy", over="mass11.y")
    page.frames(1)
    time = np.arange(1, 3001) / 60.0 + 1.0
    for t in time:
        page.plot.append((t, math.cos(t), math.sin(t)))
    page.plot.shown = float(time[-1])
    values, past = curve(page.plot, 40.0, 100)
    assert past == values.shape[1] <= 4 * 100 + 3
    assert np.hypot(*values[1:]) == pytest.approx(np.ones(past), abs=1e-3)
    assert np.diff(values[0])[1:-1] == pytest.approx(np.full(past - 3, 0.1), abs=0.02)


def test_what_is_ahead_is_pale_and_the_axes_have_room_for_their_labels() -> None:
    page = PlotPage("energy.kinetic", "energy.linear", "energy.angular")
    page.frames(60)
    page.frames(1, commands.GoBack(0.5))
    gui, colors = MagicMock(), palette("softrod", dark=False)
    chart, time_chart = gui.add_uplot.return_value, plots.TimeChart(gui, 0.0)
    drawn = curve(page.plot, 10.0, 200)
    time_chart.draw(page.plot, drawn, palette("softrod", dark=True))
    time_chart.draw(page.plot, drawn, colors)
    time, *lines = chart.data
    until, whole = lines[:3], lines[3:]
    assert len(time) == drawn.values.shape[1]
    for one, other, pale, strong in zip(whole, until, chart.series[4:], chart.series[1:4], strict=True):
        assert np.isfinite(one).all()
        assert np.array_equal(one[: drawn.past], other[: drawn.past])
        assert np.isnan(other[drawn.past :]).all()
        assert pale["stroke"] == strong["stroke"]
        assert pale["alpha"] == plots.PALE
        assert "alpha" not in strong
    assert chart.axes[1]["label"] == "energy, kg px²/s²"
    page.frames(30, commands.Play(True))
    time_chart.draw(page.plot, curve(page.plot, 10.0, 200), colors)
    assert len(chart.series) == len(chart.data) == 7, "as before: another number would be another chart"
    assert all(np.isfinite(line).all() for line in chart.data[1:4])
    assert not any(map(len, chart.data[4:])), "nothing is sent twice"


def test_over_another_quantity_a_disc_marks_the_moment_and_what_is_ahead_is_pale() -> None:
    x, y = np.array([0.0, 1.0, 2.0, 3.0]), np.array([[0.0, 1.0, 4.0, 9.0]])
    for past, paths in ((4, [""]), (2, ["softrod-ahead", ""]), (1, ["softrod-ahead"])):
        text = phase_svg(x, y, past, ["red"], ("<x>", "y"), "y over x")
        assert re.findall(r'<path class="(softrod-ahead|)"', text) == paths
        (place,) = re.findall(r'<circle cx="([\d.]+)" cy="([\d.]+)"', text)
        if past > 1:  # where the strong line ends
            assert text.split('<path class="" d="')[1].split('"')[0].endswith(" ".join(place))
        assert "<x>" not in text


class MeasureTab:
    """The Measure tab of a page, in a panel of viser's own."""

    def __init__(self, server: viser.ViserServer) -> None:
        self.page, self.told = SessionPage("rod"), list[Notice]()
        self.noted = Noted(server)
        tab = server.gui.add_tab_group().add_tab("Measure")
        self.seen = page_of(self.page.session, self.noted, notify=self.told.append)
        self.panel = MeasurePanel(self.seen, tab)

    def tick(self) -> None:
        self.seen.serve()
        self.panel.tick()


@pytest.fixture
def measure() -> Iterator[MeasureTab]:
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    yield MeasureTab(server)
    server.stop()


def test_plots_that_nobody_sees_run_on_and_are_not_sent(measure: MeasureTab) -> None:
    page, panel, noted = measure.page, measure.panel, measure.noted
    panel.plot_angle()
    panel.tick()
    (chart,) = noted.charts
    assert np.isfinite(chart.data[1]).all(), "its line is strong although nothing moves"
    # Another number of lines is another chart.
    noted.made["Quantity"].value = "rate"
    press(noted.made[""], say(ADD))
    measure.seen.serve()
    _, chart = noted.charts
    assert len(chart.data) == len(chart.series) == 5
    assert len(set(map(len, chart.data))) == 1
    panel.plots.looked_at = False
    before = chart.data
    for _ in range(30):
        page.frames(1)
        panel.tick()
    assert chart.data is before
    panel.plots.looked_at = True
    panel.tick()
    assert chart.data[0][-1] == pytest.approx(page.simulation.time, abs=1e-3)
    assert np.diff(chart.data[0]).max() < 0.03, "no frame is missing"


def test_values_that_are_none_leave_a_gap() -> None:
    page = PlotPage("ghost.distance", "stability.dt_over_limit")
    page.frames(3)
    assert np.isnan(page.plot.rows[:, 1]).all()
    assert page.plot.rows[-1, 2] == pytest.approx(page.simulation.dt / page.session.stability.limit)
    page.frames(3, commands.Compare("rk4", "", 4))
    assert page.session.ghost is not None
    assert page.plot.rows[-1, 1] == page.session.ghost.distance
    assert np.isfinite(curve(page.plot, 10.0, 5).values[2]).all()
    assert page.plot.table().splitlines()[1].split(",")[1] == ""


def test_formulas_are_plotted_with_gaps_beside_what_they_are_made_of() -> None:
    names = ("mass11.y - mass0.y", "1 / (mass0.x - mass0.x) * mass0.x^2", "mass11.y")
    page = PlotPage(*names)
    page.frames(5)
    (_, height, gap, y), top = page.plot.rows[-1], page.simulation.positions[0, 1]
    assert height == y - top
    assert math.isnan(gap)
    assert page.plot.units == ("px",)
    assert page.plot.turned == (True,), "as its mass"
    assert PlotPage("-mass11.y").plot.turned == (False,), "a height grows upwards"
    assert page.plot.table().splitlines()[1].split(",")[2] == ""
    energies = PlotPage("energy.kinetic / mass1.mass", "stability.dt_over_limit * 100")
    energies.frames(5)
    assert energies.plot.wants_energy
    kinetic, share = energies.plot.rows[-1, 1:]
    assert kinetic == energies.simulation.energy().kinetic / energies.simulation.scene.masses[1].mass
    assert share == 100.0 * energies.simulation.dt / energies.session.stability.limit


@pytest.mark.parametrize(
    ("text", "names", "over"),
    [
        ("mass1.x, mass3.x", ("mass1.x", "mass3.x"), ""),
        (
            "atan2(mass1.y, mass1.x), mass1.y over body[0,2].x",
            ("atan2(mass1.y, mass1.x)", "mass1.y"),
            "body[0,2].x",
        ),
        ("body[1,2].x,body.y over (mass1.x)", ("body[1,2].x", "body.y"), "(mass1.x)"),
    ],
)
def test_commas_in_brackets_are_a_quantity_s_own(text: str, names: tuple[str, ...], over: str) -> None:
    assert parse_plot(text) == PlotSpec(names, over)
    Plot(parse_plot(text), sim.load_scene("tutorial-3.3"))


def test_a_formula_takes_the_place_of_the_quantity_or_says_below_why_not() -> None:
    page = WholePage("rod")
    page.enter("Formula", "mass1.y + <b>")
    assert "&#x27;&lt;&#x27; has no place in a formula." in page.gui.text()
    page.enter("Formula", "mass1.y + mass1.vy")
    assert "(px) and &#x27;mass1.vy&#x27; (px/s) cannot be added: their units differ." in page.gui.text()
    page.enter("New plot")
    assert not page.tab.probe().plots
    page.enter("Formula", " mass1.y -  mass0.y ")
    assert "cannot be added" not in page.gui.text()
    page.enter("New plot")
    assert page.tab.probe().plots == (PlotSpec(("mass1.y - mass0.y",)),)
    page.enter("Formula", "")
    page.enter("New plot")
    assert len(page.tab.probe().plots) == 2
    # A quantity that is chosen takes its place, and is not hidden by what still stands there.
    page.enter("Formula", "mass1.y - mass0.y")
    page.enter("Quantity", page.gui["Quantity"].options[1])
    assert page.gui["Formula"].value == ""
    page.enter("Formula", "(" * 100_000)
    assert "named in at most 200 letters, and not in 201." in page.gui.text()


def test_energies_add_up_and_leave_the_log_as_it_is() -> None:
    page = PlotPage("energy.total", "energy.residual")
    page.drag(0, 60.0, frames=20)
    page.frames(20, commands.DragEnd())
    assert page.plot.rows[-1, 1] == page.simulation.energy().total
    assert not page.session.follows_energy
    agrees(page)


def test_the_table_has_all_rows_and_units() -> None:
    page = PlotPage("joint0.angle", "joint0.torque", over="mass11.x")
    page.frames(10)
    header, *rows = csv.reader(io.StringIO(page.plot.table()))
    commas = list(csv.reader(io.StringIO(page.plot.table(decimal_comma=True)), delimiter=";"))
    assert commas == [header, *([cell.replace(".", ",") for cell in row] for row in rows)]
    assert header == ["time [s]", "joint0.angle [deg]", "joint0.torque [kg px^2/s^2]", "mass11.x [px]"]
    assert np.array_equal(np.array(rows, float), page.plot.rows)


def test_a_plot_has_room_for_two_units() -> None:
    scene = sim.load_scene("tutorial-3.3")
    assert Plot(PlotSpec(("joint0.angle", "mass0.x", "joint1.angle")), scene).units == ("°", "px")
    with pytest.raises(InputError, match="room for two units"):
        Plot(PlotSpec(("joint0.angle", "mass0.x", "mass0.vx")), scene)
    with pytest.raises(InputError, match="mass 99 does not exist"):
        Plot(PlotSpec(("mass0.x",), "mass99.x"), scene)


def test_a_body_that_ran_away_leaves_finite_values() -> None:
    page = PlotPage("mass11.speed")
    page.frames(90, commands.SetValue("angular_stiffness", 1e8), commands.SetValue("rest_angle", 10.0))
    assert page.simulation.divergence is not None
    drawn = curve(page.plot, 10.0, 50).values
    assert len(drawn[0]) >= 1
    assert all(map(math.isfinite, drawn[0]))


def test_the_lists_of_the_tab_bear_any_text_and_there_is_room_for_four_plots(measure: MeasureTab) -> None:
    page, panel, told = measure.page, measure.panel, measure.told
    panel.tick()
    part, what, over = (measure.noted.made[label] for label in ("Part", "Quantity", "Over"))
    part.value, what.value, over.value = "joint999999", "<b>", "nan"
    press(panel.new)
    press(what, "<b>")
    measure.tick()
    assert "not a quantity" in told[0].text
    assert (part.value, what.value) == ("joint0", "angle")
    for _ in range(3):
        panel.plot_angle()  # twice the same is one plot
    for _ in range(5):
        press(panel.new)
    measure.tick()
    assert len(panel.plots.specs) == MAX_PLOTS
    assert "room for 4 plots" in told[-1].text
    # Another body keeps what it has, too; one without joints keeps nothing.
    for scene, count in ((sim.load_scene("tutorial-3.3"), MAX_PLOTS), (sim.rope(3, joints=False), 0)):
        page.frames(1, commands.Open(scene))
        panel.build()
        assert len(panel.plots.specs) == count
    panel.plot_angle()
    panel.tick()
    assert told[-1].text == "This scene has no joints."


def ring_of(plot: Plot, times: np.ndarray, *columns: np.ndarray) -> None:
    """Have a plot show values as if they had been noted."""
    for row in np.column_stack((times, *columns)).tolist():
        plot.append(row)
    plot.shown = float(times[-1])


def drawn_range(plot: Plot, rows: list[int]) -> float:
    return float(np.ptp(curve(plot, 60.0, 150).values[rows]))


@pytest.mark.parametrize(
    ("name", "value", "noise", "stays"),
    [
        ("mass11.y", 331.2, 3e-11, False),
        ("mass11.y", 331.2, 0.004, False),  # less than a hundredth of a pixel
        ("mass11.y", 0.0, 0.004, False),
        ("mass11.y", 331.2, 0.02, True),
        ("spring0.force", 512.0, 1e-5, False),
        ("spring0.force", 512.0, 1e-2, True),
        ("spring0.force", 0.0, 1e-3, True),
    ],
)
def test_what_a_body_at_rest_still_does_is_a_straight_line(
    name: str, value: float, noise: float, stays: bool
) -> None:
    times = np.linspace(0.0, 50.0, 2000)
    wiggle = value + noise * np.sin(times)
    plot = Plot(PlotSpec((name,)), sim.load_scene("tutorial-3.3"))
    ring_of(plot, times, wiggle)
    assert (drawn_range(plot, [1]) > noise) == stays
    assert stays or drawn_range(plot, [1]) == 0.0
    over = Plot(PlotSpec((name,), over=name), sim.load_scene("tutorial-3.3"))
    ring_of(over, times, wiggle, wiggle)
    x, y = curve(over, 60.0, 150).values[1:]
    svg = phase_svg(x, y[None], len(x), ["red"], ("x", "y"), "a plot")
    low, high, *_ = map(float, re.search(r'data-ends="([^"]*)"', svg)[1].split())  # type: ignore[index]
    assert high - low > 1e-6 * abs(value)
    marks = re.findall(r'text-anchor="end">([^<]*)<', svg)
    assert len(set(marks)) == len(marks) > 1


def test_lines_of_one_axis_are_levelled_together() -> None:
    times = np.linspace(0.0, 50.0, 2000)
    plot = Plot(PlotSpec(("mass10.y", "mass11.y", "mass3.vx")), sim.load_scene("tutorial-3.3"))
    ring_of(plot, times, 300.0 + 1e-12 * np.sin(times), np.full(2000, 300.0 + 1e-12), np.cos(times))
    assert drawn_range(plot, [1, 2]) == 0.0
    assert drawn_range(plot, [3]) > 1.9
    apart = Plot(PlotSpec(("mass10.y", "mass11.y")), sim.load_scene("tutorial-3.3"))
    ring_of(apart, times, np.full(2000, 300.0), np.where(times > 20.0, np.nan, 301.0))
    values = curve(apart, 60.0, 150).values
    assert drawn_range(apart, [1]) == 0.0
    assert set(values[2][np.isfinite(values[2])]) == {301.0}
    assert np.isnan(values[2]).any()


@pytest.mark.parametrize(
    ("names", "over"), [(("joint0.angle", "mass3.y"), ""), (("joint0.torque",), "joint0.angle")]
)
def test_a_plot_is_a_picture(names: tuple[str, ...], over: str) -> None:
    page = PlotPage(*names, over=over, scene=sim.load_scene("rod"))
    page.frames(40)
    colors = plots.colors_of(page.plot, palette("softrod", dark=False))
    data = plot_png(page.plot, curve(page.plot, 10.0, 500), colors, r"Rope <3> for $\frac$")
    with Image.open(io.BytesIO(data)) as image:
        pixels = np.asarray(image.convert("RGB")).reshape(-1, 3)
    found = {tuple(pixel) for pixel in np.unique(pixels, axis=0).tolist()}
    assert (255, 255, 255) in found, "it is on white"
    for color in colors:
        assert tuple(bytes.fromhex(color.removeprefix("#"))) in found, "each line has its colour"


def growing(names: tuple[str, ...], over: str = "", y_down: bool = True) -> Plot:
    """A plot whose first quantity grows from 100 to 300."""
    scene = sim.load_scene("tutorial-3.3")
    view = msgspec.structs.replace(scene.view, y_down=y_down)
    plot = Plot(PlotSpec(names, over), msgspec.structs.replace(scene, view=view))
    times = np.linspace(0.0, 9.0, 500)
    others = [np.linspace(0.0, 1.0, 500)] * (len(plot.quantities) - 1)
    ring_of(plot, times, np.linspace(100.0, 300.0, 500), *others)
    return plot


@pytest.mark.parametrize(
    ("names", "y_down", "turned"),
    [
        (("mass3.y",), True, (True,)),
        (("mass3.y",), False, (False,)),
        (("mass3.vy", "mass3.vx"), True, (True,)),
        (("spring0.length", "mass3.y"), True, (True,)),
        (("mass3.x", "mass3.speed"), True, (False, False)),
        (("joint0.angle", "mass3.y"), True, (False, True)),
    ],
)
def test_an_axis_with_a_y_grows_downwards_where_the_scene_s_does(
    names: tuple[str, ...], y_down: bool, turned: tuple[bool, ...]
) -> None:
    plot = growing(names, y_down=y_down)
    assert plot.turned == turned
    gui = MagicMock()
    plots.TimeChart(gui, 0.0).draw(plot, curve(plot, 10.0, 200), palette("softrod", dark=False))
    options = gui.add_uplot.call_args.kwargs
    assert tuple(options["scales"][f"y{i}"].get("dir") == -1 for i in range(len(turned))) == turned
    assert tuple(axis["label"].endswith(", downwards") for axis in options["axes"][1:]) == turned


@pytest.mark.parametrize(("name", "y_down"), [("mass3.y", True), ("mass3.y", False), ("mass3.x", True)])
def test_a_curve_goes_down_with_its_mass_over_another_quantity_and_in_a_picture(
    name: str, y_down: bool
) -> None:
    goes_down = name == "mass3.y" and y_down
    over = growing((name,), over="joint0.angle", y_down=y_down)
    svg = plots.draw_over_another(over, curve(over, 10.0, 200), ["#123456"])
    (line,) = re.findall(r'<path class="" d="([^"]*)"', svg)
    heights = [float(point.split()[1]) for point in re.split("[ML]", line)[1:]]
    assert (heights[-1] > heights[0]) == goes_down  # SVG counts downwards
    assert (", downwards" in svg) == goes_down
    # What the pointer reads, and the marks.
    (ends,) = re.findall(r'data-ends="([^"]*)"', svg)
    *_, bottom, top = map(float, ends.split())
    assert (bottom > top) == goes_down
    marks = re.findall(r'y="([\d.]+)" text-anchor="end">([^<]*)<', svg)
    at = {float(text): float(y) for y, text in marks}
    assert (at[max(at)] > at[min(at)]) == goes_down
    for plot in (over, growing((name,), y_down=y_down)):
        with Image.open(io.BytesIO(plot_png(plot, curve(plot, 10.0, 500), ["#ff00ff"], "A"))) as image:
            pixels = np.asarray(image.convert("RGB"), int)
        rows, columns = np.nonzero((pixels == (255, 0, 255)).all(2))
        assert (rows[columns.argmax()] > rows[columns.argmin()]) == goes_down


def test_the_limit_that_is_found_while_the_clock_stands_is_plotted() -> None:
    page = PlotPage("stability.dt_over_limit")
    page.frames(1, commands.SetChoice("method", "symplectic_euler"), commands.Play(False))
    page.frames(40)
    limit = page.session.stability.limit
    assert np.isfinite(limit)
    assert page.plot.rows[-1, 1] == pytest.approx(page.simulation.dt / limit)


def test_marks_of_many_digits_stand_beside_the_label_of_their_axis() -> None:
    x = np.linspace(0.0, 1.0, 50)
    for size, most in ((1.0, 60.0), (1e6, 110.0)):
        svg = phase_svg(x, size * (1.0 + x)[None], 50, ["red"], ("x", "y"), "a plot")
        marks = re.findall(r'<text x="([\d.]+)" y="[\d.]+" text-anchor="end">([^<]*)<', svg)
        end, longest = float(marks[0][0]), max(len(text) for _, text in marks)
        # A digit of the page's letters is 7 wide, and the label reaches to 16.
        assert end - 7.0 * longest >= 16.0
        assert end < most
        (edges,) = re.findall(r'data-edges="([\d.]+) ', svg)
        assert float(edges) == end + 5.0


def test_a_plot_of_a_lesson_says_nothing_where_nothing_swings() -> None:
    page = PlotPage("mass11.x")
    page.frames(3)
    assert "no regular swing" in plots.reading(page.plot, 10.0)
    assert plots.reading(page.plot, 10.0, None).endswith("></div>")


def test_a_clicked_mass_and_its_springs_can_be_plotted_beside_the_joint() -> None:
    page = WholePage("rod")
    for mass in (0, 999_999):  # a page can name any mass
        page.shown(Pick(mass))
        assert page.gui["Part"].options[:3] == ("joint0", "mass0", "spring0")
    page.enter("Part", "joint0")
    page.enter("Quantity", "rate")
    page.enter("Over", "joint0.angle")
    page.enter("New plot")
    assert "joint0.rate over joint0.angle" in page.gui.text()


def swinging(names: tuple[str, ...] = ("mass11.y",), over: str = "") -> Plot:
    """A plot of 20 s of a decaying sine of 1.5 s, with others of twice its size and so on."""
    plot = Plot(PlotSpec(names, over), sim.load_scene("tutorial-3.3"))
    times = np.arange(1200) / 60.0
    values = 30.0 * np.exp(-0.05 * times) * np.sin(2.0 * np.pi * times / 1.5)
    ring_of(plot, times, *(300.0 + (1 + i) * values for i in range(len(plot.quantities))))
    return plot


def test_a_fitted_curve_is_drawn_over_what_is_in_view_and_its_numbers_have_errors_and_units() -> None:
    plot = swinging(("mass11.y", "mass10.y"))
    one, two = analysis.fits_of(plot, (4.0, 10.0), "decaying sine")
    assert one.ends == (4.0, 10.0)
    drawn = curve(plot, 20.0, 150)
    gui, colors = MagicMock(), palette("softrod", dark=False)
    plots.TimeChart(gui, 0.0).draw(plot, drawn, colors, (one, two))
    data, lines = gui.add_uplot.call_args.args
    assert len(data) == len(lines) == 1 + 2 + 2 + 2
    inside = (drawn.values[0] >= 4.0) & (drawn.values[0] <= 10.0)
    for fit, whole in zip(data[5:], data[1:3], strict=True):
        assert fit[inside] == pytest.approx(whole[inside], abs=0.2)
        assert np.isnan(fit[~inside]).all()
    assert lines[5]["scale"] == lines[1]["scale"]
    text = analysis.fits_text(plot, (one, two))
    assert "mass11.y from 4 s:<br>offset <b>300 px</b><br>amplitude" in text
    assert "period <b>1.5 s</b>" in text
    assert "decay rate <b>0.05 1/s</b>" in text
    assert "less than a period" not in text
    assert "less than a period" in analysis.fits_text(plot, analysis.fits_of(plot, (4.0, 5.0), "sine"))
    slope = analysis.fits_text(plot, analysis.fits_of(plot, 20.0, "line"))
    assert re.search(r"slope <b>-?[\d.]+ ± [\d.]+ px/s</b>", slope)
    with Image.open(
        io.BytesIO(plot_png(plot, drawn, ["#ff0000", "#00ff00"], "A", (one.at, two.at)))
    ) as image:
        assert image.size[0] > 1000


def test_a_line_is_fitted_over_another_quantity_and_has_the_unit_of_both() -> None:
    plot = swinging(("spring0.force",), over="mass11.y")
    (fit,) = analysis.fits_of(plot, 20.0, "line")
    text = analysis.fits_text(plot, (fit,))
    assert "slope <b>0.5 (kg px/s²)/px</b>" in text
    svg = plots.draw_over_another(plot, curve(plot, 20.0, 150), ["#123456"], (fit,))
    assert svg.count('class="softrod-fit"') == 1
    assert not set(analysis.OVER_ANOTHER) & {"sine", "spectrum"}


@pytest.mark.parametrize(
    ("value", "error", "said"),
    [
        (9.8124, 0.0234, "9.812 ± 0.023"), (-0.5, 3.0, "-0.5 ± 3.0"), (12345.6, 120.0, "12350 ± 120"),
        (1.5, 1e-12, "1.5"), (0.0, 0.0, "0"), (3.2e-9, 4e-11, "3.200e-09 ± 4.0e-11"),
    ],
)  # fmt: skip
def test_a_number_has_as_many_digits_as_its_error(value: float, error: float, said: str) -> None:
    assert analysis.with_error(value, error) == said


def test_why_nothing_is_fitted_is_said_below_the_plot() -> None:
    plot = growing(("mass3.y",))
    assert "an exponential does not converge" in analysis.fits_text(
        plot, analysis.fits_of(plot, 10.0, "exponential")
    )
    short = analysis.fits_of(plot, (1.0, 1.05), "line")
    assert "mass3.y: a line takes 5 points at least, and 3 are in view" in analysis.fits_text(plot, short)
    assert np.isnan(short[0].at(np.arange(3.0))).all()


def test_a_spectrum_has_its_peaks_labelled_and_is_of_complete_frames() -> None:
    plot = swinging(("mass11.y", "mass10.x"))
    drawn = analysis.draw_spectra(plot, 20.0)
    assert "<b>0.6667 Hz</b>" in drawn.text
    assert drawn.peaks[0][2] == "0.6667 Hz"
    assert drawn.amplitudes[1].max() == pytest.approx(2.0 * drawn.amplitudes[0].max(), rel=1e-3)
    assert len(drawn.frequencies) <= analysis.POINTS
    gui = MagicMock()
    plots.SpectrumChart(gui, 0.0).draw(plot, drawn, palette("softrod", dark=False))
    svg = gui.add_html.call_args.args[0]
    assert ">0.6667 Hz</text>" in svg
    assert "<circle" not in svg
    assert 'data-right="frequency, Hz"' in svg
    still = Plot(PlotSpec(("mass11.y",)), sim.load_scene("tutorial-3.3"))
    ring_of(still, np.arange(60) / 60.0, np.full(60, 3.0))
    nothing = analysis.draw_spectra(still, 20.0)
    assert "no spectrum" in nothing.text
    plots.SpectrumChart(gui, 0.0).draw(still, nothing, palette("softrod", dark=False))
    picture = spectrum_png(plot, *drawn[:3], ["#ff0000", "#00ff00"], "A $")
    with Image.open(io.BytesIO(picture)) as image:
        assert image.size[0] > 1000


def test_what_is_zoomed_to_is_sent_finely_and_analysed_until_all_is_shown_or_a_reset(
    measure: MeasureTab,
) -> None:
    page, panel = measure.page, measure.panel
    panel.plot_angle()
    for _ in range(90):
        page.frames(1)
        panel.tick()
    shown = first_plot(panel)
    assert shown.chart.handle is not None
    identity = uuid_of(shown.chart.handle)
    panel.plots.zoom("nothing", (0.0, 1.0))
    assert shown.zoom is None
    panel.plots.zoom(identity, (0.3, 0.8))
    times = shown.chart.handle.data[0]
    assert times[0] == pytest.approx(0.3, abs=0.03)
    assert times[-1] == pytest.approx(0.8, abs=0.03)
    panel.plots.zoom(identity, None)
    assert shown.chart.handle.data[0][-1] == pytest.approx(page.simulation.time, abs=0.01)
    panel.plots.zoom(identity, (0.3, 0.8))
    page.frames(1, commands.Reset())
    panel.tick()
    assert shown.zoom is None
    assert uuid_of(shown.chart.handle) != identity, "the page's own zoom is gone, too"


def test_the_kind_of_analysis_is_chosen_for_each_plot_and_any_text_is_borne() -> None:
    page = WholePage("rod")
    page.enter("New plot")
    for kind in ("<b>", "spectrum"):
        page.enter("Analysis", kind)
    page.frames(60)
    assert "amplitude spectrum of joint0.angle" in page.gui.text()
    page.enter("Analysis", "none")
    page.shown(InView("nothing", (1.0, 0.5)))
    page.enter("Time span", "1 h")
    assert "amplitude spectrum" not in page.gui.text()
