"""What all kernels use: how they are compiled, and the tables that they read."""
