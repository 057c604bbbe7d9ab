"""What a page measures and how its body is solved is said in its language."""

from __future__ import annotations

import gzip
import math
import re
from pathlib import Path
from typing import Any

import sim
from app.features.hands.messages import Pick
from app.features.solver.method_panel import advice_for
from app.pages.sandbox.assets import page_in
from app.session import commands
from app.session.notices import runaway_notice
from app.session.predictability import verdict
from app.ui.viser.handlers import on_press
from app.words import find, language, speaking
from app.words.quantities import part_called, quantity_of
from sim.analysis.advice import Advice, Tried
from sim.analysis.predictability import verdict as in_english
from sim.motion.quantities import KINDS
from sim.motion.stability import StabilityEstimate
from sim.solve.registry import METHODS
from tests.app.panels import Handle
from tests.app.whole import WholePage

ROOT = Path(__file__).parents[2]


def test_a_plot_is_chosen_and_told_in_the_page_s_language() -> None:
    with speaking("de"):
        page = WholePage("rod")
        page.shown(Pick(2))
        assert "Gelenk 1" in page.gui["Teil"].options
        page.enter("Teil", "Masse 2")
        page.enter("Größe", "Geschwindigkeit")
        page.enter("Neues Diagramm")
        page.enter("Auswertung", "Spektrum")
        text = page.gui.text()
        assert "mass2.speed" in text
        assert "kein Spektrum" in text
        assert page.gui["Kräfte"].hint.startswith("die Gesamtkraft")
        assert page.gui["Stroboskop"].options[:2] == ("aus", "alle 0,05 s")


def test_quantities_are_called_in_the_language_that_is_spoken() -> None:
    for of, what in KINDS:
        assert find(f"quantity-{of}-{what.replace('_', '-')}") == what == quantity_of(of, what)
    assert part_called("joint3") == "joint3"
    with speaking("de"):
        assert part_called("joint3") == "Gelenk 3"
        assert quantity_of("joint", "rest_angle") == "Ruhewinkel"
        assert quantity_of("formula", "mass0.x + 1") == "mass0.x + 1"


def test_each_quantity_stands_in_the_table_of_the_guide() -> None:
    table = (ROOT / "docs" / "measuring.md").read_text(encoding="utf-8").partition("\n## ")[0]
    named = re.findall(r"`([a-z]+)\d*\.([a-z_]+)`", table)
    assert sorted(set(named) - {("ghost", "distance")}) == sorted(KINDS)


def test_the_solver_is_told_of_in_the_page_s_language() -> None:
    with speaking("de"):
        page = WholePage("rod")
        page.frames(2)
        page.enter("Vergleichen mit", "Symplektischer Euler")
        page.enter("Schritt des Geists", "ein Zehntel")
        page.frames(2)
        ghost = page.session.ghost
        assert ghost is not None and (ghost.method, ghost.finer) == ("symplectic_euler", 10)
        assert "hält die Toleranz" in page.gui.text() or "gleiche Schritte" in page.gui.text()
        assert page.gui["Abstimmung"].hint.startswith("was die Steifigkeiten")


def test_each_method_says_what_it_is_good_for() -> None:
    said = {name: find(f"solver-method-{name.replace('_', '-')}") for name in METHODS}
    assert said == {name: method.summary for name, method in METHODS.items()}


def test_which_method_suits_a_scene_is_said_as_by_sim_and_in_the_page_s_language() -> None:
    rk4, auto = Tried("rk4", 0.002, 0.05, 1.0), Tried("auto", 0.01, 0.02, 3.0)
    for tried in ((), (rk4,), (rk4, auto), (rk4, auto._replace(seconds=1.05))):
        for doubt, moved in ((0.0, 9.0), (0.9, 9.0), (0.0, 0.5)):
            advice = Advice(tried, doubt, moved)
            assert advice_for(advice, 1.0) == advice.sentence(1.0)
    with speaking("de"):
        assert "nimm Runge-Kutta 4 mit 2 ms, das 0,05 px" in advice_for(Advice((rk4, auto), 0.0, 9.0), 1.0)


def test_what_is_taken_home_is_offered_in_the_page_s_language() -> None:
    with speaking("de"):
        page = WholePage("rod")
        page.frames(2)
    labels = {one.label for one in page.gui.there}
    assert {"Mit Haltung", "Datei öffnen", "Live-Datei", "Körper als"} <= labels


def test_the_page_of_videos_is_in_the_browser_s_language() -> None:
    page = gzip.decompress(page_in("/video", "de").content).decode()
    assert "Orte in einem Video" in page and 'aria-label="Ein Bild weiter"' in page
    assert "video-lost = { $name } ist in Bild" in page
    assert "{say" not in page


def test_an_explosion_is_explained_in_the_page_s_language() -> None:
    scene = sim.rope()

    def said(limit: float, cause: Any, **fields: Any) -> str:
        estimate = StabilityEstimate(limit, cause)
        return runaway_notice(
            sim.Divergence(3, 1, "speed", 1e6, 0.01, lambda: estimate, **fields), scene
        ).text

    with speaking("de"):
        assert "bei Dehnsteifigkeit " in said(0.004, "linear stiffness")
        assert "bei dieser Steifigkeit: Wände" in said(0.004, "walls")
        text = said(math.inf, None)
        assert text.startswith("Angehalten vor Schritt 1: Masse 3 wurde zu schnell (über ")
        assert "verkürze den Zeitschritt" in text
        assert "bewege ihn sanfter oder" in said(math.inf, None, adaptive=True)
        assert "hat keine Energie" in said(0.1, "walls", driven=True)
    divergence = sim.Divergence(3, 7, "step", 0.0, 0.01, lambda: StabilityEstimate(0.1, "walls"))
    sentence = str(divergence)
    assert runaway_notice(divergence, scene).text.startswith(sentence[:1].upper() + sentence[1:])


def test_steps_of_undo_and_the_meaning_of_errors_are_said_in_the_page_s_language() -> None:
    with speaking("de"):
        page = WholePage("rope")
        page.frames(1, commands.SetValue("gravity", 100.0))
        assert page.session.versions.undoable == "Fallbeschleunigung"
        assert verdict(page.session.scene, 1.0).startswith("Fehler wachsen nicht: ")
        assert verdict(page.session.scene, 1e3).endswith(" s ist.")
    for factor in (1.0, 3.0, 1e3):
        for scene in (sim.rope(), sim.rope(integrator=sim.Integrator(method="rk4"))):
            english = in_english(scene, factor)
            assert verdict(scene, factor) == f"{english[:1].upper()}{english[1:]}."


def test_what_a_control_calls_speaks_the_language_it_was_made_in() -> None:
    handle, said = Handle(), list[str]()
    with speaking("de"):
        on_press(handle, lambda: said.append(language()), blocks=True)
    handle.enter()
    assert said == ["de"]


def test_errors_are_told_with_the_decimals_of_the_page_s_language() -> None:
    scene = sim.load_scene("rope")
    with speaking("de"):
        assert "2,5" in verdict(scene, 2.5)
