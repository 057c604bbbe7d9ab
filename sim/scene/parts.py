"""What bodies are made of: masses, linear springs, angular springs, and anchors that hold masses."""

from __future__ import annotations

from typing import Annotated

import msgspec

from .numbers import (
    Angle,
    Damping,
    Force,
    ForceComponent,
    Index,
    Kilograms,
    Length,
    Radius,
    Speed,
    Stiffness,
    Vector,
    bounded,
)


class Mass(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
    """A point mass.

    Attributes:
        position: at the start, px, each coordinate within ±1e6.
        velocity: at the start, px/s, each component within ±1e9; ignored while the mass is held.
        mass: 1e-6..1e6 kg.
        radius: 1e-3..1e4 px; used for drawing only.
        force: a constant force on it (a point load), each component within ±1e15 kg px/s²; files leave it out
            where there is none. A held mass hands it on to what holds it.
    """

    position: Vector
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    mass: Kilograms = 1.0
    radius: Radius = 6.0
    force: tuple[ForceComponent, ForceComponent] | msgspec.UnsetType = msgspec.UNSET


class LinearSpring(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
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


class AngularSpring(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
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


class Anchor(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
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
