"""From a scene to the read-only tables of the kernels."""
