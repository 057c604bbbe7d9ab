"""What can be said of one part of a body at a moment: a mass, a spring or a joint.

As in `description`, these are numbers and kinds, which `app` puts into words. Numbers are those of
`sim.motion.quantities`, under which they are plotted, too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..engine.tables import Floats
from ..motion.quantities import Moving, quantity
from ..scene.parts import JointMuscle, Motor, SpringMuscle
from ..scene.types import Scene
from .description import STILL, STRAINED, broken_springs, touches


@dataclass(frozen=True, slots=True)
class MassFound:
    """A mass at a moment.

    Attributes:
        number: in the scene.
        mass: kg.
        place: (x, y) px.
        velocity: (vx, vy) px/s.
        is_held: whether it is held.
        springs, neighbours: the intact springs that end there, and the masses at their other ends.
        touches: whether a wall or another body pushes it.
    """

    number: int
    mass: float
    place: tuple[float, float]
    velocity: tuple[float, float]
    is_held: bool
    springs: tuple[int, ...]
    neighbours: tuple[int, ...]
    touches: bool

    @property
    def speed(self) -> float:
        """px/s; 0 where it is next to nothing."""
        speed = math.hypot(*self.velocity)
        return speed if speed > STILL else 0.0


@dataclass(frozen=True, slots=True)
class SpringFound:
    """A spring at a moment.

    Attributes:
        number: in the scene.
        ends: the masses that it joins.
        length, rest_length: px.
        force: kg px/s², with which it pulls its ends together; negative where it pushes them apart.
        unit: of the force, which with metres is N.
        is_broken, has_yielded: what has happened to it.
        muscle: what moves it, or None.
    """

    number: int
    ends: tuple[int, int]
    length: float
    rest_length: float
    force: float
    unit: str
    is_broken: bool
    has_yielded: bool
    muscle: SpringMuscle | None

    @property
    def strain(self) -> float:
        """Its elongation as a part of the rest length; 0 where it is next to nothing."""
        strain = self.length / self.rest_length - 1.0 if self.rest_length > 0.0 else 0.0
        return strain if abs(strain) >= STRAINED else 0.0


@dataclass(frozen=True, slots=True)
class JointFound:
    """A joint at a moment.

    Attributes:
        number: in the scene.
        springs: those that it keeps at an angle.
        mass: where these meet.
        corner: between the directions in which they leave the mass, degrees, 0 to 180.
        angle, rest_angle: degrees; the angle is in (-180, 180].
        torque: kg px²/s², on its first spring; positive where the angle is larger than the rest angle.
        unit: of the torque, which with metres is N m.
        is_broken, has_yielded: what has happened to it.
        muscle, motor: what moves it, or None.
    """

    number: int
    springs: tuple[int, int]
    mass: int
    corner: float
    angle: float
    rest_angle: float
    torque: float
    unit: str
    is_broken: bool
    has_yielded: bool
    muscle: JointMuscle | None
    motor: Motor | None


PartFound = MassFound | SpringFound | JointFound


def describe_part(simulation: Moving, scene: Scene, kind: str, number: int) -> PartFound:
    """Describe a mass, a spring or a joint; see `describe_mass`."""
    return {"mass": describe_mass, "spring": describe_spring, "joint": describe_joint}[kind](
        simulation, scene, number
    )


def describe_mass(simulation: Moving, scene: Scene, number: int) -> MassFound:
    """Describe a mass.

    Args:
        simulation: what moves it.
        scene: its scene.
        number: of the mass.
    """
    x, y, vx, vy = (_read(simulation, scene, f"mass{number}.{what}")[0] for what in ("x", "y", "vx", "vy"))
    whole = np.flatnonzero(~broken_springs(simulation, scene)).tolist()
    springs = [s for s in whole if number in (scene.linear_springs[s].a, scene.linear_springs[s].b)]
    others = [scene.linear_springs[s].a + scene.linear_springs[s].b - number for s in springs]
    return MassFound(
        number=number,
        mass=_read(simulation, scene, f"mass{number}.mass")[0],
        place=(x, y),
        velocity=(vx, vy),
        is_held=any(anchor.mass == number for anchor in scene.anchors),
        springs=tuple(springs),
        neighbours=tuple(others),
        touches=any(force[number] != 0.0 for force in touches(simulation).values()),
    )


def describe_spring(simulation: Moving, scene: Scene, number: int) -> SpringFound:
    """Describe a spring; see `describe_mass`."""
    spring = scene.linear_springs[number]
    length, longer = (
        _read(simulation, scene, f"spring{number}.{what}")[0] for what in ("length", "elongation")
    )
    force, unit = _read(simulation, scene, f"spring{number}.force")
    system, state = simulation.tables
    row = int(np.flatnonzero(system.spring_order == number)[0])
    return SpringFound(
        number=number,
        ends=(spring.a, spring.b),
        length=length,
        rest_length=length - longer,
        force=force,
        unit=unit,
        is_broken=bool(broken_springs(simulation, scene)[number]),
        has_yielded=bool(state.set_length.size and state.set_length[row] != 0.0),
        muscle=spring.muscle or None,
    )


def describe_joint(simulation: Moving, scene: Scene, number: int) -> JointFound:
    """Describe a joint; see `describe_mass`."""
    joint = scene.angular_springs[number]
    one, other = scene.linear_springs[joint.a], scene.linear_springs[joint.b]
    broken = broken_springs(simulation, scene)
    torque, unit = _read(simulation, scene, f"joint{number}.torque")
    system, state = simulation.tables
    row = int(system.joint_order[number])
    mass = ({one.a, one.b} & {other.a, other.b}).pop()
    ends = (spring.b if spring.a == mass else spring.a for spring in (one, other))
    at, first, second = (_place(simulation, scene, each) for each in (mass, *ends))
    (x0, y0), (x1, y1) = first - at, second - at
    return JointFound(
        number=number,
        springs=(joint.a, joint.b),
        mass=mass,
        corner=math.degrees(abs(math.atan2(x0 * y1 - y0 * x1, x0 * x1 + y0 * y1))),
        angle=_read(simulation, scene, f"joint{number}.wrapped_angle")[0],
        rest_angle=_read(simulation, scene, f"joint{number}.rest_angle")[0],
        torque=torque,
        unit=unit,
        is_broken=bool(broken[joint.a] or broken[joint.b]),
        has_yielded=bool(state.set_angle.size and state.set_angle[row] != 0.0),
        muscle=joint.muscle or None,
        motor=joint.motor or None,
    )


def _place(simulation: Moving, scene: Scene, mass: int) -> Floats:
    return np.array([_read(simulation, scene, f"mass{mass}.{axis}")[0] for axis in "xy"])


def _read(simulation: Moving, scene: Scene, name: str) -> tuple[float, str]:
    """The present value of a quantity, and its unit."""
    found = quantity(name, scene)
    return found.read(simulation), found.unit
