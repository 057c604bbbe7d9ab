"""Error messages for scenes: turns msgspec's errors into one sentence that names field, value and range."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import msgspec

from .types import Scene

_A = {float: "a number", int: "a whole number", str: "a text", bool: "true or false"}
"""Names of Python types in messages."""
_JSON = {NoneType: "null", list: "an array", dict: "an object"}
"""Names of the other JSON values in messages about files."""

_TYPES = {
    "array": "an array", "object": "an object", "str": "a text", "int": "a whole number", "float": "a number",
    "bool": "true or false", "null": "null",
}  # fmt: skip
"""Names of msgspec's types in messages."""


def _type_name(name: str) -> str:
    return _TYPES.get(name, name)


_PHRASES: tuple[tuple[str, str | Callable[[re.Match[str]], str]], ...] = (
    (
        r"^Expected `([\w |]+)`, got `(\w+)`",
        lambda m: f"{' or '.join(map(_type_name, m[1].split(' | ')))} is expected, not {_type_name(m[2])}",
    ),
    (r"^Input data was truncated", "it ends in the middle"),
    (r"^maximum recursion depth exceeded.*", "it has too many objects within each other"),
    (r"^Object missing required field (`.*`)", r"the field \1 is missing"),
    (r"^Object contains unknown field (`.*`)", r"there is no field \1"),
)
"""Messages of msgspec, and their replacements."""

_HUGE = 2**64
"""Whole numbers from this value on are not printed in messages."""


def out_of_range(where: str, value: float, meta: msgspec.Meta) -> str:
    """Return the sentence for a number outside the range of its annotation."""
    if meta.lt is not None:
        return f"{where}: {value!r} is not in the range {meta.ge:g}..{meta.lt - 1:g}"
    if meta.gt is not None and meta.le is not None:
        return f"{where}: {value:g} is not above {meta.gt:g} and at most {meta.le:g} {unit_of(meta)}".rstrip()
    low = f"{meta.ge:g}" if meta.ge is not None else ""
    high = f"{meta.le:g}" if meta.le is not None else ""
    shown = f"{value:g}" if isinstance(value, float) else repr(value)
    return f"{where}: {shown} is not in the range {low}..{high} {unit_of(meta)}".rstrip()


def unit_of(meta: msgspec.Meta) -> str:
    """Return the unit of a number, from its annotation."""
    return (meta.extra or {}).get("unit", "")


def sentence(error: msgspec.ValidationError, found: Any, kind: Any = Scene) -> str:
    """Return the sentence for a value that could not be converted.

    Args:
        error: msgspec's error.
        found: the scene as made in code, or the decoded contents of a JSON file.
        kind: the expected type.
    """
    reason, _, path = str(error).rpartition(" - at `$")
    where = path.rstrip("`").lstrip(".") if reason else ""
    value: Any = found
    at = ""
    kind, meta = _split(kind, found)
    for field, index in re.findall(r"(\w+)|\[(\d+)\]", where):
        if hasattr(value, "__struct_fields__") and type(value) is not kind:
            return _expected(at, kind, value)  # a struct of another type
        try:
            if field and get_origin(kind) is Union:
                # No struct of the union has the value's tag.
                at, wanted, value = f"{at}.{field}", Literal[_tags(kind)], value[field]
            elif field:
                at, wanted = f"{at}.{field}".lstrip("."), get_type_hints(kind, include_extras=True)[field]
                value = value[field] if isinstance(value, dict) else getattr(value, field)
            else:
                first, *others = get_args(kind)
                at, value = f"{at}[{index}]", value[int(index)]
                wanted = first if Ellipsis in others else (first, *others)[int(index)]
        except (AttributeError, LookupError, TypeError):
            break  # a field's name in the file may look like a path
        kind, meta = _split(wanted, value)
    else:
        if where and (kind in _A or get_origin(kind) is Literal or isinstance(found, Scene)):
            return _about(where, value, kind, meta, found)
        if where and get_origin(kind) is tuple and Ellipsis not in get_args(kind):
            count = len(get_args(kind))
            return f"{where}: {count} numbers are expected, as in [0, 0], not {_shown(value, found)}"
    return f"{where}: {in_words(reason)}" if where else in_words(str(error))


def in_words(reason: str) -> str:
    """Return a message of msgspec on one line and without the names of its types."""
    reason = " ".join(reason.split())
    for pattern, words in _PHRASES:
        reason = re.sub(pattern, words, reason)
    return reason


def difference(value: Any, wanted: Any, where: str = "") -> str:
    """Return the sentence for the first value that differs from its converted form."""
    if isinstance(wanted, msgspec.Struct) and type(value) is type(wanted):
        steps = [(f".{f}", getattr(value, f), getattr(wanted, f)) for f in wanted.__struct_fields__]
    elif isinstance(wanted, tuple) and isinstance(value, tuple):
        steps = [(f"[{i}]", *both) for i, both in enumerate(zip(value, wanted, strict=True))]
    else:
        return _expected(where, type(wanted), value)
    step, one, other = next(step for step in steps if step[1] != step[2])
    return difference(one, other, (where + step).lstrip("."))


def _about(where: str, value: Any, kind: Any, meta: msgspec.Meta | None, found: Any) -> str:
    """Return the sentence for a value that its type does not allow."""
    if isinstance(value, int) and abs(value) >= _HUGE:
        return f"{where}: a whole number as large as this is not allowed"
    if get_origin(kind) is Literal:
        return f"{where}: {_shown(value, found)} is not one of {', '.join(map(str, get_args(kind)))}"
    if isinstance(value, (int, float)) and not isinstance(value, bool) and kind in (float, type(value)):
        if not math.isfinite(value):
            return f"{where}: {value:.6g} is not a finite number"
        if meta is not None:
            return out_of_range(where, value, meta)
    if isinstance(value, str) and kind is str and meta is not None:
        if not value:
            return f"{where}: it must not be empty"
        return f"{where}: {len(value)} characters are more than {meta.max_length}"
    if isinstance(value, (list, tuple)) and get_origin(kind) is tuple and meta is not None:
        if meta.max_length is not None and len(value) > meta.max_length:
            return f"{where}: {len(value)} entries are more than {meta.max_length}"
        if meta.min_length is not None and len(value) < meta.min_length:
            return f"{where}: {len(value)} entries are fewer than {meta.min_length}"
    return _expected(where, kind, value, found)


def _expected(where: str, kind: Any, value: Any, found: Any = None) -> str:
    """Return the sentence for a value of a wrong type; `found` as for `sentence`."""
    if get_origin(kind) is tuple and Ellipsis not in get_args(kind):
        return f"{where}: {len(get_args(kind))} numbers are expected, as in a tuple"
    if get_origin(kind) is Union:
        names = ", ".join(struct.__name__ for struct in get_args(kind))
        return f"{where}: one of {names} is expected, not {_shown(value, found)}"
    name = (get_origin(kind) or kind).__name__
    a = _A.get(kind) or f"{'an' if name[0] in 'AEIO' else 'a'} {name}"
    return f"{where}: {a} is expected, not {_shown(value, found)}"


def _shown(value: Any, found: Any) -> str:
    """Return a value as text, in Python's notation or, if it comes from a file, in JSON's."""
    if isinstance(value, str):
        return repr(value if len(value) <= 60 else value[:60] + "…")
    in_file = isinstance(found, dict)
    if isinstance(value, (int, float)):
        return str(value).lower() if in_file else str(value)
    if value is None and not in_file:
        return "None"
    return _JSON.get(type(value), type(value).__name__) if in_file else type(value).__name__


def _split(kind: Any, value: Any) -> tuple[Any, msgspec.Meta | None]:
    """Return the type of an annotation, without None, and its range, if it has one.

    Among several structs it is the one that matches the value by type or tag.
    """
    meta = None
    while get_origin(kind) in (Annotated, Union, UnionType):
        if get_origin(kind) is Annotated:
            kind, *extras = get_args(kind)
            meta = next((extra for extra in extras if isinstance(extra, msgspec.Meta)), None)
        else:
            options = [option for option in get_args(kind) if option not in (NoneType, msgspec.UnsetType)]
            if len(options) > 1:
                return _tagged(options, value), None
            (kind,) = options
    return kind, meta


def _tags(union: Any) -> tuple[str, ...]:
    """Return the tags of the structs of a union."""
    return tuple(struct.__struct_config__.tag for struct in get_args(union))


def _tagged(structs: list[Any], value: Any) -> Any:
    """Return the struct of a tagged union that matches a value, or the whole union if none does."""
    for struct in structs:
        config = struct.__struct_config__
        if type(value) is struct or (isinstance(value, dict) and value.get(config.tag_field) == config.tag):
            return struct
    return Union[tuple(structs)]  # noqa: UP007  the types are known at run time only
