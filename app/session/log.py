"""The log of a run: what was done, in order, one JSON object a line. Pages record logs, people write them.

A log lists what was done to a `Simulation`, counted in its own steps. It has no wall clock and no pointer, so
a replay does not depend on the speed of the machine. A recorded log begins with a header that has its scene;
one written by hand may leave that out if the scene is named elsewhere.
"""

from __future__ import annotations

import hashlib
import os
import platform
from dataclasses import dataclass, field
from functools import lru_cache
from importlib import metadata
from pathlib import Path
from typing import Annotated, Any, Literal, cast, get_args

import llvmlite.binding
import msgspec
import numba
import numpy as np
from msgspec import Meta

import sim
from sim.engine.tables import SCALE_MAX, SCALE_MIN
from sim.errors import InputError, SceneError
from sim.motion.simulation import Key
from sim.scene.numbers import Angle, Vector
from sim.scene.validate import consistent_pose, validate
from sim.store.files import MAX_FILE_BYTES, decode_scene, encode_fields, fields_of
from sim.store.places import as_utf8, repeated_key, sentence_of_json
from sim.text import Text

FORMAT, VERSION = "softrod-log", 1

MAX_LOG_BYTES = 4_000_000
"""Bytes of a log besides its scene and first moment, at which it is restarted. A page can open the logs that
it saves, as long as scene and first moment take less than a megabyte."""

_MAX_BYTES = MAX_LOG_BYTES + 4 * MAX_FILE_BYTES
"""Bytes of a log that is read, at most: its scene, the scene and pose that it begins with, and its last entry
may each be as large as a scene file."""

_EXAMPLE = '{"do": "move", "mass": 0, "to": [320, 180]} and then {"do": "step", "n": 1, "times": 100}'

NOTED = 32
"""Masses whose positions a check notes, at most."""

_Mass = Annotated[int, Meta(ge=0, lt=100_000)]
_Seconds = Annotated[float, Meta(ge=0.0, le=1e9)]
_Way = Annotated[float, Meta(ge=-1.0, le=1.0)]
_Count = Annotated[int, Meta(ge=0, le=10**15)]
_Times = Annotated[int, Meta(ge=1, le=10**7)]


class Entry(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, omit_defaults=True):
    """One line after the first.

    Attributes:
        times: how often it was done in a row.
    """

    times: _Times = 1


class Act(Entry, frozen=True):
    """Something done to a body by hand, or to its numbers."""

    def do(self, simulation: sim.Simulation) -> None:
        """Do it.

        Raises:
            InputError, SettingError: it cannot be done.
        """
        raise NotImplementedError


class Step(Entry, frozen=True, tag_field="do", tag="step"):
    """A call of `Simulation.step`: n time steps, with a limited number of attempts, or any number."""

    n: Annotated[int, Meta(ge=0, le=500_000)]
    attempts: Annotated[int, Meta(ge=1, le=10**7)] | None = None


class _OfMass(Act, frozen=True):
    mass: _Mass


class _ToPlace(_OfMass, frozen=True):
    to: Vector


class Move(_ToPlace, frozen=True, tag_field="do", tag="move"):
    """A held mass was moved to a place, px, at once."""

    def do(self, simulation: sim.Simulation) -> None:
        simulation.move(self.mass, self.to)


class Lead(_ToPlace, frozen=True, tag_field="do", tag="lead"):
    """A held mass was led to a place, px, over the next call of `step`."""

    def do(self, simulation: sim.Simulation) -> None:
        simulation.lead(self.mass, self.to)


class Follow(_ToPlace, frozen=True, tag_field="do", tag="follow"):
    """A held mass was led to a place, px, as fast as the body can follow."""

    def do(self, simulation: sim.Simulation) -> None:
        simulation.follow(self.mass, self.to)


class Grab(_OfMass, frozen=True, tag_field="do", tag="grab"):
    """A hand took a mass."""

    def do(self, simulation: sim.Simulation) -> None:
        simulation.grab(self.mass)


class Release(_OfMass, frozen=True, tag_field="do", tag="release"):
    """A hand let go of a mass."""

    def do(self, simulation: sim.Simulation) -> None:
        simulation.release(self.mass)


class Keys(Act, frozen=True, tag_field="do", tag="keys"):
    """The arrow keys held from here on."""

    held: tuple[Key, ...]

    @classmethod
    def of(cls, keys: frozenset[str]) -> Keys:
        """The entry for a set of keys, in a fixed order."""
        return cls(held=tuple(key for key in get_args(Key) if key in keys))

    def do(self, simulation: sim.Simulation) -> None:
        simulation.keys = self.held


class Set(Act, frozen=True, tag_field="do", tag="set"):
    """A number of the scene was set; see `sim.set_value`."""

    key: Annotated[str, Meta(max_length=60)]
    value: float

    def do(self, simulation: sim.Simulation) -> None:
        simulation.replace(sim.set_value(simulation.scene, self.key, self.value, simulation.time))


class Choose(Act, frozen=True, tag_field="do", tag="choose"):
    """A choice was made; see `sim.set_choice`."""

    key: Annotated[str, Meta(max_length=60)]
    value: Annotated[str, Meta(max_length=60)]

    def do(self, simulation: sim.Simulation) -> None:
        simulation.replace(sim.set_choice(simulation.scene, self.key, self.value))


class FollowEnergy(Act, frozen=True, tag_field="do", tag="energy"):
    """Whether the energy is followed from here on."""

    on: bool

    def do(self, simulation: sim.Simulation) -> None:
        simulation.track_energy(self.on)


class Restore(Entry, frozen=True, tag_field="do", tag="restore"):
    """The body was put into the state of a moment, and hands let go.

    Attributes:
        pose: positions, px, and velocities, px/s.
        time, step: simulated time, s, and time steps since the start.
        scale, shift: the factor of all rest lengths, and degrees added to all rest angles.
        steer: what held keys do to motors, muscles and forces, see `Moment`.
        scene: the body and its settings; None if unchanged.
    """

    pose: sim.Pose
    time: _Seconds
    step: _Count
    scale: Annotated[float, Meta(ge=SCALE_MIN, le=SCALE_MAX)] = 1.0
    shift: Angle = 0.0
    steer: tuple[_Way, _Way, _Way, _Way, _Seconds] | msgspec.UnsetType = msgspec.UNSET
    scene: dict[str, Any] | None = None


class Check(Entry, frozen=True, tag_field="do", tag="check"):
    """The state of the body at this point.

    Attributes:
        time, step: simulated time, s, and time steps since the start.
        digest: of all positions and velocities; see `digest_of`.
        state: of these and of all else that changes; see `state_of`. Empty in older logs.
        at: positions of some masses, evenly chosen, px.
    """

    time: _Seconds
    step: _Count
    digest: Annotated[str, Meta(max_length=64)]
    state: Annotated[str, Meta(max_length=64)] = ""
    at: tuple[Vector, ...] = ()


_Kinds = Step | Move | Lead | Follow | Grab | Release | Keys | Set | Choose | FollowEnergy | Restore | Check


_decoder: Any = msgspec.json.Decoder(_Kinds)


@lru_cache(maxsize=256)
def decode_entry(line: bytes) -> Entry:
    """The entry of a line that this program has written."""
    entry: Entry = _decoder.decode(line)
    return entry


class Machine(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The machine, which last digits may depend on.

    Attributes:
        kind: its architecture, as in x86_64.
        cpu: the processor that numba compiles for.
        numba: its version.
    """

    kind: Annotated[str, Meta(max_length=60)] = ""
    cpu: Annotated[str, Meta(max_length=60)] = ""
    numba: Annotated[str, Meta(max_length=60)] = ""

    def __str__(self) -> str:
        return f"{self.kind} {self.cpu} with numba {self.numba}"


class Header(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The first line.

    Attributes:
        format, version: of the file.
        softrod: version of the program that wrote it.
        machine: where it was written.
        scene: the body, at its start.
        note: why the log begins elsewhere, if it does.
    """

    format: Literal["softrod-log"]
    version: Annotated[int, Meta(ge=1)]
    softrod: Annotated[str, Meta(max_length=60)] = ""
    machine: Machine = Machine()
    scene: msgspec.Raw
    note: Annotated[str, Meta(max_length=200)] = ""


@dataclass
class Log:
    """A log that was read.

    Attributes:
        source: its name in errors.
        scene: the body that it begins with.
        machine: where it was recorded; empty if unknown.
        entries: what was done.
        lines: line number of each entry.
        moments: that entries `Restore` lead to, by the entry's index.
    """

    source: str
    scene: sim.Scene
    machine: Machine = field(default_factory=Machine)
    entries: list[Entry] = field(default_factory=list)
    lines: list[int] = field(default_factory=list)
    moments: dict[int, sim.Moment] = field(default_factory=dict)

    @property
    def checks(self) -> int:
        """Number of checks."""
        return sum(isinstance(entry, Check) for entry in self.entries)


def this_machine() -> Machine:
    """This machine."""
    cpu = os.environ.get("NUMBA_CPU_NAME") or llvmlite.binding.get_host_cpu_name()
    return Machine(platform.machine(), cpu, numba.__version__)


def digest_of(simulation: sim.Simulation) -> str:
    """A digest of the bytes of all positions and velocities: equal only if every bit is."""
    data = simulation.positions.tobytes() + simulation.velocities.tobytes()
    return hashlib.blake2b(data, digest_size=16).hexdigest()


def state_of(simulation: sim.Simulation) -> str:
    """A short digest of the exact state: equal only if every bit of all that changes is.

    That is positions, velocities and time, what keys did to rest lengths and angles, the keys and masses
    held, what has yielded and broken, and by what friction holds.
    """
    moment = simulation.capture()
    numbers = np.array([moment.time, moment.step_count, moment.rest_length_scale, moment.rest_angle_shift])
    # Older logs have no efforts of keys.
    efforts = (moment.steer,) if moment.steer else ()
    parts = sorted(simulation.keys), simulation.grabbed, moment.damage, moment.grips, *efforts
    data = moment.rows.tobytes() + numbers.tobytes() + encode_fields(parts)
    return hashlib.blake2b(data, digest_size=8).hexdigest()


def check_of(simulation: sim.Simulation) -> Check:
    """A check of a body as it is now."""
    some = noted(simulation)
    at = tuple((x, y) for x, y in some.tolist())
    return Check(
        time=simulation.time,
        step=simulation.step_count,
        digest=digest_of(simulation),
        state=state_of(simulation),
        at=at,
    )


def noted(simulation: sim.Simulation) -> np.ndarray:
    """(k, 2) positions of the masses that a check notes, px."""
    positions = simulation.positions
    return positions[:: -(-len(positions) // NOTED)]


def encode_header(scene: sim.Scene, note: str = "") -> bytes:
    """The first line, without its end.

    Raises:
        SceneError: the scene is not valid.
    """
    header = Header(
        format=FORMAT,
        version=VERSION,
        softrod=_version(),
        machine=this_machine(),
        scene=raw_scene(validate(scene)),
        note=note,
    )
    return msgspec.json.encode(header)


def _version() -> str:
    try:
        return metadata.version("softrod")
    except metadata.PackageNotFoundError:
        return ""  # run from a checkout that is not installed


def raw_scene(scene: sim.Scene) -> msgspec.Raw:
    """A valid scene on one line."""
    return msgspec.Raw(encode_fields(fields_of(scene)))


def restore_entry(moment: sim.Moment, with_scene: bool) -> Restore:
    """The entry for a moment."""
    x, y, vx, vy = moment.rows.tolist()
    return Restore(
        pose=sim.Pose(
            positions=tuple(zip(x, y, strict=True)),
            velocities=tuple(zip(vx, vy, strict=True)),
            damage=moment.damage,
            grips=moment.grips,
        ),
        time=moment.time,
        step=moment.step_count,
        scale=moment.rest_length_scale,
        shift=moment.rest_angle_shift,
        steer=cast(Any, moment.steer or msgspec.UNSET),
        scene=fields_of(moment.scene) if with_scene else None,
    )


def moment_of(entry: Restore, scene: sim.Scene) -> sim.Moment:
    """The moment of an entry, for a scene.

    Raises:
        SceneError: the pose is not one of the scene's body.
    """
    pose = consistent_pose(entry.pose, scene)
    rows = np.ascontiguousarray([*np.array(pose.positions).T, *np.array(pose.velocities).T])
    controls, kept = (entry.scale, entry.shift), (pose.damage, pose.grips, entry.steer or ())
    return sim.Moment(scene, *controls, rows, entry.time, entry.step, *kept)


def is_recorded(data: bytes) -> bool:
    """Whether the bytes are a log with a header."""
    return _first(data).get("format") == FORMAT


def is_log(data: bytes) -> bool:
    """Whether the bytes are a log, with a header or without."""
    return is_recorded(data) or "do" in _first(data)


def _first(data: bytes) -> dict[str, Any]:
    """Return the object in the first line; an empty one if there is none."""
    try:
        first = msgspec.json.decode(data.lstrip().split(b"\n", 1)[0])
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError):
        return {}
    return first if isinstance(first, dict) else {}


def read_log(path: Path, scene: sim.Scene | None = None) -> Log:
    """Read the log in a file; arguments and errors as of `decode_log`, and the file may be unreadable."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: the file cannot be read ({error.strerror or error})") from None
    return decode_log(data, str(path), scene)


def decode_log(data: bytes, source: str, scene: sim.Scene | None = None) -> Log:
    """Read the log in a file's bytes; nothing in it is trusted.

    Args:
        data: the whole file.
        source: its name in errors, usually that of the file.
        scene: the body of a log without a header; None if it must have one.

    Raises:
        InputError: one sentence that names the line.
    """
    if len(data) > _MAX_BYTES:
        raise InputError(f"{source}: {len(data)} bytes are more than the {_MAX_BYTES} that a log may have")
    try:
        data = as_utf8(data)
    except UnicodeError as error:
        raise InputError(Text("{source}: {error}", source=source, error=str(error))) from None
    lines = [(i, line) for i, line in enumerate(data.splitlines(), start=1) if line.strip()]
    number, line = lines[0] if lines else (1, b"")
    log: Log | None = None
    try:
        if scene is None or is_recorded(line):
            header = msgspec.json.decode(line, type=Header)
            if header.version > VERSION:
                raise InputError(
                    f"version {header.version} is newer than {VERSION}; a newer softrod can read it"
                )
            scene, lines = decode_scene(bytes(header.scene), "scene", places=False), lines[1:]
            log = Log(source, scene, header.machine)
        else:
            log = Log(source, scene)
        present = scene
        for number, line in lines:
            entry = _decoder.decode(line)
            if again := repeated_key(line):
                raise InputError(f"the key {again[0][:60]!r} stands twice in one object")
            if isinstance(entry, Restore):
                if entry.scene is not None:
                    present = decode_scene(msgspec.json.encode(entry.scene), "scene", places=False)
                    log.moments[len(log.entries)] = moment_of(entry, present)
                else:
                    moment_of(entry, present)  # numbers may have been set since; a replay knows them
            if isinstance(entry, Set) and entry.key == "masses" and entry.value != len(scene.masses):
                raise InputError("set: the number of masses cannot change within a log")
            log.entries.append(entry)
            log.lines.append(number)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError, SceneError, InputError) as error:
        reason = sentence_of_json(error, line, _Kinds if log else Header)
        if reason.startswith("the field `do` is missing"):
            reason += f", which says what is done, as in {_EXAMPLE}"
        raise InputError(" ".join(f"{source}: line {number}: {reason}".split())) from None
    return log
