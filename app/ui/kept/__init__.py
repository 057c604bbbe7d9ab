"""The state of a page that its browser stores, and links that open a scene."""
