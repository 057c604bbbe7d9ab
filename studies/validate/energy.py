"""Energy: conserved without damping, and balanced with it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import sim
from sim.scene.types import Circle, Method
from sim.solve.registry import METHODS, MethodInfo

from .results import Case, Result, integrator_of, over_sizes

STEPS = (1.0 / 1600.0, 1.0 / 3200.0, 1.0 / 6400.0, 1.0 / 12800.0)
"""s, of the methods with fixed steps."""

TOLERANCES = (1e-4, 1e-5, 1e-6)
"""px, of the others."""

DURATION = 0.5
"""Simulated time, s."""

SAMPLES = 20
"""Samples of the energies within that time."""

BALANCE_ORDER = 6
"""Order at which the balance integrates powers."""


def swinging_rope(
    method: Method, size: float, damping: float = 0.0, circle: Circle | None = None
) -> sim.Simulation:
    """Return a short bendy rope, released horizontally, whose first mass may be led round a circle.

    Args:
        method: its name.
        size: the step, s, or the tolerance, px.
        damping: of its springs, kg/s.
        circle: of its first mass.
    """
    return sim.Simulation(
        sim.rope(
            6,
            150.0,
            direction=(1.0, 0.0),
            stiffness=10_000.0,
            damping=damping,
            angular_stiffness=2_000.0,
            angular_damping=0.1 * damping,
            rest_angle=20.0,
            circle=circle,
            driven=None,
            air_friction=0.0,
            integrator=integrator_of(method, size, DURATION / SAMPLES),
        )
    )


def drift(method: Method, size: float) -> float:
    """Return the largest change of the energy of a rope without damping, over its largest kinetic energy."""
    return _worst(swinging_rope(method, size), of_balance=False)


def residual(method: Method, size: float) -> float:
    """Return the largest residual of the energy balance of a damped rope on a moving anchor, the same way."""
    circle = Circle(radius=30.0, frequency=2.0, ramp=0.1)
    return _worst(swinging_rope(method, size, 20.0, circle), of_balance=True)


def _worst(simulation: sim.Simulation, of_balance: bool) -> float:
    first = simulation.energy().total
    worst = largest = 0.0
    for _ in range(SAMPLES):
        simulation.step(round(DURATION / (SAMPLES * simulation.dt)))
        balance = simulation.energy()
        worst = max(worst, abs(balance.residual if of_balance else balance.total - first))
        largest = max(largest, balance.kinetic)
    return worst / largest


def _sizes(method: MethodInfo, fast: bool) -> tuple[float, ...]:
    if method.adaptive:
        return TOLERANCES[:2] if fast else TOLERANCES
    return STEPS[1:3] if fast else STEPS


def _drifts(fast: bool) -> Iterator[Result]:
    for method in METHODS.values():
        order = 1.0 if method.adaptive else method.order
        yield over_sizes(method, _sizes(method, fast), partial(drift, method.name), order)


def _residuals(fast: bool) -> Iterator[Result]:
    for method in METHODS.values():
        order = METHODS["adams"].order if method.kernel is None else method.order
        expected = min(order, BALANCE_ORDER) / (order if method.adaptive else 1.0)
        yield over_sizes(method, _sizes(method, fast), partial(residual, method.name), expected)


CASES = (
    Case(
        "drift",
        "Energy without damping",
        "A bendy rope of six masses, let go horizontally, under the conservative law: the largest change "
        "of its energy at twenty times within half a second, in parts of its largest kinetic energy. It "
        "shrinks with the step at the method's order, and with the tolerance in proportion.",
        _drifts,
    ),
    Case(
        "balance",
        "Energy balance",
        "The same rope with damping, its first mass led round a circle of 30 px twice a second: energy, "
        "less the work of the anchor, plus what the damping took, as `Simulation.energy()` has it. The "
        "balance adds up powers to sixth order, so that under a method of order 8 the residual goes with the "
        "tolerance to the power 6/8.",
        _residuals,
    ),
)
