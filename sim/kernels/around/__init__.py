"""What acts on a body besides springs and gravity; compiled only for scenes that have any of it."""
