"""Compiled kernels. Everything here is numba; nothing here knows of scenes or files."""
