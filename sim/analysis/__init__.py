"""Analyses of a body: its equilibrium, its vibrations, and runs of many bodies."""
