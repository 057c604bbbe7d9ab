# The Share tab, and the dialog with a link.

files-name = Name
files-pose = With pose
    .hint = save where every mass is now, too
files-save = Save
files-download = Download as a file
files-save-log = Save a log
files-open = Open a file
files-about-logs = A log is all that was done since the start or the last reset; opened as a file, it does the same again.
# Before a scene is replaced; $name in quotation marks.
files-sure = Are you sure?
files-replace = Replace the saved scene { $name }?
    .yes = Replace
    .no = Cancel
files-saved = Saved
    .text = The scene is saved as { $name }.
# Titles of notices, and what they say.
files-failed = That did not work
    .error = There was an error on the server.
files-one = One at a time
    .text = Another file of this page is still being made.
files-about-file = About the file
files-about-program = About the program
files-no-body = there is no body yet
files-no-measure = { $table }: a table is fitted in the Measure tab, which this page does not have
files-not-opened = That link cannot be opened
# What is taken home: buttons, and commands for "Find anything".
files-home = <b>Take it home.</b> A picture of the page, a film of the last seconds for slides and messages, a replay that any browser shows without a network, a live file in which the body can be dragged and tuned there, too, or a model of it for Blender and the like, still or animated. Keyframes are a table of where its masses were, 60 times a second.
files-programs = <b>For programs.</b> The body as it is now: its numbers as JSON or as CSV tables, or a program that moves it by the tutorial's step; the one in JavaScript is for games.
files-seconds = Seconds
    .hint = simulated seconds of what moves in a file
files-picture = Picture
    .hint = key I
files-body-as = Body as
files-gif = GIF
    .command = Film of the last seconds (GIF)
files-replay = Replay file
    .command = Replay file of the last seconds (HTML)
files-live = Live file
    .command = Live file of the body as it is now (HTML)
files-model = 3D model
    .command = 3D model (GLB)
files-animation = Animated model
    .command = Animated 3D model of the last seconds (GLB)
files-motion = Keyframes
    .command = Keyframes of the last seconds (CSV)
files-json = JSON
    .command = Numbers of the body (JSON)
files-csv = CSV
    .command = Numbers of the body (tables in CSV)
files-python = Python
    .command = Program in Python
files-c = C
    .command = Program in C
files-javascript = JavaScript
    .command = Program in JavaScript, for games
# The dialog with a link to the scene: two kinds of it, each with a sentence about it.
share-title = Share this scene
share-what = What to share
share-short = A short address
    .about = To type or to photograph: for a class. This server stores the scene, and has to run when it is opened.
share-long = A link that holds the scene
    .about = To send and to keep: any softrod opens it, even next year. Nothing is stored on the server.
share-pose = With the present pose
# What whoever opens it can do.
share-controls = Controls for whoever opens it
    .all = All controls
    .play = For a phone: play and drag only
    .sliders = For a phone: with the scene's two main sliders
share-link = Link to this scene
    .code = QR code of the link
share-copy = Copy link
    .copied = Copied.
    .keys = Press Ctrl C to copy it.
share-long-mail = The link has { $count } characters: some e-mail programs cut links longer than 2,000.
    .file = The link has { $count } characters: many messengers cut links longer than 8,000. Send the scene as a file instead (Share, Download as a file).
share-own-machine = This address is of this machine alone. For others to open it, start softrod with --host 0.0.0.0, or with --public-url behind a proxy.
