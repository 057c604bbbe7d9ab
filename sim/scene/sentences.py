"""Error messages for scenes: turns msgspec's errors into one sentence that names field, value and range."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import msgspec

from ..errors import of_field, out_of_range
from ..text import Text, number
from .types import Scene

_A = {
    float: Text("a number"),
    int: Text("a whole number"),
    str: Text("a text"),
    bool: Text("true or false"),
}
"""Names of Python types in messages."""
_JSON = {NoneType: "null", list: Text("an array"), dict: Text("an object")}
"""Names of the other JSON values in messages about files."""

_TYPES = {
    "array": _JSON[list], "object": _JSON[dict], "str": _A[str], "int": _A[int], "float": _A[float],
    "bool": _A[bool],
}  # fmt: skip
"""Names of msgspec's types in messages."""


def _type_name(name: str) -> str:
    return _TYPES.get(name, name)


def _any_of(names: list[str]) -> str:
    """Return the names of msgspec's types as alternatives."""
    said = _type_name(names[0])
    for name in names[1:]:
        said = Text("{one} or {other}", one=said, other=_type_name(name))
    return said


_MALFORMED: dict[str, Text] = {
    said: said
    for said in (
        Text("JSON is malformed: invalid character"),
        Text("JSON is malformed: invalid number"),
        Text("JSON is malformed: invalid escape character in string"),
        Text("JSON is malformed: expected ',' or ']'"),
        Text("JSON is malformed: expected ',' or '}}'"),
        Text("JSON is malformed: expected ':'"),
        Text("JSON is malformed: expected '\"'"),
        Text("JSON is malformed: trailing comma in array"),
        Text("JSON is malformed: trailing comma in object"),
        Text("JSON is malformed: trailing characters"),
    )
}
"""Messages of msgspec about JSON that stay as they are."""


_PHRASES: tuple[tuple[str, Callable[[re.Match[str]], str]], ...] = (
    (
        r"Expected `([\w |]+)`, got `(\w+)`",
        lambda m: Text(
            "{wanted} is expected, not {found}", wanted=_any_of(m[1].split(" | ")), found=_type_name(m[2])
        ),
    ),
    (r"JSON is malformed: [^()]*[^() ]", lambda m: _MALFORMED.get(m[0], m[0])),
    (r"Input data was truncated", lambda _: Text("it ends in the middle")),
    (
        r"maximum recursion depth exceeded.*",
        lambda _: Text("it has too many objects within each other"),
    ),
    (r"Object missing required field (`.*`)", lambda m: Text("the field {field} is missing", field=m[1])),
    (r"Object contains unknown field (`.*`)", lambda m: Text("there is no field {field}", field=m[1])),
)
"""Messages of msgspec, and their replacements."""

_HUGE = 2**64
"""Whole numbers from this value on are not printed in messages."""


def _out_of_range(where: str, value: float, meta: msgspec.Meta) -> Text:
    """Return the sentence for a number outside the range of its annotation."""
    low, high, unit = meta.ge, meta.le, unit_of(meta)
    if meta.lt is not None:
        low, high = meta.ge, meta.lt - 1
    elif meta.gt is not None and high is not None:
        if not unit:
            return Text(
                "{where}: {value:g} is not above {low:g} and at most {high:g}",
                where=where,
                value=value,
                low=meta.gt,
                high=high,
            )
        return Text(
            "{where}: {value:g} is not above {low:g} and at most {high:g} {unit}",
            where=where,
            value=value,
            low=meta.gt,
            high=high,
            unit=unit,
        )
    shown = number(value) if isinstance(value, float) else value
    least, most = ("" if end is None else number(end) for end in (low, high))
    return out_of_range(where, shown, least, most, unit)


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
    # A field name in a file may contain line breaks; the sentence must not.
    where = " ".join(path.rstrip("`").lstrip(".").split()) if reason else ""
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
            return Text(
                "{where}: {count} numbers are expected, as in [0, 0], not {found}",
                where=where,
                count=count,
                found=_shown(value, found),
            )
    return of_field(where, in_words(reason)) if where else in_words(str(error))


def in_words(reason: str) -> str:
    """Return a message of msgspec on one line and without the names of its types."""
    reason = " ".join(reason.split())
    for pattern, words in _PHRASES:
        if match := re.match(pattern, reason):
            rest = reason[match.end() :]
            return Text("{said}{rest}", said=words(match), rest=rest) if rest else words(match)
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
        return Text("{where}: a whole number as large as this is not allowed", where=where)
    if get_origin(kind) is Literal:
        known = ", ".join(map(str, get_args(kind)))
        return Text(
            "{where}: {found} is not one of {known}", where=where, found=_shown(value, found), known=known
        )
    if isinstance(value, (int, float)) and not isinstance(value, bool) and kind in (float, type(value)):
        if not math.isfinite(value):
            return Text("{where}: {value:g} is not a finite number", where=where, value=value)
        if meta is not None:
            return _out_of_range(where, value, meta)
    if isinstance(value, str) and kind is str and meta is not None:
        if not value:
            return Text("{where}: it must not be empty", where=where)
        return Text(
            "{where}: {count} characters are more than {most}",
            where=where,
            count=len(value),
            most=meta.max_length,
        )
    if isinstance(value, (list, tuple)) and get_origin(kind) is tuple and meta is not None:
        if meta.max_length is not None and len(value) > meta.max_length:
            return Text(
                "{where}: {count} entries are more than {most}",
                where=where,
                count=len(value),
                most=meta.max_length,
            )
        if meta.min_length is not None and len(value) < meta.min_length:
            return Text(
                "{where}: {count} entries are fewer than {least}",
                where=where,
                count=len(value),
                least=meta.min_length,
            )
    return _expected(where, kind, value, found)


def _expected(where: str, kind: Any, value: Any, found: Any = None) -> str:
    """Return the sentence for a value of a wrong type; `found` as for `sentence`."""
    if get_origin(kind) is tuple and Ellipsis not in get_args(kind):
        return Text(
            "{where}: {count} numbers are expected, as in a tuple", where=where, count=len(get_args(kind))
        )
    if get_origin(kind) is Union:
        names = ", ".join(struct.__name__ for struct in get_args(kind))
        return Text(
            "{where}: one of {names} is expected, not {found}",
            where=where,
            names=names,
            found=_shown(value, found),
        )
    name = (get_origin(kind) or kind).__name__
    wanted = _A.get(kind) or (
        Text("an {name}", name=name) if name[0] in "AEIO" else Text("a {name}", name=name)
    )
    return Text(
        "{where}: {wanted} is expected, not {found}", where=where, wanted=wanted, found=_shown(value, found)
    )


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
