"""What the page's styles must not do."""

from __future__ import annotations

import gzip
import json
import re
from pathlib import Path

import app.pages
from app.pages.sandbox.assets import page_files

APP = Path(app.pages.__file__).parents[1]
PARTS = ("stage", "ui", "features", "pages")
SHEETS = sorted(path for part in PARTS for path in (APP / part).glob("**/*.css"))


def rules_of(text: str) -> list[tuple[str, str]]:
    """Every rule of a sheet: its selector, after the conditions around it, and what it declares."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    found, around, start = [], list[str](), 0
    for brace in re.finditer(r"[{}]", text):
        between = text[start : brace.start()].strip()
        start = brace.end()
        if brace[0] == "{":
            around.append(between)
        else:
            if between:
                found.append((" ".join(around), between))
            around.pop()
    return found


def rules() -> list[tuple[str, str]]:
    """Every rule of the page's styles."""
    return [rule for sheet in SHEETS for rule in rules_of(sheet.read_text(encoding="utf-8"))]


def test_rules_within_conditions_are_seen() -> None:
    text = "/* a { b } */ p { color: red } @media print { @supports (x: y) { a b { c: d } } e { f: g } }"
    assert rules_of(text) == [
        ("p", "color: red"),
        ("@media print @supports (x: y) a b", "c: d"),
        ("@media print e", "f: g"),
    ]


def test_only_one_folder_knows_what_viser_calls_its_widgets() -> None:
    paths = (
        path for kind in ("css", "js", "py") for part in PARTS for path in (APP / part).glob(f"**/*.{kind}")
    )
    for path in paths:
        if "viser" not in path.relative_to(APP).parts:
            found = re.search(
                r"mantine-[A-Z]\w+|tabler-icon|data-dock|__viser", path.read_text(encoding="utf-8")
            )
            assert found is None, f"{path}: {found and found[0]}"


def test_no_style_has_the_browser_search_the_whole_page() -> None:
    """With `:has` on what is always there, every change of a text restyled all of it, 5 ms each time."""
    assert SHEETS
    for selector, _ in rules():
        # Of what comes and goes, as notices, the first word alone is looked at.
        assert ":has(" not in selector or selector.startswith(".mantine-Notification-root"), selector


def test_for_a_projector_no_text_has_another_colour() -> None:
    """So it stands out there, too, where it does on light and on dark (`tests/browser/test_contrast.py`)."""
    found = [(selector, declared) for selector, declared in rules() if ".softrod-projector" in selector]
    assert len(found) > 10
    for selector, declared in found:
        kinds = set(re.findall(r"([\w-]+)\s*:", declared))
        assert not kinds & {"color", "background", "background-color", "filter"}, selector
        if "opacity" in kinds:
            assert re.search(r"softrod-(under|over)lay", selector), selector


def test_the_types_of_every_script_are_checked() -> None:
    """A folder that is moved out of the list would be checked by nobody, without a word."""
    root = APP.parent
    include = json.loads((root / "tests" / "page" / "tsconfig.json").read_text(encoding="utf-8"))["include"]
    checked = {path for one in include for path in root.glob(one.removeprefix("../../"))}
    assert {path for path in APP.rglob("*.js") if "templates" not in path.parts} == checked


def test_scripts_are_sent_without_comments_and_types_and_with_all_their_lines() -> None:
    sent = {path.partition("/softrod/")[2].partition("/")[2]: file for path, file in page_files().items()}
    for path in APP.rglob("*.js"):
        name = path.relative_to(APP).as_posix()
        if name not in sent:
            continue
        text, lean = path.read_text(encoding="utf-8"), gzip.decompress(sent[name].content).decode()
        assert text.count("\n") == lean.count("\n"), name
        for number, (line, left) in enumerate(zip(text.split("\n"), lean.split("\n"), strict=True)):
            code, *others = re.split(r"/\*\* @.*?\*/ ?", line)
            assert left in ("", "".join((code, *others))), (name, number)
            assert not left or not others or all(code.count(quote) % 2 == 0 for quote in "\"'`"), (
                name,
                number,
            )
            if not left and line:
                assert re.match(r"\s*(//|/\*\*|\*)", line), (name, number, line)
                # Nor was it in a text of several lines, which is between two of these.
                assert "\n".join(lean.split("\n")[:number]).count("`") % 2 == 0, (name, number)
