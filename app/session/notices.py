"""Notices that a page shows its user once."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import sim
from sim.settings import SETTINGS

from ..words import decimal, find, say
from ..words.english import of, sentence
from ..words.keys import Key

About = Literal["runaway", "shape"]


@dataclass(frozen=True)
class Notice:
    """A notice, shown once.

    Attributes:
        kind: how bad it is.
        title, text: what it says.
        about: a condition that may end: a body that ran away, or a shape that cannot be kept. The page shows
            one such notice at most, and removes it when the condition ends.
    """

    kind: Literal["error", "warning", "info"]
    title: str
    text: str
    about: About | None = None


def runaway_notice(divergence: sim.Divergence, scene: sim.Scene) -> Notice:
    """The notice that the simulation of a scene has stopped."""
    stability, step = divergence.stability, decimal(f"{divergence.dt:.3g}")
    cause, limit = stability.cause, decimal(f"{stability.limit:.2g}")
    if cause is None or divergence.dt <= stability.limit:
        most = decimal(f"{divergence.limit:,.0f}")
        text = say(
            "session-exploded.otherwise",
            step=str(divergence.step),
            what=say(_WHAT[divergence.quantity], mass=str(divergence.mass), limit=most),
            why=say(_why(divergence)),
            remedy=say(_remedy(divergence)),
        )
    else:
        called = find(f"session-cause-{cause.replace(' ', '-')}", cause)
        setting = SETTINGS.get(cause.replace(" ", "_"))
        if setting is None:
            text = say("session-exploded.part", step=step, limit=limit, part=called)
        else:
            value = decimal(f"{setting.read(scene):g}")
            text = say("session-exploded.setting", step=step, limit=limit, setting=called, value=value)
    return Notice("error", say("session-exploded"), text, "runaway")


def shape_notice(error: sim.DesignError) -> Notice:
    """The notice that a body cannot keep its shape."""
    why = sentence(of(error.sentence))
    if error.stiffening is None:
        text = say("session-shape.text" if error.motion is None else "session-shape.line", why=why)
    else:
        times = decimal(f"{float(f'{error.stiffening:.3g}'):g}")  # as the button has it
        text = say(
            "session-shape.button" if error.motion is None else "session-shape.both", why=why, times=times
        )
    return Notice("error", say("session-shape"), text, "shape")


_WHAT: dict[str, Key] = {
    "number": "session-what-number",
    "position": "session-what-position",
    "step": "session-what-step",
    "speed": "session-what-speed",
}


def _why(divergence: sim.Divergence) -> Key:
    """The likely cause where the time step was below the stability limit."""
    if divergence.adaptive:
        return "session-why-law" if divergence.driven else "session-why-violent"
    if math.isinf(divergence.stability.limit):
        return "session-why-violent-step"
    return "session-why-small-law" if divergence.driven else "session-why-small"


def _remedy(divergence: sim.Divergence) -> Key:
    """What helps a body that ran away though the time step was below the stability limit."""
    if divergence.driven:
        # No step is small enough for a law that creates energy.
        return "session-remedy-law"
    return "session-remedy-gently" if divergence.adaptive else "session-remedy-step"
