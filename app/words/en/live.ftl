# Files that need no server: a live file, a replay, and a lesson on paper for its teacher.

# Where scripts do not run, as in a phone's preview.
live-picture = This is a picture: scripts do not run here. Open the file in a web browser, and it moves.
live-too-old = This browser cannot show the file; a newer one can.
live-play = Play
live-pause = Pause
live-speed = Speed

# A replay, which plays what a body did.
replay-again = Play again
replay-time = Time shown
replay-too-old = This browser cannot play the file; a newer one can.

# A live file, in which a body moves.
live-exploded = The body exploded
live-back = Go back to before it
live-side = Controls and numbers
live-lesson = Lesson
live-others = More sliders
live-answers = Hand in your answers
live-step = +1 step
live-time = Time
live-reset = Reset
live-follow = Follow
    .hint = Follow the pointer
live-view = View and keys

# Buttons of the arrow keys: what they do to all springs and joints, or to what keys work.
live-arrow-left = Left: rest angles less
    .works = Left: { $work }
live-arrow-up = Up: longer
    .works = Up: { $work }
live-arrow-down = Down: shorter
    .works = Down: { $work }
live-arrow-right = Right: rest angles more
    .works = Right: { $work }
live-work-motors = turn the motors
live-work-muscles = work the muscles
live-work-forces = push masses

# What the file cannot do: some of the sentences below, with semicolons between them.
live-notes = In this file { $notes }.
live-note-verlet = the body moves by velocity Verlet, without error control
live-note-shape = the shape of the body is fixed
live-note-sliders = there is no slider for { $settings }
live-note-controls = the lesson has no control of { $settings }
live-note-plots = plots of { $quantities } are left out
live-note-ghost = there is no second body to compare with
live-note-arrows = there are no arrows
live-note-goals = some goals are not judged
live-note-runs = no run is handed in

# Over the body, with dots between them.
live-stopped = stopped
live-paused = paused
live-slowed = slowed down: { $rate } × real time
live-broken = { $count ->
    [one] { $count } spring broken
   *[other] { $count } springs broken
}
live-yielded = { $count ->
    [one] { $count } spring yielded
   *[other] { $count } springs yielded
}
live-limit = time step { $step } ms, { $part } % of the limit
    .over = time step { $step } ms, { $part } % of the limit: unstable

# Tables of numbers.
live-joint = Joint { $joint }
    .angle = angle
    .rest = rest angle
    .sine = sine
    .cosine = cosine
live-energy = Energy, { $unit }
    .kinetic = kinetic
    .height = height
    .linear = linear
    .angular = angular

# Why a body exploded.
live-cause =
    .linear = The time step of { $step } s is above the stability limit of { $limit } s, which the linear springs set.
    .angular = The time step of { $step } s is above the stability limit of { $limit } s, which the angular springs set.
    .small = The time step is below the stability limit, but that is for small motions; it was moved or set up too violently.
    .violent = It was moved or set up too violently.

# A plot: what its curves are, and what is read off them.
live-downwards = { $quantity }, downwards
live-over = over { $quantity }
live-swing = { $reading }, period { $period } s, amplitude { $amplitude }
live-swings = Periods { $periods } s; amplitudes { $amplitudes }
live-at = At { $time } s: { $readings }

# A lesson.
live-own-words = In your own words:
live-predict = Move the masses to where they will be after { $time } s. Then press the button.
    .done = It will be there
    .seen = The thin line is your prediction for { $time } s.
live-goal = Goal: { $goal }.
    .now = Goal: { $goal }. Now: { $reading }.
    .reached = Reached: { $goal }.

# Answers that are handed in.
live-leaves = Nothing leaves this file by itself. Give your teacher the file, or show the QR code.
live-name = Your name or nickname, if your teacher wants one:
live-save = Save answers as a file
live-qr = QR code of the answers
    .text = The QR code is the text below it, { $letters } letters.
    .left = The QR code is the text below it, { $letters } letters. It has no room for { $left }; the file has all.
live-left-prediction = the prediction of step { $step }
live-left-line = the line of step { $step }
    .end = the end of the line of step { $step }

# Looks, and what keys do.
live-dark = Dark
live-larger = Larger, for a projector
live-keys-drag = a mass is held while you drag it; several fingers drag several
    .keys = drag
live-keys-play = play or pause
    .keys = Space
live-keys-step = one step
live-keys-reset = reset: the body starts again, with the sliders as they are
live-keys-follow = the ringed mass follows the pointer, or stops
live-keys-longer = springs get longer or shorter
    .keys = ↑ ↓ held
live-keys-bent = rest angles grow or shrink
    .keys = → ← held
live-keys-motors = motors turn, forwards and backwards
    .keys = arrows held
live-keys-dark = dark or white; larger, for a projector
live-keys-body = to the body: there arrows choose a mass, Space takes hold of it, arrows move it
    .keys = Tab
live-keys-help = this help

# A lesson on paper: how it is given, and the parts of its steps.
live-sheet-title = { $lesson }: for the teacher
live-sheet-needs = Some { $minutes } minutes. You need a computer with a projector, and a phone, tablet or computer for each pupil or two. Begin with { $command }; { $next } leads from phase to phase.
# The button of the teacher's page that it speaks of.
live-sheet-next = Next
live-sheet-how = Ask: all answer unseen. Do not tell what is right. Below 35 % right teach it again; up to 70 % let them talk in pairs and ask again. Run it, reveal, have them write one line why; then they try, and hand in.
live-sheet-ask = Ask
live-sheet-predict = Predict
    .text = Each drags the pale body to where it will be after { $time } s.
live-sheet-run = Run
live-sheet-reveal = Reveal
live-sheet-try = Try
live-sheet-watch = Watch
live-sheet-goal = Goal
    .text = { $goal }.
live-sheet-collect = Collect
    .text = The { $reading }.
