"""What is sent of a body: once its parts and surroundings, then the positions of its masses.

The page draws by itself. It gets an array of numbers for the plan of a body, and one for each frame. Their
sections are declared by the messages `Plan`, `Frame` and `Damage`, and read by `plan.js`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sim import Moment, Scene, Simulation
from sim.forces.fillings import FillingRow
from sim.forces.muscles import efforts
from sim.forces.touch.walls import WallRow
from sim.scene.columns import column
from sim.scene.surroundings import STILL_AIR
from sim.scene.types import Damage

from ..wire import to_page
from ..wire.to_page import Frame, Plan
from .colors import blend
from .looks import YIELDED
from .sketch import Floats, Sketch

_STRAIN_SHADES = 32
"""Shades between a spring's colour at rest and its full colour, on either side."""

_TURN_SHADES = 32
"""Shades of a wedge, on either side, and of a muscle."""

_BREATH = (0.25, 0.95)
"""Saturation of a muscle at its longest and at its shortest."""

_PALEST = 0.15
"""Saturation of the wedge of a joint at its rest angle."""


@dataclass(frozen=True)
class Picture:
    """The state of a body that is drawn.

    Attributes:
        positions: (n, 2) px.
        time: simulated seconds.
        efforts: of Left and Right, and of Up and Down, from -1 to 1, by which they work muscles, motors and
            forces; empty where none was held.
        rest_length_scale: factor of the rest lengths.
        rest_angle_shift: degrees added to all rest angles.
        ghost: (n, 2) px, positions of a ghost, which has the same plan, or None.
        damage: what has yielded and broken, or None.
        ghost_broken: indices of the broken springs of the ghost.
        second: a second body, with a plan of its own, or None.
    """

    positions: Floats
    time: float = 0.0
    rest_length_scale: float = 1.0
    rest_angle_shift: float = 0.0
    ghost: Floats | None = None
    damage: Damage | None = None
    ghost_broken: tuple[int, ...] = ()
    second: Picture | None = None
    efforts: tuple[float, ...] = ()

    @staticmethod
    def of(
        body: Simulation | Moment, ghost: Floats | None = None, ghost_damage: Damage | None = None
    ) -> Picture:
        """The picture of a body, now or at a moment, with a ghost and its damage."""
        return Picture(
            body.positions,
            body.time,
            body.rest_length_scale,
            body.rest_angle_shift,
            ghost,
            body.damage,
            broken_of(ghost_damage),
            efforts=tuple(efforts(np.array(body.steer), body.time).tolist()) if body.steer else (),
        )

    @staticmethod
    def at_start(scene: Scene) -> Picture:
        """The picture of a scene at its start, without a simulation."""
        starts = scene.pose.positions if scene.pose else [mass.position for mass in scene.masses]
        damage = scene.pose.damage if scene.pose else None
        return Picture(np.array(starts, float), rest_length_scale=scene.rest_length_scale, damage=damage)


def broken_of(damage: Damage | None) -> tuple[int, ...]:
    """Indices of broken springs."""
    return damage.broken if damage is not None else ()


def own_rest_angles(simulation: Simulation) -> Floats:
    """(J,) degrees; without what keys, muscles and yielding add, which are sent separately."""
    return column(simulation.capture().scene.angular_springs, "rest_angle")


def yielded_of(damage: Damage | None, rest_lengths: Floats) -> int:
    """The number of unbroken springs that have yielded: whose rest length has changed by more than
    YIELDED."""
    if damage is None or not damage.set_lengths:
        return 0
    yielded = np.abs(damage.set_lengths) > YIELDED * rest_lengths
    yielded[list(damage.broken)] = False
    return int(np.count_nonzero(yielded))


def encode_plan(generation: int, sketch: Sketch, rest_angles: Floats) -> NDArray[np.float32]:
    """Encode the plan of a body.

    Args:
        generation: number of the plan, which its frames have too.
        sketch: its drawing.
        rest_angles: (J,) degrees, without the shift of the arrow keys.
    """
    mapping = sketch.mapping
    head = (
        generation,
        mapping.scale,
        *mapping.center,
        mapping.flip,
        sketch.many,
        sketch.bars,
        sketch.slices,
        -1 if sketch.driven is None else sketch.driven,
    )
    surroundings = _surroundings(sketch, sketch.environment) if sketch.environment is not None else {}
    muscles = len(sketch.muscles)
    return Plan.pack(
        head=head,
        radius=sketch.radius,
        springs=sketch.springs,
        rest_length=sketch.rest_length,
        thickness=sketch.thickness,
        full_strain=sketch.full_strain,
        joints=np.column_stack((sketch.joint_a, sketch.joint_b, sketch.joint_mass, sketch.joint_sense)),
        rest_angle=rest_angles,
        pinned=sketch.pinned,
        mass_colors=sketch.mass_colors(),
        strain_colors=strain_colors(sketch),
        turn_colors=turn_colors(sketch),
        ink_colors=sketch.ink_colors(),
        **surroundings,
        rails=sketch.rails,
        ropes=sketch.ropes,
        buffers=sketch.buffers,
        stops=sketch.stops,
        loads=sketch.loads,
        muscles=(*sketch.beat, *sketch.muscles.ravel()) if muscles else (),
        muscle_colors=muscle_colors(sketch) if muscles else (),
        resists=(sketch.medium, sketch.ground) if sketch.medium or sketch.ground else (),
        motors=sketch.motors,
        pushes=sketch.pushes,
    )


def encode_frame(generation: int, picture: Picture) -> NDArray[np.float32]:
    """Encode a frame.

    Args:
        generation: number of the plan.
        picture: the picture.
    """

    def moment(body: Picture) -> tuple[float, float, float, float]:
        # After a day, times in single precision are 8 ms apart.
        left = body.time - float(np.float32(body.time))
        return body.time, body.rest_length_scale, body.rest_angle_shift, left

    second = picture.second
    return Frame.pack(
        moment=(generation, *moment(picture)),
        positions=picture.positions,
        ghost=picture.ghost if picture.ghost is not None else (),
        second_moment=moment(second) if second is not None else (),
        second_positions=second.positions if second is not None else (),
        efforts=picture.efforts,
        second_efforts=second.efforts if second is not None else (),
    )


def encode_damage(generation: int, picture: Picture) -> NDArray[np.float32]:
    """Encode the damage of a picture.

    Args:
        generation: number of the plan.
        picture: the picture.
    """
    own = picture.damage or Damage()
    other = (picture.second.damage if picture.second is not None else None) or Damage()
    return to_page.Damage.pack(
        head=[generation],
        broken=own.broken,
        set_length=own.set_lengths,
        set_angle=own.set_angles,
        ghost_broken=picture.ghost_broken,
        second_broken=other.broken,
        second_set_length=other.set_lengths,
        second_set_angle=other.set_angles,
    )


def _surroundings(sketch: Sketch, environment: Any) -> dict[str, ArrayLike]:
    """The sections of walls, fillings, wind and contact."""
    loops: list[float] = []
    fillings, air = environment.fillings, environment.air
    for filling, loop in zip(fillings.rows, fillings.loops(), strict=True):
        loops += [FillingRow(*filling).is_gas, len(loop), *loop]
    blows = math.hypot(air.wind_x, air.wind_y) >= STILL_AIR
    return {
        "walls": environment.walls.rows[:, :4],  # points and normals
        "belts": belts(sketch, environment.walls.rows),
        "fillings": loops,
        "wind": (air.wind_x, air.wind_y, *air.waves[:, :-1].ravel()) if blows else (),
        "contact_of": [sketch.contact] if sketch.contact else (),
    }


def belts(sketch: Sketch, walls: Floats) -> Floats:
    """(W,) the speed of each wall's surface as it is seen, px/s, or (0,) if none runs; along the normal
    turned by a quarter from right to down."""
    speeds = -sketch.mapping.flip * walls[:, WallRow._fields.index("belt")]
    return speeds if speeds.any() else np.zeros(0)


def strain_colors(sketch: Sketch) -> NDArray[np.uint8]:
    """(2 k + 1, 3) from full compression by rest to full stretch."""
    part = np.linspace(1.0, 0.0, _STRAIN_SHADES + 1)
    colors = sketch.palette
    pushed, pulled = blend(colors.rest, colors.pushed, part), blend(colors.rest, colors.pulled, part)
    return sketch.encode(np.vstack((pushed, pulled[-2::-1])))


def muscle_colors(sketch: Sketch) -> NDArray[np.uint8]:
    """(k, 3) of a muscle at its longest to one at its shortest."""
    colors = sketch.palette
    return sketch.encode(blend(colors.paper, colors.muscle, np.linspace(*_BREATH, _TURN_SHADES)))


def turn_colors(sketch: Sketch) -> NDArray[np.uint8]:
    """(2 k + 1, 3) from the full negative deviation to the full positive one."""
    part = np.maximum(np.linspace(1.0, 0.0, _TURN_SHADES + 1), _PALEST)
    colors = sketch.palette
    minus, plus = (blend(colors.paper, full, part) for full in (colors.torque_minus, colors.torque_plus))
    return sketch.encode(np.vstack((minus, plus[-2::-1])))
