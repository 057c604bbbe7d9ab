"""`softrod gallery`: scenes as a site, for a folder that any server or none shows."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from rich.console import Console
from rich.progress import Progress
from tyro.conf import Positional, arg

from sim.errors import InputError

from ..command import Lang, spoken
from ..words import ENGLISH, speaking


@dataclass
class MakeGallery:
    """Write scenes as a site that needs no server: an index with pictures, and a page for each, in which the
    body moves and is dragged."""

    scenes: Annotated[Positional[tuple[str, ...]], arg(metavar="SCENE")] = ()
    """Presets by their names, saved scenes, files or links; all presets unless any is named."""
    out: Path | None = None
    """The folder to write; a gallery that is there is replaced, and nothing else in the folder is touched."""
    own: bool = False
    """Add all scenes that you have saved."""
    title: str = ""
    """Of the index."""
    lang: Lang = ENGLISH

    def run(self) -> int:
        """Make and write them.

        Raises:
            InputError, SceneError: it cannot be done; a gallery that is there stays as it is.
        """
        if self.out is None:
            raise InputError("--out: name the folder to write")
        with speaking(spoken(self.lang)):
            return self._write(self.out)

    def _write(self, out: Path) -> int:
        from .entries import shown
        from .folder import INDEX, Folder
        from .pages import files

        start = time.perf_counter()
        scenes = shown(self.scenes, self.own)
        made = files(scenes, self.title.strip())
        folder = Folder(out, made)
        console = Console(stderr=True)
        with Progress(console=console, transient=True, disable=not console.is_terminal) as progress:
            size = folder.write(progress.track(made.items(), description="making pages"))
        count = f"{len(scenes)} {'scene' if len(scenes) == 1 else 'scenes'}"
        seconds = time.perf_counter() - start
        print(f"{out / INDEX}: {count}, {size / 1e6:.1f} MB, in {seconds:.1f} s")
        return 0
