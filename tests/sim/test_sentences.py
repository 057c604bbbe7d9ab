"""What is said of a field of a wrong type, in a scene made in code and in a file."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

from sim import Gas, View, validate
from sim.store.files import decode_scene, encode_scene
from tests.sim.test_files import minimal
from tests.sim.test_files import refused as refused_file
from tests.sim.test_scene import BODY, changed, refused

WRONG: dict[str, Any] = {"masses": [0], "pressure": 1.0}


@pytest.mark.parametrize(
    ("route", "value", "sentence"),
    [
        ("masses", list(BODY.masses), "masses: a tuple is expected, not list"),
        ("masses.1.velocity", [1.0, 2.0], "masses[1].velocity: a tuple is expected, not list"),
        ("masses.0.position", (1.0,), "masses[0].position: 2 numbers are expected, as in a tuple"),
        ("gravity", None, "gravity: 2 numbers are expected, as in a tuple"),
        ("masses.0.position", np.ones(2), "masses[0].position: 2 numbers are expected, as in a tuple"),
        ("masses.0", BODY.anchors[0], "masses[0]: a Mass is expected, not Anchor"),
        ("masses.2", {"position": (1.0, 2.0)}, "masses[2]: a Mass is expected, not dict"),
        ("masses.2", None, "masses[2]: a Mass is expected, not None"),
        ("arrow_keys", View(), "arrow_keys: an ArrowKeys is expected, not View"),
        ("air_friction", np.int64(0), "air_friction: a number is expected, not int64"),
        ("air_friction", object(), "air_friction: a number is expected, not object"),
        ("name", object(), "name: a text is expected, not object"),
        ("name", b"ab", "name: a text is expected, not bytes"),
        ("name", "\ud800", "name: it has characters that cannot be written to a file"),
        ("description", "a\udfffb", "description: it has characters that cannot be written to a file"),
        ("view.unit", "\ud800", "view.unit: it has characters that cannot be written to a file"),
        ("template", 45.0, "template: 45.0 is not one of 180, 135, 90, 45, 0, -45, -90, -135"),
        ("force_law", "x" * 500, f"force_law: '{'x' * 60}…' is not one of tutorial, conservative, angle"),
        ("name", "", "name: it must not be empty"),
        ("view.unit", "centimetre", "view.unit: 10 characters are more than 8"),
        ("fillings", (BODY.masses[0],), "fillings[0]: one of Gas, Liquid is expected, not Mass"),
        ("fillings", (Gas(masses=(0,), pressure=math.nan),),
         "fillings[0].pressure: nan is not a finite number"),
        ("fillings", (Gas(**WRONG),), "fillings[0].masses: a tuple is expected, not list"),
    ],
)  # fmt: skip
def test_the_sentence_says_what_is_expected(route: str, value: Any, sentence: str) -> None:
    assert refused(changed(route, value)) == sentence


def test_a_whole_number_too_long_for_a_sentence_is_left_out_of_it() -> None:
    for route in ("linear_springs.0.a", "masses.0.mass", "name"):
        assert refused(changed(route, 10**5000)).endswith(": a whole number as large as this is not allowed")


def test_numbers_and_texts_of_numpy_are_good_and_can_be_saved() -> None:
    scene = validate(changed("masses.1.mass", np.float64(2.5), changed("name", np.str_("numpy"))))
    assert decode_scene(encode_scene(scene), "scene") == scene
    assert refused(changed("masses.1.mass", np.float64(0.0))).startswith(
        "masses[1].mass: 0 is not in the range"
    )
    assert (
        refused(changed("masses.1.mass", np.float64(math.nan)))
        == "masses[1].mass: nan is not a finite number"
    )


@pytest.mark.parametrize(
    ("raw", "sentence"),
    [
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
        (
            minimal(masses=[{"position": [0, 0], "x - at `$.masses[0].position": 1}]),
            "masses[0]: there is no field `x - at `$.masses[0].position`",
        ),
    ],
)  # fmt: skip
def test_files_with_a_wrong_field_say_what_is_expected(raw: dict[str, Any], sentence: str) -> None:
    assert re.sub(r" \(line \d+, column \d+\)$", "", refused_file(raw)) == sentence
