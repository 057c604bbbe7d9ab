"""What pages show of the teacher's body: encoded once, sent to all, and exact once it stands."""

from __future__ import annotations

from dataclasses import replace
from unittest.mock import MagicMock

import numpy as np
import pytest

import sim
from app.classroom.live import SharedView
from app.features.classroom import shared_view as module
from app.features.classroom.shared_view import RESYNC_EVERY, Onlooker, broadcast, same_view
from app.stage.pictures import STILL, Pictures
from app.stage.plan import Picture
from app.wire.carrier import Letter
from sim.scene.types import Damage
from tests.app.letters import Letters


@pytest.fixture
def front() -> SharedView:
    scene = sim.rope(4, view=sim.View(frame=(0.0, 0.0, 600.0, 600.0)))
    angles = np.array([joint.rest_angle for joint in scene.angular_springs])
    return SharedView(1_000_000, set(), scene, 1, angles, Picture.at_start(scene), True, 1.0)


def moved(front: SharedView, pixels: float, time: float = 0.0, **more: object) -> SharedView:
    picture = replace(front.picture, positions=front.picture.positions + pixels, time=time)
    return replace(front, picture=picture, **more)  # type: ignore[arg-type]


def a_view() -> tuple[Onlooker, Letters]:
    letters = Letters()
    return Onlooker(letters, Pictures(letters), "page", MagicMock()), letters


def numbers(letters: Letters, kind: str) -> list[np.ndarray]:
    """Those of all messages of a kind that carry some, in order."""
    begin = f'{{"tell":"{kind}"'
    carriers = [one for one in letters.sent if isinstance(one, Letter)]
    return [one.numbers for one in carriers if one.numbers is not None and one.text.startswith(begin)]


def test_a_moving_picture_is_encoded_once_for_all_who_look_on(
    front: SharedView, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent: list[tuple[int, Letter]] = []
    monkeypatch.setattr(module, "send_at_once", lambda lines, letter: sent.append((len(lines), letter)))
    views = [a_view() for _ in range(3)]
    broadcast(front, 0.0)
    assert not sent, "nobody has the plan yet"
    for view, letters in views:
        assert view.show(front, dark=False, now=0.0)
        (plan,) = numbers(letters, "plan")
        assert plan[1] == numbers(letters, "frame")[0][1] == front.number
    after = moved(front, 5.0, 0.1)
    broadcast(after, 0.1)
    assert [count for count, _ in sent] == [3]
    assert not any(view.show(after, dark=False, now=0.1) for view, _ in views), "they have it already"
    # One that was too slow for it has it a second later.
    assert all(view.show(after, dark=False, now=0.1 + RESYNC_EVERY) for view, _ in views)
    place = after.picture.positions[0, 0]
    assert all(np.isclose(numbers(letters, "frame")[-1][7], place) for _, letters in views)
    assert not any(view.show(after, dark=False, now=9.0) for view, _ in views), "and at rest nothing is sent"
    views[0][0].leave()
    broadcast(after, 9.0)
    assert sent[-1][0] == 2


def test_what_stands_or_is_broken_goes_to_each_page_by_its_mail(front: SharedView) -> None:
    view, letters = a_view()
    view.show(front, dark=False, now=0.0)
    stands = moved(front, 0.01, 0.2, playing=False)
    assert view.show(stands, dark=False, now=0.2), "however little it has moved"
    assert len(numbers(letters, "frame")) == 2
    assert not view.show(stands, dark=False, now=50.0)
    broken = replace(front, picture=replace(front.picture, damage=Damage(broken=(1,))))
    assert view.show(broken, dark=False, now=50.1)
    assert numbers(letters, "damage")
    # Another plan is another number: nobody takes pictures of one for those of the other.
    assert view.show(replace(front, number=front.number + 1), dark=False, now=50.2)
    assert numbers(letters, "frame")[-1][1] == front.number + 1


def test_two_pictures_look_alike_to_a_tenth_of_a_pixel_and_exactly_at_rest(
    front: SharedView,
) -> None:
    assert same_view(front, moved(front, 0.9 * STILL, 0.1))
    assert not same_view(front, moved(front, 1.1 * STILL, 0.1))
    stands = replace(front, playing=False)
    assert same_view(stands, moved(stands, 0.0))
    assert not same_view(stands, moved(stands, 0.001))
    assert not same_view(stands, moved(stands, 0.0, 0.1))
    assert not same_view(front, stands)
    assert not same_view(front, replace(front, number=7))
    ghost = replace(stands, picture=replace(stands.picture, ghost=stands.picture.positions))
    assert not same_view(stands, ghost)
    assert same_view(ghost, ghost)
    assert not same_view(replace(ghost, playing=True), replace(ghost, playing=True)), "it is drawn by each"
