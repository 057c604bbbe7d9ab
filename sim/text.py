"""Texts in English that can be said in other languages: each knows its template, and what stands in it.

Who shows a text in another language looks up the template, and fills its places anew. So a template is a
whole sentence, or a name; what stands in it may be a text again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Self


class Text(str):
    """A text in English.

    Its template stands as a literal where it is made: translators are given all those that do.

    Attributes:
        template: the text with its places, as for `str.format`.
        parts: what stands in them, by their names.
    """

    __slots__ = ("parts", "template")

    template: str
    parts: dict[str, object]

    def __new__(cls, template: str, /, **parts: object) -> Self:
        new = super().__new__(cls, template.format(**parts))
        new.template, new.parts = template, parts
        return new

    def __str__(self) -> str:
        """Return the text itself, so that `str` of an error is the text that it was made with."""
        return self

    def with_parts(self, **parts: object) -> Text:
        """Return the same text with something else in some of its places."""
        return Text(self.template, **{**self.parts, **parts})

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, object]]:
        return (self.template,), self.parts


def number(value: float, form: str = "g") -> Text:
    """Return a number as `format` writes it."""
    return Text(f"{{value:{form}}}", value=value)


def with_unit(value: str, unit: str) -> str:
    """Return a number with its unit, if it has one."""
    return Text("{value} {unit}", value=value, unit=unit) if unit else value


def listed(items: Sequence[str]) -> str:
    """Return some texts as a list, as in "a, b and c"."""
    *others, last = items
    if not others:
        return last
    one = others[0]
    for other in others[1:]:
        one = Text("{one}, {other}", one=one, other=other)
    return Text("{one} and {other}", one=one, other=last)
