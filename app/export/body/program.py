"""What programs of a body have in common: what they cannot do, what they say of themselves, and how they are
put together."""

from __future__ import annotations

import dataclasses
import unicodedata
from collections.abc import Iterable, Sequence

import msgspec
import numpy as np

import sim
from sim.errors import InputError
from sim.methods.registry import METHODS
from sim.scene.types import ForceLaw, Method, is_damageable, shown_name

from .body import Body, Floats

STEPS = 400
"""Time steps that a program does unless it is told another number."""

WIDTH = 100
"""Characters of a line of a program at most, but for what stands in one row of a table."""

_PLAIN = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:;()+-^/")
"""What is left of a user's text in a comment: nothing that could end the comment or mean anything in it."""


LAWS_IN_PROGRAMS: tuple[ForceLaw, ...] = ("tutorial", "conservative", "angle")
"""The force laws that the programs in Python and C are written for."""


@dataclasses.dataclass(frozen=True)
class Plan:
    """What a program is made of.

    Attributes:
        body: its numbers.
        notes: what whoever uses it should know, one sentence each without a full stop.
    """

    body: Body
    notes: list[str]

    @staticmethod
    def of(body: Body) -> Plan:
        """The plan of a body's program.

        Raises:
            InputError: something acts on the body that a program cannot do.
        """
        contact = body.scene.contact
        lacks = {"turbulence": "gusts of wind"} if body.gusts else {}
        if contact is not None and contact.distance > 0.0 and len(body.ends):
            lacks["contact_distance"] = "contact of bodies"
        law = body.scene.force_law
        if len(body.joints) and law not in LAWS_IN_PROGRAMS:
            raise InputError(f"a program cannot do the force law {law!r}, but {', '.join(LAWS_IN_PROGRAMS)}")
        if lacks:
            raise InputError(
                f"a program cannot do {' and '.join(lacks.values())}; set {' and '.join(lacks)} to 0 to have "
                f"one without {'them' if len(lacks) > 1 or body.gusts else 'it'}"
            )
        soft = body.scene.integrator.method == "stable_spring"
        return Plan(body.softened() if soft else body, _notes(body))

    # What the program needs.
    @property
    def law(self) -> str:
        """The force law of the joints; empty if there are none."""
        return self.body.scene.force_law if len(self.body.joints) else ""

    @property
    def damped(self) -> bool:
        """Whether a linear spring has damping."""
        return bool(self.body.damping.any())

    @property
    def joints_damped(self) -> bool:
        """Whether a joint has damping."""
        return bool(self.body.joint_damping.any())

    @property
    def air(self) -> bool:
        """Whether there is air friction."""
        return self.body.scene.air_friction > 0.0

    @property
    def windy(self) -> bool:
        """Whether the air moves."""
        return self.air and any(self.body.wind)

    @property
    def weighs(self) -> bool:
        """Whether there is gravity."""
        return any(self.body.scene.gravity)

    @property
    def holds(self) -> bool:
        """Whether a mass is held."""
        return bool(self.body.held.any())


def _notes(body: Body) -> list[str]:
    scene = body.scene
    method, dt = scene.integrator.method, scene.integrator.dt
    soft = method == "stable_spring"
    notes = []
    if soft:
        notes.append("springs are as soft as the method Stable spring makes them for this time step")
    elif method != "symplectic_euler":
        notes.append(f"it steps by symplectic Euler, the scene by {METHODS[method].label}")
    limit = _limit(body, "stable_spring" if soft else "symplectic_euler")
    if dt > limit:
        notes.append(
            f"its time step of {dt:g} s is above the largest stable one, {limit:.3g} s, so the body runs away"
        )
    if is_damageable(scene):
        notes.append("in it no spring breaks or yields any further")
    driven = any(anchor.driven for anchor in scene.anchors)
    hands = [*["the pointer"] * driven, *["the arrow keys"] * (scene.arrow_keys is not None)]
    if hands:
        notes.append(
            f"in it, {' and '.join(hands)} {'do' if len(hands) > 1 or not driven else 'does'} nothing"
        )
    return notes


def _limit(body: Body, method: Method) -> float:
    """The largest stable time step of the body as it is, s."""
    integrator = msgspec.structs.replace(body.scene.integrator, method=method)
    scene = msgspec.structs.replace(body.scene, integrator=integrator)
    simulation = sim.Simulation(scene)
    simulation.restore(dataclasses.replace(body.moment, scene=scene))
    simulation.stability()
    return simulation.stability().limit


# ------------------------------------------------------------------------- text
OF_WALLS = (
    "Of each wall: a point and the unit vector to the free side, hardness (1/(px s^2)), friction, slip speed "
    "(px/s), and how much harder masses are pushed that enter faster (s/px)."
)
OF_FILLINGS = (
    "Of each filling: whether it is a gas, its pressure or the bulk modulus, the pressure outside (kg/s^2), "
    "its area (px^2), and the masses around it"
)
OF_LOADS = "Of each mass with a constant force: which it is, and the force's x and y (kg px/s^2)."
OF_CIRCLES = (
    "Of each held mass that goes round: which it is, its place at time 0 (px), radius (px), turns per second "
    "(Hz), and the time constant with which it speeds up (s)."
)
"""What stands in the tables that have the same columns in every language."""


def comment(sign: str, text: str) -> list[str]:
    """A text as lines of a comment."""
    return [f"{sign} {line}" for line in wrapped(text)]


def plain(text: str) -> str:
    """A user's text as it may stand in a comment of any language: ASCII letters, digits and a few signs."""
    letters = unicodedata.normalize("NFKD", text)
    shown = (c if c in _PLAIN else "_" for c in letters if not unicodedata.combining(c))
    return "".join(shown).strip()


def about(plan: Plan, run: str) -> list[str]:
    """The lines at the top of a program, without the signs of a comment.

    Args:
        plan: of the program.
        run: how it is run.
    """
    scene = plan.body.scene
    unit = plain(scene.view.unit)
    down = "down" if scene.view.y_down else "up"
    paragraphs = [
        f"{plain(shown_name(scene))}: a body of {_counted(plan)}, written by softrod.",
        "A time step is one of symplectic Euler: all forces from the present state, then velocities, then "
        f"positions. x grows to the right and y {down}. px stands for the unit of length"
        f"{'' if unit == 'px' else ', ' + unit}.",
        f"{run} does {STEPS} steps and prints x and y of every mass; a number after it does as many.",
    ]
    if plan.notes:
        paragraphs.append("Note: " + "; ".join(plan.notes) + ".")
    return [line for paragraph in paragraphs for line in wrapped(paragraph)]


def wrapped(text: str, width: int = WIDTH - 4) -> list[str]:
    """A text in lines of some characters at most."""
    lines = [""]
    for word in text.split():
        if lines[-1] and len(lines[-1]) + 1 + len(word) > width:
            lines.append("")
        lines[-1] += f" {word}" if lines[-1] else word
    return lines


def rows(columns: Sequence[Iterable[float | int]], before: str, after: str) -> list[str]:
    """The lines of a table, a row each; numbers read back exactly as they are."""
    return [
        f"    {before}{', '.join(map(repr, row))}{after},"
        for row in zip(*map(_numbers, columns), strict=True)
    ]


def _numbers(column: Iterable[float | int]) -> list[float | int]:
    return column.tolist() if isinstance(column, np.ndarray) else list(column)


def load_columns(body: Body) -> list[np.ndarray]:
    """Which masses have constant forces on them, and the forces' x and y, kg px/s²."""
    return [np.array(list(body.loads)), *np.array(list(body.loads.values()), float).T]


def rest_terms(angles: Floats) -> tuple[Floats, Floats]:
    """(J,) cosines and sines of rest angles in degrees."""
    rest = np.radians(angles)
    return np.cos(rest), np.sin(rest)


def _counted(plan: Plan) -> str:
    body = plan.body
    counts = (len(body.mass), "mass", "masses"), (len(body.ends), "spring", "springs")
    counts += ((len(body.joints), "joint", "joints"),)
    words = [f"{n} {one if n == 1 else many}" for n, one, many in counts if n]
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
