"""What the page's styles must not do."""

from __future__ import annotations

import gzip
import json
import re
from pathlib import Path

import pytest

import app.pages
from app.gate.gate import CLASS
from app.pages.sandbox.assets import page_files, translated
from app.stage.looks import style_rules
from app.words import languages

APP = Path(app.pages.__file__).parents[1]
PARTS = ("stage", "ui", "features", "pages")
SHEETS = sorted(path for part in PARTS for path in (APP / part).glob("**/*.css"))
PAGES = sorted((APP / "pages").glob("**/*.html"))
"""Pages with styles of their own."""
FACES = APP / "ui" / "fonts" / "fonts.css"
COLOR = re.compile(
    r"#[0-9a-f]{3,8}\b|\b(?:rgb|hsl|hwb|lab|lch|oklab|oklch)a?\(|(?<![\w#-])(?:black|white|gr[ae]y|red|green|blue)(?![\w-])",
    re.IGNORECASE,
)
"""A colour that is none of the tokens, in what a rule declares."""


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


def all_styles() -> dict[str, str]:
    """Every style of softrod by its file: the page's, and those of files, of sites and of small pages."""
    found = {path: path.read_text(encoding="utf-8") for path in sorted(APP.rglob("*.css")) if path != FACES}
    for path in PAGES:
        (style,) = re.findall(r"<style>(.*?)</style>", path.read_text(encoding="utf-8"), re.DOTALL)
        found[path] = style.replace("{looks}", "")
    return {path.relative_to(APP).as_posix(): text for path, text in found.items()}


def all_rules() -> list[tuple[str, str, str]]:
    """Every rule of them: its file, its selector and what it declares."""
    return [(name, *rule) for name, text in all_styles().items() for rule in rules_of(text)]


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
    assert len(all_styles()) > 20
    for name, selector, _ in all_rules():
        assert ":has(" not in selector, (name, selector)


@pytest.mark.parametrize(
    ("declared", "literal"),
    [
        ("color: #fff", True),
        ("border: 1px solid rgb(0 0 0 / 5%)", True),
        ("background: WHITE", True),
        ("background:black", True),
        ("color: color-mix(in srgb, var(--softrod-brand) 25%, transparent)", False),
        ("background: none; fill: currentColor; stroke: url(#red)", False),
        ("white-space: pre", False),
    ],
)
def test_a_color_that_is_no_token_is_seen(declared: str, literal: bool) -> None:
    assert bool(COLOR.search(declared)) == literal


def test_every_color_is_a_token() -> None:
    for name, selector, declared in all_rules():
        found = COLOR.search(declared)
        assert found is None, (
            f"{name}: {selector} has {found and found[0]}; colours stand in app/stage/looks.py"
        )


def test_every_family_of_letters_is_a_token() -> None:
    """One family for words and one for what is copied: no part of a page stands out by its letters."""
    seen = 0
    for name, selector, declared in all_rules():
        for value in re.findall(r"(?<![\w-])font(?:-family)?\s*:\s*([^;]+)", declared):
            seen += 1
            assert value in ("inherit", "inherit !important") or value.endswith(
                ("var(--softrod-font)", "var(--softrod-font-code)")
            ), (name, selector, value)
    assert seen > 20


def test_every_variable_that_a_style_asks_for_is_there() -> None:
    made = style_rules("@media print{*}") + "".join(all_styles().values())
    names = set(re.findall(r"(--softrod-[\w-]+) *:", made))
    # Such as --softrod-seat, and --softrod-glow-1, of which a script has the number in a variable.
    for path in [*APP.rglob("*.js"), *APP.rglob("*.py")]:
        names |= set(
            re.findall(r"""["'`;\s](--softrod-[\w-]+)(?:["'`:]|\$\{)""", path.read_text(encoding="utf-8"))
        )
    begun = tuple(name for name in names if name.endswith("-"))
    used = re.findall(r"var\(\s*(--softrod-[\w-]+)", made)
    assert len(set(used)) > 60
    for name in set(used):
        assert name in names or name.startswith(begun), name


def test_the_font_is_the_page_s_own_and_every_file_of_it_is_sent() -> None:
    """From the folder with the digest, by a relative address: behind any proxy, and cached for long."""
    files = page_files()
    page = gzip.decompress(files["/"].content).decode()
    faces = re.findall(r"@font-face \{(.*?)\}", page, re.DOTALL)
    on_disk = {path.name for path in FACES.parent.glob("*.woff2")}
    asked = [re.search(r'url\("([^"]+)"\)', face) for face in faces]
    assert {one[1].rpartition("/")[2] for one in asked if one} == on_disk
    for face, one in zip(faces, asked, strict=True):
        assert one is not None
        assert re.fullmatch(r"softrod/[0-9a-f]{12}/ui/fonts/[\w-]+\.woff2", one[1])
        sent = files[f"/{one[1]}"]
        assert gzip.decompress(sent.content)[:4] == b"wOF2"
        assert sent.content_type == "font/woff2"
        assert "unicode-range" in face and "font-display: swap" in face
    assert (FACES.parent / "LICENSE.txt").read_text(encoding="utf-8").count("SIL OPEN FONT LICENSE") >= 1
    preloaded = re.findall(r'<link rel="preload" href="([^"]+)" as="font"', page)
    assert [name.rpartition("/")[2] for name in preloaded] == ["inter-latin.woff2"]


def test_files_that_are_saved_ask_for_no_font() -> None:
    for name, text in all_styles().items():
        assert "@font-face" not in text, name


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
    assert {path for path in APP.rglob("*.js") if not {"templates", "fluent"} & set(path.parts)} == checked


def test_what_a_page_loads_first_stays_small() -> None:
    """Packed, with the words of one language, and besides viser's script: some 155 and 67 kB."""
    sizes = {path.rpartition("softrod/")[2].partition("/")[2]: file for path, file in page_files().items()}
    script, of_class = (len(sizes[f"pages/{name}/main.js"].content) for name in ("sandbox", "classroom"))
    for tag in languages():
        page, class_page = (translated(path, tag) or page_files()[path] for path in ("/", CLASS))
        assert len(page.content) + script < 162_000, tag
        assert len(class_page.content) + of_class < 69_000, tag


def test_scripts_are_sent_as_one_without_comments_and_types() -> None:
    sent = {path.rpartition("/")[2]: file for path, file in page_files().items() if path.endswith(".js")}
    later = {"desk.js", "strip.js", "form.js", "sound.js", "picture.js", "wall.js", "physics.js"}
    assert sent.keys() == {"main.js", "check.js", "video.js"} | later
    for name, file in sent.items():
        lean = gzip.decompress(file.content).decode()
        assert not re.search(r"^\s*//|/\*\*", lean, re.MULTILINE), name
        begins = len(re.findall(r"^\s*import\b", lean, re.MULTILINE))
        assert begins == (name in later), name
    for path in APP.rglob("*.js"):
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            before = line.partition("/**")[0]
            # What is taken out as a comment is none in the midst of a text.
            assert before == line or all(before.count(quote) % 2 == 0 for quote in "\"'`"), (path, number)
