"""`softrod sweep`: many runs of one scene over a grid of its settings, and a table of what is measured."""
