"""What is selected, in a real page."""

from __future__ import annotations

from app.session import commands
from sim.edit.edit import Selection
from tests.browser.conftest import OpenPage


def test_what_is_selected_has_a_folder_and_a_force_on_it_is_drawn(open_page: OpenPage) -> None:
    """`tests/app/test_selection_panel.py` has its numbers and buttons."""
    desk = open_page()
    desk.tell(commands.Play(False))
    arrows = desk.page.locator(".softrod-loads .softrod-forces")
    folder = desk.page.get_by_text("1 mass", exact=True).and_(desk.page.locator(":visible"))
    desk.tell(commands.Select(lambda *_: Selection(masses=frozenset({4}))))
    folder.first.wait_for()
    for label, text in (("Start x", "320"), ("Force y", "500")):
        desk.control(label).fill(text)
        desk.control(label).press("Enter")
    desk.until(lambda: desk.session.scene.masses[4].force == (0.0, 500.0), "the mass has a force")
    desk.until(lambda: abs(desk.simulation.positions[4, 0] - 320.0) < 1e-6, "and is elsewhere")
    arrows.wait_for(state="attached")
    desk.until(lambda: (arrows.bounding_box() or {"height": 0.0})["height"] > 30.0, "its arrow is drawn")

    def begins_at_its_mass() -> bool:
        box, (x, y) = arrows.bounding_box(), desk.place(4)
        return box is not None and abs(box["x"] + box["width"] / 2.0 - x) < 3.0 and abs(box["y"] - y) < 4.0

    desk.until(begins_at_its_mass, "it begins at the mass and points down")
    desk.tell(commands.Undo())
    desk.until(lambda: arrows.count() == 0, "without a force there is no arrow")
    desk.tell(commands.Select(lambda *_: Selection()))
    desk.until(lambda: folder.count() == 0, "nothing is selected any more")
