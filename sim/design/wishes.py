"""Stiffnesses and dampings with which a body behaves as wished.

The unknowns are the logarithms of two factors, for the stiffness of all springs and of all joints, and, where
those are not enough, a taper from root to tip. The residuals are the logarithms of the reached over the
wished values; a small weight on the unknowns themselves selects the smallest of all solutions. Each trial
finds the pose at rest and the slowest vibrations anew; the derivatives are those of `sensitivity`.

Neither the pose at rest nor an undamped frequency depends on damping, so each trial finds the damping that
calms the body in time separately, see `sim.analysis.decay`.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import msgspec
import numpy as np

from ..analysis.vibrations import MAX_MASSES
from ..edit.edit import of_parts
from ..errors import InputError, SceneError, no_part, of_field
from ..motion.stability import StabilityMeter, meter_at_start
from ..scene.columns import ends
from ..scene.parts import AngularSpring, LinearSpring
from ..scene.types import Scene
from ..scene.validate import validate
from ..settings import SETTINGS, moves
from ..solve.registry import METHODS
from ..text import Text, listed
from .calming import Calming
from .keep_shape import DesignError
from .sensitivity import AtRest, Change, Floats, by_setting, scaled

# Unless noted, doubling or halving one of these numbers fails no test.
REACHED = 5e-3
"""Largest relative deviation of a reached from a wished value at which the wish counts as fulfilled."""
_MARGIN = 1.01
"""Factor by which the stability limit must exceed the time step, as in `sim.design.tune`."""
_LEAST = 1e-2
"""Weight of the unknowns relative to the residuals, which selects the solution with the smallest change and
prevents large changes for hardly any gain."""
_CLOSE, _EXACT = 0.05, 2e-4
"""Residuals below which the weight is zero, and below which the search ends. With the first doubled,
`test_wishes_that_take_the_steepest_taper_are_found` fails."""
_GAIN, _FINE = 2e-3, 5e-3
"""Relative decrease of the sum of squares in a trial, and change of the unknowns in a worse trial, below
which the search ends."""
_STIFFER, _CAUTIOUS = 4.0, 1e-5
"""Factor of Levenberg's damping after a worse trial, and its smallest value, which keeps unknowns that have
no effect unchanged."""
_MOST = 1e5
"""Largest factor, and the reciprocal of the smallest: larger changes would make it another body. Doubled or
halved, `test_an_absurd_wish_leaves_the_body_within_bounds_and_says_so` fails."""
_STEEPEST = math.log(30.0)
"""Largest logarithm of the ratio of stiffness factors, root to tip, in a taper."""
_LOST = 20.0
"""Residual of a trial that fails."""
_TRIALS = 30
"""Largest number of trials of a search."""
_STARTS, _RESTARTS = (0.02, 0.2, 1.0, 5.0, 50.0), 3
"""Factors of a grid that is tried where the descent from the scene's own numbers fails, and the number of its
best points from which further descents start. By experiment (168 frequencies that other factors give):
without the grid 9 are not found, with two starts 2, with three none. With every other factor,
`test_a_frequency_is_found_beyond_where_another_vibration_becomes_the_slowest` fails."""
_STEP = 0.05
"""Change of a logarithm in finite differences of stability limits, which are accurate to 1 %."""
_LESS = (0.02, 0.05, 0.1)
"""Decreases, in logarithms, that are tried on a design that is nearly stable at the wished time step. Without
them, `test_a_time_step_is_that_of_what_is_taken_home_where_the_method_has_no_limit` fails."""
_SHALLOW = 0.1
"""Fraction of the wished sag below which its logarithm is continued by a straight line."""
_DAMPINGS = "linear_damping", "angular_damping"
"""Keys of the settings for the damping of springs and of joints."""

P = TypeVar("P", LinearSpring, AngularSpring)


class _Wishes(msgspec.Struct, frozen=True):
    """Wishes; see `set_wishes`."""

    frequency: float | None = None
    calm_after: float | None = None
    sag: float | None = None
    dt: float | None = None

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(name for name in self.__struct_fields__ if getattr(self, name) is not None)

    def only(self, names: Sequence[str]) -> _Wishes:
        return _Wishes(**{name: getattr(self, name) for name in names})


@dataclass(frozen=True)
class Factors:
    """Changes that a design makes.

    Attributes:
        springs, joints: factors of the stiffness of all springs, and of all joints.
        taper: natural logarithm of the ratio of the stiffness factor at the root, where the body is held, to
            that at the tip, the mass farthest from there along the springs.
        spring_damping, joint_damping: the new largest damping of springs, and of joints, kg/s; the others
            keep their ratio to it. None leaves it unchanged.
    """

    springs: float = 1.0
    joints: float = 1.0
    taper: float = 0.0
    spring_damping: float | None = None
    joint_damping: float | None = None

    def applied(self, scene: Scene) -> Scene:
        """Return a scene with other stiffnesses and dampings. With a taper, a body made by a recipe is
        replaced by its parts; otherwise it stays a recipe.

        Raises:
            SceneError: a number would leave its range.
        """
        scene = self.with_stiffness(scene)
        for key, damping in zip(_DAMPINGS, (self.spring_damping, self.joint_damping), strict=True):
            if damping is not None and damping != SETTINGS[key].read(scene):
                scene = validate(SETTINGS[key].write(scene, damping))
        return scene

    def with_stiffness(self, scene: Scene) -> Scene:
        """Apply only the stiffnesses, as in `applied`."""
        for key, factor in (("linear_stiffness", self.springs), ("angular_stiffness", self.joints)):
            if factor != 1.0:
                scene = scaled(scene, key, factor)
        return tapered(scene, self.taper) if self.taper else scene


@dataclass(frozen=True)
class Design:
    """Result of `set_wishes`.

    Attributes:
        scene: the scene with other stiffnesses and dampings.
        factors: the changes of these.
        reached: values that the scene reaches, by the names of the wishes: `frequency`, Hz, `calm_after`, s,
            `sag`, px, and `dt`, s, the largest stable time step of `step_method`.
        against: the names of a smallest set of wishes that cannot be fulfilled together; empty if all are
            fulfilled.
        conflict: the same as a sentence without a full stop; empty if all are fulfilled.
    """

    scene: Scene
    factors: Factors
    reached: dict[str, float]
    against: tuple[str, ...] = ()
    conflict: str = ""


def set_wishes(
    scene: Scene,
    frequency: float | None = None,
    calm_after: float | None = None,
    sag: float | None = None,
    dt: float | None = None,
    mass: int | None = None,
) -> Design:
    """Return the scene with stiffnesses and dampings with which it behaves as wished.

    The stiffness of all springs is multiplied by one factor and that of all joints by another, with the
    smallest possible change. Where that is not enough, a taper from root to tip makes one end stiffer than
    the other. Masses, lengths, angles and gravity stay unchanged. To calm the body sooner, the damping of
    springs or joints is raised, whichever contribute more to the stiffness of the vibration; to calm it
    later, or for a longer time step, all damping is lowered.

    Args:
        scene: a valid scene of at most 1000 masses.
        frequency: Hz, of the slowest elastic vibration about the pose at rest without damping, which is
            `sim.tuning(scene).elastic.frequency`: how many times per second the body swings to and fro after
            a nudge. A swing under gravity, which stiffness hardly changes, is not meant.
        calm_after: s, time in which the amplitude of that vibration falls to a tenth, as
            `sim.tuning(scene).elastic.calm_after`. It is shortest where the vibration by itself is critically
            damped: more damping makes it creep.
        sag: px, by which the mass that sinks most is lower at rest than in the scene, as
            `sim.tuning(scene).sag`.
        dt: s, a time step at which the scene's method must be stable about the scene's start, as
            `sim.tuning(scene).stable_steps`; a body that is stable at longer ones is not changed. Where
            nothing limits the steps of the scene's method, as under `auto`, symplectic Euler must be stable,
            which exported programs use; see `step_method`.
        mass: the mass whose sag is meant, instead of the one that sinks most.

    Returns:
        The design. If the wishes cannot be fulfilled together it is the nearest, with the smallest sum of
        squares of the logarithms of reached over wished values, and it names the wishes that conflict. No
        stiffness changes by a factor of more than 100 000, or, with a taper, 550 000 at its ends.

    Raises:
        SceneError: the scene is not valid.
        InputError: a wish is out of its range, or there is none.
        DesignError: no stiffness or damping of the scene affects a wish, for example without any springs.
    """
    validate(scene)
    wishes = _Wishes(frequency, calm_after, sag, dt)
    _refuse_senseless(scene, wishes, mass)
    search = _Search(scene, mass)
    search.refuse_hopeless(wishes)
    best = search.best(wishes)
    against = () if best.is_enough else search.least_conflict(wishes)
    reached = {name: best.reached[name] for name in wishes.names}
    made = best.factors.applied(scene)
    conflict = ""
    if against:
        conflict = _sentence(wishes, against, reached, scene.view.unit)
        changed = (abs(math.log(factor)) for factor in (best.factors.springs, best.factors.joints))
        if max(changed) > 0.99 * math.log(_MOST):
            conflict = Text(
                "{error}; stiffness changes by a factor of at most {most:.0f}", error=conflict, most=_MOST
            )
    return Design(made, best.factors, reached, against, conflict)


def step_method(scene: Scene) -> str:
    """Return the method whose time step a wish refers to: the scene's, or symplectic Euler where nothing
    limits its steps."""
    method = scene.integrator.method
    return method if METHODS[method].limit is not None else "symplectic_euler"


def _refuse_senseless(scene: Scene, wishes: _Wishes, mass: int | None) -> None:
    ranges = {
        "frequency": (1e-3, 1e6, "Hz"),
        "calm_after": (1e-6, 1e6, "s"),
        "sag": (1e-6, 1e6, "px"),
        "dt": (1e-9, 1.0, "s"),
    }
    if not wishes.names:
        raise InputError(
            Text("{where}: nothing is wished; there are {known}", where="set_wishes", known=", ".join(ranges))
        )
    for name in wishes.names:
        value, (low, high, unit) = getattr(wishes, name), ranges[name]
        number = isinstance(value, int | float) and not isinstance(value, bool)
        if not (number and low <= value <= high):
            raise InputError(
                Text(
                    "{where}: {name} {value} is not in the range {low:g}..{high:g} {unit}",
                    where="set_wishes",
                    name=name,
                    value=value,
                    low=low,
                    high=high,
                    unit=unit,
                )
            )
    if mass is not None:
        whole = isinstance(mass, int) and not isinstance(mass, bool)
        if not (whole and 0 <= mass < len(scene.masses)):
            raise InputError(of_field("set_wishes", no_part("mass", mass, len(scene.masses))))
        if any(anchor.mass == mass for anchor in scene.anchors):
            raise _no(Text("mass {mass} is held, so it does not sag", mass=mass))
    if len(scene.masses) > MAX_MASSES:
        raise InputError(
            Text(
                "{where}: {count} masses are more than {most}",
                where="set_wishes",
                count=len(scene.masses),
                most=MAX_MASSES,
            )
        )


def _no(sentence: str) -> DesignError:
    return DesignError(sentence, of="set_wishes")


# ------------------------------------------------------------------------- the search
@dataclass
class _Trial:
    """A scene with some factors.

    Attributes:
        tried: the factors that were tried.
        factors: the same, with the damping that calms the body in time.
        reached: the values reached, by the names of the wishes, as far as they exist.
        residuals: for each wish, the logarithm of the reached over the wished value.
        rest: the scene at rest; None if the trial failed.
    """

    tried: Factors
    factors: Factors
    reached: dict[str, float]
    residuals: Floats
    rest: AtRest | None = None

    @property
    def miss(self) -> float:
        return float((self.residuals**2).sum())

    @property
    def is_enough(self) -> bool:
        return bool((np.abs(self.residuals) <= REACHED).all())


class _Search:
    """Searches for the factors of a scene.

    Args:
        scene: the scene.
        mass: the mass whose sag is meant; None for the one that sinks most.
    """

    def __init__(self, scene: Scene, mass: int | None) -> None:
        self._scene, self._mass = scene, mass
        self._changes: list[tuple[str, Change]] = [
            (name, by_setting(key))
            for name, key in (("springs", "linear_stiffness"), ("joints", "angular_stiffness"))
            if SETTINGS[key].applies(scene) and SETTINGS[key].read(scene) > 0.0
        ]
        self._tapers = len(scene.linear_springs) > 1 and bool(scene.anchors)
        self._start = AtRest(scene)
        self._meter: StabilityMeter | None = None  # the stiffest motions of two trials are similar
        self._rests: dict[Factors, AtRest] = {}  # other wishes are tried with the same stiffnesses
        self._last: tuple[_Wishes, _Trial] | None = None  # a search often starts where the last one ended
        self._found: dict[_Wishes, _Trial] = {}  # subsets of the wishes are searched more than once

    def refuse_hopeless(self, wishes: _Wishes) -> None:
        """Refuse wishes that do not depend on stiffness or damping.

        Raises:
            DesignError: gives the reason.
        """
        if not moves(self._scene):
            raise _no(Text("no mass is free, so nothing moves"))
        if not self._changes:
            raise _no(Text("no spring has any stiffness"))
        notes = self._start.notes
        if self._start.elastic is None and (wishes.frequency is not None or wishes.calm_after is not None):
            why = Text("no springs or joints hold it as it swings, so it has no elastic vibration")
            raise _no(Text("{error}: {reason}", error=why, reason=notes[0]) if notes else why)
        if wishes.sag is not None and self._start.sag is None:
            reason = notes[0] if notes else Text("nothing pulls it")
            raise _no(Text("nothing sags: {reason}", reason=reason))

    def best(self, wishes: _Wishes) -> _Trial:
        """Return the trial closest to some wishes; with a taper only if necessary."""
        found = self._nearest(wishes)
        about = [name for name in wishes.names if name != "calm_after"]
        if found.is_enough or not self._tapers or len(about) < 2:
            return found
        changes = [*self._changes, ("taper", tapered)]
        if wishes.dt is not None and wishes.calm_after is None:
            changes.append(("damping", _damped))
        other = self._descend(wishes, changes, self._unknowns(found, changes))
        return other if other.miss < 0.9 * found.miss else found

    def least_conflict(self, wishes: _Wishes) -> tuple[str, ...]:
        """Return a smallest set of the wishes that cannot be fulfilled together."""
        names = wishes.names
        for count in range(1, len(names)):
            for some in itertools.combinations(names, count):
                if not self.best(wishes.only(some)).is_enough:
                    return some
        return names

    def _nearest(self, wishes: _Wishes) -> _Trial:
        """Return the trial with the smallest sum of squares, without a taper."""
        if wishes not in self._found:
            found = self._newly_nearest(wishes)
            if not found.is_enough and wishes.frequency is not None:
                found = self._nearest_from(self._starts(wishes), wishes, found)
            self._found[wishes] = found
        return self._found[wishes]

    def _starts(self, wishes: _Wishes) -> list[Floats]:
        """Return unknowns from which a descent may come closer than from the scene's own numbers.

        Another vibration may become the slowest elastic one as the factors change. The frequency jumps there,
        and a descent stops.
        """
        only, changes = wishes.only(["frequency"]), self._changes
        if wishes != only:
            return [self._unknowns(self._nearest(only), changes)]
        names = [name for name, _ in changes]
        grid = [np.array(logs) for logs in itertools.product(np.log(_STARTS), repeat=len(names)) if any(logs)]
        return sorted(grid, key=lambda logs: self._try(wishes, names, logs).miss)[:_RESTARTS]

    def _nearest_from(self, starts: list[Floats], wishes: _Wishes, found: _Trial) -> _Trial:
        """Return the best of a trial and the results of descents from some unknowns."""
        for start in starts:
            if found.is_enough:
                break
            other = self._descend(wishes, self._changes, start)
            if other.miss < 0.9 * found.miss:
                found = other
        return found

    def _newly_nearest(self, wishes: _Wishes) -> _Trial:
        changes = self._changes
        first = self._try(wishes, [name for name, _ in changes], np.zeros(len(changes)))
        if first.is_enough:
            return first
        # The time step is ignored until a design violates it.
        looked = _Wishes(**{n: getattr(wishes, n) for n in wishes.names if n != "dt"})
        if wishes.dt is None:
            return self._descend(wishes, changes)
        found = self._nearest(looked) if looked.names else first
        start = self._unknowns(found, changes)
        found = self._try(wishes, [name for name, _ in changes], start)
        if found.is_enough or wishes.calm_after is not None:
            return found if found.is_enough else self._descend(wishes, changes, start)
        # No wish concerns damping, and with less of it longer steps are stable.
        return self._descend(wishes, [*changes, ("damping", _damped)], np.append(start, 0.0))

    def _unknowns(self, trial: _Trial, changes: Sequence[tuple[str, Change]]) -> Floats:
        factors = trial.factors
        dampings = zip((factors.spring_damping, factors.joint_damping), self._own_damping(), strict=True)
        logs = {
            "springs": math.log(factors.springs),
            "joints": math.log(factors.joints),
            "taper": factors.taper,
            "damping": next((math.log(damping / own) for damping, own in dampings if damping and own), 0.0),
        }
        return np.array([logs[name] for name, _ in changes])

    def _own_damping(self) -> list[float]:
        """Return the scene's damping of springs and of joints, kg/s."""
        return [SETTINGS[key].read(self._scene) for key in _DAMPINGS]

    def _descend(
        self, wishes: _Wishes, changes: Sequence[tuple[str, Change]], start: Floats | None = None
    ) -> _Trial:
        """Return the trial with the smallest sum of squares, by Levenberg's method."""
        from scipy.optimize import lsq_linear

        names = [name for name, _ in changes]
        most = np.array([_STEEPEST if name == "taper" else math.log(_MOST) for name in names])
        at = np.zeros(len(names)) if start is None else start
        here = self._try(wishes, names, at)
        caution, slopes = _CAUTIOUS, None
        # Stability limits are accurate to 1 % only, so a time step need not be matched more closely.
        exact = np.array([REACHED if name == "dt" else _EXACT for name in wishes.names])
        for _ in range(_TRIALS):
            worst = float(np.abs(here.residuals).max())
            if (np.abs(here.residuals) <= exact).all():
                break
            if slopes is None:
                slopes = self._slopes(wishes, here, names, at, changes)
            weight = 0.0 if worst <= _CLOSE else _LEAST
            unit = np.eye(len(names))
            left = np.concatenate((here.residuals, weight * at, np.zeros(len(names))))
            rows = np.vstack((slopes, weight * unit, caution * unit))
            to = at - lsq_linear(rows, left, (at - most, at + most), method="bvls").x
            there = self._try(wishes, names, to)
            before = here.miss + weight**2 * float(at @ at)
            after = there.miss + weight**2 * float(to @ to)
            moved = float(np.abs(to - at).max())
            if after < before:
                at, here = to, there
                caution = caution / _STIFFER**2 if caution > _LEAST else _CAUTIOUS
                if after > (1.0 - _GAIN) * before:
                    break
                slopes = None
            else:
                caution = max(_STIFFER * caution, _LEAST)
                if moved < _FINE:
                    break
        if wishes.names == ("dt",):
            # Where springs and joints limit it equally, no slope helps, but lowering everything does.
            for less in _LESS:
                if here.is_enough or not np.abs(here.residuals).max() <= _CLOSE:
                    break
                here = self._try(wishes, names, np.clip(at - less, -most, most))
        return here

    def _try(self, wishes: _Wishes, names: Sequence[str], unknowns: Floats) -> _Trial:
        factors = self._factors(names, unknowns)
        if self._last is None or self._last[0] != wishes or self._last[1].tried != factors:
            self._last = wishes, self._new_trial(wishes, factors)
        return self._last[1]

    def _new_trial(self, wishes: _Wishes, factors: Factors) -> _Trial:
        tried = factors
        lost = _Trial(tried, factors, {}, np.full(len(wishes.names), _LOST))
        try:
            stiff = factors.with_stiffness(self._scene)
            rest = self._rest(factors, stiff)
            factors, reached = self._reached(wishes, stiff, rest, factors)
        except (SceneError, InputError):
            return lost
        missing = [name for name in wishes.names if reached.get(name) is None]
        if missing:
            return lost
        residual = np.array([_residual(name, getattr(wishes, name), reached[name]) for name in wishes.names])
        return _Trial(tried, factors, reached, residual, rest)

    def _rest(self, factors: Factors, stiff: Scene) -> AtRest:
        """Return the scene with some stiffnesses at rest."""
        key = replace(factors, spring_damping=None, joint_damping=None)
        if key not in self._rests:
            self._rests[key] = AtRest(self._from(stiff))
        return self._rests[key]

    def _factors(self, names: Sequence[str], unknowns: Floats) -> Factors:
        logs = dict(zip(names, unknowns.tolist(), strict=True))
        factors = Factors(
            springs=math.exp(logs.get("springs", 0.0)),
            joints=math.exp(logs.get("joints", 0.0)),
            taper=logs.get("taper", 0.0),
        )
        if damping := logs.get("damping"):
            springs, joints = (math.exp(damping) * own for own in self._own_damping())
            factors = replace(factors, spring_damping=springs, joint_damping=joints)
        return factors

    def _bears(self, factors: Factors) -> float:
        """Return the largest stable time step with some factors, s."""
        method = step_method(self._scene)
        self._meter, found = meter_at_start(factors.applied(self._scene), method, self._meter)
        return found.limit

    def _from(self, scene: Scene) -> Scene:
        """Return the scene so that its search for the pose at rest begins at that of the first scene."""
        return msgspec.structs.replace(scene, pose=self._start.scene.pose or scene.pose)

    def _reached(
        self, wishes: _Wishes, stiff: Scene, rest: AtRest, factors: Factors
    ) -> tuple[Factors, dict[str, float]]:
        """Return the factors with the wished damping, and the values that the scene then reaches."""
        reached: dict[str, float] = {}
        if rest.omega is not None:
            reached["frequency"] = rest.omega / math.tau
        sag = rest.sag if self._mass is None else rest.sag_of(self._mass)
        if sag is not None:
            reached["sag"] = sag
        if wishes.calm_after is not None and rest.omega is not None:
            springs, joints, reached["calm_after"] = Calming(rest).calmed(wishes.calm_after)
            factors = replace(factors, spring_damping=springs, joint_damping=joints)
        if wishes.dt is not None:
            reached["dt"] = self._bears(factors)
        return factors, reached

    def _slopes(
        self,
        wishes: _Wishes,
        trial: _Trial,
        names: Sequence[str],
        unknowns: Floats,
        changes: Sequence[tuple[str, Change]],
    ) -> Floats:
        """Return the derivatives of a trial's residuals with respect to the unknowns."""
        rest, reached = trial.rest, trial.reached
        if rest is None:
            return np.zeros((len(wishes.names), len(changes)))
        mass = rest.sag_mass if self._mass is None else self._mass
        sags, frequencies = rest.derivatives([change for _, change in changes], mass)
        rows = {"frequency": frequencies, "calm_after": np.zeros(len(changes))}
        if wishes.sag is not None:
            rows["sag"] = sags / max(reached["sag"], _SHALLOW * wishes.sag)
        if wishes.calm_after is not None and reached["calm_after"] > (1.0 + REACHED) * wishes.calm_after:
            rows["calm_after"] = -frequencies  # it is damped critically
        if wishes.dt is not None:
            own = _residual("dt", wishes.dt, reached["dt"])
            rows["dt"] = np.zeros(len(changes))
            for k in range(len(changes) if own else 0):
                there = unknowns.copy()
                there[k] += _STEP
                rows["dt"][k] = (self._off_step(wishes, names, there) - own) / _STEP
        return np.array([rows[name] for name in wishes.names])

    def _off_step(self, wishes: _Wishes, names: Sequence[str], unknowns: Floats) -> float:
        """Return the residual of the time step at other unknowns; make the whole trial only if needed."""
        assert wishes.dt is not None
        if wishes.calm_after is not None:  # damping is found anew
            return float(self._try(wishes, names, unknowns).residuals[wishes.names.index("dt")])
        try:
            return _residual("dt", wishes.dt, self._bears(self._factors(names, unknowns)))
        except (SceneError, InputError):
            return _LOST


def _residual(name: str, wish: float, reached: float) -> float:
    if name == "dt":
        # A longer stable step than wished is as good.
        return min(0.0, math.log(max(reached, 1e-300) / (_MARGIN * wish)))
    ratio = reached / wish
    if ratio > _SHALLOW or name != "sag":
        return math.log(max(ratio, 1e-300))
    return math.log(_SHALLOW) + (ratio - _SHALLOW) / _SHALLOW


def _damped(scene: Scene, step: float) -> Scene:
    """Return a scene with all damping multiplied by exp(step)."""
    for key in _DAMPINGS:
        scene = scaled(scene, key, math.exp(step))
    return scene


def tapered(scene: Scene, steepness: float) -> Scene:
    """Return a scene with the stiffness of springs and joints multiplied by exp(steepness (1/2 - s)), where s
    is their distance from the held masses along the springs over the largest such distance: 0 at the root, 1
    at a tip.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    scene = of_parts(scene)
    a, b = ends(scene.linear_springs)
    places = np.array([mass.position for mass in scene.masses])
    lengths = np.maximum(np.hypot(*(places[b] - places[a]).T), 1e-9)
    graph = coo_array((lengths, (a, b)), (len(places),) * 2).tocsr()
    roots = sorted({anchor.mass for anchor in scene.anchors})
    way = dijkstra(graph, directed=False, indices=roots, min_only=True)
    way = np.where(np.isfinite(way), way, 0.0)
    at = 0.5 * (way[a] + way[b]) / max(float(way.max()), 1e-9)
    first, second = ends(scene.angular_springs)
    springs = np.exp(steepness * (0.5 - at))
    joints = np.exp(steepness * (0.5 - 0.5 * (at[first] + at[second])))
    return validate(
        msgspec.structs.replace(
            scene,
            linear_springs=_times(scene.linear_springs, springs),
            angular_springs=_times(scene.angular_springs, joints),
        )
    )


def _times(parts: tuple[P, ...], factors: Floats) -> tuple[P, ...]:
    return tuple(
        msgspec.structs.replace(part, stiffness=part.stiffness * factor)
        for part, factor in zip(parts, factors.tolist(), strict=True)
    )


def _sentence(wishes: _Wishes, against: tuple[str, ...], reached: dict[str, float], unit: str) -> str:
    """Return a sentence that names conflicting wishes and the nearest values."""

    def said(name: str, value: float) -> str:
        match name:
            case "dt":
                return Text("a time step of {value:.3g} ms", value=1e3 * value)
            case "sag":
                return Text("a sag of {value:.3g} {unit}", value=value, unit=unit)
            case "calm_after":
                return Text("calm after {value:.3g} s", value=value)
            case _:
                return Text("{value:.3g} Hz", value=value)

    asked = listed([said(name, getattr(wishes, name)) for name in against])
    nearest = ""
    for name in against:
        if name in reached:
            each = said(name, reached[name])
            nearest = Text("{one} and {other}", one=nearest, other=each) if nearest else each
    if len(against) == 1:
        why = Text("{asked} cannot be had by stiffness and damping", asked=asked)
    else:
        why = Text("{asked} cannot be had together", asked=asked)
    return Text("{error}; the nearest is {nearest}", error=why, nearest=nearest) if nearest else why
