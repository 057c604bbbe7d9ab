"""What a page and its server say to each other, every message a structure; docs/wire.md lists them.

- `from_page`: what a page says, and `read`, which refuses whatever is not exactly one of these.
- `to_page`: what the server tells a page: states, of which the latest counts, and events, which all arrive.
- `commands`: the one table of what keys, buttons and the palette do.
- `carrier`: the one kind of viser's messages that carries all of it, both ways.
"""
