"""A body as a program in C99 that needs no library but that of mathematics."""

from __future__ import annotations

from collections.abc import Iterable

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
    wrapped,
)


def c_program(body: Body) -> tuple[bytes, list[str]]:
    """The program, and what whoever uses it should know: sentences without a full stop.

    Raises:
        InputError: something acts on the body that a program cannot do.
    """
    plan = Plan.of(body)
    run = "cc -O2 FILE.c -o FILE -lm; ./FILE"
    lines = [f"// {line}" for line in about(plan, run)]
    headers = ["math", "stdio", "stdlib"] if _needs_math(plan) else ["stdio", "stdlib"]
    lines += [*(f"#include <{name}.h>" for name in headers), "", *_settings(plan), *_masses(plan)]
    if len(body.ends):
        lines += _springs(plan)
    lines += [*_around(plan), *_forces(plan), *_step(plan), *_main(plan)]
    return "\n".join((*lines, "")).encode("ascii"), plan.notes


def _needs_math(plan: Plan) -> bool:
    body = plan.body
    return bool(len(body.ends) or plan.air or len(body.walls) or body.circles)


def _settings(plan: Plan) -> list[str]:
    scene = plan.body.scene
    lines = [f"static const double DT = {scene.integrator.dt!r};  // time step, s"]
    if plan.weighs:
        x, y = map(float, scene.gravity)
        lines.append(f"static const double GRAVITY_X = {x!r}, GRAVITY_Y = {y!r};  // px/s^2")
    if plan.air:
        lines.append(f"static const double AIR = {scene.air_friction!r};  // air friction, kg/px")
    if plan.windy:
        x, y = plan.body.wind
        lines.append(f"static const double WIND_X = {x!r}, WIND_Y = {y!r};  // velocity of the air, px/s")
    return [*lines, ""]


def _masses(plan: Plan) -> list[str]:
    body = plan.body
    fields, columns = "double x, y, vx, vy, mass;", [*body.positions.T, *body.velocities.T, body.mass]
    if plan.holds:
        fields += " int held;"
        columns.append(body.held.astype(int))
    return [
        "// Of each mass: where it is (px), its velocity (px/s) and its mass (kg).",
        *_table("m", "MASSES", fields, columns, constant=False),
        "static double ax[MASSES], ay[MASSES];  // forces (kg px/s^2), then accelerations (px/s^2)",
        "",
    ]


def _springs(plan: Plan) -> list[str]:
    body = plan.body
    fields, said = "int a, b; double k, rest", "its masses, stiffness (kg/s^2), rest length (px)"
    columns = [*body.ends.T, body.stiffness, body.rest_length]
    if plan.damped:
        fields, said = f"{fields}, c", f"{said}, damping (kg/s)"
        columns.append(body.damping)
    lines = [f"// Of each spring: {said}.", *_table("s", "SPRINGS", f"{fields};", columns), ""]
    if not plan.law:
        return lines
    columns = [*body.joints.T, body.joint_stiffness]
    if plan.law == "angle":
        fields, said = "int p, q; double k, rest", "its springs, stiffness (kg/s^2), rest angle (radians)"
        columns.append(np.radians(body.rest_angle))
    else:
        fields = "int p, q; double k, cosine, sine"
        said = "its springs, stiffness (kg/s^2), cosine and sine of its rest angle"
        columns += rest_terms(body.rest_angle)
    if plan.joints_damped:
        fields, said = f"{fields}, c", f"{said}, damping (kg/s)"
        columns.append(body.joint_damping)
    rate = ", rx, ry" if plan.joints_damped else ""
    return [
        *lines,
        f"// Of each joint: {said}.",
        *_table("j", "JOINTS", f"{fields};", columns),
        "// Of each spring now: its vector and length, the force on mass b"
        + (", and how fast the vector changes." if rate else "."),
        f"static struct {{ double x, y, length, fx, fy{rate}; }} now[SPRINGS];",
        "",
    ]


def _around(plan: Plan) -> list[str]:
    body, lines = plan.body, []
    if body.loads:
        lines += [
            *comment("//", OF_LOADS),
            *_table("load", "LOADS", "int mass; double x, y;", load_columns(body)),
            "",
        ]
    if body.loops:
        loops = body.loops
        first = np.cumsum([0, *(len(loop.masses) for loop in loops)])
        columns = [
            [int(loop.is_gas) for loop in loops],
            [loop.pressure for loop in loops],
            [loop.outside for loop in loops],
            [loop.area for loop in loops],
            first[:-1],
            first[1:],
        ]
        fields = "int gas; double strength, outside, area; int first, end;"
        lines += [
            *comment("//", f"{OF_FILLINGS}, as a part of `around`."),
            *_table("filling", "FILLINGS", fields, columns),
            "static const int around[] = {",
            *_indented(wrapped(" ".join(f"{m}," for loop in loops for m in loop.masses))),
            "};",
            "",
        ]
    if len(body.walls):
        lines += [
            *comment("//", OF_WALLS),
            *_table(
                "wall", "WALLS", "double x, y, nx, ny, hardness, friction, slip, loss;", list(body.walls.T)
            ),
            "",
        ]
    if body.circles:
        circles = body.circles.values()
        columns = [
            list(body.circles),
            [place[0] for _, place in circles],
            [place[1] for _, place in circles],
            [circle.radius for circle, _ in circles],
            [circle.frequency for circle, _ in circles],
            [circle.ramp for circle, _ in circles],
        ]
        lines += [
            *comment("//", OF_CIRCLES),
            *_table("circle", "CIRCLES", "int mass; double x, y, radius, frequency, ramp;", columns),
            "",
        ]
    return lines


# ------------------------------------------------------------------------- code
def _forces(plan: Plan) -> list[str]:
    body = plan.body
    code = ["for (int i = 0; i < MASSES; i++) ax[i] = ay[i] = 0.0;"]
    if body.loads:
        code += [
            "for (int i = 0; i < LOADS; i++) ax[load[i].mass] = load[i].x, ay[load[i].mass] = load[i].y;"
        ]
    if len(body.ends):
        code += _spring_forces(plan)
    if body.loops:
        code += _FILLINGS
    code += ["for (int i = 0; i < MASSES; i++) {"]
    inner = ["ax[i] /= m[i].mass, ay[i] /= m[i].mass;"]
    if plan.air:
        relative = (" - WIND_X", " - WIND_Y") if plan.windy else ("", "")
        inner += [
            "// Air friction acts along each axis.",
            f"double u = m[i].vx{relative[0]}, w = m[i].vy{relative[1]};",
            "ax[i] -= AIR * u * fabs(u) / m[i].mass, ay[i] -= AIR * w * fabs(w) / m[i].mass;",
        ]
    if plan.weighs:
        inner += ["ax[i] += GRAVITY_X, ay[i] += GRAVITY_Y;"]
    if len(body.walls):
        inner += _WALLS
    code += [*_indented(inner), "}"]
    return ["static void accelerate(void) {", *_indented(code), "}", ""]


def _spring_forces(plan: Plan) -> list[str]:
    pull = " - s[i].c * (x * rx + y * ry) / length" if plan.damped else ""
    rates = ["double rx = m[b].vx - m[a].vx, ry = m[b].vy - m[a].vy;"] if _has_rates(plan) else []
    code = [
        "for (int i = 0; i < SPRINGS; i++) {",
        "    int a = s[i].a, b = s[i].b;",
        "    double x = m[b].x - m[a].x, y = m[b].y - m[a].y;",
        *_indented(rates),
        "    double length = sqrt(x * x + y * y + 1e-300);  // never 0, to divide by it",
        f"    double pull = (-s[i].k * (length - s[i].rest){pull}) / length;",
    ]
    if not plan.law:
        return [
            *code,
            "    ax[b] += pull * x, ay[b] += pull * y;",
            "    ax[a] -= pull * x, ay[a] -= pull * y;",
            "}",
        ]
    return [
        *code,
        "    now[i].fx = pull * x, now[i].fy = pull * y;",
        "    now[i].x = x, now[i].y = y, now[i].length = length;",
        *(["    now[i].rx = rx, now[i].ry = ry;"] if plan.joints_damped else []),
        "}",
        *_bending(plan),
        "for (int i = 0; i < SPRINGS; i++) {",
        "    ax[s[i].b] += now[i].fx, ay[s[i].b] += now[i].fy;",
        "    ax[s[i].a] -= now[i].fx, ay[s[i].a] -= now[i].fy;",
        "}",
    ]


def _has_rates(plan: Plan) -> bool:
    """Whether forces depend on how fast the vectors of springs change."""
    return plan.damped or plan.joints_damped


def _bending(plan: Plan) -> list[str]:
    """The torque on the joints' springs, as forces on the springs' ends; see `sim.physics`."""
    code = [
        "int p = j[i].p, q = j[i].q;",
        "double pp = now[p].length * now[p].length, qq = now[q].length * now[q].length;",
        "double cross = now[p].x * now[q].y - now[p].y * now[q].x;",
        "double dot = now[p].x * now[q].x + now[p].y * now[q].y;",
    ]
    if plan.law == "angle":
        code += [
            "double off = atan2(cross, dot) - j[i].rest;",
            "if (off > PI) off -= 2.0 * PI;",
            "if (off < -PI) off += 2.0 * PI;",
            "double torque = j[i].k * now[p].length * now[q].length * off;",
            "// The energy grows with the lengths, and so pulls along the springs.",
            "double energy = 0.5 * torque * off;",
        ]
    else:
        code += ["double torque = j[i].k * (j[i].cosine * cross - j[i].sine * dot);"]
    if plan.law == "conservative":
        code += [
            "// The energy grows with the lengths, and so pulls along the springs.",
            "double energy = now[p].length * now[q].length - j[i].cosine * dot - j[i].sine * cross;",
            "energy *= j[i].k;",
        ]
    if plan.joints_damped:
        code += [
            "double turning_p = (now[p].x * now[p].ry - now[p].y * now[p].rx) / pp;",
            "double turning_q = (now[q].x * now[q].ry - now[q].y * now[q].rx) / qq;",
            "torque += j[i].c * now[p].length * now[q].length * (turning_q - turning_p);",
        ]
    along = ["", "", "", ""]
    if plan.law != "tutorial":
        along = [f" - energy * now[{spring}].{axis}" for spring in "pq" for axis in "xy"]
    code += [
        f"now[p].fx += (-torque * now[p].y{along[0]}) / pp;",
        f"now[p].fy += (torque * now[p].x{along[1]}) / pp;",
        f"now[q].fx += (torque * now[q].y{along[2]}) / qq;",
        f"now[q].fy += (-torque * now[q].x{along[3]}) / qq;",
    ]
    pi = ["const double PI = 3.141592653589793;"] if plan.law == "angle" else []
    return [
        *pi,
        "// Joints: the angle from p to q is drawn to the rest angle.",
        "for (int i = 0; i < JOINTS; i++) {",
        *_indented(code),
        "}",
    ]


_FILLINGS = [
    "for (int k = 0; k < FILLINGS; k++) {",
    "    int first = filling[k].first, n = filling[k].end - first;",
    "    double x0 = m[around[first]].x, y0 = m[around[first]].y, area = 0.0, pressure;",
    "    for (int i = 0; i < n; i++) {",
    "        int here = around[first + i], next = around[first + (i + 1) % n];",
    "        area += 0.5 * ((m[here].x - x0) * (m[next].y - y0) - (m[here].y - y0) * (m[next].x - x0));",
    "    }",
    "    double part = area / filling[k].area;",
    "    if (!filling[k].gas) pressure = filling[k].strength * (1.0 - part);",
    "    else if (part > 0.01) pressure = filling[k].strength / part - filling[k].outside;",
    "    else  // nearly nothing is left: no division by zero",
    "        pressure = filling[k].strength * (2.0 - part / 0.01) / 0.01 - filling[k].outside;",
    "    for (int i = 0; i < n; i++) {",
    "        int before = around[first + (i + n - 1) % n], next = around[first + (i + 1) % n];",
    "        ax[around[first + i]] += 0.5 * pressure * (m[next].y - m[before].y);",
    "        ay[around[first + i]] += 0.5 * pressure * (m[before].x - m[next].x);",
    "    }",
    "}",
]

_WALLS = [
    "// Walls push with the square of the depth, softened so that a long step makes no energy.",
    "for (int k = 0; k < WALLS; k++) {",
    "    double nx = wall[k].nx, ny = wall[k].ny, rough = wall[k].friction;",
    "    double depth = (wall[k].x - m[i].x) * nx + (wall[k].y - m[i].y) * ny;",
    "    double out = m[i].vx * nx + m[i].vy * ny, along = m[i].vy * nx - m[i].vx * ny;",
    "    if (depth <= 0.0) continue;",
    "    double push = wall[k].hardness * depth * depth;",
    "    double power = pow(DT * (wall[k].loss * push + 4.0 * DT * wall[k].hardness * depth), 4);",
    "    double loss = wall[k].loss + 0.5 * DT / depth * power / (1.0 + power);",
    "    push *= fmax(1.0 - loss * out, 0.0) / pow(1.0 + power, 0.25);",
    "    double slip = pow(pow(wall[k].slip, 4) + pow(DT * rough * push, 4), 0.25);",
    "    double rub = rough * push * tanh(along / slip);",
    "    ax[i] += push * nx + rub * ny, ay[i] += push * ny - rub * nx;",
    "}",
]


def _step(plan: Plan) -> list[str]:
    lines: list[str] = []
    moves = [
        "for (int i = 0; i < MASSES; i++) {",
        *(["    if (m[i].held) continue;"] if plan.holds else []),
        "    m[i].vx += DT * ax[i], m[i].vy += DT * ay[i];",
        "    m[i].x += DT * m[i].vx, m[i].y += DT * m[i].vy;",
        "}",
    ]
    code = ["accelerate();", *moves]
    if plan.body.circles:
        lines = [
            "// Puts masses on circles where they are at time t.",
            "static void lead(double t) {",
            "    for (int k = 0; k < CIRCLES; k++) {",
            "        const double TAU = 6.283185307179586;",
            "        double fade = exp(-t / circle[k].ramp), turn = TAU * circle[k].frequency;",
            "        double phase = turn * (t - circle[k].ramp * (1.0 - fade));",
            "        double radius = circle[k].radius, speed = radius * turn * (1.0 - fade);",
            "        int i = circle[k].mass;",
            "        m[i].x = circle[k].x + radius * sin(phase);",
            "        m[i].y = circle[k].y + radius * (1.0 - cos(phase));",
            "        m[i].vx = speed * cos(phase), m[i].vy = speed * sin(phase);",
            "    }",
            "}",
            "",
        ]
        code = ["lead(t + DT);", *code]
    told = "double t" if plan.body.circles else "void"
    since = " from time t, s" if plan.body.circles else ""
    return [*lines, f"// One time step{since}.", f"static void step({told}) {{", *_indented(code), "}", ""]


def _main(plan: Plan) -> list[str]:
    call = f"step({plan.body.moment.time!r} + i * DT)" if plan.body.circles else "step()"
    return [
        "int main(int count, char **words) {",
        f"    long steps = count > 1 ? atol(words[1]) : {STEPS};",
        f"    for (long i = 0; i < steps; i++) {call};",
        '    for (int i = 0; i < MASSES; i++) printf("%.17g %.17g\\n", m[i].x, m[i].y);',
        "    return 0;",
        "}",
    ]


def _table(
    name: str,
    size: str,
    fields: str,
    columns: list[Iterable[float | int]] | list[np.ndarray],
    constant: bool = True,
) -> list[str]:
    count = len(columns[0])  # type: ignore[arg-type]
    kind = "static const struct" if constant else "static struct"
    return [
        f"enum {{ {size} = {count} }};",
        f"{kind} {{ {fields} }} {name}[{size}] = {{",
        *rows(columns, "{ ", " }"),
        "};",
    ]


def _indented(code: list[str]) -> list[str]:
    return [f"    {line}" for line in code]
