"""The tables that the kernels read and write.

Every array is C-contiguous and holds float64 or int64, so that a kernel is compiled for one type only.

The masses are at indices 1 to n, and the indices of an array are called slots. Slot 0 is padding, so that the
chain's loops can look back without a test. The slots after n are padding up to a multiple of eight, so that
vectorised loops have no scalar remainder, which for twelve masses would be most of the work. Springs are
padded likewise. A padding mass never moves, and a padding spring exerts no force.
"""

from __future__ import annotations

from typing import Any

from .strength import Strength
from .table import Floats, Indices, Rows, Table

Environment = Any
"""`forces.environment.Environment`, whose parts are on the pages about forces: these need the tables here."""


class Body(Table):
    """Read-only: which masses the springs connect, and the springs' constants. S springs, J joints, n masses.

    In a chain, spring s connects the masses in slots s + 1 and s + 2, and joint j holds springs j and j + 1.
    A ring has the same numbering, with slot n + 1 standing for the first mass and spring n for the first
    spring.
    """

    masses: int
    springs: int
    joints: int
    damped: bool  # any linear spring has damping
    joint_damped: bool  # any angular spring has damping
    chain: bool  # the springs run head to tail through all masses, in order
    ring: bool  # likewise, and the last one leads back to the first mass
    law: int  # see `forces.joints`
    softening: float  # px²; the length of a spring with vector L is sqrt(L² + softening)
    softenings: Floats  # (S padded + 1) px², for `forces.chain`; very large for padding
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
    # The torque of a joint acts on its springs a and b with opposite signs. Each spring has the index j + 1
    # of one joint in which it is b and of one in which it is a, or 0 where there is none, for a torque of
    # zero. The few others are in lists, so that the common case is a gather without branches. Springs that
    # are held by joints come before all others.
    hinged: int  # number of springs that joints hold
    joint_in: Indices  # (S,)
    joint_out: Indices  # (S,)
    more_joint: Indices  # of each joint in the lists: its index j + 1,
    more_joint_spring: Indices  # the spring that it acts on,
    more_joint_sign: Floats  # and the sign
    # The same for the springs at each slot of a mass; the padding after the springs stands for none. Where
    # many masses have more springs, each has two more in the next layer, and so on.
    layers: int
    spring_in: Indices  # (layers (n + 1),)
    spring_out: Indices  # (layers (n + 1),)
    more_spring: Indices  # of each spring in the lists: its index,
    more_spring_mass: Indices  # the slot of the mass that it acts on,
    more_spring_sign: Floats  # and the sign
    environment: Environment  # what else acts on the masses; see there
    strength: Strength  # what springs and joints bear; see there


class State(Table):
    """Mutable: positions and velocities, and what keys and dragging change while a body moves.

    Vectors are flat: x of every slot, then y of every slot. There is no mass in the first slot of either
    half, nor in the last `SPARE` ones. Loops over a flat vector skip these slots at its two ends, so that
    they start where loops over masses start: the vectors that one loop stores are those that the next one
    loads, which avoids stalls.
    """

    q: Floats  # (2 slots) positions, px
    v: Floats  # (2 slots) velocities, px/s
    controls: Floats  # rest_length_scale, rest_angle_shift (degrees)
    rest_tension: Floats  # (S padded + 1) stiffness * present rest length, kg px/s²
    torque_cos: Floats  # stiffness * cos(rest angle now), kg/s², of joint j at index j + 1; index 0 as above
    torque_sin: Floats  # likewise with the sine
    torque_rest: Floats  # present rest angle, radians, of joint j at index j + 1
    # What acts on each mass besides the springs; all zero for a mass that is held.
    inverse_mass: Floats  # (slots,) 1/kg
    air: Floats  # (slots,) air friction / mass, 1/px
    gx: Floats  # (slots,) acceleration by gravity and by the constant force on each mass, px/s²
    gy: Floats
    clock: Floats  # (1,) time of the gusts, s
    # Empty where nothing yields or breaks.
    set_length: Floats  # (S,) px by which rest lengths have moved for good
    set_angle: Floats  # (J,) degrees by which rest angles have
    hardened: Floats  # (S,) kg px/s² by which yield forces have grown
    broken: Floats  # (S,) 1 for a spring that is broken, else 0

    @property
    def slots(self) -> int:
        """Number of slots, padding included."""
        return self.q.size // 2

    @property
    def x(self) -> Floats:
        """(slots,) a view of the first half of `q`; for Python only, like the three below."""
        return self.q[: self.slots]

    @property
    def y(self) -> Floats:
        """(slots,) a view of the second half of `q`."""
        return self.q[self.slots :]

    @property
    def vx(self) -> Floats:
        """(slots,) a view of the first half of `v`."""
        return self.v[: self.slots]

    @property
    def vy(self) -> Floats:
        """(slots,) a view of the second half of `v`."""
        return self.v[self.slots :]


class Scratch(Table):
    """Scratch arrays, so that no step allocates memory."""

    lx: Floats  # (S padded) vectors of the springs, px
    ly: Floats
    dvx: Floats  # their rates, px/s
    dvy: Floats
    inverse: Floats  # 1 / length, 1/px; `chain_accelerations` stores only that of the shortest, at index 0
    turning: Floats  # rate at which a spring turns, 1/s
    torque_at: Floats  # sum of the torques of the joints at each spring
    energy_at: Floats  # sum of their energies
    dot_at: Floats  # sum of their `dot`, or of what stands for it under other laws
    friction_at: Floats  # sum of the torques of their damping
    torque: Floats  # of joint j at index j + 1
    energy: Floats  # of joint j at index j + 1, as far as the loop of the law needs it
    dot: Floats  # K A . R(-r) B of joint j at index j + 1, under the conservative law
    friction: Floats  # torque of the damping of joint j at index j + 1
    tx: Floats  # force on the b end of each spring, kg px/s²
    ty: Floats
    fx: Floats  # (slots,) force of springs and joints on each mass, kg px/s²
    fy: Floats


CONTROL_SCALE = 0
"""In `State.controls`: the factor of all rest lengths."""
CONTROL_SHIFT = 1
"""In `State.controls`: the angle that is added to all rest angles, degrees."""
SCALE_MIN = 0.01
"""The smallest factor of rest lengths."""
SCALE_MAX = 100.0
"""The largest factor of rest lengths."""

SHORTEST_SQUARED = 1e-300
"""Smallest softening, px². It changes no length but zero: a spring of zero length then exerts no force,
instead of making everything NaN."""


def padded(count: int) -> int:
    """The count, rounded up to a multiple of eight."""
    return -(-count // 8) * 8


SPARE = 7
"""Number of slots at the end of a flat vector that are always padding; see `State`."""


class Matrix(Table):
    """The factors of the matrix of an implicit step, and their pattern."""

    blocks: Floats  # the factors; see `linear.sparse`
    # A spanning forest: an order of the masses in which every mass comes after its parent.
    walk: Indices  # (n,) slots of the masses in this order
    parent: Indices  # (slots,) slot of the parent; 0 for a mass that is held or first in its part of the body
    # Rows are numbered in the order of elimination.
    order: Indices  # (n,) slot of the mass that row i belongs to
    row_start: Indices  # (n + 1,) first block of each row
    column: Indices  # of each block, ascending in a row
    diagonal: Indices  # (n,) block on the diagonal of each row
    slot: Indices  # (n,) scratch: block of the current row in each column
    spring_target: Indices  # (4 S,) blocks that a spring adds to, at rows and columns bb, ba, ab, aa
    joint_target: Indices  # (16 J,) blocks that a joint adds to, likewise for each pair of its springs
    loop_target: Indices  # (2 M,) for each mass of a loop, blocks of its row with the masses before and after
    # For the products of gradients of L fillings, see `linear.implicit`.
    borders: Rows  # (2 L, 2 slots)
    corrections: Rows  # (L + 1, L)
    # For contact, see `linear.krylov`; empty where there is none.
    of_mass: Indices  # (slots,) block of each mass on the diagonal
    touching: Floats  # (3,), see the TOUCHING_ constants there
    touched: Rows  # (3, 2 slots) positions, velocities and inverse masses for which the matrix was built
    krylov: Rows  # (K + 3, 2 slots) basis of a Krylov space, and scratch
    hessenberg: Rows  # (K + 4, K + 1) scratch of GMRES


class Drive(Table):
    """How held masses move, and what held keys do, during a call."""

    moving: bool  # any mass is listed here, a key is held, or a force changes with time
    pressed: bool  # a key is held
    timed: bool  # a force changes with time by itself, see `forces.term.Term`
    start: float  # time at the start of the call, s
    duration: float  # s until masses that are led straight reach their targets; infinite if there are none
    mass: Indices  # (M,) slots of the masses
    x: Floats  # (M,) px, where each is at the start, without its circle
    y: Floats
    vx: Floats  # (M,) px/s, at the start
    vy: Floats
    ax: Floats  # (M,) px/s², at the start
    ay: Floats
    jx: Floats  # (M,) px/s³, constant
    jy: Floats
    hand: Floats  # (M,) 0 where the damping treats a dragged mass as being at rest, 1 elsewhere
    radius: Floats  # (M,) px, of its circle; 0 where there is none
    omega: Floats  # (M,) angular frequency, 1/s
    ramp: Floats  # (M,) time constant, s
    scale: float  # of rest lengths at the start
    shift: float  # of rest angles at the start, degrees
    growth: float  # rate of the logarithm of the scale of rest lengths, 1/s
    turn: float  # rate of the rest angles, degrees/s


class IntegratorState(Table):
    """Mutable: what an integrator keeps from step to step, and its scratch; vectors as in `State`."""

    a: Floats  # accelerations of the state, px/s²
    controller: Floats  # see the CONTROLLER_ constants
    limits: Floats  # largest coordinate, px, and largest velocity component, px/s, of a good state
    counts: Indices  # see the COUNT_ constants
    rows: Rows  # (R, 2 slots) scratch
    selector: Floats  # what `auto` has learnt, see the AUTO_ constants
    history: Rows  # (4, 2 slots) kept by generalized-alpha from step to step; no rows where it is not used
    past: Rows  # (PAST, 2 slots) past accelerations of Adams methods; no rows where they are not used


CONTROLLER_TIME = 0
"""In `controller`: simulated time, s."""
CONTROLLER_STEP = 1
"""In `controller`: the next step that the current method would try, s; 0 where unknown."""
CONTROLLER_CAP = 2
"""In `controller`: the largest step of Verlet that seems to be stable, s."""
CONTROLLER_LAST = 3
"""In `controller`: the last step that is part of `history`, s; 0 where there is none."""
CONTROLLER_LAST_BUT_ONE = 4
"""In `controller`: the step before it in `history`, s; 0 where there is none."""
CONTROLLER_SOLVABLE = 5
"""In `controller`: the largest step for which Newton's method seems to converge, s; 0 where unknown."""
CONTROLLER_BEGUN = 6
"""In `controller`: number of steps that generalized-alpha has taken since it took over."""
CONTROLLER_PAST = 7
"""In `controller`, of Adams methods: time of the latest row of `past`, s; negative if that is invalid."""
CONTROLLER_SPACING = 8
"""In `controller`, of Adams methods: the time between two rows of `past`, s."""
CONTROLLER_DEGREE = 9
"""In `controller`, of Adams methods: the degree of the polynomial."""
CONTROLLER_HEAD = 10
"""In `controller`, of Adams methods: the row of `past` with the latest acceleration."""
CONTROLLER_SINCE = 11
"""In `controller`, of Adams methods: number of steps since the step size changed."""
CONTROLLER_HELD = 12
"""In `controller`: the share of Verlet's steps in its last turn that were limited by stability."""
CONTROLLER_CONTRACTION = 13
"""In `controller`: size of the second update of Newton's method divided by the square of the first, 1/px; 0
where unknown."""
CONTROLLER_CUBE = 14
"""In `controller`: a product of three time spans, s³, to which the error of generalized-alpha's last
prediction is proportional; 0 where unknown."""
CONTROLLER_MOST = 15
"""In `controller`, of Adams methods: the degree that the method is raising its degree to."""
CONTROLLER_KNOWN = 16
"""In `controller`, of Adams methods: number of rows of `past`, from the latest on, at the present spacing."""
CONTROLLER_ORIGIN = 17
"""In `controller`: the time at which the run began, s."""
CONTROLLERS = 18
"""Length of `controller`."""

ARM_VERLET, ARM_ROSENBROCK, ARM_ALPHA, ARM_ADAMS = 0, 1, 2, 3
"""The methods that `auto` chooses from."""
ARMS = 4
"""Number of these methods."""

AUTO_STEP = 0
"""In `selector`: from here on, the next step of each method, s."""
AUTO_PACE = ARMS
"""In `selector`: from here on, the simulated time, s, that each method gains in the computing time of one
Verlet step; negative where unknown."""
AUTO_WORK = 2 * ARMS
"""In `selector`: computing time since another method was last tried, in Verlet steps."""
AUTO_LAST = 2 * ARMS + 1
"""In `selector`: the method that had the last turn."""
AUTO_ASKED = 2 * ARMS + 2
"""In `selector`: number of times that another method was tried."""
AUTO_TURN = 2 * ARMS + 3
"""In `selector`: the method whose turn it is, or -1."""
AUTO_BEGAN = 2 * ARMS + 4
"""In `selector`: the time at which this turn began, s."""
AUTO_TRIED = 2 * ARMS + 5
"""In `selector`: the number of steps that had been tried by then."""
AUTO_NEW = (0.0,) * ARMS + (-1.0,) * ARMS + (0.0,) * 3 + (-1.0, 0.0, 0.0)
"""Initial contents of `selector`."""

COUNT_FRESH = 0
"""In `counts`: 1 if `a` belongs to the present state, 0 if not."""
COUNT_STEPS = 1
"""In `counts`: number of accepted steps."""
COUNT_REJECTED = 2
"""In `counts`: number of rejected steps."""
COUNT_WHAT = 3
"""In `counts`: GOOD or what is wrong, see `integrators.guard`."""
COUNT_MASS = 4
"""In `counts`: slot of the mass at which it was found."""
COUNT_FORCES = 5
"""In `counts`: number of evaluations of the accelerations."""
COUNT_MATRICES = 6
"""In `counts`: number of factorised matrices."""
COUNT_FALLBACKS = 7
"""In `counts`: number of fallback steps."""
COUNTS = 8
"""Length of `counts`."""


class Tableau(Table):
    """An explicit Runge-Kutta method for q'' = f(t, q, q').

    Stage i is at q + c_i h v + h² sum abar_ij k_j and v + h sum a_ij k_j.
    """

    stages: int  # evaluations of a step; the first of the next step is that at the end of this one
    c: Floats  # (stages + 1,) the last is the end of the step
    a: Rows  # (stages + 1, stages + 1); the last row is b
    abar: Rows  # a a


class Rosenbrock(Table):
    """A Rosenbrock method, in the form in which each stage is one solve (Hairer & Wanner II, IV.7).

    Rows are padded with zeros to a multiple of four stages.
    """

    stages: int
    order: int  # power of the step to which the error estimate is proportional
    gamma: float
    c: Floats  # (stages + 1,) times of the stages; the last is the end of the step
    slope: Floats  # (stages,) weights of the derivative with respect to time
    a: Rows  # (stages + 1, padded); the last row gives the end of the step
    coupling: Rows  # (stages + 1, padded); the last row belongs to no stage and is zero
    error: Floats  # (padded) weights of the error estimate


PAST = 8
"""Number of accelerations that Adams methods keep, one more than the highest degree; a power of two."""


class Adams(Table):
    """Adams methods for q'' = f(t, q, q'), by the degree k of the polynomial through past accelerations.

    Row k of each table is for degree k, and column i has the weight of the acceleration i steps back.
    """

    degree: int  # the highest that is used
    position: Rows  # (PAST, PAST) weights in the predicted position
    velocity: Rows  # in the predicted velocity
    ahead: Rows  # in the predicted acceleration
    barycentric: Rows  # in an interpolated acceleration, without the factors of the time distances
    to_position: Floats  # (PAST,) weight of the error of the predicted acceleration in the corrected position
    to_velocity: Floats  # in the corrected velocity
    error: Floats  # in the error estimate
    back: Rows  # (PAST², PAST) weights in the velocity gained in the last r steps, in row k PAST + r


class EnergyBalance(Table):
    """What has changed the energy since the balance was opened, and scratch for computing it."""

    active: bool
    work: Floats  # (WORKS,) kg px²/s², see the WORK_ constants
    mass: Floats  # (slots,) kg
    rows: Rows  # (k, 2 slots) scratch, see `energy.work`
    dampers: Rows  # (DAMPER_ROWS, springs + joints) scratch, see `energy.dissipation`
    quick: Rows  # (W, 2 slots) scratch, see `forces.walls.mark_quick`; empty for methods of first order


WORK_ANCHORS = 0
"""In `EnergyBalance.work`: work done by moved anchors."""
WORK_DAMPING = 1
"""In `EnergyBalance.work`: work of damping, which is negative."""
WORK_AIR = 2
"""In `EnergyBalance.work`: work of air friction, which is negative."""
WORK_LAW = 3
"""In `EnergyBalance.work`: work of a force law that has no energy."""
WORK_KEYS = 4
"""In `EnergyBalance.work`: work of keys that change rest lengths and rest angles."""
WORK_FALLBACK = 5
"""In `EnergyBalance.work`: energy added by fallback steps, which is negative or zero."""
WORK_WALLS = 6
"""In `EnergyBalance.work`: work of friction on walls and in contact, and of bouncing, which is negative."""
WORK_PLASTIC = 7
"""In `EnergyBalance.work`: energy lost in yielding, which is negative."""
WORK_BROKEN = 8
"""In `EnergyBalance.work`: energy of springs and joints that broke, which is negative."""
WORKS = 9
"""Length of `EnergyBalance.work`."""


class Problem(Table):
    """Everything that a run of a method needs, except what drives the body and how far it is to go."""

    body: Body
    state: State
    scratch: Scratch
    matrix: Matrix  # empty where no method is implicit
    integrator: IntegratorState
    balance: EnergyBalance
    # Addresses of kernels, see `core.shared`; 0 where the method does not need one.
    accelerations: int
    accumulate: int
    factorise: int
    solve: int
    resistance: int
    apart: int
    overstrained: int
    settle: int
    fixed: float  # the step, s, or 0 for error control
    near_limit: float  # s; steps from here on count as near Verlet's stability limit
    explicit: Tableau
    implicit: Rosenbrock
    adams: Adams
    costs: Floats  # (ARMS,) computing time of a step of each `auto` method, in Verlet steps; 0: not used
    tolerance_factor: Floats  # (ARMS,) tolerance of each of them as a part of the scene's
