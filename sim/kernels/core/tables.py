"""The arrays that the kernels read and write.

Every array is one-dimensional, C-contiguous, float64 or int64, so that a kernel is compiled once.

Masses stand at indices 1 to n: index 0 is padding, so that the chain's loops can look back without a test,
and the places behind n are filled up to a multiple of eight, so that vector loops have no scalar rest, which
for twelve masses is the larger part of the work. Springs are filled up likewise. A padding mass never
moves and a padding spring pulls at nothing.
"""

from __future__ import annotations

from .table import Floats, Indices, Rows, Table


class Body(Table):
    """Read-only: how masses are joined, and the springs' constants. S springs, J joints, n masses.

    In a chain, spring s joins the masses at places s + 1 and s + 2, and joint j holds springs j and j + 1. So
    it does in a ring, where the mass at place n + 1 is the first one again, and the spring n the first one.
    """

    masses: int
    springs: int
    joints: int
    damped: bool  # any linear spring has damping
    joint_damped: bool  # any angular spring has damping
    chain: bool  # the springs run head to tail through all masses, in order
    ring: bool  # so they do, and back to the first
    law: int  # see `laws`
    softening: float  # px²; the length of a spring with vector L is sqrt(L² + softening)
    softenings: Floats  # that of every spring, for `links`; of padding so much that it is never the shortest
    spring_a: Indices  # (S,) mass at the start of each spring
    spring_b: Indices
    stiffness: Floats  # (S padded + 1) kg/s²
    damping: Floats  # (S padded + 1) kg/s
    rest_length: Floats  # (S padded + 1) px, before the scale
    joint_a: Indices  # (J,) first spring of each joint
    joint_b: Indices
    joint_stiffness: Floats  # (J,) kg/s²
    joint_rest: Floats  # (J,) degrees, before the shift
    torque_size: Floats  # stiffness of joint j at index j + 1, kg/s²; at index 0 a ring's last, or zero
    torque_damping: Floats  # damping of joint j at index j + 1, kg/s
    # The torque of a joint acts on its spring a with one sign and on its spring b with the other. Each spring
    # names the place of one joint of which it is b and one of which it is a (0 where there is none: a
    # torque of zero); the rare others are in the lists. So the common case is a gather without branches.
    # Springs that joints hold come before all others.
    hinged: int  # how many springs joints hold
    joint_in: Indices  # (S,)
    joint_out: Indices  # (S,)
    more_joint: Indices
    more_joint_spring: Indices
    more_joint_sign: Floats
    # The same for the springs of each place of a mass; there, the padding behind the springs stands for none.
    # Where many masses have more springs, each names two more in the next layer, and so on.
    layers: int
    spring_in: Indices  # (layers (n + 1),)
    spring_out: Indices  # (layers (n + 1),)
    more_spring: Indices
    more_spring_mass: Indices
    more_spring_sign: Floats


class State(Table):
    """Mutable: positions and velocities, and what the keys and the hand of the user change while it runs.

    Vectors are flat: x of every slot, then y of every slot. No mass is at the first place of either half,
    nor at the last `SPARE` ones; loops over a vector leave them out at its two ends, and so start where loops
    over masses do: what is stored by one is loaded by the next in the same pieces, without waiting.
    """

    q: Floats  # (2 slots) positions, px
    v: Floats  # (2 slots) velocities, px/s
    controls: Floats  # rest_length_scale, rest_angle_shift (degrees)
    pull: Floats  # (S padded + 1) stiffness * rest length now
    torque_cos: Floats  # stiffness * cos(rest angle now), that of joint j at index j + 1; index 0 as above
    torque_sin: Floats
    torque_rest: Floats  # rest angle now, radians, that of joint j at index j + 1
    # What acts on each mass beside the springs; all zero for a mass that is held.
    inverse_mass: Floats  # (slots) 1/kg
    air: Floats  # (slots) air friction / mass, 1/px
    gx: Floats  # (slots) px/s²
    gy: Floats

    @property
    def slots(self) -> int:
        """How many there are, padding included."""
        return self.q.size // 2

    @property
    def x(self) -> Floats:
        """(slots) a view of the first half of `q`; for Python only, as the others below."""
        return self.q[: self.slots]

    @property
    def y(self) -> Floats:
        """(slots) a view of the second half of `q`."""
        return self.q[self.slots :]

    @property
    def vx(self) -> Floats:
        """(slots) a view of the first half of `v`."""
        return self.v[: self.slots]

    @property
    def vy(self) -> Floats:
        """(slots) a view of the second half of `v`."""
        return self.v[self.slots :]


class Scratch(Table):
    """Scratch, so that no step allocates."""

    lx: Floats  # (S padded) vectors of the springs
    ly: Floats
    dvx: Floats
    dvy: Floats
    inverse: Floats  # 1 / length; `chain_accelerations` only tells that of the shortest spring, at index 0
    turning: Floats  # rate at which a spring turns, 1/s
    turn: Floats  # what the torques of its joints add up to at each spring
    draw: Floats  # what the energies of its joints add up to at each spring
    hold: Floats  # what their conservative pulls along it add up to at each spring, times its length
    brake: Floats  # what the torques of their damping add up to at each spring
    torque: Floats  # of joint j at index j + 1
    energy: Floats  # of joint j at index j + 1, under a law that has one, as the law's loop wants it
    dot: Floats  # K A . R(-r) B of joint j at index j + 1, under the conservative law
    friction: Floats  # torque of the damping of joint j at index j + 1
    tx: Floats  # force on the b end of each spring; in a chain at the place of the mass at that end
    ty: Floats
    fx: Floats  # (slots)
    fy: Floats


CONTROL_SCALE = 0
"""In `State.controls`: the factor of all rest lengths."""
CONTROL_SHIFT = 1
"""In `State.controls`: what is added to all rest angles, degrees."""
SCALE_MIN = 0.01
"""The least factor of rest lengths."""
SCALE_MAX = 100.0
"""The largest factor of rest lengths."""


SHORTEST_SQUARED = 1e-300
"""Smallest softening, px²: it changes no length but zero. A spring of exactly zero length has no direction;
with this it pulls at nothing, instead of making everything NaN."""


def padded(count: int) -> int:
    """The count, rounded up to a multiple of eight."""
    return -(-count // 8) * 8


SPARE = 7
"""Places at the end of a flat vector that no mass is ever at; see `IntegratorState`."""


class Matrix(Table):
    """What an implicit step needs: the factors of its matrix and, where the body is no chain, the pattern."""

    blocks: Floats  # the factors; see `joint_damped` and `sparse`
    parts: Floats  # scratch of a chain; see `band`
    ux: Floats  # (S padded + 1) unit vectors of the springs where the matrix was built, each at index s + 1
    uy: Floats
    inverse: Floats  # 1 / length there, likewise
    damping: Floats  # of the springs, likewise
    # A spanning forest: an order of the masses in which the one that a mass hangs on comes before it.
    walk: Indices  # (n,) places
    parent: Indices  # (slots) the place that a mass hangs on; 0 for one that is held, or first in its part
    # Empty for a chain. Rows are numbered in the order of elimination.
    order: Indices  # (n,) place of the mass that row i belongs to
    row_start: Indices  # (n + 1,) first block of each row
    column: Indices  # of each block, ascending in a row
    diagonal: Indices  # (n,) block on the diagonal
    slot: Indices  # (n,) scratch: block of the present row in each column
    spring_target: Indices  # (4 S,) blocks that a spring adds to, at rows and columns bb, ba, ab, aa
    joint_target: Indices  # (16 J,) blocks that a joint adds to, likewise for each pair of its springs
    straight: bool  # each mass of the forest that hangs on another one hangs on that of the place before it


class Drive(Table):
    """How held masses move, and what held keys do, from the start of a call on."""

    moving: bool  # any mass of the list moves, or a key is held
    pressed: bool  # a key is held
    start: float  # time at the start of the call, s
    duration: float  # s until masses that are led straight have reached their targets; infinite if none is
    mass: Indices  # (M,) places of the masses
    x: Floats  # (M,) px, where each is at the start, without its circle
    y: Floats
    vx: Floats  # (M,) px/s, at the start
    vy: Floats
    ax: Floats  # (M,) px/s², at the start
    ay: Floats
    jx: Floats  # (M,) px/s³
    jy: Floats
    hand: Floats  # (M,) 0 where a mass moved by hand counts as standing still in the damping, 1 elsewhere
    radius: Floats  # (M,) px, of its circle
    omega: Floats  # (M,) 1/s
    ramp: Floats  # (M,) s
    scale: float  # of rest lengths at the start
    shift: float  # of rest angles at the start, degrees
    growth: float  # logarithm of the factor of rest lengths, 1/s
    turn: float  # degrees/s added to the rest angles


class IntegratorState(Table):
    """Mutable: what an integrator carries from step to step, and its scratch; vectors as in `State`."""

    a: Floats  # px/s², of the state
    controller: Floats  # see the CLOCK_ constants
    limits: Floats  # farthest coordinate, px, and fastest speed, px/s, that a good state has
    counts: Indices  # see the COUNT_ constants
    rows: Rows  # (R, 2 slots) scratch
    selector: Floats  # what `auto` has learnt, see the AUTO_ constants
    history: (
        Rows  # (4, 2 slots) what generalized-alpha carries from step to step; no rows where it is not used
    )
    past: Rows  # (PAST, 2 slots) past accelerations, of Adams' methods; no rows where they are not used


CONTROLLER_TIME = 0
"""In `controller`: simulated time, s."""
CONTROLLER_STEP = 1
"""In `controller`: the next step that the method in use would try, s; 0 when it has to find out."""
CONTROLLER_CAP = 2
"""In `controller`: the largest step that seems to be stable, s."""
CONTROLLER_LAST = 3
"""In `controller`: the last step that `history` knows of, s; 0 where it does not."""
CONTROLLER_LAST_BUT_ONE = 4
"""In `controller`: the one before it, s; 0 where `history` does not know it."""
CONTROLLER_SOLVABLE = 5
"""In `controller`: the largest step for which Newton's method seems to converge, s; 0 where unknown."""
CONTROLLER_BEGUN = 6
"""In `controller`: how many steps generalized-alpha has taken since it took over."""
CONTROLLER_PAST = 7
"""In `controller`, of Adams' methods: the time that `past` goes up to, s; negative where it says nothing."""
CONTROLLER_SPACING = 8
"""In `controller`, of Adams' methods: the time between two rows of `past`, s."""
CONTROLLER_DEGREE = 9
"""In `controller`, of Adams' methods: the degree of the polynomial."""
CONTROLLER_HEAD = 10
"""In `controller`, of Adams' methods: the row of the latest acceleration."""
CONTROLLER_SINCE = 11
"""In `controller`, of Adams' methods: steps since a change of the step."""
CONTROLLER_HELD = 12
"""In `controller`: the share of Verlet's steps in its last turn that its stability kept short."""
CONTROLLER_CONTRACTION = 13
"""In `controller`: how large a second move of Newton's method is for the square of the first, 1/px; 0
where unknown."""
CONTROLLER_CUBE = 14
"""In `controller`: a product of three spans of time, s³, that the error of generalized-alpha's last
prediction goes with; 0 where it is not known."""
CONTROLLER_MOST = 15
"""In `controller`, of Adams' methods: the degree to rise to."""
CONTROLLER_KNOWN = 16
"""In `controller`, of Adams' methods: rows of `past`, from the latest on, that are at the present spacing."""
CONTROLLERS = 17

ARM_VERLET, ARM_ROSENBROCK, ARM_ALPHA, ARM_ADAMS = 0, 1, 2, 3
"""The methods that `auto` chooses from."""
ARMS = 4

AUTO_STEP = 0
"""In `selector`: from here on, the next step of each method, s."""
AUTO_PACE = ARMS
"""In `selector`: from here on, simulated time for the computing of a Verlet step, s; negative where
unknown."""
AUTO_WORK = 2 * ARMS
"""In `selector`: computing, in Verlet steps, since a method was asked."""
AUTO_LAST = 2 * ARMS + 1
"""In `selector`: the method that had the last turn."""
AUTO_ASKED = 2 * ARMS + 2
"""In `selector`: how many times a method was asked."""
AUTO_TURN = 2 * ARMS + 3
"""In `selector`: the method whose turn is under way, or -1."""
AUTO_BEGAN = 2 * ARMS + 4
"""In `selector`: the time when that turn began, s."""
AUTO_TRIED = 2 * ARMS + 5
"""In `selector`: the steps that had been tried then."""
AUTO_NEW = (0.0,) * ARMS + (-1.0,) * ARMS + (0.0,) * 3 + (-1.0, 0.0, 0.0)
"""What `auto` knows at first."""

COUNT_FRESH = 0
"""In `counts`: whether `a` is that of the state."""
COUNT_STEPS = 1
"""In `counts`: steps kept."""
COUNT_REJECTED = 2
"""In `counts`: steps tried in vain."""
COUNT_WHAT = 3
"""In `counts`: GOOD, or what is wrong."""
COUNT_MASS = 4
"""In `counts`: the mass that shows it."""
COUNT_FORCES = 5
"""In `counts`: evaluations of the accelerations."""
COUNT_MATRICES = 6
"""In `counts`: matrices factorised."""
COUNT_FALLBACKS = 7
"""In `counts`: fallback steps."""
COUNTS = 8


class Tableau(Table):
    """An explicit Runge-Kutta(-Nyström) method for q'' = f(t, q, q').

    Stage i is at q + c_i h v + h² sum abar_ij k_j and v + h sum a_ij k_j.
    """

    stages: int  # evaluations of a step; the first of the next step is the last of this one
    c: Floats  # (stages + 1,) the last is the end of the step
    a: Rows  # (stages + 1, stages + 1); the last row is b
    abar: Rows


class Rosenbrock(Table):
    """A Rosenbrock method, in the form in which each stage is one solve (Hairer & Wanner II, IV.7).

    Rows are padded with zeros to a multiple of four stages.
    """

    stages: int
    order: int  # power of the step that the error estimate goes with
    gamma: float
    c: Floats  # (stages + 1,) times of the stages; the last is the end of the step
    slope: Floats  # (stages,) weights of the derivative by time
    a: Rows  # (stages + 1, padded); the last row gives the end of the step
    coupling: Rows  # (stages + 1, padded); the last row, which is no stage's, is zero
    error: Floats  # (padded) weights of the error estimate


PAST = 8
"""Past accelerations that are kept for Adams' methods: one more than the highest degree. A power of two."""


class Adams(Table):
    """Adams' methods for q'' = f(t, q, q'), by the degree k of the polynomial through past accelerations.

    The weights of the acceleration i steps back are in column i.
    """

    degree: int  # the highest that is used
    position: Rows  # (PAST, PAST) in a predicted position, by row k
    velocity: Rows  # in a predicted velocity
    ahead: Rows  # in the acceleration that is expected
    barycentric: Rows  # in an interpolated acceleration, but for the distances in time from all others
    to_position: Floats  # (PAST,) of what the acceleration is off, in a corrected position
    to_velocity: Floats  # in a corrected velocity
    error: Floats  # in the error estimate
    back: Rows  # (PAST², PAST) in the velocity gained in the last r steps, in row k PAST + r


class EnergyBalance(Table):
    """What has changed the energy since the balance was opened; scratch for finding it out."""

    active: bool
    work: Floats  # (WORKS,) kg px²/s², see the WORK_ constants
    mass: Floats  # (slots) kg
    rows: Rows  # (3, 2 slots) scratch
    dampers: Rows  # (DAMPER_ROWS, springs + joints) scratch, see `dissipation`


WORK_ANCHORS = 0
"""In `EnergyBalance.work`: done by moved anchors."""
WORK_DAMPING = 1
"""In `EnergyBalance.work`: taken away by damping, so negative."""
WORK_AIR = 2
"""In `EnergyBalance.work`: taken away by air, so negative."""
WORK_LAW = 3
"""In `EnergyBalance.work`: done by a law without an energy."""
WORK_KEYS = 4
"""In `EnergyBalance.work`: done by keys that change rest lengths and angles."""
WORK_FALLBACK = 5
"""In `EnergyBalance.work`: taken away by fallback steps."""
WORKS = 6


class Problem(Table):
    """All that a run of a method needs, beside what drives the body and how far it is to go."""

    body: Body
    state: State
    scratch: Scratch
    matrix: Matrix  # empty where no method is implicit
    integrator: IntegratorState
    balance: EnergyBalance
    # Addresses of kernels, see `shared`; 0 where the method has no use for one.
    accelerations: int
    accumulate: int
    factorise: int
    solve: int
    fixed: float  # the step, s, or 0 for error control
    near_limit: float  # s; steps from here on are near Verlet's stability limit
    explicit: Tableau
    implicit: Rosenbrock
    adams: Adams
    costs: Floats  # (ARMS,) of a step of each method for `auto`, in those of Verlet's; 0: not used
    tolerance_factor: Floats  # (ARMS,) of each of them
