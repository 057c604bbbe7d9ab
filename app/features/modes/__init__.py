"""The strip of modes: how much of each slow vibration is in the motion, and how to put the body into one."""
