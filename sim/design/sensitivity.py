"""Sensitivity of a scene's pose at rest and of its slowest elastic vibration to its numbers.

At rest the accelerations a(q, p) vanish, where q are the positions and p is the logarithm of a number. So the
pose moves by dq/dp = -J⁻¹ da/dp, where J = da/dq is the matrix factorised in the search for the pose. Forces
are linear in stiffnesses and in gravity, so da/dp is a difference of two evaluations, without error.

The square of the angular frequency of a vibration w with wᵀ M w = 1 is ω² = -wᵀ M J w. As w is stationary,
dω²/dp = -wᵀ M (dJ/dp) w, where dJ/dp has two parts: one at a fixed pose, which is the number's share of the
energy of the vibration, and one from the motion of the pose. Both together are a difference of J w, along
q + p dq/dp. Under the tutorial's law J is not symmetric, and vibrations are not orthogonal: there dω²/dp is
minus the component of (dJ/dp) w along w in its expansion in all vibrations.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..analysis.equilibrium import StaticModel
from ..analysis.tuning import Dampers, at_rest, elastic_vibration, pull_direction
from ..analysis.vibrations import MAX_MASSES, Vibrations
from ..errors import InputError
from ..forces.joints import TUTORIAL
from ..scene.types import Scene
from ..scene.validate import validate
from ..settings import SETTINGS, settings_of

Floats = NDArray[np.float64]
Change = Callable[[Scene, float], Scene]
"""Returns the scene with the logarithm of a number increased by an amount."""

NUMBERS = ("linear_stiffness", "angular_stiffness", "gravity")
"""The settings whose derivatives `sensitivities` gives."""
# Unless noted, doubling or halving one of these numbers fails no test.
_STEP = 1e-4
"""Change of a logarithm in finite differences."""
_SWAY = 1e-3
"""Amplitude of a vibration in finite differences, in typical lengths of a spring."""
_NEAR, _TIMES = 1e-3, 4
"""Relative distance of the shift of an inverse iteration from the square of the angular frequency; and the
number of iterations."""
_SHIFTS = 1e-100, 1e-6
"""Shifts of the Jacobian, 1/s², that make it invertible; the second for bodies that can move freely."""


class AtRest:
    """A scene at rest.

    Args:
        scene: a valid scene. The search for its pose at rest starts from its pose.

    Attributes:
        scene: in its pose at rest; see `sim.tuning` for scenes without one.
        sag, sag_mass: see `sim.tuning`.
        notes: why there is no sag or no vibration.
        dampers: its damping.
        found: its slowest vibrations.
        elastic: index of the slowest elastic one; None if there is none.
    """

    def __init__(self, scene: Scene) -> None:
        self.notes: list[str] = []
        self.scene, self.sag, self.sag_mass = at_rest(scene, self.notes)
        self._down = pull_direction(scene)
        self.dampers = Dampers(self.scene)
        self.found, self.elastic = Vibrations(np.zeros(0), np.zeros((0, len(scene.masses), 2))), None
        free = len(scene.masses) > len({anchor.mass for anchor in scene.anchors})
        if free and len(scene.masses) <= MAX_MASSES:
            try:
                self.found, self.elastic = elastic_vibration(self.scene, self.dampers)
            except InputError as error:
                self.notes.append(str(error).partition(": ")[2])

    @property
    def omega(self) -> float | None:
        """Angular frequency of the slowest elastic vibration without damping, rad/s."""
        return None if self.elastic is None else float(self.found.omega[self.elastic])

    def sag_of(self, mass: int) -> float | None:
        """Return how far a mass is below its scene position, px, in the direction of `sim.tuning`'s sag."""
        if self.sag is None or self._down is None or self.scene.pose is None:
            return None
        moved = np.subtract(self.scene.pose.positions[mass], self.scene.masses[mass].position)
        return float(moved @ self._down)

    def moves(self, changes: list[Change]) -> list[Floats]:
        """Return for each number the derivative of the pose at rest by its logarithm, (n, 2), px."""
        return [np.column_stack(self._body.by_mass(move)) for move, _, _ in self._moves(changes)]

    def derivatives(self, changes: list[Change], mass: int | None) -> tuple[Floats, Floats]:
        """Return (k,) the derivatives of a mass's sag, px, and of the logarithm of the elastic vibration's
        angular frequency, with respect to the logarithms of some numbers; zero where these do not exist.
        """
        sags, frequencies = np.zeros(len(changes)), np.zeros(len(changes))
        body = self._body
        shape = self._shape()
        turns: list[Floats] = []
        for k, (move, more, less) in enumerate(self._moves(changes)):
            if mass is not None and self._down is not None:
                sags[k] = np.column_stack(body.by_mass(move))[mass] @ self._down
            if shape is not None and self.omega is not None:
                # J times the shape, at both ends of the difference.
                there = _along(more, body.start + _STEP * move, shape)
                back = _along(less, body.start - _STEP * move, shape)
                turns.append((there - back) / (2.0 * _STEP))
        if shape is not None and self.omega is not None:
            frequencies = -0.5 * self._parts_along(shape, turns) / self.omega**2
        return sags, frequencies

    # --------------------------------------------------------------------- inside
    def _parts_along(self, shape: Floats, vectors: list[Floats]) -> Floats:
        """Return (k,) the component of each vector along the elastic vibration, as a multiple of it.

        Where vibrations are not orthogonal, an inverse iteration removes all other components.
        """
        body, own = self._body, shape
        if body.tables.law == TUTORIAL and self.omega is not None:
            body.factorise(body.start, (_NEAR - 1.0) * self.omega**2)
            for _ in range(_TIMES):
                own, vectors = body.solve(own), [body.solve(each) for each in vectors]
        across = self._weights * shape
        return np.array([float(across @ each) for each in vectors]) / float(across @ own)

    @cached_property
    def _body(self) -> StaticModel:
        return StaticModel(self.scene, balanced=False)

    @cached_property
    def _weights(self) -> Floats:
        """Mass of every slot, kg, twice; zero where it is held."""
        inverse = self._body.state.inverse_mass
        return np.tile(np.where(inverse > 0.0, 1.0 / np.where(inverse > 0.0, inverse, 1.0), 0.0), 2)

    def _shape(self) -> Floats | None:
        """Return the elastic vibration, flattened, with an amplitude for finite differences, px."""
        if self.elastic is None:
            return None
        body, shape = self._body, np.zeros(2 * self._body.slots)
        place = body.system.mass_index
        shape[place], shape[body.slots + place] = self.found.shapes[self.elastic].T
        return _SWAY * body.typical * shape

    def _moves(self, changes: list[Change]) -> list[tuple[Floats, StaticModel, StaticModel]]:
        """Return for each number the pose's derivative, and the bodies with slightly more and less of it."""
        body, found = self._body, []
        bodies = [
            (StaticModel(change(self.scene, _STEP), False), StaticModel(change(self.scene, -_STEP), False))
            for change in changes
        ]
        pushes = [
            (more.accelerations(body.start) - less.accelerations(body.start)) / (2.0 * _STEP)
            for more, less in bodies
        ]
        for shift in _SHIFTS:
            found = []
            if body.factorise(body.start, shift):
                found = [body.solve(push) for push in pushes]
                if np.isfinite(found).all():
                    break
        else:
            found = [np.zeros_like(body.start)] * len(changes)
        return [(move, more, less) for move, (more, less) in zip(found, bodies, strict=True)]


def _along(body: StaticModel, at: Floats, shape: Floats) -> Floats:
    """Return J times a shape at some positions, 1/s² times its unit, by a fourth-order difference."""
    one, two = (body.accelerations(at + k * shape) - body.accelerations(at - k * shape) for k in (1.0, 2.0))
    return (8.0 * one - two) / 12.0


@dataclass(frozen=True)
class Sensitivity:
    """The effect of a number.

    Attributes:
        key: of its setting, as in "angular_stiffness".
        sag: px by which the mass that sinks most sinks farther, per relative change of the number: an
            increase of 1 % causes a hundredth of it. None if nothing sinks, see `sim.tuning`.
        frequency: relative change of the frequency of the slowest elastic vibration per relative change of
            the number; None if there is none.
    """

    key: str
    sag: float | None
    frequency: float | None


def sensitivities(scene: Scene) -> tuple[Sensitivity, ...]:
    """Return the effects of the stiffness of springs, that of joints, and gravity on the pose at rest and the
    slowest elastic vibration, as derivatives; see the module for the method.

    Args:
        scene: a valid scene. Numbers that are zero or have no effect are left out.

    Raises:
        SceneError: the scene is not valid.
    """
    return sensitivities_at(AtRest(validate(scene)))


def sensitivities_at(rest: AtRest) -> tuple[Sensitivity, ...]:
    """As `sensitivities`, for a scene at rest."""
    applying = {setting.key for setting in settings_of(rest.scene)}
    keys = [key for key in NUMBERS if key in applying and SETTINGS[key].read(rest.scene)]
    if rest.sag is None and rest.elastic is None:
        return ()
    sags, frequencies = rest.derivatives([by_setting(key) for key in keys], rest.sag_mass)
    return tuple(
        Sensitivity(
            key, None if rest.sag is None else float(sag), None if rest.omega is None else float(rate)
        )
        for key, sag, rate in zip(keys, sags, frequencies, strict=True)
    )


def by_setting(key: str) -> Change:
    """Return a change of the setting of that name."""
    return lambda scene, step: scaled(scene, key, math.exp(step))


def scaled(scene: Scene, key: str, factor: float) -> Scene:
    """Return the scene with the setting of that name multiplied; the recipes of a scene stay recipes.

    Raises:
        SceneError: it leaves its range.
    """
    setting = SETTINGS[key]
    return validate(setting.write(scene, setting.read(scene) * factor))
