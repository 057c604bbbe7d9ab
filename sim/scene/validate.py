"""Validation: refuses every scene that cannot be simulated, with one sentence that names the field.

Types and ranges are annotations in `sim.scene.types`, which msgspec reads, so a scene made in code must
satisfy the same limits as one read from a file.
"""

from __future__ import annotations

import math
import re
import weakref
from collections.abc import Iterator
from typing import get_type_hints

import msgspec

from ..errors import SceneError, no_part, of_field, span
from ..text import Text
from .columns import is_set_in_any
from .lesson import StepRun, texts_of
from .numbers import MAX_MASSES, MAX_SPRINGS, annotation_of, of_python
from .parts import AngularSpring
from .recipes.assembly import TooLarge
from .recipes.recipe import expand
from .sentences import difference, sentence, unit_of
from .surroundings import loop_area
from .types import BODY_FIELDS, FORMAT_VERSION, Pose, Scene

SHORTEST = 1e-9
"""Distance, px, below which the ends of a spring count as coincident: the spring would have no direction.
Doubled or halved, no test fails."""

_valid: dict[int, weakref.ref[Scene]] = {}
"""Scenes found valid, by id, as long as they exist: a scene is frozen, with all its contents. Most come here
more than once: from the function that made them, and from a simulation."""

_writer, _reader = msgspec.msgpack.Encoder(enc_hook=of_python), msgspec.msgpack.Decoder(Scene)

_HALF = re.compile("[\ud800-\udfff]")
"""Half of a surrogate pair, which a Python string can contain but UTF-8 cannot."""


def validate(scene: Scene) -> Scene:
    """Return the scene unchanged if it is valid.

    Raises:
        SceneError: one sentence that names the field, as in
            `angular_springs[3].b: spring 17 does not exist (0..10)`.
    """
    known = _valid.get(id(scene))
    if known is not None and known() is scene:
        return scene
    if not isinstance(scene, Scene):
        raise SceneError(Text("a Scene is expected, not {kind}", kind=type(scene).__name__))
    converted = _read_back(scene)
    if converted != scene:  # a list is converted to a tuple, and a dict to a struct
        raise SceneError(difference(scene, converted))
    consistent(scene)
    key = id(scene)
    _valid[key] = weakref.ref(scene, lambda _gone: _valid.pop(key, None))
    return scene


def consistent(scene: Scene) -> Scene:
    """Return a scene whose types and ranges are right, if its parts fit together.

    Raises:
        SceneError: as `validate`.
    """
    for problem in _problems(scene):
        raise SceneError(problem)
    return scene


def consistent_pose(pose: Pose, scene: Scene) -> Pose:
    """Return a pose whose types and ranges are right, if it fits the scene's body.

    Raises:
        SceneError: as `validate`.
    """
    for problem in _pose_problems(scene, pose):
        raise SceneError(problem)
    return pose


def _read_back(scene: Scene) -> Scene:
    """Return the scene as read from its written form.

    Raises:
        SceneError: a type or a number is wrong.
    """
    try:
        return _reader.decode(_writer.encode(scene))
    except Exception:
        # Conversion to dicts takes several times as long, but finds errors even if it cannot be written.
        try:
            return msgspec.convert(msgspec.to_builtins(scene, enc_hook=of_python), Scene)
        except msgspec.ValidationError as error:
            raise SceneError(sentence(error, scene)) from None


def number_range(kind: type, field: str) -> tuple[float, float, str]:
    """Return (lowest, highest, unit) of a numeric field of a scene's types, from its annotation; for a
    vector, those of its components."""
    found = annotation_of(get_type_hints(kind, include_extras=True)[field])
    assert found is not None, "it is a number"
    _, meta = found
    low = -math.inf if meta.ge is None else meta.ge
    high = math.inf if meta.le is None else meta.le
    return float(low), float(high), unit_of(meta)


# ------------------------------------------------------------------------- consistency
def _problems(scene: Scene) -> Iterator[str]:
    """Yield a sentence for each inconsistency between the parts."""
    if scene.format > FORMAT_VERSION:
        yield Text(
            "{where}: this scene has format version {format}, newer than {newest}, which "
            "is the newest that this softrod reads",
            where="format",
            format=scene.format,
            newest=FORMAT_VERSION,
        )
    for field, text in (
        ("name", scene.name),
        ("title", scene.title),
        ("description", scene.description),
        ("view.unit", scene.view.unit),
    ):
        if _HALF.search(text):
            yield Text("{where}: it has characters that cannot be written to a file", where=field)
    yield from _lesson_problems(scene)
    yield from _recipe_problems(scene)
    n, springs = len(scene.masses), len(scene.linear_springs)
    if n == 0:
        yield Text("{where}: a scene needs at least one mass, or a recipe in bodies", where="masses")
    if n > MAX_MASSES:
        yield of_field("masses", Text("{count} masses are more than {most}", count=n, most=MAX_MASSES))
    for field in ("linear_springs", "angular_springs"):
        if len(getattr(scene, field)) > MAX_SPRINGS:
            yield Text(
                "{where}: {count} springs are more than {most}",
                where=field,
                count=len(getattr(scene, field)),
                most=MAX_SPRINGS,
            )
    yield from _linear_problems(scene, n)
    yield from _angular_problems(scene, springs)
    yield from _limit_problems(scene)
    yield from _muscle_problems(scene)
    for i, mass in enumerate(scene.masses):
        if mass.keys and not mass.force:
            yield Text("{where}: there is no force that they could work", where=f"masses[{i}].keys")
        if mass.rail and not any(mass.rail):
            yield Text("{where}: a direction of (0, 0) points nowhere", where=f"masses[{i}].rail")
    for w, wall in enumerate(scene.walls):
        if not any(wall.normal):
            yield Text("{where}: a normal of (0, 0) points nowhere", where=f"walls[{w}].normal")
        if wall.static_friction is not msgspec.UNSET and not wall.tangential_hardness:
            yield Text(
                "{where}: it needs a tangential_hardness, by which friction holds",
                where=f"walls[{w}].static_friction",
            )
    yield from _anchor_problems(scene, n)
    xmin, ymin, xmax, ymax = scene.view.frame
    if not (xmax - xmin > 1e-3 and ymax - ymin > 1e-3):
        yield Text("{where}: it must run from (x min, y min) to a larger (x max, y max)", where="view.frame")
    yield from _pose_problems(scene, scene.pose)
    yield from _filling_problems(scene, n)


def _lesson_problems(scene: Scene) -> Iterator[str]:
    for i, step in enumerate(scene.lesson.steps if scene.lesson else ()):
        question = step.question
        if question is not None and question.answer >= len(question.choices):
            where = f"lesson.steps[{i}].question.answer"
            yield Text(
                "{where}: choice {choice} does not exist ({span})",
                where=where,
                choice=question.answer,
                span=span(len(question.choices)),
            )
        if (goal := step.goal) is not None:
            low, high = (
                -math.inf if goal.low is None else goal.low,
                math.inf if goal.high is None else goal.high,
            )
            for field, bound in (("low", low), ("high", high)):
                if getattr(goal, field) is not None and not math.isfinite(bound):
                    yield Text(
                        "{where}: {value:g} is not a finite number",
                        where=f"lesson.steps[{i}].goal.{field}",
                        value=bound,
                    )
            if goal.low is None and goal.high is None:
                yield Text("{where}: it needs low, high or both", where=f"lesson.steps[{i}].goal")
            elif low > high:
                yield Text(
                    "{where}: low {low:g} is above high {high:g}",
                    where=f"lesson.steps[{i}].goal",
                    low=low,
                    high=high,
                )
        if step.run:
            yield from _run_problems(step.run, len(scene.masses), f"lesson.steps[{i}].run")
        if any(_HALF.search(text) for text in texts_of(step)):
            yield Text(
                "{where}: it has characters that cannot be written to a file", where=f"lesson.steps[{i}]"
            )


def _run_problems(run: StepRun, n: int, where: str) -> Iterator[str]:
    if run == StepRun():
        yield Text("{where}: it needs settings, pulls, leads or muscles", where=where)
    for field, moved in (("pulls", run.pulls), ("leads", run.leads)):
        masses = [one.mass for one in moved]
        for i, mass in enumerate(masses):
            if mass >= n:
                yield of_field(f"{where}.{field}[{i}].mass", no_part("mass", mass, n))
            if mass in masses[:i]:
                twice = f"{where}.{field}[{i}].mass"
                if field == "pulls":
                    yield Text("{where}: mass {mass} is pulled twice", where=twice, mass=mass)
                else:
                    yield Text("{where}: mass {mass} is led twice", where=twice, mass=mass)
    joints = [one.joint for one in run.muscles]
    yield from (
        Text(
            "{where}: the muscle of joint {joint} is changed twice",
            where=f"{where}.muscles[{i}].joint",
            joint=joint,
        )
        for i, joint in enumerate(joints)
        if joint in joints[:i]
    )


def _recipe_problems(scene: Scene) -> Iterator[str]:
    if not scene.bodies:
        if scene.links:
            yield Text(
                "{where}: they join the bodies, and this scene has none; its springs are its linear_springs",
                where="links",
            )
        return
    driven = None
    for i, body in enumerate(scene.bodies):
        if not any(getattr(body, "direction", (1.0, 0.0))):
            yield Text("{where}: a direction of (0, 0) points nowhere", where=f"bodies[{i}].direction")
            return
        if body.driven is not None:
            if driven is not None:
                yield Text(
                    "{where}: bodies[{driven}] has a driven mass already, and only one can be",
                    where=f"bodies[{i}].driven",
                    driven=driven,
                )
            driven = i
    try:
        parts = expand(scene.bodies, scene.links)
    except TooLarge as error:
        yield of_field("bodies", str(error))
        return
    n = len(parts.masses)
    for i, link in enumerate(scene.links):
        for end in ("a", "b"):
            if getattr(link, end) >= n:
                yield of_field(f"links[{i}].{end}", no_part("mass", getattr(link, end), n))
                return
    if any(getattr(scene, field) != part for field, part in zip(BODY_FIELDS, parts, strict=True)):
        yield Text(
            "{where}: a scene has either recipes or masses, springs, anchors and fillings "
            "of its own, not both",
            where="bodies",
        )


def _linear_problems(scene: Scene, n: int) -> Iterator[str]:
    pairs: dict[int, int] = {}
    starts = scene.pose.positions if scene.pose else tuple(mass.position for mass in scene.masses)
    for s, spring in enumerate(scene.linear_springs):
        a, b = spring.a, spring.b
        if a >= n or b >= n:
            end, i = ("a", a) if a >= n else ("b", b)
            yield of_field(f"linear_springs[{s}].{end}", no_part("mass", i, n))
            return
        if a == b:
            yield Text(
                "{where}: a spring must join two masses, not mass {a} with itself",
                where=f"linear_springs[{s}].b",
                a=a,
            )
        other = pairs.setdefault(_pair(a, b), s)
        if other != s:
            yield Text(
                "{where}: it joins masses {a} and {b}, as spring {other} does",
                where=f"linear_springs[{s}]",
                a=a,
                b=b,
                other=other,
            )
        if len(starts) == n and math.dist(starts[a], starts[b]) < SHORTEST:
            what = "pose.positions" if scene.pose else "masses"
            yield Text(
                "{where}: {what} {a} and {b} start in the same place, so the spring between "
                "them has no direction",
                where=f"linear_springs[{s}]",
                what=what,
                a=a,
                b=b,
            )


def _pair(a: int, b: int) -> int:
    """Return a number that identifies an unordered pair of indices."""
    return a << 32 | b if a < b else b << 32 | a


def _angular_problems(scene: Scene, springs: int) -> Iterator[str]:
    pairs: dict[int, int] = {}
    linear, template = scene.linear_springs, scene.template
    for j, joint in enumerate(scene.angular_springs):
        a, b = joint.a, joint.b
        if a >= springs or b >= springs:
            end, s = ("a", a) if a >= springs else ("b", b)
            yield of_field(f"angular_springs[{j}].{end}", no_part("spring", s, springs))
            return
        if a == b:
            yield Text(
                "{where}: it must hold two different springs, not {a} with itself",
                where=f"angular_springs[{j}].b",
                a=a,
            )
            continue
        p, q = linear[a], linear[b]
        if p.a != q.a and p.a != q.b and p.b != q.a and p.b != q.b:
            yield Text("{where}: springs {a} and {b} share no mass", where=f"angular_springs[{j}]", a=a, b=b)
        pair = _pair(a, b)
        other = pairs.setdefault(pair, j)
        if other != j and _are_opposite(joint, scene.angular_springs[other]):
            other = pairs.setdefault(~pair, j)
        if other != j:
            yield Text(
                "{where}: it holds springs {a} and {b}, as spring {other} does",
                where=f"angular_springs[{j}]",
                a=a,
                b=b,
                other=other,
            )
        if template is not None and joint.rest_angle != template:
            yield Text(
                "{where}: {angle:g} is not the scene's template, {template}",
                where=f"angular_springs[{j}].rest_angle",
                angle=joint.rest_angle,
                template=template,
            )


def _are_opposite(joint: AngularSpring, other: AngularSpring) -> bool:
    """Whether two joints of the same springs act on one side each, as the two stops of a knee do."""
    sides = {joint.only, other.only}
    return sides == {"above", "below"} if joint.a == other.a else sides in ({"above"}, {"below"})


def _limit_problems(scene: Scene) -> Iterator[str]:
    """Yield errors in the forces and torques at which springs break or yield."""
    for s, spring in enumerate(scene.linear_springs):
        yields = spring.yield_force
        if yields is None:
            if spring.hardening:
                yield Text(
                    "{where}: it has no effect on a spring without a yield_force",
                    where=f"linear_springs[{s}].hardening",
                )
            continue
        if spring.stiffness == 0.0:
            yield Text(
                "{where}: a spring whose stiffness is 0 never yields",
                where=f"linear_springs[{s}].yield_force",
            )
        if spring.strength is not None and spring.strength < yields:
            yield Text(
                "{where}: {strength:g} is below the yield_force {yields:g}, so the spring "
                "breaks before it yields",
                where=f"linear_springs[{s}].strength",
                strength=spring.strength,
                yields=yields,
            )
    for j, joint in enumerate(scene.angular_springs):
        if joint.yield_torque is not None and joint.stiffness == 0.0:
            yield Text(
                "{where}: an angular spring whose stiffness is 0 never yields",
                where=f"angular_springs[{j}].yield_torque",
            )


def _filling_problems(scene: Scene, n: int) -> Iterator[str]:
    for f, filling in enumerate(scene.fillings):
        where, loop = f"fillings[{f}].masses", filling.masses
        missing = next((i for i in loop if i >= n), None)
        if len(loop) < 3:
            yield Text("{where}: a loop has at least three masses, not {count}", where=where, count=len(loop))
        elif missing is not None:
            yield of_field(f"{where}[{loop.index(missing)}]", no_part("mass", missing, n))
        elif len(set(loop)) < len(loop):
            twice = next(k for k, i in enumerate(loop) if i in loop[:k])
            yield Text(
                "{where}: mass {mass} is in the loop already", where=f"{where}[{twice}]", mass=loop[twice]
            )
        elif filling.area is None and loop_area([scene.masses[i].position for i in loop]) < 1e-6:
            yield Text("{where}: the loop has no area, so its filling has none either", where=where)


def _muscle_problems(scene: Scene) -> Iterator[str]:
    for field in ("linear_springs", "angular_springs"):
        parts = getattr(scene, field)
        for i, part in enumerate(parts if is_set_in_any(parts, "muscle") else ()):
            if part.muscle and part.muscle.wave == "steady" and not part.muscle.keys:
                yield Text(
                    '{where}: "steady" needs keys, by which the muscle works',
                    where=f"{field}[{i}].muscle.wave",
                )


def _anchor_problems(scene: Scene, n: int) -> Iterator[str]:
    seen: dict[int, int] = {}
    driven = None
    for i, anchor in enumerate(scene.anchors):
        if anchor.mass >= n:
            yield of_field(f"anchors[{i}].mass", no_part("mass", anchor.mass, n))
        if anchor.mass in seen:
            yield Text(
                "{where}: mass {mass} is held by anchor {other} already",
                where=f"anchors[{i}].mass",
                mass=anchor.mass,
                other=seen[anchor.mass],
            )
        seen[anchor.mass] = i
        if anchor.driven:
            if driven is not None:
                yield Text(
                    "{where}: anchor {driven} is driven already, and only one can be",
                    where=f"anchors[{i}].driven",
                    driven=driven,
                )
            driven = i


def _pose_problems(scene: Scene, pose: Pose | None) -> Iterator[str]:
    if pose is None:
        return
    n, damage = len(scene.masses), pose.damage
    for field in ("positions", "velocities"):
        count = len(getattr(pose, field))
        if count != n:
            yield Text(
                "{where}: {count} entries do not match the {n} masses",
                where=f"pose.{field}",
                count=count,
                n=n,
            )
    if damage is not None:
        springs, joints = len(scene.linear_springs), len(scene.angular_springs)
        for field, of in (("set_lengths", springs), ("hardened", springs), ("set_angles", joints)):
            count = len(getattr(damage, field))
            if count not in (0, of):
                where = f"pose.damage.{field}"
                if field == "set_angles":
                    yield Text(
                        "{where}: {count} entries do not match the {of} angular springs",
                        where=where,
                        count=count,
                        of=of,
                    )
                else:
                    yield Text(
                        "{where}: {count} entries do not match the {of} linear springs",
                        where=where,
                        count=count,
                        of=of,
                    )
        for i, spring in enumerate(damage.broken):
            if spring >= springs:
                yield of_field(f"pose.damage.broken[{i}]", no_part("spring", spring, springs))
    if pose.grips is not None:
        for field, of in (("walls", len(scene.walls)), ("springs", len(scene.linear_springs))):
            for i, (index, mass, _) in enumerate(getattr(pose.grips, field)):
                if index >= of:
                    what = "wall" if field == "walls" else "spring"
                    yield of_field(f"pose.grips.{field}[{i}]", no_part(what, index, of))
                if mass >= n:
                    yield of_field(f"pose.grips.{field}[{i}]", no_part("mass", mass, n))
        for i, (wall, mass) in enumerate(pose.grips.sliding or ()):
            if wall >= len(scene.walls) or mass >= n:
                yield Text(
                    "{where}: wall {wall} or mass {mass} does not exist",
                    where=f"pose.grips.sliding[{i}]",
                    wall=wall,
                    mass=mass,
                )
