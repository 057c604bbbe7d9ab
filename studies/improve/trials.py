"""One run of a search: a pure function of its arguments, which can be computed anywhere."""

from __future__ import annotations

from collections.abc import Sequence

import sim

from ..sweep.measures import GAVE_UP
from ..sweep.runs import Row, follow, made_by, simulation_of
from .goals import Goal, GoalMeter

RAN_AWAY = "ran away"
BROKE = "broke"
NO_READING = "no reading"
INVALID = "not valid"
"""Reasons why a run counts as worst, besides GAVE_UP; the reason of any other run is ""."""


def trial(data: bytes, assignments: Sequence[str], duration: float, goal: Goal) -> Row:
    """Simulate, and measure how near the body came to a goal.

    Args:
        data: the scene in the format of files.
        assignments: changes of it, KEY=VALUE.
        duration: s; rounded to whole time steps.
        goal: of the scene.

    Returns:
        A row of the result, the score, and the reason why it counts as worst. Result and score are None if
        the body ran away or a spring broke.
    """
    simulation = simulation_of(data, assignments)
    meter, whole = GoalMeter(goal, simulation), _broken(simulation)
    if not follow(simulation, duration, None if meter.needs_end_only else meter.look):
        return Row((None, None, GAVE_UP if simulation.divergence is None else RAN_AWAY), made_by())
    if _broken(simulation) > whole:
        return Row((None, None, BROKE), made_by())
    result, score = meter.result()
    return Row((result, score, NO_READING if score is None else ""), made_by())


def _broken(simulation: sim.Simulation) -> int:
    """Return the number of broken springs."""
    damage = simulation.damage
    return len(damage.broken) if damage else 0
