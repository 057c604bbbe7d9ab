"""`softrod link`: prints a scene as a link."""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from typing import Annotated

import msgspec
import segno
from tyro.conf import Positional, arg

from sim.errors import InputError
from sim.scene.types import Scene
from sim.store.files import built_in_files, read_scene
from sim.store.link import PATH, pack_scene
from sim.store.shared import share_scene

from .command import Settings, fail, scene_of

ADDRESS = "http://127.0.0.1:8080"
"""Of the page that softrod serves on this machine by default."""


@dataclass
class Link:
    """Print a link that holds a scene, which any page of softrod opens."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")]
    """A preset's name, a file's path or another link."""
    pose: bool = False
    """Keep the pose that was saved with the scene."""
    address: str = ADDRESS
    """Of the page that is to open it."""
    short: bool = False
    """Print a short address instead, for pages of this machine: of a preset by its name, of any other scene
    by a code under which this machine keeps it."""
    qr: bool = False
    """Print its QR code, too."""
    settings: Settings = ()

    def run(self) -> int:
        """Print it."""
        scene = scene_of(self.scene, self.settings)
        if not self.pose:
            scene = msgspec.structs.replace(scene, pose=None)
        address = self.address.rstrip("/")
        if not re.fullmatch(r"https?://[^\s/?#]+(/[^\s/?#]+)*", address):
            return fail(
                f"--address: {self.address!r} is not the address of a page, as in http://127.0.0.1:8080"
            )
        text = short_address(f"{address}/", scene) if self.short else link_to(scene, address)
        print(text)
        if self.qr:
            print_qr_code(text)
        return 0


def link_to(scene: Scene, address: str = ADDRESS) -> str:
    """A link that holds a scene, with its pose if it has one.

    Args:
        scene: the scene.
        address: of the page that is to open it, without a slash at its end.

    Raises:
        SceneError: the scene is not valid, or too large for a link.
    """
    return f"{address}{PATH}#{pack_scene(scene)}"


def short_address(base: str, scene: Scene) -> str:
    """An address of a scene on this machine: a preset by its name, any other by the code it is stored under.

    Args:
        base: the page's address, with a slash at its end.

    Raises:
        SceneError: the scene cannot be stored.
    """
    if _is_preset(scene):
        return f"{base}?scene={scene.name}"
    return f"{base}?s={share_scene(scene)}"


def _is_preset(scene: Scene) -> bool:
    """Whether a scene is an unchanged preset."""
    path = next((path for path in built_in_files() if path.stem == scene.name), None)
    return path is not None and read_scene(path) == scene


def print_qr_code(text: str) -> None:
    """Print a QR code in the terminal.

    Raises:
        InputError: the text is too long for one, or the terminal lacks its blocks.
    """
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    try:
        "█▀▄".encode(encoding)
    except UnicodeEncodeError:
        raise InputError(
            f"--qr: the terminal's encoding, {encoding}, lacks the blocks of a QR code"
        ) from None
    try:
        code = segno.make(text, error="l", micro=False)
    except segno.DataOverflowError:
        size = f"a link of {len(text)} characters is too long for a QR code"
        raise InputError(f"--qr: {size}; --short makes a short address") from None
    code.terminal(compact=True)
