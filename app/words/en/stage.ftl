# Over the canvas, beside the body.

# The arrow at the edge of the canvas, where the body has gone.
stage-away = The body is out of view. Show the whole scene
# At the mass with a ring, until somebody drags a mass.
stage-drag = drag me
# On an empty canvas: before the tool is chosen, and then, for a finger or a mouse, and where taps stand for drags.
stage-empty = Nothing is built here yet.
    .draw = Draw a body
    .tap = Tap for a mass. Drag from a mass for a spring.
    .click = Click for a mass. Drag from a mass for a spring.
    .taps = Tap for a mass. Tap a mass, and then another, for a spring.
