"""What a page's script does to the body's parts: gestures become edits, and it is told what came of them."""

from __future__ import annotations

import base64
import binascii
import math
import re
from collections.abc import Callable, Sequence
from dataclasses import replace

import msgspec
import numpy as np

from sim import Moment, Scene
from sim.design.keep_shape import keep_shape_at
from sim.edit import build, copying, muscles, shape, texts
from sim.edit.edit import Edit, Selection, carried, counted, refuse_missing
from sim.edit.values import number, set_number, take_as_rest
from sim.errors import SceneError, SettingError
from sim.scene.numbers import Vector

from ...session import commands
from ...session.session import Notice, Session
from ...stage.sketch import Mapping
from ...wire.carrier import Mail
from . import messages as asks
from .messages import Copied, Selected, TextsTaken, Versions

ASIDE = 0.3
"""By how much a copy lies to the right and below of what it was made of, in the page's world."""

NUDGES = 1.0
"""Seconds between two moves by keys that are one step of undo, at most."""

OFFER = "Reset, and “Keep this shape” beside the tools lets what you drew stand as you drew it."
"""What is said once to who has drawn a spring and lets it go."""

_PASTE = re.compile(r"(-?\d{1,7}(?:\.\d{1,6})?),(-?\d{1,7}(?:\.\d{1,6})?),([A-Za-z0-9+/=]+)")


class Edits:
    """What one page does to the parts of its body.

    Args:
        session: the page's simulation.
        mail: to the page's script.
        notify: tells the user something.
    """

    def __init__(self, session: Session, mail: Mail, notify: Callable[[Notice], None]) -> None:
        self._session = session
        self._mail = mail
        self._notify = notify
        self._copy = False
        self._selected: Selection | None = None
        self._drew = self._offered = (
            False  # whether a spring was drawn, and whether it was said what keeps it
        )

    # --------------------------------------------------------------------- any thread
    def do(self, ask: asks.Edit) -> None:
        """Do what a gesture, or the form of texts, asks for."""
        match ask:
            case asks.SetTexts():
                self._set_texts(ask)
            case asks.Select() | asks.Marquee() | asks.Act(what="all"):
                self._session.post(commands.Select(lambda *now: selected(ask, *now)))
            case asks.Act(what="copy"):
                self._copy = True
            case asks.Tempo(frequency):
                self._session.post(commands.SetValue("tempo", frequency))
            case asks.MoveMuscles():
                key, within = ("muscles by keys", NUDGES) if ask.keys else ("muscles by hand", math.inf)
                self._session.post(commands.Change(lambda *now: edited(ask, *now), key, within=within))
            case asks.Move(keys=True):
                move = commands.Change(lambda *now: edited(ask, *now), "moved by keys", within=NUDGES)
                self._session.post(move)
            case asks.Gesture():
                self._drew |= isinstance(ask, asks.Line)
                heavy = isinstance(ask, asks.Act) and ask.what in ("keep", "stiffen")
                self._session.post(commands.Change(lambda *now: edited(ask, *now), heavy=heavy))

    def _set_texts(self, ask: asks.SetTexts) -> None:
        """Give the scene another name and description, or say in the page why not: what was typed is kept."""
        refused = ""
        try:
            texts.set_texts(self._session.scene, ask.name, ask.description)
        except SceneError as error:
            refused = f"{str(error)[:1].upper()}{str(error)[1:]}."
        else:
            self._session.post(
                commands.Change(lambda moment, _: texts.set_texts(moment.scene, ask.name, ask.description))
            )
        self._mail.send(TextsTaken(refused=refused))

    def paste(self, message: str) -> None:
        """Put in what was copied; in a thread, since it may be long.

        Args:
            message: where its middle is to be, in the page's world, and the text as base64.
        """
        match = _PASTE.fullmatch(message)
        if match is None:
            return
        try:
            text = base64.b64decode(match[3], validate=True).decode()
            fragment = copying.decode(text)
        except (binascii.Error, UnicodeDecodeError):
            return
        except SceneError as error:
            self._notify(Notice("error", "That cannot be pasted", str(error)))
            return
        x, y = float(match[1]), float(match[2])
        self._session.post(
            commands.Change(lambda moment, _: _pasted(moment, fragment, _point(moment.scene, x, y)))
        )

    # --------------------------------------------------------------------- the ticker's
    def tell(self) -> None:
        """Tell the script what is selected, what can be undone, and what it wanted to copy."""
        session = self._session
        if session.selection is not self._selected:
            self._selected = session.selection
            self._mail.send(
                Selected(**{kind: tuple(sorted(of)) for kind, of in self._selected._asdict().items()})
            )
        versions = session.versions
        stiffen = (session.refusal.stiffening or 0.0) if session.refusal is not None else 0.0
        self._mail.send(
            Versions(
                undo=versions.undoable, redo=versions.redoable, count=len(versions), stiffen=round(stiffen, 3)
            )
        )
        if session.playing and self._drew and not self._offered:
            self._offered = True
            self._notify(Notice("info", "It sags?", OFFER))
        if self._copy:
            self._copy = False
            moment = session.simulation.capture()
            try:
                fragment = _copied(moment, masses_of(moment.scene, session.selection))
                self._mail.send(Copied(text=copying.encode(fragment)))
            except SceneError as error:
                self._notify(Notice("error", "That cannot be copied", str(error)))


# ------------------------------------------------------------------------- what is selected
def selected(ask: asks.Gesture, moment: Moment, before: Selection) -> Selection:
    """What is selected after a gesture that selects."""
    match ask:
        case asks.Select(masses, springs, joints, toggle):
            parts = Selection(*map(frozenset, (masses, springs, joints)))
            return (
                Selection(*(one ^ two for one, two in zip(before, parts, strict=True))) if toggle else parts
            )
        case asks.Marquee(x, y, add):
            parts = _enclosed(moment, x, y)
            return Selection(*(one | two for one, two in zip(before, parts, strict=True))) if add else parts
        case _:
            scene = moment.scene
            every = scene.masses, scene.linear_springs, scene.angular_springs
            return Selection(*(frozenset(range(len(parts))) for parts in every))


def _enclosed(moment: Moment, x: Vector, y: Vector) -> Selection:
    """Masses in a rectangle, springs with both ends and joints with both springs among them."""
    scene, corners = moment.scene, np.array([_point(moment.scene, *c) for c in zip(x, y, strict=True)])
    at = moment.positions
    inside = ((at >= corners.min(0)) & (at <= corners.max(0))).all(1)
    broken = set(moment.damage.broken) if moment.damage is not None else set()
    springs = frozenset(
        s
        for s, spring in enumerate(scene.linear_springs)
        if inside[spring.a] and inside[spring.b] and s not in broken
    )
    joints = (j for j, joint in enumerate(scene.angular_springs) if joint.a in springs and joint.b in springs)
    return Selection(frozenset(np.flatnonzero(inside).tolist()), springs, frozenset(joints))


def masses_of(scene: Scene, selection: Selection) -> frozenset[int]:
    """The masses that are selected, and those that selected springs and joints join."""
    springs = set(selection.springs)
    for j in selection.joints:
        springs |= {scene.angular_springs[j].a, scene.angular_springs[j].b}
    ends = {end for s in springs for end in (scene.linear_springs[s].a, scene.linear_springs[s].b)}
    return selection.masses | ends


# ------------------------------------------------------------------------- what is changed
def edited(ask: asks.Gesture, moment: Moment, selection: Selection) -> Edit:
    """The edit that a gesture asks for.

    Raises:
        SceneError, SettingError: it cannot be made.
    """
    scene = moment.scene
    match ask:
        case asks.Place(x, y):
            edit = build.add_mass(scene, _point(scene, x, y))
            return replace(edit, select=_one(len(scene.masses)))
        case asks.Line(a, b, start, end):
            return _lined(moment, a, b, _point(scene, *start), _point(scene, *end))
        case asks.Hold(a, b):
            return _held(moment, a, b)
        case asks.Turn(joint, angle):
            return _turned(moment, joint, angle)
        case asks.Stroke(points):
            stroke = [_point(scene, *point) for point in points]
            edit = shape.cut(scene, stroke, build.positions_of(moment))
            return edit if edit.springs else Edit("", scene)
        case asks.Move(x, y, rest, under):
            origin, point = _point(scene, 0.0, 0.0), _point(scene, x, y)
            masses = masses_of(scene, _aimed(scene, selection, None, under))
            return _moved(moment, masses, (point[0] - origin[0], point[1] - origin[1]), rest)
        case asks.MoveMuscles(later, stretch, turn):
            return muscles.move_muscles(scene, selection, later, stretch, turn)
        case asks.ShapeMuscles(spread=True):
            return muscles.spread_muscles(scene, selection)
        case asks.ShapeMuscles(wave, per_beat):
            return muscles.shape_muscles(scene, selection, wave, per_beat)
        case asks.Act(what, mass, under):
            return _done(what, moment, _aimed(scene, selection, mass, under))
        case _:
            return Edit("", scene)


def _aimed(scene: Scene, selection: Selection, mass: int | None, under: int | None) -> Selection:
    """What an action is meant for: a mass, or what is selected, or else what is under the pointer."""
    if mass is None:
        mass = None if any(selection) else under
    if mass is None:
        return selection
    refuse_missing([mass], len(scene.masses))
    return _one(mass)


def _done(what: str, moment: Moment, selection: Selection) -> Edit:
    scene, positions = moment.scene, build.positions_of(moment)
    masses = masses_of(scene, selection)
    some = masses or frozenset(range(len(scene.masses)))  # where nothing is selected, the whole body is meant
    match what:
        case "remove" if any(selection):
            return build.remove(scene, selection)
        case "pin" if masses:
            held = {anchor.mass for anchor in scene.anchors}
            return build.pin(scene, masses, on=not masses <= held)
        case "duplicate" if masses:
            fragment = _copied(moment, masses)
            at = (_middle([positions[i][k] for i in masses]) for k in (0, 1))
            zero, aside = _point(scene, 0.0, 0.0), _point(scene, ASIDE, -ASIDE)
            x, y = (a + one - none for a, one, none in zip(at, aside, zero, strict=True))
            return replace(
                _pasted(moment, fragment, (x, y)), label=f"{counted(len(masses), 'mass')} duplicated"
            )
        case "mirror":
            return shape.mirror(scene, some, positions)
        case "corners":
            edit = shape.add_corners(scene, some, positions, moment.rest_angle_shift)
            if edit.joints is None:
                raise SceneError("every corner there has an angular spring, or has none to get")
            return edit
        case "triangulate":
            edit = shape.triangulate(scene, some, positions, moment.rest_length_scale)
            if edit.springs is None:
                raise SceneError("there is nothing left to brace")
            return edit
        case "rest":
            return take_as_rest(moment, selection if any(selection) else Selection(masses=some))
        case "keep" | "stiffen":
            return _kept(moment, selection, what == "stiffen")
        case _:
            raise SceneError("nothing is selected")


def _lined(moment: Moment, a: int | None, b: int | None, start: Vector, end: Vector) -> Edit:
    scene, positions, scale = moment.scene, build.positions_of(moment), moment.rest_length_scale
    n = len(scene.masses)
    if a is None and b is not None:
        return replace(build.extend(scene, b, start, positions, scale), select=_one(b))
    if a is None:
        first = build.add_mass(scene, start)
        second = build.extend(first.scene, n, end, [*positions, start], scale)
        return replace(build.joined("2 masses and a spring added", first, second), select=_one(n + 1))
    if b is None:
        return replace(build.extend(scene, a, end, positions, scale), select=_one(n))
    edit = build.add_springs(scene, [(a, b)], positions, scale)
    return replace(edit if edit.springs else Edit("", scene), select=_one(b))


def _held(moment: Moment, a: int, b: int) -> Edit:
    scene, positions = moment.scene, build.positions_of(moment)
    refuse_missing((a, b), len(scene.linear_springs), "spring")
    angle = build.angle_between(scene, a, b, positions) - moment.rest_angle_shift
    edit = build.add_joints(scene, [(a, b)], [angle])
    if edit.joints is None:
        return Edit("", scene)
    return replace(edit, select=Selection(joints=frozenset({len(scene.angular_springs)})))


def _turned(moment: Moment, joint: int, angle: float | None) -> Edit:
    scene = moment.scene
    refuse_missing([joint], len(scene.angular_springs), "joint")
    if angle is None:
        two = scene.angular_springs[joint]
        angle = build.angle_between(scene, two.a, two.b, build.positions_of(moment))
    angle -= moment.rest_angle_shift
    if moment.damage is not None and moment.damage.set_angles:
        angle -= moment.damage.set_angles[joint]
    edit = set_number(scene, number("angular_springs", "rest_angle"), [joint], build.in_turn(angle))
    return replace(edit, select=Selection(joints=frozenset({joint})))


def _kept(moment: Moment, selection: Selection, allow_stiffening: bool) -> Edit:
    """What is selected holds the body as it is: springs and joints, or all that selected masses have."""
    scene, parts = moment.scene, None
    if any(selection):
        masses = selection.masses
        springs = selection.springs | {
            s for s, each in enumerate(scene.linear_springs) if each.a in masses or each.b in masses
        }
        joints = selection.joints | {
            j
            for j, each in enumerate(scene.angular_springs)
            if masses and (each.a in springs or each.b in springs)
        }
        parts = Selection(springs=springs, joints=joints)
    kept = keep_shape_at(moment, parts, allow_stiffening)
    assert kept.pose is not None
    shift = np.array(kept.pose.positions).T - moment.rows[:2]
    starts = scene.pose.positions if scene.pose else tuple(mass.position for mass in scene.masses)
    # Where it is to start in this shape, too, it starts there at rest.
    made = kept if starts != kept.pose.positions else msgspec.structs.replace(kept, pose=scene.pose)
    return Edit("keep this shape", made, shift=shift if shift.any() else None, stops=True)


def _moved(moment: Moment, masses: frozenset[int], by: Vector, rest: bool) -> Edit:
    if not masses:
        raise SettingError("nothing is selected that could be moved")
    edit = shape.move(moment.scene, masses, by)
    if not (rest and any(s.a in masses or s.b in masses for s in moment.scene.linear_springs)):
        return edit
    resting = take_as_rest(carried(edit, moment), Selection(masses=masses))
    return replace(edit, scene=resting.scene)


def _copied(moment: Moment, masses: frozenset[int]) -> copying.Fragment:
    return copying.copy(moment.scene, masses, build.positions_of(moment))


def _pasted(moment: Moment, fragment: copying.Fragment, at: Vector) -> Edit:
    scene = moment.scene
    edit = copying.paste(scene, fragment, at)
    olds = len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)
    news = edit.scene.masses, edit.scene.linear_springs, edit.scene.angular_springs
    select = Selection(*(frozenset(range(old, len(new))) for old, new in zip(olds, news, strict=True)))
    return replace(edit, select=select)


def _one(mass: int) -> Selection:
    return Selection(masses=frozenset({mass}))


def _middle(values: Sequence[float]) -> float:
    return (min(values) + max(values)) / 2.0


def _point(scene: Scene, x: float, y: float) -> Vector:
    """A point of the page's world in the scene, px."""
    return Mapping.of(scene).to_scene(x, y)
