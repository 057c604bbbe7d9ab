"""Muscles: the strip of their beat, and how springs and joints become some."""
