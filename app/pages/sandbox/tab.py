"""One browser tab: ties together its session, its canvas, its panel and its features.

Everything here belongs to the ticker's thread, which makes, draws and discards the tab. Handlers, which run
on viser's event loop or in its thread pool, only post commands and requests.
"""

from __future__ import annotations

import secrets
import time
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

import viser

import sim
from app.classroom.live import SharedView
from sim.compiling.compiler import Compiler
from sim.scene.lesson import Lesson

from ...features.classroom import messages as class_messages
from ...features.classroom.role import Role
from ...features.classroom.shared_view import Onlooker
from ...features.gallery.feature import GalleryFeature
from ...features.measure.feature import MeasureFeature
from ...session import commands
from ...session.pacing import LONGEST_FRAME, is_large
from ...session.plots import PlotSpec
from ...session.preparation import Preparation
from ...session.session import Notice, Session
from ...stage.plan import Picture
from ...ui.controls import Controls
from ...ui.feature import Feature
from ...ui.kept import keeping
from ...ui.kept.keeper import Keeper
from ...ui.notice_board import NoticeBoard
from ...ui.page import Page
from ...ui.queues import BoundedQueue
from ...ui.shelf import Shelf
from ...ui.ticked import CALM_FRAME, STOPPED, RunInThread
from ...ui.view import Canvas
from ...wire import from_page
from ...wire.carrier import Mail, by_viser, listen
from ...wire.messages import Ask, FromPage, messages
from ...wire.to_page import Hud, Keepsake, PageState, Run
from ...words import language, say
from .address import PageAddress
from .features import COMMANDS, FEATURES
from .page_panel import PagePanel
from .page_view import PageView
from .probe import Probe
from .requests import RequestHandler

MAX_REQUESTS = 20
"""Requests of one page that the ticker serves in a frame, so that one page cannot starve the others."""

UNTOUCHED = 1.0
"""Seconds without input after which nothing happens on a page."""


class Tab:
    """One page; it is made in the language of its user.

    Args:
        client: viser's handle of it.
        scene: the scene that is shown first, if the address asks for none.
        compiler: compiles kernels in the background.
        query: of the page's address, which may name controls and a scene.
        owned: the page is known to be that of this computer's owner.
        for_others: converts the address of the page into one by which others reach it.
        role_of: makes the role of the page in a class from its mail; None if it is in no class.
        begin_class: see `Page`.
        stands: whether a body that is opened stands until it is played.
        is_taught: returns True while a class goes through a lesson, which only the owner then sees elsewhere.
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
        stands: bool = False,
    ) -> None:
        self.client, self.language = client, language()
        self._stands = stands
        self._for_others, self._begin_class, self._is_taught = for_others, begin_class, is_taught
        self._mail = Mail(by_viser(client))
        self._notices = NoticeBoard(client)
        self._requests: BoundedQueue[Callable[[Session], object]] = BoundedQueue(self.notify)
        self._number = secrets.token_hex(4)
        self._shelf = Shelf(owned)
        self._preparation = Preparation(compiler)
        self._address = PageAddress(query, self.notify)
        self._role = role_of(self._mail)
        # In a class, the class decides what is shown.
        self._first = scene = (self._address.scene() if self._role is None else None) or scene
        self._session: Session | None = None
        self._features: tuple[Feature, ...] = ()
        self._receivers: dict[type, list[tuple[Feature, str]]] = {}
        self._calm, self._stirred = False, time.monotonic()
        self._under_way: Future[Any] | None = None
        self._view = Canvas(client, self._mail, self._post)
        self._shared_view: SharedView | None = None
        self._onlooker = Onlooker(self._mail, self._view, self._number)
        listen(client, self.hear)
        self._view.build(scene, keeping.DEFAULT_LOOKS.dark)
        self._view.draw(Picture.at_start(scene), time.monotonic())

    def leave(self) -> None:
        """See `Ticked`."""
        self._onlooker.leave()
        if self._role is not None:
            self._role.leave()

    def flush(self) -> None:
        """See `Ticked`."""
        self.client.flush()

    def stop(self) -> None:
        """See `Ticked`."""
        title, text = map(say, STOPPED)
        self.client.add_notification(title, text, color="red")
        self.client.flush()

    @property
    def session(self) -> Session | None:
        """The page's simulation; None until the first picture has been sent."""
        return self._session

    def probe(self) -> Probe:
        """Describe the present state for a test; any thread may call once there is a session."""
        page, hud, saved = self._page, self._mail.last_sent(Hud), self._mail.last_sent(Keepsake)
        return Probe(
            generation=self._shown.generation,
            state=self._mail.last_sent(PageState),
            hud=hud.html if hud is not None else "",
            looks=page.looks,
            controls=page.controls.names,
            plots=self._plots,
            plots_seen=(measure := page.find(MeasureFeature)) is not None and measure.is_seen,
            kept=self._keeper.kept,
            saved=saved.kept if saved is not None else "",
            owned=self._shelf.owned,
            requests=len(self._requests),
            nodes=self._view.nodes,
            mapping=page.mapping,
            drawn=self._view.pictures.drawn,
        )

    # --------------------------------------------------------------------- handlers, any thread
    def hear(self, said: FromPage) -> None:
        """Handle a message of the page, or leave it to the ticker; nothing in it is trusted."""
        session, role = self._session, self._role
        if session is None or (role is not None and not role.allows(said)):
            return
        match said:
            case from_page.Visit():
                session.post(commands.Visit())
            case from_page.Perform(command):
                self.perform(command)
            case from_page.Part():
                self._handler.take(said)
            case from_page.Who() | from_page.Unsent():
                self._handler.ask(said)
                if role is not None and isinstance(said, from_page.Who):
                    self._requests.add(lambda now: role.introduce(said, now))
            case class_messages.InSeat() | class_messages.Lead() | class_messages.Checked():
                if role is not None:
                    self._requests.add(lambda now: role.hear(said, now))
            case _:
                pass
        for feature, needs in self._receivers.get(type(said), ()):
            if needs and needs not in self._page.controls:
                continue
            if isinstance(said, Ask):
                self._handler.later(feature.hear, said)
            else:
                feature.hear(said)

    def perform(self, command: str) -> None:
        """Execute a command of the table, if the page has the control that it needs."""
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
        """Show a notice to the user with the next frame."""
        self._notices.add(notice)

    def snapshot(self) -> sim.Scene:
        """The scene with its present pose; the first scene if nothing is drawn yet.

        Raises:
            InputError: the ticker did not answer.
        """
        session = self._session
        return self._first if session is None else session.snapshot(session.scene.name, with_pose=True)

    def stir(self) -> None:
        """Note that a message arrived, of any kind; any thread may call."""
        self._stirred = time.monotonic()

    def _post(self, command: commands.Command) -> None:
        if self._session is not None:
            self._session.post(command)

    # --------------------------------------------------------------------- frames
    @property
    def is_calm(self) -> bool:
        """True if an occasional frame is enough: the body is at rest, and nobody does anything."""
        return self._calm and not (self._requests or self._notices.has_new or self._has_commands)

    @property
    def looks_on(self) -> bool:
        """See `Ticked`."""
        return self._shared_view is not None

    @property
    def _has_commands(self) -> bool:
        return self._session is not None and (self._session.has_commands or self._page.has_requests)

    def _is_settled(self, session: Session) -> bool:
        """Return True if there is nothing left to send, and only the clock advances."""
        shown = self._shown
        waits = not self._preparation.is_done or self._notices.has_transient or shown.unsettled
        plotting = session.playing and any(each.specs and each.looked_at for each in self._page.plots)
        untouched = time.monotonic() - self._stirred > UNTOUCHED
        still = shown.stillness.is_shown and not (waits or plotting or self._role is not None)
        return untouched and still and session.is_idle

    def frame(self, budget: float, beside: RunInThread) -> bool:
        """Compute and send one frame, and return True if anything may have been sent.

        What a heavy body needs is computed in another thread. Until that is done the session belongs to that
        thread, and the page shows its last picture.

        Args:
            budget: seconds of computing time.
            beside: runs the work of a heavy body.
        """
        session, calm = self._session, self._calm
        if not self.is_calm and calm:
            self.stir()  # there is a request
        self._calm = False
        if self._under_way is not None:
            if not self._under_way.done():
                if session is not None:
                    self._shown.send_state(session.will_play)
                return True
            done, self._under_way = self._under_way, None
            made = done.result()
        elif session is None:
            if is_large(self._first):
                self._under_way = beside(Session, self._first, wait=False, stands=self._stands)
                return True
            made = Session(self._first, wait=False, stands=self._stands)
        else:
            made = session
            self._serve_requests(session)
            self._shown.apply_looks()
            if self._role is not None:
                self._role.frame(session)
                sent = self._show_teachers_body(session, self._role.shared_view)
                if self._shared_view is not None:
                    return sent
            self._preparation.update(session)
            if session.is_heavy:
                self._under_way = beside(self._advance, session, budget)
                return True
            self._advance(session, budget, CALM_FRAME + LONGEST_FRAME if calm else LONGEST_FRAME)
        # In one batch: viser 1.1.1 sets an `asyncio.Event` from this thread at every message, which raises if
        # its event loop is just waking up from the one before. And no panel appears in parts.
        with self.client.atomic():
            session = session or self._begin(made)
            self._shown.send()
            self._notices.show(session)
        self._keeper.keep(self._plots, self._shown.stillness.is_shown)
        self._calm = self._is_settled(session)
        return True

    @staticmethod
    def _advance(session: Session, budget: float, longest: float = LONGEST_FRAME) -> None:
        session.drain()
        session.tick(budget, longest)

    def _serve_requests(self, session: Session) -> None:
        self._page.serve()
        for _ in range(min(len(self._requests), MAX_REQUESTS)):
            self._requests.take()(session)

    def _show_teachers_body(self, session: Session, view: SharedView | None) -> bool:
        """Show the teacher's body instead of the page's own, if there is one to show.

        Returns:
            True if anything was sent.
        """
        before, self._shared_view = self._shared_view, view
        if (before is None) != (view is None):
            self._shown.generation = -1
            self._onlooker.leave()
        if view is None:
            return False
        show, is_new = self._onlooker.show, self._shown.generation != session.generation
        if not (is_new or session.notices or self._notices.has_new or self._notices.has_transient):
            return show(view, self._page.looks.dark, session.now())
        with self.client.atomic():
            if is_new:
                self._onlooker.leave()
                self._shown.rebuild()
            self._notices.show(session)
            show(view, self._page.looks.dark, session.now())
        return True

    # --------------------------------------------------------------------- beginning
    def _begin(self, session: Session) -> Session:
        """Make the panel and the features, after the first picture has been sent."""
        self._page = Page(
            self.client, session, self._mail, self.notify, self.perform, self._shelf,
            commands=COMMANDS, controls=self._wanted_controls(session.scene), begin_class=self._begin_class,
            is_closed=self._is_closed, is_in_class=self._role is not None,
            for_others=self._for_others, soon=lambda act: self._requests.add(lambda _: act()),
        )  # fmt: skip
        self._add_features()
        role = self._role
        self._keeper = Keeper(self._page, role.keep if role is not None else lambda _: False)
        self._handler = RequestHandler(
            self._page, self._features, lambda saved: self._page.soon(lambda: self._resume(saved))
        )
        panel = PagePanel(self._page, self._features)
        self._shown = PageView(
            self._page, self._features, self._view, panel, self._number, self._wanted_controls
        )
        self._session = session
        if self._address.problem:
            # With the next frame, when the page can show the gallery.
            self._requests.add(lambda _: self._offer_other_scenes(self._address.problem))
        return session

    def _add_features(self) -> None:
        self._page.features = self._features = tuple(feature(self._page) for feature in FEATURES)
        for feature in self._features:
            for kind, needs in feature.messages.items():
                for message in messages(kind):
                    self._receivers.setdefault(message, []).append((feature, needs))

    def _is_closed(self, lesson: Lesson) -> bool:
        """Return True if the page must not show a lesson, whose answers come when the class reaches them."""
        return self._role is not None or (not self._shelf.owned and self._is_taught(lesson))

    def _wanted_controls(self, scene: sim.Scene) -> Controls:
        """The controls of the page's role in a class, or of its address, or else of the scene."""
        if self._role is not None and (given := self._role.controls) is not None:
            return given
        return self._address.controls(scene)

    def _offer_other_scenes(self, why: str) -> None:
        """Say why the scene of the address is not shown, in the gallery if there is one."""
        gallery = self._page.find(GalleryFeature)
        if gallery is not None and "chooser" in self._page.controls:
            gallery.offer(why)
        else:
            self.notify(Notice("error", say("ui-no-scene"), why))

    def _resume(self, saved: keeping.SavedPage) -> None:
        """Restore a saved state; the plots first, since they are made when the body is built."""
        self._keeper.resume(saved)
        if (measure := self._page.find(MeasureFeature)) is not None:
            measure.remember(saved.plots)

    @property
    def _plots(self) -> tuple[PlotSpec, ...]:
        """The open plots."""
        measure = self._page.find(MeasureFeature)
        return measure.specs if measure is not None else ()
