"""The page of a body: its tab, its features, and the files that a browser gets."""
