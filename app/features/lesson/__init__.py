"""The scene's lesson: its steps, with what each of them shows."""
