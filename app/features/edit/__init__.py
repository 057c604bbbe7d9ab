"""Tools that build and change the body."""
