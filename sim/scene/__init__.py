"""Scenes: what users edit and save. Types with ranges, validation, files, the recipe of a rope."""
