"""A body as the script of a live file has it; see `static/body.js` for the fields and their units."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np

import sim
from sim.forces.muscles import KINDS, steer_of
from sim.model.system import System, build_system
from sim.scene.parts import JointMuscle, SpringMuscle
from sim.scene.types import Damage, Grips, is_damageable

from ..body.body import Body
from ..body.features import features_of

ENDLESS = 1e300
"""What stands for no limit, since JSON has no infinity."""


def body_data(moment: sim.Moment, has: Mapping[str, bool] | None = None) -> dict[str, Any]:
    """The `BodyData` of a moment.

    Args:
        moment: the moment.
        has: the features of the script, see `features_of`; those of the moment's scene if it is None.

    Raises:
        InputError: a position or a velocity is not a finite number.
    """
    body, scene = Body.of(moment), moment.scene
    has = has or features_of(scene)
    system = build_system(scene)
    rest_angle = np.array([j.rest_angle for j in scene.angular_springs]) + moment.rest_angle_shift
    air = system.body.environment.air
    return {
        "time": moment.time,
        "law": scene.force_law,
        "gravity": list(map(float, scene.gravity)),
        "down": 1 if scene.view.y_down else -1,
        "airFriction": scene.air_friction,
        "airLaw": scene.air_law,
        "wind": list(body.wind),
        "waves": air.waves.tolist(),
        "medium": msgspec.to_builtins(scene.medium) if scene.medium else None,
        "ground": _ground(scene.ground) if scene.ground else None,
        "softening": system.body.softening,
        "positions": body.positions.ravel().tolist(),
        "velocities": body.velocities.ravel().tolist(),
        "mass": body.mass.tolist(),
        "held": body.held.astype(int).tolist(),
        "loads": [[mass, *map(float, force)] for mass, force in body.loads.items()],
        "circles": [
            {"mass": mass, "x": x, "y": y, **msgspec.structs.asdict(circle)}
            for mass, (circle, (x, y)) in body.circles.items()
        ],
        "ends": body.ends.ravel().tolist(),
        "stiffness": [s.stiffness for s in scene.linear_springs],
        "damping": [s.damping for s in scene.linear_springs],
        "restLength": [s.rest_length * moment.rest_length_scale for s in scene.linear_springs],
        "joints": body.joints.ravel().tolist(),
        "jointStiffness": system.body.joint_stiffness[system.joint_order].tolist(),
        "jointDamping": [j.damping for j in scene.angular_springs],
        "restAngle": (180.0 - (180.0 - rest_angle) % 360.0).tolist(),
        "sides": _sides(body),
        "broken": np.flatnonzero(body.broken).tolist(),
        "walls": _walls(body, has),
        "fillings": [
            {
                "masses": loop.masses,
                "isGas": loop.is_gas,
                "strength": loop.pressure,
                "outside": loop.outside,
                "area": loop.area,
            }
            for loop in body.loops
        ],
        "contact": _contact(system, has),
        "limits": _limits(scene) if is_damageable(scene) else None,
        "yielded": _yielded(moment.damage),
        "grips": _grips(moment.grips, has),
        "muscles": _muscles(body, has),
        **_features(body, has),
    }


def _features(body: Body, has: Mapping[str, bool]) -> dict[str, Any]:
    """The fields that there are with some features only."""
    data: dict[str, Any] = {}
    if has["HAS_SOLID"]:
        data["sizes"] = body.size.tolist()
    if has["HAS_RAILS"]:
        data["rails"] = [[mass, *way] for mass, way in body.rails.items()]
    if has["HAS_MOTORS"]:
        data["motors"] = [
            [joint, math.radians(motor.speed), motor.torque, math.radians(motor.slip), steer_of(motor.keys)]
            for joint, motor in body.motors.items()
        ]
    if has["HAS_PUSHES"]:
        data["pushes"] = [list(push) for push in body.pushes]
    if has["HAS_EFFORTS"]:
        data["efforts"] = list(body.efforts)
    return data


def _walls(body: Body, has: Mapping[str, bool]) -> list[list[float | None]]:
    """The `Wall`s of the script."""
    rows = body.walls.tolist()
    if has["HAS_BELTS"] or has["HAS_STATIC"]:
        for row, wall in zip(rows, body.scene.walls, strict=True):
            row.append(None if wall.speed is msgspec.UNSET else wall.speed)
            if has["HAS_STATIC"]:
                row.append(None if wall.static_friction is msgspec.UNSET else wall.static_friction)
    return rows


def _sides(body: Body) -> dict[str, list[int]] | None:
    if not (body.spring_side.any() or body.joint_side.any()):
        return None
    return {"springs": body.spring_side.tolist(), "joints": body.joint_side.tolist()}


def _contact(system: System, has: Mapping[str, bool]) -> dict[str, Any] | None:
    contact = system.body.environment.contact
    if not contact.present:
        return None
    apart: list[list[int]] = [[]] * system.body.springs
    for s, spring in enumerate(system.spring_order.tolist()):
        slots = contact.apart[contact.apart_start[s] : contact.apart_start[s + 1]]
        apart[spring] = system.mass_order[slots - 1].tolist()
    solid: dict[str, Any] = {}
    if has["HAS_SOLID"]:
        slots = contact.end_a[system.body.springs :]
        starts = contact.apart_start[system.body.springs :]
        never = [
            system.mass_order[contact.apart[first:behind] - 1].tolist()
            for first, behind in itertools.pairwise(starts.tolist())
        ]
        solid["solid"] = [*zip(system.mass_order[slots - 1].tolist(), never, strict=True)]
    return {
        **solid,
        "distance": contact.distance,
        "stiffness": contact.stiffness,
        "friction": contact.friction,
        "slipSpeed": contact.slip_speed,
        "lost": [contact.damping, contact.hysteresis, contact.calm],
        "tangential": [contact.tangential, contact.resisting],
        "margin": contact.margin,
        "apart": apart,
    }


def _grips(grips: Grips | None, has: Mapping[str, bool]) -> dict[str, Any] | None:
    if grips is None:
        return None
    sliding = {"sliding": grips.sliding or ()} if has["HAS_STATIC"] else {}
    return {"walls": grips.walls, "springs": grips.springs, **sliding}


def _ground(ground: sim.Ground) -> dict[str, float]:
    return {
        "gravity": ground.gravity,
        "forward": ground.forward,
        "backward": ground.backward,
        "sideways": ground.sideways,
        "slipSpeed": ground.slip_speed,
    }


def _limits(scene: sim.Scene) -> dict[str, list[float]]:
    springs, joints = scene.linear_springs, scene.angular_springs
    return {
        "strength": [ENDLESS if s.strength is None else s.strength for s in springs],
        "yieldForce": [ENDLESS if s.yield_force is None else s.yield_force for s in springs],
        "hardening": [s.hardening for s in springs],
        "yieldTorque": [ENDLESS if j.yield_torque is None else j.yield_torque for j in joints],
    }


def _muscles(body: Body, has: Mapping[str, bool]) -> dict[str, Any] | None:
    if body.beat is None:
        return None
    return {
        "frequency": body.beat.frequency,
        "phase": body.beat.phase,
        "springs": _rows(body.spring_muscles, has),
        "joints": _rows(body.joint_muscles, has),
    }


def _rows(muscles: Mapping[int, SpringMuscle | JointMuscle], has: Mapping[str, bool]) -> list[list[float]]:
    return [
        [
            *(part, muscle.amplitude, muscle.per_beat, muscle.phase, int(KINDS[muscle.wave])),
            *([steer_of(muscle.keys)] if has["HAS_EFFORTS"] else ()),
        ]
        for part, muscle in muscles.items()
    ]


def _yielded(damage: Damage | None) -> dict[str, list[float]] | None:
    if damage is None or not (damage.set_lengths or damage.hardened or damage.set_angles):
        return None
    return {
        "length": list(damage.set_lengths),
        "hardened": list(damage.hardened),
        "angle": list(damage.set_angles),
    }
