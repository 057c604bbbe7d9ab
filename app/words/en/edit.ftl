# The tools that build and change the body, and what is selected.

# The bars of the tools, for a screen reader.
edit-tools = Editing
edit-bar = What is selected
# What a tool waits for on a phone, where the tools have no words.
edit-waits-build = Tap for a mass, drag for a spring
edit-waits-joint = Tap a mass, then an angle at it
edit-waits-select = Tap a part, or drag round some
edit-waits-cut = Drag across springs
# Buttons.
edit-paste = Paste
edit-done = Done
edit-rests = Moved rest
    .hint = Springs and joints of what is moved take their new lengths and angles as rest, or keep the old ones
edit-stiffen = Keep it, { $times } times as stiff
# What can be undone and redone; the key follows in brackets.
edit-undo = Undo: { $what }
    .none = Nothing to undo
    .done = Undone: { $what }
edit-redo = Redo: { $what }
    .none = Nothing to redo
# Parts; numbers of several kinds stand in a list, "2 masses, 1 spring".
edit-masses = { $count ->
    [one] { $count } mass
   *[other] { $count } masses
}
edit-springs = { $count ->
    [one] { $count } spring
   *[other] { $count } springs
}
edit-joints = { $count ->
    [one] { $count } joint
   *[other] { $count } joints
}
edit-parts = { $count ->
    [one] { $count } part
   *[other] { $count } parts
}
# A single part by its number.
edit-mass = mass { $number }
edit-spring = spring { $number }
edit-joint = joint { $number }
edit-selected = { $parts } selected
    .none = Nothing selected
# For a screen reader: the tools were opened, with the name of the one that is in hand; a spring is begun.
edit-open = Tools open: { $tool }
    .closed = Tools closed
edit-begins = A spring begins at mass { $mass }: Enter at another one joins them and goes on from there, Esc ends it
    .ended = The spring is given up
# A cross that arrow keys move over the canvas; $place: as in "x 300, y 200 px"; $part: what is there.
edit-cross = Cross at { $place }. Arrows move it, with Shift by a tenth; Enter presses there, Esc takes it away
    .gone = The cross is gone
edit-cross-on = { $place }: { $part }
# Beside a knob that turns a joint.
edit-rests-at = rests at { $angle }
# A question after masses were moved by hand.
edit-moved = Moved masses
    .text = Springs and joints of what you moved can rest as they are now, or keep their rest lengths and angles: then they pull back as soon as the clock runs.
    .take = Take the new lengths
    .keep = Keep the rest lengths
    .once = This is asked once. The button Moved rest changes it.
# The form for name and description.
edit-texts = Name and description of this scene
    .name = Name
    .description = What it shows
    .done = Done
    .cancel = Cancel
# A picture behind the body.
edit-picture = Picture
    .hint = A picture behind the body, to draw over; it stays in this browser
    .size = Size
    .opacity = Opacity
    .move = Move it
    .drag = Drag it, or use the arrow keys, until Esc
    .another = Another
    .remove = Take it away
edit-no-picture = { $name } is not a picture that this browser can show

# Notices; below their titles stands why.
edit-not-pasted = That cannot be pasted
edit-not-copied = That cannot be copied
edit-sags = It sags?
    .text = Reset, then press “Keep this shape” next to the tools: the body will stay as you drew it.

# The folder with the numbers of what is selected; mixed: of parts that have different ones.
number-mixed = mixed
number-middle = middle
number-note = { $number } ({ $note })
number-proportions = Keep proportions
    .hint = a number then sets the largest value, and the others change in proportion
number-holding = Masses
    .pin = Pin
    .release = Let go
number-rest = Rest as it is now
    .hint = rest lengths and rest angles become the present ones
number-delete = Delete
number-position-x = Start x
number-position-y = Start y
number-mass = Mass
number-radius = Radius
number-force-x = Force x
number-force-y = Force y
number-spring-stiffness = Stiffness
number-spring-damping = Damping
number-spring-rest-length = Rest length
number-spring-strength = Strength
number-spring-yield-force = Yield force
number-spring-hardening = Hardening
number-joint-stiffness = Joint stiffness
number-joint-damping = Joint damping
number-joint-rest-angle = Rest angle
number-joint-yield-torque = Yield torque
number-spring-muscle-amplitude = Muscle amplitude
number-spring-muscle-phase = Muscle phase
number-spring-muscle-per-beat = Muscle waves per beat
number-joint-muscle-amplitude = Joint muscle amplitude
number-joint-muscle-phase = Joint muscle phase
number-joint-muscle-per-beat = Joint muscle waves per beat
number-joint-motor-speed = Motor speed
number-joint-motor-torque = Motor torque

# How parts act: the label of a list, hint, and its choices, which go on from the label.
way-touch = Masses touch
    .hint = balls collide: they bounce off each other and, where there is contact, off springs
    .usual = no other mass
    .solid = other balls
way-move = Masses move
    .hint = a mass on a rail moves along it only, as a cart does
    .usual = freely
    .level = to and fro on a rail
    .upright = up and down on a rail
way-springs = Springs act
    .hint = a rope only pulls, and a stop acts on one side of its rest angle
    .usual = both ways
    .pull = pulls only
    .push = pushes only
way-joints = Joints act
    .hint = { way-springs.hint }
    .usual = on both sides
    .above = above its angle only
    .below = below its angle only
way-turn = Joints turn
    .hint = a motor turns the second spring of a joint against the first
    .usual = freely
    .motor = by a motor
    .left-right = by a motor, with the keys Left and Right
    .up-down = by a motor, with the keys Up and Down
way-forces = Forces act
    .hint = a force on a mass acts always, or while an arrow key is held
    .usual = always
    .left-right = with the keys Left and Right
    .up-down = with the keys Up and Down
way-muscles = Muscles work
    .hint = a muscle works always, or while an arrow key is held; one that is steady then stays as it is
    .usual = to the beat
    .left-right = to the beat, with the keys Left and Right
    .up-down = to the beat, with the keys Up and Down
    .steady-left-right = steadily, with the keys Left and Right
    .steady-up-down = steadily, with the keys Up and Down
way-joint-muscles = Joint muscles work
    .hint = { way-muscles.hint }
    .usual = { way-muscles.usual }
    .left-right = { way-muscles.left-right }
    .up-down = { way-muscles.up-down }
    .steady-left-right = { way-muscles.steady-left-right }
    .steady-up-down = { way-muscles.steady-up-down }

# What steps of undo are called: what was done. Keys are the words of the labels in sim/edit.
done-masses-removed = { $count ->
    [one] { $count } mass removed
   *[other] { $count } masses removed
}
done-springs-removed = { $count ->
    [one] { $count } spring removed
   *[other] { $count } springs removed
}
done-joints-removed = { $count ->
    [one] { $count } joint removed
   *[other] { $count } joints removed
}
done-muscles-removed = { $count ->
    [one] { $count } muscle removed
   *[other] { $count } muscles removed
}
done-springs-cut = { $count ->
    [one] { $count } spring cut
   *[other] { $count } springs cut
}
done-springs-added = { $count ->
    [one] { $count } spring added
   *[other] { $count } springs added
}
done-joints-added = { $count ->
    [one] { $count } joint added
   *[other] { $count } joints added
}
done-muscles-added = { $count ->
    [one] { $count } muscle added
   *[other] { $count } muscles added
}
done-masses-pinned = { $count ->
    [one] { $count } mass pinned
   *[other] { $count } masses pinned
}
done-masses-let-go = { $count ->
    [one] { $count } mass let go
   *[other] { $count } masses let go
}
done-masses-moved = { $count ->
    [one] { $count } mass moved
   *[other] { $count } masses moved
}
done-masses-mirrored = { $count ->
    [one] { $count } mass mirrored
   *[other] { $count } masses mirrored
}
done-masses-duplicated = { $count ->
    [one] { $count } mass duplicated
   *[other] { $count } masses duplicated
}
done-masses-pasted = { $count ->
    [one] { $count } mass pasted
   *[other] { $count } masses pasted
}
done-muscles-moved = { $count ->
    [one] { $count } muscle moved
   *[other] { $count } muscles moved
}
done-muscles-changed = { $count ->
    [one] { $count } muscle changed
   *[other] { $count } muscles changed
}
done-muscles-spread = { $count ->
    [one] { $count } muscle spread
   *[other] { $count } muscles spread
}
done-springs-critically-damped = { $count ->
    [one] { $count } spring critically damped
   *[other] { $count } springs critically damped
}
done-triangulated-springs-added = { $count ->
    [one] triangulated: { $count } spring added
   *[other] triangulated: { $count } springs added
}
done-mass-added = mass added
done-mass-and-spring-added = mass and spring added
done-masses-and-a-spring-added = { $count } masses and a spring added
done-nothing-removed = nothing removed
done-nothing-mirrored = nothing mirrored
done-rest-as-it-is = rest as it is
done-keep-this-shape = keep this shape
done-fitted = fitted
done-scene-renamed = scene renamed
done-scene-described = scene described
done-mode = mode { $count }
done-own-values-of-the-body = own values of the body
done-own-values-of-the-solver = own values of the solver
done-number-set = { $number } set: { $parts }
done-number-scaled = { $number } scaled: { $parts }
done-way = { $way }: { $choice }
done-lesson-deleted = lesson deleted
done-step-added = step { $count } added
done-step-duplicated = step { $count } duplicated
done-step-removed = step { $count } removed
done-step-moved = “{ $title }” moved to step { $count }
done-beginning-of-step = beginning of step { $count }
done-title-of-step = title of step { $count }
done-task-of-step = task of step { $count }
done-what-to-watch-of-step = what to watch of step { $count }
done-question-of-step = question of step { $count }
done-prediction-of-step = prediction of step { $count }
done-goal-of-step = goal of step { $count }
done-what-is-handed-in-of-step = what is handed in of step { $count }
done-sliders-of-step = sliders of step { $count }
done-plots-of-step = plots of step { $count }
done-arrows-of-step = arrows of step { $count }
done-second-body-of-step = second body of step { $count }
done-run-of-step = run of step { $count }

# Why an edit is impossible, without a full stop.
edit-no-corner = there is no corner without an angular spring
edit-no-brace = there is nothing left to brace
edit-no-selection = nothing is selected
edit-no-move = nothing is selected that could be moved
