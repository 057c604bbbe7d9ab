"""Time: the bar under the body, and the commands that play, step and go back."""
