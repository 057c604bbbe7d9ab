"""What `softrod sweep` measures, held against what is known otherwise."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import sim
from sim.store.files import encode_scene
from studies.sweep.measures import Track, period
from studies.sweep.runs import reference_of, run, run_reference
from tests.studies.sweeping import ROPE, rows_of, swept


# ------------------------------------------------------------------------- what is measured
def pendulum(degrees: float, length: float = 100.0) -> sim.Scene:
    """A mass on a spring that is nearly a rod, under a gravity of 1000."""
    angle = math.radians(degrees)
    return sim.rope(
        2,
        length,
        direction=(math.sin(angle), math.cos(angle)),
        driven=None,
        stiffness=1e9,
        damping=0.0,
        joints=False,
        gravity=(0.0, 1000.0),
        air_friction=0.0,
        integrator=sim.Integrator(method="rodas5p", tolerance=1e-6),
    )


@pytest.mark.parametrize("degrees", [5.0, 90.0])
def test_the_period_of_a_pendulum(degrees: float) -> None:
    from scipy.special import ellipk

    row = run(encode_scene(pendulum(degrees)), (), 6.0, ("period",))
    exact = 4.0 * math.sqrt(100.0 / 1000.0) * float(ellipk(math.sin(math.radians(degrees) / 2.0) ** 2))
    assert row.values[0] == pytest.approx(exact, rel=2e-6)


def test_periods_of_damped_and_of_no_swings() -> None:
    t = np.linspace(0.0, 5.0, 601)
    z = np.exp((-0.2 + 2j * np.pi / 0.7) * t)
    speed = z * (-0.2 + 2j * np.pi / 0.7)
    one = np.array((0.6, -0.8))
    found = period(t, 300.0 + np.outer(np.real(z), one), np.outer(np.real(speed), one))
    assert found == pytest.approx(0.7, rel=2e-3)
    # A ripple on the swing is none of its own.
    ripple, its_speed = 0.02 * np.sin(60.0 * t), 1.2 * np.cos(60.0 * t)
    pure = np.exp(2j * np.pi / 0.7 * t)
    swing, speed = np.imag(pure) + ripple, 2.0 * np.pi / 0.7 * np.real(pure) + its_speed
    assert period(t, np.outer(swing, one), np.outer(speed, one)) == pytest.approx(0.7, rel=1e-2)
    creep = np.column_stack((np.exp(-t), 0.0 * t))
    assert period(t, creep, -creep) is None
    assert period(t, 0.0 * creep, 0.0 * creep) is None
    assert period(t[:3], creep[:3], creep[:3]) is None


def test_the_sag_is_that_of_the_equilibrium() -> None:
    scene = sim.rope(
        6, 100.0, direction=(1.0, 0.0), held=(0, 5), driven=None, damping=200.0, angular_damping=50.0,
        air_friction=0.1, integrator=sim.Integrator(method="rodas5p", tolerance=1e-6),
    )  # fmt: skip
    rest = np.array(sim.equilibrium(scene).positions) - [mass.position for mass in scene.masses]
    row = run(encode_scene(scene), (), 20.0, ("sag", "survived"))
    assert rest[:, 1].max() > 1.0
    assert row.values == (pytest.approx(rest[:, 1].max(), rel=1e-4), True)
    # Along gravity, wherever that points; and nowhere where there is none.
    up = run(encode_scene(scene), ("gravity=-2000",), 20.0, ("sag",))
    assert up.values == (pytest.approx(rest[:, 1].max(), rel=1e-4),)
    assert run(encode_scene(scene), ("gravity=0",), 0.1, ("sag",)).values == (None,)


def test_the_growth_of_errors_is_that_of_the_motion() -> None:
    standing = encode_scene(pendulum(180.0))
    row = run(standing, (), 3.0, ("growth",))
    assert row.values[0] == pytest.approx(math.exp(math.sqrt(10.0)), rel=0.05)
    assert row.values == run(standing, (), 3.0, ("growth",)).values
    held = run(encode_scene(sim.load_scene("tutorial-3.1")), (), 0.1, ("growth", "survived"))
    assert held.values == (None, True)


def test_the_stretch_is_the_largest_of_all_looks() -> None:
    weight = sim.rope(
        2, 100.0, joints=False, driven=None, damping=0.0, stiffness=1000.0, gravity=(0.0, 5000.0),
        air_friction=0.0, integrator=sim.Integrator(method="rk4", dt=1e-3),
    )  # fmt: skip
    # It falls to twice the distance at which it would rest, 5000 / 1000 px, and comes back.
    period = 2.0 * math.pi / math.sqrt(1000.0)
    assert run(encode_scene(weight), (), period, ("stretch",)).values[0] == pytest.approx(0.1, rel=2e-2)


def test_the_energy_residual_is_relative_and_none_at_rest() -> None:
    coarse, fine = (
        run(encode_scene(ROPE), ("method=velocity_verlet", f"dt={dt}"), 0.5, ("energy_residual",)).values[0]
        for dt in (1e-3, 2.5e-4)
    )
    assert isinstance(coarse, float) and isinstance(fine, float)
    assert 0.0 < fine < coarse < 0.01
    assert coarse / fine == pytest.approx(16.0, rel=0.3)
    assert run(encode_scene(ROPE), ("gravity=0",), 0.1, ("energy_residual", "period")).values == (None, None)


@pytest.mark.parametrize(("method", "order"), [("symplectic_euler", 1), ("velocity_verlet", 2), ("rk4", 4)])
def test_the_error_falls_with_the_step_at_the_order_of_the_method(
    method: str, order: int, tmp_path: Path
) -> None:
    steps = (1e-3, 5e-4, 2.5e-4)
    vary = ("dt=" + ",".join(map(str, steps)),)
    status, here, _ = swept(tmp_path, ROPE, vary, ("error",), settings=(f"method={method}",))
    assert status == 0
    errors = [float(row["error [px]"]) for row in rows_of(tmp_path)]
    assert math.log2(errors[0] / errors[-1]) / 2.0 == pytest.approx(order, abs=0.25)
    assert here.asked == ["run_reference", "run", "run", "run"]


@pytest.mark.parametrize(("measures", "looks"), [(("sag", "survived"), 0), (("sag", "stretch"), 25)])
def test_nobody_looks_in_between_where_only_the_end_counts(
    measures: tuple[str, ...], looks: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[float] = []
    look = Track.look
    monkeypatch.setattr(Track, "look", lambda track: (seen.append(0.0), look(track)))
    row = run(encode_scene(ROPE), ("method=auto", "dt=1e-3"), 0.192, measures)
    assert len(seen) == looks
    assert row.values[0] == pytest.approx(
        run(encode_scene(ROPE), ("method=rk4",), 0.192, ("sag",)).values[0], abs=0.1
    )


def test_near_exact_runs_are_shared_where_only_the_solver_varies(tmp_path: Path) -> None:
    vary = ("method=rk4,adams", "gravity=500,1000", "dt=1e-3,5e-4")
    _, here, _ = swept(tmp_path, ROPE, vary, ("error",))
    assert (here.asked.count("run_reference"), here.asked.count("run")) == (2, 8)
    # However the product of steps and step is rounded: 7 times 0.1 s is not quite 0.7 s.
    ends = {reference_of(sim.set_value(ROPE, "dt", dt), 0.7, 0.1) for dt in (0.1, 0.7)}
    assert len({end.data for end in ends}) == len(ends) == 1
    # A step that does not fit into the duration has an end, and a near-exact run, of its own.
    _, here, _ = swept(tmp_path / "new", ROPE, ("dt=1e-3,3e-3",), ("error",))
    assert here.asked.count("run_reference") == 2
    assert all(float(row["error [px]"]) < 0.1 for row in rows_of(tmp_path / "new"))


def test_a_run_that_runs_away_is_a_row(tmp_path: Path) -> None:
    vary = ("linear_stiffness=1e4,1e9", "method=rk4,rodas5p")
    status, _, _ = swept(tmp_path, ROPE, vary, ("sag", "stretch", "error", "energy_residual", "period"))
    assert status == 0
    rows = rows_of(tmp_path)
    assert [row["survived"] for row in rows] == ["yes", "yes", "no", "yes"]
    assert list(rows[2].values()) == ["1000000000", "rk4", "", "", "", "", "", "no"]
    assert rows[3]["sag [px]"] and rows[3]["error [px]"]


def test_a_near_exact_run_that_fails_leaves_an_empty_cell(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(data: bytes, end: float) -> None:
        return None

    failing.__name__ = run_reference.__name__
    monkeypatch.setattr("studies.sweep.sweep.run_reference", failing)
    swept(tmp_path, ROPE, ("gravity=1,2",), ("error", "sag"))
    assert [(row["error [px]"], row["survived"]) for row in rows_of(tmp_path)] == [("", "yes")] * 2
