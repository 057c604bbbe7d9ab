# What happens to the body, in notices; and steps of undo.

session-cannot = That cannot be done
session-busy = the scene is busy; try again
session-not-resumed = could not be resumed: { $why }

# The body ran away. The limit is set by a number, or else by a part of the body; otherwise: what happened, why,
# and what helps.
session-exploded = The body exploded
    .setting = Time step { $step } s is above the stability limit { $limit } s at { $setting } { $value }. The last good state is shown. Go back to just before it, lower either of them, and go on; or press Reset.
    .part = Time step { $step } s is above the stability limit { $limit } s at the stiffness of the { $part }. The last good state is shown. Go back to just before it, lower it or choose the integrator Auto, and go on; or press Reset.
    .otherwise = Stopped before step { $step }: { $what }; { $why }. The last good state is shown. Go back to just before it, { $remedy }, and go on; or press Reset.
session-what-number = mass { $mass } would get a position or velocity that is not a finite number
session-what-position = mass { $mass } went too far (over { $limit } px)
session-what-step = no step from here is short enough
session-what-speed = mass { $mass } became too fast (over { $limit } px/s)
session-why-law = the tutorial's force law has no energy and can drive a body ever faster
session-why-violent = the body was moved or set up too violently
session-why-violent-step = the body was moved or set up too violently for this time step
session-why-small = the time step is below the stability limit, but that is for small motions about one pose; large or fast ones can pass it
session-why-small-law = the time step is below the stability limit, but that is for small motions about one pose; large or fast ones can pass it, and the tutorial's force law has no energy and can drive a body ever faster
session-remedy-law = move it more gently, raise the damping or choose another force law
session-remedy-gently = move it more gently or raise the damping
session-remedy-step = lower the time step, choose the integrator Auto, raise the damping or move it more gently
# What sets the limit.
session-cause-linear-stiffness = linear stiffness
session-cause-linear-damping = linear damping
session-cause-angular-stiffness = angular stiffness
session-cause-angular-damping = angular damping
session-cause-air-friction = air friction
session-cause-one-sided = one-sided
session-cause-resistance = resistance
session-cause-walls = walls
session-cause-fillings = fillings
session-cause-contact = contact
session-cause-motors = motors
session-cause-pushes = pushes
session-cause-rails = rails

# The body cannot keep its shape; after a sentence that says why.
session-shape = This shape cannot be kept
    .line = { $why } The line shows where it goes.
    .button = { $why } The button “Keep it, { $times } times as stiff” makes it so.
    .both = { $why } The line shows where it goes. The button “Keep it, { $times } times as stiff” makes it so.
    .text = { $why }

# After Undo and Redo, where they lead to another scene; names of buttons, too.
session-back-to = Back to “{ $scene }”
    .undo = Undo leads to “{ $scene }” again.
    .redo = Redo leads to “{ $scene }” again.
# Steps of undo.
session-opening = opening { $scene }
session-own-body = own values of the body
session-own-solver = own values of the solver

# A log was played: how it compares with what was recorded.
session-replay-ended = The replay has ended
    .taken = You have taken over from the replay.
    .stuck = It cannot go on: { $why }.
    .agrees = It agrees with the log: { $verdict }.
    .differs = It does not agree with the log: it { $verdict }.
session-replayed = { $checks ->
    [one] replayed { $steps } steps; its check agrees
   *[other] replayed { $steps } steps; all { $checks } checks agree
}
    .digest = { $checks ->
    [one] replayed { $steps } steps; its check agrees, digest { $digest }
   *[other] replayed { $steps } steps; all { $checks } checks agree, digest { $digest }
}
# $how: one of the next three.
session-differs = differs first at step { $step }, t = { $time } s (check { $check } of { $checks }; it agrees at step { $agreed }), { $how }
    .elsewhere = differs first at step { $step }, t = { $time } s (check { $check } of { $checks }; it agrees at step { $agreed }), { $how }; it was recorded on { $machine }, this is { $here }
session-differs-hidden = not in positions and velocities, but in what keys, damage or friction did
session-differs-apart = largest distance of a mass noted { $distance }
session-differs-unknown = largest distance unknown
session-too-heavy = this frame is too heavy to be played in a page; `softrod run --inputs` can do it
session-log-plays = a log is being played; there is nothing else to save

# How far the compiler is; $what is what it compiles.
session-awaited = moves by NumPy until { $what } is compiled: { $ready } of { $count } parts ready
session-preparing = preparing { $what }: { $ready } of { $count } parts ready

# How errors grow, and what that means for the tolerance or the time step.
session-errors-kept = Errors do not grow: a tolerance of { $tolerance } is kept.
    .grow = Errors grow × { $factor } in a second: a tolerance of { $tolerance } is kept.
session-errors-step = Errors do not grow: a shorter time step makes them smaller.
    .grow = Errors grow × { $factor } in a second: a shorter time step makes them smaller.
session-errors-lost = Errors grow × { $factor } in a second: no tolerance can promise where it is in { $seconds } s.
    .step = Errors grow × { $factor } in a second: no time step can promise where it is in { $seconds } s.

# Why there is no plot, and why a mode cannot be driven.
session-plot-many = a plot has room for { $count } quantities
session-plot-units = a plot has room for two units, but not for { $units }
session-mode-fast = mode { $mode } has a period of { $period } s, less than four time steps
