# What is measured on the canvas.

# The box of instruments, a button that opens it, and its tooltip.
instruments-box = Instruments
    .hint = Instruments: ruler, protractor, stopwatch, light gate
    .drag = Drag it onto the canvas, and back into the box
instruments-ruler = Ruler
instruments-protractor = Protractor
instruments-stopwatch = Stopwatch
instruments-gate = Light gate
# What a screen reader says of an instrument: what it reads, that it has been put away.
instruments-reads = { $instrument }: { $reading }
instruments-away = { $instrument } back in the box
# The points of an instrument, and how one is moved, for a screen reader.
instruments-first-end = first end
instruments-second-end = second end
instruments-first-side = first side
instruments-corner = corner
instruments-second-side = second side
instruments-point = { $instrument }, { $point }. Arrows move it, Enter fixes it to a mass
    .fixed = { $instrument }, { $point }. At mass { $mass }. Arrows choose another, Enter frees it
instruments-watch = Stopwatch, { $time }. Arrows move it
# Buttons of a stopwatch; for a screen reader they have their key.
instruments-start = Start
instruments-zero = Zero
instruments-stop = Stop
instruments-lap = Lap
instruments-key = { $button } ({ $key })
# By how much an angle differs from a straight line.
instruments-bend = bend { $angle }
# Of a light gate: no mass has crossed it, and which did.
instruments-nothing = nothing yet
instruments-crossed = mass { $mass }
# Beside the sample arrow, before the value that its length stands for.
instruments-force = force { $value }
instruments-speed = speed { $value }
instruments-torque = torque { $value }
# Beside a mass, with its coordinates.
instruments-at = mass { $mass }: { $x }, { $y } { $unit }
# Switches of the Measure tab.
instruments-forces = Forces
    .hint = the net force on each mass; on a held one, dashed, the load on its support
instruments-velocities = Velocities
    .hint = the velocity of each mass
instruments-torques = Torques
    .hint = the torque by which each angular spring turns its first spring
instruments-coordinates = Coordinates
    .hint = of the mass under the pointer, or clicked last
instruments-trace = Trace the chosen mass
    .hint = click a mass to choose it; several can have one
    .length = Length of a trace
    .clear = Clear the traces
instruments-strobe = Stroboscope
    .hint = leaves images of the body at equal intervals of simulated time
    .off = off
    .every = every { $seconds } s
