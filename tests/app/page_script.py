"""What the page's script draws, computed by node instead of a browser."""

from __future__ import annotations

import json
import subprocess
from typing import Any

import numpy as np

from app.drawing.colors import palette
from app.drawing.plan import Picture, encode_damage, encode_frame, encode_plan
from app.drawing.sketch import Sketch
from sim import Scene, Simulation
from tests.page.check import FOLDER, NODE

_WIDTHS = {"positions": 3, "wxyzs": 4, "scales": 3, "colors": 3}


def sketch_of(scene: Scene) -> Sketch:
    return Sketch(scene, palette(scene.view.colors, dark=False))


def drawn(scene: Scene, picture: Picture) -> dict[str, Any]:
    """What the page draws of a picture, with the scene's rest angles.

    Returns:
        For each node its arrays `positions`, `wxyzs`, `scales` and `colors`; the (J,) `deviations` of the
        joints, degrees; the `sizes` of the sections for walls, fillings and wind, `outlines` of these on a
        screen whose pixels are px of the scene, and the velocity of the `air` at a place, see instances.mjs.
    """
    rest = np.array([joint.rest_angle for joint in scene.angular_springs])
    plan = encode_plan(1, sketch_of(scene), rest)
    arrays = {
        "plan": plan,
        "frame": encode_frame(1, picture),
        "damage": encode_damage(1, picture),
    }
    line = json.dumps({name: array.tolist() for name, array in arrays.items()})
    out = subprocess.run(
        [NODE, FOLDER / "instances.mjs"], input=line, stdout=subprocess.PIPE, text=True, check=True
    ).stdout
    return {
        name: {key: np.array(values, float).reshape(-1, _WIDTHS[key]) for key, values in node.items()}
        if isinstance(node, dict) and "positions" in node
        else node if node is None or isinstance(node, dict) else np.array(node, float)
        for name, node in json.loads(out).items()
    }  # fmt: skip


def after(scene: Scene, steps: int) -> tuple[Simulation, Picture]:
    """A scene in motion, and its picture."""
    simulation = Simulation(scene)
    simulation.step(steps)
    return simulation, Picture.of(simulation)
