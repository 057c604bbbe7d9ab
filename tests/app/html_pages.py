"""What files in HTML have in them."""

from __future__ import annotations

import base64
import hashlib
import html.parser
import json
import re
from collections.abc import Iterable
from typing import Any

WICKED = '"></script><script>alert(1)</script><img src=x onerror=alert(1)>&'
"""A text that would do harm if it were markup anywhere."""


def held(text: str, id: str) -> Any:
    """The JSON that a file holds for its script under an id."""
    match = re.search(rf'<script type="application/json" id="{id}">(.*?)</script>', text, re.DOTALL)
    assert match is not None
    return json.loads(match[1])


class Page(html.parser.HTMLParser):
    """What a page has: addresses, ids, texts of its elements, and its scripts and styles."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.addresses: list[str] = []
        self.ids: list[str] = []
        self.tags: list[str] = []
        self.parts: dict[str, list[str]] = {"script": [], "style": [], "title": [], "h1": [], "b": []}
        self.policy = ""
        self._open: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """As `HTMLParser` has it."""
        told = dict(attrs)
        assert not [name for name in told if name.startswith("on")]
        self.tags.append(tag)
        self.ids += [told["id"] or ""] if "id" in told else []
        self.addresses += [value or "" for name, value in attrs if name in ("src", "href")]
        if told.get("http-equiv") == "Content-Security-Policy":
            self.policy = told["content"] or ""
        kind = "data" if told.get("type") in ("application/json", "text/plain") else tag
        if kind in self.parts:
            self.parts[kind].append("")
        self._open.append(kind)

    def handle_endtag(self, tag: str) -> None:
        """As `HTMLParser` has it."""
        while self._open and self._open.pop() not in (tag, "data"):
            pass

    def handle_data(self, data: str) -> None:
        """As `HTMLParser` has it."""
        if self._open and self._open[-1] in self.parts:
            self.parts[self._open[-1]][-1] += data

    def check_policy(self, images: str = "data:", of_site: bool = False) -> None:
        """It may load nothing but images, and runs and has no script or style but those that are in it."""
        rules = dict(rule.split(" ", 1) for rule in self.policy.split("; "))
        assert rules.pop("img-src") == images
        assert rules.pop("default-src") == rules.pop("base-uri") == rules.pop("form-action") == "'none'"
        for kind in ("script", "style"):
            digests = [
                f"'sha256-{base64.b64encode(hashlib.sha256(part.encode()).digest()).decode()}'"
                for part in self.parts[kind]
            ]
            assert rules.pop(f"{kind}-src") == " ".join(digests)
        if of_site:  # what installs it
            assert rules.pop("manifest-src") == rules.pop("worker-src") == "'self'"
        assert not rules
        assert not {"iframe", "object", "embed", "form", "base"} & set(self.tags)


class _Shown(html.parser.HTMLParser):
    """The texts of a page that somebody reads or hears."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.texts: list[str] = []
        self._open = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """As `HTMLParser` has it."""
        self._open = tag
        self.texts += [
            text or "" for name, text in attrs if name in ("aria-label", "title", "alt", "placeholder")
        ]

    def handle_data(self, data: str) -> None:
        """As `HTMLParser` has it."""
        if self._open not in ("script", "style"):
            self.texts.append(data)


def plain_texts(text: str) -> set[str]:
    """What a page in pseudo-English, which has dots at the end of words, shows in another language."""
    return plain_of(_Shown(text).texts)


def plain_of(texts: Iterable[str]) -> set[str]:
    """Those of some texts that are in no pseudo-English."""
    return {" ".join(text.split()) for text in texts if re.search("[A-Za-z]{2}", text) and "·" not in text}
