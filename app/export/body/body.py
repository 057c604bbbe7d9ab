"""A body at one moment, with all that acts on it, as plain numbers."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import sim
from sim import AngularSpring, LinearSpring
from sim.errors import InputError
from sim.forces.muscles import efforts, steer_of
from sim.forces.one_sided import SIDES
from sim.forces.plasticity import leaking
from sim.forces.rails import ways_of
from sim.forces.touch.walls import WallRow
from sim.model.stable_spring import clamp_stiffness
from sim.model.system import System, build_system, joint_stiffness
from sim.motion.driving import NO_RAIL, offset, velocity
from sim.scene.parts import Beat, JointMuscle, Motor, SpringMuscle, constant_force
from sim.scene.types import Circle, is_muscular

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]


@dataclass(frozen=True)
class Loop:
    """A gas or a liquid.

    Attributes:
        masses: around it, in the order in which its area is positive.
        is_gas: whether it is a gas.
        pressure: of a gas at its area, or the bulk modulus of a liquid, kg/s².
        outside: the pressure outside, kg/s².
        area: px².
    """

    masses: list[int]
    is_gas: bool
    pressure: float
    outside: float
    area: float


@dataclass(frozen=True)
class Body:
    """More numbers in the order of the scene's parts. What is broken has no stiffness and no damping.

    Attributes:
        moment: what it was made of.
        positions, velocities: (n, 2) px and px/s; a held mass is at rest unless it goes round a circle.
        mass: (n,) kg.
        radius: (n,) px.
        size: (n,) px, the radius of each solid mass, 0 of all others.
        loads: the constant forces on masses, kg px/s², by mass.
        pushes: the forces that keys work: mass, x and y in kg px/s², and the index in `State.steer`.
        efforts: (2,) of the keys, which nobody holds from now on.
        held: (n,) whether a mass is held.
        circles: the circles on which held masses go, and where each is at time zero, px, by mass.
        rails: the unit vectors of the rails on which masses are, by mass.
        ends: (S, 2) masses at the ends of each linear spring.
        stiffness, damping, rest_length: (S,) kg/s², kg/s, px.
        joints: (J, 2) linear springs of each joint.
        joint_stiffness, joint_damping, rest_angle: (J,) kg/s², kg/s, degrees.
        spring_side, joint_side: (S,) and (J,) 1 for a part that acts only beyond its rest length or angle, -1
            for one that acts only below it, 0 for one that acts on both sides.
        motors: by joint.
        broken: (S,) whether a linear spring is broken.
        walls: (W, 12) rows as in `sim.forces.touch.walls`.
        wind: of the mean wind, px/s.
        gusts: whether the wind has gusts.
        loops: gases and liquids.
        beat: of the muscles, or None if there are none.
        spring_muscles, joint_muscles: the muscles that move, by spring and by joint.
    """

    moment: sim.Moment
    positions: Floats
    velocities: Floats
    mass: Floats
    radius: Floats
    size: Floats
    loads: dict[int, tuple[float, float]]
    pushes: list[tuple[int, float, float, int]]
    efforts: tuple[float, ...]
    held: NDArray[np.bool_]
    circles: dict[int, tuple[Circle, tuple[float, float]]]
    rails: dict[int, tuple[float, float]]
    ends: Indices
    stiffness: Floats
    damping: Floats
    rest_length: Floats
    joints: Indices
    joint_stiffness: Floats
    joint_damping: Floats
    rest_angle: Floats
    spring_side: Indices
    joint_side: Indices
    motors: dict[int, Motor]
    broken: NDArray[np.bool_]
    walls: Floats
    wind: tuple[float, float]
    gusts: bool
    loops: list[Loop]
    beat: Beat | None
    spring_muscles: dict[int, SpringMuscle]
    joint_muscles: dict[int, JointMuscle]

    @property
    def scene(self) -> sim.Scene:
        """The scene of the moment."""
        return self.moment.scene

    @staticmethod
    def of(moment: sim.Moment) -> Body:
        """The body of a moment.

        Raises:
            InputError: a position or a velocity is not a finite number.
        """
        if not np.isfinite(moment.rows).all():
            raise InputError("a position or a velocity is not a finite number")
        scene, damage = moment.scene, moment.damage
        springs, joints = scene.linear_springs, scene.angular_springs
        rest_length = np.array([s.rest_length for s in springs]) * moment.rest_length_scale
        rest_angle = np.array([j.rest_angle for j in joints]) + moment.rest_angle_shift
        broken = np.zeros(len(springs), np.bool_)
        if damage is not None:
            broken[list(damage.broken)] = True
            if damage.set_lengths:
                rest_length += damage.set_lengths
            if damage.set_angles:
                rest_angle += damage.set_angles
        ends = np.array([(s.a, s.b) for s in springs], np.int64).reshape(-1, 2)
        held_springs = np.array([(j.a, j.b) for j in joints], np.int64).reshape(-1, 2)
        whole, unbent = ~broken, ~broken[held_springs].any(1)
        held = np.zeros(len(scene.masses), np.bool_)
        held[[anchor.mass for anchor in scene.anchors]] = True
        velocities = np.where(held[:, None], 0.0, moment.velocities)
        system = build_system(scene)
        rails = {int(system.mass_order[slot - 1]): way for slot, way in ways_of(system.body).items()}
        circles = _circles(moment, rails)
        for mass, (circle, _) in circles.items():
            velocities[mass] = velocity(circle, moment.time, rails.get(mass, NO_RAIL))
        environment = system.body.environment
        air = environment.air
        return Body(
            moment=moment,
            positions=np.array(moment.positions),
            velocities=velocities,
            mass=np.array([m.mass for m in scene.masses], float),
            radius=np.array([m.radius for m in scene.masses], float),
            size=np.array([m.radius if m.solid else 0.0 for m in scene.masses], float),
            loads={i: force for i, force in enumerate(map(constant_force, scene.masses)) if force},
            pushes=[
                (i, float(mass.force[0]), float(mass.force[1]), steer_of(mass.keys))
                for i, mass in enumerate(scene.masses)
                if mass.keys and mass.force
            ],
            efforts=tuple(efforts(np.array(moment.steer), moment.time).tolist())
            if moment.steer
            else (0.0, 0.0),
            held=held,
            circles=circles,
            rails=rails,
            ends=ends,
            stiffness=np.where(whole, [s.stiffness for s in springs], 0.0),
            damping=np.where(whole, [s.damping for s in springs], 0.0),
            rest_length=rest_length,
            joints=held_springs,
            joint_stiffness=np.where(unbent, joint_stiffness(scene), 0.0),
            joint_damping=np.where(unbent, [j.damping for j in joints], 0.0),
            rest_angle=180.0 - (180.0 - rest_angle) % 360.0,
            spring_side=_sides(springs),
            joint_side=_sides(joints),
            motors={i: j.motor for i, j in enumerate(joints) if j.motor},
            broken=broken,
            walls=np.array(environment.walls.rows)[:, : WallRow._fields.index("belt")],
            wind=(float(air.wind_x), float(air.wind_y)),
            gusts=bool(air.waves.size),
            loops=_loops(system, ends, np.flatnonzero(broken)),
            beat=scene.beat or None if is_muscular(scene) else None,
            spring_muscles={i: s.muscle for i, s in enumerate(springs) if s.muscle and scene.beat},
            joint_muscles={i: j.muscle for i, j in enumerate(joints) if j.muscle and scene.beat},
        )

    def softened(self) -> Body:
        """With springs and joints as soft as the stable spring makes them for the scene's time step."""
        scene = self.scene
        system = build_system(scene)
        body = clamp_stiffness(system.body, system.inverse_mass, system.held, scene.integrator.dt)
        at, springs = np.argsort(system.spring_order), body.springs
        order, unbent = system.joint_order, ~self.broken[self.joints].any(1)
        return dataclasses.replace(
            self,
            stiffness=np.where(self.broken, 0.0, body.stiffness[:springs][at]),
            damping=np.where(self.broken, 0.0, body.damping[:springs][at]),
            joint_stiffness=np.where(unbent, body.joint_stiffness[order], 0.0),
            joint_damping=np.where(unbent, body.torque_damping[1 + order], 0.0),
        )


def _sides(parts: Sequence[LinearSpring] | Sequence[AngularSpring]) -> Indices:
    return np.array([SIDES[part.only] if part.only else 0 for part in parts], np.int64)


def _circles(
    moment: sim.Moment, rails: Mapping[int, tuple[float, float]]
) -> dict[int, tuple[Circle, tuple[float, float]]]:
    circles = {}
    for anchor in moment.scene.anchors:
        if anchor.circle is not None and anchor.circle.radius > 0.0:
            x, y = moment.positions[anchor.mass].tolist()
            dx, dy = offset(anchor.circle, moment.time, rails.get(anchor.mass, NO_RAIL))
            circles[anchor.mass] = anchor.circle, (x - dx, y - dy)
    return circles


def _loops(system: System, ends: Indices, broken: Indices) -> list[Loop]:
    """The loops with their fillings, but those that these have left."""
    fillings = system.body.environment.fillings
    masses = [system.mass_order[loop - 1] for loop in fillings.loops()]
    left = set(leaking(masses, ends, broken))
    return [
        Loop(masses[k].tolist(), bool(is_gas), pressure, outside, area)
        for k, (is_gas, pressure, outside, area) in enumerate(fillings.rows.tolist())
        if k not in left
    ]
