"""Which scene is shown: the gallery, the shelf, lessons, and whose the scenes are."""
