"""The picture of the body: what the server sends of it, and what the script draws over and under it."""
