"""What holds for every run of the tests."""

import os

from hypothesis import HealthCheck, settings

from tests.amount import examples  # here, before other processes are started: it fixes the day

# Read when NumPy is loaded, so it is set here, before any test is. On a machine with other things to do,
# threads that share the algebra of small matrices mostly wait for each other, for minutes on end.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# A machine with other things to do is no reason to fail.
settings.register_profile(
    "softrod", max_examples=examples(100), deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("softrod")
