"""A kernel for each method, and what they share."""
