"""The body without a pointer that hits it: by keys alone, and by a finger or a mouse beside a mass."""

from __future__ import annotations

from app.session import commands
from tests.browser.conftest import OpenPage


def test_a_mass_is_chosen_taken_and_moved_by_keys_alone(open_page: OpenPage) -> None:
    desk = open_page()
    live = desk.page.locator(".softrod-live")
    for _ in range(40):
        desk.page.keyboard.press("Tab")
        if "mass 0 of 0 to 11" in live.inner_text():
            break
    assert "mass 0 of 0 to 11" in live.inner_text(), "the Tab key comes to the body"
    assert "Body of 12 masses" in (desk.page.locator(".softrod-body").get_attribute("aria-label") or "")
    for _ in range(5):
        desk.page.keyboard.press("ArrowRight")
    desk.until(lambda: "mass 5 of 0 to 11" in live.inner_text(), "the arrows choose")
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
    for name in ("Reset", "Back 1 second", "Back 1 frame", "Pause", "1 step", "Time shown", "Speed"):
        assert name in reached


def test_a_finger_beside_a_mass_takes_hold_of_it(open_page: OpenPage) -> None:
    desk = open_page(phone=True)
    desk.tell(commands.Play(False))
    x, y = desk.place(8)
    touch = desk.context.new_cdp_session(desk.page)

    def send(kind: str, *points: tuple[float, float]) -> None:
        places = [{"x": px, "y": py} for px, py in points]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": places})

    send("touchStart", (x + 22.0, y))
    desk.until(lambda: desk.session.hands.masses == (8,), "the mass 22 px away is in hand")
    before = desk.simulation.positions[8]
    for i in range(1, 6):
        send("touchMove", (x + 22.0 + 8.0 * i, y))
        desk.rest(1)
    desk.until(lambda: desk.simulation.positions[8][0] > before[0] + 20.0, "it comes with the finger")
    send("touchEnd")
    desk.until(lambda: not desk.session.hands.masses, "it is let go")


def test_every_control_has_a_name(open_page: OpenPage) -> None:
    desk = open_page()
    unnamed = """() => {
      const named = e => e.ariaLabel || e.innerText || e.labels?.[0]?.innerText || e.title;
      return [...document.querySelectorAll("button, input:not([type=hidden]), select, [role=slider]")]
        .filter(e => e.checkVisibility() && e.tabIndex >= 0 && !named(e)).map(e => e.outerHTML.slice(0, 300));
    }"""
    for tab in ("Play", "Measure", "Solver", "Share"):
        desk.show(tab)
        desk.rest(5)
        assert desk.page.evaluate(unnamed) == [], tab
    desk.show("Play")
    thumb = desk.page.get_by_role("slider", name="Linear stiffness")
    desk.until(lambda: thumb.get_attribute("aria-valuetext") == "10000", "not the power of ten")


def test_space_presses_what_the_tab_key_has_reached(open_page: OpenPage) -> None:
    desk = open_page()

    def reach(selector: str) -> None:
        for _ in range(60):
            desk.page.keyboard.press("Tab")
            if desk.page.evaluate("s => document.activeElement.matches(s)", selector):
                return
        raise AssertionError(f"the Tab key never comes to {selector}")

    reach("input[type=checkbox]")
    desk.page.keyboard.press("Space")
    desk.until(lambda: desk.session.follow, "the switch is turned")
    assert desk.session.playing
    desk.pause(0.3)  # until the server has shown what it made of it
    desk.page.keyboard.press("Space")
    desk.until(lambda: not desk.session.follow, "and back")
    reach("[data-softrod-key=right]")
    desk.page.keyboard.down("Space")
    desk.until(lambda: "right" in desk.simulation.keys, "the pad holds")
    desk.page.keyboard.up("Space")
    desk.until(lambda: not desk.simulation.keys, "and lets go")
    assert desk.session.playing
