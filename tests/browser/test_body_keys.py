"""The body by keys alone, and names for all controls."""

from __future__ import annotations

from tests.browser.conftest import OpenPage


def test_a_mass_is_chosen_taken_and_moved_by_keys_alone(open_page: OpenPage) -> None:
    desk = open_page()
    live = desk.page.locator(".softrod-live")
    for _ in range(40):
        desk.page.keyboard.press("Tab")
        if "mass 0, " in live.inner_text():
            break
    assert "mass 0, " in live.inner_text(), "the Tab key comes to the body"
    assert "Body of 12 masses" in (desk.page.locator(".softrod-body").get_attribute("aria-label") or "")
    for _ in range(5):
        desk.page.keyboard.press("ArrowRight")
    desk.until(lambda: "mass 5, " in live.inner_text(), "the arrows choose")
    x, y = desk.place(5)
    ring = desk.page.locator(".softrod-chosen")
    desk.until(
        lambda: (
            abs(float(ring.get_attribute("cx") or 0.0) - x) < 3.0
            and abs(float(ring.get_attribute("cy") or 0.0) - y) < 3.0
        ),
        "the mass is marked",
    )
    desk.page.keyboard.press("Space")
    desk.until(lambda: desk.session.hands.masses == (5,), "Space takes hold")
    assert desk.session.playing  # and does not pause
    before = desk.simulation.positions[5]
    for _ in range(4):
        desk.page.keyboard.press("Shift+ArrowRight")
    desk.until(lambda: desk.simulation.positions[5][0] > before[0] + 100.0, "the arrows move it")
    assert abs(desk.simulation.positions[5][1] - before[1]) < 5.0
    desk.page.keyboard.press("Space")
    desk.until(lambda: not desk.session.hands.masses, "Space lets go")
    assert "let go" in live.inner_text()
    desk.page.keyboard.press("Space")
    desk.until(lambda: desk.session.hands.masses == (5,), "it is taken once more")
    desk.page.keyboard.press("Escape")
    desk.until(lambda: not desk.session.hands.masses, "Esc lets go")
    assert desk.session.playing  # and does not pause
    desk.page.keyboard.press("Space")
    desk.until(lambda: desk.session.hands.masses == (5,), "and again")
    desk.page.evaluate("window.dispatchEvent(new Event('blur'))")
    desk.until(lambda: not desk.session.hands.masses, "leaving the window lets go, too")
    desk.until(lambda: desk.readout("joint4") == "of 10", "its joint is read out")


def test_everything_is_reached_with_the_tab_key_and_can_be_seen_to_be(open_page: OpenPage) -> None:
    desk = open_page()
    reached = set()
    for _ in range(70):
        desk.page.keyboard.press("Tab")
        name, outlined = desk.page.evaluate(
            """() => {
              const focused = document.activeElement, style = getComputedStyle(focused);
              if (focused === document.body) return ["", true];
              const seen = style.outlineStyle !== "none" || style.boxShadow !== "none";
              return [focused.ariaLabel ?? focused.innerText, seen || focused.tagName === "INPUT"];
            }"""
        )
        reached.add(name)
        assert outlined or not name, f"{name!r} has the focus, and does not show it"
    for name in ("Reset", "Back 1 s", "Back 1 frame", "Pause", "1 step", "Time shown", "Speed"):
        assert name in reached


def test_every_control_has_a_name(open_page: OpenPage) -> None:
    desk = open_page()
    unnamed = """() => {
      const named = e => e.ariaLabel || e.innerText || e.labels?.[0]?.innerText || e.title
        || document.getElementById(e.getAttribute("aria-labelledby"))?.innerText;
      return [...document.querySelectorAll("button, input:not([type=hidden]), select, [role=slider]")]
        .filter(e => e.checkVisibility() && e.tabIndex >= 0 && !named(e)).map(e => e.outerHTML.slice(0, 300));
    }"""
    for tab in ("Play", "Measure", "Solver", "Share"):
        desk.show(tab)
        desk.rest(5)
        assert desk.page.evaluate(unnamed) == [], tab
    desk.show("Play")
    thumb = desk.thumb("Stretching stiffness")
    desk.until(lambda: thumb.get_attribute("aria-valuetext") == "10000 kg/s²", "not the power of ten")
