"""In which direction a spring is written matters neither to what is drawn nor to what is taken home."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import sim
from app.export import instances
from app.export.body.body import Body
from app.export.body.program import python_program
from app.stage.plan import Picture
from tests.app.page_script import drawn, sketch_of
from tests.sim.bodies import body, some_flipped


def pair(shape: str) -> tuple[sim.Scene, sim.Scene]:
    scene = body(shape, "conservative", 4)
    return scene, some_flipped(scene, 1)


@pytest.mark.parametrize("shape", ["chain", "hub", "tree"])
def test_wedges_and_springs_are_drawn_alike(shape: str) -> None:
    found = []
    for scene in pair(shape):
        picture, sketch = Picture.of(sim.Simulation(scene)), sketch_of(scene)
        rest = np.array([joint.rest_angle for joint in scene.angular_springs])
        places = instances.springs(sketch, picture)
        found.append(
            (instances.deviations(sketch, picture, rest), sketch.joint_mass, places, drawn(scene, picture))
        )
    one, other = found
    assert other[0] == pytest.approx(one[0], abs=1e-9)
    assert (one[1] == other[1]).all()
    assert other[2].colors == pytest.approx(one[2].colors)
    assert other[3]["deviations"] == pytest.approx(one[3]["deviations"], abs=1e-2)
    # The wedges lie at the second spring as it leaves the mass, however that is written.
    for key in ("positions", "wxyzs"):
        assert np.abs(other[3]["wedges"][key]) == pytest.approx(np.abs(one[3]["wedges"][key]), abs=1e-3)


@pytest.mark.parametrize("shape", ["chain", "hub"])
def test_programs_move_alike(shape: str, tmp_path: Path) -> None:
    ends = []
    for i, scene in enumerate(pair(shape)):
        program = tmp_path / f"program{i}.py"
        program.write_bytes(python_program(Body.of(sim.Simulation(scene).capture()))[0])
        run = subprocess.run([sys.executable, program, "100"], capture_output=True, text=True, check=True)
        ends.append(np.array(run.stdout.split(), float))
    assert ends[0].size and ends[1] == pytest.approx(ends[0], abs=1e-6)
