"""The files that a browser gets: viser's page with softrod's script and styles in its head, and these."""

from __future__ import annotations

import gzip
import hashlib
from functools import cache
from pathlib import Path

import viser

from ..gate.gate import PAGE_PATHS, GateError, StaticFile

_FOLDER = Path(__file__).parent / "static"
_TYPES = {".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".webp": "image/webp"}
_FOREVER = "public, max-age=31536000, immutable"
_STYLES = (
    "page.css",
    "overlay.css",
    "dock.css",
    "tools.css",
    "edit.css",
    "dialogs.css",
    "gallery.css",
    "lesson.css",
    "looks.css",
)
"""Later ones win."""
_TITLE = "<title>Viser</title>"
_VISERS_SCRIPT = {
    "<script data-p=": '<script type="module" data-p=',
    "document.currentScript": 'document.querySelector("script[data-p]")',
}


@cache
def page_files() -> dict[str, StaticFile]:
    """Every file of the page by its path.

    The script's address has a digest of its text, so that a browser keeps it, and never mixes two versions.

    Raises:
        GateError: viser's page is not as it is known here.
    """
    paths = (path for path in sorted(_FOLDER.rglob("*")) if path.suffix in _TYPES)
    sources = {path.relative_to(_FOLDER).as_posix(): path.read_bytes() for path in paths}
    digest = hashlib.sha256(b"".join(sources.values())).hexdigest()[:12]
    # Without a slash before it, since the page may be in a folder of another site.
    folder = f"softrod/{digest}/"
    files = {
        f"/{folder}{name}": StaticFile(gzip.compress(text, mtime=0), _TYPES[Path(name).suffix], _FOREVER)
        for name, text in sources.items()
    }
    index = StaticFile(gzip.compress(_index(folder).encode(), mtime=0), "text/html", "no-cache")
    return {**files, **dict.fromkeys(PAGE_PATHS, index)}


def _index(folder: str) -> str:
    """viser's page, which is one HTML file, with what is softrod's in its head.

    softrod's script has to be there before viser's begins, or it would miss the first messages. Modules run
    in the order of the document, so viser's is made one as well.
    """
    path = Path(viser.__file__).parent / "client" / "build" / "index.html"
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise GateError(f"viser's page cannot be read: {error}") from None
    icon_begin, icon_end = text.find("<link"), text.find("/>", text.find("<link"))
    known = 'rel="icon"' in text[icon_begin:icon_end]
    if not known or any(text.count(part) != 1 for part in (_TITLE, *_VISERS_SCRIPT)):
        raise GateError("viser's page is not the one that softrod knows.")
    own = "\n".join(
        (
            "<title>softrod</title>",
            f'<link rel="icon" href="{folder}icon.svg" />',
            *(f'<link rel="stylesheet" href="{folder}{name}" />' for name in _STYLES),
            f'<script type="module" src="{folder}main.js"></script>',
        )
    )
    text = (text[:icon_begin] + text[icon_end + 2 :]).replace(_TITLE, own)
    for part, instead in _VISERS_SCRIPT.items():
        text = text.replace(part, instead)
    return text
