"""The tables that the kernels read and write.

Every array is C-contiguous and contains float64 or int64, so that a kernel is compiled for one type only.

The masses are at indices 1 to n; the indices of an array are called slots. Slot 0 is padding, so that the
chain's loops can look back without a test. The slots after n are padding up to a multiple of eight, so that
vectorised loops have no scalar remainder, which for twelve masses would be most of the work. Springs are
padded in the same way. A padding mass never moves, and a padding spring exerts no force.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from .table import Floats, Indices, Record, Rows, Table

if TYPE_CHECKING:
    Environment = Any  # made from the list of terms, see `forces.environment`


class Links(Table):
    """Read-only. Connections of pairs of ends: springs connect masses, joints connect springs.

    Pairs first to loose - 1 are in runs: number first + i of a run connects the ends a + i and b + i. See
    `forces.runs` for the rows to which they write, and why the others have slots.
    """

    first: Indices  # (R,) first pair of each run
    a: Indices  # (R,) its ends
    b: Indices  # (R,)
    count: Indices  # (R,) number of pairs
    row: Indices  # (R,) where in the rows the run begins
    at_a: Indices  # (D,) where in them end 0 is as an end a, one for each row; an even number
    at_b: Indices  # (D,) and as an end b
    room: int  # length of all rows together
    loose: int  # first pair that is in no run
    behind: int  # one past the last pair
    ends: int  # number of ends
    # Of the pairs in no run, each end has one in each layer as an end b and one as an end a, or the number of
    # a pair without effect. The common case is thus a gather without branches. The others are in a list.
    layers: int
    into: Indices  # (layers ends,)
    out_of: Indices  # (layers ends,)
    rest: Indices  # for each pair in the list: its number,
    rest_end: Indices  # the end that it acts on,
    rest_sign: Floats  # and 1 for an end b, -1 for an end a


class Limits(Table):
    """Read-only. All arrays are empty where nothing yields or breaks."""

    present: bool  # anything yields or breaks
    breaking: Floats  # (S,) B, kg px/s²; infinite for a spring that never breaks
    yielding: Floats  # (S,) Y before any hardening, kg px/s²; or infinite
    hardening: Floats  # (S,) H, kg/s²
    bending: Floats  # (J,) T, kg px²/s²; or infinite


class Muscles(Table):
    """Read-only. The S springs and J joints that muscles actuate."""

    present: bool  # there are any
    period: float  # of the beat, s; 0 where it is not periodic
    spring: Indices  # (S,) each spring
    stretch: Rows  # (S, 5) a `Row` for each
    joint: Indices  # (J,) each joint
    turn: Rows  # (J, 5) a `Row` for each


class Body(Table):
    """Read-only: the connections and constants of the springs. S springs, J joints, n masses.

    In a chain, spring s connects the masses in slots s + 1 and s + 2, and joint j the springs j and j + 1. A
    ring has the same numbering, with slot n + 1 standing for the first mass and spring n for the first
    spring.
    """

    masses: int
    springs: int
    joints: int
    damped: bool  # any linear spring has damping
    joint_damped: bool  # any angular spring has damping
    chain: bool  # the springs run head to tail through all masses, in order
    ring: bool  # the same, and the last one leads back to the first mass
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
    joint_rest: Floats  # (J,) degrees, before the shift
    angular_stiffness: Floats  # stiffness of joint j at index j + 1, kg/s²; at index 0 a ring's last, or zero
    torque_damping: Floats  # damping of joint j at index j + 1, kg/s
    hinged: int  # number of springs attached to joints, which precede all others
    held: Links  # these springs, between slots of masses
    free: Links  # the others
    bends: Links  # joints, between springs
    environment: Environment  # everything else that acts on the masses
    limits: Limits  # strengths of springs and joints
    muscles: Muscles  # what changes rest lengths and rest angles by itself

    @property
    def joint_stiffness(self) -> Floats:
        """The (J,) view of the joints' part of `angular_stiffness`; for Python only."""
        return self.angular_stiffness[1 : self.joints + 1]


class State(Table):
    """Mutable: positions and velocities, what keys and dragging change during a motion, and its memory.

    Vectors are flat: x of every slot, then y of every slot. There is no mass in the first slot of either
    half, nor in the last `SPARE` ones. Loops over a flat vector skip these slots at its two ends, so that
    they start where loops over masses start: one loop then loads the same vectors that another one stored,
    which avoids stalls.
    """

    q: Floats  # (2 slots) positions, px
    v: Floats  # (2 slots) velocities, px/s
    controls: Floats  # rest_length_scale, rest_angle_shift (degrees)
    rest_tension: Floats  # (S padded + 1) stiffness * current rest length, kg px/s²
    torque_cos: (
        Floats  # stiffness * cos(current rest angle), kg/s², of joint j at index j + 1; index 0 as above
    )
    torque_sin: Floats  # the same with the sine
    torque_rest: Floats  # current rest angle, radians, of joint j at index j + 1
    # What acts on each mass besides the springs; all zero for a held mass.
    inverse_mass: Floats  # (slots,) 1/kg
    air: Floats  # (slots,) friction of still air under the tutorial's law / mass, 1/px
    gx: Floats  # (slots,) acceleration due to gravity and the constant force on each mass, px/s²
    gy: Floats
    clock: Floats  # (1,) time of the gusts, of belts and of the muscles, s
    # (5,) 1 while Right is held, -1 while Left is, else 0; the same of Up and Down; and from what their
    # efforts follow, see `engine.numerics.waves`.
    steer: Floats
    # Empty where nothing yields or breaks.
    set_length: Floats  # (S,) permanent changes of rest lengths, px
    set_angle: Floats  # (J,) permanent changes of rest angles, degrees
    hardened: Floats  # (S,) increases of yield forces, kg px/s²
    # `rest_tension` and `torque_rest` (here of joint j at index j) without yielding in the current step.
    trial_tension: Floats  # (S,) kg px/s²
    trial_angle: Floats  # (J,) radians
    broken: Floats  # (S,) 1 for a broken spring, else 0
    # For derivatives, see `forces.plasticity`: 1 where a spring, or after them a joint, is yielding, else -1;
    # and at the end 1 where it does so whatever the force is, else 0.
    yields: Floats  # (S + J + 1,)
    # Friction of still air under other laws / mass, 1/px or 1/s, zero for a held mass; empty without.
    drag: Floats  # (slots,)
    # Tangential springs as they were at the end of the last step, see `forces.touch.friction_history`; empty
    # where there are none. Those between W walls and masses:
    wall_stretch: Rows  # (W, slots) px
    wall_place: (
        Rows  # (W, slots) position of the mass along the wall, px; `forces.touch.walls.NOWHERE` without one
    )
    wall_time: Floats  # (1,) when they were noted, s; empty where no wall with them runs
    wall_slides: Rows  # (W, slots) 1 where it slides, else 0; empty where no wall has static friction
    # Those of contact, by the touched spring, then by the touching mass:
    contact_start: Indices  # (S + 1,) where those of each spring start; after the last one is unused space
    contact_mass: Indices  # slots of the masses
    contact_stretch: Rows  # (n, 6) stretch, px, and `forces.touch.pairs.place_of`

    @property
    def slots(self) -> int:
        """The number of slots, padding included."""
        return self.q.size // 2

    @property
    def x(self) -> Floats:
        """The (slots,) view of the first half of `q`; for Python only, like the three below."""
        return self.q[: self.slots]

    @property
    def y(self) -> Floats:
        """The (slots,) view of the second half of `q`."""
        return self.q[self.slots :]

    @property
    def vx(self) -> Floats:
        """The (slots,) view of the first half of `v`."""
        return self.v[: self.slots]

    @property
    def vy(self) -> Floats:
        """The (slots,) view of the second half of `v`."""
        return self.v[self.slots :]


class Scratch(Table):
    """Scratch arrays, so that no step allocates memory."""

    lx: Floats  # (S padded) vectors of the springs, px
    ly: Floats
    dvx: Floats  # their rates, px/s, where needed
    dvy: Floats
    inverse: Floats  # 1 / length, 1/px; `chain_accelerations` stores only that of the shortest, at index 0
    held_x: Floats  # (S padded) force of the joints on the b end of each attached spring, kg px/s²
    held_y: Floats
    tx: Floats  # force on the b end of each spring that is in no run, kg px/s²
    ty: Floats
    fx: Floats  # (slots,) force of springs and joints on each mass, kg px/s²
    fy: Floats
    # Contents of the rows of `Body.held`, `free` and `bends`, and forces of joints in no run, kg px/s²:
    held_rows: Rows  # (2, room) x and y on b ends
    free_rows: Rows
    joint_rows: Rows  # (4, room) x and y on the b end of each spring a, then on that of each spring b
    joint_alone: Rows  # (4, J + 1) of joint j; the last one exerts nothing
    # Where the next `contact_mass` and `contact_stretch` of a state are made.
    next_mass: Indices
    next_stretch: Rows
    # Touching pairs, whose forces are computed together, see `forces.touch.batch`; empty without contact.
    batch_mass: Indices  # (B,) slots of the mass and of the ends of the spring
    batch_a: Indices
    batch_b: Indices
    batch_force: Rows  # (5, B) F.x, F.y, G.x, G.y, kg px/s²; t
    batch_reach: Floats  # (B,) px, at which they touch
    # Tangential springs (8, B): current stretch, px; a row of `State.contact_stretch`; 1 if there is one,
    # else 0.
    batch_stretch: Rows


CONTROL_SCALE = 0
"""Index in `State.controls` of the factor of all rest lengths."""
CONTROL_SHIFT = 1
"""Index in `State.controls` of the angle added to all rest angles, degrees."""
SCALE_MIN = 0.01
"""The smallest factor of rest lengths."""
SCALE_MAX = 100.0
"""The largest factor of rest lengths."""

SHORTEST_SQUARED = 1e-300
"""Smallest softening, px². It changes no length but zero: a spring of zero length then exerts no force
instead of making everything NaN."""


def padded(count: int) -> int:
    """Return the count, rounded up to a multiple of eight."""
    return -(-count // 8) * 8


SPARE = 7
"""Number of slots at the end of a flat vector that are always padding; see `State`."""


class Matrix(Table):
    """The factors of the matrix of an implicit step, and their pattern."""

    blocks: Floats  # the factors; see `solve.linear.sparse`
    # A spanning forest: an order of the masses in which every mass comes after its parent.
    walk: Indices  # (n,) slots of the masses in this order
    parent: Indices  # (slots,) slot of the parent; 0 for a held mass or the first one in its part of the body
    # Rows are numbered in the order of elimination.
    order: Indices  # (n,) slot of the mass that row i belongs to
    row_start: Indices  # (n + 1,) first block of each row
    column: Indices  # of each block, ascending in a row
    diagonal: Indices  # (n,) block on the diagonal of each row
    slot: Indices  # (n,) scratch: block of the current row in each column
    spring_target: Indices  # (4 S,) blocks that a spring adds to, at rows and columns bb, ba, ab, aa
    joint_target: Indices  # (16 J,) blocks that a joint adds to, the same for each pair of its springs
    # For each loop in turn, blocks in the row of each of its masses: in a small loop with all its masses, in
    # its order; in another one with the previous and next masses.
    loop_target: Indices
    # For the products of gradients of the B fillings that are not small, see `solve.linear.implicit`.
    bordered: Indices  # (B,) numbers of these fillings
    low_rank: Rows  # (2 B, 2 slots)
    corrections: Rows  # (B + 1, B)
    # For contact, see `solve.linear.krylov`; empty where there is none.
    of_mass: Indices  # (slots,) block of each mass on the diagonal
    coupling: Floats  # (3,), see the COUPLING_ constants in `forces.touch.contact`
    coupling_state: Rows  # (3, 2 slots) positions, velocities and inverse masses of the last factors
    krylov: Rows  # (K + 3, 2 slots) basis of a Krylov space, and scratch
    hessenberg: Rows  # (K + 4, K + 1) scratch of GMRES


class PrescribedMotion(Table):
    """How held masses move, and the effect of held keys, during a call."""

    moving: bool  # any mass is listed here, a key is held, or anything changes with time
    pressed: bool  # a key is held
    timed: bool  # there are muscles, or a force changes with time by itself, see `forces.term.Term`
    start: float  # time at the start of the call, s
    duration: float  # time until masses guided straight reach their targets, s; infinite if there are none
    mass: Indices  # (M,) slots of the masses
    rows: Rows  # (M, 14), a `LeadParameters` each
    scale: float  # of rest lengths at the start
    shift: float  # of rest angles at the start, degrees
    growth: float  # rate of the logarithm of the scale of rest lengths, 1/s
    turn: float  # rate of the rest angles, degrees/s


class LeadParameters(NamedTuple):
    """The guided motion of a held mass."""

    x: float  # px, its position at the start, without its circle
    y: float
    vx: float  # px/s, at the start
    vy: float
    ax: float  # px/s², at the start
    ay: float
    jx: float  # px/s³, constant
    jy: float
    hand: float  # 0 where the damping treats a dragged mass as at rest, 1 elsewhere
    radius: float  # px, of its circle; 0 where there is none
    omega: float  # angular frequency, 1/s
    ramp: float  # time constant, s
    along_x: float  # unit vector of the rail to which its circle is projected; (0, 0) where there is none
    along_y: float


class Progress(Record):
    """The progress of a run, and its counters."""

    time: float  # simulated time, s
    origin: float  # time at which the run began, s
    step: float  # next step that the current method would try, s; 0 where unknown
    farthest: float  # largest coordinate of a good state, px
    fastest: float  # largest velocity component of a good state, px/s
    current: bool  # the accelerations belong to the current state
    since: int  # steps since these were recomputed after something other than a step changed the motion
    status: int  # GOOD or the kind of failure, see `solve.steps.guard`
    mass: int  # slot of the mass where the failure was found
    steps: int  # number of accepted steps
    rejected: int
    forces: int  # evaluations of the accelerations
    matrices: int  # factorisations
    fallbacks: int  # fallback steps


class PhasePoint(Table):
    """A point of the motion, the start or end of a step; vectors as in `State`."""

    q: Floats  # (2 slots) positions, px
    v: Floats  # (2 slots) velocities, px/s
    a: Floats  # (2 slots) accelerations, px/s²; meaningless for methods that do not keep them


class StepAttempt(Record):
    """An attempted step, see `solve.steps.loop`."""

    h: float  # its length, s; of each, if several are done at once
    start: float  # the time at which it starts, s; of the last one
    end: float  # the time at which it ends, s
    max_position: float  # largest coordinate at its end, px; infinite where unknown, as are the next two
    max_speed: float  # its largest velocity component, px/s
    max_move: float  # largest change of a coordinate, px, if the last forces are those at its end
    event_fraction: float  # fraction of it to try instead, which ends at an event in it; 1 without an event
    failures: int  # number of steps rejected since the last good one
    number: int  # number of fixed steps before it
    max_steps: int  # number of steps that may be done at once
    remaining: float  # time left until the end of the run, s; unused with a fixed step
    count: int  # number of steps done


class VerletState(Record):
    """The memory of velocity Verlet from step to step."""

    cap: float  # the largest step that seems to be stable, s
    limited: int  # number of steps in this call that were limited by stability
    row: int  # the row with the accelerations that predict velocities
    failed: float  # the step that gave that limit, s
    sure: bool  # the previous failure gave about the same limit
    since: int  # number of steps for which the limit has been kept
    held: bool  # the limit, not the error, determines the next step
    reach: float  # how far each mass may move before a spring could have turned too far, px; 0: unknown
    speed: float  # the largest velocity component, px/s


class AlphaState(Record):
    """The memory of generalized-alpha from step to step."""

    rows: Rows  # (4, 2 slots); no rows where the method is not used
    last: float  # the last step included in `rows`, s; 0 where there is none
    older: float  # the step before it, s; 0 where there is none
    solvable: float  # the largest step for which Newton's method seems to converge, s; 0 where unknown
    steps: int  # number of steps since it took over
    contraction: float  # size of Newton's second update by the square of the first, 1/px; 0: unknown
    next_cube: float  # product of three time spans of the attempted step, s³
    cube: float  # that of the last step, to which its prediction error is proportional; 0: unknown


class AdamsState(Record):
    """The memory of Adams methods from step to step."""

    past: Rows  # (PAST, 2 slots) past accelerations; no rows where the method is not used
    time: float  # of the latest row of `past`, s
    spacing: float  # the time between two rows, s
    degree: int  # of the polynomial
    target_degree: int  # the degree to which it is being raised
    head: int  # the row with the latest acceleration
    known: int  # number of rows, from the latest back, at the current spacing
    since: int  # number of steps since the step size changed
    kinks: bool  # the kinks of air friction matter, see `solve.steps.kinks`
    turns: bool  # a velocity changes its sign in the attempted step, and kinks matter


VERLET, ROSENBROCK, ALPHA, ADAMS = 0, 1, 2, 3
"""The methods that `auto` chooses from."""
CHOICES = 4
"""Number of these methods."""


class AutoState(Record):
    """What `auto` has learnt about its methods."""

    step: Floats  # (CHOICES,) the next step of each, s
    pace: Floats  # (CHOICES,) simulated s gained by each in the computing time of a Verlet step; < 0: unknown
    work: float  # computing time since another method was last tried, in Verlet steps
    last: int  # the method that was used in the last turn
    asked: int  # number of times that another method was tried
    turn: int  # the method whose turn it is, or -1
    began: float  # time at which this turn began, s
    tried: int  # number of steps attempted by then
    made: int  # number of matrices factorised by then
    limited: float  # fraction of steps in Verlet's last turn that were limited by stability


class IntegratorState(Table):
    """Mutable: the memory of an integrator from step to step, and its scratch; vectors as in `State`."""

    a: Floats  # accelerations of the state, px/s²
    old: PhasePoint  # the state and these accelerations
    new: PhasePoint  # storage for the end of a step
    rows: Rows  # (R, 2 slots) scratch
    run: Progress
    trial: StepAttempt
    verlet: VerletState
    alpha: AlphaState
    adams: AdamsState
    auto: AutoState


class Tableau(Table):
    """An explicit Runge-Kutta method for q'' = f(t, q, q').

    Stage i is at q + c_i h v + h² sum abar_ij k_j and v + h sum a_ij k_j.
    """

    stages: int  # evaluations per step; the first of the next step is that at the end of this one
    c: Floats  # (stages + 1,) the last is the end of the step
    a: Rows  # (stages + 1, stages + 1); the last row is b
    abar: Rows  # a a


class Rosenbrock(Table):
    """A Rosenbrock method, in the form where each stage takes one solve (Hairer & Wanner II, IV.7).

    Rows are padded with zeros to a multiple of four stages.
    """

    stages: int
    order: int  # power of the step to which the error estimate is proportional
    gamma: float
    c: Floats  # (stages + 1,) times of the stages; the last is the end of the step
    time_weights: Floats  # (stages,) weights of the derivative with respect to time
    a: Rows  # (stages + 1, padded); the last row gives the end of the step
    coupling: Rows  # (stages + 1, padded); the last row belongs to no stage and is zero
    error: Floats  # (padded) weights of the error estimate


PAST = 8
"""Number of accelerations that Adams methods keep, one more than the highest degree; a power of two."""


class Adams(Table):
    """Adams methods for q'' = f(t, q, q'), by the degree k of the polynomial through past accelerations.

    Row k of each table is for degree k, and column i has the weight of the acceleration i steps back.
    """

    degree: int  # the highest in use
    position: Rows  # (PAST, PAST) weights in the predicted position
    velocity: Rows  # in the predicted velocity
    ahead: Rows  # in the predicted acceleration
    barycentric: Rows  # in an interpolated acceleration, without the factors of the time distances
    to_position: Floats  # (PAST,) weight of the error of the predicted acceleration in the corrected position
    to_velocity: Floats  # in the corrected velocity
    error: Floats  # in the error estimate
    back: Rows  # (PAST², PAST) weights in the velocity gained in the last r steps, in row k PAST + r


class Work(Record):
    """Changes of the energy since the balance was opened, by cause, kg px²/s²."""

    anchors: float  # by moved anchors
    damping: float  # by damping; negative
    air: float  # by air friction and a medium; negative
    law: float  # by a force law without an energy
    keys: float  # by keys that change rest lengths and rest angles, and forces that keys work
    muscles: float  # by muscles, which change them too
    motors: float  # by motors
    fallbacks: float  # by fallback steps; negative or zero
    walls: float  # by friction on walls, the ground and in contact, and by bouncing; negative
    plastic: float  # by yielding; negative
    broken: float  # of springs and joints that broke; negative

    @property
    def total(self) -> float:
        """The sum of all changes; for Python only."""
        return sum(getattr(self, name) for name in self.numbers)


class EnergyBalance(Table):
    """The changes of the energy since the balance was opened, and scratch for computing them."""

    active: bool
    work: Work
    rows: Rows  # (k, 2 slots) scratch, see `solve.balance.work`
    dampers: Rows  # (DAMPER_ROWS, springs + joints) scratch, see `solve.balance.dissipation`
    # (W + L, 2 slots) scratch for W walls and L laws of resistance; empty for first-order methods.
    # First half: 1 for each mass that friction there stops within a fraction of the step, see
    # `mark_stiff_friction`. Second half: the power of all other forces on it, kg px²/s³.
    quick: Rows


class Problem(Table):
    """Everything that a run of a method needs, except how the body is driven and how far it is to go."""

    body: Body
    state: State
    scratch: Scratch
    matrix: Matrix  # empty where no method is implicit
    integrator: IntegratorState
    balance: EnergyBalance
    # Addresses of the kernels of `engine.calls.INDIRECT_CALLS`; 0 for one that the run does not need.
    accelerations: int  # with yielding, if anything yields
    accumulate_work: int
    factorise_matrix: int
    solve_matrix: int
    add_damping_product: int
    no_tunnelling: int
    event_fraction: int
    kink_fraction: int
    slip_fraction: int
    update_friction_history: int
    commit_plasticity: int
    fixed: float  # the step, s, or 0 for error control
    near_limit: float  # s; steps from here on count as near the stability limit, for an undamped body
    near_damped_limit: float  # s; the same, with damping
    explicit: Tableau
    implicit: Rosenbrock
    adams: Adams
    costs: Floats  # (CHOICES,) computing time of a step of each `auto` method, in Verlet steps; 0: not used
    tolerance_factor: Floats  # (CHOICES,) tolerance of each of them as a part of the scene's
