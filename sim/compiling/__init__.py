"""Keeps track of which kernels are compiled, and compiles them in the background."""
