"""How it is judged whether a first-time task is done (`tasks.py`)."""

from __future__ import annotations

from typing import Any

from tests.browser.tasks import TASKS, Result, report

DONE = {task.name: task.steps[-1].done for task in TASKS}
START: dict[str, Any] = {
    "scene": {"name": "rope", "bodies": [{"stiffness": 10.0, "angular_stiffness": 5.0}]},
    "text": "Period of the beat. A rope",
    "told": "",
    "masses": 3,
    "springs": 2,
    "back": 0,
    "second": False,
    "heard": False,
    "downloads": 0,
}


def is_done(name: str, **changed: Any) -> bool:
    """Whether a task is done once the page's state has changed so."""
    return DONE[name](START, START, START | changed)


def test_a_task_is_done_by_what_the_page_has_then() -> None:
    assert not any(done(START, START, START) for done in DONE.values())
    assert is_done("make it stiffer", scene={"bodies": [{"stiffness": 10.0, "angular_stiffness": 6.0}]})
    assert not is_done("make it stiffer", scene={"bodies": [{"stiffness": 9.0, "angular_stiffness": 5.0}]})
    assert is_done("read a period", text="angle: period 1.2 s") and not is_done(
        "read a period", text="period"
    )
    assert is_done("find the jelly", scene={"name": "jelly"})
    assert is_done("build a triangle", masses=6, springs=5)
    assert not is_done("build a triangle", masses=9, springs=5)
    assert (
        is_done("save", told="Saved") and is_done("save", downloads=1) and not is_done("save", text="saved")
    )
    assert is_done("share to a phone", text="http://127.0.0.1:8080/?s=abc")
    assert is_done("race", second=True) and is_done("hear it", heard=True)
    assert is_done("go back in time", back=1)
    # What was done before is undone.
    other = START | {"scene": {"name": "rope", "bodies": []}}
    assert DONE["undo"](START, other, START) and not DONE["undo"](START, other, other)


def test_the_table_sums_presses_and_wrong_turns() -> None:
    text = report([Result("undo", True, 2, 1, ("Edit", "Undo")), Result("save", False, 20, 18, ("View",))])
    assert [cell.strip() for cell in text.splitlines()[4].strip("|").split("|")] == [
        "all",
        "1 of 2",
        "22",
        "19",
    ]
    assert "undo: Edit, Undo" in text
