"""Which method suits a scene: a button in the Solver tab, a sentence and a figure."""

from __future__ import annotations

import msgspec
import viser

import sim
from sim.analysis.advice import AS_FAST, ERRORS, Advice, Tried, best_two, compare_methods
from sim.solve.registry import METHODS

from ...ui.page import Page
from ...ui.viser.handlers import add_command
from ...words import decimal, say
from ...words.settings import options_of
from .job import Job, paragraph


class MethodPanel:
    """The button, and what it finds.

    Args:
        page: whose scene it is about.
        order: of the first control; the others come within 1 of it.
    """

    def __init__(self, page: Page, order: float) -> None:
        self._page, self._job = page, Job(page)
        self._button = page.button(
            say("solver-which"),
            viser.Icon.SCALE,
            self._ask,
            hint=say("solver-which.hint"),
            order=order,
        )
        self._advice = page.client.gui.add_html("", order=order + 0.1)
        self._is_pending = False  # until its result is shown
        self._found: tuple[sim.Scene, str] | None = None
        add_command(page.client.gui, say("solver-which.command"), self._ask)

    @property
    def waits(self) -> bool:
        """Whether there will be more to show, though nothing moves."""
        return self._is_pending

    def build(self, moving: bool) -> None:
        """Show it if the body can move."""
        self._button.visible = moving

    def refresh(self) -> None:
        """Show what is known of the scene as it is now, whatever its method is."""
        self._is_pending = busy = self._job.busy
        # Read after `busy`: a result is there before the job ends.
        scene, found = self._page.session.scene, self._found
        if found is not None and not _moves_alike(found[0], scene):
            self._found = found = None
        self._button.disabled = busy
        self._advice.content = paragraph(say("solver-which.busy")) if busy else found[1] if found else ""

    def _ask(self) -> None:
        if self._job.run_on_scene(say("solver-which.fails"), self._compare, instead="softrod study"):
            self._is_pending = True

    def _compare(self, scene: sim.Scene) -> None:
        self._found = scene, _advice_html(compare_methods(scene, wait=False))


def _advice_html(advice: Advice) -> str:
    from ...export.method_picture import methods_svg  # matplotlib does not delay the start

    sentences = [advice_for(advice, error) for error in ERRORS]
    if any(METHODS[one.method].adaptive for one in advice.tried):
        sentences.append(say("solver-which.luck"))
    return "".join(map(paragraph, sentences)) + (methods_svg(advice) if advice.tried else "")


def advice_for(advice: Advice, error: float) -> str:
    """Name the cheapest method for an error, px, and the cost of the next best, as `Advice.sentence` does."""
    to = decimal(f"{error:g}")
    if advice.moved <= error:
        return say("solver-advice-still", error=to)
    if advice.is_doubtful(error):
        return say("solver-advice-doubt", error=to, doubt=decimal(f"{advice.doubt:.1g}"))
    best, other = best_two(advice.tried, error)
    if best is None:
        return say("solver-advice-none", error=to)
    setting, off = _setting(best), decimal(f"{best.error:.1g}")
    if other is None:
        return say("solver-advice-take", error=to, setting=setting, off=off)
    second, far, ratio = _setting(other), decimal(f"{other.error:.1g}"), other.seconds / best.seconds
    if ratio < AS_FAST:
        return say("solver-advice-take.fast", error=to, setting=setting, off=off, other=second, far=far)
    return say(
        "solver-advice-take.slow",
        error=to,
        setting=setting,
        off=off,
        other=second,
        far=far,
        ratio=decimal(f"{ratio:.2g}"),
    )


def _setting(one: Tried) -> str:
    """A method and its tolerance or time step."""
    value = decimal(f"{one.value:g} px" if METHODS[one.method].adaptive else f"{1e3 * one.value:.3g} ms")
    return say("solver-advice-setting", method=options_of("method")[one.method], value=value)


def _moves_alike(one: sim.Scene, other: sim.Scene) -> bool:
    """Whether two scenes move alike, except for their methods."""
    return msgspec.structs.replace(one, name=other.name, integrator=other.integrator) == other
