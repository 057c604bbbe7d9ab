"""Scenes, which users edit and save: types with ranges, validation, files, and recipes."""
