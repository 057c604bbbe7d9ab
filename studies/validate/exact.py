"""Exact results and reference curves of continua and textbook systems, without softrod's solver.

Lengths are in the length L of the beam or rope (or the span, for the catenary) and angles in radians, unless
noted otherwise. SciPy is imported where it is used, since it takes long to load.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Elastica:
    """The shape of a bent rod, clamped horizontally at its start.

    Attributes:
        x, y: (k,) along the clamp's direction and downwards, from the clamp to the free end.
    """

    x: Floats
    y: Floats

    @property
    def reach(self) -> float:
        """x of the free end."""
        return float(self.x[-1])

    @property
    def drop(self) -> float:
        """y of the free end."""
        return float(self.y[-1])


def elastica(weight: float, tip: float = 0.0, points: int = 201) -> Elastica:
    """Return the planar elastica under weight and a load at its free end (Euler 1744; Romero et al. 2021).

    EI theta'' = -(w (L - s) + P) cos theta, theta(0) = theta'(L) = 0, solved by shooting from the free end:
    the angle from the vertical grows from there, so that a boundary layer at the clamp does no harm.

    Args:
        weight: Gamma = w L³ / EI, w the weight per length; up to 1e5.
        tip: P L² / EI.
        points: of the shape, at equal arc lengths.
    """
    from scipy.integrate import solve_ivp

    def slopes(s: float, state: Floats) -> tuple[float, ...]:
        fall, turn = state[0], state[1]  # s from the free end; the angle from the vertical
        return turn, (weight * s + tip) * math.sin(fall), math.sin(fall), math.cos(fall)

    def beyond(s: float, state: Floats) -> float:
        return state[0] - 2.0

    beyond.terminal = True  # type: ignore[attr-defined]

    def shoot(log_fall: float, dense: bool = False):
        # The angle is small at the free end, and has to be right relative to its own size.
        fall = math.exp(log_fall)
        tiny = np.array([1e-13 * fall, 1e-13 * fall, 1e-14, 1e-14])
        return solve_ivp(
            slopes, (0.0, 1.0), (fall, 0.0, 0.0, 0.0), "DOP853",
            dense_output=dense, events=beyond, rtol=1e-12, atol=tiny,
        )  # fmt: skip

    def miss(log_fall: float) -> float:
        return float(shoot(log_fall).y[0, -1]) - 0.5 * math.pi

    # It grows at most like exp(integral of sqrt(w s + P)).
    lowest = -2.0 - math.sqrt(weight + tip)
    log_fall = _root(miss, lowest, math.log(0.5 * math.pi))
    s = np.linspace(0.0, 1.0, points)
    _, _, x, y = shoot(log_fall, dense=True).sol(s)
    return Elastica((x[-1] - x)[::-1].copy(), (y[-1] - y)[::-1].copy())


def clamped_free_roots(count: int) -> Floats:
    """Return beta_n L of a beam clamped at one end and free at the other: cos b cosh b = -1.

    The angular frequencies are (beta_n L)² sqrt(EI / (rho A L⁴)).
    """
    middles = (np.arange(count) + 0.5) * math.pi
    return np.array([_root(lambda b: math.cos(b) + 1.0 / math.cosh(b), m - 0.6, m + 0.6) for m in middles])


def pinned_chain_frequencies(
    segments: int, spacing: float, stiffness: float, mass: float, count: int
) -> Floats:
    """Return angular frequencies (rad/s) of small vibrations of a straight chain held at both ends.

    A joint's angle is V = (y[i+1] - 2 y[i] + y[i-1]) / h to first order, and its energy under every force law
    K h² V² / 2 to second order. So m y'' = -K (fourth difference of y), with no couple at the ends, where
    there is no joint; y[i] = sin(n pi i / N) solves it with omega = 4 sqrt(K / m) sin²(n pi / 2N). In terms
    of the couple per radian k = K h² that is (4 / h) sqrt(k / m) sin²(n pi / 2N).

    Args:
        segments: N, springs of the chain; all at their rest length.
        spacing: h, px.
        stiffness: K of the angular springs, kg/s².
        mass: of every mass, kg.
        count: how many.
    """
    n = np.arange(1, count + 1)
    couple = stiffness * spacing**2
    return 4.0 / spacing * math.sqrt(couple / mass) * np.sin(n * math.pi / (2.0 * segments)) ** 2


def hanging_rope_frequencies(count: int) -> Floats:
    """Return frequencies of a hanging rope without stiffness, in sqrt(g / L): j_0n / 2 (Bernoulli 1733)."""
    from scipy.special import jn_zeros

    return jn_zeros(0, count) / 2.0


@dataclass(frozen=True)
class Catenary:
    """A rope that hangs between two points of the same height, in lengths of the span.

    Attributes:
        parameter: a, which is also the horizontal tension over the weight per length.
        sag: depth of its lowest point below the ends.
    """

    parameter: float
    sag: float


def catenary(length: float) -> Catenary:
    """Return the catenary y = a cosh(x / a) of a length (over the span), from 1.0001 on."""
    # u = 1 / (2 a): sinh(u) / u = length.
    u = _root(lambda u: math.sinh(u) / u - length, 1e-3, 700.0)
    a = 0.5 / u
    return Catenary(a, a * (math.cosh(u) - 1.0))


def ring_radius(spacing: float, rest_angle: float) -> float:
    """Return the radius of the arc of a chain whose joints all have a rest angle (radians)."""
    return spacing / (2.0 * math.sin(0.5 * rest_angle))


def damped_oscillation(time: Floats, start: float, mass: float, stiffness: float, damping: float) -> Floats:
    """Return x of m x'' + c x' + k x = 0, weakly damped, released at `start`."""
    decay = damping / (2.0 * mass)
    omega = math.sqrt(stiffness / mass - decay**2)
    return start * np.exp(-decay * time) * (np.cos(omega * time) + decay / omega * np.sin(omega * time))


def double_pendulum(time: float, angles: tuple[float, float], gravity: float) -> Floats:
    """Return (2, 2) positions of unit masses on two rigid massless unit rods, released at rest; y is down.

    Args:
        time: s.
        angles: of the rods from the vertical at first, radians.
        gravity: in lengths of a rod per s².
    """
    from scipy.integrate import solve_ivp

    def slopes(_: float, state: Floats) -> tuple[float, ...]:
        one, two, v, w = state
        sine, cosine = math.sin(one - two), math.cos(one - two)
        # Lagrange's equations: a linear system for the two angular accelerations.
        right = np.array(
            [
                -(w**2) * sine - 2.0 * gravity * math.sin(one),
                v**2 * sine - gravity * math.sin(two),
            ]
        )
        a, b = np.linalg.solve(np.array([[2.0, cosine], [cosine, 1.0]]), right)
        return v, w, float(a), float(b)

    end = solve_ivp(slopes, (0.0, time), (*angles, 0.0, 0.0), "DOP853", rtol=1e-13, atol=1e-13)
    one, two = end.y[:2, -1]
    first = np.array([math.sin(one), math.cos(one)])
    return np.array([first, first + np.array([math.sin(two), math.cos(two)])])


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """Return the zero of a function between two arguments at which its signs differ."""
    from scipy.optimize import brentq

    return float(np.asarray(brentq(function, low, high, xtol=1e-14)))
