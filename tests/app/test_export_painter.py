"""Pictures made without a page: the same parts in the same places as in the page, and in its colours."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from msgspec import UNSET
from msgspec.structs import replace as changed
from PIL import Image

import sim
from app.export import around, instances
from app.export.painter import Painter, paint
from app.export.window import Window
from app.stage.colors import palette, plain, rgb
from app.stage.plan import Picture, encode_plan
from app.stage.shapes import COILS, meshes
from app.stage.sketch import Floats, Sketch
from sim.scene.types import Damage
from tests.app.page_script import after, drawn
from tests.sim.changes import with_joints, with_springs


def pixel(image: Image.Image, window: Window, sketch: Sketch, place: Floats) -> np.ndarray:
    """(3,) the colour at a place of the scene, px."""
    x, y = window.pixels(sketch.mapping.to_world(np.array([place]))[:, :2])[0]
    return np.asarray(image)[round(float(y) - 0.5), round(float(x) - 0.5)].astype(int)


@pytest.mark.parametrize("name", ["tutorial-3.3", "box", "flag-pole", "water-balloon", "box of ropes"])
def test_parts_lie_where_the_page_draws_them(name: str) -> None:
    scene = sim.load_scene(name.removesuffix(" of ropes"))
    if name.endswith(" of ropes"):
        sides = ("pull", "push", UNSET, "pull")
        scene = with_springs(
            scene,
            only=lambda i, _: sides[i % 4],
            rest_length=lambda i, spring: spring.rest_length * (1.3 if i % 2 else 0.9),
        )
        stops = ("above", "below", UNSET)
        scene = with_joints(scene, only=lambda i, _: stops[i % 3])
    _, picture = after(scene, 120)
    count = len(scene.linear_springs)
    damage = Damage(broken=(1,), set_lengths=tuple(np.linspace(-2.0, 2.0, count)))
    ghost = picture.positions + np.array((7.0, -3.0))
    picture = replace(picture, damage=damage, ghost=ghost, ghost_broken=(0,), rest_angle_shift=5.0)
    nodes = drawn(scene, picture)
    sketch = Sketch(scene, palette(scene.view.colors, dark=False))
    loose = [a == 0.0 for a in nodes["deviations"][sketch.stops[:, 0]]]
    assert len(set(loose)) == (2 if name.endswith(" of ropes") else 0)
    rest = np.array([joint.rest_angle for joint in scene.angular_springs])
    found = {
        "springs": instances.springs(sketch, picture),
        "ropes": instances.ropes(sketch, picture),
        "yielded": instances.yielded(sketch, picture),
        "wedges": instances.wedges(sketch, picture, rest),
        "masses": instances.masses(sketch, picture),
        "pins": instances.pins(sketch, picture),
        "ring": instances.ring(sketch, picture),
        "ghost": instances.ghost(sketch, picture),
    }
    assert instances.deviations(sketch, picture, rest) == pytest.approx(nodes["deviations"], abs=1e-3)
    for kind, parts in found.items():
        node = nodes[kind]
        if node is None:
            assert not len(parts.angles), kind
            continue
        parts = parts.seen()
        # The page keeps a place for what is broken, too small to be seen.
        there = node["scales"][:, 0] > 2e-6
        assert len(parts.angles) == there.sum(), kind
        if kind in ("springs", "yielded", "ghost"):
            assert not there.all()
            assert there.any()
        turns = 2.0 * np.arctan2(node["wxyzs"][there, 3], node["wxyzs"][there, 0])
        off = (parts.angles - turns + np.pi) % (2.0 * np.pi) - np.pi
        big = parts.lengths > 1e-3
        assert parts.places == pytest.approx(node["positions"][there, :2], abs=1e-5), kind
        assert off[big] == pytest.approx(0.0, abs=1e-4), kind
        assert parts.lengths == pytest.approx(node["scales"][there, 0], abs=1e-5), kind
        assert parts.widths == pytest.approx(node["scales"][there, 1], abs=1e-5), kind
        # Single precision can fall on the other side of the edge between two shades.
        assert np.abs(parts.colors.astype(int) - node["colors"][there]).max(initial=0) <= 16, kind


@pytest.mark.parametrize("part", [0.2, 0.7, 0.95, 1.0, 1.2])
def test_a_rope_is_as_long_as_it_rests_or_straight(part: float) -> None:
    masses = (sim.Mass(position=(100.0, 100.0)), sim.Mass(position=(100.0 + 200.0 * part, 100.0)))
    rope = sim.LinearSpring(a=0, b=1, stiffness=1.0, rest_length=200.0, only="pull")
    sketch = Sketch.plain(sim.Scene(name="rope", masses=masses, linear_springs=(rope,)))
    places = np.array([mass.position for mass in masses])
    pieces = instances.ropes(sketch, Picture(places))
    scale = sketch.mapping.scale
    assert pieces.lengths.sum() / scale == pytest.approx(200.0 * max(part, 1.0), rel=0.04)
    ends = (
        pieces.places
        + np.column_stack((np.cos(pieces.angles), np.sin(pieces.angles))) * pieces.lengths[:, None]
    )
    assert ends[:-1] == pytest.approx(pieces.places[1:], abs=1e-9)
    assert ends[-1] == pytest.approx(sketch.mapping.to_world(places)[1, :2])
    lowest = pieces.places[:, 1].min() - pieces.places[0, 1]
    assert (lowest < -0.1 * scale) == (part < 1.0)


@pytest.mark.parametrize("name", ["disc", "ring", "bar", "slice", "pin", *COILS])
def test_an_outline_goes_around_its_mesh(name: str) -> None:
    lines = meshes()[name].outlines
    assert len(lines) == {"ring": 2, "pin": 2}.get(name, 1)
    areas = [
        0.5 * float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) for x, y in (line.T for line in lines)
    ]
    if name == "disc":
        assert sum(areas) == pytest.approx(np.pi, rel=0.01)
    if name == "ring":
        assert sum(areas) == pytest.approx(np.pi * (1.0 - 0.82**2), rel=0.01)


@pytest.mark.parametrize("dark", [False, True])
def test_a_picture_has_the_colours_of_its_parts(dark: bool) -> None:
    scene = sim.load_scene("water-balloon")
    scene = changed(scene, walls=scene.walls[:1])
    _, picture = after(scene, 200)
    painter = Painter(scene, (640, 480), dark)
    image, sketch = painter.paint(picture), painter.sketch
    colors, free = palette(scene.view.colors, dark), ~np.isin(np.arange(len(scene.masses)), sketch.held)
    for place in picture.positions[free]:
        assert pixel(image, painter.window, sketch, place) == pytest.approx(colors.mass, abs=2)
    paper = palette("softrod", dark).paper
    # The liquid, between the lines of the grid under it.
    around_middle = picture.positions.mean(0) + np.mgrid[-9:10:3, -9:10:3].reshape(2, -1).T
    inside = np.median([pixel(image, painter.window, sketch, place) for place in around_middle], axis=0)
    assert inside == pytest.approx(paper + 0.35 * (rgb("1c8fe0") - paper), abs=3)
    corner = np.asarray(image)[3, 3]
    assert min(np.abs(corner - color).max() for color in (paper, colors.grid, colors.line)) <= 2
    # The floor.
    floor = np.asarray(image)[-4, 5:60].reshape(-1, 3).astype(float)
    wanted = paper + 0.1 * (palette("softrod", dark).text - paper)
    assert np.median(floor, axis=0) == pytest.approx(wanted, abs=3)


@pytest.mark.parametrize("dark", [False, True])
def test_a_picture_has_the_colours_of_a_medium_and_of_the_ground(dark: bool) -> None:
    own = palette("softrod", dark)
    for around_it, color, opacity in (
        ({"medium": sim.Medium()}, own.liquid, 0.1),
        ({"ground": sim.Ground()}, own.text, 0.07),
    ):
        image = paint(changed(sim.rope(4), **around_it), size=(320, 180), dark=dark, grid=False)
        wanted = own.paper + opacity * (color - own.paper)
        assert np.median(np.asarray(image).reshape(-1, 3), axis=0) == pytest.approx(wanted, abs=2)


@pytest.mark.parametrize(
    ("y_down", "walls"), [(True, ()), (False, (sim.Wall(point=(0.0, 9e3), normal=(0, 1)),))]
)
def test_constant_forces_are_arrows_in_pictures_and_in_the_plan(
    y_down: bool, walls: tuple[sim.Wall, ...]
) -> None:
    """Only where there are any; the largest has the longest arrow, and none is too short to be seen."""
    forces = ((0.0, 4000.0), UNSET, (-1.0, 0.0))
    masses = tuple(sim.Mass(position=(150.0 * i, 300.0), force=force) for i, force in enumerate(forces, 1))
    scene = sim.Scene(name="loads", masses=masses, walls=walls, view=sim.View(y_down=y_down))
    painter = Painter(scene, (600, 600), grid=False)
    sketch, window = painter.sketch, painter.window
    image = painter.paint(Picture.at_start(scene))
    force = rgb("c2185b")
    shown = (150.0, 325.0), (150.0, 356.0), (434.0, 300.0)
    empty = (150.0, 365.0), (150.0, 275.0), (300.0, 330.0), (420.0, 300.0)
    for place in (*shown, *empty):
        apart = np.abs(pixel(image, window, sketch, np.array(place)) - force).max()
        assert bool(apart < 120) is (place in shown), place
    plan, sections = encode_plan(1, sketch, np.zeros(0)), []
    while len(plan):
        sections.append(plan[1 : 1 + int(plan[0])])
        plan = plan[1 + int(plan[0]) :]
    assert len(sections) == 23
    down = -0.6 if y_down else 0.6
    assert sections[-1] == pytest.approx([0.0, 0.0, down, 2.0, -0.18, 0.0], abs=1e-6)


def test_pictures_are_the_same_every_time_and_of_any_size() -> None:
    scene = sim.load_scene("flag-pole")
    one, other = (paint(scene, size=(320, 180)).tobytes() for _ in range(2))
    assert one == other
    assert paint(scene, size=(160, 500)).size == (160, 500)
    for size in ((8, 100), (100, 5000)):
        with pytest.raises(ValueError, match="16 to 4096"):
            paint(scene, size=size)
    with pytest.raises(ValueError, match="finite"):
        paint(scene, np.full((len(scene.masses), 2), np.nan))
    far = np.array([mass.position for mass in scene.masses]) + 1e30
    assert paint(scene, far, size=(160, 90)).size == (160, 90)


def test_a_motor_has_an_arc_that_points_where_it_turns() -> None:
    """The jib of the crane goes up while Up is held: anticlockwise on the screen."""
    scene = sim.load_scene("crane")
    painter = Painter(scene, (400, 400), grid=False)
    start = Picture.at_start(scene)
    hub = painter.window.pixels(painter.sketch.mapping.to_world(start.positions)[:, :2])[1]

    def swept(picture: Picture) -> tuple[float, int]:
        works, rests = around.driven_arrows(painter.sketch, picture, painter.window)
        angles = np.unwrap(np.angle(((works or rests)[0] - hub) @ (1.0, 1.0j)))
        return float(angles[-1] - angles[0]), len(works)

    assert swept(start) == (pytest.approx(-math.tau + 1.3), 0)
    assert swept(replace(start, efforts=(0.0, 1.0))) == (pytest.approx(-math.tau + 1.3), 2)
    assert swept(replace(start, efforts=(1.0, -1.0))) == (pytest.approx(math.tau - 1.3), 2)
    images = [np.asarray(painter.paint(one)) for one in (start, replace(start, efforts=(0.0, 1.0)))]
    assert (images[0] != images[1]).any()


def test_a_broken_spring_is_absent_and_a_ghost_is_drawn() -> None:
    scene = sim.rope(masses=3, length=200.0)
    painter = Painter(scene, (400, 400), grid=False)
    whole = Picture.at_start(scene)
    middle = whole.positions[:2].mean(0)

    def inked(picture: Picture, place: Floats) -> bool:
        x, y = painter.window.pixels(painter.sketch.mapping.to_world(place[None])[:, :2])[0]
        patch = np.asarray(painter.paint(picture))[int(y) - 6 : int(y) + 6, int(x) - 6 : int(x) + 6]
        return bool((patch < 250).any())

    assert inked(whole, middle)
    assert not inked(replace(whole, damage=Damage(broken=(0,))), middle)
    aside = np.array((60.0, 0.0))
    assert not inked(whole, middle + aside)
    assert inked(replace(whole, ghost=whole.positions + aside), middle + aside)


def test_a_filling_that_has_got_out_is_not_drawn() -> None:
    scene = sim.load_scene("water-balloon")
    painter = Painter(scene, (400, 400), grid=False)
    whole = Picture.at_start(scene)
    middle = whole.positions[list(scene.fillings[0].masses)].mean(0)
    colors = [
        pixel(painter.paint(replace(whole, damage=damage)), painter.window, painter.sketch, middle).tolist()
        for damage in (None, Damage(broken=(3,)))
    ]
    assert colors[0] != colors[1] == [255, 255, 255]


def test_the_window_shows_the_frame_near_walls_and_a_body_that_leaves_a_little() -> None:
    scene = sim.load_scene("water-balloon")
    sketch = Sketch(scene, palette("softrod", dark=False), plain)
    frame = scene.view.frame
    window = Window.fit(sketch, frame, (600, 600))
    surface = [wall.surface for wall in around.walls(sketch, window) if len(wall.surface)]
    assert surface
    assert (surface[0][:, 1] < 600.0).all()
    size = max(frame[2] - frame[0], frame[3] - frame[1])
    aside = np.array([[frame[2] + 0.3 * size, frame[1]]])
    near = Window.fit(sketch, frame, (600, 600), aside)
    assert (near.pixels(sketch.mapping.to_world(aside)[:, :2]) > 0.0).all()
    assert (near.pixels(sketch.mapping.to_world(aside)[:, :2]) < 600.0).all()
    far = Window.fit(sketch, frame, (600, 600), aside + 1e9)
    assert far.step > 0.4 * window.step
