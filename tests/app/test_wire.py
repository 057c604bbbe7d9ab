"""What a page says, which any client can forge, and what is made from the messages and the commands."""

from __future__ import annotations

import math
import re
from collections import Counter
from typing import Any

import numpy as np
import pytest
from msgspec import inspect

from app.features.gallery.messages import OfferGallery, ShelfChanged
from app.features.hands import messages as hands
from app.features.instruments.messages import Tools
from app.features.measure import messages as measure
from app.features.time import messages as time_messages
from app.pages.sandbox.features import COMMANDS, CONTROLS
from app.session import commands
from app.ui import controls
from app.ui.commands import key_lines
from app.wire import from_page, to_page
from app.wire.messages import Event, FromPage, Numbers, State, ToPage, messages, read
from tests.app.inside import Bare
from tests.app.letters import Letters
from tests.page import generate

SAID = {
    '{"do":"perform","command":"play"}': from_page.Perform("play"),
    '{"do":"keys","held":["up","right"]}': hands.Keys(("up", "right")),
    '{"do":"keys","held":[]}': hands.Keys(()),
    '{"do":"at","hands":[[0,1.5,-0.5]]}': hands.At(((0, 1.5, -0.5),)),
    '{"do":"at","hands":[[2,1.5,-0.5],[9,0,0]]}': hands.At(((2, 1.5, -0.5), (9, 0.0, 0.0))),
    '{"do":"grab","hand":2,"mass":3,"x":1.5,"y":-0.5}': hands.Grab(2, 3, 1.5, -0.5),
    '{"do":"drop","hand":2}': hands.Drop(2),
    '{"do":"pick","mass":3}': hands.Pick(3),
    '{"do":"goTo","time":12.5}': time_messages.GoTo(12.5),
    '{"do":"speed","speed":0.125}': time_messages.Speed(0.125),
    '{"do":"seen","tab":""}': measure.Seen(""),
}


@pytest.mark.parametrize("text", SAID)
def test_messages_are_understood(text: str) -> None:
    assert read(text) == SAID[text]


@pytest.mark.parametrize(
    "text",
    [
        "", "null", '"play"', "{}", '{"do":"format"}', '{"do":"perform"}',
        '{"do":"perform","command":"for mat"}', '{"do":"perform","command":"play","more":1}',
        '{"do":"keys","held":["X"]}', '{"do":"keys","held":"up"}',
        '{"do":"keys","held":["up","up","up","up","up"]}', '{"do":"at","hands":[]}',
        '{"do":"at","hands":[[0,NaN,0]]}', '{"do":"at","hands":[[0,Infinity,1]]}',
        '{"do":"at","hands":[[0,1e400,1]]}', '{"do":"at","hands":[[0,1e9,1]]}', '{"do":"at","hands":[[0,1]]}',
        '{"do":"at","hands":[[0,1,2,3]]}', '{"do":"at","hands":[[10,1,2]]}',
        '{"do":"at","hands":[[0.5,1,2]]}',
        '{"do":"at","hands":[' + ",".join(11 * ["[1,2,3]"]) + "]}", '{"do":"at","hands":[["0",1,2]]}',
        '{"do":"goTo","time":NaN}', '{"do":"goTo","time":null}', '{"do":"speed","speed":"x"}',
        '{"do":"grab","hand":0,"mass":-1,"x":0,"y":0}', '{"do":"grab","hand":0,"mass":3,"x":0}',
        '{"do":"drop"}', '{"do":"drop","hand":10}', '{"do":"pick","mass":1e6}',
        '{"do":"switch","what":"dark"}',
        '{"do":"seen","tab":"files"}', '{"do":"part","kind":"resume","number":0,"of":1,"letters":""}',
    ],
)  # fmt: skip
def test_nonsense_is_refused(text: str) -> None:
    assert read(text) is None


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999", "-1e999", "1e99"])
def test_no_message_brings_in_what_is_no_number(number: str) -> None:
    for text in SAID:
        for found in re.finditer(r"(?<=[\[,:])-?\d+(\.\d+)?", text):
            assert read(text[: found.start()] + number + text[found.end() :]) is None


def test_every_number_that_a_page_says_has_bounds() -> None:
    """NaN and infinity are in none."""

    def look(kind: Any, where: str) -> None:
        if isinstance(kind, inspect.IntType | inspect.FloatType):
            assert kind.ge is not None and kind.le is not None, where
            assert math.isfinite(kind.ge) and math.isfinite(kind.le), where
        for inner in (*getattr(kind, "types", ()), *getattr(kind, "item_types", ())):
            look(inner, where)
        if inner := getattr(kind, "item_type", None):
            look(inner, where)

    for message in messages(FromPage):
        for field in inspect.type_info(message).fields:  # type: ignore[attr-defined]
            look(field.type, f"{message.__name__}.{field.name}")


def test_of_states_the_latest_counts_and_events_all_arrive() -> None:
    letters = Letters()
    for chosen in (1, 2, 2):
        letters.send(Tools(chosen=chosen))
    letters.send(ShelfChanged())
    letters.send(ShelfChanged())
    letters.send(OfferGallery(why=""))
    assert letters.sent[:2] == [Tools(chosen=1), Tools(chosen=2)], "what has not changed is not told again"
    assert letters.keys[0] == letters.keys[1]
    assert len(set(letters.keys)) == len(letters.keys) - 1
    assert letters.last_sent(Tools) == Tools(chosen=2)


def test_every_message_is_a_state_an_event_or_numbers() -> None:
    kinds = State | Event | Numbers
    assert all(issubclass(kind, kinds) for kind in messages(ToPage))


def test_numbers_are_told_each_time_and_the_latest_count() -> None:
    letters, numbers = Letters(), np.array([1.0, 2.0], np.float32)
    for wall in (12.25, 12.25):
        letters.send(to_page.Frame(numbers=numbers, wall=wall))
    assert [message.text for message in letters.sent] == ['{"tell":"frame","wall":12.25}'] * 2
    assert all(message.numbers is numbers for message in letters.sent)
    assert letters.keys[0] == letters.keys[1]
    for kind in (*messages(FromPage), *messages(ToPage)):
        assert kind.__doc__, f"{kind.__name__} does not say what it is"


def test_what_is_made_from_the_messages_and_commands_is_up_to_date() -> None:
    for path, text in generate.files().items():
        current = path.read_text(encoding="utf-8")
        assert current == text, f"{path.name} is old: run {generate.COMMAND}"


def test_the_guide_to_the_page_has_all_keys() -> None:
    text = (generate.ROOT / "docs" / "using.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (.+?) \|", text.partition("## Keys")[2].partition("\n## ")[0], re.MULTILINE)
    shown = {key for row in rows for key in re.split(r" or | ", row)}
    for keys, _ in key_lines(COMMANDS):
        for key in re.split(r" or | ", keys):
            assert key in shown


def test_a_key_gives_one_command() -> None:
    keys = Counter(key for row in COMMANDS.values() for key in row.keys)
    assert [key for key, count in keys.items() if count > 1] == []


# ------------------------------------------------------------------------- what is done
@pytest.mark.parametrize(
    ("said", "posted"),
    [
        (hands.Keys(("up", "right")), commands.HoldKeys(frozenset({"up", "right"}))),
        (
            hands.At(((2, 1.5, -0.5), (9, 0.0, 0.0))),
            [commands.Point(450.0, 350.0, 2), commands.Point(300.0, 300.0, 9)],
        ),
        (hands.Grab(2, 3, 1.5, -0.5), commands.DragStart(3, 450.0, 350.0, 2)),
        (hands.Drop(2), commands.DragEnd(2)),
        (time_messages.GoTo(12.5), commands.GoTo(12.5)),
        (time_messages.Speed(0.125), commands.Speed(0.125)),
        (from_page.Visit(), commands.Visit()),
        (from_page.Perform("pause"), commands.Play(False)),
        (from_page.Perform("steps"), commands.DoSteps(10)),
        (from_page.Perform("second"), commands.GoBack(1.0)),
        (from_page.Perform("format"), []),
    ],
)
def test_what_a_page_says_is_done(said: FromPage, posted: commands.Command | list[commands.Command]) -> None:
    tab = Bare()
    tab.hear(said)
    assert tab.done == (posted if isinstance(posted, list) else [posted])


def test_a_command_is_done_by_whom_the_table_says_and_needs_its_control() -> None:
    for name, row in COMMANDS.items():
        for names in (controls.ALL, controls.Controls(("play",))):
            tab = Bare(names)
            tab.perform(name)
            offered = (not row.needs or row.needs in names) and row.does not in ("edit", "own")
            assert len(tab.done) == offered, name
    assert {row.needs for row in COMMANDS.values()} <= {"", *CONTROLS}
