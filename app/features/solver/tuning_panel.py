"""What the numbers of a scene mean, and buttons that change them: a part of the Solver tab."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from functools import partial

import viser

import sim
from sim.analysis.decay import TENTH
from sim.analysis.tuning import Numbers, Tuning
from sim.compiling.compiler import for_balance, is_ready
from sim.design.tune import as_far_as_stable, damp_springs, edit_of, is_limited, with_numbers
from sim.design.wishes import Design, Factors, step_method
from sim.edit.edit import Edit, Selection
from sim.errors import InputError, SceneError
from sim.model.system import build_system
from sim.settings import Setting

from ...session import commands
from ...session.notices import Notice
from ...session.session import Session
from ...ui import readouts
from ...ui.page import Page
from ...ui.viser.handlers import add_command, on_change
from ...ui.viser.look import describe_control
from ...ui.viser.slider_box import SliderBox, alike, allows, rounded
from ...words import decimal, joined, say
from .job import MAX_MASSES, Job, paragraph, problem, worker

APPLY_TIMEOUT = 1.0
"""Seconds within which the page's next frame has applied a change."""

SLIDERS = ("frequency", "damping")
"""Targets that have a slider; all others have a box."""

NEAR = 0.02
"""Largest relative deviation of a body from a wish that was met before, at which it still is."""

_SAME = {"damping": "calm_after", "calm_after": "damping"}
"""Targets that are set by the same number of a body, so that each replaces the other."""


class TuningAnalysis:
    """Analyses the tuning of a scene whenever it has changed.

    Attributes:
        scene: that was analysed last; None before the first.
        tuning: of it; None if there is none yet.
        sensitivities: what its numbers do.
        trouble: why it cannot be analysed; empty if it can.
        busy: whether an analysis is under way, or due.
    """

    def __init__(self) -> None:
        self.scene: sim.Scene | None = None
        self.tuning: Tuning | None = None
        self.sensitivities: tuple[sim.Sensitivity, ...] = ()
        self.trouble = ""
        self.busy = True
        self._seen: sim.Scene | None = None
        self._is_running = False

    def look(self, scene: sim.Scene) -> None:
        """Begin to analyse a scene if it is another one that no longer changes, as while a key is held."""
        settled, self._seen = scene is self._seen, scene
        self.busy = scene is not self.scene
        if not self.busy or self._is_running or not settled:
            return
        if len(scene.masses) > MAX_MASSES:
            self._finish(scene, None, say("solver-tuning-row.many", count=MAX_MASSES))
        elif is_compiled(scene):
            self._is_running = True
            worker.submit(lambda: self._run(scene))
        else:
            self.tuning, self.trouble = None, say("solver-tuning-row.compiled")

    def _run(self, scene: sim.Scene) -> None:
        try:
            tuning = sim.tuning(scene)
            self.sensitivities = sim.sensitivities(scene)
            self._finish(scene, tuning, "")
        except Exception:
            self._finish(scene, None, say("solver-tuning-row.error"))
            raise
        finally:
            self._is_running = False

    def _finish(self, scene: sim.Scene, tuning: Tuning | None, trouble: str) -> None:
        self.tuning, self.trouble = tuning, trouble
        self.scene = scene  # last: others look at it to see whether there is anything new


def is_compiled(scene: sim.Scene) -> bool:
    """Whether a scene's equilibrium is found without compiling anything."""
    return is_ready(for_balance(build_system(scene).body))


class _TargetBox:
    """A number box that shows a property of a body, and takes a target for it.

    Args:
        page: the page.
        of: the property.
        hint: what it means.
        aim: called with a target.
        order: where it stands in its tab.
    """

    def __init__(
        self,
        page: Page,
        of: Setting,
        hint: str,
        aim: Callable[[float], None],
        order: float,
    ) -> None:
        self._of, self._mail = of, page.mail
        self._known, self._unit = 0.0, ""
        self._box = page.client.gui.add_number(
            of.label, initial_value=0.0, step=0.1, hint=hint, visible=False, order=order
        )
        self._show_unit(of.unit)

        def enter() -> None:
            value = self._box.value
            if allows(of, value):
                aim(value)
            else:
                self._box.value = rounded(self._known)

        on_change(self._box, enter)

    def show(self, value: float | None, unit: str, working: bool) -> None:
        """Show a value, unless a target is being worked on; hide the box if it is None.

        A value out of the range of targets is shown as the end of the range.
        """
        self._box.visible = value is not None
        if unit != self._unit:
            self._show_unit(unit)
        if value is None or working:
            return
        value = _digits(min(max(value, self._of.low), self._of.high))
        if not alike(value, self._known):
            self._box.step = 10.0 ** (math.floor(math.log10(value)) - 1)
        self._known = value
        if not alike(value, self._box.value):
            self._box.value = rounded(value)

    def _show_unit(self, unit: str) -> None:
        self._unit = unit
        describe_control(self._mail, self._box, unit=unit, low=self._of.low, high=self._of.high)


class Wished:
    """What was wished of a body and met."""

    def __init__(self) -> None:
        self._wishes: dict[str, tuple[float, str]] = {}
        self._last = ""
        self._lost: list[str] = []

    def discarded_by(self, key: str, value: float, label: str, scene: sim.Scene) -> list[str]:
        """Add a wish that is met; return the labels of those before that no longer are.

        They are told once, except that a slider which is dragged on tells them again.

        Args:
            key, value: of the new one.
            label: of its step of undo.
            scene: that came of it.
        """
        if key != self._last:
            for lost in self._lost:
                self._wishes.pop(lost, None)
        self._last, self._lost = key, []
        self._wishes.pop(_SAME.get(key, ""), None)
        older = {of: wish for of, wish in self._wishes.items() if of != key}
        self._wishes[key] = value, label
        if older:
            tuning = sim.tuning(scene)
            self._lost = [of for of, (wish, _) in older.items() if not _is_met(of, wish, tuning, scene)]
        return [older[lost][1] for lost in self._lost]


def _is_met(key: str, wish: float, tuning: Tuning, scene: sim.Scene) -> bool:
    """Whether a body is still as it was wished."""
    if key == "dt":
        return tuning.stable_steps.get(step_method(scene), math.inf) >= (1.0 - NEAR) * wish
    if key == "sag":
        found = tuning.sag
    elif tuning.elastic is None:
        found = None
    elif key == "frequency":
        found = tuning.elastic.frequency
    else:
        found = tuning.elastic.calm_after if key == "calm_after" else tuning.elastic.damping_ratio
    return found is not None and math.isclose(found, wish, rel_tol=NEAR)


class TuningPanel:
    """The controls.

    Args:
        page: whose body it is about.
        order: of the first of them in the tab; the others come within 1 of it.
    """

    def __init__(self, page: Page, order: float) -> None:
        self._session, self._notify, self._job = page.session, page.notify, Job(page)
        self._analysis: TuningAnalysis | None = None
        gui = page.client.gui
        self._on = gui.add_checkbox(
            say("solver-tuning"),
            initial_value=False,
            hint=say("solver-tuning.hint"),
            order=order,
        )
        self._table = gui.add_html("", order=order + 0.3)  # below what it follows from
        self._stable = page.button(
            say("solver-stable"),
            viser.Icon.SHIELD_CHECK,
            self._make_stable,
            hint=say("solver-stable.hint"),
            visible=False,
            order=order + 0.2,
        )
        self._damp = page.button(
            say("solver-damp"),
            viser.Icon.WAVE_SINE,
            self._damp_it,
            hint=say("solver-damp.hint"),
            visible=False,
            order=order + 0.22,
        )
        self._sliders = [
            SliderBox(page.client, page.mail, of, value, partial(self._aim, of.key), order + place)
            for of, value, place in (
                (_target("frequency", say("solver-frequency"), "Hz", (1e-3, 1e6), (0.1, 30.0)), 1.0, 0.1),
                (_target("damping", say("solver-damping"), "", (1e-4, 1.0), (0.005, 1.0)), 0.1, 0.12),
            )
        ]
        for one in self._sliders:
            one.slider.visible = False
        calm = say("solver-calm-after.hint")
        sag, step = say("solver-sag.hint"), say("solver-dt.hint")
        self._boxes = {
            of.key: _TargetBox(page, of, hint, partial(self._aim, of.key), order + place)
            for of, hint, place in (
                (_target("calm_after", say("solver-calm-after"), "s", (1e-6, 1e6)), calm, 0.15),
                (_target("sag", say("solver-sag"), "px", (1e-6, 1e6)), sag, 0.16),
                (_target("dt", say("solver-dt"), "s", (1e-9, 1.0)), step, 0.17),
            )
        }
        self._targets: dict[str, float] = {}  # of these the last one of each waits
        self._lock = threading.Lock()  # guards the targets
        self._is_pending = False  # until all results are shown
        self._works = False  # until the numbers that came of a wish or a button are found out
        self._wished = Wished()
        self._opening = -1  # the body that they are about
        self._conflict = ""
        self._conflict_scene: sim.Scene | None = None  # that the conflict is about; None until it is shown
        on_change(self._on, self._switch)
        add_command(gui, say("solver-tuning.command"), self._toggle)
        add_command(gui, say("solver-stable"), self._make_stable)
        add_command(gui, say("solver-damp"), self._damp_it)

    @property
    def waits(self) -> bool:
        """Whether there will be more to show, though nothing moves."""
        analysis = self._analysis
        if analysis is None:
            return bool(self._table.content)
        touched = any(one.slider.visible and not one.settled for one in self._sliders)
        return analysis.busy or touched or self._is_pending or self._job.busy

    def build(self, moving: bool) -> None:
        """Show it if the body can move."""
        self._on.visible = moving
        self.refresh()

    def refresh(self) -> None:
        """Show what is known of the scene as it is now."""
        analysis, session = self._analysis, self._session
        self._is_pending = busy = self._job.busy
        scene, content = session.scene, ""
        if not busy and scene is not self._conflict_scene:
            # A conflict is shown for the scene that came of the target, and for no later one.
            self._conflict = "" if self._conflict_scene is not None else self._conflict
            self._conflict_scene = scene
        if analysis is not None:
            analysis.look(scene)
            self._works = busy or (self._works and analysis.busy)
            content = paragraph(self._conflict, " softrod-lag") + _content(analysis, session, self._works)
        shown = analysis is not None and self._on.visible
        self._stable.visible, self._damp.visible = shown and is_limited(scene.integrator.method), shown
        self._table.content = content
        self._show_values(analysis if shown else None, busy)

    def _show_values(self, analysis: TuningAnalysis | None, busy: bool) -> None:
        """Show the properties of the body in the sliders and boxes; hide them without an analysis."""
        scene, tuning = self._session.scene, analysis.tuning if analysis is not None else None
        elastic = tuning.elastic if tuning is not None else None
        busy = busy or analysis is None or analysis.busy
        for one in self._sliders:
            one.slider.visible = elastic is not None
            if elastic is not None and not busy:
                ratio = min(max(elastic.damping_ratio, 1e-4), 1.0)
                one.show_value(_digits(elastic.frequency if one.setting.key == "frequency" else ratio))
        values: dict[str, float | None] = dict.fromkeys(self._boxes)
        if tuning is not None:
            values["calm_after"] = elastic.calm_after if elastic is not None else None
            values["sag"] = tuning.sag if tuning.sag is not None and tuning.sag > 0.0 else None
            limit = tuning.stable_steps.get(scene.integrator.method, math.inf)
            values["dt"] = limit if is_limited(scene.integrator.method) and math.isfinite(limit) else None
        for key, box in self._boxes.items():
            box.show(values[key], scene.view.unit if key == "sag" else "s", busy)

    # --------------------------------------------------------------------- what handlers do
    def _toggle(self) -> None:
        self._on.value = not self._on.value
        self._switch()

    def _switch(self) -> None:
        # The ticker sees that there is something to show.
        self._analysis = TuningAnalysis() if self._on.value else None

    def _make_stable(self) -> None:
        if self._session.simulation.divergence is not None:
            # What it looks like then says nothing of the body: it was torn apart.
            self._notify(Notice("warning", say("solver-not-stable"), say("solver-not-stable.exploded")))
            return
        # In its present shape, which is what the meter shows.
        self._start(say("solver-not-stable"), self._stabilize, with_pose=True)

    def _damp_it(self) -> None:
        if self._session.selection.springs:
            self._session.post(commands.Change(lambda moment, some: damp_springs(moment.scene, some.springs)))
        else:
            self._start(say("solver-not-damped"), self._damp_vibration, with_pose=False)

    def _aim(self, key: str, value: float) -> None:
        """Take a target from a slider or a box."""
        with self._lock:
            self._targets[key] = value
        self._begin()

    def _begin(self) -> None:
        """Work on the targets in the thread, unless it is busy for this page."""
        if self._targets and self._job.run(self._work, then=self._begin):
            self._is_pending = True

    def _work(self) -> None:
        while self._targets:
            with self._lock:
                key = next(iter(self._targets))
                value = self._targets.pop(key)
            self._conflict, self._conflict_scene = self._design(key, value), None

    def _design(self, key: str, value: float) -> str:
        """Change the body so that it meets a target; return what prevents that, or what that discards."""
        session = self._session
        if self._opening != session.openings:
            self._opening, self._wished = session.openings, Wished()
        try:
            scene = session.snapshot("tuning", False)
            if len(scene.masses) > MAX_MASSES or not is_compiled(scene):
                return ""
            designed = _designed(scene, key, value)
        except (InputError, SceneError) as error:
            return problem(error)
        if designed is None:
            return ""
        design, label = designed
        if key == "dt" and design.factors == Factors():
            return say("solver-is-stable.target", step=decimal(f"{1e3 * value:.3g} ms"))
        applied = threading.Event()

        def make(moment: sim.Moment, _: Selection) -> Edit:
            applied.set()
            return edit_of(design.factors.applied, scene, moment.scene, label)

        # A drag of a slider is one step of undo; each number that is typed is one by itself.
        session.post(commands.Change(make, f"wish {key}" if key in SLIDERS else ""))
        applied.wait(APPLY_TIMEOUT)  # the next target starts from the result of this one
        if design.conflict:
            return problem(design.conflict)
        lost = self._wished.discarded_by(key, value, label, design.scene)
        return say("solver-lost", wishes=joined(lost)) if lost else ""

    def _start(self, trouble: str, work: Callable[[sim.Scene], None], with_pose: bool) -> None:
        """Change the scene in the thread, unless it is busy for this page."""

        def run(scene: sim.Scene) -> None:
            if not is_compiled(scene):
                raise InputError(say("solver-compiling"))
            work(scene)

        self._job.run_on_scene(trouble, run, with_pose, then=self._begin)

    def _stabilize(self, scene: sim.Scene) -> None:
        made, step = sim.make_stable(scene), decimal(f"{1e3 * scene.integrator.dt:.3g} ms")
        if made is scene:
            self._notify(Notice("info", say("solver-is-stable"), say("solver-is-stable.text", step=step)))
        else:
            self._change(made, scene, say("solver-did-stable", step=step))

    def _damp_vibration(self, scene: sim.Scene) -> None:
        damped = sim.damp_vibration(scene)
        made = as_far_as_stable(scene, damped)
        if made is damped:
            self._change(made, scene, say("solver-did-damp"))
            return
        elastic = sim.tuning(made).elastic
        step = decimal(f"{1e3 * scene.integrator.dt:.3g} ms")
        self._change(made, scene, say("solver-did-damp-some", step=step))
        if elastic is None:
            text = say("solver-not-critical.text", step=step)
        else:
            text = say("solver-not-critical.ratio", step=step, ratio=decimal(f"{elastic.damping_ratio:.2g}"))
        self._notify(Notice("info", say("solver-not-critical"), text))

    def _change(self, made: sim.Scene, scene: sim.Scene, label: str) -> None:
        change = partial(with_numbers, numbers=Numbers.of(made))
        self._session.post(commands.Change(lambda moment, _: edit_of(change, scene, moment.scene, label)))


def _designed(scene: sim.Scene, key: str, value: float) -> tuple[Design, str] | None:
    """Return the design that meets a target, and its label; None if there is no vibration to change."""
    if key == "calm_after":
        return sim.set_wishes(scene, calm_after=value), say(
            "solver-did-calm", seconds=decimal(f"{value:.3g}")
        )
    if key == "sag":
        return sim.set_wishes(scene, sag=value), say(
            "solver-did-sag", length=decimal(f"{value:.3g} {scene.view.unit}")
        )
    if key == "dt":
        return sim.set_wishes(scene, dt=value), say("solver-did-dt", step=decimal(f"{1e3 * value:.3g} ms"))
    elastic = sim.tuning(scene).elastic
    if elastic is None:
        return None
    if key == "damping":
        calm = TENTH / (math.tau * elastic.frequency * value)
        return sim.set_wishes(scene, calm_after=calm), say("solver-did-ratio", ratio=decimal(f"{value:.2g}"))
    # The damping ratio stays, unless nothing damps the vibration.
    ratio = elastic.damping_ratio
    calm = TENTH / (math.tau * value * ratio) if 1e-3 < ratio < 1.0 else None
    return sim.set_wishes(scene, frequency=value, calm_after=calm), say(
        "solver-did-frequency", frequency=decimal(f"{value:.3g}")
    )


def _content(analysis: TuningAnalysis, session: Session, works: bool) -> str:
    busy = readouts.table({say("solver-tuning-row"): say("solver-tuning-row.busy")})
    scene, tuning = analysis.scene, analysis.tuning
    if analysis.trouble:
        return readouts.table({say("solver-tuning-row"): analysis.trouble})
    if scene is None or tuning is None:
        return busy
    springs = session.selection.springs
    chosen = next(iter(springs)) if len(springs) == 1 else None
    known = chosen is not None and chosen < len(tuning.springs.frequency)
    table = readouts.tuning_table(scene, tuning, chosen if known else None, analysis.sensitivities)
    return busy + table if works else table


def _target(
    key: str, label: str, unit: str, limits: tuple[float, float], slider: tuple[float, float] | None = None
) -> Setting:
    """Describe a target to a slider or a box; it is no setting of a scene."""
    return Setting(
        key, label, unit, *limits, slider or limits,
        lambda _: math.nan, lambda scene, _: scene, lambda _: True,
        logarithmic=True,
    )  # fmt: skip


def _digits(value: float) -> float:
    """Round a number as in the table."""
    return float(f"{value:.3g}")
