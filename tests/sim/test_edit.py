"""Edits: a valid scene stays valid, undo is exact, masses keep their identity; what each edit makes."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim.edit.build import add_joints, add_mass, add_springs, extend, pin, positions_of, remove
from sim.edit.copying import copy, decode, encode, paste
from sim.edit.edit import Edit, Selection, carried, inverse, of_parts
from sim.edit.shape import add_corners, cut, mirror, move, triangulate
from sim.edit.values import NUMBERS, number, scale_number, set_number, take_as_rest, values_of
from sim.errors import SceneError, SettingError
from sim.scene.types import Damage
from sim.scene.validate import validate
from tests.amount import examples
from tests.sim.builders import built
from tests.sim.changes import after, step_all, with_springs
from tests.sim.checks import known

SCENES = ("tutorial-3.2", "tutorial-3.3", "ring", "box", "girder", "air-balloon", "pile", "hair-tuft")
Positions = list[tuple[float, float]]


def square(joints: bool = False) -> sim.Scene:
    """Four masses, joined around."""
    corners = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)]
    around = [(0, 1), (1, 2), (2, 3), (3, 0)]
    scene = built(corners, around, stiffness=1000.0, damping=3.0)
    return add_corners(scene, range(4), starts(scene)).scene if joints else scene


def starts(scene: sim.Scene) -> Positions:
    return [mass.position for mass in scene.masses]


# ------------------------------------------------------------------------- any edits at all
def some_edit(draw: Callable[[st.SearchStrategy[Any]], Any], scene: sim.Scene, at: Positions) -> Edit:
    """One edit of any kind, with any of the scene's parts."""
    n, springs, joints = len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)
    mass = st.integers(0, n - 1)
    masses = st.frozensets(mass, max_size=6)
    point = st.tuples(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3))

    def parts(count: int) -> st.SearchStrategy[frozenset[int]]:
        return st.frozensets(st.integers(0, count - 1), max_size=4) if count else st.just(frozenset())

    def numbers() -> Edit:
        of = draw(st.sampled_from(NUMBERS))
        some = draw(parts(len(getattr(scene, of.kind))))
        value = draw(st.floats(max(of.low, -1e6), min(of.high, 1e6)))
        return draw(st.sampled_from((set_number, scale_number)))(scene, of, some, value)

    kinds: tuple[Callable[[], Edit], ...] = (
        lambda: add_mass(scene, draw(point), draw(st.booleans())),
        lambda: add_springs(scene, draw(st.lists(st.tuples(mass, mass), max_size=3)), at),
        lambda: extend(scene, draw(mass), draw(point), at),
        lambda: remove(scene, Selection(draw(masses), draw(parts(springs)), draw(parts(joints)))),
        lambda: pin(scene, draw(masses), draw(st.booleans())),
        lambda: move(scene, draw(masses), draw(point)),
        lambda: mirror(scene, draw(masses), at),
        lambda: cut(scene, draw(st.lists(point, min_size=2, max_size=4)), at),
        lambda: add_corners(scene, draw(masses), at),
        lambda: triangulate(scene, draw(masses), at),
        lambda: paste(scene, copy(scene, draw(masses), at), draw(point)),
        numbers,
    )
    return draw(st.sampled_from(kinds))()


@given(st.data())
@settings(max_examples=examples(150))
def test_a_valid_scene_stays_valid_and_undo_is_exact(data: st.DataObject) -> None:
    simulation = sim.Simulation(sim.load_scene(data.draw(st.sampled_from(SCENES))))
    if data.draw(st.booleans()):
        simulation.advance(0.3)
    before = simulation.capture()
    moment, undo = before, []
    for _ in range(data.draw(st.integers(1, 6))):
        try:
            at = [(x, y) for x, y in moment.positions.tolist()]
            edit = some_edit(data.draw, moment.scene, at)
        except (SceneError, SettingError):
            continue  # a sentence, and nothing has changed
        assert validate(edit.scene) == edit.scene
        undo.append(inverse(edit, moment.scene, moment))
        after = carried(edit, moment)
        _keeps_identity(edit, moment, after)
        moment = after
    simulation.restore(moment)  # the solver takes it
    assert np.isfinite(simulation.positions).all()
    for back in reversed(undo):
        moment = carried(back, moment)
    assert moment.scene is before.scene
    np.testing.assert_allclose(moment.rows[:2], before.rows[:2], rtol=0.0, atol=1e-9)
    assert moment.damage == before.damage


def _keeps_identity(edit: Edit, before: sim.Moment, after: sim.Moment) -> None:
    """Masses that were there before are where they were, but for those that were moved."""
    origin = edit.masses if edit.masses is not None else range(len(before.scene.masses))
    assert len(after.scene.masses) == after.rows.shape[1]
    for new, old in enumerate(origin):
        if old >= 0:
            by = edit.shift[:, new] if edit.shift is not None else 0.0
            np.testing.assert_array_equal(after.rows[:2, new], before.rows[:2, old] + by)
            one, two = after.scene.masses[new], before.scene.masses[old]
            if edit.shift is None and "set" not in edit.label and "scaled" not in edit.label:
                assert one == two


# ------------------------------------------------------------------------- each of them
def test_the_first_edit_takes_recipes_apart_without_changing_the_body() -> None:
    scene = sim.load_scene("tutorial-3.3")
    parts = of_parts(scene)
    assert not parts.bodies
    assert parts.masses == scene.masses
    template = sim.load_scene("tutorial-3.2")
    one, two = sim.Simulation(template), sim.Simulation(of_parts(template))
    step_all(200, one, two)
    np.testing.assert_allclose(two.positions, one.positions, atol=1e-9)


def test_a_mass_and_a_spring_are_like_the_others_and_rest_as_they_are() -> None:
    scene = square()
    edit = extend(scene, 2, (160.0, 180.0), starts(scene))
    assert edit.label == "mass and spring added"
    mass, spring = edit.scene.masses[4], edit.scene.linear_springs[4]
    assert (mass.position, mass.mass) == ((160.0, 180.0), 1.0)
    assert (spring.a, spring.b, spring.stiffness, spring.damping) == (2, 4, 1000.0, 3.0)
    assert spring.rest_length == pytest.approx(100.0)
    assert edit.masses == (0, 1, 2, 3, -1)


def test_a_mass_that_extends_a_moving_body_starts_where_it_is_seen_from_the_other() -> None:
    """After a reset the new spring is at rest, too."""
    scene = square()
    start = sim.Simulation(scene).capture()
    rows = start.rows + np.array([[30.0], [-20.0], [0.0], [0.0]])
    moment = dataclasses.replace(start, rows=rows)
    edit = extend(scene, 2, (160.0, 180.0), positions_of(moment))
    after = carried(edit, moment)
    np.testing.assert_allclose(after.positions[4], (160.0, 180.0))
    np.testing.assert_allclose(after.positions[:4], moment.positions)
    start, other = (edit.scene.masses[i].position for i in (4, 2))
    assert math.dist(start, other) == pytest.approx(edit.scene.linear_springs[4].rest_length)
    assert start == pytest.approx((130.0, 200.0))
    again = carried(inverse(edit, scene, moment), after)
    np.testing.assert_array_equal(again.positions, moment.positions)


def test_a_new_spring_is_at_rest_under_any_scale_of_rest_lengths() -> None:
    scene = replace(square(), rest_length_scale=2.0)
    edit = add_springs(scene, [(0, 2)], starts(scene))
    assert edit.scene.linear_springs[4].rest_length * 2.0 == pytest.approx(math.hypot(100.0, 100.0))
    for edit in (
        add_springs(scene, [(0, 2)], starts(scene), scale=5.0),
        triangulate(scene, range(4), starts(scene), scale=5.0),
    ):
        assert edit.scene.linear_springs[4].rest_length * 5.0 == pytest.approx(math.hypot(100.0, 100.0))
    edit = extend(scene, 0, (0.0, 60.0), starts(scene), scale=3.0)
    assert edit.scene.linear_springs[4].rest_length == pytest.approx(20.0)


def test_what_a_mass_held_goes_with_it() -> None:
    scene = square(joints=True)
    scene = pin(scene, [3], True).scene
    assert len(scene.angular_springs) == 4
    edit = remove(scene, Selection(masses=frozenset({1})))
    assert edit.label == "1 mass removed"
    assert starts(edit.scene) == [(0.0, 0.0), (100.0, 100.0), (0.0, 100.0)]
    assert [(s.a, s.b) for s in edit.scene.linear_springs] == [(1, 2), (2, 0)]
    assert [(j.a, j.b) for j in edit.scene.angular_springs] == [(1, 0)]
    assert [anchor.mass for anchor in edit.scene.anchors] == [2]
    with pytest.raises(SceneError, match="at least one mass"):
        remove(scene, Selection(masses=frozenset(range(4))))


def test_a_filling_gets_out_where_its_skin_is_cut() -> None:
    balloon = sim.load_scene("air-balloon")
    rim = balloon.fillings[0].masses
    around = next(i for i, s in enumerate(balloon.linear_springs) if {s.a, s.b} == set(rim[:2]))
    assert not remove(balloon, Selection(springs=frozenset({around}))).scene.fillings
    assert not remove(balloon, Selection(masses=frozenset({rim[4]}))).scene.fillings
    # What is not of the skin may go.
    lone = sim.Mass(position=balloon.masses[0].position, mass=1.0)
    chord = sim.LinearSpring(a=rim[0], b=rim[5], stiffness=1.0, rest_length=9.0)
    springs = (*balloon.linear_springs, chord)
    inside = replace(balloon, bodies=(), masses=(*balloon.masses, lone), linear_springs=springs)
    across, alone = len(balloon.linear_springs), len(balloon.masses)
    left = remove(inside, Selection(springs=frozenset({across}), masses=frozenset({alone}))).scene
    assert left.fillings == balloon.fillings
    # Of two fillings, only the one that is cut.
    jelly = sim.jelly(columns=3, rows=2)
    assert [f.masses for f in remove(jelly, Selection(masses=frozenset({0}))).scene.fillings] == [
        (0, 1, 4, 3)
    ]
    # The stroke of a pen does the same, and an undo fills it again.
    x, y = balloon.masses[rim[0]].position
    moment = sim.Simulation(balloon).capture()
    open_ = cut(balloon, ((x - 500.0, y + 1.0), (x + 500.0, y + 1.0)), positions_of(moment))
    assert open_.scene.linear_springs != balloon.linear_springs
    assert not open_.scene.fillings
    assert inverse(open_, balloon, moment).scene.fillings == balloon.fillings


def test_a_filling_in_a_loop_without_a_skin_goes_with_the_last_of_it() -> None:
    places = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)]
    loop = built(places, [], fillings=(sim.Gas(masses=(0, 1, 2, 3), pressure=1.0),))
    assert remove(loop, Selection(masses=frozenset({1}))).scene.fillings[0].masses == (0, 1, 2)
    assert not remove(loop, Selection(masses=frozenset({1, 2}))).scene.fillings


def test_corners_are_held_as_they_are() -> None:
    scene = square(joints=True)
    assert sorted(abs(joint.rest_angle) for joint in scene.angular_springs) == [90.0] * 4
    simulation = after(scene, 1.0)
    np.testing.assert_allclose(simulation.positions, starts(scene), atol=1e-4)
    assert add_corners(scene, range(4), starts(scene)).joints is None  # there are no others


def test_a_square_is_braced_by_one_diagonal_and_only_inside() -> None:
    scene = square()
    edit = triangulate(scene, range(4), starts(scene))
    assert len(edit.scene.linear_springs) == 5
    # An outline with a dent: what is outside of it stays free.
    dent = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (50.0, 20.0), (0.0, 100.0)]
    dented = built(dent, [(i, (i + 1) % 5) for i in range(5)], stiffness=1.0)
    pairs = {(s.a, s.b) for s in triangulate(dented, range(5), dent).scene.linear_springs[5:]}
    assert pairs == {(0, 3), (1, 3)}
    with pytest.raises(SceneError, match="not on one line"):
        triangulate(scene, [0, 1], starts(scene))


def test_a_stroke_cuts_what_it_crosses() -> None:
    scene = square(joints=True)
    edit = cut(scene, [(50.0, -10.0), (50.0, 200.0)], starts(scene))
    assert edit.label == "2 springs cut"
    assert [(s.a, s.b) for s in edit.scene.linear_springs] == [(1, 2), (3, 0)]
    assert not edit.scene.angular_springs
    inside = cut(scene, [(50.0, 10.0), (50.0, 90.0)], starts(scene))
    assert inside.scene.linear_springs == scene.linear_springs
    corner_on_a_spring = [(50.0, -10.0), (50.0, 0.0), (50.0, 10.0)]
    assert cut(scene, corner_on_a_spring, starts(scene)).label == "1 spring cut"


def test_a_mirror_keeps_a_bent_body_at_rest() -> None:
    scene = square()
    bent = add_joints(scene, [(0, 1)], [90.0]).scene
    edit = mirror(bent, range(4), starts(scene))
    assert starts(edit.scene) == [(100.0, 0.0), (0.0, 0.0), (0.0, 100.0), (100.0, 100.0)]
    assert edit.scene.angular_springs[0].rest_angle == -90.0
    simulation = after(edit.scene, 0.5)
    np.testing.assert_allclose(simulation.positions, starts(edit.scene), atol=1e-4)


def test_moved_masses_keep_their_rest_lengths_or_take_the_new_ones() -> None:
    scene = square(joints=True)
    moved = move(scene, [2], (40.0, 30.0)).scene
    assert moved.linear_springs == scene.linear_springs
    resting = take_as_rest(sim.Simulation(moved).capture(), Selection(masses=frozenset({2}))).scene
    simulation = after(resting, 0.5)
    np.testing.assert_allclose(simulation.positions, starts(moved), atol=1e-4)
    with pytest.raises(SceneError, match="in the same place"):
        move(scene, [1], (-100.0, 0.0))


def test_a_copy_goes_through_text_and_nothing_forged_does() -> None:
    scene = pin(square(joints=True), [0], True).scene
    fragment = decode(encode(copy(scene, [0, 1, 2], starts(scene))))
    edit = paste(scene, fragment, (500.0, 500.0))
    assert starts(edit.scene)[4:] == [(450.0, 450.0), (550.0, 450.0), (550.0, 550.0)]
    assert [(s.a, s.b) for s in edit.scene.linear_springs[4:]] == [(4, 5), (5, 6)]
    assert [anchor.mass for anchor in edit.scene.anchors] == [0, 4]
    assert len(edit.scene.angular_springs) == 5
    text: Any = encode(fragment)
    for forged in (
        "", "[]", "{}", text.replace('"a":0', '"a":99'), text.replace("450", "NaN"), text[:-5],
        text.replace("softrod-fragment", "x"), '{"type":"softrod-fragment","masses":[]}',
    ):  # fmt: skip
        if forged != text:
            with pytest.raises(SceneError, match="cannot be pasted"):
                decode(forged)


def test_a_copy_that_is_too_much_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = triangulate(square(), range(4), starts(square())).scene
    scene = add_corners(scene, range(4), starts(scene)).scene
    springs, joints = len(scene.linear_springs), len(scene.angular_springs)
    assert joints > springs
    fragment = copy(scene, range(4), starts(scene))
    for most, what in ((2 * springs - 1, "9 springs"), (2 * joints - 1, f"{2 * joints - 1} angular springs")):
        monkeypatch.setattr("sim.edit.edit.MAX_SPRINGS", most)
        with pytest.raises(SceneError, match=what):
            paste(scene, fragment, (500.0, 500.0))
    monkeypatch.setattr("sim.edit.edit.MAX_SPRINGS", 2 * joints)
    validate(paste(scene, fragment, (500.0, 500.0)).scene)


def test_numbers_of_single_parts() -> None:
    scene = square(joints=True)
    stiffness = number("linear_springs", "stiffness")
    one = set_number(scene, stiffness, [1], 500.0)
    assert one.label == "Stiffness set: 1 spring"
    assert [s.stiffness for s in one.scene.linear_springs] == [1000.0, 500.0, 1000.0, 1000.0]
    assert values_of(one.scene, stiffness, [0, 1]) == {500.0, 1000.0}
    both = scale_number(one.scene, stiffness, [0, 1], 4000.0).scene
    assert [s.stiffness for s in both.linear_springs] == [4000.0, 2000.0, 1000.0, 1000.0]
    with pytest.raises(SettingError, match=r"^Stiffness: -1 is not in the range 0\.\.1e\+15 kg/s²$"):
        set_number(scene, stiffness, [0], -1.0)
    with pytest.raises(SettingError, match=r"range"):
        set_number(scene, stiffness, [0], math.nan)
    strength = number("linear_springs", "strength")
    strong = set_number(scene, strength, [0], 5.0).scene
    assert set_number(strong, strength, [0], None).scene == of_parts(scene)
    with pytest.raises(SettingError, match="no effect on a spring without a yield force"):
        set_number(scene, number("linear_springs", "hardening"), [0], 1.0)


def test_what_is_broken_stays_broken_when_others_go() -> None:
    scene = with_springs(square(), strength=1e9)
    simulation = sim.Simulation(scene)
    broken = dataclasses.replace(simulation.capture(), damage=Damage(broken=(2,)))
    after = carried(remove(scene, Selection(springs=frozenset({0}))), broken)
    assert known(after.damage).broken == (1,)
    simulation.restore(after)
    none = (0.0,) * 3
    assert simulation.damage == Damage(broken=(1,), set_lengths=none, hardened=none, set_angles=())


def test_numbers_in_proportion_stay_in_their_range() -> None:
    scene = square()
    mass = number("masses", "mass")
    light = set_number(scene, mass, [1], 1e-5).scene
    with pytest.raises(SettingError, match=r"^Mass: 5e-07 is not in the range 1e-06\.\.1e\+06 kg$"):
        scale_number(light, mass, [0, 1], 0.05)
    with pytest.raises(SceneError, match=r"^mass 4 does not exist \(0\.\.3\)$"):
        scale_number(light, mass, [0, 4], 2.0)


def test_rest_angles_can_be_set_with_what_keys_have_added() -> None:
    scene, angle = square(joints=True), number("angular_springs", "rest_angle")
    others = [joint.rest_angle for joint in scene.angular_springs[1:]]
    one = set_number(scene, angle, [0], 30.0, shift=350.0).scene
    assert [joint.rest_angle for joint in one.angular_springs] == [40.0, *others]
    two = set_number(one, angle, [1], -175.0, shift=10.0).scene
    assert two.angular_springs[1].rest_angle == pytest.approx(175.0)
    # 50 and -165 degrees with the shift; the second is the largest, and gets 33.
    scaled = scale_number(set_number(two, angle, [1], -175.0).scene, angle, [0, 1], 33.0, shift=10.0).scene
    assert [joint.rest_angle for joint in scaled.angular_springs[:2]] == pytest.approx([0.0, -43.0])
    assert set_number(scene, angle, [0], 33.3).scene.angular_springs[0].rest_angle == 33.3


def moment_of(scene: sim.Scene, positions: Positions, damage: Damage | None = None) -> sim.Moment:
    rows = np.array([*np.array(positions).T, *np.zeros((2, len(positions)))])
    return sim.Moment(scene, 2.0, 15.0, rows, 0.0, 0, damage)


def test_parts_rest_as_they_are_under_all_that_moves_their_rest() -> None:
    scene = square(joints=True)
    corners = [(0.0, 0.0), (120.0, 0.0), (120.0, 90.0), (0.0, 90.0)]
    damage = Damage(set_lengths=(20.0, 0.0, 0.0, 0.0), set_angles=(5.0, 0.0, 0.0, 0.0))
    moment = moment_of(scene, corners, damage)
    edit = take_as_rest(moment, Selection(springs=frozenset({0, 1}), joints=frozenset({0})))
    assert [s.rest_length for s in edit.scene.linear_springs] == pytest.approx([50.0, 45.0, 100.0, 100.0])
    first, others = edit.scene.angular_springs[0].rest_angle, edit.scene.angular_springs[1:]
    # The corner is as square as it was.
    assert first == pytest.approx(scene.angular_springs[0].rest_angle - 20.0)
    assert others == scene.angular_springs[1:]
    # Of masses alone: the springs at them, and all joints of these.
    of_mass = take_as_rest(moment, Selection(masses=frozenset({1}))).scene
    changed = [new != old for new, old in zip(of_mass.linear_springs, scene.linear_springs, strict=True)]
    assert changed == [True, True, False, False]
    turned = [new != old for new, old in zip(of_mass.angular_springs, scene.angular_springs, strict=True)]
    assert sum(turned) == 3
    with pytest.raises(SettingError, match="no spring and no joint is selected"):
        take_as_rest(moment, Selection())


def test_springs_that_had_yielded_come_back_as_they_were_by_an_undo() -> None:
    simulation = sim.Simulation(sim.load_scene("girder"))
    count = len(simulation.scene.linear_springs)
    worn = Damage(broken=(3,), set_lengths=(2.0, *[0.0] * (count - 2), -1.0))
    moment = dataclasses.replace(simulation.capture(), damage=worn)
    edit = remove(moment.scene, Selection(springs=frozenset((0, 3, count - 1))))
    after = carried(edit, moment)
    assert after.damage is None
    assert carried(inverse(edit, moment.scene, moment), after).damage == worn
