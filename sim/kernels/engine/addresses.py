"""Calling a kernel through the address of its machine code."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba import types
from numba.extending import intrinsic


def address_of(kernel: Any, signature: Any) -> int:
    """The address of a kernel's machine code, which is compiled if need be."""
    result = kernel.get_compile_result(signature)
    return result.library.get_pointer_to_function(result.fndesc.llvm_func_name)


def caller(signature: Any) -> tuple[Any, Callable[..., Any]]:
    """What an intrinsic returns that calls a kernel with a signature: its own signature, whose first argument
    is the address, and the generator of its code."""

    def generate(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        convention = context.call_conv
        function = convention.get_function_type(signature.return_type, signature.args).as_pointer()
        pointer = builder.inttoptr(arguments[0], function)
        # Kernels raise nothing, so the status need not be checked.
        _, result = convention.call_function(
            builder, pointer, signature.return_type, signature.args, arguments[1:]
        )
        return result

    return signature.return_type(types.int64, *signature.args), generate


def intrinsic_call(function: Any) -> Any:
    """numba's `intrinsic`, whose first parameter is not one of the caller's."""
    return intrinsic(function)
