"""The sentences of `sim` know their templates, so that all languages can say them."""

from __future__ import annotations

import ast
import copy
import pickle
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

import sim
from sim.errors import InputError, SceneError, SettingError
from sim.motion.quantities import quantity
from sim.motion.stability import CAUSES
from sim.store.files import decode_scene
from sim.text import Text, listed
from tests.words import sim_templates, wrong_in_sim

ROOT = Path(__file__).parents[2]
REFUSALS = {"SceneError", "SettingError", "InputError", "DesignError", "TooLarge"}


def test_a_text_is_english_and_knows_its_template_and_what_stands_in_it() -> None:
    inner = Text("mass {mass} is held", mass=3)
    text = Text("{where}: {error}; {value:.2g} is the most", where="pulls[0]", error=inner, value=1234.5)
    assert text == "pulls[0]: mass 3 is held; 1.2e+03 is the most"
    assert text.parts["error"] is inner and inner.parts == {"mass": 3}
    assert text.with_parts(value=0.5) == "pulls[0]: mass 3 is held; 0.5 is the most"
    assert [listed(["a", "b", "c"][:n]) for n in (1, 2, 3)] == ["a", "a and b", "a, b and c"]


@pytest.mark.parametrize(
    "again", [lambda e: e, copy.copy, copy.deepcopy, lambda e: pickle.loads(pickle.dumps(e))]
)
def test_an_error_keeps_its_text_in_a_copy_and_in_another_process(
    again: Callable[[SceneError], SceneError],
) -> None:
    text = str(again(SceneError(Text("{where}: {error}", where="a", error=Text("{n} is too many", n=2)))))
    assert isinstance(text, Text) and text == "a: 2 is too many"
    assert (inner := text.parts["error"]) == "2 is too many" and isinstance(inner, Text)


def test_the_places_of_each_template_are_given_and_no_others() -> None:
    assert len(sim_templates()) > 400
    assert not list(wrong_in_sim())


def test_no_refusal_is_a_plain_string() -> None:
    for path in sorted((ROOT / "sim").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Call(ast.Name(name), [said, *_]) if name in REFUSALS:
                    is_plain = isinstance(said, (ast.JoinedStr, ast.Constant, ast.BinOp))
                    assert not is_plain, f"{path.name}:{node.lineno}: {ast.unparse(node)}"
                case _:
                    pass


def said(data: object) -> Text:
    with pytest.raises(SceneError) as caught:
        decode_scene(data if isinstance(data, bytes) else msgspec.json.encode(data), "a file")
    text = str(caught.value)
    assert isinstance(text, Text)
    return text


@pytest.mark.parametrize(
    ("data", "template"),
    [
        (b"", "the file is empty"),
        (b'{"format": 4,', "it ends in the middle"),
        (b'{"a" 3}', "JSON is malformed: expected ':'"),
        ({"masses": 3}, "{wanted} is expected, not {found}"),
        ({"name": "a", "mases": 3}, "there is no field {field}"),
        ({"name": "a", "gravity": [0, "x"]}, "{where}: {wanted} is expected, not {found}"),
        (
            {"name": "a", "integrator": {"dt": 9}},
            "{where}: {value} is not in the range {low}..{high} {unit}",
        ),
        (
            {"name": "a", "rope": {"masses": 3, "length": 2, "direction": [0, 0]}},
            "{where}: a direction of (0, 0) points nowhere",
        ),
    ],
)
def test_a_refused_file_is_refused_by_templates(data: object, template: str) -> None:
    found: list[str] = []
    inside: list[object] = [said(data)]
    while inside:
        if isinstance(text := inside.pop(), Text):
            found.append(text.template)
            inside += text.parts.values()
    assert template in found and template in sim_templates()


def test_what_limits_the_time_step_has_words() -> None:
    from sim.forces import words

    assert set(CAUSES) <= words.CAUSES.keys()


@pytest.mark.parametrize("name", ["mass9.x", "joint0.angle", "mass0.x + joint0.angle", "sqrt(sqrt(mass0.x))"])
def test_a_refused_quantity_is_refused_by_a_template(name: str) -> None:
    scene = sim.Scene(name="a", masses=(sim.Mass(position=(0.0, 0.0)),))
    with pytest.raises(InputError) as caught:
        quantity(name, scene)
    assert isinstance(str(caught.value), Text)


def test_a_refused_setting_is_refused_by_a_template() -> None:
    with pytest.raises(SettingError) as caught:
        sim.set_value(sim.load_scene("rope"), "gravity", 1e30)
    text = str(caught.value)
    assert isinstance(text, Text) and text.template in sim_templates()
