"""The table of what acts on a body."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..engine.addresses import ADDRESSES
from ..engine.table import Indices, Table
from ..scene.columns import column
from ..scene.types import Scene
from .all import SURROUNDINGS, TERMS
from .term import Places

_FIELDS = {
    "present": "bool",  # any of `all.SURROUNDINGS` acts
    "touches": "bool",  # any of those that are `Term.touches` does
    "sticks": "bool",  # tangential springs may hold what touches something
    "step": "float",  # s, of an explicit method with a fixed step, which softens touch; else 0
    "mass": "Floats",  # (slots,) kg
    "acting": "Indices",  # (k,) indices in `all.TERMS` of those that act
    "calls": "Indices",  # `engine.addresses.ADDRESSES`
    **{term.field: term.table.__name__ for term in SURROUNDINGS},
}

Environment: Any = type(
    "Environment",
    (Table,),
    {
        "__annotations__": _FIELDS,
        "changing": frozenset({"calls"}),
        "__doc__": "What terms share, and a table for each of `all.SURROUNDINGS`.",
    },
)


def acting_on(scene: Scene) -> tuple[int, ...]:
    """Indices in `all.TERMS` of the terms that act on a valid scene's masses."""
    return tuple(index for index, term in enumerate(TERMS) if term.acts(scene))


def is_surrounded(scene: Scene) -> bool:
    """Whether anything acts on a valid scene's masses besides springs, joints, still air and gravity."""
    return any(term.acts(scene) for term in SURROUNDINGS)


def new_environment(
    scene: Scene,
    mass_index: Indices,
    ends: Indices,
    slots: int,
    spring_order: Indices,
    joint_order: Indices,
    step: float = 0.0,
) -> Any:
    """The `Environment` of a valid scene.

    Args:
        scene: the scene.
        mass_index, ends, slots, spring_order, joint_order: see `Places`.
        step: see `Environment`.
    """
    mass = np.zeros(slots)
    mass[mass_index] = column(scene.masses, "mass")
    places = Places(mass_index, ends, slots, mass, spring_order, joint_order)
    acting = acting_on(scene)
    tables = {term.field: term.new(scene, places) for term in SURROUNDINGS if term.new}
    return Environment(
        present=is_surrounded(scene),
        touches=any(TERMS[index].touches for index in acting),
        sticks=any(term.sticks(tables[term.field]) for term in SURROUNDINGS),
        step=step,
        mass=mass,
        acting=np.array(acting, np.int64),
        calls=ADDRESSES,
        **tables,
    )


EMPTY = Environment.empty().replaced(calls=ADDRESSES, acting=np.arange(len(TERMS) - len(SURROUNDINGS)))
"""The table of a body of springs and joints that nothing surrounds."""
