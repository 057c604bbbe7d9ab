"""The scene: what a user edits, saves and shares.

A scene is frozen. Lengths are in the scene's own unit (`View.unit`, pixels in the tutorial), masses in
kilograms, times in seconds, angles in degrees; forces follow (kg px/s²). The type of every number states its
range, from which validation, error messages and JSON Schema are derived.
"""

from __future__ import annotations

import math
from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from .numbers import (
    MAX_MASSES,
    Angle,
    Coordinate,
    Damping,
    Force,
    Index,
    Kilograms,
    Length,
    Name,
    Radius,
    Speed,
    Stiffness,
    Vector,
    bounded,
)
from .surroundings import Contact, Gas, Liquid, Wall, Wind

FORMAT_VERSION = 2
"""Version of the file format that this release writes; older files are read, newer ones are refused."""

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
"""The integration method; `sim.methods.registry` describes each."""

Template = Literal[180, 135, 90, 45, 0, -45, -90, -135]
"""The tutorial's eight rest angles, degrees."""


class Mass(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A point mass.

    Attributes:
        position: at the start, px, each coordinate within ±1e6.
        velocity: at the start, px/s, each component within ±1e9; ignored while the mass is held.
        mass: 1e-6..1e6 kg.
        radius: 1e-3..1e4 px; used for drawing only.
    """

    position: Vector
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    mass: Kilograms = 1.0
    radius: Radius = 6.0


class LinearSpring(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A damped spring along the line from mass `a` to mass `b`.

    The force along the line is -stiffness (|L| - rest_length) - damping (u . dv), with the vector L from a to
    b, its unit vector u, and the relative velocity dv.

    Attributes:
        a, b: indices of two different masses.
        stiffness: 0..1e15 kg/s² (newtons per metre if a px is a metre).
        damping: 0..1e6 kg/s.
        rest_length: 0..1e6 px.
        strength: the force at which it breaks, 0..1e15 kg px/s², or None if it never does. The angular
            springs that hold it break with it.
        yield_force: the force beyond which it is stretched or squeezed for good, so that its rest length
            follows, 0..1e15 kg px/s², or None if it never is.
        hardening: 0..1e15 kg/s²; by how much the yield force grows per px by which the rest length has moved.
    """

    a: Index
    b: Index
    stiffness: Stiffness
    damping: Damping = 0.0
    rest_length: Length
    strength: Force | None = None
    yield_force: Force | None = None
    hardening: Stiffness = 0.0


class AngularSpring(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A spring that holds two linear springs, which share a mass, at an angle.

    V is the angle from spring `a` to spring `b`, positive from +x towards +y. Opposite torques act on the two
    springs. Their size depends on the scene's force law:

    - "tutorial": stiffness |L_a| |L_b| sin(V - rest_angle), without forces along the springs. This is not the
      gradient of any energy.
    - "conservative": the gradient of stiffness |L_a| |L_b| (1 - cos(V - rest_angle)), which is the same
      torque and a pull along each spring.
    - "angle": the gradient of stiffness |L_a| |L_b| (V - rest_angle)² / 2; it jumps where V is opposite to
      the rest angle.

    Under every law, damping adds a torque of damping |L_a| |L_b| dV/dt.

    Attributes:
        a, b: indices of two linear springs that share exactly one mass.
        stiffness: 0..1e15 kg/s².
        damping: 0..1e6 kg/s.
        rest_angle: -180..180 °.
        yield_torque: the torque beyond which it is bent for good, so that its rest angle follows,
            0..1e18 kg px²/s², or None if it never is.
    """

    a: Index
    b: Index
    stiffness: Stiffness
    damping: Damping = 0.0
    rest_angle: Angle = 0.0
    yield_torque: Annotated[float, bounded(0.0, 1e18, "kg px²/s²", "A torque")] | None = None


class Circle(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The motion of an anchor that goes round a circle.

    At time t the anchor is displaced from its starting position by radius (sin p, 1 - cos p), with the phase
    p = 2 pi frequency (t - ramp (1 - exp(-t / ramp))), so that it starts at rest and speeds up smoothly.

    Attributes:
        radius: 0..1e4 px.
        frequency: -100..100 Hz; negative values run in the opposite direction.
        ramp: 1e-3..100 s, the time constant with which it speeds up.
    """

    radius: Annotated[float, bounded(0.0, 1e4, "px", "Radius of an anchor's circle")]
    frequency: Annotated[float, bounded(-100.0, 100.0, "Hz", "Turns per second")] = 1.0
    ramp: Annotated[float, bounded(1e-3, 100.0, "s", "Time in which the motion gets going")] = 0.1


class Anchor(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A mass that is held: it moves only when it is dragged, or on its own circle.

    Under the force law "tutorial", the damping of springs treats a dragged mass as being at rest, as the
    tutorial does. In all other cases the velocity of the anchor counts.

    Attributes:
        mass: index of the mass.
        driven: whether the pointer drives it; at most one anchor of a scene is driven.
        circle: the circle that it moves on, or None.
    """

    mass: Index
    driven: bool = False
    circle: Circle | None = None


class Rope(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The recipe of a straight rope, from which the masses, springs and anchors of a scene are made.

    Mass i starts at `start` + (i + offset) * length / (masses - 1) * direction / |direction|. Linear
    spring s joins masses s and s + 1; angular spring j joins linear springs j and j + 1.

    Attributes:
        masses: 2..20000.
        length: 1e-3..1e6 px; every linear spring's rest length is length / (masses - 1).
        start: px.
        offset: -1000..1000; shifts the whole rope by that many spring lengths.
        direction: any vector but zero.
        stiffness, damping: of every linear spring, 0..1e15 kg/s² and 0..1e6 kg/s.
        angular_stiffness, angular_damping: of every angular spring, 0..1e15 kg/s² and 0..1e6 kg/s.
        rest_angle: of every angular spring, -180..180 °.
        joints: whether there are angular springs; with a stiffness of 0 they only measure angles.
        mass, radius: of every mass, kg and px.
        held: indices of masses that are held.
        driven: index of the held mass that the pointer drives, or None.
        circle: motion of mass 0, if it is held, or None.
    """

    masses: Annotated[int, Meta(ge=2, le=MAX_MASSES)] = 12
    length: Annotated[float, bounded(1e-3, 1e6, "px", "Length of the rope")] = 300.0
    start: Vector = (0.0, 0.0)
    offset: Annotated[float, bounded(-1000.0, 1000.0, "springs", "Shift in spring lengths")] = 0.0
    direction: Vector = (1.0, 0.0)
    stiffness: Stiffness = 10_000.0
    damping: Damping = 40.0
    angular_stiffness: Stiffness = 10_000.0
    angular_damping: Damping = 0.0
    rest_angle: Angle = 0.0
    joints: bool = True
    mass: Kilograms = 1.0
    radius: Radius = 6.0
    held: tuple[Index, ...] = (0,)
    driven: Index | None = None
    circle: Circle | None = None


class Integrator(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The integration method and its parameters.

    Attributes:
        method: see `sim.methods.registry`. "auto" keeps to the tolerance and chooses other methods by itself;
            "symplectic_euler" is the tutorial's.
        dt: 1e-6..1 s. The step of a method with a fixed step. Adaptive methods choose their own steps; for
            them `dt` is only the unit in which the clock advances.
        tolerance: 1e-12..1e3 px; the position error that adaptive methods aim at after one second.
    """

    method: Method = "auto"
    dt: Annotated[float, bounded(1e-6, 1.0, "s", "Time step")] = 0.0025
    tolerance: Annotated[float, bounded(1e-12, 1e3, "px", "Tolerance of the error control")] = 0.1


class ArrowKeys(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What a held arrow key does, per `interval` of simulated time.

    Attributes:
        rest_length_factor: 1..2; Up multiplies every rest length by it, Down divides.
        rest_angle_step: 0..90 °; Right adds it to every rest angle, Left subtracts, wrapped into (-180, 180].
        interval: 1e-6..10 s.
    """

    rest_length_factor: Annotated[float, bounded(1.0, 2.0, "", "Factor of Up and Down")] = 1.002
    rest_angle_step: Annotated[float, bounded(0.0, 90.0, "°", "Step of Left and Right")] = 0.1
    interval: Annotated[float, bounded(1e-6, 10.0, "s", "Simulated time per factor or step")] = 0.0025


Readout = Literal["sine", "cosine", "radians", "degrees", "rest_angle"]
"""What the page can show of a joint's angle."""


class View(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How the scene is shown.

    Attributes:
        y_down: whether y grows downwards on the screen, as in the tutorial.
        unit: label of the unit of length.
        frame: the region shown initially, (x min, y min, x max, y max) in px.
        colors: the colour scheme: softrod's own, or the tutorial's green springs and red masses.
        readouts: what is shown of a joint's angle.
    """

    y_down: bool = True
    unit: Annotated[str, Meta(min_length=1, max_length=8)] = "px"
    frame: tuple[Coordinate, Coordinate, Coordinate, Coordinate] = (0.0, 0.0, 600.0, 600.0)
    colors: Literal["softrod", "tutorial"] = "softrod"
    readouts: tuple[Readout, ...] = ("degrees", "rest_angle")


class Pose(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Positions and velocities of all masses, saved from a running simulation.

    Attributes:
        positions: one per mass, px.
        velocities: one per mass, px/s.
    """

    positions: tuple[Vector, ...]
    velocities: tuple[tuple[Speed, Speed], ...]


class Scene(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A body, its surroundings, and how it is solved and shown.

    The body is given either by its masses, springs and anchors, or by the recipe `rope`. A recipe is expanded
    when the scene is made, so that code can always read the masses and springs.

    Attributes:
        format: version of the file format, 2.
        name: 1..60 characters.
        description: what the scene shows, at most 2000 characters.
        rope: the recipe, or None.
        masses, linear_springs, angular_springs, anchors: the body.
        fillings: gases and liquids in closed loops of masses.
        gravity: acceleration, px/s², each component within ±1e6; +y is down where `view.y_down`.
        air_friction: 0..1000 kg/px; the force on each axis is -air_friction v |v|.
        wind: air that moves, or None.
        walls: walls, floors and slopes.
        contact: contact of bodies with each other and with themselves, or None.
        rest_length_scale: 0.01..100; multiplies every rest length.
        template: one of the tutorial's eight rest angles for every joint, or None. The angular springs
            must then have that rest angle. The diagonal templates are sqrt(2) times as stiff as the general
            law.
        force_law: the force law of the angular springs, see `AngularSpring`.
        integrator, arrow_keys, view: see their types; without `arrow_keys` the keys have no effect.
        pose: a saved state to start from, or None to start from the masses' own positions.
    """

    format: Annotated[int, Meta(ge=1)] = FORMAT_VERSION
    name: Name
    description: Annotated[str, Meta(max_length=2000)] = ""
    rope: Rope | None = None
    masses: tuple[Mass, ...] = ()
    linear_springs: tuple[LinearSpring, ...] = ()
    angular_springs: tuple[AngularSpring, ...] = ()
    anchors: tuple[Anchor, ...] = ()
    fillings: tuple[Gas | Liquid, ...] = ()
    gravity: Annotated[Vector, Meta(description="Acceleration of gravity (px/s²)")] = (0.0, 0.0)
    air_friction: Annotated[float, bounded(0.0, 1000.0, "kg/px", "Air friction")] = 0.0
    wind: Wind | None = None
    walls: tuple[Wall, ...] = ()
    contact: Contact | None = None
    rest_length_scale: Annotated[float, bounded(0.01, 100.0, "", "Factor of all rest lengths")] = 1.0
    template: Template | None = None
    force_law: ForceLaw = "conservative"
    integrator: Integrator = Integrator()
    arrow_keys: ArrowKeys | None = None
    view: View = View()
    pose: Pose | None = None

    def __post_init__(self) -> None:
        # Every scene is made here, those from files included, so this is where a recipe is expanded.
        if self.rope is not None and not self.masses:
            try:
                body = expand_rope(self.rope)
            except (ArithmeticError, AttributeError, TypeError, ValueError):
                return  # the validation says what is wrong with the recipe
            for field, value in zip(BODY_FIELDS, body, strict=True):
                msgspec.structs.force_setattr(self, field, value)


def is_surrounded(scene: Scene) -> bool:
    """Whether anything acts on a scene's masses besides springs, still air and gravity."""
    touches = scene.contact is not None and scene.contact.distance > 0.0 and bool(scene.linear_springs)
    return bool(scene.walls or scene.fillings or touches or (scene.wind and scene.air_friction > 0.0))


BODY_FIELDS = ("masses", "linear_springs", "angular_springs", "anchors")
"""The fields of a scene that its recipe determines."""


def expand_rope(
    rope: Rope,
) -> tuple[tuple[Mass, ...], tuple[LinearSpring, ...], tuple[AngularSpring, ...], tuple[Anchor, ...]]:
    """The masses, linear springs, angular springs and anchors of a recipe.

    Raises:
        ArithmeticError, TypeError, ValueError: the recipe is not valid.
    """
    n = rope.masses
    if not 2 <= n <= MAX_MASSES:
        raise ValueError("the number of masses is out of range")
    spacing = rope.length / (n - 1)
    dx, dy = rope.direction
    norm = math.hypot(dx, dy)
    dx, dy = dx / norm, dy / norm
    masses = tuple(
        Mass(
            position=(
                rope.start[0] + spacing * (i + rope.offset) * dx,
                rope.start[1] + spacing * (i + rope.offset) * dy,
            ),
            mass=rope.mass,
            radius=rope.radius,
        )
        for i in range(n)
    )
    linear = tuple(
        LinearSpring(a=s, b=s + 1, stiffness=rope.stiffness, damping=rope.damping, rest_length=spacing)
        for s in range(n - 1)
    )
    angular = tuple(
        AngularSpring(
            a=j,
            b=j + 1,
            stiffness=rope.angular_stiffness,
            damping=rope.angular_damping,
            rest_angle=rope.rest_angle,
        )
        for j in range(n - 2 if rope.joints else 0)
    )
    # A recipe with fewer masses keeps the anchors whose masses still exist.
    held = {i for i in rope.held if i < n}
    if rope.driven is not None and rope.driven < n:
        held.add(rope.driven)
    anchors = tuple(
        Anchor(mass=i, driven=i == rope.driven, circle=rope.circle if i == 0 else None) for i in sorted(held)
    )
    return masses, linear, angular, anchors
