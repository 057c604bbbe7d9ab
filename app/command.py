"""What the commands share: the scene with its changed numbers, and how they fail."""

from __future__ import annotations

import sys
from typing import Annotated

from tyro.conf import UseAppendAction, arg

import sim
from sim.settings import apply_assignments

Settings = Annotated[
    UseAppendAction[tuple[str, ...]],
    arg(
        name="set",
        metavar="KEY=VALUE",
        help="set a number of the scene; may be repeated. Keys: linear_stiffness, linear_damping, "
        "angular_stiffness, angular_damping, rest_length_scale, rest_angle, gravity, air_friction, masses, "
        "dt, tolerance, template; tempo; wind_speed, wind_direction, turbulence; wall_friction, bounciness; "
        "contact_distance, contact_stiffness, contact_friction; gas_pressure, liquid_stiffness; strength, "
        "yield_force; and force_law, method, restitution and grip, which are names",
    ),
]

CsvComma = Annotated[
    bool,
    arg(
        help="write CSV with decimal commas, and semicolons between the columns, as spreadsheets of many "
        "countries read it"
    ),
]


def scene_of(name: str, settings: tuple[str, ...]) -> sim.Scene:
    """A scene by its name, its file's path or a link, with settings KEY=VALUE.

    Raises:
        SceneError: there is none, or it is not valid.
        SettingError: one of the settings makes no sense.
    """
    return apply_assignments(sim.load_scene(name), settings)


def fail(reason: object) -> int:
    """Say why on the error stream; the exit status is 1."""
    print(f"softrod: {reason}", file=sys.stderr)
    return 1
