"""The table of what springs and joints bear before they yield or break."""

from __future__ import annotations

from ..engine.table import Floats, Table


class Strength(Table):
    """Read-only. All arrays are empty where nothing yields or breaks."""

    present: bool  # anything yields or breaks
    breaking: Floats  # (S,) force at which a spring breaks, kg px/s²; infinite where it never does
    yielding: Floats  # (S,) force beyond which a spring yields, kg px/s², before any hardening; or infinite
    hardening: Floats  # (S,) growth of that force with the way that the rest length has moved, kg/s²
    bending: Floats  # (J,) torque beyond which a joint yields, kg px²/s²; or infinite
