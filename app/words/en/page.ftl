# What all pages have in common.

# What a screen reader calls the canvas.
canvas-body = The body
line-away = Not connected. Reconnecting…
