"""Bodies that are exported, as data and as programs."""

from __future__ import annotations

from msgspec.structs import replace as changed

import sim
from app.export.body.body import Body
from tests.sim.surrounded import ONE_SIDED, around

EULER = sim.Integrator(method="symplectic_euler")

STEPS = 400

CLOSE = 1e-9
"""px"""


def body_of(scene: sim.Scene) -> Body:
    return Body.of(sim.Simulation(scene).capture())


LOOSE = sim.Scene(
    name="loose",
    masses=tuple(sim.Mass(position=(100.0 * i, 300.0), velocity=(90.0, 0.0), mass=1 + i) for i in range(3)),
    walls=(sim.Wall(point=(0.0, 500.0), normal=(1.0, -3.0), friction=0.3),),
    gravity=(0.0, 900.0),
)

DAMPED = sim.rope(masses=7, length=240.0, direction=(1.0, 0.2), angular_damping=30.0, rest_angle=20.0)

LOADED = changed(
    DAMPED,
    bodies=(),
    masses=tuple(
        changed(m, force=(300.0 * i, -4000.0)) if i % 3 == 2 else m for i, m in enumerate(DAMPED.masses)
    ),
)

MUSCULAR = changed(
    DAMPED,
    bodies=(),
    beat=sim.Beat(frequency=1.7, phase=40.0),
    linear_springs=tuple(
        changed(s, muscle=sim.SpringMuscle(amplitude=0.2, phase=50.0 * i, per_beat=1 + i % 3)) if i % 2 else s
        for i, s in enumerate(DAMPED.linear_springs)
    ),
    angular_springs=tuple(
        changed(j, muscle=sim.JointMuscle(amplitude=-30.0, phase=70.0 * i, wave="pulse")) if i % 3 else j
        for i, j in enumerate(DAMPED.angular_springs)
    ),
)

ONE_SIDED_GIRDER = around(ONE_SIDED)
"""Its springs and joints begin and end to act as it moves."""
