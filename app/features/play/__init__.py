"""The Play tab: the scene, the sliders that make most of it, and all other numbers of the body."""
