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
from .method_panel import MethodPanel
from .tuning_panel import TuningPanel

NO_GHOST = "nothing"
REFERENCE_LABEL = "a near-exact solution"
SAME_LAW = "the same"
FINER_LABELS: dict[int, str] = dict(zip(FINER, ("the same", "a half", "a quarter", "a tenth"), strict=True))

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
        methods, laws = CHOICES["method"].options, CHOICES["force_law"].options
        self._sentence = gui.add_html("", order=0.1)
        self._method = ChoiceBox(page, "method", 1)
        self._about = gui.add_html("", order=2)
        self._law = ChoiceBox(page, "force_law", 3)
        self._own_values = page.button(
            "Scene's own values",
            viser.Icon.RESTORE,
            lambda: session.post(commands.RestoreSceneValues("solver")),
            order=LAST - 1,
        )
        self._energy = gui.add_checkbox(
            "Energy", initial_value=False, hint="follow what changes the energy", order=LAST
        )
        self._energies = gui.add_html("", order=LAST + 1)
        self._foretell = gui.add_checkbox(
            "Predictability",
            initial_value=False,
            hint="how fast small errors grow: whether any tolerance can tell where the body will be",
            order=LAST + 1.2,
        )
        self._growth = gui.add_html("", order=LAST + 1.4)
        self._advice = MethodPanel(page, 0.2)
        self._tuning = TuningPanel(page, LAST + 1.5)
        self._other = gui.add_dropdown(
            "Compare with", (NO_GHOST, REFERENCE_LABEL, *methods.values()), order=LAST + 2
        )
        self._other_law = gui.add_dropdown("Ghost's law", (SAME_LAW, *laws.values()), order=LAST + 3)
        self._finer = gui.add_dropdown(
            "Ghost's step",
            tuple(FINER_LABELS.values()),
            hint="its time step, or its tolerance where it has one, as a part of the body's",
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
        method = METHODS[scene.integrator.method]
        laws = CHOICES["force_law"].options
        other = NO_GHOST
        if ghost is not None:
            other = REFERENCE_LABEL if ghost.method == REFERENCE else METHODS[ghost.method].label
        self._method.show(scene)
        self._law.show(scene)
        self._other.value = other
        # The ghost has its own controls, and a reference has no step.
        self._other_law.visible = ghost is not None and CHOICES["force_law"].applies(scene)
        self._finer.visible = ghost is not None and ghost.method != REFERENCE
        # Without one, these are the values that the next one begins with.
        self._other_law.value = laws[ghost.law] if ghost is not None and ghost.law else SAME_LAW
        self._finer.value = FINER_LABELS[ghost.finer if ghost is not None else 1]
        self._energy.value = self._session.follows_energy
        self._foretell.value = self._session.predictability is not None
        self._sentence.content = f'<div class="softrod-text softrod-lead">{_sentence(scene)}</div>'
        self._about.content = f'<div class="softrod-text softrod-about">{method.summary}</div>'

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
        law = _key_of(CHOICES["force_law"].options, self._other_law.value)
        finer: int = next((part for part, label in FINER_LABELS.items() if label == self._finer.value), 1)
        if self._other.value == REFERENCE_LABEL:
            method = REFERENCE
        else:
            method = _key_of(CHOICES["method"].options, self._other.value)
        self._session.post(commands.Compare(method, law, finer))


def _sentence(scene: Scene) -> str:
    """What the method of a scene does, in one sentence."""
    solver = scene.integrator
    method = METHODS[solver.method]
    if method.adaptive:
        return f"<b>{method.label}</b> keeps to {solver.tolerance:g} px, with steps as long as that allows."
    return (
        f"<b>{method.label}</b> takes {1.0 / solver.dt:.0f} equal steps a second, of {1e3 * solver.dt:g} ms."
    )


def _key_of(options: dict[str, str], label: str) -> str:
    return next((key for key, text in options.items() if text == label), "")
