"""What the keys and the pointer do at the start of a step: the same for every path and integrator."""

from __future__ import annotations

import math

from .jit import kernel
from .tables import CONTROL_SCALE, CONTROL_SHIFT, SCALE_MAX, SCALE_MIN


@kernel()
def wrap(angle):
    """Wrap once into (-180, 180] degrees, as the tutorial does."""
    if angle > 180.0:
        return angle - 360.0
    if angle <= -180.0:
        return angle + 360.0
    return angle


@kernel()
def refresh(body, live):
    """Recompute what depends on the scale of rest lengths and the shift of rest angles."""
    scale = live.controls[CONTROL_SCALE]
    shift = live.controls[CONTROL_SHIFT]
    for s in range(body.springs):
        live.pull[s] = body.stiffness[s] * (body.rest_length[s] * scale)
    for j in range(body.joints):
        rest = math.radians(wrap(body.joint_rest[j] + shift))
        live.couple_cos[j + 1] = body.joint_stiffness[j] * math.cos(rest)
        live.couple_sin[j + 1] = body.joint_stiffness[j] * math.sin(rest)
        live.couple_rest[j + 1] = rest
    if body.ring:
        live.couple_cos[0] = live.couple_cos[body.joints]
        live.couple_sin[0] = live.couple_sin[body.joints]


@kernel(inner=True)
def lead_and_press(body, live, motion, step, steps):
    """Step `step` of `steps`: first pointer and circles set their masses, then the keys do their work."""
    place_led(live, motion, step, steps)
    if motion.length_factor != 1.0 or motion.angle_step != 0.0:
        scale = live.controls[CONTROL_SCALE] * motion.length_factor
        live.controls[CONTROL_SCALE] = min(max(scale, SCALE_MIN), SCALE_MAX)
        live.controls[CONTROL_SHIFT] = wrap(live.controls[CONTROL_SHIFT] + motion.angle_step)
        refresh(body, live)


@kernel(inner=True)
def place_led(live, motion, step, steps):
    """Put the masses that are led, and those on circles, where they are at the end of a step."""
    part = (step + 1) / steps
    for i in range(motion.mass.size):
        m = motion.mass[i]
        x, y, vx, vy = motion.to_x[i], motion.to_y[i], motion.vx[i], motion.vy[i]
        if step + 1 < steps:
            x = motion.from_x[i] + (motion.to_x[i] - motion.from_x[i]) * part
            y = motion.from_y[i] + (motion.to_y[i] - motion.from_y[i]) * part
        if motion.radius[i] > 0.0:
            dx, dy, du, dv = circle_at(
                motion.start + (step + 1) * motion.dt, motion.radius[i], motion.omega[i], motion.ramp[i]
            )
            x, y, vx, vy = x + dx, y + dy, vx + du, vy + dv
        live.x[m], live.y[m], live.vx[m], live.vy[m] = x, y, vx, vy


@kernel()
def circle_at(t, radius, omega, ramp):
    """How far an anchor on a circle is off its place at time t, and how fast it is: x, y, vx, vy."""
    fade = math.exp(-t / ramp)
    phase, rate = omega * (t - ramp * (1.0 - fade)), omega * (1.0 - fade)
    sine, cosine = math.sin(phase), math.cos(phase)
    return radius * sine, radius * (1.0 - cosine), radius * cosine * rate, radius * sine * rate
