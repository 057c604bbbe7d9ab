"""Messages between a page and its server, each a structure; docs/wire.md lists them.

- `messages`: their base classes, and `read`, which refuses whatever is not exactly one of them.
- `from_page`, `to_page`: messages that belong to no feature; features declare their own.
- `sections`: arrays of numbers with named sections.
- `carrier`: the kind of viser's messages that carries them, both ways.
"""
