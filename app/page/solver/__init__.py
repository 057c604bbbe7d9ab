"""The Solver tab."""
