"""What docs/extending.md adds to the solver is added by its steps alone, in a copy, and is right."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import sim
from sim.motion import quantities
from tests.amount import NIGHT

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs" / "extending.md").read_text(encoding="utf-8")

TRY = """
import msgspec
import numpy as np
import sim
from msgspec.structs import replace
from sim.analysis.equilibrium import StaticModel
from sim.model.system import build_system
from sim.forces.all import accelerations
from sim.compiling.compiler import needed_by
from sim.motion.stability import limit_at_start
from sim.forces.reference import Physics
from sim.scene.types import Attractor

def differs(scene):
    body = StaticModel(scene, balanced=False)
    q = body.start + 3.0 * np.random.default_rng(1).normal(size=body.start.size)
    q[[0, *range(len(scene.masses) + 1, body.slots)]] = 0.0
    q[body.slots + np.array([0, *range(len(scene.masses) + 1, body.slots)])] = 0.0
    x = q[: body.slots] + 1j * q[body.slots :]
    v = (x - x[1]) * 0.5j * (body.state.inverse_mass > 0.0)
    by_numpy = Physics(body.tables, body.state).accelerations(x, v)
    a = np.zeros_like(q)
    accelerations(body.tables, body.state, body.scratch, q, np.concatenate((v.real, v.imag)), a)
    return np.abs(a[: body.slots] + 1j * a[body.slots :] - by_numpy).max() / np.abs(by_numpy).max()

still = sim.rope(masses=6)
assert differs(still) < 1e-12
assert b"attractors" not in msgspec.json.encode(still)
points = Attractor(point=(400.0, 300.0), strength=50.0, reach=80.0, drag=4.0),
pulled = sim.rope(masses=6, attractors=points, gravity=(0.0, 0.0), air_friction=0.0)
assert differs(pulled) < 1e-12
needs = needed_by("rk4", build_system(pulled).body)
assert "attractors.add_forces" in needs, needs
assert not any("attractors" in name for name in needed_by("rk4", build_system(still).body))

moving = sim.Simulation(pulled, integrator="rk4", dt=1e-4)
moving.energy()
moving.advance(0.3)
balance = moving.energy()
assert abs(balance.attractors) > 1.0 and balance.air < -1.0, balance
assert abs(balance.residual) < 1e-6 * abs(balance.total), balance

stiff = sim.rope(masses=2, attractors=(Attractor(point=(300.0, 100.0), strength=9e5, reach=1e4),),
    stiffness=1.0, damping=0.0, angular_stiffness=1.0, angular_damping=0.0)
found = limit_at_start(stiff, "velocity_verlet")
assert found.cause == "attractors", found
assert abs(found.limit - 2.0 / 9e5 ** 0.5) < 0.02 * found.limit, found
one = sim.Mass(position=(320.0, 90.0))
floats = sim.Scene(name="one", masses=(one,), attractors=stiff.attractors, gravity=(0.0, 9e4))
assert np.abs(np.subtract(sim.equilibrium(floats).positions[0], (300.0, 100.1))).max() < 1e-6

bent = sim.rope(masses=6, force_law="tangent", gravity=(0.0, 0.0))
assert differs(bent) < 1e-12

free = sim.rope(masses=6, damping=0.0, angular_damping=0.0, air_friction=0.0)
errors = []
for dt in (2e-3, 1e-3):
    both = ("beeman", dt), ("rk4", 1e-5)
    ends = [sim.Simulation(free, integrator=method, dt=h) for method, h in both]
    for one in ends:
        one.advance(0.1)
    errors.append(np.abs(ends[0].positions - ends[1].positions).max())
assert 3.5 < errors[0] / errors[1] < 4.6, errors

# A hand has stopped one mass: what the method remembers is of no use any more.
stopped = sim.Simulation(free, integrator="beeman", dt=1e-3)
stopped.advance(0.1)
stopped.grab(3)
stopped.release(3)
begun = sim.Simulation(replace(free, pose=stopped.pose()), integrator="beeman", dt=1e-3)
for one in (stopped, begun):
    one.advance(0.05)
assert np.abs(stopped.positions - begun.positions).max() < 1e-9
"""


TANGENT_IN_NUMPY = """
def tangent_law(s):
    half = 0.5 * np.angle(s)
    return 2.0 * abs(s) * np.tan(half), -4.0 * abs(s) * np.log(np.cos(half))


"""


def blocks(heading: str) -> list[str]:
    """The pieces of Python in a section of the guide."""
    section = GUIDE.partition(f"## {heading}\n")[2].partition("\n## ")[0]
    found = re.findall(r"^   ```python\n(.*?)^   ```", section, re.DOTALL | re.MULTILINE)
    return [re.sub(r"^   ", "", block, flags=re.MULTILINE) for block in found]


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1, (path.name, old)
    path.write_text(text.replace(old, new), encoding="utf-8")


def test_the_guide_s_quantity_is_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    section = GUIDE.partition("## A quantity\n")[2].partition("\n## ")[0]
    row, function = re.findall(r"```python\n(.*?)```", section, re.DOTALL)
    shutil.copy(str(quantities.__file__), path := tmp_path / "quantities.py")
    catalogue = f"# {'-' * 73} the catalogue\n"
    change(path, catalogue, f"{function}\n\n{catalogue}")
    change(path, "_ALL = (\n", f"_ALL = (\n    *{row.strip()},\n")
    new = ModuleType("sim.motion.quantities_of_the_guide")
    monkeypatch.setitem(sys.modules, new.__name__, new)
    vars(new).update(__package__="sim.motion")
    exec(path.read_text(encoding="utf-8"), vars(new))
    simulation = sim.Simulation(sim.rope(masses=4, mass=2.5, gravity=(0.0, 1000.0)))
    simulation.advance(0.1)
    found = new.KINDS["mass", "momentum"].values(simulation, np.arange(4))
    assert found == pytest.approx(2.5 * np.hypot(*simulation.velocities.T))
    assert found.max() > 0.0
    assert len(new.KINDS) == len(quantities.KINDS) + 1
    for name, kind in quantities.KINDS.items():
        of = np.arange(1 if kind.of in ("joint", "spring") else 4)
        assert np.array_equal(new.KINDS[name].values(simulation, of), kind.values(simulation, of)), name


@pytest.mark.skipif(not NIGHT, reason="it compiles a copy of the solver; by night")
def test_a_term_a_law_and_a_method_are_added_by_the_guide_s_steps_alone(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "sim", tmp_path / "sim", ignore=shutil.ignore_patterns("__pycache__"))
    types, forces = tmp_path / "sim" / "scene" / "types.py", tmp_path / "sim" / "forces"
    # A physical term: two files, and a line of a third.
    fields, module = blocks("A physical term")
    change(types, "class Scene(", f"{fields}\n\nclass Scene(")
    change(
        types,
        "    lesson: Lesson | None = None\n",
        "    lesson: Lesson | None = None\n"
        "    attractors: tuple[Attractor, ...] | msgspec.UnsetType = msgspec.UNSET\n",
    )
    (forces / "attractors.py").write_text(module, encoding="utf-8")
    change(forces / "all.py", "PUSHES, RAILS)\n", "PUSHES, RAILS, ATTRACTORS)\n")
    change(forces / "all.py", "from .air import", "from .attractors import ATTRACTORS\nfrom .air import")
    # A law: a code, a row, a case, and the same in NumPy.
    (case,) = blocks("A force law of joints")
    joints = forces / "joints.py"
    change(types, '"tutorial", "conservative", "angle"', '"tutorial", "conservative", "angle", "tangent"')
    change(
        joints,
        "    if law == ANGLE:\n        return deflection, 0.5",
        re.sub("^", "    ", case, flags=re.MULTILINE).rstrip()
        + "\n    if law == ANGLE:\n        return deflection, 0.5",
    )
    change(
        joints,
        "NO_JOINTS, TUTORIAL, CONSERVATIVE, ANGLE = 0, 1, 2, 3",
        "NO_JOINTS, TUTORIAL, CONSERVATIVE, ANGLE, TANGENT = 0, 1, 2, 3, 4",
    )
    change(
        joints,
        '    "angle": Law(ANGLE, "Angle law"),\n',
        '    "angle": Law(ANGLE, "Angle law"),\n    "tangent": Law(TANGENT, "Tangent law"),\n',
    )
    change(joints, "    ANGLE: angle_law,\n", "    ANGLE: angle_law,\n    TANGENT: tangent_law,\n")
    tangent = TANGENT_IN_NUMPY
    change(joints, "IN_NUMPY: dict", f"{tangent}IN_NUMPY: dict")
    # A method without a tableau.
    (method,) = blocks("A method without a tableau")
    (tmp_path / "sim" / "solve" / "steps" / "beeman.py").write_text(method, encoding="utf-8")
    change(types, '    "rk4",\n', '    "rk4",\n    "beeman",\n')
    registry = tmp_path / "sim" / "solve" / "registry.py"
    change(
        registry,
        "from .steps.verlet import",
        "from .steps.beeman import BEEMAN_LIMIT, run_beeman\nfrom .steps.verlet import",
    )
    row = (
        'MethodInfo("beeman", "Beeman", run_beeman, order=2, look=("b", "h"), '
        'summary="With a memory.", limit=BEEMAN_LIMIT)'
    )
    change(registry, "_ALL = (\n", f"_ALL = (\n    {row},\n")
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path / "cache")}
    tried = subprocess.run(
        [sys.executable, "-c", TRY],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env=environment,
        check=False,
    )
    assert tried.returncode == 0, tried.stderr
