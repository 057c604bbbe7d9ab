"""What a page shows of its session, sent as far as it has changed."""

from __future__ import annotations

from collections.abc import Callable

from sim.scene.types import Scene

from ...session.framing import Framing
from ...stage.colors import palette
from ...stage.plan import broken_of, own_rest_angles
from ...stage.sketch import Mapping
from ...stage.together import together
from ...ui import readouts
from ...ui.controls import Controls
from ...ui.feature import Drawn, Feature
from ...ui.kept.keeping import DEFAULT_LOOKS
from ...ui.page import Page
from ...ui.panel import set_theme
from ...ui.view import Canvas, picture_of
from ...wire.to_page import Hud
from .page_panel import PagePanel
from .state import page_state
from .stillness import Stillness


class PageView:
    """Sends plan, picture, state, texts and controls of one page.

    Args:
        page: the page.
        features: its features.
        canvas: draws the body.
        panel: its panel.
        number: the id of its connection.
        wanted_controls: the controls that the page is to have with a scene.

    Attributes:
        generation: of the body that is shown; -1 to have it built again.
        stillness: whether it stands still.
    """

    def __init__(
        self,
        page: Page,
        features: tuple[Feature, ...],
        canvas: Canvas,
        panel: PagePanel,
        number: str,
        wanted_controls: Callable[[Scene], Controls],
    ) -> None:
        self._page, self._features, self._canvas, self._panel = page, features, canvas, panel
        self._number, self._wanted_controls = number, wanted_controls
        self._session = page.session
        self.generation = -1
        self.stillness = Stillness()
        self._planned = self._last_revision = -1  # revisions of the session
        self._scenes = page.session.scenes
        self._was_running = True
        self._at_rest = False
        self._broken = 0
        self._looks = DEFAULT_LOOKS
        self._framing = Framing()

    @property
    def unsettled(self) -> bool:
        """True if a control shows a value that is not set yet, or will have more to show."""
        return any(feature.unsettled for feature in self._features)

    def apply_looks(self) -> None:
        """Switch theme and gizmos if they have been changed."""
        looks, shown = self._page.looks, self._looks
        self._looks = looks
        if looks.dark != shown.dark:
            set_theme(self._page.client.gui, dark=looks.dark)
            self.generation = -1
        if looks.gizmos != shown.gizmos:
            self._canvas.show_gizmos(looks.gizmos)

    def send(self) -> None:
        """Send what has changed."""
        if self._session.generation != self.generation:
            self.rebuild()
        if self._session.revision != self._planned:
            self._plan()
        drawn = self._show()
        for feature in self._features:
            feature.frame(drawn)

    def rebuild(self) -> None:
        """Build the nodes and the controls of another body."""
        session = self._session
        self._plan()
        self._canvas.show_gizmos(self._page.looks.gizmos)
        self._panel.update(self._wanted_controls(session.scene))
        if session.scenes != self._scenes:
            self._scenes = session.scenes
            for feature in self._features:
                feature.clear()
        for feature in self._features:
            feature.build()
        self.stillness.move(session.now())
        self.generation = session.generation

    def _plan(self) -> None:
        """Send the plan of the body if it has changed."""
        session = self._session
        self._planned = session.revision
        self._page.mapping = Mapping.of(session.scene)
        dark, others = self._page.looks.dark, session.companions.drawn
        self._canvas.build(session.scene, dark, own_rest_angles(session.simulation))
        self._canvas.build_second(together([one.capture().scene for one in others]) if others else None, dark)

    def _show(self) -> Drawn:
        """Send the picture, the state, the texts and the controls, as far as they have changed."""
        session, still = self._session, self.stillness
        now = session.now()
        running = session.playing and session.simulation.divergence is None
        # A changed setting and the end of a run are drawn exactly, a moving body only if it moved visibly.
        changed = session.revision != self._last_revision or running != self._was_running
        self._last_revision, self._was_running = session.revision, running
        picture = picture_of(session)
        if self._canvas.draw(picture, now, exactly=changed or not running):
            still.move(now)
        at_rest = still.is_at_rest(now)
        self._at_rest, self._broken = at_rest and running, len(broken_of(picture.damage))
        self.send_state(session.playing)
        if changed or still.is_refresh_due(now, self.unsettled):
            still.refresh(now, more_follows=session.stability_watch.is_looking)
            with self._page.client.atomic():
                for feature in self._features:
                    feature.refresh()
                looks = self._page.looks
                colors = palette(session.scene.view.colors, looks.dark)
                self._page.mail.send(Hud(html=readouts.hud(session, colors, at_rest, looks.meter)))
        return Drawn(self._canvas.pictures.plan_number, now, exactly=changed or not running)

    def send_state(self, playing: bool) -> None:
        """Send the state of the page if it has changed; `playing`: the clock runs, or is about to."""
        session = self._session
        bounds = self._framing.bounds(session.openings, session.scene, not session.simulation.plain)
        state = page_state(
            self._page, self._panel, self._number, playing, self._at_rest, self._broken, bounds
        )
        self._page.mail.send(state)
