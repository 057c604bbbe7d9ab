"""The texts that a page shows of a running simulation: pure functions from a session to HTML."""

from __future__ import annotations

import html
import math
from collections.abc import Sequence

import numpy as np

import sim
from sim.analysis.predictability import factor_of
from sim.analysis.tuning import Tuning, Vibration
from sim.forces.all import WITH_ENERGY
from sim.motion.quantities import ENERGY_UNIT, unit_in
from sim.scene.types import is_loaded
from sim.solve.registry import METHODS

from ..session.session import Session
from ..stage.colors import Palette
from ..stage.plan import broken_of, yielded_of

_NAMES = {
    "sine": "sine",
    "cosine": "cosine",
    "radians": "angle",
    "degrees": "angle",
    "rest_angle": "rest angle",
}

_BEHIND = 5.0
"""Distance of a rate-limited hand behind the pointer, px, from which on it is shown."""


def short(value: float) -> str:
    """A round number in few characters, for the ends of a slider."""
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if abs(value) >= size:
            return f"{value / size:g}{letter}"
    return f"{value:g}"


def grouped(value: float) -> str:
    """A number with its thousands in groups, unless that is long."""
    return (
        f"{value:,.0f}" if 1e4 <= abs(value) < 1e9 else f"{value:.4g}".replace("e+0", "e").replace("e+", "e")
    )


NEAR_THE_LIMIT = 0.8
"""Part of the stability limit beyond which the meter is shown in any scene."""


def hud(session: Session, colors: Palette, at_rest: bool, meter: bool = False) -> str:
    """The head-up display over the canvas.

    It says whether the body moves and whether the clock keeps up, and explains the colours. The stability
    meter is there if the time step is near the limit, if the scene asks for it, or with `meter`."""
    state = _state(session, at_rest)
    lines = [f"<b>{state}</b>"] if state else []
    lines += _damage(session, colors)
    rates = session.pacer.rates(session.now())
    if rates.losing > 0.05 and rates.real_time_factor < 0.95:
        lines.append(
            f'<span class="softrod-quiet">slowed down: {rates.real_time_factor:.2g} × real time</span>'
        )
    behind = max(session.simulation.behind.values(), default=0.0)
    if behind > _BEHIND:
        lines.append(
            f'<span class="softrod-lag">the body cannot follow so fast: the hand is {behind:.0f} '
            f"{html.escape(session.scene.view.unit)} behind</span>"
        )
    if session.preparing:
        lines.append(f'<span class="softrod-quiet">{html.escape(session.preparing)}</span>')
    dt, limit = session.simulation.dt, session.stability.limit  # infinite for methods without one
    wanted = meter or "stability" in session.scene.view.readouts or dt > NEAR_THE_LIMIT * limit
    if wanted and math.isfinite(limit):
        lines.append(_meter(dt, limit, state == "at rest"))
    if len(session.simulation.anchors) < len(session.simulation.scene.masses):
        gradient = ",".join(colors.css(name) for name in ("pushed", "rest", "pulled"))
        bar = f'<i class="softrod-key" style="background:linear-gradient(90deg,{gradient})"></i>'
        lines.append(f'<span class="softrod-legend">squeezed{bar}stretched</span>')
    return "<br>".join(lines)


def _damage(session: Session, colors: Palette) -> list[str]:
    """The numbers of broken and of yielded springs, with the mark of the latter."""
    damage, lines = session.simulation.damage, []
    if broken := len(broken_of(damage)):
        lines.append(f"{_springs(broken)} broken")
    if damage is not None and damage.set_lengths:
        rest = np.array([spring.rest_length for spring in session.simulation.scene.linear_springs])
        if yielded := yielded_of(damage, rest):
            side, middle = colors.css("rest"), colors.css("ink")
            mark = f"linear-gradient({side} 33%,{middle} 33% 67%,{side} 67%)"
            lines.append(f'{_springs(yielded)} yielded<i class="softrod-key" style="background:{mark}"></i>')
    return lines


def _springs(count: int) -> str:
    return f"{count} {'spring' if count == 1 else 'springs'}"


def _state(session: Session, at_rest: bool) -> str:
    if session.simulation.divergence is not None:
        return "stopped"
    if not session.playing:
        return "looking back" if session.history.scrubbed else "paused"
    return "at rest" if at_rest else ""


def _meter(dt: float, limit: float, at_rest: bool) -> str:
    """A bar of the time step over the largest stable one.

    Below the limit nothing is guaranteed: the limit is that of the body's present shape.
    """
    ratio = dt / limit
    color = "good-bar" if ratio < 0.7 else "call-edge" if ratio < 1.0 else "bad"
    width = min(100.0, 100.0 * ratio)
    words = f"time step {1e3 * dt:.3g} ms, {100.0 * ratio:.0f} % of the limit"
    if ratio >= 1.0:
        words += ": unstable, explodes when touched" if at_rest else ": unstable"
    bar = f"width:{width:.0f}%;background:var(--softrod-{color})"
    return f'<span class="softrod-meter"><i style="{bar}"></i></span>{words}'


def joint_table(session: Session) -> str:
    """The angle of the joint that is read out, in the units that the scene asks for."""
    simulation = session.simulation
    angles = simulation.angles
    if not len(angles):
        return ""
    angle = float(angles[session.joint])
    radians = math.radians(angle)
    values = {
        "sine": f"{math.sin(radians):+.4f}",
        "cosine": f"{math.cos(radians):+.4f}",
        "radians": f"{radians:+.4f} rad",
        "degrees": f"{angle:+.2f}°",
        "rest_angle": f"{float(simulation.rest_angles[session.joint]):+.2f}°",
    }
    # Named as in plots; numbers count from 0 everywhere.
    rows = [f"<tr><td>joint{session.joint}</td><td>of {len(angles)}</td></tr>"]
    rows += [
        f"<tr><td>{_NAMES[key]}</td><td>{values[key]}</td></tr>"
        for key in simulation.scene.view.readouts
        if key in values
    ]
    return f'<table class="softrod-table">{"".join(rows)}</table>'


def reading(session: Session, mass: int, joint: int | None) -> tuple[str, dict[str, str]]:
    """What stands beside a clicked mass: a title, and values by names of its joint, or of where it is."""
    scene = session.scene

    def read(name: str) -> str:
        found = sim.quantity(name, scene)
        return _tenths(found.read(session.simulation), found.unit)

    if joint is None:
        return f"Mass {mass}", {what: read(f"mass{mass}.{what}") for what in ("x", "y", "speed")}
    others = sum(mass_of_joint(scene, j) == mass for j in range(len(scene.angular_springs))) - 1
    return f"Joint {joint}" + (f" (of {others + 1} here)" if others else ""), {
        "angle": read(f"joint{joint}.angle"),
        "rest angle": read(f"joint{joint}.rest_angle"),
        "stiffness": f"{grouped(scene.angular_springs[joint].stiffness)} kg/s²",
        "speed": read(f"mass{mass}.speed"),
    }


def _tenths(value: float, unit: str) -> str:
    """A value with its unit; zero has no sign."""
    return f"{round(value, 1) + 0.0:.1f}{'' if unit == '°' else ' '}{unit}".replace("-", "−")


def table(rows: dict[str, str]) -> str:
    cells = "".join(f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows.items())
    return f'<table class="softrod-table">{cells}</table>'


def rates_table(session: Session) -> str:
    """How fast the simulation runs."""
    rates = session.pacer.rates(session.now())
    rows = {
        "real-time factor": f"{rates.real_time_factor:.2f}",
        "steps per second": f"{rates.steps_per_second:.0f}",
        "solver, per frame": f"{rates.solver_ms:.3f} ms",
        "clock behind by": f"{rates.behind:.2f} s",
    }
    if METHODS[session.simulation.method].adaptive:
        rows["rejected per second"] = f"{rates.rejected_per_second:.0f}"
    if session.fallbacks:
        rows["fallback steps"] = f"{session.fallbacks}"
    return table(rows)


def predictability_table(session: Session) -> str:
    """The growth of small errors, and what it means."""
    meter = session.predictability
    if meter is None:
        return ""
    if meter.is_compiling:
        return table({"predictability": "comes when it is compiled"})
    if meter.shadow.held:
        return table({"predictability": "no mass is free"})
    growth = meter.growth
    if growth is None:
        return table({"errors grow": "being measured, for a second"})
    rows = {
        "errors grow, last second": f"× {factor_of(growth):.2g}",
        "rate": f"{growth:+.2g} / s",
        "e-folding time": f"{1.0 / growth:.2g} s" if growth > 0.0 else "none",
        "its solver, per frame": f"{1e3 * meter.cost:.3f} ms",
    }
    kind = "softrod-lag" if meter.is_chaotic else "softrod-about"
    words = html.escape(meter.verdict)
    return f'{table(rows)}<div class="softrod-text {kind}">{words[:1].upper()}{words[1:]}.</div>'


_MORE = {
    "linear_stiffness": "stiffness of the springs",
    "angular_stiffness": "stiffness of the joints",
    "gravity": "gravity",
}
_NEGLIGIBLE = 1e-5
"""Relative effect of 1 % of a number below which it is not shown."""


def tuning_table(
    scene: sim.Scene,
    found: Tuning,
    spring: int | None,
    does: Sequence[sim.Sensitivity] = (),
) -> str:
    """What the parameters of a scene mean for its motion.

    Args:
        scene: the scene.
        found: the analysis of its vibrations.
        spring: a spring that is described alone; None for the fastest one.
        does: the effects of its parameters.
    """
    rows: dict[str, str] = {}
    slowest, elastic = found.slowest, found.elastic
    if slowest is not None:
        rows["slowest vibration"] = _vibration(slowest)
    # The slowest vibration of a body may be swinging under gravity, without its springs.
    if elastic is not None and slowest is not None and elastic.frequency > 1.001 * slowest.frequency:
        rows["slowest elastic one"] = _vibration(elastic)
    if elastic is not None:
        calm = elastic.calm_after
        rows["calm after"] = f"{_duration(calm)}, to a tenth" if math.isfinite(calm) else "never: undamped"
    if found.fastest is not None:
        rows["fastest vibration"] = _vibration(found.fastest)
    if found.sag is not None:
        pull = "gravity" if any(scene.gravity) else "its loads"
        rows[f"sag under {pull}"] = f"{found.sag:.3g} {html.escape(scene.view.unit)}, mass {found.sag_mass}"
    for method, step in found.stable_steps.items():
        limit = f"stable to {1e3 * step:.3g} ms" if math.isfinite(step) else "stable at any step"
        rows[METHODS[method].label] = limit
    alone = found.springs
    if len(alone.frequency):
        name = f"spring {spring} alone"
        if spring is None:
            spring, name = int(np.argmax(alone.frequency)), "fastest spring alone"
        rows[name] = _rate(float(alone.frequency[spring]), float(alone.damping_ratio[spring]))
    for one in does:
        if effects := _effects(one, found.sag, html.escape(scene.view.unit)):
            rows[f"1 % more {_MORE[one.key]}"] = effects
    notes = "".join(
        f'<div class="softrod-text softrod-about">{html.escape(note[:1].upper() + note[1:])}.</div>'
        for note in found.notes
    )
    return table(rows) + notes


def _effects(one: sim.Sensitivity, sag: float | None, unit: str) -> str:
    """The effect of 1 % more of a number; empty if negligible."""
    effects = []
    if one.sag is not None and sag is not None and abs(0.01 * one.sag) > _NEGLIGIBLE * abs(sag):
        effects.append(f"{abs(0.01 * one.sag):.2g} {unit} {'more' if one.sag > 0.0 else 'less'} sag")
    if one.frequency is not None and abs(0.01 * one.frequency) > _NEGLIGIBLE:
        effects.append(f"{abs(one.frequency):.2g}\u00a0% {'faster' if one.frequency > 0.0 else 'slower'}")
    return ", ".join(effects)


def _vibration(vibration: Vibration) -> str:
    return _rate(vibration.frequency, vibration.damping_ratio)


def _rate(frequency: float, ratio: float) -> str:
    """A frequency, its period, and a damping ratio."""
    if not frequency > 0.0:
        return "none"
    damped = "undamped" if ratio < 1e-4 else f"damping ratio {ratio:.2g}"
    return f"{frequency:.3g} Hz, {_duration(1.0 / frequency)}, {damped}"


def _duration(seconds: float) -> str:
    return f"{seconds:.3g} s" if seconds >= 0.1 else f"{1e3 * seconds:.3g} ms"


def ghost_table(session: Session) -> str:
    """The distance of the ghost from the body, and its cost."""
    ghost = session.ghost
    if ghost is None:
        return ""
    if ghost.is_compiling:
        return table({"ghost": f"{html.escape(ghost.label)}: comes when it is compiled"})
    unit = html.escape(session.scene.view.unit)
    rows = {
        "ghost": html.escape(ghost.label),
        "distance now": f"{ghost.distance:.3g} {unit}",
        "largest distance": f"{ghost.worst:.3g} {unit}",
        "ghost's solver, per frame": f"{1e3 * ghost.cost:.3f} ms",
    }
    if session.predictability is not None and session.predictability.growth is not None:
        rows["any error grows"] = f"× {factor_of(session.predictability.growth):.2g} in a second"
    if ghost.simulation.divergence is not None:
        rows["ghost stopped"] = "it exploded"
    return table(rows)


ENERGY_NAMES = {
    "kinetic": "kinetic",
    "gravity": "height",
    **{term.name: term.label for term in WITH_ENERGY},
    "anchors": "work of your hand",
    "damping": "lost to damping",
    "air": "lost to air and medium",
    "friction": "lost to walls, ground, contact",
    "plastic": "lost in yielding",
    "broken": "lost in breaking",
    "law": "made by the tutorial's law",
    "keys": "work of the keys",
    "muscles": "work of the muscles",
    "motors": "work of the motors",
    "changes": "changes of settings",
    "fallbacks": "lost in fallback steps",
    "residual": "residual: the method's error",
}
"""Names of the entries of the energy balance in the table."""


_LOSSES = ("damping", "air", "friction", "plastic", "broken", "fallbacks")
"""Entries that the table shows with the other sign, as losses."""


def energy(value: float, largest: float) -> str:
    """An energy as text; 0 if it is negligible against the largest, or too small for any motion to be
    seen."""
    if abs(value) <= max(1e-12 * largest, 1e-9):
        return "0"
    return grouped(value)


def energy_table(session: Session) -> str:
    """The energies and what has changed them; entries that are zero are left out."""
    if not session.follows_energy:
        return ""
    if not session.simulation.track_energy(True):
        return table({"energy": "is followed when it is compiled"})
    balance = session.simulation.energy()
    rows = {"unit": html.escape(unit_in(ENERGY_UNIT, session.scene.view.unit))}
    largest = max(abs(getattr(balance, key)) for key in ENERGY_NAMES)
    for key, name in ENERGY_NAMES.items():
        value = getattr(balance, key)
        if key in _LOSSES:
            value = -value
        if value or key in ("kinetic", "residual"):
            loaded = key == "gravity" and is_loaded(session.scene)
            rows[f"{name} and loads" if loaded else name] = energy(value, largest)
    return table(rows)


def description(scene: sim.Scene, editable: bool) -> str:
    """A scene's description as HTML; it may come from anybody's file.

    Args:
        scene: the scene.
        editable: add the button that opens the form of texts.js in the same place.
    """
    text = f"<p>{html.escape(scene.description)}</p>" if scene.description else ""
    if editable:
        words = "Edit name and text" if text else "Name this scene, and say what it shows"
        text += f'<button type="button" class="softrod-edit-texts">{words}</button>'
    return f'<div id="softrod-about" class="softrod-text softrod-about">{text}</div>' if text else ""


def joint_of_mass(scene: sim.Scene, mass: int) -> int | None:
    """The joint to read out when a mass is clicked: the first one at it."""
    for j, joint in enumerate(scene.angular_springs):
        a, b = scene.linear_springs[joint.a], scene.linear_springs[joint.b]
        if mass in {a.a, a.b} & {b.a, b.b}:
            return j
    return None


def mass_of_joint(scene: sim.Scene, joint: int) -> int:
    """The mass shared by the springs of a joint; the first end of its first spring if there is none."""
    of = scene.angular_springs[joint]
    a, b = scene.linear_springs[of.a], scene.linear_springs[of.b]
    return min({a.a, a.b} & {b.a, b.b}, default=a.a)


HELP_PICTURES = (
    (
        "Drag",
        '<path class="softrod-help-line" d="M30 12 38 34 52 54 72 68 96 74"/>'
        '<g class="softrod-help-mass"><circle cx="30" cy="12" r="6"/><circle cx="52" cy="54" r="6"/>'
        '<circle cx="96" cy="74" r="8"/></g>'
        '<path class="softrod-help-hand" d="M96 74l4 20 5-6 8 0z"/>'
        '<path class="softrod-help-way" d="M108 66q14-12 20-32m-8 6 8-6 3 9"/>',
        "any mass. Held ones stay where you leave them, free ones fall. Drag the paper to move it, scroll or "
        "pinch to zoom.",
    ),
    (
        "Change",
        '<path class="softrod-help-rail" d="M16 28h118M16 66h118"/>'
        '<path class="softrod-help-way" d="M16 28h72M16 66h34"/>'
        '<g class="softrod-help-mass"><circle cx="88" cy="28" r="8"/><circle cx="50" cy="66" r="8"/></g>'
        '<path class="softrod-help-way" d="M96 44h26m-8-6 8 6-8 6"/>',
        "stiffness, damping, lengths and angles in the Play tab, or draw a body of your own with Edit.",
    ),
    (
        "Measure",
        '<path class="softrod-help-rail" d="M18 8v78h122"/>'
        '<path class="softrod-help-way" d="M18 60C30 0 40 0 52 50S72 92 84 54 104 20 114 50 126 66 138 52"/>',
        "with plots that read off period and damping, with arrows, a ruler, a protractor and a stopwatch.",
    ),
)
"""Pictures of the help: a word, a picture of 150 by 96, and the rest of the sentence."""


def help_html(keys: list[tuple[str, str]]) -> str:
    """The help panel, with the keys and their descriptions."""
    figures = "".join(
        f'<figure><svg viewBox="0 0 150 96" aria-hidden="true">{picture}</svg>'
        f"<figcaption><b>{title}</b> {text}</figcaption></figure>"
        for title, picture, text in HELP_PICTURES
    )
    rows = "".join(f"<tr><td><kbd translate='no'>{key}</kbd></td><td>{what}</td></tr>" for key, what in keys)
    return (
        f'<div class="softrod-text"><div class="softrod-help">{figures}</div>'
        "<p>The bar below the body goes back to any moment of the run. Play goes on from the moment that it "
        "shows; what happened before you went back stays as a thin line. Click or tap a mass to read its "
        f"joint.</p><table>{rows}</table></div>"
    )
