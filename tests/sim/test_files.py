"""Scenes as files: exact round trips, what broken files get to hear, and no file half written."""

from __future__ import annotations

import json
import os
import stat
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import ArrowKeys, Scene, SceneError, Simulation, list_scenes, load_scene, save_scene
from sim.scene.types import Circle
from sim.store.files import (
    MAX_FILE_BYTES,
    built_in_folder,
    decode_scene,
    encode_scene,
    safe_name,
    save_user_scene,
    write_atomically,
)
from sim.store.own_scenes import trash_user_scene
from tests.sim.bodies import tangle
from tests.sim.builders import PRESETS, star
from tests.sim.checks import refusal
from tests.sim.fuzzing import with_muscles


def refused(data: bytes | dict[str, Any]) -> str:
    """The sentence for a file that is no scene."""
    text = data if isinstance(data, bytes) else json.dumps(data).encode()
    said = refusal(SceneError, decode_scene, text, "file.json")
    assert said.startswith("file.json: ")
    return said.removeprefix("file.json: ")


# ------------------------------------------------------------------------- presets
def test_the_presets_are_there() -> None:
    assert {"tutorial-3.1", "tutorial-3.2", "tutorial-3.3", "ring", "box", "hair-tuft"} <= set(PRESETS)
    assert [info.name for info in list_scenes() if info.built_in and not info.group] == PRESETS


def test_groups_of_presets_are_kept_apart_and_found_by_name() -> None:
    grouped = {info.name: info for info in list_scenes() if info.group}
    assert {name for name, info in grouped.items() if info.group == "study"} == {
        f"study-{name}" for name in ("w1", "w2", "w3", "w4", "w5", "ring", "tree", "cloth")
    }
    assert {info.group for info in grouped.values()} == {"lessons", "muscles", "study"}
    assert all(info.built_in for info in grouped.values())
    for name in grouped:
        scene = load_scene(name)
        assert scene.name == name
        assert scene.description
        assert Simulation(scene).step(400) == 400
    with pytest.raises(SceneError, match="built-in"):
        safe_name("Study-W1")


@pytest.mark.parametrize("preset", PRESETS)
def test_presets_load_and_run(preset: str) -> None:
    scene = load_scene(preset)
    assert scene.name == preset
    assert scene.description
    simulation = Simulation(scene)
    assert simulation.step(2000) == 2000
    assert simulation.divergence is None
    assert simulation.dt < simulation.stability().limit


# ------------------------------------------------------------------------- round trips


SCENES = [
    sim.rope(),
    sim.rope(masses=2, joints=False, held=(), driven=None, direction=(-0.3, 1e-9), length=0.1 + 0.2),
    sim.rope(masses=700, arrow_keys=ArrowKeys(rest_length_factor=1.0 + 2.0**-52), gravity=(5e-324, -1e6)),
    sim.rope(
        angular_damping=3.0,
        circle=Circle(radius=20.0, frequency=-2.5, ramp=0.3),
        force_law="angle",
        integrator=sim.Integrator(method="rodas5p", tolerance=1e-7),
    ),
    replace(star(5), anchors=(sim.Anchor(mass=2, circle=Circle(radius=0.1 + 0.2)),)),
    tangle(1, held=(2,)),
    star(7),
    with_muscles(star(6), np.random.default_rng(1)),
    with_muscles(sim.rope(), np.random.default_rng(2)),
    replace(with_muscles(star(6), np.random.default_rng(1)), beat=msgspec.UNSET),
    replace(star(4), name='"quoted" \\ ü 中 \x00', description="two\nlines\tand a tab"),
]


@pytest.mark.parametrize("scene", SCENES, ids=[f"{i}-{scene.name[:12]!a}" for i, scene in enumerate(SCENES)])
def test_round_trips_are_exact(scene: Scene, tmp_path: Path) -> None:
    data = encode_scene(scene)
    again = decode_scene(data, "scene")
    assert again == scene
    assert encode_scene(again) == data
    save_scene(scene, tmp_path / "scene.json")
    assert load_scene(tmp_path / "scene.json") == scene


def test_a_scene_without_muscles_has_nothing_of_them_in_its_file() -> None:
    assert "beat" not in json.loads(encode_scene(star(4)))
    assert b"muscle" not in encode_scene(star(4))


def test_brackets_in_a_text_are_left_alone() -> None:
    text = "drag [ 1,  2 ] and [ 3 ], not [\t4 ]"
    assert decode_scene(encode_scene(sim.rope(description=text)), "scene").description == text


def test_a_recipe_stays_a_recipe_in_its_file() -> None:
    raw = json.loads(encode_scene(sim.rope(masses=500)))
    assert [(body["recipe"], body["masses"]) for body in raw["bodies"]] == [("rope", 500)]
    assert not {"masses", "linear_springs", "angular_springs", "anchors"} & set(raw)
    assert raw["format"] == 4


def test_files_are_readable_json_with_vectors_on_one_line() -> None:
    lines = encode_scene(star(3)).decode().splitlines()
    assert '      "position": [0.0, 0.0],' in lines
    assert lines[0] == "{"


def test_invalid_scenes_are_not_written(tmp_path: Path) -> None:
    path = tmp_path / "scene.json"
    with pytest.raises(SceneError, match="air_friction"):
        save_scene(replace(star(3), air_friction=-1.0), path)
    assert list(tmp_path.iterdir()) == []


def test_a_name_that_no_file_can_hold_is_refused(tmp_path: Path) -> None:
    # Half of a surrogate pair: Python has such texts, UTF-8 does not.
    with pytest.raises(SceneError):
        save_scene(replace(star(3), name="\ud800"), tmp_path / "scene.json")


# ------------------------------------------------------------------------- what is no scene
def minimal(**changes: Any) -> dict[str, Any]:
    return {"name": "one", "masses": [{"position": [1, 2.5]}], **changes}


def test_a_file_may_leave_out_what_has_a_default() -> None:
    scene = decode_scene(json.dumps(minimal()).encode(), "scene")
    assert scene == Scene(name="one", masses=(sim.Mass(position=(1.0, 2.5)),))


def mass(**fields: Any) -> dict[str, Any]:
    """A file with one mass."""
    return minimal(masses=[{"position": [0, 1], **fields}])


@pytest.mark.parametrize(
    ("data", "begins"),
    [
        (b"", "the file is empty"),
        (b" \n\t", "the file is empty"),
        (b"\xff\xfe", "the file is empty"),
        (b"{", "this is not a JSON file"),
        (b'{"name": "a"} {}', "this is not a JSON file"),
        (b"[" * 200_000, "this is not a JSON file"),
        (b'{"name": "\\ud800"}', "this is not a JSON file"),
        (b'{"name": "a", "masses": [', "this is not a JSON file (it ends in the middle)"),
        (b"[]", "a scene is a JSON object"),
        (b"null", "a scene is a JSON object"),
        (b"3", "a scene is a JSON object"),
        (b'{"name": "a", "gravity": [0, NaN], "rope": {}}', "NaN is no number that JSON has"),
        (b'{"name": "a", "gravity": [0, Infinity], "rope": {}}', "Infinity is no number that JSON has"),
        (b'{"name": "a", "masses": [-Infinity]}', "-Infinity is no number that JSON has (line 1, column 26)"),
        (b'{"name": "NaN",\n "gravity": [0, NaN]}', "NaN is no number that JSON has (line 2, column 17)"),
        (b'{"name": "a",\n "rope": {"mass": 1e999}}', "1e999 is too large for a number (line 2, column 19)"),
        (b'{"name": "1e999",\n "gravity": [0, -1e400], "rope": {}}',
         "-1e400 is too large for a number (line 2, column 17)"),
        (b'{"name": "a",\n "rope": {},\n "name": "b"}',
         "the key 'name' stands twice in one object (line 3, column 2)"),
        (b'{"name": "a",\n "rope": {"mass": 1, "m\\u0061ss": 2}}', "the key 'mass' stands twice"),
        (b'{"format": 3, "name": "a", "masses": [], "gravity": 9.81}',
         "gravity: 2 numbers are expected, as in [0, 0], not 9.81 (line 1, column 53)"),
        (mass(force=[1, 2e15]),
         "masses[0].force[1]: 2e+15 is not in the range -1e+15..1e+15 kg px/s² (line 1, "),
        (mass(force=[1, "x"]), "masses[0].force[1]: a number is expected, not 'x'"),
        (mass(force=[1]), "masses[0].force: "),
        (mass(force=None), "masses[0].force: "),
        (mass(force=5), "masses[0].force: "),
        ({"name": "a", "rope": {}, "two\nlines": 1}, "there is no field"),
        (minimal(format=5), "format: version 5 is newer than 4"),
        (minimal(format=10**30), "format: version"),
        (minimal(format=5, unheard_of={"of": "later"}), "format: version 5 is newer"),
        (minimal(format=0), "format: 0 is not in the range 1"),
        (minimal(format=True), "format: "),
        (minimal(format="1"), "format: "),
        (minimal(colour="red"), "there is no field `colour`"),
        (minimal(masses=[{"position": [0, 0], "wieght": 1}]), "masses[0]: there is no field `wieght`"),
        ({"masses": [{"position": [0, 0]}]}, "the field `name` is missing"),
        (minimal(masses=[{}]), "masses[0]: the field `position` is missing"),
        (mass(position=[0, 2e6]), "masses[0].position[1]: 2e+06 is not in the range -1e+06"),
        (mass(position=[0, "2"]), "masses[0].position[1]: "),
        (mass(position=[0, 1, 2]), "masses[0].position: "),
        (mass(mass=0), "masses[0].mass: 0 is not in the range 1e-06"),
        *((mass(mass=wrong), "masses[0].mass: ") for wrong in (True, None, 10**400)),
        (minimal(anchors=[{"mass": 1}]), "anchors[0].mass: mass 1 does not exist (0..0)"),
        (minimal(anchors=[{"mass": -1}]), "anchors[0].mass: -1 is not in the range 0..99999"),
        (minimal(rope={"masses": 3}), "rope: a scene has either recipes or masses"),
        ({"name": "a", "rope": {"masses": 1}}, "rope.masses: 1 is not in the range 2..20000"),
        ({"name": "a", "rope": {"direction": [0, 0]}}, "rope.direction: "),
        (minimal(name="x" * 61), "name: "),
        (minimal(integrator={"dt": 2}), "integrator.dt: 2 is not in the range 1e-06..1 s"),
        (minimal(template=30), "template: 30 is not one of 180, 135, 90, 45, 0, -45, -90, -135"),
        (minimal(force_law=None), "force_law: null is not one of tutorial, conservative, angle"),
        (minimal(view={"unit": "centimetre"}), "view.unit: 10 characters are more than 8"),
        (minimal(name=""), "name: it must not be empty"),
        (minimal(name=[]), "name: a text is expected, not an array"),
        (minimal(air_friction=True), "air_friction: a number is expected, not true"),
        (minimal(anchors=[{"mass": {}}]), "anchors[0].mass: a whole number is expected, not an object"),
        (minimal(air_friction=10**400), "air_friction: a whole number as large as this is not allowed"),
        (minimal(masses=None), "masses: an array is expected, not null"),
        ({"name": "a", "bodies": [{"recipe": "rod", "length": 0}]},
         "bodies[0].length: 0 is not in the range 0.001..1e+06 px"),
        ({"name": "a", "bodies": [{"recipe": "rod", "sides": 3}]}, "bodies[0]: there is no field `sides`"),
        ({"name": "a", "bodies": [{"recipe": "girder", "truss": "howe"}]},
         "bodies[0].truss: 'howe' is not one of warren, pratt"),
        ({"name": "a", "bodies": [{"recipe": "girder", "strength": -2}]},
         "bodies[0].strength: -2 is not in the range 0..1e+15 kg px/s²"),
        ({"name": "a", "bodies": [{"recipe": "rope"}, {}]}, "bodies[1]: the field `recipe` is missing"),
        ({"name": "a", "bodies": [7]}, "bodies[0]: an object is expected, not a whole number"),
        ({"name": "a", "bodies": [{"recipe": "raft"}]},
         "bodies[0].recipe: 'raft' is not one of rope, rod, box, polygon, hair_tuft, flag_pole, tree, "
         "air_balloon, water_balloon, cloth, girder, jelly, bridge, worm, swimmer, walker, heart, hand"),
        (minimal(fillings=[{"kind": "foam", "masses": [0]}]),
         "fillings[0].kind: 'foam' is not one of gas, liquid"),
        (minimal(fillings=[{"kind": "gas", "masses": [0], "pressure": -1}]),
         "fillings[0].pressure: -1 is not in the range 0..1e+09 kg/s²"),
        (minimal(fillings=[{"kind": "liquid", "masses": [0], "pressure": 1}]),
         "fillings[0]: there is no field `pressure`"),
        (mass(**{"x - at `$.masses[0].position": 1}),
         "masses[0]: there is no field `x - at `$.masses[0].position`"),
    ],
)  # fmt: skip
def test_what_is_wrong_in_a_file_is_said_with_what_is_expected(
    data: bytes | dict[str, Any], begins: str
) -> None:
    assert refused(data).startswith(begins)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ('{"name": "é",\n "masses": [\n  {"position": [0, 1]},\n  {"position": [0, "1"]}]}', (4, 20)),
        ('{"name": "é", "masses": [{"position": [0, "1"]}]}', (1, 43)),
        ('\n{"masses": [{"mass": "x", "position": [0, 1]}], "name": "a"}', (2, 22)),
        ('{"name": "a",\n"masses": [{}]}', (2, 12)),
        ('{"name": "a",\n"masses": [],,}', (2, 14)),
    ],
)
def test_what_is_wrong_in_a_file_has_a_place(text: str, place: tuple[int, int]) -> None:
    assert "line {}, column {}".format(*place) in refused(text.encode())


@pytest.mark.parametrize(
    ("mark", "encoding"),
    [
        (b"\xef\xbb\xbf", "utf-8"),
        (b"\xff\xfe", "utf-16-le"),
        (b"\xfe\xff", "utf-16-be"),
        (b"\xff\xfe\0\0", "utf-32-le"),
    ],
)
def test_files_of_other_programs_with_a_byte_order_mark(mark: bytes, encoding: str, tmp_path: Path) -> None:
    text = json.dumps(minimal(name="Маятник 中"), ensure_ascii=False).replace(",", ",\r\n")
    path = tmp_path / "scene.json"
    path.write_bytes(mark + text.encode(encoding))
    assert load_scene(path).name == "Маятник 中"
    wrong = text.replace("[1", '["x"')
    assert "masses[0].position[0]: " in refused(mark + wrong.encode(encoding))
    assert "(line 2, column 27)" in refused(mark + wrong.encode(encoding))


def test_other_encodings_are_refused_with_what_to_do() -> None:
    text = '{"name": "one",\n"title": "Mädchen", "rope": {}}'
    said = "line 2: the text is not in UTF-8; save the file with the encoding UTF-8"
    assert refused(text.encode("latin-1")) == said
    assert refused(b"\xff\xfe" + '{"name": "one"}'.encode("utf-16-le")[:-1]).startswith("line 1: ")


def test_keys_of_different_objects_and_texts_that_look_like_keys_may_repeat() -> None:
    masses = [{"position": [0, 0]}, {"position": [1, 0]}]
    raw = {"name": 'x": 1, "', "description": '"name": {', "masses": masses}
    assert len(decode_scene(json.dumps(raw).encode(), "file").masses) == 2


def test_files_that_are_too_large_are_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "large.json"
    path.write_bytes(b" " * (MAX_FILE_BYTES + 1))
    with pytest.raises(SceneError, match="larger than"):
        load_scene(path)
    assert "are more than" in refused(b" " * (MAX_FILE_BYTES + 1))
    with pytest.raises(SceneError, match="more than"):
        save_scene(replace(sim.rope(masses=20_000, joints=False), bodies=()), tmp_path / "out.json")
    assert not (tmp_path / "out.json").exists()


# ------------------------------------------------------------------------- loading by name or path
def test_what_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"there is no scene called 'nowhere'; there are .*tutorial-3\.3"):
        load_scene("nowhere")
    for path in (tmp_path / "nowhere.json", tmp_path):
        with pytest.raises(SceneError, match="cannot be read"):
            load_scene(path)
    with pytest.raises(SceneError, match="cannot be written"):
        save_scene(sim.rope(), tmp_path / "no" / "folder.json")


@pytest.mark.parametrize("name", ["", "x" * 300, "x\0", "x\0.json", "x" * 300 + ".json"])
def test_names_that_no_file_can_have(name: str) -> None:
    with pytest.raises(SceneError):
        load_scene(name)


# ------------------------------------------------------------------------- writing
def fail(*_: object, **__: object) -> None:
    raise OSError(28, "No space left on device")


@pytest.mark.parametrize("broken", ["fsync", "replace", "fdopen"])
def test_a_failed_write_leaves_the_old_file_and_nothing_else(
    broken: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "scene.json"
    save_scene(star(3), path)
    before = path.read_bytes()
    with monkeypatch.context() as patch:
        if broken == "replace":
            patch.setattr(Path, "replace", fail)
            patch.setattr(os, "replace", fail)
        else:
            patch.setattr(os, broken, fail)
        with pytest.raises(SceneError, match=r"scene\.json: the file cannot be written \(No space left"):
            save_scene(star(4), path)
    assert path.read_bytes() == before
    assert [entry.name for entry in tmp_path.iterdir()] == ["scene.json"]
    save_scene(star(4), path)
    assert load_scene(path) == star(4)


def test_a_folder_that_cannot_be_synced_does_not_make_a_liar_of_the_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Some file systems refuse to sync a folder, and by then the new file is in place.
    path = tmp_path / "scene.json"
    save_scene(star(3), path)
    sync = os.fsync

    def files_only(handle: int) -> None:
        if stat.S_ISDIR(os.fstat(handle).st_mode):
            raise OSError(22, "Invalid argument")
        sync(handle)

    monkeypatch.setattr(os, "fsync", files_only)
    expected = star(4)
    try:
        save_scene(star(4), path)
    except SceneError:
        expected = star(3)
    assert load_scene(path) == expected


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_a_saved_file_is_as_readable_as_any_new_file(tmp_path: Path) -> None:
    save_scene(star(3), tmp_path / "scene.json")
    (tmp_path / "other").write_bytes(b"")
    assert (tmp_path / "scene.json").stat().st_mode == (tmp_path / "other").stat().st_mode


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_threads_that_write_at_once_leave_the_mask_of_the_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def slow(mask: int, umask: Callable[[int], int] = os.umask) -> int:
        time.sleep(0.002)
        return umask(mask)

    monkeypatch.setattr(os, "umask", slow)
    before = os.umask(0o027)
    try:
        with ThreadPoolExecutor(8) as threads:
            list(threads.map(lambda n: write_atomically(tmp_path / str(n), b""), range(32)))
        assert os.umask(0o027) == 0o027
        assert {path.stat().st_mode & 0o777 for path in tmp_path.iterdir()} == {0o640}
    finally:
        os.umask(before)


# ------------------------------------------------------------------------- the user's own scenes
@pytest.mark.parametrize(
    ("name", "safe"),
    [
        ("my rope", "my rope"),
        ("  spaces  ", "spaces"),
        ("Größe 2", "Größe 2"),
        ("绳子", "绳子"),
        ("../../etc/passwd", "etc-passwd"),
        ("/etc/x", "etc-x"),
        ("C:\\x\\y", "C-x-y"),
        ("a\0b\nc", "a-b-c"),
        (".hidden", "hidden"),
        ("dots...", "dots"),
        ("ﬁsh", "fish"),
        ("v1.5", "v1.5"),
        ('what? <no> *|"', "what- -no"),
        ("Newton's cradle (5 balls)", "Newton's cradle (5 balls)"),
        ("x" * 100, "x" * 60),
        ("console", "console"),
    ],
)
def test_names_are_made_safe(name: str, safe: str) -> None:
    assert safe_name(name) == safe
    assert safe_name(safe) == safe


@pytest.mark.parametrize(
    "name",
    [
        "", " ", "...", "..", "/", "-_-", "\0", "CON", "con", "Nul", "aux.txt", "COM1", "lpt9.x", "com¹",
        "tutorial-3.3", "Tutorial-3.3", "TUTORIAL-3.3", "RING", " box ", "ｒｉｎｇ", "x" + "\U00020000" * 59,
    ],
)  # fmt: skip
def test_names_that_cannot_be_used(name: str, home: Path) -> None:
    for act in (safe_name, lambda name: save_user_scene(star(3), name), trash_user_scene):
        refusal(SceneError, act, name)
    assert not home.exists() or list(home.iterdir()) == []


def test_an_empty_name_is_asked_for(home: Path) -> None:
    assert refusal(SceneError, safe_name, " ") == "a scene needs a name; use letters, digits and spaces"


def test_saving_listing_loading_and_deleting(home: Path) -> None:
    assert all(info.built_in for info in list_scenes())
    assert save_user_scene(replace(star(5), description="mine"), "../My: star") == "My- star"
    assert [path.name for path in home.iterdir()] == ["My- star.json"]
    info = list_scenes()[-1]
    assert (info.name, info.description, info.built_in, info.path.parent) == ("My- star", "mine", False, home)
    assert load_scene("My- star") == replace(star(5), name="My- star", description="mine")
    save_user_scene(star(6), "My- star")
    assert len(load_scene("My- star").masses) == 7
    trash_user_scene("My- star")
    assert list(home.glob("*.json")) == []
    with pytest.raises(SceneError, match="there is no scene"):
        load_scene("My- star")
    with pytest.raises(SceneError, match="cannot be deleted"):
        trash_user_scene("My- star")


@pytest.mark.parametrize("name", ["v1.5", "my.json", "a b-c_d", "Größe", "x.JSON"])
def test_what_is_saved_under_a_name_is_found_under_it(name: str, home: Path) -> None:
    saved = save_user_scene(star(3), name)
    assert saved in [info.name for info in list_scenes()]
    assert load_scene(saved).name == saved


def test_a_broken_file_of_the_user_is_left_out_of_the_list(home: Path) -> None:
    save_user_scene(star(3), "good")
    (home / "bad.json").write_bytes(b"{")
    # Nor can a file that bears a preset's name pose as it.
    (home / "Ring.json").write_bytes((home / "good.json").read_bytes())
    assert [info.name for info in list_scenes() if not info.built_in] == ["good"]
    assert load_scene("ring").description == load_scene(built_in_folder() / "ring.json").description
