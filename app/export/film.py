"""A film as a GIF, which every browser, mail program and slide show plays."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import sim

from ..page.colors import palette, plain
from ..page.drawing import Sketch
from .clip import Clip
from .painter import Painter
from .window import Window, bounds

WIDTH = 640
"""Pixels of a film's longer side."""

TICK = 0.01
"""Seconds; a GIF counts in these."""

TICKS = 4
"""Between two frames: 25 frames a second, and fewer of a long or large film."""

MOST_PIXELS = 160_000_000
"""Of all frames together, which are in memory at once."""

_SAMPLES = 6
"""Frames from which the film's colours are taken."""

_COLORS, _EXACT = 255, 16
"""Of a film, and how many of them are the most frequent ones as they are: paper is not to be nearly white."""

Progress = Callable[[float], None]
"""Is called now and then with the part that is done, 0..1; what it raises ends the work."""


def size_of(scene: sim.Scene, clip: Clip | None = None, longer: int = WIDTH) -> tuple[int, int]:
    """A picture's width and height, pixels, in the shape of what is to be seen.

    Args:
        scene: what is drawn.
        clip: its motion, or None.
        longer: the longer side.
    """
    sketch = Sketch(scene, palette(scene.view.colors, dark=False), plain)
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
        progress: hears how far it is.
    """
    size = size or size_of(clip.scene, clip)
    ticks = TICKS
    while clip.count(ticks * TICK) * size[0] * size[1] > MOST_PIXELS:
        ticks += 1
    tell = progress or (lambda _: None)
    count = clip.count(ticks * TICK)
    film = _paint(clip, ticks * TICK, size, dark)
    chosen = _chosen_colors(clip, size, dark)

    def frames() -> Iterator[Image.Image]:
        for done, image in enumerate(film, start=1):
            yield image.quantize(palette=chosen, dither=Image.Dither.NONE)
            tell(0.95 * done / count)

    rest = frames()
    first, out = next(rest), io.BytesIO()
    # The last pose stays for a second.
    durations = [10 * ticks] * (count - 1) + [1000]
    first.save(
        out, "GIF", save_all=True, append_images=rest, duration=durations, loop=0, optimize=False, disposal=1
    )
    tell(1.0)
    return out.getvalue()


def _paint(clip: Clip, interval: float, size: tuple[int, int], dark: bool) -> Iterator[Image.Image]:
    painter: Painter | None = None
    window: Window | None = None
    for shot in clip.at(interval):
        if painter is None or painter.scene is not shot.scene:
            painter = Painter(shot.scene, size, dark, window=window)
            if window is None:  # the same for the whole film
                window = Window.fit(painter.sketch, clip.scene.view.frame, size, clip.places())
                painter = Painter(shot.scene, size, dark, window=window)
        yield painter.paint(shot.picture)


def _chosen_colors(clip: Clip, size: tuple[int, int], dark: bool) -> Image.Image:
    """An image whose palette is nearest to the colours of some frames.

    How often there is a colour counts by its square root, or all of them would be paper.
    """
    some = list(_paint(clip, clip.seconds / (_SAMPLES - 1), size, dark))
    pixels = np.concatenate([np.asarray(image).reshape(-1, 3) for image in some])
    packed = pixels.astype(np.uint32) @ np.array((65536, 256, 1), np.uint32)
    colors, counts = np.unique(packed, return_counts=True)
    order = np.argsort(counts)[::-1]
    exact, others = colors[order[:_EXACT]], order[_EXACT:]
    chosen = list(_channels(exact).ravel())
    if len(others):
        weighted = np.repeat(colors[others], np.ceil(np.sqrt(counts[others])).astype(int))
        nearest = Image.fromarray(_channels(weighted)[None]).quantize(
            _COLORS - _EXACT, Image.Quantize.MEDIANCUT
        )
        chosen += (nearest.getpalette() or [])[: 3 * (_COLORS - _EXACT)]
    image = Image.new("P", (1, 1))
    image.putpalette(chosen)
    return image


def _channels(packed: NDArray[np.uint32]) -> NDArray[np.uint8]:
    """(k, 3) of (k,) colours."""
    return np.stack([packed >> 16, packed >> 8, packed], axis=-1).astype(np.uint8)
