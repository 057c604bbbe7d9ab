"""What can be read of a body: its scene, where its masses are, and its angles."""

from __future__ import annotations

import dataclasses

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..body.stable_spring import clamp_stiffness
from ..body.system import System, build_system, new_state, put_damage
from ..kernels.core.tables import CONTROL_SCALE, CONTROL_SHIFT, State
from ..scene.types import Anchor, Damage, Pose, Scene
from ..settings import shift_rest_angles


class Reading:
    """The tables of a scene and its present state; `Simulation` moves them."""

    _folded: tuple[tuple[float, float], Scene]
    """The scene as keys have made it, and the scale and the shift for which it was made."""

    @property
    def scene(self) -> Scene:
        """The scene as it is now: what the arrow keys changed is in it, the motion is not."""
        scale, shift = map(float, self._state.controls)
        if (scale, shift) != self._folded[0]:
            scene = msgspec.structs.replace(self._scene, rest_length_scale=scale)
            self._folded = (scale, shift), shift_rest_angles(scene, shift) if shift else scene
        return self._folded[1]

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
        return self._read(self._state.x, self._state.y)

    @property
    def velocities(self) -> NDArray[np.float64]:
        """(n, 2) velocities in px/s, zero where a mass is held; a copy."""
        return self._read(self._state.vx, self._state.vy)

    @property
    def angles(self) -> NDArray[np.float64]:
        """(J,) the present angle of each angular spring, in degrees in (-180, 180]."""
        positions = self.positions
        a, b = (positions[ends[:, 1]] - positions[ends[:, 0]] for ends in self._joint_ends)
        cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
        return np.degrees(np.arctan2(cross, (a * b).sum(1)))

    @property
    def rest_angles(self) -> NDArray[np.float64]:
        """(J,) the present rest angle of each angular spring, in degrees in (-180, 180]."""
        angles = self._body.joint_rest + self._state.controls[CONTROL_SHIFT]
        if self._body.strength.present:
            angles = angles + self._state.set_angle
        return 180.0 - (180.0 - angles[self._system.joint_order]) % 360.0

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
        )

    @property
    def damage(self) -> Damage | None:
        """What has yielded and broken; None where nothing has."""
        state, system = self._state, self._system
        if not (state.set_length.any() or state.set_angle.any() or state.broken.any()):
            return None
        index = np.argsort(system.spring_order)  # of each spring of the scene, in the tables
        return Damage(
            broken=tuple(np.flatnonzero(state.broken[index]).tolist()),
            set_lengths=tuple(state.set_length[index].tolist()),
            hardened=tuple(state.hardened[index].tolist()),
            set_angles=tuple(state.set_angle[system.joint_order].tolist()),
        )

    # --------------------------------------------------------------------- inside
    def _build(self, scene: Scene, damaged: bool) -> None:
        """Make the tables of a valid scene; its state is still to be filled in.

        Args:
            scene: the scene.
            damaged: whether the state will have damage.
        """
        self._scene = scene
        system = build_system(scene, damaged)
        if scene.integrator.method == "stable_spring":
            body = clamp_stiffness(system.body, system.inverse_mass, system.held, scene.integrator.dt)
            system = dataclasses.replace(system, body=body)
        self._whole = self._system = system  # `_system` is without what has broken
        self._body = system.body
        self._state: State = new_state(system)
        joints = system.joint_order
        springs = np.stack((self._body.spring_a, self._body.spring_b), 1)
        ends = system.mass_order[springs - 1]  # of the springs of the tables, as the scene counts masses
        self._joint_ends = ends[self._body.joint_a[joints]], ends[self._body.joint_b[joints]]

    def _lacks_room_for(self, damage: Damage | None) -> bool:
        """Whether the tables are those of a body that can have no damage."""
        return damage is not None and not self._body.strength.present

    def _rows(self) -> NDArray[np.float64]:
        """(4, n) x, y, vx and vy of the scene's masses; a copy."""
        state, index = self._state, self._system.mass_index
        rows = np.empty((4, index.size))
        # The mode is of no meaning for indices that exist; with it, numpy writes without a detour.
        for row, field in zip(rows, (state.x, state.y, state.vx, state.vy), strict=True):
            field.take(index, out=row, mode="clip")
        return rows

    def _adopt(self, rows: NDArray[np.float64], damage: Damage | None) -> None:
        """Fill in the state from what `_rows` and `damage` give."""
        state, index = self._state, self._system.mass_index
        state.q[:] = state.v[:] = 0.0  # the padding, too
        state.x[index], state.y[index], state.vx[index], state.vy[index] = rows
        if self._body.strength.present:
            put_damage(state, self._system, damage)

    def _read(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        index = self._system.mass_index
        return np.column_stack((x[index], y[index]))
