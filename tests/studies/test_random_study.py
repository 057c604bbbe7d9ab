"""How near `auto` keeps to its tolerance on random bodies, and how that is summed up."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace
from numpy.typing import NDArray

import sim
from sim.model.system import build_system
from sim.scene.types import Method
from studies.compare import random_study, references
from studies.compare.random_bodies import random_body
from studies.compare.random_study import (
    GROWTHS,
    measure_body,
    shares,
    shares_by_growth,
    shares_by_tolerance,
)
from tests.amount import NIGHT, part_of
from tests.studies.fragile_bodies import KINDS, fragile_body
from tests.studies.results import some_body


def test_random_bodies_are_the_same_every_time_and_of_all_kinds() -> None:
    assert random_body(3) == random_body(3)
    bodies = [random_body(seed) for seed in range(60)]
    assert {body.name.partition("-")[0] for body in bodies} == {"chain", "ring", "tree", "grid", "tangle"}
    assert {body.force_law for body in bodies} == {"tutorial", "conservative"}
    assert any(anchor.circle for body in bodies for anchor in body.anchors)
    assert {build_system(body).body.chain for body in bodies} == {True, False}


def test_a_body_is_measured_and_chaos_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    body = measure_body(13)
    assert (body.shape, body.masses, body.left_out) == ("chain", 5, "")
    assert body.doubt < 1e-5
    assert 0.1 < body.growth < 100.0
    assert body.error < 0.3
    monkeypatch.setattr(random_study, "CHAOTIC", 0.5 * body.growth)
    assert measure_body(13).left_out == "chaotic"


def test_shares_count_what_is_not_left_out() -> None:
    bodies = [some_body(0, 0.1), some_body(1, 0.2), some_body(2, 1.5), some_body(3, math.inf)]
    found = shares([*bodies, some_body(4, 7.0, "chaotic")])
    assert (found.counted, found.within, found.within_three) == (4, 0.25, 0.5)
    assert found.beyond == (3, 2)
    assert shares(bodies, framed=True).within == 1.0


def test_shares_by_tolerance_count_bodies_whose_references_are_sure() -> None:
    bodies = [
        some_body(0, 0.1),
        some_body(1, 0.6),
        some_body(2, 0.1, doubt=1e-4),
        some_body(3, 9.0, "chaotic"),
    ]
    found = shares_by_tolerance(bodies)
    assert [(s.tolerance, s.counted) for s in found] == [(1.0, 3), (0.1, 3), (0.01, 3), (1e-3, 2), (1e-4, 2)]
    assert [s.within for s in found] == pytest.approx([2.0 / 3.0, 2.0 / 3.0, 1.0, 0.0, 1.0])
    assert found[3].largest == pytest.approx(2.0)


def test_shares_by_growth_count_chaotic_bodies_whose_references_agree() -> None:
    bodies = [
        some_body(0, 0.05, growth=2.0),
        some_body(1, 0.05, growth=50.0),
        some_body(2, 0.3, growth=150.0),
        some_body(3, 7.0, "chaotic", growth=1e4),
        some_body(4, 7.0, "chaotic", growth=1e9, doubt=1.0),
    ]
    found = shares_by_growth(bodies)
    assert [s.counted for s in found.values()] == [1, 1, 1, 1]
    assert [s.within for s in found.values()] == [1.0, 1.0, 0.0, 0.0]
    assert list(found) == ["0 to 10", "10 to 100", "100 to 1000", "1000 and more"]


@pytest.fixture
def one_reference(monkeypatch: pytest.MonkeyPatch) -> None:
    """By day one method, since another kind of method takes ten times as long for the same."""
    if not NIGHT:
        monkeypatch.setattr(references, "METHODS", ("adams", "adams"))


@pytest.mark.usefixtures("one_reference")
def test_auto_keeps_to_its_tolerance_where_something_yields_or_breaks() -> None:
    bodies = []
    for kind in KINDS:
        for seed in part_of(range(48), 6):
            scene = fragile_body(seed, kind)
            if scene is not None:
                bodies.append(measure_body(100 * KINDS.index(kind) + seed, scene))
    bodies = [body for body in bodies if body.growth < GROWTHS[1]]
    for found in shares_by_tolerance(bodies)[:4]:
        assert found.counted >= 10
        assert found.within >= 0.9  # a few may be unlucky


@pytest.mark.parametrize("method", ["auto", "rodas4", "rodas5p"])
def test_a_small_tolerance_is_kept_where_springs_break_under_a_touch(method: Method) -> None:
    # Ropes on which collisions leave a method most easily with a wrong speed.
    for seed in (23, 54, 95, 119):
        errors = _errors(seed, KINDS[3], method, 1e-3, 0.5)
        assert np.median(errors) <= 1e-3, seed
        assert sorted(errors)[-2] <= 3.0 * 1e-3, seed  # one may be unlucky


def test_auto_keeps_to_a_small_tolerance_where_much_yields() -> None:
    # Bodies at whose many kinks a high order is of no use.
    for seed, kind in ((82, KINDS[0]), (84, KINDS[0]), (69, KINDS[1])):
        errors = _errors(seed, kind, "auto", 1e-3, 1.0)
        assert np.median(errors) <= 1.2 * 1e-3, seed
        assert sorted(errors)[-2] <= 5.0 * 1e-3, seed


def _errors(seed: int, kind: str, method: Method, tolerance: float, duration: float) -> list[float]:
    """How far a mass of a fragile body is from where it should be, px, after starts that differ by next to
    nothing.

    Which trial of a step is the first to pass, and so how large one error is, rounding decides.
    """
    scene = fragile_body(seed, kind)
    assert scene is not None
    rng = np.random.default_rng(seed)

    def end(by: Method, within: float, nudge: float) -> NDArray[np.float64]:
        simulation = sim.Simulation(
            replace(scene, integrator=sim.Integrator(method=by, dt=duration, tolerance=within))
        )
        simulation.take_state(simulation, nudge * rng.normal(size=(4, len(scene.masses))))
        assert simulation.step(attempts=100_000) == 1
        return simulation.positions

    exact = end("adams", 1e-9, 0.0)
    return [float(np.abs(end(method, tolerance, 1e-9) - exact).max()) for _ in range(9)]


def test_fragile_bodies_are_the_same_every_time_and_do_what_they_are_to_do() -> None:
    for kind in KINDS:
        scene = fragile_body(2, kind)
        assert scene is not None and scene == fragile_body(2, kind)
        simulation = sim.Simulation(scene)
        simulation.advance(1.0)
        damage = simulation.damage
        assert damage is not None
        assert bool(damage.broken) == ("break" in kind)
        assert any(damage.set_lengths) == (kind == KINDS[0])
        assert any(damage.set_angles) == (kind == KINDS[1])


@pytest.mark.usefixtures("one_reference")
def test_auto_keeps_to_large_tolerances_and_small_ones() -> None:
    bodies = [measure_body(seed) for seed in part_of(range(36), 3)]
    for found in shares_by_tolerance(bodies):
        assert found.counted >= 0.75 * len(bodies)  # the others amplify errors, whatever the method
        assert found.within > 0.9  # one of them may be unlucky
