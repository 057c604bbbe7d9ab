"""A body as JSON with plain arrays, and as tables in CSV."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence
from typing import Any

import msgspec

import sim
from sim import AngularSpring, LinearSpring
from sim.motion.driving import NO_RAIL
from sim.store.csv_text import csv_text
from sim.store.files import indented_json

from .body import Body

FORMAT = "softrod-body"
VERSION = 1

_UNITS = {
    "position": "L",
    "velocity": "L/s",
    "mass": "kg",
    "radius": "L",
    "force": "kg L/s^2",
    "stiffness": "kg/s^2",
    "damping": "kg/s",
    "rest_length": "L",
    "rest_angle": "deg",
    "strength": "kg L/s^2",
    "yield_force": "kg L/s^2",
    "hardening": "kg/s^2",
    "yield_torque": "kg L^2/s^2",
    "time": "s",
    "time_step": "s",
    "gravity": "L/s^2",
    "air_friction": "kg/L",
}
"""Units, where L stands for the unit of length."""

_MORE_UNITS = {
    "circle_radius": "L",
    "circle_frequency": "Hz",
    "circle_ramp": "s",
    "point": "L",
    "hardness": "1/(L s^2)",
    "tangential_hardness": "1/s^2",
    "slip_speed": "L/s",
    "speed": "L/s",
    "pressure_or_bulk_modulus": "kg/s^2",
    "outside": "kg/s^2",
    "area": "L^2",
    "wind_velocity": "L/s",
    "wind_length_scale": "L",
    "medium_across": "kg/(L s)",
    "medium_along": "kg/(L s)",
    "ground_gravity": "L/s^2",
    "ground_slip_speed": "L/s",
    "contact_distance": "L",
    "contact_stiffness": "kg/(L s^2)",
    "contact_slip_speed": "L/s",
    "contact_tangential_stiffness": "kg/s^2",
    "beat_frequency": "Hz",
    "beat_phase": "deg",
    "muscle_angle": "deg",
    "muscle_phase": "deg",
    "motor_speed": "deg/s",
    "motor_torque": "kg L^2/s^2",
    "motor_slip": "deg/s",
}
"""Of columns that there are in tables only."""

_AXES = {"position": ("x", "y"), "point": ("x", "y"), "velocity": ("vx", "vy")}
"""Names of the two columns for a list of pairs; those of others end in _x and _y."""

_Parts = Sequence[LinearSpring] | Sequence[AngularSpring]

Columns = Mapping[str, Sequence[Any]]
"""Lists of as many numbers, or pairs of numbers, by name."""


def body_json(body: Body) -> bytes:
    """The body as one JSON object: a list of numbers, or of pairs, for each property of the parts.

    What the scene does not have is not in it. `docs/export.md` describes the fields.
    """
    scene = body.scene
    data: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        **_settings(body),
        "units": {name: _unit(name, scene) for name in _UNITS},
        "y_down": scene.view.y_down,
        "masses": _masses(body),
        "springs": _springs(body) | _muscles(scene.linear_springs),
        "joints": _joints(body) | _muscles(scene.angular_springs) | _motors(body),
        "anchors": scene.anchors,
        **_surroundings(scene),
    }
    if scene.walls:
        data["walls"] = scene.walls
    if body.loops:
        data["fillings"] = [
            {
                "kind": "gas" if loop.is_gas else "liquid",
                "pressure" if loop.is_gas else "bulk_modulus": loop.pressure,
                "outside": loop.outside,
                "area": loop.area,
                "masses": loop.masses,
            }
            for loop in body.loops
        ]
    return indented_json(msgspec.json.encode(data))


def body_csv(body: Body, decimal_comma: bool = False) -> bytes:
    """The body as a ZIP archive of tables in CSV, with units in their first lines.

    `masses.csv`, `springs.csv` and `joints.csv` have a line for each part, `settings.csv` one for each number
    or name of the scene. There are `walls.csv` and `fillings.csv` if the scene has such things.
    """
    scene, masses = body.scene, _masses(body)
    masses["held"] = body.held.astype(int).tolist()
    circles = {anchor.mass: anchor.circle for anchor in scene.anchors if anchor.circle is not None}
    if circles:
        for field in ("radius", "frequency", "ramp"):
            numbers = [getattr(circles.get(i), field, None) for i in range(len(scene.masses))]
            masses[f"circle_{field}"] = numbers
    stretch = _muscle_columns(scene.linear_springs, "muscle_amplitude")
    turn = _muscle_columns(scene.angular_springs, "muscle_angle")
    if body.motors:
        motors = _motors(body)["motor"]
        for field in ("speed", "torque", "slip", "keys"):
            turn[f"motor_{field}"] = [getattr(motor, field, None) or None for motor in motors]
    tables = {
        "masses": _table({"index": range(len(body.mass)), **masses}, scene),
        "springs": _table({"index": range(len(body.ends)), **_springs(body), **stretch}, scene),
        "joints": _table({"index": range(len(body.joints)), **_joints(body), **turn}, scene),
    }
    settings = {**_settings(body), "unit_of_length": scene.view.unit, "y_down": int(scene.view.y_down)}
    for name, fields in msgspec.to_builtins(_surroundings(scene)).items():
        settings |= {f"{name}_{field}": value for field, value in fields.items()}
    heads, values = _table({name: [value] for name, value in settings.items()}, scene)
    tables["settings"] = [["setting", "value"], *map(list, zip(heads, values, strict=True))]
    if scene.walls:
        walls = msgspec.to_builtins(scene.walls)
        fields = dict.fromkeys(field for wall in walls for field in wall)
        tables["walls"] = _table({field: [wall.get(field) for wall in walls] for field in fields}, scene)
    if body.loops:
        fillings = {
            "kind": ["gas" if loop.is_gas else "liquid" for loop in body.loops],
            "pressure_or_bulk_modulus": [loop.pressure for loop in body.loops],
            "outside": [loop.outside for loop in body.loops],
            "area": [loop.area for loop in body.loops],
            "masses": [" ".join(map(str, loop.masses)) for loop in body.loops],
        }
        tables["fillings"] = _table(fillings, scene)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, rows in tables.items():
            text = csv_text(rows, decimal_comma)
            # Without the time of day, the same body makes the same file.
            archive.writestr(zipfile.ZipInfo(f"{name}.csv"), text, zipfile.ZIP_DEFLATED)
    return out.getvalue()


# ------------------------------------------------------------------------- the body's numbers
def _masses(body: Body) -> dict[str, Sequence[Any]]:
    columns = {
        "position": body.positions.tolist(),
        "velocity": body.velocities.tolist(),
        "mass": body.mass.tolist(),
        "radius": body.radius.tolist(),
    }
    if body.loads or body.pushes:
        columns["force"] = [mass.force or (0.0, 0.0) for mass in body.scene.masses]
    if body.pushes:
        columns["keys"] = [mass.keys or None for mass in body.scene.masses]
    if body.size.any():
        columns["solid"] = (body.size > 0.0).astype(int).tolist()
    if body.rails:
        columns["rail"] = [body.rails.get(i, NO_RAIL) for i in range(len(body.mass))]
    return columns


def _springs(body: Body) -> dict[str, Sequence[Any]]:
    a, b = body.ends.T.tolist()
    numbers = {"stiffness": body.stiffness, "damping": body.damping, "rest_length": body.rest_length}
    columns = {"a": a, "b": b, **{name: values.tolist() for name, values in numbers.items()}}
    for name in ("strength", "yield_force", "hardening"):
        values = [getattr(spring, name) for spring in body.scene.linear_springs]
        if any(values):
            columns[name] = values
    columns |= _sides(body.scene.linear_springs)
    if body.broken.any():
        columns["broken"] = body.broken.astype(int).tolist()
    return columns


def _joints(body: Body) -> dict[str, Sequence[Any]]:
    a, b = body.joints.T.tolist()
    numbers = {
        "stiffness": body.joint_stiffness,
        "damping": body.joint_damping,
        "rest_angle": body.rest_angle,
    }
    columns: dict[str, Sequence[Any]] = {
        "a": a,
        "b": b,
        **{name: values.tolist() for name, values in numbers.items()},
    }
    torques = [joint.yield_torque for joint in body.scene.angular_springs]
    if any(torque is not None for torque in torques):
        columns["yield_torque"] = torques
    return columns | _sides(body.scene.angular_springs)


def _sides(parts: _Parts) -> dict[str, Sequence[Any]]:
    """A column of the sides on which parts act, and None; nothing where all act on both."""
    sides = [part.only or None for part in parts]
    return {"only": sides} if any(sides) else {}


def _muscles(parts: _Parts) -> dict[str, Sequence[Any]]:
    """A column of muscles as scenes have them, and None; nothing where no part has one."""
    muscles = [part.muscle or None for part in parts]
    return {"muscle": muscles} if any(muscles) else {}


def _motors(body: Body) -> dict[str, Sequence[Any]]:
    """A column of motors as scenes have them, and None; nothing where there is none."""
    return {"motor": [body.motors.get(j) for j in range(len(body.joints))]} if body.motors else {}


def _muscle_columns(
    parts: Sequence[LinearSpring | AngularSpring], amplitude: str
) -> dict[str, Sequence[Any]]:
    """The same with a column for each number; `amplitude` is the name of that."""
    muscles = [part.muscle or None for part in parts]
    if not any(muscles):
        return {}
    names = {amplitude: "amplitude", "muscle_phase": "phase"}
    names |= {"muscle_wave": "wave", "muscle_waves_per_beat": "per_beat"}
    columns: dict[str, Sequence[Any]] = {
        name: [getattr(muscle, field, None) for muscle in muscles] for name, field in names.items()
    }
    keys = [muscle.keys or None if muscle else None for muscle in muscles]
    if any(keys):
        columns["muscle_keys"] = keys
    return columns


def _settings(body: Body) -> dict[str, Any]:
    scene = body.scene
    return {
        "name": scene.name,
        "title": scene.title,
        "time": body.moment.time,
        "time_step": scene.integrator.dt,
        "method": scene.integrator.method,
        "force_law": scene.force_law,
        "gravity": scene.gravity,
        "air_friction": scene.air_friction,
        "air_law": scene.air_law,
    }


def _surroundings(scene: sim.Scene) -> dict[str, Any]:
    """What may act on a body from outside, with single numbers."""
    names = ("wind", "medium", "ground", "contact", "beat")
    return {name: value for name in names if (value := getattr(scene, name))}


# ------------------------------------------------------------------------- tables
def _table(columns: Columns, scene: sim.Scene) -> list[Sequence[Any]]:
    """The heads of columns with their units, and the rows; a column of pairs becomes two."""
    flat: dict[str, Sequence[Any]] = {}
    for name, values in columns.items():
        unit = _unit(name, scene)
        parts = {name: values}
        if values and isinstance(values[0], list | tuple):
            axes = _AXES.get(name, (f"{name}_x", f"{name}_y"))
            parts = dict(zip(axes, zip(*values, strict=True), strict=True))
        flat |= {f"{head} [{unit}]" if unit else head: part for head, part in parts.items()}
    return [list(flat), *zip(*flat.values(), strict=True)]


def _unit(name: str, scene: sim.Scene) -> str:
    unit = _UNITS.get(name) or _MORE_UNITS.get(name, "")
    if name == "air_friction" and scene.air_law == "linear":
        unit = "kg/s"
    return unit.replace("L", scene.view.unit)
