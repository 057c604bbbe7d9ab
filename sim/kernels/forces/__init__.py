"""Forces of springs and joints, and the motion of held masses."""
