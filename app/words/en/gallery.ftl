# The gallery: a dialog with a card for each scene.

gallery-title = Scenes
gallery-search = Find a scene
gallery-new = New, from nothing
gallery-none = No scene has all of these words.
gallery-groups = Groups of scenes
# The groups; headings, and choices of what is shown.
gallery-all = All
gallery-own = Your own
gallery-shared = Saved on this computer
gallery-start = Start here
gallery-lessons = Lessons
gallery-muscles = Muscles
gallery-bodies = Bodies
gallery-tutorial = Tutorial
gallery-studies = Studies
# Before a button with the title of the empty scene.
gallery-none-saved = You have saved no scene yet. Save the one that you see in the Share tab, or build one:{" "}
# Beside a scene in "Find anything".
gallery-scene = Scene
# What can be done with a scene; label: for a screen reader, which says the scene, too.
gallery-rename = Rename
    .label = Rename { $title }
    .name = New name of { $name }
gallery-copy = Copy
    .label = Copy { $title }
gallery-delete = Delete
    .label = Delete { $title }
gallery-use = Use in class
    .label = Use in class { $title }
gallery-cancel = Cancel
# What was done.
gallery-renamed = It is called { $name } now.
gallery-copied = The copy is called { $name }.
gallery-deleted = { $name } is deleted.
gallery-restored = { $name } is back.
# A command for a terminal, with a button that copies it.
gallery-command = Command
    .about = Only this computer reaches this server. A class that others can come to begins in a terminal:
    .copy = Copy
    .copied = Copied
    .keys = Press Ctrl+C
# Titles of notices; below them stands why.
gallery-not-opened = That scene cannot be opened
gallery-not-used = That scene cannot be used in a class
gallery-no-class = No class has begun
gallery-gone = there is no scene called { $name } any more
