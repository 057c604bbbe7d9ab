"""Logs: whatever was done to a body is in them, and done again it leads to the same bits."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from app.session import commands, log, record
from app.session.hand import GIZMO
from app.session.log import Check, Log, decode_log
from app.ui.kept.keeping import MAX_BYTES
from sim.errors import InputError
from sim.scene.types import Damage
from sim.solve.registry import METHODS
from sim.store.files import encode_fields
from tests.amount import examples
from tests.app.command import Softrod, refused, rows_of
from tests.app.pages import SessionPage, in_one_piece
from tests.app.recording import agrees, busy_page, joined, lines_of, log_of, perturbed, replayed
from tests.sim.fuzzing import with_muscles


@pytest.mark.parametrize(
    "scene",
    [sim.set_choice(sim.load_scene("tutorial-3.3"), "method", method) for method in METHODS]
    + [sim.load_scene(preset) for preset in ("ring", "hair-tuft", "flag-pole")],
    ids=lambda scene: f"{scene.name} {scene.integrator.method}",
)
def test_a_log_leads_to_the_same_bits(scene: sim.Scene) -> None:
    page = busy_page(scene)
    assert page.simulation.divergence is None
    player = agrees(page)
    assert player.steps > 300
    assert player.record.checks >= 2


def test_a_log_of_muscles_leads_to_the_same_bits_also_through_another_tempo() -> None:
    scene = with_muscles(sim.load_scene("tutorial-3.3"), np.random.default_rng(5))
    page = busy_page(scene)
    page.frames(1, commands.Play(False))
    simulation = page.simulation
    beat, time = simulation.scene.beat, simulation.time
    page.frames(1, commands.SetValue("tempo", 0.7))
    assert beat
    assert page.simulation.scene.beat == beat.at_tempo(0.7, time)
    page.frames(20, commands.Play(True))
    page.frames(5, commands.GoBack(0.1))
    page.frames(20, commands.Play(True))
    agrees(page)


def test_a_log_of_a_follower_of_choices_and_of_the_energy() -> None:
    page = SessionPage()
    page.frames(20, commands.FollowEnergy(True), commands.Follow(True), commands.Point(290.0, 170.0))
    page.frames(20, commands.SetChoice("method", "adams"), commands.Point(340.0, 190.0))
    page.frames(20, commands.Follow(False), commands.SetChoice("force_law", "conservative"))
    page.frames(20, commands.SetValue("template", 90.0))
    # With another method they begin anew.
    followed = [entry.on for entry in agrees(page).record.entries if isinstance(entry, log.FollowEnergy)]
    assert followed == [True, False, True]


def test_a_log_of_a_machine_that_is_too_slow() -> None:
    """Where the attempts of a frame run out, the body stops between two steps of the clock."""
    page = SessionPage(sim.set_value(sim.load_scene("ring"), "tolerance", 1e-6))
    in_one_piece(page.session.costs, 9)
    page.frames(90)
    assert page.session.pacer.behind > 0.1
    agrees(page)


def test_a_log_of_frames_that_just_suffice() -> None:
    """What `auto` tries depends on how much is left in a frame, also where that is enough."""
    page = SessionPage(sim.set_value(sim.load_scene("hair-tuft"), "tolerance", 0.1))
    in_one_piece(page.session.costs, 12)
    page.frames(12)
    agrees(page)


PLACES = st.floats(0.0, 600.0)
HANDS = st.integers(0, GIZMO)
ACTS: st.SearchStrategy[commands.Command] = st.one_of(
    st.builds(commands.DragStart, st.integers(-1, 12), PLACES, PLACES, HANDS),
    st.builds(commands.Point, PLACES, PLACES, HANDS),
    st.builds(commands.Point, PLACES, PLACES, HANDS, st.just(True)),
    st.builds(commands.DragEnd, HANDS),
    st.builds(commands.Follow, st.booleans()),
    st.builds(commands.HoldKeys, st.frozensets(st.sampled_from(["up", "down", "left", "right"]))),
    st.builds(
        commands.SetValue, st.sampled_from(["gravity", "dt", "rest_angle", "masses"]), st.floats(0.0, 90.0)
    ),
    st.builds(
        commands.SetChoice, st.just("method"), st.sampled_from(["rk4", "symplectic_euler", "adams", "rodas4"])
    ),
    st.builds(commands.RestoreSceneValues, st.sampled_from(["body", "solver"])),
    st.builds(commands.FollowEnergy, st.booleans()),
    st.builds(commands.Play, st.sampled_from([None, True, False])),
    st.builds(commands.DoSteps, st.integers(0, 20)),
    st.just(commands.Reset()),
    st.builds(commands.GoTo, st.floats(0.0, 2.0)),
    st.builds(commands.GoBack, st.floats(0.0, 0.5)),
    st.sampled_from([commands.GoForward(), commands.Play(True), commands.BackBeforeDivergence()]),
)


@given(st.lists(st.tuples(ACTS, st.integers(0, 12)), max_size=25))
@settings(max_examples=examples(60))
def test_whatever_is_done_a_log_leads_to_the_same_bits(acts: list[tuple[commands.Command, int]]) -> None:
    page = SessionPage()
    for command, frames in acts:
        page.session.post(command)
        page.session.drain()
        page.frames(frames)
    agrees(page)
    page.frames(10, commands.Play(True))
    agrees(page)


def test_a_log_of_a_body_that_comes_late() -> None:
    from studies.bench import frames

    page = SessionPage(frames.rod(100, sim.Integrator()))
    page.frames(10)
    page.drag(0, 300.0, frames=20)
    assert page.simulation.behind
    page.frames(40, commands.DragEnd())
    agrees(page)


def test_a_log_starts_anew_with_another_body_and_at_reset() -> None:
    page = busy_page(sim.load_scene("tutorial-3.3"))
    long = len(log_of(page))
    page.frames(5, commands.Reset(), commands.Play(True))
    assert len(log_of(page)) < long / 3
    agrees(page)
    page.frames(30, commands.SetValue("masses", 7))
    assert len(agrees(page).record.scene.masses) == 7
    page.frames(30, commands.Open(sim.load_scene("ring")))
    assert agrees(page).record.scene.name == "ring"


def test_keys_that_are_held_while_a_log_starts_anew_are_in_it() -> None:
    page = SessionPage()
    page.frames(5, commands.HoldKeys(frozenset({"up"})))
    page.frames(5, commands.Reset(), commands.Play(True))
    assert page.simulation.rest_length_scale > 1.0
    agrees(page)


def test_equal_entries_are_folded_and_only_the_last_of_many_moments_is_noted() -> None:
    page = SessionPage()
    page.frames(30)
    page.frames(1, commands.Play(False))
    size = len(log_of(page))
    x, y = page.simulation.positions[0]
    page.frames(600, commands.DragStart(0, x, y))
    for i in range(100):
        page.frames(1, commands.GoTo(0.004 * i))
    grown = log_of(page)
    assert len(grown) - size < 3000
    assert grown.count(b'"do":"restore"') == 1
    agrees(page)


def test_a_log_that_grows_too_long_starts_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(log, "MAX_LOG_BYTES", 3000)
    page = SessionPage("ring")
    x, y = page.drag(3)
    for i in range(400):
        page.frames(1, commands.Point(x + 0.1 * i, y), commands.HoldKeys(frozenset({"up"})))
    data = log_of(page)
    header, first, *_ = data.splitlines()
    assert json.loads(header)["note"] == record.TOO_LONG
    assert json.loads(first)["do"] == "restore"
    # What the log starts anew with, which has the whole scene, does not count.
    assert len(data) - len(header) - len(first) < 3000
    agrees(page)
    page.frames(30, commands.DragEnd())
    agrees(page)


def test_a_log_stays_short_while_time_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(log, "MAX_LOG_BYTES", 3000)
    page = SessionPage()
    page.frames(10)
    x, y = page.simulation.positions[8]
    page.frames(1, commands.Play(False), commands.DragStart(8, x, y))
    acts: list[commands.Command] = []
    for i in range(25):
        acts += [
            commands.Point(x + 0.1 * i, y), commands.SetValue("gravity", 1.0 + i), commands.GoBack(),
            commands.DragStart(8, x, y), commands.FollowEnergy(bool(i % 2)), commands.DragEnd(),
        ]  # fmt: skip
    for act in acts:
        page.frames(1, act)
        assert sum(map(len, page.session.recorder.file().splitlines()[1:-1])) < 3000 + 4000
    agrees(page)
    page.frames(30, commands.Play(True))
    agrees(page)


def test_a_body_that_is_larger_than_a_log_does_not_start_it_anew_all_the_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(log, "MAX_LOG_BYTES", 3000)
    page = SessionPage(sim.rope(masses=100))
    page.frames(1, commands.GoBack())
    begun: set[bytes] = set()
    for i in range(200):
        page.frames(1, commands.Play(True), commands.HoldKeys(frozenset({"up"} if i % 2 else ())))
        begun.add(page.session.recorder.file().splitlines()[1])
    assert 1 < len(begun) < 10


def test_a_page_can_open_the_longest_log_that_it_saves() -> None:
    assert log.MAX_LOG_BYTES + 1_000_000 <= MAX_BYTES


def test_a_log_says_where_it_was_made_and_not_whose(tmp_path: Path) -> None:
    import platform

    data = log_of(busy_page(sim.load_scene("tutorial-3.3")))
    header = json.loads(data.splitlines()[0])
    assert header["format"] == "softrod-log"
    assert set(header["machine"]) == {"kind", "cpu", "numba"}
    assert header["softrod"]
    assert platform.node().encode() not in data
    assert str(Path.home()).encode() not in data


def test_steps_by_numpy_are_left_out_and_what_follows_is_exact(monkeypatch: pytest.MonkeyPatch) -> None:
    """While a kernel is compiled, nobody could do the same again; then the log goes on from there."""
    late = [True]
    complete = sim.Simulation.complete.fget
    assert complete is not None
    monkeypatch.setattr(sim.Simulation, "complete", property(lambda self: not late[0] and complete(self)))
    page = SessionPage()
    x, y = page.simulation.positions[5]
    page.frames(20, commands.DragStart(5, x, y), commands.HoldKeys(frozenset({"up"})))
    early = replayed(log_of(page))
    assert (early.steps, early.agrees) == (0, True)
    late[0] = False
    page.frames(10, commands.Point(x + 20.0, y))
    assert 0 < agrees(page).steps < page.simulation.step_count


# ------------------------------------------------------------------------- differing
@pytest.fixture(scope="module")
def data() -> bytes:
    return log_of(busy_page(sim.load_scene("tutorial-3.3")))


def test_a_replay_says_where_it_first_differs(data: bytes) -> None:
    player = replayed(perturbed(data))
    checks = player.record.checks
    assert not player.agrees
    one, two = [(line["step"], line["time"]) for line in lines_of(data) if line.get("do") == "check"][:2]
    says = f"step {two[0]}, t = {two[1]:.6g} s (check 2 of {checks}; it agrees at step {one[0]}), "
    assert player.verdict.startswith(f"differs first at {says}")
    assert player.ended  # it goes on
    assert "largest distance of a mass noted 0.125 px" in player.verdict
    assert "recorded on abacus beads with numba 1" in player.verdict


def test_a_replay_says_what_differs_besides_positions(data: bytes) -> None:
    lines = lines_of(data)
    checks = [line for line in lines if line.get("do") == "check"]
    checks[1]["state"] = "0" * 16
    player = replayed(joined(lines))
    assert player.verdict.startswith(f"differs first at step {checks[1]['step']}, t = ")
    assert f"it agrees at step {checks[0]['step']})" in player.verdict
    assert "not in positions and velocities" in player.verdict


def test_a_log_without_states_is_replayed_as_before(data: bytes) -> None:
    lines = lines_of(data)
    for line in lines:
        line.pop("state", None)
    assert replayed(joined(lines)).agrees


def test_a_state_is_all_that_changes() -> None:
    simulation = sim.Simulation(sim.load_scene("girder"))
    states = {log.state_of(simulation)}
    simulation.keys = {"up"}
    states.add(log.state_of(simulation))
    simulation.step(1)
    simulation.keys = ()
    states.add(log.state_of(simulation))
    moment = simulation.capture()
    damage = Damage(broken=(1,), set_lengths=(), hardened=(), set_angles=())
    for other in (replace(moment, damage=damage), replace(moment, rest_angle_shift=1.0)):
        simulation.restore(other)
        states.add(log.state_of(simulation))
    assert len(states) == 5
    simulation.restore(moment)
    assert log.state_of(simulation) in states


def test_a_step_less_differs(data: bytes) -> None:
    lines = lines_of(data)
    at = next(i for i, line in enumerate(lines) if line.get("do") == "step")
    player = replayed(joined(lines[:at] + lines[at + 1 :]))
    assert "differs first" in player.verdict
    assert "(check 1 of" in player.verdict


def test_run_replays_what_a_page_saved(data: bytes, tmp_path: Path, softrod: Softrod) -> None:
    saved, out = tmp_path / "log.jsonl", tmp_path / "o.csv"
    saved.write_bytes(data)
    result = softrod("run", "--inputs", saved, "--every", "50", "--out", out)
    assert result.returncode == 0, result.stderr
    player = replayed(data)
    assert result.stdout.strip() == player.verdict
    assert f"replayed {player.steps} steps; all {player.record.checks} checks agree, digest" in result.stdout
    rows = rows_of(out)[1:]
    assert len(rows) > 5
    assert softrod("run", "tutorial-3.3", "--inputs", saved).returncode == 0
    refused(softrod("run", "ring", "--inputs", saved), "another scene than ring")
    refused(softrod("run", "--inputs", saved, "--set", "gravity=0"), "--set")
    saved.write_bytes(perturbed(data))
    refused(softrod("run", "--inputs", saved), "differs first at step ", "(check 2 of")


# ------------------------------------------------------------------------- nothing in a log is trusted
POSE = {"positions": [[0.0, 0.0]] * 12, "velocities": [[0.0, 0.0]] * 12}


@pytest.mark.parametrize(
    ("entry", "fragment"),
    [
        ('{"do":"step","n":-1}', "n"),
        ('{"do":"step","n":1e9}', "n"),
        ('{"do":"step","n":1,"times":0}', "times"),
        ('{"do":"jump"}', "jump"),
        ('{"do":"move","mass":0,"to":[1e300,0]}', "to"),
        ('{"do":"move","mass":0,"to":[NaN,0]}', "line 2"),
        ('{"do":"keys","held":["enter"]}', "enter"),
        ('{"do":"step","n":1,"more":2}', "more"),
        ('{"do":"set","key":"masses","value":5}', "masses"),
        (json.dumps({"do": "restore", "pose": POSE, "time": -1.0, "step": 0}), "time"),
        (json.dumps({"do": "restore", "pose": POSE, "time": 0.0, "step": 0, "scale": 0.0}), "scale"),
        ('{"do":"restore","pose":{"positions":[],"velocities":[]},"time":0,"step":0}', "12 masses"),
        ("nonsense", "line 2"),
        ("[1, 2]", "line 2"),
    ],
)
def test_a_bad_line_is_named(entry: str, fragment: str) -> None:
    header = log.encode_header(sim.load_scene("tutorial-3.3"))
    with pytest.raises(InputError, match=r"^my\.log: line 2: ") as error:
        decode_log(header + b"\n" + entry.encode(), "my.log")
    assert fragment in str(error.value)
    assert "\n" not in str(error.value)


def test_a_bad_header_is_named() -> None:
    header = json.loads(log.encode_header(sim.load_scene("tutorial-3.3")))
    bad = {"version": 2, "scene": 3, "more": 1, "machine": {"host": "me"}}
    for change in (*({key: value} for key, value in bad.items()), {"scene": {"name": "x"}}):
        with pytest.raises(InputError, match=r"^my\.log: line 1: "):
            decode_log(json.dumps(header | change).encode(), "my.log")


def test_what_cannot_be_done_is_named_by_its_line() -> None:
    header = log.encode_header(sim.load_scene("tutorial-3.3"))
    for entry in (
        b'{"do":"grab","mass":99}',
        b'{"do":"set","key":"weight","value":1}',
        b'{"do":"choose","key":"method","value":"leap"}',
    ):
        with pytest.raises(InputError, match=r"^log: line 3: "):
            replayed(header + b'\n{"do":"step","n":3}\n' + entry)


def test_a_check_notes_few_masses_of_a_large_body() -> None:
    simulation = sim.Simulation(sim.rope(masses=1000))
    check = log.check_of(simulation)
    assert 16 <= len(check.at) <= log.NOTED
    assert isinstance(check, Check)
    assert len(msgspec.json.encode(check)) < 2000


def test_a_log_is_read_back_as_it_was_written(data: bytes) -> None:
    recorded = decode_log(data, "log")
    assert isinstance(recorded, Log)
    assert [encode_fields(entry) for entry in recorded.entries] == data.splitlines()[1:]
