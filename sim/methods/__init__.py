"""The integration methods: a table with one row each, their coefficients and their stability limits."""
