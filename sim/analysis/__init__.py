"""Analyses of a body: equilibrium, vibrations, decay, predictability and comparison of methods."""
