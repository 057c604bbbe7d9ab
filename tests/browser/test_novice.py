"""What attracts somebody who sees the page for the first time (`novice.py`)."""

from __future__ import annotations

from tests.browser.novice import Thing, key_of, promising, revealing, score

STIFFER = ("stiff", "stiffness")


def thing(kind: str, seen: str = "", name: str = "", tip: str = "", **more: object) -> Thing:
    """Something on a page, in view and free."""
    usual = {"disabled": False, "inView": True, "state": None, "opens": False}
    return {"kind": kind, "seen": seen, "name": name, "tip": tip, **usual, **more}


def test_words_attract_by_how_well_and_how_alone_they_fit() -> None:
    alone, among = thing("button", "Stiff"), thing("button", "Stiff or soft, as you like it")
    longer, last = thing("slider", name="Stiffness"), thing("button", "Hard")
    unseen = thing("button", "Stiff", inView=False)
    assert score(STIFFER, alone) > score(STIFFER, among) > 0.0
    assert score(STIFFER, longer) > 0.0
    assert score(("stiff",), last) == score(("hair",), last) == 0.0
    assert score(("stiff", "hard"), last) < score(("hard", "stiff"), last)
    assert score(STIFFER, unseen) < score(STIFFER, alone)
    # Short words stand for themselves alone, and a finger sees no tooltips.
    assert score(("new",), thing("button", "News")) == 0.0
    tip = thing("button", name="Edit", tip="Build and change the body")
    assert score(("build",), tip) > 0.0 == score(("build",), tip, touched=True)


def test_the_best_is_pressed_first_and_nothing_twice() -> None:
    things = [thing("slider", name="Angular stiffness"), thing("button", "Stiff"), thing("button", "Pause")]
    assert [one["seen"] for _, one in promising(things, STIFFER, set())] == ["Stiff", ""]
    assert [one["name"] for _, one in promising(things, STIFFER, {key_of(things[1])})] == [
        "Angular stiffness"
    ]
    on, off = thing("button", "Stiff", state="true"), thing("button", "Stiff", disabled=True)
    assert promising([on, off], STIFFER, set()) == []
    # A figure that runs makes no other thing of it.
    assert key_of(thing("slider", name="Mode 1, 0.44 hertz")) == key_of(
        thing("slider", name="Mode 1, 0.45 hertz")
    )


def test_who_sees_nothing_that_fits_looks_behind_things() -> None:
    things = [
        thing("button", "Reset"),
        thing("button", name="All commands"),
        thing("button", "View", opens=True),
        thing("slider", name="Gravity"),
        thing("tab", "Play", state="true"),
        thing("tab", "Share"),
        thing("button"),
    ]
    order = [one["seen"] or one["name"] for one in revealing(things, set())]
    assert order == ["Share", "View", "All commands", "Reset"]
    assert revealing(things, {key_of(things[5])})[0]["seen"] == "View"
