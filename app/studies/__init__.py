"""Studies: the solver held against exact results."""
