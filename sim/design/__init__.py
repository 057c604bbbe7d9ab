"""Inverse problems: from what a body should do, or was measured to do, to its parameters."""
