"""The pages of a class: the teacher's desk, the wall, and the pupils' seats."""
