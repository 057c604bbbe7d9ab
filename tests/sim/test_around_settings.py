"""The numbers with a slider of what surrounds a body, and of what its springs bear."""

from __future__ import annotations

import math

import msgspec
import pytest

from sim import Scene, Simulation, set_value
from sim.scene.surroundings import Gas
from sim.scene.types import Damage
from sim.settings import settings_of
from tests.sim.around_everything import OF_STRENGTH, OF_SURROUNDINGS, with_everything
from tests.sim.bodies import tangle

REPLACE = msgspec.structs.replace


def keys_of(scene: Scene) -> set[str]:
    return {setting.key for setting in settings_of(scene)}


def test_what_surrounds_a_body_and_what_breaks_has_settings_only_where_it_is() -> None:
    whole = with_everything()
    assert keys_of(whole) - keys_of(tangle(4)) == OF_SURROUNDINGS | OF_STRENGTH
    absent = {"wind": None, "medium": msgspec.UNSET, "ground": msgspec.UNSET, "walls": (), "contact": None}
    gone = {part: keys_of(whole) - keys_of(REPLACE(whole, **{part: no})) for part, no in absent.items()}
    assert gone == {
        "wind": {"wind_speed", "wind_direction", "turbulence"},
        "medium": {"drag_across", "drag_along"},
        "ground": {"ground_forward", "ground_backward", "ground_sideways"},
        "walls": {"wall_friction", "bounciness"},
        "contact": {"contact_distance", "contact_stiffness", "contact_friction"},
    }
    assert keys_of(whole) - keys_of(REPLACE(whole, fillings=whole.fillings[:2])) == {"liquid_stiffness"}
    assert keys_of(whole) - keys_of(REPLACE(whole, fillings=whole.fillings[2:])) == {"gas_pressure"}


def test_proportions_of_walls_fillings_and_strengths_are_kept() -> None:
    scene = with_everything()
    assert [w.friction for w in set_value(scene, "wall_friction", 0.8).walls] == pytest.approx([0.8, 0.4])
    fillings = set_value(scene, "gas_pressure", 5.0).fillings
    assert [f.pressure for f in fillings if isinstance(f, Gas)] == pytest.approx([5.0, 2.0])
    assert fillings[2] == scene.fillings[2]
    springs = set_value(scene, "strength", 1600.0).linear_springs
    assert [s.strength for s in springs[:3]] == [1600.0, 800.0, None]
    assert springs[2].yield_force == 300.0


def test_wind_keeps_its_direction_in_a_calm() -> None:
    calm = set_value(with_everything(), "wind_speed", 0.0)
    assert calm.wind is not None
    assert math.hypot(*calm.wind.velocity) < 1e-6
    again = set_value(calm, "wind_speed", 500.0).wind
    assert again is not None
    assert again.velocity == pytest.approx((300.0, -400.0))


@pytest.mark.parametrize("y_down", [True, False])
def test_wind_of_ninety_degrees_blows_up_the_screen(y_down: bool) -> None:
    scene = with_everything()
    scene = REPLACE(scene, view=REPLACE(scene.view, y_down=y_down))
    wind = set_value(scene, "wind_direction", 90.0).wind
    assert wind is not None
    assert wind.velocity == pytest.approx((0.0, -500.0 if y_down else 500.0))


def test_a_change_of_the_surroundings_lets_the_motion_go_on() -> None:
    """What has broken stays broken."""
    scene = with_everything()
    simulation = Simulation(scene)
    simulation.step(40)
    moment = simulation.capture()
    worn = REPLACE(scene, pose=REPLACE(simulation.pose(), damage=Damage(broken=(1,))))
    simulation = Simulation(worn)
    for key, value in (
        ("wall_friction", 0.1),
        ("wind_speed", 900.0),
        ("gas_pressure", 10.0),
        ("contact_distance", 7.0),
        ("strength", 9e3),
    ):
        simulation.replace(set_value(simulation.scene, key, value))
        damage = simulation.damage
        assert damage is not None
        assert damage.broken == (1,)
        assert (simulation.positions == moment.positions).all()
        assert (simulation.velocities == moment.velocities).all()
