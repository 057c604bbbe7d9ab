"""Rest lengths and rest angles with which a body is at rest in its present pose."""

from __future__ import annotations

import math
from collections.abc import Iterator

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..analysis.equilibrium import NEUTRAL, NEUTRAL_FREE, StaticModel
from ..edit.build import wrapped_degrees
from ..edit.edit import Selection, of_parts
from ..errors import InputError, SceneError, of_field
from ..forces.touch.walls import WallRow, place_along
from ..motion.moment import Moment
from ..scene.parts import AngularSpring
from ..scene.types import Pose, Scene
from ..scene.validate import validate
from ..text import Text
from .statics import Bools, Floats, Indices, Statics, Touch, Vectors

# Unless noted, doubling or halving one of these numbers fails no test.
_TOUCHES = 1e-6
"""Distance from a wall, as a fraction of a typical spring's length, within which a mass touches it."""
_SINKINGS = 60
"""Largest number of times that masses are repositioned in walls."""
_SUNK = 1e-14
"""Movement, relative to the largest coordinate, at which that ends."""
_LIGHTER = 40
"""Largest number of times that overloaded parts are relieved."""
_MAX_FOR_PROGRAM = 1500
"""Largest number of masses for the linear program, whose run time grows faster than their square."""
_TAUT = (0.01, 0.03, 0.1, 0.2, 0.4)
"""Tensions, as fractions of stiffness times length, tried for springs where the body would buckle."""
_ITERATIONS = 30
"""Number of inverse iterations that find a motion."""
_ALIKE = 1e-3
"""Difference, relative to the largest movement, up to which a motion is a rotation."""
_STIFFEST = 1e3
"""Largest factor by which a body is stiffened."""
_FINE = 1.01
"""Ratio between a sufficient and an insufficient factor at which the search ends. At 2,
`test_a_mast_buckles_at_eulers_load_and_stands_with_the_stiffness_that_is_named` fails."""


_KEEP_SHAPE = Text("keep shape")


class DesignError(InputError):
    """The requested design is impossible. The message is one sentence that names the part.

    Attributes:
        sentence: the message without the name of the operation, and without a full stop.
        motion: (n, 2) how the masses would move, relative to the largest movement; None if the obstacle is
            not a motion.
        stiffening: factor of all stiffness with which it would be possible, or None.
    """

    def __init__(
        self,
        sentence: str,
        motion: NDArray[np.float64] | None = None,
        stiffening: float | None = None,
        of: str = _KEEP_SHAPE,
    ) -> None:
        super().__init__(of_field(of, sentence))
        self.sentence, self.motion, self.stiffening = sentence, motion, stiffening


def keep_shape(scene: Scene, parts: Selection | None = None, allow_stiffening: bool = False) -> Scene:
    """Return the scene with rest lengths and rest angles such that its pose is at rest.

    Gravity, constant forces, the mean wind, fillings, walls and contact are balanced in the pose as it is.
    Masses that only touch a wall sink into it as far as necessary. The solution is the one that deforms
    springs and joints least; where that would buckle, one in which springs are under more tension. See
    `statics` for the equations. Masses, damping and stiffness stay unchanged.

    Args:
        scene: a valid scene. The pose is its own, or the masses' own positions.
        parts: the springs and joints that may change; None for all.
        allow_stiffening: whether the parts that change may also become stiffer, all by the smallest factor
            that helps, where nothing else does.

    Returns:
        The scene, with the pose at rest.

    Raises:
        SceneError: the scene is not valid.
        DesignError: there is no such scene.
    """
    scene = of_parts(validate(scene))
    springs, joints = (np.zeros(len(each), bool) for each in (scene.linear_springs, scene.angular_springs))
    if parts is None:
        springs[:] = joints[:] = True
    else:
        springs[list(parts.springs)] = joints[list(parts.joints)] = True
    positions = scene.pose.positions if scene.pose else [mass.position for mass in scene.masses]
    at = np.array(positions, float).reshape(-1, 2).view(np.complex128).ravel()
    body = StaticModel(scene, balanced=True)
    statics, x = _balance(body, at, springs, joints)
    if x is None:
        raise _unheld(statics, parts is not None)
    x, stiffening, over = _within_bounds(statics, x)
    if stiffening > 1.0 and not allow_stiffening:
        raise _overloaded(statics, over, stiffening)
    best = _with_rest(scene, statics, x, stiffening)
    shape = _buckling(best)
    if shape is None:
        return best
    for tighter in _tighter(statics, x) if stiffening == 1.0 else ():
        made = _with_rest(scene, statics, tighter, 1.0)
        if _buckling(made) is None:
            return made
    return _stiff_enough(scene, statics, x, stiffening, shape, allow_stiffening)


def keep_shape_at(moment: Moment, parts: Selection | None = None, allow_stiffening: bool = False) -> Scene:
    """As `keep_shape`, for the pose at a moment, including what keys have changed until then."""
    scene, shift = of_parts(moment.scene), moment.rest_angle_shift
    still = tuple((0.0, 0.0) for _ in scene.masses)
    places = tuple((float(x), float(y)) for x, y in moment.positions)
    here = msgspec.structs.replace(
        scene,
        rest_length_scale=moment.rest_length_scale,
        angular_springs=_turned(scene, shift),
        pose=Pose(positions=places, velocities=still, damage=moment.damage, grips=moment.grips),
    )
    kept = keep_shape(here, parts, allow_stiffening)
    return msgspec.structs.replace(
        kept, rest_length_scale=scene.rest_length_scale, angular_springs=_turned(kept, -shift)
    )


def _turned(scene: Scene, shift: float) -> tuple[AngularSpring, ...]:
    """Return the scene's joints with rest angles turned by some degrees."""
    if not shift:
        return scene.angular_springs
    return tuple(
        msgspec.structs.replace(joint, rest_angle=wrapped_degrees(joint.rest_angle + shift))
        for joint in scene.angular_springs
    )


# ------------------------------------------------------------------------- the balance
def _balance(body: StaticModel, at: Vectors, springs: Bools, joints: Bools) -> tuple[Statics, Floats | None]:
    """Return the balance in a pose, and the loads on springs and joints in it; None if there is none.

    In that case masses that touch walls are set into them as deep as the necessary push requires, if that
    helps. The push is an unknown; where the wall would have to pull, the mass does not touch it after all.
    The friction that holds masses along walls is an unknown, too, up to its limit.
    """
    statics = Statics(body, at, springs, joints, Touch.none())
    x = statics.without_slack(statics.solve(statics.stiffness))
    touch = _touching(body, at)
    here = at
    for _ in range(_SINKINGS):
        if x is not None or not touch.mass.size:
            break
        trial = Statics(body, here, springs, joints, touch)
        borne = trial.without_slack(trial.solve(trial.stiffness))
        if borne is None:
            break
        pushes = borne[borne.size - touch.mass.size :]
        pulls = (pushes < 0.0) & ~touch.along
        if pulls.any():
            touch = touch.without(pulls)
            continue
        moved = _set_into_walls(body, here, touch, pushes)
        _hold_along_walls(body, moved, touch, pushes)
        change = float(np.abs(moved - here).max())
        here = moved
        if change <= _SUNK * float(np.abs(here).max()):
            sunk = Statics(body, here, springs, joints, Touch.none())
            return sunk, sunk.without_slack(sunk.solve(sunk.stiffness))
    return statics, x


def _touching(body: StaticModel, at: Vectors) -> Touch:
    """Return the free masses that touch a wall or are in one, with the forces that it can exert."""
    free = body.state.inverse_mass[body.system.mass_index] > 0.0
    masses: list[Indices] = []
    walls: list[Indices] = []
    ways: list[Vectors] = []
    along: list[Bools] = []
    for row, numbers in enumerate(body.tables.environment.walls.rows):
        wall = WallRow(*numbers)
        normal = complex(wall.nx, wall.ny)
        depth = ((complex(wall.x, wall.y) - at) * normal.conjugate()).real + _size(body)
        here = np.flatnonzero(free & (depth >= -_TOUCHES * body.typical))
        for way, is_along in ((normal, False), (1j * normal, True))[: 2 if wall.tangential else 1]:
            masses.append(here)
            walls.append(np.full(here.size, row))
            ways.append(np.full(here.size, way))
            along.append(np.full(here.size, is_along))
    if not masses:
        return Touch.none()
    columns = np.concatenate(masses), np.concatenate(walls), np.concatenate(ways), np.concatenate(along)
    return Touch(*columns)


def _size(body: StaticModel) -> Floats:
    """Return (n,) px, the radius of each solid mass, 0 of any other, where there are walls."""
    return body.tables.environment.walls.size[body.system.mass_index]


def _set_into_walls(body: StaticModel, at: Vectors, touch: Touch, pushes: Floats) -> Vectors:
    """Return the positions with each touching mass at the depth where its wall has this push, kg px/s²."""
    moved = at.copy()
    for row, numbers in enumerate(body.tables.environment.walls.rows):
        wall, here = WallRow(*numbers), (touch.wall == row) & ~touch.along
        masses, normal = touch.mass[here], complex(wall.nx, wall.ny)
        weights = np.array([body.scene.masses[i].mass for i in masses])
        depth = ((complex(wall.x, wall.y) - moved[masses]) * normal.conjugate()).real + _size(body)[masses]
        moved[masses] += (depth - np.sqrt(pushes[here] / (weights * wall.hardness))) * normal
    return moved


def _hold_along_walls(body: StaticModel, at: Vectors, touch: Touch, forces: Floats) -> None:
    """Stretch the tangential springs of touching masses so that they hold with these forces, kg px/s²."""
    state, slot = body.state, body.system.mass_index
    for row, numbers in enumerate(body.tables.environment.walls.rows):
        wall, here = WallRow(*numbers), (touch.wall == row) & touch.along
        masses = touch.mass[here]
        weights = np.array([body.scene.masses[i].mass for i in masses])
        if masses.size:
            state.wall_stretch[row, slot[masses]] = -forces[here] / (weights * wall.tangential)
            here = place_along(numbers, at[masses].real, at[masses].imag)
            state.wall_place[row, slot[masses]] = here


# ------------------------------------------------------------------------- limits of loads
def _within_bounds(statics: Statics, x: Floats) -> tuple[Floats, float, Floats]:
    """Return loads on springs and joints within their limits; the factor of stiffness that this takes, 1 for
    none; and each load over its limit.

    Overloaded parts are weighted as softer and softer in the sum that is minimised. If that does not help, a
    linear program finds the solution that minimises the largest load over its limit; for a large body, the
    best previous solution is used instead.
    """
    stiffness, best, least = statics.stiffness.copy(), x, np.inf
    for _ in range(_LIGHTER):
        share = statics.share(x)
        most = float(share.max(initial=0.0))
        if most < least:
            best, least = x, most
        if most <= 1.0:
            return x, 1.0, share
        stiffness = stiffness / np.maximum(share, 1.0)
        lighter = statics.solve(stiffness)
        if lighter is None:
            break
        x = lighter
    if statics.at.size <= _MAX_FOR_PROGRAM:
        even = statics.most_even()
        # The program may load all parts as much as the most loaded one, even without need.
        if even is not None and float(statics.share(even).max()) < least * (1.0 - _ALIKE):
            best = even
    share = statics.share(best)
    return best, max(1.0, float(share.max())), share


def _tighter(statics: Statics, x: Floats) -> Iterator[Floats]:
    """Yield solutions in which springs are under more and more tension, as far as there are any."""
    for taut in _TAUT:
        target = np.where(statics.is_spring, taut * statics.most, x)
        tighter = statics.solve(statics.stiffness, target)
        if tighter is not None and (statics.share(tighter) <= 1.0).all():
            yield tighter


def _stiff_enough(
    scene: Scene, statics: Statics, x: Floats, stiffening: float, shape: Floats, allowed: bool
) -> Scene:
    """Return the scene with the parts that change just stiff enough that it does not buckle.

    Raises:
        DesignError: stiffening is not allowed, or does not help.
    """
    low = high = stiffening
    made = None
    while made is None and high < _STIFFEST:
        low, high = high, 2.0 * high
        made = _standing(scene, statics, x, high)
    if made is None:
        raise DesignError(
            Text("it would buckle at mass {mass}, however stiff it is", mass=_most_moved(shape)), shape
        )
    while high > _FINE * low:
        middle = math.sqrt(low * high)
        stands = _standing(scene, statics, x, middle)
        low, high, made = (middle, high, made) if stands is None else (low, middle, stands)
    if allowed:
        return made
    raise DesignError(
        Text(
            "it would buckle at mass {mass}; with {high:.3g} times the stiffness it stands",
            mass=_most_moved(shape),
            high=high,
        ),
        shape,
        high,
    )


def _standing(scene: Scene, statics: Statics, x: Floats, stiffening: float) -> Scene | None:
    """Return the scene with some factor of stiffness; None if it buckles or a stiffness is out of range."""
    try:
        made = _with_rest(scene, statics, x, stiffening)
    except SceneError:
        return None
    return made if _buckling(made) is None else None


def _most_moved(motion: Floats) -> int:
    return int(np.argmax(np.hypot(*motion.T)))


# ------------------------------------------------------------------------- rest lengths and rest angles
def _with_rest(scene: Scene, statics: Statics, x: Floats, stiffening: float) -> Scene:
    """Return the scene in which springs and joints have the given loads, in closed form."""
    lengths, angles = statics.rest(x, stiffening)
    damage = scene.pose.damage if scene.pose else None
    if damage is not None and damage.set_lengths:
        lengths = lengths - np.array(damage.set_lengths)
    if damage is not None and damage.set_angles:
        angles = angles - np.array(damage.set_angles)
    lengths = lengths / scene.rest_length_scale
    springs, joints = list(scene.linear_springs), list(scene.angular_springs)
    for s in np.flatnonzero(statics.springs).tolist():
        old = springs[s]
        stiffness = old.stiffness * stiffening
        springs[s] = msgspec.structs.replace(old, rest_length=float(lengths[s]), stiffness=stiffness)
    for j in np.flatnonzero(statics.joints).tolist():
        old = joints[j]
        stiffness = old.stiffness * stiffening
        joints[j] = msgspec.structs.replace(
            old, rest_angle=wrapped_degrees(float(angles[j])), stiffness=stiffness
        )
    pose = Pose(
        positions=tuple(zip(statics.at.real.tolist(), statics.at.imag.tolist(), strict=True)),
        velocities=((0.0, 0.0),) * statics.at.size,
        damage=damage,
        grips=statics.grips,
    )
    return validate(
        msgspec.structs.replace(
            scene, linear_springs=tuple(springs), angular_springs=tuple(joints), pose=pose
        )
    )


# ------------------------------------------------------------------------- stability
def _buckling(scene: Scene) -> Floats | None:
    """Return (n, 2) the motion by which a balanced body leaves its pose, relative to the largest movement;
    None if it is stable."""
    body = StaticModel(scene, balanced=True)
    neutral = NEUTRAL if body.system.held.any() else NEUTRAL_FREE
    if body.factorise(body.start, neutral):
        return None
    # The smallest shift that makes the matrix positive definite is minus its lowest eigenvalue, and inverse
    # iteration with a shift just above it converges to the motion of that eigenvalue.
    low, high = neutral, 1e-9
    while not body.factorise(body.start, high):
        low, high = high, 4.0 * high
    while high > _FINE * low:
        middle = math.sqrt(low * high)
        low, high = (low, middle) if body.factorise(body.start, middle) else (middle, high)
    body.factorise(body.start, high)
    motion = body.nudge(np.zeros_like(body.start), 1.0)
    for _ in range(_ITERATIONS):
        motion = body.solve(motion)
        motion /= np.abs(motion).max()
    return _relative(np.column_stack(body.by_mass(motion)))


def _relative(motion: Floats) -> Floats:
    return motion / np.hypot(*motion.T).max()


# ------------------------------------------------------------------------- refusals
def _overloaded(statics: Statics, share: Floats, stiffening: float) -> DesignError:
    """Return the error for overloaded springs or joints."""
    over = np.flatnonzero(share > 1.0)
    worst = int(over[np.argmax(share[over])])
    word, index = statics.name_of(worst)
    rest, times = int(over.size) - 1, float(share[worst])
    if word == "spring":
        why = Text("spring {index} would need {times:.3g} times its stiffness", index=index, times=times)
    else:
        why = Text("joint {index} would need {times:.3g} times its stiffness", index=index, times=times)
    if rest == 1:
        why = Text("{error}, and 1 other up to as much", error=why)
    elif rest:
        why = Text("{error}, and {rest} others up to as much", error=why, rest=rest)
    return DesignError(why, stiffening=stiffening)


def _unheld(statics: Statics, are_some: bool) -> DesignError:
    """Return the error where no forces of springs and joints, or of some of them, balance the others."""
    motion = statics.mechanism()
    first = int(np.argmax(np.abs(motion)))
    if are_some:
        return DesignError(
            Text("what is selected cannot balance mass {mass}: select more springs and joints", mass=first)
        )
    part = statics.connected(first)
    held = part & ~statics.free
    shape = _relative(np.column_stack((motion.real, motion.imag)))
    if not held.any():
        return DesignError(
            Text("nothing holds mass {mass}: hold a mass that is connected to it", mass=first), shape
        )
    about = int(np.flatnonzero(held)[0])
    arms = (statics.at - statics.at[about])[part]
    turn = (arms.conj() @ motion[part]) / max(float((abs(arms) ** 2).sum()), 1e-300)
    rest = np.abs(motion[part] - 1j * turn.imag * arms).max()
    if held.sum() == 1 and rest <= _ALIKE * np.abs(motion).max():
        return DesignError(
            Text(
                "nothing keeps it from turning about mass {mass}: hold a second mass or add a joint",
                mass=about,
            ),
            shape,
        )
    return DesignError(
        Text("nothing keeps mass {mass} in its place: add a spring or a joint there", mass=first), shape
    )
