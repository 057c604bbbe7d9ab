"""What the README and the pages in docs/ say: links lead somewhere, and examples do what they promise."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any, get_args

import pytest

from sim.scene.recipes.recipe import AnyRecipe
from sim.store.files import read_scene
from tests.app.command import Softrod

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.glob("**/*.md"))]


def blocks(page: Path, language: str) -> list[str]:
    """The fenced blocks of a page in one language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)


def anchors(page: Path) -> set[str]:
    """The names that a link can use for the headings of a page, made as GitHub makes them."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    headings = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_relative_links_lead_somewhere(page: Path) -> None:
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
        if re.match(r"[a-z]+:", target):
            continue  # another site
        path, _, anchor = target.partition("#")
        file = page.parent / path if path else page
        assert file.exists(), f"{page.name} links to {target}"
        if anchor:
            assert anchor in anchors(file), f"{page.name} links to {target}"


def test_the_reference_pages_are_linked_from_the_readme() -> None:
    readme = (ROOT / "README.md").read_text()
    pages = sorted(DOCS.glob("*.md"))
    assert pages
    for page in pages:
        assert f"](docs/{page.name})" in readme, page.name


def test_a_number_of_lessons_is_right() -> None:
    texts = "".join(page.read_text() for page in PAGES)
    told = re.findall(r"(\w+) lessons (?:with|come)", texts)
    lessons = sorted((ROOT / "presets" / "lessons").glob("*.json"))
    assert set(told) == {str(len(lessons))}


def test_the_page_on_access_has_every_criterion_and_tests_that_are_there() -> None:
    text = (DOCS / "access.md").read_text()
    lines = [line for line in text.splitlines() if re.match(r"\| \d\.\d\.\d+ ", line)]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    assert len(rows) == len({row[0].split()[0] for row in rows}) == 56
    for criterion, met, how, shown in rows:
        assert met in ("supported", "partly", "not supported", "does not apply"), criterion
        assert how or shown, criterion
        for name in re.findall(r"[\w/.]+\.(?:py|mjs)", shown):
            file = ROOT / name if "/" in name else ROOT / "tests" / "browser" / name
            assert file.exists(), f"{criterion}: {name}"


def test_what_the_map_names_is_there() -> None:
    paths = re.findall(r"`((?:app|sim|studies|schema)(?:/[\w.-]+)*)`", (DOCS / "map.md").read_text())
    assert len(paths) > 60
    for path in paths:
        assert (ROOT / path).exists(), path


def test_the_examples_of_editing_run() -> None:
    (example,) = blocks(DOCS / "editing.md", "python")
    names: dict[str, Any] = {}
    exec(example, names)
    assert len(names["braced"].linear_springs) > len(names["scene"].linear_springs)
    assert len(names["longer"].masses) == len(names["scene"].masses) + 1


def test_the_python_example_of_the_readme_runs(capsys: pytest.CaptureFixture[str]) -> None:
    (example,) = blocks(ROOT / "README.md", "python")
    names: dict[str, object] = {}
    exec(example, names)
    time, *_ = capsys.readouterr().out.split()
    assert float(time) == pytest.approx(2.0)


def test_the_scenes_of_the_reference_are_valid(tmp_path: Path) -> None:
    examples = blocks(DOCS / "scene-files.md", "json")
    assert len(examples) == 8
    for example in examples:
        file = tmp_path / "example.json"
        file.write_text(example)
        read_scene(file)


def test_the_input_log_of_the_reference_is_accepted(tmp_path: Path, softrod: Softrod) -> None:
    (example,) = blocks(DOCS / "command-line.md", "jsonl")
    log, out = tmp_path / "log.jsonl", tmp_path / "out.csv"
    log.write_text(example)
    assert softrod("run", "tutorial-3.3", "--steps", 300, "--inputs", log, "--out", out).returncode == 0
    assert len(out.read_text().splitlines()) == 301


@pytest.mark.parametrize("kind", get_args(AnyRecipe), ids=lambda kind: kind.__name__)
def test_the_reference_has_every_number_of_every_recipe(kind: type[AnyRecipe]) -> None:
    tag = kind.__struct_config__.tag
    own, common = re.findall(rf"^\| `{tag}` \| (.*) \|$", (DOCS / "scene-files.md").read_text(), re.MULTILINE)
    recipe = kind()
    shown = re.split(r" *\| *", common)
    columns = ("stiffness", "damping", "angular_stiffness", "mass", "radius")
    for field, text in zip(columns, shown, strict=True):
        assert float(text or "nan") == pytest.approx(getattr(recipe, field, math.nan), nan_ok=True)
    elsewhere = {*columns, "angular_damping", "bend", "driven"}
    for field in set(kind.__struct_fields__) - elsewhere:
        assert f"`{field}`" in own, field
    for field, default in re.findall(r"`(\w+)` (-?[\d.]+)", own):
        assert getattr(recipe, field) == float(default), field
