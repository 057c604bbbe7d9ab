"""The table of a scene's contact, and which pairs never touch."""

from __future__ import annotations

import numpy as np

from ..kernels.core.contacts import Contacts
from ..kernels.core.tables import Indices, padded
from ..near import near_pairs
from ..scene.types import Scene

_APART = 1.25
"""Distance, as a multiple of that of contact, below which a mass never touches a spring of its own body."""

_MARGIN = 0.5
"""Margin of the list of pairs, as a fraction of the distance of contact or of a typical spring's length."""
_ROOM = 64
"""Room in the list, in masses for each spring. If it does not suffice, finding pairs takes longer."""


def new_contacts(scene: Scene, mass_index: Indices, ends: Indices, slots: int, loss: float) -> Contacts:
    """The table of a valid scene.

    A mass never touches the springs that it is an end of. Nor does it touch a spring of its own body to which
    it is, as the scene's masses say (and not its pose), nearer than 1.25 times the distance of contact. So
    a body is at rest as it is built, however fine its mesh is. Parts of a scene that no springs connect are
    different bodies, which touch from the start.

    Args:
        scene: the scene.
        mass_index: (n,) the slot of each of its masses.
        ends: (S, 2) the slots of the masses at the ends of each spring, in the order of the tables.
        slots: number of slots of a state.
        loss: factor of the speed in the damping, s/px.
    """
    contact, springs, n = scene.contact, len(ends), len(scene.masses)
    if contact is None or contact.distance == 0.0 or not springs:
        springs = n = slots = 0
        distance = margin = 1.0
        pairs = np.zeros((2, 0), np.int64)
    else:
        distance = contact.distance
        x = np.zeros(slots, complex)
        x[mass_index] = [complex(*mass.position) for mass in scene.masses]
        margin = max(_MARGIN * max(distance, float(np.median(np.abs(x[ends[:, 1]] - x[ends[:, 0]])))), 1e-3)
        pairs = _apart(x, np.sort(mass_index), ends, _APART * distance)
    return Contacts(
        present=bool(springs),
        distance=distance,
        stiffness=contact.stiffness if contact else 0.0,
        friction=contact.friction if contact else 0.0,
        slip=contact.slip_speed if contact else 1.0,
        loss=loss,
        margin=margin,
        cell=2.0 * (distance + margin),
        apart_start=np.searchsorted(pairs[0], np.arange(springs + 1)),
        apart=np.ascontiguousarray(pairs[1]),
        broken=np.zeros(springs),
        number=np.full(1, -1.0),
        crowded=np.zeros(1, np.int64),
        at=np.zeros(2 * slots),
        start=np.zeros(springs + 1, np.int64),
        member=np.zeros(_ROOM * springs + n, np.int64),
        bucket_start=np.zeros(2 ** (padded(2 * n).bit_length()) + 1, np.int64),
        bucket=np.zeros(n, np.int64),
        column=np.zeros(slots, np.int64),
        row=np.zeros(slots, np.int64),
    )


def _apart(x: np.ndarray, masses: Indices, ends: Indices, distance: float) -> Indices:
    """(2, k) springs and the masses that never touch them, in order."""
    spring, mass = near_pairs(x, masses, ends, distance)
    body = _bodies(ends, x.size)
    own = body[mass] == body[ends[spring, 0]]
    return np.stack((spring[own], mass[own]))  # the ends of each spring are among them


def _bodies(ends: Indices, slots: int) -> Indices:
    """(slots,) a number of the body that each mass belongs to."""
    root = list(range(slots))

    def find(mass: int) -> int:
        while root[mass] != mass:
            root[mass] = root[root[mass]]
            mass = root[mass]
        return mass

    for a, b in ends.tolist():
        root[find(a)] = find(b)
    return np.array([find(mass) for mass in range(slots)], np.int64)
