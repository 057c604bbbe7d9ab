"""Clips that need no solver: a body that is swung about."""

from __future__ import annotations

import numpy as np

import sim
from app.export.clip import ClipFrame
from app.stage.plan import Picture


def swing(scene: sim.Scene, seconds: float = 1.0, rate: float = 60.0, start: float = 2.0) -> list[ClipFrame]:
    """Moments in which each mass goes to and fro sideways, once a second, by up to 40 px."""
    places = np.array([mass.position for mass in scene.masses])
    size = np.linspace(0.0, 40.0, len(places))
    return [
        ClipFrame(
            scene,
            Picture(places + np.outer(size * np.sin(2.0 * np.pi * k / rate), (1.0, 0.0)), start + k / rate),
        )
        for k in range(round(seconds * rate) + 1)
    ]
