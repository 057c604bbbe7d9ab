"""The gallery on the server's side, and the pictures of the presets."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import Literal

import msgspec
import numpy as np
import pytest
from PIL import Image

import sim
from app.classroom import live
from app.classroom.live import Classes
from app.features.classroom.roles import desk_address
from app.features.gallery import gallery, thumbnails
from app.features.gallery.gallery import Gallery
from app.features.gallery.messages import (
    ChangeScene,
    ListScenes,
    OpenScene,
    SceneChanged,
    ScenePictures,
    Scenes,
    UsedInClass,
    UseInClass,
)
from app.pages.sandbox.assets import page_files
from app.session.notices import Notice
from app.stage.plan import Picture
from app.ui import owner, shelf
from app.ui.shelf import Shelf
from app.wire.from_page import Who
from sim.store import files
from tests.app.letters import Letters
from tests.app.pages import SessionPage
from tests.app.panels import page_of

MAX_BYTES = 300_000


class Page(SessionPage):
    """A session with its gallery."""

    def __init__(self, owned: bool = True) -> None:
        super().__init__("ring")
        self.letters, self.notices = Letters(), list[Notice]()
        self.page = page_of(self.session, None, self.letters, self.notices.append, owned)
        self.gallery = Gallery(self.page)


# ------------------------------------------------------------------------- pictures
def test_the_pictures_are_of_the_presets_as_they_are() -> None:
    known = msgspec.json.decode(thumbnails.DIGESTS.read_bytes())
    assert known == thumbnails.digests(), "run: python -m app.features.gallery.thumbnails"


def test_every_preset_has_two_small_pictures() -> None:
    size = 0
    for name in thumbnails.digests():
        for dark in (False, True):
            path = thumbnails.FOLDER / thumbnails.file_name(name, dark)
            size += path.stat().st_size
            with Image.open(path) as image:
                assert image.size == thumbnails.SIZE
                # It shows something.
                assert len(np.unique(np.asarray(image.convert("L")))) > 20
                light = image.getpixel((2, 2))
                assert isinstance(light, tuple)
                assert (sum(light) < 300) == dark
    assert size < MAX_BYTES
    assert any(path.endswith("/thumbnails/ring-dark.webp") for path in page_files())


def test_a_picture_is_of_where_the_masses_are() -> None:
    scene = sim.load_scene("rod")
    still, moved = thumbnails.picture(scene, False), sim.Simulation(scene)
    moved.advance(0.5)
    assert thumbnails.picture(scene, False, Picture.of(moved)) != still
    with Image.open(io.BytesIO(still)) as image:
        assert image.format == "WEBP"


# ------------------------------------------------------------------------- the server's side
def test_what_is_listed_opens_and_nothing_else(home: Path, tmp_path: Path) -> None:
    page = Page()
    files.save_user_scene(sim.rope(masses=5), "mine")
    sim.save_scene(sim.rope(masses=7), tmp_path / "elsewhere.json")
    page.gallery.open(OpenScene(name="mine"))
    page.frames(1)
    assert len(page.session.scene.masses) == 5
    for name in (str(tmp_path / "elsewhere.json"), "../elsewhere", "http://x/s#1.AAAA", "nothing"):
        page.gallery.open(OpenScene(name=name))
        page.frames(1)
        assert "there is no scene called" in page.notices.pop().text
    assert len(page.session.scene.masses) == 5


def test_the_list_has_all_scenes_and_own_ones_are_painted_once(
    home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files.save_user_scene(sim.rope(), "mine")
    (home / "broken.json").write_text("{")
    page = Page()
    page.gallery.list(ListScenes(dark=True))
    listed, painted = page.letters.sent
    names = [entry.name for entry in listed.scenes]
    assert {"ring", "mine", "study-w1"} <= set(names)
    assert "broken" not in names
    assert listed.present == "ring"
    assert list(painted.pictures) == ["mine"]
    assert painted.pictures["mine"].startswith("data:image/webp;base64,")
    monkeypatch.setattr(thumbnails, "picture", lambda *_: pytest.fail("painted again"))
    page.gallery.list(ListScenes(dark=True))
    assert page.letters.sent[-1] == painted
    assert gallery.painted.cache_parameters()["maxsize"] is not None


def test_the_folder_is_read_once_for_a_list_however_many_scenes_were_just_saved(
    home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(3):
        files.save_user_scene(sim.rope(), f"mine {number}")
    page, counted = Page(), list[int]()

    def counting(list_scenes: Callable[[], list[files.SceneInfo]] = sim.list_scenes) -> list[files.SceneInfo]:
        counted.append(1)
        return list_scenes()

    monkeypatch.setattr(sim, "list_scenes", counting)
    page.gallery.list(ListScenes(dark=False))
    assert len(page.letters.last(ScenePictures).pictures) == 3
    assert len(counted) == 1


def test_what_is_done_is_said_and_can_be_undone(home: Path) -> None:
    files.save_user_scene(sim.rope(), "mine")
    page = Page()
    page.gallery.change(ChangeScene(how="delete", name="mine"))
    letter = page.letters.last(SceneChanged)
    assert letter.text == "'mine' is deleted."
    page.gallery.change(ChangeScene(how="restore", name=letter.undo))
    assert page.letters.last(SceneChanged).text == "'mine' is back."
    assert not page.letters.last(SceneChanged).undo
    page.gallery.change(ChangeScene(how="duplicate", name="mine"))
    page.gallery.change(ChangeScene(how="rename", name="mine 2", to="ring"))
    assert "built-in" in page.letters.last(SceneChanged).text
    assert sorted(path.stem for path in home.glob("*.json")) == ["mine", "mine 2"]
    # A preset cannot be deleted.
    page.gallery.change(ChangeScene(how="delete", name="ring"))
    assert "built-in" in page.letters.last(SceneChanged).text
    assert files.load_scene("ring")


# ------------------------------------------------------------------------- whose scenes they are
def visitor(digit: str, key: str = "") -> Page:
    """The gallery of somebody else's browser."""
    page = Page(owned=False)
    page.page.shelf.introduce(Who(visitor=32 * digit, owner=key))
    return page


def listed(page: Page) -> dict[str, tuple[str, str, bool]]:
    """Title, group and whether it is its own, of each scene that is saved."""
    page.gallery.list(ListScenes(dark=False))
    letter = page.letters.last(Scenes)
    page.letters.sent.clear()
    return {e.name: (e.title, e.group, e.own) for e in letter.scenes if e.saved}


def said(page: Page, how: Literal["rename", "duplicate", "delete", "restore"], name: str) -> str:
    page.gallery.change(ChangeScene(how=how, name=name, to="other"))
    return str(page.letters.last(SceneChanged).text)


def test_a_visitor_opens_and_copies_the_owner_s_scenes_and_changes_none(home: Path) -> None:
    files.save_user_scene(sim.rope(masses=5), "mine")
    page = visitor("a")
    assert listed(page) == {"shared/mine": ("mine", "Saved on this computer", False)}
    before = (home / "mine.json").read_bytes()
    for name in ("mine", "shared/mine"):
        said(page, "rename", name)
        said(page, "delete", name)
    assert sorted(path.name for path in home.iterdir()) == ["mine.json"]
    assert (home / "mine.json").read_bytes() == before
    page.gallery.open(OpenScene(name="shared/mine"))
    page.frames(1)
    assert len(page.session.scene.masses) == 5
    assert said(page, "duplicate", "shared/mine") == "The copy is called 'mine'."
    assert listed(page)["mine"] == ("mine", "Your own", True)
    assert said(page, "delete", "mine") == "'mine' is deleted."
    page.gallery.change(ChangeScene(how="restore", name=page.letters.last(SceneChanged).undo))
    assert "mine" in listed(page)
    assert len(sim.load_scene("mine").masses) == 5
    # Neither another visitor nor the owner has it.
    assert list(listed(visitor("b"))) == ["shared/mine"]
    assert list(listed(Page())) == ["mine"]
    assert listed(visitor("a")).keys() == {"shared/mine", "mine"}


def test_a_page_with_the_owner_s_key_is_the_owner_s(home: Path) -> None:
    files.save_user_scene(sim.rope(), "mine")
    page = visitor("a", owner.key())
    assert listed(page)["mine"] == ("mine", "Your own", True)
    assert said(page, "delete", "mine") == "'mine' is deleted."
    assert not list(home.glob("*.json"))
    assert owner.key_path().stat().st_mode & 0o077 == 0
    assert not visitor("a", "guess").page.shelf.owned
    owner.key_in.cache_clear()
    assert visitor("b", owner.key_path().read_text()).page.shelf.owned


def test_a_page_that_has_not_said_whose_it_is_changes_nothing(home: Path) -> None:
    files.save_user_scene(sim.rope(), "mine")
    page = Page(owned=False)
    assert "has not identified" in said(page, "delete", "mine")
    assert list(listed(page)) == ["shared/mine"]
    assert (home / "mine.json").exists()


def test_what_visitors_save_is_bounded(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shelf, "MAX_SCENES", 2)
    one = visitor("a").page.shelf
    for name in ("x", "y", "y"):
        one.save(sim.rope(), name)
    with pytest.raises(sim.SceneError, match="you have 2 scenes here"):
        one.save(sim.rope(), "z")
    monkeypatch.setattr(shelf, "MAX_BYTES", files.MAX_FILE_BYTES + 100)
    with pytest.raises(sim.SceneError, match="no room"):
        visitor("b").page.shelf.save(sim.rope(), "x")
    Shelf(owned=True).save(sim.rope(), "z")
    assert [path.name for path in home.glob("*.json")] == ["z.json"]


def test_each_picture_is_sent_once_and_none_can_be_lost(home: Path) -> None:
    for number in range(20):
        files.save_user_scene(sim.rope(masses=3), f"mine {number}")
    page = Page()
    page.gallery.list(ListScenes(dark=False))
    letters = [letter for letter in page.letters.sent if isinstance(letter, ScenePictures)]
    assert len(letters) == 3
    assert len(set(page.letters.keys)) == len(page.letters.keys)
    sent = [name for letter in letters for name in letter.pictures]
    assert len(sent) == len(set(sent)) == 20


# ------------------------------------------------------------------------- in a class
def test_a_card_begins_a_class_where_others_reach_the_server_and_says_the_command_elsewhere(
    home: Path,
) -> None:
    page, ask = Page(), UseInClass("lesson-hooke")
    page.gallery.use_in_class(ask)
    assert page.letters.sent == [UsedInClass(address="", command="softrod class lesson-hooke")]
    classes = Classes(alone=False)
    page.page.begin_class = lambda scene: desk_address("", classes.begin((scene,)))
    page.gallery.use_in_class(ask)
    assert not list(classes)  # until it is the ticker's turn
    page.page.serve()
    (classroom,) = classes
    assert classroom.room.scenes[0].lesson is not None
    told = page.letters.sent[-1]
    assert isinstance(told, UsedInClass)
    assert told.address == f"?room={classroom.room.code}&as=desk#teacher={classroom.room.key}"
    # No path of a file is one of the scenes that are listed.
    page.gallery.use_in_class(UseInClass("../owner-key"))
    assert "no scene called" in page.notices[-1].text


def test_only_the_owner_begins_a_class(home: Path) -> None:
    page = Page(owned=False)
    page.page.begin_class = lambda _: pytest.fail("a visitor has begun a class")
    page.gallery.use_in_class(UseInClass("lesson-hooke"))
    page.page.serve()
    assert not page.letters.sent
    page.gallery.list(ListScenes(dark=False))
    assert not next(told for told in page.letters.sent if isinstance(told, Scenes)).teaches


def test_a_server_holds_so_many_classes(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page, classes = Page(), Classes(alone=False)
    page.page.begin_class = lambda scene: desk_address("", classes.begin((scene,)))
    monkeypatch.setattr(live, "MAX_CLASSES", 1)
    for _ in range(2):
        page.gallery.use_in_class(UseInClass("lesson-hooke"))
        page.page.serve()
    assert len(list(classes)) == 1
    assert page.notices[-1].text == "A server holds 1 classes at most."
