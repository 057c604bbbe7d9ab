"""What is measured of the solver: against exact results, against other programs, and over many settings.

Nothing that runs a page imports this package; it imports `sim` and `app`.
"""
