"""The strip of modes: a body is put into a mode by a drag and by keys, and its sound is as its tones say."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from app.bundle import bundle
from app.features import modes
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, until

MODES = Path(modes.__file__).parent

# Renders what the page would play after one stroke, with the very voices that it has.
RENDERED = (
    f"""async ([frequencies, dampings]) => {{
  const {{ Voices }} = (() => {{ {bundle(MODES / "sound.js")}; return {{ Voices }}; }})();
  const {{ tonesOf }} = (() => {{ {bundle(MODES / "tones.js")}; return {{ tonesOf }}; }})();
"""
    + """
  const found = [];
  for (let i = 0; i < frequencies.length; i++) {
    const context = new OfflineAudioContext(1, 3 * 24000, 24000);
    const one = frequencies.map((_, k) => (k === i ? 1 : 0));
    new Voices(context, context.destination).follow(tonesOf(frequencies, dampings, one), 0);
    const samples = (await context.startRendering()).getChannelData(0);
    // Where it crosses zero upwards: from the first to the last of them, a whole number of periods.
    const crossings = [];
    for (let n = 24000; n < samples.length; n++) {
      const [before, now] = [samples[n - 1], samples[n]];
      if (before < 0 && now >= 0) crossings.push(n - now / (now - before));
    }
    const loud = (from) => Math.hypot(...samples.subarray(from * 24000, from * 24000 + 12000));
    const pitch = ((crossings.length - 1) * 24000) / (crossings.at(-1) - crossings[0]);
    found.push([pitch, Math.log(loud(1) / loud(2))]);
  }
  return found;
}"""
)


def told(desk: Desk) -> str:
    """What the strip says of the bar that is looked at."""
    return desk.page.locator(".softrod-modes-says").inner_text()


def reached(desk: Desk, mode: int) -> float:
    """Amplitude of a mode of the page's body, px."""
    watch = desk.session.modes
    if watch is None or watch.found is None:
        return 0.0
    now = watch.excitation(desk.session.simulation)
    if now is None:
        return 0.0
    return math.hypot(now.amplitudes[mode], now.rates[mode] / watch.found.omega[mode])


def test_a_body_is_put_into_a_mode_and_heard(open_page: OpenPage) -> None:
    desk = open_page("bridge")
    desk.tell(commands.Play(False))  # or a mode dies away before a slow machine looks at it
    page: Any = desk.page
    assert page.locator(".softrod-modes").is_hidden()
    page.keyboard.press("v")
    bars = page.locator(".softrod-mode")
    until(page, lambda: bars.count() == 11, "there are ten bars, and one for what is in none")
    watch = desk.session.modes
    assert watch is not None
    bars.nth(3).hover()
    until(page, lambda: told(desk).startswith("Mode 4: 6.71 Hz"), "the strip says which mode it is")
    shape = page.locator(".softrod-mode-shape")
    until(page, lambda: len(shape.get_attribute("d") or "") > 100, "its shape is over the body")
    box = bars.nth(3).locator(".softrod-mode-box").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] - 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y - 10)
    page.mouse.move(x, y - box["height"] * 0.6)
    until(page, lambda: reached(desk, 3) > 0.4 * watch.full[3], "the body swings in the mode")
    page.mouse.up()
    assert desk.session.versions.undoable == "mode 4"
    page.mouse.move(x, 100)
    bars.nth(0).focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("End")
    until(page, lambda: reached(desk, 1) > 0.7 * watch.full[1], "a key puts it into another one")
    sound = page.locator(".softrod-modes-sound")
    assert sound.get_attribute("aria-pressed") == "false"
    page.keyboard.press("m")
    until(page, lambda: sound.get_attribute("aria-pressed") == "true", "M turns the sound on")
    page.keyboard.press("m")
    until(page, lambda: sound.get_attribute("aria-pressed") == "false", "and off")
    frequencies, dampings = [2.32, 3.43, 5.03], [0.031, 0.02, 0.0092]
    (first, *_), *_ = heard = page.evaluate(RENDERED, [frequencies, dampings])
    for (pitch, decay), frequency, damping in zip(heard, frequencies, dampings, strict=True):
        damped = (
            frequency * math.sqrt(1.0 - damping**2) / (frequencies[0] * math.sqrt(1.0 - dampings[0] ** 2))
        )
        assert abs(1200.0 * math.log2(pitch / first / damped)) < 2.0
        assert decay == pytest.approx(2.0 * math.pi * frequency * damping, rel=0.03)
    page.keyboard.press("v")
    until(page, lambda: page.locator(".softrod-modes").is_hidden(), "the strip closes")
    assert desk.session.modes is None
