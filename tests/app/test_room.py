"""A class's room: what it takes from whom, and that every answer counts once."""

from __future__ import annotations

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from app.classroom import names
from app.classroom.answers import (
    Answer,
    Line,
    Phase,
    Prediction,
    Refused,
    Vote,
    Work,
)
from app.classroom.room import MAX_SEATS, MAX_SEATS_PER_VISITOR, Room, Seat
from app.words import languages, say, speaking
from sim.scene.lesson import Lesson, Question, Step
from tests.amount import examples

SECRETS = [f"{i:032x}" for i in range(MAX_SEATS + 2)]


def a_room() -> Room:
    """A class with a lesson of two steps, of which the first asks, and with a scene without a lesson."""
    question = Question(text="Which way?", choices=("left", "right", "neither"), answer=1, because="It is.")
    steps = (
        Step(title="One", question=question, do="Look.", predict=2.0),
        Step(title="Two", do="Try."),
    )
    scene = msgspec.structs.replace(sim.rope(masses=4), lesson=Lesson(steps=steps))
    return Room(code="ABCD", key="key", scenes=(scene, sim.rope()))


def an_answer(id: int, content: Vote | Prediction | Line | Work, turn: int = 0, **more: int) -> Answer:
    return Answer(
        **{"id": f"{id:016x}", "turn": turn, "seat": 0, "twin": 0, "stop": 0, "round": 0, **more},
        content=content,
    )


def asking() -> tuple[Room, Seat]:
    """A class that is asked, and a seat in it."""
    room = a_room()
    seat = room.enter(SECRETS[0])
    room.go(0, Phase.ASK)
    return room, seat


def test_a_class_goes_through_all_its_stops() -> None:
    room = a_room()
    went = []
    while (after := room.next()) is not None:
        room.go(*after)
        went.append((room.at, room.phase.value, room.round))
    # Its steps have nothing to hand in; it can be collected all the same.
    asked = ["show", "ask", "results", "run", "reveal", "explain", "try"]
    assert [phase for at, phase, _ in went if at == 0] == asked
    assert [phase for at, phase, _ in went if at == 1] == ["show", "try"]
    assert (Phase.COLLECT, 0) in room.order(0)
    assert [phase for at, phase, _ in went if at == 2] == ["show", "try", "collect"]
    with pytest.raises(Refused):
        room.go(3, Phase.SHOW)
    with pytest.raises(Refused):
        room.go(1, Phase.ASK)


def test_a_browser_comes_back_to_its_seat() -> None:
    room = a_room()
    first, second = room.enter(SECRETS[0]), room.enter(SECRETS[1])
    assert (first.number, second.number) == (1, 2)
    assert first.name != second.name
    room.is_open = False
    assert room.enter(SECRETS[1]) is second
    with pytest.raises(Refused, match="open the door"):
        room.enter(SECRETS[2])
    room.is_open = True
    room.remove(1)
    with pytest.raises(Refused, match="closed this seat"):
        room.enter(SECRETS[0])
    # A number is not given twice: answers of the one who left are not another's.
    assert room.enter(SECRETS[2]).number == 3


def test_a_class_is_full() -> None:
    room = a_room()
    given_names = {room.enter(secret).name for secret in SECRETS[:MAX_SEATS]}
    assert len(given_names) == MAX_SEATS
    with pytest.raises(Refused, match=f"{MAX_SEATS} seats"):
        room.enter(SECRETS[MAX_SEATS])


def test_one_visitor_does_not_fill_a_class() -> None:
    room = a_room()
    granted = {room.enter(secret).number for secret in SECRETS[:MAX_SEATS_PER_VISITOR]}
    with pytest.raises(Refused, match=f"{MAX_SEATS_PER_VISITOR} seats"):
        room.enter(SECRETS[MAX_SEATS_PER_VISITOR], granted=granted)
    assert room.enter(SECRETS[MAX_SEATS_PER_VISITOR], granted={99}).number == MAX_SEATS_PER_VISITOR + 1
    # Who has a seat keeps it, and where the teacher removes one there is room.
    assert room.enter(SECRETS[0], granted=granted).number == 1
    room.remove(2)
    room.enter(SECRETS[MAX_SEATS_PER_VISITOR + 1], granted=granted)


def test_a_choice_can_be_changed_until_all_are_shown() -> None:
    room, seat = asking()
    assert room.take(seat.number, an_answer(1, Vote(0), turn=1))
    assert room.take(seat.number, an_answer(2, Vote(2), turn=2))
    assert room.bars(0, 0) == [0, 0, 1]
    # The first one comes once more, from a network that says things twice.
    assert not room.take(seat.number, an_answer(1, Vote(0), turn=1))
    assert room.bars(0, 0) == [0, 0, 1]
    room.go(0, Phase.RESULTS)
    with pytest.raises(Refused, match="have been shown"):
        room.take(seat.number, an_answer(3, Vote(1), turn=3))
    assert not room.take(seat.number, an_answer(2, Vote(2), turn=2))
    assert room.bars(0, 0) == [0, 0, 1]
    # Whoever was away when it was asked is late, and counts.
    other = room.enter(SECRETS[1])
    assert room.take(other.number, an_answer(4, Vote(1)))
    assert room.answers[f"{4:016x}"].late
    assert room.bars(0, 0) == [0, 1, 1]


def test_a_second_vote_is_another_one() -> None:
    room, seat = asking()
    room.take(seat.number, an_answer(1, Vote(0), turn=1))
    with pytest.raises(Refused, match="not been asked"):
        room.take(seat.number, an_answer(2, Vote(1), turn=2, round=1))
    room.go(0, Phase.ASK, 1)
    room.take(seat.number, an_answer(2, Vote(1), turn=2, round=1))
    assert (room.bars(0, 0), room.bars(0, 1)) == ([1, 0, 0], [0, 1, 0])


def test_two_at_one_seat_answer_both() -> None:
    room, seat = asking()
    with pytest.raises(Refused, match="Only one"):
        room.take(seat.number, an_answer(1, Vote(0), twin=1))
    seat.twins = True
    room.take(seat.number, an_answer(1, Vote(0)))
    room.take(seat.number, an_answer(2, Vote(1), twin=1))
    assert room.bars(0, 0) == [1, 1, 0]


@pytest.mark.parametrize(
    "forged",
    [
        an_answer(1, Vote(3)),
        an_answer(1, Vote(0), twin=1),
        an_answer(1, Vote(0), stop=1),
        an_answer(1, Vote(0), stop=7),
        an_answer(1, Vote(0), stop=-1),
        an_answer(1, Vote(0), round=1),
        an_answer(1, Line("too early")),
        an_answer(1, Work()),
        an_answer(1, Prediction(((0.0, 0.0),))),
        an_answer(1, Prediction(((float("nan"), 0.0),) * 4)),
    ],
)
def test_what_nobody_asked_for_is_refused(forged: Answer) -> None:
    room, seat = asking()
    before = msgspec.json.encode(room)
    with pytest.raises(Refused):
        room.take(seat.number, forged)
    assert msgspec.json.encode(room) == before


def test_a_seat_gives_no_answers_of_another() -> None:
    room, seat = asking()
    other = room.enter(SECRETS[1])
    room.take(seat.number, an_answer(1, Vote(0), seat=other.number))
    assert room.answers[f"{1:016x}"].seat == seat.number
    with pytest.raises(Refused, match="somebody else"):
        room.take(other.number, an_answer(1, Vote(1)))
    room.remove(seat.number)
    assert room.bars(0, 0) == [0, 0, 0]
    with pytest.raises(Refused):
        room.take(seat.number, an_answer(2, Vote(1)))


def test_what_is_sealed_does_not_come_on_the_wall() -> None:
    room, seat = asking()
    room.take(seat.number, an_answer(1, Prediction(((0.0, 0.0),) * 4)))
    with pytest.raises(Refused, match="before all are shown"):
        room.put_on_wall(f"{1:016x}")
    room.go(0, Phase.RESULTS)
    room.put_on_wall(f"{1:016x}")
    assert room.on_wall == f"{1:016x}"
    room.remove(seat.number)
    assert room.on_wall == ""


def test_a_line_is_text_on_one_line() -> None:
    room, seat = asking()
    room.go(0, Phase.EXPLAIN)
    room.take(seat.number, an_answer(1, Line("because\n<b>it</b> is")))
    ((_, line),) = room.given(0, 0, Line)
    assert line == Line("because <b>it</b> is")
    with pytest.raises(Refused, match="needs a letter"):
        room.take(seat.number, an_answer(2, Line("\u200b"), turn=1))


def test_names_are_given_unless_the_teacher_allows_others() -> None:
    room = a_room()
    seat, other = room.enter(SECRETS[0]), room.enter(SECRETS[1])
    before = seat.name
    room.rename(seat.number)
    assert seat.name != before
    with pytest.raises(Refused, match="names are given"):
        room.rename(seat.number, "Ann")
    room.own_names = True
    room.rename(seat.number, " An\u200bn ")
    assert seat.name == "An n"
    with pytest.raises(Refused, match="Somebody has"):
        room.rename(other.number, "an N")


def test_another_device_takes_a_seat_over() -> None:
    room, seat = asking()
    room.take(seat.number, an_answer(1, Vote(0)))
    with pytest.raises(Refused, match="No seat"):
        room.move(SECRETS[1], "")
    room.offer_move(seat.number)
    digits = seat.move
    room.enter(SECRETS[1])
    assert room.move(SECRETS[1], digits) is seat
    assert room.enter(SECRETS[1]) is seat
    assert len(room.seats) == 1
    with pytest.raises(Refused, match="No seat"):
        room.move(SECRETS[2], digits)
    # The old device is a new pupil's now.
    assert room.enter(SECRETS[0]) is not seat


def test_a_device_that_has_answered_takes_no_other_seat_over() -> None:
    room, seat = asking()
    room.offer_move(seat.number)
    other = room.enter(SECRETS[1])
    room.take(other.number, an_answer(1, Vote(0)))
    with pytest.raises(Refused, match="answers of its own"):
        room.move(SECRETS[1], seat.move)
    assert room.seats[other.number] is other


def test_where_there_is_a_question_only_an_answer_to_it_counts_as_one() -> None:
    room, seat = asking()
    room.take(seat.number, an_answer(1, Prediction(((0.0, 0.0),) * 4)))
    assert room.answered() == set()
    room.take(seat.number, an_answer(2, Vote(0)))
    assert room.answered() == {seat.number}


def test_a_seat_follows_only_where_it_has_a_body_of_its_own() -> None:
    room, seat = asking()
    with pytest.raises(Refused, match="All look"):
        room.follow(seat.number, True)
    room.go(0, Phase.TRY)
    room.follow(seat.number, True)
    assert seat.follows
    room.gather(True)
    with pytest.raises(Refused, match="All look"):
        room.follow(seat.number, False)
    room.gather(False)
    assert not seat.follows
    room.follow(seat.number, True)
    room.put_seat_on_wall(seat.number)
    room.gather(True)
    room.go(0, Phase.COLLECT)
    assert (seat.follows, room.gathered, room.seat_on_wall) == (False, False, 0)


def test_the_wall_shows_one_thing_of_one_seat_alone() -> None:
    room, seat = asking()
    with pytest.raises(Refused, match="no bodies"):
        room.put_seat_on_wall(seat.number)
    room.go(0, Phase.COLLECT)
    room.take(seat.number, an_answer(1, Work()))
    room.put_on_wall(f"{1:016x}")
    assert room.is_on_wall(seat.number)
    other = room.enter(SECRETS[1])
    room.put_seat_on_wall(other.number)
    assert room.is_on_wall(other.number)
    assert not room.is_on_wall(seat.number)
    with pytest.raises(Refused, match="no such seat"):
        room.put_seat_on_wall(99)
    room.remove(other.number)
    assert room.seat_on_wall == 0


def test_codes_are_no_words_for_a_wall() -> None:
    numbers = iter([names.LETTERS.index(c) for c in "CRAP" + "ASSB" + "ABCD" + "WXYZ"])
    assert names.new_code({"ABCD"}, lambda _: next(numbers)) == "WXYZ"


@pytest.mark.parametrize("tag", languages())
def test_names_of_a_class_are_of_its_language(tag: str) -> None:
    """All differ, also where a pupil's own name is a single word; the first ones in animal and colour."""
    room = a_room()
    room.language, room.own_names = tag, True
    with speaking(tag):
        animals, colors = say("seat-animals").splitlines(), say("seat-colors").splitlines()
    assert len(set(animals)) == len(animals) >= 45
    assert len(set(colors)) == len(names.COLORS)
    first = room.enter(SECRETS[0]).number
    room.rename(first, "Ann")
    room.rename(room.enter(SECRETS[1]).number)
    given: list[names.Name] = []
    with speaking(tag):
        for _ in range(2 * len(animals)):
            given.append(names.new_name([name.text for name in given]))
    assert len({name.text for name in given}) == len(given)
    assert {name.color for name in given[:10]} == set(names.COLORS)
    assert all(name.text.isprintable() for name in given)
    with speaking(tag):
        rest = {names.new_name([], lambda _, i=i: i).text for i in range(len(animals) * len(colors))}
    assert len(rest) == len(animals) * len(colors)
    assert room.seats[2].given in rest


_CONTENT = {Vote: Vote(1), Prediction: Prediction(((1.0, 2.0),) * 4), Line: Line("so"), Work: Work()}


@settings(max_examples=examples(200))
@given(st.data())
def test_whatever_happens_every_answer_counts_once_and_the_last_one_before_it_is_shown(
    data: st.DataObject,
) -> None:
    room = a_room()
    seats = [room.enter(secret).number for secret in SECRETS[:3]]
    sent: list[tuple[int, Answer]] = []
    last: dict[tuple[int, int, type], Answer] = {}
    for _ in range(data.draw(st.integers(1, 25))):
        act = data.draw(st.sampled_from(("next", "give", "again", "restart")))
        if act == "next" and (after := room.next()) is not None:
            room.go(*after)
        elif act == "restart":
            room = msgspec.json.decode(msgspec.json.encode(room), type=Room)
        elif act == "again" and sent:
            number, answer = data.draw(st.sampled_from(sent))
            before = dict(room.answers)
            try:
                counts = room.take(number, answer)
            except Refused:
                counts = False
            if answer.id in before:
                assert not counts
            if counts:  # it was refused at first, since the class was not there yet
                last[number, answer.round, type(answer.content)] = answer
            else:
                assert room.answers == before
        elif act == "give":
            kind = data.draw(st.sampled_from(list(_CONTENT)))
            number = data.draw(st.sampled_from(seats))
            answer = an_answer(len(sent) + 1, _CONTENT[kind], turn=len(sent), round=room.round)
            sent.append((number, answer))
            if room.phase is kind.phase and room.at == 0:
                assert room.take(number, answer)
                last[number, room.round, kind] = answer
    places = [answer.slot for answer in room.answers.values()]
    assert len(places) == len(set(places))
    assert {answer.id for answer in last.values()} == set(room.answers)


@pytest.mark.parametrize(
    ("right", "of", "again"), [(1, 3, False), (1, 2, True), (2, 3, True), (3, 4, False), (0, 0, False)]
)
def test_only_a_class_that_is_split_is_asked_again(right: int, of: int, again: bool) -> None:
    room = a_room()
    seats = [room.enter(f"{n:032x}") for n in range(max(of, 1))]
    room.go(0, Phase.ASK)
    for n in range(of):
        room.take(seats[n].number, an_answer(n + 1, Vote(1 if n < right else 0)))
    room.go(0, Phase.RESULTS)
    assert room.next() == ((0, Phase.ASK, 1) if again else (0, Phase.RUN, 0))


def test_after_a_second_vote_it_is_the_one_that_counts() -> None:
    room, seat = asking()
    room.take(seat.number, an_answer(1, Vote(0)))
    room.go(0, Phase.RESULTS)
    room.go(0, Phase.ASK, 1)
    room.go(0, Phase.RUN)
    assert room.vote_round == 0, "nobody has voted again"
    room.go(0, Phase.ASK, 1)
    room.take(seat.number, an_answer(2, Vote(1), round=1))
    room.go(0, Phase.RESULTS, 1)
    assert room.next() == (0, Phase.RUN, 0)
    room.go(0, Phase.REVEAL)
    assert room.vote_round == 1
