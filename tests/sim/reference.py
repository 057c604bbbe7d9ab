"""The tutorial's equations, written down once more: one body at a time, with loops, unit vectors and `math`.

Nothing here is shared with the solver, and nothing is made fast, so that the two can only agree where
both say what the tutorial says.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

AngleLaw = Callable[[float, float, float], float]
"""(sin V, cos V, rest angle in degrees) -> force per stiffness, with the tutorial's minus sign."""


def general_law(sine: float, cosine: float, rest: float) -> float:
    r = rest * math.pi / 180.0
    return -(math.cos(r) * sine - math.sin(r) * cosine)


TEMPLATE_LAWS: dict[int, AngleLaw] = {
    180: lambda sine, cosine, _: sine,
    135: lambda sine, cosine, _: sine + cosine,
    90: lambda sine, cosine, _: cosine,
    45: lambda sine, cosine, _: -sine + cosine,
    0: lambda sine, cosine, _: -sine,
    -45: lambda sine, cosine, _: -sine - cosine,
    -90: lambda sine, cosine, _: -cosine,
    -135: lambda sine, cosine, _: sine - cosine,
}


@dataclass
class Point:
    x: float
    y: float
    mass: float = 1.0
    held: bool = False
    vx: float = 0.0
    vy: float = 0.0
    fx: float = 0.0
    fy: float = 0.0


@dataclass
class Spring:
    a: int
    b: int
    stiffness: float
    damping: float
    rest_length: float
    length: float = 0.0
    ux: float = 0.0
    uy: float = 0.0


@dataclass
class Joint:
    a: int
    b: int
    stiffness: float
    rest_angle: float
    sine: float = 0.0
    cosine: float = 1.0


@dataclass
class Body:
    """A body and its surroundings; `step` is the tutorial's main loop once."""

    points: list[Point]
    springs: list[Spring]
    joints: list[Joint]
    gravity: tuple[float, float] = (0.0, 2000.0)
    air: float = 0.002
    dt: float = 0.0025
    law: AngleLaw = general_law
    mouse: dict[int, tuple[float, float]] = field(default_factory=dict)

    def forces(self) -> None:
        for p in self.points:
            p.fx = p.fy = 0.0
        for s in self.springs:
            a, b = self.points[s.a], self.points[s.b]
            s.length = math.sqrt((b.x - a.x) ** 2 + (b.y - a.y) ** 2)
            s.ux, s.uy = (b.x - a.x) / s.length, (b.y - a.y) / s.length
            rate = s.ux * (b.vx - a.vx) + s.uy * (b.vy - a.vy)
            force = -s.stiffness * (s.length - s.rest_length) - s.damping * rate
            a.fx, a.fy = a.fx - force * s.ux, a.fy - force * s.uy
            b.fx, b.fy = b.fx + force * s.ux, b.fy + force * s.uy
        for j in self.joints:
            s, t = self.springs[j.a], self.springs[j.b]
            j.cosine = s.ux * t.ux + s.uy * t.uy
            j.sine = s.ux * t.uy - s.uy * t.ux
            force = j.stiffness * self.law(j.sine, j.cosine, j.rest_angle)
            # The "weighted average": each spring gets the force times the other's length.
            for spring, share in ((s, force * t.length), (t, -force * s.length)):
                nx, ny = spring.uy, -spring.ux
                a, b = self.points[spring.a], self.points[spring.b]
                a.fx, a.fy = a.fx - share * nx, a.fy - share * ny
                b.fx, b.fy = b.fx + share * nx, b.fy + share * ny

    def step(self, keys: frozenset[str] = frozenset()) -> None:
        for i, (x, y) in self.mouse.items():
            self.points[i].x, self.points[i].y = x, y
        for s in self.springs:
            if "up" in keys:
                s.rest_length *= 1.002
            if "down" in keys:
                s.rest_length /= 1.002
        for j in self.joints:
            if "right" in keys:
                j.rest_angle += 0.1
            if "left" in keys:
                j.rest_angle -= 0.1
            if j.rest_angle > 180.0:
                j.rest_angle -= 360.0
            if j.rest_angle <= -180.0:
                j.rest_angle += 360.0
        self.forces()
        for p in self.points:
            if p.held:
                continue
            p.fx -= self.air * p.vx * abs(p.vx)
            p.fy -= self.air * p.vy * abs(p.vy)
            p.vx += (p.fx / p.mass + self.gravity[0]) * self.dt
            p.vy += (p.fy / p.mass + self.gravity[1]) * self.dt
        for p in self.points:
            if not p.held:
                p.x += p.vx * self.dt
                p.y += p.vy * self.dt

    def positions(self) -> list[tuple[float, float]]:
        return [(p.x, p.y) for p in self.points]


def tutorial_rope(positions: list[tuple[float, float]], held: int, rest_angle: float) -> Body:
    """A row of masses, of which the first few are held, with the constants of all three examples."""
    count = len(positions)
    return Body(
        points=[Point(x, y, held=i < held) for i, (x, y) in enumerate(positions)],
        springs=[Spring(i, i + 1, 10_000.0, 40.0, 300.0 / (count - 1)) for i in range(count - 1)],
        joints=[Joint(i, i + 1, 10_000.0, rest_angle) for i in range(count - 2)],
    )


def example_1() -> Body:
    """The angle test: three masses that are all held."""
    return tutorial_rope([(300.0, 300.0 - 175.0 + 175.0 * i) for i in range(3)], 3, 0.0)


def example_2(template: int) -> Body:
    """The soft rod."""
    positions = [(300.0 + (300.0 / 7.0) * (i - 1), 300.0) for i in range(8)]
    body = tutorial_rope(positions, 2, float(template))
    body.law = TEMPLATE_LAWS[template]
    return body


def example_3() -> Body:
    """The general rest angle."""
    return tutorial_rope([(300.0, 150.0 + (300.0 / 11.0) * (i + 1) - 1.0) for i in range(12)], 1, 0.0)
