"""What kernels are made of: how they are compiled, and the tables that they read."""
