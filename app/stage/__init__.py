"""Drawing a body without a page: colours, shapes, what does not move, and what is sent of it."""
