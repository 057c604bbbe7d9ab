"""Which part of the page's world a picture shows, and where in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..stage.looks import MARGIN, NEAR, STRIP
from ..stage.sketch import WORLD_SIZE, Floats, Sketch

ROOM = 0.5
"""How far beyond the frame a body is followed on each side, in sizes of the frame."""


@dataclass(frozen=True)
class Window:
    """The pixels of a picture: origin + step * world; y grows downwards.

    Attributes:
        size: width and height, pixels.
        x, y: pixels of the world's origin.
        step: pixels of a unit of the world.
    """

    size: tuple[int, int]
    x: float
    y: float
    step: float

    @staticmethod
    def fit(
        sketch: Sketch,
        frame: tuple[float, float, float, float],
        size: tuple[int, int],
        moves: Floats | None = None,
    ) -> Window:
        """Shows a scene's frame with the walls near it, and a body that leaves it by not too much.

        Args:
            sketch: of the scene.
            frame: of the scene's view, px.
            size: of the picture, pixels.
            moves: (n, 2) px, places that are to be seen, too.
        """
        left, right, low, high = bounds(sketch, frame, moves)
        step = min(size[0] / (right - left), size[1] / (high - low)) / MARGIN
        x = size[0] / 2.0 - step * (left + right) / 2.0
        return Window(size, x, size[1] / 2.0 + step * (low + high) / 2.0, step)

    @property
    def unit(self) -> float:
        """Width of a thin line, pixels: 1 where the world is as large as in a page of middling size."""
        return min(max(self.step * WORLD_SIZE / 600.0, 0.4), 4.0)

    def pixels(self, world: Floats) -> Floats:
        """(n, 2) of (n, 2)."""
        return np.array((self.x, self.y)) + world * np.array((self.step, -self.step))


def bounds(
    sketch: Sketch, frame: tuple[float, float, float, float], moves: Floats | None = None
) -> tuple[float, float, float, float]:
    """Left, right, low and high of what is to be seen, in the world; see `Window.fit`."""
    xmin, ymin, xmax, ymax = frame
    scale = sketch.mapping.scale
    half_x, half_y = (xmax - xmin) * scale / 2.0, (ymax - ymin) * scale / 2.0
    low, high = np.array((-half_x, -half_y)), np.array((half_x, half_y))
    _show_walls(low, high, sketch)
    if moves is not None and len(moves):
        world = sketch.mapping.to_world(moves)[:, :2]
        room = 2.0 * ROOM * np.array((half_x, half_y))
        radius = float(sketch.radius.max(initial=0.0))
        low = np.maximum(np.minimum(low, world.min(0) - radius), low - room)
        high = np.minimum(np.maximum(high, world.max(0) + radius), high + room)
    return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def _show_walls(low: Floats, high: Floats, sketch: Sketch) -> None:
    """Makes room for the surfaces of walls that would be just beyond the edge, as camera.js does."""
    if sketch.environment is None:
        return
    size = float((high - low).max())
    mapping = sketch.mapping
    for px, py, nx, ny in sketch.environment.walls.rows[:, :4]:
        point = mapping.to_world(np.array([[px, py]]))[0, :2]
        normal = np.array((nx, ny * mapping.flip))
        # From the surface to the nearest corner.
        corner = np.where(normal > 0.0, low, high)
        free = float((corner - point) @ normal)
        missing = free + STRIP * size
        if missing <= 0.0 or free > NEAR * size:
            continue
        axis = 0 if abs(normal[0]) > abs(normal[1]) else 1
        side = low if normal[axis] > 0.0 else high
        side[axis] -= missing / normal[axis]
