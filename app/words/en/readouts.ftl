# Lines and tables of numbers that follow the running body.

# Over the canvas: what the body does, in bold.
hud-stopped = stopped
hud-past = looking back
hud-paused = paused
hud-rest = at rest
hud-slow = slowed down: { $factor } × real time
hud-behind = the body cannot follow so fast: the hand is { $distance } behind
hud-broken = { $count ->
    [one] { $count } spring broken
   *[other] { $count } springs broken
}
hud-yielded = { $count ->
    [one] { $count } spring yielded
   *[other] { $count } springs yielded
}
# The ends of a bar of colours.
hud-squeezed = squeezed
    .stretched = stretched
hud-step = time step { $step } ms, { $percent } % of the limit
    .unstable = time step { $step } ms, { $percent } % of the limit: unstable
    .explodes = time step { $step } ms, { $percent } % of the limit: unstable, explodes when touched

# The angle of a joint. $count: how many joints there are.
card-sine = sine
card-cosine = cosine
card-angle = angle
card-rest-angle = rest angle
card-of = of { $count }
# The card beside a mass that was clicked; of: several joints are at that mass.
card-mass = Mass { $mass }
card-joint = Joint { $joint }
    .of = Joint { $joint } (of { $count } here)
card-x = x
card-y = y
card-speed = speed
card-stiffness = stiffness

# How fast the solver runs.
rates-factor = real-time factor
rates-steps = steps per second
rates-solver = solver, per frame
rates-behind = clock behind by
rates-rejected = rejected per second
rates-fallbacks = fallback steps

# How fast a small error grows.
errors-title = predictability
    .compiled = comes when it is compiled
    .held = no mass is free
errors-grow = errors grow
    .measured = being measured, for a second
errors-factor = errors grow, last second
errors-rate = rate
errors-time = e-folding time
    .none = none
errors-solver = its solver, per frame

# What stiffness, damping and mass mean for the motion; left the name, right the value.
tuning-slowest = slowest vibration
tuning-elastic = slowest elastic one
tuning-fastest = fastest vibration
tuning-calm = calm after
    .after = { $time }, to a tenth
    .never = never: undamped
tuning-sag = sag under gravity
    .loads = sag under its loads
    .value = { $sag }, mass { $mass }
tuning-stable = stable to { $step } ms
    .always = stable at any step
tuning-spring = spring { $spring } alone
tuning-spring-fastest = fastest spring alone
tuning-rate = { $frequency } Hz, { $period }, damping ratio { $ratio }
    .undamped = { $frequency } Hz, { $period }, undamped
    .none = none
tuning-one-linear-stiffness = 1 % more stiffness of the springs
tuning-one-angular-stiffness = 1 % more stiffness of the joints
tuning-one-gravity = 1 % more gravity
tuning-more-sag = { $sag } more sag
tuning-less-sag = { $sag } less sag
tuning-faster = { $percent } % faster
tuning-slower = { $percent } % slower

# A second body that is computed in another way.
ghost-title = ghost
    .compiled = { $ghost }: comes when it is compiled
    .tolerance = tolerance / { $finer }
    .step = step / { $finer }
ghost-distance = distance now
ghost-worst = largest distance
ghost-solver = ghost's solver, per frame
ghost-error = any error grows
    .factor = × { $factor } in a second
ghost-stopped = ghost stopped
    .why = it exploded

# The energies, and what has changed them.
energy-title = energy
    .compiled = is followed when it is compiled
energy-unit = unit
energy-kinetic = kinetic
energy-gravity = height
    .loads = height and loads
energy-linear = linear springs
energy-angular = angular springs
energy-walls = depth in walls
energy-fillings = gases and liquids
energy-contact = contact
energy-anchors = work of your hand
energy-damping = lost to damping
energy-air = lost to air and medium
energy-friction = lost to walls, ground, contact
energy-plastic = lost in yielding
energy-broken = lost in breaking
energy-law = made by the tutorial's law
energy-keys = work of the keys
energy-muscles = work of the muscles
energy-motors = work of the motors
energy-changes = changes of settings
energy-fallbacks = lost in fallback steps
energy-residual = residual: the method's error

# The button below a scene's description, which opens a form; new: where there is none.
about-edit = Edit name and text
    .new = Name this scene, and say what it shows
