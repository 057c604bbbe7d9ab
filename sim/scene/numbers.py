"""The numeric types of scenes, with the range of each.

Validation, error messages, sliders and the JSON Schema are derived from these annotations.
"""

from __future__ import annotations

from typing import Annotated, Any, get_args

from msgspec import Meta

MAX_MASSES = 20_000
"""Largest number of masses in a scene."""
MAX_SPRINGS = 100_000
"""Largest number of linear springs in a scene, and of angular springs."""
MAX_COORDINATE = 1e6
"""Largest absolute value of a coordinate, px."""
MAX_SPEED = 1e9
"""Largest absolute value of a velocity component, px/s."""

RUNAWAY_SPEED = 1e6
"""Speed, px/s, from which a body under a method without error control counts as having run away."""


def bounded(
    low: float,
    high: float,
    unit: str,
    what: str,
    slider: tuple[float, float] | None = None,
    logarithmic: bool = False,
) -> Meta:
    """Return the annotation of a number: its range, unit, description, and slider range, if any."""
    return Meta(
        ge=low,
        le=high,
        description=f"{what} ({unit})" if unit else what,
        extra={"unit": unit, "label": what, "slider": slider, "logarithmic": logarithmic},
    )


# The ranges are wide enough for any body that one would draw, and narrow enough that no product of two of
# these numbers overflows.
Coordinate = Annotated[float, bounded(-MAX_COORDINATE, MAX_COORDINATE, "px", "A coordinate")]
Speed = Annotated[float, bounded(-MAX_SPEED, MAX_SPEED, "px/s", "A component of a velocity")]
Length = Annotated[float, bounded(0.0, 1e6, "px", "A length")]
Stiffness = Annotated[float, bounded(0.0, 1e15, "kg/s²", "Stiffness")]
Damping = Annotated[float, bounded(0.0, 1e6, "kg/s", "Damping")]
Force = Annotated[float, bounded(0.0, 1e15, "kg px/s²", "A force")]
ForceComponent = Annotated[float, bounded(-1e15, 1e15, "kg px/s²", "A component of a force")]
Angle = Annotated[float, bounded(-180.0, 180.0, "°", "An angle")]
Kilograms = Annotated[float, bounded(1e-6, 1e6, "kg", "A mass")]
Radius = Annotated[float, bounded(1e-3, 1e4, "px", "Radius of a mass")]
Index = Annotated[int, Meta(ge=0, lt=MAX_SPRINGS)]
Name = Annotated[str, Meta(min_length=1, max_length=60)]
Vector = tuple[Coordinate, Coordinate]


def annotation_of(hint: Any) -> tuple[type, Meta] | None:
    """Return the type and annotation of the number in a field's type; None if there is no number."""
    meta = next((each for each in getattr(hint, "__metadata__", ()) if isinstance(each, Meta)), None)
    if meta is not None:
        return get_args(hint)[0], meta
    return next(filter(None, map(annotation_of, get_args(hint))), None)


def of_python(value: Any) -> Any:
    """Convert a NumPy number to a Python number, and any other value to its type's name, which msgspec
    refuses."""
    return next((kind(value) for kind in (float, int, str) if isinstance(value, kind)), type(value).__name__)
