"""Scenes, which users edit and save: types with ranges, validation, lessons, and recipes."""
