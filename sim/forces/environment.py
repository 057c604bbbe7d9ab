"""The table of all that acts on a body besides springs, still air and gravity."""

from __future__ import annotations

import numpy as np

from ..kernels.engine.addresses import ADDRESSES
from ..kernels.engine.table import Floats, Indices, Table
from ..scene.columns import column
from ..scene.types import Scene, is_surrounded
from .air import Air, new_air, still_air
from .all import TERMS
from .contact_pairs import Contacts, new_contacts
from .fillings import Fillings, new_fillings
from .resistance import Resistance, new_resistance
from .walls import Walls, new_walls

_NO_TERMS = np.zeros(0, np.int64)


class Environment(Table):
    """A table for each term in `all.TERMS`, and what they share."""

    present: bool  # anything is in these tables
    step: float  # s, of an explicit method with a fixed step, which softens walls and contact; 0 for others
    mass: Floats  # (slots,) kg
    acting: Indices  # (k,) indices in `all.TERMS` of those that act
    calls: Indices  # `kernels.engine.addresses.ADDRESSES`
    air: Air
    resistance: Resistance
    walls: Walls
    fillings: Fillings
    contact: Contacts


def new_environment(
    scene: Scene, mass_index: Indices, ends: Indices, slots: int, step: float = 0.0
) -> Environment:
    """The table of a valid scene.

    Args:
        scene: the scene.
        mass_index: (n,) the slot of each of its masses.
        ends: (S, 2) the slots of the masses at the ends of each spring, in the order of the tables.
        slots: number of slots of a state.
        step: see `Environment`.
    """
    mass = np.zeros(slots)
    mass[mass_index] = column(scene.masses, "mass")
    mass.setflags(write=False)
    present = is_surrounded(scene)
    around = Environment(
        present=present,
        step=step,
        mass=mass,
        acting=_NO_TERMS,
        calls=ADDRESSES,
        air=new_air(scene) if present else still_air(scene.air_friction),
        resistance=new_resistance(scene, ends, mass),
        walls=new_walls(scene),
        fillings=new_fillings(scene, mass_index),
        contact=new_contacts(scene, mass_index, ends, slots),
    )
    acting = [index for index, term in enumerate(TERMS) if term.acts(around)]
    return around.replaced(acting=np.array(acting, np.int64)) if acting else around


EMPTY = Environment.empty().replaced(calls=ADDRESSES)
"""The table of a body that has none yet."""
