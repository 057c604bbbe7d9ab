"""The scenes on which softrod and engines are compared: masses, springs, weight, and contact in heaps.

Air friction and angular springs are left out, since most others have none. Ropes are one rope in more and
more pieces; nets have the same meshes, so the larger one is larger; heaps are those of `softrod bench heap`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import msgspec

import sim
from sim import Scene
from sim.scene.makers import fine_rope
from sim.scene.types import Circle

from ..bench.heap import heap

MESH = 30.0
"""Length of a spring of a net, px."""

SOFT = (2e5, 30.0)
"""Stiffness, kg/s², and damping, kg/s, of soft nets. With masses of .2 kg, Verlet needs some 1500 steps/s."""

STIFF = (2e7, 300.0)
"""The same of stiff nets; Verlet needs some 14 500 steps/s."""


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
class NamedScene:
    """A scene of the comparison.

    Attributes:
        name: in options and tables; of a rope or net, also that of its reference.
        title: for people.
        make: makes it.
    """

    name: str
    title: str
    make: Callable[[], Scene]


_PATHS = (
    *(NamedScene(f"rope-{n}", f"Rope of {n} masses", partial(rope, n)) for n in (12, 100, 1000)),
    *(
        NamedScene(
            f"net-{n**2}-{kind}", f"{kind.capitalize()} net of {n**2} masses", partial(net, n, *numbers)
        )
        for n in (10, 30)
        for kind, numbers in (("soft", SOFT), ("stiff", STIFF))
    ),
)

PATHS: dict[str, NamedScene] = {scene.name: scene for scene in _PATHS}
"""Ropes and nets, whose positions after a second are known."""

CONTACT_STIFFNESS = 44_000.0
"""kg/(px s²), of contact in heaps: rings of the small heap then overlap by some .13 px, as Box2D's do."""


def _firm_heap(rings: int) -> Scene:
    scene = heap(rings)
    assert scene.contact is not None
    return msgspec.structs.replace(
        scene, contact=msgspec.structs.replace(scene.contact, stiffness=CONTACT_STIFFNESS)
    )


HEAPS: dict[str, NamedScene] = {
    f"heap-{12 * rings}": NamedScene(
        f"heap-{12 * rings}", f"Heap of {12 * rings} masses", partial(_firm_heap, rings)
    )
    for rings in (10, 84)
}
"""Rings that fall into a box."""

HEAP_SECONDS = 5.0
"""Simulated time of heaps, s."""

MANY = "ropes-1000"
"""The name of the scene of many ropes of 12 masses."""

COUNT = 1000
"""How many they are."""

EVERY = 20
"""One in so many of them has a reference."""

NAMES: dict[str, str] = {scene.name: scene.title for scene in (*PATHS.values(), *HEAPS.values())}
NAMES[MANY] = f"{COUNT} ropes of 12 masses"
"""Titles of all scenes by name."""
