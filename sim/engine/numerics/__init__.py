"""Functions of numbers and of small vectors that kernels call."""
