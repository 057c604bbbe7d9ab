"""The largest stable step by brute force: the whole step differentiated numerically, and its eigenvalues."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from sim import Simulation
from sim.forces.reference import Physics, Vectors, euler_step, verlet_step

Floats = NDArray[np.float64]
SIZES = (1e-5, 1e-3, 1e-1)
"""Sizes of the differences: px, px/s, px/s²."""
GROWS = 1.001
"""Growth in a step that counts as unstable."""


def rk4_step(physics: Physics, x: Vectors, v: Vectors, h: float) -> tuple[Vectors, Vectors]:
    """The classical Runge-Kutta method."""
    force = physics.accelerations
    a1 = force(x, v)
    v2, a2 = v + h / 2 * a1, force(x + h / 2 * v, v + h / 2 * a1)
    v3, a3 = v + h / 2 * a2, force(x + h / 2 * v2, v + h / 2 * a2)
    v4, a4 = v + h * a3, force(x + h * v3, v + h * a3)
    return x + h / 6 * (v + 2 * v2 + 2 * v3 + v4), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)


def step_matrix(simulation: Simulation, h: float) -> Floats:
    """What a step of h seconds of the simulation's method makes of small changes of its state."""
    system, state = simulation.tables
    body, method = system.body, simulation.method
    body = body.replaced(environment=body.environment.replaced(step=h))  # with which walls and contact soften
    physics = Physics(body, state)
    free = np.flatnonzero(state.inverse_mass > 0.0)
    x, v = state.x + 1j * state.y, state.vx + 1j * state.vy

    def step(parts: list[Vectors]) -> tuple[Vectors, ...]:
        if method == "velocity_verlet":
            return verlet_step(physics, parts[0], parts[1], parts[2], h, lambda *_: None)
        return (rk4_step if method == "rk4" else euler_step)(physics, parts[0], parts[1], h)

    parts = [x, v, physics.accelerations(x, v)] if method == "velocity_verlet" else [x, v]

    def state_after(part: int, direction: complex, mass: int, by: float) -> Vectors:
        changed = [part.copy() for part in parts]
        changed[part][mass] += by * direction
        return np.concatenate([part[free] for part in step(changed)])

    columns = [
        (state_after(i, direction, mass, SIZES[i]) - state_after(i, direction, mass, -SIZES[i]))
        / (2.0 * SIZES[i])
        for i in range(len(parts))
        for mass in free.tolist()
        for direction in (1.0, 1j)
    ]
    return np.column_stack([change.view(float) for change in columns])


def spectral_radius(simulation: Simulation, h: float) -> float:
    """By how much the small motion that grows fastest grows in a step of h seconds."""
    return float(np.abs(np.linalg.eigvals(step_matrix(simulation, h))).max())


def whole_limit(simulation: Simulation, near: float) -> float:
    """The step at which a motion begins to grow that would not by itself, to 0.05 %.

    Args:
        simulation: in any state.
        near: s, where to start from.
    """
    fine = 0.02 * near
    values = np.linalg.eigvals(step_matrix(simulation, fine))
    rates = np.log(values[np.abs(values) > 0.5]) / fine
    own = float(rates.real.max(initial=0.0))
    # Under the tutorial's law fast vibrations may grow by themselves, too.
    fast = rates[(np.abs(rates) > 0.5 * np.abs(rates).max()) & (rates.imag != 0.0)]
    vibrating = float(fast.real.max(initial=0.0))

    def grows(h: float) -> bool:
        values = np.linalg.eigvals(step_matrix(simulation, h))
        if simulation.method == "rk4":
            return bool(np.abs(values).max() > GROWS * np.exp(1.1 * own * h))
        # What the step resolves grows as it does by itself; what it causes changes its direction.
        return bool((np.abs(values[values.real < 0.0]) > GROWS * np.exp(2.0 * vibrating * h)).any())

    return bisected(grows, near)


def bisected(grows: Callable[[float], bool], near: float) -> float:
    low = 0.8 * near
    while grows(low):
        low *= 0.8
    high = low * 1.05
    while not grows(high):
        low, high = high, 1.05 * high
    while high > 1.0005 * low:
        middle = (low * high) ** 0.5
        low, high = (low, middle) if grows(middle) else (middle, high)
    return low


def hold(simulation: Simulation, within: float = 0.01) -> float:
    """Hold the stability meter against the whole step, and return the limit that it says."""
    said = simulation.stability().limit
    assert said == pytest.approx(whole_limit(simulation, said), rel=within)
    # And so do later looks, which start from what the first has found.
    assert simulation.stability().limit == pytest.approx(said, rel=0.005)
    return said
