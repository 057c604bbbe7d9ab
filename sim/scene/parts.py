"""The components of bodies: masses, linear and angular springs, their muscles, and anchors."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

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

Keys = Literal["left-right", "up-down"]
"""What works a motor, a muscle or a force while it is held: Right, and backwards Left; or Up, and Down."""


class Mass(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
    """A point mass.

    Attributes:
        position: at the start, px, each coordinate within ±1e6.
        velocity: at the start, px/s, each component within ±1e9; ignored while the mass is held.
        mass: 1e-6..1e6 kg.
        radius: 1e-3..1e4 px, with which it is drawn, and touches what it meets if it is solid.
        solid: whether it touches as a ball of its radius: other solid masses, walls, and springs where the
            scene has contact; see `Contact`. Omitted in files if it is a point.
        rail: the direction of a straight rail through it, along which alone it moves, any vector but zero;
            omitted in files if it moves freely. A held mass on a rail is led along it, and goes to and fro on
            it where it has a circle.
        force: a constant force on it (a point load), each component within ±1e15 kg px/s²; omitted in files
            if there is none. A held mass passes it on to its support.
        keys: "left-right" for a force that acts only while Right is held, or the opposite one while Left is;
            "up-down" the same with Up and Down. Omitted in files if the force always acts.
    """

    position: Vector
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    mass: Kilograms = 1.0
    radius: Radius = 6.0
    solid: bool | msgspec.UnsetType = msgspec.UNSET
    rail: Vector | msgspec.UnsetType = msgspec.UNSET
    force: tuple[ForceComponent, ForceComponent] | msgspec.UnsetType = msgspec.UNSET
    keys: Keys | msgspec.UnsetType = msgspec.UNSET


Wave = Literal["sine", "pulse", "steady"]
"""The waveform of a muscle during a beat; see `Muscle`."""


class Muscle(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Makes a spring's rest length or a joint's rest angle oscillate in time with the scene's `Beat`.

    At the phase p the wave "sine" is sin p, and "pulse" is exp(4 (sin p - 1)): it stays near 0 for most of
    the time, and rises to 1 where the sine does. With b(t) the number of beats until time t, p is 2 pi
    (per_beat b(t) + phase / 360°). The wave "steady" is 1.

    A muscle that keys work has an effort e, which comes to 1 while one key is held, to -1 while the other
    is, and else to 0, where the muscle rests. It comes there as 1 - exp(-t / 0.05 s). The wave is multiplied
    by |e|, and runs backwards, with -b(t), where e is below 0; "steady" is multiplied by e.

    Attributes:
        phase: 0..360 °, its lead over the beat.
        wave: its waveform; "steady" is only for muscles that keys work.
        per_beat: 1..16, waves per beat.
        keys: "left-right" for a muscle that works only while Right is held, or backwards while Left is;
            "up-down" the same with Up and Down. Omitted in files if it always works.
    """

    phase: Annotated[float, bounded(0.0, 360.0, "°", "Phase of a muscle")] = 0.0
    wave: Wave = "sine"
    per_beat: Annotated[int, Meta(ge=1, le=16, description="Waves of a muscle in a beat")] = 1
    keys: Keys | msgspec.UnsetType = msgspec.UNSET


class SpringMuscle(Muscle, frozen=True, kw_only=True):
    """The muscle of a linear spring: its rest length is multiplied by 1 + amplitude times the wave.

    Attributes:
        amplitude: -0.9..0.9, as a fraction of the rest length.
    """

    amplitude: Annotated[float, bounded(-0.9, 0.9, "", "Amplitude of a spring's muscle")] = 0.2


class JointMuscle(Muscle, frozen=True, kw_only=True):
    """The muscle of an angular spring: amplitude times the wave is added to its rest angle.

    Attributes:
        amplitude: -180..180 °.
    """

    amplitude: Annotated[float, bounded(-180.0, 180.0, "°", "Amplitude of a joint's muscle")] = 20.0


class Motor(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
    """Turns a joint's second spring against its first, with the torque `torque` tanh((speed - V') / slip) on
    the second one at the rate V' of the joint's angle.

    Attributes:
        speed: -1e5..1e5 °/s, the rate at which the angle should grow.
        torque: 0..1e18 kg px²/s², the largest torque.
        slip: 1e-3..1e5 °/s, how far the rate is off where three quarters of the torque act.
        keys: "left-right" for a motor that turns only while Right is held, or backwards while Left is;
            "up-down" the same with Up and Down. Without a key it holds still. Omitted in files if it always
            turns.
    """

    speed: Annotated[float, bounded(-1e5, 1e5, "°/s", "Speed of a motor")] = 180.0
    torque: Annotated[float, bounded(0.0, 1e18, "kg px²/s²", "Torque of a motor")] = 1e6
    slip: Annotated[float, bounded(1e-3, 1e5, "°/s", "Slip of a motor")] = 20.0
    keys: Keys | msgspec.UnsetType = msgspec.UNSET


def constant_force(mass: Mass) -> tuple[float, float] | None:
    """Return the force that always acts on a mass, kg px/s², or None if there is none."""
    return mass.force if mass.force and not mass.keys else None


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
            springs attached to it break with it.
        yield_force: the force beyond which it is permanently stretched or compressed, changing its rest
            length, 0..1e15 kg px/s², or None if it never is.
        hardening: 0..1e15 kg/s²; increase of the yield force per px of permanent change of the rest length.
        muscle: the muscle that changes its rest length; omitted in files if there is none.
        only: "pull" for a spring that only pulls, like a rope, and exerts nothing where it is shorter than
            its rest length; "push" for one that only pushes; omitted in files if it does both.
    """

    a: Index
    b: Index
    stiffness: Stiffness
    damping: Damping = 0.0
    rest_length: Length
    strength: Force | None = None
    yield_force: Force | None = None
    hardening: Stiffness = 0.0
    muscle: SpringMuscle | msgspec.UnsetType = msgspec.UNSET
    only: Literal["pull", "push"] | msgspec.UnsetType = msgspec.UNSET


class AngularSpring(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
    """A spring that keeps two linear springs, which share a mass, at an angle.

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
        yield_torque: the torque beyond which it is permanently bent, changing its rest angle,
            0..1e18 kg px²/s², or None if it never is.
        muscle: the muscle that changes its rest angle; omitted in files if there is none.
        only: "above" for a stop, which acts only where V - rest_angle is between 0 and 180°, "below" for one
            that acts only where it is between -180° and 0; omitted in files if it acts on both sides.
        motor: what turns it; omitted in files if nothing does.
    """

    a: Index
    b: Index
    stiffness: Stiffness
    damping: Damping = 0.0
    rest_angle: Angle = 0.0
    yield_torque: Annotated[float, bounded(0.0, 1e18, "kg px²/s²", "A torque")] | None = None
    muscle: JointMuscle | msgspec.UnsetType = msgspec.UNSET
    motor: Motor | msgspec.UnsetType = msgspec.UNSET
    only: Literal["above", "below"] | msgspec.UnsetType = msgspec.UNSET


class Beat(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The common beat of all muscles of a scene: frequency t + phase / 360° beats until time t.

    Attributes:
        frequency: 0..100 Hz.
        phase: 0..360 °, at time zero.
    """

    frequency: Annotated[float, bounded(0.0, 100.0, "Hz", "Tempo", slider=(0.0, 4.0))] = 1.0
    phase: Annotated[float, bounded(0.0, 360.0, "°", "Phase of the beat")] = 0.0

    def at_tempo(self, frequency: float, time: float) -> Beat:
        """Return a beat of another frequency, Hz, with the same phase at a time, s."""
        phase = (self.phase + 360.0 * (self.frequency - frequency) * time) % 360.0
        return msgspec.structs.replace(self, frequency=frequency, phase=phase)


class Circle(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The motion of an anchor on a circle.

    At time t the anchor is displaced from its starting position by radius (sin p, 1 - cos p), with the phase
    p = 2 pi frequency (t - ramp (1 - exp(-t / ramp))), so that it starts at rest and speeds up smoothly.

    Attributes:
        radius: 0..1e4 px.
        frequency: -100..100 Hz; negative values run in the opposite direction.
        ramp: 1e-3..100 s, the time constant of its acceleration.
    """

    radius: Annotated[float, bounded(0.0, 1e4, "px", "Radius of an anchor's circle")]
    frequency: Annotated[float, bounded(-100.0, 100.0, "Hz", "Turns per second")] = 1.0
    ramp: Annotated[float, bounded(1e-3, 100.0, "s", "Time in which the motion gets going")] = 0.1


class Anchor(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, gc=False):
    """A held mass: it moves only when dragged, or on its own circle.

    Under the force law "tutorial", the damping of springs treats a dragged mass as being at rest, as the
    tutorial does. In all other cases the velocity of the anchor counts.

    Attributes:
        mass: index of the mass.
        driven: whether the pointer drives it; at most one anchor of a scene is driven.
        circle: its path, or None.
    """

    mass: Index
    driven: bool = False
    circle: Circle | None = None
