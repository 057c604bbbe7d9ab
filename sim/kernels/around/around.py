"""The accelerations, energies and powers of a body in surroundings."""

from __future__ import annotations

from ..core.jit import FAST, kernel
from ..forces.forces import from_forces, spring_forces
from .contact import push_apart
from .fillings import press_from_inside
from .walls import push_from_walls
from .wind import blow


@kernel(fastmath=FAST)
def accelerations_around(body, state, scratch, q, v, a):
    """Like `forces.forces.accelerations`, for a body in surroundings."""
    slots = q.size // 2
    x, y, vx, vy, ax, ay = q[:slots], q[slots:], v[:slots], v[slots:], a[:slots], a[slots:]
    around = body.surroundings
    spring_forces(body, state, scratch, x, y, vx, vy)
    press_from_inside(around, x, y, scratch.fx, scratch.fy)
    if around.contact.present:
        push_apart(body, state.inverse_mass, x, y, vx, vy, scratch.fx, scratch.fy)
    from_forces(body, state, scratch, vx, vy, a)
    push_from_walls(body, state.inverse_mass, x, y, vx, vy, ax, ay)
    if around.air_friction > 0.0:
        blow(body, state, scratch, x, y, vx, vy, ax, ay)
