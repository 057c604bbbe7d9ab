"""A kernel for each integration method, and what they share."""
