"""Hands on the body: pointers, the arrow keys, and a mass that is clicked."""
