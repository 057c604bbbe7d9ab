"""The static equilibrium of a body."""

from __future__ import annotations

import warnings
from functools import cached_property

import msgspec
import numpy as np

from ..compiling.compiler import fetch, for_balance
from ..engine.tables import Floats, Indices, Matrix
from ..errors import InputError, of_field
from ..forces.all import TERMS, accelerations
from ..forces.joints import JointsReference
from ..forces.plasticity import NO_LIMITS
from ..forces.reference import Physics
from ..forces.springs import SpringsReference
from ..forces.touch.contact import no_tunnelling
from ..forces.touch.walls import NOWHERE, WallRow, place_along
from ..model.sparsity import new_matrix
from ..model.state import grips_of, new_scratch, start_of
from ..model.system import build_system, damage_of, for_analysis
from ..scene.numbers import MAX_COORDINATE
from ..scene.types import Grips, Pose, Scene
from ..scene.validate import validate
from ..solve.linear.implicit import factorise_matrix, solve_matrix
from ..text import Text

# Unless noted, doubling or halving one of these numbers fails no test.
_MAX_STEPS = 3000
"""Largest number of steps."""
_STUCK = 1000
"""Number of steps after which another start is tried."""
_MAX_ROTATION = 0.5
"""Largest relative displacement of a spring's ends in a step, as a fraction of its length."""
_CONTRACTION = 0.5
"""Largest size of each iteration of a step relative to the one before."""
_ITERATIONS = 6
"""Largest number of iterations in a step."""
_SETTLED = 0.02
"""Size of an iteration, relative to the first, at which a step has converged."""
_PRECISION = 1e-12
"""Size of a step, in typical spring lengths, at which the search ends."""
_LOWEST = 1e-15
"""Smallest shift that is tried, 1/s²."""
NEUTRAL = 1e-13
"""Largest shift, 1/s², that a stable body with held masses may need for its matrix to be definite in spite of
rounding."""
NEUTRAL_FREE = 1e-9
"""The same for a body that is free to move as a whole."""
_CLOSE = 1e-5
"""Size of a step, in typical spring lengths, at which the forces balance; if the balance is unstable, the
body is nudged."""
_NUDGE = 1e-3
"""Size of a nudge, in typical spring lengths."""
_NUDGES = 5
"""Largest number of nudges."""
_HALVINGS = 60
"""Largest number of halvings in a line search."""
_OVER = 1e-6
"""Relative overload of a part that cannot be due to rounding."""
_EPSILON = 4.0 * float(np.finfo(float).eps)
"""Assumed relative rounding error."""
_TRIALS = 4
"""Number of trials for the rounding errors of the surroundings."""
_MAGNIFIED = 1e3
"""Errors of coordinates in a trial, relative to rounding errors."""


def equilibrium(scene: Scene) -> Pose:
    """Find the pose at rest that a scene would creep into if everything were heavily damped.

    The search starts from the scene's pose, or from the masses' own positions. Held masses stay there,
    including those on circles. The springs are those of the scene, whatever its method.

    The algorithm is pseudo-transient continuation (Kelley & Keyes 1998): steps of implicit Euler, each from
    rest, which grow longer and finally become Newton's method. Each step is solved by Newton's iterations
    with the analytic Jacobian; the first one is the linearly implicit step. Their rate of convergence
    determines the length of the next step. No energy is needed, so this works for every force law. A step may
    not be so long that the matrix is indefinite, so the body leaves an unstable balance. Where no step
    converges, the positive definite matrix and a line search are used.

    Whatever is broken or has yielded in the scene's pose stays so, and nothing else breaks or yields. If a
    part would, because its load exceeds its strength, yield force or yield torque, a `UserWarning` names it.

    The wind is the mean wind, without gusts. Friction with tangential springs, see `Wall`, supports whatever
    touches something, from the point of contact at the end of a step; other friction creeps and cannot
    support anything at rest. Stability is judged without the coupling between touching masses and springs.

    Args:
        scene: a valid scene. There is no equilibrium if spring forces cannot balance gravity and constant
            forces.

    Returns:
        Positions in px, zero velocities, the damage of the scene's pose, and the grips of friction. Positions
        are as accurate as rounding and the softness of the body permit: usually within 1e-9 of a spring's
        length, less for long bodies with springs more than 1e5 times as stiff as their joints.

    Raises:
        SceneError: the scene is not valid.
        InputError: a loaded part of the body is unsupported, or the steps do not end in a balance.
    """
    pose, overloads = loaded_equilibrium(scene)
    for sentence in overloads:
        warnings.warn(f"equilibrium: {sentence}", stacklevel=2)
    return pose


def loaded_equilibrium(scene: Scene) -> tuple[Pose, list[str]]:
    """Find the `equilibrium` and describe what would break or yield in it, one sentence per kind."""
    body = StaticModel(scene, balanced=True)
    body.refuse_falling()
    q = _continuation(body)
    body.refuse_shrunk(q)
    return body.pose(q), body.overloads(q)


class StaticModel:
    """The tables of a scene's body, with solvers for the Jacobian of its accelerations.

    Vectors are flat: x of every slot, then y of every slot.

    Args:
        scene: the scene.
        balanced: whether each mass (in kg) is replaced by the stiffnesses acting on it (in kg/s²), as in
            dynamic relaxation. The equilibrium depends on weights only, and all masses then move about
            equally fast: eigenvalues of the Jacobian are of the order of 1/s².
    """

    def __init__(self, scene: Scene, balanced: bool) -> None:
        scene = for_analysis(validate(scene))
        wind = scene.wind and msgspec.structs.replace(scene.wind, turbulence=0.0)
        scene = msgspec.structs.replace(scene, wind=wind)
        self.scene = scene
        self.system, self.state = start_of(scene, build_system(scene))
        body = self.tables = self.system.body.replaced(limits=NO_LIMITS)  # nothing yields during the search
        fetch(for_balance(body))
        self.surrounded = bool(body.environment.present)
        self.scratch = new_scratch(self.system)
        state, here = self.state, slice(1, body.masses + 1)
        free = np.where(self.system.held, 0.0, 1.0)
        weight = 1.0 / self.system.inverse_mass
        state.inverse_mass[here] = free * (1.0 / self._stiffness_at_masses() if balanced else 1.0 / weight)
        forces = np.outer(scene.gravity, weight) + (0.0 if self.system.loads is None else self.system.loads)
        state.gx[here], state.gy[here] = state.inverse_mass[here] * forces
        self._sticks = body.environment.sticks
        self.slots = state.x.size
        self.start = np.zeros(2 * self.slots)
        self.start[here], self.start[self.slots :][here] = self.system.start[:2]
        self.still = np.zeros(2 * self.slots)
        self.update_friction_history(self.start)
        lengths = body.rest_length[: body.springs] * scene.rest_length_scale
        self.typical = max(float(np.median(lengths)) if body.springs else 1.0, 1e-3)

    @cached_property
    def matrix(self) -> Matrix:
        """Storage for its factorised linear systems."""
        return new_matrix(self.tables, self.system.held)

    def _stiffness_at_masses(self) -> Floats:
        """Return (n,) the sum of the stiffnesses at each mass, kg/s²; never zero."""
        body = self.tables
        own = body.stiffness[: body.springs].copy()
        for joints in (body.joint_a, body.joint_b):
            np.add.at(own, joints, 2.0 * body.joint_stiffness)
        at_mass = np.zeros(body.masses + 1)
        for masses in (body.spring_a, body.spring_b):
            np.add.at(at_mass, masses, own)
        return np.where(at_mass[1:] > 0.0, at_mass[1:], max(1.0, float(at_mass.max())))

    @property
    def slides(self) -> bool:
        """Whether there is anything that a part can fall on and slide along."""
        environment = self.tables.environment
        return bool(environment.touches)

    @property
    def _is_held(self) -> bool:
        """Whether something besides held masses can keep a part in place."""
        return any(TERMS[index].holds for index in self.tables.environment.acting)

    @property
    def creeps(self) -> bool:
        """Whether some friction cannot support anything at rest."""
        environment = self.tables.environment
        walls, contact = self.scene.walls, environment.contact
        return any(wall.friction and not wall.tangential_hardness for wall in walls) or (
            bool(contact.present) and contact.tangential == 0.0
        )

    def refuse_falling(self) -> None:
        """Raise an error if a part is connected to no held mass, unless something else can hold it.

        Broken springs connect nothing. A part whose gravity and constant forces balance is accepted.
        """
        if self._is_held:
            return
        state, part = self.state, self.parts()
        free = state.inverse_mass[: part.size] > 0.0
        force = np.zeros(part.size, complex)
        force[free] = (state.gx + 1j * state.gy)[: part.size][free] / state.inverse_mass[: part.size][free]
        net, size = np.zeros(part.size, complex), np.zeros(part.size)
        np.add.at(net, part, force)
        np.add.at(size, part, np.abs(force))
        net[part[1:][self.system.held]] = 0.0
        net[part[self.tables.environment.rails.slot]] = 0.0
        falling = np.flatnonzero(np.isin(part, np.flatnonzero(np.abs(net) > _OVER * size)))
        if falling.size:
            first = falling[np.argmin(self.system.mass_order[falling - 1])]
            broken = np.concatenate((self.tables.spring_a, self.tables.spring_b))[np.tile(self._broken, 2)]
            is_broken, falls = bool(np.isin(part[first], part[broken])), any(self.scene.gravity)
            mass = int(self.system.mass_order[first - 1])
            if is_broken and falls:
                why = Text("only broken springs hold mass {mass}, so it falls", mass=mass)
            elif is_broken:
                why = Text("only broken springs hold mass {mass}, so it moves away", mass=mass)
            elif falls:
                why = Text("nothing holds mass {mass}, so it falls", mass=mass)
            else:
                why = Text("nothing holds mass {mass}, so it moves away", mass=mass)
            raise InputError(of_field("equilibrium", why))

    @property
    def _broken(self) -> np.ndarray:
        """(S,) whether each spring is broken."""
        return self.state.broken > 0.0 if self.state.broken.size else np.zeros(self.tables.springs, bool)

    def parts(self) -> Indices:
        """Return the (n + 1,) part of each slot's mass, identified by its lowest slot.

        A part consists of masses connected by intact springs.
        """
        a, b = (
            ends[: self.tables.springs][~self._broken]
            for ends in (self.tables.spring_a, self.tables.spring_b)
        )
        part = np.arange(self.tables.masses + 1)
        while (part[a] != part[b]).any():
            low = np.minimum(part[a], part[b])
            for ends in (a, b):
                np.minimum.at(part, part[ends], low)
            part = part[part]
        return part

    @cached_property
    def _physics(self) -> Physics:
        return Physics(self.tables, self.state)

    def update_friction_history(self, q: Floats) -> None:
        """Let friction grip whatever touches something at positions q, as after a step of a run.

        For masses that do not touch a wall yet, the grip is at the current position, since the way to a wall
        is a single long step.
        """
        if not self._sticks:
            return
        state = self.state
        self._physics.update_friction_history(
            q[: self.slots] + 1j * q[self.slots :], np.zeros(self.slots, complex)
        )
        for row, place in zip(self.tables.environment.walls.rows, state.wall_place, strict=False):
            wall = WallRow(*row)
            if wall.tangential:
                along = place_along(row, q[: self.slots], q[self.slots :])
                np.copyto(place, along, where=place >= NOWHERE)

    def grips(self, q: Floats) -> Grips | None:
        """Return the grips of everything that touches something at positions q."""
        if not self._sticks:
            return None
        self._physics.update_friction_history(
            q[: self.slots] + 1j * q[self.slots :], np.zeros(self.slots, complex)
        )
        return grips_of(self.state, self.system)

    def accelerations(self, q: Floats) -> Floats:
        """Return the accelerations at positions q and at rest, px/s²."""
        a = np.zeros_like(q)
        accelerations(self.tables, self.state, self.scratch, q, self.still, a)
        return a

    def factorise(self, q: Floats, shift: float, definite: bool = False) -> bool:
        """Factorise shift I - J at positions q; return whether it is positive definite.

        Without pivoting between blocks, a matrix that is symmetric apart from the masses is positive definite
        if and only if all its pivots are. (Under the tutorial's law it is slightly unsymmetric.) Fillings of
        large loops add products of vectors, which make as many of its eigenvalues positive as their own small
        matrix has negative ones (Haynsworth 1968). The blocks that couple a mass to a spring it touches are
        not among the pivots and are ignored here.
        """
        matrix = self.matrix
        if not factorise_matrix(self.tables, self.state, matrix, q, self.still, shift, 0.0, definite):
            return False
        inverse = matrix.blocks.reshape(-1, 4)[matrix.diagonal]
        xx, xy, yx, yy = inverse[self.state.inverse_mass[matrix.order] > 0.0].T
        both, one = xx + yy < 0.0, xx * yy - xy * yx < 0.0
        negative = int(np.where(one, 1, 2 * both).sum())
        if matrix.bordered.size:
            negative -= int((np.linalg.eigvals(matrix.corrections[:-1]).real < 0.0).sum())
        return negative == 0

    def solve(self, b: Floats) -> Floats:
        """Return the solution with the last factors."""
        x = b.copy()
        solve_matrix(self.tables, self.state, self.matrix, x)
        return x

    def vectors(self, q: Floats) -> tuple[Floats, Floats]:
        """Return (S,) x and y of the springs' vectors, px."""
        a, b, p = self.tables.spring_a, self.tables.spring_b, self.slots
        return q[b] - q[a], q[p + b] - q[p + a]

    def turn(self, q: Floats, move: Floats) -> float:
        """Return the largest relative displacement of a spring's ends, as a fraction of its length."""
        if not self.tables.springs:
            return 0.0
        lengths = np.maximum(np.hypot(*self.vectors(q)), 1e-3 * self.typical)
        return float((np.hypot(*self.vectors(move)) / lengths).max())

    def no_tunnelling(self, q: Floats, to_q: Floats) -> bool:
        """Return whether no mass can have passed through a spring it touches on the way from q to to_q."""
        return not self.tables.environment.contact.present or bool(no_tunnelling(self.tables, q, to_q))

    def nudge(self, q: Floats, size: float) -> Floats:
        """Return the positions with every free mass displaced at random by up to `size` typical lengths."""
        noise = np.random.default_rng(1).uniform(-1.0, 1.0, q.size)
        return q + size * self.typical * noise * (np.tile(self.state.inverse_mass, 2) > 0.0)

    def rounding(self, q: Floats) -> Floats:
        """Return a bound on the rounding errors of accelerations at positions q, px/s².

        The rounding errors of coordinates are proportional to their size. Springs turn them into forces
        mainly along themselves, joints into forces in all directions.
        """
        body, p = self.tables, self.slots
        x, y = self.vectors(q)
        length = np.maximum(np.hypot(x, y), 1e-300)
        rest_tension = self.state.rest_tension[: body.springs]
        across = np.abs(rest_tension / length - body.stiffness[: body.springs])
        for one, other in ((body.joint_a, body.joint_b), (body.joint_b, body.joint_a)):
            np.add.at(across, one, 4.0 * body.joint_stiffness * (1.0 + length[other] / length[one]))
        along = body.stiffness[: body.springs] + rest_tension / length
        size = _EPSILON * (float(np.abs(q).max()) + length)
        force = np.zeros(q.size)
        for masses in (body.spring_a, body.spring_b):
            np.add.at(force, masses, size * (along * np.abs(x) / length + across))
            np.add.at(force, p + masses, size * (along * np.abs(y) / length + across))
        gravity = np.concatenate((np.abs(self.state.gx), np.abs(self.state.gy)))
        bound = force * np.tile(self.state.inverse_mass, 2) + _EPSILON * gravity
        return bound + self._rounding_around(q) if self.surrounded else bound

    def _rounding_around(self, q: Floats) -> Floats:
        """Return the rounding errors added by surroundings, found by trial with much larger errors."""
        size = _EPSILON * float(np.abs(q).max())
        signs = np.random.default_rng(2).choice((-1.0, 1.0), (_TRIALS, q.size))
        here = self.accelerations(q)
        changes = [self.accelerations(q + _MAGNIFIED * size * some) - here for some in signs]
        return 2.0 * np.abs(changes).max(0) / _MAGNIFIED

    def refuse_shrunk(self, q: Floats) -> None:
        """Raise an error if a spring has shrunk to a point, as may happen under some force laws."""
        lengths = np.hypot(*self.vectors(q))
        for s in np.flatnonzero(lengths < 1e-9 * max(self.typical, 1.0)).tolist():
            ends = (int(self.tables.spring_a[s]), int(self.tables.spring_b[s]))
            a, b = sorted(int(self.system.mass_order[slot - 1]) for slot in ends)
            raise InputError(
                of_field(
                    "equilibrium",
                    Text("the spring between masses {a} and {b} shrinks to no length", a=a, b=b),
                )
            )

    def overloads(self, q: Floats) -> list[str]:
        """Describe what would break or yield at positions q and at rest, in one sentence for each kind."""
        limits, state, unit = self.system.body.limits, self.state, self.scene.view.unit
        if not limits.present:
            return []
        still = np.zeros(self.slots, complex)
        x = q[: self.slots] + 1j * q[self.slots :]
        springs, joints = self.system.spring_order, np.argsort(self.system.joint_order)
        force = np.abs(SpringsReference(self.tables, state).pulls(x, still))
        torque = np.abs(JointsReference(self.tables, state).torques(x, still))
        ways = (
            ("breaks", springs, force, limits.breaking),
            ("yields", springs, force, limits.yielding + state.hardened),
            ("bends", joints, torque, limits.bending),
        )
        sentences: list[str] = []
        for how, order, load, limit in ways:
            over = np.flatnonzero(load > (1.0 + _OVER) * limit)
            if over.size:
                worst = int(over[np.argmax(load[over] / limit[over])])
                said = _overload(
                    how,
                    bool(over.size > 1),
                    index=int(order[worst]),
                    more=int(over.size) - 1,
                    load=float(load[worst]),
                    unit=unit,
                    limit=float(limit[worst]),
                )
                sentences.append(said)
        return sentences

    def by_mass(self, q: Floats) -> tuple[Floats, Floats]:
        """Return (n,) x and y of each mass, in the order of the scene's masses."""
        index = self.system.mass_index
        return q[index], q[self.slots + index]

    def pose(self, q: Floats) -> Pose:
        """Return the positions as a pose at rest."""
        x, y = (part.tolist() for part in self.by_mass(q))
        return Pose(
            positions=tuple(zip(x, y, strict=True)),
            velocities=((0.0, 0.0),) * len(x),
            damage=damage_of(self.scene),
            grips=self.grips(q),
        )


def _continuation(body: StaticModel) -> Floats:
    """Find positions at which the accelerations vanish."""
    q = body.start
    neutral = NEUTRAL if body.system.held.any() else NEUTRAL_FREE
    a = body.accelerations(q)
    first = shift = float(np.abs(a).max()) / body.typical + _LOWEST
    nudges = balanced = 0
    for number in range(_MAX_STEPS):
        if number and number % _STUCK == 0:
            # A crumpled body may alternate between two folds; from another start it folds differently.
            q = body.nudge(body.start, number // _STUCK * _NUDGE)
            a, shift, nudges, balanced = body.accelerations(q), first, 0, 0
        if (np.abs(a) <= body.rounding(q)).all():
            # A few more steps reach the accuracy that rounding permits.
            balanced += shift <= 1e4 * neutral
            if balanced == 8:
                return q
        ratio, turned, to_q = np.inf, 0.0, q
        if body.factorise(q, shift):
            move = body.solve(a)
            size = float(np.abs(move).max()) / body.typical
            if size <= _CLOSE and nudges < _NUDGES and not body.factorise(q, neutral):
                # An unstable balance, or close to one.
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
            if turned <= _MAX_ROTATION:
                ratio, to_q = _settle(body, q, move, shift)
                if not body.no_tunnelling(q, to_q):
                    ratio = np.inf
        if ratio < np.inf:
            q = to_q
            body.update_friction_history(q)
            a = body.accelerations(q)
            if not np.abs(q).max() <= MAX_COORDINATE:
                raise InputError(
                    of_field(
                        "equilibrium",
                        Text(
                            "the body would leave ±{most:g} px; nothing stops it, and friction that creeps "
                            "holds nothing that is at rest",
                            most=MAX_COORDINATE,
                        )
                        if body.creeps
                        else Text("the body would leave ±{most:g} px; nothing stops it", most=MAX_COORDINATE),
                    )
                )
            # Finally each step is one of Newton's method, whose second iteration hardly moves.
            calm = max(turned / _MAX_ROTATION, ratio / _CONTRACTION)
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
        of_field(
            "equilibrium",
            Text(
                "no balance was found in {most} steps; {force:.3g} kg px/s² are left at mass {mass}",
                most=_MAX_STEPS,
                force=force,
                mass=mass,
            ),
        )
    )


def _settle(body: StaticModel, q: Floats, move: Floats, shift: float) -> tuple[float, Floats]:
    """Solve an implicit step by Newton's iterations; `move` is the first.

    Returns:
        The size of the second iteration relative to the first, infinite if they do not converge; and the
        positions at the end.
    """
    first = last = float(np.abs(move).max())
    ratio = 0.0
    to_q = q + move
    for i in range(_ITERATIONS):
        if not body.factorise(to_q, shift):
            return np.inf, q
        rest = body.accelerations(to_q) - shift * (to_q - q)
        if (np.abs(rest) <= body.rounding(to_q)).all():
            return ratio, to_q
        update = body.solve(rest)
        size = float(np.abs(update).max())
        if not size <= _CONTRACTION * last:
            return np.inf, q
        to_q = to_q + update
        ratio = ratio if i else size / first
        if size <= _SETTLED * first:
            return ratio, to_q
        last = size
    return np.inf, q


def _search(body: StaticModel, q: Floats, a: Floats) -> tuple[float, Floats, Floats]:
    """Take one step along the solution with the positive definite matrix.

    The step is halved until the power of the forces along it is no longer strongly negative, so that it does
    not go far beyond the minimum.

    Returns:
        The shift to continue with, the positions, and the accelerations there.
    """
    shift = 1e-6
    body.factorise(q, shift, definite=True)
    move = body.solve(a)
    if not np.isfinite(move).all():  # the iteration for contact has not converged
        move = a
    free = np.tile(body.state.inverse_mass, 2) > 0.0
    along = np.zeros(q.size)
    along[free] = move[free] / np.tile(body.state.inverse_mass, 2)[free]  # times a, this is a power
    power = float(a @ along)
    part = min(1.0, _MAX_ROTATION / max(body.turn(q, move), 1e-300))
    to_q, to_a = q, a
    for _ in range(_HALVINGS):
        to_q = q + part * move
        to_a = body.accelerations(to_q)
        if float(to_a @ along) >= -0.5 * power and body.no_tunnelling(q, to_q):
            break
        part *= 0.5
    return shift, to_q, to_a


def _overload(how: str, several: bool, **parts: object) -> Text:
    """Return the sentence for springs or joints that would not stand the load at rest."""
    match how, several:
        case "breaks", False:
            return Text(
                "spring {index} would break in the pose at rest: {load:.4g} kg {unit}/s² is more than its "
                "strength of {limit:.4g}",
                **parts,
            )
        case "breaks", True:
            return Text(
                "spring {index} and {more} more would break in the pose at rest: {load:.4g} kg {unit}/s² is "
                "more than its strength of {limit:.4g}",
                **parts,
            )
        case "yields", False:
            return Text(
                "spring {index} would yield in the pose at rest: {load:.4g} kg {unit}/s² is more than its "
                "yield force of {limit:.4g}",
                **parts,
            )
        case "yields", True:
            return Text(
                "spring {index} and {more} more would yield in the pose at rest: {load:.4g} kg {unit}/s² is "
                "more than its yield force of {limit:.4g}",
                **parts,
            )
        case _, False:
            return Text(
                "joint {index} would yield in the pose at rest: {load:.4g} kg {unit}²/s² is more than its "
                "yield torque of {limit:.4g}",
                **parts,
            )
        case _:
            return Text(
                "joint {index} and {more} more would yield in the pose at rest: {load:.4g} kg {unit}²/s² is "
                "more than its yield torque of {limit:.4g}",
                **parts,
            )
