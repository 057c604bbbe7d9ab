"""Draws one pose of a scene into an image, as the page draws it.

Matplotlib's renderer fills the outlines, which it smooths by the area that they cover; nothing else of
Matplotlib is used. It is imported with the first picture, since it takes a while.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from sim import Scene

from ..stage.colors import palette
from ..stage.looks import ARROW, LAYERS, RESTS
from ..stage.plan import Picture, broken_of
from ..stage.shapes import meshes
from ..stage.sketch import Floats, Sketch
from . import around, instances
from .instances import Instances
from .window import Window

if TYPE_CHECKING:
    from matplotlib.path import Path

SMALLEST, LARGEST = 16, 4096
"""Pixels of a side of a picture."""

TOGETHER = 400
"""Parts that are drawn in one call, which holds the interpreter: some milliseconds."""

_CRISP = ("grid", "major")
"""Layers whose lines are moved onto whole pixels."""

_GROUND = 100_000_000
"""Numbers beyond which the renderer's integers would overflow."""


class Painter:
    """Draws pictures of a scene, one after the other.

    Args:
        scene: what is drawn.
        size: width and height, pixels, `SMALLEST`..`LARGEST` each.
        dark: whether on dark paper.
        grid: whether the paper has a grid.
        window: which part is shown; the scene's frame unless given.

    Raises:
        ValueError: the size is out of range.
    """

    def __init__(
        self,
        scene: Scene,
        size: tuple[int, int],
        dark: bool = False,
        grid: bool = True,
        window: Window | None = None,
    ) -> None:
        if not all(SMALLEST <= side <= LARGEST for side in size):
            raise ValueError(f"a picture has {SMALLEST} to {LARGEST} pixels on each side, not {size}")
        self.scene = scene
        self.sketch = Sketch.plain(scene, dark)
        self.window = window or Window.fit(self.sketch, scene.view.frame, size)
        self._own = palette("softrod", dark)
        self._rest_angles = np.array([joint.rest_angle for joint in scene.angular_springs])
        self._paper = self._blank(size, grid)

    def paint(self, picture: Picture) -> Image.Image:
        """An RGB image of a pose.

        Raises:
            ValueError: a position is not a finite number.
        """
        if not np.isfinite(picture.positions).all():
            raise ValueError("a position is not a finite number")
        sketch, pen = self.sketch, self._paper.copy()
        broken = broken_of(picture.damage)
        lines, wide = around.skin(sketch, picture.positions, broken, self.window)
        self._lay(pen, "skin", list(lines), wide / self.window.unit)
        for gas, polygon in around.fillings(sketch, picture.positions, broken, self.window):
            self._lay(pen, "gas" if gas else "liquid", [polygon])
        self._lay(pen, "wind", around.streaks(sketch, picture.time, self.window))
        if len(sketch.muscles):
            pen.stamp("disc", instances.muscles(sketch, picture, of_joints=True))
            pen.stamp("belly", instances.muscles(sketch, picture, of_joints=False))
        pen.stamp("pin", instances.pins(sketch, picture))
        if len(sketch.springs):
            pen.stamp(sketch.spring_shape, instances.springs(sketch, picture))
        if len(sketch.ropes):
            pen.stamp("bar", instances.ropes(sketch, picture))
        if sketch.yields:
            pen.stamp("bar", instances.yielded(sketch, picture))
        if len(self._rest_angles):
            pen.stamp("slice", instances.wedges(sketch, picture, self._rest_angles))
        pen.stamp("ring", instances.ring(sketch, picture))
        pen.stamp("disc", instances.masses(sketch, picture))
        if picture.ghost is not None and np.isfinite(picture.ghost).all():
            pen.stamp("bar", instances.ghost(sketch, picture))
        if len(sketch.loads):
            shafts, heads = around.load_arrows(sketch, picture.positions, self.window)
            pen.lines(list(shafts), self._own.force, ARROW)
            pen.fill(list(heads), self._own.force)
        if len(sketch.motors) or len(sketch.pushes):
            works, rests = around.driven_arrows(sketch, picture, self.window)
            pen.lines(rests, self._own.force, ARROW, RESTS, round_ends=True)
            pen.lines(works, self._own.force, ARROW, round_ends=True)
        return pen.image()

    def _lay(self, pen: _Pen, name: str, lines: list[Floats], width: float = 0.0) -> None:
        """Draw one of `looks.LAYERS`; `width` is for one that has none of its own."""
        layer = LAYERS[name]
        color, wide = getattr(self._own, layer.color), width if layer.width is None else layer.width
        if layer.width == 0.0:
            pen.fill(lines, color, layer.opacity)
        else:
            pen.lines(lines, color, wide, layer.opacity, crisp=name in _CRISP, round_ends=layer.round)

    def _blank(self, size: tuple[int, int], grid: bool) -> _Pen:
        """Paper, grid, a medium, the ground and walls, which stay."""
        sketch, window = self.sketch, self.window
        pen = _Pen(window)
        width, height = size
        all_of_it = [np.array(((0, 0), (width, 0), (width, height), (0, height)), float)]
        pen.fill(all_of_it, self._own.paper)
        if grid:
            thin, thick = around.grid(sketch, self.scene.view.frame, window)
            self._lay(pen, "grid", list(thin))
            self._lay(pen, "major", list(thick))
        self._lay(pen, "medium", all_of_it if sketch.medium else [])
        self._lay(pen, "ripple", list(around.ripples(sketch, window)))
        self._lay(pen, "ground", all_of_it if sketch.ground else [])
        self._lay(pen, "grain", list(around.grains(sketch, window)))
        walls = around.walls(sketch, window)
        self._lay(pen, "wall", [wall.corners for wall in walls if len(wall.corners)])
        strokes = [stroke for wall in walls for stroke in around.hatching(wall, sketch, window)]
        self._lay(pen, "hatch", strokes)
        self._lay(pen, "surface", [wall.surface for wall in walls if len(wall.surface)])
        self._lay(pen, "rail", around.rails(sketch, window))
        return pen


def paint(
    scene: Scene,
    positions: Floats | None = None,
    size: tuple[int, int] = (640, 360),
    dark: bool = False,
    grid: bool = True,
    ghost: Floats | None = None,
) -> Image.Image:
    """An RGB image of one pose of a scene.

    Args:
        scene: what is drawn.
        positions: (n, 2) px; where the scene starts unless given.
        size: width and height, pixels, `SMALLEST`..`LARGEST` each.
        dark: whether on dark paper.
        grid: whether the paper has a grid.
        ghost: (n, 2) px of a second body, drawn as thin lines, or None.

    Raises:
        ValueError: the size is out of range, or a position is not a finite number.
    """
    picture = Picture.at_start(scene)
    if positions is not None:
        picture = replace(picture, positions=np.asarray(positions, float))
    return Painter(scene, size, dark, grid).paint(replace(picture, ghost=ghost))


class _Pen:
    """An image that is being drawn.

    Args:
        window: of the picture.
        pixels: what it begins with, (height, width, 4); nothing unless given.
    """

    def __init__(self, window: Window, pixels: NDArray[np.uint8] | None = None) -> None:
        from matplotlib.backends.backend_agg import RendererAgg

        self._window = window
        width, height = window.size
        # At 72 points an inch a point is a pixel.
        self._renderer: Any = RendererAgg(width, height, 72)  # its types say less than it takes
        if pixels is not None:
            self._pixels()[:] = pixels

    def copy(self) -> _Pen:
        """The same, to be drawn on."""
        return _Pen(self._window, self._pixels())

    def image(self) -> Image.Image:
        """What is drawn, without transparency."""
        return Image.frombuffer("RGBA", self._window.size, self._renderer.buffer_rgba()).convert("RGB")

    def _pixels(self) -> NDArray[np.uint8]:
        return np.asarray(self._renderer.buffer_rgba())

    def fill(self, polygons: list[Floats], color: Floats, opacity: float = 1.0) -> None:
        """Fill polygons, pixels, as one area: where they overlap they are no darker."""
        if polygons:
            self._draw(_area(polygons), color, opacity, 0.0)

    def lines(
        self,
        lines: list[Floats],
        color: Floats,
        width: float,
        opacity: float = 1.0,
        crisp: bool = False,
        round_ends: bool = False,
    ) -> None:
        """Draw lines, pixels, so wide in units of the window's thin line.

        Args:
            lines: (k, 2) each.
            color, width, opacity: of all.
            crisp: whether they are aligned with whole pixels, and at least one pixel wide.
            round_ends: whether they end in half circles.
        """
        if lines:
            width = max(width * self._window.unit, 1.0 if crisp else 0.0)
            self._draw(_strokes(lines), color, opacity, width, crisp, round_ends)

    def stamp(self, mesh: str, parts: Instances) -> None:
        """Fill copies of a mesh, in their order; those of one colour that follow each other are one area,
        without seams.

        Args:
            mesh: its name, see `app.stage.shapes`.
            parts: the copies.
        """
        from matplotlib.path import Path
        from matplotlib.transforms import IdentityTransform

        parts = parts.seen()
        if not len(parts.angles):
            return
        shape = _area(meshes()[mesh].outlines)
        x, y = np.asarray(shape.vertices, float).T
        along, across = x * parts.lengths[:, None], y * parts.widths[:, None]
        cosine, sine = np.cos(parts.angles)[:, None], np.sin(parts.angles)[:, None]
        turned = np.stack((along * cosine - across * sine, along * sine + across * cosine), axis=-1)
        corners = self._window.pixels(parts.places[:, None] + turned)
        corners[..., 1] = self._window.size[1] - corners[..., 1]  # the renderer's y grows upwards
        corners = np.clip(corners, -_GROUND, _GROUND)
        starts = np.flatnonzero(np.any(np.diff(parts.colors, axis=0, prepend=-1), axis=1))
        paths = [
            Path(some.reshape(-1, 2), np.tile(shape.codes, len(some)))  # type: ignore[arg-type]
            for some in np.split(corners, starts[1:])
        ]
        faces = np.column_stack((parts.colors[starts] / 255.0, np.ones(len(starts))))
        context, same = self._renderer.new_gc(), IdentityTransform()
        for i in range(0, len(faces), TOGETHER):
            some, inks = paths[i : i + TOGETHER], faces[i : i + TOGETHER]
            offsets = np.zeros((len(some), 2))  # there are as many copies as offsets
            self._renderer.draw_path_collection(
                context, same, some, np.zeros((0, 3, 3)), offsets, same, inks, np.zeros((0, 4)), [], [],
                [True], [], "screen",
            )  # fmt: skip
        context.restore()

    def _draw(
        self,
        path: Path,
        color: Floats,
        opacity: float,
        width: float,
        crisp: bool = False,
        round_ends: bool = False,
    ) -> None:
        from matplotlib.transforms import Affine2D

        context = self._renderer.new_gc()
        red, green, blue = (float(part) / 255.0 for part in color)
        context.set_linewidth(width)
        context.set_foreground((red, green, blue, opacity), isRGBA=True)
        context.set_alpha(opacity)
        context.set_snap(crisp)
        context.set_capstyle("round" if round_ends else "butt")
        flip = Affine2D().scale(1.0, -1.0).translate(0.0, self._window.size[1])
        face = (red, green, blue, opacity) if width == 0.0 else None
        self._renderer.draw_path(context, path, flip, face)
        context.restore()


def _area(polygons: Sequence[Floats]) -> Path:
    """Closed polygons as one path."""
    from matplotlib.path import Path

    vertices = np.concatenate([np.vstack((polygon, polygon[:1])) for polygon in polygons])
    codes = np.full(len(vertices), Path.LINETO)
    ends = np.cumsum([len(polygon) + 1 for polygon in polygons])
    codes[ends - 1] = Path.CLOSEPOLY
    codes[[0, *ends[:-1]]] = Path.MOVETO
    return Path(vertices, codes)


def _strokes(lines: list[Floats]) -> Path:
    """Open lines as one path."""
    from matplotlib.path import Path

    codes = np.full(sum(map(len, lines)), Path.LINETO)
    codes[np.cumsum([0, *(len(line) for line in lines[:-1])])] = Path.MOVETO
    return Path(np.concatenate(lines), codes)
