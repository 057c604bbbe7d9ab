"""Copying parts of a scene, within it and into another."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import msgspec

from ..errors import SceneError
from ..scene.numbers import MAX_MASSES, MAX_SPRINGS, Vector
from ..scene.parts import Anchor, AngularSpring, LinearSpring, Mass
from ..scene.sentences import in_words
from ..scene.types import Scene
from ..scene.validate import validate
from .build import place
from .edit import Edit, added, counted, of_parts, refuse_missing, with_added

MAX_FRAGMENT_BYTES = 2_000_000
"""Size of the largest text that is pasted."""


class Fragment(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag="softrod-fragment"):
    """Masses, the springs and joints among them, and which are held; indices count from 0.

    Attributes:
        masses: about the middle of their bounding box, px.
        springs, joints: among them.
        held: indices of held masses.
    """

    masses: tuple[Mass, ...]
    springs: tuple[LinearSpring, ...] = ()
    joints: tuple[AngularSpring, ...] = ()
    held: tuple[int, ...] = ()


def copy(scene: Scene, masses: Collection[int], positions: Sequence[Vector]) -> Fragment:
    """Some masses as they are now, at rest, with the springs and joints among them.

    Raises:
        SceneError: there are none, or one does not exist.
    """
    chosen = sorted(masses)
    refuse_missing(chosen, len(scene.masses))
    if not chosen:
        raise SceneError("nothing is selected that could be copied")
    scene = of_parts(scene)
    middle = [
        (min(positions[i][k] for i in chosen) + max(positions[i][k] for i in chosen)) / 2.0 for k in (0, 1)
    ]
    at = {old: new for new, old in enumerate(chosen)}
    replace = msgspec.structs.replace
    kept = [s for s, spring in enumerate(scene.linear_springs) if spring.a in at and spring.b in at]
    spring_at = {old: new for new, old in enumerate(kept)}
    held = {anchor.mass for anchor in scene.anchors}
    return Fragment(
        masses=tuple(
            replace(
                scene.masses[i],
                position=(positions[i][0] - middle[0], positions[i][1] - middle[1]),
                velocity=(0.0, 0.0),
            )
            for i in chosen
        ),
        springs=tuple(
            replace(spring, a=at[spring.a], b=at[spring.b])
            for spring in (scene.linear_springs[s] for s in kept)
        ),
        joints=tuple(
            replace(joint, a=spring_at[joint.a], b=spring_at[joint.b])
            for joint in scene.angular_springs
            if joint.a in spring_at and joint.b in spring_at
        ),
        held=tuple(at[i] for i in chosen if i in held),
    )


def paste(scene: Scene, fragment: Fragment, at: Vector) -> Edit:
    """A fragment with its middle at a place, px.

    Raises:
        SceneError: it would be out of range, or too much for one scene.
    """
    scene = of_parts(scene)
    x, y = place(at)
    n, s = len(scene.masses), len(scene.linear_springs)
    if n + len(fragment.masses) > MAX_MASSES:
        raise SceneError(f"a scene has {MAX_MASSES} masses at most")
    if s + len(fragment.springs) > MAX_SPRINGS:
        raise SceneError(f"a scene has {MAX_SPRINGS} springs at most")
    if len(scene.angular_springs) + len(fragment.joints) > MAX_SPRINGS:
        raise SceneError(f"a scene has {MAX_SPRINGS} angular springs at most")
    replace = msgspec.structs.replace
    new = with_added(
        scene,
        masses=[
            replace(mass, position=place((mass.position[0] + x, mass.position[1] + y)))
            for mass in fragment.masses
        ],
        springs=[replace(spring, a=spring.a + n, b=spring.b + n) for spring in fragment.springs],
        joints=[replace(joint, a=joint.a + s, b=joint.b + s) for joint in fragment.joints],
    )
    new = replace(new, anchors=(*scene.anchors, *(Anchor(mass=n + i) for i in fragment.held)))
    return Edit(
        f"{counted(len(fragment.masses), 'mass')} pasted",
        new,
        added(n, len(fragment.masses)),
        added(s, len(fragment.springs)),
        added(len(scene.angular_springs), len(fragment.joints)),
    )


def encode(fragment: Fragment) -> str:
    """A fragment as text, for a clipboard."""
    return msgspec.json.encode(fragment).decode()


def decode(text: str) -> Fragment:
    """The fragment in a text, which may come from anywhere.

    Raises:
        SceneError: one sentence; it is not a fragment, or not one of a valid body.
    """
    data = text.encode("utf-8", "replace")
    if len(data) > MAX_FRAGMENT_BYTES:
        raise SceneError(f"{len(data)} bytes are more than the {MAX_FRAGMENT_BYTES} that can be pasted")
    try:
        fragment = msgspec.json.decode(data, type=Fragment)
    except (msgspec.DecodeError, RecursionError) as error:
        raise SceneError(f"this cannot be pasted: {in_words(str(error))}") from None
    try:
        # A scene of its own, so that whatever could be wrong with it is found.
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
        raise SceneError(f"this cannot be pasted: {error}") from None
    return fragment
