"""How well `auto` respects its tolerance on random bodies of any topology."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from sim import Pose, Scene

from . import references
from .engines.softrod import run_at
from .random_bodies import random_body
from .references import path_by
from .runs import FRAME, SECONDS, distance, run

TOLERANCE = 0.1
"""Tolerance of `auto`, px."""

OTHER_TOLERANCES = (1.0, 1e-2, 1e-3, 1e-4)
"""Further tolerances of `auto`, px, in one call each."""

TIGHT = 1e-9
"""Tolerance of the references, px."""

NUDGE = 1e-6
"""Displacement of the farthest mass in a perturbed start, px."""

CHAOTIC = 1e3
"""Growth of a nudge of the start from which on a body counts as chaotic and is left out: it would amplify
errors of a thousandth of the tolerance beyond the tolerance, whatever the method."""

GROWTHS = (10.0, 100.0, 1e3)
"""Borders between classes of growth."""

UNSURE = 1e-3
"""Distance between two references, px, from which on a body is left out."""

UNSURE_PART = 0.03
"""The same, as a part of the tolerance that a body is to count for."""


@dataclass(frozen=True)
class BodyResult:
    """Results of one random body.

    Attributes:
        seed: `random_bodies.random_body(seed)` makes it again.
        shape, law: its kind and its force law.
        masses: how many.
        growth: largest growth of a nudge of its start along the path.
        doubt: largest distance between the references, px; infinite if one failed.
        left_out: why it does not count, or empty; this does not depend on `auto`.
        error, framed_error: at the end, px, in one call and in a call per frame; infinite where it failed.
        seconds, framed_seconds: of computing, once.
        other_errors: at the end in one call, px, under each of `OTHER_TOLERANCES`.
    """

    seed: int
    shape: str
    law: str
    masses: int
    growth: float
    doubt: float
    left_out: str
    error: float
    framed_error: float
    seconds: float
    framed_seconds: float
    other_errors: tuple[float, ...]


def measure_body(seed: int, scene: Scene | None = None) -> BodyResult:
    """Run a body by the references, by one of them with a nudge of its start, and by `auto`.

    Args:
        seed: see `random_bodies.random_body`.
        scene: another body instead.
    """
    scene = random_body(seed) if scene is None else scene
    first, second = references.METHODS
    path, other = (path_by(scene, method, TIGHT) for method in (first, second))
    nudged = None if path is None else path_by(_nudged(scene, seed), first, TIGHT)
    growth = math.inf if path is None or nudged is None else distance(nudged, path) / NUDGE
    doubt = math.inf if path is None or other is None else distance(other, path)
    left_out = "a reference fails" if path is None or other is None or nudged is None else ""
    if not left_out and growth > CHAOTIC:
        left_out = "chaotic"
    elif not left_out and doubt > UNSURE:
        left_out = "references disagree"
    right = path if path is not None else other
    whole = run(run_at(scene, "auto", TOLERANCE))
    framed = run(run_at(scene, "auto", TOLERANCE, round(SECONDS / FRAME)))
    others = [run(run_at(scene, "auto", tolerance)) for tolerance in OTHER_TOLERANCES]
    error, framed_error, *other_errors = (
        math.inf if trial.path is None or right is None else distance(trial.path[-1], right[-1])
        for trial in (whole, framed, *others)
    )
    shape = scene.name.partition("-")[0]
    return BodyResult(
        seed, shape, scene.force_law, len(scene.masses), growth, doubt, left_out, error, framed_error,
        whole.seconds, framed.seconds, tuple(other_errors),
    )  # fmt: skip


def measure_bodies(count: int) -> Iterator[BodyResult]:
    """Yield the results of the seeds from 0 on."""
    for seed in range(count):
        yield measure_body(seed)


def _nudged(scene: Scene, seed: int) -> Scene:
    """Return the scene with its free masses moved a little, in random directions."""
    shift = np.random.default_rng((7, seed)).normal(size=(len(scene.masses), 2))
    shift[[anchor.mass for anchor in scene.anchors]] = 0.0
    shift *= NUDGE / np.hypot(*shift.T).max()
    positions = np.array([mass.position for mass in scene.masses]) + shift
    pose = Pose(
        positions=tuple((x, y) for x, y in positions.tolist()),
        velocities=tuple(mass.velocity for mass in scene.masses),
    )
    return msgspec.structs.replace(scene, pose=pose)


@dataclass(frozen=True)
class Shares:
    """Summary of the bodies that count.

    Attributes:
        tolerance: px.
        counted: their number.
        within, within_three: the share that ends within the tolerance, and within three times that.
        largest: the largest error, in tolerances.
        beyond: seeds of those that end beyond ten times the tolerance, the worst first.
    """

    tolerance: float
    counted: int
    within: float
    within_three: float
    largest: float
    beyond: tuple[int, ...]


def shares(bodies: Sequence[BodyResult], framed: bool = False) -> Shares:
    """Summarise the bodies that are not left out, in one call or in a call per frame."""
    return _summarise(
        {b.seed: b.framed_error if framed else b.error for b in bodies if not b.left_out}, TOLERANCE
    )


def shares_by_tolerance(bodies: Sequence[BodyResult]) -> list[Shares]:
    """Summarise them in one call, for all tolerances in descending order."""
    found = [shares(bodies)]
    for i, tolerance in enumerate(OTHER_TOLERANCES):
        sure = (b for b in bodies if not b.left_out and b.doubt <= UNSURE_PART * tolerance)
        found.append(_summarise({b.seed: b.other_errors[i] for b in sure}, tolerance))
    return sorted(found, key=lambda shares: -shares.tolerance)


def shares_by_growth(bodies: Sequence[BodyResult], framed: bool = False) -> dict[str, Shares]:
    """Summarise them by the growth of a nudge, chaotic bodies included if their references agree."""
    found = {}
    for low, high in itertools.pairwise((0.0, *GROWTHS, math.inf)):
        those = (b for b in bodies if low <= b.growth < high and b.doubt <= UNSURE)
        what = f"{low:g} to {high:g}" if high < math.inf else f"{low:g} and more"
        found[what] = _summarise({b.seed: b.framed_error if framed else b.error for b in those}, TOLERANCE)
    return found


def _summarise(error: dict[int, float], tolerance: float) -> Shares:
    """Summarise errors, px, by seed."""
    found = sorted((px / tolerance, seed) for seed, px in error.items())
    errors = np.array([error for error, _ in found])
    if not found:
        return Shares(tolerance, 0, math.nan, math.nan, math.nan, ())
    return Shares(
        tolerance=tolerance,
        counted=len(found),
        within=float((errors <= 1.0).mean()),
        within_three=float((errors <= 3.0).mean()),
        largest=found[-1][0],
        beyond=tuple(seed for error, seed in reversed(found) if error > 10.0),
    )
