"""Hands on the body: pointers, the arrow keys, and a mass that is clicked."""

from __future__ import annotations

from typing import ClassVar

from ...session import commands
from ...session.session import Session
from ...stage.sketch import Mapping
from ...ui import readouts
from ...ui.commands import Row
from ...ui.feature import Feature
from ...wire.messages import FromPage
from .messages import At, Drop, Grab, Keys, Pick


def hand_commands(said: FromPage, mapping: Mapping) -> list[commands.Command]:
    """The commands of a message about hands and held keys; none for others."""
    match said:
        case At(hands):
            return [commands.Point(*mapping.to_scene(x, y), hand) for hand, x, y in hands]
        case Grab(hand, mass, x, y):
            return [commands.DragStart(mass, *mapping.to_scene(x, y), hand)]
        case Drop(hand):
            return [commands.DragEnd(hand)]
        case Keys(held):
            return [commands.HoldKeys(frozenset(held))]
        case _:
            return []


def _show_help(_: Session, feature: Feature) -> None:
    feature.page.perform("help")


class HandsFeature(Feature):
    """Moves the masses that a page's hands hold, and shows the joint of a mass that is clicked."""

    messages: ClassVar = {At: "", Grab: "", Drop: "", Keys: "", Pick: ""}
    commands: ClassVar = {
        "body": Row("own", ("Tab",)),
        "lengths": Row(_show_help, ("↑ ↓",), held=True),
        "angles": Row(_show_help, ("→ ←",), held=True),
    }

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        if isinstance(said, Pick):
            self.page.soon(lambda: self._pick(said.mass))
        for command in hand_commands(said, self.page.mapping):
            self.session.post(command)

    def _pick(self, mass: int) -> None:
        """Show the angle of a mass's joint."""
        scene = self.session.scene
        if mass < len(scene.masses) and (joint := readouts.joint_of_mass(scene, mass)) is not None:
            self.session.post(commands.SelectJoint(joint))
