"""Words: each language says what English does, and a page is sent its own."""

from __future__ import annotations

import ast
import gzip
import re
from pathlib import Path

import pytest
from websockets.datastructures import Headers
from websockets.http11 import Request

import sim
from app import words
from app.gate.gate import language_of
from app.pages.sandbox.assets import page_in
from app.words import (
    ENGLISH,
    PSEUDO,
    choose,
    decimal,
    find,
    joined,
    language,
    languages,
    listed,
    number,
    of_script,
    quoted,
    say,
    speaking,
)
from app.words.english import catalogue, name_of, of, read, sentence, step_of
from sim.errors import InputError
from sim.motion.quantities import quantity
from sim.text import Text
from tests.page.generate import texts
from tests.words import wrong

ROOT = Path(__file__).parents[2]

COMMAND = "what a command prints, in English"
CODE = "code and its comments, in English"
BY_HAND = {
    "bundle.py": (6, CODE),
    "cli/main.py": (2, COMMAND),
    "command.py": (2, COMMAND),
    "export/command.py": (1, COMMAND),
    "ui/controls.py": (2, "what is wrong with an option of a command or an address, in English"),
    "lessons.py": (1, "what is wrong with the file of a lesson, in English"),
    "export/body/program.py": (4, CODE),
    "export/live/program.py": (1, CODE),
    "export/live/static/game.js": (1, "what a program did wrong that uses the file, in English"),
    "export/html_file.py": (1, "a policy"),
    "session/plots.py": (1, "the name of a plot, which is read again"),
    "wire/to_page.py": (1, "what a message has, for a comment"),
}
"""Files whose lists have marks by hand, how many, and what these are of."""


@pytest.mark.parametrize("tag", [tag for tag in languages() if tag != ENGLISH])
def test_the_texts_of_a_language_are_english_ones_with_the_same_places(tag: str) -> None:
    assert not list(wrong(tag))


def test_what_stands_in_quotation_marks_has_those_of_the_language() -> None:
    error = Text("{name!r} is too long for the name of a scene", name="a'b")
    assert of(error) == str(error) == '"a\'b" is too long for the name of a scene'
    with pytest.raises(InputError) as refused:
        quantity("2 mass0.x", sim.rope())
    for tag, first, last in (
        ("de", "„", "“"),
        ("fr", "«\u202f", "\u202f»"),
        ("es", "«", "»"),
        ("tr", "“", "”"),
        ("ar", "«", "»"),
    ):
        with speaking(tag):
            assert f"{first}a'b{last}" in of(error)
            assert f"{first}a\\n{last}" == quoted("a\n")
            assert f"{first}mass0.x{last}" in of(str(refused.value))


def test_what_is_said_has_all_that_stands_in_it() -> None:
    known = texts()
    for path in sorted((ROOT / "app").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            match node:
                case ast.Call(ast.Name("say"), [ast.Constant(str(key))], keywords):
                    given = {each.arg for each in keywords}
                    assert given == set(known[key]), f"{path}: {ast.unparse(node)}"
                case _:
                    pass


def test_a_text_is_said_in_the_language_that_is_spoken() -> None:
    assert language() == ENGLISH
    with speaking("de"):
        assert say("language-name") == "Deutsch"
        with speaking(PSEUDO):
            assert say("language-name") == "Éñğļîšh···"
        assert language() == "de"
    assert say("language-name") == "English"


def test_a_sentence_of_sim_is_said_in_pseudo_english_with_its_numbers() -> None:
    with speaking(PSEUDO):
        assert of(Text("a {name} of {mass:.3g} kg", name="body", mass=2.0)) == "à body öf· 2 ķğ·"


@pytest.mark.parametrize(
    ("tag", "text", "said"),
    [
        ("en", "low is above high", "Low is above high."),
        ("en", "name: it must not be empty", "Name: it must not be empty."),
        ("en", "mass99.y: mass 99 does not exist", "mass99.y: mass 99 does not exist."),
        ("en", "is it held?", "Is it held?"),
        ("fr", "l’objet est fixé", "L’objet est fixé."),
        ("tr", "itmeler eksik", "İtmeler eksik."),
        ("tr", "özellik yok", "Özellik yok."),
    ],
)
def test_a_sentence_has_a_capital_letter_and_an_end(tag: str, text: str, said: str) -> None:
    with speaking(tag):
        assert sentence(text) == said


def test_lists_have_the_marks_of_their_language() -> None:
    assert joined(("a", "", "b", "c")) == "a, b, c"
    with speaking("ar"):
        plain = joined(("a", "b"), "language-semicolon") + joined(("a", "b"))
        assert re.sub("[\u200f\u2068\u2069]", "", plain) == "a؛ ba، b"
    by_hand = re.compile(r"""["'](?:, |; )["']\.join|\.join\(["'](?:, |; )["']\)""")
    found = {
        path.relative_to(ROOT / "app").as_posix(): count
        for path in (ROOT / "app").rglob("*.*")
        if path.suffix in (".py", ".js") and (count := len(by_hand.findall(path.read_text(encoding="utf-8"))))
    }
    assert found == {path: count for path, (count, _) in BY_HAND.items()}


@pytest.mark.parametrize(
    ("asked", "accepted", "chosen"),
    [
        ("de", "en", "de"),
        ("", "de-CH, en;q=0.5", "de"),
        ("", "xx, de;q=0.3, en;q=0.9", "en"),
        ("nonsense", "de", "de"),
        ("", "de;q=nan, ;;;,=", "en"),
        ("", "", "en"),
        (PSEUDO, "de", PSEUDO),
    ],
)
def test_the_language_is_the_one_asked_for_or_the_browser_s(asked: str, accepted: str, chosen: str) -> None:
    assert choose(asked, accepted) == chosen


@pytest.mark.parametrize(
    ("path", "headers", "chosen"),
    [
        ("/?lang=de", {}, "de"),
        ("/?lang=en", {"Cookie": "softrod-lang=de"}, "en"),
        ("/", {"Cookie": "a=b; softrod-lang=de", "Accept-Language": "en"}, "de"),
        ("/", {"Accept-Language": "de"}, "de"),
        ("/?lang=%00", {}, "en"),
    ],
)
def test_a_request_says_in_which_language(path: str, headers: dict[str, str], chosen: str) -> None:
    assert language_of(Request(path, Headers(headers))) == chosen


def test_what_a_language_lacks_is_said_in_english(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for tag, text in (
        ("en", "line-away = Away\n    .hint = why\ncanvas-body = Body\n"),
        ("xx", "line-away = Yawa\nlanguage-direction = ltr\n"),
    ):
        (tmp_path / tag).mkdir()
        (tmp_path / tag / "all.ftl").write_text(text)
    caches = words.entries, words.messages, words.bundle_of
    monkeypatch.setattr(words.spoken, "FOLDER", tmp_path)
    for cache in caches:
        cache.cache_clear()
    try:
        with speaking("xx"):
            assert [find(key) for key in ("line-away", "line-away.hint", "canvas-body")] == [
                "Yawa",
                "why",
                "Body",
            ]
            assert (find("line-away.word"), find("nothing-here", "-")) == ("", "-")
        assert ".hint = why" in of_script('say("line-away.hint")', "xx")
    finally:
        for cache in caches:
            cache.cache_clear()


def test_a_page_has_the_words_of_its_script_in_its_language_and_no_others() -> None:
    page = gzip.decompress(page_in("/class", "de").content).decode()
    assert '<html lang="de">' in page and "JavaScript ist" not in page
    words = re.search(r'<script type="text/plain" id="words" lang="de"[^>]*>(.*?)</script>', page, re.S)
    assert words and "line-away" in words[1] and "check-good" not in words[1]
    assert "{say" not in page


def test_a_page_without_words_has_places_that_its_script_fills() -> None:
    page = gzip.decompress(page_in("/check", "de").content).decode()
    assert 'data-pictures="Bewegte Bilder kommen an, {rate} in der Sekunde."' in page
    assert "{say" not in page
    script = (ROOT / "app" / "pages" / "check" / "check.js").read_text(encoding="utf-8")
    given = set(re.findall(r'data-([a-z-]+)="', page)) - {"try"}
    asked = {
        name for said in re.findall(r"\btexts?\((.*?)\)", script) for name in re.findall(r'"([a-z-]+)"', said)
    }
    asked |= set(re.findall(r'conclude\("([a-z]+)"', script))
    assert asked == given


def test_keys_are_found_in_a_script_as_strings() -> None:
    script = 'const a = say("line-away"), b = {x: "class-title.hint"}, c = "no-such-key";'
    assert re.findall(r"^[a-z-]+(?= =)", of_script(script, ENGLISH), re.M) == ["class-title", "line-away"]


def test_numbers_are_written_as_the_language_does() -> None:
    assert (decimal("1,234.5"), number(2 / 3)) == ("1,234.5", "0.667")
    assert listed(["a", "b", "c"]) == "a, b and c"
    with speaking("de"):
        assert (decimal("1,234.5"), number(2 / 3)) == ("1\u202f234,5", "0,667")
        assert listed(["a", "b", "c"]) == "a, b und c"


def test_all_texts_of_a_lesson_are_said_in_the_language_that_is_spoken() -> None:
    scene, german = sim.load_scene("lesson-hooke"), catalogue("de")
    assert scene.lesson is not None
    step = scene.lesson.steps[0]
    with speaking("de"):
        said = step_of(step)
        assert (name_of(scene), of("my own words")) == (german[scene.title], "my own words")
    assert said.question is not None and step.question is not None
    assert (said.title, said.do) == (german[step.title], german[step.do])
    assert said.question.choices == tuple(german[choice] for choice in step.question.choices)
    assert said.question.because == german[step.question.because] != step.question.because
    assert (said.settings, said.question.answer) == (step.settings, step.question.answer)
    assert step_of(step) is step


def test_a_file_of_texts_that_is_none_is_named(tmp_path: Path) -> None:
    (path := tmp_path / "de" / "scenes" / "a.json").parent.mkdir(parents=True)
    path.write_text("[1]")
    with pytest.raises(ValueError, match=r"de/scenes/a\.json: Expected `object`"):
        read(path)
