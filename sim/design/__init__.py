"""Backwards: from what a body is to do to its numbers."""
