"""The table that the page /video writes is one that a scene can be fitted to."""

from __future__ import annotations

import json
import subprocess

import numpy as np
import pytest

import sim
from sim.design.measurements import parse_measurements
from sim.settings import set_value
from tests.page.check import FOLDER, NODE
from tests.sim.measured import measure

RATE = FOLDER.parents[1] / "app" / "pages" / "video" / "rate.js"
RATES = """
import { readFileSync } from "node:fs";
import { rateOf } from "%s";
process.stdout.write(JSON.stringify(JSON.parse(readFileSync(0, "utf8")).map(rateOf)));
"""
TABLE = FOLDER.parents[1] / "app" / "pages" / "video" / "table.js"
WRITE = """
import { readFileSync } from "node:fs";
import { tableOf } from "%s";
const { points, times, scale } = JSON.parse(readFileSync(0, "utf8"));
const found = points.map(({ name, places }) => ({ name, places: new Map(places) }));
process.stdout.write(tableOf(found, new Map(times), scale));
"""


def by_node(script: str, given: object) -> bytes:
    """What a script of the page writes, given something."""
    run = subprocess.run(
        [NODE, "--input-type=module", "--eval", script],
        input=json.dumps(given).encode(),
        capture_output=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr.decode()
    return run.stdout


def written(places: np.ndarray, times: np.ndarray, **scale: object) -> bytes:
    """The table as the page's own script writes it.

    Args:
        places: (k, 2) of one point in each frame, pixels of the video; NaN where it is not marked.
        times: (k,) s.
        scale: see `table.js`.
    """
    marked = [[k, {"x": x, "y": y}] for k, (x, y) in enumerate(places.tolist()) if np.isfinite([x, y]).all()]
    said = {
        "points": [{"name": "mass1", "places": marked}],
        "times": list(enumerate(times.tolist())),
        "scale": scale,
    }
    return by_node(WRITE % TABLE.as_uri(), said)


def test_the_frame_rate_is_told_from_the_times_of_some_frames() -> None:
    random = np.random.default_rng(7)
    cases, rates = [], []
    for rate in (12.5, 24.0, 25.0, 29.97, 30.0, 59.94, 60.0, 120.0, 240.0):
        times = np.arange(24) / rate
        in_milliseconds = np.round(times, 3)
        # Up to a third of the frames is not caught, in the middle.
        caught = np.sort(random.choice(np.arange(1, 23), 15, replace=False))
        some = np.concatenate(([0], caught, [23]))
        uneven = times + random.uniform(-0.1, 0.1, times.size) / rate
        cases += [times, in_milliseconds[some], random.permutation(times[some]), uneven]
        rates += 4 * [rate]
    found = json.loads(by_node(RATES % RATE.as_uri(), [case.tolist() for case in cases]))
    assert found == pytest.approx(rates, rel=0.012)
    assert found[0::4] == rates[0::4]
    assert json.loads(by_node(RATES % RATE.as_uri(), [[], [0.0] * 9, [0.0, 0.1, 0.2]])) == [None] * 3


def test_a_table_of_a_video_gives_back_what_the_body_was() -> None:
    """A pendulum of the preset's length under another gravity and in air, filmed at 1.7 pixels a px and
    marked to a third of a pixel; its ruler is the rod, half a metre long."""
    random = np.random.default_rng(5)
    guess = set_value(sim.load_scene("pendulum"), "air_friction", 2e-4)
    hidden = set_value(set_value(guess, "gravity", 1400.0), "air_friction", 6e-4)
    swing = measure(hidden, ["mass1.x", "mass1.y"], 2.5, 0.0, random)
    places = 1.7 * np.column_stack([column.values for column in swing.columns]) + [40.0, -25.0]
    seen = places + random.normal(0.0, 1.0 / 3.0, places.shape)
    seen[17] = np.nan
    corner = {"x": 40.0, "y": -25.0}
    text = written(seen, swing.time, origin=corner, pixels=1.7 * 500.0, unit="m", down=True)
    (table,) = parse_measurements(text, "video.csv")
    assert table.time.size == swing.time.size - 1
    assert [(column.name, column.unit) for column in table.columns] == [("mass1.x", "m"), ("mass1.y", "m")]
    found = sim.fit(guess, table, ["gravity", "air_friction"], scale=500.0)
    for name, truth in (("gravity", 1400.0), ("air_friction", 6e-4)):
        each = found.values[name]
        assert each.known
        assert each.low < truth < each.high, name
        assert each.high - each.low < 0.2 * truth, name
    # A third of a pixel is what is left.
    assert [each.noise for each in found.series] == pytest.approx([1.0 / 3.0 / 850.0] * 2, rel=0.3)
