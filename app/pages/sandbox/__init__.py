"""The page with a body: its tab, its features, and the files that are sent to browsers."""
