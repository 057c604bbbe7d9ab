"""`python -m app` is `softrod`."""

from .cli import main

main()
