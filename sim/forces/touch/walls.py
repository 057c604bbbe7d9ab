"""Walls: half planes, which push back the free masses that have entered them; see `push`.

With the point p and the unit normal n of a wall, a mass m at x is inside at the depth d = (p - x) . n + r
where that is positive; r is the radius of a solid mass, 0 of any other. It is pushed along n with
m H d² (1 + c s), with the hardness H, 1/(px s²), and the speed s at which it enters, and slowed along the
wall, t = (-n.y, n.x), by friction. A held mass is not pushed.

The surface of a belt moves with the speed b along t: speeds along the wall are relative to it, and so is the
way of a mass since a stretch was noted. Where a wall has static friction, its
coefficient is that of a mass with a tangential spring that does not slide. It slides from the end of the step
in which the spring is stretched to the limit, until spring and speed have opposite signs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ...engine.jit import FAST, kernel
from ...engine.table import Rows, Table
from ...engine.tables import Body, State
from ...scene.surroundings import Wall
from ...scene.types import Scene
from ..events import kept_stretch, slip_fraction, stretch_since_touch, touch_fraction
from ..term import Floats, Places, Term, Vectors
from .pairs import sizes_of
from .push import (
    friction_slopes,
    losses,
    push_and_friction,
    push_slopes,
    pushes_and_frictions,
    softened,
    softened_for,
    tangential_spring,
    time_to_deepest,
)

_STIFF = 4.0
"""Step length in time constants of friction from which it stops a mass within a fraction of the step. By
experiment: an eighth makes a jelly on walls a third slower while its balance is followed."""

_WHOLE = 1.0 - 1e-9
"""Part of the largest stretch from which a tangential spring counts as sliding: it is cut to that,
rounded."""


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Walls(Table):
    """Read-only. W walls."""

    rows: Rows  # (W, 14), a `WallRow` each
    tangential: bool  # any wall has tangential springs
    static: bool  # any wall has static friction
    runs: bool  # any belt has tangential springs
    size: Floats  # (slots,) px, the radius of each solid mass, else 0


class WallRow(NamedTuple):
    """A wall."""

    x: float  # px, a point of the surface
    y: float
    nx: float  # the unit vector to the free side
    ny: float
    hardness: float  # 1/(px s²)
    friction: float  # coefficient
    slip_speed: float  # px/s
    damping: float  # what is lost, see `push.Lost`: s/px
    hysteresis: float
    calm: float  # px^(-1/2)/s
    tangential: float  # of a tangential spring of a mass of 1 kg: its stiffness, 1/s²
    resisting: float  # and its damping, 1/s
    belt: float  # px/s, the speed of the surface along the wall
    static: float  # coefficient of static friction; 0 where it is that of sliding


NOWHERE = 1e300
"""In `State.wall_place`, the place of a mass that has no tangential spring there."""

NO_WALLS = Walls.empty().replaced(rows=np.zeros((0, len(WallRow._fields)))).read_only()


def new_walls(scene: Scene, places: Places) -> Walls:
    """The table of a valid scene."""
    if not scene.walls:
        return NO_WALLS
    rows = np.array([_row(wall) for wall in scene.walls], float).reshape(-1, len(WallRow._fields))
    springy = [wall for wall in scene.walls if wall.tangential_hardness]
    return Walls(
        rows=rows,
        tangential=bool(springy),
        static=any(wall.static_friction for wall in springy),
        runs=any(wall.speed for wall in springy),
        size=sizes_of(scene, places),
    )


def _row(wall: Wall) -> WallRow:
    nx, ny = (part / math.hypot(*wall.normal) for part in wall.normal)
    lost = losses(wall.restitution, wall.bounciness, wall.hardness, 1.0)
    spring = tangential_spring(wall.tangential_hardness, 1.0)
    static = wall.static_friction or 0.0
    return WallRow(
        *wall.point, nx, ny, wall.hardness, wall.friction, wall.slip_speed, *lost, *spring,
        wall.speed or 0.0, static if static > wall.friction else 0.0,
    )  # fmt: skip


def place_along(row: Floats, x: Any, y: Any) -> Any:
    """Where something at (x, y) is along a wall, px; see `State.wall_place`."""
    wall = WallRow(*row)
    return y * wall.nx - x * wall.ny


@kernel(forceinline=True)
def _wall(body, k):
    """The k-th wall."""
    row = body.environment.walls.rows[k]
    return WallRow(
        row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8], row[9], row[10], row[11],
        row[12], row[13],
    )  # fmt: skip


@kernel(forceinline=True)
def _lost(wall):
    return wall.damping, wall.hysteresis, wall.calm


@kernel(forceinline=True)
def _spring(wall):
    return wall.tangential, wall.resisting


# ------------------------------------------------------------------------- force and energy
@kernel(forceinline=True, fastmath=FAST)
def _depth_in(body, wall, i, x, y):
    """How deep mass i at (x, y) is inside a wall, px; negative outside."""
    return (wall.x - x) * wall.nx + (wall.y - y) * wall.ny + body.environment.walls.size[i]


@kernel(forceinline=True, fastmath=FAST)
def _stretch_at(state, wall, k, i, x, y):
    """The stretch of the tangential spring between the k-th wall and mass i at (x, y), px; 0 without one."""
    if wall.tangential == 0.0:
        return 0.0
    place = state.wall_place[k, i]
    if not place < NOWHERE:
        return 0.0
    moved = y * wall.nx - x * wall.ny - place
    if wall.belt != 0.0:
        moved -= wall.belt * (state.clock[0] - state.wall_time[0])
    return state.wall_stretch[k, i] + moved


@kernel(forceinline=True, fastmath=FAST)
def _limit(state, wall, k, i):
    """The coefficient of the friction between the k-th wall and mass i."""
    return wall.static if wall.static > 0.0 and state.wall_slides[k, i] == 0.0 else wall.friction


@kernel(forceinline=True, fastmath=FAST)
def _wall_push(wall, limit, h, depth, vx, vy, stretch):
    """What a wall does to a mass of 1 kg inside it: (push, friction, elastic part of the push, speed along,
    relative to the wall).

    Args:
        wall: the wall.
        limit: of `_limit`.
        h: `Environment.step`.
        depth: of the mass, px, positive.
        vx, vy: its velocity, px/s.
        stretch: of its tangential spring, px.
    """
    nx, ny = wall.nx, wall.ny
    along = vy * nx - vx * ny - wall.belt
    push, friction, elastic = push_and_friction(
        wall.hardness, _lost(wall), limit, wall.slip_speed,
        _spring(wall), h, 1.0, 1.0, depth, vx * nx + vy * ny, along, stretch,
    )  # fmt: skip
    return push, friction, elastic, along


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    environment, rows, slots = body.environment, body.environment.walls.rows, q.size // 2
    fx, fy, free = scratch.fx, scratch.fy, state.inverse_mass
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            depth = _depth_in(body, wall, i, q[i], q[slots + i])
            if depth > 0.0 and free[i] > 0.0:
                stretch = _stretch_at(state, wall, k, i, q[i], q[slots + i])
                limit, vx, vy = _limit(state, wall, k, i), v[i], v[slots + i]
                push, friction, _, _ = _wall_push(wall, limit, environment.step, depth, vx, vy, stretch)
                fx[i] += environment.mass[i] * (push * wall.nx + friction * wall.ny)
                fy[i] += environment.mass[i] * (push * wall.ny - friction * wall.nx)


@kernel(fastmath=FAST)
def _energy(body, state, q):
    """The sum of m H d³ / 3, and what tangential springs have."""
    environment, rows, slots, energy = body.environment, body.environment.walls.rows, q.size // 2, 0.0
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            depth = _depth_in(body, wall, i, q[i], q[slots + i])
            if depth > 0.0 and state.inverse_mass[i] > 0.0:
                energy += environment.mass[i] * wall.hardness * depth * depth * depth / 3.0
    return energy + energy_along_walls(body, state, q, False)


@kernel(fastmath=FAST)
def energy_along_walls(body, state, q, kept):
    """The energy of the tangential springs at positions q, kg px²/s²; with `kept`, as they have been
    noted."""
    environment, rows, slots, energy = body.environment, body.environment.walls.rows, q.size // 2, 0.0
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        if wall.tangential > 0.0:
            stiffness, _ = softened(_spring(wall), environment.step, 1.0)
            for i in range(1, body.masses + 1):
                if _depth_in(body, wall, i, q[i], q[slots + i]) > 0.0 and state.inverse_mass[i] > 0.0:
                    stretch = _stretch_at(state, wall, k, i, q[i], q[slots + i])
                    stretch = state.wall_stretch[k, i] if kept else stretch
                    energy += 0.5 * environment.mass[i] * stiffness * stretch * stretch
    return energy


@kernel(forceinline=True, fastmath=FAST)
def _slider(body, state, wall, k, i, q, v, pull, begins):
    """Depth of mass i in the k-th wall, px, speed outwards, px/s, and what `events.slip_fraction` asks of an
    end of a step, for 1 kg. `pull`: acceleration outwards, px/s²; `begins`: it is the first end, at which
    stretches have been noted, and the clock has gone on since."""
    slots = q.size // 2
    x, y, vx, vy = q[i], q[slots + i], v[i], v[slots + i]
    depth, most, grows, speed = _depth_in(body, wall, i, x, y), 0.0, 0.0, vx * wall.nx + vy * wall.ny
    stretch, along = _stretch_at(state, wall, k, i, x, y), vy * wall.nx - vx * wall.ny - wall.belt
    if begins and wall.tangential > 0.0:
        stretch = state.wall_stretch[k, i]
    if depth > 0.0:
        limit = _limit(state, wall, k, i)
        push, _, _, _ = _wall_push(wall, limit, body.environment.step, depth, vx, vy, stretch)
        most = limit * push
        by_depth, by_speed = push_slopes(wall.hardness, _lost(wall), depth, speed)
        grows = limit * (by_speed * pull - by_depth * speed)
    return depth, speed, (stretch, along, most, grows)


@kernel(forceinline=True, fastmath=FAST)
def _outwards(wall, i, v0, v1):
    """How much faster a mass moves outwards afterwards, px/s."""
    slots = v0.size // 2
    return (v1[i] - v0[i]) * wall.nx + (v1[slots + i] - v0[slots + i]) * wall.ny


@kernel(fastmath=FAST)
def slip_fraction_on_walls(body, state, q, v, to_q, to_v, h, unseen):
    """The part of a step that leads just beyond where a mass begins to touch a wall, or to slide along it, or
    turns round; see `events.slip_fraction`."""
    rows, part = body.environment.walls.rows, 1.0
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        if wall.tangential > 0.0:
            for i in range(1, body.masses + 1):
                if state.inverse_mass[i] > 0.0:
                    pull = _outwards(wall, i, v, to_v) / h
                    depth, speed, start = _slider(body, state, wall, k, i, q, v, pull, True)
                    to_depth, to_speed, end = _slider(body, state, wall, k, i, to_q, to_v, pull, False)
                    if depth > 0.0 and _has_grip(state, wall, k, i):
                        part = min(part, slip_fraction(h, _spring(wall), 1.0, start, end, unseen))
                    elif depth <= 0.0 < to_depth:
                        depths, speeds = (depth, to_depth), (speed, to_speed)
                        part = min(part, touch_fraction(h, _spring(wall), 1.0, depths, speeds, end, unseen))
    return part


@kernel(fastmath=FAST)
def stick_to_walls(body, state, q0, v0, q, v, h):
    """Note the stretch of each tangential spring at the end of a step, and let sliders slide: see `push`.

    Arguments: see `friction_history.update_friction_history`.

    Returns:
        Whether any force has jumped, as static friction is no more.
    """
    rows, slots, jumped = body.environment.walls.rows, q.size // 2, False
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        if wall.tangential > 0.0:
            stiffness, _ = softened(_spring(wall), body.environment.step, 1.0)
            for i in range(1, body.masses + 1):
                pull = _outwards(wall, i, v0, v) / h if h > 0.0 else 0.0
                depth, speed, end = _slider(body, state, wall, k, i, q, v, pull, False)
                if depth > 0.0 and state.inverse_mass[i] > 0.0:
                    before, speed0, start = depth, speed, end
                    if h > 0.0:
                        before, speed0, start = _slider(body, state, wall, k, i, q0, v0, pull, True)
                    if _has_grip(state, wall, k, i):
                        stretch = kept_stretch(h, stiffness, start, end)
                    elif before < 0.0:
                        way = (q[slots + i] - q0[slots + i]) * wall.nx - (q[i] - q0[i]) * wall.ny
                        way -= wall.belt * h
                        stretch = stretch_since_touch(
                            h, stiffness, (before, depth), (speed0, speed), way, (start[1], end[1]), end[2]
                        )
                    else:
                        stretch = 0.0
                    if wall.static > 0.0:
                        most = end[2] / stiffness
                        if state.wall_slides[k, i] > 0.0:
                            state.wall_slides[k, i] = 1.0 if stretch * end[1] > 0.0 else 0.0
                        elif abs(stretch) >= _WHOLE * most:
                            most *= wall.friction / wall.static
                            stretch = min(max(stretch, -most), most)
                            state.wall_slides[k, i], jumped = 1.0, True
                    state.wall_stretch[k, i] = stretch
                    state.wall_place[k, i] = q[slots + i] * wall.nx - q[i] * wall.ny
                else:
                    state.wall_stretch[k, i], state.wall_place[k, i] = 0.0, NOWHERE
                    if wall.static > 0.0:
                        state.wall_slides[k, i] = 0.0
    if body.environment.walls.runs:
        state.wall_time[0] = state.clock[0]
    return jumped


# ------------------------------------------------------------------------- the balance
@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    """Friction, and what bouncing loses; friction on the masses of `mark_stiff_friction` is left out."""
    environment, rows, slots, power = body.environment, body.environment.walls.rows, q.size // 2, 0.0
    quick = balance.quick
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            depth = _depth_in(body, wall, i, q[i], q[slots + i])
            if depth > 0.0 and state.inverse_mass[i] > 0.0:
                vx, vy = v[i], v[slots + i]
                stretch = _stretch_at(state, wall, k, i, q[i], q[slots + i])
                limit, along = _limit(state, wall, k, i), vy * wall.nx - vx * wall.ny
                push, friction, elastic, _ = _wall_push(wall, limit, environment.step, depth, vx, vy, stretch)
                rubbing = friction * along if quick.shape[0] == 0 or quick[k, i] == 0.0 else 0.0
                power += environment.mass[i] * ((push - elastic) * (vx * wall.nx + vy * wall.ny) - rubbing)
    balance.work.walls += part * power


@kernel(fastmath=FAST)
def mark_stiff_friction(body, inverse_mass, q0, q1, h, quick):
    """Whether friction on a wall would stop any mass within a fraction of a step of h seconds.

    Where it does, the speeds of a step have errors that the tolerance allows, but friction in proportion to
    them would seem to take many times the energy that there is. So its work is found from the change of the
    kinetic energy along the wall and the work of all other forces there, which goes by the way that is made.

    Args:
        q0, q1: flat positions at both ends of the step.
        quick: `EnergyBalance.quick`, which is zero.
    """
    rows, slots, found = body.environment.walls.rows, q0.size // 2, False
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        rate = h * wall.friction * wall.hardness / wall.slip_speed
        for i in range(1, body.masses + 1):
            before = _depth_in(body, wall, i, q0[i], q0[slots + i])
            depth = max(before, _depth_in(body, wall, i, q1[i], q1[slots + i]))
            if depth > 0.0 and inverse_mass[i] > 0.0 and rate * depth * depth > _STIFF:
                quick[k, i], found = 1.0, True
    return found


@kernel(fastmath=FAST)
def gather_others(body, state, q, v, a, part, quick):
    """Add, weighted by `part`, the power along each wall of all forces but its friction, kg px²/s³.

    Args:
        q, v, a: flat positions, velocities and accelerations.
        part: of the step.
        quick: of `mark_stiff_friction`; the powers are in its second half.
    """
    environment, rows, slots = body.environment, body.environment.walls.rows, q.size // 2
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                x, y, vx, vy = q[i], q[slots + i], v[i], v[slots + i]
                depth, along, friction = _depth_in(body, wall, i, x, y), vy * wall.nx - vx * wall.ny, 0.0
                if depth > 0.0:
                    stretch = _stretch_at(state, wall, k, i, x, y)
                    limit = _limit(state, wall, k, i)
                    _, friction, _, _ = _wall_push(wall, limit, environment.step, depth, vx, vy, stretch)
                others = a[slots + i] * wall.nx - a[i] * wall.ny + friction
                quick[k, slots + i] += part * environment.mass[i] * others * along


@kernel(fastmath=FAST)
def work_of_quick(body, v0, v1, h, quick):
    """The work of friction on the masses of `mark_stiff_friction` in a step, which is negative, kg px²/s²."""
    environment, rows, slots, work = body.environment, body.environment.walls.rows, v0.size // 2, 0.0
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                first = v0[slots + i] * wall.nx - v0[i] * wall.ny
                last = v1[slots + i] * wall.nx - v1[i] * wall.ny
                kinetic = 0.5 * environment.mass[i] * (last * last - first * first)
                work += kinetic - h * quick[k, slots + i]
    return work


# ------------------------------------------------------------------------- derivatives
@kernel(forceinline=True)
def _has_grip(state, wall, k, i):
    """Whether there is a tangential spring between the k-th wall and mass i."""
    return wall.tangential > 0.0 and state.wall_place[k, i] < NOWHERE


@kernel(fastmath=FAST)
def _wall_derivatives(wall, limit, depth, vx, vy, stretch, gripped, definite):
    """The derivatives of a wall's acceleration f of a mass inside it: two blocks, 1/s² and 1/s.

    With the push N(d, s), the normal n, t = (-n.y, n.x), the speeds s = v . n outwards and u = v . t along,
    the friction coefficient mu, and the friction T(mu N, z, u) with the stretch z, f = N n - T t. With
    d' = -n and z' = t by position,

        df/dx = -dN/dd (n - mu dT/d(mu N) t) nᵀ - dT/dz t tᵀ,
        df/dv = dN/ds (n - mu dT/d(mu N) t) nᵀ - dT/du t tᵀ.

    Without a tangential spring, T = mu N tanh(u / u0). `gripped`: whether the mass has one there.
    The push is that without the softening for explicit methods, which use no derivatives. With `definite`,
    friction along t, which is not symmetric, is left out of the first factors, and dT/du is its secant T / u.
    """
    nx, ny = wall.nx, wall.ny
    friction, slip_speed = limit, wall.slip_speed
    push, rubbing, _, along = _wall_push(wall, limit, 0.0, depth, vx, vy, stretch)
    held, stiff, drag = friction_slopes(friction * push, slip_speed, _spring(wall), along, stretch)
    stiff = stiff if gripped else 0.0
    by_depth, by_speed = push_slopes(wall.hardness, _lost(wall), depth, vx * nx + vy * ny)
    fx, fy = nx + friction * held * ny, ny - friction * held * nx
    if definite:
        fx, fy = nx, ny
        drag = rubbing / along if wall.tangential == 0.0 and along != 0.0 else drag
    by_position = (
        -by_depth * fx * nx - stiff * ny * ny,
        -by_depth * fx * ny + stiff * ny * nx,
        -by_depth * fy * nx + stiff * nx * ny,
        -by_depth * fy * ny - stiff * nx * nx,
    )
    by_velocity = (
        by_speed * fx * nx - drag * ny * ny,
        by_speed * fx * ny + drag * ny * nx,
        by_speed * fy * nx + drag * nx * ny,
        by_speed * fy * ny - drag * nx * nx,
    )
    return by_position, by_velocity


@kernel(fastmath=FAST)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    rows, mass, slots = body.environment.walls.rows, body.environment.mass, q.size // 2
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(body.masses):
            m = matrix.order[i]
            depth = _depth_in(body, wall, m, q[m], q[slots + m])
            if depth > 0.0 and state.inverse_mass[m] > 0.0:
                stretch, gripped = (
                    _stretch_at(state, wall, k, m, q[m], q[slots + m]),
                    _has_grip(state, wall, k, m),
                )
                limit, vx, vy = _limit(state, wall, k, m), v[m], v[slots + m]
                by_q, by_v = _wall_derivatives(wall, limit, depth, vx, vy, stretch, gripped, definite)
                d = 4 * matrix.diagonal[i]
                for e in range(4):
                    matrix.blocks[d + e] += mass[m] * (by_q[e] + g * by_v[e])


@kernel(fastmath=FAST)
def _add_damping(body, state, q, v, z, factor, out):
    rows, mass, w, slots = body.environment.walls.rows, body.environment.mass, state.inverse_mass, q.size // 2
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for m in range(1, body.masses + 1):
            depth = _depth_in(body, wall, m, q[m], q[slots + m])
            if depth > 0.0 and w[m] > 0.0:
                stretch = _stretch_at(state, wall, k, m, q[m], q[slots + m])
                limit, vx, vy = _limit(state, wall, k, m), v[m], v[slots + m]
                _, block = _wall_derivatives(wall, limit, depth, vx, vy, stretch, False, False)
                share = factor * w[m] * mass[m]
                out[m] += share * (block[0] * z[m] + block[1] * z[slots + m])
                out[slots + m] += share * (block[2] * z[m] + block[3] * z[slots + m])


# ------------------------------------------------------------------------- what it asks of a step
@kernel(fastmath=FAST)
def _impact_time(body, state, q, v, a, h):
    rows, slots, shortest = body.environment.walls.rows, q.size // 2, math.inf
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        nx, ny, hardness = wall.nx, wall.ny, wall.hardness
        for i in range(1, body.masses + 1):
            if state.inverse_mass[i] > 0.0:
                depth = _depth_in(body, wall, i, q[i], q[slots + i])
                speed, outwards = nx * v[i] + ny * v[slots + i], nx * a[i] + ny * a[slots + i]
                shortest = min(shortest, time_to_deepest(hardness, depth, speed, outwards, h))
    return shortest


# ------------------------------------------------------------------------- in NumPy
class WallsReference:
    """Walls in NumPy; see `Reference`. For a unit vector n, conj(n) v has the parts of v along n and across
    it."""

    def __init__(self, body: Body, state: State) -> None:
        self._walls, self._step = body.environment.walls, body.environment.step
        self._mass, self._state = body.environment.mass, state

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`."""
        return sum(self.force_of_each(x, v), np.zeros_like(x))

    def force_of_each(self, x: Vectors, v: Vectors) -> Iterator[Vectors]:
        """The forces of each wall on free masses."""
        mass = np.where(self._state.inverse_mass > 0.0, self._mass, 0.0)
        for k, (wall, depth, normal) in enumerate(self._depths(x)):
            # Real part: outwards, imaginary part: along the wall, relative to its surface.
            speed = v * normal.conjugate() - 1j * wall.belt
            push, rubbing = pushes_and_frictions(
                wall.hardness, wall[7:10], self._limit(k, wall), wall.slip_speed, wall[10:12],
                self._step, 1.0, 1.0, depth, speed, self._stretch(k, wall, x),
            )  # fmt: skip
            yield mass * (push - 1j * rubbing) * normal

    def energy(self, x: Vectors) -> float:
        """See `Reference`; that of free masses."""
        mass, total = np.where(self._state.inverse_mass > 0.0, self._mass, 0.0), 0.0
        for k, (wall, depth, _) in enumerate(self._depths(x)):
            total += float((mass * wall.hardness * depth**3).sum()) / 3.0
            stiffness = float(softened_for(wall[10:12], self._step, 1.0)[0])
            total += 0.5 * stiffness * float((mass * (depth > 0.0) * self._stretch(k, wall, x) ** 2).sum())
        return total

    def update_friction_history(self, x: Vectors, v: Vectors) -> None:
        """`stick_to_walls`."""
        for k, (wall, depth, normal) in enumerate(self._depths(x)):
            if wall.tangential:
                stretch = self._stretch(k, wall, x)
                limit, speed = self._limit(k, wall), v * normal.conjugate() - 1j * wall.belt
                push, _ = pushes_and_frictions(
                    wall.hardness, wall[7:10], limit, wall.slip_speed, wall[10:12],
                    self._step, 1.0, 1.0, depth, speed, stretch,
                )  # fmt: skip
                per_stretch = softened_for(wall[10:12], self._step, 1.0)[0]
                most = limit * push / per_stretch
                inside = (depth > 0.0) & (self._state.inverse_mass > 0.0)
                if wall.static:
                    slides = self._state.wall_slides[k] > 0.0
                    begins = ~slides & (abs(stretch) >= _WHOLE * most)
                    slides = inside & (begins | (slides & (stretch * speed.imag > 0.0)))
                    most = np.where(begins, wall.friction * push / per_stretch, most)
                    self._state.wall_slides[k] = slides
                self._state.wall_stretch[k] = np.where(inside, np.clip(stretch, -most, most), 0.0)
                place = place_along(self._walls.rows[k], x.real, x.imag)
                self._state.wall_place[k] = np.where(inside, place, NOWHERE)
        if self._walls.runs:
            self._state.wall_time[:] = self._state.clock

    def _limit(self, k: int, wall: WallRow) -> Floats:
        """The coefficient of friction of each mass."""
        if not wall.static:
            return np.full(self._mass.size, wall.friction)
        return np.where(self._state.wall_slides[k] > 0.0, wall.friction, wall.static)

    def _stretch(self, k: int, wall: WallRow, x: Vectors) -> Floats:
        """The stretch of each tangential spring, px; 0 without one."""
        if not wall.tangential:
            return np.zeros(x.size)
        place = self._state.wall_place[k]
        moved = place_along(self._walls.rows[k], x.real, x.imag) - place
        if wall.belt:
            moved = moved - wall.belt * float(self._state.clock[0] - self._state.wall_time[0])
        return np.where(place < NOWHERE, self._state.wall_stretch[k] + moved, 0.0)

    def _depths(self, x: Vectors) -> Iterator[tuple[WallRow, Floats, complex]]:
        """Each wall, how deep each mass is in it, px, or 0, and its normal."""
        for row in self._walls.rows:
            wall = WallRow(*row)
            normal = complex(wall.nx, wall.ny)
            depth = ((complex(wall.x, wall.y) - x) * normal.conjugate()).real + self._walls.size
            yield wall, np.maximum(depth, 0.0), normal


WALLS = Term(
    "walls",
    lambda scene: bool(scene.walls),
    WallsReference,
    _add_forces,
    field="walls",
    table=Walls,
    new=new_walls,
    energy=_energy,
    label="depth in walls",
    add_power=_add_power,
    add_derivatives=_add_derivatives,
    add_damping=_add_damping,
    impact_time=_impact_time,
    touches=True,
    holds=True,
    sticks=lambda walls: walls.tangential,
    depends_on_time=lambda body: bool(body.environment.walls.runs),
)
