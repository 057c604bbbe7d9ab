"""What a user takes home: pictures, films, replays and models of a scene, made without a page."""
