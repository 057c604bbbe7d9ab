"""What can be measured of a body, under the same names in Python, in tables and on the command line.

A name says of what and what: `joint3.angle`, `spring0.force`, `mass5.x`, `body.vx`, `energy.kinetic`,
`stability.dt_over_limit`. Parts are counted from 0, as in scene files. `body[2,5..7].x` is of some masses of
the body. Everything is read from the present state and is what the solver goes by: what has yielded has its
new rest length or angle, what is broken has no force, and lengths in forces are softened as
`sim.forces.springs` says. A held mass has the velocity of what holds it, and so its momentum.

A formula of such quantities is a quantity, too; see `formulas`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Protocol, cast

import numpy as np
from numpy.typing import NDArray

from ..engine.tables import State
from ..errors import InputError, Part, did_you_mean, no_part_of_scene, of_field
from ..forces.all import WITH_ENERGY
from ..forces.joints import JointsReference
from ..forces.springs import SpringsReference
from ..model.loads import Loads
from ..model.state import rest_lengths
from ..model.system import System
from ..scene.types import Scene
from ..text import Text
from .dimensions import Dimension, dimension_of
from .divergence import Divergence
from .energy import ENERGY_FIELDS, Energies
from .formulas import MAX_LENGTH, Formula, Measured, read_formula
from .stability import StabilityEstimate

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Vectors = NDArray[np.complex128]

ENERGY_UNIT = "kg {unit}²/s²"

_NAMED = {"kg m/s²": "N", "kg m²/s²": "J"}
"""Units that have a name, where lengths are in metres."""

MOMENTUM_UNIT = "kg {unit}/s"

_NAME = re.compile(r"([a-z]+)(\d{1,9}|\[[\d., ]{1,190}\])?\.([a-z_]+)", re.ASCII)

_IS_FORMULA = re.compile(r"[-+*/^() ]")
"""Found in every formula, and in a name only between masses."""

_RANGE = re.compile(r" *(\d{1,9}) *(?:\.\. *(\d{1,9}) *)?", re.ASCII)


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
        of: the kind of part: "joint", "spring" or "mass"; or "body", "energy" and "stability", which exist
            once; or "formula".
        what: the rest of the name.
        unit: with "{unit}" for the scene's unit of length; empty for a pure number.
        summary: what it is, in a few words.
        values: it, for an array of indices of parts (of the scene), (k,) each; (1,) for what exists once.
            For "body" the indices are those of its masses, and without any it is all of them.
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
    """Something that is measured of a scene; `quantity` finds it by its name.

    Attributes:
        name: such as "joint3.angle"; of a formula its text.
        unit: such as "°" or "px/s"; empty for a pure number.
        kind: what it is.
        indices: of the part; of some masses of a body those, and none for all.
        formula: what is computed from the quantities that it names; None if it is measured itself.
        leaves: these quantities, in the order of `Formula.names`.
    """

    name: str
    unit: str
    kind: Kind
    indices: tuple[int, ...] = ()
    formula: Formula | None = None
    leaves: tuple[Quantity, ...] = ()

    @property
    def index(self) -> int:
        """That of the only part; -1 if it is not of one part."""
        return self.indices[0] if len(self.indices) == 1 else -1

    @property
    def measured(self) -> tuple[Quantity, ...]:
        """The quantities that are measured for it: itself, or those in its formula."""
        return self.leaves or (self,)

    @property
    def dimension(self) -> Dimension:
        """The powers of its unit."""
        return dimension_of(self.kind.unit)

    @property
    def unwrapped(self) -> bool:
        """Whether it is an angle that goes on beyond half a turn while it is followed."""
        return self.kind.unwrapped

    def is_of(self, of: str) -> bool:
        """Whether anything of a kind is measured for it, such as "energy"."""
        return any(each.kind.of == of for each in self.measured)

    def read(self, simulation: Moving, before: float = math.nan) -> float:
        """Its present value; NaN where a formula has none, as after a division by zero.

        Args:
            simulation: the body.
            before: the value a moment ago, less than half a turn away, from which an angle goes on; without
                it an angle is in (-180, 180].

        Raises:
            InputError: it is an energy, and the kernels for these are still being compiled.
        """
        found = [
            float(each.kind.values(simulation, np.array(each.indices, np.int64))[0]) for each in self.measured
        ]
        return self.value(found, before)

    def value(self, values: Sequence[float], before: float = math.nan) -> float:
        """Its value for those of the `measured`; see `read`."""
        value = values[0] if self.formula is None else self.formula.value(values)
        if self.unwrapped and math.isfinite(value) and math.isfinite(before):
            value += 360.0 * round((before - value) / 360.0)
        return value


def unit_in(unit: str, length: str) -> str:
    """A unit with that of length put in for "{unit}"; with metres a force is in N, and an energy in J."""
    unit = unit.format(unit=length)
    return _NAMED.get(unit, unit)


def quantity(name: str, scene: Scene) -> Quantity:
    """A quantity of a scene by its name, such as "joint3.angle", or by a formula of names, see `formulas`.

    Raises:
        InputError: there is no such quantity, the scene has no such part, or it is not a formula.
    """
    name = name.strip(" ")
    if len(name) > MAX_LENGTH:
        raise InputError(
            Text(
                "a quantity is named in at most {most} letters, and not in {count}",
                most=MAX_LENGTH,
                count=len(name),
            )
        )
    if not _IS_FORMULA.search(name):
        return _named(name, scene)
    text = re.sub(" +", " ", name)
    formula = read_formula(text, lambda leaf: _named(leaf, scene), scene.view.unit)
    leaves = tuple(_named(leaf, scene) for leaf in formula.names)
    if isinstance(formula.tree, Measured):
        return leaves[0]
    unit = formula.dimension.unit
    kind = Kind("formula", text, unit, "formula of quantities", _of_leaves, unwrapped=formula.unwrapped)
    return Quantity(text, unit_in(unit, scene.view.unit), kind, (), formula, leaves)


def _named(name: str, scene: Scene) -> Quantity:
    """The quantity of a name that is no formula."""
    match = _NAME.fullmatch(name)
    of, which, what = match.groups() if match else ("", None, "")
    if of not in PARTS:
        parts = ", ".join(f"{part}0" if part in COUNTED else part for part in PARTS)
        raise InputError(
            Text(
                "{name!r} is not a quantity: it begins with one of {parts}, and then a point{meant}",
                name=name,
                parts=parts,
                meant=did_you_mean(of, PARTS),
            )
        )
    kind = KINDS.get((of, what))
    if kind is None:
        meant = did_you_mean(what, PARTS[of])
        raise InputError(
            Text(
                "{name!r} is not a quantity: {of} has {known}{meant}",
                name=name,
                of=of,
                known=", ".join(PARTS[of]),
                meant=meant,
            )
        )
    counted, is_some = of in COUNTED, which is not None and which.startswith("[")
    if of != "body" if is_some else counted == (which is None):
        raise InputError(
            Text("{name!r} is not a quantity: {of} needs a number", name=name, of=of)
            if counted
            else Text("{name!r} is not a quantity: {of} has no number", name=name, of=of)
        )
    indices: tuple[int, ...] = ()
    whole = of
    if is_some:
        indices = _some_masses(name, which or "", scene)
        whole = of + (which or "").replace(" ", "")
    elif which is not None:
        indices = (int(which),)
        whole = f"{of}{indices[0]}"  # without leading zeros
        _check_part(name, of, indices[0], scene)
    unit = unit_in(kind.unit, scene.view.unit)
    return Quantity(f"{whole}.{what}", "N m" if (what, unit) == ("torque", "J") else unit, kind, indices)


def _check_part(name: str, of: str, index: int, scene: Scene) -> None:
    if index >= (count := COUNTED[of](scene)):
        raise InputError(of_field(name, no_part_of_scene(cast(Part, of), index, count)))


def _some_masses(name: str, which: str, scene: Scene) -> tuple[int, ...]:
    """The masses in brackets, as in "[2,5..7]", each once."""
    found: set[int] = set()
    for part in which[1:-1].split(","):
        match = _RANGE.fullmatch(part)
        if match is None:
            raise InputError(
                Text("{name!r} is not a quantity: masses are named as in body[2,5..7]", name=name)
            )
        first = int(match[1])
        last = int(match[2] or first)
        if last < first:
            raise InputError(
                Text(
                    "{name!r} is not a quantity: {first}..{last} goes backwards",
                    name=name,
                    first=first,
                    last=last,
                )
            )
        _check_part(name, "mass", last, scene)
        found.update(range(first, last + 1))
    return tuple(sorted(found))


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


def _momenta(simulation: Moving, masses: Indices) -> Vectors:
    m, _, v = _bodies(simulation, masses)
    return m * v


def _bodies(simulation: Moving, masses: Indices) -> tuple[Floats, Vectors, Vectors]:
    """Masses, positions and velocities of some masses; of all for no index."""
    system = simulation.tables[0]
    masses = masses if masses.size else np.arange(system.mass_index.size)
    return system.body.environment.mass[system.mass_index[masses]], *_masses(simulation, masses)


def _centre(simulation: Moving, masses: Indices) -> tuple[complex, complex]:
    """Position and velocity of the centre of mass."""
    m, x, v = _bodies(simulation, masses)
    return complex(m @ x / m.sum()), complex(m @ v / m.sum())


def _momentum(simulation: Moving, masses: Indices) -> complex:
    return complex(_momenta(simulation, masses).sum())


def _angular_momentum(simulation: Moving, masses: Indices, of_centre: bool) -> float:
    """Angular momentum about the centre of mass or the origin, positive from +x towards +y."""
    m, x, v = _bodies(simulation, masses)
    if of_centre:
        place, velocity = _centre(simulation, masses)
        x, v = x - place, v - velocity
    return float((m * (x.conj() * v).imag).sum())


def _of_body(read: Callable[[Moving, Indices], float]) -> Callable[[Moving, Indices], Floats]:
    return lambda simulation, masses: np.array([read(simulation, masses)])


def _of_leaves(simulation: Moving, _: Indices) -> Floats:
    return np.full(1, np.nan)  # a formula is computed from its leaves, see `Quantity.read`


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
    "motors": "work of the motors",
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
    Kind("mass", "mass", "kg", "mass", lambda *of: _bodies(*of)[0]),
    Kind("mass", "momentum_x", MOMENTUM_UNIT, "momentum along x", lambda *of: _momenta(*of).real),
    Kind(
        "mass", "momentum_y", MOMENTUM_UNIT, "momentum along y", lambda *of: _momenta(*of).imag, vertical=True
    ),
    Kind(
        "body", "x", "{unit}", "x coordinate of the centre of mass",
        _of_body(lambda *of: _centre(*of)[0].real),
    ),
    Kind(
        "body", "y", "{unit}", "y coordinate of the centre of mass",
        _of_body(lambda *of: _centre(*of)[0].imag), vertical=True,
    ),
    Kind(
        "body", "vx", "{unit}/s", "velocity of the centre of mass along x",
        _of_body(lambda *of: _centre(*of)[1].real),
    ),
    Kind(
        "body", "vy", "{unit}/s", "velocity of the centre of mass along y",
        _of_body(lambda *of: _centre(*of)[1].imag), vertical=True,
    ),
    Kind("body", "mass", "kg", "total mass", _of_body(lambda *of: float(_bodies(*of)[0].sum()))),
    Kind(
        "body", "momentum_x", MOMENTUM_UNIT, "total momentum along x",
        _of_body(lambda *of: _momentum(*of).real),
    ),
    Kind(
        "body", "momentum_y", MOMENTUM_UNIT, "total momentum along y",
        _of_body(lambda *of: _momentum(*of).imag), vertical=True,
    ),
    Kind(
        "body", "angular_momentum", "kg {unit}²/s",
        "angular momentum about the centre of mass, from +x towards +y",
        _of_body(lambda *of: _angular_momentum(*of, of_centre=True)),
    ),
    Kind(
        "body", "angular_momentum_about_origin", "kg {unit}²/s",
        "angular momentum about the origin, from +x towards +y",
        _of_body(lambda *of: _angular_momentum(*of, of_centre=False)),
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
