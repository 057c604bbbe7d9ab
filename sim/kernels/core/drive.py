"""The motion of held masses, and the effect of held keys, at any time."""

from __future__ import annotations

import math

from ..engine.jit import kernel
from .tables import CONTROL_SCALE, CONTROL_SHIFT, SCALE_MAX, SCALE_MIN


@kernel(internal=True)
def wrap(angle):
    """Wrap once into (-180, 180] degrees, as the tutorial does."""
    if angle > 180.0:
        return angle - 360.0
    if angle <= -180.0:
        return angle + 360.0
    return angle


@kernel(internal=True)
def refresh(body, state):
    """Recompute what depends on the scale of rest lengths and the shift of rest angles."""
    scale = state.controls[CONTROL_SCALE]
    shift = state.controls[CONTROL_SHIFT]
    for s in range(body.springs):
        state.rest_tension[s] = body.stiffness[s] * (body.rest_length[s] * scale)
    if body.limits.present:
        for s in range(body.springs):
            state.rest_tension[s] += body.stiffness[s] * state.set_length[s]
    for j in range(body.joints):
        degrees = wrap(body.joint_rest[j] + shift)
        if body.limits.present:
            degrees = wrap(degrees + state.set_angle[j])
        rest = math.radians(degrees)
        state.torque_cos[j + 1] = body.torque_size[j + 1] * math.cos(rest)
        state.torque_sin[j + 1] = body.torque_size[j + 1] * math.sin(rest)
        state.torque_rest[j + 1] = rest
    if body.ring:
        state.torque_cos[0] = state.torque_cos[body.joints]
        state.torque_sin[0] = state.torque_sin[body.joints]


@kernel(internal=True)
def circle_at(t, radius, omega, ramp):
    """Displacement and velocity at time t of an anchor on a circle: x, y (px), vx, vy (px/s)."""
    fade = math.exp(-t / ramp)
    phase, rate = omega * (t - ramp * (1.0 - fade)), omega * (1.0 - fade)
    sine, cosine = math.sin(phase), math.cos(phase)
    return radius * sine, radius * (1.0 - cosine), radius * cosine * rate, radius * sine * rate


@kernel(forceinline=True)
def hand_speed(drive, i, t):
    """The velocity at time t with which the i-th mass of the drive is led by hand, px/s."""
    since = t - drive.start
    return (
        drive.vx[i] + since * (drive.ax[i] + 0.5 * since * drive.jx[i]),
        drive.vy[i] + since * (drive.ay[i] + 0.5 * since * drive.jy[i]),
    )


@kernel(forceinline=True)
def drive_to(body, state, drive, t, q, v):
    """Set the held masses in q and v to their state at time t, and rest lengths and angles likewise."""
    lead_to(drive, t, q, v)
    act_at(body, state, drive, t)


@kernel(forceinline=True)
def act_at(body, state, drive, t):
    """Set the clock of the gusts to time t, and rest lengths and angles to what held keys make of them then.

    A step that is refused has set them to a later time.
    """
    if drive.timed:
        state.clock[0] = t
    if drive.pressed:
        since = t - drive.start
        scale, shift = drive.scale * math.exp(drive.growth * since), drive.shift + drive.turn * since
        set_controls(body, state, scale, shift)


@kernel(forceinline=True)
def press(body, state, drive, h):
    """Let held keys act for h more seconds; unlike `drive_to`, the same for any grouping of steps."""
    if drive.pressed:
        scale = state.controls[CONTROL_SCALE] * math.exp(drive.growth * h)
        set_controls(body, state, scale, state.controls[CONTROL_SHIFT] + drive.turn * h)


@kernel(internal=True)
def set_controls(body, state, scale, shift):
    """Set the scale of rest lengths, clamped to its range, and the shift of rest angles, degrees, wrapped."""
    state.controls[CONTROL_SCALE] = min(max(scale, SCALE_MIN), SCALE_MAX)
    state.controls[CONTROL_SHIFT] = 180.0 - (180.0 - shift) % 360.0
    refresh(body, state)


@kernel(forceinline=True)
def lead_to(drive, t, q, v):
    """Set the held masses in q and v to their state at time t."""
    slots = q.size // 2
    # A hand must not go beyond its target because of rounding in the time.
    since = min(t - drive.start, drive.duration)
    for i in range(drive.mass.size):
        m = drive.mass[i]
        x = drive.x[i] + since * (drive.vx[i] + since * (0.5 * drive.ax[i] + since / 6.0 * drive.jx[i]))
        y = drive.y[i] + since * (drive.vy[i] + since * (0.5 * drive.ay[i] + since / 6.0 * drive.jy[i]))
        vx, vy = hand_speed(drive, i, t)
        vx, vy = vx * drive.hand[i], vy * drive.hand[i]
        if drive.radius[i] > 0.0:
            dx, dy, du, dv = circle_at(t, drive.radius[i], drive.omega[i], drive.ramp[i])
            x, y, vx, vy = x + dx, y + dy, vx + du, vy + dv
        q[m], q[slots + m] = x, y
        v[m], v[slots + m] = vx, vy
