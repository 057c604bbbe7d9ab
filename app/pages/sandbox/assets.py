"""The files that are sent to browsers: viser's page with softrod's script and styles."""

from __future__ import annotations

import gzip
import hashlib
import inspect
from functools import cache
from pathlib import Path

from ...bundle import bundles, compact_style
from ...gate.gate import CHECK, CLASS, PAGE_PATHS, VIDEO, GateError, StaticFile
from ...stage.looks import style_rules, used_rules
from ...viser_inside import PLACE, page_script
from ...words import ENGLISH, localized
from ..check.page import check_page
from ..classroom.page import class_page
from ..video.page import video_page
from .features import FEATURES

_APP = Path(__file__).parents[2]
_MAIN = "pages/sandbox/main.js"
_VISER = "ui/viser/viser.txt"
"""viser's page: apart from softrod's, so that browsers keep most of what they are sent."""
_PAGES = {
    CLASS: (class_page, "pages/classroom/main.js"),
    CHECK: (check_page, "pages/check/check.js"),
    VIDEO: (video_page, "pages/video/video.js"),
}
"""By their paths, what makes each page but the sandbox, and its script. This is sent as one with all that it
imports at once, since many small files cost more bytes."""
_FOLDERS = tuple(_APP / name for name in ("ui", "features", "pages"))
"""Folders with images and fonts, which have the same relative paths as on the disk."""
_MEDIA = {".svg": "image/svg+xml", ".webp": "image/webp", ".woff2": "font/woff2"}
_TYPES = {".js": "text/javascript", ".txt": "text/plain", **_MEDIA}
_FOREVER = "public, max-age=31536000, immutable"
_FIRST_SHEETS = (
    "ui/page.css",
    "ui/viser/viser.css",
    "ui/dialogs.css",
    "ui/gui/gui.css",
    "stage/stage.css",
    "ui/described.css",
    "ui/hands/taps.css",
)
_LAST_SHEETS = ("features/classroom/classroom.css", "features/classroom/desk.css", "ui/looks.css")
"""Style sheets of no feature, before and after those of features; later ones take precedence."""


@cache
def _sources() -> dict[str, bytes]:
    """Scripts, images and fonts, by their names in the folder of the application.

    Raises:
        GateError: viser's page differs from the known version.
    """
    paths = (path for folder in _FOLDERS for path in sorted(folder.rglob("*")) if path.suffix in _MEDIA)
    sources = {path.relative_to(_APP).as_posix(): path.read_bytes() for path in paths}
    try:
        sources[_VISER] = page_script().encode()
    except (OSError, ValueError) as error:
        raise GateError(f"viser's page cannot be used: {error}") from None
    for script in (_MAIN, *(script for _, script in _PAGES.values())):
        sources |= {name: text.encode() for name, text in _scripts(script).items()}
    return sources


@cache
def _scripts(start: str) -> dict[str, str]:
    """A page's script and those that it loads later, by their names."""
    return {path.relative_to(_APP).as_posix(): text for path, text in bundles(_APP / start).items()}


@cache
def _folder() -> str:
    """Where they are, with a slash at its end. It is relative, since the page may be in a site's folder."""
    return f"softrod/{hashlib.sha256(b''.join(_sources().values())).hexdigest()[:12]}/"


@cache
def page_files() -> dict[str, StaticFile]:
    """All files of the page by their paths.

    Paths of scripts contain a digest of all scripts, so that browsers can cache them and never mix two
    versions.

    Raises:
        GateError: viser's page differs from the known version.
    """
    folder = _folder()
    files = {
        f"/{folder}{name}": StaticFile(gzip.compress(data, mtime=0), _TYPES[Path(name).suffix], _FOREVER)
        for name, data in _sources().items()
    }
    return {**files, **{path: page_in(path, ENGLISH) for path in (*PAGE_PATHS, *_PAGES)}}


def translated(path: str, language: str) -> StaticFile | None:
    """The page at a path in a language; None for what is no page."""
    is_page = language != ENGLISH and path in (*PAGE_PATHS, *_PAGES)
    return page_in(PAGE_PATHS[0] if path in PAGE_PATHS else path, language) if is_page else None


def _sheets() -> list[Path]:
    """The style sheets; later ones take precedence."""
    of_features = [Path(inspect.getfile(feature)).parent for feature in FEATURES]
    sheets = [folder / f"{folder.name}.css" for folder in of_features]
    return [
        *(_APP / name for name in _FIRST_SHEETS),
        *(sheet for sheet in sheets if sheet.exists()),
        *(_APP / name for name in _LAST_SHEETS),
    ]


def page_styles(fonts: str) -> str:
    """The style sheet of the page.

    Args:
        fonts: where the page's fonts are, with a slash at its end.
    """
    faces = (
        (_APP / "ui" / "fonts" / "fonts.css").read_text(encoding="utf-8").replace('url("', f'url("{fonts}')
    )
    return "\n".join(
        (faces, style_rules('html[data-mantine-color-scheme="dark"]*'), compact_style(*_sheets()))
    )


@cache
def page_in(path: str, language: str) -> StaticFile:
    """The page at a path in a language.

    Raises:
        GateError: viser's page differs from the known version.
    """
    make, script = _PAGES.get(path, (_index, _MAIN))
    scripts = "\n".join(_scripts(script).values())
    [page] = used_rules([make(_folder())], scripts)
    page = localized(page, language, scripts)
    return StaticFile(gzip.compress(page.encode(), mtime=0), "text/html", "no-cache")


def _index(folder: str) -> str:
    """The page: a loading screen, then viser's page, which is one long script.

    softrod's script has to run before viser's, or it would miss the first messages. So viser's is not run by
    the browser but started by softrod's."""
    return "\n".join(
        (
            '<!doctype html><html lang="en"><head><meta charset="utf-8" />',
            '<meta name="viewport" content="width=device-width, initial-scale=1" />',
            "<title>softrod</title>",
            f'<link rel="icon" href="{folder}pages/sandbox/icon.svg" />',
            f'<link rel="preload" href="{folder}ui/fonts/inter-latin.woff2" as="font" crossorigin />',
            f'<link rel="modulepreload" href="{folder}{_MAIN}" />',
            f'<link rel="preload" href="{folder}{_VISER}" as="fetch" crossorigin />',
            f"<style>{page_styles(f'{folder}ui/fonts/')}</style></head><body>",
            (_APP / "ui" / "viser" / "loading.html").read_text(encoding="utf-8"),
            f'<main class="softrod-main"><h1 class="softrod-tell">softrod</h1>{PLACE}</main>',
            "{words}",
            f'<script type="module" src="{folder}{_MAIN}"></script></body></html>',
        )
    )
