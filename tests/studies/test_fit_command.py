"""`softrod fit`: what it prints and writes, and what it refuses."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import sim
from app.cli.main import main
from tests.sim.measured import measure, spring_pendulum


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A scene with another stiffness, and a table in the manner of a spreadsheet: 4 px to the centimetre."""
    path = tmp_path_factory.mktemp("fit")
    data = measure(spring_pendulum(), ["mass1.y"], 1.5, 0.01, np.random.default_rng(1))
    rows = (
        f"{t:.4f};{-y / 4:.4f}".replace(".", ",")
        for t, y in zip(data.time, data.columns[0].values, strict=True)
    )
    (path / "phone.csv").write_text("t (s);Height (cm)\n" + "\n".join(rows), encoding="utf-8")
    sim.save_scene(sim.set_value(spring_pendulum(), "linear_stiffness", 95.0), path / "scene.json")
    return path


def run(folder: Path, *words: str) -> int:
    with pytest.raises(SystemExit) as end:
        main(["fit", str(folder / "scene.json"), str(folder / "phone.csv"), *words])
    return int(end.value.code or 0)


def test_numbers_are_printed_and_scene_values_and_figure_written(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ("--vary", "linear_stiffness", "--scale", "400", "--out", str(folder / "out"))
    assert run(folder, *words) == 0
    printed = capsys.readouterr().out
    assert "phone.csv, Height as -mass1.y: what is left is 0." in printed
    rows = list(csv.DictReader(io.StringIO((folder / "out" / "values.csv").read_text())))
    assert [row["number"] for row in rows] == ["linear_stiffness"]
    assert float(rows[0]["low"]) < 80.2
    assert float(rows[0]["high"]) > 79.8
    assert rows[0]["known"] == "yes"
    fitted = sim.load_scene(folder / "out" / "scene.json")
    assert fitted.linear_springs[0].stiffness == pytest.approx(80.0, rel=0.01)
    with Image.open(folder / "out" / "fit.png") as image:
        assert image.size[0] > 500


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), "--vary: name what is sought"),
        (
            ("--vary", "gravity"),
            "column 'Height': it is in cm, but the scene in px; say how many px one m is",
        ),
        (("--vary", "gravity", "--match", "Height"), "--match Height: COLUMN=QUANTITY is expected"),
        (
            ("--vary", "gravity", "--match", "Depth=mass1.y"),
            "phone.csv: there is no column 'Depth'; there are Height",
        ),
        (("--vary", "gravity", "--match", "Height=mass9.y"), "mass9.y: mass 9 does not exist"),
    ],
)
def test_what_is_not_right_is_said_in_a_sentence(
    words: tuple[str, ...], said: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(folder, *words) == 1
    assert said in capsys.readouterr().err
