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

from ..session.ghost import REFERENCE, Ghost
from ..session.session import Session
from ..stage.colors import Palette
from ..stage.plan import broken_of, yielded_of
from ..words import decimal, find, joined, number, say
from ..words.english import of, sentence
from ..words.keys import Key
from ..words.settings import label_of_choice, options_of

_NAMES: dict[str, Key] = {
    "sine": "card-sine",
    "cosine": "card-cosine",
    "radians": "card-angle",
    "degrees": "card-angle",
    "rest_angle": "card-rest-angle",
}

_BEHIND = 5.0
"""Distance of a rate-limited hand behind the pointer, px, from which on it is shown."""


def short(value: float) -> str:
    """A round number in few characters, for the ends of a slider."""
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if abs(value) >= size:
            return decimal(f"{value / size:g}{letter}")
    return decimal(f"{value:g}")


def grouped(value: float) -> str:
    """A number with its thousands in groups, unless that is long."""
    if 1e4 <= abs(value) < 1e9:
        return decimal(f"{value:,.0f}")
    return decimal(f"{value:.4g}".replace("e+0", "e").replace("e+", "e"))


NEAR_THE_LIMIT = 0.8
"""Part of the stability limit beyond which the meter is shown in any scene."""


def hud(session: Session, colors: Palette, at_rest: bool, meter: bool = False) -> str:
    """The head-up display over the canvas.

    It says whether the body moves and whether the clock keeps up, and explains the colours. The stability
    meter is there if the time step is near the limit, if the scene asks for it, or with `meter`."""
    state = _state(session, at_rest)
    lines = [f"<b>{html.escape(say(state))}</b>"] if state else []
    lines += _damage(session, colors)
    rates = session.pacer.rates(session.now())
    if rates.losing > 0.05 and rates.real_time_factor < 0.95:
        lines.append(_span("softrod-quiet", say("hud-slow", factor=decimal(f"{rates.real_time_factor:.2g}"))))
    behind = max(session.simulation.behind.values(), default=0.0)
    if behind > _BEHIND:
        distance = f"{behind:.0f} {session.scene.view.unit}"
        lines.append(_span("softrod-lag", say("hud-behind", distance=distance)))
    if session.preparing:
        lines.append(_span("softrod-quiet", session.preparing))
    dt, limit = session.simulation.dt, session.stability.limit  # infinite for methods without one
    wanted = meter or "stability" in session.scene.view.readouts or dt > NEAR_THE_LIMIT * limit
    if wanted and math.isfinite(limit):
        lines.append(_meter(dt, limit, state == "hud-rest"))
    if len(session.simulation.anchors) < len(session.simulation.scene.masses):
        gradient = ",".join(colors.css(name) for name in ("pushed", "rest", "pulled"))
        bar = f'<i class="softrod-key" style="background:linear-gradient(90deg,{gradient})"></i>'
        squeezed, stretched = html.escape(say("hud-squeezed")), html.escape(say("hud-squeezed.stretched"))
        lines.append(f'<span class="softrod-legend">{squeezed}{bar}{stretched}</span>')
    return "<br>".join(lines)


def _span(name: str, text: str) -> str:
    return f'<span class="{name}">{html.escape(text)}</span>'


def _damage(session: Session, colors: Palette) -> list[str]:
    """The numbers of broken and of yielded springs, with the mark of the latter."""
    damage, lines = session.simulation.damage, []
    if broken := len(broken_of(damage)):
        lines.append(html.escape(say("hud-broken", count=broken)))
    if damage is not None and damage.set_lengths:
        rest = np.array([spring.rest_length for spring in session.simulation.scene.linear_springs])
        if yielded := yielded_of(damage, rest):
            side, middle = colors.css("rest"), colors.css("ink")
            mark = f"linear-gradient({side} 33%,{middle} 33% 67%,{side} 67%)"
            text = html.escape(say("hud-yielded", count=yielded))
            lines.append(f'{text}<i class="softrod-key" style="background:{mark}"></i>')
    return lines


def _state(session: Session, at_rest: bool) -> Key | None:
    if session.simulation.divergence is not None:
        return "hud-stopped"
    if not session.playing:
        return "hud-past" if session.history.scrubbed else "hud-paused"
    return "hud-rest" if at_rest else None


def _meter(dt: float, limit: float, at_rest: bool) -> str:
    """A bar of the time step over the largest stable one.

    Below the limit nothing is guaranteed: the limit is that of the body's present shape.
    """
    ratio = dt / limit
    color = "good-bar" if ratio < 0.7 else "call-edge" if ratio < 1.0 else "bad"
    width = min(100.0, 100.0 * ratio)
    key: Key = "hud-step"
    if ratio >= 1.0:
        key = "hud-step.explodes" if at_rest else "hud-step.unstable"
    words = html.escape(say(key, step=decimal(f"{1e3 * dt:.3g}"), percent=f"{100.0 * ratio:.0f}"))
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
        "sine": decimal(f"{math.sin(radians):+.4f}"),
        "cosine": decimal(f"{math.cos(radians):+.4f}"),
        "radians": decimal(f"{radians:+.4f} rad"),
        "degrees": decimal(f"{angle:+.2f}°"),
        "rest_angle": decimal(f"{float(simulation.rest_angles[session.joint]):+.2f}°"),
    }
    # Named as in plots; numbers count from 0 everywhere.
    which = html.escape(say("card-of", count=len(angles)))
    rows = [f'<tr><td translate="no">joint{session.joint}</td><td>{which}</td></tr>']
    rows += [
        f"<tr><td>{html.escape(say(_NAMES[key]))}</td><td>{values[key]}</td></tr>"
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
        return say("card-mass", mass=str(mass)), {
            say("card-x"): read(f"mass{mass}.x"),
            say("card-y"): read(f"mass{mass}.y"),
            say("card-speed"): read(f"mass{mass}.speed"),
        }
    others = sum(mass_of_joint(scene, j) == mass for j in range(len(scene.angular_springs))) - 1
    title = say("card-joint", joint=str(joint))
    if others:
        title = say("card-joint.of", joint=str(joint), count=others + 1)
    return title, {
        say("card-angle"): read(f"joint{joint}.angle"),
        say("card-rest-angle"): read(f"joint{joint}.rest_angle"),
        say("card-stiffness"): f"{grouped(scene.angular_springs[joint].stiffness)} kg/s²",
        say("card-speed"): read(f"mass{mass}.speed"),
    }


def _tenths(value: float, unit: str) -> str:
    """A value with its unit; zero has no sign."""
    said = decimal(f"{round(value, 1) + 0.0:.1f}".replace("-", "−"))
    return f"{said}{'' if unit == '°' else ' '}{unit}"


def table(rows: dict[str, str]) -> str:
    cells = "".join(f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows.items())
    return f'<table class="softrod-table">{cells}</table>'


def rates_table(session: Session) -> str:
    """How fast the simulation runs."""
    rates = session.pacer.rates(session.now())
    rows = {
        say("rates-factor"): decimal(f"{rates.real_time_factor:.2f}"),
        say("rates-steps"): f"{rates.steps_per_second:.0f}",
        say("rates-solver"): decimal(f"{rates.solver_ms:.3f} ms"),
        say("rates-behind"): decimal(f"{rates.behind:.2f} s"),
    }
    if METHODS[session.simulation.method].adaptive:
        rows[say("rates-rejected")] = f"{rates.rejected_per_second:.0f}"
    if session.fallbacks:
        rows[say("rates-fallbacks")] = f"{session.fallbacks}"
    return table(rows)


def predictability_table(session: Session) -> str:
    """The growth of small errors, and what it means."""
    meter = session.predictability
    if meter is None:
        return ""
    if meter.is_compiling:
        return table({say("errors-title"): say("errors-title.compiled")})
    if meter.shadow.held:
        return table({say("errors-title"): say("errors-title.held")})
    growth = meter.growth
    if growth is None:
        return table({say("errors-grow"): say("errors-grow.measured")})
    rows = {
        say("errors-factor"): decimal(f"× {factor_of(growth):.2g}"),
        say("errors-rate"): decimal(f"{growth:+.2g} / s"),
        say("errors-time"): decimal(f"{1.0 / growth:.2g} s") if growth > 0.0 else say("errors-time.none"),
        say("errors-solver"): decimal(f"{1e3 * meter.cost:.3f} ms"),
    }
    kind = "softrod-lag" if meter.is_chaotic else "softrod-about"
    return f'{table(rows)}<div class="softrod-text {kind}">{html.escape(of(meter.verdict))}</div>'


_MORE: dict[str, Key] = {
    "linear_stiffness": "tuning-one-linear-stiffness",
    "angular_stiffness": "tuning-one-angular-stiffness",
    "gravity": "tuning-one-gravity",
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
        rows[say("tuning-slowest")] = _vibration(slowest)
    # The slowest vibration of a body may be swinging under gravity, without its springs.
    if elastic is not None and slowest is not None and elastic.frequency > 1.001 * slowest.frequency:
        rows[say("tuning-elastic")] = _vibration(elastic)
    if elastic is not None:
        calm = elastic.calm_after
        after = say("tuning-calm.after", time=_duration(calm))
        rows[say("tuning-calm")] = after if math.isfinite(calm) else say("tuning-calm.never")
    if found.fastest is not None:
        rows[say("tuning-fastest")] = _vibration(found.fastest)
    if found.sag is not None:
        pull = say("tuning-sag") if any(scene.gravity) else say("tuning-sag.loads")
        sag = f"{number(found.sag)} {html.escape(scene.view.unit)}"
        rows[pull] = say("tuning-sag.value", sag=sag, mass=str(found.sag_mass))
    for method, step in found.stable_steps.items():
        limit = say("tuning-stable", step=decimal(f"{1e3 * step:.3g}"))
        rows[options_of("method")[method]] = limit if math.isfinite(step) else say("tuning-stable.always")
    alone = found.springs
    if len(alone.frequency):
        name = say("tuning-spring", spring=str(spring))
        if spring is None:
            spring, name = int(np.argmax(alone.frequency)), say("tuning-spring-fastest")
        rows[name] = _rate(float(alone.frequency[spring]), float(alone.damping_ratio[spring]))
    for one in does:
        if effects := _effects(one, found.sag, html.escape(scene.view.unit)):
            rows[say(_MORE[one.key])] = effects
    notes = "".join(
        f'<div class="softrod-text softrod-about">{html.escape(sentence(of(note)))}</div>'
        for note in found.notes
    )
    return table(rows) + notes


def _effects(one: sim.Sensitivity, sag: float | None, unit: str) -> str:
    """The effect of 1 % more of a number; empty if negligible."""
    effects = []
    if one.sag is not None and sag is not None and abs(0.01 * one.sag) > _NEGLIGIBLE * abs(sag):
        key: Key = "tuning-more-sag" if one.sag > 0.0 else "tuning-less-sag"
        effects.append(say(key, sag=decimal(f"{abs(0.01 * one.sag):.2g} {unit}")))
    if one.frequency is not None and abs(0.01 * one.frequency) > _NEGLIGIBLE:
        key = "tuning-faster" if one.frequency > 0.0 else "tuning-slower"
        effects.append(say(key, percent=decimal(f"{abs(one.frequency):.2g}")))
    return joined(effects)


def _vibration(vibration: Vibration) -> str:
    return _rate(vibration.frequency, vibration.damping_ratio)


def _rate(frequency: float, ratio: float) -> str:
    """A frequency, its period, and a damping ratio."""
    if not frequency > 0.0:
        return say("tuning-rate.none")
    hertz, period = decimal(f"{frequency:.3g}"), _duration(1.0 / frequency)
    if ratio < 1e-4:
        return say("tuning-rate.undamped", frequency=hertz, period=period)
    return say("tuning-rate", frequency=hertz, period=period, ratio=decimal(f"{ratio:.2g}"))


def _duration(seconds: float) -> str:
    return decimal(f"{seconds:.3g} s" if seconds >= 0.1 else f"{1e3 * seconds:.3g} ms")


def ghost_name(ghost: Ghost) -> str:
    """How the ghost moves, where that differs from the body."""
    if ghost.method == REFERENCE:
        parts = [say("solver-compare.reference")]
    else:
        parts = [options_of("method")[ghost.method]]
        if ghost.finer > 1:
            key = "ghost-title.tolerance" if METHODS[ghost.method].adaptive else "ghost-title.step"
            parts.append(say(key, finer=ghost.finer))
    if ghost.law:
        parts.append(f"{label_of_choice('force_law')}: {options_of('force_law')[ghost.law]}")
    return joined(parts)


def ghost_table(session: Session) -> str:
    """The distance of the ghost from the body, and its cost."""
    ghost = session.ghost
    if ghost is None:
        return ""
    if ghost.is_compiling:
        return table({say("ghost-title"): html.escape(say("ghost-title.compiled", ghost=ghost_name(ghost)))})
    unit = html.escape(session.scene.view.unit)
    rows = {
        say("ghost-title"): html.escape(ghost_name(ghost)),
        say("ghost-distance"): f"{number(ghost.distance)} {unit}",
        say("ghost-worst"): f"{number(ghost.worst)} {unit}",
        say("ghost-solver"): decimal(f"{1e3 * ghost.cost:.3f} ms"),
    }
    if session.predictability is not None and session.predictability.growth is not None:
        factor = decimal(f"{factor_of(session.predictability.growth):.2g}")
        rows[say("ghost-error")] = say("ghost-error.factor", factor=factor)
    if ghost.simulation.divergence is not None:
        rows[say("ghost-stopped")] = say("ghost-stopped.why")
    return table(rows)


_TERMS = {term.name: term.label for term in WITH_ENERGY}

ENERGIES = (
    "kinetic", "gravity", *_TERMS, "anchors", "damping", "air", "friction", "plastic", "broken", "law",
    "keys", "muscles", "motors", "changes", "fallbacks", "residual",
)  # fmt: skip
"""Entries of the energy balance, in the order of the table."""


def energy_name(of: str) -> str:
    """The name of an entry of the energy balance."""
    return find(f"energy-{of}", _TERMS.get(of, ""))


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
        return table({say("energy-title"): say("energy-title.compiled")})
    balance = session.simulation.energy()
    rows = {say("energy-unit"): html.escape(unit_in(ENERGY_UNIT, session.scene.view.unit))}
    largest = max(abs(getattr(balance, key)) for key in ENERGIES)
    for key in ENERGIES:
        value = getattr(balance, key)
        if key in _LOSSES:
            value = -value
        if value or key in ("kinetic", "residual"):
            loaded = key == "gravity" and is_loaded(session.scene)
            rows[say("energy-gravity.loads") if loaded else energy_name(key)] = energy(value, largest)
    return table(rows)


def description(scene: sim.Scene, editable: bool) -> str:
    """A scene's description as HTML; it may come from anybody's file.

    Args:
        scene: the scene.
        editable: add the button that opens the form of texts.js in the same place.
    """
    text = f"<p>{html.escape(of(scene.description))}</p>" if scene.description else ""
    if editable:
        words = say("about-edit") if text else say("about-edit.new")
        text += f'<button type="button" class="softrod-edit-texts">{html.escape(words)}</button>'
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


HELP_PICTURES: tuple[tuple[Key, str], ...] = (
    (
        "view-help-drag",
        '<path class="softrod-help-line" d="M30 12 38 34 52 54 72 68 96 74"/>'
        '<g class="softrod-help-mass"><circle cx="30" cy="12" r="6"/><circle cx="52" cy="54" r="6"/>'
        '<circle cx="96" cy="74" r="8"/></g>'
        '<path class="softrod-help-hand" d="M96 74l4 20 5-6 8 0z"/>'
        '<path class="softrod-help-way" d="M108 66q14-12 20-32m-8 6 8-6 3 9"/>',
    ),
    (
        "view-help-change",
        '<path class="softrod-help-rail" d="M16 28h118M16 66h118"/>'
        '<path class="softrod-help-way" d="M16 28h72M16 66h34"/>'
        '<g class="softrod-help-mass"><circle cx="88" cy="28" r="8"/><circle cx="50" cy="66" r="8"/></g>'
        '<path class="softrod-help-way" d="M96 44h26m-8-6 8 6-8 6"/>',
    ),
    (
        "view-help-measure",
        '<path class="softrod-help-rail" d="M18 8v78h122"/>'
        '<path class="softrod-help-way" d="M18 60C30 0 40 0 52 50S72 92 84 54 104 20 114 50 126 66 138 52"/>',
    ),
)
"""Sentences of the help, and their pictures of 150 by 96."""


def help_html(keys: list[tuple[str, str]]) -> str:
    """The help panel, with the keys and their descriptions."""
    figures = "".join(
        f'<figure><svg viewBox="0 0 150 96" aria-hidden="true">{picture}</svg>'
        f"<figcaption>{say(text)}</figcaption></figure>"
        for text, picture in HELP_PICTURES
    )
    rows = "".join(f"<tr><td><kbd translate='no'>{key}</kbd></td><td>{what}</td></tr>" for key, what in keys)
    return (
        f'<div class="softrod-text"><div class="softrod-help">{figures}</div>'
        f"<p>{html.escape(say('view-help-time'))}</p><table>{rows}</table></div>"
    )
