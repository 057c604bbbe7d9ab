"""Palettes, and the colours to send so that the page shows them.

viser's page always applies the ACES filmic tone map of three.js, which dulls all colours. With ambient light
alone a mesh shows its own colour times the light, so the colour to send is the one that the tone map turns
into the wanted colour."""

from __future__ import annotations

import functools
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .looks import COLORS, TUTORIAL_COLORS

Rgb = NDArray[np.float64]

# three.js r1xx, ACESFilmicToneMapping: linear sRGB to the fit's space and back.
_IN = np.array([[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]])
_OUT = np.array([[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]])
_IN_BACK, _OUT_BACK = np.linalg.inv(_IN).T, np.linalg.inv(_OUT).T
_EXPOSURE = 0.6
LIGHT_GAIN = 2.0
"""The ambient light is pi times this: without the gain nothing gets brighter than e2e2e2."""


def rgb(text: str) -> Rgb:
    """(3,) sRGB values 0..255 of a colour such as "ff8000"."""
    return np.array([int(text[i : i + 2], 16) for i in (0, 2, 4)], float)


def linear(color: ArrayLike) -> Rgb:
    """Linear light 0..1 of (..., 3) sRGB colours 0..255."""
    c = np.asarray(color, float) / 255.0
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def sent(color: Rgb) -> NDArray[np.uint8]:
    """The colours to send for (..., 3) sRGB colours 0..255 so that the page shows them.

    Inverts, in order, the sRGB curve, the tone map's output matrix, its rational fit
    v (v + a) - b over v (c v + d) + e (Hill's fit of ACES), its input matrix, and the light.
    """
    c = np.clip(linear(color) @ _OUT_BACK, 0.0, 0.985)  # the fit never reaches 1
    p = 1.0 - 0.983729 * c
    q = 0.0245786 - 0.4329510 * c
    r = -0.000090537 - 0.238081 * c
    v = (-q + np.sqrt(q * q - 4.0 * p * r)) / (2.0 * p)
    light = v @ _IN_BACK * (_EXPOSURE / LIGHT_GAIN)
    return np.rint(np.clip(light, 0.0, 1.0) * 255.0).astype(np.uint8)


def plain(color: Rgb) -> NDArray[np.uint8]:
    """The bytes of (..., 3) sRGB colours 0..255 without any tone map."""
    return np.rint(np.clip(color, 0.0, 255.0)).astype(np.uint8)


def blend(a: Rgb, b: Rgb, part: NDArray[np.float64]) -> Rgb:
    """(n, 3) colours, `part` (n,) of the way from a to b."""
    return a + (b - a) * part[:, None]


@dataclass(frozen=True)
class Palette:
    """The colours of one scheme, (3,) sRGB 0..255 each; see `looks.COLORS`."""

    paper: Rgb
    grid: Rgb
    line: Rgb
    ink: Rgb
    text: Rgb
    brand: Rgb
    mass: Rgb
    held: Rgb
    rest: Rgb
    pulled: Rgb
    pushed: Rgb
    torque_plus: Rgb
    torque_minus: Rgb
    liquid: Rgb
    muscle: Rgb
    force: Rgb
    second: Rgb

    def css(self, name: str) -> str:
        """One of the colours in CSS notation."""
        return "#" + "".join(f"{int(part):02x}" for part in getattr(self, name))


@functools.cache
def palette(colors: str, dark: bool) -> Palette:
    """The palette of a scene's colour scheme, on white or on dark."""
    pairs = COLORS | (TUTORIAL_COLORS if colors == "tutorial" else {})
    return Palette(
        **{field.name: rgb(pairs[field.name.replace("_", "-")][dark]) for field in fields(Palette)}
    )
