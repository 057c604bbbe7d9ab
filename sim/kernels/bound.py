"""Tables that are handed to the compiled code once.

A kernel that is called from Python has every array of every tuple looked up anew: for the hundred arrays of
a body that takes 20 µs, several times what a short rope needs for a frame. So the tuples are kept, as the
compiled code has them, in a buffer, and a call takes only that. Who keeps the buffer keeps the arrays, too.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba.core import types
from numba.extending import intrinsic

from .jit import kernel
from .tables import Adams, Body, Drive, Floats, Flow, Ledger, Live, Matrix, Rosenbrock, Tableau, Work


class Bound(NamedTuple):
    """All that a run needs beside what drives the body and how far it is to go."""

    kind: int  # of the method, see the KIND_ constants
    fixed: float  # the step, s, or 0 for error control
    tolerance: float  # of one step, px per second of it; that of `auto` before it is multiplied by strictness
    body: Body
    live: Live
    work: Work
    matrix: Matrix  # empty where no method is implicit
    flow: Flow
    ledger: Ledger
    explicit: Tableau
    implicit: Rosenbrock
    adams: Adams
    costs: Floats  # (ARMS,) of a step of each method for `auto`, in those of Verlet's; 0: not used
    strictness: Floats  # (ARMS,) of each of them
    near_limit: float  # s; steps from here on are near Verlet's stability limit


_SCALARS = {"int": types.int64, "bool": types.boolean, "float": types.float64}
_ARRAYS = {"Floats": (types.float64, 1), "Rows": (types.float64, 2), "Indices": (types.int64, 1)}
_TUPLES = {
    t.__name__: t for t in (Body, Live, Work, Matrix, Drive, Flow, Ledger, Tableau, Rosenbrock, Adams, Bound)
}


def _type(name: str, read_only: bool = False) -> Any:
    """numba's type of a field, by the name of its annotation."""
    if name in _SCALARS:
        return _SCALARS[name]
    if name in _ARRAYS:
        element, dimensions = _ARRAYS[name]
        return types.Array(element, dimensions, "C", readonly=read_only)
    cls = _TUPLES[name]
    fields = [_type(field.__forward_arg__, cls is Body) for field in cls.__annotations__.values()]
    return types.BaseTuple.from_types(fields, cls)


BOUND, DRIVE = _type("Bound"), _type("Drive")


def _taker(kept: Any) -> Any:
    """A function for compiled code that takes a value of a type out of a buffer."""

    @intrinsic
    def take(_context: Any, buffer: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            array = context.make_array(signature.args[0])(context, builder, arguments[0])
            pointer = builder.bitcast(array.data, context.get_value_type(kept).as_pointer())
            return builder.load(pointer, align=8)

        return kept(buffer), generate

    return take


def _put(_context: Any, buffer: Any, value: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        array = context.make_array(signature.args[0])(context, builder, arguments[0])
        pointer = builder.bitcast(array.data, arguments[1].type.as_pointer())
        builder.store(arguments[1], pointer, align=8)
        return context.get_dummy_value()

    return types.void(buffer, value), generate


_put_away: Any = intrinsic(_put)

take_bound = _taker(BOUND)
"""Take a `Bound` out of a buffer; for kernels."""

take_drive = _taker(DRIVE)
"""Take a `Drive` out of a buffer; for kernels."""


@kernel()
def bind(buffer, value):
    """Keep a `Bound` or a `Drive` in a buffer."""
    _put_away(buffer, value)


def new_buffer(kept: Any) -> Floats:
    """An empty buffer with room for a value of a type, `BOUND` or `DRIVE`."""
    return np.zeros(_words(kept))


def _words(kept: Any) -> int:
    """How many times eight bytes the compiled code needs for a value of a type, at most."""
    if isinstance(kept, types.Array):
        return 5 + 2 * kept.ndim
    return sum(_words(part) for part in kept) if hasattr(kept, "__iter__") else 1
