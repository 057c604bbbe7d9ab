"""How large a time step symplectic Euler bears, estimated from the forces alone.

Linearised about the present state, M a = -K x - C v. A step of symplectic Euler has an eigenvalue -1, the
border of stability, exactly when some w has (dt² K + 2 dt C) w = 4 M w. So the largest stable step is the
one at which the largest eigenvalue of M^-1 (dt² K + 2 dt C) is 4; for one damped mode that is the textbook
omega dt < 2 (sqrt(1 + zeta²) - zeta). K w and C w are differences of two evaluations of the kernels' forces,
so any topology and law will do, and no matrix is built: K and C are projected on a Krylov space (Arnoldi),
and the small problem that is left is solved as a quadratic eigenvalue problem in 1/dt.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from .kernels.controls import refresh
from .kernels.forces import spring_forces
from .kernels.tables import Floats, Live
from .system import System, new_live, new_work

Cause = Literal["linear stiffness", "angular stiffness", "linear damping", "air friction"]

_FIRST_SIZE, _SIZE = 40, 12
"""Dimension of the Krylov space at first, and later, when it starts from the stiffest motion found before."""


@dataclass(frozen=True)
class StabilityEstimate:
    """What `StabilityMeter.update` found.

    Attributes:
        limit: largest stable time step, s; infinite where nothing pulls.
        cause: what sets it, or None where nothing does.
    """

    limit: float
    cause: Cause | None


class StabilityMeter:
    """Follows the stability limit of a moving body.

    The estimate concerns small motions about the present state. It approaches the true limit from above
    and is within a per cent of it.
    """

    def __init__(self, system: System) -> None:
        self._system = system
        self._probe = new_live(system)
        self._work = new_work(system)
        n = system.body.masses
        self._here = slice(1, n + 1)  # the places of the masses
        # Alternating signs are close to the stiffest mode of a chain, and no mode is orthogonal to noise.
        noise = np.random.default_rng(1).normal(size=(2, n))
        self._start = noise + 3.0 * (-1.0) ** np.arange(n)
        self._limit = 0.0

    def update(self, live: Live, air_friction: float) -> StabilityEstimate:
        """The limit at the state in `live` (which is only read).

        Args:
            live: the state; masses whose `dt_mass` is zero count as held.
            air_friction: kg/px.
        """
        body, probe = self._system.body, self._probe
        n = body.masses
        here = self._here
        free = live.dt_mass[here] > 0.0
        for field in ("x", "y", "vx", "vy", "controls"):
            getattr(probe, field)[:] = getattr(live, field)
        refresh(body, probe)
        air = 2.0 * air_friction * np.abs(np.array([live.vx[here], live.vy[here]]))
        # In coordinates q = sqrt(M) w, in which K and C of a conservative law are symmetric.
        root = np.where(free, np.sqrt(self._system.inverse_mass), 0.0)
        size = min(_SIZE if self._limit else _FIRST_SIZE, 2 * int(free.sum()))
        basis, k_basis, c_basis = [], [], []
        q = self._start * free
        scale = self._limit or 1e-3
        for _ in range(size):
            for _ in range(2):  # twice is enough to be orthogonal to rounding
                for other in basis:
                    q = q - (other * q).sum() * other
            norm = float(np.sqrt((q * q).sum()))
            if not 1e-12 < norm < np.inf:
                break
            basis.append(q / norm)
            w = basis[-1] * root
            k_basis.append(self._product(live, w, velocities=False) * root)
            c_basis.append((self._product(live, w, velocities=True) + air * w) * root)
            q = scale * scale * k_basis[-1] + 2.0 * scale * c_basis[-1]
            q = q / max(float(np.sqrt((q * q).sum())), 1e-300)
        if not basis:
            return StabilityEstimate(np.inf, None)
        flat = np.array(basis).reshape(len(basis), -1)
        k = flat @ np.array(k_basis).reshape(len(basis), -1).T
        c = flat @ np.array(c_basis).reshape(len(basis), -1).T
        if not (np.isfinite(k).all() and np.isfinite(c).all()):
            return StabilityEstimate(np.inf, None)
        limit, mode = _largest_step(k, c)
        if limit == np.inf:
            return StabilityEstimate(np.inf, None)
        self._limit = limit
        self._start = (mode @ flat).reshape(2, n)
        return StabilityEstimate(limit, self._cause(live, self._start * root, limit, air))

    def _product(self, live: Live, w: Floats, velocities: bool) -> Floats:
        """K w, or C w without the air, as a difference of forces. The springs' damping is linear in v."""
        body, probe, work, here = self._system.body, self._probe, self._work, self._here
        if velocities and not body.damped:
            return np.zeros_like(w)
        fields = (probe.vx, probe.vy) if velocities else (probe.x, probe.y)
        origin = (live.vx[here], live.vy[here]) if velocities else (live.x[here], live.y[here])
        # Small beside the springs, large beside the rounding of coordinates.
        size = 1e-6 * (1.0 + float(max(np.abs(live.x[here]).max(), np.abs(live.y[here]).max())))
        step = size / max(float(np.abs(w).max()), 1e-300)
        ends = []
        for sign in (1.0, -1.0):
            for field, start, direction in zip(fields, origin, w, strict=True):
                field[here] = start + sign * step * direction
            spring_forces(body, probe, work, probe.x, probe.y, probe.vx, probe.vy)
            ends.append(np.array([work.fx[here], work.fy[here]]))
        for field, start in zip(fields, origin, strict=True):
            field[here] = start
        return (ends[1] - ends[0]) / (2.0 * step)

    def _cause(self, live: Live, w: Floats, limit: float, air: Floats) -> Cause:
        """Which law contributes most to the stiffest motion."""
        probe = self._probe
        whole = float((w * self._product(live, w, velocities=False)).sum())
        probe.couple_cos[:] = 0.0
        probe.couple_sin[:] = 0.0
        linear = float((w * self._product(live, w, velocities=False)).sum())
        parts: dict[Cause, float] = {
            "linear stiffness": limit * limit * linear,
            "angular stiffness": limit * limit * (whole - linear),
            "linear damping": 2.0 * limit * float((w * self._product(live, w, velocities=True)).sum()),
            "air friction": 2.0 * limit * float((w * air * w).sum()),
        }
        return max(parts, key=lambda cause: parts[cause])


def _largest_step(k: Floats, c: Floats) -> tuple[float, Floats]:
    """The smallest dt > 0 with (dt² k + 2 dt c) y = 4 y for some y, and that y; infinite where there is none.

    With s = 1/dt it is s² y = s (c / 2) y + (k / 4) y, the eigenvalues of a companion matrix.
    """
    n = len(k)
    values, vectors = np.linalg.eig(np.block([[np.zeros((n, n)), np.eye(n)], [k / 4.0, c / 2.0]]))
    real = np.where(np.abs(np.imag(values)) <= 1e-6 * np.abs(values), np.real(values), 0.0)
    best = int(np.argmax(real))
    # Below this, nothing pulls: the step could be a day.
    if not real[best] > 1e-5:
        return np.inf, np.zeros(n)
    return 1.0 / float(real[best]), np.real(vectors[:n, best])
