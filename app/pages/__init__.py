"""The page: what it draws and its controls."""
