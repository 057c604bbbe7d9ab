# What all pages have in common.

# What a screen reader calls the canvas.
canvas-body = The body
line-away = Not connected. Reconnecting…
line-body-waits = Not connected: your body waits. Reconnecting…
line-blocked = The page has loaded, but its live connection fails: something on the way blocks WebSockets. Try another network, such as the hotspot of the computer that softrod runs on.
dialog-close = Close
