"""Editing scenes: pure functions from a scene to another, and how a motion goes on over them."""
