"""From a scene to a body: the read-only tables of the kernels, and the initial state."""
