"""The lessons say what is so: each answer, and each number in it, against the solver."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Iterator

import numpy as np
import pytest
from msgspec.structs import replace
from scipy.special import ellipk

import sim
from sim.analysis.spectrum import peaks, spectrum
from sim.edit.edit import Selection
from sim.edit.muscles import move_muscles, take_muscles
from sim.settings import apply_assignments, scene_of_run, scene_of_step, set_value
from sim.store.files import built_in_folder
from tests.sim.changes import after, with_masses
from tests.sim.checks import known
from tests.sim.measured import measure

NAMES = sorted(path.stem for path in (built_in_folder() / "lessons").glob("*.json"))


def step_of(name: str, number: int, *more: str) -> sim.Scene:
    """The scene as a step begins, with what its user then sets."""
    return apply_assignments(scene_of_step(sim.load_scene(name), number), more)


def is_answer(name: str, number: int, words: str) -> bool:
    question = known(known(sim.load_scene(name).lesson).steps[number].question)
    return question.choices[question.answer] == words


def with_mass_at(scene: sim.Scene, mass: int, at: tuple[float, float]) -> sim.Scene:
    """The scene that starts with one mass elsewhere."""
    return with_masses(scene, position=lambda i, other: at if i == mass else other.position)


def rest(scene: sim.Scene) -> np.ndarray:
    return np.asarray(sim.equilibrium(scene).positions)


def crossings(times: list[float], values: list[float]) -> Iterator[float]:
    """Times at which the values pass their mean upwards."""
    level = float(np.mean(values))
    for i in range(1, len(values)):
        before, after = values[i - 1] - level, values[i] - level
        if before < 0.0 <= after:
            yield times[i - 1] + (times[i] - times[i - 1]) * before / (before - after)


def period(simulation: sim.Simulation, mass: int, axis: int, seconds: float) -> float:
    times, values = [], []
    while simulation.time < seconds:
        simulation.advance(0.01)
        times.append(simulation.time)
        values.append(float(simulation.positions[mass, axis]))
    found = list(crossings(times, values))
    return (found[-1] - found[0]) / (len(found) - 1)


def widest(scene: sim.Scene, seconds: float = 15.0) -> list[float]:
    """How far each second mass swings to the side, after the beginning."""
    simulation = sim.Simulation(scene)
    most = np.zeros(len(scene.masses) // 2)
    start = simulation.positions[1::2, 0].copy()
    while simulation.time < seconds:
        simulation.advance(0.05)
        if simulation.time > 8.0:
            most = np.maximum(most, np.abs(simulation.positions[1::2, 0] - start))
    return most.tolist()


def test_there_are_seventeen_lessons_of_a_length_for_one_hour() -> None:
    assert len(NAMES) == 17
    for name in NAMES:
        assert len(known(sim.load_scene(name).lesson).steps) <= 5


def test_what_is_right_is_told_in_a_headline() -> None:
    """The wall shows the first sentence of why, large, before pupils write their own."""
    for name in NAMES:
        for step in known(sim.load_scene(name).lesson).steps:
            because = step.question.because if step.question is not None else "None."
            assert len(re.split(r"(?<=[.?!])\s", because)[0]) <= 64, because


def test_a_spring_is_stretched_by_its_load_and_a_rod_bends_less_than_in_proportion() -> None:
    simulation = after(step_of("lesson-hooke", 0), 8.0)
    assert abs(simulation.velocities[[1, 4]]).max() < 2.0, "both come to rest while one waits"
    swing = sim.Simulation(step_of("lesson-hooke", 1))
    swings = swing.record(14.0, "mass1.y")["mass1.y"]
    assert np.ptp(swings[-600:]) > 0.6 * np.ptp(swings[:600]), "after ten swings there is enough left to time"

    own = 220.0
    for gravity, sag, angle in ((1000.0, 50.0, 29.0), (2000.0, 100.0, 48.0)):
        at = rest(step_of("lesson-hooke", 0, f"gravity={gravity}"))
        assert at[1, 1] - own == pytest.approx(sag, abs=1e-3)
        dx, dy = at[4] - at[3]
        assert math.degrees(math.atan2(dy, dx)) == pytest.approx(angle, abs=0.6)
    assert is_answer("lesson-hooke", 0, "100 px")
    assert is_answer("lesson-hooke", 2, "By less than 58°")


def test_what_runs_is_what_was_asked() -> None:
    """Twice the weight, twice the swing, half as stiff: by k x = m g, T = 2 pi sqrt(m / k), and
    tan(angle) = m g / (K |A|)."""
    gravity, stiffness, mass, joint, arm = 2000.0, 20.0, 1.0, 30.0, 60.0
    asked = sim.load_scene("lesson-hooke")
    spring, lever = asked.linear_springs[0], asked.angular_springs[0]
    assert (spring.stiffness, lever.stiffness) == (stiffness, joint)
    hanging = after(scene_of_run(asked, 0), 8.0)
    assert hanging.positions[1, 1] - 220.0 == pytest.approx(mass * gravity / stiffness, abs=0.5)
    swing = sim.Simulation(scene_of_run(asked, 1))
    height = swing.positions[1, 1] - (220.0 + mass * 1000.0 / stiffness)
    assert height == pytest.approx(100.0), "it is let go 100 px from where it rests"
    assert period(swing, 1, 1, 6.0) == pytest.approx(2.0 * math.pi * math.sqrt(mass / stiffness), abs=0.01)
    dx, dy = np.subtract(*after(scene_of_run(asked, 2), 8.0).positions[[4, 3]])
    assert math.atan2(dy, dx) == pytest.approx(math.atan(mass * 1000.0 / (0.5 * joint * arm)), abs=0.01)
    # Where a step asks what becomes of something, its run is that, and no other step's is.
    for name in NAMES:
        scene = sim.load_scene(name)
        for number, step in enumerate(known(scene.lesson).steps):
            begins, runs = scene_of_step(scene, number), scene_of_run(scene, number)
            assert (begins == runs) == (not step.run)


def test_at_the_moment_that_is_predicted_the_body_is_where_the_answer_says() -> None:
    """Each number by its closed form: k x = m g; tan(angle) = m g / (K |A|); an arch a beat hides 18 px."""

    def moved(name: str, number: int, mass: int) -> np.ndarray:
        scene = scene_of_run(sim.load_scene(name), number)
        step = known(sim.load_scene(name).lesson).steps[number]
        return after(scene, known(step.predict)).positions[mass] - sim.Simulation(scene).positions[mass]

    assert moved("lesson-hooke", 0, 1)[1] == pytest.approx(1.0 * 2000.0 / 20.0, abs=0.5)
    lever, sags = (
        after(scene(sim.load_scene("lesson-hooke"), 2), 8.0) for scene in (scene_of_run, scene_of_step)
    )
    assert lever.angles[0] == pytest.approx(math.degrees(math.atan(1000.0 / (15.0 * 60.0))), abs=0.2)
    assert (round(lever.angles[0]), round(sags.angles[0])) == (48, 29)
    assert moved("lesson-worm", 0, 12)[0] == pytest.approx(5 * 18.0, abs=2.0)
    assert moved("lesson-worm", 1, 12)[0] == pytest.approx(-5 * 18.0, abs=2.0)
    assert moved("lesson-worm-floor", 0, 12)[0] == pytest.approx(0.0, abs=1.0)
    predicting = {
        (name, number)
        for name in NAMES
        for number, step in enumerate(known(sim.load_scene(name).lesson).steps)
        if step.predict is not None
    }
    told = {("lesson-hooke", 0), ("lesson-worm", 0), ("lesson-worm", 1)}
    # Where the pendulum is after ten seconds nobody can say: that is the lesson.
    assert predicting == told | {("lesson-worm-floor", 0)}


def test_the_lever_comes_to_its_goal_by_the_formula_that_the_step_tells() -> None:
    goal = known(known(sim.load_scene("lesson-hooke").lesson).steps[3].goal)
    gravity = math.tan(math.radians(60.0)) * 30.0 * 60.0
    assert math.tan(math.radians(60.0)) == pytest.approx(1.73, abs=0.005)
    rod = after(step_of("lesson-hooke", 3, f"gravity={gravity}"), 12.0)
    assert known(goal.low) < rod.angles[0] < known(goal.high)


def test_the_rope_explodes_in_its_run_as_its_limit_says() -> None:
    """2 / omega: by the fastest vibration of the whole body; 10 ms are beyond it, 2.5 ms are not."""
    asked = sim.load_scene("lesson-explosion")
    run = sim.Simulation(scene_of_run(asked, 0))
    limit = run.stability().limit
    assert 0.0025 < limit < 0.01
    run.advance(3.0)
    assert run.divergence is not None
    calm = after(apply_assignments(scene_of_run(asked, 0), ("dt=0.0025",)), 3.0)
    assert calm.divergence is None
    # Four times as stiff, it explodes at a step that the softer rope can take.
    stiffer = scene_of_run(asked, 1)
    assert after(stiffer, 3.0).divergence is not None
    softer = apply_assignments(scene_of_run(asked, 0), (f"dt={stiffer.integrator.dt}",))
    assert after(softer, 3.0).divergence is None


def test_a_period_does_not_know_the_amplitude() -> None:
    for pull in (30.0, 60.0):
        simulation = sim.Simulation(with_mass_at(step_of("lesson-hooke", 1), 1, (150.0, 270.0 + pull)))
        assert period(simulation, 1, 1, 6.0) == pytest.approx(1.405, abs=0.01)
    assert is_answer("lesson-hooke", 1, "Just as long")


def test_a_cantilever_sags_by_length_stiffness_and_weight_as_the_lesson_says() -> None:
    def sags(number: int, *more: str) -> tuple[float, float]:
        at = rest(step_of("lesson-cantilever", number, *more))
        return float(at[15, 1] - at[0, 1]), float(at[45, 1] - at[16, 1])

    short, long = sags(0)
    assert (short, long) == pytest.approx((2.6, 36.5), abs=0.1)
    assert long / short == pytest.approx(14.0, abs=0.5)
    clamps = rest(step_of("lesson-cantilever", 0))[[0, 16], 1]
    np.testing.assert_allclose(clamps, (170.0, 270.0), atol=1e-9)
    assert sags(1, "angular_stiffness=937500")[1] / sags(1)[1] == pytest.approx(0.5, abs=0.02)
    assert sags(2, "gravity=5000")[1] == pytest.approx(153.0, abs=0.6)


def test_a_chain_hangs_in_a_catenary_whatever_its_weight_unless_it_is_soft() -> None:
    chain = 42  # masses; the others are marks on the parabola
    at = rest(step_of("lesson-catenary", 0))[:chain]
    np.testing.assert_allclose(rest(step_of("lesson-catenary", 1, "gravity=3000"))[:chain], at, atol=1.0)
    soft, softer = (
        rest(step_of("lesson-catenary", 2, "linear_stiffness=3000", f"gravity={g}"))[:chain]
        for g in (1000, 3000)
    )
    assert softer[:, 1].max() > soft[:, 1].max() + 20.0
    # y = y0 - a cosh((x - x0) / a), y downwards: the depth gives a; then every mass is on it.
    x, y = at[:, 0] - 300.0, at[:, 1].max() - at[:, 1]
    a = min(np.linspace(50.0, 500.0, 4501), key=lambda a: abs(a * (math.cosh(150.0 / a) - 1.0) - y[0]))
    worst = np.abs(a * (np.cosh(x / a) - 1.0) - y).max()
    parabola = np.abs(y[0] * (x / 150.0) ** 2 - y).max()
    assert worst < 1.0
    assert parabola > 10.0, "which can be seen"
    for mass in sim.load_scene("lesson-catenary").masses[chain:]:
        px, py = mass.position
        assert at[:, 1].max() - py == pytest.approx(
            (at[:, 1].max() - 110.0) * ((px - 300.0) / 150.0) ** 2, abs=1.0
        )
    # It comes to rest while one waits.
    simulation = after(step_of("lesson-catenary", 0), 15.0)
    assert np.abs(simulation.positions[:chain] - at).max() < 2.0


def test_periods_of_a_string_go_by_its_mode_and_its_tension() -> None:
    def of(number: int, mass: int) -> float:
        return period(sim.Simulation(step_of("lesson-modes", number)), mass, 1, 8.0)

    first = of(0, 10)
    assert first / of(0, 26) == pytest.approx(2.0, abs=0.03)
    tighter = scene_of_run(sim.load_scene("lesson-modes"), 1)
    assert first / period(sim.Simulation(tighter), 10, 1, 8.0) == pytest.approx(math.sqrt(2.0), abs=0.03)
    assert is_answer("lesson-modes", 0, "Half as long")
    assert is_answer("lesson-modes", 1, "1.41 times as high")
    plucked = after(scene_of_run(sim.load_scene("lesson-modes"), 2), 3.0).positions
    assert plucked[5, 1] == pytest.approx(plucked[15, 1], abs=0.01), "odd modes only"
    assert is_answer("lesson-modes", 2, "The even ones: 2, 4, 6, ...")


def test_the_pendulum_in_tune_swings_widest() -> None:
    lesson = sim.load_scene("lesson-resonance")
    for number, best in ((0, 2), (1, 4), (2, 2)):
        most = widest(scene_of_run(lesson, number))
        assert int(np.argmax(most)) == best
    assert max(widest(scene_of_run(lesson, 2))) < 0.5 * max(widest(step_of("lesson-resonance", 0)))


def test_a_step_beyond_the_stability_limit_explodes() -> None:
    limits = [sim.Simulation(step_of("lesson-explosion", number)).stability().limit for number in (0, 1)]
    assert limits[0] == pytest.approx(0.009, abs=0.0005)
    assert limits[1] / limits[0] == pytest.approx(0.5, abs=0.05)
    for number, dt, survives in ((0, 0.0025, True), (0, 0.02, False), (2, 0.02, True)):
        simulation = after(step_of("lesson-explosion", number, f"dt={dt}"), 3.0)
        assert (simulation.divergence is None) is survives


def let_go(number: int, tolerance: float, higher: float = 0.0) -> np.ndarray:
    """The double pendulum of a step for 15 s, its lower mass let go so many px higher."""
    scene = step_of("lesson-chaos", number, f"tolerance={tolerance}")
    x, y = scene.masses[-1].position
    simulation = sim.Simulation(with_mass_at(scene, len(scene.masses) - 1, (x, y - higher)))
    places = []
    for _ in range(150):
        simulation.advance(0.1)
        places.append(simulation.positions)
    return np.array(places)


def apart(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """How far the farther mass of two motions is from itself, px, at each time."""
    return np.hypot(*np.moveaxis(one - other, -1, 0)).max(1)


def test_in_chaos_each_digit_of_the_tolerance_is_worth_two_seconds() -> None:
    """A mean over starts within half a pixel: when one motion parts from the exact one, rounding decides."""
    tolerances = (1e-1, 1e-2, 1e-3, 1e-4)
    exact = [let_go(1, 1e-7, higher) for higher in np.linspace(-0.5, 0.5, 12)]
    parts = np.empty((len(exact), len(tolerances)))
    for i, higher in enumerate(np.linspace(-0.5, 0.5, 12)):
        for k, tolerance in enumerate(tolerances):
            far = apart(let_go(1, tolerance, higher), exact[i]) > 20.0
            parts[i, k] = 0.1 * int(np.argmax(far)) if far.any() else 15.0
    assert parts.min() > 2.0
    # 1.7 of all starts, and means of 12 scatter by 0.2.
    slope = -np.polyfit(np.log10(tolerances), parts.mean(0), 1)[0]
    assert 0.8 < slope < 3.0
    # Two that are let go nearly a tenth of a pixel apart are elsewhere after ten seconds.
    assert np.median([apart(*pair)[:100].max() for pair in itertools.pairwise(exact)]) > 100.0
    assert is_answer("lesson-chaos", 0, "in entirely different places")
    assert is_answer("lesson-chaos", 1, "Some seconds longer")


def test_small_swings_are_not_chaotic() -> None:
    fall = let_go(2, 0.1)
    assert apart(fall, let_go(2, 1e-4)).max() < 20.0
    angle = np.degrees(np.arctan2(*(fall[:, 2] - fall[:, 0]).T))
    assert np.ptp(np.unwrap(angle, period=360.0)) < 130.0
    assert is_answer("lesson-chaos", 2, "No")


def test_the_sine_law_pushes_hardest_at_a_right_angle_and_the_angle_law_at_the_largest() -> None:
    def push(number: int, degrees: float) -> float:
        """Speed of the arm's end just after it was let go at an angle."""
        t = math.radians(degrees)
        at = 300.0 + 120.0 * math.cos(t), 300.0 + 120.0 * math.sin(t)
        simulation = sim.Simulation(with_mass_at(step_of("lesson-laws", number), 2, at))
        start = simulation.positions[2].copy()
        simulation.advance(0.05)
        return float(np.hypot(*(simulation.positions[2] - start)))

    for number, fastest in ((0, 90.0), (1, 170.0)):
        assert max((45.0, 90.0, 170.0), key=lambda angle: push(number, angle)) == fastest
    assert push(1, 10.0) / push(2, 10.0) == pytest.approx(1.005, abs=0.002)


def test_numbers_are_found_backwards_from_shape_sag_and_frequency() -> None:
    def numbers(scene: sim.Scene) -> tuple[float, float]:
        """Sag, px, and frequency, Hz."""
        found = sim.tuning(scene)
        return known(found.sag), known(found.elastic).frequency

    rod = step_of("lesson-backwards", 0)
    assert numbers(rod) == pytest.approx((37.0, 1.0), rel=0.01)
    kept = sim.keep_shape(rod)
    assert np.abs(rest(kept)[:, 1] - 180.0).max() < 1e-6
    springs, joints = kept.linear_springs, kept.angular_springs
    assert {spring.stiffness for spring in springs} == {2e4}
    assert {joint.stiffness for joint in joints} == {4000.0}
    one_held = replace(kept, anchors=kept.anchors[:1])
    with pytest.raises(sim.DesignError, match="nothing keeps it from turning about mass 0"):
        sim.keep_shape(one_held)
    soft = step_of("lesson-backwards", 2)
    assert step_of("lesson-backwards", 1) == rod
    with pytest.raises(sim.DesignError, match=r"joint 0 would need 3\.12 times its stiffness") as refused:
        sim.keep_shape(soft)
    assert refused.value.stiffening == pytest.approx(3.12, abs=0.005)
    stiffened = sim.keep_shape(soft, allow_stiffening=True)
    assert stiffened.angular_springs[0].stiffness == pytest.approx(312.0, abs=0.5)

    def of(*more: str) -> tuple[float, float]:
        """Sag and period, s, of the rod to be tuned."""
        scene = step_of("lesson-tuning", 0, *more)
        return float(rest(scene)[9, 1] - 180.0), period(sim.Simulation(scene), 9, 1, 6.0)

    assert of("angular_stiffness=9000")[1] == pytest.approx(0.67, abs=0.005)
    assert of("angular_stiffness=16000") == pytest.approx((9.4, 0.50), abs=0.05)
    assert of("gravity=250") == pytest.approx((9.4, 1.0), abs=0.05)
    assert of("gravity=1100")[0] - of()[0] == pytest.approx(3.5, abs=0.05), "nearly 3.7 px"
    assert of("gravity=700", "angular_stiffness=2500") == pytest.approx((41.0, 1.25), abs=0.15)
    assert is_answer("lesson-tuning", 1, "No: then it swings twice a second")
    assert is_answer("lesson-tuning", 2, "3.7 px")
    goal = known(known(sim.load_scene("lesson-tuning").lesson).steps[3].goal)
    assert known(goal.low) < of("gravity=700", "angular_stiffness=2500")[1] < known(goal.high)

    faster = sim.set_wishes(step_of("lesson-tuning", 0), frequency=2.0)
    assert faster.factors.joints == pytest.approx(4.0, rel=0.05)
    assert is_answer("lesson-tuning", 0, "4 times")
    shallow = sim.set_wishes(step_of("lesson-tuning", 1), sag=9.2)
    assert numbers(shallow.scene) == pytest.approx((9.2, 2.0), rel=0.01)
    calm = sim.set_wishes(shallow.scene, calm_after=0.5)
    assert not calm.conflict
    assert numbers(calm.scene) == pytest.approx(numbers(shallow.scene), rel=1e-6)


def creep(scene: sim.Scene, beats: int = 5) -> float:
    """How far to the right a worm gets in a second, px, after the beat in which it begins."""
    simulation = sim.Simulation(scene)
    assert scene.beat
    simulation.advance(1.0 / scene.beat.frequency)
    start = float(simulation.positions[:, 0].mean())
    simulation.advance(beats / scene.beat.frequency)
    assert 0.0 < simulation.positions[:, 0].min() < simulation.positions[:, 0].max() < 720.0
    return (float(simulation.positions[:, 0].mean()) - start) * scene.beat.frequency / beats


def test_a_worm_creeps_with_its_waves() -> None:
    there, back = (creep(step_of("lesson-worm", number)) for number in (0, 1))
    assert there == pytest.approx(18.0, abs=0.5)
    assert back == pytest.approx(-there, rel=0.02)
    assert is_answer("lesson-worm", 0, "to the right, with the arches")
    assert is_answer("lesson-worm", 1, "to the left, just as fast")
    simulation = sim.Simulation(step_of("lesson-worm", 1))
    for waves in (2.0, -2.0):
        scene = set_value(simulation.capture().scene, "waves", waves, simulation.time)
        simulation.replace(scene)
        simulation.advance(1.0)
        start = simulation.positions[:, 0].mean()
        simulation.advance(1.0)
        assert (simulation.positions[:, 0].mean() - start) * waves > 30.0, "within a beat it has turned round"
    # A mass in the middle hardly moves on at the floor and on top of an arch: a stair of two steps a beat.
    simulation, speeds = sim.Simulation(step_of("lesson-worm", 0)), []
    simulation.advance(2.0)
    for _ in range(100):
        before = simulation.positions[12, 0]
        simulation.advance(0.02)
        speeds.append(float(simulation.positions[12, 0] - before) / 0.02)
    spectrum = np.abs(np.fft.rfft(speeds))  # of two beats
    assert spectrum[4] > 3.0 * np.delete(spectrum[1:], 3).max()
    assert min(speeds) < 5.0 < 30.0 < max(speeds)


def test_a_worm_gets_on_by_what_an_arch_hides() -> None:
    for swing, reach, hidden in ((45, 205.0, 18.0), (60, 180.0, 30.0)):
        scene = step_of("lesson-worm", 2, f"swing={swing}")
        simulation = after(scene, 2.0)
        assert np.ptp(simulation.positions[:, 0]) == pytest.approx(reach, abs=3.0)
        assert (240.0 - reach) / 2.0 == pytest.approx(hidden, abs=0.6)
        assert creep(scene) == pytest.approx(hidden, abs=2.5)
    assert is_answer("lesson-worm", 2, "18 px")
    slow, fast = (creep(step_of("lesson-worm", 3, f"tempo={tempo}"), beats=4) for tempo in (1, 2))
    assert fast / slow == pytest.approx(2.0, abs=0.1)
    assert creep(step_of("lesson-worm", 3, "tempo=4")) > 5.0 * slow, "it hops"
    assert is_answer("lesson-worm", 3, "twice as fast")


def test_a_worm_gets_nowhere_on_ice_and_needs_little_friction() -> None:
    rough = creep(step_of("lesson-worm", 0))
    assert abs(creep(step_of("lesson-worm-floor", 0))) < 0.01
    simulation = after(step_of("lesson-worm-floor", 0), 1.0)
    assert np.abs(simulation.velocities[:, 0]).max() > 10.0, "though its masses move"
    assert creep(step_of("lesson-worm-floor", 1)) / rough == pytest.approx(1.05, abs=0.05)
    assert creep(step_of("lesson-worm-floor", 1, "wall_friction=2")) < rough
    slips = [
        creep(step_of("lesson-worm-floor", 1, f"wall_friction={friction}")) for friction in (0.01, 0.003)
    ]
    assert 0.8 * rough < slips[0] < 0.95 * rough
    assert slips[1] < 0.5 * rough
    assert is_answer("lesson-worm-floor", 0, "stays where it is")
    assert is_answer("lesson-worm-floor", 1, "about as fast as on an ordinary floor")


def test_what_the_marks_of_a_worm_do() -> None:
    worm = step_of("lesson-worm-floor", 2)
    whole, every = creep(worm), range(len(worm.angular_springs))
    assert len(every) == 22
    at_rest = []
    for joint in (11, 21):
        muscle = worm.angular_springs[joint].muscle
        assert muscle
        rests = Selection(joints=frozenset({joint}))
        at_rest.append(creep(move_muscles(worm, rests, 0.0, 0.0, -muscle.amplitude).scene))
        assert at_rest[-1] == pytest.approx(creep(take_muscles(worm, rests).scene), abs=0.01)
    assert at_rest[0] / whole == pytest.approx(0.8, abs=0.03)
    assert at_rest[1] > 0.98 * whole
    lesson = sim.load_scene("lesson-worm-floor")
    assert creep(scene_of_run(lesson, 2)) == pytest.approx(at_rest[0], abs=0.01)
    assert creep(scene_of_run(lesson, 3)) == pytest.approx(whole, rel=0.02)
    together = Selection(joints=frozenset(every))
    assert creep(move_muscles(worm, together, 0.25, 0.0, 0.0).scene) == pytest.approx(whole, rel=0.02)
    assert creep(move_muscles(worm, together, 0.0, 0.0, 5.0).scene) > 1.3 * whole
    assert is_answer("lesson-worm-floor", 2, "creeps on, but less well")
    assert is_answer("lesson-worm-floor", 3, "as before")


def test_what_walks_better() -> None:
    for waves, speed in ((1, 55.0), (2, 18.0), (3, 12.0)):
        assert creep(step_of("lesson-worm-floor", 4, f"waves={waves}"), beats=3) == pytest.approx(
            speed, rel=0.06
        )
    assert is_answer("lesson-worm-floor", 4, "one wave")

    def thrown(*more: str) -> float:
        """How far off the floor it gets as a whole, px."""
        simulation, most = sim.Simulation(step_of("lesson-worm-floor", 4, *more)), 0.0
        while simulation.time < 6.0:
            simulation.advance(0.02)
            most = max(most, 500.0 - float(simulation.positions[:, 1].max()))
        return most

    assert thrown() < 1.0
    assert thrown("waves=1", "swing=60", "tempo=2") > 20.0
    goal = known(known(sim.load_scene("lesson-worm-floor").lesson).steps[4].goal)
    simulation = sim.Simulation(step_of("lesson-worm-floor", 4, "swing=70", "tempo=2"))
    reached = simulation.record(4.0, goal.quantity)[goal.quantity]
    assert reached.max() > known(goal.low), "it can be done in less than 4 s"
    assert reached.max() < 740.0


def test_the_table_of_the_lesson_gives_back_what_is_not_told() -> None:
    hidden = step_of("lesson-tuning", 3, "gravity=700", "angular_stiffness=2500", "angular_damping=60")
    table = measure(hidden, ["mass9.y"], 2.5, 0.02, np.random.default_rng(1))
    sought = ["gravity", "angular_stiffness", "angular_damping"]
    found = sim.fit(step_of("lesson-tuning", 3), table, sought)
    for name, truth in zip(sought, (700.0, 2500.0, 60.0), strict=True):
        each = found.values[name]
        assert each.known, name
        assert each.low < truth < each.high, name
        assert each.value == pytest.approx(truth, rel=0.01), name


@pytest.mark.parametrize("name", NAMES)
def test_every_step_can_begin_after_the_last_and_what_it_shows_stays_in_view(name: str) -> None:
    scene = sim.load_scene(name)
    left, top, right, bottom = scene.view.frame
    for number in range(len(known(scene.lesson).steps)):
        scene = scene_of_step(scene, number)
        simulation = sim.Simulation(scene)
        for _ in range(40):
            simulation.advance(0.3)
            assert simulation.divergence is None
            x, y = simulation.positions.T
            assert left < x.min() <= x.max() < right, (number, simulation.time)
            assert top < y.min() <= y.max() < bottom, (number, simulation.time)


def test_the_lesson_says_how_much_slower_the_sine_law_swings() -> None:
    """From 10 degrees, over the angle law's 2 pi: the complete elliptic integral over pi / 2."""
    slower = ellipk(math.sin(math.radians(5.0)) ** 2) / (0.5 * math.pi) - 1.0
    assert slower == pytest.approx(0.00190719, rel=1e-5)
    lesson = known(sim.load_scene("lesson-laws").lesson)
    (because,) = (
        step.question.because for step in lesson.steps if step.question and "from 10°" in step.question.text
    )
    assert f"the periods by {100.0 * slower:.2f} %" in because


def swing_of_run(name: str, number: int, mass: int) -> float:
    """The period of a mass in the run of a step, s, after a second in which faster modes die away."""
    return period(after(scene_of_run(sim.load_scene(name), number), 1.0), mass, 1, 4.0)


def test_a_bridge_and_a_rod_swing_in_the_modes_that_are_asked_about() -> None:
    bridge = after(scene_of_run(sim.load_scene("lesson-bridge-modes"), 0), 0.05).velocities
    assert bridge[4, 1] * bridge[12, 1] < 0.0
    assert swing_of_run("lesson-bridge-modes", 2, 8) == pytest.approx(0.54, abs=0.01)
    marched = after(scene_of_run(sim.load_scene("lesson-bridge-modes"), 1), 10.0)
    assert np.ptp(marched.record(1.0, "mass8.y")["mass8.y"]) > 50.0
    large = after(scene_of_run(sim.load_scene("lesson-bridge-modes"), 3), 0.0)
    assert np.ptp(large.record(1.0, "mass8.y")["mass8.y"]) > 50.0, "the first mode gets energy"
    assert swing_of_run("lesson-rod-sound", 0, 19) == pytest.approx(0.10, abs=0.01)
    assert swing_of_run("lesson-rod-sound", 1, 19) == pytest.approx(0.32, abs=0.01)
    assert is_answer("lesson-bridge-modes", 0, "goes down")
    assert is_answer("lesson-bridge-modes", 3, "No, they mix")


def test_balls_hand_on_momentum_as_the_lesson_says() -> None:
    """Equal balls exchange velocities; 1 kg at v against 3 kg: -v / 2 and v / 2; a gun: v = x sqrt(k / m)."""
    lesson, balls = sim.load_scene("lesson-momentum"), (1, 3, 5, 7, 9)
    for number, flying in ((0, {9}), (1, {7, 9})):
        after_it = after(scene_of_run(lesson, number), 0.72).velocities[list(balls), 0]
        falling = math.sqrt(2.0 * 1000.0 * 180.0 * (1.0 - math.cos(math.radians(40.0))))
        for ball, speed in zip(balls, after_it, strict=True):
            assert speed == pytest.approx(falling if ball in flying else 0.0, abs=0.04 * falling)
    shot = after(scene_of_run(lesson, 2), 0.5)
    assert shot.velocities[11, 0] == pytest.approx(40.0 * math.sqrt(25.0), rel=1e-3)
    shot.advance(1.0)
    assert shot.velocities[[11, 12], 0] == pytest.approx((-100.0, 100.0), abs=0.1)
    assert is_answer("lesson-momentum", 2, "comes back, half as fast")
    goal = known(known(lesson.lesson).steps[3].goal)
    pulled = after(with_mass_at(step_of("lesson-momentum", 3), 11, (140.0 - 60.0, 400.0)), 1.5)
    assert known(goal.low) < pulled.velocities[12, 0] < known(goal.high)
    pulled.advance(known(goal.seconds))
    assert known(goal.low) < pulled.velocities[12, 0] < known(goal.high)


def test_a_block_sticks_and_slips_as_the_lesson_says() -> None:
    """It slips at 5400 and, about 1800, by an amplitude of sqrt(3600² + (k v / omega)²)."""
    lesson = sim.load_scene("lesson-stick-slip")
    for number, stiffness, belt in ((0, 100.0, 20.0), (1, 100.0, 40.0), (2, 400.0, 20.0)):
        sample = sim.Simulation(scene_of_run(lesson, number)).record(4.0, "spring0.force", "mass1.vx")
        force, velocity = sample["spring0.force"], sample["mass1.vx"]
        amplitude = math.hypot(3600.0, stiffness * belt * math.sqrt(6.0 / stiffness))
        assert (max(force), min(force)) == pytest.approx((1800.0 + amplitude, 1800.0 - amplitude), abs=30.0)
        slips, interval = velocity < 0.0, 4.0 / (len(force) - 1)
        backs = np.flatnonzero(np.diff(slips.astype(int)))
        back = np.diff(backs[:2])[0] * interval
        assert back == pytest.approx(math.pi * math.sqrt(6.0 / stiffness), rel=0.02)
    calm = after(scene_of_run(lesson, 3), 6.0)
    assert 100.0 * (calm.positions[1, 0] - 270.0) == pytest.approx(1800.0, abs=30.0)
    for static, sways in ((0.4, False), (0.6, True)):
        scene = apply_assignments(scene_of_run(lesson, 3), (f"static_friction={static}",))
        assert bool(np.ptp(sim.Simulation(scene).record(8.0, "mass1.vx")["mass1.vx"][-1200:]) > 5.0) == sways


def test_the_spectrum_of_a_rod_has_the_peaks_that_the_lesson_names() -> None:
    def peaks_of(number: int, quantity: str) -> dict[float, float]:
        scene = scene_of_run(sim.load_scene("lesson-spectrum"), number)
        curve = sim.Simulation(scene).record(10.0, quantity)[quantity]
        found = known(spectrum(np.linspace(0.0, 10.0, len(curve)), curve))
        return {round(peak.frequency, 2): peak.amplitude for peak in peaks(found, 10.0, 5)}

    whole = peaks_of(0, "mass19.y")
    assert list(whole) == pytest.approx((1.55, 9.72, 27.0), rel=5e-3)
    assert list(whole.values())[:2] == pytest.approx((10.0, 3.0), rel=0.05)
    assert list(peaks_of(1, "mass19.y")) == pytest.approx((9.7,), rel=5e-3)
    assert list(peaks_of(2, "mass19.y"))[:2] == pytest.approx((3.1, 19.44), rel=5e-3)
    assert not any(9.0 < frequency < 10.0 for frequency in peaks_of(3, "mass15.y"))
