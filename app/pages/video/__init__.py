"""The page that reads places off a video."""
