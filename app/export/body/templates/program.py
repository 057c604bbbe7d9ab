# GIVEN_ABOUT
import sys

import numpy as np

# ifdef TEMPLATE
# What stands for a scene's numbers while this file is read as it is. `app/export/body/program.py` fills it.
GIVEN_STEPS, GIVEN_START, GIVEN_DT, GIVEN_AIR = 400, 0.0, 0.001, 0.1
GIVEN_GRAVITY_X, GIVEN_GRAVITY_Y, GIVEN_WIND_X, GIVEN_WIND_Y = 0.0, 900.0, 10.0, 0.0
GIVEN_ACROSS, GIVEN_ALONG = 1.0, 0.5
GIVEN_FORWARD, GIVEN_BACKWARD, GIVEN_SIDEWAYS, GIVEN_SLIP = 0.2, 0.3, 0.4, 10.0
GIVEN_MASSES = [(0.0, 0.0, 0.0, 0.0, 1.0, 0)]
GIVEN_SPRINGS = [(0, 0, 1.0, 1.0, 0, 0.0)]
GIVEN_JOINTS = [(0, 0, 1.0, 1.0, 0.0, 0, 0.0)]
GIVEN_LOADS = [(0, 0.0, 0.0)]
GIVEN_RESISTED = [(0, 1000.0, 1000.0)]
GIVEN_FILLINGS = [(True, 1.0, 1.0, 1.0, [0])]
GIVEN_WALLS = [(0.0, 0.0, 0.0, -1.0, 1.0, 0.0, 1.0, 0.0, 0.5, 1.0, 1.0, 1.0)]
GIVEN_SIZES = [(0.0,)]
GIVEN_BELTS = [(0.0,)]
GIVEN_STATIC = [(0.0,)]
GIVEN_GRIPPED = [(0, 0, 0.0)]
GIVEN_SLIDING = [(0, 0)]
GIVEN_MOTORS = [(0, 1.0, 1.0, 1.0, -1)]
GIVEN_PUSHES = [(0, 1.0, 0.0, 0)]
GIVEN_EFFORT_X, GIVEN_EFFORT_Y = 0.0, 0.0
GIVEN_RAILS = [(0, 1.0, 0.0)]
GIVEN_CIRCLES = [(0, 0.0, 0.0, 1.0, 1.0, 1.0)]
GIVEN_STRETCHED = [(0, 1.0, 0.1, 1.0, 0.0, 0, -1)]
GIVEN_BENT = [(0, 0.0, 0.1, 1.0, 0.0, 0, -1)]
# endif
DT = GIVEN_DT  # time step, s
# ifdef HAS_GRAVITY
GRAVITY = np.array((GIVEN_GRAVITY_X, GIVEN_GRAVITY_Y))  # px/s^2
# endif
# ifdef HAS_AIR
AIR = GIVEN_AIR  # air friction, GIVEN_AIR_UNIT
# endif
# ifdef HAS_WIND
WIND = np.array((GIVEN_WIND_X, GIVEN_WIND_Y))  # velocity of the air, px/s
# endif
# ifdef HAS_MEDIUM
ACROSS, ALONG = GIVEN_ACROSS, GIVEN_ALONG  # drag of a medium on springs, kg/(px s)
# endif
# ifdef HAS_GROUND
FORWARD, BACKWARD, SIDEWAYS = GIVEN_FORWARD, GIVEN_BACKWARD, GIVEN_SIDEWAYS  # friction of the ground
SLIP = GIVEN_SLIP  # speed of full friction, px/s
# endif

# A row for each mass: x, y (px), velocity x, y (px/s), mass (kg).
MASSES = np.array(GIVEN_MASSES)
MASS = MASSES[:, 4:5]
# ifdef HAS_HELD
FREE = MASSES[:, 5:6] == 0  # the last number is 1 where a mass is held
# endif

# ifdef HAS_SPRINGS
SPRINGS = np.array(GIVEN_SPRINGS)
A, B = SPRINGS[:, :2].astype(int).T  # masses at the ends of each spring
K, REST = SPRINGS[:, 2:4].T  # stiffness (kg/s^2), rest length (px)
# ifdef HAS_SPRING_SIDES
SIDE = SPRINGS[:, 4]  # 1: it only pulls; -1: it only pushes; 0: both
# endif
# ifdef HAS_DAMPING
C = SPRINGS[:, -1]  # damping, kg/s
# endif

# endif
# ifdef HAS_JOINTS
JOINTS = np.array(GIVEN_JOINTS)
P, Q = JOINTS[:, :2].astype(int).T  # springs of each joint
JOINT_K = JOINTS[:, 2]  # stiffness, kg/s^2
# ifdef HAS_ANGLE_LAW
REST_ANGLE = JOINTS[:, 3]  # radians
# ifdef HAS_JOINT_SIDES
JOINT_SIDE = JOINTS[:, 4]  # 1: it acts above its rest angle only; -1: below it only; 0: both
# endif
# else
COS, SIN = JOINTS[:, 3:5].T  # of the rest angle
# ifdef HAS_JOINT_SIDES
JOINT_SIDE = JOINTS[:, 5]  # 1: it acts above its rest angle only; -1: below it only; 0: both
# endif
# endif
# ifdef HAS_JOINT_DAMPING
JOINT_C = JOINTS[:, -1]  # damping, kg/s
# endif

# endif
# ifdef HAS_MOTORS
# A row for each motor, which turns the second spring of a joint against the first: the joint, the rate at
# which its angle should grow (1/s), the largest torque (kg px^2/s^2), and how far the rate is off where three
# quarters of that act (1/s).
# ifdef HAS_STEERING
# At the end, which number in STEER steers it, or -1.
# endif
MOTORS = np.array(GIVEN_MOTORS)
MOTOR = MOTORS[:, 0].astype(int)
SPEED, MOST, MARGIN = MOTORS[:, 1:4].T
# ifdef HAS_STEERING
STEERED = MOTORS[:, 4].astype(int)
# endif

# endif
# ifdef HAS_STEERING
STEER = np.zeros(2)  # to the right, and up: each from -1 to 1

# endif
# ifdef HAS_PUSHES
# A row for each force that keys work: the mass that it acts on, its x and y (kg px/s^2), and which number in
# STEER works it.
PUSHES = np.array(GIVEN_PUSHES)
PUSHED, PUSHED_BY = PUSHES[:, 0].astype(int), PUSHES[:, 3].astype(int)

# endif
# ifdef HAS_LOADS
# A row for each constant force: the mass that it acts on, its x and y (kg px/s^2).
LOADS = np.array(GIVEN_LOADS)

# endif
# ifdef HAS_RESISTED
# ifdef HAS_GROUND
# A row for each spring that is resisted: which it is, and the weights on its ends (kg px/s^2).
# else
# A row for each spring that is resisted: which it is.
# endif
RESISTED = np.array(GIVEN_RESISTED)
WHOLE = RESISTED[:, 0].astype(int)

# endif
# ifdef HAS_FILLINGS
# Of each filling: whether it is a gas, its pressure or the bulk modulus, the pressure outside (kg/s^2), its
# area (px^2), and the masses around it.
FILLINGS = GIVEN_FILLINGS

# endif
# ifdef HAS_WALLS
# Of each wall: a point and the unit vector to the free side, hardness (1/(px s^2)), friction, slip speed
# (px/s), and how much harder masses are pushed that enter faster (s/px).
# ifdef HAS_HYSTERESIS
# Then how much harder they are pushed on the way in, and from what speeds on (px^(-1/2)/s).
# endif
# ifdef HAS_GRIPS
# At the end, the stiffness and damping of the tangential springs by which friction holds (1/s^2, 1/s).
# endif
WALLS = GIVEN_WALLS
# ifdef HAS_SIZES
SIZES = np.array(GIVEN_SIZES)[:, 0]  # the radius of each mass that is solid, px, 0 of all others
# endif
# ifdef HAS_BELTS
BELTS = [speed for (speed,) in GIVEN_BELTS]  # of the surface of each wall, along it, px/s
# endif
# ifdef HAS_GRIPS
# Of the tangential spring between each wall and each mass, its stretch, and where along the wall the mass was
# when it had that stretch (px); NaN where there is none.
STRETCH = np.zeros((len(WALLS), len(MASSES)))
PLACE = np.full((len(WALLS), len(MASSES)), np.nan)
# endif
# ifdef HAS_STATIC
STATIC = [coefficient for (coefficient,) in GIVEN_STATIC]  # of the static friction of each wall
SLIDES = np.zeros((len(WALLS), len(MASSES)), bool)  # whether each mass slides on each wall
WHOLE = 1.0 - 1e-9  # part of the largest stretch from which on one does
# endif

# endif
# ifdef HAS_GRIPPED
# A row for each tangential spring at the start: wall, mass, and stretch (px).
GRIPPED = GIVEN_GRIPPED

# endif
# ifdef HAS_RAILS
# A row for each mass that moves only along a rail: which it is, and the unit vector of the rail.
RAILS = np.array(GIVEN_RAILS)
RAILED, WAY = RAILS[:, 0].astype(int), RAILS[:, 1:]

# endif
# ifdef HAS_SLIDING
# A row for each mass that slides at the start on a wall with static friction: wall and mass.
SLIDING = GIVEN_SLIDING

# endif
# ifdef HAS_CIRCLES
# Of each held mass that goes round: which it is, its place at time 0 (px), radius (px), turns per second
# (Hz), and the time constant with which it speeds up (s).
CIRCLES = GIVEN_CIRCLES

# endif
# ifdef HAS_MUSCLES
# A row for each muscle: the spring whose rest length it moves (px), or the joint whose rest angle it moves
# (radians), where that rests, the amplitude, the rate of the phase (1/s), the phase at time 0, and 1 for a
# pulse or 0 for a sine.
# ifdef HAS_EFFORTS
# Or 2 for one that is steady. At the end, which number in STEER works it, or -1.
# EFFORT follows STEER with a time constant of 0.05 s.
EFFORT = np.array((GIVEN_EFFORT_X, GIVEN_EFFORT_Y))
# endif
# ifdef HAS_STRETCHED
STRETCHED = np.array(GIVEN_STRETCHED)
# endif
# ifdef HAS_BENT
BENT = np.array(GIVEN_BENT)
# endif

# endif


# ifdef HAS_GRIPS
def softened(stiffness):
    """The stiffness of tangential springs (1/s^2), so that a long step makes no energy."""
    return stiffness / (1.0 + (DT * DT * stiffness) ** 4) ** 0.25


def stretches(k, x):
    """Of the tangential springs between a wall and each mass (px), and where along it the masses are (px)."""
    nx, ny = WALLS[k][2:4]
    place = x[:, 1] * nx - x[:, 0] * ny
    # ifdef HAS_BELTS
    moved = place - PLACE[k] - BELTS[k] * DT  # since the end of the last step
    return np.where(np.isnan(PLACE[k]), 0.0, STRETCH[k] + moved), place
    # else
    return np.where(np.isnan(PLACE[k]), 0.0, STRETCH[k] + place - PLACE[k]), place
    # endif


# endif
# ifdef HAS_STATIC
def limits(k):
    """The coefficient of the friction between a wall and each mass."""
    friction = WALLS[k][5]
    return np.where(SLIDES[k], friction, max(STATIC[k], friction))


# endif
# ifdef HAS_WALLS
def touch(k, x, v):
    """How deep masses are inside a wall (px), and its push and friction (px/s^2).

    The push grows with the square of the depth, softened so that a long step makes no energy.
    """
    px, py, nx, ny, hardness, friction, slip, loss = WALLS[k][:8]
    # ifdef HAS_SIZES
    depth = np.maximum((px - x[:, 0]) * nx + (py - x[:, 1]) * ny + SIZES, 0.0)
    # else
    depth = np.maximum((px - x[:, 0]) * nx + (py - x[:, 1]) * ny, 0.0)
    # endif
    out, along = v[:, 0] * nx + v[:, 1] * ny, v[:, 1] * nx - v[:, 0] * ny
    # ifdef HAS_BELTS
    along -= BELTS[k]
    # endif
    power = (DT * (loss * hardness * depth**2 + 4.0 * DT * hardness * depth)) ** 4
    gain = 1.0 - (loss + 0.5 * DT / np.maximum(depth, 1e-300) * power / (1.0 + power)) * out
    # ifdef HAS_HYSTERESIS
    hysteresis, calm = WALLS[k][8:10]
    slow = ((calm * depth**1.5) ** 4 + (DT * hysteresis * hardness * depth**2) ** 4) ** 0.25
    gain -= hysteresis * np.tanh(out / np.maximum(slow, 1e-300))
    # endif
    push = hardness * depth**2 * np.maximum(gain, 0.0) / (1.0 + power) ** 0.25
    # ifdef HAS_STATIC
    friction = limits(k)
    # endif
    most = friction * push
    rub = most * np.tanh(along / (slip**4 + (DT * most) ** 4) ** 0.25)
    # ifdef HAS_GRIPS
    stiffness, damping = WALLS[k][-2:]
    if stiffness > 0.0:
        resist = damping / (1.0 + (2.0 * DT * damping) ** 4) ** 0.25
        held = np.clip(softened(stiffness) * stretches(k, x)[0], -most, most)
        rub = np.clip(held + resist * along, -most, most)
    # endif
    return depth, push, rub


# endif
# ifdef HAS_GRIPS
def stick(x, v):
    """After a step, note the stretch of each tangential spring. What is more than friction bears has slid."""
    for k, wall in enumerate(WALLS):
        if wall[-2] > 0.0:
            depth, push, _ = touch(k, x, v)
            stretch, place = stretches(k, x)
            most = wall[5] * push / softened(wall[-2])
            # ifdef HAS_STATIC
            along = v[:, 1] * wall[2] - v[:, 0] * wall[3]
            # ifdef HAS_BELTS
            along -= BELTS[k]
            # endif
            begins = ~SLIDES[k] & (STATIC[k] > wall[5])
            begins &= abs(stretch) >= WHOLE * limits(k) * push / softened(wall[-2])
            most = np.where(begins | SLIDES[k], most, limits(k) * push / softened(wall[-2]))
            SLIDES[k] = (depth > 0.0) & (begins | SLIDES[k] & (stretch * along > 0.0))
            # endif
            STRETCH[k], PLACE[k] = np.clip(stretch, -most, most), np.where(depth > 0.0, place, np.nan)


# endif
# ifdef HAS_RAILS
def along_rails(vectors):
    """Vectors of the masses on rails, without what is across the rails."""
    return WAY * (WAY * vectors).sum(1, keepdims=True)


# endif
def accelerations(x, v):
    """Of all masses, px/s^2."""
    force = np.zeros_like(x)
    # ifdef HAS_LOADS
    force[LOADS[:, 0].astype(int)] = LOADS[:, 1:]
    # endif
    # ifdef HAS_PUSHES
    force[PUSHED] += STEER[PUSHED_BY, None] * PUSHES[:, 1:3]
    # endif
    # ifdef HAS_SPRINGS
    spring = x[B] - x[A]
    length = np.sqrt((spring * spring).sum(1) + 1e-300)  # never 0, to divide by it
    pull = -K * (length - REST)
    # ifdef HAS_RATES
    rate = v[B] - v[A]
    # endif
    # ifdef HAS_DAMPING
    pull -= C * (spring * rate).sum(1) / length
    # endif
    # ifdef HAS_SPRING_SIDES
    # One of one side exerts nothing on the other, and damping does not turn its force round.
    acts = (SIDE * K * (length - REST) > 0.0) & (SIDE * pull < 0.0)
    pull[(SIDE != 0.0) & ~acts] = 0.0
    # endif
    on_b = spring * (pull / length)[:, None]  # the force on mass b; minus it acts on a
    # endif
    # ifdef HAS_JOINTS
    # Joints: the angle from p to q is drawn to the rest angle; see `sim.forces.reference`.
    p, q = spring[P], spring[Q]
    cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    dot = (p * q).sum(1)
    # ifdef HAS_ANGLE_LAW
    off = np.arctan2(cross, dot) - REST_ANGLE
    off -= 2.0 * np.pi * np.round(off / (2.0 * np.pi))
    torque = JOINT_K * length[P] * length[Q] * off
    energy = 0.5 * torque * off
    # else
    torque = JOINT_K * (COS * cross - SIN * dot)
    # endif
    # ifdef HAS_CONSERVATIVE_LAW
    energy = JOINT_K * (length[P] * length[Q] - COS * dot - SIN * cross)
    # endif
    # ifdef HAS_TURNING
    turning = (spring[:, 0] * rate[:, 1] - spring[:, 1] * rate[:, 0]) / length**2
    # endif
    # ifdef HAS_JOINT_DAMPING
    torque += JOINT_C * length[P] * length[Q] * (turning[Q] - turning[P])
    # endif
    # ifdef HAS_JOINT_SIDES
    # One of one side exerts nothing on the other, and damping does not turn its torque round.
    # ifdef HAS_ANGLE_LAW
    acts = (JOINT_SIDE * off > 0.0) & (JOINT_SIDE * torque > 0.0)
    # else
    acts = (JOINT_SIDE * (COS * cross - SIN * dot) > 0.0) & (JOINT_SIDE * torque > 0.0)
    # endif
    torque *= (JOINT_SIDE == 0.0) | acts
    # ifdef HAS_JOINT_ENERGY
    energy *= (JOINT_SIDE == 0.0) | acts
    # endif
    # endif
    across = np.stack((-spring[:, 1], spring[:, 0]), 1) / (length**2)[:, None]
    np.add.at(on_b, P, torque[:, None] * across[P])
    np.add.at(on_b, Q, -torque[:, None] * across[Q])
    # ifdef HAS_MOTORS
    first, second, wanted = P[MOTOR], Q[MOTOR], SPEED
    # ifdef HAS_STEERING
    wanted = np.where(STEERED < 0, 1.0, STEER[STEERED]) * SPEED
    # endif
    torque = MOST * np.tanh((wanted - turning[second] + turning[first]) / MARGIN)
    np.add.at(on_b, first, -torque[:, None] * across[first])
    np.add.at(on_b, second, torque[:, None] * across[second])
    # endif
    # ifdef HAS_JOINT_ENERGY
    # The energy grows with the lengths, and so pulls along the springs.
    along = spring / (length**2)[:, None]
    np.add.at(on_b, P, -energy[:, None] * along[P])
    np.add.at(on_b, Q, -energy[:, None] * along[Q])
    # endif
    # endif
    # ifdef HAS_SPRINGS
    np.add.at(force, B, on_b)
    np.add.at(force, A, -on_b)
    # endif
    # ifdef HAS_RESISTED
    # Springs are resisted at both ends, otherwise across than along themselves.
    size = length[WHOLE]
    ahead_x, ahead_y = spring[WHOLE].T / size
    for end, at in enumerate((A[WHOLE], B[WHOLE])):
        along, across = np.zeros((2, len(at)))
        # ifdef HAS_MEDIUM
        flow_x, flow_y = v[at].T
        # ifdef HAS_WIND
        flow_x, flow_y = flow_x - WIND[0], flow_y - WIND[1]
        # endif
        along += 0.5 * size * ALONG * (ahead_x * flow_x + ahead_y * flow_y)
        across += 0.5 * size * ACROSS * (ahead_x * flow_y - ahead_y * flow_x)
        # endif
        # ifdef HAS_GROUND
        slide_x, slide_y = v[at].T
        forward, sideways = ahead_x * slide_x + ahead_y * slide_y, ahead_x * slide_y - ahead_y * slide_x
        rub = RESISTED[:, 1 + end] / np.sqrt(slide_x**2 + slide_y**2 + SLIP**2)
        along += rub * np.where(forward > 0.0, FORWARD, BACKWARD) * forward
        across += rub * SIDEWAYS * sideways
        # endif
        back = np.stack((along * ahead_x - across * ahead_y, along * ahead_y + across * ahead_x), 1)
        np.add.at(force, at, -back)
    # endif
    # ifdef HAS_FILLINGS
    for is_gas, strength, outside, size, loop in FILLINGS:
        before, after, off = np.roll(x[loop], 1, 0), np.roll(x[loop], -1, 0), x[loop] - x[loop[0]]
        next_off = np.roll(off, -1, 0)
        area = 0.5 * (off[:, 0] * next_off[:, 1] - off[:, 1] * next_off[:, 0]).sum()
        if not is_gas:
            pressure = strength * (1.0 - area / size)
        elif area > 0.01 * size:
            pressure = strength * size / area - outside
        else:  # nearly nothing is left: no division by zero
            pressure = strength * (2.0 - area / (0.01 * size)) / 0.01 - outside
        way = after - before
        np.add.at(force, loop, 0.5 * pressure * np.stack((way[:, 1], -way[:, 0]), 1))
    # endif
    a = force / MASS
    # ifdef HAS_AIR
    air = v
    # ifdef HAS_WIND
    air = v - WIND
    # endif
    # ifdef HAS_AIR_BY_AXES
    air = air * abs(air)
    # endif
    # ifdef HAS_AIR_BY_SPEED
    air = air * np.sqrt((air * air).sum(1, keepdims=True))
    # endif
    a -= AIR * air / MASS
    # endif
    # ifdef HAS_GRAVITY
    a += GRAVITY
    # endif
    # ifdef HAS_WALLS
    for k, (_, _, nx, ny, *_) in enumerate(WALLS):
        _, push, rub = touch(k, x, v)
        a += np.stack((push * nx + rub * ny, push * ny - rub * nx), 1)
    # endif
    # ifdef HAS_RAILS
    a[RAILED] = along_rails(a[RAILED])
    # endif
    # ifdef HAS_HELD
    return np.where(FREE, a, 0.0)
    # else
    return a
    # endif


# ifdef HAS_CIRCLES
def lead(x, v, t):
    """Put masses on circles where they are at time t."""
    # ifdef HAS_RAILED_CIRCLES
    before = x[RAILED]  # those on rails go to and fro along them
    # endif
    for mass, at_x, at_y, radius, frequency, ramp in CIRCLES:
        fade, turn = np.exp(-t / ramp), 2.0 * np.pi * frequency
        phase, speed = turn * (t - ramp * (1.0 - fade)), radius * turn * (1.0 - fade)
        x[mass] = at_x + radius * np.sin(phase), at_y + radius * (1.0 - np.cos(phase))
        v[mass] = speed * np.cos(phase), speed * np.sin(phase)
    # ifdef HAS_RAILED_CIRCLES
    x[RAILED], v[RAILED] = before + along_rails(x[RAILED] - before), along_rails(v[RAILED])
    # endif


# endif
# ifdef HAS_MUSCLES
def moved(muscles, t):
    """Rest lengths or rest angles that muscles move, at time t."""
    # ifdef HAS_EFFORTS
    rest, amplitude, rate, phase, pulse, keys = muscles.T[1:]
    effort = np.where(keys < 0, 1.0, EFFORT[keys.astype(int)])
    wave = np.sin(np.copysign(rate, effort) * t + phase)
    wave = np.abs(effort) * np.where(pulse == 1, np.exp(4.0 * (wave - 1.0)), wave)
    return rest + amplitude * np.where(pulse == 2, effort, wave)
    # else
    rest, amplitude, rate, phase, pulse = muscles.T[1:]
    wave = np.sin(rate * t + phase)
    return rest + amplitude * np.where(pulse == 1, np.exp(4.0 * (wave - 1.0)), wave)
    # endif


def flex(t):
    """Let all muscles move to where they are at time t."""
    # ifdef HAS_EFFORTS
    EFFORT[:] = STEER + (EFFORT - STEER) * np.exp(-DT / 0.05)
    # endif
    # ifdef HAS_STRETCHED
    REST[STRETCHED[:, 0].astype(int)] = moved(STRETCHED, t)
    # endif
    # ifdef HAS_BENT
    bent, angle = BENT[:, 0].astype(int), moved(BENT, t)
    # ifdef HAS_ANGLE_LAW
    REST_ANGLE[bent] = angle
    # else
    COS[bent], SIN[bent] = np.cos(angle), np.sin(angle)
    # endif
    # endif


# endif
def step(x, v, t):
    """One time step from time t (s), in place."""
    # ifdef HAS_MUSCLES
    flex(t + DT)
    # endif
    v += DT * accelerations(x, v)
    x += DT * v
    # ifdef HAS_CIRCLES
    lead(x, v, t + DT)  # the step has moved them
    # endif
    # ifdef HAS_GRIPS
    stick(x, v)
    # endif


if __name__ == "__main__":
    x, v = MASSES[:, 0:2].copy(), MASSES[:, 2:4].copy()
    # ifdef HAS_GRIPPED
    for wall, mass, stretch in GRIPPED:
        STRETCH[wall, mass], PLACE[wall, mass] = stretch, stretches(wall, x)[1][mass]
    # endif
    # ifdef HAS_SLIDING
    for wall, mass in SLIDING:
        SLIDES[wall, mass] = True
    # endif
    steps = int(sys.argv[1]) if len(sys.argv) > 1 else GIVEN_STEPS
    for i in range(steps):
        step(x, v, GIVEN_START + i * DT)
    for at in x.tolist():
        print(*at)
