"""The live file: its physics is the solver's, and it is one file that asks nobody for anything."""

from __future__ import annotations

import dataclasses
import html
import json
import re
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from app.export.body.features import features_of
from app.export.body.program import LAWS_IN_PROGRAMS, unknown_forces
from app.export.live.data import body_data
from app.export.live.lesson import MEASURED, OF_MASSES
from app.export.live.live import live_html
from app.export.live.program import javascript_program
from app.export.live.sliders import KEYS
from sim.scene.lesson import Lesson, Step
from sim.settings import apply_assignments, set_value
from sim.store.files import list_scenes
from tests.amount import NIGHT, part_of
from tests.app.command import Softrod, refused
from tests.app.html_pages import held
from tests.page.check import FOLDER, NODE
from tests.sim.changes import with_joints, with_springs
from tests.sim.fuzzing import wild_scene, wild_world, with_muscles
from tests.sim.surrounded import ALONE, MOTORISED, ON_RAILS, ONE_SIDED, SOLID, around, block_on_a_belt

STEPS = 400
CLOSE = 1e-9
"""px"""
PRESETS = [
    info.name for info in list_scenes() if info.built_in and not unknown_forces(sim.load_scene(info.name))
]
EULER = "symplectic_euler"
METHODS = {EULER: "symplectic_euler", "velocity_verlet": "verlet"}
"""The solver's, and the file's."""


def about_of(data: bytes) -> dict[str, Any]:
    """The data of a file's script."""
    return held(data.decode(), "about")


def by(scene: sim.Scene, method: Any) -> sim.Scene:
    """The scene by a method, with a step that is stable at its start."""
    integrator = sim.Integrator(method=method, dt=min(scene.integrator.dt, 2e-3))
    scene = replace(scene, integrator=integrator)
    limit = sim.Simulation(scene).stability().limit
    return replace(scene, integrator=replace(integrator, dt=min(integrator.dt, 0.5 * limit)))


def by_script(scenes: list[sim.Scene], steps: int = STEPS) -> list[dict[str, np.ndarray]]:
    """Where the masses of scenes are after some steps in the script of live files, and so in a program."""
    told = [
        {
            "data": body_data(sim.Simulation(scene).capture()),
            "method": METHODS[scene.integrator.method],
            "h": scene.integrator.dt,
            "count": steps,
        }
        for scene in scenes
    ]
    found: dict[int, dict[str, np.ndarray]] = {}
    features = [features_of(scene) for scene in scenes]
    for has in features:  # a program moves all bodies with its own features
        alike = [i for i in range(len(scenes)) if i not in found and features[i] == has]
        if alike:
            with tempfile.TemporaryDirectory() as folder:
                program = Path(folder) / "program.mjs"
                program.write_bytes(javascript_program(sim.Simulation(scenes[alike[0]]).capture())[0])
                found |= zip(alike, run_script([told[i] for i in alike], program), strict=True)
    assert all(one["same"].all() for one in found.values())
    assert sum(one["same"].size for one in found.values()) == sum(
        s.integrator.method == EULER for s in scenes
    )
    return [found[i] for i in range(len(scenes))]


def run_script(told: list[dict[str, Any]], *program: Path) -> list[dict[str, np.ndarray]]:
    """What comes of bodies in the script, see `tests/page/steps.mjs`."""
    lines = "".join(json.dumps(one) + "\n" for one in told)
    words = [NODE, FOLDER / "steps.mjs", *program]
    run = subprocess.run(words, input=lines, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return [{k: np.array(v) for k, v in json.loads(line).items()} for line in run.stdout.splitlines()]


def moved(scene: sim.Scene, steps: int = STEPS) -> sim.Simulation:
    simulation = sim.Simulation(scene)
    simulation.step(steps)
    return simulation


def grown(scene: sim.Scene, steps: int) -> float:
    """How far apart, px, the solver brings two motions that begin with other last digits."""
    shaken = sim.Simulation(scene)
    moment = shaken.capture()
    noise = 1e-15 * np.random.default_rng(1).normal(size=moment.rows.shape)
    shaken.restore(dataclasses.replace(moment, rows=moment.rows * (1.0 + noise)))
    shaken.step(steps)
    return float(np.abs(shaken.positions - moved(scene, steps).positions).max())


# ------------------------------------------------------------------------- physics
@pytest.fixture(scope="module")
def presets() -> list[tuple[sim.Scene, dict[str, np.ndarray]]]:
    """Presets by both methods, by day a part of them, and what the script says of each."""
    scenes = [by(sim.load_scene(name), method) for name in part_of(PRESETS, 3) for method in METHODS]
    return [*zip(scenes, by_script(scenes), strict=True)]


def test_every_preset_moves_as_the_solver_moves_it(presets: list) -> None:
    for scene, script in presets:
        off = np.abs(script["positions"].reshape(-1, 2) - moved(scene).positions).max()
        assert off < CLOSE or grown(scene, STEPS) > CLOSE, (scene.name, scene.integrator.method, off)


def test_the_limit_of_the_step_is_that_of_the_solver(presets: list) -> None:
    for scene, script in presets:
        simulation = sim.Simulation(scene)
        simulation.stability()
        limit = min(simulation.stability().limit, 1.0)
        assert script["limit"] == pytest.approx(limit, rel=0.05), (scene.name, scene.integrator.method)


def test_random_bodies_in_random_surroundings_move_and_break_as_in_the_solver() -> None:
    """But for those that run away, and those in which the last digit of a coordinate grows to be seen."""
    seeds = part_of(range(60), 5)  # of both methods, with muscles and without
    scenes = []
    for seed in seeds:
        rng = np.random.default_rng(seed)
        scene = wild_world(wild_scene(rng), rng)
        if seed % 3 == 0:
            scene = with_muscles(scene, rng)
        scene = by(scene, list(METHODS)[seed % 2])
        dt = max(1e-6, min(scene.integrator.dt, 2e-4))
        scenes.append(replace(scene, integrator=replace(scene.integrator, dt=dt)))
    compared = broke = 0
    for seed, scene, script in zip(seeds, scenes, by_script(scenes, 100), strict=True):
        simulation = moved(scene, 100)
        if simulation.divergence is not None or grown(scene, 100) > CLOSE:
            continue
        compared += 1
        off = np.abs(script["positions"].reshape(-1, 2) - simulation.positions).max()
        assert off < CLOSE, (seed, off)
        damage = simulation.damage
        broken = np.flatnonzero(script["broken"]).tolist()
        assert broken == sorted(damage.broken if damage is not None else ()), seed
        broke += bool(broken)
        if damage is not None and damage.set_lengths:
            assert script["setLength"] == pytest.approx(np.array(damage.set_lengths), abs=1e-9), seed
    assert compared >= (40 if NIGHT else 4)
    assert broke >= (10 if NIGHT else 1)


def test_springs_and_joints_of_one_side_act_as_in_the_solver() -> None:
    measures = ["energy.linear", "energy.angular", *(f"spring{k}.force" for k in range(20)), "joint9.torque"]
    for method in METHODS:
        for law in LAWS_IN_PROGRAMS:
            scene = replace(by(around(ONE_SIDED), method), force_law=law)
            scene = replace(scene, integrator=replace(scene.integrator, dt=5e-4))
            simulation = sim.Simulation(scene)
            told = {"data": body_data(simulation.capture()), "method": METHODS[method], "h": 5e-4}
            (script,) = run_script([told | {"count": STEPS, "measures": measures}])
            simulation.step(STEPS)
            off = np.abs(script["positions"].reshape(-1, 2) - simulation.positions).max()
            assert off < CLOSE, (method, law, off)
            right = np.array([sim.quantity(one, scene).read(simulation) for one in measures])
            assert script["measured"] == pytest.approx(right, rel=1e-6)
            assert (right == 0.0).sum() > 3  # some let go


def test_springs_and_joints_of_one_side_yield_and_break_where_they_act() -> None:
    for method in METHODS:
        scene = by(around(ONE_SIDED), method)
        scene = with_springs(
            scene,
            yield_force=lambda s, _: 9e3 if s % 4 else None,
            strength=lambda s, _: None if s % 4 else 3e4,
        )
        scene = with_joints(scene, yield_torque=1e6)
        scene = replace(scene, integrator=replace(scene.integrator, dt=5e-4))
        (script,) = by_script([scene], 150)
        simulation = moved(scene, 150)
        assert simulation.damage is not None
        assert any(simulation.damage.set_lengths)
        assert any(simulation.damage.set_angles)
        assert np.flatnonzero(script["broken"]).tolist() == sorted(simulation.damage.broken) != []
        assert script["setLength"] == pytest.approx(np.array(simulation.damage.set_lengths), abs=1e-9)
        assert np.abs(script["positions"].reshape(-1, 2) - simulation.positions).max() < CLOSE


@pytest.mark.parametrize("kind", [ON_RAILS, MOTORISED, SOLID, ALONE])
def test_what_only_some_bodies_have_acts_as_in_the_solver(kind: str) -> None:
    words = ("force_law=conservative", "dt=0.0002", "linear_stiffness=20000", "linear_damping=60")
    scenes = [apply_assignments(by(around(kind), method), words) for method in METHODS]
    for scene, script in zip(scenes, by_script(scenes), strict=True):
        off = np.abs(script["positions"].reshape(-1, 2) - moved(scene).positions).max()
        assert off < CLOSE, (scene.integrator.method, off)


def test_what_sticks_sticks_as_in_the_solver() -> None:
    pile = sim.load_scene("pile")
    assert pile.contact is not None
    contact = replace(pile.contact, restitution="constant", tangential_stiffness=2000.0)
    walls = tuple(replace(wall, restitution="constant", tangential_hardness=5000.0) for wall in pile.walls)
    scenes = []
    for method in METHODS:
        scene = by(replace(pile, contact=contact, walls=walls), method)
        begun = sim.Simulation(scene)
        begun.advance(1.0)
        pose = begun.pose()
        assert pose.grips is not None
        assert len(pose.grips.springs) > 3
        assert len(pose.grips.walls) > 0
        scenes += [scene, replace(scene, pose=pose, bodies=())]  # from the start, and from where it sticks
    for scene, script in zip(scenes, by_script(scenes), strict=True):
        off = np.abs(script["positions"].reshape(-1, 2) - moved(scene).positions).max()
        assert off < CLOSE, (scene.integrator.method, off)


def test_what_has_yielded_before_yields_on_as_in_the_solver() -> None:
    rope = sim.rope(masses=6, length=240.0, direction=(1.0, 0.0), driven=None)
    springs = tuple(replace(s, yield_force=2e3, hardening=800.0) for s in rope.linear_springs)
    joints = tuple(replace(j, yield_torque=1e5) for j in rope.angular_springs)
    scene = by(replace(rope, linear_springs=springs, angular_springs=joints, bodies=()), EULER)
    simulation = sim.Simulation(scene)
    simulation.step(200)
    moment = simulation.capture()
    assert moment.damage is not None
    assert min(map(any, (moment.damage.set_lengths, moment.damage.hardened, moment.damage.set_angles)))
    told = {"data": body_data(moment), "method": EULER, "h": scene.integrator.dt, "count": 200}
    simulation.step(200)
    assert simulation.damage is not None
    assert simulation.damage.hardened != moment.damage.hardened
    found = run_script([told])[0]
    assert np.abs(found["positions"].reshape(-1, 2) - simulation.positions).max() < CLOSE
    assert found["setLength"] == pytest.approx(np.array(simulation.damage.set_lengths), abs=1e-9)


def test_a_step_of_the_tutorial_is_its_own_also_where_keys_are_held() -> None:
    scene = sim.load_scene("tutorial-3.3")
    simulation = sim.Simulation(scene)
    simulation.keys = ("up", "right")
    simulation.step(200)
    about = about_of(live_html(sim.Simulation(scene).capture())[0])
    presses = {"factor": about["up"]["factor"], "angle": about["right"]["angle"]}
    told = {
        "data": about["body"],
        "method": about["method"],
        "h": about["dt"],
        "count": 200,
        "presses": presses,
    }
    assert np.abs(run_script([told])[0]["positions"].reshape(-1, 2) - simulation.positions).max() < CLOSE


@pytest.mark.parametrize(
    "of",
    [
        {"speed": -60.0},
        {"static_friction": 0.6},
        {"static_friction": 0.6, "speed": -60.0},
        {"static_friction": 0.2},
    ],
)
def test_walls_of_all_kinds_hold_and_carry_as_in_the_solver(of: dict[str, Any]) -> None:
    floor = sim.Wall(
        point=(100.0, 320.0),
        normal=(1.0, -4.0),
        friction=0.4,
        bounciness=0.3,
        tangential_hardness=4000.0,
        restitution="constant",
        **of,
    )
    other = replace(floor, normal=(-1.0, -2.0), speed=msgspec.UNSET)
    masses = tuple(
        sim.Mass(position=(100.0 * i, 300.0), velocity=(90.0, 0.0), mass=1.0 + i) for i in range(3)
    )
    loose = sim.Scene(name="loose", masses=masses, walls=(floor, other), gravity=(0.0, 900.0))
    scenes = []
    for method in METHODS:
        scene = by(loose, method)
        begun = sim.Simulation(scene)
        begun.advance(3.0)
        assert begun.pose().grips
        scenes += [scene, replace(scene, pose=begun.pose())]
    for scene, script in zip(scenes, by_script(scenes), strict=True):
        off = np.abs(script["positions"].reshape(-1, 2) - moved(scene).positions).max()
        assert off < CLOSE, (scene.integrator.method, off)


@pytest.mark.parametrize("before", [0, 180])
def test_a_block_sticks_and_slips_as_in_the_solver(before: int) -> None:
    scenes = []
    for method in METHODS:
        begun = sim.Simulation(apply_assignments(block_on_a_belt(), [f"method={method}", "dt=0.002"]))
        begun.step(before)
        pose = begun.pose()
        assert before == 0 or (pose.grips is not None and pose.grips.sliding)
        scenes.append(replace(begun.scene, pose=pose))
    for scene, script in zip(scenes, by_script(scenes), strict=True):
        off = np.abs(script["positions"].reshape(-1, 2) - moved(scene).positions).max()
        assert off < CLOSE, (scene.integrator.method, off)


def test_held_keys_steer_motors_as_in_the_solver() -> None:
    scene = by(sim.load_scene("buggy"), EULER)
    data = live_html(sim.Simulation(scene).capture())[0].decode()
    assert re.findall('data-softrod-key="(.*?)"', data) == ["left", "right"]  # what the buggy knows
    about = about_of(data.encode())
    told = {"data": about["body"], "method": EULER, "h": about["dt"], "count": 200}
    ways = []
    for key, way in (("right", 1), ("left", -1)):
        simulation = sim.Simulation(scene)
        simulation.keys = (key,)
        simulation.step(200)
        (script,) = run_script([told | {"presses": {"factor": 1, "angle": 0, "steered": [way, 0]}}])
        assert np.abs(script["positions"].reshape(-1, 2) - simulation.positions).max() < CLOSE
        ways.append(simulation.positions[:, 0].mean())
    assert ways[0] > ways[1] + 5.0


@pytest.mark.parametrize(("name", "has"), [("buggy", True), ("hopper", True), ("worm", False)])
def test_only_files_of_bodies_with_motors_or_forces_of_keys_draw_them(name: str, has: bool) -> None:
    data = live_html(sim.Simulation(sim.load_scene(name)).capture())[0].decode()
    assert ("drivenArrows" in data) == has


@pytest.mark.parametrize("method", METHODS)
def test_held_keys_work_muscles_and_forces_as_in_the_solver(method: str) -> None:
    scene = by(sim.load_scene("hopper"), method)
    data = live_html(sim.Simulation(scene).capture())[0].decode()
    says = dict(re.findall('data-softrod-key="(.*?)" aria-label="(.*?)"', data))
    assert says["up"] == "Up: work the muscles"
    assert says["right"] == "Right: push masses"
    about = about_of(data.encode())
    assert about["dt"] == scene.integrator.dt
    told = {"data": about["body"], "method": METHODS[method], "h": about["dt"], "count": 60}
    for keys, ways in ((("up", "right"), [1, 1]), (("down", "left"), [-1, -1])):
        simulation = sim.Simulation(scene)
        simulation.keys = keys
        simulation.step(60)
        (script,) = run_script([told | {"presses": {"factor": 1, "angle": 0, "steered": ways}}])
        assert np.abs(script["positions"].reshape(-1, 2) - simulation.positions).max() < CLOSE
        # From there on, with nobody at the keys.
        (rest,) = run_script([told | {"data": body_data(simulation.capture())}])
        simulation.keys = ()
        simulation.step(60)
        assert np.abs(rest["positions"].reshape(-1, 2) - simulation.positions).max() < CLOSE


def test_what_is_measured_has_the_names_and_values_of_the_solver() -> None:
    for name in ("tutorial-3.3", "girder", "lesson-laws"):
        scene = by(sim.load_scene(name), "symplectic_euler")
        last = {"joint": len(scene.angular_springs) - 1, "spring": len(scene.linear_springs) - 1}
        last["mass"] = len(scene.masses) - 1
        names = [f"{of}{last.get(of, '')}.{what}" for of, what in sorted(MEASURED) if last.get(of, 0) >= 0]
        told = {"data": body_data(sim.Simulation(scene).capture()), "method": "symplectic_euler"}
        told |= {"h": scene.integrator.dt, "count": 50, "measures": names}
        measured = run_script([told])[0]["measured"]
        simulation = moved(scene, 50)
        for one, value in zip(names, measured, strict=True):
            right = sim.quantity(one, scene).read(simulation)
            assert value == pytest.approx(right, rel=1e-6, abs=1e-6 * (1.0 + abs(right))), (name, one)


def test_what_belongs_to_several_masses_and_formulas_have_the_values_of_the_solver() -> None:
    names = [f"body{which}.{what}" for which in ("", "[2,4..6]") for what in OF_MASSES["body"]]
    names += [f"mass3.{what}" for what in OF_MASSES["mass"]]
    names += [
        "mass1.y - mass0.y", "sqrt(mass3.vx^2 + mass3.vy^2)", "energy.kinetic / (2 * body[1..3].mass)",
        "-abs(joint0.angle) + 30 [°]", "atan2(mass3.vy, mass3.vx)",
        "sin(joint0.angle)", "1 / (mass1.x - mass1.x)",
    ]  # fmt: skip
    rope = replace(sim.load_scene("tutorial-3.3"), name="measured")
    steps = tuple(Step(title=".", do=".", plots=(*names[i : i + 2],)) for i in range(0, len(names), 2))
    scene = by(replace(rope, lesson=Lesson(steps=steps)), EULER)
    data = live_html(sim.Simulation(scene).capture())[0]
    about = about_of(data)
    assert b"addDerived" in data
    assert sum(len(step["plots"]) for step in about["lesson"]["steps"]) == len(names)
    told = {"data": about["body"], "method": EULER, "h": scene.integrator.dt, "count": 50}
    told |= {"measures": names, "derived": about["lesson"]["derived"]}
    measured = run_script([told])[0]["measured"]
    simulation = moved(scene, 50)
    right = [sim.quantity(one, scene).read(simulation) for one in names]
    assert measured.astype(float) == pytest.approx(np.array(right), rel=1e-9, abs=1e-6, nan_ok=True)


def test_sliders_set_what_they_set_in_the_page() -> None:
    changes = {
        "flag-pole": {"wind_speed": 900.0, "wind_direction": 35.0, "turbulence": 0.3, "gravity": 100.0},
        "jelly": {"wall_friction": 1.5, "linear_stiffness": 9000.0, "linear_damping": 3.0},
        "pile": {"contact_stiffness": 400.0, "contact_friction": 1.2, "air_friction": 0.002},
        "tutorial-3.3": {
            "rest_angle": 25.0, "rest_length_scale": 1.3, "angular_stiffness": 700.0, "angular_damping": 12.0,
        },
        "tutorial-3.2": {"template": 90.0},
        "rope": {"tempo": 3.3, "rest_angle": 12.0, "rest_length_scale": 0.9},
        "treadmill": {"belt_speed": -90.0},
        "crane": {"motor_torque": 2e6, "motor_speed": -50.0},
        "stick-slip": {"static_friction": 0.7, "belt_speed": 25.0, "wall_friction": 0.2},
        "rod": {
            "drag_across": 0.3, "drag_along": 0.1,
            "ground_forward": 0.1, "ground_backward": 1.0, "ground_sideways": 0.6,
        },
    }  # fmt: skip
    assert {key for values in changes.values() for key in values} == KEYS - {"dt", "force_law"}
    for name, values in changes.items():
        scene = sim.load_scene(name)
        if "drag_across" in values:
            scene = replace(scene, medium=sim.Medium(), ground=sim.Ground())
        if name == "stick-slip":
            scene = block_on_a_belt()
        scene = by(scene, "symplectic_euler")
        if "tempo" in values:
            scene = with_muscles(scene, np.random.default_rng(1))
        about = about_of(live_html(sim.Simulation(scene).capture())[0])
        settings = {setting["key"]: setting for setting in about["settings"]}
        other = scene
        for key, value in values.items():
            other = set_value(other, key, value)
        told = {"data": about["body"], "method": "symplectic_euler", "h": scene.integrator.dt, "count": 100}
        told["set"] = [[settings[key], value] for key, value in values.items()]
        off = np.abs(run_script([told])[0]["positions"].reshape(-1, 2) - moved(other, 100).positions).max()
        assert off < 1e-6, (name, off)


# ------------------------------------------------------------------------- the file
def test_the_files_of_all_presets_are_small_and_say_what_they_cannot_do() -> None:
    for name in PRESETS:
        scene = sim.load_scene(name)
        data, notes = live_html(sim.Simulation(scene).capture())
        assert len(data) < 250_000, name
        text = html.unescape(data.decode())
        for note in notes:
            assert note in text
        if scene.integrator.method == "symplectic_euler":
            assert about_of(data)["dt"] == scene.integrator.dt


def test_the_command_writes_a_file_and_says_what_it_cannot_do(tmp_path: Path, softrod: Softrod) -> None:
    made = softrod("export", "cloth", "--live", tmp_path / "cloth.html")
    assert made.returncode == 0
    assert "velocity Verlet" in made.stderr
    assert about_of((tmp_path / "cloth.html").read_bytes())["method"] == "verlet"


def test_the_command_writes_a_file_in_a_language_that_is_known(tmp_path: Path, softrod: Softrod) -> None:
    file = tmp_path / "rope.html"
    assert softrod("export", "rope", "--live", file, "--lang", "de").returncode == 0
    assert "Weitere Regler" in file.read_text(encoding="utf-8")
    refused(softrod("export", "rope", "--live", file, "--lang", "xx"), "softrod speaks en (English)")
