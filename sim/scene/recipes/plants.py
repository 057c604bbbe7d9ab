"""Bodies that grow from a root: hair and trees."""

from __future__ import annotations

import math
from typing import Annotated

from ..numbers import Damping, Index, Kilograms, Radius, Stiffness, Vector, bounded
from .assembly import Assembly, Jointed, Parts


class HairTuft(Jointed, frozen=True, kw_only=True):
    """Hairs on a root of two held masses. An angular spring keeps each at its angle to the root.

    The root points up a screen whose y points down. Masses count from its foot, then along each hair.

    Attributes:
        hairs: 1..5000.
        masses: 2..5000, of each hair.
        length: 1e-3..1e6 px, of each hair.
        spread: 0..360 °, between the first and the last hair.
        root: 1e-3..1e6 px, length of the root.
        start: of its foot, px.
        taper: 0..1; the fraction by which a hair's last angular spring is less stiff than its first.
    """

    hairs: Annotated[int, bounded(1, 5000, "", "Hairs", slider=(1, 25))] = 7
    masses: Annotated[int, bounded(2, 5000, "", "Masses of a hair", slider=(2, 16))] = 8
    length: Annotated[float, bounded(1e-3, 1e6, "px", "Length of a hair", slider=(50.0, 400.0))] = 272.0
    spread: Annotated[float, bounded(0.0, 360.0, "°", "Spread", slider=(0.0, 300.0))] = 120.0
    root: Annotated[float, bounded(1e-3, 1e6, "px", "Length of the root")] = 40.0
    start: Vector = (300.0, 480.0)
    taper: Annotated[float, bounded(0.0, 1.0, "", "Taper", slider=(0.0, 1.0))] = 0.7
    stiffness: Stiffness = 5000.0
    damping: Damping = 6.0
    mass: Kilograms = 0.25
    radius: Radius = 4.0
    angular_stiffness: Stiffness = 1500.0
    driven: Index | None = 0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        x, y = self.start
        foot = body.mass((x, y), self.mass, 2.0 * self.radius)
        top = body.mass((x, y - self.root), self.mass, 2.0 * self.radius)
        root = body.spring(foot, top, self.stiffness, self.damping, self.root)
        spacing = self.length / self.masses
        angles = [self.spread * (i / max(self.hairs - 1, 1) - 0.5) for i in range(self.hairs)]
        for angle in angles if self.hairs > 1 else [0.0]:
            dx, dy = math.sin(math.radians(angle)), -math.cos(math.radians(angle))
            before, spring, turn = top, root, angle
            for i in range(self.masses):
                place = (x + (i + 1) * spacing * dx, y - self.root + (i + 1) * spacing * dy)
                tip = body.mass(place, self.mass, self.radius)
                following = body.spring(before, tip, self.stiffness, self.damping, spacing)
                left = 1.0 - self.taper * i / (self.masses - 1)
                body.joint(spring, following, turn, self, self.angular_stiffness * left)
                before, spring, turn = tip, following, 0.0
        body.hold((foot, top), self.driven)
        return body.parts()


class Tree(Jointed, frozen=True, kw_only=True):
    """A tree that forks again and again into thinner and shorter branches, clamped by its two lowest masses.

    It points up a screen whose y points down. Masses count along the trunk from its foot, then along each
    branch, fork by fork.

    Attributes:
        forks: 0..12, number of forks along each way up.
        branches: 1..10 at each fork.
        segments: 1..1000 springs along the trunk and along each branch.
        length: 1e-3..1e6 px, of the trunk.
        shrink: 0.1..1, length of a branch relative to that of its parent.
        spread: 0..340 °, between the first and the last branch of a fork.
        thinning: 0.01..1; the mass of each point, the linear stiffness and the damping of a branch are those
            of its parent times this, and its angular stiffness times the square of this.
        start: of its foot, px.
    """

    forks: Annotated[int, bounded(0, 12, "", "Forks", slider=(0, 5))] = 4
    branches: Annotated[int, bounded(1, 10, "", "Branches of a fork", slider=(1, 4))] = 2
    segments: Annotated[int, bounded(1, 1000, "", "Segments of a branch", slider=(1, 6))] = 3
    length: Annotated[float, bounded(1e-3, 1e6, "px", "Length of the trunk", slider=(40.0, 250.0))] = 140.0
    shrink: Annotated[float, bounded(0.1, 1.0, "", "Shrink", slider=(0.4, 1.0))] = 0.8
    spread: Annotated[float, bounded(0.0, 340.0, "°", "Spread", slider=(0.0, 180.0))] = 60.0
    thinning: Annotated[float, bounded(0.01, 1.0, "", "Thinning", slider=(0.2, 1.0))] = 0.6
    start: Vector = (300.0, 570.0)
    stiffness: Stiffness = 50_000.0
    damping: Damping = 60.0
    angular_stiffness: Stiffness = 30_000.0
    angular_damping: Damping = 20.0
    driven: Index | None = None

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        radius = self.radius
        foot = body.mass(self.start, self.mass, radius)
        tips = [(foot, -1, self.start, 0.0)]
        angles = [
            self.spread * (i / (self.branches - 1) - 0.5) if self.branches > 1 else 0.0
            for i in range(self.branches)
        ]
        for level in range(self.forks + 1):
            thin, spacing = self.thinning**level, self.length * self.shrink**level / self.segments
            grown = []
            for before, trunk, place, direction in tips:
                for turn in angles if level else [0.0]:
                    tip, spring, bent, point = before, trunk, turn, place
                    heading = math.radians(direction + turn)
                    dx, dy = spacing * math.sin(heading), -spacing * math.cos(heading)
                    for i in range(1, self.segments + 1):
                        point = (place[0] + i * dx, place[1] + i * dy)
                        new = body.mass(point, self.mass * thin, radius * math.sqrt(thin))
                        added = body.spring(tip, new, self.stiffness * thin, self.damping * thin, spacing)
                        if spring >= 0:
                            body.joint(spring, added, bent, self, self.angular_stiffness * thin**2)
                        tip, spring, bent = new, added, 0.0
                    grown.append((tip, spring, point, direction + turn))
            tips = grown
        body.hold((0, 1), self.driven)
        return body.parts()
