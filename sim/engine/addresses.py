"""Calling a kernel through the address of its machine code."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
from numba import types
from numba.extending import intrinsic

ADDRESSES = np.zeros(256, np.int64)
"""Addresses of the kernels of forces, by number; 0 for a kernel that is not loaded, `NONE` for one that a
force does not have. They are shared by all bodies, see `forces.environment.Environment.calls`."""

NONE = -1
"""Address that stands for a kernel that a force does not have."""


def address_of(kernel: Any, signature: Any) -> int:
    """Return the address of a kernel's machine code, compiling it if necessary."""
    result = kernel.get_compile_result(signature)
    return result.library.get_pointer_to_function(result.fndesc.llvm_func_name)


def calls(signature: Any) -> Any:
    """Return a function for kernels that calls a kernel: (its address, its arguments ...)."""

    def call(_context: Any, _address: Any, *_arguments: Any) -> Any:
        return signature.return_type(types.int64, *signature.args), generate

    def generate(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        convention = context.call_conv
        function = convention.get_function_type(signature.return_type, signature.args).as_pointer()
        pointer = builder.inttoptr(arguments[0], function)
        # Kernels raise no exceptions, so the status need not be checked.
        _, result = convention.call_function(
            builder, pointer, signature.return_type, signature.args, arguments[1:]
        )
        return result

    # numba would pack the arguments of a variadic function into a tuple.
    names = ("context", "address", *(f"argument_{i}" for i in range(len(signature.args))))
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    call.__signature__ = inspect.Signature([inspect.Parameter(name, kind) for name in names])  # type: ignore[attr-defined]
    return intrinsic(call)
