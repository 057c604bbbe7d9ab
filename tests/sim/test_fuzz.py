"""Wild scenes with wild inputs under `auto`, some in wild worlds: no bad number, no energy from nowhere, and
no frame that tries more than it may. By night thousands of them, by day those whose turn it is."""

from __future__ import annotations

import numpy as np
import pytest

from tests.amount import part_of
from tests.sim.fuzzing import run_case

CASES, IN_WORLDS, BATCH = 4000, 400, 50
FRAMES, BUDGET = 10, 400
MADE = 0.1
"""Energy that may come from nowhere, as a part of all that was turned over. What is damped away at once does
not count, since that is where most errors of a method end."""
UNEXPLAINED = 0.3
"""Energy that the balance cannot account for, as a part of all that was turned over or lost."""


@pytest.mark.parametrize("first", part_of(range(0, CASES, BATCH), 16))
def test_nothing_explodes(first: int) -> None:
    nothing_explodes(False, range(first, first + BATCH))


@pytest.mark.parametrize("first", part_of(range(0, IN_WORLDS, BATCH), 8))
def test_nothing_explodes_in_a_wild_world(first: int) -> None:
    nothing_explodes(True, range(first, first + BATCH))


def nothing_explodes(world: bool, seeds: range) -> None:
    for seed in seeds:
        ending = run_case(seed, FRAMES, BUDGET, world)
        simulation = ending.simulation
        scene = simulation.scene
        told = f"seed {seed}: {scene.name}, {scene.force_law}, {simulation.divergence}"
        assert np.isfinite(simulation.positions).all(), told
        assert np.isfinite(simulation.velocities).all(), told
        assert ending.made < MADE, f"{told}: made {ending.made:.2g}"
        assert ending.unexplained < UNEXPLAINED, f"{told}: {ending.unexplained:.2g} unexplained"
        assert ending.tries <= BUDGET, told
        # The tutorial's law has no energy: it may drive a body ever faster, and the balance says that it did.
        if simulation.divergence is not None:
            assert scene.force_law == "tutorial", told
            assert "has no energy" in str(simulation.divergence)
            balance = simulation.energy()
            # A slider flung may put in any energy, where it makes stiff what is stretched.
            held = balance.kinetic + balance.linear + balance.angular - max(balance.changes, 0.0)
            assert balance.law > 0.5 * held, told
