"""Energies, and the work that changes them."""
