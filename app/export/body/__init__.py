"""A body as numbers: plain data, and short programs that move it."""
