"""What `python -m tests.words` tells translators."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.words import spoken
from tests import words

FILES = {
    "en/language.ftl": "language-name = English\n",
    "en/a.ftl": "a-one = One\n    .hint = the first\na-two = Two { $more }\n",
    "en/b.ftl": "b-one = One\nb-two = Two\n",
    "en/c.ftl": "c-one = One\nc-two = Two\n",
    "nl/language.ftl": "language-name = Nederlands\n",
    "nl/c.ftl": "c-one = Een\n",
    "nl/scenes/rope.json": '{"A rope of ten masses": "Een touw", "Gone": "Weg", "Never": ""}',
    "nl/sim.json": '{"mass {mass} is held": "massa {mass} staat vast"}',
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A few texts in English and fewer in Dutch, and a place for those of `sim`."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    (tmp_path / "sim").mkdir()
    monkeypatch.setattr(spoken, "FOLDER", tmp_path)
    monkeypatch.setattr(words, "SIM_SOURCES", tmp_path / "sim")
    monkeypatch.setattr(words, "sim_templates", lambda: {"mass {mass} is held": "sim/a.py"})
    monkeypatch.setattr(words, "of_scenes", lambda: {"scenes/rope.json": ["A rope of twelve masses", "Hi"]})
    spoken.languages.cache_clear()
    yield tmp_path
    spoken.languages.cache_clear()


def said(capsys: pytest.CaptureFixture[str], *arguments: str) -> list[str]:
    words.main(list(arguments))
    return capsys.readouterr().out.splitlines()


def test_what_is_missing_stands_below_what_was_begun(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "nl" / "scenes" / "rope.json").unlink()
    assert said(capsys, "nl") == [
        "Nederlands (nl): 3 texts, 8 missing, 0 wrong",
        "  missing in c.ftl: c-two",
        "  missing: all 3 texts of a.ftl",
        "  missing: all 2 texts of b.ftl",
        "  missing: all 2 texts of scenes/rope.json",
    ]


def test_what_is_left_out_is_told_with_what_it_may_have_become(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = [
        "  scenes/rope.json: there is no English text 'A rope of ten masses'; it may have been reworded: "
        "'A rope of twelve masses'",
        "  scenes/rope.json: there is no English text 'Gone'; it may have been reworded",
    ]
    assert said(capsys, "nl")[1:3] == wrong
    first, *told = said(capsys, "nl", "--write")
    assert first == "Nederlands (nl): 3 texts, 8 missing, 0 wrong"
    assert told[:2] == [
        "  left out, as there is no such English text: 'A rope of ten masses' → 'Een touw'; "
        "it may have been reworded: 'A rope of twelve masses'",
        "  left out, as there is no such English text: 'Gone' → 'Weg'; it may have been reworded",
    ]
    written = json.loads((folder / "nl" / "scenes" / "rope.json").read_text(encoding="utf-8"))
    assert written == {"A rope of twelve masses": "", "Hi": ""}
    kept = json.loads((folder / "nl" / "sim.json").read_text(encoding="utf-8"))
    assert kept == {"mass {mass} is held": "massa {mass} staat vast"}


def test_all_faults_are_told_and_no_translation_is_lost_by_them(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "nl" / "a.ftl").write_text("a-one Een\n\na-two = Twee { $meer }\n")
    (folder / "nl" / "d.ftl").write_text("c-one = Een\n")
    (folder / "nl" / "sim.json").write_text('{"mass {mass} is held": "massa {mass"}')
    (broken := folder / "nl" / "scenes" / "rope.json").write_text('{"Hi": "Hoi",}')
    first, unwritten, *told = said(capsys, "nl", "--write")
    assert first == "Nederlands (nl): 4 texts, 7 missing, 5 wrong"
    assert unwritten == "  nothing is written before all files can be read"
    syntax, twice, places, unread, template = told[:5]
    assert syntax.startswith('  a.ftl of nl: Expected token: "=" in \'a-one Een')
    assert twice == "  d.ftl of nl: the message c-one is there already, in c.ftl"
    assert places == "  a-two has the places ['meer'], but in English ['more']"
    assert "rope.json: JSON is malformed" in unread
    assert template == "  sim.json: 'massa {mass' has other places than 'mass {mass} is held'"
    assert broken.read_text() == '{"Hi": "Hoi",}'


def test_a_text_of_sim_without_a_literal_is_told_with_its_line(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "sim" / "a.py").write_text('Text("a {b}", b=1)\nText(f"mass {m} is held")\nText("c", d=2)\n')
    assert words.main([]) == 1
    first, literal, places, *_ = capsys.readouterr().out.splitlines()
    assert first == "English (en): 2 wrong"
    assert literal == (
        "  sim/a.py:2: Text(f'mass {m} is held') has no literal as its template, and is said in English only"
        '; write its places, as in Text("mass {mass} is held", mass=mass)'
    )
    assert places == "  sim/a.py:3: 'c' is given ['d'] for its places"


def test_whoever_reads_it_may_stop(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    end, begin = os.pipe()
    os.close(end)
    with open(begin, "w") as out:  # noqa: PTH123
        monkeypatch.setattr(sys, "stdout", out)
        assert words.run(["nl"]) == 1
