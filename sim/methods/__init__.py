"""The methods of integration: a row each, their coefficients and their stability limits."""
