"""The scene: what a user edits, saves and shares.

A scene is frozen. Lengths are in the scene's own unit (`View.unit`, pixels in the tutorial), masses in
kilograms, times in seconds, angles in degrees; forces follow (kg px/s²). The type of every number states its
range, from which validation, error messages and JSON Schema are derived.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta

from .columns import has_any, is_set_in_any
from .lesson import Lesson
from .numbers import Angle, Coordinate, Force, Index, Name, Speed, Vector, bounded, of_python
from .parts import Anchor, AngularSpring, Beat, LinearSpring, Mass
from .parts import Circle as Circle
from .recipes.recipe import AnyRecipe, expand
from .recipes.recipe import Rope as Rope
from .surroundings import Contact, Gas, Ground, Liquid, Medium, Wall, Wind

FORMAT_VERSION = 4
"""Version of the file format that this release writes; it reads older files and refuses newer ones."""

AirLaw = Literal["isotropic", "tutorial", "linear"]
"""How air friction depends on the velocity relative to the air; see `Scene`."""

ForceLaw = Literal["tutorial", "conservative", "angle"]
"""The force law of the angular springs; see `AngularSpring`."""

Method = Literal[
    "auto",
    "symplectic_euler",
    "velocity_verlet",
    "rk4",
    "generalized_alpha",
    "stable_spring",
    "adams",
    "rodas4",
    "rodas5p",
]
"""The integration method; `sim.solve.registry` describes each."""

Template = Literal[180, 135, 90, 45, 0, -45, -90, -135]
"""The tutorial's eight rest angles, degrees."""


class Integrator(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The integration method and its parameters.

    Attributes:
        method: see `sim.solve.registry`. "auto" meets the tolerance, choosing other methods by itself;
            "symplectic_euler" is the tutorial's.
        dt: 1e-6..1 s. The step of a fixed-step method. Adaptive methods choose their own steps; for them `dt`
            is only the unit in which the clock advances.
        tolerance: 1e-12..1e3 px; the target position error of adaptive methods after one second.
    """

    method: Method = "auto"
    dt: Annotated[float, bounded(1e-6, 1.0, "s", "Time step")] = 0.0025
    tolerance: Annotated[float, bounded(1e-12, 1e3, "px", "Tolerance of the error control")] = 0.1


class ArrowKeys(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The effect of a held arrow key, per `interval` of simulated time.

    Attributes:
        rest_length_factor: 1..2; Up multiplies every rest length by it, Down divides.
        rest_angle_step: 0..90 °; Right adds it to every rest angle, Left subtracts, wrapped into (-180, 180].
        interval: 1e-6..10 s.
    """

    rest_length_factor: Annotated[float, bounded(1.0, 2.0, "", "Factor of Up and Down")] = 1.002
    rest_angle_step: Annotated[float, bounded(0.0, 90.0, "°", "Step of Left and Right")] = 0.1
    interval: Annotated[float, bounded(1e-6, 10.0, "s", "Simulated time per factor or step")] = 0.0025


Readout = Literal["sine", "cosine", "radians", "degrees", "rest_angle", "stability"]
"""Readouts of a joint's angle on the page, and of the time step relative to the stability limit."""


Control = Annotated[str, Meta(min_length=1, max_length=80)]
"""The name of a control of the page, which knows them all."""


class View(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How the scene is shown.

    Attributes:
        y_down: whether y grows downwards on the screen, as in the tutorial.
        unit: label of the unit of length.
        frame: the region shown initially, (x min, y min, x max, y max) in px.
        colors: the colour scheme: softrod's own, or the tutorial's green springs and red masses.
        readouts: what is shown of a joint's angle; with "stability", the stability meter is always shown,
            too.
        controls: names of the page's controls, in order; None for all.
    """

    y_down: bool = True
    unit: Annotated[str, Meta(min_length=1, max_length=8)] = "px"
    frame: tuple[Coordinate, Coordinate, Coordinate, Coordinate] = (0.0, 0.0, 600.0, 600.0)
    colors: Literal["softrod", "tutorial"] = "softrod"
    readouts: tuple[Readout, ...] = ("degrees", "rest_angle")
    controls: Annotated[tuple[Control, ...], Meta(max_length=100)] | None = None


class Damage(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Everything that has yielded or broken in a running simulation. Tuples without such parts are empty.

    Attributes:
        broken: indices of the broken linear springs, ascending.
        set_lengths: permanent change of the rest length of each linear spring, px.
        hardened: increase of the yield force of each linear spring, kg px/s².
        set_angles: permanent change of the rest angle of each angular spring, degrees.
    """

    broken: tuple[Index, ...] = ()
    set_lengths: tuple[Coordinate, ...] = ()
    hardened: tuple[Force, ...] = ()
    set_angles: tuple[Angle, ...] = ()


class Grips(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The tangential springs by which friction holds touching masses, see `Wall` and `Contact`.

    Attributes:
        walls: for each, the wall, the mass, and the stretch along the wall, px.
        springs: for each, the linear spring, the touching mass, and the stretch, px.
        sliding: the wall and the mass of each on a wall with static friction that slides; omitted in files if
            there are none.
    """

    walls: tuple[tuple[Index, Index, Coordinate], ...] = ()
    springs: tuple[tuple[Index, Index, Coordinate], ...] = ()
    sliding: tuple[tuple[Index, Index], ...] | msgspec.UnsetType = msgspec.UNSET


class Pose(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Positions and velocities of all masses, saved from a running simulation.

    Attributes:
        positions: one per mass, px.
        velocities: one per mass, px/s.
        damage: everything that has yielded or broken, or None.
        grips: the tangential springs of sticking friction, or None.
    """

    positions: tuple[Vector, ...]
    velocities: tuple[tuple[Speed, Speed], ...]
    damage: Damage | None = None
    grips: Grips | None = None


class Scene(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, weakref=True):
    """A body, its surroundings, and how it is solved and shown.

    The body is given either by masses, springs, anchors and fillings, or by recipes: `bodies`, and `links`
    between them. Recipes are expanded when the scene is made, so that code can always read the masses and
    springs.

    Attributes:
        format: version of the file format, 4.
        name: 1..60 characters.
        title: the name shown in lists of scenes, at most 60 characters; empty for its name.
        description: what the scene shows, at most 2000 characters.
        bodies: the recipes; the masses and springs of each follow those of the previous one.
        links: linear springs between masses of the bodies; they follow all others.
        masses, linear_springs, angular_springs, anchors: the body.
        fillings: gases and liquids in closed loops of masses.
        gravity: acceleration, px/s², each component within ±1e6; +y is down where `view.y_down`.
        air_friction: 0..1000 kg/px, or kg/s under the linear law; see `air_law`.
        air_law: how air friction depends on the velocity v relative to the air. "isotropic":
            -air_friction |v| v, the same in all directions; "tutorial": the same on each axis by itself;
            "linear": -air_friction v, with kg/s.
        wind: moving air, or None.
        medium: a viscous medium around all springs, which the wind moves; omitted in files if there is none.
        ground: ground below all springs of a scene seen from above; omitted in files if there is none.
        walls: walls, floors and slopes.
        contact: contact of bodies with each other and with themselves, or None; solid masses touch each other
            even so, with the numbers of an empty `Contact`.
        rest_length_scale: 0.01..100; multiplies every rest length.
        beat: the common beat of all muscles, which rest without one; omitted in files if there is none.
        template: one of the tutorial's eight rest angles for every joint, or None. The angular springs must
            then have that rest angle. The diagonal templates are sqrt(2) times as stiff as the general law.
        force_law: the force law of the angular springs, see `AngularSpring`.
        integrator, arrow_keys, view: see their types; without `arrow_keys` the keys have no effect.
        pose: a saved state to start from, or None to start from the masses' own positions.
        lesson: steps to follow beside the body, or None.
    """

    format: Annotated[int, Meta(ge=1)] = FORMAT_VERSION
    name: Name
    title: Annotated[str, Meta(max_length=60)] = ""
    description: Annotated[str, Meta(max_length=2000)] = ""
    bodies: tuple[AnyRecipe, ...] = ()
    links: tuple[LinearSpring, ...] = ()
    masses: tuple[Mass, ...] = ()
    linear_springs: tuple[LinearSpring, ...] = ()
    angular_springs: tuple[AngularSpring, ...] = ()
    anchors: tuple[Anchor, ...] = ()
    fillings: tuple[Gas | Liquid, ...] = ()
    gravity: Annotated[Vector, Meta(description="Acceleration of gravity (px/s²)")] = (0.0, 0.0)
    air_friction: Annotated[float, bounded(0.0, 1000.0, "kg/px", "Air friction")] = 0.0
    air_law: AirLaw = "isotropic"
    wind: Wind | None = None
    medium: Medium | msgspec.UnsetType = msgspec.UNSET
    ground: Ground | msgspec.UnsetType = msgspec.UNSET
    walls: tuple[Wall, ...] = ()
    contact: Contact | None = None
    rest_length_scale: Annotated[float, bounded(0.01, 100.0, "", "Factor of all rest lengths")] = 1.0
    beat: Beat | msgspec.UnsetType = msgspec.UNSET
    template: Template | None = None
    force_law: ForceLaw = "conservative"
    integrator: Integrator = Integrator()
    arrow_keys: ArrowKeys | None = None
    view: View = View()
    pose: Pose | None = None
    lesson: Lesson | None = None

    def __post_init__(self) -> None:
        # Every scene is made here, including those from files, so this is where recipes are expanded.
        if self.bodies and not self.masses:
            try:
                # A recipe may contain anything until checked; out of its ranges, it could take forever.
                msgspec.convert(msgspec.to_builtins(self.bodies, enc_hook=of_python), tuple[AnyRecipe, ...])
                body = expand(self.bodies, self.links)
            except (ArithmeticError, AttributeError, TypeError, ValueError):
                return  # validation reports what is wrong with the recipe
            for field, value in zip(BODY_FIELDS, body, strict=True):
                msgspec.structs.force_setattr(self, field, value)


def shown_name(scene: Scene) -> str:
    """Return a scene's displayed name: a preset's title, or the name under which it is saved."""
    return scene.title or scene.name


def is_windy(scene: Scene) -> bool:
    """Return whether a scene has wind, and air friction or a medium through which it acts."""
    return scene.wind is not None and bool(scene.air_friction > 0.0 or scene.medium)


def is_loaded(scene: Scene) -> bool:
    """Return whether a constant force acts on any mass."""
    return any(mass.force and not mass.keys for mass in scene.masses)


def is_pushed(scene: Scene) -> bool:
    """Return whether keys work a force on any mass."""
    return is_set_in_any(scene.masses, "keys")


def steered_by(scene: Scene) -> set[str]:
    """Return the pairs of keys that work motors, muscles or forces of a scene, as in "left-right"."""
    springs, joints = scene.linear_springs, scene.angular_springs
    works = [(joints, "motor"), *(((springs, "muscle"), (joints, "muscle")) if scene.beat else ())]
    pairs = {mass.keys for mass in scene.masses if mass.keys} if is_pushed(scene) else set[str]()
    for parts, field in works:
        if is_set_in_any(parts, field):
            pairs |= {has.keys for part in parts if (has := getattr(part, field)) and has.keys}
    return pairs


def keys_of(scene: Scene) -> tuple[str, ...]:
    """Return the arrow keys that do anything in a scene, as in ("left", "right")."""
    pairs = {"up-down", "left-right"} if scene.arrow_keys is not None else steered_by(scene)
    return tuple(key for pair in sorted(pairs) for key in pair.split("-"))


def is_muscular(scene: Scene) -> bool:
    """Return whether muscles move any of a scene's springs or joints."""
    return bool(scene.beat) and any(
        part.muscle for parts in (scene.linear_springs, scene.angular_springs) for part in parts
    )


def is_damageable(scene: Scene) -> bool:
    """Return whether any spring of a scene can break or yield."""
    springs, joints = scene.linear_springs, scene.angular_springs
    return has_any(springs, "strength") or has_any(springs, "yield_force") or has_any(joints, "yield_torque")


def rebuilt(scene: Scene, **changes: Any) -> Scene:
    """Return the scene with other recipes or links and the resulting body, not yet validated.

    A saved pose is kept unless the number of masses changes.
    """
    made = msgspec.structs.replace(scene, **dict.fromkeys(BODY_FIELDS, ()), pose=None, **changes)
    pose = scene.pose if len(made.masses) == len(scene.masses) else None
    return msgspec.structs.replace(made, pose=pose)


BODY_FIELDS = ("masses", "linear_springs", "angular_springs", "anchors", "fillings")
"""The fields of a scene that its recipes determine, in the order of `Parts`."""
