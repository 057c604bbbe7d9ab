# Notices of what a page simulates; below their titles stands why.

session-not-done = That cannot be done
# Undo and redo that lead to another scene; $before: the one that was shown until then.
session-back = Back to “{ $title }”
    .undo = Undo leads to “{ $before }” again.
    .redo = Redo leads to “{ $before }” again.
# A body that cannot keep its shape.
session-no-shape = This shape cannot be kept
    .line = The line shows where it goes.
    .stiffen = The button “Keep it, { $times } times as stiff” makes it so.
