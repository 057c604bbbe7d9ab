"""A body as JSON with plain arrays, and as tables in CSV."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import msgspec

import sim
from sim.csv_text import csv_text

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


def body_json(body: Body) -> bytes:
    """The body as one JSON object: a list of numbers, or of pairs, for each property of the parts.

    What the scene does not have is not in it. `docs/export.md` describes the fields.
    """
    scene = body.scene
    data: dict[str, Any] = {
        "format": FORMAT,
        "version": VERSION,
        "name": scene.name,
        "title": scene.title,
        "units": _units(scene),
        "y_down": scene.view.y_down,
        **{key: value for key, value in _settings(body).items() if key not in ("name", "title")},
        "masses": _masses(body),
        "springs": _springs(body),
        "joints": _joints(body),
        "anchors": scene.anchors,
    }
    for field in ("wind", "contact"):
        if (value := getattr(scene, field)) is not None:
            data[field] = value
    if scene.walls:
        data["walls"] = scene.walls
    if body.loops:
        data["fillings"] = [_filling(body, k) for k in range(len(body.loops))]
    return f"{_object(msgspec.to_builtins(data))}\n".encode()


def body_csv(body: Body, decimal_comma: bool = False) -> bytes:
    """The body as a ZIP archive of tables in CSV, with units in their first lines.

    `masses.csv`, `springs.csv` and `joints.csv` have a line for each part, `settings.csv` one for each number
    or name of the scene. There are `walls.csv` and `fillings.csv` if the scene has such things.
    """
    scene, unit = body.scene, _ascii(body.scene.view.unit)
    x, y = body.positions.T.tolist()
    vx, vy = body.velocities.T.tolist()
    masses: dict[str, Iterable[Any]] = {f"x [{unit}]": x, f"y [{unit}]": y}
    masses |= {f"vx [{unit}/s]": vx, f"vy [{unit}/s]": vy}
    masses |= _with_units(scene, {key: _masses(body)[key] for key in ("mass", "radius")})
    if body.loads:
        of = f"kg {unit}/s^2"
        forces = zip(*_forces(body), strict=True)
        masses |= {f"force_{axis} [{of}]": part for axis, part in zip("xy", forces, strict=True)}
    masses["held"] = body.held.astype(int).tolist()
    anchors = {anchor.mass: anchor for anchor in scene.anchors}
    if any(anchor.circle is not None for anchor in scene.anchors):
        for field, of in (("radius", unit), ("frequency", "Hz"), ("ramp", "s")):
            circles = [anchors[i].circle if i in anchors else None for i in range(len(scene.masses))]
            masses[f"circle_{field} [{of}]"] = [getattr(c, field) if c else None for c in circles]
    tables = {
        "masses": _indexed("index", masses),
        "springs": _indexed("index", _with_units(scene, _springs(body))),
        "joints": _indexed("index", _with_units(scene, _joints(body))),
        "settings": _setting_rows(body),
    }
    if scene.walls:
        rows = msgspec.to_builtins(scene.walls)
        points = [[*row.pop("point"), *row.pop("normal"), *row.values()] for row in rows]
        head = ["x", "y", "normal_x", "normal_y", *rows[0]]
        units = {"x": unit, "y": unit, "hardness": f"1/({unit} s^2)", "slip_speed": f"{unit}/s"}
        tables["walls"] = [[_head(name, units.get(name, "")) for name in head], *points]
    if body.loops:
        head = ["kind", "pressure_or_bulk_modulus [kg/s^2]", "outside [kg/s^2]", f"area [{unit}^2]", "masses"]
        loops = [list(_filling(body, k).values()) for k in range(len(body.loops))]
        tables["fillings"] = [head, *([*numbers, " ".join(map(str, masses))] for *numbers, masses in loops)]
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, rows in tables.items():
            # Without the time of day, the same body makes the same file.
            archive.writestr(zipfile.ZipInfo(f"{name}.csv"), _csv(rows, decimal_comma), zipfile.ZIP_DEFLATED)
    return out.getvalue()


def _object(data: dict[str, Any], depth: int = 1) -> str:
    """JSON in ASCII with a line for each field, and for each field of an object in it."""
    lines = []
    for key, value in data.items():
        text = _object(value, depth + 1) if isinstance(value, dict) and depth < 2 else _inline(value)
        lines.append(f"{' ' * 2 * depth}{json.dumps(key)}: {text}")
    return "{\n" + ",\n".join(lines) + "\n" + " " * 2 * (depth - 1) + "}"


def _inline(value: Any) -> str:
    return json.dumps(value, allow_nan=False)


# ------------------------------------------------------------------------- parts
def _masses(body: Body) -> dict[str, Any]:
    return {
        "position": body.positions.tolist(),
        "velocity": body.velocities.tolist(),
        "mass": body.mass.tolist(),
        "radius": body.radius.tolist(),
        **({"force": _forces(body)} if body.loads else {}),
    }


def _forces(body: Body) -> list[tuple[float, float]]:
    return [body.loads.get(i, (0.0, 0.0)) for i in range(len(body.mass))]


def _springs(body: Body) -> dict[str, Any]:
    a, b = body.ends.T.tolist()
    numbers = {"stiffness": body.stiffness, "damping": body.damping, "rest_length": body.rest_length}
    columns = {"a": a, "b": b, **{name: values.tolist() for name, values in numbers.items()}}
    springs = body.scene.linear_springs
    for name in ("strength", "yield_force", "hardening"):
        values = [getattr(spring, name) for spring in springs]
        if any(values):
            columns[name] = values
    if body.broken.any():
        columns["broken"] = body.broken.astype(int).tolist()
    return columns


def _joints(body: Body) -> dict[str, Any]:
    a, b = body.joints.T.tolist()
    numbers = {
        "stiffness": body.joint_stiffness,
        "damping": body.joint_damping,
        "rest_angle": body.rest_angle,
    }
    columns = {"a": a, "b": b, **{name: values.tolist() for name, values in numbers.items()}}
    torques = [joint.yield_torque for joint in body.scene.angular_springs]
    return columns | ({"yield_torque": torques} if any(t is not None for t in torques) else {})


def _filling(body: Body, k: int) -> dict[str, Any]:
    loop = body.loops[k]
    kind = "gas" if loop.is_gas else "liquid"
    return {
        "kind": kind,
        "pressure" if loop.is_gas else "bulk_modulus": loop.pressure,
        "outside": loop.outside,
        "area": loop.area,
        "masses": loop.masses,
    }


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
    }


def _units(scene: sim.Scene) -> dict[str, str]:
    return {name: unit.replace("L", scene.view.unit) for name, unit in _UNITS.items()}


# ------------------------------------------------------------------------- tables
def _setting_rows(body: Body) -> list[Sequence[Any]]:
    scene = body.scene
    flat = {**_settings(body), "unit_of_length": scene.view.unit, "y_down": int(scene.view.y_down)}
    for field in ("wind", "contact"):
        if (value := getattr(scene, field)) is not None:
            flat |= {f"{field}_{key}": number for key, number in msgspec.to_builtins(value).items()}
    rows: list[Sequence[Any]] = [["setting", "value"]]
    for name, value in flat.items():
        unit = _ascii(_units(scene).get(name, _SETTING_UNITS.get(name, "").replace("L", scene.view.unit)))
        if isinstance(value, tuple | list):
            rows += [[_head(f"{name}_{axis}", unit), part] for axis, part in zip("xy", value, strict=True)]
        else:
            rows.append([_head(name, unit), value])
    return rows


_SETTING_UNITS = {
    "wind_velocity": "L/s",
    "wind_length_scale": "L",
    "contact_distance": "L",
    "contact_stiffness": "kg/(L s^2)",
    "contact_slip_speed": "L/s",
}


def _with_units(scene: sim.Scene, columns: Mapping[str, Iterable[Any]]) -> dict[str, Iterable[Any]]:
    units = _units(scene)
    return {_head(name, _ascii(units.get(name, ""))): values for name, values in columns.items()}


def _head(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name


def _indexed(name: str, columns: Mapping[str, Iterable[Any]]) -> list[Sequence[Any]]:
    rows = zip(*columns.values(), strict=True)
    return [[name, *columns], *([i, *row] for i, row in enumerate(rows))]


def _csv(rows: Iterable[Sequence[Any]], decimal_comma: bool) -> str:
    return csv_text((map(_cell, row) for row in rows), decimal_comma)


def _cell(value: Any) -> Any:
    """A text that no spreadsheet takes for a formula, and everything else as it is."""
    if isinstance(value, str):
        return f"'{value}" if value[:1] in ("=", "+", "-", "@", "\t", "\r") else value
    return value


def _ascii(unit: str) -> str:
    return unit.replace("²", "^2").replace("°", "deg")
