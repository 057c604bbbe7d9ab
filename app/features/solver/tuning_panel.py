"""What the numbers of a scene mean, and buttons that change them: a part of the Solver tab.

What takes long is done by a thread of its own, one body after the other. It shares the interpreter with the
pages, so that large bodies are left to scripts.
"""

from __future__ import annotations

import html
import math
import threading
from collections.abc import Callable
from functools import partial

import viser

import sim
from sim.analysis.decay import TENTH
from sim.analysis.tuning import Tuning
from sim.compiling.compiler import FOR_FALLBACK, is_ready
from sim.design.wishes import Design, Factors, edit_of
from sim.edit.edit import Edit, Selection
from sim.edit.tune import as_far_as_stable, damp_springs, is_limited, with_numbers_of
from sim.errors import InputError, SceneError
from sim.settings import Setting

from ...server.background import BackgroundWorker
from ...session import commands
from ...session.notices import Notice
from ...session.session import Session
from ...ui import readouts
from ...ui.page import Page
from ...ui.viser.handlers import add_command, on_change
from ...ui.viser.slider_box import DECIMALS, Limits, SliderBox, alike, rounded

MAX_MASSES = 200
"""Masses of a body of which a page is told; pages would notice the work for larger ones."""

_TAKEN = 1.0
"""Seconds in which a page's next frame has come."""

_SLIDERS = "frequency", "damping"
"""What the sliders wish."""

_worker = BackgroundWorker()


class Tuner:
    """Finds out what there is to tell of a scene, whenever there is another one.

    Attributes:
        scene: of which is told; None if nothing is.
        told: of it; None if nothing is yet.
        does: what its numbers do.
        calm: s, after which its slowest elastic vibration is down to a tenth; None if it has none.
        trouble: why nothing can be told; empty if it can.
        busy: whether something is being found out, or has still to be.
    """

    def __init__(self) -> None:
        self.scene: sim.Scene | None = None
        self.told: Tuning | None = None
        self.does: tuple[sim.Sensitivity, ...] = ()
        self.trouble = ""
        self.busy = True
        self._seen: sim.Scene | None = None
        self._at_work = False

    def look(self, scene: sim.Scene) -> None:
        """Begin to find out, if that is another scene and not one of many, as while a key is held."""
        settled, self._seen = scene is self._seen, scene
        if scene is self.scene:
            self.busy = False
            return
        self.busy = True
        if self._at_work or not settled:
            return
        if len(scene.masses) > MAX_MASSES:
            self._show(
                scene, None, f"is told here of at most {MAX_MASSES} masses; sim.tuning tells it of more"
            )
        elif is_compiled(scene):
            self._at_work = True
            _worker.submit(lambda: self._work(scene))
        else:
            self.told, self.trouble = None, "comes when it is compiled"

    def _work(self, scene: sim.Scene) -> None:
        try:
            told = sim.tuning(scene)
            self.does = sim.sensitivities(scene)
            self._show(scene, told, "")
        except Exception:
            self._show(scene, None, "cannot be told because of an error on the server")
            raise
        finally:
            self._at_work = False

    def _show(self, scene: sim.Scene, told: Tuning | None, trouble: str) -> None:
        self.told, self.trouble = told, trouble
        self.scene = scene  # last: it is what others look at


def is_compiled(scene: sim.Scene) -> bool:
    """Whether a scene's equilibrium is found without compiling anything."""
    return is_ready(FOR_FALLBACK)


class _WishBox:
    """A number box that shows what a body does, and takes what it is to do.

    Args:
        client: the page.
        of: what is wished.
        hint: what it means.
        wish: hands a number on.
        tell: says something to the user.
        order: where it stands in its tab.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        of: Setting,
        hint: str,
        wish: Callable[[float], None],
        tell: Callable[[Notice], None],
        order: float,
    ) -> None:
        self._of, self._limits = of, Limits(of, tell)
        self._known, self._unit = 0.0, of.unit
        self._box = client.gui.add_number(
            f"{of.label} ({of.unit})", initial_value=0.0, step=0.1, hint=hint, visible=False, order=order
        )
        self._box.precision = DECIMALS

        def enter() -> None:
            value = self._box.value
            if self._limits.allow(value):
                wish(value)
            else:
                self._box.value = rounded(self._known)

        on_change(self._box, enter)

    def show(self, value: float | None, unit: str, working: bool) -> None:
        """Show what the body does, unless a wish is being worked at; nothing if it is None.

        A number beyond those that can be wished is shown as the last of these.
        """
        self._box.visible = value is not None
        if unit != self._unit:
            self._unit, self._box.label = unit, f"{self._of.label} ({unit})"
        if value is None or working:
            return
        value = _digits(min(max(value, self._of.low), self._of.high))
        if not alike(value, self._known):
            self._box.step = 10.0 ** (math.floor(math.log10(value)) - 1)
        self._known = value
        if not alike(value, self._box.value):
            self._box.value = rounded(value)


class TuningPanel:
    """The controls.

    Args:
        page: whose body is told of.
        order: of the first of them in the tab; the others come within 1 of it.
    """

    def __init__(self, page: Page, order: float) -> None:
        self._session, self._notify = page.session, page.notify
        self._tuner: Tuner | None = None
        self._busy = threading.Lock()
        gui = page.client.gui
        self._on = gui.add_checkbox(
            "Tuning",
            initial_value=False,
            hint="what the stiffnesses mean: frequencies, damping, sag, and stable time steps",
            order=order,
        )
        self._table = gui.add_html("", order=order + 0.3)  # below what it follows from
        self._stable = page.button(
            "Make it stable at this time step",
            viser.Icon.SHIELD_CHECK,
            self._make_stable,
            hint="lowers no more stiffness and damping than it takes",
            visible=False,
            order=order + 0.2,
        )
        self._damp = page.button(
            "Critically damp",
            viser.Icon.WAVE_SINE,
            self._damp_it,
            hint="the selected springs, each by itself; or else the body's slowest elastic vibration",
            visible=False,
            order=order + 0.22,
        )
        self._sliders = [
            SliderBox(
                page.client,
                setting,
                value,
                partial(self._wish, setting.key),
                self._notify,
                order + place,
                0.01,
            )
            for setting, value, place in (
                (_wish_of("frequency", "Soft – stiff", "Hz", (1e-3, 1e6), (0.1, 30.0)), 1.0, 0.1),
                (_wish_of("damping", "Bouncy – calm", "", (1e-4, 1.0), (0.005, 1.0)), 0.1, 0.12),
            )
        ]
        for one in self._sliders:
            one.slider.visible = one.box.visible = False
        self._boxes = {
            of.key: _WishBox(page.client, of, hint, partial(self._wish, of.key), self._notify, order + place)
            for of, hint, place in (
                (
                    _wish_of("calm_after", "Calm after", "s", (1e-6, 1e6)),
                    "when the slowest elastic vibration is down to a tenth; type how long it is to take",
                    0.15,
                ),
                (
                    _wish_of("sag", "Sag", "px", (1e-6, 1e6)),
                    "how far the mass that sinks most is to sink; stiffness makes it less",
                    0.16,
                ),
                (
                    _wish_of("dt", "Stable step", "s", (1e-9, 1.0)),
                    "the largest stable time step; less stiffness and damping make it longer",
                    0.17,
                ),
            )
        }
        self._wished: dict[str, float] = {}
        self._working = False  # and not all that came of it is shown
        self._conflict = ""
        self._about: sim.Scene | None = None  # of which the conflict is told; None until it is shown
        on_change(self._on, self._switch)
        add_command(gui, "Tuning: show it, or hide it", self._toggle)
        add_command(gui, "Make it stable at this time step", self._make_stable)
        add_command(gui, "Critically damp", self._damp_it)

    @property
    def waits(self) -> bool:
        """Whether there will be more to show, though nothing moves."""
        tuner = self._tuner
        if tuner is None:
            return bool(self._table.content)
        touched = any(one.slider.visible and not one.settled for one in self._sliders)
        return tuner.busy or touched or self._working or self._busy.locked()

    def build(self, moving: bool) -> None:
        """Show it if the body can move."""
        self._on.visible = moving
        self.refresh()

    def refresh(self) -> None:
        """Show what is known of the scene as it is now."""
        tuner, session = self._tuner, self._session
        self._working = working = self._busy.locked()
        scene, content = session.scene, ""
        if not working and scene is not self._about:
            # Of another scene than the one that came of the wish nothing is said.
            self._conflict, self._about = "" if self._about is not None else self._conflict, scene
        if tuner is not None:
            tuner.look(scene)
            content = _said(self._conflict) + _content(tuner, session)
        shown = tuner is not None and self._on.visible
        limited = is_limited(scene.integrator.method)
        self._stable.visible, self._damp.visible = shown and limited, shown
        self._table.content = content
        self._show_wishes(tuner if shown else None, working)

    def _show_wishes(self, tuner: Tuner | None, working: bool) -> None:
        """Show in the sliders and boxes what the body does; nothing if there is no tuner."""
        scene, told = self._session.scene, tuner.told if tuner is not None else None
        elastic = told.elastic if told is not None else None
        working = working or tuner is None or tuner.busy
        for one in self._sliders:
            one.slider.visible = one.box.visible = elastic is not None
            if elastic is not None and not working:
                ratio = min(max(elastic.damping_ratio, 1e-4), 1.0)
                one.show_value(_digits(elastic.frequency if one.setting.key == "frequency" else ratio))
        does: dict[str, float | None] = dict.fromkeys(self._boxes)
        if tuner is not None and told is not None:
            does["calm_after"] = elastic.calm_after if elastic is not None else None
            does["sag"] = told.sag if told.sag is not None and told.sag > 0.0 else None
            limit = told.stable_steps.get(scene.integrator.method, math.inf)
            does["dt"] = limit if is_limited(scene.integrator.method) and math.isfinite(limit) else None
        for key, box in self._boxes.items():
            box.show(does[key], scene.view.unit if key == "sag" else "s", working)

    # --------------------------------------------------------------------- what handlers do
    def _toggle(self) -> None:
        self._on.value = not self._on.value
        self._switch()

    def _switch(self) -> None:
        self._tuner = Tuner() if self._on.value else None  # the ticker sees that there is something to show

    def _make_stable(self) -> None:
        # As it is shaped now, since that is what the meter shows.
        self._start("It cannot be made stable", self._stabler, with_pose=True)

    def _damp_it(self) -> None:
        if self._session.selection.springs:
            self._session.post(commands.Change(lambda moment, some: damp_springs(moment.scene, some.springs)))
        else:
            self._start("It cannot be damped", self._damped, with_pose=False)

    def _wish(self, key: str, value: float) -> None:
        """A slider was moved, or a number typed; of those of one key that wait, the last one counts."""
        self._wished[key] = value
        self._begin()

    def _begin(self) -> None:
        """Have what is wished fulfilled in the thread, unless it is busy for this page."""
        if self._wished and self._busy.acquire(blocking=False):
            self._working = True
            _worker.submit(self._fulfil)

    def _fulfil(self) -> None:
        try:
            while self._wished:
                key = next(iter(self._wished))
                self._conflict, self._about = self._design(key, self._wished.pop(key)), None
        finally:
            self._busy.release()
            self._begin()  # with what came in between

    def _design(self, key: str, value: float) -> str:
        """Have the body do what is wished, and say what is in the way, if anything is."""
        session = self._session
        try:
            scene = session.snapshot("tuning", False)
            if len(scene.masses) > MAX_MASSES or not is_compiled(scene):
                return ""
            made = _designed(scene, key, value)
        except (InputError, SceneError) as error:
            return _sentence(str(error))
        if made is None:
            return ""
        design, label = made
        if key == "dt" and design.factors == Factors():
            return f"It is stable at {1e3 * value:.3g} ms as it is, so nothing was changed."
        done = threading.Event()

        def make(moment: sim.Moment, _: Selection) -> Edit:
            done.set()
            return edit_of(design, scene, moment.scene, label)

        # What a slider is dragged through is one step of undo, each number that is typed one by itself.
        session.post(commands.Change(make, f"wish {key}" if key in _SLIDERS else ""))
        done.wait(_TAKEN)  # the next one begins with what this one made
        return _sentence(design.conflict) if design.conflict else ""

    def _start(self, trouble: str, work: Callable[[sim.Scene], None], with_pose: bool) -> None:
        """Have something done with the scene in the thread, unless it is busy for this page."""
        if not self._busy.acquire(blocking=False):
            return

        def run() -> None:
            try:
                scene = self._session.snapshot("tuning", with_pose)
                if len(scene.masses) > MAX_MASSES:
                    raise InputError(f"a page does that for at most {MAX_MASSES} masses")
                if not is_compiled(scene):
                    raise InputError("the solver is still being compiled; try again in a moment")
                work(scene)
            except (InputError, SceneError) as error:
                self._notify(Notice("error", trouble, _sentence(str(error))))
            except Exception:
                self._notify(Notice("error", trouble, "There was an error on the server."))
                raise
            finally:
                self._busy.release()
                self._begin()

        _worker.submit(run)

    def _stabler(self, scene: sim.Scene) -> None:
        made, step = sim.make_stable(scene), f"{1e3 * scene.integrator.dt:.3g} ms"
        if made is scene:
            self._notify(Notice("info", "It is stable", f"It is stable at {step}. Nothing was changed."))
        else:
            self._change(made, scene, f"Made stable at {step}")

    def _damped(self, scene: sim.Scene) -> None:
        damped = sim.damp_vibration(scene)
        made = as_far_as_stable(scene, damped)
        if made is damped:
            self._change(made, scene, "Critically damped")
            return
        elastic = sim.tuning(made).elastic
        ratio = (
            f": a damping ratio of {elastic.damping_ratio:.2g} instead of 1" if elastic is not None else ""
        )
        step = f"{1e3 * scene.integrator.dt:.3g} ms"
        self._change(made, scene, f"Damped as far as {step} bears")
        text = f"It is damped as far as its time step of {step} bears{ratio}. The integrator Auto bears more."
        self._notify(Notice("info", "Not critical yet", text))

    def _change(self, made: sim.Scene, scene: sim.Scene, label: str) -> None:
        edit = partial(with_numbers_of, made, scene, label=label)
        self._session.post(commands.Change(lambda moment, _: edit(scene=moment.scene)))


def _designed(scene: sim.Scene, key: str, value: float) -> tuple[Design, str] | None:
    """What a wish makes of a scene, and what that is called; None if there is no vibration to change."""
    if key == "calm_after":
        return sim.set_wishes(scene, calm_after=value), f"Calm after {value:.3g} s"
    if key == "sag":
        return sim.set_wishes(scene, sag=value), f"Sag {value:.3g} {scene.view.unit}"
    if key == "dt":
        return sim.set_wishes(scene, dt=value), f"Stable to {1e3 * value:.3g} ms"
    elastic = sim.tuning(scene).elastic
    if elastic is None:
        return None
    if key == "damping":
        calm = TENTH / (math.tau * elastic.frequency * value)
        return sim.set_wishes(scene, calm_after=calm), f"Damping ratio {value:.2g}"
    # As bouncy as before, unless nothing damps it.
    ratio = elastic.damping_ratio
    calm = TENTH / (math.tau * value * ratio) if 1e-3 < ratio < 1.0 else None
    return sim.set_wishes(scene, frequency=value, calm_after=calm), f"{value:.3g} Hz"


def _content(tuner: Tuner, session: Session) -> str:
    scene, told = tuner.scene, tuner.told
    if tuner.trouble:
        return readouts.table({"tuning": tuner.trouble})
    if scene is None or told is None:
        return readouts.table({"tuning": "is being found out"})
    springs = session.selection.springs
    chosen = next(iter(springs)) if len(springs) == 1 else None
    known = chosen is not None and chosen < len(told.springs.frequency)
    return readouts.tuning_table(scene, told, chosen if known else None, tuner.does)


def _wish_of(
    key: str, label: str, unit: str, limits: tuple[float, float], slider: tuple[float, float] | None = None
) -> Setting:
    """What a slider or a box needs to know of something that is wished; it is no setting of a scene."""
    return Setting(
        key, label, unit, *limits, slider or limits,
        lambda _: math.nan, lambda scene, _: scene, lambda _: True,
        logarithmic=True,
    )  # fmt: skip


def _digits(value: float) -> float:
    """A number with the digits that the table has."""
    return float(f"{value:.3g}")


def _said(sentence: str) -> str:
    return f'<div class="softrod-text softrod-lag">{html.escape(sentence)}</div>' if sentence else ""


def _sentence(text: str) -> str:
    """An error as a sentence of its own, without the name of the function that raised it."""
    text = text.removeprefix("make_stable: ").removeprefix("damp_vibration: ").removeprefix("set_wishes: ")
    return text[:1].upper() + text[1:] + "."
