"""Softrod beside what one would take instead: physics engines, solvers of equations, loops in C and NumPy."""
