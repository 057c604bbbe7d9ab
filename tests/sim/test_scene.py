"""What makes a scene valid, and the sentence for everything that does not."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import (
    Anchor,
    AngularSpring,
    ArrowKeys,
    Gas,
    LinearSpring,
    Mass,
    Pose,
    Rope,
    Scene,
    SceneError,
    SpringMuscle,
    View,
    validate,
)
from sim.scene.numbers import MAX_MASSES, MAX_SPRINGS
from sim.scene.types import Circle, Damage, Grips
from sim.scene.validate import number_range
from sim.store.files import decode_scene, encode_scene
from tests.sim.changes import with_joints, with_springs
from tests.sim.checks import refusal

WRONG: dict[str, Any] = {"masses": [0], "pressure": 1.0}
WRONG_MUSCLES: list[dict[str, Any]] = [
    {"amplitude": 1.0}, {"amplitude": math.nan}, {"phase": 361.0}, {"per_beat": 0}, {"wave": "square"},
]  # fmt: skip

BODY = Scene(
    name="body",
    masses=(
        Mass(position=(0.0, 0.0)),
        Mass(position=(10.0, 0.0), velocity=(1.0, 2.0)),
        Mass(position=(20.0, 5.0)),
    ),
    linear_springs=(
        LinearSpring(a=0, b=1, stiffness=100.0, damping=1.0, rest_length=10.0),
        LinearSpring(a=1, b=2, stiffness=100.0, damping=1.0, rest_length=10.0),
    ),
    angular_springs=(AngularSpring(a=0, b=1, stiffness=10.0, damping=0.5, rest_angle=90.0),),
    anchors=(Anchor(mass=0, driven=True, circle=Circle(radius=5.0)),),
    arrow_keys=ArrowKeys(),
    pose=Pose(positions=((0.0, 0.0), (10.0, 1.0), (20.0, 5.0)), velocities=((0.0, 0.0),) * 3),
)
"""A scene with something in every field but the recipe."""

ROPE = Scene(name="rope", bodies=(Rope(masses=4, driven=0, circle=Circle(radius=5.0)),))


STOP = AngularSpring(a=0, b=1, stiffness=1.0, only="above")
AROUND = replace(
    with_joints(with_springs(BODY, strength=9.0, yield_force=8.0, hardening=1.0), yield_torque=50.0),
    fillings=(
        sim.Gas(masses=(0, 1, 2), pressure=5.0, area=3.0),
        sim.Liquid(masses=(2, 1, 0), bulk_modulus=2.0),
    ),
    wind=sim.Wind(velocity=(10.0, 0.0), turbulence=0.2),
    walls=(sim.Wall(point=(0.0, 50.0), normal=(0.0, -1.0)),),
    contact=sim.Contact(distance=2.0),
)
"""A scene with surroundings, and with springs that break and yield."""


Step = str | int
Route = tuple[Step, ...]


def routes(value: Any, wanted: type, kind: Any = None, before: Route = ()) -> Iterator[Route]:
    """The way to every field of a type in a struct; of a tuple of any length, to its first entry."""
    kind = type(value) if kind is None else kind
    origin = get_origin(kind)
    if origin is Annotated:
        yield from routes(value, wanted, get_args(kind)[0], before)
    elif origin in (Union, UnionType):
        if value is not None:
            inners = [a for a in get_args(kind) if a is not type(None)]
            (inner,) = inners if len(inners) == 1 else [type(value)]  # of tagged structs, the one it is
            yield from routes(value, wanted, inner, before)
    elif origin is tuple:
        arguments = get_args(kind)
        if arguments[-1] is Ellipsis:
            arguments = arguments[:1] if value else ()
        for i, inner in enumerate(arguments):
            yield from routes(value[i], wanted, inner, (*before, i))
    elif isinstance(kind, type) and issubclass(kind, msgspec.Struct):
        hints = get_type_hints(kind, include_extras=True)
        for name in kind.__struct_fields__:
            yield from routes(getattr(value, name), wanted, hints[name], (*before, name))
    elif kind is wanted:
        yield before


def with_value(whole: Any, route: Route, value: Any) -> Any:
    """A copy of a frozen struct with another value at the end of a route."""
    if not route:
        return value
    step, rest = route[0], route[1:]
    if isinstance(step, int):
        return (*whole[:step], with_value(whole[step], rest, value), *whole[step + 1 :])
    return replace(whole, **{step: with_value(getattr(whole, step), rest, value)})


def spelled(route: Route) -> str:
    """The route as error messages spell it: `masses[0].position[1]`."""
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in route).lstrip(".")


def refused(scene: Any) -> str:
    """The sentence for a scene that is not valid."""
    return refusal(SceneError, validate, scene)


def changed(route: str, value: Any, scene: Scene = BODY) -> Scene:
    steps = tuple(int(s) if s.isdigit() else s for s in route.split("."))
    return with_value(scene, steps, value)


def rope_with(**changes: Any) -> Scene:
    return Scene(name="rope", bodies=(Rope(**{"masses": 4, **changes}),))


def test_valid_scenes_are_returned_as_they_are() -> None:
    for scene in (BODY, ROPE, AROUND):
        assert validate(scene) is scene


# ------------------------------------------------------------------------- what belongs together
RULES: list[tuple[Scene, str]] = [
    (changed("fillings.0.masses", (0, 1), AROUND), r"fillings\[0\]\.masses: .*at least three masses, not 2"),
    (changed("fillings.1.masses", (0, 1, 3), AROUND), r"fillings\[1\]\.masses\[2\]: mass 3 does not exist"),
    (changed("fillings.0.masses", (0, 1, 0, 2), AROUND), r"fillings\[0\]\.masses\[2\]: mass 0 .*already"),
    (
        changed("masses.2.position", (30.0, 0.0), AROUND),
        r"fillings\[1\]\.masses: the loop has no area",  # the gas has one of its own
    ),
    (changed("walls.0.normal", (0.0, 0.0), AROUND), r"walls\[0\]\.normal: a normal of \(0, 0\)"),
    (changed("linear_springs.1.stiffness", 0.0, AROUND), r"linear_springs\[1\]\.yield_force: .*is 0 never"),
    (changed("linear_springs.0.strength", 7.0, AROUND), r"linear_springs\[0\]\.strength: 7 is below .* 8,"),
    (changed("linear_springs.0.yield_force", None, AROUND), r"linear_springs\[0\]\.hardening: .*no effect"),
    (changed("angular_springs.0.stiffness", 0.0, AROUND), r"angular_springs\[0\]\.yield_torque: .*never"),
    (replace(BODY, format=5), r"format: .*version 5, newer than 4"),
    (Scene(name="none"), r"masses: a scene needs at least one mass, or a recipe in bodies"),
    (changed("linear_springs.1.b", 3), r"linear_springs\[1\]\.b: mass 3 does not exist \(0\.\.2\)"),
    (changed("linear_springs.0.a", 7), r"linear_springs\[0\]\.a: mass 7 does not exist"),
    (changed("linear_springs.1.b", 1), r"linear_springs\[1\]\.b: .*mass 1 with itself"),
    (
        replace(BODY, linear_springs=(*BODY.linear_springs, replace(BODY.linear_springs[0], a=1, b=0))),
        r"linear_springs\[2\]: it joins masses 1 and 0, as spring 0 does",
    ),
    (
        replace(changed("masses.1.position", (0.0, 0.0)), pose=None),
        r"linear_springs\[0\]: masses 0 and 1 start in the same place",
    ),
    (changed("pose.positions.1", (0.0, 0.0)), r"linear_springs\[0\]: pose\.positions 0 and 1 start"),
    (changed("angular_springs.0.a", 2), r"angular_springs\[0\]\.a: spring 2 does not exist \(0\.\.1\)"),
    (changed("angular_springs.0.b", 9), r"angular_springs\[0\]\.b: spring 9 does not exist"),
    (replace(BODY, linear_springs=()), r"angular_springs\[0\]\.a: .* exist \(there are none\)"),
    (changed("angular_springs.0.b", 0), r"angular_springs\[0\]\.b: .*two different springs"),
    (
        replace(
            BODY,
            masses=(*BODY.masses, Mass(position=(50.0, 0.0))),
            linear_springs=(BODY.linear_springs[0], replace(BODY.linear_springs[1], a=2, b=3)),
            pose=None,
        ),
        r"angular_springs\[0\]: springs 0 and 1 share no mass",
    ),
    (
        replace(BODY, angular_springs=(*BODY.angular_springs, AngularSpring(a=1, b=0, stiffness=1.0))),
        r"angular_springs\[1\]: it holds springs 1 and 0, as spring 0 does",
    ),
    (
        replace(BODY, angular_springs=(STOP, replace(STOP, only="below"), replace(STOP, rest_angle=20.0))),
        r"angular_springs\[2\]: it holds springs 0 and 1, as spring 0 does",
    ),
    (
        replace(BODY, angular_springs=(STOP, AngularSpring(a=1, b=0, stiffness=1.0, only="below"))),
        r"angular_springs\[1\]: it holds springs 1 and 0, as spring 0 does",
    ),
    (replace(BODY, template=45), r"angular_springs\[0\]\.rest_angle: 90 is not the scene's template, 45"),
    (changed("anchors.0.mass", 3), r"anchors\[0\]\.mass: mass 3 does not exist"),
    (replace(BODY, anchors=(Anchor(mass=1), Anchor(mass=1))), r"anchors\[1\]\.mass: .*held by anchor 0"),
    (
        replace(BODY, anchors=(Anchor(mass=1, driven=True), Anchor(mass=0, driven=True))),
        r"anchors\[1\]\.driven: anchor 0 is driven already",
    ),
    (changed("view.frame", (0.0, 0.0, 0.0, 600.0)), r"view\.frame: "),
    (changed("view.frame", (0.0, 600.0, 600.0, 0.0)), r"view\.frame: "),
    (changed("pose.positions", ((0.0, 0.0), (1.0, 0.0))), r"pose\.positions: 2 entries .* 3"),
    (changed("pose.velocities", ()), r"pose\.velocities: 0 entries do not match the 3 masses"),
    (rope_with(direction=(0.0, 0.0)), r"bodies\[0\]\.direction: "),
    (rope_with(masses=1), r"bodies\[0\]\.masses: 1 is not in the range 2\.\.20000"),
    (rope_with(masses=20_001), r"bodies\[0\]\.masses: 20001 is not in the range"),
    (rope_with(length=0.0), r"bodies\[0\]\.length: 0 is not in the range 0\.001\.\."),
    (replace(ROPE, masses=BODY.masses), r"bodies: .*either recipes or masses"),
    (replace(ROPE, anchors=()), r"bodies: .*either recipes or masses"),
]  # fmt: skip


@pytest.mark.parametrize(("scene", "sentence"), RULES, ids=[str(i) for i in range(len(RULES))])
def test_every_rule_has_its_sentence(scene: Scene, sentence: str) -> None:
    assert re.match(sentence, refused(scene))


def test_too_many_masses_and_springs() -> None:
    masses = tuple(Mass(position=(float(i), 0.0)) for i in range(MAX_MASSES + 1))
    assert refused(Scene(name="many", masses=masses)).startswith("masses: 20001 masses are more than 20000")
    springs = (BODY.linear_springs[0],) * (MAX_SPRINGS + 1)
    assert "linear_springs: 100001 springs" in refused(
        replace(BODY, linear_springs=springs, angular_springs=())
    )


# ------------------------------------------------------------------------- types and ranges
TYPES: list[tuple[str, Any, str]] = [
    ("name", "x" * 61, "name: "),
    ("description", "x" * 2001, "description: "),
    ("format", 0, "format: "),
    ("format", True, "format: "),
    ("integrator.method", "leapfrog", "integrator.method: "),
    ("integrator.method", True, "integrator.method: "),
    ("force_law", "cosine", "force_law: "),
    ("air_law", "cubic", "air_law: "),
    ("anchors.0.circle", 5.0, "anchors[0].circle: "),
    ("view.unit", "", "view.unit: "),
    ("view.colors", "blue", "view.colors: "),
    ("view.readouts", ("degrees", "tangent"), "view.readouts[1]: "),
    ("view.y_down", 1, "view.y_down: "),
    ("anchors.0.driven", "yes", "anchors[0].driven: "),
    ("anchors.0.mass", 0.0, "anchors[0].mass: "),
    ("anchors.0.mass", -1, "anchors[0].mass: "),
    ("linear_springs.0.a", MAX_SPRINGS, "linear_springs[0].a: "),
    ("linear_springs.0.a", False, "linear_springs[0].a: "),
    ("masses.0.position", (1.0, 2.0, 3.0), "masses[0].position: "),
    ("masses.0.position", ("1", 2.0), "masses[0].position[0]: "),
    ("masses", list(BODY.masses), "masses: a tuple is expected, not list"),
    ("masses.1.velocity", [1.0, 2.0], "masses[1].velocity: a tuple is expected, not list"),
    ("masses.0.position", (1.0,), "masses[0].position: 2 numbers are expected, as in a tuple"),
    ("gravity", None, "gravity: 2 numbers are expected, as in a tuple"),
    ("masses.0.position", np.ones(2), "masses[0].position: 2 numbers are expected, as in a tuple"),
    ("masses.0", BODY.anchors[0], "masses[0]: a Mass is expected, not Anchor"),
    ("masses.2", {"position": (1.0, 2.0)}, "masses[2]: a Mass is expected, not dict"),
    ("masses.2", None, "masses[2]: a Mass is expected, not None"),
    ("arrow_keys", View(), "arrow_keys: an ArrowKeys is expected, not View"),
    ("air_friction", np.int64(0), "air_friction: a number is expected, not int64"),
    ("air_friction", object(), "air_friction: a number is expected, not object"),
    ("name", object(), "name: a text is expected, not object"),
    ("name", b"ab", "name: a text is expected, not bytes"),
    ("name", "\ud800", "name: it has characters that cannot be written to a file"),
    ("description", "a\udfffb", "description: it has characters that cannot be written to a file"),
    ("view.unit", "\ud800", "view.unit: it has characters that cannot be written to a file"),
    ("template", 45.0, "template: 45.0 is not one of 180, 135, 90, 45, 0, -45, -90, -135"),
    ("force_law", "x" * 500, f"force_law: '{'x' * 60}…' is not one of tutorial, conservative, angle"),
    ("name", "", "name: it must not be empty"),
    ("view.unit", "centimetre", "view.unit: 10 characters are more than 8"),
    ("fillings", (BODY.masses[0],), "fillings[0]: one of Gas, Liquid is expected, not Mass"),
    ("fillings", (Gas(masses=(0,), pressure=math.nan),),
     "fillings[0].pressure: nan is not a finite number"),
    ("fillings", (Gas(**WRONG),), "fillings[0].masses: a tuple is expected, not list"),
    ("masses.1.force", (math.nan, 0.0), "masses[1].force[0]: nan is not a finite number"),
    *(("linear_springs.0.muscle", SpringMuscle(**wrong), f"linear_springs[0].muscle.{next(iter(wrong))}: ")
      for wrong in WRONG_MUSCLES),
    ("pose.damage", Damage(broken=(99,)), "pose.damage.broken[0]: spring 99 does not exist (0..1)"),
    ("pose.damage", Damage(set_lengths=(1.0,)), "pose.damage.set_lengths: 1 entries do not match the 2"),
    ("pose.damage", Damage(set_angles=(1.0, 2.0)), "pose.damage.set_angles: 2 entries do not match the 1"),
    ("pose.damage", Damage(hardened=(math.nan,)), "pose.damage.hardened[0]: nan is not a finite number"),
    ("pose.grips", Grips(walls=((1, 0, 0.1),)), "pose.grips.walls[0]: wall 1 does not exist"),
    ("pose.grips", Grips(springs=((0, 5, 0.1),)), "pose.grips.springs[0]: mass 5 does not exist (0..2)"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("route", "value", "sentence"), TYPES, ids=[f"{i}-{route}" for i, (route, _, _) in enumerate(TYPES)]
)
def test_what_is_expected_of_a_field_is_said(route: str, value: Any, sentence: str) -> None:
    assert refused(changed(route, value)).startswith(sentence)


def test_a_whole_number_too_long_for_a_sentence_is_left_out_of_it() -> None:
    for route in ("linear_springs.0.a", "masses.0.mass", "name"):
        assert refused(changed(route, 10**5000)).endswith(": a whole number as large as this is not allowed")


def test_numbers_and_texts_of_numpy_are_good_and_can_be_saved() -> None:
    scene = validate(changed("masses.1.mass", np.float64(2.5), changed("name", np.str_("numpy"))))
    assert decode_scene(encode_scene(scene), "scene") == scene
    for number, said in ((0.0, "0 is not in the range"), (math.nan, "nan is not a finite number")):
        assert refused(changed("masses.1.mass", np.float64(number))).startswith(f"masses[1].mass: {said}")


def test_what_is_no_scene_is_refused() -> None:
    for thing in (None, {}, "tutorial-3.3", BODY.masses[0]):
        assert "a Scene is expected" in refused(thing)


FLOATS = (
    [(BODY, route) for route in routes(BODY, float)]
    + [
        (AROUND, route)
        for route in routes(AROUND, float)
        if route[0] in ("fillings", "wind", "walls", "contact")
        or route[-1] in ("strength", "yield_force", "hardening", "yield_torque")
    ]
    + [(ROPE, route) for route in routes(ROPE, float) if route[0] == "bodies"]
)


def test_the_walk_finds_the_numbers() -> None:
    # A guard for the tests below: every struct is met, and both axes of a vector.
    found = {spelled(route) for _, route in FLOATS}
    assert {
        "gravity[1]", "masses[0].mass", "linear_springs[0].damping", "angular_springs[0].rest_angle",
        "integrator.dt", "arrow_keys.interval", "view.frame[3]", "pose.velocities[0][1]", "bodies[0].offset",
        "fillings[0].pressure", "fillings[0].area", "walls[0].normal[1]", "wind.velocity[0]",
        "contact.distance", "linear_springs[0].strength", "linear_springs[0].yield_force",
        "angular_springs[0].yield_torque",
        "bodies[0].direction[0]", "bodies[0].circle.ramp", "anchors[0].circle.frequency",
        "integrator.tolerance",
    } <= found  # fmt: skip
    assert len(found) >= 47


def with_number(scene: Scene, route: Route, value: Any) -> Scene:
    """The scene with another value there; a recipe is expanded anew, as it is when a file is read."""
    if route[0] == "bodies":
        return Scene(name="rope", bodies=with_value(scene.bodies, route[1:], value))
    return with_value(scene, route, value)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 1e30, -1e30])
def test_nan_infinite_and_huge_numbers_are_refused_everywhere(value: float) -> None:
    for scene, route in FLOATS:
        text = refused(with_number(scene, route, value))
        assert text.startswith(spelled(route) + ": ")
        assert ("not a finite number" in text) == (not math.isfinite(value)), text


def test_what_is_no_number_is_refused_everywhere() -> None:
    # A recipe is expanded as the scene is made, so it must bear anything until it is looked at.
    for scene, route in FLOATS:
        for value in (10**400,) if scene is AROUND else ("1", None, True, (1.0,), 10**400):
            assert refused(with_number(scene, route, value)).startswith(spelled(route) + ": ")


@pytest.mark.parametrize(("kind", "field", "low", "high"), [
    (Mass, "mass", 1e-6, 1e6), (Mass, "radius", 1e-3, 1e4), (LinearSpring, "stiffness", 0.0, 1e15),
    (LinearSpring, "damping", 0.0, 1e6), (LinearSpring, "rest_length", 0.0, 1e6),
    (AngularSpring, "stiffness", 0.0, 1e15), (AngularSpring, "rest_angle", -180.0, 180.0),
    (sim.Integrator, "dt", 1e-6, 1.0), (Scene, "air_friction", 0.0, 1000.0),
    (Scene, "rest_length_scale", 0.01, 100.0), (ArrowKeys, "rest_length_factor", 1.0, 2.0),
    (ArrowKeys, "rest_angle_step", 0.0, 90.0), (ArrowKeys, "interval", 1e-6, 10.0),
    (Rope, "length", 1e-3, 1e6), (Rope, "offset", -1000.0, 1000.0), (AngularSpring, "damping", 0.0, 1e6),
    (sim.Integrator, "tolerance", 1e-12, 1e3), (Circle, "radius", 0.0, 1e4),
    (Circle, "frequency", -100.0, 100.0), (Circle, "ramp", 1e-3, 100.0),
])  # fmt: skip
def test_ranges_are_those_documented_and_their_ends_belong_to_them(
    kind: type, field: str, low: float, high: float
) -> None:
    assert number_range(kind, field)[:2] == (low, high)
    scene, route = next((s, r) for s, r in FLOATS if r[-1] == field and owner(s, r) is kind)
    for value in (low, high):
        validate(with_number(scene, route, value))
    for value in (math.nextafter(low, -math.inf), math.nextafter(high, math.inf)):
        assert refused(with_number(scene, route, value)).startswith(spelled(route) + ": ")


def owner(scene: Any, route: Route) -> type:
    """The type whose field the route ends at."""
    for step in route[:-1]:
        scene = scene[step] if isinstance(step, int) else getattr(scene, step)
    return type(scene)


def test_whole_numbers_may_stand_for_decimal_ones() -> None:
    scene = validate(replace(BODY, gravity=(0, 2000), air_friction=0))
    sim.Simulation(scene).step(3)


# ------------------------------------------------------------------------- recipes
def test_a_recipe_is_expanded_as_the_scene_is_made() -> None:
    scene = rope_with(masses=3, start=(1.0, 2.0), direction=(0.0, -5.0), length=8.0, offset=0.5, driven=2)
    assert [mass.position for mass in scene.masses] == [(1.0, 0.0), (1.0, -4.0), (1.0, -8.0)]
    assert [(s.a, s.b, s.rest_length) for s in scene.linear_springs] == [(0, 1, 4.0), (1, 2, 4.0)]
    assert [(j.a, j.b) for j in scene.angular_springs] == [(0, 1)]
    assert [(a.mass, a.driven) for a in scene.anchors] == [(0, False), (2, True)]


def test_a_recipe_hands_on_its_angular_damping_and_the_circle_of_its_first_mass() -> None:
    circle = Circle(radius=7.0, frequency=3.0)
    scene = validate(rope_with(angular_damping=2.5, held=(0, 3), circle=circle))
    assert [joint.damping for joint in scene.angular_springs] == [2.5, 2.5]
    assert [(a.mass, a.circle) for a in scene.anchors] == [(0, circle), (3, None)]
    assert validate(rope_with(held=(3,), circle=circle)).anchors == (Anchor(mass=3),)
    made = sim.rope(angular_damping=2.5, circle=circle, force_law="angle", joints=True)
    assert (made.anchors[0].circle, made.angular_springs[0].damping) == (circle, 2.5)
    assert made.force_law == "angle"


def test_a_scene_says_nothing_of_laws_and_methods_and_gets_the_usual_ones() -> None:
    scene = validate(Scene(name="one", masses=(Mass(position=(0.0, 0.0)),)))
    assert (scene.format, scene.force_law, scene.integrator.method) == (4, "conservative", "auto")
    assert (scene.air_law, sim.box().air_law, sim.rope().air_law) == ("isotropic", "isotropic", "tutorial")
    assert sim.rope().force_law == "conservative"


def test_a_recipe_without_joints_and_with_anchors_it_is_too_short_for() -> None:
    scene = validate(rope_with(masses=3, joints=False, held=(0, 2, 9), driven=7))
    assert scene.angular_springs == ()
    assert [(a.mass, a.driven) for a in scene.anchors] == [(0, False), (2, False)]


@pytest.mark.parametrize("direction", [(1e-200, 0.0), (0.0, -5e-324), (1e-170, 1e-170)])
def test_a_direction_may_be_as_short_as_it_likes(direction: tuple[float, float]) -> None:
    scene = validate(rope_with(direction=direction))
    assert math.dist(scene.masses[0].position, scene.masses[-1].position) == pytest.approx(300.0)


def test_scenes_are_frozen() -> None:
    for thing in (BODY, BODY.masses[0], BODY.view):
        with pytest.raises(AttributeError):
            thing.name = "other"  # type: ignore[misc, union-attr]
