"""The motion of held masses, and the effect of held keys and of muscles, at any time."""

from __future__ import annotations

import math

from ..engine.jit import kernel
from ..engine.numerics.waves import wave
from ..engine.tables import CONTROL_SCALE, CONTROL_SHIFT, SCALE_MAX, SCALE_MIN, LeadParameters


@kernel(internal=True)
def wrap(angle):
    """Wrap once into (-180, 180] degrees, as the tutorial does."""
    if angle > 180.0:
        return angle - 360.0
    if angle <= -180.0:
        return angle + 360.0
    return angle


@kernel(internal=True)
def update_rest_state(body, state):
    """Recompute what depends on the scale of rest lengths, the shift of rest angles, and the clock."""
    scale = state.controls[CONTROL_SCALE]
    for s in range(body.springs):
        rest = body.rest_length[s] * scale
        if body.limits.present:
            rest += state.set_length[s]
        state.rest_tension[s] = body.stiffness[s] * rest
    for j in range(body.joints):
        _turn_to(body, state, j, 0.0)
    if body.ring:
        state.torque_cos[0] = state.torque_cos[body.joints]
        state.torque_sin[0] = state.torque_sin[body.joints]
    if body.limits.present:
        for s in range(body.springs):
            state.trial_tension[s] = state.rest_tension[s]
    if body.muscles.present:
        actuate_muscles(body, state)


@kernel(internal=True)
def actuate_muscles(body, state):
    """Let muscles move rest lengths and rest angles to where they are at the time of the clock."""
    muscles, t, scale = body.muscles, state.clock[0], state.controls[CONTROL_SCALE]
    for i in range(muscles.spring.size):
        s = muscles.spring[i]
        rest = body.rest_length[s] * scale * (1.0 + wave(muscles.stretch[i], state.steer, t))
        if body.limits.present:
            rest += state.set_length[s]
            state.trial_tension[s] = body.stiffness[s] * rest
        state.rest_tension[s] = body.stiffness[s] * rest
    for i in range(muscles.joint.size):
        _turn_to(body, state, muscles.joint[i], wave(muscles.turn[i], state.steer, t))
    if body.ring and muscles.joint.size:
        state.torque_cos[0] = state.torque_cos[body.joints]
        state.torque_sin[0] = state.torque_sin[body.joints]


@kernel(internal=True)
def _turn_to(body, state, j, more):
    """Set the rest angle of a joint: its own, with the shift and `more` degrees."""
    degrees = wrap(body.joint_rest[j] + state.controls[CONTROL_SHIFT])
    if body.limits.present:
        degrees = wrap(degrees + state.set_angle[j])
    rest = math.radians(wrap(degrees + more))
    state.torque_cos[j + 1] = body.angular_stiffness[j + 1] * math.cos(rest)
    state.torque_sin[j + 1] = body.angular_stiffness[j + 1] * math.sin(rest)
    state.torque_rest[j + 1] = rest
    if body.limits.present:
        state.trial_angle[j] = rest


@kernel(internal=True)
def circle_at(t, radius, omega, ramp):
    """Displacement and velocity at time t of an anchor on a circle: x, y (px), vx, vy (px/s)."""
    fade = math.exp(-t / ramp)
    phase, rate = omega * (t - ramp * (1.0 - fade)), omega * (1.0 - fade)
    sine, cosine = math.sin(phase), math.cos(phase)
    return radius * sine, radius * (1.0 - cosine), radius * cosine * rate, radius * sine * rate


@kernel(forceinline=True)
def lead_of(drive, i):
    """How the i-th mass of the drive is led."""
    row = drive.rows[i]
    return LeadParameters(
        row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8], row[9], row[10], row[11],
        row[12], row[13],
    )  # fmt: skip


@kernel(forceinline=True)
def hand_speed(lead, since):
    """The velocity with which a mass is led by hand, so many seconds after the start, px/s."""
    return (
        lead.vx + since * (lead.ax + 0.5 * since * lead.jx),
        lead.vy + since * (lead.ay + 0.5 * since * lead.jy),
    )


@kernel(forceinline=True)
def drive_to(body, state, drive, t, q, v):
    """Set the held masses in q and v, and rest lengths and angles, to their state at time t."""
    lead_to(drive, t, q, v)
    apply_controls_at(body, state, drive, t)


@kernel(forceinline=True)
def apply_controls_at(body, state, drive, t):
    """Set the clock to time t, and rest lengths and angles to what held keys and muscles make of them then.

    A step that is refused has set them to a later time.
    """
    scale, shift = drive.scale, drive.shift
    if drive.pressed:
        since = t - drive.start
        scale, shift = scale * math.exp(drive.growth * since), shift + drive.turn * since
    apply_controls(body, state, drive, t, scale, shift)


@kernel(forceinline=True)
def apply_controls(body, state, drive, t, scale, shift):
    """Set the clock to time t, muscles to what they are then, and what held keys change to given values."""
    if drive.timed:
        state.clock[0] = t
    if drive.pressed:
        set_controls(body, state, scale, shift)
    elif body.muscles.present:
        actuate_muscles(body, state)


@kernel(forceinline=True)
def integrate_keys(body, state, drive, t, h):
    """Set the clock to time t, and let held keys act for h more seconds.

    Unlike `drive_to`, this is the same for any grouping of steps.
    """
    scale, shift = state.controls[CONTROL_SCALE], state.controls[CONTROL_SHIFT]
    if drive.pressed:
        scale, shift = scale * math.exp(drive.growth * h), shift + drive.turn * h
    apply_controls(body, state, drive, t, scale, shift)


@kernel(internal=True)
def set_controls(body, state, scale, shift):
    """Set the scale of rest lengths, clamped to its range, and the shift of rest angles, degrees, wrapped."""
    state.controls[CONTROL_SCALE] = min(max(scale, SCALE_MIN), SCALE_MAX)
    state.controls[CONTROL_SHIFT] = 180.0 - (180.0 - shift) % 360.0
    update_rest_state(body, state)


@kernel(forceinline=True)
def lead_to(drive, t, q, v):
    """Set the held masses in q and v to their state at time t."""
    lead(drive, t, t, q, v)


@kernel(forceinline=True)
def lead(drive, t, round_at, q, v):
    """Set the held masses in q and v to where hands lead them at time t, and circles at time `round_at`."""
    slots = q.size // 2
    # A hand must not go beyond its target because of rounding in the time.
    since = min(t - drive.start, drive.duration)
    for i in range(drive.mass.size):
        m, by = drive.mass[i], lead_of(drive, i)
        x = by.x + since * (by.vx + since * (0.5 * by.ax + since / 6.0 * by.jx))
        y = by.y + since * (by.vy + since * (0.5 * by.ay + since / 6.0 * by.jy))
        vx, vy = hand_speed(by, t - drive.start)
        vx, vy = vx * by.hand, vy * by.hand
        if by.radius > 0.0:
            dx, dy, du, dv = circle_at(round_at, by.radius, by.omega, by.ramp)
            if by.along_x != 0.0 or by.along_y != 0.0:
                way, rate = by.along_x * dx + by.along_y * dy, by.along_x * du + by.along_y * dv
                dx, dy, du, dv = by.along_x * way, by.along_y * way, by.along_x * rate, by.along_y * rate
            x, y, vx, vy = x + dx, y + dy, vx + du, vy + dv
        q[m], q[slots + m] = x, y
        v[m], v[slots + m] = vx, vy
