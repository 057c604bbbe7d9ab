"""A scene in motion."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..compiling.compiler import for_energy, is_ready
from ..engine.numerics.waves import EFFORTS, SINCE
from ..engine.numerics.waves import KEYS as PAIRS
from ..engine.tables import CONTROL_SCALE, CONTROL_SHIFT, Indices, State
from ..errors import InputError, no_part
from ..forces.muscles import efforts
from ..model.loads import LoadCalculator, Loads
from ..model.state import Carried, damage_in, grips_of, rest_angles, steer_in
from ..model.system import System, same_topology
from ..scene.columns import ends
from ..scene.types import Anchor, Damage, Pose, Scene, steered_by
from ..scene.validate import validate
from ..settings import shift_rest_angles
from ..solve.steps import guard
from ..text import Text
from .checkpoint import Checkpoint
from .divergence import Divergence, explain
from .energy import Energies, EnergyTracker
from .hands import Hands, within_bounds
from .moment import Moment
from .motion import Motion, key_rates_of
from .plain import PlainSolver
from .recording import Recording
from .solver import UNLIMITED, Solver, SolverStats
from .stability import LimitEstimate, StabilityEstimate, StabilityMeter, finished

Key = Literal["up", "down", "left", "right"]
KEYS: frozenset[str] = frozenset(("up", "down", "left", "right"))


class Simulation:
    """Steps a scene.

    Args:
        scene: a valid scene.
        dt: time step, 1e-6..1 s; None for the scene's own.
        integrator: name of a method (`sim.solve.registry`); None for the scene's own.
        wait: whether the first step may wait until the method's kernels are compiled, which takes seconds
            where they are not on the disk. Otherwise the body moves by NumPy until someone has compiled them,
            see `sim.compiling`, and `plain` says so.

    Attributes:
        keys: the arrow keys held, a set of "up", "down", "left", "right"; they act in every step.
        divergence: why it stopped, or None. A stopped simulation does no steps until it is reset or its
            scene replaced.

    Raises:
        SceneError: the scene, the time step or the method is not valid.
    """

    def __init__(
        self, scene: Scene, dt: float | None = None, integrator: str | None = None, wait: bool = True
    ) -> None:
        self._wait = wait
        self._overrides = {
            key: value for key, value in (("dt", dt), ("method", integrator)) if value is not None
        }
        self._keys: frozenset[str] = frozenset()
        scene = self._with_overrides(scene)
        self._install(Motion(scene, wait))

    # --------------------------------------------------------------------- reading
    @property
    def scene(self) -> Scene:
        """The scene as it is now: what the arrow keys changed is in it, the motion is not."""
        scale, shift = map(float, self._state.controls)
        if (scale, shift) != self._scene_with_controls[0]:
            scene = msgspec.structs.replace(self._scene, rest_length_scale=scale)
            self._scene_with_controls = (scale, shift), shift_rest_angles(scene, shift) if shift else scene
        return self._scene_with_controls[1]

    @property
    def anchors(self) -> tuple[Anchor, ...]:
        """The scene's anchors."""
        return self._scene.anchors

    @property
    def method(self) -> str:
        """Name of the method of integration."""
        return self._scene.integrator.method

    @property
    def dt(self) -> float:
        """Time step, s."""
        return self._scene.integrator.dt

    @property
    def positions(self) -> NDArray[np.float64]:
        """(n, 2) positions in px; a copy."""
        return self._state.q[self._system.vector_index]  # in half of the time of `take`

    @property
    def velocities(self) -> NDArray[np.float64]:
        """(n, 2) velocities in px/s, zero where a mass is held; a copy."""
        return self._state.v[self._system.vector_index]

    @property
    def angles(self) -> NDArray[np.float64]:
        """(J,) the present angle of each angular spring, in degrees in (-180, 180]."""
        positions = self.positions
        held = self._joint_ends
        if held is None:
            of_springs = np.stack(ends(self._scene.linear_springs), 1)
            first, second = ends(self._scene.angular_springs)
            held = self._joint_ends = of_springs[first], of_springs[second]
        a, b = (positions[of[:, 1]] - positions[of[:, 0]] for of in held)
        cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        return np.degrees(np.arctan2(cross, (a * b).sum(1)))

    @property
    def rest_angles(self) -> NDArray[np.float64]:
        """(J,) the present rest angle of each angular spring, in degrees in (-180, 180]."""
        return rest_angles(self._system.body, self._state)[self._system.joint_order]

    @property
    def rest_length_scale(self) -> float:
        """The present factor of all rest lengths."""
        return float(self._state.controls[CONTROL_SCALE])

    @property
    def rest_angle_shift(self) -> float:
        """What the arrow keys have added to all rest angles since the scene was put in place, degrees."""
        return float(self._state.controls[CONTROL_SHIFT])

    @property
    def tables(self) -> tuple[System, State]:
        """The solver's tables, without what has broken, and the state. They are its own: only read them."""
        return self._system, self._state

    def pose(self) -> Pose:
        """The present positions and velocities, as a scene can carry them."""
        return Pose(
            positions=tuple((x, y) for x, y in self.positions.tolist()),
            velocities=tuple((x, y) for x, y in self.velocities.tolist()),
            damage=self.damage,
            grips=grips_of(self._state, self._system),
        )

    @property
    def damage(self) -> Damage | None:
        """What has yielded and broken; None where nothing has."""
        found = damage_in(self._state, self._system)
        if found != self._damage:
            self._damage = found  # moments share it while nothing changes
        return self._damage

    @property
    def step_count(self) -> int:
        """Steps done since the start or the last reset."""
        return self._motion.steps

    @property
    def time(self) -> float:
        """Simulated time since the start or the last reset, s."""
        return self._motion.time

    @property
    def plain(self) -> bool:
        """Whether it moves by NumPy, because the kernels of its method are not compiled yet."""
        return isinstance(self._motion.solver, PlainSolver)

    @property
    def complete(self) -> bool:
        """Whether all kernels that it may use are there; if not, how it goes on depends on the compiler."""
        solver = self._motion.solver
        return isinstance(solver, Solver) and solver.complete

    @property
    def work(self) -> int:
        """What the method has tried since the last call of `stats`, see `SolverStats`."""
        return self._motion.solver.work

    @property
    def rate_limited(self) -> bool:
        """Whether its masses are too many, and its springs too stiff, to follow any hand, see `follow`."""
        return self._hands.rate_limited

    @property
    def grabbed(self) -> list[int]:
        """The masses that are in a hand, see `grab`."""
        return sorted(self._hands.grabbed)

    @property
    def behind(self) -> dict[int, float]:
        """How far masses that `follow` leads, or that are being stopped, still have to go, px, by mass."""
        return self._hands.behind

    @property
    def loads(self) -> Loads:
        """The net force on each mass and the torque of each joint at this moment."""
        if self._load_calculator is None or self._load_calculator.system is not self._system:
            self._load_calculator = LoadCalculator(self._scene, self._system, self._state)
        return self._load_calculator.loads(self.time)

    def stability(self) -> StabilityEstimate:
        """The method's estimated stability limit at the present state; each call refines it a little."""
        return finished(self.stability_in_parts())

    def stability_in_parts(self) -> LimitEstimate:
        """As `stability`, for whom the whole would take too long at once; see `StabilityMeter.look`."""
        if self._meter is None or self._meter.system is not self._system:
            self._meter = StabilityMeter(self._system, self.method)
        return self._meter.look(self._state)

    def stats(self) -> SolverStats:
        """What the method did since the last call of this."""
        return self._motion.solver.stats()

    def energy(self) -> Energies:
        """The energies, and what has changed them since this was first called, or since the last reset.

        Raises:
            InputError: the kernels for that are still being compiled, see `track_energy`.
        """
        self.track_energy(True)
        if self._tracker is None:
            raise InputError(Text("{where}: its kernels are still being compiled", where="energy"))
        return self._tracker.read()

    def track_energy(self, on: bool) -> bool:
        """Whether what changes the energy is followed from now on, which takes time in every step.

        It cannot be as long as a simulation that does not `wait` lacks the kernels for that.
        """
        solver = self._motion.solver
        if not on:
            self._tracker = None
            if isinstance(solver, Solver):
                solver.close_balance()
        elif (
            self._tracker is None
            and isinstance(solver, Solver)
            and (self._wait or is_ready(for_energy(self._system.body)))
        ):
            self._tracker = self._new_tracker()
        return self._tracker is not None

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
            raise InputError(
                Text(
                    "{where}: {unknown!r} is not one of up, down, left, right",
                    where="keys",
                    unknown=unknown[0],
                )
            )
        self._keys = held
        self._steer()

    @property
    def steered(self) -> bool:
        """Whether keys work any motor, muscle or force."""
        return self._steered

    @property
    def steer(self) -> tuple[float, ...]:
        """`State.steer`: what keys do to motors, muscles and forces; empty where none was held."""
        return steer_in(self._state)

    def _steer(self) -> None:
        """Let motors, muscles and forces know of the keys."""
        keys, steer = self._keys, self._state.steer
        ways = ("right" in keys) - ("left" in keys), ("up" in keys) - ("down" in keys)
        if not self._steered or (steer[:PAIRS] == ways).all():
            return
        self._motion.begin_anew()
        steer[EFFORTS:SINCE], steer[SINCE] = efforts(steer, self.time), self.time
        steer[:PAIRS] = ways

    def move(self, mass: int, to: tuple[float, float]) -> None:
        """Put a held mass somewhere at once; the forces of the next step find it there.

        Raises:
            InputError: the mass does not exist or is not held, or the place is not within ±1e6 px.
        """
        index = self._held_mass(mass)
        x, y = self._on_rail(index, within_bounds(to))
        self._hands.leave(index)
        with self._by_hand():
            self._state.x[index], self._state.y[index] = x, y
        self._motion.begin_anew()

    def lead(self, mass: int, to: tuple[float, float]) -> None:
        """Lead a held mass somewhere: in a straight line, over all steps of the next call of `step`.

        Raises:
            InputError: as `move`.
        """
        index = self._held_mass(mass)
        self._hands.lead(index, self._on_rail(index, within_bounds(to)))

    def follow(self, mass: int, to: tuple[float, float]) -> None:
        """Lead a held mass somewhere as fast as the body can follow, in this and later calls of `step`.

        Most bodies can in one call. In one that is `rate_limited` the hand stays `behind`.

        Raises:
            InputError: as `move`.
        """
        if self.rate_limited and not any(a.mass == mass and a.circle is not None for a in self.anchors):
            index = self._held_mass(mass)
            self._hands.lead_limited(index, self._on_rail(index, within_bounds(to)))
        else:
            self.lead(mass, to)

    def _on_rail(self, index: int, to: tuple[float, float]) -> tuple[float, float]:
        """Return the nearest place to a given one on the rail of the mass in a slot, if it is on one."""
        rails, state = self._system.body.environment.rails, self._state
        if not rails.slot.size or rails.number[index] < 0:
            return to
        x, y = rails.way[rails.number[index]].tolist()
        along = x * (to[0] - state.x[index]) + y * (to[1] - state.y[index])
        return float(state.x[index] + along * x), float(state.y[index] + along * y)

    def grab(self, mass: int) -> None:
        """Hold a mass that is free, as a hand does, until `release`; a held mass may be grabbed too.

        It is stopped at once, or in a `rate_limited` body as fast as that can follow.
        """
        self._hands.grab(self._existing_mass(mass))
        with self._by_hand():
            self._motion.hold()

    def release(self, mass: int) -> None:
        """Let go of a grabbed mass: it is free, and at rest, or held again, as the scene says.

        One that is held again still comes to where it was to follow.
        """
        self._hands.release(self._existing_mass(mass))
        with self._by_hand():
            self._motion.hold()

    def take_compiled(self) -> bool:
        """Go on with the kernels of the method if they are ready by now; whether it does."""
        return self._motion.take_compiled()

    def step(self, n: int = 1, attempts: int | None = None) -> int:
        """Go on by n time steps, and return how many were done.

        They are fewer when the body runs away, see `divergence`, and where `attempts` do not suffice: a
        method that chooses its own steps may try that many, where a step of a dear method counts as several
        under `auto`, see `work`. Then `time` has come as far as they led, and what is led goes on in the next
        call.
        """
        limit = UNLIMITED if attempts is None else attempts
        if n > 0 and not self._keys and self.divergence is None:
            # The usual case first: the physics of a short body takes less time than what follows.
            limit = self._motion.go_on(n, limit)
            if limit < 0:
                return n
        if n < 0:
            raise InputError(Text("{where}: {n} is not a number of steps", where="step", n=n))
        if self.divergence is not None or n == 0:
            return 0
        if self.plain:
            self.take_compiled()
        rates = key_rates_of(self._scene, self._keys)
        outcome = self._motion.step(n, rates, limit)
        if outcome.status != guard.GOOD:
            self.divergence = explain(self._scene, self._system, self._state, self.step_count, outcome)
        return outcome.steps

    def advance(self, seconds: float) -> int:
        """Do as many steps as fit into the seconds, the rest being kept for the next call.

        Returns:
            The steps done.
        """
        if not 0.0 <= seconds <= 1e9:
            raise InputError(
                Text("{where}: {seconds:g} is not in the range 0..1e+09 s", where="advance", seconds=seconds)
            )
        self._time_remainder += seconds
        # A hair more, so that ten times 0.0025 s are ten steps whatever the rounding.
        n = int(self._time_remainder / self.dt + 1e-9)
        self._time_remainder = max(0.0, self._time_remainder - n * self.dt)
        return self.step(n)

    def record(self, seconds: float, *quantities: str, every: int = 1) -> Recording:
        """Go on by some time, and note quantities: now, and after each `every` steps.

            swing = simulation.record(10.0, "joint0.angle", "energy.total")
            swing["joint0.angle"], swing.time  # arrays of the same length
            swing.to_csv("swing.csv")

        Args:
            seconds: 0..1e9, of simulated time.
            quantities: names or formulas, see `sim.quantity`; `sim.QUANTITIES` has all names.
            every: steps from one row to the next, at least 1.

        Returns:
            The recording; it ends early where the body runs away, see `divergence`.

        Raises:
            InputError: an argument is out of range, there is no such quantity, or the scene has no such part.
        """
        recording = Recording(self._scene, quantities)
        if not 0.0 <= seconds <= 1e9:
            raise InputError(
                Text("{where}: {seconds:g} is not in the range 0..1e+09 s", where="record", seconds=seconds)
            )
        if not (isinstance(every, int) and every >= 1):
            raise InputError(
                Text(
                    "{where}: every is {every}, but must be a whole number from 1",
                    where="record",
                    every=every,
                )
            )
        left = int(seconds / self.dt + 1e-9)  # a hair more, as in `advance`
        recording.add(self)
        between = recording.steps_between(self.dt, every)
        while left >= every:
            for done in range(0, every, between):
                some = min(between, every - done)
                if self.step(some) < some:
                    return recording
                recording.look(self)
            recording.add(self)
            left -= every
        self.step(left)
        return recording

    def reset(self) -> None:
        """Back to the scene's start: positions, velocities, time, rest lengths and rest angles."""
        self._motion.go_to_start()
        self._time_remainder = 0.0
        self._begun()

    def capture(self) -> Moment:
        """The present moment, to come back to; a mass in a hand is at rest in it, as if let go."""
        scale, shift = map(float, self._state.controls)
        rows, _, grips, _ = self._motion.carried()
        if self._hands.grabbed:
            rows[2:, list(self._hands.grabbed)] = 0.0
        return Moment(
            self._scene, scale, shift, rows, self.time, self.step_count, self.damage, grips, self.steer
        )

    def restore(self, moment: Moment) -> None:
        """Back to a moment of this scene, or of another: settings, rest lengths and angles, motion and time.

        Hands let go, a divergence is forgotten, and the method begins anew: going on twice from one moment
        gives the same bits. Keys stay held. The energy balance, if tracked, begins anew, and so does what
        `advance` keeps.
        """
        kept = self._tracker is not None
        time, steps = moment.time, moment.step_count
        carried = Carried(moment.rows, moment.damage, moment.grips, moment.steer)
        controls = moment.rest_length_scale, moment.rest_angle_shift
        if moment.scene is not self._scene or self._lacks_room_for(carried):
            self._install(Motion(moment.scene, self._wait, carried, time, steps, controls))
        else:
            self._hands.clear()
            self._motion.begin(carried, time, steps, controls)
            self._begun()
        self._time_remainder = 0.0
        if kept:
            self.track_energy(True)

    def checkpoint(self) -> Checkpoint:
        """All that decides every bit of how it goes on, to `resume` from, also in the middle of a motion.

        Raises:
            InputError: it moves by NumPy until its kernels are compiled, or it has run away.
        """
        if self.plain or self.divergence is not None:
            raise InputError(Text("{where}: how this body goes on is not decided yet", where="checkpoint"))
        return Checkpoint(self._scene, self._keys, self.time, self._motion.remembered())

    def resume(self, checkpoint: Checkpoint) -> None:
        """Go on as the simulation did that made the checkpoint: the same calls then lead to the same bits.

        What hands hold comes back, too, and so do the keys held then. The energy is not tracked.

        Raises:
            InputError: the kernels of its method are not there.
        """
        memory = checkpoint.memory
        self._motion.hands.clear()
        if checkpoint.scene is not self._scene or memory.damageable != self._motion.damageable or self.plain:
            self._install(Motion(checkpoint.scene, self._wait, damageable=memory.damageable))
        if self.plain:
            raise InputError(
                Text("{where}: the kernels of this method are still being compiled", where="resume")
            )
        self.track_energy(False)
        self._motion.remember(memory)
        self._keys, self._time_remainder = checkpoint.keys, 0.0
        self._begun()

    def take_state(self, other: Simulation, shift: NDArray[np.float64] | None = None) -> None:
        """Take over positions, velocities, time and held masses of a simulation of the same topology.

        Args:
            other: the other one.
            shift: (4, n) px and px/s by which x, y, vx and vy of the free masses are to differ; None for 0.
        """
        carried = other._motion.carried()
        if self._lacks_room_for(carried):
            self._install(Motion(self._scene, self._wait, carried))
        self._time_remainder = other._time_remainder
        self._hands.take_over(other._hands)
        self._keys = other._keys
        if shift is not None:
            held = self._hands.held[self._system.mass_index - 1]
            carried = carried._replace(rows=carried.rows + np.where(held, 0.0, shift))
        self._motion.begin(carried, other.time, other.step_count)
        self._begun()

    def replace(self, scene: Scene) -> None:
        """Go on with another scene. Where it joins the same masses in the same way, positions, velocities and
        time go on from where they are; otherwise it starts from its own beginning.

        Raises:
            SceneError: the scene is not valid; nothing has changed.
        """
        scene = self._with_overrides(scene)
        if not same_topology(self._scene, scene):
            self._install(Motion(scene, self._wait))
            return
        time, steps, carried = self.time, self.step_count, self._motion.carried()
        if carried.grips is not None and not same_walls(self._scene, scene):
            carried = carried._replace(grips=msgspec.structs.replace(carried.grips, walls=()))
        remainder, tracker = self._time_remainder, self._tracker
        if tracker is not None:
            tracker.close()
        self._install(Motion(scene, self._wait, carried, time, steps, hands=self._hands))
        self._time_remainder = remainder
        # Where the kernels of the new method are still being compiled, there is no balance for now.
        if tracker is not None and self.track_energy(True) and self._tracker is not None:
            self._tracker.take_over(tracker)

    # --------------------------------------------------------------------- inside
    def _install(self, motion: Motion) -> None:
        """Go on with another motion, maybe of another scene."""
        self._motion, self._scene, self._state = motion, motion.scene, motion.state
        self._steered = bool(steered_by(motion.scene))
        self._time_remainder = 0.0
        self._joint_ends: tuple[Indices, Indices] | None = None  # once angles have been asked for
        self._meter: StabilityMeter | None = None
        self._tracker: EnergyTracker | None = None
        self._load_calculator: LoadCalculator | None = None
        self._damage: Damage | None = None  # as `damage` found it last
        self._begun()

    @property
    def _system(self) -> System:
        """The tables, without what has broken."""
        return self._motion.system

    @property
    def _hands(self) -> Hands:
        return self._motion.hands

    def _lacks_room_for(self, carried: Carried) -> bool:
        """Whether a motion has damage, and the tables are those of a body that can have none."""
        return carried.damage is not None and not self._system.body.limits.present

    @contextmanager
    def _by_hand(self) -> Iterator[None]:
        """Enter what a hand changes at once into the energy balance, if it is tracked."""
        before = self._tracker.total() if self._tracker else 0.0
        yield
        if self._tracker:
            self._tracker.moved(before)

    def _new_tracker(self) -> EnergyTracker:
        assert isinstance(self._motion.solver, Solver)
        return EnergyTracker(self._state, self._motion.solver)

    def _with_overrides(self, scene: Scene) -> Scene:
        if isinstance(scene, Scene) and self._overrides:
            integrator = msgspec.structs.replace(scene.integrator, **self._overrides)
            scene = msgspec.structs.replace(scene, integrator=integrator)
        return validate(scene)

    def _begun(self) -> None:
        """Forget what belonged to the motion before."""
        self.divergence: Divergence | None = None
        self._steer()
        # The scene as keys have made it, and the scale and the shift for which it was made.
        self._scene_with_controls = (self._scene.rest_length_scale, 0.0), self._scene
        if self._tracker is not None:
            self._tracker = self._new_tracker()

    def _existing_mass(self, mass: int) -> int:
        whole = isinstance(mass, (int, np.integer)) and not isinstance(mass, bool)
        if not (whole and 0 <= mass < self._system.body.masses):
            raise InputError(no_part("mass", mass, self._system.body.masses))
        return int(mass)

    def _held_mass(self, mass: int) -> int:
        index = int(self._system.mass_index[self._existing_mass(mass)])
        if not self._hands.hold(mass):
            raise InputError(Text("mass {mass} is not held, so it cannot be moved", mass=mass))
        return index


def same_walls(one: Scene, other: Scene) -> bool:
    """Whether two scenes have walls at the same places."""
    places = [[(wall.point, wall.normal) for wall in scene.walls] for scene in (one, other)]
    return places[0] == places[1]
