"""Makes `look.html`: every control of the panel in every state, by the page's own scripts and styles.

`uv run python -m tests.browser.look FILE` writes it; `--dark` on dark paper. A browser shows no more than one
control that is pointed at, so the states of styles (`:hover` and others) are classes there as well.
"""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

from app.bundle import bundle
from app.pages.sandbox.assets import page_styles
from app.words import ENGLISH, element

FOLDER = Path(__file__).parent

STATES = {"hover": "look-hover", "active": "look-held", "focus-visible": "look-keys", "focus": "look-focus"}
"""Classes that stand for states of styles."""

STYLE = """
body { margin: 0; padding: 20px 28px; background: var(--softrod-panel); }
main section { max-width: 1100px; margin-bottom: 20px; }
main h2 { margin: 0 0 8px; font: 600 var(--softrod-type-1) / var(--softrod-line-1) var(--softrod-font); color: var(--softrod-quiet); }
main figure { margin: 0; min-width: 0; }
main figcaption { margin-top: 16px; font: 400 var(--softrod-type-1) / var(--softrod-line-1) var(--softrod-font); color: var(--softrod-quiet); }
.look-row { display: grid; grid-template-columns: repeat(auto-fill, minmax(var(--least), 1fr)); gap: 20px 24px; align-items: start; }
.softrod-panel.look { position: static; display: block; width: auto; border: 0; zoom: 1; }
.look :is(.softrod-notices, .softrod-lesson-foot) { position: static; }
.look * { animation: none !important; transition: none !important; }
"""  # noqa: E501


def page(dark: bool = False) -> str:
    """The sheet as one HTML file, but for its fonts, which are beside `app/ui/fonts/fonts.css`."""
    fonts = (FOLDER.parents[1] / "app" / "ui" / "fonts").as_uri()
    styles = page_styles(f"{fonts}/")
    for state, name in STATES.items():
        styles = re.sub(rf":{state}(?![-\w])", f":is(:{state}, .{name})", styles)
    scheme = "dark" if dark else "light"
    script = bundle(FOLDER / "look.js")
    return "".join(
        (
            f'<!doctype html><html lang="en" data-mantine-color-scheme="{scheme}"><head>',
            '<meta charset="utf-8" /><title>softrod: every control</title>',
            f'<style>{styles}{STYLE}</style></head><body><main class="softrod-panel look"></main>',
            element(script, ENGLISH),
            f'<script type="module">{script}</script></body></html>',
        )
    )


def main() -> int:
    """Write it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("file", type=Path, help="where it is written, as look.html")
    parser.add_argument("--dark", action="store_true", help="on dark paper")
    given = parser.parse_args()
    given.file.write_text(page(given.dark), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
