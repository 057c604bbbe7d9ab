"""A body as a short program in Python or C: `templates/program.py`, and `templates/softbody.c` with its
header, filled with its numbers and without what it does not need."""

from __future__ import annotations

import dataclasses
import itertools
import math
import re
import unicodedata
from collections.abc import Iterable
from pathlib import Path

import msgspec
import numpy as np

import sim
from sim.errors import InputError
from sim.forces.all import TERMS
from sim.forces.muscles import KINDS, steer_of
from sim.forces.touch.walls import WallRow
from sim.scene.parts import JointMuscle, SpringMuscle
from sim.scene.types import ForceLaw, Method, Scene, is_damageable, shown_name, steered_by
from sim.solve.registry import METHODS

from ...conditional import needed_lines
from .body import Body
from .features import features_of

_MARGIN = 0.8
"""Fraction of the largest stable time step that a program takes where the scene's own is too long: a body
that is dragged and bent becomes stiffer."""

STEPS = 400
"""Time steps that a program makes by default."""

WIDTH = 100
"""Characters of a line of a program at most, but for what stands in one row of a table."""

LICENCE = "SPDX-License-Identifier: MIT; Copyright (c) 2026 The softrod authors"
"""The line at the top of every exported program."""

_PLAIN = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:;()+-^/")
"""Characters of a user's text that a comment may have: none could end the comment or mean anything in it."""

_HYSTERESIS, _GRIP = WallRow._fields.index("hysteresis"), WallRow._fields.index("tangential")
"""Columns of a wall's row from which on only some programs need them: those of what a constant restitution
loses, and those of tangential springs."""

LAWS_IN_PROGRAMS: tuple[ForceLaw, ...] = ("tutorial", "conservative", "angle")
"""The force laws that programs and live files know."""

TERMS_IN_PROGRAMS = frozenset(
    (
        *("linear", "angular", "one-sided", "air friction", "resistance", "walls", "fillings", "contact"),
        *("rails", "motors", "pushes"),
    )
)
"""The names of the forces that they know, or refuse by themselves."""


@dataclasses.dataclass(frozen=True)
class Plan:
    """What a program is made of.

    Attributes:
        body: its numbers.
        dt: the length of its time steps, s.
        notes: what whoever uses it should know, one sentence each without a full stop.
    """

    body: Body
    dt: float
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
        check_forces(body.scene)
        if np.count_nonzero(body.size) > 1:
            raise InputError("a program in Python or C cannot do solid masses that touch each other")
        if lacks:
            raise InputError(
                f"a program cannot do {' and '.join(lacks.values())}; set {' and '.join(lacks)} to 0 to have "
                f"one without {'them' if len(lacks) > 1 or body.gusts else 'it'}"
            )
        soft = body.scene.integrator.method == "stable_spring"
        dt, notes = time_step(body)
        return Plan(body.softened() if soft else body, dt, [*notes, *_notes(body)])

    def features(self) -> dict[str, bool]:
        """What the program needs, by the names of the templates."""
        body, scene = self.body, self.body.scene
        law = scene.force_law if len(body.joints) else ""
        damped, joints_damped = bool(body.damping.any()), bool(body.joint_damping.any())
        air = scene.air_friction > 0.0
        medium = bool(body.ends.size and scene.medium and (scene.medium.across or scene.medium.along))
        ground = bool(body.ends.size and scene.ground and scene.ground.gravity)
        has = {
            "GRAVITY": any(scene.gravity),
            "AIR": air,
            "AIR_BY_AXES": air and scene.air_law == "tutorial",
            "AIR_BY_SPEED": air and scene.air_law == "isotropic",
            "WIND": (air or medium) and any(body.wind),
            "MEDIUM": medium,
            "GROUND": ground,
            "RESISTED": medium or ground,
            "HELD": bool(body.held.any()),
            "SPRINGS": len(body.ends) > 0,
            "SPRING_SIDES": bool(body.spring_side.any()),
            "DAMPING": damped,
            "JOINTS": len(body.joints) > 0,
            "JOINT_SIDES": bool(body.joint_side.any()),
            "JOINT_DAMPING": joints_damped,
            "RATES": damped or joints_damped or bool(body.motors),
            "TURNING": joints_damped or bool(body.motors),
            "ANGLE_LAW": law == "angle",
            "CONSERVATIVE_LAW": law == "conservative",
            "JOINT_ENERGY": law in ("angle", "conservative"),
            "LOADS": bool(body.loads),
            "FILLINGS": bool(body.loops),
            "WALLS": len(body.walls) > 0,
            "HYSTERESIS": bool(body.walls[:, _HYSTERESIS].any()),
            "SIZES": len(body.walls) > 0 and bool(body.size.any()),
            "GRIPS": bool(body.walls[:, _GRIP].any()),
            "GRIPPED": bool(self._gripped()),
            "SLIDING": bool(self._sliding()),
            "CIRCLES": bool(body.circles),
            "RAILED_CIRCLES": not body.rails.keys().isdisjoint(body.circles),
            "STRETCHED": bool(body.spring_muscles),
            "BENT": bool(body.joint_muscles),
            "MUSCLES": body.beat is not None,
            "TIME": bool(body.circles) or body.beat is not None,
            "MATHEMATICS": bool(len(body.ends) or air or len(body.walls) or body.circles),
        }
        return {
            "TEMPLATE": False,
            **{f"HAS_{name}": needed for name, needed in has.items()},
            **features_of(scene),
        }

    def tables(self) -> dict[str, list[tuple[float | int, ...]]]:
        """The rows of the program's tables, by the names of their places in the templates."""
        body, has = self.body, self.features()
        masses = [*body.positions.T, *body.velocities.T, body.mass]
        springs = [*body.ends.T, body.stiffness, body.rest_length]
        rest = np.radians(body.rest_angle)
        own = np.array([s.rest_length for s in body.scene.linear_springs]) * body.moment.rest_length_scale
        joints = [*body.joints.T, body.joint_stiffness]
        joints += [rest] if has["HAS_ANGLE_LAW"] else [np.cos(rest), np.sin(rest)]
        if has["HAS_HELD"]:
            masses.append(body.held.astype(int))
        if has["HAS_SPRING_SIDES"]:
            springs.append(body.spring_side)
        if has["HAS_DAMPING"]:
            springs.append(body.damping)
        if has["HAS_JOINT_SIDES"]:
            joints.append(body.joint_side)
        if has["HAS_JOINT_DAMPING"]:
            joints.append(body.joint_damping)
        walls = [*body.walls.T[:_HYSTERESIS]]
        if has["HAS_HYSTERESIS"]:
            walls += [*body.walls.T[_HYSTERESIS:_GRIP]]
        if has["HAS_GRIPS"]:
            walls += [*body.walls.T[_GRIP:]]
        columns = {"MASSES": masses, "SPRINGS": springs, "JOINTS": joints, "WALLS": walls}
        return {
            **{name: list(zip(*(c.tolist() for c in table), strict=True)) for name, table in columns.items()},
            "LOADS": [(mass, *map(float, force)) for mass, force in body.loads.items()],
            "RESISTED": self._resisted(),
            "GRIPPED": self._gripped(),
            "SLIDING": self._sliding(),
            "SIZES": [(size,) for size in body.size.tolist()],
            "BELTS": [(wall.speed or 0.0,) if has["HAS_BELTS"] else () for wall in body.scene.walls],
            "STATIC": [
                (wall.static_friction or 0.0,) if has["HAS_STATIC"] else () for wall in body.scene.walls
            ],
            "MOTORS": self._motors(),
            "PUSHES": body.pushes,
            "RAILS": [(mass, *way) for mass, way in body.rails.items()],
            "CIRCLES": [
                (mass, *place, circle.radius, circle.frequency, circle.ramp)
                for mass, (circle, place) in body.circles.items()
            ],
            "STRETCHED": [
                self._muscle(s, muscle, float(body.rest_length[s]), float(own[s]), has["HAS_EFFORTS"])
                for s, muscle in body.spring_muscles.items()
            ],
            "BENT": [
                self._muscle(j, muscle, float(rest[j]), math.radians(1.0), has["HAS_EFFORTS"])
                for j, muscle in body.joint_muscles.items()
            ],
        }

    def _motors(self) -> list[tuple[float | int, ...]]:
        """A row for each motor, with the keys that steer it if any are steered."""
        body, steered = self.body, steered_by(self.body.scene)
        loose = {j for j, springs in enumerate(body.joints) if body.broken[springs].any()}
        return [
            (
                j,
                math.radians(motor.speed),
                0.0 if j in loose else motor.torque,
                math.radians(motor.slip),
                *([steer_of(motor.keys)] if steered else ()),
            )
            for j, motor in body.motors.items()
        ]

    def _gripped(self) -> list[tuple[float | int, ...]]:
        """A row for each tangential spring between a wall and a mass: these, and its stretch, px."""
        grips = self.body.moment.grips
        return list(grips.walls) if grips is not None and self.body.walls[:, _GRIP].any() else []

    def _sliding(self) -> list[tuple[float | int, ...]]:
        """A row for each wall with static friction and a mass that slides on it."""
        grips = self.body.moment.grips
        return list(grips.sliding or ()) if grips is not None else []

    def _resisted(self) -> list[tuple[float | int, ...]]:
        """A row for each spring that a medium or the ground resists, with the weights on its ends."""
        body, ground = self.body, self.body.scene.ground
        whole = np.flatnonzero(~body.broken)
        if not ground:
            return [(s,) for s in whole.tolist()]
        bearers = np.bincount(body.ends[whole].ravel(), minlength=len(body.mass))
        weight = ground.gravity * body.mass / np.maximum(bearers, 1)
        return list(zip(whole.tolist(), *weight[body.ends[whole]].T.tolist(), strict=True))

    def _muscle(
        self, part: int, muscle: SpringMuscle | JointMuscle, rest: float, unit: float, keyed: bool
    ) -> tuple[float | int, ...]:
        """A row of a table of muscles: `part` rests at `rest`, `unit` is that of the amplitude, and those
        that are `keyed` have their keys."""
        beat = self.body.beat or sim.Beat()
        rate, phase = muscle.per_beat * beat.frequency, muscle.per_beat * beat.phase + muscle.phase
        kind, keys = int(KINDS[muscle.wave]), [steer_of(muscle.keys)] if keyed else []
        return part, rest, muscle.amplitude * unit, math.tau * rate, math.radians(phase), kind, *keys

    def numbers(self) -> dict[str, str]:
        """The program's single numbers, by the names of their places in the templates."""
        body, scene = self.body, self.body.scene
        given = {
            "START": body.moment.time,
            "DT": self.dt,
            "AIR": scene.air_friction,
            "GRAVITY_X": float(scene.gravity[0]),
            "GRAVITY_Y": float(scene.gravity[1]),
            "WIND_X": body.wind[0],
            "WIND_Y": body.wind[1],
            "EFFORT_X": body.efforts[0],
            "EFFORT_Y": body.efforts[1],
        }
        if scene.medium:
            given |= {"ACROSS": scene.medium.across, "ALONG": scene.medium.along}
        if scene.ground:
            given |= {"FORWARD": scene.ground.forward, "BACKWARD": scene.ground.backward}
            given |= {"SIDEWAYS": scene.ground.sideways, "SLIP": scene.ground.slip_speed}
        words = {"STEPS": str(STEPS), "AIR_UNIT": "kg/s" if scene.air_law == "linear" else "kg/px"}
        return words | {name: repr(number) for name, number in given.items()}


def python_program(body: Body) -> tuple[bytes, list[str]]:
    """A program in Python with NumPy, and what whoever uses it should know: sentences without a full stop.

    Raises:
        InputError: something acts on the body that a program cannot do.
    """
    plan = Plan.of(body)
    places = {name: _table(map(repr, rows), "[", "]") for name, rows in plan.tables().items()}
    loops = ((loop.is_gas, loop.pressure, loop.outside, loop.area, loop.masses) for loop in body.loops)
    places["FILLINGS"] = _table(map(repr, loops), "[", "]")
    places["ABOUT"] = "\n# ".join(_about(plan, "python FILE.py"))
    return _filled("program.py", plan, places), plan.notes


def c_program(body: Body, name: str = "softbody") -> tuple[bytes, bytes, list[str]]:
    """A source in C99 that needs only the mathematics library, its header, and notes as those of
    `python_program`.

    Args:
        body: the body.
        name: of both files, without an ending. What they define begins with it, as far as C allows.

    Raises:
        InputError: as `python_program`, or the name cannot stand between quotation marks in C.
    """
    if not re.fullmatch(r"[\w. -]+", name):
        raise InputError(f"{name!r} is no name for files in C: it may have letters, digits, spaces, - and _")
    plan = Plan.of(body)
    ends = itertools.accumulate(len(loop.masses) for loop in body.loops)
    loops = [
        (int(loop.is_gas), loop.pressure, loop.outside, loop.area, end - len(loop.masses), end)
        for loop, end in zip(body.loops, ends, strict=True)
    ]
    tables = {**plan.tables(), "FILLINGS": loops, "MASSES": _masses(body)}
    surfaces = (tables[name] for name in ("WALLS", "BELTS", "STATIC"))
    tables["WALLS"] = [tuple(itertools.chain(*rows)) for rows in zip(*surfaces, strict=True)]
    places = {
        table: _table((f"{{ {', '.join(map(repr, row))} }}" for row in rows), "{", "}")
        for table, rows in tables.items()
    }
    around = wrapped(" ".join(f"{mass}," for loop in body.loops for mass in loop.masses))
    places["AROUND"] = _table((line.removesuffix(",") for line in around), "{", "}")
    counts = {"MASS": body.mass, "SPRING": body.ends, "JOINT": body.joints, "WALL": body.walls}
    places |= {f"{kind}_COUNT": str(len(parts)) for kind, parts in counts.items()}
    word = _word(name)
    run = f"cc -O2 -D{word.upper()}_MAIN {name}.c -lm; ./a.out"
    source, header = (
        _filled(f"softbody.{ending}", plan, places | {"ABOUT": "\n// ".join(about)})
        for ending, about in (("c", [f"The body of {name}.h."]), ("h", _about(plan, run)))
    )
    source = source.replace(b'"softbody.h"', f'"{name}.h"'.encode())
    source, header = (
        re.sub(rb"\bsoftbody", word.encode(), re.sub(rb"\bSOFTBODY", word.upper().encode(), text))
        for text in (source, header)
    )
    return source, header, plan.notes


def _masses(body: Body) -> list[tuple[float | int, ...]]:
    """The rows of a program's masses in C, always with which are held, since that may be changed."""
    columns = [*body.positions.T, *body.velocities.T, body.mass, body.held.astype(int)]
    if body.loads:
        columns += np.array(
            [body.loads.get(mass, (0.0, 0.0)) for mass in range(len(body.mass))], float
        ).T.tolist()
    return list(zip(*(np.asarray(column).tolist() for column in columns), strict=True))


def _word(name: str) -> str:
    """What a name is in C."""
    word = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_").lower()
    return word if word and not word[0].isdigit() else f"body_{word}".rstrip("_")


def _table(rows: Iterable[str], opening: str, closing: str) -> str:
    """Rows in brackets, a line each; numbers read back exactly as they are."""
    return "\n".join((opening, *(f"    {row}," for row in rows), closing))


def _filled(name: str, plan: Plan, places: dict[str, str]) -> bytes:
    """A template with what the program needs of it.

    Words GIVEN_... in a template are places for text, and `app.conditional` has its directives.

    Args:
        name: of the template.
        plan: of the program.
        places: texts by what follows GIVEN_, in addition to the plan's numbers.
    """
    template = Path(__file__).with_name("templates") / name
    lines = needed_lines(template.read_text(encoding="ascii"), plan.features())
    given = plan.numbers() | places
    text = re.sub(r"\bGIVEN_(\w+)", lambda place: given[place[1]], "\n".join((*lines, "")))
    return re.sub(r"\n{4,}", "\n\n\n", text).encode("ascii")


def check_forces(scene: Scene, what: str = "a program") -> None:
    """Refuse what acts on a body and is not known outside softrod.

    Args:
        scene: a valid scene.
        what: the kind of file, with its article.

    Raises:
        InputError: there is such a force law or force.
    """
    law = scene.force_law
    if scene.angular_springs and law not in LAWS_IN_PROGRAMS:
        raise InputError(f"{what} cannot do the force law {law!r}, but {', '.join(LAWS_IN_PROGRAMS)}")
    if unknown := unknown_forces(scene):
        raise InputError(f"{what} cannot do {' and '.join(unknown)}")


def unknown_forces(scene: Scene) -> list[str]:
    """Names of the forces on a scene's body that are not known outside softrod."""
    acting = (term for term in TERMS if term.acts(scene))
    return [term.label or term.name for term in acting if term.name not in TERMS_IN_PROGRAMS]


def time_step(body: Body) -> tuple[float, list[str]]:
    """The length of a program's steps by symplectic Euler, s, and how these differ from the scene's.

    It is the scene's time step, or the largest whole fraction of it that is stable with a margin.
    """
    method, dt = body.scene.integrator.method, body.scene.integrator.dt
    notes = []
    if method == "stable_spring":
        notes.append("springs are as soft as the method Stable spring makes them for this time step")
    elif method != "symplectic_euler":
        notes.append(f"it steps by symplectic Euler, the scene by {METHODS[method].label}")
    limit = largest_step(body)
    if dt <= limit:
        return dt, notes
    parts = math.ceil(dt / (_MARGIN * limit))
    notes.append(
        f"its time step is 1/{parts} of the scene's {dt:g} s, which is above the largest stable one, "
        f"{limit:.3g} s"
    )
    return dt / parts, notes


def _notes(body: Body) -> list[str]:
    scene, notes = body.scene, []
    if is_damageable(scene):
        notes.append("in it no spring breaks or yields any further")
    if steered_by(scene):
        notes.append("in it, what keys work holds still until its steer is set")
    driven = any(anchor.driven for anchor in scene.anchors)
    hands = [*["the pointer"] * driven, *["the arrow keys"] * (scene.arrow_keys is not None)]
    if hands:
        notes.append(
            f"in it, {' and '.join(hands)} {'do' if len(hands) > 1 or not driven else 'does'} nothing"
        )
    return notes


def largest_step(body: Body) -> float:
    """The largest stable time step of the body as it is, by symplectic Euler, s."""
    soft = body.scene.integrator.method == "stable_spring"
    method: Method = "stable_spring" if soft else "symplectic_euler"
    integrator = msgspec.structs.replace(body.scene.integrator, method=method)
    scene = msgspec.structs.replace(body.scene, integrator=integrator)
    simulation = sim.Simulation(scene)
    simulation.restore(dataclasses.replace(body.moment, scene=scene))
    simulation.stability()
    return simulation.stability().limit


# ------------------------------------------------------------------------- text
def plain(text: str) -> str:
    """A user's text as it may stand in a comment of any language: ASCII letters, digits and a few signs."""
    letters = unicodedata.normalize("NFKD", text)
    shown = (c if c in _PLAIN else "_" for c in letters if not unicodedata.combining(c))
    return "".join(shown).strip()


def _about(plan: Plan, run: str) -> list[str]:
    """The lines at the top of a program, without the signs of a comment.

    Args:
        plan: of the program.
        run: how it is run.
    """
    scene = plan.body.scene
    unit = plain(scene.view.unit)
    down = "down" if scene.view.y_down else "up"
    paragraphs = [
        f"{plain(shown_name(scene))}: a body of {counted(plan.body)}, written by softrod.",
        "A time step is one of symplectic Euler: all forces from the present state, then velocities, then "
        f"positions. x grows to the right and y {down}. px stands for the unit of length"
        f"{'' if unit == 'px' else ', ' + unit}.",
        f"{run} does {STEPS} steps and prints x and y of every mass; a number after it does as many.",
    ]
    if plan.notes:
        paragraphs.append("Note: " + "; ".join(plan.notes) + ".")
    return [*(line for paragraph in paragraphs for line in wrapped(paragraph)), LICENCE]


def wrapped(text: str, width: int = WIDTH - 4) -> list[str]:
    """A text in lines of some characters at most."""
    lines = [""]
    for word in text.split():
        if lines[-1] and len(lines[-1]) + 1 + len(word) > width:
            lines.append("")
        lines[-1] += f" {word}" if lines[-1] else word
    return lines


def counted(body: Body) -> str:
    """Of how many parts it is, in words."""
    counts = (len(body.mass), "mass", "masses"), (len(body.ends), "spring", "springs")
    counts += ((len(body.joints), "joint", "joints"),)
    words = [f"{n} {one if n == 1 else many}" for n, one, many in counts if n]
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
