"""Bodies at rest and their small vibrations: the elastica, beams, hanging ropes, rings, catenaries."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cache

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

import sim
from sim.analysis.equilibrium import equilibrium
from sim.analysis.vibrations import vibrations
from sim.scene.types import ForceLaw

from . import bodies, exact
from .results import Case, Result, compared, converging

LOADS = (0.1, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 30.0, 50.0, 100.0, 300.0, 1000.0)
"""Gamma = w L³ / EI of the master curve."""

FAST_LOADS = (0.1, 1.0, 10.0, 100.0, 1000.0)
"""Gamma in a fast run."""

TIP_LOADS = (1.0, 2.0, 5.0, 10.0)
"""P L² / EI."""

SEGMENTS = (12, 25, 50, 100)
"""Numbers of springs over which orders of convergence are fitted."""

HANGING_LENGTHS = (1.05, 1.1, 1.25, 1.5, 2.0)
"""Of ropes, in spans."""


@cache
def resting_shape(
    segments: int, weight: float, tip: float = 0.0, law: ForceLaw = "conservative"
) -> NDArray[np.float64]:
    """Return the (N + 1, 2) positions of a cantilever at rest, in lengths of the beam, from its clamp."""
    pose = equilibrium(bodies.cantilever(segments, weight, tip, law))
    return (np.array(pose.positions) - (0.5, 0.0)) / bodies.beam_length(segments)


def drop_over_reach(segments: int, weight: float, law: ForceLaw = "conservative") -> float:
    """Return H / W of a heavy cantilever's free end."""
    x, y = resting_shape(segments, weight, law=law)[-1]
    return float(y / x)


@cache
def exact_drop_over_reach(weight: float) -> float:
    """Return H / W of the elastica."""
    shape = exact.elastica(weight)
    return shape.drop / shape.reach


Errors = tuple[list[float], list[float]]
"""Spacings in lengths of the body, and the relative errors."""


def errors_of_cantilever(weight: float) -> Errors:
    """Return the errors of H / W of a heavy cantilever."""
    return _beam_errors(lambda n: drop_over_reach(n, weight) / exact_drop_over_reach(weight))


def errors_of_tip(load: float) -> Errors:
    """Return the errors of the drop under a load at the tip."""
    drop = exact.elastica(0.0, load).drop
    return _beam_errors(lambda n: float(resting_shape(n, 0.0, load)[-1, 1]) / drop)


def errors_of_beam() -> Errors:
    """Return the errors of the first frequency of a clamped and free beam."""
    return _beam_errors(
        lambda n: float(vibrations(bodies.cantilever(n), 1).omega[0] / beam_frequencies(n, 1)[0])
    )


def _beam_errors(ratio: Callable[[int], float]) -> Errors:
    return [1.0 / bodies.beam_length(n) for n in SEGMENTS], [ratio(n) - 1.0 for n in SEGMENTS]


def errors_of_rope(mode: int) -> Errors:
    """Return the errors of a frequency of a hanging rope; modes count from 0."""
    omega = float(exact.hanging_rope_frequencies(mode + 1)[mode])
    return [1.0 / n for n in SEGMENTS], [float(rope_frequencies(n)[mode]) / omega - 1.0 for n in SEGMENTS]


def errors_of_catenary(length: float) -> tuple[Errors, Errors]:
    """Return the errors of sag and of horizontal tension of a rope; its length is in spans."""
    hanging = exact.catenary(length)
    even = [n + n % 2 for n in SEGMENTS]
    found = [sag_and_tension(n, length) for n in even]
    sizes = [1.0 / n for n in even]
    return (
        (sizes, [sag / hanging.sag - 1.0 for sag, _ in found]),
        (sizes, [tension / hanging.parameter - 1.0 for _, tension in found]),
    )


def _heavy_cantilever(fast: bool) -> Iterator[Result]:
    for n in (12, 50):
        for weight in FAST_LOADS if fast else LOADS:
            within = {12: 0.005 if weight <= 1.0 else None, 50: 0.02 if weight == 1000.0 else None}[n]
            yield compared(
                f"H/W, N = {n}, Γ = {weight:g}",
                exact_drop_over_reach(weight),
                drop_over_reach(n, weight),
                within,
            )
    for law in ("tutorial", "angle"):
        for weight, within in ((1.0, 0.005), (1000.0, 0.02)):
            yield compared(
                f"H/W, N = 50, Γ = {weight:g}, law “{law}”",
                exact_drop_over_reach(weight),
                drop_over_reach(50, weight, law),
                within,
            )
    yield converging("H/W, Γ = 1, N = 12 to 100", *errors_of_cantilever(1.0), order=2.0)


def _tip_load(fast: bool) -> Iterator[Result]:
    for load in TIP_LOADS:
        drop = exact.elastica(0.0, load).drop
        yield compared(
            f"H/L, N = 50, PL²/EI = {load:g}", drop, float(resting_shape(50, 0.0, load)[-1, 1]), 0.001
        )
    yield converging("H/L, PL²/EI = 1, N = 12 to 100", *errors_of_tip(1.0), order=2.0)


CHAIN_TO_BEAM = {12: (0.9988, 0.9857, 0.9618, 0.9261), 50: (0.9999, 0.9992, 0.9979, 0.9959)}
"""Frequencies of a chain over those of the beam, to four digits."""


def beam_frequencies(segments: int, count: int) -> NDArray[np.float64]:
    """Return (count,) angular frequencies of the clamped and free beam that a chain models, rad/s."""
    # EI = 1, and a mass of 1 kg per px.
    return (exact.clamped_free_roots(count) / bodies.beam_length(segments)) ** 2


def _beam(fast: bool) -> Iterator[Result]:
    for n, ratios in CHAIN_TO_BEAM.items():
        found = vibrations(bodies.cantilever(n), 4).omega
        for mode, (beam, mine, ratio) in enumerate(
            zip(beam_frequencies(n, 4), found, ratios, strict=True), 1
        ):
            error = mine / beam - 1.0
            yield Result(
                f"ω{mode}, clamped and free, N = {n}", beam, mine, error,
                target=f"ratio {ratio:.4f}", met=bool(abs(mine / beam - ratio) <= 5e-5),
            )  # fmt: skip
    yield converging("ω1, clamped and free, N = 12 to 100", *errors_of_beam(), order=2.0)
    yield _by_time_steps(12, 2 if fast else 10)
    for n in (12,) if fast else (12, 50):
        scene = bodies.chain(bodies.straight(n), stiffness=1e5, angular_stiffness=1.0, held=(0, n))
        formula = exact.pinned_chain_frequencies(n, 1.0, 1.0, 1.0, 4)
        for mode, (chain, mine) in enumerate(zip(formula, vibrations(scene, 4).omega, strict=True), 1):
            yield compared(f"ω{mode}, pinned at both ends, N = {n}, exact for the chain", chain, mine, 1e-8)


def _by_time_steps(segments: int, periods: int) -> Result:
    """Return the first frequency of a cantilever, from zero crossings of its end in a run by `auto`."""
    scene = bodies.cantilever(segments)
    modes = vibrations(scene, 1)
    omega, amplitude = float(modes.omega[0]), 1e-3
    positions = np.array([mass.position for mass in scene.masses]) + amplitude * modes.shapes[0]
    pose = sim.Pose(
        positions=tuple((x, y) for x, y in positions.tolist()), velocities=((0.0, 0.0),) * (segments + 1)
    )
    integrator = sim.Integrator(method="auto", dt=1.0, tolerance=1e-6 * amplitude)
    simulation = sim.Simulation(replace(bodies.at(scene, pose), integrator=integrator))
    times, heights = [0.0], [float(positions[-1, 1])]
    steps = round(2.0 * math.pi / omega / 40.0)
    for _ in range(40 * periods):
        simulation.step(steps)
        times.append(simulation.time)
        heights.append(float(simulation.positions[-1, 1]))
    crossings = _zero_crossings(np.array(times), np.array(heights))
    mine = math.pi * (len(crossings) - 1) / (crossings[-1] - crossings[0])
    return compared(
        f"ω1, clamped and free, N = {segments}, over {periods} periods in time (auto)", omega, mine, 1e-5
    )


def _zero_crossings(times: NDArray[np.float64], values: NDArray[np.float64]) -> list[float]:
    """Return the zero crossings of a sampled smooth function, by cubics through four points each."""
    zeros = []
    for i in np.flatnonzero(values[:-1] * values[1:] < 0.0).tolist():
        if 1 <= i <= len(values) - 3:
            near = slice(i - 1, i + 3)
            # Time as a function of the value, so that the crossing is its value at 0.
            zeros.append(
                float(np.polyval(np.polyfit(values[near], times[near] - times[i], 3), 0.0)) + times[i]
            )
    return zeros


@cache
def rope_frequencies(segments: int) -> NDArray[np.float64]:
    """Return (3,) angular frequencies of a hanging rope, in sqrt(g / L)."""
    scene = bodies.hanging_rope(segments)
    # Gravity is 1 px/s² and the length N px.
    return vibrations(bodies.at(scene, equilibrium(scene)), 3).omega * math.sqrt(segments)


def _hanging_rope(fast: bool) -> Iterator[Result]:
    for mode, omega in enumerate(exact.hanging_rope_frequencies(3)):
        yield compared(f"ω{mode + 1} √(L/g), N = 50", omega, float(rope_frequencies(50)[mode]), 0.01)
    for mode in range(3):
        yield converging(f"ω{mode + 1}, N = 12 to 100", *errors_of_rope(mode), order=2.0)


def _ring(fast: bool) -> Iterator[Result]:
    for n in (12, 50) if fast else (12, 24, 50, 100):
        positions = np.array(equilibrium(bodies.rolled(n)).positions)
        gap = float(np.hypot(*(positions[-1] - positions[0])))
        yield Result(
            f"gap between the ends, N = {n}", 0.0, gap, gap, unit="px", target="≤ 1e-06 px", met=gap <= 1e-6
        )
        radii = np.hypot(*(positions - positions[:-1].mean(0)).T)
        yield compared(
            f"radius, N = {n}", exact.ring_radius(1.0, 2.0 * math.pi / n), float(radii.mean()), 1e-8
        )


def _catenary(fast: bool) -> Iterator[Result]:
    for length in HANGING_LENGTHS:
        hanging = exact.catenary(length)
        sag, tension = sag_and_tension(50, length)
        yield compared(f"sag / span, length / span = {length:g}, N = 50", hanging.sag, sag, 0.001)
        yield compared(f"H / (w span), length / span = {length:g}, N = 50", hanging.parameter, tension, 0.001)
    for what, errors in zip(("sag", "tension"), errors_of_catenary(1.25), strict=True):
        yield converging(f"{what}, length / span = 1.25, N = 12 to 100", *errors, order=2.0)


@cache
def sag_and_tension(segments: int, length: float) -> tuple[float, float]:
    """Return sag in spans, and horizontal tension over the weight of a span, of a rope at rest."""
    scene = bodies.sagging_rope(segments, length)
    positions = np.array(equilibrium(scene).positions)
    span = segments / length
    spring = scene.linear_springs[0]
    x, y = positions[1] - positions[0]
    stretched = math.hypot(x, y)
    tension = spring.stiffness * (stretched - spring.rest_length) * x / stretched
    return float(positions[segments // 2, 1]) / span, tension / span


CASES = (
    Case(
        "cantilever",
        "Heavy cantilever",
        "A rod clamped horizontally bends under its own weight: EI θ'' = -w (L - s) cos θ, with Γ = w L³ / "
        "EI (the protocol of Romero et al. 2021); H is the drop and W the reach of its free end. A chain "
        "with masses 0 and 1 held stands for a rod of length L = (N - 1/2) h and EI = K h³, and its end "
        "mass is half a mass. Force laws are “conservative” unless named. At Γ = 1000 the rod bends within "
        "a twentieth of its length: with N = 50 the first joint turns by 42°, where the couple of a law "
        "that goes by the sine is 9 % weaker than EI times the curvature; the drop is within 0.1 %, and "
        "the reach, which is a twentieth of it, is not.",
        _heavy_cantilever,
    ),
    Case(
        "tip",
        "Load at the tip",
        "The same rod without weight of its own and with a load P at its free end.",
        _tip_load,
    ),
    Case(
        "beam",
        "Small vibrations of a beam",
        "Clamped and free: Euler and Bernoulli's beam has ω = (β L)² √(EI / (ρA L⁴)) with cos βL cosh βL = "
        "-1; the target is what a chain is known to have of that, to four digits. The frequencies of the "
        "chain are eigenvalues of the solver's Jacobian, and the first also comes from a simulation with "
        "“auto”, compared with the eigenvalue. Pinned at both ends there is an exact result for the chain "
        "itself: the angle at a joint is V = (y[i+1] - 2 y[i] + y[i-1]) / h and the energy K h² V² / 2 "
        "under every force law, so m y'' = -K δ⁴y, and with y[i] = sin(nπi/N) ω = 4 √(K/m) sin²(nπ/2N).",
        _beam,
    ),
    Case(
        "rope",
        "Small vibrations of a hanging rope",
        "A rope without bending stiffness: ω = (j₀ₙ / 2) √(g/L), the zeros of the Bessel function J₀. The "
        "end mass is half a mass.",
        _hanging_rope,
    ),
    Case(
        "ring",
        "Ring from rest angles",
        "A straight chain of N springs whose joints want an angle θ₀ = 2π/N rolls up until its ends meet, "
        "on a circle of radius h / (2 sin(θ₀/2)).",
        _ring,
    ),
    Case(
        "catenary",
        "Catenary",
        "A rope without bending stiffness between two points of the same height: y = a cosh(x/a), with the "
        "horizontal tension H = w a.",
        _catenary,
    ),
)
