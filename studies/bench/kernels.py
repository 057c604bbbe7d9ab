"""`softrod bench kernels`: the tutorial's step by several programs, and steps of other bodies in runs or not.

The record-array kernel is the tutorial's own way of writing it: masses, springs and joints are records,
unit vectors and lengths are stored, and each law adds to the accelerations. The C program is the fused
loop, where gcc is at hand.
"""

from __future__ import annotations

import ctypes
import dataclasses
import math
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path

import msgspec
import numba
import numpy as np
from rich.console import Console

import sim
from sim.engine.tables import Body
from sim.forces.runs import new_links
from sim.model.state import new_scratch

from ..reporting.report import Table
from . import fastest

_INDICES = [("a", "i8"), ("b", "i8")]
MASS = np.dtype([(name, "f8") for name in ("x", "y", "vx", "vy", "ax", "ay", "m")], align=True)
SPRING = np.dtype([*_INDICES, *((name, "f8") for name in ("k", "c", "rest", "len", "ux", "uy"))], align=True)
JOINT = np.dtype([*_INDICES, *((name, "f8") for name in ("k", "cos", "sin"))], align=True)

STEP = 1e-6
"""A tiny step, s: the arithmetic is the same, and the body stays put however often it is measured."""

TARGETS = {12: 0.95, 50: 0.4, 100: 0.4, 1000: 0.4}
"""Masses, and the largest part of the C program's time that the chain path may take."""

BODIES: dict[str, Callable[[], sim.Scene]] = {
    "cloth of 100": lambda: sim.cloth(columns=10, rows=10),
    "cloth of 900": lambda: sim.cloth(columns=30, rows=30),
    "cloth of 4900": lambda: sim.cloth(columns=70, rows=70),
    "springs of 100": lambda: sim.jelly(columns=10, rows=10, bulk_modulus=0.0),
    "springs of 900": lambda: sim.jelly(columns=30, rows=30, bulk_modulus=0.0),
    "springs of 4900": lambda: sim.jelly(columns=70, rows=70, bulk_modulus=0.0),
    "jelly": sim.jelly,
    "bridge": sim.bridge,
    "flag": sim.flag_pole,
    "tree": sim.tree,
    "cloth of 900, damped joints": lambda: _with_joints_like(sim.cloth(columns=30, rows=30), damping=5.0),
    "cloth of 900, tutorial's law": lambda: sim.cloth(columns=30, rows=30, force_law="tutorial"),
    "cloth of 900, angle law": lambda: sim.cloth(columns=30, rows=30, force_law="angle"),
}
"""Bodies that are no chains, by name; cloth has joints."""


@numba.njit
def record_steps(masses, springs, joints, gravity, air, dt, steps):
    """Do steps as in the tutorial's listing, line by line: every field through its array and index."""
    for _ in range(steps):
        for i in range(masses.size):
            masses[i].ax = 0.0
            masses[i].ay = 0.0
        for s in range(springs.size):
            a = springs[s].a
            b = springs[s].b
            lx = masses[b].x - masses[a].x
            ly = masses[b].y - masses[a].y
            springs[s].len = math.sqrt(lx * lx + ly * ly)
            springs[s].ux = lx / springs[s].len
            springs[s].uy = ly / springs[s].len
            rate = springs[s].ux * (masses[b].vx - masses[a].vx) + springs[s].uy * (
                masses[b].vy - masses[a].vy
            )
            force = -springs[s].k * (springs[s].len - springs[s].rest) - springs[s].c * rate
            masses[a].ax -= force * springs[s].ux
            masses[a].ay -= force * springs[s].uy
            masses[b].ax += force * springs[s].ux
            masses[b].ay += force * springs[s].uy
        for j in range(joints.size):
            p = joints[j].a
            q = joints[j].b
            sine = springs[p].ux * springs[q].uy - springs[p].uy * springs[q].ux
            cosine = springs[p].ux * springs[q].ux + springs[p].uy * springs[q].uy
            force = -joints[j].k * (joints[j].cos * sine - joints[j].sin * cosine)
            force_p = force * springs[q].len
            force_q = -force * springs[p].len
            masses[springs[p].a].ax -= force_p * springs[p].uy
            masses[springs[p].a].ay += force_p * springs[p].ux
            masses[springs[p].b].ax += force_p * springs[p].uy
            masses[springs[p].b].ay -= force_p * springs[p].ux
            masses[springs[q].a].ax -= force_q * springs[q].uy
            masses[springs[q].a].ay += force_q * springs[q].ux
            masses[springs[q].b].ax += force_q * springs[q].uy
            masses[springs[q].b].ay -= force_q * springs[q].ux
        for i in range(1, masses.size):
            masses[i].ax -= air * masses[i].vx * abs(masses[i].vx)
            masses[i].ay -= air * masses[i].vy * abs(masses[i].vy)
            masses[i].vx += masses[i].ax / masses[i].m * dt
            masses[i].vy += (masses[i].ay / masses[i].m + gravity) * dt
            masses[i].x += masses[i].vx * dt
            masses[i].y += masses[i].vy * dt


def compiled_c(folder: Path) -> ctypes.CDLL | None:
    """Return the C program, compiled with gcc -O3 -march=native; None where there is no gcc."""
    gcc = shutil.which("gcc")
    if gcc is None:
        return None
    library = folder / "fused.so"
    source = Path(__file__).with_name("fused.c")
    subprocess.run(
        [gcc, "-O3", "-march=native", "-shared", "-fPIC", "-o", library, source, "-lm"], check=True
    )
    return ctypes.CDLL(str(library))


def contenders(n: int, steps: int, library: ctypes.CDLL | None) -> dict[str, Callable[[], None]]:
    """Return the programs, each with a state of its own, all starting alike."""
    scene = sim.rope(
        masses=n,
        length=300.0 / 11.0 * (n - 1),
        force_law="tutorial",
        integrator=sim.Integrator(method="symplectic_euler", dt=STEP),
    )
    # Masses that are exactly in line would make some products zero, and so perhaps cheaper.
    noise = np.random.default_rng(1).normal(size=(n, 2))
    chain = sim.Simulation(scene)
    in_runs = _with_body(sim.Simulation(scene), lambda body: body.replaced(chain=False))
    for simulation in (chain, in_runs):
        simulation._state.x[1 : n + 1] += noise[:, 0]
        simulation._state.y[1 : n + 1] += noise[:, 1]
    positions = chain.positions
    masses = np.zeros(n, MASS)
    masses["x"], masses["y"], masses["m"] = positions[:, 0], positions[:, 1], 1.0
    springs = np.zeros(n - 1, SPRING)
    springs["a"], springs["b"] = np.arange(n - 1), np.arange(1, n)
    springs["k"], springs["c"], springs["rest"] = 1e4, 40.0, 300.0 / 11.0
    joints = np.zeros(n - 2, JOINT)
    joints["a"], joints["b"], joints["k"], joints["cos"] = np.arange(n - 2), np.arange(1, n - 1), 1e4, 1.0
    runs: dict[str, Callable[[], None]] = {
        "record arrays": lambda: record_steps(masses, springs, joints, 2000.0, 0.002, STEP, steps),
        "path for any body": lambda: _step(in_runs, steps),
        "chain path": lambda: _step(chain, steps),
    }
    if library is not None:
        x, y = positions.T.copy()
        vx, vy, free = np.zeros(n), np.zeros(n), np.ones(n)
        free[0] = 0.0
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (x, y, vx, vy, free)]
        numbers = [ctypes.c_double(v) for v in (1e4, 40.0, 300.0 / 11.0, 1e4, 0.0, 2000.0, 0.002, STEP)]
        arrays = (x, y, vx, vy, free)  # pointers do not keep them alive
        runs["fused C"] = lambda: _call(library, n, steps, pointers, numbers, arrays)
    return runs


def _with_body(simulation: sim.Simulation, changed: Callable[[Body], Body]) -> sim.Simulation:
    """Give a simulation other tables."""
    motion = simulation._motion
    motion._whole = dataclasses.replace(motion._whole, body=changed(motion._whole.body))
    motion.scratch = new_scratch(motion._whole)
    motion.solver = motion._new_solver()
    return simulation


def without_runs(body: Body) -> Body:
    """The table of a body whose springs and joints are loaded one by one."""
    a, b, ends, n = body.spring_a, body.spring_b, body.masses + 1, body.hinged
    none, joints = body.stiffness.size, body.joints
    return body.replaced(
        held=new_links(a[:n], b[:n], ends, none, has_runs=False),
        free=new_links(a[n:], b[n:], ends, none, begin=n, has_runs=False),
        bends=new_links(body.joint_a, body.joint_b, n, joints, has_runs=False),
    )


def _with_joints_like(scene: sim.Scene, damping: float) -> sim.Scene:
    joints = tuple(msgspec.structs.replace(joint, damping=damping) for joint in scene.angular_springs)
    return msgspec.structs.replace(scene, bodies=(), angular_springs=joints)


def programs_of_body(scene: sim.Scene) -> tuple[dict[str, Callable[[], None]], int]:
    """Return steps of a body with runs and without, and the number of springs that one run computes."""
    scene = msgspec.structs.replace(scene, integrator=sim.Integrator(method="symplectic_euler", dt=STEP))
    springs = len(scene.linear_springs)
    steps = max(4, 60_000 // springs)
    alone, in_runs = _with_body(sim.Simulation(scene), without_runs), sim.Simulation(scene)
    return {"alone": lambda: _step(alone, steps), "runs": lambda: _step(in_runs, steps)}, springs * steps


def _step(simulation: sim.Simulation, steps: int) -> None:
    if simulation.step(steps) != steps:
        raise RuntimeError(f"the body ran away: {simulation.divergence}")


def _call(library: ctypes.CDLL, n: int, steps: int, pointers: list, numbers: list, _arrays: tuple) -> None:
    library.fused(ctypes.c_long(n), ctypes.c_long(steps), *pointers, *numbers)


def bench_kernels(console: Console, repeats: int) -> None:
    """Measure, and print ns per mass and step and the ratios that matter."""
    with tempfile.TemporaryDirectory() as folder:
        library = compiled_c(Path(folder))
        rows = [_row_of_rope(n, target, library, repeats) for n, target in TARGETS.items()]
    names = ("record arrays", "path for any body", "chain path", *(["fused C"] if library else []))
    headings = ("masses", *names, "records / chain", "any / chain", "chain / C", "target", "")
    console.print(Table(headings, rows, title="symplectic Euler, ns per mass and step"))
    rows = []
    for name, scene in BODIES.items():
        programs, computed = programs_of_body(scene())
        alone, runs = (1e9 * seconds / computed for seconds in fastest(programs, repeats).values())
        rows.append((name, f"{alone:.2f}", f"{runs:.2f}", f"{alone / runs:.2f}"))
    headings = ("body", "one by one", "in runs", "ratio")
    console.print(Table(headings, rows, title="symplectic Euler, ns per spring and step"))


def _row_of_rope(n: int, target: float, library: ctypes.CDLL | None, repeats: int) -> list[str]:
    steps = max(200, 1_200_000 // n)
    times = fastest(contenders(n, steps, library), repeats)
    ns = {name: seconds / (n * steps) * 1e9 for name, seconds in times.items()}
    chain = ns["chain path"]
    row = [str(n), *(f"{each:.2f}" for each in ns.values())]
    row += [f"{ns[name] / chain:.2f}" for name in ("record arrays", "path for any body")]
    if not library:
        return [*row, "no gcc", f"≤ {target:g}", ""]
    ratio = chain / ns["fused C"]
    return [*row, f"{ratio:.2f}", f"≤ {target:g}", "met" if ratio <= target else "missed"]
