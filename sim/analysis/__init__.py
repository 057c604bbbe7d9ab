"""What is asked of a body beside its motion: where it rests, how it vibrates, how many of it end."""
