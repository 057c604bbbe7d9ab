"""`softrod gallery`: what it writes holds together, keeps to its folder, and loses nothing that is there."""

from __future__ import annotations

import hashlib
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace
from PIL import Image

import sim
from app.export.body.program import unknown_forces
from app.site import pages
from app.site.entries import shown
from app.site.folder import MARKER, Folder
from app.site.install import ICONS, MANIFEST, WORKER
from app.words import PSEUDO, speaking
from sim.store import files
from sim.store.link import pack_scene
from tests.app.command import Softrod, refused
from tests.app.html_pages import WICKED, Page, held, plain_texts


def read(path: Path) -> Page:
    return Page(path.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def presets(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The gallery of all presets."""
    out = tmp_path_factory.mktemp("gallery") / "site"
    made = pages.files(shown((), own=False), "")
    Folder(out, made).write(made.items())
    return out


def make(softrod: Softrod, out: Path, *words: str | Path) -> None:
    result = softrod("gallery", "--out", out, *words)
    assert result.returncode == 0, result.stderr


def found(folder: Path) -> set[str]:
    """The files of a folder, hidden ones as well."""
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def check_links(folder: Path, whole: bool = True) -> None:
    """Every address of every page leads to a file of the folder, and in a whole one to a place in it."""
    for path in folder.glob("*.html"):
        for address in read(path).addresses:
            if address.startswith(("data:image/svg+xml,", "data:image/webp;")):
                continue
            file, _, anchor = address.partition("#")
            assert re.fullmatch(r"[a-z0-9./-]*", file), address
            target = folder / file if file else path
            assert target.is_file(), (path.name, address)
            if anchor and whole:
                assert anchor in read(target).ids, (path.name, address)


# ------------------------------------------------------------------------- all presets
def test_all_presets_are_there_in_the_order_of_the_page_and_every_link_leads_somewhere(presets: Path) -> None:
    check_links(presets)
    found = {path.stem: sim.load_scene(path.stem) for path in files.built_in_files()}
    names = [name for name, scene in found.items() if name != "empty" and not unknown_forces(scene)]
    assert {"cradle", "bungee", "cart", "kapitza", "crane", "buggy", "hopper", "stick-slip"} <= set(names)
    index = read(presets / "index.html")
    cards = [id.removeprefix("at=") for id in index.ids if re.fullmatch(r"at=.*(?<!-title)(?<!-line)", id)]
    assert sorted(cards) == sorted(names)
    assert cards[:3] == ["rope", "pile", "water-balloon"]
    assert cards.index("lesson-hooke") < cards.index("lesson-chaos") < cards.index("air-balloon")
    assert {path.stem for path in presets.glob("*.html")} == {*names, "index"}
    titles = {read(presets / f"{name}.html").parts["h1"][0].strip() for name in names}
    assert titles == {title.strip() for title in index.parts["b"]}
    # From each page one gets to the next, and to the card that one came by.
    for before, name, after in zip(cards, cards[1:], cards[2:], strict=False):
        addresses = read(presets / f"{name}.html").addresses
        assert {f"index.html#at={name}", f"{before}.html", f"{after}.html"} <= set(addresses)


def test_pictures_show_something_and_all_of_it_is_small(presets: Path) -> None:
    for name in ("rope", "pile", "study-w4"):
        for kind in ("light", "dark"):
            with Image.open(presets / "pictures" / kind / f"{name}.webp") as image:
                assert image.format == "WEBP"
                pixel = image.convert("RGB").getpixel((2, image.size[1] - 3))
                assert isinstance(pixel, tuple)
                assert (sum(pixel) < 300) == (kind == "dark")
    sizes = {
        str(path.relative_to(presets)): path.stat().st_size for path in presets.rglob("*") if path.is_file()
    }
    pages = [size for name, size in sizes.items() if name.endswith(".html") and name != "index.html"]
    assert max(pages) < 250_000
    assert sizes["index.html"] < 88_000
    assert sum(sizes.values()) < 194_000 * len(pages)


def test_each_page_may_load_nothing_and_run_nothing_but_its_scripts(presets: Path) -> None:
    for path in presets.glob("*.html"):
        read(path).check_policy("'self' data:" if path.name == "index.html" else "data:", of_site=True)


def test_the_worker_names_each_file_by_what_is_in_it_and_is_the_last_that_is_written(presets: Path) -> None:
    digests = json.loads(
        (presets / WORKER).read_text().split("\n")[0].removeprefix("self.FILES=").rstrip(";")
    )
    assert digests.keys() == found(presets) - {MARKER, WORKER}
    for path, digest in digests.items():
        assert hashlib.sha256((presets / path).read_bytes()).hexdigest() == digest
    assert list(pages.files(shown(("ring",), own=False), ""))[-1] == WORKER


def test_an_icon_is_the_page_s_and_may_be_cut_to_a_circle(presets: Path) -> None:
    for file, size in ICONS.items():
        with Image.open(presets / file) as image:
            assert image.size == (size, size)
            pixels = np.asarray(image.convert("RGB")).astype(int)
        drawn = np.argwhere((pixels != 255).any(axis=2)) - (size - 1) / 2.0
        assert 0.25 * size < np.hypot(*drawn.T).max() < 0.4 * size
        last = round(size * (0.5 + 0.62 * (26.0 / 32.0 - 0.5)))
        assert tuple(pixels[last, last]) == (0xFB, 0xBF, 0x24)


# ------------------------------------------------------------------------- what is shown
def test_named_scenes_files_links_and_the_shelf(home: Path, tmp_path: Path, softrod: Softrod) -> None:
    files.save_user_scene(sim.rope(masses=5), "mine")
    files.save_user_scene(sim.rope(masses=6), "other")
    sim.save_scene(replace(sim.load_scene("ring"), title="A ring of ours"), tmp_path / "Größe 1.json")
    link = f"http://127.0.0.1:8080/s#{pack_scene(replace(sim.load_scene('box'), name='linked', title=''))}"
    out = tmp_path / "site"
    make(softrod, out, "ring", tmp_path / "Größe 1.json", link, "mine")
    assert {path.name for path in out.glob("*.html")} == {
        "index.html", "ring.html", "groe-1.html", "linked.html", "mine.html",
    }  # fmt: skip
    index = read(out / "index.html")
    assert index.parts["b"] == ["A ring of ours", "linked", "mine", sim.load_scene("ring").title]
    check_links(out)
    make(softrod, out, "ring", "--own", "--title", "Class <3>")
    assert {path.name for path in out.glob("*.html")} == {
        "index.html", "ring.html", "mine.html", "other.html",
    }  # fmt: skip
    assert len(list(out.rglob("*.webp"))) == 6
    assert read(out / "index.html").parts["h1"] == ["Class <3>"]
    assert read(out / "index.html").parts["title"] == ["Class <3>"]
    check_links(out)


def test_scenes_of_one_name_are_refused_and_files_of_one_name_told_apart(
    tmp_path: Path, softrod: Softrod
) -> None:
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        sim.save_scene(sim.load_scene("ring"), tmp_path / folder / "x.json")
    out = tmp_path / "site"
    both = [tmp_path / folder / "x.json" for folder in ("a", "b")]
    refused(softrod("gallery", "--out", out, *both), "two scenes are called 'x'")
    refused(softrod("gallery", "--out", out, "ring", "ring"), "two scenes are called 'ring'")
    assert not out.exists()
    names = ["index", "日本", "中国", "con", "X y", "x!y", "..", "a" * 90, "pictures", "nul.x", ".hidden"]
    for name in names:
        sim.save_scene(sim.load_scene("ring"), tmp_path / f"{name}.json")
    make(softrod, out, *(tmp_path / f"{name}.json" for name in names))
    written = sorted(path.stem for path in out.glob("*.html"))
    assert len(set(map(str.casefold, written))) == len(names) + 1
    assert all(re.fullmatch(r"[a-z0-9][a-z0-9.-]{0,65}", stem) for stem in written)
    assert not {"con", "nul.x", "scene-index.html"} & set(written)
    check_links(out)
    # All have the title of the preset, so their cards say which is which.
    titles = read(out / "index.html").parts["b"]
    assert len(set(titles)) == len(names)


def test_hostile_texts_show_as_text(tmp_path: Path, softrod: Softrod) -> None:
    scene = replace(
        sim.load_scene("ring"), title=WICKED[:60], description=f"{WICKED} Two. {WICKED}", name="x"
    )
    out = tmp_path / "site"
    for name in ("x' onclick=alert(1) '", "javascript:alert(1)"):
        sim.save_scene(scene, tmp_path / f"{name}.json")
    make(softrod, out, *sorted(tmp_path.glob("*.json")), "--title", WICKED)
    check_links(out)
    for path in out.glob("*.html"):
        page = read(path)  # which looks for handlers
        assert page.parts["title"] == [WICKED if path.stem == "index" else WICKED[:60]]
        assert page.parts["h1"] == page.parts["title"]
        assert "alert(1)" not in "".join(page.parts["script"])
        assert page.tags.count("img") == (4 if path.stem == "index" else 1)  # where scripts do not run
    assert WICKED in held((out / "index.html").read_text(), "scenes")[0]["text"]


def test_a_gallery_is_in_one_language(tmp_path: Path, softrod: Softrod) -> None:
    out = tmp_path / "site"
    make(softrod, out, "ring", "--lang", "de")
    for path in out.glob("*.html"):
        assert '<html lang="de">' in path.read_text(encoding="utf-8")
    assert read(out / "index.html").parts["h1"] == ["Seile und weiche Körper"]
    refused(softrod("gallery", "--out", out, "--lang", "xx"), "--lang xx: softrod speaks en (English)")
    with speaking(PSEUDO):
        scenes = shown(("ring", "rope"), own=False)
        made = pages.files(scenes, "")
        own = {text for one in scenes for text in (one.title, one.line, one.group, one.scene.description)}
        for name in ("index.html", "ring.html"):
            assert plain_texts(made[name]().decode()) <= own


# ------------------------------------------------------------------------- the folder
def test_a_folder_that_is_no_gallery_is_left_alone(tmp_path: Path, softrod: Softrod) -> None:
    refused(softrod("gallery", "ring"), "--out: name the folder")
    refused(softrod("gallery", "--out", tmp_path / "no" / "where", "ring"), "does not exist")
    file = tmp_path / "file"
    file.write_text("mine")
    refused(softrod("gallery", "--out", file, "ring"), "is no folder")
    full = tmp_path / "full"
    full.mkdir()
    (full / "index.html").write_text("mine")
    refused(softrod("gallery", "--out", full, "ring"), "is not empty and has no gallery")
    assert found(full) == {"index.html"}
    (full / MARKER).write_text('{"format": "softrod-gallery", "version": 1, "files": ["../file"]}')
    refused(softrod("gallery", "--out", full, "ring"), MARKER, "left as it is")
    assert file.read_text() == (full / "index.html").read_text() == "mine"
    refused(softrod("gallery", "--out", tmp_path / "new", "nothing-like-it"), "no scene called")
    broken = tmp_path / "broken.json"
    broken.write_text("{")
    refused(softrod("gallery", "--out", tmp_path / "new", broken), "not a JSON file")
    assert not (tmp_path / "new").exists()


def test_a_gallery_is_replaced_and_nothing_else_is_touched(tmp_path: Path, softrod: Softrod) -> None:
    out = tmp_path / "site"
    out.mkdir()
    make(softrod, out, "ring", "rope")
    (out / "notes.txt").write_text("mine")
    (out / ".git").mkdir()
    (out / ".git" / "HEAD").write_text("mine")
    (out / "pictures" / "mine.png").write_text("mine")
    make(softrod, out, "ring", "box")
    own = {"index.html", "ring.html", "box.html", MARKER, MANIFEST, WORKER, *ICONS}
    own |= {f"pictures/{kind}/{name}.webp" for kind in ("light", "dark") for name in ("ring", "box")}
    assert found(out) == own | {"notes.txt", ".git/HEAD", "pictures/mine.png"}
    (out / "rope.html").write_text("mine")
    before = (out / "index.html").read_bytes()
    refused(softrod("gallery", "--out", out, "rope"), "rope.html is there", "move it")
    assert (out / "rope.html").read_text() == "mine"
    assert (out / "index.html").read_bytes() == before


def test_a_gallery_that_fails_on_the_way_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, softrod: Softrod
) -> None:
    out, new, empty = tmp_path / "site", tmp_path / "new", tmp_path / "empty"
    empty.mkdir()
    make(softrod, out, "ring", "rope")
    before = {path: (out / path).read_bytes() for path in found(out)}

    opened = Path.open

    def full(path: Path, mode: str = "r", *options: Any, **more: Any) -> Any:
        if path.name == "index.html" and "w" in mode:
            raise OSError(28, "No space left on device")
        return opened(path, mode, *options, **more)

    monkeypatch.setattr(Path, "open", full)
    for folder in (out, new, empty):
        refused(softrod("gallery", "--out", folder, "box"), "cannot be written (No space left")
    assert {path: (out / path).read_bytes() for path in found(out)} == before
    assert not new.exists()
    assert not found(empty)
    # A run that was killed leaves a folder that the next one takes.
    (out / ".softrod-new").mkdir()
    (out / ".softrod-new" / "half.html").write_text("<")
    monkeypatch.undo()
    make(softrod, out, "box")
    assert not (out / ".softrod-new").exists()


def test_a_disk_that_fails_while_files_take_their_places_leaves_links_that_lead_somewhere(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, softrod: Softrod
) -> None:
    out = tmp_path / "site"
    make(softrod, out, "ring", "rope")
    real = Path.replace

    def failing(path: Path, target: Path) -> Path:
        if path.name == "index.html":
            raise OSError(5, "Input/output error")
        return real(path, target)

    monkeypatch.setattr(Path, "replace", failing)
    refused(softrod("gallery", "--out", out, "ring", "box"), "cannot be written (Input/output")
    check_links(out, whole=False)
    monkeypatch.undo()
    make(softrod, out, "ring", "box")
    assert {path.name for path in out.glob("*.html")} == {"index.html", "ring.html", "box.html"}


def test_the_same_scenes_make_the_same_files(tmp_path: Path, softrod: Softrod) -> None:
    for name in ("a", "b"):
        make(softrod, tmp_path / name, "pile", "lesson-hooke")
    assert found(tmp_path / "a") == found(tmp_path / "b")
    for path in found(tmp_path / "a"):
        assert (tmp_path / "a" / path).read_bytes() == (tmp_path / "b" / path).read_bytes()
