"""The Solver tab: force law, integrator, its step or tolerance, the energy, and a second body to compare."""

from __future__ import annotations

import viser

from sim.scene.types import Scene
from sim.settings import CHOICES
from sim.solve.registry import METHODS

from ...session import commands
from ...session.ghost import FINER, REFERENCE
from ...ui import readouts
from ...ui.page import Page
from ...ui.viser.choice_box import ChoiceBox
from ...ui.viser.handlers import on_change
from ...words import decimal, find, say
from ...words.keys import Key
from ...words.settings import options_of
from .method_panel import MethodPanel
from .tuning_panel import TuningPanel

NO_GHOST: Key = "solver-compare.nothing"
REFERENCE_LABEL: Key = "solver-compare.reference"
SAME_LAW: Key = "solver-ghost-law.same"
FINER_LABELS: tuple[Key, ...] = (
    "solver-ghost-step.same",
    "solver-ghost-step.half",
    "solver-ghost-step.quarter",
    "solver-ghost-step.tenth",
)
"""Of the parts of a step in `FINER`."""

LAST = 1e6
"""Order of what stands below the sliders, which come and go."""


class SolverPanel:
    """The controls of one page's Solver tab; made inside the tab.

    Args:
        page: whose body is solved.
    """

    def __init__(self, page: Page) -> None:
        self._session = session = page.session
        gui = page.client.gui
        self._methods, self._laws = options_of("method"), options_of("force_law")
        self._parts: dict[int, str] = dict(zip(FINER, map(say, FINER_LABELS), strict=True))
        self._sentence = gui.add_html("", order=0.1)
        self._method = ChoiceBox(page, "method", 1)
        self._about = gui.add_html("", order=2)
        self._law = ChoiceBox(page, "force_law", 3)
        self._own_values = page.button(
            say("solver-own"),
            viser.Icon.RESTORE,
            lambda: session.post(commands.RestoreSceneValues("solver")),
            order=LAST - 1,
        )
        self._energy = gui.add_checkbox(
            say("solver-energy"), initial_value=False, hint=say("solver-energy.hint"), order=LAST
        )
        self._energies = gui.add_html("", order=LAST + 1)
        self._foretell = gui.add_checkbox(
            say("solver-foretell"),
            initial_value=False,
            hint=say("solver-foretell.hint"),
            order=LAST + 1.2,
        )
        self._growth = gui.add_html("", order=LAST + 1.4)
        self._advice = MethodPanel(page, 0.2)
        self._tuning = TuningPanel(page, LAST + 1.5)
        self._other = gui.add_dropdown(
            say("solver-compare"),
            (say(NO_GHOST), say(REFERENCE_LABEL), *self._methods.values()),
            order=LAST + 2,
        )
        self._other_law = gui.add_dropdown(
            say("solver-ghost-law"), (say(SAME_LAW), *self._laws.values()), order=LAST + 3
        )
        self._finer = gui.add_dropdown(
            say("solver-ghost-step"),
            tuple(self._parts.values()),
            hint=say("solver-ghost-step.hint"),
            order=LAST + 4,
        )
        self._ghost = gui.add_html("", order=LAST + 5)
        self.rates = gui.add_html("", order=LAST + 6)
        for handle in (self._other, self._other_law, self._finer):
            on_change(handle, self._compare)
        on_change(self._energy, lambda: session.post(commands.FollowEnergy(self._energy.value)))
        on_change(self._foretell, lambda: session.post(commands.MeasurePredictability(self._foretell.value)))

    def build(self) -> None:
        """Show the controls that the session's scene needs."""
        scene = self._session.scene
        jointed = CHOICES["force_law"].applies(scene)
        moving = CHOICES["method"].applies(scene)
        self._law.handle.visible = jointed
        for handle in (
            self._sentence, self._method.handle, self._about, self._own_values, self._energy, self._foretell,
            self._other,
        ):  # fmt: skip
            handle.visible = moving
        self._advice.build(moving)
        self._tuning.build(moving)
        self.refresh_controls()

    def refresh_controls(self) -> None:
        """Update the controls after commands or other controls."""
        scene, ghost = self._session.scene, self._session.ghost
        method = scene.integrator.method
        other = say(NO_GHOST)
        if ghost is not None:
            other = say(REFERENCE_LABEL) if ghost.method == REFERENCE else self._methods[ghost.method]
        self._method.show(scene)
        self._law.show(scene)
        self._other.value = other
        # The ghost has its own controls, and a reference has no step.
        self._other_law.visible = ghost is not None and CHOICES["force_law"].applies(scene)
        self._finer.visible = ghost is not None and ghost.method != REFERENCE
        # Without one, these are the values that the next one begins with.
        self._other_law.value = self._laws[ghost.law] if ghost is not None and ghost.law else say(SAME_LAW)
        self._finer.value = self._parts[ghost.finer if ghost is not None else 1]
        self._energy.value = self._session.follows_energy
        self._foretell.value = self._session.predictability is not None
        self._sentence.content = f'<div class="softrod-text softrod-lead">{_sentence(scene)}</div>'
        self._about.content = f'<div class="softrod-text softrod-about">{_about(method)}</div>'

    @property
    def waits(self) -> bool:
        """Whether there will be more to show, though nothing moves."""
        return self._tuning.waits or self._advice.waits

    def refresh_readouts(self) -> None:
        """Show the present energies, tuning, ghost and rates."""
        session = self._session
        self._advice.refresh()
        self._tuning.refresh()
        self._energies.content = readouts.energy_table(session)
        self._growth.content = readouts.predictability_table(session)
        self._ghost.content = readouts.ghost_table(session)
        self.rates.content = readouts.rates_table(session)

    def _compare(self) -> None:
        """Compare with the chosen method."""
        law = _key_of(self._laws, self._other_law.value)
        finer: int = next((part for part, label in self._parts.items() if label == self._finer.value), 1)
        if self._other.value == say(REFERENCE_LABEL):
            method = REFERENCE
        else:
            method = _key_of(self._methods, self._other.value)
        self._session.post(commands.Compare(method, law, finer))


def _sentence(scene: Scene) -> str:
    """What the method of a scene does, in one sentence."""
    solver = scene.integrator
    name = options_of("method")[solver.method]
    if METHODS[solver.method].adaptive:
        return say("solver-adaptive", method=name, tolerance=decimal(f"{solver.tolerance:g}"))
    return say(
        "solver-fixed",
        method=name,
        rate=decimal(f"{1.0 / solver.dt:.0f}"),
        step=decimal(f"{1e3 * solver.dt:g}"),
    )


def _about(method: str) -> str:
    """What a method is and what it is good for, in one sentence."""
    return find(f"solver-method-{method.replace('_', '-')}", METHODS[method].summary)


def _key_of(options: dict[str, str], label: str) -> str:
    return next((key for key, text in options.items() if text == label), "")
