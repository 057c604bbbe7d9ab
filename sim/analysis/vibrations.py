"""Small vibrations of a body about a pose."""

from __future__ import annotations

import contextlib
import math
import warnings
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..engine.tables import Floats, Indices
from ..errors import InputError, of_field
from ..scene.types import Scene
from ..text import Text
from .equilibrium import StaticModel

if TYPE_CHECKING:
    from scipy.sparse import csr_array

MAX_MASSES = 1000
"""Largest number of masses for vibrations, which are computed with full matrices."""
_NOT_HELD = of_field(
    "vibrations",
    Text(
        "the springs do not hold the body where it starts, so it does not vibrate there; sim.equilibrium "
        "finds where they do"
    ),
)
# Unless noted, doubling or halving one of these numbers fails no test.
_BALANCED = 1e-6
"""Acceleration, relative to the largest from gravity or loads, up to which a body counts as at rest."""
_ROUNDED = 100.0
"""Residual acceleration allowed in addition, in bounds of the rounding errors."""
_SHIFT = 1.0
"""Shift of the squared angular frequencies, 1/s², which makes the matrix of a free body invertible."""
NOTHING = 1e-3
"""Squared angular frequency, 1/s², up to which a motion counts as unresisted."""
_FEW, _MANY = 6, 120
"""Arnoldi's method finds the slowest vibrations if there are at least `_MANY` and at most one in `_FEW` of
them is wanted."""


class Vibrations(NamedTuple):
    """Small undamped vibrations, slowest first.

    Attributes:
        omega: (k,) angular frequencies, rad/s.
        shapes: (k, n, 2) amplitude of each mass relative to the largest; signs are arbitrary.
    """

    omega: Floats
    shapes: Floats

    @property
    def frequencies(self) -> Floats:
        """(k,) frequencies, Hz."""
        return self.omega / math.tau


def vibrations(scene: Scene, count: int) -> Vibrations:
    """Find the slowest small vibrations about the scene's start, which should be an equilibrium.

    The effect of stresses from gravity and loads is included only about the loaded equilibrium, as after
    `msgspec.structs.replace(scene, pose=sim.equilibrium(scene))`. A `UserWarning` is issued if the forces do
    not balance at the start.

    The vibrations follow from the eigenvalues of the inverse of the Jacobian of the accelerations with
    respect to positions, so the slow ones are accurate however stiff the body is. A few out of many are found
    by Arnoldi's method. Damping and air friction are ignored.

    Args:
        scene: a valid scene of at most 1000 masses.
        count: number of vibrations, from 1 to twice the number of free masses, those on rails
            counted once.

    Raises:
        SceneError: the scene is not valid.
        InputError: the count or the number of masses is out of range, or the body can move without any
            restoring force or leaves its start by itself, so that its motion there is no vibration.
    """
    body = _checked(scene, count)
    pulls = np.concatenate((body.state.gx, body.state.gy))
    small = _BALANCED * float(np.abs(pulls).max(initial=0.0)) + _ROUNDED * body.rounding(body.start)
    if (np.abs(body.accelerations(body.start)) > small).any():
        warnings.warn(
            "vibrations: forces do not balance where the scene starts, so what they strain at rest is left "
            "out; give it the pose of sim.equilibrium",
            stacklevel=2,
        )
    return _vibrations(body, count)


def _vibrations(body: StaticModel, count: int) -> Vibrations:
    # A negligible shift; without it the rows of held masses would be zero.
    softness, shapes = _motions(body, 1e-100, count)
    if not softness[0] < 1e18 * softness[-1]:
        raise InputError(_NOT_HELD)
    return Vibrations(1.0 / np.sqrt(softness[:count]), _by_mass(body, shapes[:count]))


def free_vibrations(scene: Scene, count: int) -> Vibrations:
    """Find vibrations like `vibrations`, but of any body, leaving out unresisted motions.

    Motions such as those of a free body as a whole are left out, as are vibrations slower than 0.005 Hz, so
    fewer than the count, or none, may be returned.

    Arguments and errors are those of `vibrations`, except that the body may move without restoring force.
    """
    body = _checked(scene, count)
    with contextlib.suppress(InputError):
        return _vibrations(body, count)
    most = _freedoms(body)[1].size
    for wanted in (count, most):
        softness, shapes = _motions(body, _SHIFT, wanted)
        square = 1.0 / softness - _SHIFT
        kept = np.flatnonzero(square > NOTHING)[:count]
        if kept.size == count or softness.size == most:
            break
    return Vibrations(np.sqrt(square[kept]), _by_mass(body, shapes[kept]))


def _checked(scene: Scene, count: int) -> StaticModel:
    body = StaticModel(scene, balanced=False)
    freedoms = _freedoms(body)[1].size
    if not 1 <= count <= freedoms:
        raise InputError(
            of_field(
                "vibrations",
                Text("{count} is not in the range 1..{freedoms}", count=count, freedoms=freedoms),
            )
        )
    if body.tables.masses > MAX_MASSES:
        raise InputError(
            of_field(
                "vibrations",
                Text("{count} masses are more than {most}", count=body.tables.masses, most=MAX_MASSES),
            )
        )
    return body


def _motions(body: StaticModel, shift: float, count: int) -> tuple[Floats, Floats]:
    """Return 1 / (squared angular frequency + shift), s², and the flat shapes of the slowest motions, or of
    all motions, slowest first.

    Args:
        body: the body.
        shift: 1/s².
        count: number of motions wanted besides the unresisted ones.

    Raises:
        InputError: a squared angular frequency is less than minus the shift, or is not real.
    """
    ways, mass = _freedoms(body)
    stable = body.factorise(body.start, shift)
    if not stable:
        raise InputError(_NOT_HELD)
    # Scaling by the masses on both sides makes the matrix symmetric if the law has an energy.
    root = np.sqrt(body.state.inverse_mass[mass])

    def scaled_inverse(vector: Floats) -> Floats:
        return (ways.T @ body.solve(ways @ (root * vector.ravel()))) / root

    # Each connected part has at most three unresisted motions, and usually there is one part.
    wanted = count + 3
    few = mass.size >= _MANY and wanted * _FEW <= mass.size
    if few:
        values, vectors = _slowest_few(scaled_inverse, mass.size, wanted)
    else:
        values, vectors = _eigen(np.array([scaled_inverse(unit) for unit in np.eye(mass.size)]).T)
    if not (np.abs(np.imag(values)) <= 1e-6 * np.abs(values)).all():
        raise InputError(_NOT_HELD)
    values, vectors = np.real(values), np.real(vectors)
    if not values.min() > 0.0:
        raise InputError(_NOT_HELD)
    slowest = np.argsort(values)[::-1]
    return values[slowest], (ways @ (root[:, None] * vectors[:, slowest])).T


def _freedoms(body: StaticModel) -> tuple[csr_array, Indices]:
    """Return the independent ways in which free masses can move, (2 slots, f) flat unit vectors, and the (f,)
    slot of the mass of each: two of a mass, or one on a rail."""
    from scipy.sparse import coo_array

    rails, free = body.tables.environment.rails, np.flatnonzero(body.state.inverse_mass)
    loose = np.setdiff1d(free, rails.slot)
    on = np.flatnonzero(np.isin(rails.slot, free))
    mass = np.concatenate((loose, loose, rails.slot[on]))
    two, one = np.arange(2 * loose.size), 2 * loose.size + np.arange(on.size)
    row = np.concatenate((loose, body.slots + loose, rails.slot[on], body.slots + rails.slot[on]))
    value = np.concatenate((np.ones(two.size), *rails.way[on].T))
    shape = 2 * body.slots, mass.size
    return coo_array((value, (row, np.concatenate((two, one, one)))), shape).tocsr(), mass


def _eigen(matrix: Floats) -> tuple[np.ndarray, np.ndarray]:
    """Return all eigenvalues and eigenvectors of a symmetric or nearly symmetric matrix."""
    if not np.isfinite(matrix).all():
        raise InputError(_NOT_HELD)
    if np.allclose(matrix, matrix.T, rtol=1e-6, atol=1e-9 * float(np.abs(matrix).max())):
        return np.linalg.eigh(0.5 * (matrix + matrix.T))
    return np.linalg.eig(matrix)


def _slowest_few(
    scaled_inverse: Callable[[Floats], Floats], size: int, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the largest eigenvalues and their eigenvectors of a matrix given as a matrix-vector product."""
    from scipy.sparse.linalg import ArpackError, LinearOperator, eigs

    start = np.random.default_rng(1).uniform(-1.0, 1.0, size)
    if not np.isfinite(scaled_inverse(start)).all():
        raise InputError(_NOT_HELD)
    try:
        operator = LinearOperator((size, size), matvec=scaled_inverse)  # pyright: ignore
        values, vectors = eigs(operator, count, which="LM", v0=start)[:2]
        return np.asarray(values), np.asarray(vectors)
    except ArpackError:
        return _eigen(np.array([scaled_inverse(unit) for unit in np.eye(size)]).T)


def _by_mass(body: StaticModel, flat: Floats) -> Floats:
    """Return the (k, n, 2) shapes, each scaled to its largest amplitude."""
    shapes = np.array([np.column_stack(body.by_mass(row)) for row in flat])
    shapes = shapes.reshape(len(flat), body.tables.masses, 2)
    return shapes / np.abs(shapes).max((1, 2), keepdims=True)
