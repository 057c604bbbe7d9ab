"""The files that are sent to browsers: viser's page with softrod's script and styles."""

from __future__ import annotations

import gzip
import hashlib
import inspect
import re
from functools import cache
from pathlib import Path

from ...gate.gate import CHECK, PAGE_PATHS, VIDEO, GateError, StaticFile
from ...stage.looks import style_rules
from ...viser_inside import PLACE, page_script
from ..check.page import SCRIPT, check_page
from ..video.page import SCRIPTS, video_page
from .features import FEATURES

_APP = Path(__file__).parents[2]
_SCRIPTS = tuple(_APP / name for name in ("stage", "wire", "ui", "features", "pages"))
"""Folders with scripts, which have the same relative paths as on the disk."""
_TYPES = {".js": "text/javascript", ".svg": "image/svg+xml", ".webp": "image/webp", ".woff2": "font/woff2"}
_COMMENT = re.compile(rb"^[ \t]*(?:/\*\*(?:(?!\*/).)*\*/|//[^\n]*)[ \t]*\n", re.MULTILINE | re.DOTALL)
"""A comment on lines of its own; a test checks that none is in a text of several lines."""
_TYPE = re.compile(rb"/\*\* @[^\n]*?\*/ ?")
"""A type within a line of a script; a test checks that none is in a text."""
_FOREVER = "public, max-age=31536000, immutable"
_FIRST_SHEETS = ("ui/page.css", "ui/viser/viser.css", "ui/dialogs.css", "ui/gui/gui.css", "stage/stage.css")
_LAST_SHEETS = ("features/classroom/classroom.css", "ui/looks.css")
"""Style sheets of no feature, before and after those of features; later ones take precedence."""


@cache
def page_files() -> dict[str, StaticFile]:
    """All files of the page by their paths.

    Paths of scripts contain a digest of all scripts, so that browsers can cache them and never mix two
    versions.

    Raises:
        GateError: viser's page differs from the known version.
    """
    paths = (path for folder in _SCRIPTS for path in sorted(folder.rglob("*")) if path.suffix in _TYPES)
    sources = {path.relative_to(_APP).as_posix(): _as_sent(path) for path in paths}
    digest = hashlib.sha256(b"".join(sources.values())).hexdigest()[:12]
    # Relative, since the page may be in a folder of another site.
    folder = f"softrod/{digest}/"
    files = {
        f"/{folder}{name}": StaticFile(gzip.compress(text, mtime=0), _TYPES[Path(name).suffix], _FOREVER)
        for name, text in sources.items()
    }
    scripts = [folder + name for name in sources if name.endswith(".js") and name not in (SCRIPT, *SCRIPTS)]
    index = _html(_index(folder, scripts))
    others = {CHECK: _html(check_page(folder)), VIDEO: _html(video_page(folder))}
    return {**files, **dict.fromkeys(PAGE_PATHS, index), **others}


def _as_sent(path: Path) -> bytes:
    """A file as it is sent: scripts without types, and without comments on lines of their own.

    Their lines stay, empty, so that errors have the right line numbers.
    """
    data = path.read_bytes()
    if path.suffix != ".js":
        return data
    return _TYPE.sub(b"", _COMMENT.sub(lambda found: b"\n" * found[0].count(b"\n"), data))


def _sheets() -> list[Path]:
    """The style sheets; later ones take precedence."""
    of_features = [Path(inspect.getfile(feature)).parent for feature in FEATURES]
    sheets = [folder / f"{folder.name}.css" for folder in of_features]
    return [
        *(_APP / name for name in _FIRST_SHEETS),
        *(sheet for sheet in sheets if sheet.exists()),
        *(_APP / name for name in _LAST_SHEETS),
    ]


def _html(page: str) -> StaticFile:
    return StaticFile(gzip.compress(page.encode(), mtime=0), "text/html", "no-cache")


def _index(folder: str, scripts: list[str]) -> str:
    """The page: a loading screen, then viser's page, which is one long script.

    softrod's script has to run before viser's, or it would miss the first messages. So viser's is not run by
    the browser but started by softrod's."""
    try:
        script = page_script()
    except (OSError, ValueError) as error:
        raise GateError(f"viser's page cannot be used: {error}") from None
    fonts = (_APP / "ui" / "fonts" / "fonts.css").read_text(encoding="utf-8")
    styles = "\n".join(
        (
            fonts.replace('url("', f'url("{folder}ui/fonts/'),
            style_rules('html[data-mantine-color-scheme="dark"]*'),
            *(path.read_text(encoding="utf-8") for path in _sheets()),
        )
    )
    return "\n".join(
        (
            '<!doctype html><html lang="en"><head><meta charset="utf-8" />',
            '<meta name="viewport" content="width=device-width, initial-scale=1" />',
            "<title>softrod</title>",
            f'<link rel="icon" href="{folder}pages/sandbox/icon.svg" />',
            f'<link rel="preload" href="{folder}ui/fonts/inter-latin.woff2" as="font" crossorigin />',
            *(f'<link rel="modulepreload" href="{name}" />' for name in scripts),
            f"<style>{styles}</style></head><body>",
            (_APP / "ui" / "viser" / "loading.html").read_text(encoding="utf-8"),
            PLACE,
            f'<script type="module" src="{folder}pages/sandbox/main.js"></script>',
            f'<script type="text/plain"{script.removeprefix("<script")}</body></html>',
        )
    )
