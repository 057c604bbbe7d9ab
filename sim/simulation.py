"""A scene in motion."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from .divergence import FARTHEST, FASTEST, LIMITS, Divergence
from .errors import InputError
from .kernels import guard
from .kernels.chain import run_chain
from .kernels.controls import refresh
from .kernels.general import run_general, run_held
from .kernels.tables import (
    CONTROL_SCALE,
    CONTROL_SHIFT,
    NO_JOINTS,
    SCALE_MAX,
    SCALE_MIN,
    TUTORIAL,
    Live,
    Motion,
)
from .scene import Anchor, Pose, Scene
from .settings import shift_rest_angles
from .stability import StabilityEstimate, StabilityMeter
from .system import build_system, new_live, new_work, same_topology
from .validate import validate

Key = Literal["up", "down", "left", "right"]
KEYS: frozenset[str] = frozenset(("up", "down", "left", "right"))


class Simulation:
    """Steps a scene.

    Args:
        scene: a valid scene.
        dt: time step, 1e-6..1 s; None for the scene's own.
        integrator: "symplectic_euler"; None for the scene's own.

    Attributes:
        keys: the arrow keys held, a set of "up", "down", "left", "right"; they act in every step.
        divergence: why it stopped, or None. A stopped simulation does no steps until it is reset or its
            scene replaced.

    Raises:
        SceneError: the scene, the time step or the method is not valid.
    """

    def __init__(self, scene: Scene, dt: float | None = None, integrator: str | None = None) -> None:
        self._overrides = {
            key: value for key, value in (("dt", dt), ("method", integrator)) if value is not None
        }
        self._keys: frozenset[str] = frozenset()
        self.divergence: Divergence | None = None
        self._install(self._with_overrides(scene))
        self.reset()

    # --------------------------------------------------------------------- reading
    @property
    def scene(self) -> Scene:
        """The scene as it is now: what the arrow keys changed is in it, the motion is not."""
        scale, shift = (float(c) for c in self._live.controls)
        if (scale, shift) != self._folded[0]:
            scene = msgspec.structs.replace(self._scene, rest_length_scale=scale)
            self._folded = (scale, shift), shift_rest_angles(scene, shift) if shift else scene
        return self._folded[1]

    @property
    def anchors(self) -> tuple[Anchor, ...]:
        """The scene's anchors."""
        return self._scene.anchors

    @property
    def step_count(self) -> int:
        """Steps done since the start or the last reset."""
        return self._steps

    @property
    def time(self) -> float:
        """Simulated time since the start or the last reset, s."""
        return self._time_before + (self._steps - self._steps_before) * self.dt

    @property
    def dt(self) -> float:
        """Time step, s."""
        return self._scene.integrator.dt

    @property
    def positions(self) -> NDArray[np.float64]:
        """(n, 2) positions in px; a copy."""
        return self._read(self._live.x, self._live.y)

    @property
    def velocities(self) -> NDArray[np.float64]:
        """(n, 2) velocities in px/s, zero where a mass is held; a copy."""
        return self._read(self._live.vx, self._live.vy)

    @property
    def angles(self) -> NDArray[np.float64]:
        """(J,) the present angle of each angular spring, in degrees in (-180, 180]."""
        positions = self.positions
        a, b = self._joint_vectors(positions)
        cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        return np.degrees(np.arctan2(cross, (a * b).sum(1)))

    @property
    def rest_angles(self) -> NDArray[np.float64]:
        """(J,) the present rest angle of each angular spring, in degrees in (-180, 180]."""
        angles = self._body.joint_rest[self._system.joint_order] + self._live.controls[CONTROL_SHIFT]
        return 180.0 - (180.0 - angles) % 360.0

    @property
    def rest_length_scale(self) -> float:
        """The present factor of all rest lengths."""
        return float(self._live.controls[CONTROL_SCALE])

    def pose(self) -> Pose:
        """The present positions and velocities, as a scene can carry them."""
        return Pose(
            positions=tuple((x, y) for x, y in self.positions.tolist()),
            velocities=tuple((x, y) for x, y in self.velocities.tolist()),
        )

    def stability(self) -> StabilityEstimate:
        """The estimated stability limit at the present state; each call refines it a little."""
        if self._meter is None:
            self._meter = StabilityMeter(self._system)
        return self._meter.update(self._live, self._scene.air_friction)

    # --------------------------------------------------------------------- acting
    @property
    def keys(self) -> frozenset[str]:
        """The arrow keys held."""
        return self._keys

    @keys.setter
    def keys(self, keys: Iterable[str]) -> None:
        held = frozenset(keys)
        unknown = sorted(map(str, held - KEYS))
        if unknown:
            raise InputError(f"keys: {unknown[0]!r} is not one of up, down, left, right")
        self._keys = held

    def move(self, mass: int, to: tuple[float, float]) -> None:
        """Put a held mass somewhere at once; the forces of the next step find it there.

        Raises:
            InputError: the mass does not exist or is not held, or the place is not within ±1e6 px.
        """
        place, (x, y) = self._held_mass(mass), self._place(to)
        self._targets.pop(place, None)
        self._live.x[place], self._live.y[place] = x, y

    def lead(self, mass: int, to: tuple[float, float]) -> None:
        """Lead a held mass somewhere: in a straight line, over all steps of the next call of `step`.

        Raises:
            InputError: as `move`.
        """
        self._targets[self._held_mass(mass)] = self._place(to)

    def grab(self, mass: int) -> None:
        """Hold a mass that is free, as a hand does, until `release`; a held mass may be grabbed too."""
        self._grabbed.add(self._existing_mass(mass))
        self._weigh()

    def release(self, mass: int) -> None:
        """Let go of a grabbed mass: it is free or held again, as the scene says."""
        self._grabbed.discard(self._existing_mass(mass))
        self._targets.pop(int(self._system.mass_place[mass]), None)
        self._weigh()

    def step(self, n: int = 1) -> int:
        """Do n steps, and return how many were done: fewer when the body runs away, see `divergence`."""
        if n < 0:
            raise InputError(f"step: {n} is not a number of steps")
        if self.divergence is not None or n == 0:
            return 0
        places = np.array(list(self._targets), np.int64)
        targets = np.array(list(self._targets.values()), float).reshape(-1, 2)
        factor, angle = self._key_rates()
        motion = Motion(
            active=bool(self._targets) or (factor, angle) != (1.0, 0.0),
            mass=places,
            from_x=self._live.x[places],
            from_y=self._live.y[places],
            to_x=targets[:, 0].copy(),
            to_y=targets[:, 1].copy(),
            length_factor=factor,
            angle_step=angle,
        )
        if self._all_held:
            run_held(self._body, self._live, motion, n)
            done, what, mass = n, guard.GOOD, -1
        else:
            run = run_chain if self._body.chain and self._body.law in (NO_JOINTS, TUTORIAL) and not self._body.twisted else run_general
            progress = guard.new_progress()
            run(
                self._body, self._live, self._work, motion, self._kept, progress, self.dt, n,
                self._scene.air_friction > 0.0, FARTHEST, FASTEST,
            )  # fmt: skip
            done, _, what, mass = (int(p) for p in progress)
        self._steps += done
        self._targets.clear()
        if what != guard.GOOD:
            quantity, limit = LIMITS[what]
            self.divergence = Divergence(
                int(self._system.mass_order[mass - 1]),
                self._steps,
                quantity,
                limit,
                self.dt,
                self._diagnose(),
            )
        return done

    def advance(self, seconds: float) -> int:
        """Do as many steps as fit into the seconds, the rest being kept for the next call.

        Returns:
            The steps done.
        """
        if not 0.0 <= seconds <= 1e9:
            raise InputError(f"advance: {seconds:g} is not in the range 0..1e+09 s")
        self._owed += seconds
        # A hair more, so that ten times 0.0025 s are ten steps whatever the rounding.
        n = int(self._owed / self.dt + 1e-9)
        self._owed = max(0.0, self._owed - n * self.dt)
        return self.step(n)

    def reset(self) -> None:
        """Back to the scene's start: positions, velocities, time, rest lengths and rest angles."""
        live = self._live
        for field, row in zip((live.x, live.y, live.vx, live.vy), self._system.start, strict=True):
            field[self._masses] = row
        self._steps = self._steps_before = 0
        self._time_before = self._owed = 0.0
        self._grabbed.clear()
        self._restart()

    def replace(self, scene: Scene) -> None:
        """Go on with another scene. Where it joins the same masses in the same way, positions, velocities and
        time go on from where they are; otherwise it starts from its own beginning.

        Raises:
            SceneError: the scene is not valid; nothing has changed.
        """
        scene = self._with_overrides(scene)
        if not same_topology(self._scene, scene):
            self._install(scene)
            self.reset()
            return
        positions, velocities = self.positions, self.velocities
        time, steps, owed, grabbed = self.time, self._steps, self._owed, self._grabbed
        self._install(scene)
        order = self._system.mass_order
        self._live.x[self._masses], self._live.y[self._masses] = positions[order].T
        self._live.vx[self._masses], self._live.vy[self._masses] = velocities[order].T
        self._time_before, self._steps, self._steps_before, self._owed = time, steps, steps, owed
        self._grabbed = grabbed
        self._restart()

    # --------------------------------------------------------------------- inside
    def _with_overrides(self, scene: Scene) -> Scene:
        if isinstance(scene, Scene) and self._overrides:
            integrator = msgspec.structs.replace(scene.integrator, **self._overrides)
            scene = msgspec.structs.replace(scene, integrator=integrator)
        return validate(scene)

    def _install(self, scene: Scene) -> None:
        """Build tables and room for a valid scene; the state is still to be filled in."""
        self._scene = scene
        self._system = system = build_system(scene)
        self._body = system.body
        self._masses = slice(1, system.body.masses + 1)
        self._live: Live = new_live(system)
        self._work = new_work(system)
        self._kept = np.zeros((5, self._live.x.size))
        springs = np.array([(s.a, s.b) for s in scene.linear_springs], np.int64).reshape(-1, 2)
        joints = np.array([(j.a, j.b) for j in scene.angular_springs], np.int64).reshape(-1, 2)
        self._joint_ends = springs[joints[:, 0]], springs[joints[:, 1]]
        self._meter: StabilityMeter | None = None
        self._targets: dict[int, tuple[float, float]] = {}
        self._grabbed: set[int] = set()

    def _restart(self) -> None:
        self.divergence = None
        self._targets.clear()
        self._live.controls[:] = self._scene.rest_length_scale, 0.0
        self._folded = (self._scene.rest_length_scale, 0.0), self._scene
        refresh(self._body, self._live)
        self._weigh()

    def _weigh(self) -> None:
        """Say what forces do to each mass: nothing where it is held."""
        held = self._system.held.copy()
        held[self._system.mass_place[list(self._grabbed)] - 1] = True
        live, dt = self._live, self.dt
        free = np.where(held, 0.0, 1.0)
        live.vx[self._masses] *= free
        live.vy[self._masses] *= free
        live.inverse_mass[self._masses] = free * self._system.inverse_mass
        live.air[self._masses] = live.inverse_mass[self._masses] * self._scene.air_friction
        live.gx[self._masses] = free * self._scene.gravity[0]
        live.gy[self._masses] = free * self._scene.gravity[1]
        live.dt_mass[self._masses] = free * dt * self._system.inverse_mass
        live.dt_air[self._masses] = live.dt_mass[self._masses] * self._scene.air_friction
        live.dt_gx[self._masses] = free * dt * self._scene.gravity[0]
        live.dt_gy[self._masses] = free * dt * self._scene.gravity[1]
        self._all_held = bool(held.all())

    def _diagnose(self) -> StabilityEstimate:
        """The stability limit to blame for a divergence.

        The last good state is torn apart already, so the body is looked at as it was before it moved; if
        that was stable, in its last shape. Speeds are left out: an exploding body is fast for that reason.
        """
        rest = Live(*(field.copy() for field in self._live))
        rest.vx[:] = rest.vy[:] = 0.0
        torn = rest.x[self._masses].copy(), rest.y[self._masses].copy()
        rest.x[self._masses], rest.y[self._masses] = self._system.start[:2]
        estimate = StabilityMeter(self._system).update(rest, self._scene.air_friction)
        if estimate.limit < self.dt:
            return estimate
        rest.x[self._masses], rest.y[self._masses] = torn
        return StabilityMeter(self._system).update(rest, self._scene.air_friction)

    def _key_rates(self) -> tuple[float, float]:
        """(factor of the rest lengths, degrees added to the rest angles) per step, for the keys held."""
        rates = self._scene.arrow_keys
        if rates is None or not self._keys:
            return 1.0, 0.0
        intervals = self.dt / rates.interval
        # However fast the keys: more than the whole range of scales, or than a full turn, is no more.
        most = math.log(SCALE_MAX / SCALE_MIN)
        if intervals * math.log(rates.rest_length_factor) < most:
            growth = rates.rest_length_factor**intervals
        else:
            growth = SCALE_MAX / SCALE_MIN
        length = (growth if "up" in self._keys else 1.0) / (growth if "down" in self._keys else 1.0)
        turn = math.remainder(rates.rest_angle_step * intervals, 360.0)
        return length, turn * (("right" in self._keys) - ("left" in self._keys))

    def _existing_mass(self, mass: int) -> int:
        if (
            isinstance(mass, bool)
            or not isinstance(mass, (int, np.integer))
            or not 0 <= mass < self._body.masses
        ):
            raise InputError(f"mass {mass} does not exist (0..{self._body.masses - 1})")
        return int(mass)

    def _held_mass(self, mass: int) -> int:
        place = int(self._system.mass_place[self._existing_mass(mass)])
        if not (self._system.held[place - 1] or mass in self._grabbed):
            raise InputError(f"mass {mass} is not held, so it cannot be moved")
        return place

    @staticmethod
    def _place(to: tuple[float, float]) -> tuple[float, float]:
        x, y = (float(c) for c in to)
        if not (abs(x) <= FARTHEST and abs(y) <= FARTHEST):
            raise InputError(f"({x:g}, {y:g}) is not within ±{FARTHEST:g} px")
        return x, y

    def _read(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        place = self._system.mass_place
        return np.column_stack((x[place], y[place]))

    def _joint_vectors(
        self, positions: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        a, b = self._joint_ends
        return positions[a[:, 1]] - positions[a[:, 0]], positions[b[:, 1]] - positions[b[:, 0]]
