"""The balance of a body in a given pose, with the forces of springs and joints as unknowns.

In a static pose, the forces on all free masses are linear in the tension T of each spring and the torque G of
each joint, under every force law. With the vector L = b - a of a spring as a complex number,

- a spring pulls with T L / |L| on its mass a, and with the opposite force on b;
- a joint of the springs A and B acts with i G A / |A|² on the b end of A and with the opposite force on its a
  end, and with -i G B / |B|² on the b end of B and with the opposite force on its a end. The forces of a
  joint along its springs are included in their T, see `sim.forces.joints`;
- a wall pushes a mass that touches it with P n, where n is its normal and P is not negative, and static
  friction, see `Wall`, acts with F i n.

The balance is B x = -f, with a column of B for each unknown and all other forces in f. The solution with the
smallest sum of T² / k + G² / (K |A||B|) is x = D Bᵀ l with (B D Bᵀ) l = -f, where D has k and K |A||B| on its
diagonal: it deforms springs and joints least. B D Bᵀ is the stiffness matrix of the body without prestress.
(Hsu et al. 2022, "A general two-stage initialization for sag-free deformable simulations", solve the same
problem for other force laws by descent.)
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..analysis.equilibrium import StaticModel
from ..forces.all import SURROUNDINGS
from ..forces.joints import IN_NUMPY, TUTORIAL, JointsReference
from ..forces.one_sided import ONE_SIDED, SIDES
from ..forces.rails import ways_of
from ..forces.springs import SpringsReference
from ..forces.touch.walls import WallRow, WallsReference
from ..scene.columns import ends
from ..scene.parts import constant_force
from ..scene.types import Grips

if TYPE_CHECKING:
    from scipy.sparse import csr_array
    from scipy.sparse.linalg import SuperLU

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
Bools = NDArray[np.bool_]
Vectors = NDArray[np.complex128]

MAX_BENT = math.radians(60.0)
"""Largest deflection of a joint, radians. Under the laws with a sine it gets softer the more it is bent, and
beyond 90 degrees its torque does not increase. Halved,
`test_a_joint_that_bears_too_much_is_named_with_the_stiffness_that_it_needs` fails."""
# Unless noted, doubling or halving one of these numbers fails no test.
_SHIFT = 1e-13
"""Shift of the diagonal of B D Bᵀ, relative to it, so that mechanisms do no harm."""
_PLAIN_SHIFT = 1e-7
"""The same, where the mechanism itself is sought."""
_REFINEMENTS = 12
"""Largest number of iterative refinements."""
BALANCED = 1e-10
"""Largest residual force on a mass in balance, as a fraction of the largest load on any mass."""
_EPSILON = 8.0 * float(np.finfo(float).eps)
"""Relative rounding error of the force of an unknown."""
_BISECTIONS = 54
"""Number of bisections that give an angle of up to 90 degrees to rounding error. Halved,
`test_presets_stand_as_they_were_drawn` fails."""
_NONE = 1e-20
"""Replacement for zeros on the diagonal of the augmented system, so that it has an inverse."""
_EXACT = 1e-13
"""Residual force, relative to the largest load, at which refinement ends."""


class Touch(NamedTuple):
    """Unknown forces of walls on masses that touch them or are in them: the mass, the wall, the direction,
    and whether that is along the wall, as for friction, and not along its normal."""

    mass: Indices
    wall: Indices
    way: Vectors
    along: Bools

    @classmethod
    def none(cls) -> Touch:
        """Return an empty `Touch`: nothing touches a wall."""
        return cls(np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0, complex), np.zeros(0, bool))

    def without(self, some: Bools) -> Touch:
        """Drop some of them, together with the friction between the same masses and walls."""
        gone = np.isin(self.mass + 1j * self.wall, self.mass[some] + 1j * self.wall[some])
        return Touch(self.mass[~gone], self.wall[~gone], self.way[~gone], self.along[~gone])


class Statics:
    """The balance of a scene's body in a pose.

    Args:
        body: the tables of a valid scene; their masses are at rest in its pose.
        at: (n,) the pose, px, in the order of the scene's masses.
        springs, joints: which springs and joints of the scene are unknowns. Forces of the others are in f.
        touching: the masses on which walls act with unknown forces; forces of walls on others are in f.

    Attributes:
        at: (n,) the pose, px.
        free: (n,) whether each mass is free.
        springs, joints: whether each spring and joint of the scene is an unknown: false if it has no
            stiffness or is broken.
        stiffness: (m,) D of all unknowns: of springs, of joints, and of touching masses.
        most: (m,) the largest load on each: for a spring the tension that would need a rest length of zero,
            for a joint the torque that bends it by `MAX_BENT`. Infinite for touching masses.
        is_spring: (m,) whether each is a spring.
        sides: (m,) 1 for what only pulls or acts above its rest angle only, -1 for the opposite, else 0.
        load: (2 f,) f, kg px/s²: x and y for each free mass, in the order in which they are eliminated.
        scale: the largest magnitude in `load` and among the weights.
    """

    def __init__(
        self, body: StaticModel, at: Vectors, springs: Bools, joints: Bools, touching: Touch
    ) -> None:
        self._body, self.at, self._touching = body, at, touching
        scene, system, tables = body.scene, body.system, body.tables
        self.free = body.state.inverse_mass[system.mass_index] > 0.0
        self._a, self._b = ends(scene.linear_springs)
        self._first, self._second = ends(scene.angular_springs)
        k = np.zeros(self._a.size)
        k[system.spring_order] = tables.stiffness[: tables.springs]
        self._k, self._vectors = k, at[self._b] - at[self._a]
        self._lengths = np.maximum(np.abs(self._vectors), 1e-300)
        self._size = tables.angular_stiffness[1:][system.joint_order]
        self._size = self._size * self._lengths[self._first] * self._lengths[self._second]  # K |A||B|
        self.springs, self.joints = springs & (k > 0.0), joints & (self._size > 0.0)
        self._has_energy, self._law = tables.law != TUTORIAL, IN_NUMPY[tables.law]
        bent = self._of_law(np.array([MAX_BENT]))[0][0]
        of_springs, of_joints = k[self.springs], self._size[self.joints]
        self.stiffness = np.concatenate((of_springs, of_joints, self._stiffness_of_walls()))
        self.most = np.concatenate(
            (
                of_springs * self._lengths[self.springs],
                bent * of_joints,
                np.full(touching.mass.size, np.inf),
            )
        )
        self.is_spring = np.arange(self.most.size) < of_springs.size
        unknown = itertools.chain(
            itertools.compress(scene.linear_springs, self.springs),
            itertools.compress(scene.angular_springs, self.joints),
        )
        self.sides = np.zeros(self.most.size)
        for k, part in enumerate(unknown):
            self.sides[k] = SIDES[part.only] if part.only else 0.0
        order = system.mass_order[body.matrix.order - 1]
        self._rows = order[self.free[order]]
        self.load = self._on_rails(self._known()[self._rows].view(np.float64).copy())
        pulls = np.array([mass.mass for mass in scene.masses])[self.free] * math.hypot(*scene.gravity)
        self.scale = max(float(np.abs(self.load).max(initial=0.0)), float(pulls.max(initial=0.0)))

    @property
    def grips(self) -> Grips | None:
        """Grips of static friction in the pose."""
        q = np.zeros(2 * self._body.slots)
        place = self._body.system.mass_index
        q[place], q[self._body.slots + place] = self.at.real, self.at.imag
        return self._body.grips(q)

    def _stiffness_of_walls(self) -> Floats:
        """Return (t,) the stiffness of a wall's push where it supports a touching mass's own weight, or of
        the friction that holds it along the wall, kg/s²."""
        touch, scene = self._touching, self._body.scene
        weights = np.array([scene.masses[i].mass for i in touch.mass])
        rows = self._body.tables.environment.walls.rows[touch.wall]
        hard, held = (rows[:, WallRow._fields.index(name)] for name in ("hardness", "tangential"))
        push = 2.0 * np.sqrt(hard * max(math.hypot(*scene.gravity), 1.0))
        return weights * np.where(touch.along, held, push)

    def _known(self) -> Vectors:
        """Return (n,) all forces except those of the unknowns, kg px/s²."""
        body, state, place = self._body, self._body.state, self._body.system.mass_index
        x = np.zeros(body.slots, complex)
        x[place] = self.at
        still, force = np.zeros_like(x), np.zeros_like(x)
        for term in SURROUNDINGS:
            if term is not ONE_SIDED:
                force += term.reference(body.tables, state).forces(x, still)
        order = body.system.spring_order
        springs = SpringsReference(body.tables, state, np.flatnonzero(~self.springs[order]))
        joints = JointsReference(body.tables, state, body.system.joint_order[~self.joints])
        for others in (springs, joints):
            force += others.forces(x, still, others.acting(x, still))
        weights = np.array([mass.mass for mass in body.scene.masses])
        known = force[place] + weights * complex(*body.scene.gravity)
        known += np.array([complex(*(constant_force(mass) or (0.0, 0.0))) for mass in body.scene.masses])
        # Forces of walls on touching masses are unknowns instead.
        for row, forces in enumerate(WallsReference(body.tables, state).force_of_each(x, still)):
            here = np.unique(self._touching.mass[self._touching.wall == row])
            known[here] -= forces[place][here]
        return known

    @cached_property
    def matrix(self) -> csr_array:
        """B."""
        from scipy.sparse import coo_array

        s, j, t = np.flatnonzero(self.springs), np.flatnonzero(self.joints), self._touching
        unit = self._vectors / self._lengths
        across = 1j * self._vectors / self._lengths**2
        of_joint = s.size + np.arange(j.size)
        first, second = self._first[j], self._second[j]
        mass = np.concatenate(
            (self._a[s], self._b[s], self._b[first], self._a[first], self._b[second], self._a[second], t.mass)
        )
        column = np.concatenate(
            (*([np.arange(s.size)] * 2), *([of_joint] * 4), s.size + j.size + np.arange(t.mass.size))
        )
        value = np.concatenate(
            (unit[s], -unit[s], across[first], -across[first], -across[second], across[second], t.way)
        )
        here = self.free[mass]
        place = np.zeros(self.free.size, np.int64)
        place[self._rows] = np.arange(self._rows.size)
        row = 2 * place[mass[here]]
        rows = np.concatenate((row, row + 1))
        columns, values = np.tile(column[here], 2), np.concatenate((value[here].real, value[here].imag))
        shape = self.load.size, self.stiffness.size
        return self._on_rails(coo_array((values, (rows, columns)), shape).tocsr())

    def _on_rails(self, forces: Any) -> Any:
        """Return forces, with rows as `load`, without what rails take: all that is across them."""
        rails = ways_of(self._body.tables)
        if not rails:
            return forces
        from scipy.sparse import block_diag

        slots = self._body.system.mass_index[self._rows].tolist()
        ways = [np.array(rails[slot]) if slot in rails else None for slot in slots]
        blocks = [np.eye(2) if way is None else np.outer(way, way) for way in ways]
        return block_diag(blocks, format="csr") @ forces

    def solve(self, stiffness: Floats, target: Floats | float = 0.0) -> Floats | None:
        """Return the unknowns in balance that are closest to a target, (m,), or None if there is no balance.

        Args:
            stiffness: (m,) D; unknowns with zero stay at the target.
            target: (m,) the desired values.
        """
        start = np.zeros(self.stiffness.size) + target
        if self.is_balanced(start) or not stiffness.any():
            return start if self.is_balanced(start) else None
        factors, weighted = self._factors(stiffness, _SHIFT)
        x = self._refined(start, lambda left: -(weighted @ factors.solve(left)))
        if self.is_balanced(x):
            return x
        try:
            x = self._refined(start, self._augmented(stiffness))
        except RuntimeError:  # a pivot is zero
            return None
        return x if self.is_balanced(x) else None

    def without_slack(self, x: Floats | None) -> Floats | None:
        """Return loads in balance in which no rope pushes and no stop pulls, or None if none are found.

        What would do so bears nothing from now on; the others take over.

        Args:
            x: loads in balance, or None.
        """
        while x is not None and (wrong := self.sides * x < -BALANCED * self.scale).any():
            self.stiffness[wrong] = 0.0
            x = self.solve(self.stiffness)
        return x

    def _refined(self, x: Floats, correction: Callable[[Floats], Floats]) -> Floats:
        """Refine iteratively: correct the unknowns for the residual forces, as long as these shrink."""
        worst = np.inf
        for _ in range(_REFINEMENTS):
            left = self.load + self.matrix @ x
            size = float(np.abs(left).max())
            if size <= _EXACT * self.scale or not size < 0.9 * worst:
                break
            worst = size
            x = x + correction(left)
        return x

    def is_balanced(self, x: Floats) -> bool:
        """Return whether unknowns balance the load, to `BALANCED` of the largest or to rounding error."""
        left = np.abs(self.load + self.matrix @ x)
        return bool((left <= BALANCED * self.scale + _EPSILON * (abs(self.matrix) @ np.abs(x))).all())

    def _augmented(self, stiffness: Floats) -> Callable[[Floats], Floats]:
        """Return corrections by the system of unknowns and multipliers, for long chains: its condition number
        is the square root of that of B D Bᵀ.

            [ I   Aᵀ ] [ y ]   [  0 ]
            [ A   0  ] [ l ] = [ -f ]   with A = B sqrt(D) and x = sqrt(D) y.
        """
        from scipy.sparse import block_array, diags_array, eye_array
        from scipy.sparse.linalg import splu

        root = np.sqrt(stiffness)
        a = self.matrix @ diags_array(root)
        size = float(abs(a).max())
        a = a / size
        none = eye_array(self.load.size) * -_NONE
        factors = splu(block_array([[eye_array(root.size), a.T], [a, none]]).tocsc())
        zeros = np.zeros(root.size)
        return lambda left: root * factors.solve(np.concatenate((zeros, -left / size)))[: root.size]

    def _factors(self, stiffness: Floats, shift: float, evenly: bool = False) -> tuple[SuperLU, csr_array]:
        """Return the factorisation of B D Bᵀ, and D Bᵀ.

        Args:
            stiffness: (m,) D.
            shift: added to the diagonal, relative to each element.
            evenly: makes it relative to the largest element instead.
        """
        from scipy.sparse import diags_array
        from scipy.sparse.linalg import splu

        weighted = (diags_array(stiffness) @ self.matrix.T).tocsr()
        square = (self.matrix @ weighted).tocsc()
        diagonal = square.diagonal()
        typical = float(diagonal.max(initial=0.0)) or 1.0
        added = typical if evenly else np.where(diagonal > 0.0, diagonal, typical)
        shifted = (square + diags_array(np.full(diagonal.size, shift * added))).tocsc()
        options = {"SymmetricMode": True}
        return splu(shifted, permc_spec="NATURAL", diag_pivot_thresh=0.0, options=options), weighted

    def mechanism(self) -> Vectors:
        """Return (n,) the part of the load that no unknown can balance, kg px/s²: an unresisted motion."""
        left = self.load.copy()
        if self.stiffness.any():
            # With the same shift everywhere, the remainder is orthogonal to all that can be balanced.
            factors, weighted = self._factors(self.stiffness, _PLAIN_SHIFT, evenly=True)
            for _ in range(_REFINEMENTS):
                left = left - self.matrix @ (weighted @ factors.solve(left))
        motion = np.zeros(self.free.size, complex)
        motion[self._rows] = left.view(complex)
        return motion

    def share(self, x: Floats) -> Floats:
        """Return (m,) the load on each unknown over its largest; compression of springs is not limited."""
        return np.where(self.is_spring, x, np.abs(x)) / self.most

    def most_even(self) -> Floats | None:
        """Return (m,) the unknowns in balance with the smallest maximum `share`, by a linear program; None
        if it finds none."""
        from scipy.optimize import linprog
        from scipy.sparse import csr_array, diags_array, eye_array, hstack, vstack

        count = self.most.size
        borne = self.matrix @ diags_array(self.most) / self.scale
        balance = hstack((borne, csr_array((self.load.size, 1)))).tocsr()
        bent = int((~self.is_spring).sum())
        below = hstack((eye_array(count), np.full((count, 1), -1.0)))
        above = hstack((-eye_array(bent, count, k=count - bent), np.full((bent, 1), -1.0)))
        result = linprog(
            np.concatenate((np.zeros(count), (1.0,))),
            A_ub=vstack((below, above)).tocsr(), b_ub=np.zeros(count + bent),
            A_eq=balance, b_eq=-self.load / self.scale,
            bounds=[(None, None)] * count + [(0.0, None)], method="highs",
        )  # fmt: skip
        # Its solution is accurate to about 1e-7 only.
        return self.solve(self.stiffness, result.x[:-1] * self.most) if result.success else None

    def rest(self, x: Floats, stiffening: float) -> tuple[Floats, Floats]:
        """Return the rest length of each spring, px, and the rest angle of each joint, degrees; NaN for those
        that are not unknowns.

        With d = asin(G / (K |A||B|)), or without the arcsine under the angle law, the rest angle is V - d,
        where V is the angle from A to B. Under a law with an energy the joint pulls on its spring A with its
        energy over |A|; what is left of T gives the rest length |A| - T / k.

        Args:
            x: (m,) the unknowns.
            stiffening: factor of their stiffness.
        """
        springs = int(self.is_spring.sum())
        tension, bend = np.full(self.springs.size, np.nan), np.full(self.joints.size, np.nan)
        tension[self.springs] = x[:springs]
        size = self._size * stiffening
        bend[self.joints] = x[springs : springs + int(self.joints.sum())] / size[self.joints]
        off = self._deflection(bend)
        if self._has_energy:
            energy = size * self._of_law(off)[1]
            for one in (self._first, self._second):
                pull = np.where(self.joints, energy / self._lengths[one], 0.0)
                tension -= np.bincount(one, pull, tension.size)
        angle = np.angle(self._vectors[self._first].conj() * self._vectors[self._second]) - off
        stiff = np.where(self.springs, self._k * stiffening, 1.0)
        return self._lengths - tension / stiff, np.degrees(angle)

    def _of_law(self, off: Floats) -> tuple[Floats, Floats]:
        """Return the torque and energy of joints with K |A||B| = 1 that are bent by some angles, radians."""
        return self._law(np.exp(1j * off))

    def _deflection(self, bend: Floats) -> Floats:
        """Return the angles, radians, at which joints have some torques, as fractions of K |A||B|: by
        bisection between -90 and 90 degrees, where the torque of every law increases."""
        low, high = np.full(bend.shape, -0.5 * math.pi), np.full(bend.shape, 0.5 * math.pi)
        for _ in range(_BISECTIONS):
            middle = 0.5 * (low + high)
            below = self._of_law(middle)[0] < bend
            low, high = np.where(below, middle, low), np.where(below, high, middle)
        return np.where(np.isfinite(bend), 0.5 * (low + high), bend)

    def name_of(self, unknown: int) -> tuple[str, int]:
        """Return the kind of an unknown, "spring" or "joint", and its index in the scene."""
        springs = np.flatnonzero(self.springs)
        if unknown < springs.size:
            return "spring", int(springs[unknown])
        return "joint", int(np.flatnonzero(self.joints)[unknown - springs.size])

    def connected(self, mass: int) -> Bools:
        """Return (n,) whether springs and joints with any stiffness connect each mass with a given one."""
        from scipy.sparse import coo_matrix
        from scipy.sparse.csgraph import connected_components

        s, j = np.flatnonzero(self._k > 0.0), np.flatnonzero(self._size > 0.0)
        one = np.concatenate((self._a[s], self._a[self._first[j]]))
        other = np.concatenate((self._b[s], self._a[self._second[j]]))
        graph = coo_matrix((np.ones(one.size), (one, other)), (self.free.size,) * 2)
        part = connected_components(graph, directed=False)[1]
        return part == part[mass]
