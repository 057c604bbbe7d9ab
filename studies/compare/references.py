"""References: what errors are measured against.

Positions of ropes and nets at the end are found without softrod, by SciPy's DOP853 at a tight tolerance, and
stored. `python -m studies.compare.references` computes all of them again, which takes a quarter of an hour,
and says how far softrod's `rodas5p` ends from them. Of any other scene, a reference is what two methods of
softrod agree on.
"""

from __future__ import annotations

import hashlib
import io
import time
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

import sim
from sim import Scene
from sim.store.files import write_file

from .engines.softrod import run_at
from .plain import PlainSystem
from .runs import FRAME, SECONDS, Floats, distance, run
from .scenes import COUNT, EVERY, MANY, PATHS, ropes

STORED = Path(__file__).with_name("references.npz")

TIGHT = 1e-10
"""Absolute tolerance, px and px/s; the relative one is a hundredth of it."""

AGREE = 1e-6
"""Tolerance, px, at which softrod is compared with it."""


def compute(scene: Scene) -> Floats:
    """Return the (n, 2) positions after `SECONDS`, px."""
    from scipy.integrate import DOP853

    system = PlainSystem(scene)
    solver: Any = DOP853(
        system.derivative, 0.0, system.start, SECONDS, rtol=max(1e-2 * TIGHT, 3e-14), atol=TIGHT
    )
    while solver.status == "running":
        problem = solver.step()
        if problem:
            raise RuntimeError(f"{scene.name}: {problem}")
    return system.positions(SECONDS, solver.y)


def fingerprint(scene: Scene) -> NDArray[np.uint8]:
    """A digest of all numbers of a scene's system."""
    system = PlainSystem(scene)
    numbers = (
        system.springs, system.numbers, system.masses, system.held, system.gravity,
        system.circle or (), system.start,
    )  # fmt: skip
    digest = hashlib.sha256(b"".join(np.asarray(part, float).tobytes() for part in numbers))
    return np.frombuffer(digest.digest()[:8], np.uint8)


def some_ropes() -> list[Scene]:
    """Return those of the many ropes that have a reference."""
    return ropes(COUNT)[::EVERY]


def reference(name: str) -> Floats:
    """Return the stored (n, 2) positions at the end of a scene of `PATHS`, or of all of `some_ropes`, px.

    Raises:
        sim.InputError: the scene differs from that of the file.
    """
    stored = _stored()
    scenes = some_ropes() if name == MANY else [PATHS[name].make()]
    if not np.array_equal(stored[f"{name} fingerprint"], np.stack([fingerprint(s) for s in scenes])):
        raise sim.InputError(
            f"{name}: its reference is of another scene; python -m studies.compare.references"
        )
    return stored[name]


@cache
def _stored() -> dict[str, NDArray[Any]]:
    with np.load(STORED) as stored:
        return dict(stored)


METHODS = ("adams", "rodas5p")
"""Methods of very different kinds, whose agreement makes a reference."""


@dataclass(frozen=True)
class Agreed:
    """A reference on which two methods agree.

    Attributes:
        path: (frames, n, 2) px.
        doubt: largest distance between the two, px; infinite where one of them fails.
    """

    path: Floats
    doubt: float


def path_by(scene: Scene, method: str, tolerance: float) -> Floats | None:
    """Return the (frames, n, 2) path by a method, px; None where it fails."""
    return run(run_at(scene, method, tolerance, round(SECONDS / FRAME))).path


def agreed_reference(scene: Scene, tolerances: tuple[float, ...], good: float) -> Agreed:
    """Return the path of the first of `METHODS`, at the tolerance where both agree best.

    Args:
        scene: a valid scene.
        tolerances: px, from large to small.
        good: agreement, px, at which no smaller tolerance is tried.

    Raises:
        sim.InputError: both fail.
    """
    best: Agreed | None = None
    for tolerance in tolerances:
        paths = [path_by(scene, method, tolerance) for method in METHODS]
        arrived = [path for path in paths if path is not None]
        if not arrived:
            continue
        found = Agreed(arrived[0], distance(*arrived) if len(arrived) == 2 else np.inf)
        if best is None or found.doubt < best.doubt:
            best = found
        if best.doubt <= good:
            break
    if best is None:
        raise sim.InputError(f"{scene.name}: no method gets to the end of {SECONDS:g} s at tight tolerances")
    return best


def main() -> None:
    """Compute all stored references."""
    arrays: dict[str, NDArray[Any]] = {}
    for name in (*PATHS, MANY):
        scenes = some_ropes() if name == MANY else [PATHS[name].make()]
        began = time.perf_counter()
        arrays[name] = np.concatenate([compute(scene) for scene in scenes])
        arrays[f"{name} fingerprint"] = np.stack([fingerprint(scene) for scene in scenes])
        spent = time.perf_counter() - began
        exact, ends = sim.Integrator(method="rodas5p", dt=SECONDS, tolerance=AGREE), []
        for scene in scenes:
            simulation = sim.Simulation(msgspec.structs.replace(scene, integrator=exact))
            simulation.step()
            ends.append(simulation.positions)
        off = np.hypot(*(np.concatenate(ends) - arrays[name]).T).max()
        print(f"{name}: {spent:.1f} s; softrod's rodas5p at {AGREE:g} px is {off:.2g} px away", flush=True)
    packed = io.BytesIO()
    np.savez_compressed(packed, allow_pickle=False, **arrays)
    write_file(STORED, packed.getvalue())


if __name__ == "__main__":
    main()
