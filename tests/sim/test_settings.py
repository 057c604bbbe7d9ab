"""The numbers with a slider: which scene has which, and that each does just what it says."""

from __future__ import annotations

import math
import re
from functools import partial

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import ArrowKeys, Scene, SettingError, Simulation, load_scene, set_value, validate
from sim.model.system import joint_stiffness
from sim.scene.surroundings import Contact, Wall
from sim.scene.types import Damage
from sim.settings import (
    CHOICES,
    SETTINGS,
    TEMPLATES,
    Setting,
    apply_assignments,
    set_choice,
    settings_of,
    shift_rest_angles,
)
from sim.solve.registry import METHODS
from tests.sim.bodies import tangle
from tests.sim.builders import PRESETS, chain, row, star
from tests.sim.changes import with_joints
from tests.sim.checks import known, refusal
from tests.sim.fuzzing import with_muscles
from tests.sim.surrounded import OF_STRENGTH, OF_SURROUNDINGS, with_everything

DYNAMIC = {
    "linear_stiffness", "linear_damping", "angular_stiffness", "angular_damping", "rest_length_scale",
    "rest_angle", "gravity", "air_friction", "dt",
}  # fmt: skip
OF_JOINTS = {"angular_stiffness", "angular_damping", "rest_angle"}


def keys_of(scene: Scene) -> set[str]:
    return {setting.key for setting in settings_of(scene)}


# ------------------------------------------------------------------------- which apply
def test_each_example_has_its_settings() -> None:
    assert keys_of(load_scene("tutorial-3.1")) == set()
    assert keys_of(load_scene("tutorial-3.2")) == DYNAMIC | {"template", "masses"}
    assert keys_of(load_scene("tutorial-3.3")) == DYNAMIC | {"masses"}
    assert keys_of(load_scene("ring")) == DYNAMIC | {"tolerance"}  # its method is `auto`
    bent = (DYNAMIC | {"tolerance", "bend"}) - {"rest_angle"}
    assert keys_of(load_scene("box")) == bent | {"width", "height", "per_side"}
    assert keys_of(load_scene("hair-tuft")) == bent | {"hairs", "masses", "length", "spread", "taper"}
    assert keys_of(load_scene("girder")) == (DYNAMIC | {"tolerance"}) - OF_JOINTS | {
        "panels", "depth", "load", "strength", "yield_force", "wall_friction", "bounciness",
    }  # fmt: skip


def test_a_body_without_joints_or_springs_has_fewer() -> None:
    assert keys_of(sim.rope(joints=False)) == (DYNAMIC | {"masses", "tolerance"}) - OF_JOINTS
    assert keys_of(chain(row(1))) == {"gravity", "air_friction", "dt"}
    assert keys_of(chain(row(3), stiffness=1.0, held=(0, 1, 2))) == set()


def test_only_methods_with_error_control_have_a_tolerance() -> None:
    for name, info in METHODS.items():
        scene = set_choice(load_scene("ring"), "method", name)
        assert ("tolerance" in keys_of(scene)) == info.adaptive


def test_a_setting_without_use_is_refused() -> None:
    scene, said = load_scene("tutorial-3.1"), "the scene 'tutorial-3.1' has no"
    for key in SETTINGS:
        why = "the method symplectic_euler has a fixed" if key == "tolerance" else said
        assert f"{key}: {why}" in refusal(SettingError, set_value, scene, key, 1.0)


# ------------------------------------------------------------------------- reading back
def samples(setting: Setting) -> list[float]:
    if setting.key == "template":
        return [float(t) for t in TEMPLATES]
    low, high = setting.slider
    if setting.integer:
        return [low, low + 1, (low + high) // 2, high]
    if setting.key not in SETTINGS:  # of a recipe, whose widest range is not for every body
        return [low, high, low + 0.1234567 * (high - low)]
    return [low, high, low + 0.1234567 * (high - low), setting.low, setting.high]


SCENES = {"everything around": with_everything, **{name: partial(load_scene, name) for name in PRESETS}}


@pytest.mark.parametrize("name", SCENES)
def test_what_is_set_is_read_back(name: str) -> None:
    scene = SCENES[name]()
    for setting in settings_of(scene):
        if name not in PRESETS and setting.key not in OF_SURROUNDINGS | OF_STRENGTH:
            continue  # without stiffness, nothing yields
        assert setting.low <= setting.slider[0] <= setting.read(scene) or setting.key == "rest_angle"
        for value in samples(setting):
            changed = set_value(scene, setting.key, value)
            assert setting.read(changed) == value, setting.key
            # The change reaches the solver, and setting it again changes nothing more.
            Simulation(changed)
            assert set_value(changed, setting.key, value) == changed, setting.key


@pytest.mark.parametrize("name", SCENES)
def test_setting_one_leaves_the_others(name: str) -> None:
    scene = SCENES[name]()
    for setting in settings_of(scene):
        changed = set_value(scene, setting.key, samples(setting)[1])
        touched = {setting.key}
        if setting.key in ("template", "rest_angle"):
            # They set the same angles, and the general law takes over the stiffness of a template.
            touched |= {"template", "rest_angle", "angular_stiffness"}
        if setting.key in ("linear_stiffness", "shear_stiffness"):
            # The one scales the other, and the stiffest spring may be a diagonal.
            touched |= {"linear_stiffness", "shear_stiffness"}
        for other in settings_of(scene):
            if other.key not in touched:
                assert other.read(changed) == other.read(scene), (setting.key, other.key)


@pytest.mark.parametrize("setting", SETTINGS.values(), ids=list(SETTINGS))
def test_values_out_of_range_are_refused(setting: Setting) -> None:
    scene = load_scene("tutorial-3.2")
    if setting.key == "tolerance":
        scene = set_choice(scene, "method", "auto")
    elif setting.key in OF_SURROUNDINGS | OF_STRENGTH:
        scene = with_everything()
    elif setting.key in ("motor_torque", "motor_speed"):
        scene = load_scene("crane")
    elif setting.key == "tempo":
        scene = with_muscles(scene, np.random.default_rng(0))
    assert setting.key in keys_of(scene)
    for value in (math.nan, math.inf, -math.inf, setting.low - 1.0, setting.high * 1.01 + 1.0):
        assert refusal(SettingError, set_value, scene, setting.key, value).startswith(f"{setting.key}: ")


# ------------------------------------------------------------------------- choices
def test_a_choice_is_made_and_read_back() -> None:
    contact = Contact(distance=12.0, stiffness=4000.0)
    wall = Wall(point=(0.0, 900.0), normal=(0.0, -1.0))
    scene = replace(load_scene("ring"), contact=contact, walls=(wall,))
    for key, choice in CHOICES.items():
        assert choice.read(scene) in choice.options
        for value in choice.options:
            changed = set_choice(scene, key, value)
            assert validate(changed) is changed
            assert choice.read(changed) == value
            Simulation(changed).step()
            # Nothing else is touched.
            assert set_choice(changed, key, choice.read(scene)) == scene
    assert set_choice(scene, "force_law", "angle").force_law == "angle"
    assert set_choice(scene, "method", "rk4").integrator == replace(scene.integrator, method="rk4")
    constant = set_choice(scene, "restitution", "constant")
    assert constant.walls == (replace(wall, restitution="constant"),)
    assert constant.contact == replace(contact, restitution="constant")


def test_what_is_touched_has_choices_of_its_own() -> None:
    pile, ring = load_scene("pile"), load_scene("ring")
    for key in ("restitution", "grip"):
        assert CHOICES[key].applies(pile)
        assert not CHOICES[key].applies(ring)


# ------------------------------------------------------------------------- scenes of unequal springs
def joint_damped(scene: Scene) -> Scene:
    """The scene with a different angular damping at every joint."""
    return with_joints(scene, damping=lambda j, _: 0.5 + 0.1 * j)


OF_PARTS = [
    ("linear_stiffness", "linear_springs", "stiffness"),
    ("linear_damping", "linear_springs", "damping"),
    ("angular_stiffness", "angular_springs", "stiffness"),
    ("angular_damping", "angular_springs", "damping"),
    ("rest_angle", "angular_springs", "rest_angle"),
    ("strength", "linear_springs", "strength"),
    ("yield_force", "linear_springs", "yield_force"),
    ("wall_friction", "walls", "friction"),
    ("bounciness", "walls", "bounciness"),
    ("gas_pressure", "fillings", "pressure"),
    ("liquid_stiffness", "fillings", "bulk_modulus"),
]
"""Settings of numbers that many parts have: key, parts and field."""


@pytest.mark.parametrize("kind", ["star", "tangle", "recipes", "everything around"])
def test_unequal_numbers_keep_their_proportion(kind: str) -> None:
    makers = {"star": lambda: joint_damped(star(5)), "tangle": lambda: joint_damped(tangle(4))}
    scene = {**makers, "recipes": several, "everything around": with_everything}[kind]()
    unequal = 0
    for key, parts, field in OF_PARTS:
        before = [getattr(part, field, None) for part in getattr(scene, parts)]
        largest = max((number for number in before if number is not None), default=0.0)
        if key == "rest_angle" or not largest:
            continue
        assert SETTINGS[key].read(scene) == largest
        changed = set_value(scene, key, 0.77 * largest)
        after = [getattr(part, field, None) for part in getattr(changed, parts)]
        assert after == [number if number is None else pytest.approx(0.77 * number) for number in before]
        assert max(number for number in after if number is not None) == 0.77 * largest
        unequal += len({number for number in after if number is not None}) > 1
    assert unequal >= 2


def test_springs_without_any_damping_all_get_the_same() -> None:
    scene = set_value(star(4), "linear_damping", 0.0)
    assert {s.damping for s in set_value(scene, "linear_damping", 3.0).linear_springs} == {3.0}


def test_rest_angle_turns_every_joint_by_as_much() -> None:
    scene = star(4)
    before = [j.rest_angle for j in scene.angular_springs]
    changed = set_value(scene, "rest_angle", before[0] + 170.0)
    after = [j.rest_angle for j in changed.angular_springs]
    assert len(set(before)) > 1
    assert after == pytest.approx([180.0 - (180.0 - (angle + 170.0)) % 360.0 for angle in before])
    assert after[0] == before[0] + 170.0


def test_gravity_keeps_its_direction_is_down_the_screen_otherwise_and_may_point_up() -> None:
    slanted = replace(star(3), gravity=(30.0, 40.0))
    assert SETTINGS["gravity"].read(slanted) == 50.0
    assert set_value(slanted, "gravity", 5.0).gravity == pytest.approx((3.0, 4.0))
    assert set_value(star(3), "gravity", 5.0).gravity == (0.0, 5.0)
    upwards = replace(star(3), view=sim.View(y_down=False))
    assert set_value(upwards, "gravity", 5.0).gravity == (0.0, -5.0)
    for scene in (star(3), slanted, upwards):
        for strength in (5.0, -5.0):
            changed = set_value(scene, "gravity", strength)
            assert SETTINGS["gravity"].read(changed) == strength
            assert set_value(changed, "gravity", strength) == changed


# ------------------------------------------------------------------------- recipes and templates
def several() -> Scene:
    link = sim.LinearSpring(a=9, b=10, stiffness=500.0, damping=1.0, rest_length=30.0)
    return validate(
        Scene(name="several", bodies=(sim.Rod(), sim.FlagPole(driven=None), sim.Girder()), links=(link,))
    )


def test_numbers_of_several_bodies_have_the_place_of_their_body() -> None:
    scene = several()
    keys = [setting.key for setting in settings_of(scene)]
    assert len(set(keys)) == len(keys)
    assert {"bodies[0].length", "bodies[1].length", "bodies[2].load"} <= set(keys)
    assert "length" not in keys
    assert "bodies[2].strength" not in keys  # it has none
    (label,) = (setting.label for setting in settings_of(scene) if setting.key == "bodies[1].length")
    assert label == "FlagPole 2: Length of the flag"
    # Links refer to masses by index, so without them only may the number of masses change.
    assert "bodies[0].masses" not in keys
    scene = replace(scene, links=(), masses=())
    changed = apply_assignments(scene, ["bodies[1].length=50", "bodies[0].masses=4"])
    assert changed.bodies == (sim.Rod(masses=4), sim.FlagPole(driven=None, length=50.0), sim.Girder())
    assert len(changed.masses) == len(scene.masses) - 6
    for key in ("bodies[3].length", "bodies[0].sides", "length"):
        assert "there is no such setting" in refusal(SettingError, set_value, scene, key, 3.0)


def test_what_stays_of_a_panel_is_the_same_setting() -> None:
    # The page keeps a slider as long as its setting is equal to that before.
    scene = several()
    assert settings_of(scene) == settings_of(set_value(scene, "bodies[0].length", 99.0))
    assert settings_of(scene) != settings_of(replace(scene, bodies=scene.bodies[:1], masses=(), links=()))


def test_links_of_recipes_go_to_no_stiffness_and_back_with_the_others() -> None:
    scene = several()
    assert set_value(scene, "linear_stiffness", 0.0).links[0].stiffness == 0.0
    again = set_value(set_value(scene, "linear_stiffness", 0.0), "linear_stiffness", 5.0)
    assert max(spring.stiffness for spring in again.linear_springs) == 5.0


def test_keys_bend_recipes() -> None:
    scene = replace(several(), arrow_keys=ArrowKeys())
    turned = validate(shift_rest_angles(scene, 100.0))
    assert [getattr(body, "bend", None) for body in turned.bodies] == [100.0, 100.0, None]
    assert shift_rest_angles(turned, 100.0).bodies[0] == replace(sim.Rod(), bend=-160.0)


def test_another_number_of_masses_builds_the_rope_again() -> None:
    scene = set_value(load_scene("tutorial-3.3"), "masses", 21)
    assert (len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)) == (21, 20, 19)
    assert {s.rest_length for s in scene.linear_springs} == {15.0}
    assert [a.mass for a in scene.anchors if a.driven] == [0]
    (rope,) = scene.bodies
    assert isinstance(rope, sim.Rope)
    assert rope.length == 300.0
    # The tip stays where the tutorial's recipe puts it: one spring below the start, plus the length.
    assert scene.masses[-1].position[1] == pytest.approx(149.0 + 15.0 + 300.0)


def test_masses_drop_a_pose_that_no_longer_fits() -> None:
    simulation = Simulation(load_scene("tutorial-3.3"))
    simulation.step(5)
    scene = replace(simulation.scene, pose=simulation.pose())
    assert set_value(scene, "masses", 12).pose == scene.pose
    assert set_value(scene, "masses", 9).pose is None
    assert set_value(scene, "angular_stiffness", 9.0).pose == scene.pose


@pytest.mark.parametrize("as_recipe", [True, False])
@pytest.mark.parametrize("template", TEMPLATES)
def test_a_template_sets_angle_and_stiffness_and_a_turn_keeps_its_strength(
    template: int, as_recipe: bool
) -> None:
    scene = load_scene("tutorial-3.2")
    scene = set_value(scene if as_recipe else replace(scene, bodies=()), "template", template)
    assert scene.template == template
    assert {j.rest_angle for j in scene.angular_springs} == {float(template)}
    assert {j.stiffness for j in scene.angular_springs} == {10_000.0}
    factor = math.sqrt(2.0) if template in (135, 45, -45, -135) else 1.0
    assert joint_stiffness(scene) == [pytest.approx(factor * 10_000.0)] * 6
    turned = validate(shift_rest_angles(scene, 30.0))
    assert turned.template is None
    expected = template + 30.0 - (360.0 if template + 30.0 > 180.0 else 0.0)
    assert {j.rest_angle for j in turned.angular_springs} == {expected}
    assert bool(turned.bodies) == as_recipe
    for each in (turned, set_value(scene, "rest_angle", expected)):
        assert joint_stiffness(each) == pytest.approx(joint_stiffness(scene))


@pytest.mark.parametrize("degrees", [-360.0, -180.0, -0.1, 0.1, 180.0, 359.0, 360.0])
def test_turned_angles_stay_in_range(degrees: float) -> None:
    scene = replace(star(5), arrow_keys=ArrowKeys())
    turned = validate(shift_rest_angles(scene, degrees))
    for old, new in zip(scene.angular_springs, turned.angular_springs, strict=True):
        assert -180.0 < new.rest_angle <= 180.0
        assert math.cos(math.radians(new.rest_angle - old.rest_angle - degrees)) == pytest.approx(1.0)


# ------------------------------------------------------------------------- assignments
def test_assignments_are_applied_in_order() -> None:
    texts = ["masses=5", " gravity = 10 ", "angular_stiffness=2e3", "gravity=-3.5"]
    scene = apply_assignments(load_scene("tutorial-3.3"), texts)
    assert len(scene.masses) == 5
    assert scene.gravity == (0.0, -3.5)
    assert scene.angular_springs[0].stiffness == 2000.0
    assert apply_assignments(scene, []) is scene
    # The tolerance is of use only once the method is another.
    scene = apply_assignments(scene, ["method=rodas4", "tolerance=1e-5", "force_law = angle"])
    assert scene.integrator == sim.Integrator(method="rodas4", tolerance=1e-5)
    assert scene.force_law == "angle"


@pytest.mark.parametrize(
    ("preset", "text", "sentence"),
    [
        *(("tutorial-3.3", text, "KEY=VALUE") for text in
          ("gravity", "gravity=", "gravity=much", "gravity=nan", "gravity=inf")),
        ("tutorial-3.3", "=5", "there is no such setting"),
        ("tutorial-3.3", "weight=5", "weight: there is no such setting; there are linear_stiffness"),
        ("tutorial-3.3", "template=90", "template: the scene 'tutorial-3.3' has no use for it"),
        ("tutorial-3.2", "template=30", "template: 30 is not one of 180, 135"),
        ("tutorial-3.3", "dt=2", "dt: 2 is not in the range 1e-06..1 s"),
        ("tutorial-3.3", "masses=2.5", "masses: 2.5 is not a whole number"),
        ("tutorial-3.3", "method=leapfrog", "method: 'leapfrog' is not one of auto, symplectic_euler"),
        ("tutorial-3.3", "method=", "method: '' is not one of"),
        ("tutorial-3.3", "force_law=", "force_law: '' is not one of tutorial, conservative, angle"),
        ("tutorial-3.3", "tolerance=1",
         "tolerance: the method symplectic_euler has a fixed step, so it takes no tolerance"),
        ("tutorial-3.1", "method=rk4", "method: the scene 'tutorial-3.1' has no use for it"),
        ("pendulum", "force_law=angle", "force_law: the scene 'pendulum' has no use for it"),
    ],
)  # fmt: skip
def test_wrong_assignments_are_refused(preset: str, text: str, sentence: str) -> None:
    assert sentence in refusal(SettingError, apply_assignments, load_scene(preset), [text])


def test_a_choice_and_a_number_are_not_taken_for_each_other() -> None:
    scene = load_scene("rope")
    assert "method: this takes a name: auto, " in refusal(SettingError, set_value, scene, "method", 1.0)
    there = "law: there is no such choice; there are force_law, restitution, grip, air_law, method"
    assert refusal(SettingError, set_choice, scene, "law", "angle") == there


def test_a_preset_s_description_names_only_sliders_that_it_has() -> None:
    labels = {preset: {s.label for s in settings_of(load_scene(preset))} for preset in PRESETS}
    named = {
        (preset, label)
        for preset in PRESETS
        for label in set().union(*labels.values())
        if re.search(rf"\b{re.escape(label)}\b", load_scene(preset).description)
    }
    assert {("jelly", "Shear stiffness"), ("girder", "Load"), ("water-balloon", "Filling")} <= named
    assert all(label in labels[preset] for preset, label in named), named


@pytest.mark.parametrize(("key", "parts", "field"), OF_PARTS)
def test_a_setting_knows_whether_its_parts_differ(key: str, parts: str, field: str) -> None:
    scene, setting = with_everything(), SETTINGS[key]
    every = getattr(scene, parts)
    has = [i for i, part in enumerate(every) if getattr(part, field, None) is not None]
    # As many as have the number, and at least two.
    two = [*has, *has][: max(2, len(has))]

    def valued(*values: float) -> Scene:
        changed = [replace(every[i], **{field: value}) for i, value in zip(two, values, strict=False)]
        return replace(scene, **{parts: tuple(changed)})

    same = valued(*[0.5] * len(two))
    assert not setting.differs(same)
    assert setting.differs(valued(0.5, *[0.25] * (len(two) - 1)))
    # Rounding is no difference, and nothing at all has none.
    assert not setting.differs(valued(0.5, *[math.nextafter(0.5, 1.0)] * (len(two) - 1)))
    assert not setting.differs(replace(scene, **{parts: ()}))


def test_what_a_scene_has_but_once_never_differs() -> None:
    scene = load_scene("tree")
    differing = {setting.key for setting in settings_of(scene) if setting.differs(scene)}
    assert differing == {"linear_stiffness", "linear_damping", "angular_stiffness"}


# ------------------------------------------------------------------------- surroundings and strengths
def test_what_surrounds_a_body_and_what_breaks_has_settings_only_where_it_is() -> None:
    whole = with_everything()
    assert keys_of(whole) - keys_of(tangle(4)) == OF_SURROUNDINGS | OF_STRENGTH
    absent = {"wind": None, "medium": msgspec.UNSET, "ground": msgspec.UNSET, "walls": (), "contact": None}
    gone = {part: keys_of(whole) - keys_of(replace(whole, **{part: no})) for part, no in absent.items()}
    assert gone == {
        "wind": {"wind_speed", "wind_direction", "turbulence"},
        "medium": {"drag_across", "drag_along"},
        "ground": {"ground_forward", "ground_backward", "ground_sideways"},
        "walls": {"wall_friction", "static_friction", "belt_speed", "bounciness"},
        "contact": {"contact_distance", "contact_stiffness", "contact_friction"},
    }
    assert keys_of(whole) - keys_of(replace(whole, fillings=whole.fillings[:2])) == {"liquid_stiffness"}
    assert keys_of(whole) - keys_of(replace(whole, fillings=whole.fillings[2:])) == {"gas_pressure"}


def test_wind_keeps_its_direction_in_a_calm() -> None:
    calm = set_value(with_everything(), "wind_speed", 0.0)
    assert math.hypot(*known(calm.wind).velocity) < 1e-6
    assert known(set_value(calm, "wind_speed", 500.0).wind).velocity == pytest.approx((300.0, -400.0))


@pytest.mark.parametrize("y_down", [True, False])
def test_wind_of_ninety_degrees_blows_up_the_screen(y_down: bool) -> None:
    scene = with_everything()
    scene = replace(scene, view=replace(scene.view, y_down=y_down))
    wind = known(set_value(scene, "wind_direction", 90.0).wind)
    assert wind.velocity == pytest.approx((0.0, -500.0 if y_down else 500.0))


def test_a_change_of_the_surroundings_lets_the_motion_go_on() -> None:
    """What has broken stays broken."""
    scene = with_everything()
    simulation = Simulation(scene)
    simulation.step(40)
    moment = simulation.capture()
    worn = replace(scene, pose=replace(simulation.pose(), damage=Damage(broken=(1,))))
    simulation = Simulation(worn)
    others = {"wind_speed": 900.0, "gas_pressure": 10.0, "contact_distance": 7.0, "strength": 9e3}
    for key, value in {"wall_friction": 0.1, **others}.items():
        simulation.replace(set_value(simulation.scene, key, value))
        assert known(simulation.damage).broken == (1,)
        assert (simulation.positions == moment.positions).all()
        assert (simulation.velocities == moment.velocities).all()
