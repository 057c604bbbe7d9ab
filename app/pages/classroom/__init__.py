"""The page of a pupil, and of the wall: without viser, by a line of its own."""
