# The description of a body: one paragraph, put together of these sentences in this order.

# What it consists of. Like pieces are counted together.
describe-mass = { $count ->
    [one] A single mass.
   *[other] { $count } single masses.
}
describe-chain = { $count ->
    [one] A chain of { $masses } masses, with { $springs ->
        [one] one spring
       *[other] { $springs } springs
    } and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
   *[other] { $count } chains of { $masses } masses, each with { $springs ->
        [one] one spring
       *[other] { $springs } springs
    } and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
}
describe-ring = { $count ->
    [one] A ring of { $masses } masses, with { $springs } springs and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
   *[other] { $count } rings of { $masses } masses, each with { $springs } springs and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
}
describe-tree = { $count ->
    [one] A tree of { $masses } masses, with { $springs } springs and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
   *[other] { $count } trees of { $masses } masses, each with { $springs } springs and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
}
describe-net = { $count ->
    [one] A net of { $masses } masses, with { $springs } springs in { $loops ->
        [one] one loop
       *[other] { $loops } loops
    } and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
   *[other] { $count } nets of { $masses } masses, each with { $springs } springs in { $loops ->
        [one] one loop
       *[other] { $loops } loops
    } and { $joints ->
        [0] no joints
        [one] one joint
       *[other] { $joints } joints
    }.
}

# What holds it; parts: one or several of several pieces; mass: a piece that is a single mass.
describe-free = Nothing holds it.
    .parts = { $count ->
        [one] Nothing holds it.
       *[other] Nothing holds them.
    }
describe-held = It is held at mass { $mass }, { $side ->
    [left] at its left end
    [right] at its right end
    [top] at its top
    [bottom] at its bottom
    [leftTop] at its upper left
    [rightTop] at its upper right
    [leftBottom] at its lower left
    [rightBottom] at its lower right
   *[inside] between its ends
}.
    .mass = Mass { $mass } is held.
describe-held-many = { $count } masses are held: { $masses }.
describe-held-most = { $count } masses are held.

# How it lies: lengths with their unit; all: of several pieces.
describe-lies = It is { $width } wide and { $height } high.
    .all = Together they are { $width } wide and { $height } high.
# One of several bodies, by its place among them; $masses is a list of $count numbers. What is said of one body follows it.
describe-piece = Body { $number } from the { $side ->
    [top] top
   *[left] left
} consists of { $count ->
    [one] mass
   *[other] masses
} { $masses }.
describe-hangs = Its lowest mass, { $mass }, is { $depth } below the highest one that is held.

# How it moves: speeds with their unit. { $way } and { $whole } are directions, see describe-way.
describe-still = It is at rest.
    .away = It does not move now, { $length } away from its rest.
    .nearly = It is nearly at rest: it swings by less than { $length }.
    .all = Nothing moves.
describe-moves = Its fastest mass, { $mass }, moves { $way } at { $speed }.
    .all = The fastest mass, { $mass }, moves { $way } at { $speed }.
describe-drifts = As a whole it moves { $whole } at { $speed }.
describe-turns = It turns { $sense ->
    [clockwise] clockwise
   *[counterclockwise] counterclockwise
} by { $degrees } degrees a second.
describe-way = { $way ->
    [right] to the right
    [upRight] up to the right
    [up] up
    [upLeft] up to the left
    [left] to the left
    [downLeft] down to the left
    [down] down
   *[downRight] down to the right
}

# What strains it.
describe-stretched = Spring { $spring } is stretched most, by { $percent } %.
describe-squeezed = Spring { $spring } is squeezed most, by { $percent } %.
describe-touching = { $count ->
    [one] One mass touches something.
   *[other] { $count } masses touch something.
}
describe-broken = { $count ->
    [one] One spring is broken.
   *[other] { $count } springs are broken.
}
describe-yielded = { $count ->
    [one] One spring or joint has yielded.
   *[other] { $count } springs and joints have yielded.
}

# How it swings about its rest.
describe-swings = Left alone, it swings once in { $period } seconds, and loses { $percent } % of each swing.
describe-swings-on = Left alone, it swings once in { $period } seconds, and loses next to nothing.

# What has changed since it was described before.
describe-same = Nothing has changed since.
describe-moved = Since then it has gone { $way } by { $length }.
describe-broke = { $count ->
    [one] Since then one spring has broken.
   *[other] Since then { $count } springs have broken.
}
describe-built = Since then it has been changed.

# A part of the body: a mass, a spring or a joint. Numbers have their units.
describe-part-mass = Mass { $mass }, { $weight }, is at x = { $x }, y = { $y }.
describe-part-held = It is held.
    .hand = It is in your hand.
describe-part-still = It is at rest.
describe-part-moves = It moves { $way } at { $speed }.
describe-part-alone = No spring is attached to it.
# $springs and $masses are lists of as many numbers.
describe-part-joined = { $count ->
    [one] Spring { $springs } joins it to mass { $masses }.
   *[other] Springs { $springs } join it to masses { $masses }.
}
describe-part-joined-most = { $count ->
    [one] { $count } spring joins it to another mass.
   *[other] { $count } springs join it to other masses.
}
describe-part-touches = It touches something.
describe-part-spring = Spring { $spring } joins masses { $one } and { $other }.
describe-part-length = It is { $length } long; its rest length is { $rest }.
describe-part-strain = It is { $sense ->
    [stretched] stretched
   *[squeezed] squeezed
} by { $percent } %.
describe-part-force = It { $sense ->
    [pulls] pulls its ends together
   *[pushes] pushes its ends apart
} with { $force }.
describe-part-broken = It is broken.
describe-part-yielded = It has yielded.
describe-part-muscle = It is a muscle, which changes its rest length by up to { $percent } %.
describe-part-joint = Joint { $joint } is at mass { $mass }, between springs { $one } and { $other }.
describe-part-corner = The corner between these springs has { $corner }.
describe-part-angle = Its angle is { $angle }, its rest angle { $rest }.
describe-part-torque = Its torque is { $torque }.
describe-part-bends = It is a muscle, which changes its rest angle by up to { $degrees }.
describe-part-motor = A motor turns it at up to { $speed }.

# What happens, for a screen reader: one short sentence at a time.
news-broke = { $count ->
    [one] One spring broke.
   *[other] { $count } springs broke.
}
news-touched = { $by ->
    [floor] The body touches the floor.
    [wall] The body touches a wall.
   *[body] The body touches another one, or itself.
}
news-rest = The body has come to rest.
news-exploded = The body exploded and is stopped.
news-grabbed = Mass { $mass } is in hand.
news-dropped = Mass { $mass } is let go.
news-running = Running.
    .paused = Paused.
# A step of a lesson begins.
news-step = Step { $number }: { $title }

describe-title = Description
describe-close = Close the description
