"""Bodies as data and as programs: the numbers are the scene's, and the programs move as the solver does."""

from __future__ import annotations

import io
import json
import re
import runpy
import subprocess
import sys
from contextlib import redirect_stdout
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace as changed

import sim
from app.export.body import program
from app.export.body.body import Body
from app.export.body.data import body_json
from app.export.body.program import LAWS_IN_PROGRAMS, c_program, plain, python_program
from app.export.formats import FORMATS, Options, Source
from app.export.live.live import live_html
from app.export.live.program import javascript_program
from sim.errors import InputError
from sim.forces.all import TERMS
from sim.forces.joints import LAWS, Law
from sim.scene.parts import Keys, Wave
from sim.scene.types import AirLaw, Circle, Damage
from sim.settings import apply_assignments
from tests.app.command import Softrod, refused
from tests.app.compiling_c import SANITIZED, compiled
from tests.app.exported import CLOSE, DAMPED, EULER, LOADED, LOOSE, MUSCULAR, ONE_SIDED_GIRDER, STEPS, body_of
from tests.page.check import NODE
from tests.sim.changes import with_joints
from tests.sim.surrounded import MOTORISED, ON_RAILS, STEERED, around, block_on_a_belt

WRITERS = (
    python_program,
    c_program,
    lambda body: javascript_program(body.moment),
    lambda body: live_html(body.moment),
)
"""Whatever writes a body that moves by itself."""


def printed(words: list[str]) -> np.ndarray:
    """(n, 2) the places that a program prints."""
    run = subprocess.run(words, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert not run.stderr
    return np.array(run.stdout.split(), float).reshape(-1, 2)


def by_javascript(module: Path, *lines: str) -> list[str]:
    """The words that run lines of JavaScript after which the places of `body` are printed."""
    start = f"import {{ createBody }} from {json.dumps(module.as_uri())}; const body = createBody();"
    end = 'console.log([...body.positions].join(" "));'
    return [str(NODE), "--input-type=module", "--eval", "\n".join((start, *lines, end))]


def by_python(program: Path, steps: int) -> np.ndarray:
    """(n, 2) the places that a program in Python prints, in this process, which has NumPy already."""
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(io.StringIO()) as out:
        patch.setattr(sys, "argv", [str(program), str(steps)])
        runpy.run_path(str(program), run_name="__main__")
    return np.array(out.getvalue().split(), float).reshape(-1, 2)


def in_c(body: Body, folder: Path) -> None:
    """A body's program in C, as body.c and body.h."""
    for ending, text in zip(("c", "h"), c_program(body, "body")[:2], strict=True):
        (folder / f"body.{ending}").write_bytes(text)


def moved_by_programs(body: Body, folder: Path, steps: int = STEPS) -> list[np.ndarray]:
    """Where the masses are in the end, by the programs in Python, C and JavaScript."""
    (folder / "body.py").write_bytes(python_program(body)[0])
    in_c(body, folder)
    (folder / "body.mjs").write_bytes(javascript_program(body.moment)[0])
    c = [str(compiled(folder / "body.c", "-DBODY_MAIN")), str(steps)]
    javascript = by_javascript(folder / "body.mjs", f"body.step({steps});")
    return [by_python(folder / "body.py", steps), printed(c), printed(javascript)]


def programs_end_where_it_is(
    simulation: sim.Simulation, body: Body, folder: Path, steps: int = STEPS
) -> None:
    """Whether the programs of a body end where the solver has got to from there."""
    for places in moved_by_programs(body, folder, steps):
        assert places == pytest.approx(simulation.positions, abs=CLOSE, rel=0.0)


# ------------------------------------------------------------------------- programs and the solver
BENT = sim.rope(masses=9, length=240.0, force_law="angle", angular_damping=15.0, rest_angle=40.0)
POSE = sim.Pose(
    positions=tuple((300.0 + 25.0 * i, 200.0 + 3.0 * i * i) for i in range(9)),
    velocities=tuple((10.0 * i, -30.0) for i in range(9)),
)
FLOATING = changed(
    DAMPED, medium=sim.Medium(across=0.4, along=0.1), wind=sim.Wind(velocity=(80.0, -30.0)), air_friction=0.0
)
LYING = changed(MUSCULAR, gravity=(0.0, 0.0), ground=sim.Ground(forward=0.1, backward=0.5, sideways=0.9))
CALM = ("dt=0.0002", "linear_stiffness=20000", "linear_damping=60")
"""With these, the girder does not tumble so that the last digit of its start grows to be seen."""
SCENES: dict[str, tuple[sim.Scene, tuple[str, ...]]] = {
    "rope": (sim.load_scene("tutorial-3.3"), ("rest_angle=25",)),
    "diagonal template": (sim.load_scene("tutorial-3.2"), ("template=135",)),
    "rod": (sim.load_scene("rod"), ()),
    "ring": (sim.load_scene("ring"), ()),
    "ring, tutorial": (sim.load_scene("ring"), ("force_law=tutorial",)),
    "box": (sim.load_scene("box"), ("gravity=700",)),
    "cloth": (sim.load_scene("cloth"), ()),
    "damped joints": (DAMPED, ()),
    "angle law in a pose": (changed(BENT, pose=POSE, gravity=(0.0, 300.0)), ()),
    # Damped, so that the last digit of its start does not grow to be seen.
    "springs alone in a pose": (
        changed(BENT, angular_springs=(), bodies=(), pose=POSE),
        ("linear_damping=100", "dt=0.001"),
    ),
    "liquid on a floor": (sim.load_scene("water-balloon"), ()),
    "gas on a floor": (sim.load_scene("air-balloon"), ("dt=0.001",)),
    "circles": (sim.load_scene("lesson-resonance"), ()),
    "steady wind": (sim.load_scene("flag-pole"), ("turbulence=0",)),
    "stable spring": (sim.load_scene("girder"), ("method=stable_spring",)),
    "no springs, a slope": (LOOSE, ()),
    "a slope with a constant restitution": (
        changed(LOOSE, walls=(changed(LOOSE.walls[0], restitution="constant", bounciness=0.6),)),
        (),
    ),
    "a slope on which friction holds": (
        changed(LOOSE, walls=(changed(LOOSE.walls[0], tangential_hardness=4000.0),)),
        (),
    ),
    "a belt": (changed(LOOSE, walls=(changed(LOOSE.walls[0], speed=-120.0),)), ()),
    "a belt on which friction holds": (
        changed(LOOSE, walls=(changed(LOOSE.walls[0], speed=40.0, tangential_hardness=4000.0),)),
        (),
    ),
    "a block that sticks and slips": (block_on_a_belt(), ("dt=0.002",)),
    "static friction on a slope": (
        changed(LOOSE, walls=(changed(LOOSE.walls[0], static_friction=0.6, tangential_hardness=4000.0),)),
        (),
    ),
    "a solid block on a belt": (sim.load_scene("stick-slip"), ()),
    "a crane with a solid load": (sim.load_scene("crane"), ("dt=0.001",)),
    "a walker on a belt": (sim.load_scene("treadmill"), ("dt=0.001",)),
    "constant forces": (LOADED, ()),
    "muscles": (MUSCULAR, ()),
    "muscles, angle law": (MUSCULAR, ("force_law=angle", "tempo=3")),
    "muscles of springs alone": (changed(MUSCULAR, angular_springs=()), ()),
    "a medium": (sim.load_scene("swimmer"), ("dt=0.0005",)),
    "a medium that flows": (FLOATING, ()),
    "the ground": (LYING, ()),
    "a medium over the ground": (changed(LYING, medium=sim.Medium(across=0.3, along=0.1)), ()),
    "a medium and the ground that do nothing": (
        changed(LYING, ground=sim.Ground(gravity=0.0), medium=sim.Medium(across=0.0, along=0.0)),
        (),
    ),
    **{
        f"parts of one side, {words}": (ONE_SIDED_GIRDER, ("dt=0.0005", words))
        for words in (*(f"force_law={law}" for law in LAWS_IN_PROGRAMS), "linear_damping=0")
    },
    "parts of one side, stable spring": (
        ONE_SIDED_GIRDER,
        ("method=stable_spring", "dt=0.0005", "linear_stiffness=1000000"),
    ),
    "a cart on a rail": (sim.load_scene("cart"), ()),
    "an anchor that goes to and fro on a rail": (sim.load_scene("kapitza"), ()),
    "rails": (around(ON_RAILS), ("dt=0.0002",)),
    **{f"motors, {law}": (around(MOTORISED), (*CALM, f"force_law={law}")) for law in LAWS_IN_PROGRAMS},
    "motors, undamped": (
        around(MOTORISED),
        ("dt=0.0002", "force_law=tutorial", "linear_damping=0", "angular_damping=0"),
    ),
    "muscles that rest": (changed(MUSCULAR, beat=msgspec.UNSET), ()),
    **{
        f"{law} air{', wind' if wind else ''}": (
            changed(DAMPED, air_friction=0.8 if law == "linear" else 0.004, air_law=law, wind=wind),
            (),
        )
        for law in get_args(AirLaw)
        for wind in (None, sim.Wind(velocity=(80.0, -130.0)))
    },
}


@pytest.mark.parametrize("name", SCENES)
def test_programs_move_as_the_solver_does_by_the_tutorials_step(name: str, tmp_path: Path) -> None:
    """Whatever the method of the scene that they are made of."""
    scene, words = SCENES[name]
    simulation = sim.Simulation(apply_assignments(scene, ["method=symplectic_euler", *words]))
    body = body_of(apply_assignments(scene, [*words]))
    simulation.step(STEPS)
    assert abs(simulation.positions - body.positions).max() > 1.0  # it is a motion
    programs_end_where_it_is(simulation, body, tmp_path)


def test_the_command_makes_programs_of_the_scene_with_its_settings(tmp_path: Path, softrod: Softrod) -> None:
    words = ("tutorial-3.3", "--set", "method=symplectic_euler", "--set", "rest_angle=25")
    python, c, javascript = (tmp_path / f"body.{ending}" for ending in ("py", "c", "mjs"))
    assert softrod("export", *words, "--python", python, "--c", c, "--javascript", javascript).returncode == 0
    table = tmp_path / "run.csv"
    assert softrod("run", *words, "--steps", STEPS, "--every", STEPS, "--out", table).returncode == 0
    wanted = np.loadtxt(table, delimiter=",", skiprows=1)[2:].reshape(-1, 2)
    by_script = by_javascript(javascript, f"body.step({STEPS});")
    for started in ([sys.executable, str(python)], [str(compiled(c, "-DBODY_MAIN"))], by_script):
        assert printed(started) == pytest.approx(wanted, abs=CLOSE, rel=0.0)


def test_a_program_begins_at_the_moment_that_it_is_made_of(tmp_path: Path) -> None:
    rope = sim.rope(masses=8, length=240.0, driven=None, arrow_keys=sim.ArrowKeys(), integrator=EULER)
    circle = sim.Anchor(mass=0, circle=Circle(radius=20.0, frequency=1.5))
    scene = changed(rope, anchors=(circle,), bodies=())
    springs = tuple(changed(s, muscle=sim.SpringMuscle(phase=90.0)) for s in scene.linear_springs)
    joints = tuple(changed(j, muscle=sim.JointMuscle()) for j in scene.angular_springs[2:])
    simulation = sim.Simulation(
        changed(
            scene, beat=sim.Beat(), linear_springs=springs, angular_springs=scene.angular_springs[:2] + joints
        )
    )
    simulation.keys = {"up", "right"}
    simulation.step(80)
    simulation.keys = ()
    body = Body.of(simulation.capture())
    simulation.restore(simulation.capture())
    simulation.step(STEPS)
    programs_end_where_it_is(simulation, body, tmp_path)


@pytest.mark.parametrize(
    "around", [{}, {"medium": sim.Medium(), "ground": sim.Ground()}], ids=["", "resisted"]
)
def test_what_is_broken_and_bent_for_good_is_so_in_a_program(around: dict[str, Any], tmp_path: Path) -> None:
    rope = sim.rope(masses=6, length=240.0, direction=(1.0, 0.0), integrator=EULER, **around)
    springs = tuple(changed(s, strength=1e14, yield_force=1e13) for s in rope.linear_springs)
    joints = tuple(changed(j, yield_torque=1e17) for j in rope.angular_springs)
    simulation = sim.Simulation(changed(rope, linear_springs=springs, angular_springs=joints, bodies=()))
    damage = Damage(
        broken=(3,),
        set_lengths=(5.0, -4.0, 0.0, 0.0, 0.0),
        hardened=(0.0,) * 5,
        set_angles=(20.0, 0.0, 0.0, 0.0),
    )
    simulation.restore(replace(simulation.capture(), damage=damage))
    body = Body.of(simulation.capture())
    simulation.step(STEPS)
    assert simulation.damage is not None
    assert simulation.damage.broken == (3,)
    programs_end_where_it_is(simulation, body, tmp_path)
    assert "in it no spring breaks or yields any further" in c_program(body)[2]
    assert json.loads(body_json(body))["springs"]["broken"] == [0, 0, 0, 1, 0]


def test_the_stable_spring_may_break_too(tmp_path: Path) -> None:
    rope = sim.rope(masses=6, length=240.0, direction=(1.0, 0.0), stiffness=1e7)
    springs = tuple(changed(s, strength=1e14) for s in rope.linear_springs)
    integrator = sim.Integrator(method="stable_spring", dt=0.01)
    simulation = sim.Simulation(changed(rope, linear_springs=springs, bodies=(), integrator=integrator))
    simulation.restore(replace(simulation.capture(), damage=Damage(broken=(2,))))
    body = Body.of(simulation.capture())
    simulation.step(100)
    programs_end_where_it_is(simulation, body, tmp_path, 100)


FREE = changed(sim.load_scene("tutorial-3.3"), bodies=(), integrator=EULER)
PUSHED = (*FREE.masses[:3], changed(FREE.masses[3], force=(-900.0, 4000.0)), *FREE.masses[4:])
HANDLED: dict[str, tuple[str, sim.Scene]] = {
    "push": ("body.push(3, 90, 0); body.push(3, -900, 4000);", changed(FREE, masses=PUSHED)),
    "hold": ("body.hold(5);", changed(FREE, anchors=(*FREE.anchors, sim.Anchor(mass=5)))),
    "let go": ("body.hold(0); body.hold(0, false);", changed(FREE, anchors=())),
    "bend": ("body.bend(385);", apply_assignments(FREE, ["rest_angle=25"])),
    "stretch": ("body.stretch(1.25);", apply_assignments(FREE, ["rest_length_scale=1.25"])),
}


@pytest.mark.parametrize("name", HANDLED)
def test_what_a_game_does_with_a_body_is_what_the_scene_could_have(name: str, tmp_path: Path) -> None:
    lines, scene = HANDLED[name]
    (tmp_path / "body.mjs").write_bytes(javascript_program(sim.Simulation(FREE).capture())[0])
    simulation = sim.Simulation(scene)
    simulation.step(STEPS)
    places = printed(
        by_javascript(tmp_path / "body.mjs", lines, f"body.advance({STEPS * FREE.integrator.dt}, 9);")
    )
    assert places == pytest.approx(simulation.positions, abs=CLOSE, rel=0.0)


def test_a_game_drags_a_mass_as_a_pointer_does(tmp_path: Path) -> None:
    (tmp_path / "body.mjs").write_bytes(javascript_program(sim.Simulation(FREE).capture())[0])
    simulation = sim.Simulation(FREE)
    drags = []
    for x, y in ((420.0, 180.0), (500.0, 250.0), (380.0, 320.0)):
        simulation.follow(0, (x, y))
        simulation.step(40)
        drags.append(f"body.drag(0, {x}, {y}); body.step(40);")
    places = printed(by_javascript(tmp_path / "body.mjs", *drags))
    assert places == pytest.approx(simulation.positions, abs=CLOSE, rel=0.0)
    assert places[0].tolist() == [380.0, 320.0]


def test_a_module_for_games_has_contact_and_gusts_and_a_step_that_is_stable(
    tmp_path: Path, softrod: Softrod
) -> None:
    for name in ("pile", "tree"):
        assert "cannot" not in "".join(javascript_program(sim.Simulation(sim.load_scene(name)).capture())[1])
    out = tmp_path / "body.mjs"
    assert softrod("export", "lesson-cantilever", "--javascript", out).returncode == 0
    head = " ".join(line.removeprefix("// ") for line in out.read_text().splitlines()[:24])
    assert "its time step is 1/23 of the scene's 0.0025 s, which is above the largest stable one" in head
    words = by_javascript(out, "if (!body.advance(1, 1)) throw Error('it has run away');")
    scene = apply_assignments(
        sim.load_scene("lesson-cantilever"), ["method=symplectic_euler", f"dt={0.0025 / 23!r}"]
    )
    simulation = sim.Simulation(scene)
    simulation.step(23 * 400)
    assert printed(words) == pytest.approx(simulation.positions, abs=1e-6, rel=0.0)


PAIRS: tuple[Keys, Keys] = ("left-right", "up-down")
WAVES: tuple[Wave, ...] = ("sine", "pulse", "steady")
WORKED = {
    "motors": with_joints(
        around(MOTORISED), motor=lambda i, joint: joint.motor and changed(joint.motor, keys=PAIRS[i % 2])
    ),
    "motors and forces": around(STEERED),
    "muscles": changed(
        MUSCULAR,
        arrow_keys=None,
        linear_springs=tuple(
            changed(s, muscle=changed(s.muscle, keys=PAIRS[i // 2 % 2], wave=WAVES[i % 3])) if s.muscle else s
            for i, s in enumerate(MUSCULAR.linear_springs)
        ),
        angular_springs=tuple(
            changed(j, muscle=changed(j.muscle, keys=PAIRS[i // 2 % 2])) if j.muscle and i % 2 else j
            for i, j in enumerate(MUSCULAR.angular_springs)
        ),
    ),
    "hopper": sim.load_scene("hopper"),
}


@pytest.mark.parametrize("worked", WORKED)
def test_keys_work_in_programs_what_they_work_in_the_solver(worked: str, tmp_path: Path) -> None:
    calm = () if worked in ("muscles", "hopper") else CALM
    simulation = sim.Simulation(apply_assignments(WORKED[worked], ["method=symplectic_euler", *calm]))
    held = worked == "muscles"  # they are held before, so efforts are where the program begins
    if held:
        simulation.keys = ("left", "down")
        simulation.step(20)
    body = Body.of(simulation.capture())
    assert any(body.efforts) == held
    simulation.keys = ("right", "down")
    simulation.step(STEPS)
    (tmp_path / "body.py").write_bytes(python_program(body)[0])
    program = runpy.run_path(str(tmp_path / "body.py"))
    program["STEER"][:] = 1.0, -1.0
    x, v = body.positions.copy(), body.velocities.copy()
    for i in range(STEPS):
        program["step"](x, v, body.moment.time + i * program["DT"])
    in_c(body, tmp_path)
    (tmp_path / "main.c").write_text(
        f'#include "body.h"\n#include <stdio.h>\nint main(void) {{\n    static body b;\n    body_reset(&b);\n'
        f"    b.steer[0] = 1.0, b.steer[1] = -1.0;\n    for (int i = 0; i < {STEPS}; i++) body_step(&b);\n"
        '    for (int i = 0; i < BODY_MASSES; i++) printf("%.17g %.17g\\n", b.mass[i].x, b.mass[i].y);\n'
        "    return 0;\n}\n"
    )
    built = compiled(tmp_path / "main.c", tmp_path / "body.c", *SANITIZED, program=tmp_path / "steered")
    (tmp_path / "body.mjs").write_bytes(javascript_program(body.moment)[0])
    steered = by_javascript(tmp_path / "body.mjs", f"body.steer(1, -1); body.step({STEPS});")
    for places in (x, printed([str(built)]), printed(steered)):
        assert places == pytest.approx(simulation.positions, abs=CLOSE, rel=0.0)
    assert "what keys work holds still until its steer is set" in " ".join(c_program(body)[2])


GAME = Path(__file__).with_name("game.c")


@pytest.mark.parametrize("holds", [False, True])
def test_a_game_in_c_has_bodies_of_its_own(holds: bool, tmp_path: Path) -> None:
    """With all warnings, and with what finds wrong accesses and undefined behaviour."""
    floor = sim.Wall(point=(100.0, 500.0), normal=(0.0, -1.0), tangential_hardness=4000.0 if holds else 0.0)
    rope = sim.rope(masses=5, length=300.0, driven=None, gravity=(0.0, 900.0))
    masses = (*rope.masses, sim.Mass(position=(500.0, 480.0)))
    in_c(body_of(changed(rope, bodies=(), masses=masses, walls=(floor,), integrator=EULER)), tmp_path)
    words = ("-I", str(tmp_path), *SANITIZED)
    built = compiled(GAME, tmp_path / "body.c", *words, program=tmp_path / "game")
    run = subprocess.run([str(built)], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout, run.stderr) == (0, "ok\n", "")


def test_two_bodies_are_in_one_program_in_c(tmp_path: Path, softrod: Softrod) -> None:
    """Each in files of its own, whose names are those of what they define; also where C has no such names."""
    for scene, name in (("bridge", "my-bridge"), ("water-balloon", "2 balloons")):
        assert softrod("export", scene, "--c", tmp_path / f"{name}.c").returncode == 0
    main = tmp_path / "main.c"
    main.write_text(
        '#include "my-bridge.h"\n#include "2 balloons.h"\n#include <stdio.h>\n'
        "static my_bridge bridge;\nstatic body_2_balloons balloon;\nint main(void) {\n"
        "    my_bridge_reset(&bridge), body_2_balloons_reset(&balloon);\n"
        "    for (int i = 0; i < 120; i++) {\n"
        "        if (!my_bridge_advance(&bridge, 1 / 60.0)) return 1;\n"
        "        if (!body_2_balloons_advance(&balloon, 1 / 60.0)) return 2;\n"
        '    }\n    printf("%g %g\\n", bridge.mass[8].y, balloon.mass[0].y);\n    return 0;\n}\n'
    )
    others = (tmp_path / "my-bridge.c", tmp_path / "2 balloons.c")
    built = compiled(main, *others, *SANITIZED, program=tmp_path / "both")
    assert np.isfinite(printed([str(built)])).all()
    refused(
        softrod("export", "ring", "--c", tmp_path / 'a"b.c'),
        "softrod: 'a\"b' is no name for files in C: it may have letters, digits, spaces, - and _\n",
    )


def test_what_springs_ask_of_a_time_step_is_the_same_in_all_programs(tmp_path: Path) -> None:
    """An untouched preset must not end in nan in one of them."""
    bridge = body_of(sim.load_scene("bridge"))
    ends = moved_by_programs(bridge, tmp_path, 800)
    assert all(np.isfinite(places).all() for places in ends)
    assert all(places == pytest.approx(ends[0], abs=1e-6) for places in ends)
    for notes in (python_program(bridge)[1], c_program(bridge)[2], javascript_program(bridge.moment)[1]):
        assert "its time step is 1/2 of the scene's 0.0025 s" in " ".join(notes)


# ------------------------------------------------------------------------- templates
TEMPLATES = Path(program.__file__).with_name("templates")


@pytest.mark.parametrize("law", ["", *LAWS_IN_PROGRAMS])
def test_the_template_in_c_compiles_as_it_stands(law: str, tmp_path: Path) -> None:
    """With all that a body can have, for each law of joints; and with nothing."""
    files = [(TEMPLATES / f"softbody.{ending}").read_text() for ending in ("c", "h")]
    names = set(re.findall(r"HAS_\w+", "".join(files)))
    laws = {name for name in names if name.endswith(("_LAW", "_ENERGY"))}
    energy = set() if law == "tutorial" else {"HAS_JOINT_ENERGY"}
    has = (names - laws | {f"HAS_{law.upper()}_LAW"} | energy) if law else set()
    words = (f"-D{name}" for name in ("TEMPLATE", "SOFTBODY_MAIN", *sorted(has)))
    built = compiled(TEMPLATES / "softbody.c", *words, program=tmp_path / "program")
    assert printed([str(built), "0"]).shape == (1, 2)


def test_the_template_in_python_is_clean_as_it_stands() -> None:
    words = [sys.executable, "-m", "ruff", "check", "--no-cache", str(TEMPLATES / "program.py")]
    run = subprocess.run(words, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout


# ------------------------------------------------------------------------- what programs say
def test_a_file_has_no_line_for_what_its_scene_lacks() -> None:
    rope = sim.Simulation(sim.load_scene("rope")).capture()
    texts = [live_html(rope)[0].decode(), javascript_program(rope)[0].decode()]
    texts += map(bytes.decode, (python_program(body_of(rope.scene))[0], *c_program(body_of(rope.scene))[:2]))
    words = (
        "keepOnRail",
        "reachable",
        "RAIL",
        "MOTOR",
        "atSpeed",
        "steer",
        "exert",
        "EFFORT",
        "PUSHES",
        "BELT",
        "STATIC",
        "slides",
        "sizes",
    )
    for word in (*words, "SIZES", "erived", "ifdef HAS"):
        for text in texts:
            assert word not in text, word


def test_a_program_has_only_what_the_scene_needs() -> None:
    bare = changed(sim.rope(masses=3, length=100.0, driven=None), air_friction=0.0, gravity=(0.0, 0.0))
    springs = tuple(changed(spring, damping=0.0) for spring in bare.linear_springs)
    body = body_of(changed(bare, linear_springs=springs, angular_springs=(), anchors=(), bodies=()))
    words = ("AIR", "GRAVITY", "wall", "WALLS", "joint", "Joint", "FREE", "damping", "pp", "side", "SIDE")
    for text in map(bytes.decode, (python_program(body)[0], *c_program(body)[:2])):
        for word in words:
            assert word not in text.replace("stopped", "")
    assert "held" not in python_program(body)[0].decode()  # in C, what is held may be changed
    full = body_of(sim.load_scene("water-balloon"))
    assert "WALLS" in python_program(full)[0].decode()
    assert "tanh" in c_program(full)[0].decode()


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("pile", "a program cannot do contact of bodies; set contact_distance to 0 to have one without it"),
        ("tree", "a program cannot do gusts of wind; set turbulence to 0 to have one without them"),
    ],
)
def test_what_a_program_cannot_do_is_refused_in_one_sentence(
    name: str, said: str, tmp_path: Path, softrod: Softrod
) -> None:
    for kind, ending in (("python", "py"), ("c", "c")):
        out = tmp_path / f"body.{ending}"
        refused(softrod("export", name, f"--{kind}", out), f"softrod: {said}\n")
        assert not out.exists()
    # What the sentence says does it, and data have it all.
    setting = "contact_distance" if "contact" in said else "turbulence"
    assert softrod("export", name, "--json", tmp_path / "body.json").returncode == 0
    assert softrod("export", name, "--c", out, "--set", f"{setting}=0").returncode == 0


def test_a_program_refuses_solid_masses_that_may_touch_each_other(tmp_path: Path, softrod: Softrod) -> None:
    said = "softrod: a program in Python or C cannot do solid masses that touch each other\n"
    refused(softrod("export", "cradle", "--c", tmp_path / "body.c"), said)
    refused(softrod("export", "cradle", "--python", tmp_path / "body.py"), said)
    assert softrod("export", "cradle", "--javascript", tmp_path / "body.mjs").returncode == 0
    assert json.loads(body_json(body_of(sim.load_scene("cradle"))))["masses"]["solid"][1] == 1


@pytest.mark.parametrize("belt", [msgspec.UNSET, 30.0])
def test_a_program_goes_on_with_friction_that_holds(belt: Any, tmp_path: Path) -> None:
    """Masses that bounce and come to rest in a groove, from the middle of their motion."""
    hard = sim.Wall(
        point=(100.0, 320.0), normal=(1.0, -4.0), friction=0.4, bounciness=0.3, tangential_hardness=4000.0,
        speed=belt,
    )  # fmt: skip
    floors = changed(hard, restitution="constant"), changed(hard, normal=(-1.0, -2.0))
    simulation = sim.Simulation(changed(LOOSE, walls=floors, integrator=EULER))
    simulation.step(400)
    body = Body.of(simulation.capture())
    assert body.moment.grips is not None and body.moment.grips.walls
    without = Body.of(replace(body.moment, grips=None))
    simulation.step(STEPS)
    programs_end_where_it_is(simulation, body, tmp_path)
    if not belt:  # on a belt they slide, and forget
        for places in moved_by_programs(without, tmp_path):
            assert abs(places - simulation.positions).max() > 1e-3


@pytest.mark.parametrize(("before", "slides"), [(135, False), (180, True)])
def test_a_program_goes_on_with_what_slides_in_spite_of_static_friction(
    before: int, slides: bool, tmp_path: Path
) -> None:
    simulation = sim.Simulation(apply_assignments(block_on_a_belt(), ["method=symplectic_euler", "dt=0.002"]))
    simulation.step(before)
    grips = simulation.capture().grips
    assert grips is not None and bool(grips.sliding) == slides
    body = Body.of(simulation.capture())
    simulation.step(STEPS)
    programs_end_where_it_is(simulation, body, tmp_path)


def test_a_program_says_what_is_another_in_it(tmp_path: Path, softrod: Softrod) -> None:
    out = tmp_path / "body.py"
    assert softrod("export", "lesson-cantilever", "--python", out).stderr.splitlines() == [
        f"softrod: {out}: it steps by symplectic Euler, the scene by Auto",
        f"softrod: {out}: its time step is 1/23 of the scene's 0.0025 s, which is above the largest stable "
        "one, 0.000138 s",
    ]
    head = " ".join(line.removeprefix("# ") for line in out.read_text().splitlines()[:12])
    assert "the largest stable one, 0.000138 s" in head
    words = ("--set", "dt=0.0001", "--set", "method=symplectic_euler")
    assert not softrod("export", "lesson-cantilever", "--python", out, *words).stderr
    made = softrod("export", "tutorial-3.3", "--python", out)
    assert made.stderr.endswith("in it, the pointer and the arrow keys do nothing\n")


HOSTILE = "*/ int x = 1; ??/\n\"\"\"\n#'''\nimport os\\\r\u2028\n#define DT 9 \\"


def test_nothing_of_a_scene_is_code_in_a_program(tmp_path: Path) -> None:
    plainly = moved_by_programs(body_of(LOOSE), tmp_path, 3)
    for text in (HOSTILE, "a\\", "??/", "\u202e\x00\x1b[2J", "a*/", '"""'):
        scene = changed(LOOSE, title=text[:60], name=text[:60], view=sim.View(unit=text[:8]))
        hostile = moved_by_programs(body_of(scene), tmp_path, 3)
        assert all((one == other).all() for one, other in zip(plainly, hostile, strict=True))
        head = (tmp_path / "body.mjs").read_text().partition("\n/**")[0]
        assert head.isascii()
        assert "a module" in head
        assert all(line.startswith("//") or not line for line in head.splitlines())
        for name in ("body.c", "body.h", "body.py"):
            bytes_ = (tmp_path / name).read_bytes()
            assert all(byte == 10 or 32 <= byte < 127 for byte in bytes_)
            assert b"??" not in bytes_
            assert not any(line.endswith(b"\\") for line in bytes_.splitlines())
    assert plain("Brücke №5: 3.5 px/s") == "Brucke No5: 3.5 px/s"


def test_a_step_bears_a_rope_that_is_slack_at_the_start(tmp_path: Path) -> None:
    """It falls until the rope is taut, which the step of a body without a rope would not bear."""
    falling = sim.Scene(
        name="falling",
        masses=(sim.Mass(position=(300.0, 100.0)), sim.Mass(position=(300.0, 110.0))),
        linear_springs=(sim.LinearSpring(a=0, b=1, stiffness=1e7, rest_length=60.0, only="pull"),),
        anchors=(sim.Anchor(mass=0),),
        gravity=(0.0, 1000.0),
    )
    assert "the largest stable one, 0.000632 s" in " ".join(python_program(body_of(falling))[1])
    for places in moved_by_programs(body_of(falling), tmp_path, 4000):
        assert 100.0 < places[1, 1] < 161.0


def test_a_body_that_has_run_away_is_refused() -> None:
    moment = sim.Simulation(LOOSE).capture()
    rows = moment.rows.copy()
    rows[0, 1] = np.nan
    with pytest.raises(InputError, match="finite"):
        Body.of(replace(moment, rows=rows))


# ------------------------------------------------------------------------- the command
def test_the_command_takes_the_moment_that_is_asked_for(tmp_path: Path, softrod: Softrod) -> None:
    out, png = tmp_path / "body.json", tmp_path / "end.png"
    assert softrod("export", "rod", "--json", out).returncode == 0
    assert json.loads(out.read_text())["time"] == 0.0
    words = ("--after", 0.25, "--seconds", 0.25, "--png", png)
    assert softrod("export", "rod", "--json", out, *words).returncode == 0
    data = json.loads(out.read_text())
    simulation = sim.Simulation(sim.load_scene("rod"))
    simulation.advance(0.25)
    assert data["time"] == 0.25
    assert data["masses"]["position"] == simulation.positions.tolist()


def test_a_link_can_be_exported(tmp_path: Path, softrod: Softrod) -> None:
    link = softrod("link", "ring").stdout.strip()
    assert softrod("export", link, "--json", tmp_path / "ring.json").returncode == 0
    assert json.loads((tmp_path / "ring.json").read_text())["name"] == "ring"


def test_a_filling_that_has_got_out_is_not_in_the_body() -> None:
    scene = sim.load_scene("water-balloon")
    assert len(body_of(scene).loops) == 1
    moment = replace(sim.Simulation(scene).capture(), damage=Damage(broken=(3,)))
    assert not Body.of(moment).loops
    assert b"fillings" not in body_json(Body.of(moment))


def test_a_program_refuses_a_law_that_it_does_not_know(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(LAWS, "made-up", Law(LAWS["angle"].code, "Made up"))
    body = body_of(BENT)
    scene = changed(body.scene, force_law="made-up")
    other = replace(body, moment=replace(body.moment, scene=scene))
    for write in WRITERS:
        with pytest.raises(InputError, match="cannot do the force law 'made-up', but tut"):
            write(other)


def test_files_refuse_a_force_that_they_do_not_know_and_tables_leave_it_out_with_a_word(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    vortices = replace(TERMS[-1], name="vortices", label="", acts=lambda _: True)
    monkeypatch.setattr(program, "TERMS", (*TERMS, vortices))
    body = body_of(BENT)
    for write in WRITERS:
        with pytest.raises(InputError, match=r"^a (program|live file) cannot do vortices$"):
            write(body)
    source, options = Source(body.moment, [], 0.0), Options("x")
    for flag in ("json", "csv"):
        (kind,) = (kind for kind in FORMATS if kind.flag == flag)
        assert kind.make(source, options).notes == ["vortices are not in it"]
