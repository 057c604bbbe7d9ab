"""The scenes on which softrod is held against others: masses, springs, weight, and contact in heaps.

Air friction and angular springs are left out, since most others have none. Ropes are one rope in more and
more pieces; nets have the same meshes, so the larger one is larger; heaps are those of `softrod bench heap`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import msgspec

import sim
from sim import Scene
from sim.scene.makers import fine_rope
from sim.scene.types import Circle

from ..bench.heap import heap

MESH = 30.0
"""Length of a spring of a net, px."""

SOFT, STIFF = (2e5, 30.0), (2e7, 300.0)
"""Stiffness, kg/s², and damping, kg/s, of nets. Their masses of .2 kg make Verlet need some 1500 and 14 500
steps a second."""


def rope(masses: int) -> Scene:
    """A hanging rope whose upper end is led in a circle once a second."""
    circle = Circle(radius=20.0, frequency=1.0, ramp=0.1)
    return fine_rope(
        masses,
        name=f"rope-{masses}",
        start=(300.0, 100.0),
        direction=(0.0, 1.0),
        circle=circle,
        joints=False,
        air_friction=0.0,
        arrow_keys=None,
    )


def net(columns: int, stiffness: float, damping: float) -> Scene:
    """A square net that is let go, stretched out upright and held by its upper corners."""
    side = MESH * (columns - 1)
    scene = sim.cloth(
        columns=columns, rows=columns, width=side, height=side, diagonals=False,
        stiffness=stiffness, damping=damping, mass=0.2, air_friction=0.0,
    )  # fmt: skip
    # A cloth is a net but for its angular springs.
    return sim.validate(msgspec.structs.replace(scene, bodies=(), angular_springs=()))


def ropes(count: int) -> list[Scene]:
    """Hanging ropes of 12 masses, each with its own stiffness, let go from a direction of its own."""
    made = []
    for i in range(count):
        part = (i + 0.5) / count
        made.append(
            fine_rope(
                12,
                name=f"rope-{i}",
                start=(300.0, 100.0),
                direction=(1.0 - part, 1.0),
                stiffness=1e4 * (1.0 + part),
                joints=False,
                air_friction=0.0,
                arrow_keys=None,
            )
        )
    return made


@dataclass(frozen=True)
class PathScene:
    """A scene of which it is known where its masses are in the end.

    Attributes:
        name: also that of its reference.
        title: for people.
        make: makes it.
    """

    name: str
    title: str
    make: Callable[[], Scene]


PATHS = {
    scene.name: scene
    for scene in (
        *(PathScene(f"rope-{n}", f"rope of {n} masses", lambda n=n: rope(n)) for n in (12, 100, 1000)),
        *(
            PathScene(f"net-{columns**2}-{name}", f"{name} net of {columns**2} masses", make)
            for columns in (10, 30)
            for name, make in (
                ("soft", lambda columns=columns: net(columns, *SOFT)),
                ("stiff", lambda columns=columns: net(columns, *STIFF)),
            )
        ),
    )
}
"""By name; each is looked at after `SECONDS`."""

SECONDS = 1.0
"""Simulated time of ropes and nets, s."""

HEAPS = {f"heap-{12 * rings}": lambda rings=rings: heap(rings) for rings in (10, 84)}
"""Rings that fall into a box, by name."""

HEAP_SECONDS = 5.0
"""Simulated time of heaps, s."""

MANY, COUNT = "ropes-1000", 1000
"""The name of many ropes of 12 masses at once, and how many."""

EVERY = 20
"""Every so many of them has a reference."""

NAMES = (*PATHS, *HEAPS, MANY)
"""All scenes."""
