"""The keys of all texts. Made by `uv run python -m tests.page.generate` from app/words/en."""

from typing import Literal

Key = Literal[
    "class-title",
    "class-needs-javascript",
    "class-blocked",
    "language-name",
    "language-direction",
    "canvas-body",
    "line-away",
]
