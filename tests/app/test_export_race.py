"""Two bodies on one terrain, in one film or replay."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import msgspec
import numpy as np
import pytest
from rich.console import Console

import sim
from app.export.clip import Clip
from app.export.making import simulated
from app.export.race import race, result, winner
from app.export.replay import replay_html
from sim.edit.terrain import on_terrain
from sim.errors import SceneError
from sim.scene.types import Damage
from tests.app.command import Softrod, refused

REPLACE = msgspec.structs.replace


def test_each_moves_as_it_does_alone_on_that_terrain() -> None:
    worm, walker = sim.load_scene("worm"), sim.load_scene("walker")
    rival = on_terrain(walker, REPLACE(worm, gravity=(0.0, 700.0)))
    assert rival.gravity == (0.0, 700.0)
    assert rival.walls == worm.walls
    assert rival.beat == walker.beat
    # Another time step: its places are those between its own steps.
    rival = REPLACE(rival, integrator=REPLACE(rival.integrator, dt=0.004))
    console = Console(quiet=True)
    moments, others = simulated(worm, 1.0, 0.5, console), simulated(rival, 1.0, 0.5, console)
    shots = race(moments, others)
    assert [shot.picture.time for shot in shots] == [moment.time for moment in moments]
    n, times = len(worm.masses), [moment.time for moment in others]
    xs = np.array([moment.positions[0, 0] for moment in others])
    for shot, moment in zip(shots, moments, strict=True):
        assert np.array_equal(shot.picture.positions[:n], moment.positions)
        assert shot.picture.positions[n, 0] == pytest.approx(np.interp(moment.time, times, xs))
    assert "Worm" in shots[0].scene.title
    assert "Walker" in shots[0].scene.title
    assert replay_html(Clip(shots)).startswith(b"<!")


def test_what_is_drawn_is_a_valid_scene_with_the_parts_of_both() -> None:
    one, other = sim.load_scene("water-balloon"), REPLACE(sim.load_scene("tree"), rest_length_scale=1.25)
    shots = race(*([sim.Simulation(scene).capture()] for scene in (one, other)))
    drawn = sim.validate(shots[0].scene)
    assert len(drawn.linear_springs) == len(one.linear_springs) + len(other.linear_springs)
    assert len(drawn.angular_springs) == len(one.angular_springs) + len(other.angular_springs)
    assert drawn.fillings == one.fillings
    last = other.linear_springs[-1]
    assert drawn.linear_springs[-1].rest_length == pytest.approx(1.25 * last.rest_length)
    assert drawn.linear_springs[-1].a == len(one.masses) + last.a


def test_muscles_of_another_beat_are_drawn_at_rest() -> None:
    worm, walker = sim.load_scene("worm"), sim.load_scene("walker")
    for rival, muscular in ((walker, False), (REPLACE(walker, beat=worm.beat), True)):
        shots = race(*([sim.Simulation(scene).capture()] for scene in (worm, rival)))
        assert shots[0].scene.beat == worm.beat
        assert bool(shots[0].scene.linear_springs[-1].muscle) is muscular


def test_what_is_broken_of_either_is_drawn_so() -> None:
    girder = sim.load_scene("girder")
    count = len(girder.linear_springs)
    whole = sim.Simulation(girder).capture()
    broken = dataclasses.replace(whole, damage=Damage(broken=(3,), set_lengths=(1.0,) * count))
    for moments, at in (((broken, whole), 3), ((whole, broken), count + 3)):
        damage = race(*([moment] for moment in moments))[0].picture.damage
        assert damage is not None
        assert damage.broken == (at,)
        assert sum(damage.set_lengths) == count
        assert len(damage.set_lengths) == 2 * count


def test_the_command_writes_a_race_and_says_how_far_each_went(tmp_path: Path, softrod: Softrod) -> None:
    link = tmp_path / "rival.json"
    sim.save_scene(REPLACE(sim.load_scene("rod"), name="rival", title="A rod"), link)
    out = tmp_path / "race.html"
    said = softrod("export", "rope", "--race", link, "--seconds", 0.4, "--html", out).stdout
    assert "A rod: " in said
    assert " px in 0.4 s" in said
    assert "the finish at " in said
    assert out.stat().st_size > 10_000


def test_how_far_is_that_of_the_centre_of_mass() -> None:
    scene = sim.Scene(
        name="flying",
        masses=(
            sim.Mass(position=(0.0, 0.0), velocity=(100.0, 0.0), mass=3.0),
            sim.Mass(position=(0.0, 50.0), velocity=(-20.0, 0.0)),
        ),
    )
    moments = simulated(scene, 2.0, 0.0, Console(quiet=True))
    assert result(moments) == "flying: 140 px in 2 s"


@pytest.mark.parametrize(
    ("speed", "seconds", "said"),
    [
        (20.0, 3.0, "flying was first at the finish at 240 px, after 2.40 s"),
        (20.0, 13.0, "flying was first at the finish at 240 px, after 2.40 s, by 9.60 s"),
        (100.0, 3.0, "Both came to the finish at 240 px at once, after 2.40 s"),
        (-100.0, 1.0, "Nobody came to the finish at 240 px"),
    ],
)
def test_who_was_first_is_said(
    monkeypatch: pytest.MonkeyPatch, speed: float, seconds: float, said: str
) -> None:
    monkeypatch.setattr("app.export.race.finish_of", lambda one, other: 240.0)
    one = sim.Scene(name="flying", masses=(sim.Mass(position=(0.0, 0.0), velocity=(100.0, 0.0)),))
    other = REPLACE(one, name="slow", masses=(sim.Mass(position=(50.0, 0.0), velocity=(speed, 0.0)),))
    console = Console(quiet=True)
    assert winner(simulated(one, seconds, 0.5, console), simulated(other, seconds, 0.5, console)) == said


@pytest.mark.parametrize(
    "options", [["--glb", "a.glb"], ["--motion", "a.csv"], ["--html", "a.html", "--json", "a.json"]]
)
def test_what_cannot_show_two_bodies_is_refused(
    options: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, softrod: Softrod
) -> None:
    monkeypatch.chdir(tmp_path)
    refused(
        softrod("export", "rope", "--race", "rod", *options), "--race: it is shown by --png, --gif and --html"
    )
    assert not list(tmp_path.iterdir())


def test_a_body_on_another_terrain_begins_outside_the_walls() -> None:
    worm = sim.load_scene("worm")
    high = REPLACE(worm, walls=(REPLACE(worm.walls[0], point=(0.0, 450.0)),))
    placed = on_terrain(worm, high)
    assert max(mass.position[1] for mass in placed.masses) == pytest.approx(450.0)
    pose = sim.Simulation(worm).pose()
    assert placed.masses[3].position[0] == worm.masses[3].position[0]
    with_pose = on_terrain(REPLACE(worm, pose=pose), high).pose
    assert with_pose is not None
    assert max(y for _, y in with_pose.positions) == pytest.approx(450.0)
    assert on_terrain(worm, worm) == worm


@pytest.mark.parametrize(
    ("view", "why"), [({"unit": "m"}, "is measured in m"), ({"y_down": False}, "stand on its head")]
)
def test_what_does_not_go_with_the_terrain_is_refused(view: dict[str, object], why: str) -> None:
    worm = sim.load_scene("worm")
    with pytest.raises(SceneError, match=why):
        on_terrain(REPLACE(worm, view=REPLACE(worm.view, **view)), worm)
