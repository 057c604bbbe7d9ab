"""What a medium and the ground do to springs: more across a spring than along it.

At an end of a spring, let t be its direction and n = (-t.y, t.x), and u the velocity of the end relative to
what resists. The force on the end is

    -p (s (u . n) n + l (u . t) t) / w.

In a viscous medium, p is half of the spring's length, s is the drag across, l that along, and w is 1:
resistive force theory (Gray & Hancock, "The propulsion of sea-urchin spermatozoa", 1955), which is linear in
the velocity, as the drag of slow flow is. Wind moves the medium. On the ground, seen from above, p is the
weight that rests on the end, s and l are the coefficients of friction sideways and forwards or backwards, and
w = sqrt(|u|² + slip²): dry friction like that of a snake (Hu et al., "The mechanics of slithering
locomotion", 2009), which has the size of friction however slow the sliding is, but for a slip. All springs of
a mass bear an equal share of its weight.

The derivative by the spring's vector L follows from dt = (dL - t (t . dL)) / |L| and dn = (-dt.y, dt.x);
those by the components of u along t and n are called `Slopes`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.numerics.blocks import add_block
from ..engine.numerics.vectors import from_to, length_of
from ..engine.table import Indices, Rows, Table
from ..engine.tables import Body, State
from ..scene.types import Scene
from .air import AirReference, wind_at, wind_gradient_at
from .term import Floats, Places, Term, Vectors, summed

_STIFF = 0.5
"""Step length in time constants of resistance from which the energy balance takes its work from displacements
and not from speeds. By experiment (test_the_balance_closes_at_any_resistance, RODAS at 0.1 px): with 4, `air`
is off by 60 to 100 %; with 0.5, by less than 1 %. Doubled or halved, no test fails."""


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Resistance(Table):
    """Read-only. A row for each spring in a medium, if there is one, then one for each on the ground."""

    rows: Rows  # (R, 7), a `ResistanceRow` each
    grounded: bool  # there is ground


class ResistanceRow(NamedTuple):
    """What resists a spring."""

    part: float  # of its length that counts for each end: 1/2 in a medium, 0 on the ground
    on_a: float  # kg px/s², the weight that rests on its a end; 0 in a medium
    on_b: float  # on its b end
    across: float  # kg/(px s) in a medium; on the ground, a coefficient of friction
    forward: float  # along it, from a to b
    backward: float
    slip: float  # px/s, see above; 0 in a medium


NO_RESISTANCE = Resistance(rows=np.zeros((0, len(ResistanceRow._fields))), grounded=False).read_only()


def is_resisted(scene: Scene) -> bool:
    """Whether a medium or the ground acts on a scene's springs."""
    return bool((scene.medium or scene.ground) and scene.linear_springs)


def new_resistance(scene: Scene, places: Places) -> Resistance:
    """The table of a valid scene."""
    medium, ground, ends, mass = scene.medium, scene.ground, places.ends, places.mass
    if not is_resisted(scene):
        return NO_RESISTANCE
    rows = NO_RESISTANCE.rows
    none = np.zeros(len(ends))
    if medium:
        row = ResistanceRow(0.5, 0.0, 0.0, medium.across, medium.along, medium.along, 0.0)
        rows = np.tile(row, (len(ends), 1))
    if ground:
        on_a, on_b = _shares(ends, none == 0.0, ground.gravity * mass).T
        row = ResistanceRow(
            0.0, 0.0, 0.0, ground.sideways, ground.forward, ground.backward, ground.slip_speed
        )
        below = np.tile(row, (len(ends), 1))
        below[:, 1], below[:, 2] = on_a, on_b
        rows = np.concatenate((rows, below))
    return Resistance(rows=rows, grounded=bool(ground))


def _shares(ends: Indices, whole: np.ndarray, weight: Floats) -> Floats:
    """(S, 2) the part of the weight of each mass that each spring's ends bear; none is on a broken spring."""
    count = np.bincount(ends[whole].ravel(), minlength=weight.size)
    return np.where(whole[:, None], (weight / np.maximum(count, 1))[ends], 0.0)


def of_whole_springs(resistance: Resistance, ends: Indices, broken: Floats) -> Resistance:
    """The table without what resists broken springs; others bear the weight that was on them.

    Args:
        resistance: the table.
        ends: (S, 2) the slots of the masses at the ends of each spring.
        broken: (S,) 1 for each broken spring.
    """
    rows, whole = resistance.rows.copy(), broken == 0.0
    for first in range(0, len(rows), max(len(ends), 1)):
        of_law = rows[first : first + len(ends)]
        weight = np.asarray(np.bincount(ends.ravel(), of_law[:, 1:3].ravel()), float)
        of_law[:, 1:3] = _shares(ends, whole, weight)
        of_law[~whole, 0] = 0.0
    return resistance.replaced(rows=rows)


def _bounds(body: Body) -> tuple[Floats, Floats]:
    """See `Term.bounds`."""
    rows, most = body.environment.resistance.rows, np.zeros(body.masses + 1)
    for first in range(0, len(rows), body.springs):
        part, on_a, on_b, *coefficients, slip = rows[first : first + body.springs].T
        slope = np.max(coefficients, 0) / np.where(slip > 0.0, slip, 1.0)
        for at, weight in ((body.spring_a, on_a), (body.spring_b, on_b)):
            np.add.at(most, at, slope * (part * body.rest_length[: body.springs] + weight))
    return np.zeros(body.masses), most[1:]


@kernel(forceinline=True)
def _row(body, k):
    """The k-th row."""
    row = body.environment.resistance.rows[k]
    return ResistanceRow(row[0], row[1], row[2], row[3], row[4], row[5], row[6])


# ------------------------------------------------------------------------- force
@kernel(forceinline=True, fastmath=FAST)
def _direction(body, q, s):
    """The direction of a spring, t.x and t.y, and its length, px."""
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    length = length_of(x, y, body.softening)
    return x / length, y / length, length


@kernel(forceinline=True, fastmath=FAST)
def _relative_velocity(body, state, row, q, v, m):
    """The velocity of mass m relative to what resists it, px/s."""
    slots = q.size // 2
    if row.slip == 0.0 and body.environment.air.moves:
        u, w = wind_at(body.environment.air, state.clock[0], q[m], q[slots + m])
        return v[m] - u, v[slots + m] - w
    return v[m], v[slots + m]


class Slopes(NamedTuple):
    """The derivatives of what resists an end, per pressure."""

    across_by_across: float  # by the velocity across the spring
    across_by_along: float  # by that along it
    along_by_across: float
    along_by_along: float


@kernel(forceinline=True, fastmath=FAST)
def _resisted(row, tx, ty, ux, uy):
    """What resists an end across and along its spring, per pressure."""
    along, beside = tx * ux + ty * uy, tx * uy - ty * ux
    per = 1.0 if row.slip == 0.0 else 1.0 / math.sqrt(ux * ux + uy * uy + row.slip * row.slip)
    return row.across * beside * per, (row.forward if along > 0.0 else row.backward) * along * per


@kernel(forceinline=True, fastmath=FAST)
def _slopes(row, tx, ty, ux, uy, definite):
    """The derivatives of `_resisted`; with `definite`, its secants, with which Newton's method converges, if
    slowly, however far beyond the slip a mass is."""
    along, beside = tx * ux + ty * uy, tx * uy - ty * ux
    ahead = row.forward if along > 0.0 else row.backward
    per = 1.0 if row.slip == 0.0 else 1.0 / math.sqrt(ux * ux + uy * uy + row.slip * row.slip)
    if definite or row.slip == 0.0:
        return Slopes(row.across * per, 0.0, 0.0, ahead * per)
    cubed = per * per * per
    mixed = along * beside * cubed
    return Slopes(
        row.across * (per - beside * beside * cubed),
        -row.across * mixed,
        -ahead * mixed,
        ahead * (per - along * along * cubed),
    )


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    rows = body.environment.resistance.rows
    for k in range(rows.shape[0]):
        row, s = _row(body, k), k % body.springs
        tx, ty, length = _direction(body, q, s)
        for end in range(2):
            m, p = _end(body, row, s, length, end)
            if state.inverse_mass[m] > 0.0:
                ux, uy = _relative_velocity(body, state, row, q, v, m)
                across, along = _resisted(row, tx, ty, ux, uy)
                scratch.fx[m] -= p * (along * tx - across * ty)
                scratch.fy[m] -= p * (along * ty + across * tx)


@kernel(forceinline=True, fastmath=FAST)
def _end(body, row, s, length, end):
    """The slot of an end of spring s, and p there; `end` is 0 for a, 1 for b."""
    if end == 0:
        return body.spring_a[s], row.part * length + row.on_a
    return body.spring_b[s], row.part * length + row.on_b


# ------------------------------------------------------------------------- the balance
@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    """On free masses, except those of `mark_stiff_resistance`; a medium that moves can do work on a body."""
    rows, quick = body.environment.resistance.rows, balance.quick
    for k in range(rows.shape[0]):
        row, s, power = _row(body, k), k % body.springs, 0.0
        tx, ty, length = _direction(body, q, s)
        for end in range(2):
            m, p = _end(body, row, s, length, end)
            if state.inverse_mass[m] > 0.0 and (quick.shape[0] == 0 or quick[_law(body, k), m] == 0.0):
                power += _power_at(body, state, row, q, v, m, p, tx, ty)
        if row.slip == 0.0:
            balance.work.air += part * power
        else:
            balance.work.walls += part * power


@kernel(forceinline=True, fastmath=FAST)
def _power_at(body, state, row, q, v, m, p, tx, ty):
    """The power, kg px²/s³, of what resists mass m at an end of a spring."""
    ux, uy = _relative_velocity(body, state, row, q, v, m)
    across, along = _resisted(row, tx, ty, ux, uy)
    vx, vy = v[m], v[q.size // 2 + m]
    return -p * (along * (tx * vx + ty * vy) + across * (tx * vy - ty * vx))


@kernel(forceinline=True)
def _law(body, k):
    """The row in `EnergyBalance.quick` of the law that the k-th row belongs to."""
    return body.environment.walls.rows.shape[0] + k // body.springs


@kernel(fastmath=FAST)
def mark_stiff_resistance(body, inverse_mass, q, h, quick):
    """Whether a medium or the ground would stop any mass within a fraction of a step of h seconds.

    There the speeds of a step, which are as accurate as the tolerance asks, do not tell what a strong
    resistance takes. Its work is the change of the kinetic energy less the work of all other forces, which
    depends on displacements. A mass that both stop is left to the ground.
    """
    rows, found = body.environment.resistance.rows, False
    for k in range(rows.shape[0]):
        row, s, law = _row(body, k), k % body.springs, _law(body, k)
        _, _, length = _direction(body, q, s)
        slope = max(row.across, row.forward, row.backward) / (row.slip if row.slip > 0.0 else 1.0)
        for end in range(2):
            m, p = _end(body, row, s, length, end)
            if h * slope * p * inverse_mass[m] > _STIFF:
                if k >= body.springs:
                    quick[law - 1, m] = 0.0
                quick[law, m], found = 1.0, True
    return found


@kernel(fastmath=FAST)
def gather_other_powers(body, state, q, v, a, part, quick):
    """Add, weighted by `part`, the power of all forces but resistance on the masses of
    `mark_stiff_resistance`; q, v, a: flat positions, velocities and accelerations."""
    rows, mass, slots, last = body.environment.resistance.rows, body.environment.mass, q.size // 2, -1
    for k in range(rows.shape[0]):
        row, s, law = _row(body, k), k % body.springs, _law(body, k)
        tx, ty, length = _direction(body, q, s)
        for end in range(2):
            m, p = _end(body, row, s, length, end)
            if quick[law, m] > 0.0:
                quick[law, slots + m] -= part * _power_at(body, state, row, q, v, m, p, tx, ty)
        if law != last:
            for m in range(1, body.masses + 1):
                if quick[law, m] > 0.0:
                    quick[law, slots + m] += part * mass[m] * (a[m] * v[m] + a[slots + m] * v[slots + m])
        last = law


@kernel(fastmath=FAST)
def work_of_stiff_resistance(body, balance, v0, v1, h):
    """Add the work of resistance on the masses of `mark_stiff_resistance` in a step, kg px²/s²."""
    rows, mass, quick, slots = (
        body.environment.resistance.rows,
        body.environment.mass,
        balance.quick,
        v0.size // 2,
    )
    for k in range(0, rows.shape[0], max(body.springs, 1)):
        row, law, work = _row(body, k), _law(body, k), 0.0
        for i in range(1, body.masses + 1):
            if quick[law, i] > 0.0:
                j = slots + i
                change = v1[i] * v1[i] - v0[i] * v0[i] + v1[j] * v1[j] - v0[j] * v0[j]
                work += 0.5 * mass[i] * change - h * quick[law, j]
        if row.slip == 0.0:
            balance.work.air += work
        else:
            balance.work.walls += work


# ------------------------------------------------------------------------- derivatives
@kernel(forceinline=True, fastmath=FAST)
def _by_velocity(p, tx, ty, slopes):
    """The derivative of the force on an end by its velocity, kg/s."""
    # Of what resists across and along the spring, the derivatives by both components of the velocity.
    across_x = slopes.across_by_along * tx - slopes.across_by_across * ty
    across_y = slopes.across_by_along * ty + slopes.across_by_across * tx
    along_x = slopes.along_by_along * tx - slopes.along_by_across * ty
    along_y = slopes.along_by_along * ty + slopes.along_by_across * tx
    return (
        -p * (along_x * tx - across_x * ty),
        -p * (along_y * tx - across_y * ty),
        -p * (along_x * ty + across_x * tx),
        -p * (along_y * ty + across_y * tx),
    )


@kernel(forceinline=True, fastmath=FAST)
def _by_vector(row, p, length, tx, ty, ux, uy, dx, dy):
    """How the force on an end changes with the vector of its spring, by (dx, dy) px to first order."""
    beside, ahead = _resisted(row, tx, ty, ux, uy)
    slopes = _slopes(row, tx, ty, ux, uy, False)
    longer = tx * dx + ty * dy
    turn_x, turn_y = (dx - tx * longer) / length, (dy - ty * longer) / length
    across, along = turn_x * uy - turn_y * ux, turn_x * ux + turn_y * uy
    beside_more = slopes.across_by_across * across + slopes.across_by_along * along
    ahead_more = slopes.along_by_across * across + slopes.along_by_along * along
    more_x = ahead_more * tx + ahead * turn_x - beside_more * ty - beside * turn_y
    more_y = ahead_more * ty + ahead * turn_y + beside_more * tx + beside * turn_x
    return (
        -row.part * longer * (ahead * tx - beside * ty) - p * more_x,
        -row.part * longer * (ahead * ty + beside * tx) - p * more_y,
    )


@kernel(fastmath=FAST)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    rows, air = body.environment.resistance.rows, body.environment.air
    target, slots = matrix.spring_target, q.size // 2
    for k in range(rows.shape[0]):
        row, s = _row(body, k), k % body.springs
        tx, ty, length = _direction(body, q, s)
        for end in range(2):
            m, p = _end(body, row, s, length, end)
            own, other = (4 * s + 3, 4 * s + 2) if end == 0 else (4 * s, 4 * s + 1)
            ux, uy = _relative_velocity(body, state, row, q, v, m)
            xx, xy, yx, yy = _by_velocity(p, tx, ty, _slopes(row, tx, ty, ux, uy, definite))
            add_block(matrix.blocks, target[own], g, (xx, xy, yx, yy))
            if not definite:
                one = _by_vector(row, p, length, tx, ty, ux, uy, 1.0, 0.0)
                two = _by_vector(row, p, length, tx, ty, ux, uy, 0.0, 1.0)
                sign = -1.0 if end == 0 else 1.0
                add_block(matrix.blocks, target[own], sign, (one[0], two[0], one[1], two[1]))
                add_block(matrix.blocks, target[other], -sign, (one[0], two[0], one[1], two[1]))
                if row.slip == 0.0 and air.waves.shape[0] > 0:
                    a, b, c, d = wind_gradient_at(air, state.clock[0], q[m], q[slots + m])
                    of_gusts = xx * a + xy * c, xx * b + xy * d, yx * a + yy * c, yx * b + yy * d
                    add_block(matrix.blocks, target[own], -1.0, of_gusts)


@kernel(fastmath=FAST)
def _add_damping(body, state, q, v, z, factor, out):
    rows, slots = body.environment.resistance.rows, z.size // 2
    for k in range(rows.shape[0]):
        row, s = _row(body, k), k % body.springs
        tx, ty, length = _direction(body, q, s)
        for end in range(2):
            m, p = _end(body, row, s, length, end)
            ux, uy = _relative_velocity(body, state, row, q, v, m)
            xx, xy, yx, yy = _by_velocity(p, tx, ty, _slopes(row, tx, ty, ux, uy, False))
            size = factor * state.inverse_mass[m]
            out[m] += size * (xx * z[m] + xy * z[slots + m])
            out[slots + m] += size * (yx * z[m] + yy * z[slots + m])


# ------------------------------------------------------------------------- in NumPy
class ResistanceReference:
    """Resistance in NumPy; see `Reference`."""

    def __init__(self, body: Body, state: State) -> None:
        self._rows, self._air = body.environment.resistance.rows, AirReference(body, state)
        self._ends = np.stack((body.spring_a, body.spring_b))
        self._moves = body.environment.air.moves

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`; also on masses that are held."""
        total = np.zeros_like(x)
        if not len(self._rows):
            return total
        laws = self._rows.reshape(-1, self._ends.shape[1], len(ResistanceRow._fields))
        spring = x[self._ends[1]] - x[self._ends[0]]
        length = np.maximum(abs(spring), 1e-300)
        for part, on_a, on_b, across, forward, backward, slip in np.moveaxis(laws, 2, 1):
            in_medium = not slip[0]
            past = v - self._air.wind(x) if in_medium and self._moves else v
            for at, weight in zip(self._ends, (on_a, on_b), strict=True):
                u = past[at] * (spring / length).conj()  # along the spring, and across it
                resisted = np.where(u.real > 0.0, forward, backward) * u.real + 1j * across * u.imag
                if not in_medium:
                    resisted /= np.hypot(abs(u), slip)
                force = -(part * length + weight) * resisted * spring / length
                total += summed(at, force, x.size)
        return total

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        return 0.0


RESISTANCE = Term(
    "resistance",
    is_resisted,
    ResistanceReference,
    _add_forces,
    field="resistance",
    table=Resistance,
    new=new_resistance,
    add_power=_add_power,
    add_derivatives=_add_derivatives,
    add_damping=_add_damping,
    bounds=_bounds,
)
