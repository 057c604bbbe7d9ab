# What frames the sandbox page: its panel, notices, search, number boxes and lines of numbers.

# A list of rest angles, all joints the same.
ui-templates = Angle template
# The label of a slider whose parts have different values; in its hint, what the slider then does; and below
# the sliders, with what it does.
ui-mixed = { $setting } (mixed)
    .angles = the slider turns the first angle, and the others by as much
    .numbers = the slider sets the largest number, and the others keep their ratio to it
    .note = <b>mixed</b>: { $what }.
# What a number may be, as in "0 to 200 kg/s".
ui-range = { $low } to { $high }

# Names of keys, as they are printed on keyboards. Letters and digits stay as they are.
key-ctrl = Ctrl
key-shift = Shift
key-space = Space
key-esc = Esc
key-delete = Delete
key-backspace = Backspace
key-tab = Tab
# Two keys, or groups of keys, that do the same.
key-or = { $one } or { $other }
# The tooltip of a button that a key presses, too.
key-too = { $text } ({ $key })
# Beside a command that is found: its keys; held: they act as long as they are held.
key-of = key { $keys }
    .held = key { $keys }, held

# The panel beside the body, a sheet on phones.
ui-panel = Controls
    .hide = Hide the panel
    .show = Show the panel
    .down = Hide the controls
    .up = Show the controls
# The button with the scene's title, on phones.
ui-scene = { $title }: choose another scene
ui-close = Close
ui-progress = Progress
# A switch, where it is found.
ui-on = on
    .off = off
# Words of a plot for a screen reader. $label: what is plotted, with its unit; numbers are without one. The axis of the time.
ui-plot-time = time, s
ui-plot-said = { $label }: now { $now }; lowest { $low } at { $lowAt } s, highest { $high } at { $highAt } s.
# Over another quantity, $across, with its unit.
ui-plot-over = { $label }: now { $now }; lowest { $low } where { $across } is { $lowAt }, highest { $high } where it is { $highAt }.
ui-plot-level = { $label }: { $now } all the time.
ui-plot-none = { $label }: no values yet.
# What keys do in it.
ui-plot-keys = Arrows left and right show another part of the time, up and down a shorter or longer one, Home all
# A line below a plot that opens a table.
ui-plot-numbers = Numbers
    .caption = { $count } of the numbers in view, evenly spread; close and open it for newer ones

# What "Find anything" has found.
ui-found = Found
    .none = Nothing is called this. What belongs to a mass, a spring or a joint is found once one is selected.

# Why a number that was typed is not taken; $least and $most are numbers with their units.
ui-number-unclear = { $written } could be { $one } or { $other }. Write one of these.
ui-number-none = “{ $written }” is not a number. Write one as 20000, 2e4 or 0.05.
ui-number-least = At least { $least }.
ui-number-most = At most { $most }.
ui-number-sign = Change the sign

# While there is no connection.
ui-away = Not connected: your body waits. Reconnecting…
ui-blocked = The page has loaded, but its live connection fails: something on the way blocks WebSockets. Try another network, such as the hotspot of the computer that softrod runs on.
ui-loading = Loading…
    .later = On a slow network the first time takes up to half a minute.
ui-needs-javascript = softrod needs JavaScript, which is switched off here.
ui-needs-webgl = softrod draws with WebGL 2, which this browser does not have or has switched off: allow hardware acceleration in its settings, or use another browser.
ui-other-viser = This page cannot draw: its viser page is not the version that softrod supports.
# These two stand before a button that loads the page again.
ui-not-loaded = The page did not arrive whole:
ui-no-canvas = The browser no longer draws this page. Your body is saved:
    .reload = Reload

# The arrow pad of touch screens.
ui-pad = Arrow keys
    .up = Up
    .left = Left
    .down = Down
    .right = Right

# What a screen reader says of the body.
ui-body = { $count ->
    [one] Body of { $count } mass
   *[other] Body of { $count } masses
}
# The mass that keys have chosen, and its place.
ui-mass = mass { $mass }, { $place }
    .first = mass { $mass }, { $place }. Arrows choose, Space takes hold
    .tools = mass { $mass }, { $place }. Arrows choose, Enter does what the tool does, + adds a mass, X moves a cross
    .held = mass { $mass } in hand. Arrows move it
    .free = mass { $mass } let go
    .none = no mass
# A place on the canvas, in the scene's unit.
ui-place = x { $x }, y { $y } { $unit }
# Another scene was opened.
ui-opened = { $title } is open
ui-exploded = The body exploded and is stopped
ui-running = Running
    .paused = Paused
ui-broken = { $count ->
    [0] No springs broken
    [one] { $count } spring broken
   *[other] { $count } springs broken
}

# Titles and texts of notices.
ui-too-much = Too much at once
    .text = The last requests were ignored. Try again in a moment.
ui-stopped = This page has stopped
    .text = There was an error on the server. Reload the page to go on.
ui-undo-afresh = Undo starts afresh
    .text = What was changed before the connection was lost can no longer be undone.
ui-commas = Decimal commas
    .hint = tables that are saved have 0,5 for 0.5, and semicolons between the columns

# Why a scene is not there or not saved; below a title.
ui-no-preset = there is no preset called { $name }; choose one in the gallery
ui-no-user = the page has not identified its user; reload it and try again
ui-no-room = you have { $count } scenes here, the maximum; delete some first
    .computer = this computer has no room for more scenes of visitors; download it as a file

# The tabs of the panel.
ui-tab-play = Play
ui-tab-measure = Measure
ui-tab-solver = Solver
ui-tab-share = Share
ui-tab-lesson = Lesson

# The title of a notice: something is too large. The text below it says how large it may be.
ui-unsent = That cannot be sent
    .text = It is too large for a page to send: at most 4.7 MB, which is some 11,000 masses.
ui-unsent-resume = That cannot be resumed
ui-unsent-link = That cannot be opened
ui-unsent-file = That cannot be opened
ui-unsent-paste = That cannot be pasted
ui-unsent-rival = That cannot be raced against
# Titles of notices; below them stands why.
ui-all-controls = All controls are shown
ui-no-scene = That address has no scene
