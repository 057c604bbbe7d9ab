"""What is measured on the canvas."""
