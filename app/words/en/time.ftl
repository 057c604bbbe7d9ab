# The bar of time under the body.

time-bar = Time
    .more = More of time
# The button that plays from a moment in the past; word: beside its icon, part of the name.
time-go-on = Go on from here
    .word = Go on
time-speed = Speed
    .hint = Simulated seconds per second
# The slider of time, and what it says.
time-shown = Time shown
    .said = { $seconds } seconds
# The oldest moments of a long run are dropped.
time-lost = Of the time before { $seconds } s too much happened to be kept.
time-past = The thin line is what happened before you went back.
# While less motion is wished; Play is what the button of the bar is called.
time-stands = Less motion is wished, so the body stands until you press Play.
