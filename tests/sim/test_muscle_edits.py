"""Muscles given to springs and joints, moved, mirrored, copied and taken away; and the tempo of a run."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim.edit import copying
from sim.edit.build import positions_of, remove
from sim.edit.edit import Selection, inverse
from sim.edit.muscles import (
    crest,
    give_muscles,
    move_muscles,
    muscles_of,
    shape_muscles,
    spread_muscles,
    take_muscles,
)
from sim.edit.shape import mirror
from sim.edit.values import number, set_number, take_as_rest, values_of
from sim.forces.muscles import swings
from sim.scene.parts import Beat, JointMuscle, SpringMuscle, Wave
from sim.settings import set_value, settings_of
from tests.sim.changes import after, step_all

NONE: frozenset[int] = frozenset()
SOME = Selection(springs=frozenset({0, 2}), joints=frozenset({1}))


def rope() -> sim.Scene:
    """Of five masses that hang from the first."""
    return sim.rope(5)


def worm() -> sim.Scene:
    return give_muscles(rope(), SOME).scene


def starts(scene: sim.Scene) -> list[tuple[float, float]]:
    return positions_of(sim.Simulation(scene).capture())


# ------------------------------------------------------------------------- giving and taking
def test_muscles_are_given_once_with_a_beat() -> None:
    scene = rope()
    edit = give_muscles(scene, SOME)
    assert edit.label == "3 muscles added"
    assert edit.scene.beat == Beat()
    assert muscles_of(edit.scene, Selection(NONE, frozenset(range(4)), frozenset(range(3)))) == SOME
    tuned = replace(edit.scene, beat=Beat(frequency=3.0))
    more = give_muscles(tuned, Selection(springs=frozenset({0, 1})))
    assert more.label == "1 muscle added"  # the other one stays as it is
    assert more.scene.beat == Beat(frequency=3.0)
    assert inverse(edit, scene).scene is scene


def test_the_last_muscle_takes_the_beat_along() -> None:
    scene = worm()
    fewer = take_muscles(scene, Selection(springs=frozenset({0, 1})))
    assert fewer.label == "1 muscle removed"
    assert fewer.scene.beat
    none = take_muscles(fewer.scene, SOME).scene
    before = replace(none, bodies=rope().bodies)
    assert before == rope()  # to the last field


@pytest.mark.parametrize("change", [give_muscles, take_muscles, spread_muscles])
def test_what_has_nothing_to_be_changed_is_refused(change: object) -> None:
    assert callable(change)
    with pytest.raises(sim.SettingError, match="select"):
        change(rope(), Selection(masses=frozenset({1})))
    with pytest.raises(sim.SceneError, match=r"joint 7 does not exist \(0\.\.2\)"):
        change(rope(), Selection(joints=frozenset({7})))


# ------------------------------------------------------------------------- changing
def test_all_move_by_as_much_along_the_beat_whatever_their_waves() -> None:
    scene = shape_muscles(worm(), Selection(springs=frozenset({2})), "pulse", 3).scene
    before = [part.muscle for part in (scene.linear_springs[0], scene.linear_springs[2])]
    moved = move_muscles(scene, SOME, 0.25, 0.1, -30.0).scene
    after = [part.muscle for part in (moved.linear_springs[0], moved.linear_springs[2])]
    for old, new in zip(before, after, strict=True):
        assert isinstance(old, SpringMuscle) and isinstance(new, SpringMuscle)
        later = (crest(new) - crest(old) - 0.25) * old.per_beat
        assert later == pytest.approx(round(later), abs=1e-12)
        assert new.amplitude == 0.3
    assert moved.angular_springs[1].muscle == JointMuscle(amplitude=-10.0, phase=270.0)
    far = move_muscles(moved, SOME, -0.25, 5.0, 5000.0).scene
    assert far.linear_springs[0].muscle == SpringMuscle(amplitude=0.9)
    assert far.angular_springs[1].muscle == JointMuscle(amplitude=180.0)


def test_a_wave_is_largest_where_its_crest_is() -> None:
    scene = move_muscles(worm(), SOME, 0.37, 0.0, 0.0).scene
    waves: tuple[tuple[Wave, int], ...] = (("sine", 1), ("pulse", 1), ("sine", 5), ("pulse", 16))
    for wave, per_beat in waves:
        muscle = shape_muscles(scene, SOME, wave, per_beat).scene.linear_springs[0].muscle
        assert isinstance(muscle, SpringMuscle)
        times = np.linspace(0.0, 1.0, 4001)
        sizes = [swings(Beat(), [muscle], (), t)[0] for t in times]
        at = times[int(np.argmax(sizes))] % (1.0 / per_beat)
        assert at == pytest.approx(crest(muscle), abs=5e-4)
        assert max(sizes) == pytest.approx(0.2, abs=1e-4)


def test_muscles_are_spread_one_after_the_other() -> None:
    every = Selection(springs=frozenset(range(4)))
    scene = give_muscles(rope(), every).scene
    crests = [crest(s.muscle) for s in spread_muscles(scene, every).scene.linear_springs if s.muscle]
    assert crests == [0.0, 0.25, 0.5, 0.75]


def test_numbers_of_muscles_are_those_of_the_parts_that_have_one() -> None:
    scene, every = worm(), range(4)
    phase = number("linear_springs", "muscle.phase")
    assert values_of(scene, phase, every) == {0.0, None}
    after = set_number(scene, phase, every, 90.0).scene
    assert [bool(s.muscle) and s.muscle.phase for s in after.linear_springs] == [90.0, False, 90.0, False]
    per_beat = number("angular_springs", "muscle.per_beat")
    twice = set_number(scene, per_beat, (1,), 2.0).scene.angular_springs[1].muscle
    assert isinstance(twice, JointMuscle) and repr(twice.per_beat) == "2"
    for value, why in ((1.5, "1.5 is not a whole number"), (17.0, r"range 1\.\.16"), (math.inf, "range")):
        with pytest.raises(sim.SettingError, match=why):
            set_number(scene, per_beat, (1,), value)


# ------------------------------------------------------------------------- other edits
def test_a_mirrored_body_moves_as_a_mirror_shows_it() -> None:
    scene = replace(worm(), anchors=(), integrator=sim.Integrator(method="rk4", dt=0.002))
    places = starts(scene)
    turned = mirror(scene, range(5), places).scene
    assert turned.angular_springs[1].muscle == JointMuscle(amplitude=-20.0)
    assert turned.linear_springs[0].muscle == SpringMuscle()
    xs = [x for x, _ in places]
    one, other = sim.Simulation(scene), sim.Simulation(turned)
    step_all(300, one, other)
    seen = other.positions * (-1.0, 1.0) + (min(xs) + max(xs), 0.0)
    np.testing.assert_allclose(seen, one.positions, atol=1e-8)
    assert np.abs(one.positions - places).max() > 1.0


def test_muscles_of_joints_alone_bring_a_beat_where_they_are_pasted() -> None:
    scene = give_muscles(rope(), Selection(joints=frozenset({1}))).scene
    assert (
        copying.paste(rope(), copying.copy(scene, range(5), starts(scene)), (100.0, 100.0)).scene.beat
        == Beat()
    )


def test_copies_keep_their_muscles_and_bring_a_beat() -> None:
    scene = worm()
    fragment = copying.decode(copying.encode(copying.copy(scene, range(5), starts(scene))))
    still = replace(rope(), bodies=())
    pasted = copying.paste(still, fragment, (100.0, 100.0)).scene
    assert pasted.beat == Beat()
    assert pasted.linear_springs[4].muscle == SpringMuscle()
    assert pasted.angular_springs[4].muscle == JointMuscle()
    own = copying.paste(replace(still, beat=Beat(frequency=2.0)), fragment, (0.0, 0.0))
    assert own.scene.beat == Beat(frequency=2.0)
    plain = copying.copy(still, range(5), starts(still))
    assert not copying.paste(still, plain, (0.0, 0.0)).scene.beat


def test_what_is_left_of_a_cut_body_keeps_its_muscles() -> None:
    left = remove(worm(), Selection(springs=frozenset({0}))).scene
    assert [bool(s.muscle) for s in left.linear_springs] == [False, True, False]
    assert [bool(j.muscle) for j in left.angular_springs] == [True, False]


def test_what_rests_as_it_is_feels_no_force_then() -> None:
    scene = replace(worm(), gravity=(0.0, 0.0))
    simulation = after(scene, 0.3)
    every = Selection(springs=frozenset(range(4)), joints=frozenset(range(3)))
    moment = simulation.capture()
    rests = take_as_rest(moment, every).scene
    off = simulation.angles - simulation.rest_angles
    strained = simulation.energy().linear
    assert np.abs(off).min() > 1e-3 and strained > 1.0
    simulation.restore(dataclasses.replace(moment, scene=rests))
    np.testing.assert_allclose(simulation.angles, simulation.rest_angles, atol=1e-9)
    assert simulation.energy().linear < 1e-9


# ------------------------------------------------------------------------- the tempo
def test_the_tempo_is_a_setting_of_scenes_with_muscles() -> None:
    assert "tempo" in {setting.key for setting in settings_of(worm())}
    assert "tempo" not in {setting.key for setting in settings_of(rope())}
    rests = replace(rope(), beat=Beat())
    assert "tempo" not in {setting.key for setting in settings_of(rests)}
    assert set_value(worm(), "tempo", 2.5).beat == Beat(frequency=2.5)
    with pytest.raises(sim.SettingError, match=r"101 is not in the range 0\.\.100 Hz"):
        set_value(worm(), "tempo", 101.0)


@pytest.mark.parametrize("time", [0.0, 0.3, 17.25, 4321.0])
def test_waves_go_on_from_where_they_are_at_another_tempo(time: float) -> None:
    muscles = [SpringMuscle(phase=40.0, per_beat=3), JointMuscle(phase=200.0), SpringMuscle(wave="pulse")]
    beat = Beat(frequency=1.3, phase=77.0)
    for frequency in (0.0, 0.4, 1.3, 9.0):
        other = beat.at_tempo(frequency, time)
        assert other.frequency == frequency and 0.0 <= other.phase <= 360.0
        np.testing.assert_allclose(
            swings(other, muscles, (), time), swings(beat, muscles, (), time), atol=1e-6
        )
        scene = replace(worm(), beat=beat)
        assert set_value(scene, "tempo", frequency, time).beat == other
