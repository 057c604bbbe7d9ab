"""Turns the gestures of a page into edits of the body, and reports the results to the page."""

from __future__ import annotations

import base64
import binascii
import math
import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from operator import or_, xor

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
from ...words import say
from ...words.english import refusal, written
from . import messages as asks
from .labels import done
from .messages import Copied, Selected, TextsTaken, Versions

COPY_OFFSET = 0.3
"""How far a copy lies to the right of and below the original, in the page's world."""

MERGE_WITHIN = 1.0
"""Seconds within which moves by keys are one step of undo."""

_PASTED = re.compile(r"(-?\d{1,7}(?:\.\d{1,6})?),(-?\d{1,7}(?:\.\d{1,6})?),([A-Za-z0-9+/=]+)")


class Edits:
    """The edits of one page.

    Args:
        session: the page's simulation.
        mail: to the page's script.
        notify: shows a notice to the user.
    """

    def __init__(self, session: Session, mail: Mail, notify: Callable[[Notice], None]) -> None:
        self._session = session
        self._mail = mail
        self._notify = notify
        self._copies = False  # whether the selection is to be copied
        self._selected: Selection | None = None  # what the page knows to be selected
        self._labels = self._done = ("", "")  # of undo and redo, as the steps have them and as they are said
        self._drew = self._offered = False  # whether a spring was drawn, and how to keep its shape was shown

    # --------------------------------------------------------------------- any thread
    def do(self, ask: asks.Edit) -> None:
        """Carry out a message of the page."""
        post = self._session.post
        match ask:
            case asks.SetTexts():
                self._set_texts(ask)
            case asks.Select() | asks.Marquee() | asks.Act(what="all"):
                post(commands.Select(partial(select, ask)))
            case asks.Act(what="copy"):
                self._copies = True
            case asks.Tempo(frequency):
                post(commands.SetValue("tempo", frequency))
            case asks.MoveMuscles(keys=False):
                post(commands.Change(partial(make_edit, ask), "muscles by hand", within=math.inf))
            case asks.MoveMuscles() | asks.Move(keys=True):
                key = "moved by keys" if isinstance(ask, asks.Move) else "muscles by keys"
                post(commands.Change(partial(make_edit, ask), key, within=MERGE_WITHIN))
            case asks.Gesture():
                self._drew |= isinstance(ask, asks.Line)
                heavy = isinstance(ask, asks.Act) and ask.what in ("keep", "stiffen")
                post(commands.Change(partial(make_edit, ask), heavy=heavy))

    def _set_texts(self, ask: asks.SetTexts) -> None:
        """Change the scene's name and description, or report to the page why that is impossible."""
        refused, scene = "", self._session.scene
        name, description = (written(text, scene) for text in (ask.name, ask.description))
        try:
            texts.set_texts(scene, name, description)
        except SceneError as error:
            refused = refusal(error)
        else:
            self._session.post(
                commands.Change(lambda moment, _: texts.set_texts(moment.scene, name, description))
            )
        self._mail.send(TextsTaken(refused=refused))

    def paste(self, message: str) -> None:
        """Paste copied parts; in a thread, since the text may be long.

        Args:
            message: where their middle goes, in the page's world, and the copied text as base64.
        """
        match = _PASTED.fullmatch(message)
        if match is None:
            return
        try:
            text = base64.b64decode(match[3], validate=True).decode()
            fragment = copying.decode(text)
        except (binascii.Error, UnicodeDecodeError):
            return
        except SceneError as error:
            self._notify(Notice("error", say("edit-not-pasted"), str(error)))
            return
        x, y = float(match[1]), float(match[2])
        self._session.post(
            commands.Change(lambda moment, _: _paste(moment, fragment, _to_scene(moment.scene, x, y)))
        )

    # --------------------------------------------------------------------- the ticker's
    def tell(self) -> None:
        """Report to the page what is selected, what can be undone, and what it copies."""
        session, versions = self._session, self._session.versions
        if session.selection is not self._selected:
            self._selected = session.selection
            self._mail.send(Selected(*(tuple(sorted(parts)) for parts in self._selected)))
        stiffen = (session.refusal.stiffening or 0.0) if session.refusal is not None else 0.0
        labels = versions.undoable, versions.redoable
        if labels != self._labels:
            self._labels = labels
            self._done = done(labels[0], session.scene), done(labels[1], session.scene)
        self._mail.send(Versions(*self._done, len(versions), round(stiffen, 3)))
        if session.playing and self._drew and not self._offered:
            self._offered = True
            self._notify(Notice("info", say("edit-sags"), say("edit-sags.text")))
        if self._copies:
            self._copies = False
            moment = session.simulation.capture()
            try:
                fragment = _copy(moment, masses_of(moment.scene, session.selection))
                self._mail.send(Copied(text=copying.encode(fragment)))
            except SceneError as error:
                self._notify(Notice("error", say("edit-not-copied"), str(error)))


# ------------------------------------------------------------------------- what is selected
def select(ask: asks.Gesture, moment: Moment, before: Selection) -> Selection:
    """Return the selection after a gesture that selects."""
    match ask:
        case asks.Select(masses, springs, joints, toggle):
            parts = Selection(*map(frozenset, (masses, springs, joints)))
            return Selection(*map(xor, before, parts)) if toggle else parts
        case asks.Marquee(x, y, add):
            parts = _inside(moment, x, y)
            return Selection(*map(or_, before, parts)) if add else parts
        case _:
            scene = moment.scene
            every = scene.masses, scene.linear_springs, scene.angular_springs
            return Selection(*(frozenset(range(len(parts))) for parts in every))


def _inside(moment: Moment, x: Vector, y: Vector) -> Selection:
    """Return the masses in a rectangle, springs with both ends and joints with both springs in it."""
    scene, corners = moment.scene, np.array([_to_scene(moment.scene, *c) for c in zip(x, y, strict=True)])
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
    """Return the selected masses, and those at selected springs and joints."""
    springs = set(selection.springs)
    for j in selection.joints:
        springs |= {scene.angular_springs[j].a, scene.angular_springs[j].b}
    ends = {end for s in springs for end in (scene.linear_springs[s].a, scene.linear_springs[s].b)}
    return selection.masses | ends


# ------------------------------------------------------------------------- what is changed
def make_edit(ask: asks.Gesture, moment: Moment, selection: Selection) -> Edit:
    """Return the edit that a gesture makes.

    Raises:
        SceneError, SettingError: it is impossible.
    """
    scene = moment.scene
    match ask:
        case asks.Place(x, y):
            edit = build.add_mass(scene, _to_scene(scene, x, y))
            return replace(edit, select=_only(len(scene.masses)))
        case asks.Line(a, b, start, end):
            return _add_line(moment, a, b, _to_scene(scene, *start), _to_scene(scene, *end))
        case asks.Hold(a, b):
            return _add_joint(moment, a, b)
        case asks.Turn(joint, angle):
            return _turn_joint(moment, joint, angle)
        case asks.Stroke(points):
            stroke = [_to_scene(scene, *point) for point in points]
            edit = shape.cut(scene, stroke, build.positions_of(moment))
            return edit if edit.springs else Edit("", scene)
        case asks.Move(x, y, rest, under):
            masses = masses_of(scene, _target(scene, selection, None, under))
            return _move(moment, masses, _vector(scene, x, y), rest)
        case asks.MoveMuscles(later, stretch, turn):
            return muscles.move_muscles(scene, selection, later, stretch, turn)
        case asks.ShapeMuscles(spread=True):
            return muscles.spread_muscles(scene, selection)
        case asks.ShapeMuscles(wave, per_beat):
            return muscles.shape_muscles(scene, selection, wave, per_beat)
        case asks.Act(what, mass, under):
            return _act(what, moment, _target(scene, selection, mass, under))
        case _:
            return Edit("", scene)


def _target(scene: Scene, selection: Selection, mass: int | None, under: int | None) -> Selection:
    """Return the target of an action: a mass, or the selection, or else the mass under the pointer."""
    if mass is None:
        mass = None if any(selection) else under
    if mass is None:
        return selection
    refuse_missing([mass], len(scene.masses))
    return _only(mass)


def _act(what: str, moment: Moment, selection: Selection) -> Edit:
    scene, positions = moment.scene, build.positions_of(moment)
    masses = masses_of(scene, selection)
    some = masses or frozenset(range(len(scene.masses)))  # without a selection, the whole body
    match what:
        case "remove" if any(selection):
            return build.remove(scene, selection)
        case "pin" if masses:
            held = {anchor.mass for anchor in scene.anchors}
            return build.pin(scene, masses, on=not masses <= held)
        case "duplicate" if masses:
            fragment = _copy(moment, masses)
            at = (_center([positions[i][k] for i in masses]) for k in (0, 1))
            offset = _vector(scene, COPY_OFFSET, -COPY_OFFSET)
            x, y = (a + b for a, b in zip(at, offset, strict=True))
            label = f"{counted(len(masses), 'mass')} duplicated"
            return replace(_paste(moment, fragment, (x, y)), label=label)
        case "mirror":
            return shape.mirror(scene, some, positions)
        case "corners":
            edit = shape.add_corners(scene, some, positions, moment.rest_angle_shift)
            if edit.joints is None:
                raise SceneError(say("edit-no-corner"))
            return edit
        case "triangulate":
            edit = shape.triangulate(scene, some, positions, moment.rest_length_scale)
            if edit.springs is None:
                raise SceneError(say("edit-no-brace"))
            return edit
        case "rest":
            return take_as_rest(moment, selection if any(selection) else Selection(masses=some))
        case "keep" | "stiffen":
            return _keep_shape(moment, selection, what == "stiffen")
        case _:
            raise SceneError(say("edit-no-selection"))


def _add_line(moment: Moment, a: int | None, b: int | None, start: Vector, end: Vector) -> Edit:
    scene, positions, scale = moment.scene, build.positions_of(moment), moment.rest_length_scale
    n = len(scene.masses)
    if a is None and b is not None:
        return replace(build.extend(scene, b, start, positions, scale), select=_only(b))
    if a is None:
        first = build.add_mass(scene, start)
        second = build.extend(first.scene, n, end, [*positions, start], scale)
        return replace(build.joined("2 masses and a spring added", first, second), select=_only(n + 1))
    if b is None:
        return replace(build.extend(scene, a, end, positions, scale), select=_only(n))
    edit = build.add_springs(scene, [(a, b)], positions, scale)
    return replace(edit if edit.springs else Edit("", scene), select=_only(b))


def _add_joint(moment: Moment, a: int, b: int) -> Edit:
    scene, positions = moment.scene, build.positions_of(moment)
    refuse_missing((a, b), len(scene.linear_springs), "spring")
    angle = build.angle_between(scene, a, b, positions) - moment.rest_angle_shift
    edit = build.add_joints(scene, [(a, b)], [angle])
    if edit.joints is None:
        return Edit("", scene)
    return replace(edit, select=Selection(joints=frozenset({len(scene.angular_springs)})))


def _turn_joint(moment: Moment, joint: int, angle: float | None) -> Edit:
    scene = moment.scene
    refuse_missing([joint], len(scene.angular_springs), "joint")
    if angle is None:
        two = scene.angular_springs[joint]
        angle = build.angle_between(scene, two.a, two.b, build.positions_of(moment))
    angle -= moment.rest_angle_shift
    if moment.damage is not None and moment.damage.set_angles:
        angle -= moment.damage.set_angles[joint]
    edit = set_number(scene, number("angular_springs", "rest_angle"), [joint], build.wrapped_degrees(angle))
    return replace(edit, select=Selection(joints=frozenset({joint})))


def _keep_shape(moment: Moment, selection: Selection, allow_stiffening: bool) -> Edit:
    """Make the selected springs and joints, and all those at selected masses, hold the present shape."""
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
    held = keep_shape_at(moment, parts, allow_stiffening)
    assert held.pose is not None
    shift = np.array(held.pose.positions).T - moment.rows[:2]
    starts = scene.pose.positions if scene.pose else tuple(mass.position for mass in scene.masses)
    # A body that starts in this shape starts at rest.
    made = held if starts != held.pose.positions else msgspec.structs.replace(held, pose=scene.pose)
    return Edit("keep this shape", made, shift=shift if shift.any() else None, stops=True)


def _move(moment: Moment, masses: frozenset[int], by: Vector, rest: bool) -> Edit:
    if not masses:
        raise SettingError(say("edit-no-move"))
    edit = shape.move(moment.scene, masses, by)
    if not (rest and any(s.a in masses or s.b in masses for s in moment.scene.linear_springs)):
        return edit
    resting = take_as_rest(carried(edit, moment), Selection(masses=masses))
    return replace(edit, scene=resting.scene)


def _copy(moment: Moment, masses: frozenset[int]) -> copying.Fragment:
    return copying.copy(moment.scene, masses, build.positions_of(moment))


def _paste(moment: Moment, fragment: copying.Fragment, at: Vector) -> Edit:
    scene = moment.scene
    edit = copying.paste(scene, fragment, at)
    olds = len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)
    news = edit.scene.masses, edit.scene.linear_springs, edit.scene.angular_springs
    select = Selection(*(frozenset(range(old, len(new))) for old, new in zip(olds, news, strict=True)))
    return replace(edit, select=select)


def _only(mass: int) -> Selection:
    return Selection(masses=frozenset({mass}))


def _center(values: Sequence[float]) -> float:
    return (min(values) + max(values)) / 2.0


def _to_scene(scene: Scene, x: float, y: float) -> Vector:
    """Convert a point of the page's world to the scene, px."""
    return Mapping.of(scene).to_scene(x, y)


def _vector(scene: Scene, x: float, y: float) -> Vector:
    """Convert a displacement in the page's world to the scene, px."""
    (x0, y0), (x1, y1) = _to_scene(scene, 0.0, 0.0), _to_scene(scene, x, y)
    return x1 - x0, y1 - y0
