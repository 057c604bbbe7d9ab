"""Looking back: the ring of moments, going back and on, the old future, and the way out of a divergence."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from app.session import commands, history
from app.session.ghost import GhostMoment
from app.session.history import AbandonedFuture, History
from app.session.reel import Reel
from tests.amount import examples, part_of
from tests.app.pages import FRAME, SessionPage
from tests.sim.builders import tutorial_preset


def moment(time: float, scene: sim.Scene | None = None) -> sim.Moment:
    scene = scene or SCENE
    return sim.Moment(scene, 1.0, 0.0, np.full((4, len(scene.masses)), time), time, 0)


SCENE = sim.rope(masses=3)


@pytest.fixture
def page() -> SessionPage:
    page = SessionPage()
    page.frames(90)
    return page


# ------------------------------------------------------------------------- the ring
class HasAll(Reel):
    """A reel from which any frame could be computed again."""

    def has(self, number: int) -> bool:
        return True


def test_a_minute_of_frames_is_kept_and_what_the_reel_lacks() -> None:
    ring = History()
    for i in range(5000):
        ring.reel = Reel() if i < 100 else HasAll()
        ring.add(moment(i * FRAME))
    assert len(ring) == history.SPAN
    assert ring.end == pytest.approx(4999 * FRAME)
    assert ring.end - ring.start == pytest.approx(3599 * FRAME)
    ring.reel = Reel()
    for i in range(5000, 5100):
        ring.add(moment(i * FRAME))
    assert len(ring) == history.SPAN + 100


def bytes_of(ring: History) -> int:
    """What is kept, counted anew."""
    moments = [ring[i] for i in range(len(ring))]
    scenes = {id(m.scene): len(m.scene.masses) * 3 * 200 for m in moments}  # about
    return sum(m.rows.nbytes for m in moments) + sum(scenes.values())


def test_a_large_body_keeps_its_last_frames_and_fewer_of_a_minute(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "MAX_BYTES", 200_000)
    ring = History()
    ring.reel = HasAll()
    for i in range(5000):
        ring.add(moment(i * FRAME))
        assert ring.bytes <= 200_000
    times = np.array([ring[i].time for i in range(len(ring))])
    assert 100 < len(ring) < 500
    assert ring.end - ring.start == pytest.approx(60.0, abs=3.0)
    assert np.allclose(np.diff(times[-len(ring) // 3 :]), FRAME)
    assert (np.diff(times) > 0.0).all()


def test_of_a_body_of_which_hardly_one_moment_fits_the_last_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "MAX_BYTES", 3000)
    ring = History()
    for i in range(10):
        ring.add(moment(i * FRAME, sim.rope(masses=3)), {"ghost": GhostMoment(moment(0.0), 0.0, 0.0)})
        assert ring.end == i * FRAME
        assert len(ring) <= 2


def test_scenes_of_sliders_count_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "MAX_BYTES", 1_000_000)
    ring = History()
    for i in range(2000):
        ring.add(moment(i * FRAME, sim.rope(masses=20)))
        assert bytes_of(ring) < 1_500_000
    assert ring.end - ring.start > 30.0


@given(st.lists(st.floats(0.0, 100.0), min_size=1, max_size=40, unique=True), st.floats(-10.0, 110.0))
@settings(max_examples=examples(200))
def test_nearest_is_the_nearest(times: list[float], time: float) -> None:
    ring = History()
    for t in sorted(times):
        ring.add(moment(t))
    found = abs(ring[ring.nearest(time)].time - time)
    assert found == min(abs(t - time) for t in times)


@given(
    st.lists(st.tuples(st.sampled_from(["add", "cut", "amend", "back"]), st.floats(0.01, 2.0)), max_size=80)
)
@settings(max_examples=examples(200))
def test_the_ring_stays_in_order_and_counts_its_bytes(steps: list[tuple[str, float]]) -> None:
    ring, time = History(), 0.0
    scenes = [sim.rope(masses=3), sim.rope(masses=4)]
    ring.add(moment(0.0))
    for i, (what, seconds) in enumerate(steps):
        if what == "add":
            time = ring.end + seconds
            second = GhostMoment(moment(time, scenes[i % 3 % 2]), 0.0, 0.0)
            ring.add(moment(time, scenes[i % 2]), {"ghost": second} if i % 5 else None)
        elif what == "amend":
            ring.amend(moment(ring.end))
        elif what == "back":
            index = ring.back(seconds)
            assert isinstance(index, int)  # the reel has nothing
            ring.shown = index
        else:
            shown = ring.shown
            newer = ring.cut()
            assert ring.last == shown
            assert not newer or newer[0] is ring[shown]
        moments = [ring[i] for i in range(len(ring))]
        times = [m.time for m in moments]
        assert times == sorted(set(times))
        assert 0 <= ring.shown <= ring.last
    counted = ring.bytes
    ring.forget("nothing")  # counts anew
    assert ring.bytes == counted


# ------------------------------------------------------------------------- going back and on
def test_going_back_shows_what_was(page: SessionPage) -> None:
    session = page.session
    before = session.simulation.positions
    time = session.simulation.time
    page.frames(60)
    page.frames(5, commands.GoTo(time))
    assert not session.playing
    assert session.simulation.time == time
    assert np.array_equal(session.simulation.positions, before)
    assert session.history.scrubbed


def test_scrubbing_does_not_lose_what_is_newer(page: SessionPage) -> None:
    end, positions = page.session.history.end, page.simulation.positions
    for time in (0.1, 1.2, 0.3, -5.0, 1e9):
        page.frames(2, commands.GoTo(time))
    assert page.simulation.time == end
    assert np.array_equal(page.simulation.positions, positions)
    assert not page.session.history.scrubbed


def test_frames_back_and_forward(page: SessionPage) -> None:
    session = page.session
    end = session.simulation.time
    for i in range(1, 4):
        page.frames(2, commands.GoBack())
        assert session.simulation.time == pytest.approx(end - i * FRAME, abs=0.0026)
    for _ in range(2):
        page.frames(1, commands.GoForward())
    assert session.simulation.time == pytest.approx(end - FRAME, abs=0.0026)
    page.frames(1, commands.GoForward(), commands.GoForward(), commands.GoForward())
    assert session.simulation.time == end
    page.frames(1, commands.GoBack(0.5))
    page.frames(1, commands.GoBack(0.5))
    assert session.simulation.time == pytest.approx(end - 1.0, abs=0.03)
    page.frames(1, commands.GoBack(500.0), commands.GoBack())
    assert session.simulation.time == 0.0


@pytest.mark.parametrize("time", [math.nan, math.inf, -math.inf])
def test_no_time_at_all_is_refused(page: SessionPage, time: float) -> None:
    before = page.simulation.time
    page.frames(1, commands.Play(False), commands.GoTo(time), commands.GoBack(time))
    assert len(page.session.notices) == 2
    assert page.simulation.time == before


def test_settings_and_keys_come_back(page: SessionPage) -> None:
    session = page.session
    page.hold(20, "up")
    time, scene = session.simulation.time, session.scene
    revision, generation = session.revision, session.generation
    page.frames(10, commands.SetValue("gravity", 10.0))
    page.frames(10, commands.SetValue("rest_angle", 30.0))
    page.frames(1, commands.GoTo(time))
    assert session.scene == scene
    assert session.revision > revision + 2
    assert session.generation == generation
    page.frames(1, commands.GoForward(), commands.GoForward())
    assert session.scene.gravity == (0.0, 10.0)


def test_other_controls_come_back_with_the_method(page: SessionPage) -> None:
    session = page.session
    page.frames(10, commands.SetChoice("method", "rk4"))
    generation = session.generation
    page.frames(1, commands.GoBack(0.5))
    assert session.simulation.method == "symplectic_euler"
    assert session.generation == generation + 1
    page.frames(1, commands.GoTo(1e9))
    assert session.simulation.method == "rk4"
    assert session.generation == generation + 2


def test_a_slider_keeps_the_moment_that_is_shown(page: SessionPage) -> None:
    session = page.session
    page.frames(1, commands.GoTo(0.5))
    time, positions = session.simulation.time, session.simulation.positions
    end = session.history.end
    page.frames(5, commands.SetValue("gravity", 10.0))
    assert (session.simulation.time, session.history.end) == (time, end)
    assert np.array_equal(session.simulation.positions, positions)
    page.frames(30, commands.Play(True))
    assert session.scene.gravity == (0.0, 10.0)
    assert session.simulation.time == pytest.approx(time + 0.5, abs=0.03)


def test_what_was_changed_while_paused_is_not_lost_by_looking_back(page: SessionPage) -> None:
    page.frames(1, commands.Play(False), commands.SetValue("gravity", 10.0))
    page.frames(1, commands.GoBack(0.5), commands.GoTo(1e9))
    assert page.session.scene.gravity == (0.0, 10.0)


def test_a_mass_in_hand_is_let_go(page: SessionPage) -> None:
    page.drag(8, 40.0, frames=20)
    page.frames(1, commands.GoBack(0.2))
    assert not page.session.hands.masses
    place = page.simulation.positions
    page.frames(10, commands.Point(0.0, 0.0))
    assert np.array_equal(page.simulation.positions, place)


def test_what_follows_the_pointer_does_not_disturb_the_past(page: SessionPage) -> None:
    page.frames(20, commands.Follow(True), commands.Point(250.0, 150.0))
    page.frames(1, commands.GoTo(0.5))
    place = page.simulation.positions
    page.frames(10, commands.Point(400.0, 300.0))
    assert np.array_equal(page.simulation.positions, place)
    page.frames(20, commands.Play(True))
    page.frames(20, commands.Point(400.0, 300.0))
    assert page.simulation.positions[0] == pytest.approx((400.0, 300.0))


def test_the_ghost_goes_back_to_where_it_was(page: SessionPage) -> None:
    page.frames(30, commands.Compare("rk4", "angle", 1), commands.SetValue("rest_angle", 30.0))
    ghost = page.ghost
    time, positions, worst = page.simulation.time, ghost.simulation.positions, ghost.worst
    assert worst > 0.0
    page.frames(30)
    page.frames(30, commands.SetValue("gravity", 10.0))
    page.frames(1, commands.GoTo(time))
    assert ghost.simulation.time == page.simulation.time == time
    assert np.array_equal(ghost.simulation.positions, positions)
    assert ghost.simulation.scene.gravity == page.session.scene.gravity
    assert ghost.worst == worst
    page.frames(30, commands.Play(True))
    assert ghost.simulation.time == pytest.approx(page.simulation.time)
    assert page.simulation.time > time


def test_the_ghost_starts_from_a_moment_before_it_was_there_and_before_it_was_another(
    page: SessionPage,
) -> None:
    time = page.simulation.time
    page.frames(10, commands.HoldKeys(frozenset({"up", "right"})))
    keyed = page.simulation.time
    page.frames(30, commands.HoldKeys(frozenset()), commands.Compare("rk4", "", 1))
    page.frames(30, commands.Compare("adams", "", 1))
    for moment in (keyed + 0.3, keyed, time):
        page.frames(1, commands.GoTo(moment))
        ghost, body = page.ghost.simulation, page.simulation
        assert np.array_equal(ghost.positions, body.positions)
        assert (ghost.time, page.ghost.worst) == (body.time, 0.0)
        # What keys have changed until then is in both.
        assert ghost.rest_length_scale == body.rest_length_scale
        assert ghost.rest_angles == pytest.approx(body.rest_angles)


def test_a_body_and_a_ghost_that_do_the_same_are_never_apart(page: SessionPage) -> None:
    page.frames(5, commands.Compare("symplectic_euler", "", 1))
    page.frames(10, commands.HoldKeys(frozenset({"up"})))
    page.frames(10, commands.HoldKeys(frozenset()))
    page.frames(1, commands.GoBack(0.2))
    page.frames(30, commands.Play(True))
    assert page.ghost.simulation.time == page.simulation.time
    assert page.ghost.worst == 0.0


def test_the_past_begins_anew_with_another_body(page: SessionPage) -> None:
    for command in (commands.Reset(), commands.SetValue("masses", 5), commands.Open(tutorial_preset("ring"))):
        page.frames(30, commands.Play(True))
        page.frames(1, commands.GoBack(0.2), commands.Play(False), command)
        session = page.session
        assert (len(session.history), session.history.end, session.abandoned_future) == (1, 0.0, None)
        page.frames(1, commands.GoBack())
        assert len(session.simulation.positions) == len(session.scene.masses)


# ------------------------------------------------------------------------- what would have come
def test_the_old_future_stays_for_comparison(page: SessionPage) -> None:
    session = page.session
    newer = [session.history[i] for i in range(len(session.history))]
    page.frames(2, commands.GoTo(0.5))
    assert session.abandoned_future is None
    start, end = session.simulation.time, session.history.end
    page.frames(1, commands.SetValue("gravity", 100.0))
    page.frames(12, commands.Play(True))
    old = session.abandoned_future
    assert old is not None
    assert (old.start, old.end) == (start, end)
    assert session.history.end == session.simulation.time < end
    known = newer[-5]
    assert old.positions_at(known.time) == pytest.approx(known.positions)
    between = old.positions_at(0.5 * (newer[-5].time + newer[-4].time))
    assert between == pytest.approx(0.5 * (newer[-5].positions + newer[-4].positions))
    assert old.positions_at(end + 1e-3) is None
    assert old.positions_at(start - 1e-3) is None
    at = old.positions_at(session.simulation.time)
    assert at is not None
    assert np.abs(at - session.simulation.positions).max() > 0.1
    page.frames(5, commands.Play(False), commands.Play(True))
    assert session.abandoned_future is old
    page.frames(2, commands.GoBack(0.1), commands.Play(True))
    assert session.abandoned_future is not None
    assert session.abandoned_future is not old
    page.frames(1, commands.ForgetFuture())
    assert session.abandoned_future is None


def test_single_steps_from_the_past_branch_too(page: SessionPage) -> None:
    page.frames(1, commands.GoTo(0.5), commands.DoSteps(3))
    assert page.session.abandoned_future is not None
    assert page.session.history.end == page.simulation.time == pytest.approx(0.5075, abs=0.01)


def test_positions_of_an_abandoned_future_are_copies() -> None:
    future = AbandonedFuture([moment(0.0), moment(1.0)])
    found = future.positions_at(0.5)
    assert found is not None
    found[:] = 7.0
    assert future.positions_at(0.5) == pytest.approx(np.full((3, 2), 0.5))


# ------------------------------------------------------------------------- after a divergence
def torn(speed: Callable[[float], float], seconds: float) -> History:
    """A body of 300 px whose masses go at a speed, px/s, that depends on the time, s."""
    ring = History()
    for i in range(int(seconds * 60)):
        rows = np.array([[0.0, 150.0, 300.0], [0.0] * 3, [speed(i * FRAME)] * 3, [0.0] * 3])
        ring.add(sim.Moment(SCENE, 1.0, 0.0, rows, i * FRAME, i))
    return ring


def swing(time: float) -> float:
    return 100.0 * math.sin(3.0 * time)


def test_a_slow_runaway_is_left_half_a_second_before_it_began() -> None:
    # It swings slower and slower until 5 s; then it takes 3 s until its speed is beyond all measure.
    ring = torn(
        lambda t: 30.0 - 5.0 * t + swing(t) / 20.0 if t < 5.0 else 5.0 * math.exp(4.0 * (t - 5.0)), 8.0
    )
    assert ring[ring.before_runaway()].time == pytest.approx(5.0 - history.BEFORE_RUNAWAY, abs=0.15)


def test_a_body_that_was_torn_for_long_is_taken_to_where_it_was_calm() -> None:
    ring = torn(lambda t: swing(t) if t < 3.0 else 4000.0 + 10.0 * swing(t) if t < 6.0 else 10.0**t, 7.0)
    assert ring[ring.before_runaway()].time == pytest.approx(3.0, abs=0.02)


RUNAWAYS = [
    *product(
        ["tutorial-3.2", "tutorial-3.3", "ring", "box", "hair-tuft", "flag-pole"],
        ["symplectic_euler", "velocity_verlet", "rk4"],
        [1.02, 1.3, 3.0],
    )
]


@pytest.mark.parametrize(("preset", "method", "over"), part_of(RUNAWAYS, 9))
def test_there_is_a_way_back_to_before_a_divergence(preset: str, method: str, over: float) -> None:
    scene = sim.set_choice(sim.load_scene(preset), "method", method)
    page = SessionPage(scene)
    session = page.session
    page.frames(60, commands.SetValue("dt", 2e-4), commands.SetValue("gravity", 500.0))
    size = np.ptp(session.simulation.positions, axis=0).max()
    limit = session.stability.limit
    if not math.isfinite(limit):
        pytest.skip("it has no limit")
    page.frames(1, commands.SetValue("dt", limit * over))
    for _ in range(1500):
        page.frames(1)
        if session.simulation.divergence is not None:
            break
    else:
        pytest.skip("it does not run away")
    assert session.offer_back
    diverged = session.simulation.time
    assert "Go back to just before it, lower" in page.told
    page.frames(2, commands.BackBeforeDivergence())
    assert not session.playing
    assert not session.offer_back
    assert session.simulation.divergence is None
    assert session.simulation.time < diverged
    assert np.ptp(session.simulation.positions, axis=0).max() < 1.5 * size
    assert np.abs(session.simulation.velocities).max() < 5000.0
    page.frames(60, commands.SetValue("dt", 2e-4), commands.Play(True))
    assert session.simulation.divergence is None
    assert np.ptp(session.simulation.positions, axis=0).max() < 2.0 * size


def test_going_back_before_a_divergence_keeps_the_step_that_was_too_long() -> None:
    page = SessionPage(sim.set_choice(sim.load_scene("tutorial-3.3"), "method", "symplectic_euler"))
    page.frames(60, commands.SetValue("rest_angle", 10.0))
    page.frames(1, commands.SetValue("dt", 1.5 * page.session.stability.limit))
    scene = page.session.scene
    for _ in range(300):
        page.frames(1)
    assert page.session.offer_back
    page.frames(1, commands.BackBeforeDivergence())
    assert page.session.scene.integrator == scene.integrator
    assert page.session.versions.undoable == "Time step"
    assert page.simulation.time < 1.0
    page.frames(30, commands.SetChoice("method", "auto"), commands.Play(True))
    assert page.simulation.divergence is None


def test_a_body_that_runs_away_from_the_first_step_goes_back_there() -> None:
    page = SessionPage(sim.set_value(tutorial_preset("ring"), "angular_stiffness", 1e8))
    page.drag(0, 1.0, frames=300)
    assert page.session.offer_back
    page.frames(1, commands.BackBeforeDivergence())
    assert page.simulation.time < 0.1
