"""Symplectic Euler on any topology, under any force law."""

from __future__ import annotations

from .controls import lead_and_press, place_led
from .forces import internal_forces
from .guard import DONE, GOOD, STRIDE, WHAT, judge, keep
from .jit import FUSED, kernel
from .lanes import whole_eights


@kernel(fastmath=FUSED)
def run_general(body, live, work, motion, kept, progress, dt, steps, has_air, farthest, fastest):
    """Do `steps` steps, or as many as go well; arguments as those of `run_chain`."""
    masses = whole_eights(body.masses)
    while progress[DONE] < steps and progress[WHAT] == GOOD:
        done = progress[DONE]
        count = min(progress[STRIDE], steps - done)
        keep(live, kept)
        for step in range(done, done + count):
            if motion.active:
                lead_and_press(body, live, motion, step, steps)
            internal_forces(False, body, live, work, live.x, live.y, live.vx, live.vy)
            general_axis(live.x, live.vx, work.fx, live.dt_mass, live.dt_air, live.dt_gx, dt, masses, has_air)
            general_axis(live.y, live.vy, work.fy, live.dt_mass, live.dt_air, live.dt_gy, dt, masses, has_air)
            if motion.active:
                place_led(live, motion, step, steps)  # those that have a speed were moved on by it
        judge(body, live, kept, progress, count, farthest, fastest)


@kernel()
def run_held(body, live, motion, kept, progress, steps, farthest, fastest):
    """The steps of a body all of whose masses are held: no forces, only circles, the pointer and the keys."""
    while progress[DONE] < steps and progress[WHAT] == GOOD:
        done = progress[DONE]
        count = min(progress[STRIDE], steps - done)
        keep(live, kept)
        for step in range(done, done + count):
            lead_and_press(body, live, motion, step, steps)
        judge(body, live, kept, progress, count, farthest, fastest)


@kernel(inline="always")
def general_axis(position, velocity, force, dt_mass, dt_air, dt_gravity, dt, masses, has_air):
    """v += dt F/m, then x += dt v, along one axis."""
    if has_air:
        for i in range(1, masses + 1):
            v = velocity[i]
            v = v + (force[i] * dt_mass[i] - dt_air[i] * (v * abs(v)) + dt_gravity[i])
            velocity[i] = v
            position[i] += v * dt
    else:
        for i in range(1, masses + 1):
            v = velocity[i] + (force[i] * dt_mass[i] + dt_gravity[i])
            velocity[i] = v
            position[i] += v * dt
