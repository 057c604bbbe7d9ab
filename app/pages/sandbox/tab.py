"""One browser tab: its session, its picture and its panel, tied together.

All of it is the ticker's: it is made, drawn and thrown away in the ticker's thread. Handlers, which run on
viser's event loop or in its pool, only post commands and requests.
"""

from __future__ import annotations

import math
import secrets
import time
from collections.abc import Callable
from concurrent.futures import Future
from functools import partial
from typing import Any, Protocol

import viser

import sim
from app.classroom.live import Front
from sim.compiling.compiler import Compiler, cache_trouble, needed_by
from sim.errors import InputError, SceneError
from sim.methods.registry import METHODS
from sim.scene.lesson import Lesson
from sim.scene.types import shown_name

from ...features.classroom.front import FrontView
from ...features.classroom.role import Role
from ...features.gallery.feature import GalleryFeature
from ...features.measure.feature import MeasureFeature
from ...session import commands
from ...session.pacing import LONGEST_FRAME, is_large
from ...session.plots import Wish
from ...session.session import Changed, Notice, Session
from ...stage.colors import palette
from ...stage.plan import Picture, broken_of, own_rest_angles
from ...stage.sketch import Mapping, world_size
from ...ui import controls, readouts
from ...ui.controls import Controls
from ...ui.feature import Drawn, Feature
from ...ui.kept import keeping
from ...ui.kept.keeper import Keeper
from ...ui.notice_board import NoticeBoard
from ...ui.opening import asked_scene
from ...ui.page import Page
from ...ui.panel import Panel, set_theme
from ...ui.shelf import Shelf
from ...ui.view import Canvas, picture_of
from ...ui.waiting import Waiting
from ...viser_inside import element_id
from ...wire import from_page
from ...wire.carrier import Mail, listen
from ...wire.messages import Ask, FromPage, messages
from ...wire.to_page import Hud, PageState, Run
from .answers import Answers
from .features import COMMANDS, CONTROLS, FEATURES
from .probe import Probe

READOUTS_EVERY = 0.1
"""Seconds between two updates of texts and sliders; faster would only flicker."""

MAX_REQUESTS = 20
"""What one page may ask the ticker for in a frame; what comes faster waits, or is dropped."""

CALM_FRAME = 1.0
"""Seconds between two frames of a page on which nothing happens."""

UNTOUCHED = 1.0
"""Seconds for which its user has done nothing then."""

RESTING_AFTER = 0.5
"""Seconds without a visible movement after which the body counts as at rest."""


def compile_status(ready: int, of: int, busy_with: str, awaited: str) -> str:
    """How far the compiler is, as the page says it; empty if all is ready.

    Args:
        ready: number of parts that are compiled.
        of: number of all parts.
        busy_with: what is being compiled.
        awaited: the method that the body waits for, moved by NumPy meanwhile; empty if it does not wait.
    """
    if awaited:
        text = f"moves by NumPy until {awaited} is compiled: {ready} of {of} parts ready"
    elif ready < of:
        text = f"preparing {busy_with}: {ready} of {of} parts ready"
    else:
        return ""
    trouble = cache_trouble()
    return f"{text}; {trouble}" if trouble else text


class Submit(Protocol):
    """Has something done in another thread, as `ThreadPoolExecutor.submit`."""

    def __call__(self, work: Any, /, *arguments: Any, **options: Any) -> Future[Any]: ...


class Tab:
    """One page.

    Args:
        client: viser's handle of it.
        scene: what it shows first.
        compiler: makes kernels ready in the background.
        query: of the page's address, which may say which controls there are, and which scene comes first.
        owned: whether it is known to be the page of this computer's owner.
        for_others: the address by which others reach the page, from that by which it was reached itself.
        role_of: what the page is in a class, if it is in one, from its mail.
        begin_class: see `Page`.
        is_taught: whether a class goes through a lesson: then only the owner sees it outside the class.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        scene: sim.Scene,
        compiler: Compiler,
        query: str = "",
        owned: bool = False,
        for_others: Callable[[str], str] = str,
        role_of: Callable[[Mail], Role | None] = lambda _: None,
        begin_class: Callable[[sim.Scene], str] | None = None,
        is_taught: Callable[[Lesson], bool] = lambda _: False,
    ) -> None:
        self.client = client
        self._compiler = compiler
        self._notices = NoticeBoard(client)
        self._requests: Waiting[Callable[[Session], object]] = Waiting(self.notify)
        self._generation = -1
        self._number = secrets.token_hex(4)
        self._planned = -1
        self._shelf = Shelf(owned)
        self._readouts_due = 0.0
        self._moved_at = 0.0
        self._was_at_rest = self._rests = False
        self._broken = 0
        self._last_revision = -1
        self._was_playing = True
        self._wanted = ""
        self._all_ready = False
        self._for_others = for_others
        self._begin_class = begin_class
        self._is_taught = is_taught
        self._mail = Mail(client)
        self._role = role_of(self._mail)
        # In a class, the class says what is shown.
        self._first = scene = (self._asked_scene(query) if self._role is None else None) or scene
        self._view = Canvas(client, self._mail, self._post)
        self._front: Front | None = None
        self._front_view = FrontView(client, self._mail, self._view, self._number)
        listen(client, self.hear)
        self._asked_controls = self._checked(partial(controls.of_query, parts=CONTROLS), query)
        self._scenes_controls = controls.ALL
        self._named_controls: tuple[str, ...] | None = None
        self._features: tuple[Feature, ...] = ()
        self._hearers: dict[type, list[tuple[Feature, str]]] = {}
        self._session: Session | None = None
        self._calm, self._stirred = False, time.monotonic()
        self._under_way: Future[Any] | None = None
        self._mapping = Mapping.of(scene)
        self._looks = keeping.PLAIN
        self._view.build(scene, self._looks.dark)
        self._view.draw(Picture.at_start(scene), time.monotonic())

    def leave(self) -> None:
        """The page is gone."""
        self._front_view.leave()
        if self._role is not None:
            self._role.leave()

    @property
    def session(self) -> Session | None:
        """The page's simulation; None until the first picture has been sent."""
        return self._session

    def probe(self) -> Probe:
        """What is so now, for a test; any thread may look, once there is a session."""
        page, hud = self._page, self._mail.last_sent(Hud)
        return Probe(
            generation=self._generation,
            state=self._mail.last_sent(PageState),
            hud=hud.html if hud is not None else "",
            looks=page.looks,
            controls=page.controls.names,
            plots=self._wishes,
            plots_seen=(measure := page.find(MeasureFeature)) is not None and measure.is_seen,
            kept=self._keeper.kept,
            owned=self._shelf.owned,
            requests=len(self._requests),
            nodes=self._view.nodes,
            mapping=self._mapping,
            drawn=self._view.drawn,
        )

    # --------------------------------------------------------------------- handlers, any thread
    def hear(self, said: FromPage) -> None:
        """Do what the page says, or have the ticker do it; nothing in it is trusted."""
        session, role = self._session, self._role
        if session is None or (role is not None and not role.allows(said)):
            return
        match said:
            case from_page.Visit():
                session.post(commands.Visit())
            case from_page.Perform(command):
                self.perform(command)
            case from_page.Part():
                self._answers.take(said)
            case from_page.Who() | from_page.Unread() | from_page.Unsent():
                self._answers.ask(said)
                if role is not None and isinstance(said, from_page.Who):
                    self._requests.add(lambda now: role.introduce(said, now))
            case from_page.InSeat() | from_page.Lead() | from_page.Checked():
                if role is not None:
                    self._requests.add(lambda now: role.hear(said, now))
            case _:
                pass
        for feature, needs in self._hearers.get(type(said), ()):
            if needs and needs not in self._page.controls:
                continue
            if isinstance(said, Ask):
                self._answers.later(feature.hear, said)
            else:
                feature.hear(said)

    def perform(self, command: str) -> None:
        """Do a command of the table, if the page has the control that it needs."""
        row, session = COMMANDS.get(command), self._session
        if row is None or session is None or (row.needs and row.needs not in self._page.controls):
            return
        does = row.does
        if does in ("edit", "own"):
            return
        if does == "page":
            self._mail.send(Run(command=command))
        elif callable(does):
            owner = next(one for one in self._features if command in one.commands)
            self._requests.add(lambda now: does(now, owner))
        else:
            session.post(does)

    def notify(self, notice: Notice) -> None:
        """Have the user told something."""
        self._notices.add(notice)

    def snapshot(self) -> sim.Scene:
        """The scene as it is now, with its pose; as it comes first where the page is not drawn yet.

        Raises:
            InputError: the ticker did not answer.
        """
        session = self._session
        return self._first if session is None else session.snapshot(session.scene.name, with_pose=True)

    def _post(self, command: commands.Command) -> None:
        if self._session is not None:
            self._session.post(command)

    # --------------------------------------------------------------------- the ticker's
    @property
    def is_calm(self) -> bool:
        """Whether a frame now and then will do: its body rests or stands, and nobody does anything."""
        return self._calm and not (self._requests or self._notices.has_new or self._has_commands)

    @property
    def _has_commands(self) -> bool:
        return self._session is not None and (self._session.has_commands or self._page.is_asked)

    def stir(self) -> None:
        """The page has said something, of whatever kind; any thread may call."""
        self._stirred = time.monotonic()

    def _is_settled(self, session: Session) -> bool:
        """Whether the page is told all that there is to tell, and nothing goes on but the clock."""
        waits = (
            not self._all_ready or self._notices.has_transient or self._unsettled or self._role is not None
        )
        lists = [*self._page.plots] if session.playing else []
        plots = any(each.wishes and each.looked_at for each in lists)
        untouched = time.monotonic() - self._stirred > UNTOUCHED
        return untouched and self._was_at_rest and not (waits or plots) and session.is_left_alone

    def frame(self, budget: float, beside: Submit) -> bool:
        """One frame, of `budget` seconds of computing at most; returns whether the page is told anything.

        What a heavy body needs is done by `beside`, in another thread. Until that is done the session is that
        thread's, and the page keeps its picture.
        """
        session, calm = self._session, self._calm
        if not self.is_calm and calm:
            self.stir()  # something was asked for
        self._calm = False
        if self._under_way is not None:
            if not self._under_way.done():
                if session is not None:
                    self._set_state(session.will_play)
                return True
            done, self._under_way = self._under_way, None
            made = done.result()
        elif session is None:
            if is_large(self._first):
                self._under_way = beside(Session, self._first, wait=False)
                return True
            made = Session(self._first, wait=False)
        else:
            made = session
            self._serve_requests(session)
            self._apply_looks()
            if self._role is not None:
                self._role.frame(session)
                told = self._show_teachers_body(session, self._role.front)
                if self._front is not None:
                    return told
            self._prepare(session)
            if session.heavy:
                self._under_way = beside(self._advance, session, budget)
                return True
            self._advance(session, budget, CALM_FRAME + LONGEST_FRAME if calm else LONGEST_FRAME)
        # All at once: viser 1.1.1 sets an `asyncio.Event` from this thread at every message, which raises if
        # its event loop is just waking up from the one before. And no panel comes in parts.
        with self.client.atomic():
            session = session or self._begin(made)
            self._send(session)
        self._keeper.keep(self._wishes, self._was_at_rest)
        self._calm = self._is_settled(session)
        return True

    def _show_teachers_body(self, session: Session, front: Front | None) -> bool:
        """Show what the teacher's page does, if there is that, instead of the page's own body.

        Returns:
            whether the page was told anything.
        """
        before, self._front = self._front, front
        if (before is None) != (front is None):
            self._generation = -1
            self._front_view.leave()
        if front is None:
            return False
        show, anew = self._front_view.show, self._generation != session.generation
        if not (anew or session.notices or self._notices.has_new or self._notices.has_transient):
            return show(front, self._page.looks.dark, session.now())
        with self.client.atomic():
            if anew:
                self._front_view.leave()
                self._rebuild(session)
            self._notices.show(session)
            show(front, self._page.looks.dark, session.now())
        return True

    def _send(self, session: Session) -> None:
        """Send what the page does not know yet."""
        if session.generation != self._generation:
            self._rebuild(session)
        if session.revision != self._planned:
            self._plan(session)
        drawn = self._show(session)
        for feature in self._features:
            feature.frame(drawn)
        self._notices.show(session)

    @staticmethod
    def _advance(session: Session, budget: float, longest: float = LONGEST_FRAME) -> None:
        session.drain()
        session.tick(budget, longest)

    def _begin(self, session: Session) -> Session:
        """What is made after the first picture has been sent."""

        self._page = Page(
            self.client, session, self._mail, self.notify, self.perform, self._shelf,
            commands=COMMANDS, controls=self._wanted_controls(session.scene), begin_class=self._begin_class,
            is_closed=self._is_closed, is_in_class=self._role is not None,
            for_others=self._for_others, soon=lambda act: self._requests.add(lambda _: act()),
        )  # fmt: skip
        self._add_features()
        role = self._role
        self._keeper = Keeper(self._page, role.keep if role is not None else lambda _: False)
        self._answers = Answers(
            self._page, self._features, lambda kept: self._page.soon(lambda: self._resume(kept))
        )
        self._make_panel(session)
        self._session = session
        return session

    def _add_features(self) -> None:
        self._page.features = self._features = tuple(feature(self._page) for feature in FEATURES)
        for feature in self._features:
            for kind, needs in feature.messages.items():
                for message in messages(kind):
                    self._hearers.setdefault(message, []).append((feature, needs))

    def _asked_scene(self, query: str) -> sim.Scene | None:
        """The scene that the page's address asks for; if there is none, its user is told and may choose."""
        try:
            return asked_scene(query)
        except SceneError as error:
            # Later, when the page knows how to ask for the scenes that there are.
            why = f"{str(error)[:1].upper()}{str(error)[1:]}."
            self._requests.add(lambda _: self._say_not_found(why))
            return None

    def _is_closed(self, lesson: Lesson) -> bool:
        """Whether the page is not to show a lesson: what is right in it comes when the class comes to it."""
        return self._role is not None or (not self._shelf.owned and self._is_taught(lesson))

    def _wanted_controls(self, scene: sim.Scene) -> Controls:
        """Those that its place in a class gives it, or that the page's address names, or else the scene."""
        if self._role is not None and (given := self._role.controls) is not None:
            return given
        if self._asked_controls is None and scene.view.controls != self._named_controls:
            self._named_controls = scene.view.controls
            self._scenes_controls = (
                self._checked(partial(controls.of_scene, parts=CONTROLS), scene) or controls.ALL
            )
        return self._asked_controls or self._scenes_controls

    def _checked(self, find: Callable[[Any], Controls | None], source: Any) -> Controls | None:
        """The controls that are found; if one of them is none, its user is told, and all are there."""
        try:
            return find(source)
        except InputError as error:
            self.notify(Notice("error", "All controls are shown", str(error)))
            return None

    def _make_panel(self, session: Session) -> None:
        """The panel, with the controls that there are."""
        page = self._page
        self._panel = Panel(page)
        self._has_lesson = page.has_lesson
        for feature in self._features:
            feature.attach(self._panel)
        play = self._panel.find("Play")
        if self._role is not None and play is not None:
            with play:
                self.client.gui.add_html(self._role.place, order=0)
        self._panel.finish()

    def _prepare(self, session: Session) -> None:
        """Have compiled first what the session waits for, and say what it is and how far it is."""
        method = session.simulation.method
        if self._all_ready and not session.simulation.plain:
            return
        if session.simulation.plain and method != self._wanted:
            self._wanted = method
            self._compiler.want(needed_by(method))
        ready, of = self._compiler.progress
        self._all_ready = ready == of
        label = METHODS[method].label if session.simulation.plain else ""
        text = compile_status(ready, of, self._compiler.busy_with, label)
        if text != session.preparing:
            session.preparing = text
            session.note(Changed.SETTINGS)

    def _rebuild(self, session: Session) -> None:
        """Another body: other nodes and other controls."""
        self._plan(session)
        self._view.show_gizmos(self._page.looks.gizmos)
        wanted, has_lesson = self._wanted_controls(session.scene), self._page.has_lesson
        if (wanted, has_lesson) != (self._page.controls, self._has_lesson):
            was_empty = self._panel.is_empty
            self._page.controls = wanted
            for feature in self._features:
                feature.detach()
            self.client.gui.reset()
            self._page.clear()
            self._make_panel(session)
            if was_empty and not self._panel.is_empty:
                self.client.gui.main_panel.expand()
        for feature in self._features:
            feature.build()
        self._moved_at = session.now()
        self._generation = session.generation

    def _plan(self, session: Session) -> None:
        """Tell the page of the body, as far as it is another one."""
        self._planned = session.revision
        self._mapping = self._page.mapping = Mapping.of(session.scene)
        dark, second = self._page.looks.dark, session.companions.second
        self._view.build(session.scene, dark, own_rest_angles(session.simulation))
        self._view.build_second(second.capture().scene if second is not None else None, dark)

    @property
    def _wishes(self) -> tuple[Wish, ...]:
        """What is plotted."""
        measure = self._page.find(MeasureFeature)
        return measure.wishes if measure is not None else ()

    @property
    def _unsettled(self) -> bool:
        """Whether a control shows what is not set, or there will be more to show."""
        return any(feature.unsettled for feature in self._features)

    def _show(self, session: Session) -> Drawn:
        """Send the picture, the texts and the controls, as far as they changed."""
        now = session.now()
        running = session.playing and session.simulation.divergence is None
        # A change of the controls, or the end of a run, is drawn exactly; a moving body only when it shows.
        changed = session.revision != self._last_revision or running != self._was_playing
        self._last_revision, self._was_playing = session.revision, running
        picture = picture_of(session)
        if self._view.draw(picture, now, force=changed or not running):
            self._moved_at = now
        at_rest = now - self._moved_at > RESTING_AFTER
        self._broken = len(broken_of(picture.damage))
        self._rests = at_rest and running
        self._set_state(session.playing)
        still = at_rest and self._was_at_rest and not self._unsettled
        if changed or (now >= self._readouts_due and not still):
            self._readouts_due = now + READOUTS_EVERY
            self._was_at_rest = at_rest and not session.stability_watch.is_looking
            with self.client.atomic():
                for feature in self._features:
                    feature.refresh()
                colors, looks = palette(session.scene.view.colors, self._page.looks.dark), self._page.looks
                self._mail.send(Hud(html=readouts.hud(session, colors, at_rest, looks.meter)))
        return Drawn(self._view.plan_number, now, exactly=changed or not running)

    def _set_state(self, playing: bool) -> None:
        """Tell the page's script how things are."""
        if (session := self._session) is None:
            return
        history, joint = session.history, session.joint
        width, height = world_size(session.scene)
        scrubbed, measures = history.scrubbed, self._panel.find("Measure")
        state = PageState(
            page=self._number,
            scene=session.openings,
            title=shown_name(session.scene),
            width=width,
            height=height,
            unit=session.scene.view.unit,
            joint=joint if session.scene.angular_springs else -1,
            playing=playing,
            rest=self._rests and playing,
            scrubbed=scrubbed,
            # Coarse while time passes, so that this seldom changes.
            start=history.start if scrubbed else math.floor(2.0 * history.start) / 2.0,
            end=history.end if scrubbed else 0.0,
            speed=session.pacer.speed,
            offer=session.offer_back,
            future=session.old_future is not None,
            follow=session.follow,
            broken=self._broken,
            controls=tuple(name for name in CONTROLS if name in self._page.controls),
            gizmos=self._page.looks.gizmos,
            meter=self._page.looks.meter,
            measuring=element_id(measures) if measures is not None else "",
            lesson=session.lesson_begun if self._has_lesson else None,
        )
        self._mail.send(state)

    def _apply_looks(self) -> None:
        """Show how the page is to look."""
        looks, shown = self._page.looks, self._looks
        self._looks = looks
        if looks.dark != shown.dark:
            set_theme(self.client.gui, dark=looks.dark)
            self._generation = -1
        if looks.gizmos != shown.gizmos:
            self._view.show_gizmos(looks.gizmos)

    def _resume(self, kept: keeping.Kept) -> None:
        """Go on from a saved state.

        The plots are remembered before the body comes: with it they are put up.
        """
        self._keeper.resume(kept)
        if (measure := self._page.find(MeasureFeature)) is not None:
            measure.remember(kept.plots)

    def _serve_requests(self, session: Session) -> None:
        self._page.serve()
        # No more in a frame than a person can ask for: others wait for the same thread.
        for _ in range(min(len(self._requests), MAX_REQUESTS)):
            self._requests.take()(session)

    def _say_not_found(self, why: str) -> None:
        gallery = self._page.find(GalleryFeature)
        if gallery is not None and "chooser" in self._page.controls:
            gallery.offer(why)
        else:
            self.notify(Notice("error", "That address has no scene", why))
