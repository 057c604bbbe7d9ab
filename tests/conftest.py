"""What holds for every run of the tests."""

import os

# Read when NumPy is loaded, so it is set here, before any test is. On a machine with other things to do,
# threads that share the algebra of small matrices mostly wait for each other, for minutes on end.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
