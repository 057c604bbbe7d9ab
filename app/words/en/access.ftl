# The page Access of the View menu.

access-title = Access and language
access-language = Language
    .hint = Of the page; scenes of your own stay in theirs. The body and what can be undone are kept.
access-letters = Letters as keys
    .hint = For those who speak their texts, or press keys by mistake. Keys with Ctrl, arrows and Esc always work.
    .always = always
    .body = while the body has the focus
    .never = never
access-taps = Tap instead of drag
    .hint = Tap a thing, then where it goes. Esc, or another tap on the thing, puts it back. Dragging works as well.
access-larger = Larger
    .hint = Everything larger and bolder.
access-contrast = More contrast
    .hint = Letters and edges stand out more.
access-still = Less motion
    .hint = Wind, views and marks do not move by themselves. The body moves when it is played.
access-sound = Sound
    .hint = Of plots, of modes, and of what touches and breaks.
access-events = Spoken events
    .hint = A screen reader says in few words what happens: what breaks, touches, comes to rest, is taken or let go. At most one sentence in two seconds.
access-kept = This device keeps these settings.

# While something is picked up by a tap, and after that; $thing is one of the names below, or that of an instrument, a
# bar or a mark.
taps-held = Picked up: { $thing }. Tap where it goes. Esc, or a tap on it, puts it back.
taps-put = Put down: { $thing }
taps-back = Put back: { $thing }
taps-nothing = There is nothing to pick up here; a body that is paused is easier to tap.
taps-button = Put back
taps-selection = selection
taps-frame = corner of a frame
taps-cut = end of a cut
taps-turn = rest angle of a joint
taps-picture = picture
# Of a plot: the end of the part of the time that is to be shown larger.
taps-part = end of the part to enlarge
