"""Builds the read-only tables of the kernels from a scene."""
