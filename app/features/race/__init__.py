"""A race of the body against another one."""
