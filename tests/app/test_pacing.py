"""The clock: what is owed, what is lost, and what the page is told of it."""

from __future__ import annotations

from unittest import mock

import pytest

import sim
from app.session.pacing import Costs, Pacer
from sim.motion.solver import SolverStats

DT = 0.01
FRAME = 0.05


def ran(pacer: Pacer, frames: int, missed: int = 0) -> float:
    """Let frames pass, each of five time steps, so many of which are not reached; the time."""
    now = 0.0
    pacer.grant(now, DT)
    for _ in range(frames):
        now += FRAME
        steps = pacer.grant(now, DT)
        assert steps == 5
        pacer.record(now, DT, steps - missed, 1e-3, SolverStats(steps=steps - missed), missed)
    return now


def test_a_clock_that_keeps_up_is_not_behind() -> None:
    pacer = Pacer()
    rates = pacer.rates(ran(pacer, 12))
    assert (rates.behind, rates.losing) == (0.0, 0.0)
    assert rates.real_time_factor == pytest.approx(1.0)


def test_steps_that_were_granted_and_not_reached_are_lost() -> None:
    pacer = Pacer()
    rates = pacer.rates(ran(pacer, 12, missed=2))
    assert [pacer.behind, rates.behind, rates.losing] == pytest.approx([12 * 2 * DT] * 3)
    assert rates.real_time_factor == pytest.approx(0.6)
    pacer.restart()
    assert pacer.behind == 0.0


def test_what_is_lost_is_of_the_last_second() -> None:
    pacer = Pacer()
    rates = pacer.rates(ran(pacer, 60, missed=1))
    assert rates.behind == pytest.approx(60 * DT)
    assert rates.losing == pytest.approx(20 * DT, abs=1.5 * DT)


class Machine:
    """Does steps that cost what a test says, on a clock of its own.

    Args:
        costs: seconds of each attempt, by its number; the last one goes on.
        each: attempts of a time step.
    """

    def __init__(self, *costs: float, each: int = 1) -> None:
        self.costs, self.each = costs, each
        self.now, self.tried, self.calls = 0.0, 0, 0

    def go(self, n: int, attempts: int) -> tuple[int, int]:
        """See `Costs.spend`."""
        self.calls += 1
        first = self.tried
        end = min(self.each * (self.tried // self.each + n), self.tried + attempts)
        while self.tried < end:
            self.now += self.costs[min(self.tried, len(self.costs) - 1)]
            self.tried += 1
        return self.tried // self.each - first // self.each, self.tried - first

    def frame(self, costs: Costs, steps: int) -> tuple[int, float]:
        """(time steps done, seconds taken)."""
        began = self.now
        return costs.spend(BUDGET, steps, self.go, lambda: self.now), self.now - began


BUDGET = 0.01


def test_what_is_cheap_is_done_at_once() -> None:
    costs, machine = Costs(), Machine(1e-5)
    assert machine.frame(costs, 6)[0] == 6
    machine.calls = 0
    assert machine.frame(costs, 6)[0] == 6
    assert machine.calls == 1


@pytest.mark.parametrize("each", [1, 10, 10_000])
def test_a_frame_takes_little_more_than_its_budget_whatever_steps_cost(each: int) -> None:
    costs, machine = Costs(), Machine(1e-5, each=each)
    for _ in range(20):
        machine.frame(costs, 100)
    # Each step costs fifty times as much from now on.
    machine.costs = (5e-4,)
    took = [machine.frame(costs, 20_000)[1] for _ in range(5)]
    assert took[0] < BUDGET + 0.36  # planned by what they cost before
    assert max(took[1:]) < 1.1 * BUDGET
    assert min(took) > 0.8 * BUDGET


def test_nobody_knows_yet_what_the_first_steps_cost() -> None:
    costs, machine = Costs(), Machine(0.02, each=1000)
    _, took = machine.frame(costs, 6)
    assert took == pytest.approx(0.02)
    # The first one makes tables, which is no reason to go slowly from then on.
    costs, machine = Costs(), Machine(2e-3, 1e-5, each=100)
    machine.frame(costs, 6)
    assert machine.frame(costs, 6)[0] == 6
    # A step of another body costs more than its budget: it moves, one step at a time.
    costs, machine = Costs(), Machine(0.3)
    machine.frame(costs, 6)
    for _ in range(3):
        done, took = machine.frame(costs, 6)
        assert (done, took) == (1, pytest.approx(0.3))


def test_a_motion_that_has_ended_is_asked_no_more() -> None:
    go = mock.Mock(return_value=(0, 0))
    assert Costs().spend(BUDGET, 5, go) == 0
    assert go.call_count == 1


def test_what_another_body_costs_is_not_known_by_that_of_the_last_one() -> None:
    costs = Costs()
    costs.reset_for(sim.rope(12))
    cheap = Machine(1e-6)
    cheap.frame(costs, 100)
    cheap.frame(costs, 100)
    for scene in (sim.rope(13), sim.rope(13, integrator=sim.Integrator(method="rodas4"))):
        costs.reset_for(scene)
        _, took = Machine(0.02, each=1000).frame(costs, 6)
        assert took == pytest.approx(0.02)
    costs.reset_for(sim.rope(13, integrator=sim.Integrator(method="rodas4"), gravity=(0.0, 1.0)))
    assert costs.unit == pytest.approx(0.02)
