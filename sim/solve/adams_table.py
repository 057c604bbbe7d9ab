"""Coefficients of Adams methods, computed as integrals of polynomials in exact fractions."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from ..engine.tables import PAST, Adams

_Polynomial = list[Fraction]
"""Coefficients of a polynomial, the constant one first."""


def adams(degree: int) -> Adams:
    """The coefficients for degrees of the polynomial up to `degree`, which is at most `PAST` - 1.

    Time s is measured in steps: 0 at the last known state and 1 at the next one. The polynomial of degree k
    goes through the accelerations at 0, -1, ... -k. The correction adds e L(s) to it, where e is the
    difference between the acceleration found and the one extrapolated, and L is the polynomial that is 1 at 1
    and 0 at these times.
    """
    shape = (PAST, PAST)
    position, velocity, ahead, barycentric = (np.zeros(shape) for _ in range(4))
    back = np.zeros((PAST * PAST, PAST))
    to_position, to_velocity, error = np.zeros(PAST), np.zeros(PAST), np.zeros(PAST)
    for k in range(degree + 1):
        nodes = [Fraction(-i) for i in range(k + 1)]
        for i in range(k + 1):
            basis = _lagrange(nodes, i)
            position[k, i], velocity[k, i] = _twice_integrated(basis), _integrated(basis)
            ahead[k, i] = float(sum(basis))
            for steps in range(1, k + 1):
                back[k * PAST + steps, i] = -_integrated(basis, -steps)
            barycentric[k, i] = 1.0 / math.prod(i - other for other in range(k + 1) if other != i)
        longer, shorter = (_lagrange([Fraction(1), *nodes[:count]], 0) for count in (k + 1, k))
        to_position[k], to_velocity[k] = _twice_integrated(longer), _integrated(longer)
        # The estimate is the effect of the oldest point on positions, directly or through velocities in a
        # step.
        error[k] = max(
            abs(to_position[k] - _twice_integrated(shorter)), abs(to_velocity[k] - _integrated(shorter))
        )
    return Adams(
        degree=degree,
        position=position,
        velocity=velocity,
        ahead=ahead,
        barycentric=barycentric,
        to_position=to_position,
        to_velocity=to_velocity,
        error=error,
        back=back,
    )


def _lagrange(nodes: list[Fraction], i: int) -> _Polynomial:
    """The polynomial that is 1 at one of the nodes and 0 at the others."""
    out = [Fraction(1)]
    for k, node in enumerate(nodes):
        if k != i:
            scale = 1 / (nodes[i] - node)
            raised = [Fraction(0), *out]
            out = [scale * (up - node * low) for up, low in zip(raised, [*out, Fraction(0)], strict=True)]
    return out


def _integrated(p: _Polynomial, to: int = 1) -> float:
    """The integral from 0 to `to`."""
    return float(sum(c * to ** (i + 1) / (i + 1) for i, c in enumerate(p)))


def _twice_integrated(p: _Polynomial) -> float:
    """The integral from 0 to 1 of the integral that starts at 0."""
    return float(sum(c / ((i + 1) * (i + 2)) for i, c in enumerate(p)))
