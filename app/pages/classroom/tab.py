"""A page of a pupil, or of the wall, on the server: its session, its picture, and what it works with.

Everything here belongs to the ticker's thread; `hear` and `stir` may be called from any.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

import sim
from app.classroom.live import SharedView
from app.classroom.plotted import Plotted
from sim.compiling.compiler import Compiler
from sim.errors import InputError, SettingError
from sim.scene.types import keys_of
from sim.settings import CHOICES, Choice, Setting, setting_of

from ...export.body.program import unknown_forces
from ...export.live.data import body_data
from ...export.live.sliders import TUTORIAL, sliders
from ...features.classroom import messages
from ...features.classroom.role import NOTHING, Role
from ...features.classroom.shared_view import Onlooker
from ...features.describe.describer import Describer
from ...features.describe.messages import Describe, Described
from ...features.hands.feature import hand_commands
from ...features.time.messages import Speed
from ...lessons import quantity_text
from ...session import commands
from ...session.pacing import LONGEST_FRAME
from ...session.plots import Plot
from ...session.preparation import Preparation
from ...session.session import Session
from ...stage.colors import plain
from ...stage.pictures import Pictures
from ...stage.plan import own_rest_angles
from ...stage.sketch import Mapping, Sketch, world_size
from ...ui.controls import Controls
from ...ui.queues import BoundedQueue
from ...ui.ticked import STOPPED, RunInThread
from ...ui.view import picture_of
from ...wire import from_page
from ...wire.carrier import Mail
from ...wire.line import Line
from ...wire.messages import FromPage
from ...wire.to_page import PageState
from ...words import language, say
from ...words.english import name_of
from ...words.settings import label_of, label_of_choice, options_of

MAX_REQUESTS = 20
"""Requests of one page that are served in a frame."""

LEAST_FRAME = 1.0 / 30.0
"""Seconds between two pictures of a page, at least: it draws those between them itself."""

LOOK_EVERY = 1.0 / 15.0
"""Seconds between two looks at the class for a page without a body of its own: the pictures of a moving body
reach it at once, see `shared_view`."""

KEPT_EVERY = 2.0
"""Seconds between two keepsakes of a body."""

MAX_ALONE = 200
"""Masses of a body with which a page goes on alone, at most."""

ALONE = {TUTORIAL: TUTORIAL, "velocity_verlet": "verlet", "auto": "verlet"}
"""Methods of bodies with which a page goes on alone, and by which of a live file's it does."""

PERFORMED: dict[str, commands.Command] = {
    "play": commands.Play(None),
    "run": commands.Play(True),
    "pause": commands.Play(False),
    "reset": commands.Reset(),
    "before": commands.BackBeforeDivergence(),
}
"""Commands of the table that such a page has."""


class ClassTab:
    """One page; it is made in the language of its user.

    Args:
        line: its connection.
        scene: what it shows until the class says otherwise.
        compiler: compiles kernels in the background.
        role_of: makes the role of the page from its mail.
        send: has the line's letters sent after this frame.
    """

    def __init__(
        self,
        line: Line,
        scene: sim.Scene,
        compiler: Compiler,
        role_of: Callable[[Mail], Role],
        send: Callable[[Line], object],
    ) -> None:
        self.language = language()
        self._line, self._send = line, send
        self._mail = Mail(line.post)
        self._role = role_of(self._mail)
        self._session = Session(scene, wait=False)
        self._pictures = Pictures(self._mail, lambda scene, colors: Sketch(scene, colors, plain))
        self._onlooker = Onlooker(self._mail, self._pictures, self._number, line)
        self._preparation = Preparation(compiler)
        self._requests: BoundedQueue[Callable[[], object]] = BoundedQueue(lambda _: None)
        self._describer = Describer(self._mail, self._requests.add)
        self._under_way: Future[Any] | None = None
        self._mapping = Mapping.of(scene)
        self._shared: SharedView | None = None
        self._planned: tuple[int, int] | None = None
        self._revision, self._was_running = -1, True
        self._due = self._look_due = self._kept_due = 0.0
        self._kept: tuple[int, float] = (-1, -1.0)
        self._offered: tuple[object, ...] = ()
        self._plotted = Plotted()
        self._read = -1.0
        line.receive = self.hear

    @property
    def _number(self) -> str:
        return str(-self._line.number)

    # --------------------------------------------------------------------- any thread
    def hear(self, said: FromPage) -> None:
        """Handle a message of the page, or leave it to the ticker; nothing in it is trusted."""
        role, session = self._role, self._session
        if not role.allows(said):
            return
        match said:
            case from_page.Who():
                self._requests.add(lambda: role.introduce(said, session))
            case messages.InSeat() | messages.Checked():
                self._requests.add(lambda: role.hear(said, session))
            case Describe(mass):
                self._requests.add(lambda: self._describe(mass))
            case Speed(speed) if "play" in self._controls:
                session.post(commands.Speed(speed))
            case from_page.Visit():
                session.post(commands.Visit())
            case from_page.Perform(command) if command in PERFORMED and "play" in self._controls:
                session.post(PERFORMED[command])
            case messages.SetNumber(key, value) if key in self._controls and key not in CHOICES:
                session.post(commands.SetValue(key, value))
            case messages.SetWord(key, value) if key in self._controls and key in CHOICES:
                session.post(commands.SetChoice(key, value))
            case _:
                for command in hand_commands(said, self._mapping):
                    session.post(command)

    def stir(self) -> None:
        """See `Ticked`."""

    def _describe(self, mass: int | None) -> None:
        """Describe the page's body; one that somebody else moves is at the front, to be told of there."""
        if self._role.describes:
            self._describer.describe(self._session, mass)
        else:
            self._mail.send(Described(text=say("seat-look")))

    # --------------------------------------------------------------------- frames
    @property
    def is_calm(self) -> bool:
        """See `Ticked`."""
        return False

    @property
    def looks_on(self) -> bool:
        """See `Ticked`."""
        return self._shared is not None

    @property
    def session(self) -> Session:
        """The page's simulation."""
        return self._session

    @property
    def _controls(self) -> Controls:
        controls = self._role.controls
        return controls if controls is not None else NOTHING

    @property
    def _names(self) -> tuple[str, ...]:
        return self._controls.names or ()

    def flush(self) -> None:
        """See `Ticked`."""
        self._send(self._line)

    def leave(self) -> None:
        """See `Ticked`."""
        self._onlooker.leave()
        self._role.leave()

    def stop(self) -> None:
        """See `Ticked`."""
        title, text = map(say, STOPPED)
        self._mail.send(messages.Remark(title=title, text=text))
        self.flush()

    def frame(self, budget: float, beside: RunInThread) -> bool:
        """See `Ticked`."""
        session, now = self._session, time.monotonic()
        if self._under_way is not None:
            if not self._under_way.done():
                return False
            self._under_way.result()
            self._under_way = None
        elif self._shared is not None and now < self._look_due and not self._requests:
            return False
        else:
            self._look_due = now + LOOK_EVERY
            for _ in range(min(len(self._requests), MAX_REQUESTS)):
                self._requests.take()()
            self._role.frame(session)
            if self._look_on(session):
                return True
            self._preparation.update(session)
            if session.is_heavy:
                self._under_way = beside(self._advance, session, budget)
                return True
            self._advance(session, budget)
        if now < self._due and session.revision == self._revision and not session.has_commands:
            return True
        self._due = max(self._due + LEAST_FRAME, now)
        self._show(session)
        self._keep(session)
        return True

    @staticmethod
    def _advance(session: Session, budget: float) -> None:
        session.drain()
        session.tick(budget, LONGEST_FRAME)

    def _look_on(self, session: Session) -> bool:
        """Show the body that all look at, if the class does, and return whether it does."""
        before, self._shared = self._shared, self._role.shared_view
        if (before is None) != (self._shared is None):
            self._onlooker.leave()
            self._planned = None
        if self._shared is None:
            return False
        plots = self._role.front_plots
        self._offer((), session, plots)
        if plots is not None:
            self._send_readings(plots)
        session.notices.clear()
        self._onlooker.show(self._shared, False, session.now(), self._role.bounds)
        return True

    def _show(self, session: Session) -> None:
        """Send the page's own body, as far as it has changed."""
        now = session.now()
        plan = session.openings, session.revision
        if plan != self._planned:
            if self._planned is None or plan[0] != self._planned[0]:
                self._describer.forget()
            self._planned, self._mapping = plan, Mapping.of(session.scene)
            self._pictures.build(session.scene, False, own_rest_angles(session.simulation))
        running = session.playing and session.simulation.divergence is None
        changed = session.revision != self._revision or running != self._was_running
        self._revision, self._was_running = session.revision, running
        self._pictures.draw(picture_of(session), now, exactly=changed or not running)
        self._mail.send(self._state(session))
        controls = self._names
        self._plotted.follow(session, self._role.plots if controls else ())
        self._offer(controls, session)
        self._send_readings(self._plotted)
        for notice in session.notices:
            # What the limit is, is for the pupil to find out.
            text = say("seat-try-again") if notice.about == "runaway" else notice.text
            self._mail.send(messages.Remark(title=notice.title, text=text))
        session.notices.clear()

    def _state(self, session: Session) -> PageState:
        scene = session.scene
        width, height = world_size(scene)
        bounds = self._role.bounds
        return PageState(
            page=self._number,
            scene=session.openings,
            title=name_of(scene),
            width=width,
            height=height,
            view=() if bounds is None else self._mapping.box(bounds),
            unit=scene.view.unit,
            playing=session.playing,
            speed=session.pacer.speed,
            offer=session.offer_back,
            arrows=keys_of(scene) if "keys" in self._controls else (),
            controls=self._names,
        )

    def _keep(self, session: Session) -> None:
        """Store the body, if it is time and it has changed."""
        state = session.revision, session.simulation.time
        if session.now() >= self._kept_due and state != self._kept and session.replay is None:
            self._kept, self._kept_due = state, session.now() + KEPT_EVERY
            self._role.keep(session.keepsake())

    # --------------------------------------------------------------------- what the pupil works with
    def _offer(self, controls: tuple[str, ...], session: Session, front: Plotted | None = None) -> None:
        """Send sliders, plots, and the body with which the page goes on alone, if any of them has changed.

        Args:
            controls: of the page's own body; none while it looks at another one.
            session: of its own body.
            front: the plots of the body that it looks at.
        """
        shown = front or self._plotted
        plots = shown.plots if front or controls else ()
        offered = controls, plots, shown.opening, session.revision if controls else -1
        if offered == self._offered:
            return
        is_new = offered[:3] != self._offered[:3]
        self._offered = offered
        if is_new:
            self._read = -1.0
            self._mail.send(_alone(session) if controls else messages.Alone())
        self._mail.send(
            messages.Bench(
                opening=shown.opening,
                dials=tuple(_dials(controls, session.scene)),
                curves=tuple(map(_curve, plots)),
            )
        )

    def _send_readings(self, plotted: Plotted) -> None:
        """Send what plots show, if time has passed."""
        if plotted.plots and plotted.time != self._read:
            self._read = plotted.time
            numbers = messages.Readings.pack(now=[plotted.opening, self._read], values=plotted.values)
            self._mail.send(messages.Readings(numbers=numbers))


def _dials(keys: tuple[str, ...], scene: sim.Scene) -> list[messages.Dial]:
    """The sliders and lists of a scene with these keys, in their order."""
    of_file = {one["key"]: tuple(one["sets"]) for one in sliders(scene)}
    dials = []
    for key in keys:
        if key in CHOICES and CHOICES[key].applies(scene):
            dials.append(_list(CHOICES[key], key, scene, of_file.get(key, ())))
        else:
            try:
                dials.append(_slider(setting_of(scene, key), scene, of_file.get(key, ())))
            except SettingError:
                continue  # it is no setting, such as "play"
    return dials


def _list(choice: Choice, key: str, scene: sim.Scene, sets: tuple[str, ...]) -> messages.Dial:
    options = tuple((value, str(word)) for value, word in options_of(key).items())
    return messages.Dial(
        key=key, label=label_of_choice(key), value=choice.read(scene), options=options, sets=sets
    )


def _slider(setting: Setting, scene: sim.Scene, sets: tuple[str, ...]) -> messages.Dial:
    low, high = setting.slider
    return messages.Dial(
        key=setting.key,
        label=label_of(setting),
        unit=setting.unit.replace("px", scene.view.unit),
        low=low,
        high=high,
        logarithmic=setting.logarithmic,
        value=float(setting.read(scene)),
        sets=sets,
    )


def _curve(plot: Plot) -> messages.Curve:
    names = plot.spec.names
    units = tuple(quantity.unit for quantity in plot.quantities)
    return messages.Curve(
        names=names,
        labels=tuple(map(quantity_text, names)),
        units=units[: len(names)],
        over=plot.spec.over,
        over_label=quantity_text(plot.spec.over) if plot.spec.over else "",
        over_unit=units[-1] if plot.spec.over else "",
        turned=all(plot.turned),
    )


def _alone(session: Session) -> messages.Alone:
    """The body with which the page goes on alone; none where that would be another motion."""
    scene = session.scene
    method = ALONE.get(scene.integrator.method)
    if method is None or len(scene.masses) > MAX_ALONE or unknown_forces(scene):
        return messages.Alone()
    try:
        body = body_data(session.simulation.capture())
    except InputError:
        return messages.Alone()
    return messages.Alone(
        opening=session.openings,
        body=json.dumps(body, allow_nan=False),
        method=method,
        dt=scene.integrator.dt,
    )
