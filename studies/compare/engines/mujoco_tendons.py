"""MuJoCo: point masses on two slides each, and a tendon for each spring.

Steps of a scene in which no mass is led are one call; a led mass is put where it is before every step.
"""

from __future__ import annotations

from sim import Scene

from ..engine import package, per_second
from ..measure import Contender, ladder
from ..plain import PlainSystem
from ..runs import SECONDS, Failed, Floats, Runner

RATES = tuple(60.0 * 2**i for i in range(2, 13))
"""Steps per second."""

LARGE = 1e9
"""Mass of a led mass, kg, so that springs do not move it between two steps."""


def paths(scene: Scene) -> list[Contender]:
    """Three integrators on a rope or a net."""
    system = PlainSystem(scene)
    return [
        Contender(
            "MuJoCo",
            integrator,
            ladder(RATES),
            per_second("steps"),
            lambda rate, integrator=integrator: _Run(system, rate, integrator),
        )
        for integrator in ("Euler", "implicitfast", "RK4")
    ]


def model_of(system: PlainSystem, rate: float, integrator: str) -> str:
    """Return MuJoCo's XML; its x and z are x and -y."""
    g = system.gravity
    bodies, tendons = [], []
    for i, (mass, held) in enumerate(zip(system.masses, system.held, strict=True)):
        x, y = system.start[4 * i : 4 * i + 2]
        led = i == 0 and system.circle is not None
        slides = '<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/>'
        weight = LARGE if led else mass
        inertia = f'<inertial pos="0 0 0" mass="{weight:.17g}" diaginertia="1 1 1"/>'
        bodies.append(
            f'<body pos="{x:.17g} 0 {-y:.17g}"{" gravcomp=" + chr(34) + "1" + chr(34) if led else ""}>'
            f'{slides if led or not held else ""}{inertia}<site name="s{i}"/></body>'
        )
    for (a, b), (k, c, rest) in zip(system.springs, system.numbers, strict=True):
        tendons.append(
            f'<spatial stiffness="{k:.17g}" damping="{c:.17g}" springlength="{rest:.17g}">'
            f'<site site="s{a}"/><site site="s{b}"/></spatial>'
        )
    return (
        f'<mujoco><option timestep="{1.0 / rate:.17g}" integrator="{integrator}" jacobian="sparse" '
        f'gravity="{g[0]:.17g} 0 {-g[1]:.17g}"><flag contact="disable" constraint="disable"/></option>'
        f"<worldbody>{''.join(bodies)}</worldbody><tendon>{''.join(tendons)}</tendon></mujoco>"
    )


class _Run(Runner):
    """A rope or a net."""

    def __init__(self, system: PlainSystem, rate: float, integrator: str) -> None:
        mujoco = package("mujoco")

        self._mujoco = mujoco
        mujoco.set_mju_user_warning(lambda _: None)  # it would write them into a file
        self._system, self._steps = system, round(rate * SECONDS)
        self._model = mujoco.MjModel.from_xml_string(model_of(system, rate, integrator))
        self._data = mujoco.MjData(self._model)
        self._start = system.start.reshape(-1, 4)[:, :2]
        self._moving = ~system.held
        if system.circle is not None:
            self._moving[0] = True

    def restart(self) -> None:
        self._mujoco.mj_resetData(self._model, self._data)

    def advance(self) -> None:
        model, data, system = self._model, self._data, self._system
        if system.circle is None:
            self._mujoco.mj_step(model, data, self._steps)
        else:
            step, qpos, qvel = SECONDS / self._steps, data.qpos, data.qvel
            x, y = self._start[0]
            for i in range(self._steps):
                at = system.lead_at(i * step)
                qpos[0], qpos[1], qvel[0], qvel[1] = at[0] - x, y - at[1], at[2], -at[3]
                self._mujoco.mj_step(model, data)
        if any(data.warning[kind].number for kind in range(len(data.warning))):
            raise Failed("ran away")

    def positions(self) -> Floats:
        found = self._start.copy()
        found[self._moving] += self._data.qpos.reshape(-1, 2) * (1.0, -1.0)
        if self._system.circle is not None:
            found[0] = self._system.lead_at(SECONDS)[:2]
        return found
