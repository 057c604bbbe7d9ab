"""What a user takes home of a scene: pictures, films, replays, models, data and programs."""
