"""Notices that a page shows its user once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import sim
from sim.settings import SETTINGS

from ..words import number, say

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
    limit, cause = divergence.stability.limit, divergence.stability.cause
    if cause is not None and divergence.dt > limit:
        setting = SETTINGS.get(cause.replace(" ", "_"))
        value = f"{cause} {setting.read(scene):g}" if setting else f"the stiffness of the {cause}"
        remedy = "lower either of them" if setting else "lower it or choose the integrator Auto"
        text = (
            f"Time step {divergence.dt:.3g} s is above the stability limit {limit:.2g} s at {value}. "
            f"The last good state is shown. Go back to just before it, {remedy}, and go on; or press Reset."
        )
    else:
        text = (
            f"{_capitalized(str(divergence))}. The last good state is shown. Go back to "
            f"just before it, {_remedy(divergence)}, and go on; or press Reset."
        )
    return Notice("error", "The body exploded", text, "runaway")


def shape_notice(error: sim.DesignError) -> Notice:
    """The notice that a body cannot keep its shape."""
    text = f"{_capitalized(error.sentence)}."
    if error.motion is not None:
        text += f" {say('session-no-shape.line')}"
    if error.stiffening is not None:
        text += f" {say('session-no-shape.stiffen', times=number(error.stiffening))}"
    return Notice("error", say("session-no-shape"), text, "shape")


def _capitalized(sentence: str) -> str:
    return sentence[:1].upper() + sentence[1:]


def _remedy(divergence: sim.Divergence) -> str:
    """What helps a body that ran away though the time step was below the stability limit."""
    if divergence.driven:
        # No step is small enough for a law that creates energy.
        return "move it more gently, raise the damping or choose another force law"
    if divergence.adaptive:
        return "move it more gently or raise the damping"
    return "lower the time step, choose the integrator Auto, raise the damping or move it more gently"
