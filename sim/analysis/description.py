"""What can be said of a body at a moment: of which parts it consists, what holds it, how it lies and moves.

These are numbers and kinds, no sentences: `app` puts them into words. All of them are read from the present
state, and so is what is broken; y is up or down as the scene draws it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..forces.all import TERMS
from ..forces.reference import Physics
from ..motion.quantities import Moving, quantity
from ..scene.types import Scene

Floats = NDArray[np.float64]

Shape = Literal["mass", "chain", "ring", "tree", "net"]
"""What masses and springs are: one mass; a row; a closed row; branches without a loop; anything else."""

Side = Literal["left", "right", "top", "bottom", "leftTop", "rightTop", "leftBottom", "rightBottom", "inside"]
"""Where a mass is in the body's bounding box."""

# Unless noted, doubling or halving one of these numbers fails no test.
_EDGE = 0.1
"""Part of the bounding box that counts as its edge."""
_PLAIN = 0.15
"""Part of the larger side of the box below which the smaller says nothing about where a mass is."""
STILL = 0.5
"""Speed of the fastest mass, px/s, up to which a body is at rest."""
STRAINED = 0.005
"""Strain from which on a spring counts as stretched or squeezed."""


@dataclass(frozen=True, slots=True)
class Motion:
    """Where some masses are and how they move; lengths in px, as the scene has them.

    Attributes:
        centre: of all of them.
        drift: (vx, vy) of that, px/s.
        turning: angular velocity about it, rad/s, counterclockwise as it is drawn; 0 for a single mass.
        fastest: number of the fastest mass.
        velocity: of that, px/s.
        lowest: number of the lowest mass, as it is drawn.
        hangs: how far that is below the highest held mass, px; None if none is held.
    """

    centre: tuple[float, float]
    drift: tuple[float, float]
    turning: float
    fastest: int
    velocity: tuple[float, float]
    lowest: int
    hangs: float | None

    @property
    def speed(self) -> float:
        """Of the fastest mass, px/s."""
        return math.hypot(*self.velocity)

    @property
    def is_still(self) -> bool:
        """Whether they are at rest."""
        return self.speed <= STILL


@dataclass(frozen=True, slots=True)
class Piece:
    """Masses that intact springs connect.

    Attributes:
        shape: what they are.
        masses: their numbers in the scene.
        springs, joints: how many, without what is broken.
        loops: closed ways along springs that are independent of each other.
        held: the numbers of those that are held.
        sides: where each of `held` is in the piece.
        motion: of its masses.
    """

    shape: Shape
    masses: tuple[int, ...]
    springs: int
    joints: int
    loops: int
    held: tuple[int, ...]
    sides: tuple[Side, ...]
    motion: Motion


@dataclass(frozen=True, slots=True)
class Description:
    """A body at a moment; lengths in px, as the scene has them.

    Attributes:
        time: s.
        pieces: the largest first.
        box: xmin, ymin, xmax, ymax of the masses.
        motion: of all masses.
        stretched, squeezed: the spring with the largest strain, and that with the smallest, with the strain;
            None where no spring has one.
        broken, yielded: how many springs; `yielded` counts joints, too.
        touching: how many masses touch a wall or another body.
    """

    time: float
    pieces: tuple[Piece, ...]
    box: tuple[float, float, float, float]
    motion: Motion
    stretched: tuple[int, float] | None
    squeezed: tuple[int, float] | None
    broken: int
    yielded: int
    touching: int


def describe(simulation: Moving, scene: Scene) -> Description:
    """Describe a body.

    Args:
        simulation: what moves it.
        scene: its scene.
    """
    system, state = simulation.tables
    index = system.mass_index
    x, v = state.x[index] + 1j * state.y[index], state.vx[index] + 1j * state.vy[index]
    mass = system.body.environment.mass[index]
    broken = broken_springs(simulation, scene)
    strains = _strains(simulation, scene, broken)
    body = _Masses(x, v, mass, {anchor.mass for anchor in scene.anchors}, -1.0 if scene.view.y_down else 1.0)
    return Description(
        time=simulation.time,
        pieces=_pieces(scene, broken, body),
        box=(x.real.min(), x.imag.min(), x.real.max(), x.imag.max()),
        motion=body.motion(np.arange(len(x))),
        stretched=_largest(strains, 1.0),
        squeezed=_largest(strains, -1.0),
        broken=int(broken.sum()),
        yielded=int(np.count_nonzero(state.set_length) + np.count_nonzero(state.set_angle)),
        touching=int(np.any([force != 0.0 for force in touches(simulation).values()], axis=0).sum()),
    )


@dataclass(frozen=True, slots=True)
class _Masses:
    """All masses of a scene, in its order.

    Attributes:
        x, v: (n,) places, px, and velocities, px/s, as complex numbers.
        mass: (n,) kg.
        held: the numbers of those that are held.
        up: the sign of y upwards, as it is drawn.
    """

    x: NDArray[np.complex128]
    v: NDArray[np.complex128]
    mass: Floats
    held: set[int]
    up: float

    def motion(self, numbers: NDArray[np.int64]) -> Motion:
        """How some of them move, by their numbers."""
        x, v, mass = self.x[numbers], self.v[numbers], self.mass[numbers]
        centre, drift = complex(mass @ x / mass.sum()), complex(mass @ v / mass.sum())
        inertia = float(mass @ np.abs(x - centre) ** 2)
        spin = float((mass * ((x - centre).conj() * (v - drift)).imag).sum())
        fastest, height = int(np.abs(v).argmax()), self.up * x.imag
        lowest = int(height.argmin())
        own = self.held.intersection(numbers.tolist())
        top = max((self.up * float(self.x[m].imag) for m in own), default=None)
        return Motion(
            centre=(centre.real, centre.imag),
            drift=(drift.real, drift.imag),
            turning=self.up * spin / inertia if inertia > 0.0 else 0.0,
            fastest=int(numbers[fastest]),
            velocity=(v[fastest].real, v[fastest].imag),
            lowest=int(numbers[lowest]),
            hangs=None if top is None else top - float(height[lowest]),
        )


def broken_springs(simulation: Moving, scene: Scene) -> NDArray[np.bool_]:
    """(S,) whether each spring is broken."""
    system, state = simulation.tables
    broken = np.zeros(len(scene.linear_springs), bool)
    if state.broken.size:
        broken[system.spring_order] = state.broken[: broken.size] > 0.0
    return broken


def _strains(simulation: Moving, scene: Scene, broken: NDArray[np.bool_]) -> Floats:
    """(S,) of each spring; 0 where it is broken."""
    springs = np.arange(len(scene.linear_springs))
    if not springs.size:
        return np.zeros(0)
    longer, length = (
        quantity(f"spring0.{what}", scene).kind.values(simulation, springs)
        for what in ("elongation", "length")
    )
    rest = length - longer
    return np.where(broken | (rest <= 0.0), 0.0, longer / np.where(rest > 0.0, rest, 1.0))


def _largest(strains: Floats, side: float) -> tuple[int, float] | None:
    if not strains.size:
        return None
    spring = int((side * strains).argmax())
    return (spring, float(strains[spring])) if side * strains[spring] >= STRAINED else None


def touches(simulation: Moving) -> dict[str, NDArray[np.complex128]]:
    """(n,) the force on each mass, kg px/s², of what touches it, by the names of these: walls and contact."""
    system, state = simulation.tables
    physics = Physics(system.body, state)
    x, v = state.x + 1j * state.y, state.vx + 1j * state.vy
    acting = (TERMS[k] for k in system.body.environment.acting)
    return {
        term.name: physics.terms[term.name].forces(x, v)[system.mass_index] for term in acting if term.touches
    }


# ------------------------------------------------------------------------- pieces
def _pieces(scene: Scene, broken: NDArray[np.bool_], body: _Masses) -> tuple[Piece, ...]:
    """The pieces, those with most masses first, then by their first mass."""
    ends = [(s.a, s.b) for s, gone in zip(scene.linear_springs, broken, strict=True) if not gone]
    part = _connected(len(scene.masses), ends)
    degree = np.bincount(np.array(ends, int).ravel(), minlength=len(scene.masses))
    springs = (
        np.bincount(part[[a for a, _ in ends]], minlength=len(scene.masses)) if ends else np.zeros(1, int)
    )
    joints = [j for j in scene.angular_springs if not (broken[j.a] or broken[j.b])]
    turning = np.bincount(
        [part[scene.linear_springs[j.a].a] for j in joints] or [0], minlength=len(scene.masses)
    ) * bool(joints)
    found = []
    for first in np.unique(part):
        masses = np.flatnonzero(part == first)
        lines, own = int(springs[first]) if ends else 0, sorted(body.held.intersection(masses.tolist()))
        most = int(degree[masses].max())
        loops = lines - masses.size + 1
        found.append(
            Piece(
                shape=_shape(masses.size, loops, most),
                masses=tuple(masses.tolist()),
                springs=lines,
                joints=int(turning[first]),
                loops=loops,
                held=tuple(own),
                sides=tuple(_sides(body.x[masses], body.x[own], body.up)),
                motion=body.motion(masses),
            )
        )
    return tuple(sorted(found, key=lambda piece: (-len(piece.masses), piece.masses[0])))


def _shape(masses: int, loops: int, most: int) -> Shape:
    if masses == 1:
        return "mass"
    if loops == 0:
        return "chain" if most <= 2 else "tree"
    return "ring" if loops == 1 and most == 2 else "net"


def _connected(count: int, ends: Sequence[tuple[int, int]]) -> NDArray[np.int64]:
    """(n,) the lowest mass that each is connected with."""
    from scipy.sparse import coo_array  # it loads what a page can begin without
    from scipy.sparse.csgraph import connected_components

    a, b = np.array(ends, int).reshape(-1, 2).T
    part = connected_components(coo_array((np.ones(len(a)), (a, b)), (count, count)), directed=False)[1]
    return np.unique(part, return_index=True)[1][part]


def _sides(all_of: NDArray[np.complex128], some: NDArray[np.complex128], up: float) -> Iterable[Side]:
    """Where some masses are among all of a piece."""
    width, height = np.ptp(all_of.real), np.ptp(all_of.imag)
    larger = max(width, height)
    for place in some:
        across = _third(place.real, all_of.real) if width > _PLAIN * larger else 0
        upward = _third(up * place.imag, up * all_of.imag) if height > _PLAIN * larger else 0
        yield _SIDES[across, upward]


_SIDES: dict[tuple[int, int], Side] = {
    (-1, 0): "left", (1, 0): "right", (0, 1): "top", (0, -1): "bottom", (0, 0): "inside",
    (-1, 1): "leftTop", (1, 1): "rightTop", (-1, -1): "leftBottom", (1, -1): "rightBottom",
}  # fmt: skip


def _third(value: float, values: Floats) -> int:
    """-1 at the lower edge of values, 1 at the upper one, 0 between."""
    part = (value - values.min()) / (values.max() - values.min())
    return -1 if part < _EDGE else 1 if part > 1.0 - _EDGE else 0


def direction(vector: tuple[float, float], up: float) -> float:
    """The direction of a vector as it is drawn, degrees counterclockwise from the right, in -180..180."""
    return math.degrees(math.atan2(up * vector[1], vector[0]))
