"""`python -m app` is `softrod`."""

from .cli.main import main

main()
