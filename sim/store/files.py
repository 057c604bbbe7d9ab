"""Scene files: reading and writing, and the two folders that contain them.

Built-in presets ship with softrod and are never written to. The user's own scenes are in the platform's data
folder (`platformdirs`).
"""

from __future__ import annotations

import contextlib
import os
import re
import tempfile
import threading
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import platformdirs

from ..errors import InputError, SceneError, did_you_mean, of_field
from ..scene.numbers import of_python
from ..scene.sentences import in_words, sentence
from ..scene.types import BODY_FIELDS, FORMAT_VERSION, Scene
from ..scene.validate import consistent, validate
from ..text import Text
from .link import link_data, unpack
from .places import as_utf8, infinite_number, line_and_column, place_of, repeated_key, too_large

MAX_FILE_BYTES = 5_000_000
"""Largest size of a scene file that is read or written, bytes."""

_TEXT_OR_NUMBERS = re.compile(rb'"(?:[^"\\]|\\.)*"|\[\s+[-+.\deE]+(?:,\s+[-+.\deE]+)*\s+\]')
"""Matches a string, which is left unchanged, or an array of numbers, which is put on one line."""


# The umask of the process can only be read by setting it: two threads could leave each other's.
_umask_lock = threading.Lock()


@dataclass(frozen=True)
class SceneInfo:
    """One entry of `list_scenes()`.

    Attributes:
        name: of the file, without its suffix.
        title, description: of the scene.
        path: of its file.
        built_in: whether it ships with softrod.
        group: its folder of presets, such as "study", or empty.
    """

    name: str
    description: str
    path: Path
    built_in: bool
    group: str = ""
    title: str = ""


def built_in_folder() -> Path:
    """Return the folder of the presets: inside the installed package, beside it in a checkout."""
    installed = Path(__file__).parents[1] / "presets"
    return installed if installed.is_dir() else Path(__file__).parents[2] / "presets"


def built_in_files() -> list[Path]:
    """Return the presets: first those for the page, then the other groups, each in its own subfolder."""
    folder = built_in_folder()
    return [*sorted(folder.glob("*.json")), *sorted(folder.glob("*/*.json"))]


def user_folder() -> Path:
    """Return the folder of the user's own scenes; it may not exist yet."""
    return platformdirs.user_data_path("softrod", appauthor=False) / "scenes"


# ------------------------------------------------------------------------- bytes and scenes
def encode_scene(scene: Scene) -> bytes:
    """Return the scene as an indented JSON file. If it has recipes, the body that follows from them is left
    out.

    Raises:
        SceneError: the scene is not valid.
    """
    validate(scene)
    return indented_json(encode_fields(fields_of(scene)))


def indented_json(data: bytes) -> bytes:
    """Format JSON with one line per field; an array of numbers is on one line."""
    return _TEXT_OR_NUMBERS.sub(_on_one_line, msgspec.json.format(data, indent=2) + b"\n")


def fields_of(scene: Scene) -> dict[str, Any]:
    """Return the fields in a valid scene's file, by name; `encode_fields` turns them into JSON."""
    fields = {**msgspec.structs.asdict(scene), "format": FORMAT_VERSION}
    fields = {name: value for name, value in fields.items() if value is not msgspec.UNSET}
    if scene.bodies:
        for field in BODY_FIELDS:
            del fields[field]
    if scene.lesson is None:
        del fields["lesson"]
    return fields


def encode_fields(fields: Any) -> bytes:
    """Return one line of JSON for any part of a valid scene."""
    return msgspec.json.encode(fields, enc_hook=of_python)


def _on_one_line(match: re.Match[bytes]) -> bytes:
    found = match[0]
    return found if found.startswith(b'"') else b"[" + b" ".join(found[1:-1].split()) + b"]"


def decode_scene(data: bytes, source: str, places: bool = True) -> Scene:
    """Read the scene in a JSON file's bytes.

    Args:
        data: the whole file.
        source: its name in error messages, usually that of the file.
        places: whether messages give line and column.

    Raises:
        SceneError: one sentence, `source: field: reason`.
    """
    if len(data) > MAX_FILE_BYTES:
        raise SceneError(
            Text(
                "{source}: {count} bytes are more than the {most} that a scene may have",
                source=source,
                count=len(data),
                most=MAX_FILE_BYTES,
            )
        )
    try:
        data = as_utf8(data)
    except UnicodeError as error:
        why = str(error) if places else Text("this is not a JSON file")
        raise SceneError(of_field(source, why)) from None
    try:
        raw = msgspec.json.decode(data)
    except (msgspec.DecodeError, RecursionError) as error:
        if isinstance(error, msgspec.ValidationError) and (number := infinite_number(data)):
            why = too_large(number)
        else:
            why = _why_no_json(str(error), data)
        raise SceneError(of_field(source, why)) from None
    if again := repeated_key(data):
        why = Text("the key {key!r} stands twice in one object", key=again[0][:60])
        if places:
            why = Text("{error} ({place})", error=why, place=again[1])
        raise SceneError(of_field(source, why))
    if not isinstance(raw, dict):
        raise SceneError(
            Text("{source}: a scene is a JSON object, with fields such as name and masses", source=source)
        )
    version = raw.get("format")
    if isinstance(version, int) and version > FORMAT_VERSION:
        raise SceneError(
            Text(
                "{where}: version {version} is newer than {newest}, the newest that this "
                "softrod reads; a newer softrod can open it",
                where=f"{source}: format",
                version=str(version)[:20],
                newest=FORMAT_VERSION,
            )
        )
    if version == 1 and not isinstance(version, bool):
        raw = _from_format_1(raw)
    one_rope = raw.get("format", 2) == 2 and "rope" in raw and "bodies" not in raw
    if one_rope or raw.get("format") in (2, 3):
        raw = {"air_law": "tutorial", **raw, "format": FORMAT_VERSION}  # there was no other
    if one_rope:
        raw = _from_format_2(raw)
    raw = _with_present_method(raw)
    try:
        return consistent(msgspec.convert(raw, Scene))
    except msgspec.ValidationError as error:
        why = sentence(error, raw)
    except SceneError as error:
        why = str(error)
    if one_rope and isinstance(why, Text) and isinstance(where := why.parts.get("where"), str):
        why = why.with_parts(where=re.sub(r"^bodies(\[0\])?(?=\.|$)", "rope", where))
    path = re.match(r"\w[\w.\[\]]*(?=: )", why)
    if path and places and (place := place_of(data, path[0])):
        why = Text("{error} ({place})", error=why, place=place)
    raise SceneError(of_field(source, why))


_NO_NUMBER = re.compile(rb'"(?:[^"\\]|\\.)*"|(-?(?:NaN|Infinity|inf|nan)\b)')
"""Matches a text, or what some programs write for NaN and infinity."""


def _why_no_json(reason: str, data: bytes) -> str:
    """Explain why a file is not JSON."""
    if not data.strip():
        return Text("the file is empty")
    for match in _NO_NUMBER.finditer(data):
        if match[1]:
            return Text(
                "{number} is no number that JSON has ({place})",
                number=match[1].decode(),
                place=line_and_column(data, match.start(1)),
            )
    return Text("this is not a JSON file ({error})", error=_with_line(reason, data))


def _with_line(reason: str, data: bytes) -> str:
    """Explain an error in a file's JSON, giving a line instead of a byte."""
    match = re.fullmatch(r"(.*) \(byte (\d+)\)", reason)
    if match is None:
        return in_words(reason)
    return Text("{error} ({place})", error=in_words(match[1]), place=line_and_column(data, int(match[2])))


RETIRED = {"dopri5": "adams", "dop853": "adams"}
"""Methods that have been removed, and those that replace them when files are read."""


def _from_format_1(raw: dict[str, Any]) -> dict[str, Any]:
    """Convert a file of format 1, which had only the tutorial's law and symplectic Euler, to format 2."""
    integrator = raw.get("integrator", {})
    if isinstance(integrator, dict):
        integrator = {"method": "symplectic_euler", **integrator}
    return {"force_law": "tutorial", **raw, "format": 2, "integrator": integrator}


def _from_format_2(raw: dict[str, Any]) -> dict[str, Any]:
    """Turn the field `rope`, which contained the only recipe or null, into a recipe among `bodies`."""
    rope = raw["rope"]
    rest = {field: value for field, value in raw.items() if field != "rope"}
    if isinstance(rope, dict):
        rope = {"recipe": "rope", **rope}
    return {**rest, "bodies": [] if rope is None else [rope]}


def _with_present_method(raw: dict[str, Any]) -> dict[str, Any]:
    """Replace a method that has been removed."""
    integrator = raw.get("integrator")
    if isinstance(integrator, dict) and isinstance(name := integrator.get("method"), str) and name in RETIRED:
        return {**raw, "integrator": {**integrator, "method": RETIRED[name]}}
    return raw


def decode_link(data: str) -> Scene:
    """Read the scene in the data of a link, see `sim.store.link`.

    Raises:
        SceneError: one sentence that says what is wrong.
    """
    return decode_scene(unpack(data, MAX_FILE_BYTES), Text("the link"), places=False)


# ------------------------------------------------------------------------- files
def read_scene(path: Path) -> Scene:
    """Read the scene in a file.

    Raises:
        SceneError: the file cannot be read, or does not contain a valid scene.
    """
    try:
        with path.open("rb") as file:
            data = file.read(MAX_FILE_BYTES + 1)
    except (OSError, ValueError) as error:  # ValueError: not a possible file name
        reason = getattr(error, "strerror", None) or str(error)
        raise SceneError(
            Text("{path!r}: the file cannot be read ({reason})", path=str(path), reason=reason)
        ) from None
    if len(data) > MAX_FILE_BYTES:
        raise SceneError(
            Text(
                "{path}: the file is larger than the {most} bytes that a scene may have",
                path=str(path),
                most=MAX_FILE_BYTES,
            )
        )
    return decode_scene(data, str(path))


def load_scene(name_or_path: str | os.PathLike[str]) -> Scene:
    """Load a scene by its name (a built-in preset, or one saved in the page), its file's path, or a link to
    it.

    Raises:
        SceneError: there is none, or it is not valid.
    """
    text = os.fspath(name_or_path)
    if (data := link_data(text)) is not None:
        return decode_link(data)
    path = Path(text)
    if path.suffix == ".json" or path.name != text:
        return read_scene(path)
    for path in built_in_files():
        if path.stem == text:
            return read_scene(path)
    with contextlib.suppress(OSError, ValueError):  # not a possible file name
        candidate = user_folder() / f"{text}.json"
        if candidate.is_file():
            return read_scene(candidate)
    known = [info.name for info in list_scenes()]
    raise SceneError(
        Text(
            "there is no scene called {name!r}{meant}; there are {known}",
            name=text,
            meant=did_you_mean(text, known),
            known=", ".join(known),
        )
    )


def save_scene(scene: Scene, path: str | os.PathLike[str]) -> None:
    """Write the scene to a file, atomically: a reader sees either the old file or the new one.

    Raises:
        SceneError: the scene is not valid or the file cannot be written; an existing file is unchanged.
    """
    data = encode_scene(scene)
    if len(data) > MAX_FILE_BYTES:
        raise SceneError(
            Text(
                "{path}: the scene takes {count} bytes, more than the {most} allowed",
                path=str(path),
                count=len(data),
                most=MAX_FILE_BYTES,
            )
        )
    try:
        write_file(Path(path), data)
    except InputError as error:
        raise SceneError(str(error)) from None


def write_atomically(path: Path, data: bytes) -> None:
    """Write to a temporary file in the same folder, sync it, and rename it over the path.

    Raises:
        OSError: the file could not be written; nothing was changed.
    """
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".tmp")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        # mkstemp makes files that only their owner can read; a scene should be as readable as any new file.
        with _umask_lock:
            mask = os.umask(0)
            os.umask(mask)
        Path(temporary).chmod(0o666 & ~mask)
        Path(temporary).replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            Path(temporary).unlink()
        raise
    if hasattr(os, "O_DIRECTORY"):
        # Makes the rename itself survive a power cut. Where this is impossible, the file is written anyway.
        with contextlib.suppress(OSError):
            folder = os.open(path.parent, os.O_RDONLY | os.O_DIRECTORY)
            try:
                os.fsync(folder)
            finally:
                os.close(folder)


def write_file(path: Path, data: bytes) -> None:
    """Write a file like `write_atomically`.

    Raises:
        InputError: the file cannot be written; nothing was changed.
    """
    try:
        write_atomically(path, data)
    except OSError as error:
        raise InputError(
            Text(
                "{path}: the file cannot be written ({reason})",
                path=str(path),
                reason=error.strerror or str(error),
            )
        ) from None


def take_out(newest: Iterable[Path], most: int, most_bytes: int) -> None:
    """Permanently delete files beyond a number of files or bytes; the first of them always stays.

    Raises:
        OSError: a file cannot be deleted.
    """
    size = 0
    for count, path in enumerate(newest, start=1):
        size += path.stat().st_size
        if count > 1 and (count > most or size > most_bytes):
            path.unlink(missing_ok=True)


def list_scenes() -> list[SceneInfo]:
    """List all scenes that `load_scene` finds by name: built-in presets first, then the user's own.

    A file that is not a valid scene is left out; `softrod check` says what is wrong with it.
    """
    presets = built_in_files()
    found = []
    for path in presets:
        group = path.parent.name if path.parent != built_in_folder() else ""
        found += _info(path, True, group)
    return found + list_saved(user_folder())


def list_saved(folder: Path) -> list[SceneInfo]:
    """List the scenes saved in a folder, which may not exist; see `list_scenes`."""
    paths = sorted(folder.glob("*.json")) if folder.is_dir() else []
    return [info for path in paths if not is_built_in(path.stem) for info in _info(path, False)]


def _info(path: Path, built_in: bool, group: str = "") -> list[SceneInfo]:
    """Return the entry of a scene's file in a list; empty if it is not valid."""
    try:
        scene = read_scene(path)
    except SceneError:
        return []
    about = scene.description, path, built_in, group, scene.title
    return [SceneInfo(path.stem, *about)]


# ------------------------------------------------------------------------- the user's own scenes
def safe_name(name: str) -> str:
    """Reduce a name to what a file name may contain on any system: letters, digits, spaces, some signs.

    Raises:
        SceneError: nothing usable is left, or a built-in preset has that name.
    """
    if not name.strip():
        raise SceneError(Text("a scene needs a name; use letters, digits and spaces"))
    text = re.sub(r"(?i)\.json$", "", unicodedata.normalize("NFKC", name).strip())
    text = re.sub(r"[^\w\-. '’&(),!+]+", "-", text).strip(" .-_")[:60].rstrip(" .-_")
    if not text or re.fullmatch(r"(?i)(con|prn|aux|nul|com\d|lpt\d)(\..*)?", text):
        raise SceneError(
            Text("{name!r} cannot be the name of a scene; use letters, digits and spaces", name=name)
        )
    if len(text.encode()) > 200:
        raise SceneError(Text("{name!r} is too long for the name of a scene", name=name))
    if is_built_in(text):
        raise SceneError(
            Text("{name!r} is a built-in preset, which cannot be overwritten; choose another name", name=text)
        )
    return text


def is_built_in(name: str) -> bool:
    """Return whether a preset has that name, ignoring case."""
    return any(path.stem.casefold() == name.casefold() for path in built_in_files())


def user_path(name: str, folder: Path | None = None) -> Path:
    """Return the path of the saved scene of that name, whether it exists or not.

    Args:
        name: of the scene.
        folder: where it is saved; by default the user's own folder.

    Raises:
        SceneError: as `safe_name`.
    """
    return (folder or user_folder()) / f"{safe_name(name)}.json"


def save_user_scene(scene: Scene, name: str, folder: Path | None = None) -> str:
    """Save a scene and return the name used, see `safe_name`; `folder` as for `user_path`.

    The title is left out: it is that of the scene from which this one was derived.

    Raises:
        SceneError: the name is not usable, the scene not valid, or the file cannot be written.
    """
    path = user_path(name, folder)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SceneError(
            Text(
                "{folder}: the folder cannot be made ({reason})",
                folder=str(path.parent),
                reason=error.strerror or str(error),
            )
        ) from None
    save_scene(msgspec.structs.replace(scene, name=path.stem, title=""), path)
    return path.stem
