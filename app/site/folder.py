"""The folder of a gallery: files are written to a subfolder first, then moved, and no other file is touched.

`softrod-gallery.json` says which files are the gallery's. Whatever else is in the folder stays as it is.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
from collections.abc import Callable, Collection, Iterable
from pathlib import Path
from typing import Annotated, Literal

import msgspec

from sim.errors import InputError
from sim.store.files import write_file

MARKER, INDEX = "softrod-gallery.json", "index.html"

_ASIDE = ".softrod-new"
"""The folder, inside of the gallery's, where its files are until all of them are there."""

_OWN = (
    r"^([a-z0-9][a-z0-9.-]*\.html|pictures/(light|dark)/[a-z0-9][a-z0-9.-]*\.webp"
    r"|manifest\.json|offline\.js|icon-\d+\.png)\Z"
)
"""What a gallery's files are called: a forged list deletes nothing but such files inside of the folder."""


class Marker(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the marker says.

    Attributes:
        format: that it is one.
        files: paths inside of the folder.
        version: of the format.
    """

    format: Literal["softrod-gallery"]
    files: tuple[Annotated[str, msgspec.Meta(pattern=_OWN)], ...]
    version: Literal[1] = 1


class Folder:
    """The folder of a gallery, which need not exist yet.

    Args:
        path: of the folder.
        files: paths inside of it of all that is to be written, the index among them.

    Raises:
        InputError: it cannot be one, or something else would be lost; nothing was changed.
    """

    def __init__(self, path: Path, files: Collection[str]) -> None:
        self._path, self._files = path, frozenset(files)
        assert INDEX in files
        assert all(re.match(_OWN, file) for file in files)
        try:
            self._old = self._present()
            taken = sorted(file for file in self._files - self._old if os.path.lexists(path / file))
        except OSError as error:
            raise self._cannot(error) from None
        if taken:
            raise InputError(
                f"--out {path}: {taken[0]} is there, which softrod did not write; move it elsewhere first"
            )

    def _present(self) -> frozenset[str]:
        """The files of the gallery that is there."""
        path = self._path
        if not path.exists():
            if not path.parent.is_dir():
                raise InputError(f"--out {path}: the folder {path.parent} does not exist")
            return frozenset()
        if not path.is_dir():
            raise InputError(f"--out {path}: this is no folder")
        marker = path / MARKER
        if not marker.exists():
            if any(path.iterdir()):
                raise InputError(
                    f"--out {path}: the folder is not empty and has no gallery of softrod; name another one"
                )
            return frozenset()
        try:
            return frozenset(msgspec.json.decode(marker.read_bytes(), type=Marker).files)
        except msgspec.MsgspecError:
            raise InputError(
                f"--out {path}: {MARKER} is not as this softrod writes it, so the gallery is left as it is"
            ) from None

    def write(self, made: Iterable[tuple[str, Callable[[], bytes]]]) -> int:
        """Write all files, and return how many bytes they are.

        Until all of them are made the gallery that is there stays as it is. Then each takes its place, the
        index and the service worker last, and what only the old one had is deleted.

        Args:
            made: the path of each file, and what makes it.

        Raises:
            InputError: a file cannot be written; there is the old gallery, or, if the disk failed at the
                very end, one that another run overwrites.
        """
        path, aside = self._path, self._path / _ASIDE
        is_new, is_marked = not path.exists(), (path / MARKER).exists()
        size = 0
        try:
            path.mkdir(exist_ok=True)
            # So that a run that is cut off leaves a folder that another one takes.
            if not is_marked:
                self._mark(())
            shutil.rmtree(aside, ignore_errors=True)
            aside.mkdir()
            for file, make in made:
                data = make()
                _write(aside / file, data)
                size += len(data)
            self._mark(self._old | self._files)
            for file in sorted(self._files, key=lambda name: (name.endswith(".js"), name == INDEX)):
                (path / file).parent.mkdir(parents=True, exist_ok=True)
                (aside / file).replace(path / file)
            for file in self._old - self._files:
                (path / file).unlink(missing_ok=True)
            self._mark(self._files)
        except OSError as error:
            raise self._cannot(error) from None
        finally:
            shutil.rmtree(aside, ignore_errors=True)
            if not is_marked:
                self._clean_up(is_new)
        return size

    def _clean_up(self, is_new: bool) -> None:
        """Remove what a failed first run has left: the marker, and the folder if it is new."""
        with contextlib.suppress(OSError):
            if [entry.name for entry in self._path.iterdir()] == [MARKER]:
                (self._path / MARKER).unlink()
                if is_new:
                    self._path.rmdir()

    def _mark(self, files: Iterable[str]) -> None:
        marker = Marker("softrod-gallery", tuple(sorted(files)))
        write_file(self._path / MARKER, msgspec.json.format(msgspec.json.encode(marker)) + b"\n")

    def _cannot(self, error: OSError) -> InputError:
        return InputError(f"--out {self._path}: it cannot be written ({error.strerror or error})")


def _write(path: Path, data: bytes) -> None:
    """Write a file, with its folder, so that it is on the disk."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
