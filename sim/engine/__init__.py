"""Everything that depends on internals of numba and LLVM, so that only this needs review for a new version.

Checked with numba 0.68.1 and llvmlite 0.50.0; `pyproject.toml` has the allowed range.

| module | undocumented parts of numba that it uses |
|---|---|
| `jit` | `Compiler.define_pipelines` and `flags.noalias`, the option `_nrt` |
| `kept` | a dispatcher's `_cache`, `CompileResult._reduce` and `_rebuild`, `magic_tuple`, `dumps` |
| `table` | `_numba_type_`, `AttributeTemplate`, `lower_setattr_generic`, `populate_array` |
| `addresses` | `fndesc`, `call_conv`, functions called by their address |
| `lanes` | attributes of LLVM's functions: the width of vectors, and gathers on AMD processors |
| `bits` | `llvmlite.ir`, for the bits of a number |
"""
