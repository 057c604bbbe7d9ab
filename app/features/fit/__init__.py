"""A table of what was measured, and the fit of the scene to it."""
