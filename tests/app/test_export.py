"""What is taken home from a scene: films, replays and models, and the command that writes them."""

from __future__ import annotations

import base64
import io
import json
import subprocess
import threading
import zlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from msgspec.structs import replace as changed
from PIL import Image

import sim
from app.background import BackgroundWorker
from app.bundle import BundleError, bundle, bundles
from app.export import film, model, replay
from app.export.clip import Clip, ClipFrame
from app.export.formats import FORMATS
from app.session import commands
from app.session.session import Session
from app.stage.plan import Picture
from app.words import language, say, speaking
from sim.errors import InputError
from sim.scene.types import Damage
from tests.app.clips import swing
from tests.app.command import Softrod, refused
from tests.app.html_pages import held
from tests.app.pages import answered
from tests.page.check import NODE

ROPE = sim.rope(masses=5, length=200.0)


# ------------------------------------------------------------------------- clips
def test_a_clip_is_sampled_evenly_between_its_moments_and_ends_with_the_last() -> None:
    shots = swing(ROPE, 1.0, rate=17.0)
    clip = Clip(shots)
    found = list(clip.at(0.04))
    assert len(found) == clip.count(0.04) == 26
    assert np.diff([shot.picture.time for shot in found]) == pytest.approx(0.04)
    assert found[-1] is shots[-1]
    times = np.array([shot.picture.time for shot in shots])
    tips = np.array([shot.picture.positions[-1, 0] for shot in shots])
    for shot in found:
        assert shot.picture.positions[-1, 0] == pytest.approx(np.interp(shot.picture.time, times, tips))


def test_a_clip_has_the_last_seconds_of_one_body_only() -> None:
    assert Clip(swing(ROPE, 2.0), 0.5).seconds == pytest.approx(0.5)
    other = [replace(shot, picture=replace(shot.picture, time=shot.picture.time - 2.0)) for shot in swing(
        sim.rope(masses=4, length=200.0), 1.0
    )]  # fmt: skip
    clip = Clip([*other, *swing(ROPE, 0.5)])
    assert clip.seconds == pytest.approx(0.5)
    assert {len(shot.picture.positions) for shot in clip.frames} == {5}
    with pytest.raises(InputError, match="press Play"):
        Clip(swing(ROPE, 0.1))
    with pytest.raises(InputError, match="press Play"):
        Clip([])
    bad = swing(ROPE, 0.5)
    bad[3].picture.positions[0] = np.nan
    with pytest.raises(InputError, match="finite"):
        Clip(bad)


def test_a_session_hands_out_what_its_page_has_shown() -> None:
    clock = iter(np.arange(0.0, 1e3, 1.0 / 60.0))
    session = Session(ROPE, lambda: float(next(clock)))

    def recent(seconds: float) -> list[sim.Moment]:
        moments = answered(session, lambda: session.recent(seconds))
        return [moment for moment, ghost in moments if ghost is None]

    assert len(recent(1.0)) <= 1
    for _ in range(60):
        session.drain()
        session.tick(1.0)
    moments = recent(0.3)
    assert moments[-1].time == session.simulation.time
    assert (moments[-1].positions == session.simulation.positions).all()
    assert 0.3 <= moments[-1].time - moments[0].time < 0.4
    # What is gone back to is what ends it.
    session.post(commands.GoBack(0.2))
    assert recent(0.1)[-1].time == session.simulation.time < moments[-1].time


# ------------------------------------------------------------------------- films
def test_a_film_goes_at_real_speed_and_shows_the_body_where_it_is() -> None:
    clip = Clip(swing(ROPE, 0.8))
    told: list[float] = []
    data = film.gif(clip, (160, 120), progress=told.append)
    assert told == sorted(told)
    assert told[-1] == 1.0
    image = Image.open(io.BytesIO(data))
    assert image.size == (160, 120)
    durations, held = [], []
    for k in range(image.n_frames):  # type: ignore[attr-defined]
        image.seek(k)
        durations.append(image.info["duration"])
        frame = np.asarray(image.convert("RGB")).astype(int)
        red = (frame[:, :, 0] > 200) & (frame[:, :, 1] < 230) & (frame[:, :, 2] < 90)
        held.append(float(np.nonzero(red)[1].mean()))
    assert sum(durations[:-1]) == pytest.approx(800, abs=1)
    assert set(durations[:-1]) == {40}
    # Sideways and back: the discs, yellow, on their way.
    assert max(held) - min(held) > 3.0
    # Paper is white, not nearly.
    assert (np.asarray(image.convert("RGB")).reshape(-1, 3) == 255).all(1).mean() > 0.5
    assert film.gif(clip, (160, 120)) == data


def test_a_long_or_large_film_has_fewer_frames(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(film, "MAX_PIXELS", 11 * 64 * 64)
    image = Image.open(io.BytesIO(film.gif(Clip(swing(ROPE, 1.0)), (64, 64))))
    assert image.n_frames <= 11  # type: ignore[attr-defined]
    wide = changed(ROPE, view=sim.View(frame=(0.0, 0.0, 900.0, 100.0)))
    assert film.size_of(wide) == (640, 320)
    assert film.size_of(changed(ROPE, view=sim.View(frame=(0.0, 0.0, 300.0, 400.0))))[1] == 640


# ------------------------------------------------------------------------- replays
def sections(numbers: np.ndarray) -> list[np.ndarray]:
    """Arrays that stand one after the other, each after its length."""
    found = []
    while len(numbers):
        found.append(numbers[1 : 1 + int(numbers[0])])
        numbers = numbers[1 + int(numbers[0]) :]
    return found


def parts(text: str) -> tuple[dict, list[tuple[float, np.ndarray]]]:
    """What a replay's script is told, and the time and the places, px, of each of its frames."""
    about, data = held(text, "about"), base64.b64decode(held(text, "data"))
    arrays = sections(np.frombuffer(zlib.decompress(data), np.float32))
    assert len(arrays) == 2 * len(about["plans"]) + len(about["damages"]) + about["frames"]
    frames = map(sections, arrays[-about["frames"] :])
    return about, [(float(head[1]), positions.reshape(-1, 2)) for head, positions in frames]


def test_a_replay_has_every_pose_to_a_hundredth_of_a_pixel() -> None:
    shots = swing(ROPE, 1.0)
    text = replay.replay_html(Clip(shots)).decode()
    assert len(text) < 100_000
    _, frames = parts(text)
    assert len(frames) == 61
    for (time, positions), shot in zip(frames, shots, strict=True):
        assert time == pytest.approx(shot.picture.time)
        assert positions == pytest.approx(shot.picture.positions, abs=0.01)


def test_what_breaks_yields_or_is_set_anew_is_in_a_replay() -> None:
    shots = swing(ROPE)
    stiff = changed(ROPE, gravity=(0.0, 5.0))
    damage = Damage(broken=(2,))
    for k in range(30, 61):
        shots[k] = ClipFrame(stiff, replace(shots[k].picture, damage=damage))
    about, _ = parts(replay.replay_html(Clip(shots)).decode())
    assert about["plans"] == [0, 30]
    assert about["damages"] == [0, 30]


def test_a_large_body_has_fewer_frames_in_a_replay(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(replay, "MAX_NUMBERS", 200)
    about, frames = parts(replay.replay_html(Clip(swing(ROPE))).decode())
    assert len(frames) * 10 <= 200
    assert about["interval"] * (about["frames"] - 1) <= 1.0 + 1e-6


def test_the_bundler_refuses_what_it_does_not_know(tmp_path: Path) -> None:
    (tmp_path / "a.js").write_text('import "./b.js";\n')
    (tmp_path / "b.js").write_text("export const b = 1;\n")
    with pytest.raises(BundleError, match="is not known"):
        bundle(tmp_path / "a.js")
    (tmp_path / "b.js").write_text('import { c } from "./c.js";\nexport const b = c;\n')
    (tmp_path / "c.js").write_text('import { b } from "./b.js";\nexport const c = b;\n')
    with pytest.raises(BundleError, match="imports it"):
        bundle(tmp_path / "b.js")
    (tmp_path / "b.js").write_text("export const b = 1;\n")
    (tmp_path / "a.js").write_text(
        'import { b as c } from "./b.js";\nimport * as all from "./b.js";\nc + all.b;\n'
    )
    text = bundle(tmp_path / "a.js")
    assert text.count("const b = 1;") == 1
    assert "const { b: c } = module_b;" in text
    assert "import" not in text
    (tmp_path / "within").mkdir()
    (tmp_path / "within" / "b.js").write_text("export default import.meta.url;\n")
    (tmp_path / "a.js").write_text('import { b } from "./b.js";\nimport other from "./within/b.js";\n')
    text = bundle(tmp_path / "a.js")
    assert 'const exported_ = new URL("within/b.js", import.meta.url).href;' in text
    assert "const other = module_b_2.default;" in text
    (tmp_path / "a.js").write_text("const text = `\n  two lines`;\n")
    with pytest.raises(BundleError, match="several lines"):
        bundle(tmp_path / "a.js")


def test_what_is_loaded_later_shares_its_modules_with_what_is_there(tmp_path: Path) -> None:
    """Run by node: each module is there once, also one that has a namesake in another folder."""
    texts = {
        "pages/main.mjs": 'import { note } from "../parts/count.mjs";\n'
        'const load = async () => (await import("../later/more.mjs")).more();\n'
        "note();\nload().then((told) => console.log(told, note()));\n",
        "parts/count.mjs": "let count = 0;\nexport const note = () => (count += 1);\n",
        "later/more.mjs": 'import { note } from "../parts/count.mjs";\n'
        'import { note as own } from "./count.mjs";\n'
        "export const more = () => `${note()} ${own()}`;\nexport default 3;\n",
        "later/count.mjs": "export const note = () => 40;\n",
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    made = bundles(tmp_path / "pages" / "main.mjs")
    assert [path.name for path in made] == ["main.mjs", "more.mjs"]
    for path, text in made.items():
        target = tmp_path / "made" / path.relative_to(tmp_path)
        target.parent.mkdir(parents=True)
        target.write_text(text)
    run = subprocess.run([NODE, tmp_path / "made" / "pages" / "main.mjs"], capture_output=True, text=True)
    assert run.stdout == "2 40 3\n", run.stderr
    with pytest.raises(BundleError, match="alone cannot load"):
        bundle(tmp_path / "pages" / "main.mjs")
    (tmp_path / "later" / "more.mjs").write_text('const load = () => import("./count.mjs");\n')
    with pytest.raises(BundleError, match="cannot load others"):
        bundles(tmp_path / "pages" / "main.mjs")
    (tmp_path / "later" / "more.mjs").write_text('import { note } from "./count.mjs";\nnote();\n')
    (tmp_path / "later" / "other.mjs").write_text('import { note } from "./count.mjs";\nnote();\n')
    both = 'const all = [import("../later/more.mjs"), import("../later/other.mjs")];\n'
    (tmp_path / "pages" / "main.mjs").write_text(both)
    with pytest.raises(BundleError, match="several that are loaded later"):
        bundles(tmp_path / "pages" / "main.mjs")


# ------------------------------------------------------------------------- models
def test_a_model_has_the_bodys_parts_and_colours() -> None:
    scene = changed(sim.load_scene("girder"), walls=())
    picture = Picture.at_start(scene)
    data = model.glb(scene, replace(picture, damage=Damage(broken=(0, 1))))
    loaded = trimesh.load_scene(io.BytesIO(data), file_type="glb")
    assert set(loaded.geometry) == {"masses", "springs", "supports"}
    low, high = picture.positions.min(0), picture.positions.max(0)
    radius = max(mass.radius for mass in scene.masses)
    reach = loaded.geometry["masses"].bounds
    assert reach[1][0] - reach[0][0] == pytest.approx(0.001 * (high[0] - low[0] + 2 * radius), rel=0.05)
    balls = loaded.geometry["masses"].split()
    assert len(balls) == len(scene.masses)
    assert all(ball.is_watertight and ball.volume > 0.0 for ball in balls)
    coils = loaded.geometry["springs"].split()
    assert len(coils) == len(scene.linear_springs) - 2
    assert all(coil.volume > 0.0 for coil in coils)
    # Linear light: the yellow of a mass has little blue.
    red, green, blue = np.median(loaded.geometry["masses"].visual.vertex_attributes["color"], axis=0)[:3]
    assert red > 240
    assert 110 < green < 160
    assert blue < 10
    words = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
    assert words["asset"]["extras"]["metres_per_px"] == 0.001
    with pytest.raises(InputError, match="finite"):
        model.glb(scene, replace(picture, positions=picture.positions * np.nan))


def test_walls_and_wedges_are_in_a_model_where_there_are_any() -> None:
    scene = sim.load_scene("water-balloon")
    scene = changed(scene, walls=scene.walls[:1])
    start = Picture.at_start(scene)
    loaded = trimesh.load_scene(
        io.BytesIO(model.glb(scene, replace(start, positions=start.positions * (1.0, 0.8)))), file_type="glb"
    )
    assert {"walls", "wedges"} <= set(loaded.geometry)
    assert loaded.geometry["walls"].bounds[1][1] <= loaded.geometry["masses"].bounds[0][1] + 1e-3


# ------------------------------------------------------------------------- the command
def test_the_command_writes_all_four(tmp_path: Path, softrod: Softrod) -> None:
    files = {kind: tmp_path / f"rope.{kind}" for kind in ("png", "gif", "html", "glb")}
    words = [word for kind, path in files.items() for word in (f"--{kind}", path)]
    made = softrod("export", "tutorial-3.3", *words, "--seconds", 0.4, "--size", "120x90", "--dark")
    assert made.returncode == 0
    assert Image.open(files["png"]).size == Image.open(files["gif"]).size == (120, 90)
    assert np.asarray(Image.open(files["png"]))[2, 2].max() < 70
    assert files["html"].read_text().startswith("<!doctype html>")
    assert files["glb"].read_bytes()[:4] == b"glTF"
    assert str(files["glb"]) in made.stdout
    assert {path.name for path in tmp_path.iterdir()} == {path.name for path in files.values()}


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), "--live, --sheet, --glb, --animation, --motion, --json, --csv, --python, --c or --javascript"),
        (("--gif", "a.png"), "must end in .gif"),
        (("--gif", "nowhere/a.gif"), "the folder nowhere does not exist"),
        (("--gif", "a.gif", "--seconds", 0), "0.2..60 s"),
        (("--png", "a.png", "--seconds", "nan"), "0..60 s"),
        (("--png", "a.png", "--size", "9000x10"), "16 to 4096"),
        (("--png", "a.png", "--after", "inf"), "0..10000 s"),
        (("--png", "a.png", "--set", "dt=0.5", "--set", "method=symplectic_euler"), "time step"),
        (("--motion", "a.zip"), "--motion a.zip: the file must end in .csv"),
        (("--animation", "a.gltf"), "--animation a.gltf: the file must end in .glb"),
        (("--glb", "a.glb", "--scale", 0), "--scale: 0 is not in the range 0.001..1e+09 px in a metre"),
        (("--motion", "a.csv", "--fps", 0), "--fps: 0 is not in the range 1..240"),
        (("--motion", "a.csv", "--fps", 241), "--fps: 241 is not in the range 1..240"),
        (("--animation", "a.glb", "--seconds", 0), "--seconds: 0 is not in the range 0.2..60 s"),
        (("--csv", "a.csv"), "--csv a.csv: the file must end in .zip"),
        (("--python", "a.c"), "--python a.c: the file must end in .py"),
        (("--c", "nowhere/a.c"), "the folder nowhere does not exist"),
    ],
)
def test_the_command_says_what_is_wrong_and_writes_nothing(
    words: tuple[object, ...],
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    softrod: Softrod,
) -> None:
    monkeypatch.chdir(tmp_path)
    refused(softrod("export", "tutorial-3.3", *words), said)
    assert not list(tmp_path.iterdir())


def test_the_guides_have_every_kind_of_file() -> None:
    docs = Path(__file__).parents[2] / "docs"
    heads = [line.split("|")[1] for line in (docs / "export.md").read_text().splitlines() if line[:2] == "| "]
    labels = {label.strip() for head in heads for label in head.split(",")}
    assert {say(each.button.label) for each in FORMATS if each.button is not None} <= labels
    options = (docs / "command-line.md").read_text()
    for each in FORMATS:
        assert f"`--{each.flag} FILE.{each.endings[0]}`" in options


def test_the_command_shows_a_recorded_log(tmp_path: Path, softrod: Softrod) -> None:
    clock = iter(np.arange(0.0, 1e3, 1.0 / 60.0))
    session = Session(sim.load_scene("tutorial-3.3"), lambda: float(next(clock)))
    session.post(commands.SetValue("rest_angle", 20.0))
    for _ in range(40):
        session.drain()
        session.tick(1.0)
    log = tmp_path / "log.jsonl"
    log.write_bytes(session.recorder.file())
    out, table = tmp_path / "rope.html", tmp_path / "rope.csv"
    made = softrod("export", "--inputs", log, "--html", out, "--motion", table, "--seconds", 0.3)
    assert made.returncode == 0
    _, frames = parts(out.read_text())
    assert frames[-1][0] == pytest.approx(session.simulation.time)
    rows = np.loadtxt(table, delimiter=",", skiprows=1)
    assert rows[:, 0] == pytest.approx(np.arange(19) / 60)
    assert rows[-1, 1:] == pytest.approx(session.simulation.positions.ravel(), abs=1e-3)
    assert "differs" not in made.stderr
    assert softrod("export", "ring", "--inputs", log, "--html", out).returncode == 1
    by_hand = tmp_path / "drive.log"
    by_hand.write_text('{"do": "step", "n": 10}\n')
    for given in (log, by_hand):
        refused(softrod("export", given, "--html", out), f"{given}: this is a log and no scene; ", "--inputs")


# ------------------------------------------------------------------------- the background
def test_the_worker_does_one_thing_after_the_other_and_survives_a_defect() -> None:
    done: list[int] = []
    shop, last = BackgroundWorker(), threading.Event()

    def defect() -> None:
        raise RuntimeError("a defect")

    shop.submit(lambda: done.append(1))
    shop.submit(defect)
    shop.submit(lambda: done.append(2))
    shop.submit(last.set)
    assert last.wait(10.0)
    assert done == [1, 2]


def test_the_worker_speaks_the_language_of_whoever_has_work_for_it() -> None:
    said: list[str] = []
    shop, last = BackgroundWorker(), threading.Event()
    with speaking("de"):
        shop.submit(lambda: said.append(language()))
    shop.submit(lambda: said.append(language()))
    shop.submit(last.set)
    assert last.wait(10.0)
    assert said == ["de", "en"]
