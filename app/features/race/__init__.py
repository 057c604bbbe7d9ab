"""A race of the body against another one: the rival is found, and both are watched."""
