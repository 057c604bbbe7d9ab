"""Changing the shape of a body: moving, mirroring, cutting and bracing."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Sequence

import msgspec
import numpy as np

from ..errors import SceneError
from ..scene.numbers import Vector
from ..scene.recipes.assembly import wrapped
from ..scene.types import Scene
from ..scene.validate import SHORTEST
from ..text import Text
from .build import add_joints, add_springs, angle_between, place, remove
from .edit import Edit, Selection, changed, counted, of_parts, refuse_missing


def move(scene: Scene, masses: Collection[int], by: Vector) -> Edit:
    """Move some masses, at the start and in the present pose; springs keep their rest lengths.

    Raises:
        SceneError: one of them would be out of range, or coincide with another that a spring connects to it.
    """
    dx, dy = by
    return _displaced(scene, dict.fromkeys(masses, (dx, dy)), f"{counted(len(masses), 'mass')} moved")


def mirror(scene: Scene, masses: Collection[int], positions: Sequence[Vector]) -> Edit:
    """Mirror some masses left to right about their middle, and the forces on them; the joints between them
    and their muscles then bend the other way.

    Raises:
        SceneError: one of them would be out of range.
    """
    chosen = sorted(masses)
    if not chosen:
        return Edit("nothing mirrored", scene)
    axis = (min(positions[i][0] for i in chosen) + max(positions[i][0] for i in chosen)) / 2.0
    label = f"{counted(len(chosen), 'mass')} mirrored"
    edit = _displaced(scene, {i: (2.0 * (axis - positions[i][0]), 0.0) for i in chosen}, label)
    inside, scene = set(chosen), edit.scene
    forces = []
    for i in chosen:
        if force := scene.masses[i].force:
            turned_force = (0.0 - force[0], force[1])  # not -0.0, which a file would show
            forces.append((i, msgspec.structs.replace(scene.masses[i], force=turned_force)))
    springs = scene.linear_springs
    turned = []
    for j, joint in enumerate(scene.angular_springs):
        ends = {springs[joint.a].a, springs[joint.a].b, springs[joint.b].a, springs[joint.b].b}
        if ends <= inside:
            muscle = joint.muscle
            if muscle:
                muscle = msgspec.structs.replace(muscle, amplitude=0.0 - muscle.amplitude)
            rest_angle = wrapped(-joint.rest_angle)
            turned.append((j, msgspec.structs.replace(joint, rest_angle=rest_angle, muscle=muscle)))
    joints = changed(scene.angular_springs, turned)
    scene = msgspec.structs.replace(scene, masses=changed(scene.masses, forces), angular_springs=joints)
    return Edit(label, scene, shift=edit.shift)


def _displaced(scene: Scene, by: dict[int, Vector], label: str) -> Edit:
    scene = of_parts(scene)
    refuse_missing(by, len(scene.masses))
    new = []
    for i, (dx, dy) in by.items():
        x, y = scene.masses[i].position
        new.append((i, msgspec.structs.replace(scene.masses[i], position=place((x + dx, y + dy)))))
    pose = scene.pose
    if pose is not None:
        spots = [
            (i, place((pose.positions[i][0] + d[0], pose.positions[i][1] + d[1]))) for i, d in by.items()
        ]
        pose = msgspec.structs.replace(pose, positions=changed(pose.positions, spots))
    moved = msgspec.structs.replace(scene, masses=changed(scene.masses, new), pose=pose)
    _refuse_coincidence(moved, set(by))
    shift = np.zeros((2, len(scene.masses)))
    for i, d in by.items():
        shift[:, i] = d
    return Edit(label, moved, shift=shift)


def _refuse_coincidence(scene: Scene, moved: set[int]) -> None:
    starts: list[Sequence[Vector]] = [[mass.position for mass in scene.masses]]
    if scene.pose is not None:
        starts.append(scene.pose.positions)
    for spring in scene.linear_springs:
        if spring.a in moved or spring.b in moved:
            for at in starts:
                if math.dist(at[spring.a], at[spring.b]) < SHORTEST:
                    raise SceneError(
                        Text(
                            "masses {a} and {b}, which a spring joins, would be in the same place",
                            a=spring.a,
                            b=spring.b,
                        )
                    )


def cut(scene: Scene, stroke: Sequence[Vector], positions: Sequence[Vector]) -> Edit:
    """Remove the springs that a stroke crosses.

    Args:
        scene: the scene to cut.
        stroke: its corners, px; at least two.
        positions: of all masses, px.
    """
    at = np.asarray(positions, float).reshape(-1, 2)
    ends = np.array([(s.a, s.b) for s in scene.linear_springs], np.int64).reshape(-1, 2)
    hit = np.zeros(len(ends), bool)
    a, b = at[ends[:, 0]], at[ends[:, 1]]
    for one, two in itertools.pairwise(stroke):
        start, end = np.array([one], float), np.array([two], float)
        # A corner of the stroke that lies on a spring belongs to one side of it.
        hit |= ((_side(a, b, start) < 0.0) != (_side(a, b, end) < 0.0)) & (
            _side(start, end, a) * _side(start, end, b) < 0.0
        )
    edit = remove(scene, Selection(springs=frozenset(np.flatnonzero(hit).tolist())))
    return Edit(edit.label.replace("removed", "cut"), edit.scene, edit.masses, edit.springs, edit.joints)


def crossing(a: np.ndarray, b: np.ndarray, c: np.ndarray, d: np.ndarray) -> np.ndarray:
    """Return whether segments a to b cross segments c to d; each (k, 2), or (1, 2) for one for all."""
    return (_side(a, b, c) * _side(a, b, d) < 0.0) & (_side(c, d, a) * _side(c, d, b) < 0.0)


def _side(p: np.ndarray, q: np.ndarray, r: np.ndarray) -> np.ndarray:
    """Return by its sign on which side of the line from p to q the points r are; 0 on the line."""
    return (q[:, 0] - p[:, 0]) * (r[:, 1] - p[:, 1]) - (q[:, 1] - p[:, 1]) * (r[:, 0] - p[:, 0])


def add_corners(
    scene: Scene, masses: Collection[int], positions: Sequence[Vector], shift: float = 0.0
) -> Edit:
    """Add angular springs at every corner of some masses, at rest as they are: between springs that are next
    to each other around a mass.

    Args:
        scene: the scene to extend.
        masses: the masses at the corners.
        positions: of all masses, px.
        shift: degrees that keys have added to all rest angles.
    """
    scene = of_parts(scene)
    around: dict[int, list[tuple[float, int]]] = {i: [] for i in masses}
    for s, spring in enumerate(scene.linear_springs):
        for here, there in ((spring.a, spring.b), (spring.b, spring.a)):
            if here in around:
                dx = positions[there][0] - positions[here][0]
                dy = positions[there][1] - positions[here][1]
                around[here].append((math.atan2(dy, dx), s))
    pairs = []
    for spokes in around.values():
        order = [s for _, s in sorted(spokes)]
        pairs += itertools.pairwise(order)
        if len(order) > 2:
            pairs.append((order[-1], order[0]))
    angles = [angle_between(scene, a, b, positions) - shift for a, b in pairs]
    return add_joints(scene, pairs, angles)


def triangulate(
    scene: Scene, masses: Collection[int], positions: Sequence[Vector], scale: float | None = None
) -> Edit:
    """Add springs, at rest as they are, between some masses to triangulate the area between them (Delaunay).

    Where springs between the masses form a closed outline, only its inside is braced. No new spring crosses
    an existing one.

    Args:
        scene: the scene to extend.
        masses: the masses to connect.
        positions: of all masses, px.
        scale: see `add_springs`.

    Raises:
        SceneError: the masses are on one line, or fewer than three.
    """
    from scipy.spatial import Delaunay, QhullError

    scene, chosen = of_parts(scene), sorted(masses)
    at = np.array([positions[i] for i in chosen], float).reshape(-1, 2)
    try:
        triangles = Delaunay(at).simplices if len(chosen) >= 3 else None
    except QhullError:
        triangles = None
    if triangles is None:
        raise SceneError(Text("only three masses or more that are not on one line can be braced"))
    inside = set(chosen)
    present = {frozenset((s.a, s.b)) for s in scene.linear_springs if s.a in inside and s.b in inside}
    outline = _outline(chosen, present)
    every = np.asarray(positions, float).reshape(-1, 2)
    old = np.array([sorted(pair) for pair in present], np.int64).reshape(-1, 2)
    pairs = []
    for i, j in sorted({tuple(sorted((t[k], t[k - 1]))) for t in triangles.tolist() for k in range(3)}):
        a, b = chosen[i], chosen[j]
        if frozenset((a, b)) in present:
            continue
        middle = (every[a] + every[b]) / 2.0
        if outline is not None and not _is_inside(middle, every[outline]):
            continue
        if crossing(every[old[:, 0]], every[old[:, 1]], every[[a]], every[[b]]).any():
            continue
        pairs.append((a, b))
    edit = add_springs(scene, pairs, positions, scale)
    return Edit(f"triangulated: {edit.label}", edit.scene, springs=edit.springs)


def _outline(masses: Sequence[int], pairs: set[frozenset[int]]) -> list[int] | None:
    """Return the masses in order around the closed loop that the springs between them form, or None."""
    beside: dict[int, list[int]] = {i: [] for i in masses}
    for pair in pairs:
        a, b = pair
        beside[a].append(b)
        beside[b].append(a)
    if any(len(two) != 2 for two in beside.values()):
        return None
    loop, before = [masses[0]], -1
    while True:
        after = next(i for i in beside[loop[-1]] if i != before)
        if after == loop[0]:
            return loop if len(loop) == len(masses) else None
        before = loop[-1]
        loop.append(after)


def _is_inside(point: np.ndarray, loop: np.ndarray) -> bool:
    """Return whether a point is inside a polygon, by the crossings of a ray to the right."""
    x, y = point
    after = np.roll(loop, -1, axis=0)
    spans = (loop[:, 1] > y) != (after[:, 1] > y)
    one, two = loop[spans], after[spans]
    at = one[:, 0] + (y - one[:, 1]) / (two[:, 1] - one[:, 1]) * (two[:, 0] - one[:, 0])
    return bool(np.count_nonzero(at > x) % 2)
