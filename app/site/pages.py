"""The files of a gallery: its index, a live file for each scene with a bar that leads on, and pictures."""

from __future__ import annotations

import hashlib
import html
import re
from collections.abc import Callable, Sequence
from functools import cache, partial
from itertools import groupby
from pathlib import Path

import sim
from sim.errors import InputError
from sim.text import Text

from ..bundle import bundle, compact_style
from ..export.html_file import Bar, document, said
from ..export.live.live import DARK, early_script, live_html
from ..features.gallery import thumbnails
from ..stage.looks import style_rules
from ..words import say
from .entries import Shown
from .folder import INDEX
from .install import ICONS, MANIFEST, WORKER, icon, manifest, worker

_FOLDER = Path(__file__).parent / "static"
_CARDS = Path(__file__).parents[1] / "features" / "gallery" / "gallery.css"

_ICONS = {
    "dark": '<circle cx="12" cy="12" r="8.5"/><path class="full" d="M12 3.5a8.5 8.5 0 0 1 0 17z"/>',
    "save": '<path d="M12 4v11M7 10.5l5 5 5-5M5 20h14"/>',
    "before": '<path d="M15 5l-7 7 7 7"/>',
    "after": '<path d="M9 5l7 7-7 7"/>',
    "all": '<path d="M4 4h6v6H4zM14 4h6v6h-6zM4 14h6v6H4zM14 14h6v6h-6z"/>',
}
"""Lines in 24 by 24."""


def files(scenes: Sequence[Shown], title: str) -> dict[str, Callable[[], bytes]]:
    """The path of each file of a gallery, and what makes it; they are to be made in this order.

    Args:
        scenes: in order.
        title: of the gallery; if it is empty, the usual one.
    """
    title = title or say("site-title")
    made: dict[str, Callable[[], bytes]] = {}
    for i, scene in enumerate(scenes):
        before = scenes[i - 1] if i else None
        after = scenes[i + 1] if i + 1 < len(scenes) else None
        made[_page(scene)] = partial(_live, scene, before, after)
        for dark in (False, True):
            made[_picture(scene, dark)] = partial(_painted, scene, dark)
    made[INDEX] = partial(_index, scenes, title)
    made[MANIFEST] = partial(manifest, title)
    made |= {file: partial(icon, size) for file, size in ICONS.items()}
    digests: dict[str, str] = {}

    def noted(file: str, make: Callable[[], bytes]) -> bytes:
        data = make()
        digests[file] = hashlib.sha256(data).hexdigest()
        return data

    # The last one: it names all others.
    return {file: partial(noted, file, make) for file, make in made.items()} | {
        WORKER: partial(worker, digests)
    }


def _page(scene: Shown) -> str:
    return f"{scene.file}.html"


def _picture(scene: Shown, dark: bool) -> str:
    return f"pictures/{'dark' if dark else 'light'}/{scene.file}.webp"


def _painted(scene: Shown, dark: bool) -> bytes:
    """A picture: of a preset the one that ships, of any other scene one of where it starts."""
    if scene.built_in:
        return (thumbnails.FOLDER / thumbnails.file_name(scene.name, dark)).read_bytes()
    return thumbnails.picture(scene.scene, dark)


# ------------------------------------------------------------------------- pages
def _live(scene: Shown, before: Shown | None, after: Shown | None) -> bytes:
    bar = Bar(_bar(scene, before, after), *_bar_parts())
    try:
        return live_html(sim.Simulation(scene.scene).capture(), bar)[0]
    except InputError as error:
        raise InputError(Text("{scene}: {error}", scene=scene.name, error=str(error))) from None


def _bar(scene: Shown, before: Shown | None, after: Shown | None) -> str:
    links = []
    if before is not None:
        inside = f"{_icon('before')}<span>{html.escape(before.title)}</span>"
        links.append(_link("before", "prev", before, say("site-before", scene=before.title), inside))
    if after is not None:
        inside = f"<span>{html.escape(after.title)}</span>{_icon('after')}"
        links.append(_link("after", "next", after, say("site-after", scene=after.title), inside))
    line = "\n"
    back, save = _icon("all") + f"<span>{said('site-all')}</span>", said("site-save")
    return f"""<nav id="bar" aria-label="{said("site-bar")}">
<a class="all" href="{INDEX}#at={scene.file}" title="{said("site-all.hint")}">{back}</a>
{line.join(links)}
<button id="save" type="button" title="{save}" aria-label="{save}"
 data-file="{_page(scene)}">{_icon("save")}</button>
</nav>"""


def _link(name: str, rel: str, to: Shown, label: str, inside: str) -> str:
    """A link of the bar to another page."""
    where = f'rel="{rel}" href="{_page(to)}"'
    return f'<a class="{name}" {where} aria-label="{html.escape(label)}">{inside}</a>'


@cache
def _bar_parts() -> tuple[str, str]:
    """The style and the script of the bar."""
    return compact_style(_FOLDER / "bar.css"), bundle(_FOLDER / "bar.js")


def _icon(name: str) -> str:
    return f'<svg class="icon" viewBox="0 0 24 24" aria-hidden="true">{_ICONS[name]}</svg>'


# ------------------------------------------------------------------------- index
def _index(scenes: Sequence[Shown], title: str) -> bytes:
    groups = [(group, list(members)) for group, members in groupby(scenes, lambda scene: scene.group)]
    jumps = "".join(
        f'<a href="#{_anchor(group)}">{html.escape(group)} <small>{len(members)}</small></a>'
        for group, members in groups
    )
    sections = "\n".join(
        f'<section id="{_anchor(group)}" aria-labelledby="{_anchor(group)}-title">\n'
        f'<h2 id="{_anchor(group)}-title">{html.escape(group)}</h2>\n<ul class="softrod-cards">\n'
        + "\n".join(map(_card, members))
        + "\n</ul>\n</section>"
        for group, members in groups
    )
    count, find, dark = say("site-count", count=len(scenes)), said("site-find"), said("site-dark")
    body = f"""<header>
<h1>{html.escape(title)}</h1>
<p>{said("site-about")}</p>
</header>
<div id="tools">
<input id="search" class="softrod-search" type="search" placeholder="{find}" aria-label="{find}"
 autocomplete="off" aria-keyshortcuts="/">
<output id="count" for="search">{html.escape(count)}</output>
<button id="dark" type="button" title="{dark}" aria-label="{dark}">{_icon("dark")}</button>
<nav aria-label="{said("site-groups")}">{jumps if len(groups) > 1 else ""}</nav>
</div>
<main>
<p id="none" role="status"></p>
{sections}
</main>
<footer>{said("site-made")} <span id="kept" role="status"></span></footer>"""
    searched = [
        {"name": one.name, "file": one.file, "title": one.title, "text": one.text, "group": one.group}
        for one in scenes
    ]
    style = f"{style_rules(DARK)}\n{compact_style(_CARDS, _FOLDER / 'index.css')}"
    script = bundle(_FOLDER / "index.js")
    return document(
        title,
        body,
        [style],
        [script],
        {"scenes": searched},
        early_script(),
        images="'self' data:",
        plain="#tools>:not(nav){display:none}",
        of_site=True,
    )


def _anchor(group: str) -> str:
    return "group-" + re.sub(r"[^a-z]+", "-", group.lower())


def _card(scene: Shown) -> str:
    """A card. Its id is what follows `#` in a link that leads back to it, so that it needs no script."""
    width, height = thumbnails.SIZE
    images = "".join(
        f'<img class="{name}" src="{_picture(scene, name == "dark")}" width="{width}" height="{height}" '
        'alt="" loading="lazy">'
        for name in ("light", "dark")
    )
    id = f"at={scene.file}"
    return (
        f'<li class="softrod-card"><a class="softrod-open" id="{id}" href="{_page(scene)}" '
        f'aria-labelledby="{id}-title" aria-describedby="{id}-line">'
        f'{images}<b id="{id}-title">{html.escape(scene.title)}</b>'
        f'<span id="{id}-line">{html.escape(scene.line)}</span></a></li>'
    )
