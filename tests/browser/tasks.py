"""Counts how many presses and wrong turns somebody needs who sees the page for the first time.

`uv run python -m tests.browser.tasks` does twelve tasks on a page of this softrod, with an address behind it
on the one that runs there; `--size 390x844` with a finger. Whoever does them knows a few everyday words for
each, and what can be seen (`novice.py`). A wrong turn is a press that neither did it nor brought up anything
that promises more. Leave the machine alone meanwhile: a hand misses a body whose picture comes late.
"""

from __future__ import annotations

import argparse
import math
import os
import re
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from typing import Any, Literal, NamedTuple

from playwright.sync_api import Browser, Page, sync_playwright

import sim
from app.server.serve import serving
from sim.compiling.compiler import ENTRY_POINTS
from tests.browser import seen
from tests.browser.driver import Point, until
from tests.browser.novice import SEARCHED, SLID, TYPED, Key, Thing, key_of, promising, revealing

MOST = 20
"""Presses after which somebody gives up."""

PATIENCE = 4.0
"""Seconds for which somebody looks whether a press did it; the page tells its state once a second."""

TOUCHED = 500
"""Least side of a window below which a finger presses, CSS px."""

CLOSING = r"(close|cancel|done|back|[×✕])\b|[×✕]$"
"""Words on what leads out of a dialog."""

LOOKS = 3
"""How often somebody looks whether anything has come up."""

CALM, STILL = 6.0, 20
"""Px that a mass moves at most between two looks when it is taken, for which a hand can wait; and looks
without any motion after which it stands."""

LOOK = """() => {
  const { plan, frame, secondPlan } = __softrod.shown();
  const kept = JSON.parse(sessionStorage.getItem("softrod") ?? "null");
  const words = (elements) => [...elements].map((one) => one.innerText).join(" ");
  const values = [...document.querySelectorAll("input, textarea")].filter((one) => one.checkVisibility());
  return {
    scene: kept?.session.scene ?? null,
    told: words(document.querySelectorAll("[role=alert], [role=status], output")),
    text: [document.body.innerText, ...values.map((one) => one.value)].join(" "),
    masses: plan.radius.length,
    springs: plan.springs.length / 2,
    back: window.softrodBack,
    second: Boolean(secondPlan || frame.ghost),
    heard: Boolean(window.softrodHeard),
    downloads: 0,
  };
}"""
"""The page's state, as it tells it to tests and as it keeps it for a reload."""

LISTEN = """
  const start = OscillatorNode.prototype.start;
  OscillatorNode.prototype.start = function (...when) {
    window.softrodHeard = true;
    return start.apply(this, when);
  };
  let last = 0;
  window.softrodBack = 0;
  setInterval(() => {
    const time = window.__softrod?.shown().frame?.time;
    if (time < last - 0.005) window.softrodBack++;
    last = time ?? last;
  }, 20);
"""
"""Runs before the page's scripts: notes what can be heard, and how often time went back."""

MASSES = """() => {
  const places = __softrod.instances("/body/masses") ?? [];
  const all = Array.from({ length: places.length / 48 }, (_, i) => places.slice(16 * i + 12, 16 * i + 15));
  return __softrod.project(all.map((place) => [...place]));
}"""

THUMB = """(index) => {
  const element = visibleThings.elements[index];
  element.scrollIntoView({ block: "center", behavior: "instant" });
  const { left, top, width, height } = element.getBoundingClientRect();
  const [min, max] = [Number(element.min || 0), Number(element.max || 100)];
  const part = element.matches("input") ? (Number(element.value) - min) / (max - min) : 0.5;
  return [left, top, width, height, part];
}"""
"""Where a slider is, and where on it its thumb is, 0 to 1."""

FREE = """(masses) => {
  const canvas = __softrod.canvas();
  const far = (corners) => masses.every(([x, y]) => corners.every(([a, b]) => Math.hypot(x - a, y - b) > 50));
  const free = (x, y) => document.elementFromPoint(x, y) === canvas;
  for (let size = 110; size > 40; size -= 20) {
    for (let y = innerHeight - 40; y > size + 40; y -= 20) {
      for (let x = 60; x + size < innerWidth; x += 20) {
        const corners = [[x, y], [x + size, y], [x + size / 2, y - size]];
        const about = ([a, b]) => [-12, 0, 12].every((i) => free(a + i, b) && free(a, b + i));
        if (corners.every(about) && far(corners)) return corners;
      }
    }
  }
  return null;
}"""
"""Three corners of a triangle on paper that is free, far from all masses, or null."""

State = dict[str, Any]
Done = Callable[[State, State, State], bool]
"""Whether it is done, by the states at the beginning, before the last press, and now."""


class Step(NamedTuple):
    """What somebody wants.

    Attributes:
        words: theirs, the most likely first.
        done: whether they have it.
        act: what they do. Whoever raises something pulls sliders to the right, and drags the body to see it;
            whoever draws tries after each press whether three strokes on the paper make a triangle.
        patience: s for which they look whether a press did it.
    """

    words: tuple[str, ...]
    done: Done
    act: Literal["press", "raise", "drag", "draw"] = "press"
    patience: float = PATIENCE


class Task(NamedTuple):
    """One task: its steps, the scene in which it begins, and what was done before, which is not counted."""

    name: str
    steps: tuple[Step, ...]
    scene: str = "rope"
    before: Step | None = None


def numbers(scene: Any, name: str) -> Sequence[float]:
    """All numbers of a scene whose names end so."""
    if isinstance(scene, list):
        return [found for one in scene for found in numbers(one, name)]
    if not isinstance(scene, dict):
        return []
    own = [v for k, v in scene.items() if k.endswith(name) and isinstance(v, int | float)]
    return [*own, *(found for one in scene.values() for found in numbers(one, name))]


def _stiffer(start: State, _: State, now: State) -> bool:
    then, later = numbers(start["scene"], "stiffness"), numbers(now["scene"], "stiffness")
    return len(then) == len(later) and any(b > a for a, b in zip(then, later, strict=True))


def _says(pattern: str, where: Literal["text", "told"] = "text") -> Done:
    """Whether the page says something that it did not say: anywhere, or in a notice."""

    def done(start: State, _: State, now: State) -> bool:
        then, later = (len(re.findall(pattern, state[where], re.IGNORECASE)) for state in (start, now))
        return later > then

    return done


_told_saved = _says(r"\bsaved\b", "told")


def _saved(start: State, before: State, now: State) -> bool:
    return now["downloads"] > start["downloads"] or _told_saved(start, before, now)


def _undone(start: State, before: State, now: State) -> bool:
    return before["scene"] != start["scene"] and now["scene"] == start["scene"]


def _went_back(_: State, before: State, now: State) -> bool:
    return now["back"] > before["back"]


STIFFER = Step(("stiff", "stiffness", "hard", "firm", "strong"), _stiffer, "raise")

TASKS = (
    Task("drag the body", (Step(("drag",), lambda *_: False, "drag"),)),
    Task("make it stiffer", (STIFFER,)),
    Task(
        "make it explode and mend it",
        (
            Step(("explode", "stiff", "stiffness", "step", "big"), _says(r"\bexploded\b", "told"), "raise"),
            Step(
                ("mend", "back", "before", "undo", "reset"),
                _went_back,
            ),
        ),
        "tutorial-3.3",
    ),
    Task(
        "read a period",
        (
            Step(
                ("period", "swing", "measure", "plot", "graph"),
                _says(r"period\D{0,30}\d[\d.,]*\s*s\b"),
                patience=8.0,
            ),
        ),
        "pendulum",
    ),
    Task(
        "find the jelly",
        (
            Step(
                ("jelly", "rope", "scene", "gallery", "example", "other", "open"),
                lambda _s, _b, now: now["scene"] is not None and now["scene"]["name"] == "jelly",
            ),
        ),
    ),
    Task(
        "build a triangle",
        (
            Step(
                ("build", "draw", "pause", "edit", "new", "add", "make"),
                lambda _, before, now: (
                    now["masses"] == before["masses"] + 3 and now["springs"] == before["springs"] + 3
                ),
                "draw",
            ),
        ),
    ),
    Task("undo", (Step(("undo", "back", "revert"), _undone),), before=STIFFER),
    Task("save", (Step(("save", "keep", "store", "file"), _saved),)),
    Task(
        "share to a phone",
        (Step(("phone", "share", "link", "qr", "send"), _says(r"https?://\S+[?#/]\S*\w")),),
    ),
    Task(
        "race",
        (
            Step(
                ("race", "rival", "against", "opponent", "worm"),
                lambda start, _, now: now["second"] and not start["second"],
                patience=8.0,
            ),
        ),
    ),
    Task("hear it", (Step(("hear", "sound", "listen", "loud", "tone"), lambda _s, _b, now: now["heard"]),)),
    Task(
        "go back in time",
        (
            Step(
                ("back", "rewind", "earlier", "past"),
                _went_back,
            ),
        ),
    ),
)


class Visitor:
    """Does one task on one page.

    Attributes:
        presses, wrong: how many presses, and how many of them were wrong turns.
        way: the words of what was pressed.
    """

    def __init__(self, page: Page, touched: bool) -> None:
        self.page, self._touched = page, touched
        self._downloads = 0
        self.presses = self.wrong = 0
        self.way: list[str] = []
        page.on("download", self._count)
        # What opens beside the page is closed: it was a wrong turn.
        page.context.on("page", lambda other: other.close())

    def _count(self, _: object) -> None:
        self._downloads += 1

    def state(self) -> State:
        """What the page tells of itself now."""
        return self.page.evaluate(LOOK) | {"downloads": self._downloads}

    def _comes(self, step: Step, start: State, before: State) -> bool:
        """Look for a while whether it is done."""
        end = time.monotonic() + step.patience
        while not step.done(start, before, self.state()):
            if time.monotonic() > end:
                return False
            self.page.wait_for_timeout(100)
        return True

    # --------------------------------------------------------------------- one step
    def do(self, step: Step, start: State | None = None) -> bool:
        """Do a step; whether it came to that. Its beginning is now, if it is not given."""
        if step.act == "drag":
            return self._drag_body(counted=True)
        start = start or self.state()
        tried, limit = set[Key](), self.presses + MOST
        while self.presses < limit:
            things = seen.pressables(self.page)
            tried |= {key_of(one) for one in things if one["kind"] == "tab" and one["state"] == "true"}
            # Boxes for words and numbers are for whoever has a number in mind.
            usable = [one for one in things if step.act == "raise" or one["kind"] not in (*TYPED, *SLID)]
            fitting = promising(usable, step.words, tried, self._touched)
            choice = fitting[0][1] if fitting else next(iter(revealing(things, tried)), None)
            if choice is None:
                return False
            tried.add(key_of(choice))
            before = self.state()
            self._note(choice["words"])
            used = self._use(choice, step)
            hoped = used and bool(fitting)
            if self._comes(step, start, before) if hoped else step.done(start, before, self.state()):
                return True
            if hoped and step.act == "draw" and self._draws(step):
                return True
            if hoped and step.act == "raise":
                self._drag_body()
                if self._comes(step, start, before):
                    return True
            self._judge(things, choice, step, tried)
        return False

    def _note(self, words: str) -> None:
        self.presses += 1
        self.way.append(words)

    def _use(self, thing: Thing, step: Step) -> bool:
        """Do with a thing what one does with its kind; whether that could be done."""
        if step.act == "raise" and thing["kind"] in SLID:
            self._raise_slider(thing)
            return True
        if not seen.press(self.page, thing["index"], self._touched):
            return False
        if thing["kind"] in SEARCHED:
            self.page.keyboard.type(step.words[0])
        elif thing["kind"] in TYPED and step.act == "raise":
            value = re.sub(r"[^\d.eE+-]", "", str(thing["value"]))
            self.page.keyboard.press("ControlOrMeta+a")
            self.page.keyboard.type(f"{100.0 * float(value or 1.0):g}")
            self.page.keyboard.press("Enter")
        return True

    def _judge(self, things: list[Thing], choice: Thing, step: Step, tried: set[Key]) -> None:
        """Look whether the press brought up anything; close what it opened in vain."""
        known = {key_of(thing) for thing in things}
        now: list[Thing] = []
        new: list[Thing] = []
        for _ in range(LOOKS):
            now = seen.pressables(self.page)
            new = [thing for thing in now if key_of(thing) not in known]
            if new:
                break
            self.page.wait_for_timeout(1e3 * seen.REST)
        if promising(new, step.words, tried, self._touched):
            return
        self.wrong += 1
        if choice["kind"] == "tab" or not new:
            return
        self.page.keyboard.press("Escape")
        self.page.wait_for_timeout(1e3 * seen.REST)
        now = seen.pressables(self.page)
        if len(known & {key_of(thing) for thing in now}) > 0.5 * len(known):
            return
        for thing in now:
            if re.match(CLOSING, thing["words"], re.IGNORECASE):
                self._note(thing["words"])
                seen.press(self.page, thing["index"], self._touched)
                return

    # --------------------------------------------------------------------- with the hand
    def _stroke(self, start: Point, end: Point, held: Callable[[], bool] = lambda: True) -> bool:
        """Press, go, and let go; what holds before that."""
        steps = 12
        way = [
            tuple(a + (b - a) * i / steps for a, b in zip(start, end, strict=True)) for i in range(steps + 1)
        ]
        tools = self.page.context.new_cdp_session(self.page) if self._touched else None
        for i, (x, y) in enumerate(way):
            if tools is not None:
                kind = "touchMove" if i else "touchStart"
                tools.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y}]})
            else:
                self.page.mouse.move(x, y)
                if i == 0:
                    self.page.mouse.down()
            self.page.wait_for_timeout(20)
        latest = time.monotonic() + PATIENCE
        while not (result := held()) and time.monotonic() < latest:
            self.page.wait_for_timeout(100)
        self.page.wait_for_timeout(600)
        if tools is not None:
            tools.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
            tools.detach()
        else:
            self.page.mouse.up()
        self.page.wait_for_timeout(1e3 * seen.REST)
        return result

    def _raise_slider(self, thing: Thing) -> None:
        """Pull a slider to the right end of its track."""
        left, top, width, height, part = self.page.evaluate(THUMB, thing["index"])
        x, y = left + part * width, top + height / 2
        # Of a thumb alone the track goes on; a hand goes as far as it does.
        self._stroke((x, y), (left + width - 2.0 if width > 40.0 else x + 120.0, y))

    def _drag_body(self, counted: bool = False) -> bool:
        """Take the body by a free end and pull it aside; whether it comes along."""
        places: list[Point] = self.page.evaluate(MASSES)
        for mass in dict.fromkeys((len(places) - 1, len(places) // 2, 0)):
            x, y = self._calm(mass)
            size = self.page.viewport_size
            assert size is not None
            aim = (
                x + (-80.0 if x > size["width"] / 3 else 80.0),
                y + (80.0 if y < size["height"] / 3 else -60.0),
            )

            def follows(mass: int = mass, aim: Point = aim) -> bool:
                place = self.page.evaluate(MASSES)[mass]
                return math.dist(place, aim) < 40.0

            if counted:
                self._note("the body")
            if self._stroke((x, y), aim, follows):
                return True
            self.wrong += counted
        return False

    def _calm(self, mass: int) -> Point:
        """Where a mass is, once it is slow; or after some time anyway."""
        last: Point = self.page.evaluate(MASSES)[mass]
        same = 0
        for _ in range(200):
            self.page.wait_for_timeout(30)
            place: Point = self.page.evaluate(MASSES)[mass]
            moved = math.dist(place, last)
            # A page with little time shows the same picture for a while.
            same = 0 if moved else same + 1
            if 0.0 < moved < CALM or same > STILL:
                return place
            last = place
        return last

    def _draws(self, step: Step) -> bool:
        """Draw three strokes on free paper; whether they make a triangle."""
        places = None
        for _ in range(STILL):
            places = self.page.evaluate(FREE, self.page.evaluate(MASSES))
            if places is not None:
                break
            self.page.wait_for_timeout(200)  # the body swings away
        if places is None:
            return False
        self._note("three strokes")
        before = self.state()
        for a, b in zip(places, (*places[1:], places[0]), strict=True):
            self._stroke(tuple(a), tuple(b))
        if self._comes(step, before, before):
            return True
        self.wrong += 1
        return False


class Result(NamedTuple):
    """How a task went."""

    name: str
    done: bool
    presses: int
    wrong: int
    way: tuple[str, ...]


def attempt(browser: Browser, url: str, task: Task, size: tuple[int, int], touched: bool) -> Result:
    """Do a task on a new page."""
    with seen.opened(browser, f"{url.rstrip('/')}/?scene={task.scene}", size, touched, first=LISTEN) as page:
        visitor = Visitor(page, touched)
        # The state is kept from the first second on.
        until(page, lambda: visitor.state()["scene"], "the page keeps its state")
        start = visitor.state()
        if task.before is not None:
            visitor.do(task.before)
            until(page, lambda: visitor.state()["scene"] != start["scene"], "what is to be undone")
            visitor.presses = visitor.wrong = 0
            visitor.way.clear()
        done = all(visitor.do(step, start if task.before else None) for step in task.steps)
        return Result(task.name, done, visitor.presses, visitor.wrong, tuple(visitor.way))


@contextmanager
def served() -> Iterator[str]:
    """This softrod, whose scenes are saved where nobody finds them; its address."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_DATA_HOME"] = folder
        with serving(sim.load_scene("rope"), "127.0.0.1", 0) as (server, _, compiler):
            compiler.want(ENTRY_POINTS)
            compiler.start()
            compiler.wait()
            yield f"http://127.0.0.1:{server.get_port()}"


def report(results: list[Result]) -> str:
    """A table with sums, and what was pressed."""
    rows = [(one.name, "yes" if one.done else "no", one.presses, one.wrong) for one in results]
    done, presses, wrong = (sum(numbers) for numbers in zip(*(one[1:4] for one in results), strict=True))
    rows.append(("all", f"{done} of {len(results)}", presses, wrong))
    ways = [f"{one.name}: {', '.join(one.way)}" for one in results]
    return seen.table(("task", "done", "presses", "wrong turns"), rows) + "\n\n" + "\n".join(ways)


def main() -> int:
    """Do all tasks, or those whose names are given, and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("url", nargs="?", help="address of the page; without it, this softrod is served")
    parser.add_argument(
        "--size", default="1280x720", help="of the window, CSS px; below 500 px it is touched"
    )
    parser.add_argument("--only", default="", help="a part of the names of the tasks that are done")
    given = parser.parse_args()
    width, height = map(int, given.size.split("x"))
    with ExitStack() as stack:
        url = given.url or stack.enter_context(served())
        browser = seen.open_browser(stack.enter_context(sync_playwright()))
        touched = min(width, height) < TOUCHED
        chosen = [task for task in TASKS if given.only in task.name]
        print(report([attempt(browser, url, task, (width, height), touched) for task in chosen]))
        browser.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
