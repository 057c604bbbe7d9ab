"""Pairs of a mass and a linear spring, or of two solid masses, that touch, and their forces.

Let p = (1 - t) a + t b be the point of a spring that is nearest to a mass, e = b - a the spring's vector, r
the distance, n the unit vector from p to the mass, and tau = (-n.y, n.x) the one across. Where r is less than
the distance of contact D, the mass is pushed along n with N(d, s), where d = D - r is the depth and s the
speed outwards, and the masses a and b get the opposite force in the shares 1 - t and t.

With the velocity V of the mass relative to p, the speed of sliding is that relative to the spring, which
turns: u = tau . V - L . e', with the moment arm L = r (-e.y, e.x) / |e|², px. It is zero where everything
turns like a rigid body. Friction T(N, u), kg px/s², acts along the gradient of u by the velocities, which
takes energy whenever anything slides, and has neither a sum nor a torque: besides F = N n - T tau on the mass
there is the couple G = T L on the spring. A spring shorter than the distance of contact could not bear that,
so friction decreases with the square of its length there.

A tangential spring (see `push`) is remembered for a pair as long as it touches, with where it was at the end
of the last step: its stretch, t, the direction of n relative to the spring, (n . e, e x n) / |e|, and |e| and
r. The way since then is the integral of u, with the means of |e| and r then and now: -|e| times the change of
t where n is to the left of the spring, |e| times it on the other side, and r times the sine of the angle by
which n has turned about an end. A mass that slides on to the next spring of a body begins anew there: it is
sliding anyway.

A solid mass is a spring of length zero whose ends are both that mass, which only solid masses of a higher
slot touch, without friction. The distance D of contact is the thickness of what is touched plus the size of
the mass that touches it: the thickness of a spring is the distance in the scene, that of a solid mass its
radius; the size of a mass is its radius if it is solid, else 0.

A pair's forces are w_i F + c_i G with the weights w = (1, t - 1, -t) and c = (0, -1, 1) of the mass, a and b.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ...engine.jit import FUSED, kernel
from ...engine.table import Floats, Indices, Table
from ...engine.tables import padded
from ...near import near_pairs, nearest_points
from ...scene.columns import column, is_set_in_any
from ...scene.surroundings import Contact
from ...scene.types import Scene
from ..term import Places
from .broad_phase import meeting, reach_of, segment
from .push import losses, push_and_friction, softened, tangential_spring

# Unless noted, doubling or halving one of these numbers fails no test.
_APART = 1.25
"""Distance, as a multiple of that of contact, below which a mass never touches a spring of its own body.
Halved, `test_a_body_does_not_touch_itself_as_it_is_built` fails."""
_MARGIN = 0.5
"""Margin of the list of pairs, as a fraction of the distance of contact or of a typical spring's length."""
_TYPICAL = 1.5
"""Mobility of a pair, in those of the median mass, by which it is damped: that in the middle of a spring."""
_ROOM = 64
"""Room in the list, in masses for each spring. If it does not suffice, finding pairs takes longer. Halved,
`test_the_list_has_all_pairs_that_are_near` fails."""
TANGENTIAL_ROOM = 8
"""Room for tangential springs, for each spring. A place takes 56 bytes; pairs that find none do without.
Halved, `test_many_pairs_are_pushed_like_a_few` fails."""


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Contacts(Table):
    """S springs, G things that are touched, B buckets: first the springs, then the solid masses. The arrays
    from `number` on change while a body moves; the others are read-only.

    The pairs that may touch are listed spring by spring, with the masses of each in ascending order. So sums
    over them do not depend, even by rounding, on where the masses were when the list was made. The list is no
    part of the state: it only saves finding again what follows from positions.
    """

    changing = frozenset(
        ("number", "crowded", "at", "start", "member", "bucket_start", "bucket", "column", "row")
    )

    present: bool
    first: int  # the first that is touched: 0, or S where only solid masses are
    end_a: Indices  # (G,) slots of the ends of each; twice that of a solid mass
    end_b: Indices
    thickness: Floats  # (G,) px
    size: Floats  # (slots,) of each mass, px
    sized: bool  # any mass is solid
    reach: float  # the largest and the smallest distance at which anything touches, px
    least: float
    distance: float  # px, of springs
    stiffness: float  # kg/(px s²)
    friction: float  # coefficient
    slip_speed: float  # px/s
    damping: float  # what is lost, see `push.Lost`: s/px
    hysteresis: float
    calm: float  # px^(-1/2)/s
    tangential: float  # of tangential springs: their stiffness, kg/s²
    resisting: float  # and their damping, kg/s
    margin: float  # px, by which pairs that are listed may be farther apart than `distance`
    cell: float  # px, width of a cell of the grid
    apart_start: Indices  # (G + 1,) where the masses of each start in `apart`
    apart: Indices  # slots of the masses that never touch it, ascending
    broken: Floats  # (S,) 1 for a spring that is broken and touches nothing any more, else 0
    # The list
    number: Floats  # (1,) the margin with which it was made, px; negative if there is none
    crowded: Indices  # (1,) 1 if it has no room for all pairs: those of a spring are then found when needed
    at: Floats  # (2 slots) positions for which it was made, px
    start: Indices  # (G + 1,) where the masses of each start in `member`
    member: Indices  # slots of masses
    # A grid of square cells in a hash table
    bucket_start: Indices  # (B + 1,) where the masses of each bucket start in `bucket`; B is a power of two
    bucket: Indices  # (n,) slots of masses
    column: Indices  # (slots,) the cell of each mass
    row: Indices


NO_CONTACTS = Contacts.empty()


def has_contact(scene: Scene) -> bool:
    """Whether masses of a scene may touch its springs, or each other."""
    return touches_springs(scene) or is_set_in_any(scene.masses, "solid")


def touches_springs(scene: Scene) -> bool:
    """Whether masses of a scene may touch its springs."""
    return scene.contact is not None and scene.contact.distance > 0.0 and bool(scene.linear_springs)


def sizes_of(scene: Scene, places: Places) -> Floats:
    """(slots,) px, the radius of each solid mass, 0 of all others."""
    size = np.zeros(places.slots)
    if is_set_in_any(scene.masses, "solid"):
        size[places.mass_index] = [mass.radius if mass.solid else 0.0 for mass in scene.masses]
    return size


def new_contacts(scene: Scene, places: Places) -> Contacts:
    """The table of a valid scene.

    A mass never touches the springs that it is an end of. Nor does it touch what belongs to its own body and
    is, as the scene's masses say (and not its pose), nearer than 1.25 times the distance of contact. So
    a body is at rest as it is built, however fine its mesh is. Parts of a scene that no springs connect are
    different bodies, which touch from the start.
    """
    mass_index, slots, n = places.mass_index, places.slots, len(scene.masses)
    if not has_contact(scene):
        return NO_CONTACTS
    contact, on_springs = scene.contact or Contact(distance=0.0), touches_springs(scene)
    size, distance = sizes_of(scene, places), contact.distance if on_springs else 0.0
    solid = np.flatnonzero(size)
    ends = np.concatenate((places.ends, np.stack((solid, solid), 1)))
    springs, touched = len(places.ends), len(ends)
    thickness = np.concatenate((np.full(springs, distance), size[solid]))
    first = 0 if on_springs else springs
    reach = float(thickness[first:].max() + size.max())
    x = np.zeros(slots, complex)
    x[mass_index] = [complex(*mass.position) for mass in scene.masses]
    mobility = _TYPICAL / float(np.median(column(scene.masses, "mass")))
    lost = losses(contact.restitution, contact.bounciness, contact.stiffness, mobility)
    damping, hysteresis, calm = lost
    tangential, resisting = tangential_spring(contact.tangential_stiffness if on_springs else 0.0, mobility)
    margin = max(_MARGIN * max(reach, float(np.median(np.abs(x[ends[:, 1]] - x[ends[:, 0]])))), 1e-3)
    pairs = _apart(x, np.sort(mass_index), ends, _APART * thickness, _APART * size)
    return Contacts(
        present=True,
        first=first,
        end_a=np.ascontiguousarray(ends[:, 0]),
        end_b=np.ascontiguousarray(ends[:, 1]),
        thickness=thickness,
        size=size,
        sized=bool(solid.size),
        reach=reach,
        least=float(thickness[first:].min() + (0.0 if on_springs else size[solid].min())),
        distance=distance,
        stiffness=contact.stiffness,
        friction=contact.friction if on_springs else 0.0,
        slip_speed=contact.slip_speed,
        damping=damping,
        hysteresis=hysteresis,
        calm=calm,
        tangential=tangential,
        resisting=resisting,
        margin=margin,
        cell=2.0 * (reach + margin),
        apart_start=np.searchsorted(pairs[0], np.arange(touched + 1)),
        apart=np.ascontiguousarray(pairs[1]),
        broken=np.zeros(springs),
        number=np.full(1, -1.0),
        crowded=np.zeros(1, np.int64),
        at=np.zeros(2 * slots),
        start=np.zeros(touched + 1, np.int64),
        member=np.zeros(_ROOM * (touched - first) + n, np.int64),
        bucket_start=np.zeros(2 ** (padded(2 * n).bit_length()) + 1, np.int64),
        bucket=np.zeros(n, np.int64),
        column=np.zeros(slots, np.int64),
        row=np.zeros(slots, np.int64),
    )


def _apart(x: np.ndarray, masses: Indices, ends: Indices, thickness: Floats, size: Floats) -> Indices:
    """(2, k) what is touched, and the masses of its own body that never touch it, in order.

    That is where they are nearer than the sum of a `thickness`, (G,), and a `size`, (slots,).
    """
    spring, mass = near_pairs(x, masses, ends, float(thickness.max() + size.max()))
    body = _bodies(ends, x.size)
    own = body[mass] == body[ends[spring, 0]]
    spring, mass = spring[own], mass[own]
    a, b = x[ends[spring, 0]], x[ends[spring, 1]]
    gap = abs(x[mass] - a - nearest_points(x[mass], a, b) * (b - a))
    near = gap <= thickness[spring] + size[mass]
    return np.stack((spring[near], mass[near]))  # the ends of each spring are among them


def _bodies(ends: Indices, slots: int) -> Indices:
    """(slots,) a number of the body that each mass belongs to."""
    root = list(range(slots))

    def find(mass: int) -> int:
        while root[mass] != mass:
            root[mass] = root[root[mass]]
            mass = root[mass]
        return mass

    for a, b in ends.tolist():
        root[find(a)] = find(b)
    return np.array([find(mass) for mass in range(slots)], np.int64)


# ------------------------------------------------------------------------- a pair, and its forces
class Pair(NamedTuple):
    """A mass that touches a spring, or another mass; the symbols are those above."""

    m: int  # slots of the mass and of the ends of the spring
    a: int
    b: int
    t: float
    r: float  # px
    reach: float  # D, px
    nx: float  # n
    ny: float
    ex: float  # e, px
    ey: float
    per_square: float  # 1 / |e|², 1/px²
    vx: float  # V, px/s
    vy: float
    wx: float  # e', px/s
    wy: float
    lx: float  # L, px
    ly: float
    speed: float  # s, outwards, px/s
    along: float  # u, px/s
    push: float  # N, kg px/s²
    elastic: float  # the part of N that does not depend on the speed
    friction: float  # T, kg px/s²
    gripped: bool  # whether there is a tangential spring
    stretch: float  # of it, px
    tangential: float  # its stiffness, kg/s²


@kernel(forceinline=True, fastmath=FUSED)
def pair_at(body, state, w, s, m, q, v, reach=0.0):
    """(whether mass m is nearer to what is touched as number s than the distance of contact and `reach` px
    more, the pair that they are, of no meaning where it is not).

    Of the state, only tangential springs matter here. `w`: (slots,) inverse masses, 1/kg, which matter for
    explicit methods with a fixed step only.
    """
    contact, h, slots = body.environment.contact, body.environment.step, q.size // 2
    a, b, distance = contact.end_a[s], contact.end_b[s], reach_of(contact, s, m)
    line = segment(q[:slots], q[slots:], a, b)
    t, dx, dy = meeting(line, q[m], q[slots + m])
    _, _, ex, ey, per_square = line
    square = dx * dx + dy * dy
    if not square < (distance + reach) * (distance + reach):
        return False, Pair(
            m, a, b, t, 0.0, distance, 0.0, 0.0, ex, ey, per_square, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
            0.0, 0.0, 0.0, False, 0.0, 0.0,
        )  # fmt: skip
    r = math.sqrt(square)
    per_r = 1.0 / (r + 1e-300)
    nx, ny, lx, ly = dx * per_r, dy * per_r, -r * ey * per_square, r * ex * per_square
    wx, wy = v[b] - v[a], v[slots + b] - v[slots + a]
    vx, vy = v[m] - v[a] - t * wx, v[slots + m] - v[slots + a] - t * wy
    speed, along = vx * nx + vy * ny, vy * nx - vx * ny - (wx * lx + wy * ly)
    mobility, mobility_along = 0.0, 0.0
    if h > 0.0:
        mobility, mobility_along = mobilities((w[m], w[a], w[b]), t, (nx, ny), (lx, ly))
    gripped, stretch, tangential = False, 0.0, 0.0
    if contact.tangential > 0.0 and s < body.springs:
        gripped, stretch = _stretch_of(state, s, m, (t, r, nx, ny, ex, ey, per_square))
        tangential, _ = softened((contact.tangential, contact.resisting), h, mobility_along)
    push, friction, elastic = push_and_friction(
        contact.stiffness, lost_in(contact),
        friction_on(contact, ex * ex + ey * ey), contact.slip_speed, (contact.tangential, contact.resisting),
        h, mobility, mobility_along, max(distance - r, 0.0), speed, along, stretch,
    )  # fmt: skip
    return True, Pair(
        m, a, b, t, r, distance, nx, ny, ex, ey, per_square, vx, vy, wx, wy, lx, ly, speed, along,
        push, elastic, friction, gripped, stretch, tangential,
    )  # fmt: skip


@kernel(forceinline=True, fastmath=FUSED)
def mobilities(w, t, n, arm):
    """The accelerations of a pair by a push of one and by friction of one, 1/kg.

    Args:
        w: inverse masses of the mass, a and b, 1/kg.
        t, n, arm: t, n and L above.
    """
    (wm, wa, wb), (nx, ny), (lx, ly), u = w, n, arm, 1.0 - t
    along = (
        wm
        + wa * ((lx + u * ny) * (lx + u * ny) + (ly - u * nx) * (ly - u * nx))
        + wb * ((lx - t * ny) * (lx - t * ny) + (ly + t * nx) * (ly + t * nx))
    )
    return wm + u * u * wa + t * t * wb, along


@kernel(forceinline=True, fastmath=FUSED)
def _stretch_of(state, s, m, where):
    """(whether the pair of spring s and mass m has a tangential spring, its stretch, px).

    `where`: t, r, n.x, n.y, e.x, e.y, 1 / |e|² of the pair.
    """
    kept = state.contact_stretch
    for k in range(state.contact_start[s], state.contact_start[s + 1]):
        if state.contact_mass[k] == m:
            was = kept[k, 0], kept[k, 1], kept[k, 2], kept[k, 3], kept[k, 4], kept[k, 5]
            return True, stretch_since(was, where)
    return False, 0.0


@kernel(forceinline=True, fastmath=FUSED)
def stretch_since(was, where):
    """The stretch of a tangential spring, px; `was`: a row of `State.contact_stretch`, `where`: as above."""
    t, r, nx, ny, ex, ey, per_square = where
    stretch, was_t, was_ahead, was_beside, was_length, was_r = was
    length = math.sqrt(ex * ex + ey * ey)
    ahead, beside = (nx * ex + ny * ey) * (length * per_square), (ex * ny - ey * nx) * (length * per_square)
    turned = was_ahead * beside - was_beside * ahead
    mean = math.copysign(0.5 * (length + was_length), beside)
    return stretch + 0.5 * (r + was_r) * turned - mean * (t - was_t)


@kernel(forceinline=True, fastmath=FUSED)
def place_of(pair):
    """Where a pair touches: t, (n . e, e x n) / |e|, |e| and r."""
    ahead, beside = pair.nx * pair.ex + pair.ny * pair.ey, pair.ex * pair.ny - pair.ey * pair.nx
    length = math.sqrt(pair.ex * pair.ex + pair.ey * pair.ey)
    factor = length * pair.per_square
    return pair.t, ahead * factor, beside * factor, length, pair.r


@kernel(forceinline=True)
def lost_in(contact):
    """How the push of contact loses energy, see `push.Lost`."""
    return contact.damping, contact.hysteresis, contact.calm


@kernel(forceinline=True, fastmath=FUSED)
def friction_on(contact, square):
    """The coefficient of friction on a spring with the squared length `square`."""
    return friction_coefficient(contact.friction, contact.distance, square)


@kernel(forceinline=True, fastmath=FUSED)
def friction_coefficient(friction, distance, square):
    """The same for the coefficient `friction` of contact with the distance `distance`."""
    whole = distance * distance
    return friction * (square * (1.0 / whole)) if square < whole else friction


@kernel(forceinline=True, fastmath=FUSED)
def add_at_pair(pair, factors, force, out):
    """Add w_i F + c_i G, times a factor of each, at the mass and the ends of the spring.

    Args:
        pair: the pair.
        factors: of the mass, a and b.
        force: F.x, F.y, G.x, G.y.
        out: the two halves of a flat vector.
    """
    (m, a, b), t, (of_m, of_a, of_b), (x, y) = (pair.m, pair.a, pair.b), pair.t, factors, out
    fx, fy, gx, gy = force
    x[m] += of_m * fx
    y[m] += of_m * fy
    x[a] -= of_a * ((1.0 - t) * fx + gx)
    y[a] -= of_a * ((1.0 - t) * fy + gy)
    x[b] += of_b * (gx - t * fx)
    y[b] += of_b * (gy - t * fy)
