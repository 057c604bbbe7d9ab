"""Who is compared: a module for each, which says what it can do with a scene."""
