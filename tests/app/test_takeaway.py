"""What a teacher takes home of a class."""

from __future__ import annotations

import csv
import io
import zipfile

import numpy as np
import pytest
from PIL import Image

import sim
from app.classroom.answers import Line, Phase, Prediction, Vote, Work
from app.classroom.room import Room
from app.classroom.takeaway import PICTURE_SIZE, log_path, pack
from app.export.window import Window
from app.stage.colors import palette
from app.stage.sketch import Sketch
from app.words import speaking
from tests.app.test_room import a_room, an_answer

pytestmark = pytest.mark.usefixtures("class_folder")


def tables(data: bytes, delimiter: str = ",") -> tuple[list[dict[str, str]], list[dict[str, str]]]:
    with zipfile.ZipFile(io.BytesIO(data)) as file:
        texts = [file.read(name).decode("utf-8-sig") for name in ("answers.csv", "predictions.csv")]
    answers, predictions = (list(csv.DictReader(io.StringIO(text), delimiter=delimiter)) for text in texts)
    return answers, predictions


def test_everything_that_was_given_is_in_the_zip_once() -> None:
    room = a_room()
    seat = room.enter("0" * 32)
    room.go(0, Phase.ASK)
    room.take(1, an_answer(1, Vote(1)))
    room.take(1, an_answer(2, Prediction(((0.5, 1.0), (2.0, 3.0), (4.0, 5.0), (6.0, 7.0)))))
    room.go(0, Phase.EXPLAIN)
    room.take(1, an_answer(3, Line('=HYPERLINK("x")')))
    room.go(0, Phase.COLLECT)
    path = log_path(room.code, "one.jsonl")
    path.parent.mkdir(parents=True)
    path.write_text("a log")
    points = tuple((100.0 + 40.0 * i, 200.0) for i in range(4))
    room.take(1, an_answer(4, Work(log="one.jsonl", found=1.25, reached=True, points=points)))
    data = pack(room)
    answers, predictions = tables(data)
    assert [(row["kind"], row["answer"], row["right"]) for row in answers] == [
        ("vote", "right", "yes"),
        ("line", '\'=HYPERLINK("x")', ""),
        ("handed in", "1.25", "yes"),
    ]
    assert {row["name"] for row in answers} == {seat.name}
    assert [(row["mass"], row["x"], row["y"]) for row in predictions] == [
        ("0", "0.5", "1"), ("1", "2", "3"), ("2", "4", "5"), ("3", "6", "7"),
    ]  # fmt: skip
    with zipfile.ZipFile(io.BytesIO(data)) as file:
        assert file.testzip() is None
        logs = [name for name in file.namelist() if name.startswith("logs/")]
        assert [file.read(name) for name in logs] == [b"a log"]
        (picture,) = (name for name in file.namelist() if name.startswith("pictures/"))
        with Image.open(file.open(picture)) as image:
            assert image.size == PICTURE_SIZE
            shown = np.asarray(image.convert("RGB")).copy()
        # Where the third mass is, and not where the scene has it.
        scene = room.scenes[0]
        sketch = Sketch(scene, palette(scene.view.colors, False))
        window = Window.fit(sketch, scene.view.frame, PICTURE_SIZE, np.array(points))
        at = np.array([points[2], scene.masses[3].position])
        columns, rows = window.pixels(sketch.mapping.to_world(at)[:, :2]).round().astype(int).T
        assert (shown[rows, columns].min(axis=1) < 150).tolist() == [True, False]
        scenes = sorted(name for name in file.namelist() if name.startswith("scenes/"))
        assert len(scenes) == 2
        file.extract(scenes[0], path.parent)
    assert sim.load_scene(path.parent / scenes[0]).lesson == room.scenes[0].lesson


def test_tables_have_decimal_commas_where_the_language_has() -> None:
    room = a_room()
    room.enter("0" * 32)
    room.go(0, Phase.COLLECT)
    room.take(1, an_answer(1, Work(found=1.25)))
    with speaking("de"):
        data = pack(room)
    (row,), _ = tables(data, ";")
    assert row["Antwort"] == "1,25"
    with zipfile.ZipFile(io.BytesIO(data)) as file:
        assert "Dezimalkommas" in file.read("README.txt").decode()


def test_a_late_prediction_is_marked_in_its_table() -> None:
    room = a_room()
    for secret in ("0", "1"):
        room.enter(secret * 32)
    room.go(0, Phase.ASK)
    where = Prediction(((0.5, 1.0),) * 4)
    room.take(1, an_answer(1, where))
    room.go(0, Phase.RESULTS)
    room.take(2, an_answer(2, where))
    _, predictions = tables(pack(room))
    assert {(row["seat"], row["late"]) for row in predictions} == {("1", "no"), ("2", "yes")}


def test_points_of_the_plot_are_in_the_zip_with_its_axes() -> None:
    room = Room(code="ABCD", key="key", scenes=(sim.load_scene("lesson-hooke"),))
    room.enter("0" * 32)
    room.go(0, Phase.COLLECT)
    room.take(1, an_answer(1, Work(found=12.5, setting=1000.0)))
    with zipfile.ZipFile(io.BytesIO(pack(room))) as file:
        (row,) = csv.DictReader(io.StringIO(file.read("found.csv").decode("utf-8-sig")))
    axes = [row[key] for key in ("over", "over unit", "what", "unit")]
    assert axes == ["Gravity", "px/s²", "stretch of spring 0", "px"]
    assert (row["setting"], row["found"]) == ("1000", "12.5")
