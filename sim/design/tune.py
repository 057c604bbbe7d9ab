"""Change stiffness and damping so that a scene is stable at a time step, or critically damped."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
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
from ..errors import InputError, SettingError, no_part, of_field
from ..forces.words import CAUSES
from ..model.system import same_topology
from ..motion.divergence import Divergence
from ..motion.simulation import Simulation
from ..motion.stability import limit_at_start
from ..scene.parts import AngularSpring, LinearSpring
from ..scene.types import Method, Scene
from ..scene.validate import number_range, validate
from ..solve.registry import METHODS
from ..text import Text

_MARGIN = 1.01
"""Factor by which the stability limit must exceed the time step: its estimate is accurate to 1 %. At 1.005 or
1.02, `test_a_spring_alone_keeps_what_the_step_bears` fails."""
# Unless noted, doubling or halving one of these numbers fails no test.
_SOFTEST = 1e-6
"""Smallest cap tried, see `make_stable`."""
_CLOSE = 1.002
"""Ratio of caps at which the search ends."""
_SECONDS, _MAX_STEPS = 1.0, 2000
"""Longest test run, s and steps."""
_LOWER = 0.8
"""Factor of the cap after a test run that diverges."""
_HALVINGS = 12
"""Number of bisections in the search for the largest damping that is stable at a time step."""
_MIN_HOLD = 1e-6
"""Share of springs or joints in a vibration's stiffness below which they cannot damp it."""


P = TypeVar("P", LinearSpring, AngularSpring)


def with_numbers(scene: Scene, numbers: Numbers) -> Scene:
    """Return the scene with these numbers; parts whose numbers do not change stay the same objects."""
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
    """Return the scene with the smallest change that makes it stable at a time step.

    The smallest change is one common cap, as high as possible, on the demand that each spring and joint by
    itself makes on the time step: dt² stiffness / mu, and w dt damping / mu, where mu is its reduced mass,
    see `sim.tuning`, and w is 2 for symplectic Euler and 4 for velocity Verlet. Stiffness and damping above
    the cap are lowered to it independently of each other; all other numbers and parts stay unchanged. The cap
    is the highest at which the limit of `sim.motion.stability` at the scene's start is 1 % above the time
    step, to within 0.2 %.

    The body is then run for 1 s or 2000 steps, whichever is shorter. Large motions may diverge where small
    ones do not; the cap is then lowered by a fifth until the body stays stable.

    Args:
        scene: a valid scene. Its pose, if it has one, is its start.
        dt: 1e-6..1 s; None for the scene's own.
        method: None for the scene's own.

    Returns:
        The scene with this time step and method. It is the same object if these are its own and it is stable.
        Where the method has no limit, nothing else is changed. A body made by a recipe is replaced by its
        parts.

    Raises:
        SceneError: the scene, the time step or the method is not valid.
        InputError: something other than springs and joints limits the time step, or the body diverges even
            with soft ones.
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
        return with_numbers(scene, Numbers(*map(np.minimum, own, limits)))

    loads = np.concatenate([of * number for of, number in zip(asked, own, strict=True)])
    high, low = float(loads.max(initial=0.0)), _SOFTEST
    if high <= low or not _is_calm(capped(low)):
        raise InputError(
            Text(
                "{where}: at {step:g} s it is not springs and joints that limit the time step, but {cause}",
                where="make_stable",
                step=step,
                cause=_cause(capped(low)),
            )
        )
    while not calm and high > _CLOSE * low:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if _is_calm(capped(middle)) else (low, middle)
    cap = high if calm else low
    found = capped(cap)
    while (runs_away := _runs_away(found)) is not None and cap * _LOWER >= _SOFTEST:
        cap *= _LOWER
        found = capped(cap)
    if runs_away is None:
        return found
    raise InputError(
        Text(
            "{where}: at {step:g} s the body runs away from its start, however soft its springs: {reason}",
            where="make_stable",
            step=step,
            reason=runs_away.reason,
        )
    )


def damp_vibration(scene: Scene, mode: int | None = None, spring: int | None = None) -> Scene:
    """Return the scene with a vibration of the whole body, or a single spring, critically damped.

    The damping of a single spring becomes 2 sqrt(stiffness mu), where mu is its reduced mass.

    For a vibration, either the springs or the joints get damping in proportion to their stiffness, whichever
    then damp it more, so that other dampings can stay and no more parts than necessary are heavily damped.
    The damping ratio in `sim.tuning` becomes 1. All faster vibrations become overdamped, which lowers the
    largest stable time step of explicit methods.

    Args:
        scene: a valid scene.
        mode: index of the vibration about the pose at rest, 0 for the slowest; None for the slowest with more
            than half of its stiffness from springs and joints. This excludes swings under gravity, which they
            hardly damp.
        spring: index of a linear spring, instead of a vibration.

    Returns:
        The scene. A body made by a recipe is replaced by its parts.

    Raises:
        SceneError: the scene is not valid.
        InputError: there is no such spring or vibration, the body has more than 1000 masses, or the damping
            needed is out of range.
    """
    validate(scene)
    if spring is not None:
        return _with_damped(scene, (spring,))
    own = Numbers.of(scene)
    if mode is not None and (isinstance(mode, bool) or not isinstance(mode, int) or mode < 0):
        raise InputError(
            Text(
                "{where}: {mode} is not the number of a vibration, from 0", where="damp_vibration", mode=mode
            )
        )
    resting, found = vibrations_at_rest(scene, MAX_VIBRATIONS if mode is None else mode + 1)
    if mode is not None and mode >= len(found.omega):
        raise InputError(
            Text(
                "{where}: the body has no vibration {mode}, but {count}",
                where="damp_vibration",
                mode=mode,
                count=len(found.omega),
            )
        )
    dampers = Dampers(resting)
    for omega, shape in list(zip(found.omega.tolist(), found.shapes, strict=True))[mode or 0 :]:
        hold = dampers.hold(omega, shape)
        if hold.is_elastic or (mode is not None and max(hold.springs, hold.joints) > _MIN_HOLD):
            return with_numbers(scene, _damped(own, dampers, omega, shape, hold))
    raise InputError(
        Text(
            "{where}: springs and joints hold no such vibration, so they cannot damp it",
            where="damp_vibration",
        )
    )


def _damped(own: Numbers, dampers: Dampers, omega: float, shape: Floats, hold: Hold) -> Numbers:
    """Return the numbers with which the damping ratio of a vibration is 1."""
    left = 1.0 - hold.around
    if not left > 0.0:
        raise InputError(
            Text(
                "{where}: the vibration is damped critically without springs and joints",
                where="damp_vibration",
            )
        )
    by_joints = hold.joints > hold.springs
    springs, joints = own.damping, own.joint_damping
    other = dampers.ratio(omega, shape, springs) if by_joints else dampers.ratio(omega, shape, None, joints)
    other -= hold.around
    # If the other kind alone damps too much, it is lowered and this one gets none.
    lower, rest = min(1.0, left / other) if other > 0.0 else 1.0, max(0.0, left - other)
    if by_joints:
        springs, joints = lower * springs, rest / hold.joints * (2.0 / omega) * own.joint_stiffness
    else:
        springs, joints = rest / hold.springs * (2.0 / omega) * own.stiffness, lower * joints
    return own._replace(damping=_allowed(springs), joint_damping=_allowed(joints))


def damp_springs(scene: Scene, springs: Collection[int]) -> Edit:
    """Return an edit that critically damps each of some springs by itself, see `damp_vibration`.

    Raises:
        InputError: as `damp_vibration`.
    """
    return Edit(f"{counted(len(springs), 'spring')} critically damped", _with_damped(scene, springs))


def as_far_as_stable(scene: Scene, damped: Scene) -> Scene:
    """Return the scene with its dampings changed towards those of another as far as it stays stable.

    Args:
        scene: a valid scene.
        damped: the same scene with other dampings.

    Raises:
        InputError: the time step is too long for the scene as it is.
    """
    own, other = Numbers.of(scene), Numbers.of(damped)

    def part(of_way: float) -> Scene:
        numbers = own._replace(
            damping=own.damping + of_way * (other.damping - own.damping),
            joint_damping=own.joint_damping + of_way * (other.joint_damping - own.joint_damping),
        )
        return with_numbers(scene, numbers)

    if not is_limited(scene.integrator.method) or _is_calm(damped):
        return damped
    if not _is_calm(scene):
        raise InputError(
            Text(
                "{where}: a time step of {step:g} s is too long for the body as it is",
                where="damping",
                step=scene.integrator.dt,
            )
        )
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _is_calm(part(middle)) else (low, middle)
    return part(low)


def edit_of(change: Callable[[Scene], Scene], origin: Scene, scene: Scene, label: str) -> Edit:
    """Return an edit that gives a scene stiffnesses and dampings that were found for another moment of it.

    Args:
        change: gives a scene of the same parts these numbers.
        origin: the scene for which they were found: `scene` at another moment.
        scene: the scene to edit.
        label: describes the edit.

    Raises:
        SettingError: the parts, stiffnesses or dampings of `scene` differ from those of `origin`.
    """
    same = same_topology(origin, scene) and all(map(np.array_equal, Numbers.of(origin), Numbers.of(scene)))
    if not same:
        raise SettingError(
            Text("{label}: the body was changed meanwhile, so that it is not that one any more", label=label)
        )
    return Edit(label, change(scene))


def _with_damped(scene: Scene, springs: Collection[int]) -> Scene:
    own, softness = Numbers.of(scene), inverse_reduced_masses(scene)[0]
    damping, broken = own.damping.copy(), broken_parts(scene)[0]
    for spring in springs:
        if isinstance(spring, bool) or not isinstance(spring, int) or not 0 <= spring < len(softness):
            raise InputError(of_field("damp_vibration", no_part("spring", spring, len(softness))))
        if spring in broken:
            raise InputError(
                Text(
                    "{where}: spring {spring} is broken, so it cannot vibrate",
                    where="damp_vibration",
                    spring=spring,
                )
            )
        if not softness[spring] > 0.0:
            raise InputError(
                Text(
                    "{where}: both masses of spring {spring} are held, so it cannot vibrate",
                    where="damp_vibration",
                    spring=spring,
                )
            )
        damping[spring] = 2.0 * math.sqrt(float(own.stiffness[spring] / softness[spring]))
    return with_numbers(scene, own._replace(damping=_allowed(damping)))


def _allowed(damping: Floats) -> Floats:
    most = number_range(LinearSpring, "damping")[1]
    if damping.size and not damping.max() <= most:
        raise InputError(
            Text(
                "{where}: it would take a damping of {damping:.3g} kg/s, and {most:g} is the most",
                where="damp_vibration",
                damping=damping.max(),
                most=most,
            )
        )
    return damping


def is_limited(method: Method) -> bool:
    """Return whether springs and joints limit the time step of a method."""
    return METHODS[method].limit is not None and method != "stable_spring"


def _is_calm(scene: Scene) -> bool:
    method, dt = scene.integrator.method, scene.integrator.dt
    return limit_at_start(scene, method).limit >= _MARGIN * dt


def _cause(scene: Scene) -> str:
    cause = limit_at_start(scene, scene.integrator.method).cause
    return CAUSES[cause] if cause else Text("something else")


def _runs_away(scene: Scene) -> Divergence | None:
    """Return why a body diverges in a test run; None if it does not."""
    simulation = Simulation(scene)
    simulation.step(min(math.ceil(_SECONDS / scene.integrator.dt), _MAX_STEPS))
    return simulation.divergence
