"""`rope(...)`: a whole scene from a few numbers."""

from __future__ import annotations

from typing import Any

from .numbers import Vector
from .types import ArrowKeys, Circle, ForceLaw, Integrator, Rope, Scene, View
from .validate import validate


def rope(
    masses: int = 12,
    length: float = 300.0,
    *,
    name: str = "rope",
    description: str = "",
    start: Vector = (300.0, 150.0),
    offset: float = 0.0,
    direction: Vector = (0.0, 1.0),
    stiffness: float = 10_000.0,
    damping: float = 40.0,
    angular_stiffness: float = 10_000.0,
    angular_damping: float = 0.0,
    rest_angle: float = 0.0,
    joints: bool = True,
    mass: float = 1.0,
    radius: float = 6.0,
    held: tuple[int, ...] = (0,),
    driven: int | None = 0,
    circle: Circle | None = None,
    gravity: Vector = (0.0, 2000.0),
    air_friction: float = 0.002,
    force_law: ForceLaw = "conservative",
    integrator: Integrator | None = None,
    arrow_keys: ArrowKeys | None = None,
    view: View | None = None,
) -> Scene:
    """A scene with one straight rope; the defaults are the tutorial's constants.

    The parameters up to `circle` are those of `sim.Rope`, the others those of `sim.Scene`;
    units and ranges are given there. The rope hangs down the screen unless `direction` says otherwise.

    Raises:
        SceneError: a number is out of range; the sentence names it.
    """
    recipe = Rope(
        masses=masses,
        length=length,
        start=start,
        offset=offset,
        direction=direction,
        stiffness=stiffness,
        damping=damping,
        angular_stiffness=angular_stiffness,
        angular_damping=angular_damping,
        rest_angle=rest_angle,
        joints=joints,
        mass=mass,
        radius=radius,
        held=held,
        driven=driven,
        circle=circle,
    )
    return validate(
        Scene(
            name=name,
            description=description,
            bodies=(recipe,),
            gravity=gravity,
            air_friction=air_friction,
            force_law=force_law,
            integrator=integrator or Integrator(),
            arrow_keys=arrow_keys or ArrowKeys(),
            view=view or View(),
        )
    )


def fine_rope(masses: int, **changes: Any) -> Scene:
    """The tutorial's rope of twelve masses, divided more finely; horizontal, held at its left end.

    Length, weight, drag and stiffness of the rope as a whole stay the same. `changes` are arguments of
    `rope`.
    """
    finer = (masses - 1) / 11.0
    numbers = {
        "start": (100.0, 100.0),
        "direction": (1.0, 0.0),
        "driven": None,
        "mass": 12.0 / masses,
        "stiffness": 1e4 * finer,
        "damping": 40.0 * finer,
        "angular_stiffness": 1e4 * finer**3,
        "air_friction": 0.002 * 12.0 / masses,
    }
    return rope(masses, **(numbers | changes))
