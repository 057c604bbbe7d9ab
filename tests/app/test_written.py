"""Files, links, logs, and names of keys and options that users have from earlier releases can still be read.

`tests/app/written` holds them as they were written then. Never change them: when a name changes, its old form
is still read.
"""

from __future__ import annotations

import io
import json
import re
import zipfile
import zlib
from base64 import b64encode
from pathlib import Path

import msgspec
import pytest

import sim
from app.classroom import kept as disk
from app.classroom import takeaway
from app.pages.sandbox.features import COMMANDS, CONTROLS
from app.session import commands
from app.session.log import decode_log
from app.ui.kept import keeping
from sim.motion.quantities import PARTS
from sim.settings import CHOICES, setting_keys
from sim.solve.registry import METHODS
from tests.app.command import Softrod
from tests.app.pages import SessionPage
from tests.app.recording import replayed

WRITTEN = Path(__file__).parent / "written"
NAMES = json.loads((WRITTEN / "names.json").read_text(encoding="utf-8"))
LINKS: dict[str, str] = json.loads((WRITTEN / "links.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("kind", "now"),
    [
        ("commands", COMMANDS),
        ("controls", CONTROLS),
        ("settings", setting_keys()),
        ("choices", CHOICES),
        ("methods", METHODS),
        ("presets", {info.name for info in sim.list_scenes()}),
    ],
)
def test_every_name_is_known(kind: str, now: object) -> None:
    assert NAMES[kind]
    assert not set(NAMES[kind]) - set(now)  # type: ignore


def test_every_quantity_is_known() -> None:
    assert {part: set(names) - set(PARTS[part]) for part, names in NAMES["quantities"].items()} == {
        part: set() for part in NAMES["quantities"]
    }


@pytest.mark.parametrize("command", NAMES["options"])
def test_every_option_of_the_command_line_is_known(
    command: str, softrod: Softrod, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "300")  # so that no option is broken at the end of a line
    shown = softrod(*command.split(), "--help").stdout
    assert not set(NAMES["options"][command]) - set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", shown))


@pytest.mark.parametrize("name", LINKS)
def test_links_lead_to_their_scenes(name: str) -> None:
    was, now = sim.load_scene(LINKS[name]), sim.load_scene(name)
    # It may be worded in another way since; what was written in format 3 keeps the tutorial's air.
    now = msgspec.structs.replace(now, air_law="tutorial", lesson=None, description=was.description)
    assert msgspec.structs.replace(was, lesson=None) == now
    assert (was.lesson is None) == (sim.load_scene(name).lesson is None)


def test_a_saved_pose_goes_on() -> None:
    scene = sim.load_scene(WRITTEN / "posed.json")
    assert scene.pose is not None
    assert scene.pose.damage is not None
    before = sim.load_scene("girder")
    assert scene.linear_springs == before.linear_springs
    assert sim.Simulation(scene).positions.tolist() == [list(place) for place in scene.pose.positions]


def test_a_log_is_replayed() -> None:
    player = replayed((WRITTEN / "log.jsonl").read_bytes())
    # Another machine rounds otherwise: the verdict is either, but every line was done.
    assert player.ended
    assert player.simulation.time > 1.0
    assert decode_log((WRITTEN / "log.jsonl").read_bytes(), "log").checks > 0


def test_a_page_comes_back() -> None:
    kept = keeping.decode(b64encode(zlib.compress((WRITTEN / "page.json").read_bytes())).decode())
    assert kept is not None
    assert (kept.looks.dark, kept.looks.commas, kept.looks.gizmos, kept.looks.meter) == (
        True,
        True,
        True,
        False,
    )
    assert [plot.names for plot in kept.plots] == [("joint4.angle",), ("mass11.vy",)]
    assert kept.plots[1].over == "mass11.y"
    page = SessionPage("ring")
    page.frames(5)
    page.session.post(commands.Resume(bytes(kept.session)))
    page.session.drain()
    assert page.session.scene.name == sim.load_scene("tutorial-3.3").name
    assert (page.session.joint, page.session.pacer.speed, page.session.follow) == (4, 2.0, True)


def test_a_class_goes_on_and_gives_the_same_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(disk, "classes_folder", lambda: tmp_path)
    (tmp_path / "ABCD").mkdir()
    (tmp_path / "ABCD" / disk.FILE).write_bytes((WRITTEN / "class.json").read_bytes())
    room = disk.read("ABCD")
    assert room is not None
    assert len(room.answers) == 4
    with zipfile.ZipFile(io.BytesIO(takeaway.pack(room))) as file:
        assert file.read("answers.csv").splitlines() == (WRITTEN / "answers.csv").read_bytes().splitlines()
        assert len(file.read("predictions.csv").splitlines()) == 5
