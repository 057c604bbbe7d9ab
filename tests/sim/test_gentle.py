"""Whether springs turn far in a step: on chains, on any topology, and where it need not be asked."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor
from sim.solve.steps.common import all_rotations_ok, rotation_ok, shortest_of
from tests.amount import part_of
from tests.sim.arrays import Arrays

STEP = 1e-3


def rope(masses: int, held: tuple[int, ...] = ()) -> sim.Scene:
    anchors = tuple(Anchor(mass=m) for m in held)
    return replace(sim.rope(masses), bodies=(), anchors=anchors)


def turned(arrays: Arrays, spring: int, degrees: float) -> np.ndarray:
    """The positions with one spring turned about its first end, and all behind it shifted along."""
    at = arrays.pairs(arrays.q)
    angle = math.radians(degrees)
    vector = at[spring + 1] - at[spring]
    cos, sin = math.cos(angle), math.sin(angle)
    to = np.array([cos * vector[0] - sin * vector[1], sin * vector[0] + cos * vector[1]])
    at[spring + 1 :] += to - vector
    return arrays.flat(at)


@pytest.mark.parametrize("general", [False, True], ids=["chain", "general"])
@pytest.mark.parametrize("masses", [2, 8, 9, 16, 17, 33])
def test_one_spring_that_turns_by_more_than_60_degrees_is_seen(masses: int, general: bool) -> None:
    arrays = Arrays(rope(masses), general=general)
    ask = (arrays.body, arrays.state, arrays.q)
    for spring in range(masses - 1):
        for degrees in (59.0, -59.0):
            assert all_rotations_ok(*ask, turned(arrays, spring, degrees), STEP)
        for degrees in (61.0, -61.0, 120.0, 180.0):
            assert not all_rotations_ok(*ask, turned(arrays, spring, degrees), STEP)


@pytest.mark.parametrize("general", [False, True], ids=["chain", "general"])
@pytest.mark.parametrize("masses", [2, 7, 8, 9, 16])
def test_behind_the_last_mass_there_is_no_spring(masses: int, general: bool) -> None:
    # What is behind it in memory stands at the origin, which the whole rope is shifted across.
    arrays = Arrays(rope(masses), general=general)
    at = arrays.pairs(arrays.q)
    at += (5.0, 0.0) - at[-1]
    q, to_q = arrays.flat(at), arrays.flat(at - (10.0, 0.0))
    assert all_rotations_ok(arrays.body, arrays.state, q, to_q, STEP)


@pytest.mark.parametrize("general", [False, True], ids=["chain", "general"])
def test_a_spring_between_two_held_masses_may_turn(general: bool) -> None:
    arrays = Arrays(rope(9, held=(3, 4)), general=general)
    assert all_rotations_ok(arrays.body, arrays.state, arrays.q, turned(arrays, 3, 90.0), STEP)
    assert not all_rotations_ok(arrays.body, arrays.state, arrays.q, turned(arrays, 4, 90.0), STEP)


def of_kind(masses: int, kind: str) -> sim.Scene:
    """A rope under one of the laws, or without joints, or with damped ones."""
    law = kind if kind in ("tutorial", "conservative", "angle") else "conservative"
    return sim.rope(
        masses,
        joints=kind != "no joints",
        angular_damping=1.0 if kind == "damped joints" else 0.0,
        force_law=law,  # type: ignore[arg-type]
        integrator=sim.Integrator(method="auto"),
    )


KINDS = ["tutorial", "conservative", "angle", "no joints", "damped joints"]


@pytest.mark.parametrize("general", [False, True], ids=["chain", "general"])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("masses", [2, 3, 11, 12, 13, 44, 45, 60])
def test_the_shortest_spring_is_known_from_the_forces(masses: int, kind: str, general: bool) -> None:
    rng = np.random.default_rng(masses)
    arrays = Arrays(of_kind(masses, kind), general=general)
    soft = math.sqrt(arrays.body.softening)
    for short in range(masses - 1):
        spans = rng.normal(size=(masses, 2))
        spans[short + 1] *= 0.01
        at = np.cumsum(spans, 0)
        arrays.accelerations(arrays.flat(at), arrays.v)
        least = np.hypot(*np.diff(at, axis=0).T).min()
        assert shortest_of(arrays.body, arrays.scratch) == pytest.approx(math.hypot(least, soft))


@pytest.mark.parametrize("kind", KINDS)
def test_what_need_not_be_asked_is_gentle(kind: str) -> None:
    # Small moves and large ones, one after the other, of a rope with springs of very different lengths.
    for seed in part_of(range(20), 4):
        rng = np.random.default_rng(seed)
        arrays = Arrays(of_kind(11, kind))
        at = np.cumsum(rng.normal(size=(11, 2)) * 10.0 ** rng.uniform(-2, 2, (11, 1)), 0)
        q, asked = arrays.flat(at), 0
        for _ in range(60):
            arrays.accelerations(q, arrays.v)
            shortest = shortest_of(arrays.body, arrays.scratch)
            lengths = np.hypot(*np.diff(arrays.pairs(q), axis=0).T)
            assert shortest == pytest.approx(math.hypot(lengths.min(), math.sqrt(arrays.body.softening)))
            to_q = q + arrays.flat(rng.normal(size=(11, 2)) * 10.0 ** rng.uniform(-5, 1))
            gentle = all_rotations_ok(arrays.body, arrays.state, q, to_q, STEP)
            for moved in (float(np.abs(to_q - q).max()), 1e9):
                assert rotation_ok(arrays.body, arrays.state, q, to_q, STEP, moved, shortest) == gentle
            asked += not gentle
            q = to_q
        assert 0 < asked < 60
