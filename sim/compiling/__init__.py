"""Which kernels are ready, and compiling them in the background."""
