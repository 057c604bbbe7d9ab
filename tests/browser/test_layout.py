"""The count of what is wrong with a layout finds what is wrong, and nothing else (`layout.py`)."""

from __future__ import annotations

from playwright.sync_api import Browser

from tests.browser.layout import faults

RIGHT = """<style>
  body { margin: 0; font: 16px/24px sans-serif }
  button { display: block; width: 120px; height: 48px }
  .near { position: relative; width: 10px; height: 10px; margin: 24px }
  .near::after { content: ""; position: absolute; inset: -24px }
  .spoken { position: absolute; width: 1px; height: 1px; overflow: hidden }
  .long { width: 100px; overflow-x: auto; white-space: nowrap }
</style>
<button>Pause</button>
<button class="near" aria-label="Close"></button>
<label style="display: block; height: 48px; width: 200px"><input type="checkbox">Follow</label>
<p>A link <a href="#there">in a sentence</a>.</p>
<span class="spoken">words for screen readers alone, which nobody sees</span>
<div class="long">a line that can be scrolled to its end, however long it is</div>
<div style="overflow: hidden; height: 30px"><div style="overflow-y: auto; height: 60px">
  <p>one</p><p>two</p><p>three</p></div></div>
<button inert style="width: 9px; height: 9px"></button>
"""

WRONG = """<style>
  .over { position: absolute; left: 0; top: 0; width: 130px; height: 50px; background: white }
  .narrow { width: 60px; overflow: hidden; white-space: nowrap; text-overflow: ellipsis }
  .out { position: absolute; left: 340px; top: 300px; white-space: nowrap }
</style>
<div class="over"></div>
<button style="width: 20px; height: 20px; margin-top: 30px" aria-label="tiny"></button>
<button style="width: 100px; white-space: nowrap; margin-top: 30px">words that leave the button</button>
<div class="narrow">words that end in dots</div>
<div class="out">words that leave the window</div>
<input aria-label="mass" value="123456789012345" style="width: 40px; height: 48px">
"""


def test_a_layout_is_judged_by_what_a_finger_and_an_eye_find(browser: Browser) -> None:
    context = browser.new_context(viewport={"width": 390, "height": 844})
    page = context.new_page()
    page.set_content(RIGHT)
    assert faults(page, touched=True) == []
    page.set_content(RIGHT + WRONG)
    found = [(fault.fault, fault.words, fault.more.split()[0]) for fault in faults(page, touched=True)]
    assert found == [
        ("small", "tiny", "20"),
        ("small", "mass", "40"),
        ("covered", "Pause", "under"),
        ("cut", "words that leave the button", "out"),
        ("cut", "words that end in dots", "cut"),
        ("cut", "words that leave the window", "out"),
        ("cut", "mass 123456789012345", "longer"),
        ("zooms", "mass", "13.3333px"),
    ]
    context.close()


def test_what_has_just_opened_may_lie_over_the_rest(browser: Browser) -> None:
    context = browser.new_context(viewport={"width": 390, "height": 844})
    page = context.new_page()
    page.set_content("<button style='width: 120px; height: 48px'>Pause</button>")
    assert faults(page, touched=False) == []
    page.evaluate("visibleThings.remember()")
    page.evaluate("""document.body.insertAdjacentHTML("beforeend",
        "<div style='position: absolute; inset: 0; background: white'>a menu</div>")""")
    assert faults(page, touched=False) == []
    page.evaluate("visibleThings.remember()")
    assert [fault.fault for fault in faults(page, touched=False)] == ["covered"]
    context.close()
