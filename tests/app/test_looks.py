"""Colours stand out from what they are on, light and dark: WCAG 2.2, 1.4.3 of letters, 1.4.11 of marks."""

from __future__ import annotations

import re

import pytest

import sim
from app.export.live.live import live_html
from app.export.replay import replay_html
from app.export.teacher_sheet import sheet_html
from app.stage import looks
from app.stage.looks import LAYERS, style_rules
from tests.app.test_html_files import Clip, swing
from tests.app.test_styles import all_rules

LETTERS = 4.5
DRAWN = 3.0
LOOKS = ("light", "dark")

SURFACES = ("paper", "panel", "float", "key")
"""What letters stand on."""

ON = {
    "text": (*SURFACES, "key-over", "line"),
    "strong": (*SURFACES, "key-over", "line", "brand-soft", "good-soft"),
    "quiet": (*SURFACES, "key-over"),
    "brand-word": (*SURFACES, "key-over", "brand-soft"),
    "brand": SURFACES,
    "good": (*SURFACES, "good-soft"),
    "warn": (*SURFACES, "warn-soft"),
    "bad": SURFACES,
    "call": (*SURFACES, "call-soft"),
    "on-brand": ("brand", "brand-over", "good", "warn", "bad"),
}
"""Letters and what they stand on."""

MARKS = {
    "edge": (*SURFACES, "key-over", "brand-soft"),
    "brand": (*SURFACES, "key-over", "brand-soft"),
    "good-bar": (*SURFACES, "key-over", "good-soft"),
    "call-edge": (*SURFACES, "call-soft"),
    "bad": SURFACES,
    "held": ("paper", "panel"),
    "rest": ("paper", "panel", "float"),
    "pulled": ("paper", "panel", "float"),
    "pushed": ("paper", "panel"),
    "torque-minus": ("paper", "panel"),
    "muscle": ("paper", "panel", "float"),
    "force": ("paper",),
    "velocity": ("paper",),
    "torque": ("paper",),
    "second": ("paper", "float"),
    "liquid": ("paper",),
}
"""What bounds a control or is drawn, and what it is on."""


def contrast(one: str, other: str) -> float:
    """The contrast of two colours as in `looks.COLORS`, from 1 to 21."""
    dim, bright = sorted((_luminance(one), _luminance(other)))
    return (bright + 0.05) / (dim + 0.05)


def _luminance(color: str) -> float:
    parts = (int(color[i : i + 2], 16) / 255.0 for i in (0, 2, 4))
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_contrast_is_that_of_wcag() -> None:
    assert contrast("000000", "ffffff") == pytest.approx(21.0)
    assert contrast("777777", "ffffff") == pytest.approx(4.48, abs=0.005)
    assert contrast("ffffff", "777777") == contrast("777777", "ffffff")


@pytest.mark.parametrize("look", LOOKS)
@pytest.mark.parametrize(("pairs", "least"), [(ON, LETTERS), (MARKS, DRAWN)], ids=["letters", "drawn"])
def test_colors_stand_out(pairs: dict[str, tuple[str, ...]], least: float, look: str) -> None:
    k = LOOKS.index(look)
    found = {
        f"{front} on {back}": contrast(looks.COLORS[front][k], looks.COLORS[back][k])
        for front, backs in pairs.items()
        for back in backs
    }
    assert not {name: round(value, 2) for name, value in found.items() if value < least}


@pytest.mark.parametrize("look", LOOKS)
def test_where_more_contrast_is_wished_letters_and_edges_stand_out_more(look: str) -> None:
    k = LOOKS.index(look)
    colors = {name: looks.MORE.get(name, pair)[k] for name, pair in looks.COLORS.items()}
    asked = [(ON, 7.0), ({name: MARKS[name] for name in ("edge", "brand", "good-bar", "call-edge")}, 4.5)]
    found = {
        f"{front} on {back}": contrast(colors[front], colors[back])
        for pairs, least in asked
        for front, backs in pairs.items()
        for back in backs
        if contrast(colors[front], colors[back]) < least
    }
    assert not found


def test_where_the_system_forces_colours_every_colour_of_a_control_is_the_system_s() -> None:
    drawn = {*MARKS, "mass", "ink", "torque-plus", "liquid"} - {
        "edge",
        "brand",
        "good-bar",
        "call-edge",
        "bad",
    }
    assert looks.COLORS.keys() - looks.FORCED.keys() == drawn


@pytest.mark.parametrize("look", LOOKS)
def test_a_mass_stands_out_by_its_outline_or_its_fill(look: str) -> None:
    """On white its outline is dark, on dark paper its fill is bright."""
    k = LOOKS.index(look)
    paper = looks.COLORS["paper"][k]
    assert max(contrast(looks.COLORS[name][k], paper) for name in ("ink", "mass")) > 10.0


def _token(declared: str, kind: str) -> str | None:
    """The token that a rule gives to `color` or to `background`."""
    found = re.search(rf"(?<![\w-]){kind}(?:-color)?\s*:\s*var\(--softrod-([\w-]+)", declared)
    return found and found[1]


def test_every_color_of_letters_in_a_style_is_judged() -> None:
    """None has letters of a colour, or on a ground, that the test above leaves out."""
    used = [
        (name, selector, _token(text, "color"), _token(text, "background"))
        for name, selector, text in all_rules()
    ]
    assert sum(front is not None and back is not None for *_, front, back in used) > 20
    for name, selector, front, back in used:
        if front in looks.COLORS:
            if re.search(r"::(before|after)$", selector) and front in MARKS:
                continue  # a sign, not words
            assert front in ON, (name, selector, front)
            assert back is None or back not in looks.COLORS or back in ON[front], (
                name,
                selector,
                front,
                back,
            )


def test_in_the_dark_what_floats_has_a_line() -> None:
    """Shadows vanish there."""
    assert looks.SHADOWS.keys() == {"bar", "menu", "dialog"}
    for light, dark in looks.SHADOWS.values():
        assert "0 0 0 1px" not in light
        assert dark.endswith("0 0 0 1px var(--softrod-line)")


def test_lines_of_letters_share_one_rhythm() -> None:
    assert all(line % 4 == 0 and line > size >= 12 for size, line in looks.TYPE)
    assert list(looks.TYPE) == sorted(looks.TYPE)


def test_under_a_finger_what_is_pressed_is_higher_and_with_less_motion_nothing_takes_time() -> None:
    rules = looks.style_rules("[data-dark]*")
    (touched,) = re.findall(r"@media \(pointer: coarse\)\{(.*)\}", rules)
    heights = {name: int(size) for name, size in re.findall(r"--softrod-height-(\w+):(\d+)px", touched)}
    assert heights and all(size == 48 > looks.HEIGHTS[name] for name, size in heights.items())
    (still,) = re.findall(r"@media \(prefers-reduced-motion: reduce\)\{(.*)\}", rules)
    assert dict(re.findall(r"--softrod-(\w+):(\w+)", still)) == dict.fromkeys(looks.TIMES, "0s")


ALIKE = {
    "live": {"second": "a part of a time, in Fluent's script"},
    "replay": {"second": "a part of a time, in Fluent's script", "held": "a section of a moment"},
    "sheet": {},
}
"""Variables that a file has without using them, and what its scripts have by that name."""


@pytest.mark.parametrize("kind", list(ALIKE))
def test_a_file_has_the_variables_that_it_uses_and_no_others(kind: str) -> None:
    scene = sim.load_scene("lesson-hooke")
    moment = sim.Simulation(scene).capture()
    page = {
        "live": lambda: live_html(moment)[0],
        "replay": lambda: replay_html(Clip(swing(sim.load_scene("rope")))),
        "sheet": lambda: sheet_html(scene),
    }[kind]().decode()
    given = set(re.findall(r"--softrod-([a-z0-9-]+):", page))
    known = set(re.findall(r"--softrod-([a-z0-9-]+):", style_rules("*")))
    used = set(re.findall(r"var\(--softrod-([a-z0-9-]+)", page)) & known
    if kind != "sheet":
        used |= {layer.color for layer in LAYERS.values()} | set(re.findall(r'\bcolor\("([a-z-]+)"\)', page))
    assert given & known == used | ALIKE[kind].keys()
