"""Every number in a scene, found through the types, so that a new field is tested too."""

from __future__ import annotations

from collections.abc import Iterator
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

import msgspec

Step = str | int
Route = tuple[Step, ...]


def routes(value: Any, wanted: type, kind: Any = None, before: Route = ()) -> Iterator[Route]:
    """The way to every field of a type in a struct; of a tuple of any length, to its first entry."""
    kind = type(value) if kind is None else kind
    origin = get_origin(kind)
    if origin is Annotated:
        yield from routes(value, wanted, get_args(kind)[0], before)
    elif origin in (Union, UnionType):
        if value is not None:
            inners = [a for a in get_args(kind) if a is not type(None)]
            (inner,) = inners if len(inners) == 1 else [type(value)]  # of tagged structs, the one it is
            yield from routes(value, wanted, inner, before)
    elif origin is tuple:
        arguments = get_args(kind)
        if arguments[-1] is Ellipsis:
            arguments = arguments[:1] if value else ()
        for i, inner in enumerate(arguments):
            yield from routes(value[i], wanted, inner, (*before, i))
    elif isinstance(kind, type) and issubclass(kind, msgspec.Struct):
        hints = get_type_hints(kind, include_extras=True)
        for name in kind.__struct_fields__:
            yield from routes(getattr(value, name), wanted, hints[name], (*before, name))
    elif kind is wanted:
        yield before


def with_value(whole: Any, route: Route, value: Any) -> Any:
    """A copy of a frozen struct with another value at the end of a route."""
    if not route:
        return value
    step, rest = route[0], route[1:]
    if isinstance(step, int):
        return (*whole[:step], with_value(whole[step], rest, value), *whole[step + 1 :])
    return msgspec.structs.replace(whole, **{step: with_value(getattr(whole, step), rest, value)})


def spelled(route: Route) -> str:
    """The route as error messages spell it: `masses[0].position[1]`."""
    return "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in route).lstrip(".")
