"""What can be measured of a body, under the same names in Python, in tables and on the command line.

A name says of what and what: `joint3.angle`, `spring0.force`, `mass5.x`, `energy.kinetic`,
`stability.dt_over_limit`. Parts are counted from 0, as in scene files. Everything is read from the present
state and is what the solver goes by: what has yielded has its new rest length or angle, what is broken has no
force, and lengths in forces are softened as `sim.forces.springs` says.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..engine.tables import State
from ..errors import InputError
from ..forces.all import WITH_ENERGY
from ..forces.joints import JointsReference
from ..forces.springs import SpringsReference
from ..model.loads import Loads
from ..model.state import rest_lengths
from ..model.system import System
from ..scene.types import Scene
from .divergence import Divergence
from .energy import ENERGY_FIELDS, Energies
from .stability import StabilityEstimate

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Vectors = NDArray[np.complex128]

ENERGY_UNIT = "kg {unit}²/s²"

_NAMED = {"kg m/s²": "N", "kg m²/s²": "J"}
"""Units that have a name, where lengths are in metres."""

_NAME = re.compile(r"([a-z]+)(\d{1,9})?\.([a-z_]+)", re.ASCII)


class Moving(Protocol):
    """What is read of a body in motion; a `sim.Simulation` is one."""

    @property
    def tables(self) -> tuple[System, State]: ...
    @property
    def angles(self) -> Floats: ...
    @property
    def rest_angles(self) -> Floats: ...
    @property
    def time(self) -> float: ...
    @property
    def dt(self) -> float: ...
    @property
    def loads(self) -> Loads: ...
    @property
    def divergence(self) -> Divergence | None: ...
    def energy(self) -> Energies: ...
    def stability(self) -> StabilityEstimate: ...


@dataclass(frozen=True)
class Kind:
    """Something that can be measured of every part of a kind.

    Attributes:
        of: the kind of part: "joint", "spring" or "mass"; or "energy" and "stability", which a body has once.
        what: the rest of the name.
        unit: with "{unit}" for the scene's unit of length; empty for a pure number.
        summary: what it is, in a few words.
        values: it, for an array of indices of parts (of the scene), (k,) each; for energy and stability,
            the indices have no meaning.
        vertical: whether it is a y coordinate, or the y component of a vector.
        unwrapped: whether it is an angle that goes on beyond half a turn while it is followed.
    """

    of: str
    what: str
    unit: str
    summary: str
    values: Callable[[Moving, Indices], Floats] = field(repr=False, compare=False)
    vertical: bool = False
    unwrapped: bool = False


@dataclass(frozen=True)
class Quantity:
    """Something that is measured of one part of a scene; `quantity` finds it by its name.

    Attributes:
        name: such as "joint3.angle".
        unit: such as "°" or "px/s"; empty for a pure number.
        kind: what it is.
        index: of the part.
    """

    name: str
    unit: str
    kind: Kind
    index: int

    def read(self, simulation: Moving, before: float = math.nan) -> float:
        """Its present value.

        Args:
            simulation: the body.
            before: the value a moment ago, less than half a turn away, from which an angle goes on; without
                it an angle is in (-180, 180].

        Raises:
            InputError: it is an energy, and the kernels for these are still being compiled.
        """
        value = float(self.kind.values(simulation, np.array([self.index]))[0])
        if self.kind.unwrapped and math.isfinite(value) and math.isfinite(before):
            value += 360.0 * round((before - value) / 360.0)
        return value


def unit_in(unit: str, length: str) -> str:
    """A unit with that of length put in for "{unit}"; with metres a force is in N, and an energy in J."""
    unit = unit.format(unit=length)
    return _NAMED.get(unit, unit)


def quantity(name: str, scene: Scene) -> Quantity:
    """A quantity of a scene by its name, such as "joint3.angle".

    Raises:
        InputError: there is no such quantity, or the scene has no such part.
    """
    match = _NAME.fullmatch(name)
    of, digits, what = match.groups() if match else ("", None, "")
    if of not in PARTS:
        parts = ", ".join(f"{part}0" if part in COUNTED else part for part in PARTS)
        raise InputError(f"{name!r} is not a quantity: it begins with one of {parts}, and then a point")
    kind = KINDS.get((of, what))
    if kind is None:
        raise InputError(f"{name!r} is not a quantity: {of} has {', '.join(PARTS[of])}")
    counted = of in COUNTED
    if counted == (digits is None):
        raise InputError(f"{name!r} is not a quantity: {of} {'needs a' if counted else 'has no'} number")
    index = int(digits or 0)
    if counted and index >= (count := COUNTED[of](scene)):
        there = f"(0..{count - 1})" if count else f"(the scene has no {of}s)"
        raise InputError(f"{name}: {of} {index} does not exist {there}")
    whole = f"{of}{index}" if counted else of  # without leading zeros
    unit = unit_in(kind.unit, scene.view.unit)
    return Quantity(f"{whole}.{what}", "N m" if (what, unit) == ("torque", "J") else unit, kind, index)


# ------------------------------------------------------------------------- how they are read
def _masses(simulation: Moving, masses: Indices) -> tuple[Vectors, Vectors]:
    """Positions and velocities of masses."""
    system, state = simulation.tables
    x, v = _all_masses(state)
    slots = system.mass_index[masses]
    return x[slots], v[slots]


def _speeds(simulation: Moving, masses: Indices) -> Floats:
    _, v = _masses(simulation, masses)
    return np.hypot(v.real, v.imag)


def _accelerations(simulation: Moving, masses: Indices) -> Vectors:
    system, state = simulation.tables
    forces = simulation.loads.forces[masses]
    return (forces[:, 0] + 1j * forces[:, 1]) * state.inverse_mass[system.mass_index[masses]]


def _all_masses(state: State) -> tuple[Vectors, Vectors]:
    """(slots,) positions and velocities."""
    return state.x + 1j * state.y, state.vx + 1j * state.vy


def _spring_rows(simulation: Moving, springs: Indices) -> Indices:
    """Rows of springs in the tables."""
    order = simulation.tables[0].spring_order
    return np.flatnonzero(order == springs[0]) if springs.size == 1 else np.argsort(order)[springs]


def _lengths(simulation: Moving, springs: Indices) -> Floats:
    (system, state), rows = simulation.tables, _spring_rows(simulation, springs)
    a, b = system.body.spring_a[rows], system.body.spring_b[rows]
    return np.hypot(state.x[b] - state.x[a], state.y[b] - state.y[a])


def _directions(simulation: Moving, springs: Indices) -> Floats:
    """Degrees."""
    (system, state), rows = simulation.tables, _spring_rows(simulation, springs)
    a, b = system.body.spring_a[rows], system.body.spring_b[rows]
    return np.degrees(np.arctan2(state.y[b] - state.y[a], state.x[b] - state.x[a]))


def _elongations(simulation: Moving, springs: Indices) -> Floats:
    (system, state), rows = simulation.tables, _spring_rows(simulation, springs)
    return _lengths(simulation, springs) - rest_lengths(system.body, state)[rows]


def _pulls(simulation: Moving, springs: Indices) -> Floats:
    (system, state), rows = simulation.tables, _spring_rows(simulation, springs)
    pulls = SpringsReference(system.body, state, rows).pulls(*_all_masses(state))
    return np.where(state.broken[rows] > 0.0, 0.0, pulls) if system.body.limits.present else pulls


def _joints(simulation: Moving, joints: Indices) -> tuple[JointsReference, tuple[Vectors, Vectors]]:
    """Some joints, and the positions and velocities of all masses."""
    system, state = simulation.tables
    return JointsReference(system.body, state, system.joint_order[joints]), _all_masses(state)


def _bending(simulation: Moving, joints: Indices) -> Floats:
    """Rates at which angles grow, radians/s."""
    joint_forces, masses = _joints(simulation, joints)
    return joint_forces.rates(*masses)


def _torques(simulation: Moving, joints: Indices) -> Floats:
    joint_forces, masses = _joints(simulation, joints)
    return joint_forces.torques(*masses)


def _of_energy(name: str) -> Callable[[Moving, Indices], Floats]:
    return lambda simulation, _: np.array([getattr(simulation.energy(), name)])


def _over_limit(simulation: Moving, _: Indices) -> Floats:
    # A body that has exploded is far from the shape in which its step became too long.
    estimate = simulation.stability() if simulation.divergence is None else simulation.divergence.stability
    return np.array([simulation.dt / estimate.limit])


# ------------------------------------------------------------------------- the catalogue
_ENERGY_SUMMARIES = {
    "total": "sum of the energies",
    "kinetic": "kinetic energy",
    "gravity": "energy of height and of constant forces",
    **{term.name: f"energy of {term.label}" for term in WITH_ENERGY},
    "anchors": "work of moved anchors and of a hand",
    "damping": "work of the springs' damping",
    "air": "work of the air",
    "friction": "work of friction and of bouncing",
    "plastic": "energy change by yielding",
    "broken": "energy change by breaking",
    "law": "work of a law without an energy",
    "keys": "work of the arrow keys",
    "muscles": "work of the muscles",
    "changes": "energy change by changes of settings",
    "fallbacks": "energy change by fallback steps",
    "residual": "error of the energy balance",
}

_ALL = (
    Kind(
        "joint", "angle", "°", "angle from its first spring to its second, which goes on beyond 180°",
        lambda simulation, joints: simulation.angles[joints], unwrapped=True,
    ),
    Kind(
        "joint", "rate", "°/s", "rate at which the angle grows",
        lambda simulation, joints: np.degrees(_bending(simulation, joints)),
    ),
    Kind(
        "joint", "rest_angle", "°", "rest angle, with what keys and yielding did to it",
        lambda simulation, joints: simulation.rest_angles[joints],
    ),
    Kind(
        "joint", "torque", ENERGY_UNIT,
        "torque of stiffness and damping on its first spring, from +x towards +y: positive where the angle "
        "is larger than the rest angle", _torques,
    ),
    Kind(
        "joint", "wrapped_angle", "°", "angle, in (-180, 180]",
        lambda simulation, joints: simulation.angles[joints],
    ),
    Kind("spring", "length", "{unit}", "length", _lengths),
    Kind("spring", "elongation", "{unit}", "length minus rest length", _elongations),
    Kind(
        "spring", "direction", "°",
        "direction from its first mass to its second, from +x towards +y, which goes on beyond 180°",
        _directions, unwrapped=True,
    ),
    Kind(
        "spring", "force", "kg {unit}/s²",
        "force of stiffness and damping along the spring; positive where it pulls", _pulls,
    ),
    Kind("spring", "wrapped_direction", "°", "direction, in (-180, 180]", _directions),
    Kind("mass", "x", "{unit}", "x coordinate", lambda *of: _masses(*of)[0].real),
    Kind(
        "mass", "y", "{unit}", "y coordinate, as the scene counts it",
        lambda *of: _masses(*of)[0].imag, vertical=True,
    ),
    Kind("mass", "vx", "{unit}/s", "velocity along x", lambda *of: _masses(*of)[1].real),
    Kind(
        "mass", "vy", "{unit}/s", "velocity along y", lambda *of: _masses(*of)[1].imag, vertical=True
    ),
    Kind("mass", "speed", "{unit}/s", "speed", _speeds),
    Kind(
        "mass", "ax", "{unit}/s²", "acceleration along x; 0 while it is held",
        lambda *of: _accelerations(*of).real,
    ),
    Kind(
        "mass", "ay", "{unit}/s²", "acceleration along y; 0 while it is held",
        lambda *of: _accelerations(*of).imag, vertical=True,
    ),
    *(
        Kind("energy", name, ENERGY_UNIT, _ENERGY_SUMMARIES[name], _of_energy(name))
        for name in ("total", *ENERGY_FIELDS)
    ),
    Kind(
        "stability", "dt_over_limit", "",
        "time step over the largest stable one; 0 where there is no limit", _over_limit,
    ),
)  # fmt: skip

KINDS: dict[tuple[str, str], Kind] = {(kind.of, kind.what): kind for kind in _ALL}
"""Everything that can be measured, by the two parts of its name."""

PARTS: dict[str, tuple[str, ...]] = {
    of: tuple(kind.what for kind in _ALL if kind.of == of) for of in dict.fromkeys(kind.of for kind in _ALL)
}
"""What can be measured of each kind of part."""

COUNTED: dict[str, Callable[[Scene], int]] = {
    "joint": lambda scene: len(scene.angular_springs),
    "spring": lambda scene: len(scene.linear_springs),
    "mass": lambda scene: len(scene.masses),
}
"""How many parts of a kind a scene has; there is one energy balance, and one stability limit."""
