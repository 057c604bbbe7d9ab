"""From a scene to a body: the read-only tables of the kernels, and what a body has at its start."""
