"""Spectra and fitted curves: against closed forms, natural vibrations, and what is no such curve."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Integrator
from sim.analysis.curves import CURVES, fit_curve
from sim.analysis.spectrum import Floats, peaks, spectrum
from sim.analysis.vibrations import vibrations
from sim.errors import InputError

START = 7.0
"""Of the points; numbers count from there."""

SCATTER = 0.1

TIMES = START + np.arange(600) / 60.0

SHAPES: dict[str, tuple[Callable[[Floats], Floats], dict[str, float]]] = {
    "line": (lambda t: 3.0 - 2.0 * t, {"start": 3.0, "slope": -2.0}),
    "parabola": (
        lambda t: 3.0 + 12.0 * t - 4.905 * t**2,
        {"start": 3.0, "slope at the start": 12.0, "second derivative": -9.81},
    ),
    "sine": (
        lambda t: 5.0 + 2.0 * np.sin(math.tau * t / 1.7 + 0.5),
        {"offset": 5.0, "amplitude": 2.0, "period": 1.7, "phase": math.degrees(0.5)},
    ),
    "decaying sine": (
        lambda t: 5.0 + 2.0 * np.exp(-0.4 * t) * np.sin(math.tau * t / 0.9 - 1.0),
        {
            "offset": 5.0, "amplitude": 2.0, "period": 0.9, "phase": math.degrees(-1.0), "decay rate": 0.4,
        },
    ),
    "exponential": (
        lambda t: 1.0 + 3.0 * np.exp(-0.5 * t),
        {"offset": 1.0, "size": 3.0, "decay rate": 0.5},
    ),
}  # fmt: skip


def scattered(values: Floats, seed: int) -> Floats:
    """Values with normally distributed deviations."""
    return values + SCATTER * np.random.default_rng(seed).standard_normal(len(values))


@pytest.mark.parametrize("name", CURVES)
def test_fitted_numbers_are_those_of_the_closed_form_within_their_errors(name: str) -> None:
    shape, numbers = SHAPES[name]
    exact, misses = shape(TIMES - START), []
    for seed in range(20):
        curve = fit_curve(name, TIMES, scattered(exact, seed))
        assert curve.origin == START
        assert curve.deviation == pytest.approx(SCATTER, rel=0.15)
        assert np.abs(curve.at(TIMES) - exact).max() < SCATTER
        found = {number.name: number for number in curve.numbers}
        assert set(found) == set(numbers)
        misses.append([(found[key].value - numbers[key]) / found[key].error for key in numbers])
    each = np.array(misses)
    assert np.abs(each).max() < 4.0
    # Errors are neither too small nor too large: deviations in units of them have a variance of 1.
    assert 0.6 < np.sqrt((each**2).mean()) < 1.4


def test_a_slow_and_a_fast_sine_and_a_growth_are_found() -> None:
    for period in (15.0, 7.0, 0.12):
        curve = fit_curve("sine", TIMES, scattered(np.sin(math.tau * TIMES / period), 1))
        found = {number.name: number for number in curve.numbers}["period"]
        assert found.value == pytest.approx(period, abs=4.0 * found.error)
        assert found.error < 0.02 * period
    grows = fit_curve("exponential", TIMES, 2.0 - np.exp(0.6 * (TIMES - START)))
    assert grows.numbers[-1].value == pytest.approx(-0.6, rel=1e-6)


@pytest.mark.parametrize("name", CURVES)
def test_too_few_points_and_what_is_no_such_curve_are_refused_in_a_sentence(name: str) -> None:
    for count in (0, 1, 4):
        with pytest.raises(InputError, match=r"takes \d points at least, and \d are in view"):
            fit_curve(name, TIMES[:count], TIMES[:count])
    with pytest.raises(InputError, match="takes"):
        fit_curve(name, np.full(50, 3.0), np.arange(50.0))  # all at one place
    if name in ("line", "parabola"):
        return
    no_such = 3.0 - 2.0 * TIMES if name == "exponential" else np.full(600, 4.0)
    with pytest.raises(InputError, match="does not converge") as told:
        fit_curve(name, TIMES, no_such)
    assert "\n" not in str(told.value)


@pytest.mark.parametrize(("kind", "count"), [("rod", 2), ("net", 4)])
def test_peaks_of_a_body_that_rings_are_its_vibrations(kind: str, count: int) -> None:
    still: dict[str, Any] = {
        "gravity": (0.0, 0.0), "air_friction": 0.0, "damping": 0.0,
        "integrator": Integrator(method="rk4", dt=2e-3),
    }  # fmt: skip
    if kind == "rod":
        scene = sim.rod(masses=6, stiffness=2e4, angular_stiffness=5e3, **still)
    else:
        scene = sim.cloth(columns=4, rows=3, stiffness=2e3, **still)
    struck = len(scene.masses) - 2 if kind == "net" else 5
    masses = list(scene.masses)
    masses[struck] = replace(masses[struck], velocity=(2.0, 3.0))
    ringing = sim.Simulation(replace(scene, masses=tuple(masses), bodies=()))
    recorded = ringing.record(15.0, f"mass{struck}.y", every=4)
    found = spectrum(recorded.time, recorded[f"mass{struck}.y"])
    assert found is not None
    own = vibrations(scene, 2 * len(scene.masses) - 4).frequencies
    told = peaks(found, 15.0, 5)
    assert len(told) >= count
    for peak in told:
        assert np.abs(own / peak.frequency - 1.0).min() < 2e-3


def test_a_sine_has_a_peak_at_its_frequency_of_its_height() -> None:
    time = np.arange(1200) / 60.0
    values = 5.0 + 0.2 * time + 2.0 * np.sin(math.tau * 1.2345 * time) + 0.4 * np.sin(math.tau * 3.21 * time)
    found = spectrum(time, values)
    assert found is not None
    one, two = peaks(found, 20.0, 5)
    assert one == pytest.approx((1.2345, 2.0), rel=1e-3)
    assert two == pytest.approx((3.21, 0.4), rel=2e-3)
    assert peaks(found, 20.0, 1) == [one]
    # At unequal intervals, as frames of a page are.
    rough = time + np.random.default_rng(2).uniform(-0.003, 0.003, len(time))
    found = spectrum(rough, np.sin(math.tau * 1.2345 * rough))
    assert found is not None
    assert peaks(found, 20.0, 5)[0].frequency == pytest.approx(1.2345, rel=1e-3)


def test_what_does_not_change_or_is_too_short_has_no_spectrum() -> None:
    assert spectrum(TIMES, np.full(600, 3.0)) is None
    assert spectrum(TIMES[:15], np.sin(TIMES[:15])) is None
    drift = spectrum(TIMES, np.sin(0.2 * TIMES))
    assert drift is not None
    assert not [peak for peak in peaks(drift, 10.0, 5) if peak.frequency < 0.2]
