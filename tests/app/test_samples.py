"""Samples of a plot over hours: the last minute is complete, and what is older has its extremes."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest

import sim
from app.features.measure import plots
from app.session.history import SPAN
from app.session.plots import Plot, PlotSpec, curve
from app.session.samples import LEVEL_ROWS, LEVELS, Samples
from tests.app.inside import room_of

RATE = 20.0
"""Frames a simulated second."""

MOST = 2 * SPAN + 1000
"""Rows of a plot, at most."""


def run_for(seconds: float, *names: str, swing: float = 40.14) -> Plot:
    """A plot of quantities that swing for some time, with a spike after 20 s, and one down after 41 s."""
    plot = Plot(PlotSpec(names or ("mass11.y",)), sim.load_scene("tutorial-3.3"))
    times = np.arange(1, round(RATE * seconds) + 1) / RATE
    values = np.sin(2.0 * np.pi * times / swing)
    values[[round(20 * RATE), round(41 * RATE)]] = 9.0, -7.0
    count = len(plot.quantities)
    for time, value in zip(times.tolist(), values.tolist(), strict=True):
        plot.append((time, *(value * (1 + i) for i in range(count))))
    plot.shown = seconds
    return plot


def test_after_an_hour_the_first_minute_is_there_with_its_extremes_in_few_rows() -> None:
    plot = run_for(3600.0)
    rows = plot.rows
    assert rows[0, 0] < 1.0
    assert (np.diff(rows[:, 0]) > 0.0).all()
    assert np.diff(rows[:, 0]).max() < 40.0
    first = rows[rows[:, 0] <= 60.0]
    assert len(first) >= 4
    assert (first[:, 1].max(), first[:, 1].min()) == (9.0, -7.0)
    assert first[first[:, 1].argmax(), 0] == pytest.approx(20.0, abs=0.1)
    assert np.diff(rows[-SPAN:, 0]) == pytest.approx(1.0 / RATE), "the last frames are complete"
    assert len(rows) <= MOST
    drawn = curve(plot, 3600.0, 150).values
    assert drawn.shape[1] <= 2 * 151 + 2
    assert drawn[1].max() == pytest.approx(9.0, abs=1e-3)
    assert drawn[1].min() == pytest.approx(-7.0, abs=1e-3)


def test_however_long_it_runs_the_memory_is_bounded() -> None:
    samples = Samples(1)
    # A level further takes twice the time: the rows of an older one are put in at once.
    total = SPAN + sum(LEVEL_ROWS * 2**k for k in range(1, 7))
    for i in range(total):
        samples.append((float(i), 0.0))
    assert len(samples) <= SPAN + 7 * (LEVEL_ROWS + 8)
    assert SPAN + LEVELS * (LEVEL_ROWS + 8) <= MOST
    assert room_of(samples) < 16 * (MOST + SPAN)


def test_the_last_level_forgets(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.session.samples.LEVELS", 2)
    samples = Samples(2)
    for i in range(2 * SPAN):
        samples.append((float(i), -float(i), 1.0))
    rows = samples.rows
    assert len(rows) <= SPAN + 2 * LEVEL_ROWS + 24
    assert rows[0, 0] > 1000.0
    assert rows[-1].tolist() == [2.0 * SPAN - 1.0, 1.0 - 2.0 * SPAN, 1.0]
    assert set(samples.frames.tolist()) == {1, 2, 4}
    # Each row stands for so many frames, but for those of a bucket that is not full.
    assert samples.frames.sum() == pytest.approx(2 * SPAN - rows[0, 0], abs=32)


def test_an_abandoned_future_is_dropped_from_thinned_rows_too() -> None:
    samples = Samples(1)
    for i in range(SPAN + 200):
        samples.append((float(i), 0.0))
    samples.drop_after(50.0)
    assert samples.last is not None
    assert 45.0 < samples.last[0] <= 50.0
    samples.append((51.0, 7.0))
    assert samples.rows[-1].tolist() == [51.0, 7.0]
    assert (np.diff(samples.rows[:, 0]) > 0.0).all()
    samples.drop_after(-1.0)
    assert samples.last is None


def test_extremes_of_each_of_five_quantities_are_kept_and_gaps_are() -> None:
    names = tuple(f"mass{i}.y" for i in range(5))
    plot = run_for(600.0, *names)
    for i in range(5):
        assert plot.rows[:, 1 + i].max() == 9.0 * (1 + i)
        assert plot.rows[:, 1 + i].min() == -7.0 * (1 + i)
    samples = Samples(2)
    for i in range(SPAN + 300):
        samples.append((float(i), np.nan, float(i % 7)))
    assert np.isnan(samples.rows[:, 1]).all()
    assert samples.rows[:50, 2].max() == 6.0


def test_a_quantity_is_added_to_the_thinned_values_of_another() -> None:
    plot = run_for(300.0)
    longer = Plot(PlotSpec(("mass10.y", "mass11.y")), sim.load_scene("tutorial-3.3"))
    longer.take_over(plot)
    assert np.array_equal(longer.rows[:, [0, 2]], plot.rows)
    assert np.isnan(longer.rows[:, 1]).all()
    longer.append((301.0, 1.0, 2.0))
    assert longer.rows[-1].tolist() == [301.0, 1.0, 2.0]


def test_a_table_says_for_how_many_frames_a_row_stands() -> None:
    header, *rows = csv.reader(io.StringIO(run_for(100.0).table()))
    assert header == ["time [s]", "mass11.y [px]"]
    header, *rows = csv.reader(io.StringIO(run_for(300.0).table()))
    assert header == ["time [s]", "mass11.y [px]", "frames"]
    frames = [int(row[2]) for row in rows]
    assert frames == sorted(frames, reverse=True)
    assert set(frames) == {1, 2, 4, 8}
    assert frames.count(1) >= SPAN
    assert sum(frames) == pytest.approx(300.0 * RATE, abs=64)


@pytest.mark.parametrize(
    ("swing", "seconds", "span"),
    [(40.14, 600.0, 600.0), (40.14, 3600.0, 3600.0), (280.0, 3600.0, 3600.0), (1.2, 600.0, 600.0)],
)
def test_periods_of_minutes_are_read_and_an_envelope_is_not(
    swing: float, seconds: float, span: float
) -> None:
    plot = Plot(PlotSpec(("mass11.y",)), sim.load_scene("tutorial-3.3"))
    times = np.arange(1, round(RATE * seconds) + 1) / RATE
    for time, value in zip(times.tolist(), np.sin(2.0 * np.pi * times / swing).tolist(), strict=True):
        plot.append((time, value))
    plot.shown = seconds
    said = plots.reading(plot, span)
    period = float(said.split("period <b>")[1].split(" s")[0])
    assert period == pytest.approx(swing, rel=1e-3)
    assert "amplitude <b>1 px" in said
    assert "loses" not in said
