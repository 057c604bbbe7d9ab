# The strip of muscles over the bar of time: a beat from left to right, with a mark for each muscle.

muscles-strip = Muscles
muscles-how = Drag a mark sideways: when it moves. Up or down: how far.
# A choice between groups of muscles and single ones.
muscles-kinds = What is moved
    .groups = { $count } groups
    .muscles = { $count } muscles
muscles-selected = { $count ->
    [one] { $count } muscle selected
   *[other] { $count } muscles selected
}
# What a mark is of; $to is the last of a group.
muscles-spring = spring { $number }
muscles-joint = joint { $number }
muscles-springs = group { $group }, springs { $from } to { $to }
muscles-joints = group { $group }, joints { $from } to { $to }
# How far a muscle moves, and when.
muscles-moves = { $size } at { $crest } of the beat
muscles-pointed = { $muscle }: { $moves }
# A mark for a screen reader.
muscles-mark = Muscle of { $muscle }
    .selected = Muscle of { $muscle }, selected
# Controls.
muscles-tempo = Tempo
    .hertz = Tempo in Hz
muscles-wave = Wave of the selected muscles
    .sine = Sine
    .pulse = Pulse
muscles-often = Waves in a beat of the selected muscles
muscles-spread = Spread
    .hint = The selected muscles move one after the other, evenly over the beat
