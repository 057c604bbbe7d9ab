"""The largest size of many numbers, as fast as memory goes.

A maximum of floats that does not lose NaN is found one by one, in four cycles each. The bits of positive
floats, read as integers, are in the same order, with NaN above all; their maximum is found eight at a time.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic

_SIGN = 1 << 63


def _size_bits(_context: Any, number: Any) -> Any:

    def generate(_context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        integer = builder.bitcast(arguments[0], ir.IntType(64))
        return builder.and_(integer, ir.Constant(ir.IntType(64), _SIGN - 1))

    return types.int64(number), generate


def _bits(_context: Any, number: Any) -> Any:

    def generate(_context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        return builder.bitcast(arguments[0], ir.IntType(64))

    return types.int64(number), generate


def _from_bits(_context: Any, bits: Any) -> Any:

    def generate(_context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        return builder.bitcast(arguments[0], ir.DoubleType())

    return types.float64(bits), generate


size_bits: Any = intrinsic(_size_bits)
"""size_bits(number): the bits of |number|, as an integer."""

bits: Any = intrinsic(_bits)
"""bits(number): the bits of a number that is not negative, as an integer."""

from_bits: Any = intrinsic(_from_bits)
"""from_bits(bits): the float that has these bits."""
