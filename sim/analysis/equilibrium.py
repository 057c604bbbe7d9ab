"""A body at rest: the pose in which its forces balance, and its small vibrations about a pose."""

from __future__ import annotations

from typing import NamedTuple

import msgspec
import numpy as np

from ..body.sparsity import new_matrix
from ..body.system import build_system, new_scratch, new_state, refresh
from ..errors import InputError
from ..kernels.core.tables import Floats
from ..kernels.forces.forces import accelerations
from ..kernels.linear.implicit import factorise_matrix, solve_matrix
from ..kernels.linear.two_sided_lu import inverse_pivots
from ..scene.types import MAX_COORDINATE, Integrator, Pose, Scene
from ..scene.validate import validate

_MOST_STEPS = 3000
_TURN = 0.5
"""How far a step may move the ends of a spring against each other, in lengths of the spring."""
_CONTRACTION = 0.5
"""Each iteration of a step has to move by at most this part of what the one before it moved."""
_ITERATIONS = 6
"""Iterations of a step, at most."""
_SETTLED = 0.02
"""A step has converged when an iteration is this small beside the first."""
_PRECISION = 1e-12
"""Steps this short, in typical lengths of a spring, are the end."""
_LOWEST = 1e-15
"""The smallest shift that is tried, 1/s²."""
_NEUTRAL = 1e-13
"""The largest shift, 1/s², that a stable body with held masses may need to be definite in spite of
rounding."""
_NEUTRAL_FREE = 1e-9
"""The same of a body that is free to move as a whole."""
_CLOSE = 1e-5
"""Steps this short, in typical lengths of a spring, end at a balance; if it is not stable, the body is
nudged."""
_NUDGE = 1e-3
"""Size of a nudge, in typical lengths of a spring."""
_NUDGES = 5
"""Nudges at most."""
_HALVINGS = 60
_EPSILON = 4.0 * float(np.finfo(float).eps)
_MOST_MASSES = 1000
"""Masses up to which vibrations are worked out, with full matrices."""
_NOT_HELD = "vibrations: the springs do not hold the body where it starts, so it does not vibrate there"


def equilibrium(scene: Scene) -> Pose:
    """The pose at rest that a scene would creep into if everything were damped heavily.

    It starts from the scene's pose (or its masses' own positions), and the held masses stay where they are
    there, also those on circles. The springs are those of the scene, whatever its method.

    This is pseudo-transient continuation (Kelley & Keyes 1998): steps of implicit Euler, each from rest and
    ever longer, so that they end as Newton's method. Newton's iterations with the analytic Jacobian solve for
    the end of a step, the first of them being the linearly implicit step; how fast they converge sets the
    length of the next, which needs no energy and so serves every force law. A step may not be so long that
    the matrix is indefinite, so that the body slides off a balance that would tip over. Where no step
    converges, one is made with the positive definite matrix and a line search along it.

    Args:
        scene: a valid scene. Where the forces of no spring balance the gravity, there is no equilibrium.

    Returns:
        Positions in px, and velocities of zero. Positions are as exact as rounding and the softness of the
        body let them be: usually within 1e-9 of a spring's length, less for long bodies with springs more
        than 1e5 times as stiff as their joints.

    Raises:
        SceneError: the scene is not valid.
        InputError: something falls because nothing holds it, or the steps do not end in a balance.
    """
    body = _Resting(scene, balanced=True)
    if any(scene.gravity):
        body.refuse_falling()
    q = _continuation(body)
    body.refuse_shrunk(q)
    return body.pose(q)


class Vibrations(NamedTuple):
    """Small vibrations without damping, the slowest first.

    Attributes:
        frequencies: (k,) angular frequencies, rad/s.
        shapes: (k, n, 2) how far each mass moves, in parts of the farthest; signs are arbitrary.
    """

    frequencies: Floats
    shapes: Floats


def vibrations(scene: Scene, count: int) -> Vibrations:
    """The slowest small vibrations about the scene's start, which should be an equilibrium.

    They are eigenvalues of the inverse of the Jacobian of the accelerations by positions, so that the slow
    ones are exact however stiff the body is. Damping and air are left out.

    Args:
        scene: a valid scene of at most 1000 masses.
        count: how many, from 1 to two for each free mass.

    Raises:
        SceneError: the scene is not valid.
        InputError: the count or the number of masses is out of range, or the body is free to move without
            any force or moves away from its start on its own, so that its motion there is no vibration.
    """
    body = _Resting(scene, balanced=False)
    free = np.flatnonzero(body.state.inverse_mass)
    columns = np.concatenate((free, body.slots + free))
    if not 1 <= count <= columns.size:
        raise InputError(f"vibrations: {count} is not in the range 1..{columns.size}")
    if body.tables.masses > _MOST_MASSES:
        raise InputError(f"vibrations: {body.tables.masses} masses are more than {_MOST_MASSES}")
    # No shift to speak of, but without one the rows of held masses would be empty.
    stable = body.factorise(body.start, 1e-100)
    inverse = np.array([body.solve(unit)[columns] for unit in np.eye(2 * body.slots)[columns]]).T
    # Masses on both sides make it symmetric where the law has an energy: real and exact eigenvalues.
    root = np.sqrt(np.tile(body.state.inverse_mass[free], 2))
    scaled = inverse / root[:, None] * root[None, :]
    if not (stable and np.isfinite(scaled).all()):
        raise InputError(_NOT_HELD)
    if np.allclose(scaled, scaled.T, rtol=1e-6, atol=1e-9 * float(np.abs(scaled).max())):
        values, vectors = np.linalg.eigh(0.5 * (scaled + scaled.T))
    else:
        values, vectors = np.linalg.eig(scaled)
        if not (np.abs(np.imag(values)) <= 1e-6 * np.abs(values)).all():
            raise InputError(_NOT_HELD)
        values, vectors = np.real(values), np.real(vectors)
    if not values.max() < 1e18 * values.min():
        raise InputError(_NOT_HELD)
    slowest = np.argsort(values)[::-1][:count]
    flat = np.zeros((count, 2 * body.slots))
    flat[:, columns] = (root[:, None] * vectors[:, slowest]).T
    shapes = np.stack([np.column_stack(body.by_mass(row)) for row in flat])
    return Vibrations(1.0 / np.sqrt(values[slowest]), shapes / np.abs(shapes).max((1, 2), keepdims=True))


class _Resting:
    """The tables of a scene's body, and linear systems with the Jacobian of its accelerations.

    Vectors are flat: x of every slot, then y of every slot.

    Args:
        scene: the scene.
        balanced: whether masses are to be as large (in kg) as the stiffnesses that act on them (in kg/s²),
            instead of the scene's own, as in dynamic relaxation. Where a body rests only weights matter, and
            so no mass is much faster than another: eigenvalues of the Jacobian are of the order of 1/s².
    """

    def __init__(self, scene: Scene, balanced: bool) -> None:
        # The tutorial's method, which softens no spring.
        exact = Integrator(method="symplectic_euler")
        self.system = build_system(msgspec.structs.replace(validate(scene), integrator=exact))
        body = self.tables = self.system.body
        self.state, self.scratch = new_state(self.system), new_scratch(self.system)
        self.matrix = new_matrix(body, self.system.held)
        state, here = self.state, slice(1, body.masses + 1)
        state.controls[:] = scene.rest_length_scale, 0.0
        refresh(body, state)
        free = np.where(self.system.held, 0.0, 1.0)
        weight = 1.0 / self.system.inverse_mass
        state.inverse_mass[here] = free * (1.0 / self._stiffness_at_masses() if balanced else 1.0 / weight)
        state.gx[here], state.gy[here] = state.inverse_mass[here] * np.outer(scene.gravity, weight)
        self.slots = state.x.size
        self.start = np.zeros(2 * self.slots)
        self.start[here], self.start[self.slots :][here] = self.system.start[:2]
        self.still = np.zeros(2 * self.slots)
        lengths = body.rest_length[: body.springs] * scene.rest_length_scale
        self.typical = max(float(np.median(lengths)) if body.springs else 1.0, 1e-3)

    def _stiffness_at_masses(self) -> Floats:
        """(n,) the stiffnesses of all springs and joints that act on each mass, kg/s²; nowhere zero."""
        body = self.tables
        own = body.stiffness[: body.springs].copy()
        for joints in (body.joint_a, body.joint_b):
            np.add.at(own, joints, 2.0 * body.joint_stiffness)
        at_mass = np.zeros(body.masses + 1)
        for masses in (body.spring_a, body.spring_b):
            np.add.at(at_mass, masses, own)
        return np.where(at_mass[1:] > 0.0, at_mass[1:], max(1.0, float(at_mass.max())))

    def refuse_falling(self) -> None:
        """Refuse a body of which some part hangs on no held mass."""
        held, parent = self.system.held, self.matrix.parent
        for m in self.matrix.walk.tolist():
            if parent[m] == 0 and not held[m - 1]:
                mass = int(self.system.mass_order[m - 1])
                raise InputError(f"equilibrium: nothing holds mass {mass}, so it falls")

    def accelerations(self, q: Floats) -> Floats:
        """At positions q and at rest, px/s²."""
        a = np.zeros_like(q)
        accelerations(self.tables, self.state, self.scratch, q, self.still, a)
        return a

    def factorise(self, q: Floats, shift: float, definite: bool = False) -> bool:
        """Factorise shift I - J at positions q; whether it is positive definite.

        Without pivoting between blocks, a matrix that is symmetric but for the masses is positive definite
        exactly if all its pivots are. (The tutorial's law makes it a little unsymmetric.)
        """
        matrix, n = self.matrix, self.tables.masses
        regular = factorise_matrix(self.tables, self.state, matrix, q, self.still, shift, 0.0, definite)
        if self.tables.chain:
            inverse = inverse_pivots(matrix.blocks, n)
        else:
            inverse = matrix.blocks.reshape(-1, 4)[matrix.diagonal]
        xx, xy, yx, yy = inverse[self.state.inverse_mass[self._rows] > 0.0].T
        return bool(regular and (xx + yy > 0.0).all() and (xx * yy - xy * yx > 0.0).all())

    @property
    def _rows(self) -> np.ndarray:
        """The place of the mass that each row of the matrix belongs to."""
        return np.arange(1, self.tables.masses + 1) if self.tables.chain else self.matrix.order

    def solve(self, b: Floats) -> Floats:
        """The solution with the last factors."""
        x = b.copy()
        solve_matrix(self.tables, self.matrix, x)
        return x

    def vectors(self, q: Floats) -> tuple[Floats, Floats]:
        """(S,) x and y of the vectors of the springs."""
        a, b, p = self.tables.spring_a, self.tables.spring_b, self.slots
        return q[b] - q[a], q[p + b] - q[p + a]

    def turn(self, q: Floats, move: Floats) -> float:
        """The most that a move takes the ends of a spring against each other, in its lengths."""
        if not self.tables.springs:
            return 0.0
        lengths = np.maximum(np.hypot(*self.vectors(q)), 1e-3 * self.typical)
        return float((np.hypot(*self.vectors(move)) / lengths).max())

    def nudge(self, q: Floats, size: float) -> Floats:
        """The positions with every free mass a little elsewhere, up to `size` typical lengths."""
        noise = np.random.default_rng(1).uniform(-1.0, 1.0, q.size)
        return q + size * self.typical * noise * (np.tile(self.state.inverse_mass, 2) > 0.0)

    def rounding(self, q: Floats) -> Floats:
        """What rounding may make of accelerations that are zero at positions q, px/s².

        A coordinate is as exact as its size allows; the springs make a force of that, mostly along
        themselves, and their joints one in every direction.
        """
        body, p = self.tables, self.slots
        x, y = self.vectors(q)
        length = np.maximum(np.hypot(x, y), 1e-300)
        pull = self.state.pull[: body.springs]
        across = np.abs(pull / length - body.stiffness[: body.springs])
        for one, other in ((body.joint_a, body.joint_b), (body.joint_b, body.joint_a)):
            np.add.at(across, one, 4.0 * body.joint_stiffness * (1.0 + length[other] / length[one]))
        along = body.stiffness[: body.springs] + pull / length
        size = _EPSILON * (float(np.abs(q).max()) + length)
        force = np.zeros(q.size)
        for masses in (body.spring_a, body.spring_b):
            np.add.at(force, masses, size * (along * np.abs(x) / length + across))
            np.add.at(force, p + masses, size * (along * np.abs(y) / length + across))
        gravity = np.concatenate((np.abs(self.state.gx), np.abs(self.state.gy)))
        return force * np.tile(self.state.inverse_mass, 2) + _EPSILON * gravity

    def refuse_shrunk(self, q: Floats) -> None:
        """Refuse positions in which a spring has no direction; some force laws pull them as short as that."""
        lengths = np.hypot(*self.vectors(q))
        for s in np.flatnonzero(lengths < 1e-9 * max(self.typical, 1.0)).tolist():
            slots = (int(self.tables.spring_a[s]), int(self.tables.spring_b[s]))
            a, b = sorted(int(self.system.mass_order[index - 1]) for index in slots)
            raise InputError(f"equilibrium: the spring between masses {a} and {b} shrinks to no length")

    def by_mass(self, q: Floats) -> tuple[Floats, Floats]:
        """(n,) x and y of each mass, in the order of the scene."""
        index = self.system.mass_index
        return q[index], q[self.slots + index]

    def pose(self, q: Floats) -> Pose:
        """The positions as a scene can carry them, at rest."""
        x, y = (part.tolist() for part in self.by_mass(q))
        return Pose(positions=tuple(zip(x, y, strict=True)), velocities=((0.0, 0.0),) * len(x))


def _continuation(body: _Resting) -> Floats:
    """Positions at which the accelerations vanish."""
    q = body.start
    neutral = _NEUTRAL if body.system.held.any() else _NEUTRAL_FREE
    a = body.accelerations(q)
    shift = float(np.abs(a).max()) / body.typical + _LOWEST
    nudges = balanced = 0
    for _ in range(_MOST_STEPS):
        if (np.abs(a) <= body.rounding(q)).all():
            # A few more steps make the most of what the rounding leaves.
            balanced += shift <= 1e4 * neutral
            if balanced == 8:
                return q
        stats, turned, to_q = np.inf, 0.0, q
        if body.factorise(q, shift):
            move = body.solve(a)
            size = float(np.abs(move).max()) / body.typical
            if size <= _CLOSE and nudges < _NUDGES and not body.factorise(q, neutral):
                # Balanced on a point, or about to be: no force, and yet no rest.
                nudges += 1
                q = body.nudge(q, _NUDGE)
                a = body.accelerations(q)
                continue
            if size <= _PRECISION:
                if shift <= neutral or nudges == _NUDGES:
                    return q + move
                shift = neutral
                continue
            turned = body.turn(q, move)
            if turned <= _TURN:
                stats, to_q = _settle(body, q, move, shift)
        if stats < np.inf:
            q, a = to_q, body.accelerations(to_q)
            if not np.abs(q).max() <= MAX_COORDINATE:
                raise InputError(
                    f"equilibrium: the body would leave ±{MAX_COORDINATE:g} px; nothing stops it"
                )
            # In the end a step is Newton's, and the second iteration moves by next to nothing.
            calm = max(turned / _TURN, stats / _CONTRACTION)
            shift = max(shift * max(2.0 * calm, 1e-3), _LOWEST)
        elif shift < 1e6:
            shift = max(10.0 * shift, _LOWEST)
        else:
            shift, q, a = _search(body, q, a)
    body.refuse_shrunk(q)
    worst = int(np.argmax(np.abs(a)))
    index = worst % body.slots
    mass, force = (
        int(body.system.mass_order[index - 1]),
        abs(float(a[worst] / body.state.inverse_mass[index])),
    )
    raise InputError(
        f"equilibrium: no balance was found in {_MOST_STEPS} steps; {force:.3g} kg px/s² are left at mass "
        f"{mass}"
    )


def _settle(body: _Resting, q: Floats, move: Floats, shift: float) -> tuple[float, Floats]:
    """Newton's iterations for the end of an implicit step, of which `move` is the first.

    Returns:
        The length of the second in parts of the first, infinite if they do not converge; the end.
    """
    first = last = float(np.abs(move).max())
    stats = 0.0
    to_q = q + move
    for i in range(_ITERATIONS):
        if not body.factorise(to_q, shift):
            return np.inf, q
        rest = body.accelerations(to_q) - shift * (to_q - q)
        if (np.abs(rest) <= body.rounding(to_q)).all():
            return stats, to_q
        update = body.solve(rest)
        size = float(np.abs(update).max())
        if not size <= _CONTRACTION * last:
            return np.inf, q
        to_q = to_q + update
        stats = stats if i else size / first
        if size <= _SETTLED * first:
            return stats, to_q
        last = size
    return np.inf, q


def _search(body: _Resting, q: Floats, a: Floats) -> tuple[float, Floats, Floats]:
    """One step along the solution with the positive definite matrix, and the shift to go on with.

    It is halved until the power of the forces along it is no longer much below zero: until it does not go
    far beyond the valley.
    """
    shift = 1e-6
    body.factorise(q, shift, definite=True)
    move = body.solve(a)
    free = np.tile(body.state.inverse_mass, 2) > 0.0
    along = np.zeros(q.size)
    along[free] = move[free] / np.tile(body.state.inverse_mass, 2)[free]  # a times this is a power
    power = float(a @ along)
    part = min(1.0, _TURN / max(body.turn(q, move), 1e-300))
    to_q, to_a = q, a
    for _ in range(_HALVINGS):
        to_q = q + part * move
        to_a = body.accelerations(to_q)
        if float(to_a @ along) >= -0.5 * power:
            break
        part *= 0.5
    return shift, to_q, to_a
