"""`softrod validate`: the solver held against exact results."""
