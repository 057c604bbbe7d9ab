"""A session without a browser: what commands do to the simulation, and what the user is told."""

from __future__ import annotations

import math
from functools import partial

import msgspec
import numpy as np
import pytest

import sim
from app.session import commands
from app.session.hand import GIZMO, MAX_HANDS
from app.session.session import KEYS_FORGOTTEN_AFTER, MAX_QUEUE
from tests.app.inside import guard
from tests.app.pages import FRAME, SessionPage, answered
from tests.sim.builders import tutorial_preset


@pytest.fixture
def page() -> SessionPage:
    page = SessionPage()
    page.frames(1)
    return page


def test_a_second_on_the_wall_is_400_steps(page: SessionPage) -> None:
    page.frames(60)
    assert page.simulation.step_count == pytest.approx(400, abs=1)
    assert page.session.pacer.rates(page.wall.time).real_time_factor == pytest.approx(1.0, abs=0.03)


@pytest.mark.parametrize("factor", [0.125, 0.5, 2.0, 4.0])
def test_speed_multiplies_the_steps(page: SessionPage, factor: float) -> None:
    page.frames(120, commands.Speed(factor))
    assert page.simulation.step_count == pytest.approx(800 * factor, abs=2)


def test_pause_step_reset(page: SessionPage) -> None:
    page.frames(30, commands.Play(False))
    stood = page.simulation.step_count
    page.frames(30)
    assert page.simulation.step_count == stood
    page.frames(1, commands.DoSteps(10))
    assert page.simulation.step_count == stood + 10
    page.frames(1, commands.Reset())
    assert page.simulation.step_count == 0
    assert not page.session.playing
    page.frames(60, commands.Play())
    assert page.simulation.step_count == pytest.approx(400, abs=10)
    page.frames(5, commands.DoSteps(1))
    assert not page.session.playing, "a step pauses"


def test_held_keys_act_and_are_forgotten_in_silence(page: SessionPage) -> None:
    """After half a second without a word, the connection may be gone, and with it the key's release."""
    for _ in range(30):
        page.frames(1, commands.HoldKeys(frozenset({"right"})))
    turned = page.simulation.rest_angles[0]
    assert turned == pytest.approx(20.0, abs=1.0)  # 40 degrees a second
    page.frames(200)
    silent = page.simulation.rest_angles[0]
    assert silent == pytest.approx(turned + 40.0 * KEYS_FORGOTTEN_AFTER, abs=1.5)
    page.frames(60)
    assert page.simulation.rest_angles[0] == silent
    page.frames(2, commands.HoldKeys(frozenset({"up", "enter"})))
    assert page.simulation.keys == {"up"}, "others are ignored"


def test_a_dragged_held_mass_keeps_its_distance_to_the_pointer_and_stays(page: SessionPage) -> None:
    x, y = page.simulation.positions[0]
    page.frames(1, commands.DragStart(0, x + 3.0, y))
    page.frames(5, commands.Point(x + 53.0, y + 20.0))
    page.frames(30, commands.DragEnd())
    assert page.simulation.positions[0] == pytest.approx((x + 50.0, y + 20.0))
    assert not page.session.hands.masses


def test_a_drag_is_smooth_between_two_slow_reports(page: SessionPage) -> None:
    """viser reports drags at 20 Hz; the mass must be on its way in every frame, and never leap."""
    x, y = page.simulation.positions[0]
    page.frames(1, commands.DragStart(0, x, y))
    places = []
    for report in range(1, 11):
        page.session.post(commands.Point(x + 30.0 * report, y, late=True))
        for _ in range(3):
            page.frames(1)
            places.append(page.simulation.positions[0, 0])
    moves = np.diff(places)
    assert (moves > 1.0).all()
    assert moves.max() < 20.0


def test_a_free_mass_is_held_while_dragged_and_falls_after(page: SessionPage) -> None:
    x, y = page.drag(11, 80.0, -60.0, frames=31)
    assert page.simulation.positions[11] == pytest.approx((x + 80.0, y - 60.0))
    page.frames(30, commands.DragEnd())
    assert np.hypot(*(page.simulation.positions[11] - (x + 80.0, y - 60.0))) > 5.0


def test_a_gizmo_that_keeps_to_its_axis_is_not_disturbed_by_the_pointer(page: SessionPage) -> None:
    x, y = page.simulation.positions[0]
    page.frames(1, commands.DragStart(0, x, y, GIZMO))
    page.frames(20, commands.Point(x + 40.0, y, GIZMO, late=True), commands.Point(x + 40.0, y + 90.0))
    assert page.simulation.positions[0] == pytest.approx((x + 40.0, y))


def test_every_hand_drags_a_mass_of_its_own(page: SessionPage) -> None:
    hands = range(MAX_HANDS)
    before = page.simulation.positions
    moved = []
    for hand, (x, y) in zip(hands, before[1:].tolist(), strict=False):
        page.session.post(commands.DragStart(hand + 1, x, y, hand))
        moved.append(commands.Point(x + 5.0 * hand, y - 30.0, hand))
    page.frames(20, *moved)
    assert page.session.hands.masses == tuple(hand + 1 for hand in hands)
    wanted = before[1 : MAX_HANDS + 1] + np.outer(hands, (5.0, 0.0)) + (0.0, -30.0)
    assert page.simulation.positions[1 : MAX_HANDS + 1] == pytest.approx(wanted)
    page.frames(1, *(commands.DragEnd(hand) for hand in hands if hand != 4))
    assert page.session.hands.masses == (5,)
    assert page.simulation.grabbed == [5]
    page.frames(20, *moved)
    assert page.simulation.positions[5] == pytest.approx(wanted[4])


def test_a_mass_goes_to_the_hand_that_took_it_last(page: SessionPage) -> None:
    x, y = page.simulation.positions[11]
    page.frames(1, commands.DragStart(11, x, y, 0), commands.DragStart(11, x, y, 3))
    page.frames(20, commands.DragEnd(0), commands.Point(x + 40.0, y, 3))
    assert page.session.hands.masses == (11,)
    assert page.simulation.positions[11] == pytest.approx((x + 40.0, y))
    page.frames(1, commands.DragStart(10, x, y, 3))
    assert page.simulation.grabbed == [10]


def test_what_follows_the_pointer_comes_to_where_a_drag_has_ended(page: SessionPage) -> None:
    x, y = page.simulation.positions[11]
    page.frames(2, commands.Follow(True), commands.Point(200.0, 100.0))
    page.frames(2, commands.DragStart(11, x, y), commands.Point(x - 60.0, y))
    assert page.simulation.positions[0] == pytest.approx((200.0, 100.0))
    page.frames(20, commands.DragEnd())
    assert page.simulation.positions[0] == pytest.approx((x - 60.0, y))


def test_dragging_works_while_paused(page: SessionPage) -> None:
    x, y = page.simulation.positions[0]
    page.frames(1, commands.Play(False), commands.DragStart(0, x, y), commands.Point(x + 10.0, y))
    assert page.simulation.positions[0] == pytest.approx((x + 10.0, y))


def test_follow_needs_no_button_and_ends(page: SessionPage) -> None:
    page.frames(20, commands.Follow(True), commands.Point(111.0, 222.0))
    assert page.simulation.positions[0] == pytest.approx((111.0, 222.0))
    page.frames(20, commands.Follow(False), commands.Point(5.0, 5.0))
    assert page.simulation.positions[0] == pytest.approx((111.0, 222.0))


def test_a_pointer_that_is_nowhere_and_a_mass_that_does_not_exist_are_refused(page: SessionPage) -> None:
    before = page.simulation.positions[0]
    page.frames(1, commands.Follow(True))
    for x in (math.nan, math.inf, -math.inf):
        page.frames(3, commands.Point(x, 0.0), commands.DragStart(0, x, x))
    assert page.simulation.positions[0] == pytest.approx(before)
    page.frames(2, commands.DragStart(99, 0.0, 0.0), commands.DragStart(-1, 0.0, 0.0))
    assert not page.session.hands.masses
    assert len(page.session.notices) == 3 * 2 + 2


def test_a_pointer_out_of_the_world_is_clamped(page: SessionPage) -> None:
    page.frames(20, commands.Play(False), commands.Follow(True), commands.Point(1e30, 0.0))
    assert page.simulation.positions[0, 0] == 1e6


def test_forged_numbers_are_ignored_or_clamped(page: SessionPage) -> None:
    before = page.session.scene
    for key, value in (
        ("gravity", math.nan),
        ("nothing", 1.0),
        ("template", 45.0),
        ("linear_damping", math.inf),
    ):
        page.frames(1, commands.SetValue(key, value))
        assert page.session.scene == before, key
    page.frames(1, commands.Play(False), commands.SetValue("angular_stiffness", 1e300))
    assert page.session.scene.angular_springs[0].stiffness == 1e15
    for factor in (1e9, -1.0, math.nan, math.inf):
        page.frames(1, commands.Speed(factor))
        assert 0.125 <= page.session.pacer.speed <= 4.0, factor


def test_another_number_of_masses_is_another_body(page: SessionPage) -> None:
    generation = page.session.generation
    page.frames(2, commands.SelectJoint(9), commands.SetValue("masses", 5))
    assert len(page.session.scene.masses) == 5
    assert page.session.generation == generation + 1
    assert page.session.joint == 2


def test_the_number_of_masses_can_change_in_the_middle_of_a_drag(page: SessionPage) -> None:
    page.frames(2, commands.DragStart(11, 300.0, 480.0), commands.SetValue("masses", 4))
    page.frames(5, commands.Point(0.0, 0.0), commands.DragEnd())
    assert not page.session.hands.masses
    assert not page.session.notices


def test_opening_a_scene_starts_it_anew_and_goes_on_tracking_the_energy(page: SessionPage) -> None:
    page.frames(10, commands.Follow(True), commands.FollowEnergy(True))
    page.frames(1, commands.Open(tutorial_preset("ring")))
    assert page.session.scene.name == "ring"
    assert not page.session.follow
    assert page.session.follows_energy
    page.frames(30)
    assert page.simulation.step_count > 0
    # A balance that was opened only when it is asked for would know nothing of what was damped before.
    assert page.simulation.energy().damping < 0.0


def test_the_residual_is_that_of_one_method(page: SessionPage) -> None:
    page.frames(1, commands.SetValue("rest_angle", 20.0), commands.FollowEnergy(True))
    page.frames(60)
    assert abs(page.simulation.energy().residual) > 1.0
    # The same body by another method, which has done no step yet.
    page.frames(0, commands.Play(False), commands.SetChoice("method", "rk4"))
    page.session.drain()
    assert page.simulation.method == "rk4"
    assert page.simulation.energy().residual == 0.0


def test_the_scene_s_own_values_come_back_and_nothing_else(page: SessionPage) -> None:
    session = page.session
    mine = session.scene
    page.frames(
        20,
        commands.SetValue("gravity", 300.0),
        commands.SetValue("angular_stiffness", 0.0),  # all of them, so that no proportions are left
        commands.SetValue("dt", 0.001),
        commands.SetChoice("method", "rk4"),
        commands.SetChoice("force_law", "angle"),
        commands.HoldKeys(frozenset({"up", "right"})),
    )
    page.frames(1, commands.HoldKeys(frozenset()), commands.Play(False))
    before, time = session.simulation.positions, session.simulation.time
    page.frames(0, commands.RestoreSceneValues("body"))
    session.drain()
    assert session.scene == msgspec.structs.replace(
        mine, force_law="angle", integrator=session.scene.integrator
    )
    assert session.scene.integrator.method == "rk4"
    assert session.simulation.dt == 0.001
    page.frames(0, commands.RestoreSceneValues("solver"))
    session.drain()
    assert session.scene == mine
    assert np.array_equal(session.simulation.positions, before)
    assert session.simulation.time == time
    # Another number of masses is another body.
    page.frames(1, commands.SetValue("masses", 20.0), commands.RestoreSceneValues("body"))
    assert session.scene == mine


def run_away(page: SessionPage) -> None:
    page.frames(1, commands.SetValue("angular_stiffness", 60_000.0))
    page.frames(30, commands.Follow(True), commands.Point(400.0, 150.0))
    assert not page.session.playing
    assert [notice.about for notice in page.session.notices] == ["runaway"]


def test_a_scene_chosen_after_a_runaway_plays_and_one_chosen_in_a_pause_does_not(page: SessionPage) -> None:
    run_away(page)
    page.frames(5, commands.Open(sim.load_scene("ring")))
    assert page.session.playing
    page.frames(5, commands.Play(False), commands.Open(sim.load_scene("box")))
    assert not page.session.playing


def test_a_slow_machine_lags_and_never_spirals(page: SessionPage, monkeypatch: pytest.MonkeyPatch) -> None:
    """With a budget for three steps a frame the clock falls behind, and says by how much."""
    session, computed = page.session, 0.0
    step, spend = session.recorder.step, session.costs.spend

    def slow(n: int, attempts: int) -> int:
        nonlocal computed
        done = step(n, attempts)
        computed += 1e-3 * done
        return done

    monkeypatch.setattr(session.recorder, "step", slow)
    monkeypatch.setattr(session.costs, "spend", partial(spend, clock=lambda: computed))
    before = session.simulation.step_count
    for _ in range(60):
        page.wall.time += FRAME
        session.tick(budget=3.01e-3)
    assert session.simulation.step_count - before == pytest.approx(180, abs=6)
    rates = session.pacer.rates(page.wall.time)
    assert rates.real_time_factor == pytest.approx(180 / 400, abs=0.05)
    assert rates.behind == pytest.approx(1.0 - 180 / 400, abs=0.05)


def test_after_a_long_silence_the_body_does_not_leap(page: SessionPage) -> None:
    before = page.simulation.step_count
    page.wall.time += 30.0
    page.session.tick(budget=1.0)
    assert page.simulation.step_count - before <= 40
    assert page.session.pacer.behind == pytest.approx(29.9, abs=0.1)


def test_a_runaway_body_stops_with_the_cause_in_the_user_s_words(page: SessionPage) -> None:
    run_away(page)
    assert page.simulation.divergence is not None
    for part in ("stability limit", "angular stiffness 60000", "0.0025"):
        assert part in page.told
    assert np.abs(page.simulation.positions).max() <= 1e6  # and so none is NaN


def pulled_without_damping(page: SessionPage, law: str, dt: float = 0.0025) -> None:
    """The rope's end is pulled aside by 250 px while the clock stands, and let go: no damping, no air."""
    page.frames(1, commands.Play(False))
    for key in ("linear_damping", "air_friction"):
        page.frames(1, commands.SetValue(key, 0.0))
    page.frames(1, commands.SetValue("dt", dt), commands.SetChoice("force_law", law))
    x, y = page.simulation.positions[-1]
    page.frames(1, commands.DragStart(11, x, y), commands.Point(x + 250.0, y, late=True))
    page.frames(1, commands.DragEnd())
    page.frames(20)
    assert page.simulation.dt < 0.8 * page.session.stability.limit
    page.frames(600, commands.Play(True))


@pytest.mark.parametrize("law", ["tutorial", "conservative"])
def test_a_body_that_runs_away_below_the_limit_is_told_why_that_can_be(page: SessionPage, law: str) -> None:
    pulled_without_damping(page, law)
    divergence = page.simulation.divergence
    assert divergence is not None
    assert divergence.dt < divergence.stability.limit
    assert "below the stability limit, but that is for small motions about one pose" in page.told
    assert "raise the damping" in page.told
    # A smaller step helps where the law has an energy, and nowhere else.
    assert ("lower the time step" in page.told) == (law == "conservative")
    assert ("no energy" in page.told) == (law == "tutorial")


@pytest.mark.parametrize(("law", "helps"), [("tutorial", False), ("conservative", True)])
def test_a_smaller_step_helps_where_the_notice_says_so(page: SessionPage, law: str, helps: bool) -> None:
    pulled_without_damping(page, law, dt=0.0005)
    assert (page.simulation.divergence is None) == helps


def test_the_meter_warns_before_that(page: SessionPage) -> None:
    page.frames(20, commands.Play(True))
    calm = page.session.stability.limit
    page.frames(1, commands.SetValue("angular_stiffness", 60_000.0))
    assert page.simulation.divergence is None
    assert calm > page.simulation.dt > page.session.stability.limit


def test_a_look_at_the_limit_goes_on_over_frames(page: SessionPage) -> None:
    """With next to no time for it, a frame does a part; a change, or another body, has it begin anew."""
    page.frames(2, commands.Play(False))
    session, calm = page.session, page.session.stability
    session.post(commands.SetValue("angular_stiffness", 1e8))
    frames = 0
    while frames < 4 or session.stability.limit < calm.limit or session.stability_watch.is_looking:
        page.wall.time += FRAME
        session.drain()
        session.tick(1e-9)
        frames += 1
        if frames == 3:
            assert session.stability == calm
            session.post(commands.SetValue("angular_stiffness", 1.0))
    assert frames > 40
    assert session.stability.limit > calm.limit
    session.post(commands.SetValue("angular_stiffness", 1e8))
    session.drain()
    session.tick(1e-9)
    assert session.stability_watch.is_looking
    session.post(commands.Open(sim.load_scene("ring")))  # under "auto", which has no limit
    session.drain()
    session.tick(1e-9)
    assert not session.stability_watch.is_looking
    assert session.stability.limit == math.inf


def test_the_meter_follows_changes_while_paused(page: SessionPage) -> None:
    page.frames(2, commands.Play(False))
    page.frames(2, commands.SetValue("angular_stiffness", 1e8))
    assert page.session.stability.limit < 1e-4
    page.frames(2, commands.Open(tutorial_preset("ring")))
    assert 1e-3 < page.session.stability.limit < 1e-2
    page.frames(2, commands.Open(sim.load_scene("ring")))  # under "auto", which has no limit
    assert page.session.stability.limit == math.inf


def test_a_snapshot_holds_the_keys_work_and_the_pose(page: SessionPage) -> None:
    page.frames(20, commands.HoldKeys(frozenset({"up"})))
    page.frames(1, commands.Play(False))
    bare = answered(page.session, lambda: page.session.snapshot("a", with_pose=False))
    scene = answered(page.session, lambda: page.session.snapshot("b", with_pose=True))
    assert scene.rest_length_scale > 1.0
    again = sim.Simulation(scene)
    assert np.array_equal(again.positions, page.simulation.positions)
    assert np.array_equal(again.velocities, page.simulation.velocities)
    assert bare.pose is None


def test_of_bodies_that_are_to_come_the_last_waits_alone(page: SessionPage) -> None:
    for name in ("box", "ring", "flag-pole"):
        page.session.post(commands.Resume(b"x" * 1000))
        page.session.post(commands.SetValue("gravity", 300.0))
        page.session.post(commands.Open(sim.load_scene(name)))
    assert len(page.session.waiting) == 4
    page.frames(1)
    assert page.session.scene.name == "flag-pole"
    assert not page.session.notices


def test_what_one_body_cost_says_nothing_of_the_next(page: SessionPage) -> None:
    page.session.pacer.speed = 2.0
    page.session.costs.learn(0, 1.0, 1)
    assert page.session.is_heavy
    page.session.post(commands.Open(sim.load_scene("box")))
    page.session.drain()
    assert not page.session.is_heavy
    assert page.session.pacer.speed == 2.0


def test_a_flood_of_commands_is_bounded(page: SessionPage) -> None:
    for i in range(3 * MAX_QUEUE):
        page.session.post(commands.Point(float(i), 0.0))
    assert len(page.session.waiting) == MAX_QUEUE
    page.frames(1)
    assert not page.session.waiting


def test_the_meter_and_the_notice_of_a_runaway_name_one_limit(page: SessionPage) -> None:
    page.frames(30, commands.SetValue("rest_angle", 30.0))
    page.frames(120, commands.SetValue("angular_stiffness", 1e9))
    session = page.session
    assert session.simulation.divergence is not None
    assert session.stability == session.simulation.divergence.stability
    limit = f"stability limit {session.stability.limit:.2g} s"
    assert limit in session.notices[-1].text


def test_what_waits_is_read_while_nobody_adds_to_it(page: SessionPage) -> None:
    entered: list[bool] = []
    session = page.session

    class Lock:
        def __enter__(self) -> None:
            entered.append(True)

        def __exit__(self, *_: object) -> None: ...

    guard(session, Lock())
    for look in (lambda: session.is_heavy, lambda: session.will_play):
        entered.clear()
        look()
        assert entered
