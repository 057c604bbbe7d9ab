"""What the page's script draws, computed by node instead of a browser."""

from __future__ import annotations

import json
import subprocess
from typing import Any

import numpy as np

from app.stage.colors import palette
from app.stage.plan import Picture, encode_damage, encode_frame, encode_plan
from app.stage.sketch import Sketch
from sim import Scene, Simulation
from tests.page.check import FOLDER, NODE

_WIDTHS = {"positions": 3, "wxyzs": 4, "scales": 3, "colors": 3}


def sketch_of(scene: Scene) -> Sketch:
    return Sketch(scene, palette(scene.view.colors, dark=False))


def drawn(scene: Scene, picture: Picture) -> dict[str, Any]:
    """What the page draws of a picture, see `all_drawn`."""
    return all_drawn([(scene, picture)])[0]


def all_drawn(pictures: list[tuple[Scene, Picture]]) -> list[dict[str, Any]]:
    """What the page draws of pictures, with their scenes' rest angles.

    Returns:
        For each picture: of each node its `positions`, `wxyzs`, `scales` and `colors`; the (J,) `deviations`
        of the joints, degrees; the `sizes` of the sections for walls, fillings and wind, `outlines` of these
        on a screen whose pixels are px of the scene, and the velocity of the `air` at a place, see
        instances.mjs.
    """
    lines = []
    for scene, picture in pictures:
        rest = np.array([joint.rest_angle for joint in scene.angular_springs])
        arrays = {
            "plan": encode_plan(1, sketch_of(scene), rest),
            "frame": encode_frame(1, picture),
            "damage": encode_damage(1, picture),
        }
        lines.append(json.dumps({name: array.tolist() for name, array in arrays.items()}))
    out = subprocess.run(
        [NODE, FOLDER / "instances.mjs"],
        input="\n".join(lines),
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    ).stdout
    return [
        {
            name: {key: np.array(values, float).reshape(-1, _WIDTHS[key]) for key, values in node.items()}
            if isinstance(node, dict) and "positions" in node
            else node if node is None or isinstance(node, dict) else np.array(node, float)
            for name, node in json.loads(line).items()
        }
        for line in out.splitlines()
    ]  # fmt: skip


def after(scene: Scene, steps: int) -> tuple[Simulation, Picture]:
    """A scene in motion, and its picture."""
    simulation = Simulation(scene)
    simulation.step(steps)
    return simulation, Picture.of(simulation)
