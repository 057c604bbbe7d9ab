"""The table of all that acts on a body besides springs, still air and gravity."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..kernels.engine.addresses import ADDRESSES
from ..kernels.engine.table import Indices, Table
from ..scene.columns import column
from ..scene.types import Scene
from .all import TERMS
from .term import Places

_NO_TERMS = np.zeros(0, np.int64)

_FIELDS = {
    "present": "bool",  # any term acts
    "touches": "bool",  # any of those that are `Term.touches` does
    "step": "float",  # s, of an explicit method with a fixed step, which softens touch; else 0
    "mass": "Floats",  # (slots,) kg
    "acting": "Indices",  # (k,) indices in `all.TERMS` of those that act
    "calls": "Indices",  # `kernels.engine.addresses.ADDRESSES`
    **{term.field: term.table.__name__ for term in TERMS},
}

Environment: Any = type(
    "Environment",
    (Table,),
    {"__annotations__": _FIELDS, "__doc__": "A table for each term in `all.TERMS`, and what they share."},
)


def acting_on(scene: Scene) -> tuple[int, ...]:
    """Indices in `all.TERMS` of the terms that act on a valid scene's masses."""
    return tuple(index for index, term in enumerate(TERMS) if term.acts(scene))


def new_environment(scene: Scene, mass_index: Indices, ends: Indices, slots: int, step: float = 0.0) -> Any:
    """The `Environment` of a valid scene.

    Args:
        scene: the scene.
        mass_index, ends, slots: see `Places`.
        step: see `Environment`.
    """
    mass = np.zeros(slots)
    mass[mass_index] = column(scene.masses, "mass")
    mass.setflags(write=False)
    places = Places(mass_index, ends, slots, mass)
    acting = acting_on(scene)
    return Environment(
        present=bool(acting),
        touches=any(TERMS[index].touches for index in acting),
        step=step,
        mass=mass,
        acting=np.array(acting, np.int64) if acting else _NO_TERMS,
        calls=ADDRESSES,
        **{term.field: term.new(scene, places) for term in TERMS},
    )


EMPTY = Environment.empty().replaced(calls=ADDRESSES)
"""The table of a body that has none yet."""
