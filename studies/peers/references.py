"""Where the masses of ropes and nets are in the end, found without softrod: by SciPy's DOP853, tightly.

`python -m studies.peers.references` computes all of it anew, which takes a quarter of an hour, and says how
far softrod's `rodas5p` ends from it.
"""

from __future__ import annotations

import hashlib
import io
import time
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

import sim
from sim import Scene
from sim.store.files import write_file

from .plain import Equations, Floats
from .scenes import COUNT, EVERY, MANY, PATHS, SECONDS, ropes

STORED = Path(__file__).with_name("references.npz")

TIGHT = 1e-10
"""Absolute tolerance, px and px/s; the relative one is a hundredth of it."""

AGREE = 1e-6
"""Tolerance, px, at which softrod is held against it."""


def compute(scene: Scene) -> Floats:
    """(n, 2) positions after `SECONDS`, px."""
    from scipy.integrate import DOP853

    equations = Equations(scene)
    solver: Any = DOP853(
        equations.derivative, 0.0, equations.start, SECONDS, rtol=max(1e-2 * TIGHT, 3e-14), atol=TIGHT
    )
    while solver.status == "running":
        problem = solver.step()
        if problem:
            raise RuntimeError(f"{scene.name}: {problem}")
    return equations.positions(SECONDS, solver.y)


def fingerprint(scene: Scene) -> NDArray[np.uint8]:
    """A digest of all numbers of a scene's equations."""
    equations = Equations(scene)
    numbers = (
        equations.springs, equations.numbers, equations.masses, equations.held, equations.gravity,
        equations.circle or (), equations.start,
    )  # fmt: skip
    digest = hashlib.sha256(b"".join(np.asarray(part, float).tobytes() for part in numbers))
    return np.frombuffer(digest.digest()[:8], np.uint8)


def some_ropes() -> list[Scene]:
    """Those of the many ropes that have a reference."""
    return ropes(COUNT)[::EVERY]


def reference(name: str) -> Floats:
    """(n, 2) positions in the end of a scene of `PATHS`, or of `some_ropes` one after the other, px.

    Raises:
        sim.InputError: the scene is another one than that of the file.
    """
    stored = _stored()
    scenes = some_ropes() if name == MANY else [PATHS[name].make()]
    if not np.array_equal(stored[f"{name} fingerprint"], np.stack([fingerprint(s) for s in scenes])):
        raise sim.InputError(f"{name}: its reference is of another scene; python -m studies.peers.references")
    return stored[name]


@cache
def _stored() -> dict[str, NDArray[Any]]:
    with np.load(STORED) as stored:
        return dict(stored)


def main() -> None:
    """See the module's text."""
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
