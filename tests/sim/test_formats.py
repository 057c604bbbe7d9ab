"""Files of older format versions: what they left unsaid, and that they are saved as files of this one."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import sim
from sim import Scene, SceneError, load_scene, save_scene
from sim.store.files import decode_scene


def decoded(**fields: Any) -> Scene:
    """The scene in a file that has these fields and a mass."""
    raw = {"name": "one", "masses": [{"position": [1, 2.5]}], **fields}
    return decode_scene(json.dumps(raw).encode(), "file")


def test_format_1_knew_the_tutorials_law_and_method_only() -> None:
    fields: dict[str, Any]
    for fields in ({}, {"integrator": {"dt": 0.004}}, {"integrator": {}}):
        dt = fields.get("integrator", {}).get("dt", 0.0025)
        scene = decoded(format=1, **fields)
        assert (scene.format, scene.force_law, scene.air_law) == (4, "tutorial", "tutorial")
        assert scene.integrator == sim.Integrator(method="symplectic_euler", dt=dt)
        # The same without its version is a file of this one.
        scene = decoded(**fields)
        assert (scene.format, scene.force_law, scene.air_law) == (4, "conservative", "isotropic")
        assert scene.integrator == sim.Integrator(dt=dt)


def test_format_1_keeps_what_it_says() -> None:
    scene = decoded(format=1, force_law="angle", integrator={"method": "rk4", "tolerance": 0.5})
    assert scene.force_law == "angle"
    assert scene.integrator == sim.Integrator(method="rk4", tolerance=0.5)
    assert scene.masses == (sim.Mass(position=(1.0, 2.5)),)


def test_format_1_is_saved_as_format_4(tmp_path: Path) -> None:
    path = tmp_path / "old.json"
    path.write_text(json.dumps({"format": 1, "name": "old", "rope": {"masses": 5}}))
    scene = load_scene(path)
    save_scene(scene, path)
    raw = json.loads(path.read_bytes())
    assert (raw["format"], raw["force_law"], raw["air_law"]) == (4, "tutorial", "tutorial")
    assert raw["integrator"]["method"] == "symplectic_euler"
    assert load_scene(path) == scene
    assert len(scene.angular_springs) == 3


@pytest.mark.parametrize(
    ("fields", "sentence"),
    [
        ({"integrator": None}, "integrator: "),
        ({"integrator": []}, "integrator: "),
        ({"integrator": {"method": "leapfrog"}}, r"integrator\.method: "),
        ({"integrator": {"dt": 0}}, r"integrator\.dt: 0 is not in the range"),
        ({"force_law": "none"}, "force_law: "),
        ({"colour": "red"}, "there is no field"),
    ],
)
def test_format_1_is_held_to_the_same_rules(fields: dict[str, Any], sentence: str) -> None:
    for version in (1, 2):
        with pytest.raises(SceneError, match=f"^file: {sentence}"):
            decoded(format=version, **fields)


def test_format_2_had_one_recipe_that_of_a_rope() -> None:
    raw = {"name": "old", "rope": {"masses": 5, "length": 40}}
    for fields in ({"format": 2}, {}):  # a file that does not say its format may be an old one, too
        scene = decode_scene(json.dumps({**raw, **fields}).encode(), "file")
        assert scene == Scene(name="old", bodies=(sim.Rope(masses=5, length=40.0),), air_law="tutorial")
    assert decoded(format=2, bodies=()) == decoded(format=3)
    for version in (3, 4):
        with pytest.raises(SceneError, match="there is no field `rope`"):
            decode_scene(json.dumps({**raw, "format": version}).encode(), "file")


@pytest.mark.parametrize(
    ("rope", "sentence"),
    [
        ({"masses": 1}, r"^file: rope\.masses: 1 is not in the range 2\.\.20000 \(line 1, column \d+\)$"),
        ({"direction": [0, 0]}, r"^file: rope\.direction: a direction of \(0, 0\) points nowhere"),
        ([], r"^file: rope: an object is expected, not an array"),
    ],
)
def test_errors_in_old_files_name_the_field_that_they_have(rope: Any, sentence: str) -> None:
    with pytest.raises(SceneError, match=sentence):
        decode_scene(json.dumps({"format": 2, "name": "old", "rope": rope}).encode(), "file")
