"""All that touches the inside of numba and LLVM, so that a new version of them is one review.

Checked with numba 0.68.1 and llvmlite 0.50.0; `pyproject.toml` has the range that is allowed.

| module | what it uses that numba does not document |
|---|---|
| `jit` | `Compiler.define_pipelines` and `flags.noalias`, the option `_nrt` |
| `kept` | a dispatcher's `_cache`, `CompileResult._reduce` and `_rebuild`, `magic_tuple`, `dumps` |
| `table` | `_numba_type_`, `AttributeTemplate`, `lower_setattr_generic`, `populate_array` |
| `addresses` | `fndesc`, `call_conv`, functions called by their address |
| `lanes` | attributes of LLVM's functions: the width of vectors, and gathers on AMD processors |
| `bits` | `llvmlite.ir`, for the bits of a number |
"""
