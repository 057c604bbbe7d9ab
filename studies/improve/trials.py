"""One run of a search, as a function of nothing but its arguments, so that it can be computed anywhere."""

from __future__ import annotations

from collections.abc import Sequence

import sim

from ..sweep.measures import GAVE_UP
from ..sweep.runs import Row, follow, made_by, simulation_of
from .goals import Goal, GoalMeter

RAN_AWAY, BROKE, NO_READING, INVALID = "ran away", "broke", "no reading", "not valid"
"""How a run ended that counts as worst, besides GAVE_UP; a run that counts ended as ""."""


def trial(data: bytes, assignments: Sequence[str], duration: float, goal: Goal) -> Row:
    """Simulate, and say how near the body came to a goal.

    Args:
        data: the scene as a file has it.
        assignments: what is changed in it, KEY=VALUE.
        duration: s; rounded to whole time steps.
        goal: of the scene.

    Returns:
        A row of the result, the score, and how it ended. Of a body that ran away or of which a spring broke,
        result and score are None.
    """
    simulation = simulation_of(data, assignments)
    meter, whole = GoalMeter(goal, simulation), _broken(simulation)
    if not follow(simulation, duration, None if meter.goes_by_end else meter.look):
        return Row((None, None, GAVE_UP if simulation.divergence is None else RAN_AWAY), made_by())
    if _broken(simulation) > whole:
        return Row((None, None, BROKE), made_by())
    result, score = meter.result()
    return Row((result, score, NO_READING if score is None else ""), made_by())


def _broken(simulation: sim.Simulation) -> int:
    """How many springs are broken."""
    damage = simulation.damage
    return len(damage.broken) if damage else 0
