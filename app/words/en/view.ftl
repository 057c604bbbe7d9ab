# The View menu over the bar of time, and the help.

view-menu = View
    .hint = View: dark, projector, help and more
# Buttons of the View menu that move what is seen.
view-move = Move the view
    .left = Farther left
    .up = Farther up
    .down = Farther down
    .right = Farther right
    .farther = Farther away
    .nearer = Nearer
view-help = How to use softrod
# Three pictures, each with a word in bold and the rest of the sentence.
view-help-drag = <b>Drag</b> any mass. Held ones stay where you leave them, free ones fall. Drag the paper to move it, scroll or pinch to zoom.
view-help-change = <b>Change</b> stiffness, damping, lengths and angles in the Play tab, or draw a body of your own with Edit.
view-help-measure = <b>Measure</b> with plots that read off period and damping, with arrows, a ruler, a protractor and a stopwatch.
view-help-time = The bar below the body goes back to any moment of the run. Play goes on from the moment that it shows; what happened before you went back stays as a thin line. Click or tap a mass to read its joint.
