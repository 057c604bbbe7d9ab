"""What is measured: plots, arrows, traces and instruments."""
