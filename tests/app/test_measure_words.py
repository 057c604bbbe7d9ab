"""What a page measures and how its body is solved is said in its language."""

from __future__ import annotations

import gzip

from app.features.hands.messages import Pick
from app.pages.sandbox.assets import page_in
from app.words import speaking
from app.words.quantities import part_called, quantity_of
from sim.motion.quantities import KINDS
from tests.app.whole import WholePage


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
        assert page.gui["Stroboskop"].options[:2] == ("aus", "alle 0.05 s")


def test_quantities_are_called_in_the_language_that_is_spoken() -> None:
    for of, what in KINDS:
        assert quantity_of(of, what) == what
    assert part_called("joint3") == "joint3"
    with speaking("de"):
        assert part_called("joint3") == "Gelenk 3"
        assert quantity_of("joint", "rest_angle") == "Ruhewinkel"
        assert quantity_of("formula", "mass0.x + 1") == "mass0.x + 1"


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
