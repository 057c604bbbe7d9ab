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
