# The Solver tab: how the body is moved from one moment to the next.

# The first line; $method in bold: its name.
solver-adaptive = <b>{ $method }</b> keeps to { $tolerance } px, with steps as long as that allows.
solver-fixed = <b>{ $method }</b> takes { $rate } equal steps a second, of { $step } ms.
# What a method is, below the list of them.
solver-method-auto = Keeps to the tolerance and changes between an explicit and an implicit method as the body asks for.
solver-method-symplectic-euler = The tutorial's: forces from the present state, then velocities, then positions; explodes above a limit of the step.
solver-method-velocity-verlet = As cheap as Euler's and of second order; the same limit where nothing damps, a lower one under damping.
solver-method-rk4 = Four evaluations a step; accurate where the step is short beside every vibration.
solver-method-generalized-alpha = Implicit: stable at any stiffness; vibrations with fewer than some twenty steps per period become too slow and die out, without a message.
solver-method-stable-spring = Symplectic Euler with every spring softened as far as the step needs; cannot explode, sags instead.
solver-method-adams = Explicit multistep: two force evaluations a step, the order adapts to smoothness; for small errors of smooth motion.
solver-method-rodas4 = Error-controlled Rosenbrock method: for stiff bodies.
solver-method-rodas5p = Error-controlled Rosenbrock method of order 5: for stiff bodies and small errors.
# Controls.
solver-own = Scene's own values
solver-energy = Energy
    .hint = follow what changes the energy
solver-foretell = Predictability
    .hint = how fast small errors grow: whether any tolerance can tell where the body will be
# A second body, the ghost, that is moved otherwise.
solver-compare = Compare with
    .nothing = nothing
    .reference = a near-exact solution
solver-ghost-law = Ghost's law
    .same = the same
solver-ghost-step = Ghost's step
    .hint = its time step, or its tolerance where it has one, as a part of the body's
    .same = the same
    .half = a half
    .quarter = a quarter
    .tenth = a tenth
# A button, and its command; below it, what was found.
solver-which = Which method?
    .hint = tries them all on the first second of the scene: which is near enough, and fast
    .command = Which method suits the scene?
    .busy = All methods are tried ...
    .fails = Methods cannot be compared
    .luck = A tolerance above the error is not advised, even where the run happened to end as near.
# What the numbers of the scene mean, and targets for them.
solver-tuning = Tuning
    .hint = what the stiffnesses mean: frequencies, damping, sag, and stable time steps
    .command = Tuning: show it, or hide it
solver-stable = Make it stable at this time step
    .hint = lowers no more stiffness and damping than it takes
solver-damp = Critically damp
    .hint = the selected springs, each by itself; or else the body's slowest elastic vibration
solver-frequency = Soft – stiff
solver-damping = Bouncy – calm
solver-calm-after = Calm after
    .hint = when the slowest elastic vibration is down to a tenth; type how long it is to take
solver-sag = Sag
    .hint = how far the mass that sinks most is to sink; stiffness makes it less
solver-dt = Stable step
    .hint = the largest stable time step; less stiffness and damping make it longer
# Instead of the table of what the numbers mean; after "tuning".
solver-tuning-row = tuning
    .many = is told here of at most { $count } masses; sim.tuning tells it of more
    .compiled = comes when it is compiled
    .error = cannot be told because of an error on the server
    .busy = is being found out
# Titles of notices, and what they say.
solver-not-stable = It cannot be made stable
    .exploded = The body has exploded: go back to just before it, or press Reset, and then make it stable.
solver-not-damped = It cannot be damped
solver-error = There was an error on the server.
solver-many = a page does that for at most { $count } masses
    .instead = a page does that for at most { $count } masses; { $instead } does it for more
solver-compiling = the solver is still being compiled; try again in a moment
solver-is-stable = It is stable
    .text = It is stable at { $step }. Nothing was changed.
    .target = It is stable at { $step } as it is, so nothing was changed.
solver-lost = No longer as wished: { $wishes }.
solver-not-critical = Not critical yet
    .text = It is damped as far as its time step of { $step } bears. The integrator Auto bears more.
    .ratio = It is damped as far as its time step of { $step } bears: a damping ratio of { $ratio } instead of 1. The integrator Auto bears more.
# Steps of undo.
solver-did-stable = Made stable at { $step }
solver-did-damp = Critically damped
solver-did-damp-some = Damped as far as { $step } allows
solver-did-calm = Calm after { $seconds } s
solver-did-sag = Sag { $length }
solver-did-dt = Stable to { $step }
solver-did-ratio = Damping ratio { $ratio }
solver-did-frequency = { $frequency } Hz
# The figure of which method suits the scene.
solver-figure = Computing time of methods over their error
    .error = error after a second, px
    .time = computing, ms
# Which method suits the scene: for an error, a method with its tolerance or time step, and the next best one.
solver-advice-still = To { $error } px nothing can be told: the body ends less than that from its start.
solver-advice-doubt = To { $error } px nothing can be told: near-exact solutions end { $doubt } px apart, since small errors grow in this motion.
solver-advice-none = To { $error } px, none of the settings that were tried comes as near.
solver-advice-take = To { $error } px, take { $setting }, which ends { $off } px off.
    .fast = To { $error } px, take { $setting }, which ends { $off } px off; { $other } is as fast and ends { $far } px off.
    .slow = To { $error } px, take { $setting }, which ends { $off } px off; { $other } takes { $ratio } times as long and ends { $far } px off.
solver-advice-setting = { $method } at { $value }
