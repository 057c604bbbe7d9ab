"""Hard cases: no method ever shows a bad number, and `auto` survives them all."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

from sim import Scene, Simulation
from sim.scene.types import ForceLaw
from sim.solve.registry import METHODS
from studies.stability import hard_case_report
from studies.stability.hard_case_report import reference
from studies.stability.hard_cases import HardCase, hard_cases

CASES = hard_cases()
NO_REFERENCE = {"masses 1:1e6", "anchor torn to and fro", "sliders flung"}
"""Strict methods do not agree about these."""


def by(scene: Scene, method: str, law: ForceLaw) -> Scene:
    """The scene by another method and law."""
    return replace(scene, integrator=replace(scene.integrator, method=method), force_law=law)


def run(case: HardCase, method: str, law: ForceLaw, tracks: bool = False) -> tuple[Simulation, int]:
    """The simulation after all frames, or when it stopped, and the time steps that it is behind."""
    simulation = Simulation(by(case.scene, method, law))
    simulation.track_energy(tracks)
    behind = 0
    for missing in hard_case_report.frames_of(case, simulation):
        behind += missing
        assert np.isfinite(simulation.positions).all()
        assert np.isfinite(simulation.velocities).all()
    return simulation, behind


@pytest.mark.parametrize("law", ["conservative", "tutorial"])
@pytest.mark.parametrize("name", CASES)
def test_auto_survives_and_keeps_up_and_makes_no_energy(name: str, law: ForceLaw) -> None:
    """The energy never grows by more than was put in, and the balance agrees on where it went."""
    simulation, behind = run(CASES[name], "auto", law, tracks=law == "conservative")
    assert simulation.divergence is None
    # Flung sliders put in so much energy that some frames need more steps than they may try: the clock lags.
    assert behind <= (0.05 * simulation.step_count if name == "sliders flung" else 0)
    # A rope under gravity stays within reach of its anchor, unless nothing holds it together.
    if "stiffness, no air" not in name and "keys" not in name:
        stretch = np.hypot(*(simulation.positions - simulation.positions[0]).T).max()
        assert stretch < 1500.0
    if law == "tutorial":  # which has no energy
        return
    balance = simulation.energy()
    put_in = abs(balance.anchors) + abs(balance.keys) + abs(balance.changes)
    turned_over = balance.kinetic + balance.linear + balance.angular + put_in
    weight = sum(m.mass for m in simulation.scene.masses) * abs(simulation.scene.gravity[1])
    tolerated = weight * simulation.scene.integrator.tolerance
    # The residual, without what was lost: positive only where the method made energy.
    assert balance.residual + balance.damping + balance.air < 0.02 * turned_over + tolerated
    assert abs(balance.residual) < 0.05 * (turned_over + abs(balance.air)) + tolerated


@pytest.mark.parametrize("name", [name for name in CASES if name not in NO_REFERENCE])
def test_auto_ends_within_its_tolerance(name: str) -> None:
    """Folds, tangles and torn anchors make small errors large; tolerances beside each other tell of luck."""
    case = HardCase(by(CASES[name].scene, "auto", "conservative"), CASES[name].act)
    known = reference(case)
    assert known is not None
    off = []
    for tolerance in (0.98, 1.0, 1.02):
        outcome = hard_case_report.run(case, "auto", tolerance, tracks=False)
        off.append(float(np.hypot(*(outcome.positions - known).T).max()) / case.scene.integrator.tolerance)
    assert np.median(off) < 1.0
    assert max(off) < 1.5


@pytest.mark.parametrize("method", [name for name in METHODS if name != "auto"])
@pytest.mark.parametrize("name", CASES)
def test_no_method_shows_a_bad_number(name: str, method: str) -> None:
    """Most methods give up on some of these; they stop at a good state, and say so."""
    run(CASES[name], method, "conservative")
