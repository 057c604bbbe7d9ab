"""A motion as an animated model: a GLB file, for game engines, Blender and viewers on the web.

Each mass and each spring is a node, `mass 3` and `spring 7`. Masses have keyframes of their places; springs,
of unit length along x, follow from their first mass to the second one; muscles lie on what they move, and
swell. What does not move has no keyframes. Colours stay, as core glTF has keyframes for nodes only. Units and
axes are those of `app.export.model`; wedges and what surrounds a body but walls are left out.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

import sim
from sim.errors import InputError

from ..stage.colors import linear
from ..stage.shapes import meshes
from ..stage.sketch import Floats, Sketch
from ..words.english import name_of
from . import instances
from .clip import Clip, ClipFrame
from .glb_file import GlbFile
from .keyframes import check_size
from .model import MAX_PARTS, MUSCLES, PLATE, PX_PER_METRE, Solid, ball, plate, spring_solid, walls

_OF_MASS = 3
"""Numbers of a mass in each frame: its place."""

_OF_SPRING = 7
"""Of a spring: a rotation and a size; its place is that of its first mass."""

_OF_MUSCLE = 3
"""Of a muscle: its size; it lies where its spring or its mass is."""


def animated_glb(clip: Clip, rate: int, scale: float = PX_PER_METRE) -> bytes:
    """The animated model.

    Args:
        clip: the motion.
        rate: frames a second.
        scale: px in a metre.

    Raises:
        InputError: the scene has too many parts, or the file would be too large.
    """
    scene = clip.scene
    count, springs = len(scene.masses), len(scene.linear_springs)
    if count + springs > MAX_PARTS:
        raise InputError(f"a model has {MAX_PARTS} masses and springs at most")
    muscles = len(Sketch.plain(scene).muscles)
    check_size(clip, rate, _OF_MASS * count + _OF_SPRING * springs + _OF_MUSCLE * muscles)
    return _Animation(scene, list(clip.frames_at(rate)), rate, scale).file.bytes()


class _Animation:
    """Fills a file.

    Args:
        scene: the body.
        frames: its motion.
        rate: frames a second.
        scale: px in a metre.
    """

    def __init__(self, scene: sim.Scene, frames: list[ClipFrame], rate: int, scale: float) -> None:
        self.file, self._sketch, self._frames = GlbFile(), Sketch.plain(scene), frames
        # From the page's world to metres.
        self._metres = 1.0 / (scale * self._sketch.mapping.scale)
        self._times = np.arange(len(frames))[:, None] / rate
        self._clock: int | None = None
        self._samplers: list[dict[str, Any]] = []
        self._channels: list[dict[str, Any]] = []
        self._meshes: dict[tuple[str, tuple[float, ...]], int] = {}
        to_world = self._sketch.mapping.to_world
        places = self._metres * np.array([to_world(frame.picture.positions) for frame in frames])
        nodes = self._masses(places) + self._springs(places) + self._muscles(places) + self._walls(scene)
        root = self.file.add("nodes", name="body", children=nodes)
        tree = self.file.tree
        tree["scene"] = self.file.add("scenes", nodes=[root])
        extras = {"title": name_of(scene), "metres_per_px": 1.0 / scale, "frames_per_second": rate}
        tree["asset"]["extras"] = extras
        if self._channels:
            self.file.add("animations", name="motion", samplers=self._samplers, channels=self._channels)

    def _masses(self, places: Floats) -> list[int]:
        """Balls and the supports of held ones, of (frames, n, 3) places; returns their nodes."""
        sketch, nodes = self._sketch, []
        count, radius = len(sketch.radius), self._metres * sketch.radius
        colors = sketch.mass_colors()[count : 2 * count]
        solid = self._solid(ball(sketch.many))
        self._places = [self._sampler(places[:, i]) for i in range(count)]
        for i in range(count):
            mesh = self._mesh("mass", solid, colors[i])
            nodes.append(self._node(f"mass {i}", mesh, places[0, i], [radius[i]] * 3))
            self._channel(nodes[-1], "translation", self._places[i])
        if len(sketch.pinned):
            support = self._mesh("support", self._solid(plate(meshes()["pin"])), sketch.ink_colors()[0])
            widths = self._metres * instances.pins(sketch, self._frames[0].picture).widths
            for i, width in zip(sketch.pinned.tolist(), widths.tolist(), strict=True):
                nodes.append(self._node(f"support {i}", support, places[0, i], [width, width, PLATE * width]))
                self._channel(nodes[-1], "translation", self._places[i])
        return nodes

    def _springs(self, places: Floats) -> list[int]:
        """Coils or bars, which vanish when they break; returns their nodes."""
        sketch, nodes = self._sketch, []
        if not len(sketch.springs):
            return nodes
        drawn = [instances.springs(sketch, frame.picture, with_ropes=True) for frame in self._frames]
        half = np.unwrap([each.angles for each in drawn], axis=0) / 2.0
        turns = np.stack((0.0 * half, 0.0 * half, np.sin(half), np.cos(half)), axis=-1)
        sizes = np.array([np.stack((s.lengths, s.widths, s.widths), -1) for s in drawn]) * self._metres
        mesh = self._mesh("spring", self._solid(spring_solid(sketch)), sketch.palette.rest)
        self._turns = [self._sampler(turns[:, s]) for s in range(len(sketch.springs))]
        self._first_turns = turns[0]
        for s, a in enumerate(sketch.springs[:, 0].tolist()):
            node = self._node(f"spring {s}", mesh, places[0, a], sizes[0, s], turns[0, s])
            self._channel(node, "translation", self._places[a])
            self._channel(node, "rotation", self._turns[s])
            self._channel(node, "scale", self._sizes(sizes[:, s]))
            nodes.append(node)
        return nodes

    def _muscles(self, places: Floats) -> list[int]:
        """Plates on what muscles move, as thick as these are short; returns their nodes."""
        sketch, nodes = self._sketch, []
        for kind, flat, of_joints in MUSCLES:
            part = sketch.muscles[sketch.muscles[:, 0] == of_joints, 1].astype(int)
            if not len(part):
                continue
            drawn = [instances.muscles(sketch, frame.picture, of_joints) for frame in self._frames]
            sizes = np.array([np.stack((m.lengths, m.widths, PLATE * m.widths), -1) for m in drawn])
            sizes *= self._metres
            mesh = self._mesh("muscle", self._solid(plate(meshes()[flat])), sketch.palette.muscle)
            for k, i in enumerate(part.tolist()):
                mass = int(sketch.joint_mass[i] if of_joints else sketch.springs[i, 0])
                turn = None if of_joints else self._first_turns[i]
                node = self._node(f"muscle of {kind} {i}", mesh, places[0, mass], sizes[0, k], turn)
                self._channel(node, "translation", self._places[mass])
                self._channel(node, "rotation", None if of_joints else self._turns[i])
                self._channel(node, "scale", self._sizes(sizes[:, k]))
                nodes.append(node)
        return nodes

    def _walls(self, scene: sim.Scene) -> list[int]:
        plates = walls(self._sketch, scene)
        if plates is None:
            return []
        solid = self._solid((self._metres * plates.vertices, plates.faces))
        mesh = self._mesh("walls", solid, self._sketch.palette.line)
        return [self.file.add("nodes", name="walls", mesh=mesh)]

    # --------------------------------------------------------------------- parts of a file
    def _solid(self, solid: Solid) -> dict[str, Any]:
        from trimesh import Trimesh

        mesh = Trimesh(*solid, process=False)
        return self.file.geometry(mesh.vertices, mesh.faces, mesh.vertex_normals)

    def _mesh(self, name: str, solid: dict[str, Any], color: ArrayLike) -> int:
        """A mesh in an sRGB colour, the same one for the same name and colour."""
        light = tuple(linear(color).round(6).tolist())
        if (name, light) not in self._meshes:
            rough = {"baseColorFactor": (*light, 1.0), "metallicFactor": 0.0, "roughnessFactor": 0.6}
            material = self.file.add("materials", name=name, doubleSided=True, pbrMetallicRoughness=rough)
            primitives = [{**solid, "material": material}]
            self._meshes[name, light] = self.file.add("meshes", name=name, primitives=primitives)
        return self._meshes[name, light]

    def _node(self, name: str, mesh: int, place: Floats, size: ArrayLike, turn: Floats | None = None) -> int:
        turned = {} if turn is None else {"rotation": turn.tolist()}
        sizes = np.asarray(size).tolist()
        return self.file.add("nodes", name=name, mesh=mesh, translation=place.tolist(), scale=sizes, **turned)

    def _sizes(self, values: Floats) -> int | None:
        """Keyframes of (frames, 3) sizes, which are zero once something has vanished.

        Until that very frame it keeps its size: it does not shrink on the way there.
        """
        gone = np.flatnonzero((values == 0.0).all(1))
        if not gone.size or gone[0] == 0:
            return self._sampler(values)
        first = int(gone[0])
        times = self._times.astype(np.float32)
        until = np.nextafter(times[first], np.float32(0.0))
        clock = self.file.array(np.concatenate((times[:first], [until], times[first:])), bounds=True)
        output = self.file.array(
            np.concatenate((values[:first], values[first - 1 : first], values[first:])).astype(np.float32)
        )
        self._samplers.append({"input": clock, "output": output, "interpolation": "LINEAR"})
        return len(self._samplers) - 1

    def _sampler(self, values: Floats) -> int | None:
        """Keyframes of (frames, k) values, or None where they are all the same."""
        rows = values.astype(np.float32)
        if (rows == rows[0]).all():
            return None
        if self._clock is None:
            self._clock = self.file.array(self._times, bounds=True)
        output = self.file.array(rows)
        self._samplers.append({"input": self._clock, "output": output, "interpolation": "LINEAR"})
        return len(self._samplers) - 1

    def _channel(self, node: int, path: str, sampler: int | None) -> None:
        if sampler is not None:
            self._channels.append({"sampler": sampler, "target": {"node": node, "path": path}})
