"""The stable spring method: limits every spring to the stiffness at which symplectic Euler is stable.

After M. Nissen, "Towards a simpler, stiffer and more stable spring" (2014): a spring between masses m1 and m2
with f = -(m_red / dt²) C_k x - (m_red / dt) C_d v, m_red = m1 m2 / (m1 + m2), cannot explode for C_k, C_d up
to 1, divided among the springs that share a mass. Here a spring keeps the scene's stiffness and damping where
they are below this limit. Joints are treated in the same way, with the moment of inertia of the angle at rest
lengths in place of the reduced mass.
"""

from __future__ import annotations

import numpy as np

from ..engine.tables import Body, Floats
from ..scene.types import Scene
from ..text import Text
from .system import build_system


def clamp_stiffness(body: Body, inverse_mass: Floats, held: np.ndarray, dt: float) -> Body:
    """Return the tables with the stiffness and damping of all springs and joints limited for a step `dt`.

    Args:
        body: the tables of the scene.
        inverse_mass: (n,) 1/kg, in slot order.
        held: (n,) whether a mass is held, in slot order.
        dt: the step, s.
    """
    free = np.concatenate(([0.0], np.where(held, 0.0, inverse_mass)))
    a, b, springs = body.spring_a, body.spring_b, body.springs
    at_mass = np.bincount(np.concatenate((a, b)), minlength=body.masses + 1)
    share = np.maximum(at_mass[a], at_mass[b])
    softness = free[a] + free[b]  # 1 / m_red; zero between two held masses
    with np.errstate(divide="ignore"):
        reduced = 1.0 / (softness * share)
    stiffness, damping = body.stiffness.copy(), body.damping.copy()
    stiffness[:springs] = np.minimum(stiffness[:springs], reduced / dt**2)
    damping[:springs] = np.minimum(damping[:springs], reduced / dt)
    size, resistance = body.angular_stiffness.copy(), body.torque_damping.copy()
    if body.joints:
        limit, joints = _joint_limit(body, free), slice(1, body.joints + 1)
        size[joints] = np.minimum(size[joints], limit / dt**2)
        size[0] = size[body.joints] if body.ring else 0.0
        resistance[joints] = np.minimum(resistance[joints], limit / dt)
    limited = {"angular_stiffness": size, "torque_damping": resistance}
    return body.replaced(stiffness=stiffness, damping=damping, **limited).read_only()


def softening(scene: Scene) -> float:
    """Return the largest factor by which the scene's method softens a spring or joint; 1 for none.

    Args:
        scene: a valid scene.
    """
    if scene.integrator.method != "stable_spring":
        return 1.0
    system = build_system(scene)
    body = system.body
    soft = clamp_stiffness(body, system.inverse_mass, system.held, scene.integrator.dt)
    factors = [
        own[own > 0.0] / limited[own > 0.0]
        for own, limited in (
            (body.stiffness, soft.stiffness),
            (body.angular_stiffness, soft.angular_stiffness),
        )
    ]
    return float(np.concatenate((*factors, (1.0,))).max())


def softening_note(scene: Scene) -> str:
    """Describe the effect of `softening`, in a sentence without a full stop; empty where there is none."""
    factor = softening(scene)
    if factor < 1.001:
        return ""
    return Text(
        "the method Stable spring makes springs up to {factor:.3g} times as soft at a time step of {step:g} "
        "s, so the body sags and swings accordingly in a run",
        factor=factor,
        step=scene.integrator.dt,
    )


def _joint_limit(body: Body, free: Floats) -> Floats:
    """Return the (J,) largest stiffness of each joint times dt², kg; also its largest damping times dt."""
    ends = joint_ends(body)
    at_mass = np.zeros(body.masses + 1, np.int64)
    for j in range(len(ends)):
        at_mass[np.unique(ends[j])] += 1
    share = at_mass[ends].max(1)
    with np.errstate(divide="ignore"):
        return 1.0 / (joint_softness(body, free) * share)


def joint_ends(body: Body) -> np.ndarray:
    """Return the (J, 4) slots of the masses at the ends of both springs of each joint."""
    p, q = body.joint_a, body.joint_b
    return np.stack((body.spring_a[p], body.spring_b[p], body.spring_a[q], body.spring_b[q]), 1)


def joint_softness(body: Body, free: Floats) -> Floats:
    """Return the (J,) squared angular frequency per stiffness of each uncoupled joint with springs in line,
    1/kg.

    In line means that both springs, seen from the shared mass, are 180 degrees apart. At any other angle it
    is lower.

    Args:
        body: the tables.
        free: (n + 1,) 1/kg, by slot; zero where a mass is held.
    """
    ends = joint_ends(body)
    lengths = np.maximum(body.rest_length, 1e-9)
    la, lb = lengths[body.joint_a], lengths[body.joint_b]
    # Derivatives of the angle with respect to the position of each end, for springs in line. The effects of
    # the shared mass on both springs add up. The signs depend on the directions of the springs, and are
    # omitted.
    slopes = np.stack((1.0 / la, 1.0 / la, 1.0 / lb, 1.0 / lb), 1)
    softness = np.zeros(len(ends))
    for i in range(4):
        together = (slopes * (ends == ends[:, i : i + 1])).sum(1)
        first = (ends[:, :i] != ends[:, i : i + 1]).all(1)
        softness += np.where(first, together**2 * free[ends[:, i]], 0.0)
    return softness * la * lb
