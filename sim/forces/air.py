"""The air: friction by one of three laws, and wind.

With the friction F and the velocity u of a mass relative to the air, the force is

- isotropic: -F |u| u, the same in all directions; F in kg/px. Its derivative by u is -F (|u| + u uᵀ / |u|);
- tutorial: -F |u| u on each axis by itself; F in kg/px. Its derivative is -2 F |u| on each axis;
- linear: -F u; F in kg/s. Its derivative is -F.

Its power is that force times the velocity v of the mass, and its derivative by position is minus that by u,
times the derivative of the wind.

Still air is part of every step of every body. So `springs.accelerations_by` and `chain` have its force under
the tutorial's law, from `State.air`; under the other laws `brake` adds it, from `State.drag`. Both are F / m,
and zero for held masses and where there is wind.

Gusts are waves of velocity across their own direction, so that the air is not compressed, which the mean wind
carries along: a wave with the wave vector k adds its amplitude times sin(k . x - k . w t + phase) to the mean
wind w (Kraichnan 1970, Taylor 1938).
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.lanes import eight_at_a_time, whole_eights
from ..engine.numerics.sines import sine
from ..engine.table import Rows, Table
from ..engine.tables import Body, State
from ..scene.surroundings import Wind
from ..scene.types import AirLaw, Scene, is_windy
from .term import Floats, Places, Term, Vectors

_WAVES = 12
"""Number of waves that make gusts."""
_OCTAVES = 4.0
"""Their wavelengths reach from the length scale to this many octaves below it."""
_GOLDEN_ANGLE = math.pi * (3.0 - math.sqrt(5.0))
"""Angle between the directions of one wave and the next, radians: it spreads any number evenly."""


TUTORIAL, ISOTROPIC, LINEAR = 0, 1, 2
"""Codes of the laws."""
LAWS: dict[AirLaw, int] = {"isotropic": ISOTROPIC, "tutorial": TUTORIAL, "linear": LINEAR}


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Air(Table):
    """Read-only. K waves of gusts."""

    law: int  # a code
    brakes: bool  # still air acts by `State.drag`, under a law that is not the tutorial's
    friction: float  # F, kg/px or kg/s
    moves: bool  # there is wind, and air friction or a medium for it to act by
    wind_x: float  # px/s, the mean wind
    wind_y: float
    waves: Rows  # (K, 6), a `Wave` each


class Wave(NamedTuple):
    """A wave of gusts."""

    x: float  # 1/px, the wave vector
    y: float
    u: float  # px/s, the amplitude
    v: float
    phase: float  # at time zero
    rate: float  # 1/s, of the phase


def new_air(scene: Scene, _: Places) -> Air:
    """The table of a valid scene."""
    wind = scene.wind
    if wind is None or not is_windy(scene):
        return still_air(scene.air_law, scene.air_friction)
    x, y = wind.velocity
    return Air(
        law=LAWS[scene.air_law],
        brakes=False,
        friction=scene.air_friction,
        moves=True,
        wind_x=x,
        wind_y=y,
        waves=_waves(wind),
    )


@lru_cache(maxsize=16)
def still_air(law: AirLaw, friction: float) -> Air:
    """The table of a scene without wind. Those of all scenes of one law and one friction are the same."""
    return Air(
        law=LAWS[law],
        brakes=friction > 0.0 and law != "tutorial",
        friction=friction,
        moves=False,
        wind_x=0.0,
        wind_y=0.0,
        waves=np.zeros((0, len(Wave._fields))),
    ).read_only()


def _waves(wind: Wind) -> Floats:
    """(K, 6) waves whose energy falls with the wave number as in turbulence, by the power -5/3."""
    speed = math.hypot(*wind.velocity)
    if wind.turbulence * speed == 0.0:
        return np.zeros((0, len(Wave._fields)))
    rng = np.random.default_rng(wind.seed)
    octave = np.arange(_WAVES) * (_OCTAVES / (_WAVES - 1))
    number = np.asarray(math.tau / wind.length_scale * 2.0**octave, float)
    turn = _GOLDEN_ANGLE * np.arange(_WAVES) + rng.uniform(0.0, math.tau)
    amplitude = number ** (-1.0 / 3.0)  # equal shares of the octaves, each with the energy k^(-2/3)
    # The mean square of both components together is half of the sum of all squared amplitudes.
    amplitude *= 2.0 * wind.turbulence * speed / math.sqrt(float((amplitude**2).sum()))
    x, y = number * np.cos(turn), number * np.sin(turn)
    u, v = -amplitude * np.sin(turn), amplitude * np.cos(turn)
    phase = rng.uniform(0.0, math.tau, _WAVES)
    return np.stack((x, y, u, v, phase, -(x * wind.velocity[0] + y * wind.velocity[1])), 1)


@kernel(forceinline=True)
def _wave(air, k):
    """The k-th wave."""
    row = air.waves[k]
    return Wave(row[0], row[1], row[2], row[3], row[4], row[5])


# ------------------------------------------------------------------------- the wind
@kernel(fastmath=FAST)
def wind_at(air, t, x, y):
    """The velocity of the air at a point and a time: u, v (px/s)."""
    u, v = air.wind_x, air.wind_y
    for k in range(air.waves.shape[0]):
        wave = _wave(air, k)
        size = math.sin(wave.x * x + wave.y * y + wave.phase + wave.rate * t)
        u += wave.u * size
        v += wave.v * size
    return u, v


@kernel(fastmath=FAST)
def wind_gradient_at(air, t, x, y):
    """Its derivatives by position: du/dx, du/dy, dv/dx, dv/dy (1/s)."""
    ux, uy, vx, vy = 0.0, 0.0, 0.0, 0.0
    for k in range(air.waves.shape[0]):
        wave = _wave(air, k)
        slope = math.cos(wave.x * x + wave.y * y + wave.phase + wave.rate * t)
        ux += wave.u * slope * wave.x
        uy += wave.u * slope * wave.y
        vx += wave.v * slope * wave.x
        vy += wave.v * slope * wave.y
    return ux, uy, vx, vy


# ------------------------------------------------------------------------- force
@kernel(forceinline=True, fastmath=FAST)
def _force(law, friction, x, y):
    """Minus the force at a velocity relative to the air."""
    if law == TUTORIAL:
        return friction * x * abs(x), friction * y * abs(y)
    if law == ISOTROPIC:
        friction *= math.sqrt(x * x + y * y)
    return friction * x, friction * y


@kernel(forceinline=True, fastmath=FAST)
def _slopes(law, friction, x, y):
    """Minus its derivatives by that velocity: of x by x, of either by the other, of y by y."""
    if law == TUTORIAL:
        return 2.0 * friction * abs(x), 0.0, 2.0 * friction * abs(y)
    if law == LINEAR:
        return friction, 0.0, friction
    square = x * x + y * y
    if square == 0.0:
        return 0.0, 0.0, 0.0
    speed = math.sqrt(square)
    per_speed = friction / speed
    return per_speed * (square + x * x), per_speed * x * y, per_speed * (square + y * y)


@kernel(fastmath=FAST, noalias=True)
def brake(body, state, v, a):
    """Add the accelerations by still air under a law that is not the tutorial's."""
    eight_at_a_time()
    slots, drag = v.size // 2, state.drag
    vx, vy, ax, ay = v[:slots], v[slots:], a[:slots], a[slots:]
    if body.environment.air.law == LINEAR:
        for i in range(1, body.masses + 1):
            ax[i] -= drag[i] * vx[i]
            ay[i] -= drag[i] * vy[i]
    else:
        for i in range(1, body.masses + 1):
            rate = drag[i] * math.sqrt(vx[i] * vx[i] + vy[i] * vy[i])
            ax[i] -= rate * vx[i]
            ay[i] -= rate * vy[i]


@kernel(fastmath=FAST, noalias=True)
def _add_wave(wave, t, masses, x, y, u, v):
    """Add the velocity of the air in one wave at each mass."""
    eight_at_a_time()
    kx, ky, phase = wave.x, wave.y, wave.phase + wave.rate * t
    along_x, along_y = wave.u, wave.v
    for i in range(whole_eights(masses)):  # padded
        s = sine(kx * x[i] + ky * y[i] + phase)
        u[i] += along_x * s
        v[i] += along_y * s


@kernel(fastmath=FAST, noalias=True)
def _drag(law, friction, masses, inverse_mass, u, v, vx, vy, fx, fy):
    """Add the friction of air that moves with the velocities u, v at the masses."""
    eight_at_a_time()
    if law == TUTORIAL:
        for i in range(whole_eights(masses)):
            drag = friction if inverse_mass[i] > 0.0 else 0.0
            past_x, past_y = vx[i] - u[i], vy[i] - v[i]
            fx[i] -= drag * past_x * abs(past_x)
            fy[i] -= drag * past_y * abs(past_y)
        return
    for i in range(whole_eights(masses)):
        drag = friction if inverse_mass[i] > 0.0 else 0.0
        past_x, past_y = vx[i] - u[i], vy[i] - v[i]
        rate = drag if law == LINEAR else drag * math.sqrt(past_x * past_x + past_y * past_y)
        fx[i] -= rate * past_x
        fy[i] -= rate * past_y


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    """The friction of moving air on free masses."""
    air, masses, t, slots = body.environment.air, body.masses, state.clock[0], q.size // 2
    x, y, vx, vy = q[1:slots], q[slots + 1 :], v[1:slots], v[slots + 1 :]
    u, w = scratch.tx[1:], scratch.ty[1:]
    for i in range(whole_eights(masses)):
        u[i], w[i] = air.wind_x, air.wind_y
    for k in range(air.waves.shape[0]):
        _add_wave(_wave(air, k), t, masses, x, y, u, w)
    inverse_mass, fx, fy = state.inverse_mass[1:], scratch.fx[1:], scratch.fy[1:]
    _drag(air.law, air.friction, masses, inverse_mass, u, w, vx, vy, fx, fy)


# ------------------------------------------------------------------------- the balance
@kernel(fastmath=FAST)
def power_of_still_air(body, state, v):
    """kg px²/s³; zero where there is wind."""
    slots, power = v.size // 2, 0.0
    for i in range(1, body.masses + 1):
        vx, vy = v[i], v[slots + i]
        power -= state.air[i] * body.environment.mass[i] * (vx * vx * abs(vx) + vy * vy * abs(vy))
    if body.environment.air.brakes:
        for i in range(1, body.masses + 1):
            vx, vy = v[i], v[slots + i]
            x, y = _force(body.environment.air.law, state.drag[i] * body.environment.mass[i], vx, vy)
            power -= x * vx + y * vy
    return power


@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    """On free masses; wind can do work on a body."""
    air, slots, power = body.environment.air, q.size // 2, 0.0
    for i in range(1, body.masses + 1):
        if state.inverse_mass[i] > 0.0:
            vx, vy = v[i], v[slots + i]
            u, w = wind_at(air, state.clock[0], q[i], q[slots + i])
            x, y = _force(air.law, air.friction, vx - u, vy - w)
            power -= x * vx + y * vy
    balance.work.air += part * power


# ------------------------------------------------------------------------- derivatives
@kernel(fastmath=FAST)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    """Those of moving air."""
    air, blocks, slots = body.environment.air, matrix.blocks, q.size // 2
    for i in range(body.masses):
        m, d = matrix.order[i], 4 * matrix.diagonal[i]
        u, w = wind_at(air, state.clock[0], q[m], q[slots + m])
        drag_x, both, drag_y = _slopes(air.law, air.friction, v[m] - u, v[slots + m] - w)
        blocks[d] -= g * drag_x
        blocks[d + 3] -= g * drag_y
        if air.law == ISOTROPIC:
            blocks[d + 1] -= g * both
            blocks[d + 2] -= g * both
        if not definite and air.waves.shape[0] > 0:
            xx, xy, yx, yy = wind_gradient_at(air, state.clock[0], q[m], q[slots + m])
            blocks[d] += drag_x * xx
            blocks[d + 1] += drag_x * xy
            blocks[d + 2] += drag_y * yx
            blocks[d + 3] += drag_y * yy
            if air.law == ISOTROPIC:
                blocks[d] += both * yx
                blocks[d + 1] += both * yy
                blocks[d + 2] += both * xx
                blocks[d + 3] += both * xy


@kernel(fastmath=FAST)
def add_derivatives_of_still_air(body, state, matrix, v, g):
    """See `Term.add_derivatives`; those by the tutorial's law are in `solve.linear.sparse.eliminate`."""
    air, blocks, slots = body.environment.air, matrix.blocks, v.size // 2
    if not air.brakes:
        return
    for i in range(body.masses):
        m, d = matrix.order[i], 4 * matrix.diagonal[i]
        drag_x, both, drag_y = _slopes(air.law, air.friction, v[m], v[slots + m])
        blocks[d] -= g * drag_x
        blocks[d + 1] -= g * both
        blocks[d + 2] -= g * both
        blocks[d + 3] -= g * drag_y


@kernel(fastmath=FAST)
def add_damping_of_still_air(body, state, v, z, factor, out):
    """See `Term.add_damping`; nothing where there is wind."""
    still, slots = state.air, z.size // 2
    for i in range(1, body.masses + 1):
        k = slots + i
        out[i] -= factor * 2.0 * still[i] * abs(v[i]) * z[i]
        out[k] -= factor * 2.0 * still[i] * abs(v[k]) * z[k]
    if body.environment.air.brakes:
        for i in range(1, body.masses + 1):
            k = slots + i
            drag_x, both, drag_y = _slopes(body.environment.air.law, state.drag[i], v[i], v[k])
            out[i] -= factor * (drag_x * z[i] + both * z[k])
            out[k] -= factor * (both * z[i] + drag_y * z[k])


@kernel(fastmath=FAST)
def _add_damping(body, state, q, v, z, factor, out):
    air, slots = body.environment.air, z.size // 2
    for i in range(1, body.masses + 1):
        k = slots + i
        u, w = wind_at(air, state.clock[0], q[i], q[k])
        drag = air.friction * state.inverse_mass[i]
        if air.law == TUTORIAL:
            drag *= 2.0
            out[i] -= factor * drag * abs(v[i] - u) * z[i]
            out[k] -= factor * drag * abs(v[k] - w) * z[k]
        else:
            drag_x, both, drag_y = _slopes(air.law, drag, v[i] - u, v[k] - w)
            out[i] -= factor * (drag_x * z[i] + both * z[k])
            out[k] -= factor * (both * z[i] + drag_y * z[k])


# ------------------------------------------------------------------------- in NumPy
class AirReference:
    """The air in NumPy; see `Reference`."""

    def __init__(self, body: Body, state: State) -> None:
        self._air, self._state = body.environment.air, state

    def wind(self, x: Vectors) -> Vectors:
        """The velocity of the air at positions x (px) at the time of the state, px/s."""
        air, t = self._air, float(self._state.clock[0])
        total = np.full(x.shape, air.wind_x + 1j * air.wind_y)
        for kx, ky, u, w, phase, rate in air.waves:
            total += (u + 1j * w) * np.sin(kx * x.real + ky * x.imag + phase + rate * t)
        return total

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`; also on masses that are held."""
        u = v - self.wind(x) if self._air.moves else v
        if self._air.law == TUTORIAL:
            return -self._air.friction * (u.real * abs(u.real) + 1j * (u.imag * abs(u.imag)))
        return -self._air.friction * (u if self._air.law == LINEAR else abs(u) * u)

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        return 0.0


AIR = Term(
    "air friction",
    is_windy,
    AirReference,
    _add_forces,
    field="air",
    table=Air,
    new=new_air,
    add_power=_add_power,
    add_derivatives=_add_derivatives,
    add_damping=_add_damping,
    depends_on_time=lambda body: bool(body.environment.air.waves.size),
)
