"""Scenes outside the program: files, folders and links, and sentences for what is wrong with them."""
