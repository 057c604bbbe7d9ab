"""The softrod application: the viser page and the gate in front of it."""
