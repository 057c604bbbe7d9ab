"""Energy: kept where nothing takes any away, and accounted for where something does."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sim
from sim.methods.registry import METHODS, MethodInfo
from sim.scene.types import Circle, Method, Scene

from .results import Case, Result, converging

STEPS = (1.0 / 1600.0, 1.0 / 3200.0, 1.0 / 6400.0, 1.0 / 12800.0)
"""s, of the methods with fixed steps."""
TOLERANCES = (1e-4, 1e-5, 1e-6)
"""px, of the others."""
SAMPLES = 20
"""Times at which energies are looked at, within half a second."""
DURATION = 0.5
BOOKS_ORDER = 6
"""Order at which the books add up powers."""


def swinging_rope(
    method: Method, dt: float, tolerance: float, damping: float = 0.0, circle: Circle | None = None
) -> Scene:
    """A short bendy rope, let go horizontally, whose first mass may be led round a circle."""
    return sim.rope(
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
        integrator=sim.Integrator(method=method, dt=dt, tolerance=tolerance),
    )


def drift(method: Method, dt: float, tolerance: float = 0.1) -> float:
    """The largest change of the energy of a rope without damping, in parts of its largest kinetic energy."""
    return _worst(sim.Simulation(swinging_rope(method, dt, tolerance)), books=False)


def residual(method: Method, dt: float, tolerance: float = 0.1) -> float:
    """The largest residual of the energy books of a damped rope on a moving anchor, in the same parts."""
    circle = Circle(radius=30.0, frequency=2.0, ramp=0.1)
    return _worst(sim.Simulation(swinging_rope(method, dt, tolerance, 20.0, circle)), books=True)


def _worst(simulation: sim.Simulation, books: bool) -> float:
    first = simulation.energy().total
    worst = largest = 0.0
    for _ in range(SAMPLES):
        simulation.step(round(DURATION / (SAMPLES * simulation.dt)))
        book = simulation.energy()
        worst = max(worst, abs(book.residual if books else book.total - first))
        largest = max(largest, book.kinetic)
    return worst / largest


def _drifts(fast: bool) -> Iterator[Result]:
    for method in METHODS.values():
        yield _slope(method, drift, 1.0 if method.adaptive else method.order, fast)


def _residuals(fast: bool) -> Iterator[Result]:
    for method in METHODS.values():
        order = METHODS["adams"].order if method.kernel is None else method.order
        yield _slope(method, residual, min(order, BOOKS_ORDER) / (order if method.adaptive else 1.0), fast)


def _slope(method: MethodInfo, measure: Callable[..., float], expected: float, fast: bool) -> Result:
    """How a method's errors go with the step or with the tolerance."""
    if method.adaptive:
        sizes = TOLERANCES[:2] if fast else TOLERANCES
        errors = [measure(method.name, DURATION / SAMPLES, tolerance) for tolerance in sizes]
        what = f"tolerance {sizes[0]:g} to {sizes[-1]:g} px"
    else:
        sizes = STEPS[1:3] if fast else STEPS
        errors = [measure(method.name, dt) for dt in sizes]
        what = f"dt = 1/{1.0 / sizes[0]:g} to 1/{1.0 / sizes[-1]:g} s"
    return converging(f"{method.name}, {what}", sizes, errors, expected, exactly=False)


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
        "books",
        "Energy books",
        "The same rope with damping, its first mass led round a circle of 30 px twice a second: energy, "
        "less the work of the anchor, plus what the damping took, as `Simulation.energy()` has it. The "
        "books add up powers to sixth order, so that under a method of order 8 the residual goes with the "
        "tolerance to the power 6/8.",
        _residuals,
    ),
)
