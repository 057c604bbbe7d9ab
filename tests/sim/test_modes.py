"""How much of each vibration is in a motion: against SciPy, the energy balance, and spectra of runs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import scipy.sparse
import scipy.sparse.linalg
from msgspec.structs import replace

import sim
from sim import Moment, Scene, Simulation
from sim.analysis.modes import Excitation, Modes
from sim.errors import InputError
from tests.sim.builders import chain, rod, row
from tests.sim.changes import by, with_joints, with_springs
from tests.sim.checks import known, refusal

Floats = np.ndarray[Any, np.dtype[np.float64]]


def exact(scene: Scene, dt: float = 1.0 / 240.0) -> Scene:
    """Solved so well that errors of steps are none."""
    return by(scene, "adams", dt=dt, tolerance=1e-9)


def undamped(scene: Scene) -> Scene:
    """Without anything that takes energy."""
    scene = with_springs(with_joints(scene, damping=0.0), damping=0.0)
    return replace(scene, air_friction=0.0, force_law="conservative")


def expanded(scene: Scene) -> Scene:
    """With its own parts, at rest."""
    return exact(undamped(Simulation(scene).scene))


def start(modes: Modes, scene: Scene) -> Simulation:
    """A body at rest in the pose that the modes are about."""
    return Simulation(replace(scene, pose=modes.scene.pose))


def looked(modes: Modes, simulation: Simulation) -> Excitation:
    return modes.excitation(simulation.positions, simulation.velocities)


def put(modes: Modes, simulation: Simulation, mode: int, amplitude: float) -> None:
    simulation.restore(modes.put(simulation.capture(), mode, amplitude))


# ------------------------------------------------------------------------- frequencies
def own_frequencies(scene: Scene, rest: Floats, count: int) -> Floats:
    """The slowest angular frequencies of a scene about a pose, rad/s.

    They are those of A x = w² M x by SciPy, with the Hessian A of the energies of springs and joints, which
    is written down here once more.

    Args:
        scene: of springs and joints under the conservative law, with no other force than gravity.
        rest: (n, 2) px.
    """
    n = len(scene.masses)
    rows: list[int] = []
    columns: list[int] = []
    values: list[float] = []
    one = np.eye(2)
    quarter = np.array([[0.0, 1.0], [-1.0, 0.0]])

    def between(spring: sim.LinearSpring) -> tuple[Floats, float, tuple[tuple[int, float], ...]]:
        way = rest[spring.b] - rest[spring.a]
        length = float(np.hypot(*way))
        return way / length, length, ((spring.b, 1.0), (spring.a, -1.0))

    def add(
        block: Floats, first: tuple[tuple[int, float], ...], second: tuple[tuple[int, float], ...]
    ) -> None:
        for m, sign in first:
            for other, back in second:
                for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)):
                    rows.append(2 * m + i)
                    columns.append(2 * other + j)
                    values.append(sign * back * float(block[i, j]))

    for spring in scene.linear_springs:
        u, length, masses = between(spring)
        across = 1.0 - spring.rest_length * scene.rest_length_scale / length
        add(spring.stiffness * (np.outer(u, u) + across * (one - np.outer(u, u))), masses, masses)
    for joint in scene.angular_springs:
        (a, long, of_a), (b, wide, of_b) = (between(scene.linear_springs[s]) for s in (joint.a, joint.b))
        r = math.radians(joint.rest_angle)
        # K (|A||B| - A . B cos r - (A x B) sin r)
        add(joint.stiffness * wide / long * (one - np.outer(a, a)), of_a, of_a)
        add(joint.stiffness * long / wide * (one - np.outer(b, b)), of_b, of_b)
        both = joint.stiffness * (np.outer(a, b) - math.cos(r) * one - math.sin(r) * quarter)
        add(both, of_a, of_b)
        add(both.T, of_b, of_a)
    held = {anchor.mass for anchor in scene.anchors}
    free = [2 * m + axis for m in range(n) if m not in held for axis in (0, 1)]
    hessian = scipy.sparse.csc_matrix((values, (rows, columns)), shape=(2 * n, 2 * n))[free][:, free]
    weights = scipy.sparse.diags([scene.masses[m // 2].mass for m in free], format="csc")
    squares = scipy.sparse.linalg.eigsh(hessian, count, weights, sigma=0.0, return_eigenvectors=False)
    return np.sqrt(np.sort(squares))


@pytest.mark.parametrize("name", ["rod", "bridge", "girder", "tree"])
def test_frequencies_are_those_of_a_hessian_of_their_own(name: str) -> None:
    scene = expanded(sim.load_scene(name))
    modes = Modes(scene, 10)
    assert modes.omega == pytest.approx(own_frequencies(modes.scene, modes.rest, 10), rel=1e-8)


def test_a_thousand_masses() -> None:
    scene = undamped(sim.rope(1000))
    modes = Modes(scene, 6)
    assert modes.omega == pytest.approx(own_frequencies(modes.scene, modes.rest, 6), rel=1e-8)
    with pytest.raises(InputError, match="modes: 1200 masses are more than 1000"):
        Modes(sim.rope(1200), 3)
    with pytest.raises(InputError, match="a body with contact may have 200 masses, this has 400"):
        Modes(sim.jelly(columns=20, rows=20, contact=sim.Contact(distance=5.0)), 3)


def test_a_large_jelly_has_modes_where_it_lies_on_a_floor() -> None:
    floor = sim.Wall(point=(0.0, 500.0), normal=(0.0, -1.0))
    scene = sim.jelly(columns=20, rows=20, width=380.0, height=380.0, center=(300.0, 305.0), walls=(floor,))
    modes = Modes(exact(scene), 4)
    simulation = start(modes, exact(scene))
    below = modes.rest[:, 1] > 500.0
    assert 10 <= np.count_nonzero(below) <= 20
    weight = 1000.0 * sum(mass.mass for mass in scene.masses)
    pushed = sum(floor.hardness * scene.masses[0].mass * (modes.rest[below, 1] - 500.0) ** 2)
    assert pushed == pytest.approx(weight, rel=1e-6)
    simulation.step(60)
    assert simulation.positions == pytest.approx(modes.rest, abs=1e-4)
    assert (modes.omega > 0.1).all()


# ------------------------------------------------------------------------- energies
@pytest.mark.parametrize("name", ["rod", "bridge", "girder"])
def test_at_small_amplitudes_the_modes_have_the_energy_of_the_balance(name: str) -> None:
    scene = expanded(sim.load_scene(name))
    modes = Modes(scene, 10)
    simulation = start(modes, scene)
    at_rest = simulation.energy().total
    for mode in range(10):
        put(modes, simulation, mode, 1e-3 * modes.size / (mode + 1))
    for _ in range(5):
        simulation.advance(0.37)
        found = looked(modes, simulation)
        whole = simulation.energy().total - at_rest
        assert whole > 0.0
        assert float(found.energies.sum()) == pytest.approx(whole, rel=0.01)
        assert found.others == pytest.approx(whole - float(found.energies.sum()), abs=1e-5 * whole)


def test_each_mode_keeps_its_energy_and_a_large_swing_gives_it_away() -> None:
    scene = expanded(sim.load_scene("rod"))
    modes = Modes(scene, 10)

    def left(amplitude: float) -> float:
        """How much of its energy the first mode has after a while."""
        simulation = start(modes, scene)
        put(modes, simulation, 0, amplitude)
        before = looked(modes, simulation).energies
        assert float(before[1:].sum()) < 1e-12 * before[0]
        simulation.advance(4.3)
        return float(looked(modes, simulation).energies[0] / before[0])

    assert left(1e-4 * modes.size) == pytest.approx(1.0, rel=1e-3)
    assert left(0.7 * modes.size) < 0.9


def test_what_is_in_faster_modes_is_in_none_of_the_slow_ones() -> None:
    scene = expanded(sim.load_scene("bridge"))
    few, many = Modes(scene, 4), Modes(scene, 12)
    simulation = start(many, scene)
    put(many, simulation, 9, 1e-4 * many.size)
    found = looked(few, simulation)
    assert found.others == pytest.approx(looked(many, simulation).energies[9], rel=1e-6)
    assert float(found.energies.sum()) < 1e-9 * found.others


def test_damping_takes_from_a_mode_by_its_ratio() -> None:
    scene = exact(sim.load_scene("bridge"))
    modes = Modes(scene, 3)
    simulation = start(modes, scene)
    put(modes, simulation, 2, 1e-4 * modes.size)
    before = looked(modes, simulation).energies[2]
    seconds = simulation.dt * simulation.advance(2.0)
    rate = 2.0 * modes.damping_ratios[2] * modes.omega[2]
    assert modes.damping_ratios[2] > 0.001
    kept = looked(modes, simulation).energies[2] / before
    assert math.log(kept) == pytest.approx(-rate * seconds, rel=0.01)


# ------------------------------------------------------------------------- putting a body into a mode
def test_a_body_is_put_into_a_mode_and_the_others_stay() -> None:
    scene = expanded(sim.load_scene("girder"))
    modes = Modes(scene, 6)
    simulation = start(modes, scene)
    put(modes, simulation, 1, 2.0)
    simulation.advance(0.0371)
    before = looked(modes, simulation)
    for amplitude in (3.0, 0.5, 0.0):
        put(modes, simulation, 4, amplitude)
        after = looked(modes, simulation)
        reached = math.hypot(after.amplitudes[4], after.rates[4] / modes.omega[4])
        assert reached == pytest.approx(amplitude, rel=1e-9, abs=1e-9)
        kept = [0, 1, 2, 3, 5]
        assert after.amplitudes[kept] == pytest.approx(before.amplitudes[kept], abs=1e-9)
        assert after.rates[kept] == pytest.approx(before.rates[kept], abs=1e-7)
    energy = 7.5
    put(modes, simulation, 4, modes.amplitude_of(4, energy))
    assert looked(modes, simulation).energies[4] == pytest.approx(energy, rel=1e-9)


def test_a_mode_goes_on_in_its_sense_and_is_not_strained_where_velocity_does() -> None:
    scene = expanded(sim.load_scene("rod"))
    modes = Modes(scene, 3)
    for sign in (1.0, -1.0):
        simulation = start(modes, scene)
        moment = simulation.capture()
        rows = moment.rows.copy()
        rows[:2] += 0.5 * modes.shapes[0].T
        rows[2:] += 0.01 * sign * modes.omega[0] * modes.shapes[0].T
        simulation.restore(Moment(moment.scene, 1.0, 0.0, rows, 0.0, 0))
        put(modes, simulation, 0, 40.0)
        found = looked(modes, simulation)
        assert found.amplitudes[0] == pytest.approx(0.5, rel=1e-9)
        assert np.sign(found.rates[0]) == sign
        assert abs(found.others) < 1e-3 * found.energies[0]


def test_a_mode_that_is_not_there_is_refused() -> None:
    scene = expanded(sim.load_scene("rod"))
    modes = Modes(scene, 3)
    moment = start(modes, scene).capture()
    for mode in (-1, 3):
        assert f"there is no mode {mode}; there are 3" in refusal(InputError, modes.put, moment, mode, 1.0)
    for amplitude in (math.nan, math.inf, -1.0):
        assert "is not in the range 0.. px" in refusal(InputError, modes.put, moment, 0, amplitude)


# ------------------------------------------------------------------------- motions as a whole
def test_a_body_that_flies_and_turns_has_its_vibrations_beside_that() -> None:
    scene = exact(chain(row(6), stiffness=5000.0, angular_stiffness=300.0))
    modes = Modes(scene, 4)
    simulation = start(modes, scene)
    put(modes, simulation, 1, 0.01)
    vibrating = looked(modes, simulation)
    moment = simulation.capture()
    turn, spin, speed = 2.1, 0.02, np.array([30.0, -50.0])
    c, s = math.cos(turn), math.sin(turn)
    around = np.array([[c, -s], [s, c]])
    positions = moment.positions @ around.T + (500.0, 70.0)
    middle = positions.mean(0)
    arm = positions - middle
    velocities = moment.velocities @ around.T + speed + spin * np.column_stack((-arm[:, 1], arm[:, 0]))
    found = modes.excitation(positions, velocities)
    assert found.energies[1] == pytest.approx(vibrating.energies[1], rel=1e-6)
    assert float(np.delete(found.energies, 1).sum()) < 1e-6 * found.energies[1]
    mass = sum(m.mass for m in scene.masses)
    whole = 0.5 * mass * float(speed @ speed) + 0.5 * spin**2 * float((arm**2).sum())
    assert found.whole == pytest.approx(whole, rel=1e-9)
    assert abs(found.others) < 1e-3 * found.energies[1]
    # What is put into it there swings along the body as it lies.
    rows = np.array([*positions.T, *velocities.T])
    again = modes.put(Moment(scene, 1.0, 0.0, rows, 0.0, 0), 2, 0.02)
    more = modes.excitation(again.positions, again.velocities)
    assert more.energies[2] == pytest.approx(0.5 * modes.masses[2] * (0.02 * modes.omega[2]) ** 2, rel=1e-6)
    assert more.whole == pytest.approx(whole, rel=1e-6)


def test_a_pendulum_without_gravity_turns_as_a_whole() -> None:
    scene = exact(replace(rod(5), gravity=(0.0, 0.0)))
    hinged = replace(scene, anchors=scene.anchors[:1], masses=scene.masses)
    modes = Modes(hinged, 2)
    moment = Simulation(hinged).capture()
    pin = moment.positions[hinged.anchors[0].mass]
    arm = moment.positions - pin
    turned = pin + np.column_stack((-arm[:, 1], arm[:, 0]))
    found = modes.excitation(turned, np.zeros_like(turned))
    assert np.abs(found.amplitudes).max() < 1e-6 * modes.size
    assert abs(found.others) < 1e-6


# ------------------------------------------------------------------------- marks and driving
def test_nodes_and_antinodes_of_a_string() -> None:
    n = 24
    scene = chain(row(n + 1), stiffness=400.0, rest_length=9.9, held=(0, n))
    modes = Modes(scene, 4)
    for k in range(4):
        marks = modes.marks(k)
        at = sorted(spring + along for spring, along in marks.nodes)
        assert at == pytest.approx([n * i / (k + 1) for i in range(1, k + 1)], abs=0.05)
        tops = sorted(marks.antinodes)
        assert tops == pytest.approx([n * (i + 0.5) / (k + 1) for i in range(k + 1)], abs=0.51)


@pytest.mark.parametrize("mode", [0, 1])
def test_supports_that_move_together_drive_a_mode(mode: int) -> None:
    scene = expanded(sim.load_scene("bridge"))
    modes = Modes(scene, 3)
    simulation = start(modes, scene)
    supports = known(modes.supports(mode))
    masses, ways, felt = supports
    assert masses.tolist() == sorted(anchor.mass for anchor in scene.anchors)
    places = simulation.positions[masses]
    # As the ground moves: distances stay.
    apart = places[:, None] - places
    assert np.abs(((ways[:, None] - ways) * apart).sum(2)).max() < 1e-6 * np.abs(apart).max()
    w, swing = modes.omega[mode], 1e-4
    steps = max(1, int(2.0 * math.pi / w / 40.0 / simulation.dt))
    while simulation.time < 6.0 * math.pi / w:
        at = simulation.time + steps * simulation.dt
        for mass, (x, y) in zip(masses, places + swing * math.sin(w * at) * ways, strict=True):
            simulation.lead(int(mass), (float(x), float(y)))
        simulation.step(steps)
    found = looked(modes, simulation)
    reached = math.hypot(found.amplitudes[mode], found.rates[mode] / w)
    # A force f B sin(wt) on the mass M of a mode has it grow by f B / (2 M w) in a second.
    assert reached == pytest.approx(felt * swing * simulation.time / (2.0 * modes.masses[mode] * w), rel=0.05)
    assert found.energies[mode] > 0.7 * found.energies.sum()


def test_a_body_that_nothing_holds_has_no_support() -> None:
    assert Modes(chain(row(6), stiffness=5000.0, angular_stiffness=300.0), 4).supports(0) is None


def test_a_body_that_cannot_move_has_no_modes() -> None:
    modes = Modes(sim.load_scene("tutorial-3.1"), 10)
    simulation = Simulation(modes.scene)
    assert modes.omega.size == 0
    assert looked(modes, simulation).energies.size == 0
