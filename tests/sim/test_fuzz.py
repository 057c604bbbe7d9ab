"""Thousands of wild scenes with wild inputs under `auto`, some in wild worlds: no bad number, no energy from
nowhere, and no frame that tries more than it may."""

from __future__ import annotations

import numpy as np
import pytest

from tests.sim.fuzzing import run_case

CASES, IN_WORLDS, BATCH = 4000, 400, 50
FRAMES, BUDGET = 10, 400
MADE = 0.1
"""Energy that may come from nowhere, as a part of all that was turned over. What is damped away at once does
not count, since that is where most errors of a method end."""
UNEXPLAINED = 0.3
"""Energy that the books cannot account for, as a part of all that was turned over or lost."""


@pytest.mark.parametrize(
    ("world", "first"),
    [
        *((False, first) for first in range(0, CASES, BATCH)),
        *((True, first) for first in range(0, IN_WORLDS, BATCH)),
    ],
)
def test_nothing_explodes(world: bool, first: int) -> None:
    for seed in range(first, first + BATCH):
        ending = run_case(seed, FRAMES, BUDGET, world)
        simulation = ending.simulation
        told = f"seed {seed}: {simulation.scene.name}, {simulation.scene.force_law}, {simulation.divergence}"
        assert np.isfinite(simulation.positions).all(), told
        assert np.isfinite(simulation.velocities).all(), told
        assert ending.made < MADE, f"{told}: made {ending.made:.2g}"
        assert ending.unexplained < UNEXPLAINED, f"{told}: {ending.unexplained:.2g} unexplained"
        assert ending.tries <= BUDGET, told
        # The tutorial's law has no energy: it may drive a body ever faster, and the books say that it did.
        if simulation.divergence is not None:
            assert simulation.scene.force_law == "tutorial", told
            assert "has no energy" in str(simulation.divergence)
            book = simulation.energy()
            # A slider flung may put in any energy, where it makes stiff what is stretched.
            held = book.kinetic + book.linear + book.angular - max(book.changes, 0.0)
            assert book.law > 0.5 * held, told
