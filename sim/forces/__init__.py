"""What acts on masses: a page for each force, and the list that joins them."""
