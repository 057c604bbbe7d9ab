"""Places in a video: one that a browser has recorded from a known motion gives it back."""

from __future__ import annotations

import base64
import csv
from pathlib import Path

import numpy as np
from playwright.sync_api import Browser, Page, expect

import sim
from app.server.serve import serving
from tests.browser.driver import LIMIT

expect.set_options(timeout=LIMIT * 1e3)

SIZE = 320, 240
LENGTH = 100.0
"""Of the ruler that is drawn, px of the scene and of the video."""

RECORD = """async (places) => {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [320, 240];
  const pen = canvas.getContext("2d");
  const draw = ([x, y]) => {
    pen.fillStyle = "#203040";
    pen.fillRect(0, 0, 320, 240);
    pen.fillStyle = "#ffd43b";
    pen.beginPath();
    pen.arc(x, y, 7, 0, 2 * Math.PI);
    pen.fill();
  };
  draw(places[0]);
  const stream = canvas.captureStream(0), [track] = stream.getVideoTracks();
  const recorder = new MediaRecorder(stream, { mimeType: "video/webm;codecs=vp8", videoBitsPerSecond: 8e6 });
  const parts = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  recorder.start();
  for (const place of places) {
    draw(place);
    track.requestFrame();
    await new Promise((done) => setTimeout(done, 66));
  }
  const ended = new Promise((done) => (recorder.onstop = done));
  recorder.stop();
  await ended;
  const bytes = new Uint8Array(await new Blob(parts).arrayBuffer());
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}"""


def click_at(page: Page, x: float, y: float) -> None:
    """Click a place of the frame, in pixels of the video."""
    box = page.locator("#frame").bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + x * box["width"] / SIZE[0], box["y"] + y * box["height"] / SIZE[1])


def test_a_video_of_a_known_motion_gives_back_its_places(browser: Browser, tmp_path: Path) -> None:
    pendulum = sim.Simulation(sim.load_scene("pendulum"))
    recording = pendulum.record(1.6, "mass1.x", "mass1.y", every=round(1.0 / (15.0 * pendulum.dt)))
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
        data = page.evaluate(RECORD, places.tolist())
        page.on("request", lambda request: sent.append(request.url))
        video = {"name": "swing.webm", "mimeType": "video/webm", "buffer": base64.b64decode(data)}
        page.locator("#file").set_input_files([video])  # type: ignore[list-item]
        expect(page.locator("#said")).to_contain_text("Click a point")
        page.locator("#rate").fill("15")
        page.locator("#rate").press("Enter")
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
    assert (np.diff(table[:, 0]) > 0.0).all()
    found = table[:, 1:] * LENGTH / 0.5 + [160.0, 120.0]
    # A loaded machine may record frames late or twice, so each is compared with the nearest that was drawn.
    distances = np.hypot(*(found[:, None, :] - places[None, :, :]).transpose(2, 0, 1))
    assert distances.min(axis=1).max() < 1.0
    assert len(set(distances.argmin(axis=1))) > 0.6 * len(places)
