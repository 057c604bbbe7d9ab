"""Functions of numbers and small vectors that kernels call."""
