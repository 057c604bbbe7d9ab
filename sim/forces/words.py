"""What the terms of `all.TERMS` and their kernels are called, by their names."""

from __future__ import annotations

from ..text import Text

TERMS = {
    "linear": Text("linear springs"),
    "angular": Text("angular springs"),
    "one-sided": Text("one-sided"),
    "air friction": Text("air friction"),
    "resistance": Text("resistance"),
    "walls": Text("walls"),
    "fillings": Text("fillings"),
    "contact": Text("contact"),
    "motors": Text("motors"),
    "pushes": Text("pushes"),
    "rails": Text("rails"),
}

CAUSES = {
    **TERMS,
    "linear stiffness": Text("linear stiffness"),
    "linear damping": Text("linear damping"),
    "angular stiffness": Text("angular stiffness"),
    "angular damping": Text("angular damping"),
}
"""What limits the time step: see `sim.motion.stability`."""

KERNELS = {
    "add_forces": Text("forces"),
    "energy": Text("energy"),
    "add_power": Text("power"),
    "add_derivatives": Text("derivatives"),
    "add_damping": Text("damping"),
    "kink_fraction": Text("kink fraction"),
    "impact_time": Text("impact time"),
}
