"""The surroundings of a body: moving air, a medium, the ground and walls; also fillings and contact."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from .numbers import Index, Length, Speed, Vector, bounded

Pressure = Annotated[float, bounded(0.0, 1e9, "kg/s²", "Pressure")]
STILL_AIR = 1e-6
"""Speed, px/s, below which there is no wind."""

Restitution = Literal["viscous", "constant"]
"""How the fraction of the speed that remains after a bounce depends on the speed; see `Wall`."""

Area = Annotated[float, bounded(1e-6, 1e12, "px²", "An area")]


class Wind(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Moving air; the scene's air friction opposes the velocity relative to it.

    Gusts are frozen eddies carried along by the mean wind (Taylor 1938): a sum of transverse plane waves,
    whose phases and directions follow from the seed (Kraichnan 1970). The air is therefore incompressible but
    not uniform, and the same seed gives the same gusts.

    Attributes:
        velocity: of the mean wind, px/s.
        turbulence: 0..10; the root mean square of each component of the gusts, as a fraction of the speed.
        length_scale: 1..1e5 px, the length of the longest waves.
        seed: 0..1e9, of the gusts.
    """

    velocity: tuple[Speed, Speed]
    turbulence: Annotated[float, bounded(0.0, 10.0, "", "Turbulence")] = 0.0
    length_scale: Annotated[float, bounded(1.0, 1e5, "px", "Length of the gusts")] = 400.0
    seed: Annotated[int, Meta(ge=0, le=10**9)] = 0


class Medium(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A viscous medium around all springs, which resists motion across a spring more than motion along it.

    The force per length of a spring is -across v across it and -along v along it, where v is the velocity
    relative to the medium; half of a spring counts for each end. This is resistive force theory (Gray &
    Hancock 1955), valid for small and slow bodies. The scene's wind moves the medium. For a slender rod,
    `across` is nearly twice `along`.

    Attributes:
        across: 0..1e6 kg/(px s).
        along: 0..1e6 kg/(px s).
    """

    across: Annotated[float, bounded(0.0, 1e6, "kg/(px s)", "Drag across springs")] = 1.0
    along: Annotated[float, bounded(0.0, 1e6, "kg/(px s)", "Drag along springs")] = 0.5


class Ground(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The ground on which all springs lie, in a scene seen from above. Its friction depends on the direction,
    like that of a snake's scales.

    All springs of a mass carry an equal share of its weight. With the weight N on an end of a spring that
    slides at the velocity v, the force on it is -N (sideways v_n n + forward v_t t) / w, across the spring
    and along it, with w = sqrt(|v|² + slip_speed²), and with `backward` where it slides backwards. Forwards
    is from the spring's mass a to its mass b. A mass without springs slides freely.

    Attributes:
        gravity: 0..1e6 px/s², the acceleration that presses all masses onto the ground.
        forward, backward, sideways: 0..100, coefficients of friction.
        slip_speed: 1e-3..1e6 px/s.
    """

    gravity: Annotated[float, bounded(0.0, 1e6, "px/s²", "Gravity onto the ground")] = 1000.0
    forward: Annotated[float, bounded(0.0, 100.0, "", "Friction forwards")] = 0.2
    backward: Annotated[float, bounded(0.0, 100.0, "", "Friction backwards")] = 0.3
    sideways: Annotated[float, bounded(0.0, 100.0, "", "Friction sideways")] = 0.4
    slip_speed: Annotated[float, bounded(1e-3, 1e6, "px/s", "Speed of full friction")] = 10.0


class Wall(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """An infinite straight wall, floor or slope, which pushes back every mass that has entered it, a solid
    mass as soon as its surface has.

    A mass m at the depth d is pushed out with m hardness d² (1 + c s), where s is the speed at which it
    enters, and c follows from the bounciness (Hunt & Crossley 1975). Under gravity g it therefore comes to
    rest at the depth sqrt(g / hardness). Along the wall, a mass that is pushed with N is slowed by friction N
    tanh(s / slip_speed) at the speed s. It therefore creeps even on a slope on which it should stick: the
    smaller the slip speed, the slower. With a tangential hardness it does not creep: a spring of stiffness m
    tangential_hardness holds it where it touched the wall, and it slides as soon as the spring pulls with
    more than friction N (Cundall & Strack 1979), or than static_friction N if there is that: then it slides
    until it turns round. With a speed, the wall is a belt: friction acts against the velocity relative to its
    surface.

    Attributes:
        point: any point of the wall's surface.
        normal: any vector but zero, from the surface to the free side.
        hardness: 1e-3..1e9 1/(px s²), the acceleration at a depth of 1 px.
        friction: 0..100, coefficient of friction.
        bounciness: 0..1; the speed of a mass after a bounce, as a fraction of that before. A fixed-step
            method takes more from a mass so fast that it is deep inside after a step.
        restitution: the speeds at which `bounciness` is exact. "viscous": at 1000 px/s; slower masses keep
            more of their speed, and very slow ones all of it. "constant": at all speeds, by a force that is
            larger while a mass goes in than while it comes out (Walton & Braun 1986). Bouncing masses then
            come to rest; 0.1 is the smallest value distinguished.
        slip_speed: 1e-3..1e6 px/s.
        tangential_hardness: 0..1e9 1/s², the acceleration along the wall at a stretch of 1 px; 0 for creeping
            friction. The stiffness of the wall for a mass at rest under gravity g is 2 sqrt(g hardness).
        static_friction: 0..100, coefficient of friction of a mass that does not slide; one below `friction`
            counts as that. It needs a tangential hardness. Omitted in files if it is that of sliding.
        speed: within ±1e9 px/s, of the surface, positive along (-normal.y, normal.x): to the right on a floor
            where y is down. Omitted in files if the wall is at rest.
    """

    point: Vector
    normal: Vector
    hardness: Annotated[float, bounded(1e-3, 1e9, "1/(px s²)", "Hardness of a wall")] = 8000.0
    friction: Annotated[float, bounded(0.0, 100.0, "", "Coefficient of friction")] = 0.5
    bounciness: Annotated[float, bounded(0.0, 1.0, "", "Bounciness")] = 0.5
    slip_speed: Annotated[float, bounded(1e-3, 1e6, "px/s", "Speed of full friction")] = 10.0
    restitution: Restitution = "viscous"
    tangential_hardness: Annotated[float, bounded(0.0, 1e9, "1/s²", "Tangential hardness of a wall")] = 0.0
    static_friction: (
        Annotated[float, bounded(0.0, 100.0, "", "Coefficient of static friction")] | msgspec.UnsetType
    ) = msgspec.UNSET
    speed: Speed | msgspec.UnsetType = msgspec.UNSET


class Gas(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="kind", tag="gas"):
    """A gas inside a closed loop of masses, at a constant temperature.

    Its pressure is pressure * area / A where the loop's area is A, so that it never vanishes. The force on
    the masses is the pressure, less that outside, times the gradient of A. Below a hundredth of the area, or
    of the loop's own area or a thousandth of its squared perimeter where that is larger, the pressure grows
    linearly, through an area of zero and beyond, where a long time step may lead.

    Attributes:
        masses: indices of the masses around the loop, in order, at least three.
        pressure: 0..1e9 kg/s², force per length, at the given area.
        outside: 0..1e9 kg/s², the pressure outside.
        area: px²; None for the loop's area in the scene.
    """

    masses: tuple[Index, ...]
    pressure: Pressure
    outside: Pressure = 0.0
    area: Area | None = None


class Liquid(
    msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="kind", tag="liquid"
):
    """A liquid inside a closed loop of masses, which resists every change of the loop's area A.

    Its energy is bulk_modulus (A - area)² / (2 area), and its pressure -bulk_modulus (A - area) / area.

    Attributes:
        masses: indices of the masses around the loop, in order, at least three.
        bulk_modulus: 0..1e9 kg/s².
        area: px²; None for the loop's area in the scene.
    """

    masses: tuple[Index, ...]
    bulk_modulus: Pressure
    area: Area | None = None


class Contact(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Contact of bodies with each other and with themselves, so that masses do not pass through springs.

    A mass that comes closer to a linear spring than `distance` is pushed away from it, with the force
    stiffness d² (1 + c s) at the depth d, as by a wall; the opposite force is divided between the spring's
    two masses, more to the nearer one. A mass with the kinetic energy stiffness distance³ / 3 passes through.

    Masses that are solid touch each other where their radii overlap, without friction, as points cannot roll;
    and they touch springs at their radius and `distance`. Without a distance they touch each other only.

    A mass never touches springs attached to it, nor springs and solid masses of its own body (masses
    connected by springs) that are nearer than 1.25 times the distance at which they would touch in the
    scene's initial positions.

    Attributes:
        distance: 0..1e6 px, at which contact with springs begins; 0 for none.
        stiffness: 1e-3..1e12 kg/(px s²).
        friction, bounciness, slip_speed, restitution: as in `Wall`.
        tangential_stiffness: 0..1e12 kg/s², of the tangential springs that make masses stick, see `Wall`; 0
            for creeping friction. The stiffness of a contact under the force N is 2 sqrt(N stiffness).
    """

    distance: Length
    stiffness: Annotated[float, bounded(1e-3, 1e12, "kg/(px s²)", "Stiffness of contact")] = 8000.0
    friction: Annotated[float, bounded(0.0, 100.0, "", "Coefficient of friction")] = 0.5
    bounciness: Annotated[float, bounded(0.0, 1.0, "", "Bounciness")] = 0.5
    slip_speed: Annotated[float, bounded(1e-3, 1e6, "px/s", "Speed of full friction")] = 10.0
    restitution: Restitution = "viscous"
    tangential_stiffness: Annotated[float, bounded(0.0, 1e12, "kg/s²", "Tangential stiffness")] = 0.0


def loop_area(points: Sequence[Vector]) -> float:
    """Return the area inside a closed loop of points, px²."""
    # Relative to one of them, so that it is also exact far from the origin.
    x, y = points[0]
    at = [(p[0] - x, p[1] - y) for p in points]
    return abs(math.fsum(p[0] * q[1] - p[1] * q[0] for p, q in zip(at, at[1:] + at[:1], strict=True))) / 2.0
