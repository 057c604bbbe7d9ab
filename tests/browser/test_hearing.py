"""Plots are read by ear: what somebody hears who sees nothing."""

from __future__ import annotations

import csv
import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app import ui
from app.bundle import bundle
from app.session import commands
from tests.browser.conftest import OpenPage
from tests.browser.driver import Desk, until

SOUNDS = "() => JSON.stringify(window.__softrod.sounds())"
LOW, HIGH = 220.0, 880.0
UI = Path(ui.__file__).parent


def sounds(desk: Desk) -> list[dict[str, Any]]:
    """What has sounded."""
    return json.loads(desk.page.evaluate(SOUNDS))


def said(desk: Desk, of: str) -> str:
    """The words of a live region that say something."""
    found = desk.page.locator("[role=status]").filter(has_text=of)
    until(desk.page, lambda: found.count() == 1, f"something is said of {of}")
    return found.inner_text().strip()


def read_by_ear(desk: Desk, name: str) -> tuple[np.ndarray, float, float]:
    """Values of a line at equal times, and these times' ends, from what is said and heard alone."""
    line = re.search(re.escape(name) + r": ([-\d.]+) to ([-\d.]+) ", said(desk, name))
    span = re.search(r"From ([-\d.]+) to ([-\d.]+) s\.", said(desk, name))
    assert line
    assert span
    low, high = float(line[1]), float(line[2])
    tones = [each for each in sounds(desk) if each["kind"] == "tone" and each["name"] == name]
    parts = np.array([math.log(each["tones"][0][0] / LOW) / math.log(HIGH / LOW) for each in tones])
    return low + (high - low) * parts, float(span[1]), float(span[2])


def test_a_plot_is_read_from_words_and_tones_and_a_line_shows_where_it_sounds(open_page: OpenPage) -> None:
    desk = open_page("pendulum")
    page = desk.page
    page.keyboard.press("h")
    assert said(desk, "There is no plot to hear.")
    desk.show("Measure")
    page.locator(".softrod-chart").wait_for()
    quantity = page.get_by_label("Quantity", exact=True)
    quantity.select_option(label="vx")
    desk.button("Add to it").click()
    time = desk.simulation.time
    desk.until(lambda: desk.simulation.time > time + 3.0, "it swings")
    desk.tell(commands.Play(False))
    with page.expect_download() as download:
        desk.button("CSV").click()
    with download.value.path().open(newline="") as file:
        header, *table = csv.reader(file)
    assert header == ["time [s]", "mass1.x [px]", "mass1.vx [px/s]"]
    rows = np.array([[float(each or "nan") for each in row] for row in table])
    desk.page.evaluate("document.activeElement.blur()")
    page.keyboard.press("h")
    until(page, lambda: any(each["kind"] == "silence" for each in sounds(desk)), "it is played")
    values, start, end = read_by_ear(desk, "mass1.x")
    assert len(values) > 10
    wanted = np.interp(np.linspace(start, end, len(values)), rows[:, 0], rows[:, 1])
    assert np.abs(values - wanted).max() < 0.02 * np.ptp(rows[:, 1])
    pans = {each["name"]: each["pan"] for each in sounds(desk) if each["kind"] == "tone"}
    assert pans == {"mass1.x": -1, "mass1.vx": 1}
    speeds = rows[np.isfinite(rows[:, 2]) & (rows[:, 0] >= start - 0.01), 2]
    crossings = int((np.diff(np.sign(speeds)) != 0).sum())
    clicks = [each for each in sounds(desk) if each["kind"] == "click" and each["name"] == "mass1.vx"]
    assert abs(len(clicks) - crossings) <= 1
    cursor = page.locator(".softrod-heard")
    until(page, lambda: (cursor.get_attribute("d") or "").startswith("M"), "a line goes along")
    until(page, lambda: cursor.get_attribute("d") == "", "and away")


def test_a_plot_is_heard_while_the_body_moves_unless_sound_is_off(open_page: OpenPage) -> None:
    desk = open_page("pendulum")
    page = desk.page
    desk.show("Measure")
    page.locator(".softrod-chart").wait_for()
    live = page.get_by_label("Hear while it moves")
    live.check()
    until(page, lambda: len(sounds(desk)) > 30, "it sounds")
    tones = [each for each in sounds(desk) if each["kind"] == "tone"]
    assert {each["name"] for each in tones} == {"mass1.x"}
    assert all(LOW - 0.1 <= each["tones"][0][0] <= HIGH + 0.1 for each in tones)
    desk.tell(commands.Play(False))
    until(page, lambda: sounds(desk)[-1]["kind"] == "silence", "a paused body is silent")
    page.evaluate("document.activeElement.blur()")
    desk.view("Access and language")
    page.get_by_label("Sound", exact=True).uncheck()
    page.keyboard.press("Escape")
    count = len(sounds(desk))
    desk.tell(commands.Play(True))
    page.keyboard.press("h")
    assert said(desk, "Sound is off, see Access and language.")
    desk.rest(5)
    assert len(sounds(desk)) == count
    page.keyboard.press("Shift+H")
    until(page, lambda: not live.is_checked(), "the key turns it off")


# Renders what would be heard, with the very voices of the page: two lines, and a tone that goes round.
RENDERED = (
    f"""async () => {{
  const {{ Voice }} = (() => {{ {bundle(UI / "voice.js")}; return {{ Voice }}; }})();
  const {{ panOf, pitchOf, circularTones }} = (() => {{ {bundle(UI / "pitch.js")};
    return {{ panOf, pitchOf, circularTones }}; }})();
"""
    + """
  const context = new OfflineAudioContext(2, 24000, 24000);
  const bounds = { bottom: 0, top: 1, turns: false };
  [0, 1].forEach((value, i) => {
    const tones = [{ pitch: pitchOf(value, bounds), gain: 1 }];
    new Voice(context, context.destination, panOf(i, 2), 0.3).play(tones, 0, 0.006);
  });
  const played = await context.startRendering();
  const pitches = [0, 1].map((side) => {
    const samples = played.getChannelData(side);
    const crossings = [];
    for (let n = 12000; n < samples.length; n++) {
      const [before, now] = [samples[n - 1], samples[n]];
      if (before < 0 && now >= 0) crossings.push(n - now / (now - before));
    }
    return ((crossings.length - 1) * 24000) / (crossings.at(-1) - crossings[0]);
  });
  const round = new OfflineAudioContext(1, 24000, 24000);
  const voice = new Voice(round, round.destination, 0, 0.3);
  for (let i = 0; i < 200; i++) voice.play(circularTones(90 + 3.6 * i), i / 200, 0.006);
  const samples = (await round.startRendering()).getChannelData(0);
  let [jump, loudest] = [0, 0];
  for (let n = 2400; n < samples.length; n++) {
    jump = Math.max(jump, Math.abs(samples[n] - samples[n - 1]));
    loudest = Math.max(loudest, Math.abs(samples[n]));
  }
  return { pitches, jump, loudest };
}"""
)


def test_two_lines_are_heard_in_two_ears_and_a_tone_that_goes_round_does_not_click(
    open_page: OpenPage,
) -> None:
    desk = open_page()
    found = desk.page.evaluate(RENDERED)
    assert found["pitches"] == [pytest.approx(LOW, rel=1e-3), pytest.approx(HIGH, rel=1e-3)]
    assert 0.1 < found["loudest"] < 0.4
    assert found["jump"] < 0.5 * found["loudest"]  # a click would be as large as the tone
