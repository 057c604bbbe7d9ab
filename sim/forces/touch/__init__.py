"""What pushes where things touch, and rubs there: walls, and the parts of bodies."""
