"""`softrod link`: a scene as a link."""

from __future__ import annotations

import re
import sys
from dataclasses import dataclass
from typing import Annotated

import msgspec
import segno
from tyro.conf import Positional, arg

from sim.scene.link import PATH, pack_scene

from .command import Settings, fail, scene_of


@dataclass
class Link:
    """Print a link that holds a scene, which any page of softrod opens."""

    scene: Annotated[Positional[str], arg(metavar="SCENE")]
    """A preset's name, a file's path or another link."""
    pose: bool = False
    """Keep the pose that was saved with the scene."""
    address: str = "http://127.0.0.1:8080"
    """Of the page that is to open it."""
    qr: bool = False
    """Print its QR code, too."""
    settings: Settings = ()

    def run(self) -> int:
        """Print it."""
        scene = scene_of(self.scene, self.settings)
        if not self.pose:
            scene = msgspec.structs.replace(scene, pose=None)
        address = self.address.rstrip("/")
        if not re.fullmatch(r"https?://[^\s/?#]+", address):
            return fail(
                f"--address: {self.address!r} is not the address of a page, as in http://127.0.0.1:8080"
            )
        text = f"{address}{PATH}#{pack_scene(scene)}"
        print(text)
        if self.qr:
            encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
            try:
                "█▀▄".encode(encoding)
            except UnicodeEncodeError:
                return fail(f"--qr: the terminal's encoding, {encoding}, lacks the blocks of a QR code")
            try:
                segno.make(text, error="l", micro=False).terminal(compact=True)
            except segno.DataOverflowError:
                return fail(f"--qr: a link of {len(text)} characters is too long for a QR code")
        return 0
