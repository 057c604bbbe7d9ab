"""Recipes: what they make, that it is at rest as it is made, and that it sags as the formulas say."""

from __future__ import annotations

import json
import math
import re
from collections import Counter
from pathlib import Path
from typing import Any, get_args, get_origin, get_type_hints

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim import LinearSpring, Scene, SceneError, Simulation, validate
from sim.scene.numbers import MAX_MASSES
from sim.scene.recipes.recipe import AnyRecipe
from sim.scene.recipes.sheets import Cloth
from sim.store.files import decode_scene, encode_scene
from tests.amount import examples
from tests.sim.changes import after
from tests.sim.checks import refusal
from tests.sim.inside import forces_of

RECIPES: tuple[type[AnyRecipe], ...] = get_args(AnyRecipe)
MAKERS = (
    sim.rope, sim.rod, sim.box, sim.polygon, sim.hair_tuft, sim.flag_pole, sim.tree, sim.air_balloon,
    sim.water_balloon, sim.cloth, sim.girder, sim.jelly, sim.bridge,
    sim.worm, sim.swimmer, sim.walker, sim.heart, sim.hand,
)  # fmt: skip
NAMES = [kind.__name__ for kind in RECIPES]


def scene_of(*bodies: AnyRecipe, **fields: Any) -> Scene:
    return Scene(name="bodies", bodies=bodies, **fields)


def refused(scene: Scene) -> str:
    return refusal(SceneError, validate, scene)


def numbers_of(kind: Any) -> st.SearchStrategy[Any] | None:
    """Numbers in the range of an annotation, usual ones and its ends; None if it is no number."""
    if get_origin(kind) is tuple:
        return None
    inner = next((option for option in get_args(kind) if get_args(option)), kind)
    meta = next((m for m in getattr(inner, "__metadata__", ()) if isinstance(m, msgspec.Meta)), None)
    if meta is None or meta.ge is None or meta.le is None:
        return None
    low, high = (meta.extra or {}).get("slider") or (meta.ge, min(meta.le, 1e4))
    if get_args(inner)[0] is int:
        return st.integers(int(meta.ge), int(min(high, meta.ge + 3)))
    return st.floats(low, high) | st.sampled_from([float(meta.ge), float(meta.le)])


@st.composite
def recipes(draw: st.DrawFn) -> AnyRecipe:
    """A recipe with some numbers that are in range, the others being its own."""
    kind = draw(st.sampled_from(RECIPES))
    hints = get_type_hints(kind, include_extras=True)
    strategies = {field: numbers_of(hints[field]) for field in kind.__struct_fields__}
    able = [field for field, strategy in strategies.items() if strategy is not None]
    chosen = draw(st.lists(st.sampled_from(able), unique=True, max_size=5))
    return kind(**{field: draw(strategies[field]) for field in chosen})  # type: ignore[arg-type]


# ------------------------------------------------------------------------- any numbers
def test_one_move_of_a_slider_makes_the_body_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[object] = []
    expand = Cloth.expand
    monkeypatch.setattr(Cloth, "expand", lambda cloth: (made.append(cloth), expand(cloth))[1])
    simulation = Simulation(sim.cloth())
    simulation.replace(sim.set_value(simulation.scene, "linear_stiffness", 777.0))
    assert len(made) == 2  # the cloth, and the cloth with another stiffness
    simulation.replace(sim.set_value(simulation.scene, "gravity", 7.0))
    assert len(made) == 2
    link = LinearSpring(a=0, b=1, stiffness=5.0, rest_length=9.0)
    linked = replace(simulation.scene, masses=(), linear_springs=(), links=(link,))
    assert len(made) == 3
    assert linked.linear_springs[-1] == link


@settings(max_examples=examples(100))
@given(st.lists(recipes(), min_size=1, max_size=2))
def test_recipes_in_range_make_a_valid_scene_or_one_sentence(bodies: list[AnyRecipe]) -> None:
    scene = scene_of(*bodies)
    assert scene.masses
    try:
        validate(scene)
    except SceneError as error:
        assert "\n" not in str(error)
        assert ": " in str(error)
        return
    data = encode_scene(scene)
    assert len(data) < 4000
    again = decode_scene(data, "scene")
    assert again == scene
    assert encode_scene(again) == data


@settings(max_examples=examples(60))
@given(st.sampled_from(RECIPES), st.data())
def test_numbers_out_of_range_are_named(kind: type[AnyRecipe], data: st.DataObject) -> None:
    hints = get_type_hints(kind, include_extras=True)
    able = [field for field in kind.__struct_fields__ if numbers_of(hints[field]) is not None]
    field = data.draw(st.sampled_from(able))
    wrong = data.draw(st.sampled_from([math.nan, -1e30, 1e30, "1", (2.0,)]))
    numbers: dict[str, Any] = {field: wrong}
    assert refused(scene_of(kind(**numbers))).startswith(f"bodies[0].{field}: ")


# ------------------------------------------------------------------------- what they make
COUNTS = [
    (sim.Rod(masses=7), (7, 6, 5, 2, 0)),
    (sim.Box(per_side=3), (12, 12, 12, 0, 0)),
    (sim.Polygon(sides=5, per_side=2, held=(0, 99)), (10, 10, 10, 1, 0)),
    (sim.HairTuft(hairs=3, masses=4), (14, 13, 12, 2, 0)),
    (sim.HairTuft(hairs=1, masses=2), (4, 3, 2, 2, 0)),
    (sim.FlagPole(masses=6, columns=3, rows=2), (12, 5 + 6 + 3 + 6, 4 + 4, 2, 0)),
    (sim.Tree(forks=3, branches=3, segments=2), (81, 80, 79, 2, 0)),  # 1 + 2 (1 + 3 + 9 + 27)
    (sim.Tree(forks=0, segments=1), (2, 1, 0, 2, 0)),
    (sim.AirBalloon(masses=9), (9, 9, 9, 0, 1)),
    (sim.WaterBalloon(masses=9), (9, 9, 9, 0, 1)),
    (sim.Cloth(columns=4, rows=3), (12, 9 + 8 + 12, 6 + 4, 2, 0)),
    (sim.Cloth(columns=4, rows=3, diagonals=False, held="edge"), (12, 17, 10 + 6, 4, 0)),
    (sim.Girder(panels=6), (13, 23, 0, 2, 0)),  # 2 n - 3 members: statically determinate but for supports
    (sim.Girder(panels=6, truss="pratt"), (12, 21, 0, 2, 0)),
    (sim.Girder(panels=2, truss="pratt"), (4, 5, 0, 2, 0)),
    (sim.Girder(panels=7, truss="pratt"), (14, 25, 0, 2, 0)),
    (sim.Jelly(columns=4, rows=3), (12, 9 + 8 + 12, 0, 0, 6)),
    (sim.Jelly(columns=2, rows=2, bulk_modulus=0.0), (4, 6, 0, 0, 0)),
    (sim.Bridge(panels=4), (10, 4 + 4 + 5, 3, 4, 0)),
    (sim.Worm(masses=6), (6, 5, 4, 0, 0)),
    (sim.Swimmer(masses=6), (6, 5, 4, 0, 0)),
    (sim.Walker(pairs=2), (4 + 3 + 4, 3 + 2 + 6 + 8, 0, 0, 0)),
    (sim.Heart(masses=12), (12, 12, 12, 0, 1)),
    (sim.Hand(links=3), (2 + 6 + 16, 1 + 6 + 16, 6 + 16, 2, 0)),
]


@pytest.mark.parametrize(("recipe", "counts"), COUNTS, ids=[type(r).__name__ for r, _ in COUNTS])
def test_there_are_as_many_parts_as_there_should_be(recipe: AnyRecipe, counts: tuple[int, ...]) -> None:
    scene = validate(scene_of(recipe))
    assert tuple(map(len, recipe.expand())) == counts
    assert len(scene.masses) == counts[0]


@pytest.mark.parametrize("make", MAKERS, ids=[make.__name__ for make in MAKERS])
def test_each_makes_a_scene_that_runs(make: Any) -> None:
    scene = make()
    assert scene.name == make.__name__
    assert validate(scene) is scene
    assert len(scene.masses) < 300
    simulation = Simulation(scene)
    assert simulation.step(100) == 100
    # Numbers of the recipe and of the scene, by their names.
    other = make(mass=2.5, gravity=(0.0, 1.0), name="other")
    assert (other.gravity, other.name, other.bodies[0].mass) == ((0.0, 1.0), "other", 2.5)


def test_makers_name_what_they_do_not_know() -> None:
    with pytest.raises(SceneError, match=r"^hairs: rod has no such number; there are .*length.*gravity"):
        sim.rod(hairs=3)
    with pytest.raises(SceneError, match=r"^bodies\[0\]\.masses: 1 is not in the range 3\.\.20000"):
        sim.rod(masses=1)
    with pytest.raises(SceneError, match=r"^rod: numbers have names, as in sim.rod\(masses=10\)"):
        sim.rod(10)
    with pytest.raises(SceneError, match=r"^rope: numbers have names, but the first 2 need none"):
        sim.rope(5, 100.0, 3.0)
    assert (len(sim.rope(5).masses), sim.rope(5, 80.0).linear_springs[0].rest_length) == (5, 20.0)


@pytest.mark.parametrize("kind", RECIPES, ids=NAMES)
def test_no_spring_pulls_in_the_shape_that_is_made(kind: type[AnyRecipe]) -> None:
    # The muscles begin there, too, but for pulses, which are never quite over.
    scene = scene_of(kind(), beat=msgspec.UNSET if kind is sim.Heart else sim.Beat())
    stiffest = max(spring.stiffness for spring in scene.linear_springs)
    exact = sim.Integrator(method="symplectic_euler")  # whose forces are the law's to the last digit
    assert np.abs(forces_of(replace(scene, integrator=exact))).max() < 1e-10 * stiffest


@pytest.mark.parametrize("kind", [k for k in RECIPES if "bend" in k.__struct_fields__])
def test_a_bend_shifts_every_rest_angle(kind: type[AnyRecipe]) -> None:
    straight, bent = scene_of(kind()), validate(scene_of(replace(kind(), bend=100.0)))
    for old, new in zip(straight.angular_springs, bent.angular_springs, strict=True):
        assert math.cos(math.radians(new.rest_angle - old.rest_angle - 100.0)) == pytest.approx(1.0)
        assert -180.0 < new.rest_angle <= 180.0


def test_polygons_are_regular_and_boxes_turn() -> None:
    polygon = sim.Polygon(sides=5, per_side=2, circumradius=50.0, center=(10.0, 20.0)).expand()
    assert polygon.masses[0].position == pytest.approx((10.0, -30.0))
    assert polygon.linear_springs[3].rest_length == pytest.approx(50.0 * math.sin(math.pi / 5))
    assert Counter(joint.rest_angle for joint in polygon.angular_springs) == {0.0: 5, 72.0: 5}
    box = sim.Box(width=20.0, height=10.0, per_side=1, center=(0.0, 0.0), turn=90.0).expand()
    assert [m.position for m in box.masses] == [
        pytest.approx(p) for p in ((5.0, -10.0), (5.0, 10.0), (-5.0, 10.0), (-5.0, -10.0))
    ]


@pytest.mark.parametrize(("name", "speed"), [("air-balloon", 40.0), ("water-balloon", 10.0)])
def test_balloons_that_were_dropped_come_to_rest(name: str, speed: float) -> None:
    """Root of the mean square speed from 10 to 14 s, px/s: 120 and 53 without damping of the joints."""
    simulation = after(sim.load_scene(name), 10.0)
    squares = []
    for _ in range(100):
        simulation.advance(0.04)
        squares.append((simulation.velocities**2).sum(1).mean())
    assert np.sqrt(np.mean(squares)) < speed


def test_what_python_adds_to_recipes_is_documented() -> None:
    text = (Path(sim.__file__).parents[1] / "docs" / "scene-files.md").read_text(encoding="utf-8")
    air = r"([\d.]+)(?:, by the law `(\w+)`)?"
    row = rf"^\| ((?:`sim\.\w+`(?:, )?)+) \| (\[[\d, ]+\]) \| {air} \| ([\w ,]*)\|$"
    rows = re.findall(row, text, re.MULTILINE)
    told = {name: row for names, *row in rows for name in re.findall(r"sim\.(\w+)", names)}
    assert len(told) == len(MAKERS)
    for make in MAKERS:
        scene = make()
        gravity, air, law, also = told[make.__name__]
        assert json.loads(gravity) == list(scene.gravity)
        assert (float(air), law or "isotropic") == (scene.air_friction, scene.air_law)
        wanted = {"arrow keys": scene.arrow_keys, "wind": scene.wind, "a floor": scene.walls}
        wanted |= {"a beat": scene.beat, "contact": scene.contact, "a medium": scene.medium}
        assert ", ".join(what for what, there in wanted.items() if there) == also.strip()


def test_balloons_are_filled_to_the_number_given() -> None:
    area = 0.5 * 12 * 80.0**2 * math.sin(2.0 * math.pi / 12)
    (water,) = sim.WaterBalloon(masses=12, fill=1.5, diameter=160.0).expand().fillings
    assert isinstance(water, sim.Liquid)
    assert (water.masses, water.bulk_modulus) == (tuple(range(12)), 5000.0)
    assert water.area == pytest.approx(1.5 * area)
    (air,) = sim.AirBalloon(masses=12, pressure=70.0, outside=50.0).expand().fillings
    assert air == sim.Gas(masses=tuple(range(12)), pressure=70.0, outside=50.0)
    cells = sim.Jelly(columns=4, rows=3, width=30.0, height=20.0).expand().fillings
    assert [cell.masses for cell in cells] == [(i, i + 1, i + 5, i + 4) for i in (0, 1, 2, 4, 5, 6)]
    assert [cell.area for cell in cells if isinstance(cell, sim.Liquid)] == pytest.approx(6 * [100.0])


def test_a_jelly_that_is_pulled_turns_no_cell_inside_out_for_good() -> None:
    scene = sim.load_scene("jelly")
    loops = np.array([cell.masses for cell in scene.fillings])
    for mass, (dx, dy) in ((0, (150.0, 0.0)), (8, (0.0, -200.0)), (31, (120.0, -120.0)), (40, (60.0, 60.0))):
        simulation = sim.Simulation(scene)
        simulation.grab(mass)
        x, y = simulation.positions[mass]
        for part in np.linspace(0.1, 1.0, 10):
            simulation.follow(mass, (x + dx * part, y + dy * part))
            simulation.advance(0.05)
        simulation.release(mass)
        simulation.advance(2.0)
        across, along = simulation.positions[loops[:, 2]], simulation.positions[loops[:, 3]]
        across, along = across - simulation.positions[loops[:, 0]], along - simulation.positions[loops[:, 1]]
        assert (across[:, 0] * along[:, 1] - across[:, 1] * along[:, 0] > 0.0).all(), mass


def test_a_tree_gets_thinner_and_shorter_at_each_fork() -> None:
    tree = sim.Tree(forks=2, segments=1, thinning=0.5, shrink=0.8, length=100.0, spread=90.0).expand()
    assert [m.mass for m in tree.masses] == [1.0, 1.0, *[0.5] * 2, *[0.25] * 4]
    assert [s.rest_length for s in tree.linear_springs] == pytest.approx([100.0, 80.0, 80.0, *[64.0] * 4])
    assert [j.stiffness / 30_000.0 for j in tree.angular_springs] == [0.25] * 2 + [0.0625] * 4
    assert [j.rest_angle for j in tree.angular_springs] == [-45.0, 45.0] * 3
    # Up the screen, and to both sides.
    assert tree.masses[1].position == (300.0, 470.0)
    assert tree.masses[2].position[0] < 300.0 < tree.masses[3].position[0]


def test_a_cloth_is_held_where_it_says() -> None:
    def held(where: Any) -> list[int]:
        return [a.mass for a in sim.Cloth(columns=4, rows=3, held=where).expand().anchors]

    assert [held(where) for where in ("edge", "corners", "corner", "nothing")] == [
        [0, 1, 2, 3], [0, 3], [0], [],
    ]  # fmt: skip


# ------------------------------------------------------------------------- several bodies
TWO = (sim.Rod(masses=4, held=(0,)), sim.Polygon(sides=3, center=(500.0, 300.0)))


def test_bodies_come_one_after_the_other_and_links_join_them() -> None:
    link = LinearSpring(a=3, b=4, stiffness=50.0, rest_length=10.0)
    scene = validate(scene_of(*TWO, sim.AirBalloon(masses=5), links=(link,)))
    assert len(scene.masses) == 12
    assert [(s.a, s.b) for s in scene.linear_springs[3:6]] == [(4, 5), (5, 6), (6, 4)]
    assert scene.linear_springs[-1] == link
    assert [(j.a, j.b) for j in scene.angular_springs[2:5]] == [(3, 4), (4, 5), (5, 3)]
    assert [a.mass for a in scene.anchors] == [0]
    assert scene.fillings[0].masses == (7, 8, 9, 10, 11)
    assert decode_scene(encode_scene(scene), "scene") == scene
    # The link pulls the two together.
    gaps = []
    for links in ((), (link,)):
        simulation = Simulation(scene_of(*TWO, links=links))
        simulation.step(100)
        gaps.append(math.dist(*simulation.positions[3:5]))
    assert gaps[1] < gaps[0] - 10.0


@pytest.mark.parametrize(
    ("scene", "sentence"),
    [
        (
            scene_of(*TWO, links=(LinearSpring(a=0, b=7, stiffness=1.0, rest_length=1.0),)),
            "links[0].b: mass 7 does not exist (0..6)",
        ),
        (
            Scene(name="a", masses=(sim.Mass(position=(0.0, 0.0)),), links=(TWO[0].expand()[1][0],)),
            "links: they join the bodies, and this scene has none; its springs are its linear_springs",
        ),
        (
            scene_of(sim.Rod(driven=0), sim.Box(driven=1)),
            "bodies[1].driven: bodies[0] has a driven mass already, and only one can be",
        ),
        (scene_of(sim.Box(), sim.Rod(direction=(0.0, 0.0))), "bodies[1].direction: a direction of (0, 0)"),
        (scene_of(sim.Tree(forks=12, branches=10)), f"bodies: they have more than {MAX_MASSES} masses"),
        (scene_of(sim.Cloth(columns=10_000, rows=10_000)), f"bodies: they have more than {MAX_MASSES}"),
        (scene_of(*[sim.Rope(masses=9000)] * 5000), f"bodies: they have more than {MAX_MASSES} masses"),
        (scene_of(sim.Mass(position=(0.0, 0.0))), "bodies[0]: one of Rope, Rod, Box, "),  # type: ignore[arg-type]
        (replace(scene_of(*TWO), masses=TWO[0].expand().masses), "bodies: a scene has either recipes or"),
        (replace(sim.air_balloon(), fillings=()), "bodies: a scene has either recipes or masses"),
        (sim.rod, "a Scene is expected, not function"),
    ],
    ids=range(11),
)
def test_bodies_that_do_not_fit_have_their_sentence(scene: Scene, sentence: str) -> None:
    assert refused(scene).startswith(sentence)


# ------------------------------------------------------------------------- at rest under a load


def test_members_of_a_girder_have_one_cross_section() -> None:
    scene = scene_of(sim.Girder(truss="pratt", depth=30.0, strength=5.0, yield_force=4.0, hardening=3.0))
    products = [spring.stiffness * spring.rest_length for spring in scene.linear_springs]
    assert products == pytest.approx([products[0]] * len(products))
    assert max(spring.stiffness for spring in scene.linear_springs) == 200_000.0
    assert {(spring.strength, spring.yield_force) for spring in scene.linear_springs} == {(5.0, 4.0)}
    ratios = [spring.hardening / spring.stiffness for spring in scene.linear_springs]
    assert ratios == pytest.approx([3.0 / 200_000.0] * len(ratios))


@pytest.mark.parametrize("change", [{"strength": 100.0}, {"stiffness": 0.0, "strength": None}])
def test_members_that_cannot_yield_do_not_so_that_no_slider_is_stuck(change: dict[str, Any]) -> None:
    tough = sim.Girder(strength=300.0, yield_force=200.0, hardening=50.0)
    assert {spring.yield_force for spring in tough.expand().linear_springs} == {200.0}
    scene = validate(scene_of(replace(tough, **change)))
    assert {spring.yield_force for spring in scene.linear_springs} == {None}
    assert "hardening" in refused(scene_of(sim.Girder(hardening=50.0)))


@pytest.mark.parametrize("name", ["air-balloon", "water-balloon", "jelly"])
def test_what_is_thrown_stays_in_view(name: str) -> None:
    simulation = after(sim.load_scene(name), 1.0)
    x, y = simulation.positions[0]
    simulation.grab(0)
    for part in np.linspace(0.1, 1.0, 10):
        simulation.follow(0, (x + 200.0 * part, y - 150.0 * part))
        simulation.advance(0.02)
    simulation.release(0)
    simulation.advance(4.0)
    left, _, right, bottom = simulation.scene.view.frame
    x, y = simulation.positions.T
    assert left - 60.0 < x.min() < x.max() < right + 60.0
    assert y.max() < bottom


def test_a_girder_that_breaks_falls_to_the_ground_in_view() -> None:
    simulation = after(sim.set_value(sim.load_scene("girder"), "load", 400.0), 4.0)
    assert simulation.damage is not None and simulation.damage.broken
    assert simulation.positions[:, 1].max() < simulation.scene.view.frame[3]
