"""Scenes with other stiffnesses and dampings: stable at a time step, or critically damped."""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import TypeVar

import numpy as np
from msgspec.structs import replace

from ..analysis.tuning import (
    MAX_VIBRATIONS,
    Dampers,
    Hold,
    Numbers,
    broken_parts,
    inverse_reduced_masses,
    vibrations_at_rest,
)
from ..edit.edit import Edit, counted, of_parts
from ..engine.tables import Floats
from ..errors import InputError, SettingError
from ..model.system import same_topology
from ..motion.divergence import Divergence
from ..motion.simulation import Simulation
from ..motion.stability import Cause, limit_at_start
from ..scene.parts import AngularSpring, LinearSpring
from ..scene.types import Method, Scene
from ..scene.validate import number_range, validate
from ..solve.registry import METHODS

_MARGIN = 1.01
"""By how much the limit is to exceed the time step: it is estimated within a per cent."""
_SOFTEST = 1e-6
"""The smallest cap that is tried, see `make_stable`."""
_CLOSE = 1.002
"""Ratio of caps at which the search ends."""
_SECONDS, _MAX_STEPS = 1.0, 2000
"""How long it is run, s and steps."""
_LOWER = 0.8
"""Factor of the cap after a run that did not end well."""
_HALVINGS = 12
"""Number of halvings in the search for the largest damping that a time step bears."""
_MIN_HOLD = 1e-6
"""Part of a vibration's stiffness that is of springs or joints, below which they do not hold it."""


P = TypeVar("P", LinearSpring, AngularSpring)


def _with_numbers(scene: Scene, numbers: Numbers) -> Scene:
    """The scene with these numbers; parts whose numbers are the same stay the same objects."""
    scene = of_parts(scene)
    return replace(
        scene,
        linear_springs=_tuned(scene.linear_springs, numbers.stiffness, numbers.damping),
        angular_springs=_tuned(scene.angular_springs, numbers.joint_stiffness, numbers.joint_damping),
    )


def _tuned(parts: tuple[P, ...], stiffness: Floats, damping: Floats) -> tuple[P, ...]:
    return tuple(
        part if (part.stiffness, part.damping) == (k, c) else replace(part, stiffness=k, damping=c)
        for part, k, c in zip(parts, stiffness.tolist(), damping.tolist(), strict=True)
    )


def make_stable(scene: Scene, dt: float | None = None, method: Method | None = None) -> Scene:
    """The scene with the least change that makes it stable at a time step.

    The least change is one common cap, as high as can be. It is a cap of what each spring and each joint asks
    of the time step by itself: dt² stiffness / mu, and w dt damping / mu, where mu is its reduced mass, see
    `sim.tuning`, and w is 2 for symplectic Euler and 4 for velocity Verlet. Only what is above the cap is
    lowered to it, stiffness and damping each by itself; all other numbers, and the parts that they belong to,
    stay as they are. The cap is the highest at which the limit of `sim.motion.stability` at the scene's start
    is a per cent above the time step, within 0.2 %.

    Then the body is run for a second, or 2000 steps if those are fewer. Large motions may run away where
    small ones do not; then the cap is lowered by a fifth until the body does not.

    Args:
        scene: a valid scene. Its pose, if it has one, is its start.
        dt: 1e-6..1 s; None for the scene's own.
        method: None for the scene's own.

    Returns:
        The scene with this time step and method. It is the scene itself if these are its own and it is
        stable, and nothing but they are changed where the method has no limit. A body that a recipe made
        becomes one of its parts.

    Raises:
        SceneError: the scene, the time step or the method is not valid.
        InputError: what limits the time step are not springs and joints, or the body runs away even with soft
            ones.
    """
    integrator = scene.integrator
    if dt is not None and dt != integrator.dt:
        integrator = replace(integrator, dt=dt)
    if method is not None and method != integrator.method:
        integrator = replace(integrator, method=method)
    if integrator is not scene.integrator:
        scene = replace(scene, integrator=integrator)
    validate(scene)
    rule = METHODS[integrator.method].limit
    if rule is None or not is_limited(integrator.method):
        return scene
    calm = _is_calm(scene)
    if calm and _runs_away(scene) is None:
        return scene
    own, step = Numbers.of(scene), integrator.dt
    springs, joints = inverse_reduced_masses(scene)
    asked = Numbers(
        step**2 * springs, rule.damping * step * springs, step**2 * joints, rule.damping * step * joints
    )

    def capped(cap: float) -> Scene:
        with np.errstate(divide="ignore"):
            limits = [cap / each for each in asked]
        return _with_numbers(scene, Numbers(*map(np.minimum, own, limits)))

    loads = np.concatenate([of * number for of, number in zip(asked, own, strict=True)])
    high, low = float(loads.max(initial=0.0)), _SOFTEST
    if high <= low or not _is_calm(capped(low)):
        raise InputError(
            f"make_stable: at {step:g} s it is not springs and joints that limit the time step, but "
            f"{_cause(capped(low)) or 'something else'}"
        )
    while not calm and high > _CLOSE * low:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if _is_calm(capped(middle)) else (low, middle)
    cap = high if calm else low
    reason = ""
    while cap >= _SOFTEST:
        found = capped(cap)
        runs_away = _runs_away(found)
        if runs_away is None:
            return found
        reason = runs_away.reason
        cap *= _LOWER
    raise InputError(
        f"make_stable: at {step:g} s the body runs away from its start, however soft its springs: {reason}"
    )


def damp_vibration(scene: Scene, mode: int | None = None, spring: int | None = None) -> Scene:
    """The scene with a vibration of the whole body, or a spring by itself, critically damped.

    For a spring by itself its damping becomes 2 sqrt(stiffness mu), where mu is its reduced mass.

    For a vibration, either the springs or the joints get damping in proportion to their stiffness, whichever
    of the two then damp it more, so that other dampings can stay and no more parts than necessary are damped
    strongly. The damping ratio in `sim.tuning` becomes 1. All faster vibrations are damped beyond that, which
    lowers the largest stable time step of explicit methods.

    Args:
        scene: a valid scene.
        mode: 0 for the slowest vibration about the pose at rest, and so on; None for the slowest that springs
            and joints hold by more than half, so that it is no swing under gravity, which they hardly damp.
        spring: index of a linear spring, instead of a vibration.

    Returns:
        The scene. A body that a recipe made becomes one of its parts.

    Raises:
        SceneError: the scene is not valid.
        InputError: there is no such spring or vibration, the body has more than 1000 masses, or no damping of
            springs and joints within its range does it.
    """
    validate(scene)
    if spring is not None:
        return _with_damped(scene, (spring,))
    own = Numbers.of(scene)
    if mode is not None and (isinstance(mode, bool) or not isinstance(mode, int) or mode < 0):
        raise InputError(f"damp_vibration: {mode} is not the number of a vibration, from 0")
    resting, found = vibrations_at_rest(scene, MAX_VIBRATIONS if mode is None else mode + 1)
    if mode is not None and mode >= len(found.omega):
        raise InputError(f"damp_vibration: the body has no vibration {mode}, but {len(found.omega)}")
    dampers = Dampers(resting)
    for omega, shape in list(zip(found.omega.tolist(), found.shapes, strict=True))[mode or 0 :]:
        hold = dampers.hold(omega, shape)
        if hold.is_elastic or (mode is not None and max(hold.springs, hold.joints) > _MIN_HOLD):
            return _with_numbers(scene, _damped(own, dampers, omega, shape, hold))
    raise InputError("damp_vibration: springs and joints hold no such vibration, so they cannot damp it")


def _damped(own: Numbers, dampers: Dampers, omega: float, shape: Floats, hold: Hold) -> Numbers:
    """The numbers with which the damping ratio of a vibration is 1."""
    left = 1.0 - hold.around
    if not left > 0.0:
        raise InputError("damp_vibration: the vibration is damped critically without springs and joints")
    by_joints = hold.joints > hold.springs
    springs, joints = own.damping, own.joint_damping
    other = dampers.ratio(omega, shape, springs) if by_joints else dampers.ratio(omega, shape, None, joints)
    other -= hold.around
    # If the other kind alone is too much, it is lowered, and this one gets none.
    lower, rest = min(1.0, left / other) if other > 0.0 else 1.0, max(0.0, left - other)
    if by_joints:
        springs, joints = lower * springs, rest / hold.joints * (2.0 / omega) * own.joint_stiffness
    else:
        springs, joints = rest / hold.springs * (2.0 / omega) * own.stiffness, lower * joints
    return own._replace(damping=_allowed(springs), joint_damping=_allowed(joints))


def damp_springs(scene: Scene, springs: Collection[int]) -> Edit:
    """An edit after which some springs, each by itself, are critically damped, see `damp_vibration`.

    Raises:
        InputError: as `damp_vibration`.
    """
    return Edit(f"{counted(len(springs), 'spring')} critically damped", _with_damped(scene, springs))


def as_far_as_stable(scene: Scene, damped: Scene) -> Scene:
    """The scene with its dampings as far on the way to those of another one as its own time step bears.

    Args:
        scene: a valid scene.
        damped: the same with other dampings.

    Raises:
        InputError: the time step is too long for the scene as it is.
    """
    own, other = Numbers.of(scene), Numbers.of(damped)

    def part(of_way: float) -> Scene:
        numbers = own._replace(
            damping=own.damping + of_way * (other.damping - own.damping),
            joint_damping=own.joint_damping + of_way * (other.joint_damping - own.joint_damping),
        )
        return _with_numbers(scene, numbers)

    if not is_limited(scene.integrator.method) or _is_calm(damped):
        return damped
    if not _is_calm(scene):
        raise InputError(
            f"damping: a time step of {scene.integrator.dt:g} s is too long for the body as it is"
        )
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _is_calm(part(middle)) else (low, middle)
    return part(low)


def with_numbers_of(tuned: Scene, origin: Scene, scene: Scene, label: str) -> Edit:
    """An edit of a scene that gives it the stiffnesses and dampings that another one got.

    Args:
        tuned: the other one.
        origin: what it was made of: the scene, at another moment.
        scene: the scene.
        label: what was done.

    Raises:
        SettingError: the scene has other parts, or other stiffnesses and dampings, than then.
    """
    before, now = Numbers.of(origin), Numbers.of(scene)
    same = same_topology(origin, scene) and all(map(np.array_equal, before, now))
    if not same:
        raise SettingError(f"{label}: the body was changed meanwhile, so that it is not that one any more")
    return Edit(label, _with_numbers(scene, Numbers.of(tuned)))


def _with_damped(scene: Scene, springs: Collection[int]) -> Scene:
    own, softness = Numbers.of(scene), inverse_reduced_masses(scene)[0]
    damping, broken = own.damping.copy(), broken_parts(scene)[0]
    for spring in springs:
        if isinstance(spring, bool) or not isinstance(spring, int) or not 0 <= spring < len(softness):
            raise InputError(f"damp_vibration: spring {spring} does not exist (0..{len(softness) - 1})")
        if spring in broken:
            raise InputError(f"damp_vibration: spring {spring} is broken, so it cannot vibrate")
        if not softness[spring] > 0.0:
            raise InputError(f"damp_vibration: both masses of spring {spring} are held, so it cannot vibrate")
        damping[spring] = 2.0 * math.sqrt(float(own.stiffness[spring] / softness[spring]))
    return _with_numbers(scene, own._replace(damping=_allowed(damping)))


def _allowed(damping: Floats) -> Floats:
    most = number_range(LinearSpring, "damping")[1]
    if damping.size and not damping.max() <= most:
        raise InputError(
            f"damp_vibration: it would take a damping of {damping.max():.3g} kg/s, and {most:g} is the most"
        )
    return damping


def is_limited(method: Method) -> bool:
    """Whether springs and joints limit the time step of a method."""
    return METHODS[method].limit is not None and method != "stable_spring"


def _is_calm(scene: Scene) -> bool:
    method, dt = scene.integrator.method, scene.integrator.dt
    return limit_at_start(scene, method).limit >= _MARGIN * dt


def _cause(scene: Scene) -> Cause | None:
    return limit_at_start(scene, scene.integrator.method).cause


def _runs_away(scene: Scene) -> Divergence | None:
    """Why a body runs away within a while; None if it does not."""
    simulation = Simulation(scene)
    simulation.step(min(math.ceil(_SECONDS / scene.integrator.dt), _MAX_STEPS))
    return simulation.divergence
