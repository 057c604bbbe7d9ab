"""A class: a teacher's page, a wall, and the pupils' seats, on one server."""
