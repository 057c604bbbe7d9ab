"""Vectors of numbers: how wide LLVM makes them and how it loads them, and those it does not make by itself.

What loops do at a time is LLVM's choice. For processors that have registers for eight numbers it often
chooses four, since some of them do the rest of a program slower then; a kernel that does little else is
better off with eight. So are all that hand over vectors to such a one: what is stored in fours cannot be
loaded in eights without waiting.

Arithmetic of two numbers at a time is for loops whose rounds wait for each other. Two numbers are a tuple.
LLVM makes one vector of the two as long as they go from one of these functions to the next, or are neighbours
in an array.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from .jit import kernel

_VECTOR = ir.VectorType(ir.DoubleType(), 2)
_LANES = [ir.Constant(ir.IntType(32), lane) for lane in range(2)]

_FLAGS = ("contract",)
"""A product and the sum that it is part of may be one instruction."""


def _eight_at_a_time(_context: Any) -> Any:
    def generate(context: Any, builder: ir.IRBuilder, _signature: Any, _arguments: Any) -> ir.Value:
        # One of LLVM's attributes that have a value, which llvmlite's own `add` does not know.
        set.add(builder.function.attributes, '"prefer-vector-width"="512"')
        return context.get_dummy_value()

    return types.void(), generate


eight_at_a_time: Any = intrinsic(_eight_at_a_time)
"""Let loops of the function that calls this do eight numbers at a time, or as many as the processor can."""


def _scalar_gathers_on_amd(_context: Any) -> Any:
    def generate(context: Any, builder: ir.IRBuilder, _signature: Any, _arguments: Any) -> ir.Value:
        _, processor, features = context.codegen().magic_tuple()
        if processor.startswith("znver"):
            attributes = builder.function.attributes
            set.add(attributes, f'"target-cpu"="{processor}"')
            set.add(attributes, f'"target-features"="{features},+prefer-no-gather"')
        return context.get_dummy_value()

    return types.void(), generate


scalar_gathers_on_amd: Any = intrinsic(_scalar_gathers_on_amd)
"""Let loops of the function that calls this load numbers through indices one by one on AMD's processors.

Their instruction that gathers eight numbers takes longer than eight loads, which LLVM does not know. On
Zen 4, a run of a cloth or a tree takes a fifth to a quarter less time so.
"""


@kernel(forceinline=True)
def whole_eights(count):
    """The count, rounded up to a multiple of eight."""
    return (count + 7) // 8 * 8


def _on_vectors(operation: Callable[..., ir.Value]) -> Callable[..., ir.Value]:
    """Code that does an operation on tuples, given how it is done on vectors."""

    def generate(_context: Any, builder: ir.IRBuilder, _signature: Any, arguments: Any) -> ir.Value:
        vectors = []
        for argument in arguments:
            vector = ir.Constant(_VECTOR, ir.Undefined)
            for k, lane in enumerate(_LANES):
                vector = builder.insert_element(vector, builder.extract_value(argument, k), lane)
            vectors.append(vector)
        vector = operation(builder, *vectors)
        result = ir.Constant(arguments[0].type, ir.Undefined)
        for k, lane in enumerate(_LANES):
            result = builder.insert_value(result, builder.extract_element(vector, lane), k)
        return result

    return generate


def _of_two(operation: Callable[..., ir.Value]) -> Any:
    @intrinsic
    def pairs(_context: Any, a: Any, b: Any) -> Any:
        return a(a, b), _on_vectors(operation)

    return pairs


def _of_three(operation: Callable[..., ir.Value]) -> Any:
    @intrinsic
    def pairs(_context: Any, a: Any, b: Any, c: Any) -> Any:
        return a(a, b, c), _on_vectors(operation)

    return pairs


product = _of_two(lambda builder, a, b: builder.fmul(a, b, flags=_FLAGS))
"""product(a, b) = a b."""

quotient = _of_two(lambda builder, a, b: builder.fdiv(a, b, flags=_FLAGS))
"""quotient(a, b) = a / b."""

sum_of = _of_two(lambda builder, a, b: builder.fadd(a, b, flags=_FLAGS))
"""sum_of(a, b) = a + b."""

plus_product = _of_three(
    lambda builder, a, b, c: builder.fadd(a, builder.fmul(b, c, flags=_FLAGS), flags=_FLAGS)
)
"""plus_product(a, b, c) = a + b c."""

less_product = _of_three(
    lambda builder, a, b, c: builder.fsub(a, builder.fmul(b, c, flags=_FLAGS), flags=_FLAGS)
)
"""less_product(a, b, c) = a - b c."""
