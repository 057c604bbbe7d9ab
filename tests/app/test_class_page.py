"""The page of a pupil and of the wall, as it is sent."""

from __future__ import annotations

import gzip
import re

import pytest

from app.bundle import without_is
from app.gate.gate import CLASS
from app.pages.sandbox.assets import page_files

MAX_BYTES = 150_000
"""Of all that a pupil's browser loads at first, compressed."""

NEWER = (
    r"(?:\|\||\?\?|&&)=",  # 2021
    r"\.replaceAll\(",  # 2020, but late
    r"\bstatic \{",
    r"[.\s]#[a-z]\w*\s*[(=;.]",  # private names: 2021
    r"\bstructuredClone\b|\bObject\.hasOwn\b|\.(?:findLast|toSorted|toReversed|with)\(",
)
"""Forms of the language that browsers of 2020 do not know."""


def loaded() -> dict[str, bytes]:
    """What a browser loads at first, compressed, by the paths."""
    files = page_files()
    page = gzip.decompress(files[CLASS].content).decode()
    names = {f"/{name}" for name in re.findall(r'(?:src|href)="(softrod/[^"]+)"', page)}
    return {CLASS: files[CLASS].content, **{name: files[name].content for name in names}}


def test_it_is_small_and_has_nothing_of_viser() -> None:
    sent = loaded()
    assert any(name.endswith("pages/classroom/main.js") for name in sent)
    assert any(name.endswith("inter-latin.woff2") for name in sent)
    assert sum(map(len, sent.values())) < MAX_BYTES
    texts = [gzip.decompress(data) for name, data in sent.items() if not name.endswith("woff2")]
    assert not any(b"mantine" in text or b"webgl" in text.lower() for text in texts)


def test_its_style_is_written_out_for_such_a_browser() -> None:
    assert without_is("a:is(b, .c:not(d, e)) f, g{h:i}") == "ab f, a.c:not(d, e) f, g {h:i}"
    assert without_is("@media print{:is(a,b) :is(c,d){e:f}}") == "@media print{a c, a d, b c, b d {e:f}}"
    page = gzip.decompress(loaded()[CLASS]).decode()
    assert ":is(" not in page


@pytest.mark.parametrize("form", NEWER)
def test_a_browser_of_2020_knows_its_language(form: str) -> None:
    [script] = [gzip.decompress(data).decode() for name, data in loaded().items() if name.endswith("main.js")]
    found = re.search(form, script)
    assert found is None, script[max(0, found.start() - 60) : found.end() + 60]
