"""Scenes, which users edit and save: types with ranges, validation, files, and the recipe of a rope."""
