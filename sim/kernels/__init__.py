"""Compiled kernels. Everything here is numba code and independent of scenes and files."""
