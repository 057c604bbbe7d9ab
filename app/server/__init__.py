"""Serving pages, and the one thread that runs them."""
