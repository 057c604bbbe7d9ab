"""A body as a module in JavaScript, for games: the physics of the live file, and the body's numbers."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

from msgspec.structs import replace

import sim
from sim.scene.types import shown_name

from ...bundle import joined
from ..body.body import Body
from ..body.features import features_of
from ..body.program import LICENCE, check_forces, counted, plain, time_step, wrapped
from .data import body_data

_START = Path(__file__).parent / "static" / "game.js"

_USE = """import { createBody } from "./FILE.js";
const body = createBody();
body.advance(1 / 60); // seconds, in each frame; false once the body has run away
body.positions; // Float64Array: x and y of mass 0, of mass 1, and so on
body.drag(0, 320, 240); // leads a mass; body.release(0) lets go of it
body.push(1, 500, 0); // a force, until there is another; body.hold(1) makes it an anchor"""


def javascript_program(moment: sim.Moment) -> tuple[bytes, list[str]]:
    """The module, in UTF-8, and what whoever uses it should know: sentences without a full stop.

    Its step is the scene's, unless that is beyond the stability limit; then it is a whole part of it.

    Raises:
        InputError: a position or a velocity is not a finite number, or programs do not know a force or the
            force law.
    """
    body = Body.of(moment)
    check_forces(body.scene)
    dt, notes = time_step(body)
    head = "".join(f"// {line}".rstrip() + "\n" for line in _about(body, notes))
    text = f"""// @ts-check
{head}
{joined(_START, features_of(body.scene))}
/** The body as it was when this was written. @type {{BodyData}} */
export const BODY = {_literal(_numbers(body))};

/** The length of a time step, s. */
export const DT = {dt!r};

/** A new body, at the moment for which this was written. */
export const createBody = () => new SoftBody(BODY, DT);
"""
    return text.encode(), notes


def _numbers(body: Body) -> dict[str, Any]:
    """The body's data for the tutorial's step, or with springs as soft as the stable spring makes them."""
    scene = body.scene
    if scene.integrator.method != "stable_spring":
        tutorial = replace(scene, integrator=replace(scene.integrator, method="symplectic_euler"))
        return body_data(dataclasses.replace(body.moment, scene=tutorial))
    soft = body.softened()
    return body_data(body.moment) | {
        "stiffness": soft.stiffness.tolist(),
        "damping": soft.damping.tolist(),
        "jointStiffness": soft.joint_stiffness.tolist(),
        "jointDamping": soft.joint_damping.tolist(),
    }


def _literal(data: dict[str, Any]) -> str:
    """JSON with a line for each field, or more; numbers read back exactly as they are."""
    fields = ("\n    ".join(wrapped(f'"{key}": {json.dumps(data[key], allow_nan=False)}')) for key in data)
    return "{\n  " + ",\n  ".join(fields) + "\n}"


def _about(body: Body, notes: list[str]) -> list[str]:
    """The lines at the top."""
    scene = body.scene
    unit, down = plain(scene.view.unit), "down" if scene.view.y_down else "up"
    turn = "clockwise" if scene.view.y_down else "anticlockwise"
    first = f"{plain(shown_name(scene))}: a body of {counted(body)}, written by softrod."
    more = [
        "This is a module without dependencies, for browsers, node and bundlers. `SoftBody`, at its end, has "
        "all that can be done with a body, and its types are in comments.",
        "A time step is one of symplectic Euler: all forces from the present state, then velocities, then "
        f"positions. x grows to the right and y {down}, so positive angles are {turn}; px stands for the "
        f"unit of length{'' if unit == 'px' else ', ' + unit}.",
    ]
    if notes:
        more.append("Note: " + "; ".join(notes) + ".")
    lines = [line for paragraph in more for line in wrapped(paragraph)]
    return [*wrapped(first), "", *(f"  {line}" for line in _USE.splitlines()), "", *lines, LICENCE]
