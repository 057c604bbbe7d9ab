"""Scenes outside the program: files, folders, links, and what is wrong with them, in sentences."""
