"""Drawing a body: colours, shapes, the plan that is sent of it, and the scripts that draw it."""
