"""The axes of a map of stability, and the experiment in each of its cells."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from sim.errors import InputError, SceneError
from sim.scene.types import Mass, Rope, Scene, rebuilt
from sim.scene.validate import validate
from sim.settings import SETTINGS, no_use

GOLDEN = math.pi * (3.0 - math.sqrt(5.0))
"""The golden angle, radians: its multiples never coincide."""


@dataclass(frozen=True)
class Axis:
    """A number of a scene that a map varies; axes are logarithmic.

    Attributes:
        key, label, unit: its name in commands, for people, and its unit.
        low, high: bounds of the values.
        range: default range.
        write: the scene with another value, unvalidated.
        problem: returns why a scene has no such number, or None.
        whole: whether it is a whole number.
    """

    key: str
    label: str
    unit: str
    low: float
    high: float
    range: tuple[float, float]
    write: Callable[[Scene, float], Scene]
    problem: Callable[[Scene], str | None]
    whole: bool = False

    def values(self, ends: tuple[float, float] | None, size: int) -> NDArray[np.float64]:
        """Return at most `size` values from end to end, evenly spaced in their logarithms.

        Raises:
            InputError: the ends are not two ascending numbers within the bounds.
        """
        low, high = ends or self.range
        if not self.low <= low < high <= self.high:
            raise InputError(
                f"range of {self.key}: {low:g},{high:g} are not two ascending numbers within "
                f"{self.low:g}..{self.high:g} {self.unit}".rstrip()
            )
        values = np.geomspace(low, high, size)
        return np.unique(np.round(values)) if self.whole else values


def _of_setting(
    key: str, setting: str, label: str, ends: tuple[float, float], lowest: float = 1e-9, whole: bool = False
) -> Axis:
    """Return an axis for one of the sliders."""
    found = SETTINGS[setting]

    def problem(scene: Scene) -> str | None:
        return None if found.applies(scene) else no_use(setting, scene).partition(": ")[2]

    return Axis(key, label, found.unit, max(found.low, lowest), found.high, ends, found.write, problem, whole)


def _alternate(scene: Scene, ratio: float) -> Scene:
    """Make every second mass lighter by a factor."""
    masses = tuple(replace(m, mass=m.mass / ratio) if i % 2 else m for i, m in enumerate(scene.masses))
    return replace(scene, bodies=(), masses=masses)


def _resampled(scene: Scene, masses: float) -> Scene:
    recipe = rope_of(scene)
    assert recipe is not None, "checked by _masses_problem"
    return rebuilt(scene, bodies=(replace(recipe, masses=int(masses)),))


def _masses_problem(scene: Scene) -> str | None:
    if rope_of(scene) is None:
        return f"the scene {scene.name!r} is not one straight rope of equal masses and springs"
    return None


def rope_of(scene: Scene) -> Rope | None:
    """Return the recipe that could have made a scene's body, or None if there is none."""
    if len(scene.bodies) == 1 and isinstance(scene.bodies[0], Rope):
        return scene.bodies[0]
    masses, springs, joints = scene.masses, scene.linear_springs, scene.angular_springs
    if len(masses) < 2 or not springs:
        return None
    (x0, y0), (x1, y1) = masses[0].position, masses[-1].position
    joint = joints[0] if joints else None
    recipe = Rope(
        masses=len(masses),
        length=max(math.hypot(x1 - x0, y1 - y0), 1e-3),
        start=masses[0].position,
        direction=(x1 - x0, y1 - y0) if (x1, y1) != (x0, y0) else (1.0, 0.0),
        stiffness=springs[0].stiffness,
        damping=springs[0].damping,
        joints=joint is not None,
        angular_stiffness=joint.stiffness if joint else 0.0,
        angular_damping=joint.damping if joint else 0.0,
        rest_angle=joint.rest_angle if joint else 0.0,
        mass=masses[0].mass,
        radius=masses[0].radius,
        held=tuple(anchor.mass for anchor in scene.anchors),
    )
    made, linear, angular, *_ = recipe.expand()
    straight = len(made) == len(masses) and all(_same(a, b) for a, b in zip(made, masses, strict=True))
    even = len(linear) == len(springs) and all(
        (a.a, a.b, a.stiffness, a.damping) == (b.a, b.b, b.stiffness, b.damping)
        and math.isclose(a.rest_length, b.rest_length, rel_tol=1e-9)
        for a, b in zip(linear, springs, strict=True)
    )
    return recipe if straight and even and angular == joints else None


def _same(one: Mass, other: Mass) -> bool:
    return one.mass == other.mass and math.dist(one.position, other.position) < 1e-6


_ALL = (
    _of_setting("dt", "dt", "time step", (1e-4, 0.05)),
    _of_setting("stiffness", "linear_stiffness", "linear stiffness", (1e2, 1e7)),
    _of_setting("damping", "linear_damping", "linear damping", (1.0, 1e4)),
    _of_setting("angular_stiffness", "angular_stiffness", "angular stiffness", (1e2, 1e7)),
    _of_setting("angular_damping", "angular_damping", "angular damping", (1.0, 1e4)),
    _of_setting("air_friction", "air_friction", "air friction", (1e-4, 10.0)),
    Axis(
        "mass_ratio", "mass ratio, one mass to the next", "", 1.0, 1e6, (1.0, 1e4), _alternate,
        lambda scene: None,
    ),
    Axis(
        "masses", "number of masses", "", 2.0, 1000.0, (2.0, 100.0), _resampled, _masses_problem, whole=True,
    ),
)  # fmt: skip

AXES: dict[str, Axis] = {axis.key: axis for axis in _ALL}

_ORDER = ("masses", *(key for key in AXES if key not in ("masses", "mass_ratio")), "mass_ratio")
"""Order in which values are written: a number of masses needs the recipe, a ratio of masses removes it."""


def released(scene: Scene) -> Scene:
    """Return the scene with something to move: if every mass is held, all but the first are released."""
    if len(scene.anchors) < len(scene.masses):
        return scene
    if len(scene.masses) < 2:
        raise InputError(f"the scene {scene.name!r} has no mass that could move")
    return replace(scene, bodies=(), anchors=scene.anchors[:1])


def in_cell(scene: Scene, values: dict[str, float]) -> Scene:
    """Return the experiment of a cell: the numbers are set, and every free mass gets a kick.

    A kick is an extent of the body per second, in a direction that turns by the golden angle from mass to
    mass, so that it excites every mode.

    Raises:
        InputError: the numbers make no valid scene.
    """
    try:
        for key in _ORDER:
            if key in values:
                scene = AXES[key].write(scene, values[key])
        scene = validate(scene)
    except SceneError as error:
        numbers = ", ".join(f"{key} = {value:g}" for key, value in values.items())
        raise InputError(f"{numbers}: {error}") from None
    speed = extent(scene)
    kicks = [(speed * math.cos(i * GOLDEN), speed * math.sin(i * GOLDEN)) for i in range(len(scene.masses))]
    if scene.pose is not None:
        return validate(replace(scene, pose=replace(scene.pose, velocities=tuple(kicks))))
    masses = tuple(replace(m, velocity=kick) for m, kick in zip(scene.masses, kicks, strict=True))
    return validate(replace(scene, bodies=(), masses=masses))


def extent(scene: Scene) -> float:
    """Return the size of a body, px: the diagonal of the box around its masses at the start."""
    positions = np.array(scene.pose.positions if scene.pose else [m.position for m in scene.masses])
    return max(float(np.hypot(*np.ptp(positions, axis=0))), 1e-3)
