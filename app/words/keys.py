"""The keys of all texts. Made by `uv run python -m tests.page.generate` from app/words/en."""

from typing import Literal

Key = Literal[
    "access-title",
    "access-language",
    "access-language.hint",
    "access-letters",
    "access-letters.hint",
    "access-letters.always",
    "access-letters.body",
    "access-letters.never",
    "access-larger",
    "access-larger.hint",
    "access-still",
    "access-still.hint",
    "access-kept",
    "class-title",
    "class-needs-javascript",
    "class-blocked",
    "language-name",
    "language-direction",
    "canvas-body",
    "line-away",
]
