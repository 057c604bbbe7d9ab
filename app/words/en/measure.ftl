# The Measure tab: what is plotted, and the plots; what instruments and tables say has files of its own.

measure-about = Click or tap a mass, or take it by keys, to choose what is measured: the mass, its joint and its springs.
    .plots = Point at a plot to read values; drag across it to zoom in, double-click to see all; by keys: arrows, Home.
# Below the lists, without a plot; $quantity: as in joint3.angle.
measure-no-plot = No plot is open. <b>New plot</b> shows { $quantity } while it moves.
# Lists, a text box and a button with which a plot is made.
measure-part = Part
measure-quantity = Quantity
measure-formula = Formula
    .hint = in place of the quantity, as mass1.y - mass0.y or sqrt(mass0.vx^2 + mass0.vy^2)
measure-over = Over
    .time = time
measure-new = New plot
# For a screen reader: a plot was opened.
measure-opened = New plot: { $plot }
# Lists and buttons of a plot.
measure-span = Time span
measure-analysis = Analysis
measure-add = Add to it
measure-table = CSV
measure-picture = Picture
measure-hear = Hear
measure-hear-live = Hear while it moves
    .hint = the newest values as tones; left and right for two lines
measure-remove = Remove
# What a plot is analysed by.
measure-analysis-none = none
measure-analysis-spectrum = spectrum
measure-analysis-line = line
measure-analysis-parabola = parabola
measure-analysis-sine = sine
measure-analysis-decaying-sine = decaying sine
measure-analysis-exponential = exponential
# Titles of notices, and what they say.
measure-cannot = That cannot be plotted
measure-cannot-add = That cannot be added
measure-no-room = a page has room for { $count } plots; remove one first
measure-nothing = Nothing to plot
    .text = This scene has no joints.
# Axes, lines and names of a plot; $quantity may be several.
measure-axis-time = time, s
measure-axis-frequency = frequency, Hz
measure-axis-amplitude = amplitude of { $quantity }
measure-axis-downwards = { $label }, downwards
measure-line-fit = fit to { $quantity }
measure-title-spectrum = amplitude spectrum of { $quantity }
measure-title-over = { $quantity } over { $over }
# What a screen reader says of each quantity of such a plot; numbers have units.
measure-range = { $quantity }: now { $now }; from { $low } to { $high }.
# What is read below a plot.
measure-still = no regular swing
measure-swing = { $quantity }: period <b>{ $period } s</b>, amplitude <b>{ $amplitude }</b>
    .loses = { $quantity }: period <b>{ $period } s</b>, amplitude <b>{ $amplitude }</b>, loses { $percent } % per cycle
# A curve that is fitted to a quantity, from a place along the axis; below it stand its numbers.
measure-fit-from = { $quantity } from { $place }:
measure-fit-deviation = rms deviation { $deviation }
measure-fit-short = less than a period is in view: its errors are larger than those told
measure-number-start = start
measure-number-slope = slope
measure-number-slope-at-the-start = slope at the start
measure-number-second-derivative = second derivative
measure-number-offset = offset
measure-number-amplitude = amplitude
measure-number-period = period
measure-number-phase = phase
measure-number-decay-rate = decay rate
measure-number-size = size
measure-spectrum-none = no spectrum: nothing has changed in the frames in view, or they are too few
measure-spectrum-no-peak = no peak of two cycles or more in view
measure-spectrum-of = of the last { $seconds } s in view that have every frame
# What is said while a plot is heard: each line between its lowest and its highest value, and where it sounds.
melody-heard = { $name }: { $low } to { $high } { $unit }.
    .left = { $name }: { $low } to { $high } { $unit }, at the left.
    .right = { $name }: { $low } to { $high } { $unit }, at the right.
    .between = { $name }: { $low } to { $high } { $unit }, between left and right.
# What passes meanwhile: time, or the frequency of a spectrum.
melody-passes = From { $from } to { $to } s.
    .frequency = From { $from } to { $to } Hz.
melody-none = { $name } has no values to hear.
melody-which = Plot { $number } of { $count }.
melody-no-plot = There is no plot to hear.
melody-off = Sound is off, see Access and language.
