# What a step of a lesson reads, wants and does when it runs, in words.

# What is measured, before "of mass 1".
reading-stretch = stretch
reading-force = force
reading-length = length
reading-angle = angle
reading-torque = torque
reading-speed = speed
reading-vx = velocity vx
reading-vy = velocity vy
reading-momentum-x = momentum in x
reading-momentum-y = momentum in y
# Of a second body from the first.
reading-distance = distance
reading-time-step = time step, as a part of its limit
reading-of = { $owner ->
    [mass] { $what } of mass { $number }
    [spring] { $what } of spring { $number }
    [joint] { $what } of joint { $number }
   *[body] { $what } of the body
  }
reading-period = period of { $what }
reading-period-of = { $owner ->
    [mass] period of mass { $number }
    [spring] period of spring { $number }
    [joint] period of joint { $number }
   *[body] period of the body
  }

# Goals: numbers have their units.
goal-between = { $reading }: { $low } to { $high }
goal-least = { $reading }: at least { $low }
goal-most = { $reading }: at most { $high }
goal-held = { $goal }, for { $seconds } s

# What is otherwise when it runs: parts between semicolons.
run-choice = { $choice }: { $option }
run-many = { $count ->
   *[other] { $count } masses are pulled aside and let go
  }
run-pull = mass { $mass } is pulled { $way } and let go
# How far that is.
run-way =
  .right = { $length } right
  .left = { $length } left
  .down = { $length } down
  .up = { $length } up
run-ways = { $one } and { $other }
run-led = { $count ->
    [one] mass { $masses } is led round a circle of { $radius }, { $times } times a second
   *[other] masses { $masses } are led round a circle of { $radius }, { $times } times a second
  }
run-rests = { $count ->
    [one] the muscle at joint { $joints } rests
   *[other] the muscles at joints { $joints } rest
  }
run-muscles = { $count ->
    [one] a muscle moves at another moment or by another angle
   *[other] { $count } muscles move at another moment or by another angle
  }
