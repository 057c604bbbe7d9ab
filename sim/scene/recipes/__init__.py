"""Recipes: a body from a few numbers. Each family has a module; `recipe` has them all."""
