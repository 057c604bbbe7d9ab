"""A motion as keyframes, in a table and in an animated model: it is the motion of `softrod run`."""

from __future__ import annotations

import io
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from msgspec.structs import replace as changed
from rich.console import Console

import sim
from app.export import keyframes
from app.export.animation import animated_glb
from app.export.clip import Clip, ClipFrame
from app.export.keyframes import motion_csv
from app.export.making import simulated
from app.export.model import glb
from app.stage.plan import Picture
from sim.errors import InputError
from sim.scene.types import Damage
from tests.app.command import Softrod

EULER = sim.Integrator(method="symplectic_euler")


def clip_of(scene: sim.Scene, seconds: float, rate: int) -> Clip:
    return Clip(map(ClipFrame.of, simulated(scene, seconds, 0.0, Console(quiet=True), rate)), seconds)


class Animated:
    """What another program finds in a file.

    Attributes:
        tree: the JSON object.
        nodes: by name.
        times: (k,) of the keyframes, s.
    """

    def __init__(self, data: bytes) -> None:
        assert data[:4] == b"glTF"
        assert int.from_bytes(data[8:12], "little") == len(data)
        end = 20 + int.from_bytes(data[12:16], "little")
        self.tree: dict[str, Any] = json.loads(data[20:end])
        self._data = data[end + 8 :]
        self.nodes = {node["name"]: i for i, node in enumerate(self.tree["nodes"])}
        self._animation = self.tree.get("animations", [{"channels": [], "samplers": []}])[0]
        inputs = {sampler["input"] for sampler in self._animation["samplers"]}
        # What vanishes has a clock of its own, with one moment more.
        clocks = [self._array(one).ravel() for one in inputs]
        self.times = min(clocks, key=len, default=np.zeros(1))

    def _array(self, accessor: int) -> np.ndarray:
        about = self.tree["accessors"][accessor]
        view = self.tree["bufferViews"][about["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[about["type"]]
        return np.frombuffer(self._data, "<f4", about["count"] * width, view["byteOffset"]).reshape(-1, width)

    def channels(self, name: str) -> dict[str, np.ndarray]:
        """The keyframes of a node, by path."""
        samplers = self._animation["samplers"]
        return {
            channel["target"]["path"]: self._array(samplers[channel["sampler"]]["output"])
            for channel in self._animation["channels"]
            if channel["target"]["node"] == self.nodes[name]
        }

    def values(self, name: str, path: str) -> np.ndarray:
        """(k, n) of a node in all frames, whether it has keyframes or not."""
        fixed = np.tile(self.tree["nodes"][self.nodes[name]][path], (len(self.times), 1))
        return self.channels(name).get(path, fixed)

    def tip(self, name: str) -> np.ndarray:
        """(k, 3) where the point (1, 0, 0) of a node is in all frames."""
        x, y, z, w = self.values(name, "rotation").T
        along = np.stack((w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)), 1)
        return self.values(name, "translation") + self.values(name, "scale")[:, :1] * along


def in_metres(scene: sim.Scene, positions: np.ndarray) -> np.ndarray:
    """(..., 3) in the model, of (..., 2) px."""
    xmin, ymin, xmax, ymax = scene.view.frame
    flip = -1.0 if scene.view.y_down else 1.0
    x, y = positions[..., 0] - (xmin + xmax) / 2.0, flip * (positions[..., 1] - (ymin + ymax) / 2.0)
    return 0.001 * np.stack((x, y, 0.0 * x), axis=-1)


# ------------------------------------------------------------------------- the motion
@pytest.mark.parametrize(("name", "after"), [("tutorial-3.3", 0.0), ("jelly", 0.1)])
def test_keyframes_are_the_motion_of_the_run(
    name: str, after: float, tmp_path: Path, softrod: Softrod
) -> None:
    table, model, run = tmp_path / "motion.csv", tmp_path / "motion.glb", tmp_path / "run.csv"
    # Methods with error control see where a run pauses, and may take other steps then.
    scene_words = (name, "--set", "method=symplectic_euler")
    words = ("--fps", 50, "--seconds", 0.6, "--after", after)
    assert softrod("export", *scene_words, "--motion", table, "--animation", model, *words).returncode == 0
    assert softrod("run", *scene_words, "--duration", after + 0.6, "--every", 8, "--out", run).returncode == 0
    scene = sim.load_scene(name)
    assert scene.integrator.dt * 8 == pytest.approx(1 / 50)
    wanted = np.loadtxt(run, delimiter=",", skiprows=1)[:, 2:]
    found = np.loadtxt(table, delimiter=",", skiprows=1)
    assert found[:, 0] == pytest.approx(np.arange(31) / 50)
    assert np.abs(np.ptp(wanted, axis=0)).max() > 1.0  # it is a motion
    assert found[1:, 1:] == pytest.approx(wanted[-30:], abs=1e-6, rel=0.0)
    animated = Animated(model.read_bytes())
    assert animated.times == pytest.approx(found[:, 0], abs=1e-6)
    places = in_metres(scene, found[:, 1:].reshape(31, -1, 2))
    for i in range(len(scene.masses)):
        assert animated.values(f"mass {i}", "translation") == pytest.approx(places[:, i], abs=2e-7)
    for s, spring in enumerate(scene.linear_springs):
        assert animated.values(f"spring {s}", "translation") == pytest.approx(places[:, spring.a], abs=2e-7)
        assert animated.tip(f"spring {s}") == pytest.approx(places[:, spring.b], abs=2e-7)


def test_frames_between_steps_lie_between_them() -> None:
    scene = changed(sim.load_scene("tutorial-3.3"), integrator=changed(EULER, dt=0.003))
    found = np.loadtxt(io.BytesIO(motion_csv(clip_of(scene, 0.5, 60), 60)), delimiter=",", skiprows=1)
    simulation, steps = sim.Simulation(scene), []
    for _ in range(200):
        steps.append(simulation.positions.ravel())
        simulation.step(1)
    at = found[:, 0] / 0.003
    before, part = at.astype(int), (at - at.astype(int))[:, None]
    rows = np.array(steps)
    assert found[:, 0] == pytest.approx(np.arange(len(found)) / 60)
    assert len(found) >= 30
    assert found[:, 1:] == pytest.approx(
        (1 - part) * rows[before] + part * rows[before + 1], abs=1e-6, rel=0.0
    )


def test_a_table_may_have_decimal_commas() -> None:
    clip = clip_of(sim.load_scene("pendulum"), 0.3, 30)
    head, *rows = motion_csv(clip, 30, decimal_comma=True).decode().splitlines()
    assert head == "time;x0;y0;x1;y1"
    assert rows[1].startswith("0,03333333333;")
    assert "." not in "".join(rows)


# ------------------------------------------------------------------------- the model
SPINNING = sim.Scene(
    name="spinning",
    masses=tuple(sim.Mass(position=(50.0 * x, 0.0), velocity=(0.0, 800.0 * x), mass=1.0) for x in (-1, 1)),
    linear_springs=(sim.LinearSpring(a=0, b=1, rest_length=90.0, stiffness=5e3),),
    gravity=(0.0, 0.0),
    integrator=EULER,
)


def test_springs_turn_the_short_way_from_frame_to_frame() -> None:
    animated = Animated(animated_glb(clip_of(SPINNING, 2.0, 30), 30))
    turns = animated.channels("spring 0")["rotation"]
    assert np.linalg.norm(turns, axis=1) == pytest.approx(1.0, abs=1e-6)
    assert (turns[1:] * turns[:-1]).sum(1).min() > 0.9
    assert np.ptp(turns, axis=0)[2:].min() > 1.9  # it goes round more than once
    assert animated.tip("spring 0") == pytest.approx(animated.values("mass 1", "translation"), abs=2e-7)


def test_what_does_not_move_has_no_keyframes() -> None:
    animated = Animated(animated_glb(clip_of(sim.load_scene("pendulum"), 0.5, 60), 60))
    assert not animated.channels("mass 0")
    assert set(animated.channels("mass 1")) == {"translation"}
    assert "translation" not in animated.channels("spring 0")
    still = changed(SPINNING, masses=tuple(changed(m, velocity=(0.0, 0.0)) for m in SPINNING.masses))
    still = changed(still, linear_springs=(changed(still.linear_springs[0], rest_length=100.0),))
    tree = Animated(animated_glb(clip_of(still, 0.5, 60), 60)).tree
    assert "animations" not in tree
    assert len(tree["nodes"]) == 4


def test_a_spring_that_breaks_vanishes() -> None:
    for strength, lasts in ((1e9, True), (1e4, False)):
        spring = changed(SPINNING.linear_springs[0], strength=strength, rest_length=100.0)
        clip = clip_of(changed(SPINNING, linear_springs=(spring,)), 0.5, 60)
        sizes = Animated(animated_glb(clip, 60)).values("spring 0", "scale")
        assert (sizes[0] > 0.0).all()
        assert (sizes[-1] > 0.0).all() == lasts
        assert (sizes[-1] == 0.0).all() != lasts
        if not lasts:
            # Until the frame in which it is no more it is as large as it was: it does not shrink away.
            assert len(sizes) == len(list(clip.frames_at(60))) + 1
            gone = int(np.flatnonzero(sizes[:, 0] == 0.0)[0])
            assert (sizes[gone - 1] == sizes[gone - 2]).all()
            assert (sizes[gone:] == 0.0).all()


def test_a_model_has_as_many_px_in_a_metre_as_one_asks_for(tmp_path: Path, softrod: Softrod) -> None:
    sizes = []
    for scale in (1000, 250):
        out = tmp_path / "a.glb"
        assert (
            softrod("export", "pendulum", "--animation", out, "--seconds", 0.5, "--scale", scale).returncode
            == 0
        )
        animated = Animated(out.read_bytes())
        sizes.append(animated.values("mass 1", "translation"))
        assert animated.tree["asset"]["extras"]["metres_per_px"] == 1.0 / scale
    assert sizes[1] == pytest.approx(4.0 * sizes[0], rel=1e-5)


@pytest.mark.parametrize("kind", ["spring", "joint"])
def test_muscles_lie_on_what_they_move_and_swell(kind: str) -> None:
    """A muscle of a spring is thick while it is short; one of a joint large while it bends."""
    rope = changed(
        sim.rope(masses=4, length=150.0, integrator=EULER), bodies=(), beat=sim.Beat(frequency=2.0)
    )
    if kind == "spring":
        muscle = sim.SpringMuscle(amplitude=0.2)
        springs = (rope.linear_springs[0], changed(rope.linear_springs[1], muscle=muscle, strength=1e15))
        scene = changed(rope, linear_springs=(*springs, *rope.linear_springs[2:]))
    else:
        joints = (
            rope.angular_springs[0],
            changed(rope.angular_springs[1], muscle=sim.JointMuscle(amplitude=30.0)),
        )
        scene = changed(rope, angular_springs=joints)
    clip = clip_of(scene, 0.5, 40)
    animated, mass = Animated(animated_glb(clip, 40)), 1 if kind == "spring" else 2
    name = f"muscle of {kind} 1"
    places = animated.values(f"mass {mass}", "translation")
    assert animated.values(name, "translation") == pytest.approx(places, abs=1e-7)
    wave = np.sin(2.0 * np.pi * 2.0 * animated.times) * (-1.0 if kind == "spring" else 1.0)
    widths = animated.values(name, "scale")[:, 1]
    assert widths == pytest.approx(widths.mean() * (1.0 + 0.25 * wave), rel=0.02)
    if kind == "spring":
        assert animated.tip(name) == pytest.approx(animated.values("mass 2", "translation"), abs=2e-7)
        picture = replace(Picture.at_start(scene), damage=Damage(broken=(1,)))
        gone = animated_glb(Clip([ClipFrame(scene, replace(picture, time=t)) for t in (0.0, 0.5)]), 40)
        assert (Animated(gone).values(name, "scale") == 0.0).all()
    still = trimesh.load_scene(io.BytesIO(glb(scene, Picture.at_start(scene))), file_type="glb")
    assert f"muscles of {kind}s" in still.geometry
    assert len([name for name in still.geometry if name.startswith("muscles")]) == 1


def test_another_program_finds_the_parts_at_their_start() -> None:
    scene = changed(sim.load_scene("girder"), title='"}]</script>\u2028')
    data = animated_glb(clip_of(scene, 0.3, 30), 30)
    loaded = trimesh.load_scene(io.BytesIO(data), file_type="glb")
    names = {name.split()[0] for name in loaded.graph.nodes_geometry}
    assert names == {"mass", "spring", "support", "walls"}
    places = in_metres(scene, np.array([mass.position for mass in scene.masses]))
    for i, place in enumerate(places):
        assert loaded.graph.get(f"mass {i}")[0][:3, 3] == pytest.approx(place, abs=1e-6)
    extras = Animated(data).tree["asset"]["extras"]
    assert extras == {"title": scene.title, "metres_per_px": 0.001, "frames_per_second": 30}
    assert data == animated_glb(clip_of(scene, 0.3, 30), 30)


# ------------------------------------------------------------------------- what is wrong
def test_too_much_is_refused_before_it_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    clip = clip_of(SPINNING, 0.5, 60)
    monkeypatch.setattr(keyframes, "MAX_NUMBERS", 100)
    with pytest.raises(InputError, match="31 frames of 4 numbers are too many, there may be 100 in all"):
        motion_csv(clip, 60)
    with pytest.raises(InputError, match="31 frames of 13 numbers are too many"):
        animated_glb(clip, 60)
