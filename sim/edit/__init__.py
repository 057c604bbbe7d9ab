"""Editing scenes: pure functions from one scene to another, and how a motion continues across edits."""
