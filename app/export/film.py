"""A film as a GIF, which every browser, mail program and slide show plays."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy.spatial import KDTree

import sim

from ..stage.sketch import Sketch
from .clip import Clip
from .painter import Painter
from .window import Window, bounds

WIDTH = 640
"""Pixels of a film's longer side."""

TICK = 0.01
"""Seconds; a GIF counts in these."""

TICKS = 4
"""Between two frames: 25 frames a second, and fewer of a long or large film."""

MAX_PIXELS = 160_000_000
"""Of all frames together, which are in memory at once."""

_SAMPLES = 6
"""Frames from which the film's colours are taken."""

_COLORS = 255
"""Colours of a film, of the 256 that a GIF can have."""

_EXACT = 16
"""How many of them are the most frequent ones, unchanged."""

_CELLS = 64
"""On each side of the cube of colours: what is in one cell gets the same colour of the film."""

Progress = Callable[[float], None]
"""Called from time to time with the fraction that is done, 0..1; what it raises ends the work."""


def size_of(scene: sim.Scene, clip: Clip | None = None, longer: int = WIDTH) -> tuple[int, int]:
    """A picture's width and height, pixels, in the shape of what is to be seen.

    Args:
        scene: what is drawn.
        clip: its motion, or None.
        longer: the longer side.
    """
    sketch = Sketch.plain(scene)
    left, right, low, high = bounds(sketch, scene.view.frame, clip.places() if clip is not None else None)
    ratio = min(max((right - left) / (high - low), 0.5), 2.0)
    shorter = 2 * round(longer / max(ratio, 1.0 / ratio) / 2.0)
    return (longer, shorter) if ratio >= 1.0 else (shorter, longer)


def gif(
    clip: Clip, size: tuple[int, int] | None = None, dark: bool = False, progress: Progress | None = None
) -> bytes:
    """A film of a clip, in its own time, that plays again and again.

    Args:
        clip: what is shown.
        size: width and height, pixels, 16..4096 each; by the clip's shape unless given.
        dark: whether on dark paper.
        progress: is told how far it is, see `Progress`.
    """
    size = size or size_of(clip.scene, clip)
    ticks = TICKS
    while clip.count(ticks * TICK) * size[0] * size[1] > MAX_PIXELS:
        ticks += 1
    report = progress or (lambda _: None)
    count = clip.count(ticks * TICK)
    film = _paint(clip, ticks * TICK, size, dark)
    reduce = _Colors(clip, size, dark).reduce

    def frames() -> Iterator[Image.Image]:
        for done, image in enumerate(film, start=1):
            yield reduce(image)
            report(0.95 * done / count)

    rest = frames()
    first, out = next(rest), io.BytesIO()
    # The last pose stays for a second.
    durations = [10 * ticks] * (count - 1) + [1000]
    first.save(
        out, "GIF", save_all=True, append_images=rest, duration=durations, loop=0, optimize=False, disposal=1
    )
    report(1.0)
    return out.getvalue()


def _paint(clip: Clip, interval: float, size: tuple[int, int], dark: bool) -> Iterator[Image.Image]:
    painter: Painter | None = None
    window: Window | None = None
    for frame in clip.at(interval):
        if painter is None or painter.scene is not frame.scene:
            painter = Painter(frame.scene, size, dark, window=window)
            if window is None:  # the same for the whole film
                window = Window.fit(painter.sketch, clip.scene.view.frame, size, clip.places())
                painter = Painter(frame.scene, size, dark, window=window)
        yield painter.paint(frame.picture)


class _Colors:
    """The colours of a film: 255 that are nearest to those of some of its frames.

    How often there is a colour counts by its square root, or all of them would be paper. The most frequent
    ones stay as they are: Pillow's own quantisation would turn white paper into nearly white paper.
    """

    def __init__(self, clip: Clip, size: tuple[int, int], dark: bool) -> None:
        some = _paint(clip, clip.seconds / (_SAMPLES - 1), size, dark)
        packed = np.concatenate([np.asarray(image).reshape(-1, 3) for image in some]).astype(np.uint32)
        colors, counts = np.unique(packed @ np.array((65536, 256, 1), np.uint32), return_counts=True)
        order = np.argsort(counts, kind="stable")[::-1]
        exact, others = _channels(colors[order[:_EXACT]]), order[_EXACT:]
        chosen = exact
        if len(others):
            weighted = np.repeat(colors[others], np.ceil(np.sqrt(counts[others])).astype(int))
            image = Image.fromarray(_channels(weighted)[None])
            nearest = image.quantize(_COLORS - _EXACT, Image.Quantize.MEDIANCUT).getpalette() or []
            chosen = np.vstack((exact, np.array(nearest, np.uint8).reshape(-1, 3)))[:_COLORS]
        self._palette = chosen.ravel().tolist()
        cells = np.indices((_CELLS,) * 3).reshape(3, -1).T * (256 // _CELLS) + 128 // _CELLS
        self._nearest: NDArray[np.uint8] = np.asarray(KDTree(chosen.astype(float)).query(cells)[1], np.uint8)
        # The most frequent one last: it has its cell.
        for index in range(len(exact) - 1, -1, -1):
            self._nearest[_cell(exact[index])] = index

    def reduce(self, image: Image.Image) -> Image.Image:
        """An image in the film's colours."""
        indices = self._nearest[_cell(np.asarray(image))]
        reduced = Image.fromarray(indices)
        reduced.putpalette(self._palette)
        return reduced


def _channels(packed: NDArray[np.uint32]) -> NDArray[np.uint8]:
    """(k, 3) of (k,) colours."""
    return np.stack([packed >> 16, packed >> 8, packed], axis=-1).astype(np.uint8)


def _cell(colors: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """(...) the cell of the cube of colours that each of (..., 3) colours is in."""
    part = (colors // (256 // _CELLS)).astype(np.uint32)
    return (part[..., 0] * _CELLS + part[..., 1]) * _CELLS + part[..., 2]
