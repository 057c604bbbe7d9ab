"""Bodies moved by muscles: worm, swimmer, walker, heart and hand. They follow the scene's beat."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated

from ..numbers import Damping, Kilograms, Radius, Stiffness, Vector, bounded
from ..parts import AngularSpring, JointMuscle, LinearSpring, SpringMuscle
from ..surroundings import Gas, Pressure
from .assembly import Assembly, Jointed, Parts, Size, Sprung, wrapped

Links = Annotated[int, bounded(3, 5000, "", "Masses", slider=(8, 60))]
Length = Annotated[float, bounded(1e-3, 1e6, "px", "Length", slider=(100.0, 500.0))]
Swing = Annotated[float, bounded(0.0, 180.0, "°", "Swing of the body", slider=(0.0, 120.0))]
Waves = Annotated[float, bounded(-20.0, 20.0, "", "Waves along the body", slider=(-3.0, 3.0))]


class Undulating(Jointed, frozen=True, kw_only=True):
    """The common basis of swimmers and worms: a row of masses along which a bending wave travels.

    Spring s connects masses s and s + 1, and angular spring j springs j and j + 1. Mass 0 is the tail.

    Attributes:
        masses: 3..5000.
        length: 1e-3..1e6 px.
        start: x of mass 0 and y of the lowest one on a screen whose y points down, px.
        swing: 0..180 °; the largest angle by which the direction of the body swings to either side.
        waves: -20..20, number along the body; they travel from tail to head, or backwards if negative.
    """

    masses: Links = 24
    length: Length = 300.0
    start: Vector = (150.0, 300.0)
    swing: Swing = 45.0
    waves: Waves = 1.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body, spacing, n = Assembly(), self.length / (self.masses - 1), self.masses
        # If spring s swings by sin(p - s step), a joint bends by the difference of two such waves, also a
        # wave.
        step = 360.0 * self.waves / (n - 1)
        amplitude = min(2.0 * self.swing * abs(math.sin(math.radians(0.5 * step))), 180.0)
        phases = [(-step * j - (90.0 if step < 0.0 else -90.0)) % 360.0 for j in range(n - 2)]
        turn = -self.swing * math.sin(math.radians(0.5 * step))
        (x, y), places = (0.0, 0.0), [(0.0, 0.0)]
        for bend in (*(amplitude * math.sin(math.radians(phase)) for phase in phases), 0.0):
            x, y = x + spacing * math.cos(math.radians(turn)), y + spacing * math.sin(math.radians(turn))
            places.append((x, y))
            turn += bend
        lowest = max(y for _, y in places)
        for x, y in places:
            body.mass((self.start[0] + x, self.start[1] + y - lowest), self.mass, self.radius)
        for i in range(n - 1):
            body.spring(i, i + 1, self.stiffness, self.damping, spacing)
        for j, phase in enumerate(phases):
            body.add_joint(
                AngularSpring(
                    a=j,
                    b=j + 1,
                    stiffness=self.angular_stiffness,
                    damping=self.angular_damping,
                    rest_angle=self.bend,
                    muscle=JointMuscle(amplitude=amplitude, phase=phase),
                )
            )
        body.hold((), self.driven)
        return body.parts()


class Swimmer(Undulating, frozen=True, kw_only=True):
    """A swimmer like a sperm or an eel, in a medium with more resistance across than along it.

    A wave travelling from head to tail propels it forwards.
    """

    waves: Waves = -1.2
    stiffness: Stiffness = 20_000.0
    damping: Damping = 20.0
    mass: Kilograms = 0.1
    radius: Radius = 5.0
    angular_stiffness: Stiffness = 40_000.0


class Worm(Undulating, frozen=True, kw_only=True):
    """A worm that creeps over a floor like a caterpillar: arches travel along it, and it moves with them."""

    masses: Links = 30
    start: Vector = (60.0, 500.0)
    swing: Swing = 45.0
    waves: Waves = 2.0
    stiffness: Stiffness = 50_000.0
    damping: Damping = 60.0
    mass: Kilograms = 0.2
    radius: Radius = 7.0
    angular_stiffness: Stiffness = 40_000.0
    angular_damping: Damping = 200.0


class Walker(Sprung, frozen=True, kw_only=True):
    """A walker: a stiff body on pairs of legs. The two muscles of a leg move its foot along a loop.

    Masses count along the lower side of the body from its left end, then along the upper one; then come the
    feet. The legs of a pair move alternately, as do those of neighbouring pairs.

    Attributes:
        pairs: 2..1000, of legs.
        length, height: 1e-3..1e6 px, of the body.
        legs: 1e-3..1e6 px, their length.
        start: of the left end of its lower side, px; the feet are below it on a screen whose y points down.
        stride: 0..0.9; the fraction of their length by which a leg's muscles lengthen and shorten.
    """

    pairs: Annotated[int, bounded(2, 1000, "", "Pairs of legs", slider=(2, 6))] = 3
    length: Length = 260.0
    height: Size = 40.0
    legs: Annotated[float, bounded(1e-3, 1e6, "px", "Length of legs", slider=(30.0, 200.0))] = 75.0
    start: Vector = (60.0, 418.0)
    stride: Annotated[float, bounded(0.0, 0.9, "", "Stride", slider=(0.0, 0.4))] = 0.14
    stiffness: Stiffness = 30_000.0
    damping: Damping = 150.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body, count = Assembly(), 2 * self.pairs
        panel = self.length / (count - 1)
        x, y = self.start
        lower = [body.mass((x + i * panel, y), self.mass, self.radius) for i in range(count)]
        upper = [
            body.mass((x + (i + 0.5) * panel, y - self.height), self.mass, self.radius)
            for i in range(count - 1)
        ]
        members = [*pairwise(lower), *pairwise(upper)]
        for i, top in enumerate(upper):
            members += [(lower[i], top), (top, lower[i + 1])]
        for a, b in members:
            body.spring(a, b, self.stiffness, self.damping)
        for pair in range(self.pairs):
            hips = lower[2 * pair], lower[2 * pair + 1]
            for leg in range(2):
                phases = [(180.0 * (leg + pair) - 90.0 * side) % 360.0 for side in range(2)]
                rest = math.hypot(0.5 * panel, self.legs)
                left, right = (rest * (1.0 + self.stride * math.sin(math.radians(p))) for p in phases)
                aside = 0.5 * (panel + (left - right) * (left + right) / panel)
                below = math.sqrt(max(left * left - aside * aside, 0.0))
                foot = body.mass((x + 2 * pair * panel + aside, y + below), self.mass, self.radius)
                for hip, phase in zip(hips, phases, strict=True):
                    body.add_spring(
                        LinearSpring(
                            a=hip,
                            b=foot,
                            stiffness=self.stiffness,
                            damping=self.damping,
                            rest_length=rest,
                            muscle=SpringMuscle(amplitude=self.stride, phase=phase),
                        )
                    )
        body.hold((), self.driven)
        return body.parts()


class Heart(Jointed, frozen=True, kw_only=True):
    """A heart: a heart-shaped skin, filled with a gas. The skin contracts everywhere at each beat.

    Masses count clockwise on a screen whose y points down, from the notch.

    Attributes:
        masses: 8..5000, around the skin.
        width: 1e-3..1e6 px.
        center: px.
        squeeze: 0..0.9; the fraction of its length by which each spring is shortened.
        spread: 0..1; the delay of the tip relative to the notch, as a fraction of a beat.
        pressure, outside: 0..1e9 kg/s², of the gas inside at rest, and of that outside.
    """

    masses: Annotated[int, bounded(8, 5000, "", "Masses around", slider=(12, 80))] = 40
    width: Annotated[float, bounded(1e-3, 1e6, "px", "Width", slider=(60.0, 400.0))] = 240.0
    center: Vector = (300.0, 280.0)
    squeeze: Annotated[float, bounded(0.0, 0.9, "", "Squeeze", slider=(0.0, 0.6))] = 0.3
    spread: Annotated[float, bounded(0.0, 1.0, "", "Delay of the tip", slider=(0.0, 0.5))] = 0.12
    pressure: Pressure = 250.0
    outside: Pressure = 200.0
    stiffness: Stiffness = 8000.0
    damping: Damping = 60.0
    mass: Kilograms = 0.2
    radius: Radius = 5.0
    angular_stiffness: Stiffness = 24_000.0
    angular_damping: Damping = 60.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body, n = Assembly(), self.masses
        at = [_heart(i / n) for i in range(n)]
        for px, py in at:
            place = self.center[0] + 0.5 * self.width * px, self.center[1] + 0.5 * self.width * py
            body.mass(place, self.mass, self.radius)
        turns = []
        for i in range(n):
            (x0, y0), (x1, y1) = at[i], at[(i + 1) % n]
            turns.append(math.degrees(math.atan2(y1 - y0, x1 - x0)))
            down = (0.5 * (y0 + y1) - at[0][1]) / (at[n // 2][1] - at[0][1])
            body.add_spring(
                LinearSpring(
                    a=i,
                    b=(i + 1) % n,
                    stiffness=self.stiffness,
                    damping=self.damping,
                    rest_length=body.distance(i, (i + 1) % n),
                    muscle=SpringMuscle(
                        amplitude=-self.squeeze, wave="pulse", phase=(-360.0 * self.spread * down) % 360.0
                    ),
                )
            )
        for i in range(n):
            body.joint(i, (i + 1) % n, wrapped(turns[(i + 1) % n] - turns[i]), self)
        body.fill(Gas(masses=tuple(range(n)), pressure=self.pressure, outside=self.outside))
        body.hold((), self.driven)
        return body.parts()


def _heart(part: float) -> Vector:
    """Return a point on the outline of a heart of half width 1, at a fraction of the way round."""
    t = math.tau * part
    x = math.sin(t) ** 3
    y = -(13.0 * math.cos(t) - 4.0 * math.cos(2.0 * t) - 2.0 * math.cos(3.0 * t) - math.cos(4.0 * t)) / 16.0
    return x, y


class Hand(Jointed, frozen=True, kw_only=True):
    """A hand that closes its two fingers on a ball, lifts it, and releases it.

    Masses count along the palm from its left end, along the left finger, along the right one, and then
    around the ball. The palm is held.

    Attributes:
        links: 1..1000, springs of each finger.
        finger: 1e-3..1e6 px, its length.
        palm: 1e-3..1e6 px, its width.
        ball: 1e-3..1e6 px, the diameter of the ball.
        curl: 0..360 °, by which a whole finger bends.
        center: of the palm, px; the fingers are below it on a screen whose y points down.
    """

    links: Annotated[int, bounded(1, 1000, "", "Springs of a finger", slider=(2, 10))] = 6
    finger: Annotated[float, bounded(1e-3, 1e6, "px", "Length of a finger", slider=(50.0, 300.0))] = 190.0
    palm: Annotated[float, bounded(1e-3, 1e6, "px", "Width of the palm", slider=(40.0, 250.0))] = 120.0
    ball: Annotated[float, bounded(1e-3, 1e6, "px", "Diameter of the ball", slider=(20.0, 200.0))] = 90.0
    curl: Annotated[float, bounded(0.0, 360.0, "°", "Curl of a finger", slider=(0.0, 270.0))] = 150.0
    center: Vector = (300.0, 295.0)
    stiffness: Stiffness = 30_000.0
    damping: Damping = 40.0
    mass: Kilograms = 0.5
    angular_stiffness: Stiffness = 30_000.0
    angular_damping: Damping = 300.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body, (x, y) = Assembly(), self.center
        link, half = self.finger / self.links, 0.5 * self.palm
        palm = [body.mass((x + side * half, y), self.mass, self.radius) for side in (-1.0, 1.0)]
        across = body.spring(palm[0], palm[1], self.stiffness, self.damping)
        for base, side in zip(palm, (-1.0, 1.0), strict=True):
            before, last = across, base
            at, turn = x + side * half, 90.0
            for i in range(self.links):
                tip = body.mass((at, y + (i + 1) * link), self.mass, self.radius)
                bone = body.spring(last, tip, self.stiffness, self.damping)
                half_curl = side * 0.5 * self.curl / self.links
                body.add_joint(
                    AngularSpring(
                        a=before,
                        b=bone,
                        stiffness=self.angular_stiffness,
                        damping=self.angular_damping,
                        rest_angle=wrapped(turn + half_curl + self.bend),
                        muscle=JointMuscle(amplitude=half_curl, phase=270.0),
                    )
                )
                before, last, turn = bone, tip, 0.0
        around = 16
        ring = [
            body.mass(
                (
                    x + 0.5 * self.ball * math.sin(math.tau * i / around),
                    y + 1.05 * self.finger - 0.5 * self.ball * (1.0 + math.cos(math.tau * i / around)),
                ),
                0.2 * self.mass,
                self.radius,
            )
            for i in range(around)
        ]
        skin = [
            body.spring(a, b, self.stiffness, self.damping)
            for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
        ]
        for a, b in zip(skin, skin[1:] + skin[:1], strict=True):
            body.joint(a, b, 360.0 / around, self)
        body.hold((palm[0], palm[1]), self.driven)
        return body.parts()
