"""Copying parts of a scene, within it and into another."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import msgspec

from ..errors import SceneError
from ..scene.numbers import Vector
from ..scene.parts import Anchor, AngularSpring, Beat, LinearSpring, Mass
from ..scene.types import Scene
from ..scene.validate import validate
from ..store.places import sentence_of_json
from ..text import Text
from .build import place
from .edit import Edit, Selection, counted, of_parts, refuse_missing, with_added, without

MAX_FRAGMENT_BYTES = 2_000_000
"""Largest size of a pasted text, bytes."""


class Fragment(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag="softrod-fragment"):
    """Masses, the springs and joints between them, and which are held; indices count from 0.

    Attributes:
        masses: positioned about the centre of their bounding box, px.
        springs, joints: between them.
        held: indices of held masses.
    """

    masses: tuple[Mass, ...]
    springs: tuple[LinearSpring, ...] = ()
    joints: tuple[AngularSpring, ...] = ()
    held: tuple[int, ...] = ()


def copy(scene: Scene, masses: Collection[int], positions: Sequence[Vector]) -> Fragment:
    """Copy some masses where they are now, at rest, with the springs and joints between them.

    Raises:
        SceneError: there are none, or one does not exist.
    """
    chosen = sorted(masses)
    refuse_missing(chosen, len(scene.masses))
    if not chosen:
        raise SceneError(Text("nothing is selected that could be copied"))
    others = frozenset(range(len(scene.masses))).difference(chosen)
    left, *_ = without(of_parts(scene), Selection(masses=others))
    places = [positions[i] for i in chosen]
    x, y = ((min(along) + max(along)) / 2.0 for along in zip(*places, strict=True))
    return Fragment(
        masses=tuple(
            msgspec.structs.replace(mass, position=(at[0] - x, at[1] - y), velocity=(0.0, 0.0))
            for mass, at in zip(left.masses, places, strict=True)
        ),
        springs=left.linear_springs,
        joints=left.angular_springs,
        held=tuple(sorted(anchor.mass for anchor in left.anchors)),
    )


def paste(scene: Scene, fragment: Fragment, at: Vector) -> Edit:
    """Paste a fragment with its centre at a position, px; a fragment with muscles adds a beat if needed.

    Raises:
        SceneError: it would be out of range, or too large for one scene.
    """
    scene = of_parts(scene)
    if not scene.beat and any(part.muscle for part in (*fragment.springs, *fragment.joints)):
        scene = msgspec.structs.replace(scene, beat=Beat())
    x, y = place(at)
    n, s = len(scene.masses), len(scene.linear_springs)
    replace = msgspec.structs.replace
    return with_added(
        f"{counted(len(fragment.masses), 'mass')} pasted",
        scene,
        masses=[
            replace(mass, position=place((mass.position[0] + x, mass.position[1] + y)))
            for mass in fragment.masses
        ],
        springs=[replace(spring, a=spring.a + n, b=spring.b + n) for spring in fragment.springs],
        joints=[replace(joint, a=joint.a + s, b=joint.b + s) for joint in fragment.joints],
        anchors=[Anchor(mass=n + i) for i in fragment.held],
    )


def encode(fragment: Fragment) -> str:
    """Return a fragment as text, for a clipboard."""
    return msgspec.json.encode(fragment).decode()


def decode(text: str) -> Fragment:
    """Return the fragment in a text, which may come from anywhere.

    Raises:
        SceneError: it is not a fragment, or not one of a valid body; one sentence.
    """
    data = text.encode("utf-8", "replace")
    if len(data) > MAX_FRAGMENT_BYTES:
        raise SceneError(
            Text(
                "{count} bytes are more than the {most} that can be pasted",
                count=len(data),
                most=MAX_FRAGMENT_BYTES,
            )
        )
    try:
        fragment = msgspec.json.decode(data, type=Fragment)
    except (msgspec.DecodeError, RecursionError) as error:
        raise SceneError(
            Text("this cannot be pasted: {error}", error=sentence_of_json(error, data, Fragment))
        ) from None
    try:
        # As a separate scene, so that any error in it is found.
        validate(
            Scene(
                name="fragment",
                masses=fragment.masses,
                linear_springs=fragment.springs,
                angular_springs=fragment.joints,
                anchors=tuple(Anchor(mass=i) for i in fragment.held),
            )
        )
    except SceneError as error:
        raise SceneError(Text("this cannot be pasted: {error}", error=str(error))) from None
    return fragment
