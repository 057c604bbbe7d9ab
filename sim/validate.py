"""Refuses every scene that could not be simulated, with one sentence that names the field.

Types and ranges stand in `sim.scene`, as annotations; this module reads them there, so that a scene made
in code is held to the same limits as one read from a file.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator
from functools import cache
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import msgspec

from .errors import SceneError
from .scene import BODY_FIELDS, FORMAT_VERSION, MAX_MASSES, MAX_SPRINGS, Rope, Scene, expand_rope

Check = Callable[[Any, str], None]

_SHORTEST = 1e-9
"""Distance (px) below which the ends of a spring count as one place: it would have no direction."""


def validate(scene: Scene) -> Scene:
    """Return the scene unchanged, or refuse it.

    Raises:
        SceneError: one sentence that names the field, as in
            `angular_springs[3].b: spring 17 does not exist (0..10)`.
    """
    if not isinstance(scene, Scene):
        raise SceneError(f"a Scene is expected, not {type(scene).__name__}")
    _check_for(Scene)(scene, "")
    for problem in _problems(scene):
        raise SceneError(problem)
    return scene


def number_range(kind: type, field: str) -> tuple[float, float, str]:
    """(lowest, highest, unit) of a number of one of the scene's types, as its annotation states it."""
    meta = next(
        m for m in get_args(get_type_hints(kind, include_extras=True)[field]) if isinstance(m, msgspec.Meta)
    )
    low, high = (
        (meta.ge if meta.ge is not None else -math.inf),
        (meta.le if meta.le is not None else math.inf),
    )
    return float(low), float(high), _unit(meta)


def out_of_range(where: str, value: object, meta: msgspec.Meta) -> str:
    """The sentence for a number outside the range of its annotation."""
    if meta.lt is not None:
        return f"{where}: {value!r} is not in the range {meta.ge:g}..{meta.lt - 1:g}"
    low = f"{meta.ge:g}" if meta.ge is not None else ""
    high = f"{meta.le:g}" if meta.le is not None else ""
    shown = f"{value:g}" if isinstance(value, float) else repr(value)
    return f"{where}: {shown} is not in the range {low}..{high} {_unit(meta)}".rstrip()


def _unit(meta: msgspec.Meta) -> str:
    return (meta.extra or {}).get("unit", "")


# ------------------------------------------------------------------------- types and ranges
@cache
def _check_for(kind: Any) -> Check:
    """A function that checks a value against a type annotation, built once per annotation."""
    origin = get_origin(kind)
    if origin is Annotated:
        base, *extras = get_args(kind)
        inner = _check_for(base)
        meta = next(m for m in extras if isinstance(m, msgspec.Meta))
        return _checker_of_meta(inner, meta)
    if origin in (Union, UnionType):
        (wanted,) = (a for a in get_args(kind) if a is not type(None))
        inner = _check_for(wanted)
        return lambda value, where: None if value is None else inner(value, where)
    if origin is Literal:
        return _checker_of_choice(get_args(kind))
    if origin is tuple:
        return _checker_of_tuple(get_args(kind))
    if isinstance(kind, type) and issubclass(kind, msgspec.Struct):
        return _checker_of_struct(kind)
    return _checker_of_plain(kind)


def _checker_of_meta(inner: Check, meta: msgspec.Meta) -> Check:
    def check(value: Any, where: str) -> None:
        inner(value, where)
        if isinstance(value, str):
            if meta.min_length is not None and len(value) < meta.min_length:
                raise SceneError(f"{where}: it must not be empty")
            if meta.max_length is not None and len(value) > meta.max_length:
                raise SceneError(f"{where}: {len(value)} characters are more than {meta.max_length}")
        elif isinstance(value, (int, float)) and not (
            (meta.ge is None or value >= meta.ge)
            and (meta.le is None or value <= meta.le)
            and (meta.lt is None or value < meta.lt)
        ):
            raise SceneError(out_of_range(where, value, meta))

    return check


def _checker_of_choice(choices: tuple[Any, ...]) -> Check:
    def check(value: Any, where: str) -> None:
        if isinstance(value, bool) or value not in choices:
            raise SceneError(f"{where}: {value!r} is not one of {', '.join(map(str, choices))}")

    return check


def _checker_of_tuple(items: tuple[Any, ...]) -> Check:
    if items[-1] is Ellipsis:
        inner = _check_for(items[0])

        def check_all(value: Any, where: str) -> None:
            if not isinstance(value, tuple):
                raise SceneError(f"{where}: a tuple is expected, not {type(value).__name__}")
            for i, item in enumerate(value):
                inner(item, f"{where}[{i}]")

        return check_all
    inners = [_check_for(item) for item in items]

    def check(value: Any, where: str) -> None:
        if not isinstance(value, tuple) or len(value) != len(inners):
            raise SceneError(f"{where}: {len(inners)} numbers are expected, as in a tuple")
        for i, (item, inner) in enumerate(zip(value, inners, strict=True)):
            inner(item, f"{where}[{i}]")

    return check


def _checker_of_struct(kind: type[msgspec.Struct]) -> Check:
    hints = get_type_hints(kind, include_extras=True)
    fields = [(name, _check_for(hints[name])) for name in kind.__struct_fields__]

    def check(value: Any, where: str) -> None:
        if not isinstance(value, kind):
            raise SceneError(f"{where}: a {kind.__name__} is expected, not {type(value).__name__}")
        prefix = f"{where}." if where else ""
        for name, inner in fields:
            inner(getattr(value, name), prefix + name)

    return check


def _checker_of_plain(kind: type) -> Check:
    def check(value: Any, where: str) -> None:
        if kind is float and isinstance(value, (int, float)) and not isinstance(value, bool):
            if not -sys.float_info.max <= value <= sys.float_info.max:  # a NaN is not, either
                raise SceneError(
                    f"{where}: {value:.6g} is not a finite number"
                    if isinstance(value, float)
                    else f"{where}: a whole number as large as this is not allowed"
                )
        elif isinstance(value, str) and kind is str:
            try:
                value.encode()
            except UnicodeEncodeError:
                raise SceneError(f"{where}: it has characters that cannot be written to a file") from None
        elif not isinstance(value, kind) or (kind is int and isinstance(value, bool)):
            raise SceneError(f"{where}: {_A[kind]} is expected, not {value!r}")

    return check


_A = {float: "a number", int: "a whole number", str: "a text", bool: "true or false"}


# ------------------------------------------------------------------------- what belongs together
def _problems(scene: Scene) -> Iterator[str]:
    """Everything that is wrong with how the parts refer to each other; sentences, the first one first."""
    if scene.format > FORMAT_VERSION:
        yield (
            f"format: this scene has format version {scene.format}, newer than {FORMAT_VERSION}, which is "
            "the newest that this softrod reads"
        )
    if scene.rope is not None:
        yield from _rope_problems(scene, scene.rope)
    n, springs = len(scene.masses), len(scene.linear_springs)
    if n == 0:
        yield "masses: a scene needs at least one mass, or a rope"
    if n > MAX_MASSES:
        yield f"masses: {n} masses are more than {MAX_MASSES}"
    for field in ("linear_springs", "angular_springs"):
        if len(getattr(scene, field)) > MAX_SPRINGS:
            yield f"{field}: {len(getattr(scene, field))} springs are more than {MAX_SPRINGS}"
    yield from _linear_problems(scene, n)
    yield from _angular_problems(scene, springs)
    yield from _anchor_problems(scene, n)
    xmin, ymin, xmax, ymax = scene.view.frame
    if not (xmax - xmin > 1e-3 and ymax - ymin > 1e-3):
        yield "view.frame: it must run from (x min, y min) to a larger (x max, y max)"
    yield from _pose_problems(scene, n)


def _rope_problems(scene: Scene, rope: Rope) -> Iterator[str]:
    if not any(rope.direction):
        yield "rope.direction: a direction of (0, 0) points nowhere"
        return
    if any(getattr(scene, field) != part for field, part in zip(BODY_FIELDS, expand_rope(rope), strict=True)):
        yield "rope: a scene has either a rope or masses, springs and anchors of its own, not both"


def _linear_problems(scene: Scene, n: int) -> Iterator[str]:
    pairs: dict[frozenset[int], int] = {}
    for s, spring in enumerate(scene.linear_springs):
        for end in ("a", "b"):
            i = getattr(spring, end)
            if i >= n:
                yield f"linear_springs[{s}].{end}: mass {i} does not exist ({_span(n)})"
                return
        if spring.a == spring.b:
            yield f"linear_springs[{s}].b: a spring must join two masses, not mass {spring.a} with itself"
        other = pairs.setdefault(frozenset((spring.a, spring.b)), s)
        if other != s:
            yield f"linear_springs[{s}]: it joins masses {spring.a} and {spring.b}, as spring {other} does"
        starts = scene.pose.positions if scene.pose else None
        if starts is None or len(starts) == n:
            p = starts[spring.a] if starts else scene.masses[spring.a].position
            q = starts[spring.b] if starts else scene.masses[spring.b].position
            if math.dist(p, q) < _SHORTEST:
                where = "pose.positions" if starts else "masses"
                yield (
                    f"linear_springs[{s}]: {where} {spring.a} and {spring.b} start in the same place, "
                    "so the spring between them has no direction"
                )


def _angular_problems(scene: Scene, springs: int) -> Iterator[str]:
    pairs: dict[frozenset[int], int] = {}
    for j, joint in enumerate(scene.angular_springs):
        for end in ("a", "b"):
            s = getattr(joint, end)
            if s >= springs:
                yield f"angular_springs[{j}].{end}: spring {s} does not exist ({_span(springs)})"
                return
        if joint.a == joint.b:
            yield f"angular_springs[{j}].b: it must hold two different springs, not {joint.a} with itself"
            continue
        p, q = scene.linear_springs[joint.a], scene.linear_springs[joint.b]
        if not {p.a, p.b} & {q.a, q.b}:
            yield f"angular_springs[{j}]: springs {joint.a} and {joint.b} share no mass"
        other = pairs.setdefault(frozenset((joint.a, joint.b)), j)
        if other != j:
            yield f"angular_springs[{j}]: it holds springs {joint.a} and {joint.b}, as spring {other} does"
        if scene.template is not None and joint.rest_angle != scene.template:
            yield (
                f"angular_springs[{j}].rest_angle: {joint.rest_angle:g} is not the scene's template, "
                f"{scene.template}"
            )


def _anchor_problems(scene: Scene, n: int) -> Iterator[str]:
    seen: dict[int, int] = {}
    driven = None
    for i, anchor in enumerate(scene.anchors):
        if anchor.mass >= n:
            yield f"anchors[{i}].mass: mass {anchor.mass} does not exist ({_span(n)})"
        if anchor.mass in seen:
            yield f"anchors[{i}].mass: mass {anchor.mass} is held by anchor {seen[anchor.mass]} already"
        seen[anchor.mass] = i
        if anchor.driven:
            if driven is not None:
                yield f"anchors[{i}].driven: anchor {driven} is driven already, and only one can be"
            driven = i


def _pose_problems(scene: Scene, n: int) -> Iterator[str]:
    if scene.pose is not None:
        for field in ("positions", "velocities"):
            count = len(getattr(scene.pose, field))
            if count != n:
                yield f"pose.{field}: {count} entries do not match the {n} masses"


def _span(count: int) -> str:
    return f"0..{count - 1}" if count else "there are none"
