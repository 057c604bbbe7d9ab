"""What is drawn, without a browser: positions, turns, colours."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
import pytest
import trimesh

import sim
from app.stage import looks
from app.stage.colors import LIGHT_GAIN, rgb, sent
from app.stage.plan import Picture
from app.stage.shapes import COILS, meshes
from app.stage.sketch import FULL_STRAIN, SIMPLIFY_ABOVE_MASSES, Mapping
from sim.forces.one_sided import SIDES
from tests.app.page_script import after, all_drawn, drawn, sketch_of

PRESETS = [info.name for info in sim.list_scenes() if info.built_in]


def ends(node: dict[str, np.ndarray]) -> np.ndarray:
    """Where the far ends of instances along x are."""
    angle = 2.0 * np.arctan2(node["wxyzs"][:, 3], node["wxyzs"][:, 0])
    return node["positions"][:, :2] + node["scales"][:, :1] * np.column_stack((np.cos(angle), np.sin(angle)))


@pytest.mark.parametrize("y_down", [True, False])
def test_the_mapping_goes_there_and_back(y_down: bool) -> None:
    scene = sim.rope(view=sim.View(frame=(-10.0, 5.0, 50.0, 45.0), y_down=y_down))
    mapping = Mapping.of(scene)
    points = np.array([[3.0, 7.0], [20.0, 25.0]])
    world = mapping.to_world(points)
    assert world[1, :2] == pytest.approx((0.0, 0.0))
    for point, (x, y, _) in zip(points, world, strict=True):
        assert mapping.to_scene(x, y) == pytest.approx(tuple(point))
    assert (world[0, 1] > world[1, 1]) == y_down


def test_springs_and_ghost_are_drawn_from_mass_to_mass() -> None:
    pictures = []
    for name in PRESETS:
        scene = sim.load_scene(name)
        picture = after(scene, 50)[1]
        pictures.append((scene, replace(picture, ghost=picture.positions + np.array((7.0, -3.0)))))
    for (scene, picture), nodes in zip(pictures, all_drawn(pictures), strict=True):
        a = np.array([spring.a for spring in scene.linear_springs], int)
        b = np.array([spring.b for spring in scene.linear_springs], int)
        shown = np.array([spring.only != "pull" for spring in scene.linear_springs], bool)
        mapping = sketch_of(scene).mapping
        for node, positions in (("springs", picture.positions), ("ghost", picture.ghost)):
            world = mapping.to_world(positions)[:, :2]
            assert nodes[node]["positions"][shown, :2] == pytest.approx(world[a[shown]], abs=1e-5), scene.name
            assert ends(nodes[node])[shown] == pytest.approx(world[b[shown]], abs=1e-5), scene.name


def test_wedges_reach_from_rest_angle_to_present_angle() -> None:
    """The last slice's far edge lies along spring b as it leaves the shared mass."""
    bodies = [after(sim.load_scene(name), 200) for name in PRESETS]
    pictures = [(simulation.scene, picture) for simulation, picture in bodies]
    for (simulation, picture), nodes in zip(bodies, all_drawn(pictures), strict=True):
        scene, sketch = simulation.scene, sketch_of(simulation.scene)
        off = 180.0 - (180.0 - (simulation.angles - simulation.rest_angles)) % 360.0
        sides = [SIDES[joint.only] if joint.only else 0.0 for joint in scene.angular_springs]
        off[sides * off < 0.0] = 0.0
        assert nodes["deviations"] == pytest.approx(off, abs=1e-3), scene.name
        turns = nodes["wedges"]["wxyzs"]
        middle = 2.0 * np.degrees(np.arctan2(turns[:, 3], turns[:, 0])).reshape(-1, sketch.slices)
        world = sketch.mapping.to_world(picture.positions)
        for j, joint in enumerate(scene.angular_springs):
            a, b = scene.linear_springs[joint.a], scene.linear_springs[joint.b]
            (shared,) = {a.a, a.b} & {b.a, b.b}
            far = b.b if b.a == shared else b.a
            along = world[far] - world[shared]
            turn = nodes["deviations"][j] * sketch.mapping.flip
            wanted = np.degrees(np.arctan2(along[1], along[0])) - turn / (2 * sketch.slices)
            off_by = (middle[j, -1] - wanted + 180.0) % 360.0 - 180.0
            assert off_by == pytest.approx(0.0, abs=1e-3), (scene.name, j)


def test_held_keys_turn_the_rest_angles_of_the_wedges() -> None:
    scene = sim.load_scene("tutorial-3.3")
    simulation = sim.Simulation(scene)
    simulation.keys = frozenset({"right"})
    simulation.step(200)
    assert abs(simulation.rest_angle_shift) > 1.0
    off = simulation.angles - simulation.rest_angles
    assert drawn(scene, Picture.of(simulation))["deviations"] == pytest.approx(off, abs=1e-3)


def test_a_pulled_spring_is_red_and_a_pushed_one_blue() -> None:
    scene = sim.rope(masses=3, length=200.0, joints=False)
    colors = sketch_of(scene).palette
    picture = Picture(np.array([[0.0, 0.0], [0.0, 150.0], [0.0, 200.0]]))
    springs = drawn(scene, picture)["springs"]["colors"]
    assert (springs[0] == sent(colors.pulled)).all()
    assert (springs[1] == sent(colors.pushed)).all()
    springs = drawn(scene, replace(picture, rest_length_scale=1.5))["springs"]["colors"]
    assert (springs[0] == sent(colors.rest)).all()


def test_a_wedge_has_the_colour_of_its_sense_and_pales_at_rest() -> None:
    scene = sim.rope(masses=3, length=200.0)
    colors = sketch_of(scene).palette
    for x, full in ((-100.0, colors.torque_plus), (100.0, colors.torque_minus)):
        bent = np.array([[0.0, 0.0], [0.0, 100.0], [x, 100.0]])
        nodes = drawn(scene, Picture(bent))
        assert abs(nodes["deviations"][0]) == pytest.approx(90.0)
        full = colors.torque_plus if nodes["deviations"][0] > 0.0 else colors.torque_minus
        assert (nodes["wedges"]["colors"] == sent(full)).all()
    straight = drawn(scene, Picture(np.array([[0.0, 0.0], [0.0, 100.0], [0.0, 200.0]])))
    assert (straight["wedges"]["colors"] > sent(colors.torque_plus).min()).all()


def test_discs_pins_and_ring_are_at_their_masses() -> None:
    scene = sim.load_scene("tutorial-3.2")
    picture, sketch = Picture.at_start(scene), sketch_of(scene)
    nodes, n = drawn(scene, picture), len(scene.masses)
    world = sketch.mapping.to_world(picture.positions)[:, :2]
    discs = nodes["masses"]
    for k, size in enumerate((1.0, 0.8)):
        assert discs["positions"][k * n : (k + 1) * n, :2] == pytest.approx(world, abs=1e-5)
        assert discs["scales"][k * n : (k + 1) * n, 0] == pytest.approx(size * sketch.radius, rel=1e-5)
    assert (discs["colors"] == sketch.mass_colors()).all()
    assert nodes["pins"]["positions"][:, :2] == pytest.approx(world[sketch.pinned], abs=1e-5)
    assert nodes["ring"]["positions"][:, :2] == pytest.approx(world[sketch.held[:1]], abs=1e-5)
    held, driven, *_ = sketch.ink_colors()
    assert (nodes["pins"]["colors"] == held).all()
    assert (nodes["ring"]["colors"] == driven).all()


def test_many_masses_are_drawn_with_less() -> None:
    few, many = (
        sketch_of(sim.rope(masses=SIMPLIFY_ABOVE_MASSES)),
        sketch_of(sim.rope(masses=SIMPLIFY_ABOVE_MASSES + 1)),
    )
    assert few.slices > many.slices == 1
    assert (few.many, many.many) == (False, True)


@pytest.mark.parametrize("name", [name for name in PRESETS if name != "empty"])
def test_nets_are_drawn_with_bars_and_chains_trees_and_rings_with_coils(name: str) -> None:
    nets = (
        "girder",
        "bridge",
        "buggy",
        "cloth",
        "jelly",
        "flag-pole",
        "hopper",
        "study-cloth",
        "treadmill",
        "walker",
        "lesson-bridge-modes",
    )
    net = name in nets
    sketch = sketch_of(sim.load_scene(name))
    assert sketch.bars == (net or sketch.many)
    assert (sketch.spring_shape == "bar") == sketch.bars
    assert (sketch.spring_shape in COILS) != sketch.bars


def test_a_bar_has_the_same_width_however_long_it_is() -> None:
    scene = sim.load_scene("girder")
    picture = Picture.at_start(scene)
    near, far = (drawn(scene, replace(picture, positions=k * picture.positions)) for k in (1.0, 2.0))
    assert far["springs"]["scales"][:, 1] == pytest.approx(near["springs"]["scales"][:, 1])
    assert far["springs"]["scales"][:, 0] == pytest.approx(2.0 * near["springs"]["scales"][:, 0], rel=1e-5)


def test_a_spring_has_its_full_colour_where_it_yields_or_breaks() -> None:
    spring = sim.LinearSpring(a=0, b=1, stiffness=1000.0, damping=0.0, rest_length=100.0)
    kinds = ({}, {"strength": 2000.0}, {"strength": 2000.0, "yield_force": 1000.0}, {"strength": 1e9})
    springs = tuple(msgspec.structs.replace(spring, b=i, **kind) for i, kind in enumerate(kinds, 1))
    around = ((100.0, 0.0), (0.0, 102.0), (-101.0, 0.0), (0.0, -110.0))
    masses = tuple(sim.Mass(position=place) for place in ((0.0, 0.0), *around))
    scene = sim.Scene(name="star", masses=masses, linear_springs=springs)
    assert sketch_of(scene).full_strain == pytest.approx([FULL_STRAIN, 0.02, 0.01, FULL_STRAIN])
    colors = drawn(scene, Picture.at_start(scene))["springs"]["colors"]
    full = sent(sketch_of(scene).palette.pulled)
    assert (colors == full).all(1).tolist() == [False, True, True, True]
    assert sketch_of(sim.rope()).full_strain.tolist() == [FULL_STRAIN]


def test_only_held_masses_have_pins_and_only_the_driven_one_has_none() -> None:
    scene = sim.load_scene("tutorial-3.2")
    assert sketch_of(scene).pinned.tolist() == [1]
    assert sketch_of(sim.load_scene("tutorial-3.1")).pinned.tolist() == [1, 2]


@pytest.mark.parametrize("name", ["disc", "ring", "bar", "slice", "pin", *COILS])
def test_every_face_looks_at_the_viewer(name: str) -> None:
    # By trimesh, which has no part in making them.
    mesh = trimesh.Trimesh(*meshes()[name][:2], process=False)
    assert len(mesh.faces) > 0
    assert (mesh.face_normals[:, 2] > 0.0).all()


def test_a_disc_and_a_ring_have_the_areas_of_their_polygons() -> None:
    def polygon(corners: int, radius: float) -> float:
        return 0.5 * corners * radius**2 * np.sin(2.0 * np.pi / corners)

    disc, ring = (trimesh.Trimesh(*meshes()[name][:2], process=False) for name in ("disc", "ring"))
    assert disc.area == pytest.approx(polygon(36, 1.0))
    assert ring.area == pytest.approx(polygon(48, 1.0) - polygon(48, 0.82))


def test_the_tone_map_is_inverted() -> None:
    """three.js's ACES filmic tone map of what is sent gives back the colour that was wanted."""
    into = np.array([[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]])
    out = np.array(
        [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]]
    )
    # Not the most saturated colours, nor pure white: those lie beyond what the tone map can reach.
    for color in ("475569", "8592a6", "1971c2", "8e44ad", "dde3ea"):
        light = sent(rgb(color)) / 255.0 * LIGHT_GAIN / 0.6 @ into.T
        fitted = (light * (light + 0.0245786) - 0.000090537) / (
            light * (0.983729 * light + 0.432951) + 0.238081
        )
        linear = np.clip(fitted @ out.T, 0.0, 1.0)
        shown = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055) * 255.0
        assert shown == pytest.approx(rgb(color), abs=9.0)


# ------------------------------------------------------------------------- looks
def test_the_scripts_have_the_looks_of_python() -> None:
    written = Path(looks.__file__).with_name("looks.js").read_text(encoding="utf-8")
    assert written == looks.script(), "run: python -m app.stage.looks"


def test_looks_stand_in_one_file_only() -> None:
    """No style, script or module has a colour of the body or its paper of its own."""
    root = Path(looks.__file__).parents[1]
    own = {"ffffff", "141414"}  # also of other things: white, nearly black
    colors = {color for pair in looks.COLORS.values() for color in pair} - own
    for kind in ("py", "js", "css"):
        for path in root.rglob(f"*.{kind}"):
            found = set(re.findall(r"\b[0-9a-f]{6}\b", path.read_text(encoding="utf-8")))
            assert path.name == "looks.py" or not found & colors, path
