"""`softrod improve`: a search for the settings with which a scene comes nearest to a goal."""
