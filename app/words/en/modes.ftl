# The strip of modes over the bar of time: a bar for each slow vibration of the body.

modes-strip = Modes
modes-close = Close the modes
    .hint = Close
modes-how = Point at a bar, or Tab to it, for its shape. Move it up: the body swings so. Press and hold it, or Space: it is driven.
modes-looking = The modes are being looked for.
# $why: a sentence without its full stop.
modes-none = No modes: { $why }.
modes-still = it does not vibrate about its pose at rest
modes-shown = Modes are shown over the bar of time
# What a bar says.
modes-reading = { $swings ->
    [no] Mode { $number }: { $frequency } Hz, { $amplitude }, does not swing, { $share } of the energy
   *[yes] Mode { $number }: { $frequency } Hz, { $amplitude }, damping { $damping }, { $share } of the energy
}
modes-reading-driven = { $swings ->
    [no] Mode { $number }: { $frequency } Hz, { $amplitude }, does not swing, driven
   *[yes] Mode { $number }: { $frequency } Hz, { $amplitude }, damping { $damping }, driven
}
# The last bar, and the word below it; lacks: where the modes would have more energy than the body has.
modes-others = In none of these: faster modes, and what a large motion has beyond small ones: { $share } of the energy
    .lacks = In none of these: faster modes, and what a large motion has beyond small ones; the modes alone would have { $share } more
    .word = else
modes-share = { $percent } %
    .least = less than 0.1 %
# For a screen reader.
modes-bar = Mode { $number }, { $frequency } hertz
    .others = In no mode
modes-value = { $amplitude }, { $share } of the energy
modes-driven = Mode { $number } is driven
modes-level = Mode { $number }: { $percent } percent of a full bar
modes-volume = Volume
modes-sound = Sound of the modes
    .on = Sound: on
    .off = Sound: off
