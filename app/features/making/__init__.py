"""A lesson is made in the page."""
