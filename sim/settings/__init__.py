"""Settings: the numbers and choices of a scene that the panel and `--set` can change, by name.

The springs of a scene may differ. A stiffness or damping setting shows the largest value and scales the
others in proportion. The rest-angle setting shows the first joint's angle and turns all joints by the same
amount, as the arrow keys do. Where all springs are equal, as in the tutorial, a setting is just their value.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, get_args

import msgspec

from ..errors import SceneError, SettingError, did_you_mean, of_field, out_of_range
from ..forces.joints import LAWS
from ..forces.motors import has_motors
from ..model.system import joint_stiffness
from ..scene.columns import has_any
from ..scene.lesson import Lead, Pull, RunMuscle, Step
from ..scene.parts import Anchor, Beat, Motor
from ..scene.recipes.assembly import wrapped
from ..scene.recipes.recipe import AnyRecipe
from ..scene.surroundings import Contact, Gas, Ground, Liquid, Medium, Restitution, Wall, Wind
from ..scene.types import (
    AirLaw,
    AngularSpring,
    ForceLaw,
    Integrator,
    LinearSpring,
    Pose,
    Rope,
    Scene,
    Template,
    is_muscular,
    rebuilt,
)
from ..scene.validate import validate
from ..solve.registry import METHODS
from ..text import Text, number
from .air import with_air_law
from .numbers import Access, at, largest, replaced, wind_direction, wind_speed, with_wind
from .recipes import Setting, recipe_settings, settings_of_recipe, turned
from .touch import holds, touched, with_grip, with_restitution

TEMPLATES: tuple[int, ...] = get_args(Template)
"""The tutorial's eight rest angles, degrees."""


def settings_of(scene: Scene) -> list[Setting]:
    """Return the settings that apply to the scene, in the order of the panel; those of its recipes come
    last."""
    applying = [setting for setting in SETTINGS.values() if setting.applies(scene)]
    if scene.air_law == "linear":
        applying = [_LINEAR_AIR if setting.key == _LINEAR_AIR.key else setting for setting in applying]
    return applying + recipe_settings(scene)


def setting_of(scene: Scene, key: str) -> Setting:
    """Return the setting of that name.

    Raises:
        SettingError: there is none, or it has no effect on the scene.
    """
    applying = {setting.key: setting for setting in settings_of(scene)}
    if key in applying:
        return applying[key]
    if key in SETTINGS:
        raise SettingError(no_use(key, scene))
    if key in CHOICES:
        raise SettingError(
            Text("{key}: this takes a name: {known}", key=key, known=", ".join(CHOICES[key].options))
        )
    known = ", ".join(applying) or Text("none for this scene")
    meant = did_you_mean(key, (*applying, *SETTINGS, *CHOICES))
    raise SettingError(
        Text("{key}: there is no such setting{meant}; there are {known}", key=key, meant=meant, known=known)
    )


def no_use(key: str, scene: Scene) -> str:
    """Return why a setting or choice has no effect on a scene, in a sentence without a full stop."""
    if key == "tolerance":
        method = METHODS[scene.integrator.method]
        return Text(
            "{key}: the method {method} has a fixed step, so it takes no tolerance",
            key=key,
            method=method.name,
        )
    return Text("{key}: the scene {scene!r} has no use for it", key=key, scene=scene.name)


@dataclass(frozen=True)
class Choice:
    """A property of a scene that is chosen from a list of names.

    Attributes:
        key, label: its name in commands, and its name for people.
        options: the names to choose from, each with its label for people.
        read: returns the name that a scene has.
        write: returns the scene with another name, not yet validated.
        applies: whether the choice has any effect on a scene.
        shown: whether its list is shown, of those that apply.
    """

    key: str
    label: str
    options: dict[str, str]
    read: Callable[[Scene], str]
    write: Callable[[Scene, Any], Scene]
    applies: Callable[[Scene], bool]
    shown: Callable[[Scene], bool] = lambda _: True


def set_choice(scene: Scene, key: str, value: str) -> Scene:
    """Return the scene with another choice made.

    Raises:
        SettingError: there is no such choice, it does not apply to the scene, or the value is not one of its
            options.
    """
    choice = CHOICES.get(key)
    if choice is None:
        raise SettingError(
            Text("{key}: there is no such choice; there are {known}", key=key, known=", ".join(CHOICES))
        )
    if not choice.applies(scene):
        raise SettingError(no_use(key, scene))
    if value not in choice.options:
        raise SettingError(
            Text(
                "{key}: {value!r} is not one of {known}{meant}",
                key=key,
                value=value,
                known=", ".join(choice.options),
                meant=did_you_mean(value, choice.options),
            )
        )
    return validate(choice.write(scene, value))


def set_value(scene: Scene, key: str, value: float, time: float = 0.0) -> Scene:
    """Return the scene with one numeric setting changed; `set_choice` is for those that are names.

    Args:
        scene: the scene.
        key: name of the setting.
        value: its new value.
        time: of the run that continues with it, s: at another tempo the waves of muscles continue from their
            phase at this time.

    Raises:
        SettingError: there is no such setting, it does not apply to the scene, or the value is out of range.
    """
    setting = setting_of(scene, key)
    if key == "template" and value not in TEMPLATES:
        raise SettingError(
            Text(
                "{where}: {found} is not one of {known}",
                where=key,
                found=number(value),
                known=", ".join(map(str, TEMPLATES)),
            )
        )
    if not setting.low <= value <= setting.high:
        raise SettingError(
            out_of_range(key, number(value), number(setting.low), number(setting.high), setting.unit)
        )
    if setting.integer and value != int(value):
        raise SettingError(Text("{where}: {value:g} is not a whole number", where=key, value=value))
    try:
        new = setting.write(scene, int(value) if setting.integer else float(value))
        if key == "tempo" and scene.beat:
            new = msgspec.structs.replace(new, beat=scene.beat.at_tempo(float(value), time))
        return validate(new)
    except SceneError as error:
        raise SettingError(of_field(key, str(error))) from None


def apply_assignments(scene: Scene, assignments: Sequence[str]) -> Scene:
    """Return the scene with `KEY=VALUE` assignments applied in order, to settings and choices.

    Raises:
        SettingError: as `set_value` and `set_choice`, or an assignment is not KEY=VALUE with a finite number.
    """
    for assignment in assignments:
        key, equals, text = assignment.partition("=")
        if key.strip() in CHOICES and equals:
            scene = set_choice(scene, key.strip(), text.strip())
            continue
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not equals or not math.isfinite(value):
            if equals:
                setting_of(scene, key.strip())  # a name that is unknown is said first
            raise SettingError(
                Text("--set {assignment}: KEY=VALUE with a finite number is expected", assignment=assignment)
            )
        scene = set_value(scene, key.strip(), value)
    return scene


def scene_of_step(scene: Scene, number: int) -> Scene:
    """Return the scene with the settings of a step of its lesson.

    Args:
        scene: a scene with a lesson.
        number: of the step, counted from 0.

    Raises:
        SettingError: there is no such step, or one of its settings cannot be applied; names the field.
    """
    return _applied(scene, _step(scene, number).settings, f"lesson.steps[{number}].settings")


def scene_of_run(scene: Scene, number: int) -> Scene:
    """Return the scene of a step at the beginning of its run: with the run's changes, pulls and leads.

    Args and errors: as for `scene_of_step`.
    """
    run, where = _step(scene, number).run, f"lesson.steps[{number}].run"
    scene = scene_of_step(scene, number)
    if not run:
        return scene
    scene = _applied(scene, run.settings, f"{where}.settings")
    scene = _pulled(scene, run.pulls, f"{where}.pulls") if run.pulls else scene
    scene = _led(scene, run.leads, f"{where}.leads") if run.leads else scene
    return _with_muscles(scene, run.muscles, f"{where}.muscles") if run.muscles else scene


def _step(scene: Scene, number: int) -> Step:
    steps = scene.lesson.steps if scene.lesson else ()
    if not 0 <= number < len(steps):
        raise SettingError(Text("{where}: step {number} does not exist", where="lesson.steps", number=number))
    return steps[number]


def _applied(scene: Scene, assignments: Sequence[str], where: str) -> Scene:
    for i, assignment in enumerate(assignments):
        try:
            scene = apply_assignments(scene, (assignment,))
        except SettingError as error:
            raise SettingError(of_field(f"{where}[{i}]", str(error))) from None
    return scene


def _pulled(scene: Scene, pulls: Sequence[Pull], where: str) -> Scene:
    """Return the scene with only the start positions of some masses changed."""
    pose = scene.pose or Pose(
        positions=tuple(mass.position for mass in scene.masses),
        velocities=tuple(mass.velocity for mass in scene.masses),
    )
    positions = list(pose.positions)
    for i, pull in enumerate(pulls):
        if pull.mass >= len(positions):
            raise SettingError(
                Text(
                    "{where}: mass {mass} does not exist any more", where=f"{where}[{i}].mass", mass=pull.mass
                )
            )
        x, y = positions[pull.mass]
        positions[pull.mass] = x + pull.by[0], y + pull.by[1]
    return msgspec.structs.replace(scene, pose=msgspec.structs.replace(pose, positions=tuple(positions)))


def _led(scene: Scene, leads: Sequence[Lead], where: str) -> Scene:
    """Return the scene with some masses held and moving round circles; it no longer has recipes."""
    anchors = {anchor.mass: anchor for anchor in scene.anchors}
    for i, lead in enumerate(leads):
        if lead.mass >= len(scene.masses):
            raise SettingError(
                Text(
                    "{where}: mass {mass} does not exist any more", where=f"{where}[{i}].mass", mass=lead.mass
                )
            )
        anchors[lead.mass] = Anchor(mass=lead.mass, circle=lead.circle)
    return msgspec.structs.replace(scene, bodies=(), links=(), anchors=tuple(anchors.values()))


def _with_muscles(scene: Scene, muscles: Sequence[RunMuscle], where: str) -> Scene:
    """Return the scene with other muscles at some joints; it no longer has recipes."""
    joints = list(scene.angular_springs)
    for i, one in enumerate(muscles):
        if one.joint >= len(joints):
            raise SettingError(
                Text(
                    "{where}: joint {joint} does not exist any more",
                    where=f"{where}[{i}].joint",
                    joint=one.joint,
                )
            )
        joints[one.joint] = msgspec.structs.replace(joints[one.joint], muscle=one.muscle or msgspec.UNSET)
    if scene.beat is msgspec.UNSET:
        raise SettingError(Text("{where}: the scene has no beat that muscles could follow", where=where))
    return msgspec.structs.replace(scene, bodies=(), links=(), angular_springs=tuple(joints))


def shift_rest_angles(scene: Scene, degrees: float) -> Scene:
    """Return the scene with all rest angles shifted by |degrees| <= 360 and wrapped into (-180, 180].

    One of the eight templates is removed; its joints keep the template's stiffness.
    """
    stiffness = joint_stiffness(scene)
    if scene.bodies:
        return turned(scene, degrees, stiffness)
    joints = tuple(
        msgspec.structs.replace(joint, rest_angle=wrapped(joint.rest_angle + degrees), stiffness=k)
        for joint, k in zip(scene.angular_springs, stiffness, strict=True)
    )
    return msgspec.structs.replace(scene, angular_springs=joints, template=None)


# ------------------------------------------------------------------------- reading and writing
def _read_rest_angle(scene: Scene) -> float:
    return scene.angular_springs[0].rest_angle if scene.angular_springs else 0.0


def _write_rest_angle(scene: Scene, value: float) -> Scene:
    turn = value - _read_rest_angle(scene)
    scene = shift_rest_angles(scene, turn)
    # The sum above rounds; the first joint gets exactly the given value.
    if scene.bodies:
        ropes = _all_ropes(scene)
        return rebuilt(scene, bodies=(msgspec.structs.replace(ropes[0], rest_angle=value), *ropes[1:]))
    first = msgspec.structs.replace(scene.angular_springs[0], rest_angle=value)
    return msgspec.structs.replace(scene, angular_springs=(first, *scene.angular_springs[1:]))


def _all_ropes(scene: Scene) -> list[Rope]:
    """Return the scene's recipes if all are ropes, which have one rest angle each; otherwise none."""
    ropes = [body for body in scene.bodies if isinstance(body, Rope)]
    return ropes if len(ropes) == len(scene.bodies) else []


def _read_gravity(scene: Scene) -> float:
    """Return the magnitude of gravity, negative where it points up the screen."""
    x, y = scene.gravity
    down = y if scene.view.y_down else -y
    return math.copysign(math.hypot(x, y), down or x) if x else down


def _write_gravity(scene: Scene, value: float) -> Scene:
    """Keep the direction of gravity; straight down the screen where there was none."""
    x, y = scene.gravity
    size = _read_gravity(scene)
    if x and size:
        gravity = (x / size * value, y / size * value)
    else:
        gravity = (0.0, value if scene.view.y_down else -value)
    return msgspec.structs.replace(scene, gravity=gravity)


def _write_template(scene: Scene, value: float) -> Scene:
    template = int(value)
    if scene.bodies:
        ropes = [msgspec.structs.replace(rope, rest_angle=float(template)) for rope in _all_ropes(scene)]
        scene = rebuilt(msgspec.structs.replace(scene, template=None), bodies=tuple(ropes))
    else:
        joints = tuple(msgspec.structs.replace(j, rest_angle=float(template)) for j in scene.angular_springs)
        scene = msgspec.structs.replace(scene, angular_springs=joints)
    return msgspec.structs.replace(scene, template=template)


# ------------------------------------------------------------------------- conditions
def moves(scene: Scene) -> bool:
    """Return whether any mass is free."""
    return len(scene.anchors) < len(scene.masses)


def _has_springs(scene: Scene) -> bool:
    return moves(scene) and bool(scene.linear_springs)


def _has_joints(scene: Scene) -> bool:
    return moves(scene) and bool(scene.angular_springs)


def _has_wind(scene: Scene) -> bool:
    return moves(scene) and scene.wind is not None


def _has_walls(scene: Scene) -> bool:
    return moves(scene) and bool(scene.walls)


def _has_on_walls(field: str) -> Callable[[Scene], bool]:
    """Return whether any wall has an optional field."""
    return lambda scene: any(getattr(wall, field) is not msgspec.UNSET for wall in scene.walls)


def _has_medium(scene: Scene) -> bool:
    return _has_springs(scene) and bool(scene.medium)


def _has_ground(scene: Scene) -> bool:
    return _has_springs(scene) and bool(scene.ground)


def _bounces_are_softened(scene: Scene) -> str:
    """Return a remark if the method softens bounces that it cannot resolve, see `sim.forces.touch.push`."""
    softens = not (METHODS[scene.integrator.method].implicit or METHODS[scene.integrator.method].adaptive)
    return "with a fixed step, fast bounces lose more; with Auto they do not" if softens else ""


def _has_contact(scene: Scene) -> bool:
    return _has_springs(scene) and scene.contact is not None


def _has_waves(scene: Scene) -> bool:
    """Return whether muscles follow the beat; steady ones do not."""
    parts = (*scene.linear_springs, *scene.angular_springs) if is_muscular(scene) else ()
    return moves(scene) and any(part.muscle and part.muscle.wave != "steady" for part in parts)


def _has_motors(scene: Scene) -> bool:
    return moves(scene) and has_motors(scene)


def _has_filling(kind: type) -> Callable[[Scene], bool]:
    """Return whether any loop has this filling; recipes have their own settings for it."""
    return lambda scene: (
        moves(scene) and not scene.bodies and any(isinstance(filling, kind) for filling in scene.fillings)
    )


def _has_limit(field: str) -> Callable[[Scene], bool]:
    """Return whether any spring has this load limit; recipes have their own settings for it."""
    return lambda scene: moves(scene) and not scene.bodies and has_any(scene.linear_springs, field)


def _has_rest_angle(scene: Scene) -> bool:
    """Return whether the first rest angle can set all of them; most recipes have a bend instead."""
    return _has_joints(scene) and (not scene.bodies or bool(_all_ropes(scene)))


def _setting(
    key: str,
    label: str,
    slider: tuple[float, float],
    access: Access,
    applies: Callable[[Scene], bool],
    **rest: Any,
) -> Setting:
    low, high, unit, read, write, differs = access
    return Setting(key, label, unit, low, high, slider, read, write, applies, **rest, differs=differs)


_ALL = (
    _setting(
        "linear_stiffness", "Stretching stiffness", (100.0, 1e6),
        largest(LinearSpring, "linear_springs", "stiffness"), _has_springs, logarithmic=True,
        term="linear stiffness",
    ),
    _setting(
        "linear_damping", "Stretching damping", (0.0, 200.0),
        largest(LinearSpring, "linear_springs", "damping"), _has_springs,
        term="linear damping",
    ),
    _setting(
        "angular_stiffness", "Bending stiffness", (10.0, 1e6),
        largest(AngularSpring, "angular_springs", "stiffness"), _has_joints, logarithmic=True,
        term="angular stiffness",
    ),
    _setting(
        "angular_damping", "Bending damping", (0.0, 200.0),
        largest(AngularSpring, "angular_springs", "damping"), _has_joints,
        term="angular damping",
    ),
    _setting(
        "rest_length_scale", "Rest length", (0.1, 4.0), at(Scene, "rest_length_scale"), _has_springs,
        logarithmic=True,
    ),
    _setting(
        "rest_angle", "Curl of every joint", (-180.0, 180.0),
        largest(AngularSpring, "angular_springs", "rest_angle")._replace(
            read=_read_rest_angle, write=_write_rest_angle
        ),
        _has_rest_angle,
        term="rest angle",
    ),
    _setting(
        "template", "Template", (-180.0, 180.0),
        Access(-180.0, 180.0, "°", lambda scene: float(scene.template or 0), _write_template),
        lambda scene: _has_joints(scene) and scene.template is not None, integer=True,
    ),
    _setting("tempo", "Tempo", (0.0, 4.0), at(Beat, "beat.frequency"), _has_waves),
    _setting(
        "motor_torque", "Torque of motors", (1e3, 1e7), largest(Motor, "angular_springs", "motor.torque"),
        _has_motors, logarithmic=True,
    ),
    _setting(
        "motor_speed", "Speed of motors", (-1000.0, 1000.0), largest(Motor, "angular_springs", "motor.speed"),
        _has_motors,
    ),
    _setting(
        "gravity", "Gravity", (0.0, 5000.0), Access(-1e6, 1e6, "px/s²", _read_gravity, _write_gravity), moves,
    ),
    _setting("air_friction", "Air friction", (0.0, 0.05), at(Scene, "air_friction"), moves),
    _setting(
        "wind_speed", "Wind speed", (0.0, 3000.0),
        Access(
            0.0, 1e6, "px/s", wind_speed, lambda scene, speed: with_wind(scene, speed, wind_direction(scene))
        ),
        _has_wind,
    ),
    _setting(
        "wind_direction", "Wind direction", (-180.0, 180.0),
        Access(
            -180.0, 180.0, "°", wind_direction, lambda scene, turn: with_wind(scene, wind_speed(scene), turn)
        ),
        _has_wind,
    ),
    _setting("turbulence", "Turbulence", (0.0, 1.0), at(Wind, "wind.turbulence"), _has_wind),
    _setting("drag_across", "Drag across springs", (0.0, 5.0), at(Medium, "medium.across"), _has_medium),
    _setting("drag_along", "Drag along springs", (0.0, 5.0), at(Medium, "medium.along"), _has_medium),
    _setting("ground_forward", "Friction forwards", (0.0, 2.0), at(Ground, "ground.forward"), _has_ground),
    _setting("ground_backward", "Friction backwards", (0.0, 2.0), at(Ground, "ground.backward"), _has_ground),
    _setting("ground_sideways", "Friction sideways", (0.0, 2.0), at(Ground, "ground.sideways"), _has_ground),
    _setting(
        "wall_friction", "Friction of walls", (0.0, 2.0), largest(Wall, "walls", "friction"), _has_walls
    ),
    _setting(
        "static_friction", "Static friction of walls", (0.0, 2.0), largest(Wall, "walls", "static_friction"),
        _has_on_walls("static_friction"),
    ),
    _setting(
        "belt_speed", "Speed of belts", (-1000.0, 1000.0), largest(Wall, "walls", "speed"),
        _has_on_walls("speed"),
    ),
    _setting(
        "bounciness", "Bounciness of walls", (0.0, 1.0), largest(Wall, "walls", "bounciness"), _has_walls,
        remark=_bounces_are_softened,
    ),
    _setting(
        "contact_distance", "Contact distance", (0.0, 40.0), at(Contact, "contact.distance"), _has_contact
    ),
    _setting(
        "contact_stiffness", "Contact stiffness", (10.0, 1e5), at(Contact, "contact.stiffness"), _has_contact,
        logarithmic=True,
    ),
    _setting(
        "contact_friction", "Contact friction", (0.0, 2.0), at(Contact, "contact.friction"), _has_contact
    ),
    _setting(
        "gas_pressure", "Gas pressure", (1.0, 1e4), largest(Gas, "fillings", "pressure"), _has_filling(Gas),
        logarithmic=True,
    ),
    _setting(
        "liquid_stiffness", "Liquid stiffness", (10.0, 1e6), largest(Liquid, "fillings", "bulk_modulus"),
        _has_filling(Liquid), logarithmic=True,
    ),
    _setting(
        "strength", "Strength of springs", (100.0, 1e6), largest(LinearSpring, "linear_springs", "strength"),
        _has_limit("strength"), logarithmic=True,
    ),
    _setting(
        "yield_force", "Yield force", (100.0, 1e6), largest(LinearSpring, "linear_springs", "yield_force"),
        _has_limit("yield_force"), logarithmic=True,
    ),
    _setting("dt", "Time step", (1e-4, 0.01), at(Integrator, "integrator.dt"), moves, logarithmic=True),
    _setting(
        "tolerance", "Tolerance", (1e-6, 10.0), at(Integrator, "integrator.tolerance"),
        lambda scene: moves(scene) and METHODS[scene.integrator.method].adaptive, logarithmic=True,
    ),
)  # fmt: skip

SETTINGS: dict[str, Setting] = {setting.key: setting for setting in _ALL}
"""The settings that any scene may have, by their keys; see `settings_of` for those of its recipes."""

_LINEAR_AIR = replace(SETTINGS["air_friction"], unit="kg/s", slider=(0.0, 25.0))
"""Air friction under the linear law."""

CHOICES: dict[str, Choice] = {
    "force_law": Choice(
        "force_law",
        "Force law",
        {name: law.label for name, law in LAWS.items()},
        lambda scene: scene.force_law,
        replaced("force_law"),
        _has_joints,
    ),
    "restitution": Choice(
        "restitution",
        "Bounces",
        {"viscous": "slow ones lose least", "constant": "all lose alike"},
        lambda scene: touched(scene)[0].restitution,
        with_restitution,
        lambda scene: _has_walls(scene) or _has_contact(scene),
    ),
    "grip": Choice(
        "grip",
        "Friction at rest",
        {"creeps": "creeps", "holds": "holds"},
        lambda scene: "holds" if holds(scene) else "creeps",
        lambda scene, name: with_grip(scene, name == "holds"),
        lambda scene: _has_walls(scene) or _has_contact(scene),
    ),
    "air_law": Choice(
        "air_law",
        "Air brakes",
        {
            "isotropic": "alike in all directions",
            "linear": "in proportion to speed",
            "tutorial": "each axis by itself",
        },
        lambda scene: scene.air_law,
        with_air_law,
        moves,
        shown=lambda scene: scene.air_friction > 0.0,
    ),
    "method": Choice(
        "method",
        "Integrator",
        {name: method.label for name, method in METHODS.items()},
        lambda scene: scene.integrator.method,
        replaced("integrator.method"),
        moves,
    ),
}
"""The choices, by their keys."""

assert set(CHOICES["force_law"].options) == set(get_args(ForceLaw))
assert set(CHOICES["restitution"].options) == set(get_args(Restitution))
assert set(CHOICES["air_law"].options) == set(get_args(AirLaw))


def setting_keys() -> frozenset[str]:
    """Return the keys of all settings that any scene can have, including those of its only recipe."""
    of_recipes = (each.key for kind in get_args(AnyRecipe) for each in settings_of_recipe(kind))
    return frozenset((*SETTINGS, *of_recipes))
