"""Keeps track of the kernels that are compiled, and compiles them in the background."""
