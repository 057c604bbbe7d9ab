"""The small vibrations of a body about a pose."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..errors import InputError
from ..kernels.core.tables import Floats
from ..scene.types import Scene
from .equilibrium import Resting

MOST_MASSES = 1000
"""Largest number of masses for vibrations, which are computed with full matrices."""
_NOT_HELD = "vibrations: the springs do not hold the body where it starts, so it does not vibrate there"
_SHIFT = 1.0
"""What is added to squares of angular frequencies, 1/s², so that the matrix of a free body has an inverse."""
_NOTHING = 1e-3
"""Square of an angular frequency, 1/s², up to which a motion counts as one that nothing resists."""


class Vibrations(NamedTuple):
    """Small vibrations without damping, the slowest first.

    Attributes:
        frequencies: (k,) angular frequencies, rad/s.
        shapes: (k, n, 2) amplitude of each mass relative to the largest; signs are arbitrary.
    """

    frequencies: Floats
    shapes: Floats


def vibrations(scene: Scene, count: int) -> Vibrations:
    """The slowest small vibrations about the scene's start, which should be an equilibrium.

    They are found from the eigenvalues of the inverse of the Jacobian of the accelerations with respect to
    positions, so that the slow ones are accurate however stiff the body is. Damping and air friction are
    ignored.

    Args:
        scene: a valid scene of at most 1000 masses.
        count: number of vibrations, from 1 to twice the number of free masses.

    Raises:
        SceneError: the scene is not valid.
        InputError: the count or the number of masses is out of range, or the body can move without any
            restoring force, or moves away from its start by itself, so that its motion there is no vibration.
    """
    body = _checked(scene, count)
    # A negligible shift; without it the rows of held masses would be zero.
    softness, shapes = _motions(body, 1e-100)
    if not softness[0] < 1e18 * softness[-1]:
        raise InputError(_NOT_HELD)
    return Vibrations(1.0 / np.sqrt(softness[:count]), _by_mass(body, shapes[:count]))


def free_vibrations(scene: Scene, count: int) -> Vibrations:
    """Like `vibrations`, but of any body: motions that nothing resists, such as those of a free body as a
    whole, are left out. So are vibrations slower than 0.005 Hz. There may be fewer than the count, or none.

    Args and errors: as of `vibrations`, but that the body can move without any restoring force.
    """
    try:
        return vibrations(scene, count)
    except InputError:
        body = _checked(scene, count)
        softness, shapes = _motions(body, _SHIFT)
    square = 1.0 / softness - _SHIFT
    kept = np.flatnonzero(square > _NOTHING)[:count]
    return Vibrations(np.sqrt(square[kept]), _by_mass(body, shapes[kept]))


def _checked(scene: Scene, count: int) -> Resting:
    body = Resting(scene, balanced=False)
    freedoms = 2 * int(np.count_nonzero(body.state.inverse_mass))
    if not 1 <= count <= freedoms:
        raise InputError(f"vibrations: {count} is not in the range 1..{freedoms}")
    if body.tables.masses > MOST_MASSES:
        raise InputError(f"vibrations: {body.tables.masses} masses are more than {MOST_MASSES}")
    return body


def _motions(body: Resting, shift: float) -> tuple[Floats, Floats]:
    """1 / (square of the angular frequency + shift) of all motions, the slowest first, s²; and their shapes,
    flat.

    Raises:
        InputError: the square of an angular frequency is less than minus the shift, or is not real.
    """
    free = np.flatnonzero(body.state.inverse_mass)
    columns = np.concatenate((free, body.slots + free))
    stable = body.factorise(body.start, shift)
    inverse = np.array([body.solve(unit)[columns] for unit in np.eye(2 * body.slots)[columns]]).T
    # Scaling by the masses on both sides makes it symmetric if the law has an energy.
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
    if not values.min() > 0.0:
        raise InputError(_NOT_HELD)
    slowest = np.argsort(values)[::-1]
    flat = np.zeros((values.size, 2 * body.slots))
    flat[:, columns] = (root[:, None] * vectors[:, slowest]).T
    return values[slowest], flat


def _by_mass(body: Resting, flat: Floats) -> Floats:
    """(k, n, 2) shapes, each relative to its largest amplitude."""
    shapes = np.array([np.column_stack(body.by_mass(row)) for row in flat])
    shapes = shapes.reshape(len(flat), body.tables.masses, 2)
    return shapes / np.abs(shapes).max((1, 2), keepdims=True)
