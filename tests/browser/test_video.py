"""Places in a video: one that a browser has recorded from a known motion gives it back."""

from __future__ import annotations

import base64
import csv
import struct
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page, expect

import sim
from app.server.serve import serving
from tests.browser.driver import LIMIT

expect.set_options(timeout=LIMIT * 1e3)

SIZE = 320, 240
RATE = 25.0
"""Frames a second."""
LENGTH = 100.0
"""Of the ruler that is drawn, px of the scene and of the video."""

ENCODE = """async ([places, rate]) => {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [320, 240];
  const pen = canvas.getContext("2d");
  const chunks = [];
  const encoder = new VideoEncoder({
    output: (chunk) => {
      const bytes = new Uint8Array(chunk.byteLength);
      chunk.copyTo(bytes);
      let text = "";
      for (const byte of bytes) text += String.fromCharCode(byte);
      chunks.push([chunk.type === "key", btoa(text)]);
    },
    error: (error) => { throw error; },
  });
  encoder.configure({ codec: "vp8", width: 320, height: 240, bitrate: 4e6 });
  places.forEach(([x, y], k) => {
    pen.fillStyle = "#203040";
    pen.fillRect(0, 0, 320, 240);
    pen.fillStyle = "#ffd43b";
    pen.beginPath();
    pen.arc(x, y, 7, 0, 2 * Math.PI);
    pen.fill();
    const frame = new VideoFrame(canvas, { timestamp: (k * 1e6) / rate });
    encoder.encode(frame, { keyFrame: k % 10 === 0 });
    frame.close();
  });
  await encoder.flush();
  return chunks;
}"""


def element(name: str, content: bytes) -> bytes:
    """An element of Matroska (RFC 8794): its name, hexadecimal, its length and its content."""
    return bytes.fromhex(name) + (1 << 56 | len(content)).to_bytes(8, "big") + content


def number(name: str, value: int) -> bytes:
    return element(name, value.to_bytes(4, "big"))


def webm(chunks: list[tuple[bool, str]], rate: float) -> bytes:
    """A video file (RFC 9559) of encoded frames; times are in whole milliseconds.

    Args:
        chunks: whether each can be shown without the ones before, and its bytes, as base64.
        rate: frames a second.
    """
    head = number("4286", 1) + number("42F7", 1) + number("42F2", 4) + number("42F3", 8)
    head += element("4282", b"webm") + number("4287", 2) + number("4285", 2)
    length = struct.pack(">d", 1e3 * len(chunks) / rate)
    about = (
        number("2AD7B1", 1_000_000) + element("4489", length) + element("4D80", b"-") + element("5741", b"-")
    )
    size = element("E0", number("B0", SIZE[0]) + number("BA", SIZE[1]))
    track = number("D7", 1) + number("73C5", 1) + number("83", 1) + element("86", b"V_VP8") + size
    blocks = b"".join(
        element("A3", struct.pack(">BhB", 0x81, round(1e3 * k / rate), 0x80 * key) + base64.b64decode(data))
        for k, (key, data) in enumerate(chunks)
    )
    body = element("1549A966", about) + element("1654AE6B", element("AE", track))
    body += element("1F43B675", number("E7", 0) + blocks)
    return element("1A45DFA3", head) + element("18538067", body)


def click_at(page: Page, x: float, y: float) -> None:
    """Click a place of the frame, in pixels of the video."""
    box = page.locator("#frame").bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + x * box["width"] / SIZE[0], box["y"] + y * box["height"] / SIZE[1])


def test_a_video_of_a_known_motion_gives_back_its_places(browser: Browser, tmp_path: Path) -> None:
    pendulum = sim.Simulation(sim.load_scene("pendulum"))
    recording = pendulum.record(1.6, "mass1.x", "mass1.y", every=round(1.0 / (RATE * pendulum.dt)))
    places = np.column_stack((recording["mass1.x"], recording["mass1.y"]))
    places = places - places.mean(axis=0)
    places *= 80.0 / np.abs(places).max()
    places += np.array(SIZE) / 2.0
    with serving(sim.load_scene("rope"), "127.0.0.1", 0) as (server, _, _):
        context = browser.new_context(viewport={"width": 390, "height": 844}, accept_downloads=True)
        page = context.new_page()
        page.set_default_timeout(LIMIT * 1e3)
        page.goto(f"http://127.0.0.1:{server.get_port()}/video")
        sent: list[str] = []
        data = webm(page.evaluate(ENCODE, [places.tolist(), RATE]), RATE)
        page.on("request", lambda request: sent.append(request.url))
        video = {"name": "swing.webm", "mimeType": "video/webm", "buffer": data}
        page.locator("#file").set_input_files([video])  # type: ignore[list-item]
        # The browser tells how many frames come in a second.
        expect(page.locator("#said")).to_contain_text("It has 25 frames a second")
        rate = page.locator("#rate")
        expect(rate).to_have_value("25")
        expect(page.locator("#where")).to_have_text(f"1 of {len(places)}, 0.000 s")
        # Who knows better corrects it.
        for typed, count in (("50", 2 * len(places)), ("25", len(places))):
            rate.fill(typed)
            rate.press("Enter")
            expect(page.locator("#where")).to_contain_text(f"1 of {count}")
        click_at(page, *places[0])
        page.get_by_role("button", name="Follow", exact=True).click()
        expect(page.locator("#said")).to_have_text("Followed.")
        page.get_by_role("button", name="Ruler").click()
        click_at(page, 60.0, 220.0)
        click_at(page, 60.0 + LENGTH, 220.0)
        page.get_by_role("button", name="Origin").click()
        click_at(page, 160.0, 120.0)
        page.locator("#length").fill("0.5")
        with page.expect_download() as downloading:
            page.get_by_role("button", name="Download the table").click()
        downloading.value.save_as(tmp_path / "video.csv")
        assert [url for url in sent if not url.startswith("blob:")] == []
        context.close()
    with (tmp_path / "video.csv").open() as file:
        head, *rows = list(csv.reader(file))
    assert head == ["time [s]", "mass1.x [m]", "mass1.y [m]"]
    table = np.array(rows, float)
    assert table[:, 0] == pytest.approx(np.arange(len(places)) / RATE, abs=1e-3)
    found = table[:, 1:] * LENGTH / 0.5 + [160.0, 120.0]
    assert np.hypot(*(found - places).T).max() < 1.0
