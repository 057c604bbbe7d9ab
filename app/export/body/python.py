"""A body as a program in Python with NumPy."""

from __future__ import annotations

import numpy as np

from .body import Body
from .program import (
    OF_CIRCLES,
    OF_FILLINGS,
    OF_LOADS,
    OF_WALLS,
    STEPS,
    Plan,
    about,
    comment,
    load_columns,
    rest_terms,
    rows,
)


def python_program(body: Body) -> tuple[bytes, list[str]]:
    """The program, and what whoever uses it should know: sentences without a full stop.

    Raises:
        InputError: something acts on the body that a program cannot do.
    """
    plan = Plan.of(body)
    lines = [f"# {line}".rstrip() for line in about(plan, "python FILE.py")]
    lines += ["import sys", "", "import numpy as np", "", *_settings(plan), *_masses(plan)]
    if len(body.ends):
        lines += _springs(plan)
    lines += [*_around(plan), *_accelerations(plan), *_step(plan)]
    return "\n".join((*lines, "")).encode("ascii"), plan.notes


def _settings(plan: Plan) -> list[str]:
    scene = plan.body.scene
    lines = [f"DT = {scene.integrator.dt!r}  # time step, s"]
    if plan.weighs:
        lines.append(f"GRAVITY = np.array({_pair(scene.gravity)})  # px/s^2")
    if plan.air:
        lines.append(f"AIR = {scene.air_friction!r}  # air friction, kg/px")
    if plan.windy:
        lines.append(f"WIND = np.array({_pair(plan.body.wind)})  # velocity of the air, px/s")
    return [*lines, ""]


def _masses(plan: Plan) -> list[str]:
    body = plan.body
    columns = [*body.positions.T, *body.velocities.T, body.mass]
    if plan.holds:
        columns.append(body.held.astype(int))
    held = ", and 1 where it is held" if plan.holds else ""
    lines = [
        f"# A row for each mass: x, y (px), velocity x, y (px/s), mass (kg){held}.",
        *_table("MASSES", columns),
        "MASS = MASSES[:, 4:5]",
    ]
    if plan.holds:
        lines.append("FREE = MASSES[:, 5:6] == 0")
    return [*lines, ""]


def _springs(plan: Plan) -> list[str]:
    body = plan.body
    names, said = ["K", "REST"], ["stiffness (kg/s^2)", "rest length (px)"]
    columns = [*body.ends.T, body.stiffness, body.rest_length]
    if plan.damped:
        names, said = [*names, "C"], [*said, "damping (kg/s)"]
        columns.append(body.damping)
    lines = [
        f"# A row for each spring: its masses a and b, {', '.join(said)}.",
        *_table("SPRINGS", columns),
        "A, B = SPRINGS[:, :2].astype(int).T",
        f"{', '.join(names)} = SPRINGS[:, 2:].T",
        "",
    ]
    if not plan.law:
        return lines
    columns = [*body.joints.T, body.joint_stiffness]
    if plan.law == "angle":
        names, said = ["JOINT_K", "REST_ANGLE"], ["stiffness (kg/s^2)", "rest angle (radians)"]
        columns.append(np.radians(body.rest_angle))
    else:
        names, said = ["JOINT_K", "COS", "SIN"], ["stiffness (kg/s^2)", "cosine and sine of its rest angle"]
        columns += rest_terms(body.rest_angle)
    if plan.joints_damped:
        names, said = [*names, "JOINT_C"], [*said, "damping (kg/s)"]
        columns.append(body.joint_damping)
    return [
        *lines,
        f"# A row for each joint: its springs p and q, {', '.join(said)}.",
        *_table("JOINTS", columns),
        "P, Q = JOINTS[:, :2].astype(int).T",
        f"{', '.join(names)} = JOINTS[:, 2:].T",
        "",
    ]


def _around(plan: Plan) -> list[str]:
    body, lines = plan.body, []
    if body.loads:
        lines += [*comment("#", OF_LOADS), *_table("LOADS", load_columns(body)), ""]
    if body.loops:
        lines += [
            *comment("#", f"{OF_FILLINGS}."),
            "FILLINGS = [",
        ]
        lines += [
            f"    ({loop.is_gas}, {loop.pressure!r}, {loop.outside!r}, {loop.area!r}, {loop.masses}),"
            for loop in body.loops
        ]
        lines += ["]", ""]
    if len(body.walls):
        lines += [
            *comment("#", OF_WALLS),
            "WALLS = [",
            *rows(list(body.walls.T), "(", ")"),
            "]",
            "",
        ]
    if body.circles:
        lines += [
            *comment("#", OF_CIRCLES),
            "CIRCLES = [",
        ]
        lines += [
            f"    ({mass}, {_pair(place)}, {circle.radius!r}, {circle.frequency!r}, {circle.ramp!r}),"
            for mass, (circle, place) in body.circles.items()
        ]
        lines += ["]", ""]
    return lines


# ------------------------------------------------------------------------- code
def _accelerations(plan: Plan) -> list[str]:
    body = plan.body
    code = ["force = np.zeros_like(x)"]
    if body.loads:
        code += ["force[LOADS[:, 0].astype(int)] = LOADS[:, 1:]"]
    if len(body.ends):
        code += _SPRINGS
        if plan.damped or plan.joints_damped:
            code += ["rate = v[B] - v[A]"]
        code += ["pull = -K * (length - REST)"]
        if plan.damped:
            code += ["pull -= C * (spring * rate).sum(1) / length"]
        code += ["on_b = spring * (pull / length)[:, None]  # the force on mass b; minus it acts on a"]
        if plan.law:
            code += _bending(plan)
        code += ["np.add.at(force, B, on_b)", "np.add.at(force, A, -on_b)"]
    if body.loops:
        code += _FILLINGS
    code += ["a = force / MASS"]
    if plan.air:
        code += ["air = v - WIND" if plan.windy else "air = v"]
        code += ["a -= AIR * air * abs(air) / MASS  # along each axis"]
    if plan.weighs:
        code += ["a += GRAVITY"]
    if len(body.walls):
        code += _WALLS
    code += ["return np.where(FREE, a, 0.0)" if plan.holds else "return a"]
    return ["", "def accelerations(x, v):", '    """Of all masses, px/s^2."""', *_indented(code), ""]


_SPRINGS = [
    "spring = x[B] - x[A]",
    "length = np.sqrt((spring * spring).sum(1) + 1e-300)  # never 0, to divide by it",
]


def _bending(plan: Plan) -> list[str]:
    """The torque on the joints' springs, as forces on the springs' ends; see `sim.physics`."""
    code = [
        "# Joints: the angle from p to q is drawn to the rest angle.",
        "p, q = spring[P], spring[Q]",
        "cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]",
        "dot = (p * q).sum(1)",
    ]
    if plan.law == "angle":
        code += [
            "off = np.arctan2(cross, dot) - REST_ANGLE",
            "off -= 2.0 * np.pi * np.round(off / (2.0 * np.pi))",
            "torque = JOINT_K * length[P] * length[Q] * off",
            "energy = 0.5 * torque * off  # it grows with the lengths, and so pulls along the springs",
        ]
    else:
        code += ["torque = JOINT_K * (COS * cross - SIN * dot)"]
    if plan.law == "conservative":
        code += [
            "# The energy grows with the lengths, and so pulls along the springs.",
            "energy = JOINT_K * (length[P] * length[Q] - COS * dot - SIN * cross)",
        ]
    if plan.joints_damped:
        code += [
            "turning = (spring[:, 0] * rate[:, 1] - spring[:, 1] * rate[:, 0]) / length**2",
            "torque += JOINT_C * length[P] * length[Q] * (turning[Q] - turning[P])",
        ]
    code += [
        "across = np.stack((-spring[:, 1], spring[:, 0]), 1) / (length**2)[:, None]",
        "np.add.at(on_b, P, torque[:, None] * across[P])",
        "np.add.at(on_b, Q, -torque[:, None] * across[Q])",
    ]
    if plan.law != "tutorial":
        code += [
            "along = spring / (length**2)[:, None]",
            "np.add.at(on_b, P, -energy[:, None] * along[P])",
            "np.add.at(on_b, Q, -energy[:, None] * along[Q])",
        ]
    return code


_FILLINGS = [
    "for is_gas, strength, outside, size, loop in FILLINGS:",
    "    before, after, off = np.roll(x[loop], 1, 0), np.roll(x[loop], -1, 0), x[loop] - x[loop[0]]",
    "    next_off = np.roll(off, -1, 0)",
    "    area = 0.5 * (off[:, 0] * next_off[:, 1] - off[:, 1] * next_off[:, 0]).sum()",
    "    if not is_gas:",
    "        pressure = strength * (1.0 - area / size)",
    "    elif area > 0.01 * size:",
    "        pressure = strength * size / area - outside",
    "    else:  # nearly nothing is left: no division by zero",
    "        pressure = strength * (2.0 - area / (0.01 * size)) / 0.01 - outside",
    "    way = after - before",
    "    np.add.at(force, loop, 0.5 * pressure * np.stack((way[:, 1], -way[:, 0]), 1))",
]

_WALLS = [
    "# Walls push with the square of the depth, softened so that a long step makes no energy.",
    "for px, py, nx, ny, hardness, friction, slip, loss in WALLS:",
    "    depth = np.maximum((px - x[:, 0]) * nx + (py - x[:, 1]) * ny, 0.0)",
    "    out, along = v[:, 0] * nx + v[:, 1] * ny, v[:, 1] * nx - v[:, 0] * ny",
    "    power = (DT * (loss * hardness * depth**2 + 4.0 * DT * hardness * depth)) ** 4",
    "    more = 0.5 * DT / np.maximum(depth, 1e-300) * power / (1.0 + power)",
    "    push = hardness * depth**2 * np.maximum(1.0 - (loss + more) * out, 0.0)",
    "    push /= (1.0 + power) ** 0.25",
    "    slips = (slip**4 + (DT * friction * push) ** 4) ** 0.25",
    "    rub = friction * push * np.tanh(along / slips)",
    "    a += np.stack((push * nx + rub * ny, push * ny - rub * nx), 1)",
]


def _step(plan: Plan) -> list[str]:
    lines, start = [], plan.body.moment.time
    step = ["v += DT * accelerations(x, v)", "x += DT * v"]
    if plan.body.circles:
        lines += [
            "",
            "def lead(x, v, t):",
            '    """Put masses on circles where they are at time t."""',
            "    for mass, (at_x, at_y), radius, frequency, ramp in CIRCLES:",
            "        fade, turn = np.exp(-t / ramp), 2.0 * np.pi * frequency",
            "        phase, speed = turn * (t - ramp * (1.0 - fade)), radius * turn * (1.0 - fade)",
            "        x[mass] = at_x + radius * np.sin(phase), at_y + radius * (1.0 - np.cos(phase))",
            "        v[mass] = speed * np.cos(phase), speed * np.sin(phase)",
            "",
        ]
        step = ["lead(x, v, t + DT)", *step, "lead(x, v, t + DT)  # the step has moved them"]
    call = f"step(x, v, {start!r} + i * DT)" if plan.body.circles else "step(x, v)"
    return [
        *lines,
        "",
        f"def step(x, v{', t' if plan.body.circles else ''}):",
        f'    """One time step{" from time t (s)" if plan.body.circles else ""}, in place."""',
        *_indented(step),
        "",
        "",
        'if __name__ == "__main__":',
        "    x, v = MASSES[:, 0:2].copy(), MASSES[:, 2:4].copy()",
        f"    steps = int(sys.argv[1]) if len(sys.argv) > 1 else {STEPS}",
        f"    for {'i' if plan.body.circles else '_'} in range(steps):",
        f"        {call}",
        "    for at in x.tolist():",
        "        print(*at)",
    ]


def _table(name: str, columns: list[np.ndarray]) -> list[str]:
    return [f"{name} = np.array([", *rows(columns, "(", ")"), "])"]


def _pair(pair: tuple[float, float]) -> str:
    return f"({float(pair[0])!r}, {float(pair[1])!r})"


def _indented(code: list[str]) -> list[str]:
    return [f"    {line}" for line in code]
