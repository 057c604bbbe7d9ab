"""Girders, which are trusses of springs, and suspension bridges."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Literal

from ..numbers import Damping, Kilograms, Radius, Stiffness, Vector, bounded
from ..parts import LinearSpring
from .assembly import Assembly, Jointed, Parts, Size, Sprung

Panels = Annotated[int, bounded(2, 5000, "", "Panels", slider=(2, 20))]
Load = Annotated[float, bounded(0.0, 1e6, "kg", "Load", slider=(0.0, 500.0))]
Strength = Annotated[float, bounded(0.0, 1e15, "kg px/s²", "Strength", slider=(1e3, 1e7), logarithmic=True)]
YieldForce = Annotated[
    float, bounded(0.0, 1e15, "kg px/s²", "Yield force", slider=(1e3, 1e7), logarithmic=True)
]


class Girder(Sprung, frozen=True, kw_only=True):
    """A steel girder: a truss, supported by the two ends of its lower chord, with a load at mid-span.

    Its joints turn freely, so only its triangles make it stable. All members have the same cross-section:
    longer ones are softer. Masses count along the lower chord from its left end, then along the upper one.

    Attributes:
        truss: "warren", of equal triangles, or "pratt", with posts and with diagonals that fall towards
            mid-span.
        panels: 2..5000, of the lower chord.
        span, depth: 1e-3..1e6 px.
        start: of the left support, px; the girder is above it on a screen whose y points down.
        stiffness, damping: of the shortest member, 0..1e15 kg/s² and 0..1e6 kg/s; lower for longer members.
        load: 0..1e6 kg, added to the mass at mid-span of the lower chord, or left of it if the number of
            panels is odd.
        strength, yield_force, hardening: of every member, see `LinearSpring`. Members whose strength is below
            the yield force, or that have no stiffness, do not yield.
    """

    truss: Literal["warren", "pratt"] = "warren"
    panels: Panels = 8
    span: Size = 480.0
    depth: Annotated[float, bounded(1e-3, 1e6, "px", "Depth", slider=(20.0, 150.0))] = 60.0
    start: Vector = (60.0, 300.0)
    stiffness: Stiffness = 200_000.0
    damping: Damping = 400.0
    load: Load = 0.0
    strength: Strength | None = None
    yield_force: YieldForce | None = None
    hardening: Stiffness = 0.0

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        panel, middle = self.span / self.panels, self.panels // 2
        x, y = self.start
        lower = []
        for i in range(self.panels + 1):
            load = self.load if i == middle else 0.0
            radius = 2.0 * self.radius if load else self.radius
            lower.append(body.mass((x + i * panel, y), self.mass + load, radius))
        if self.truss == "warren":
            places = [i + 0.5 for i in range(self.panels)]
        else:
            places = [float(i) for i in range(1, self.panels)]
        upper = [body.mass((x + i * panel, y - self.depth), self.mass, self.radius) for i in places]
        members = [*pairwise(lower), *pairwise(upper)]
        if self.truss == "warren":
            for i, top in enumerate(upper):
                members += [(lower[i], top), (top, lower[i + 1])]
        else:
            members += [(lower[0], upper[0]), (upper[-1], lower[-1])]
            members += zip(lower[1:-1], upper, strict=True)
            for i in range(1, self.panels - 1):
                # Panel i is between posts i and i + 1, which are upper masses i - 1 and i.
                members.append((upper[i - 1], lower[i + 1]) if i < middle else (upper[i], lower[i]))
        lengths = [body.distance(a, b) for a, b in members]
        shortest = min(lengths)
        yield_force, hardening = self.yield_force, self.hardening
        strength = math.inf if self.strength is None else self.strength
        if yield_force is not None and (yield_force > strength or not self.stiffness):
            yield_force, hardening = None, 0.0
        for (a, b), length in zip(members, lengths, strict=True):
            member = LinearSpring(
                a=a,
                b=b,
                stiffness=self.stiffness * (shortest / length),
                damping=self.damping * (shortest / length),
                rest_length=length,
                strength=self.strength,
                yield_force=yield_force,
                hardening=hardening * (shortest / length),
            )
            body.add_spring(member)
        body.hold((lower[0], lower[-1]), self.driven)
        return body.parts()


class Bridge(Jointed, frozen=True, kw_only=True):
    """A suspension bridge: a deck, kept straight by angular springs, hangs from two cables by hangers.

    The ends of the deck and the tops of the two towers above them are held. Masses count along the deck from
    its left end, then along the cable. Initially, all springs are unloaded.

    Attributes:
        panels: 2..5000, of the deck.
        span: 1e-3..1e6 px.
        towers: 1e-3..1e6 px, their height above the deck.
        sag: 0..0.99, how much lower the cable is at mid-span, as a fraction of the height of the towers.
        start: of the left end of the deck, px.
        load: 0..1e6 kg, added to the mass at mid-span of the deck, or left of it if the number of panels is
            odd.
        strength: the force at which a spring breaks, see `LinearSpring`.
    """

    panels: Panels = 16
    span: Size = 480.0
    towers: Size = 140.0
    sag: Annotated[float, bounded(0.0, 0.99, "", "Sag", slider=(0.2, 0.95))] = 0.85
    start: Vector = (60.0, 380.0)
    stiffness: Stiffness = 100_000.0
    damping: Damping = 60.0
    mass: Kilograms = 1.0
    radius: Radius = 5.0
    angular_stiffness: Stiffness = 50_000.0
    load: Load = 0.0
    strength: Strength | None = None

    def expand(self) -> Parts:
        """See `Recipe.expand`."""
        body = Assembly()
        panel, middle = self.span / self.panels, self.panels // 2
        x, y = self.start
        deck, cable = [], []
        for i in range(self.panels + 1):
            load = self.load if i == middle else 0.0
            radius = 2.0 * self.radius if load else self.radius
            deck.append(body.mass((x + i * panel, y), self.mass + load, radius))
        for i in range(self.panels + 1):
            off = 2.0 * i / self.panels - 1.0  # -1 at the left tower, 1 at the right one
            height = self.towers * (1.0 - self.sag * (1.0 - off * off))
            cable.append(body.mass((x + i * panel, y - height), self.mass, self.radius))
        along = [self._spring(body, a, b) for a, b in pairwise(deck)]
        for a, b in (*pairwise(cable), *zip(deck, cable, strict=True)):
            self._spring(body, a, b)
        for a, b in pairwise(along):
            body.joint(a, b, 0.0, self)
        body.hold((deck[0], deck[-1], cable[0], cable[-1]), self.driven)
        return body.parts()

    def _spring(self, body: Assembly, a: int, b: int) -> int:
        return body.add_spring(
            LinearSpring(
                a=a,
                b=b,
                stiffness=self.stiffness,
                damping=self.damping,
                rest_length=body.distance(a, b),
                strength=self.strength,
            )
        )
