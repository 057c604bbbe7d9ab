"""The command line, run as a user runs it."""

from __future__ import annotations

import io
import json
import signal
import socket
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import msgspec
import numpy as np
import platformdirs
import pytest

import sim
from app.session.log import Keys, read_log
from app.session.preparation import compile_status
from sim.errors import InputError
from tests.app.command import Result, Softrod, refused, rows_of


def test_run_writes_a_table_that_reads_back_exactly(tmp_path: Path, softrod: Softrod) -> None:
    out = tmp_path / "rope.csv"
    assert softrod("run", "tutorial-3.3", "--steps", 100, "--every", 40, "--out", out).returncode == 0
    header, *rows = rows_of(out)
    assert header[:4] == ["step", "time", "x0", "y0"]
    assert len(header) == 2 + 24
    assert [row[0] for row in rows] == ["40", "80"]
    simulation = sim.Simulation(sim.load_scene("tutorial-3.3"))
    simulation.step(80)
    assert [float(value) for value in rows[1][2:]] == simulation.positions.ravel().tolist()
    assert float(rows[1][1]) == simulation.time


def test_tables_have_decimal_commas_if_they_are_to(tmp_path: Path, softrod: Softrod) -> None:
    plain, commas = tmp_path / "plain.csv", tmp_path / "commas.csv"
    for words in ((), ("--energy",), ("--record", "joint0.angle", "--record", "mass3.x")):
        run = "run", "ring", "--steps", "20", "--every", "5", *words, "--out"
        assert softrod(*run, plain).returncode == 0
        assert softrod(*run, commas, "--csv-comma").returncode == 0
        text = commas.read_text()
        head, *rows = plain.read_text().splitlines()
        wanted = [head.replace(",", ";"), *(row.replace(",", ";").replace(".", ",") for row in rows)]
        assert text.splitlines() == wanted


def test_run_replays_moves_and_keys(tmp_path: Path, softrod: Softrod) -> None:
    log, out = tmp_path / "log.jsonl", tmp_path / "out.npz"
    lines = [
        {"do": "move", "mass": 0, "to": [310.0, 170.0]},
        {"do": "step", "n": 1, "times": 10},
        {"do": "keys", "held": ["up", "right"]},
        {"do": "step", "n": 1, "times": 15},
        {"do": "keys", "held": []},
        {"do": "move", "mass": 0, "to": [350.0, 190.0]},
    ]
    log.write_text("\n".join(map(json.dumps, lines)))
    result = softrod("run", "tutorial-3.3", "--duration", "0.1", "--inputs", log, "--out", out)
    assert result.returncode == 0, result.stderr
    table = np.load(out)
    assert table["step"].tolist() == list(range(1, 41))
    assert table["positions"].shape == (40, 12, 2)
    simulation = sim.Simulation(sim.load_scene("tutorial-3.3"))
    simulation.move(0, (310.0, 170.0))
    simulation.step(10)
    simulation.keys = {"up", "right"}
    simulation.step(15)
    simulation.keys = set()
    simulation.move(0, (350.0, 190.0))
    simulation.step(15)
    assert np.array_equal(table["positions"][-1], simulation.positions)


def test_settings_are_applied_and_checked(tmp_path: Path, softrod: Softrod) -> None:
    out = tmp_path / "o.csv"
    words = ("run", "tutorial-3.2", "--steps", 1, "--out", out)
    assert softrod(*words, "--set", "template=-135", "--set", "masses=5").returncode == 0
    assert len(rows_of(out)[0]) == 2 + 10
    for assignment, fragment in (
        ("gravity=1e99", "-1e+06..1e+06"),
        ("gravity=nan", "KEY=VALUE"),
        ("gravity", "KEY=VALUE"),
        ("weight=1", "there is no such setting"),
        ("template=30", "180, 135, 90"),
        ("masses=2.5", "whole number"),
    ):
        refused(softrod(*words, "--set", assignment), fragment)


def test_a_name_that_is_misspelt_is_answered_with_the_most_similar_one(
    tmp_path: Path, softrod: Softrod
) -> None:
    run = ("run", "rope", "--steps", 1, "--out", tmp_path / "o.csv")
    sweep = ("sweep", "rope", "--out", tmp_path / "s")
    for words, meant in (
        (("run", "pendullum"), "pendulum"),
        ((*run, "--set", "gravty=1"), "gravity"),
        ((*run, "--set", "metod=rk4"), "method"),
        ((*run, "--set", "method=rk45"), "rk4"),
        ((*run, "--record", "enery.total"), "energy"),
        ((*run, "--record", "energy.totl"), "total"),
        ((*sweep, "--vary", "gravty=1,2", "--measure", "sag"), "gravity"),
        ((*sweep, "--vary", "gravity=1,2", "--measure", "sagg"), "sag"),
    ):
        refused(softrod(*words), f"(did you mean '{meant}'?)")
    assert "did you mean" not in softrod(*run, "--set", "qqq=1").stderr


def test_a_runaway_keeps_its_good_rows_and_says_why(tmp_path: Path, softrod: Softrod) -> None:
    log, out = tmp_path / "log.jsonl", tmp_path / "o.csv"
    log.write_text('{"do": "move", "mass": 0, "to": [400, 150]}\n')
    words = ("run", "tutorial-3.3", "--steps", "5000", "--inputs", log, "--out", out)
    refused(
        softrod(*words, "--set", "angular_stiffness=60000"),
        "stability limit",
        "angular stiffness",
    )
    rows = rows_of(out)[1:]
    assert 0 < len(rows) < 5000
    assert np.isfinite(np.array(rows, float)).all()


@pytest.mark.parametrize(
    ("line", "fragment"),
    [
        ('{"do": "move", "mass": 3, "to": [0, 0]}', "line 1: mass 3 is not held"),
        ('\n{"do": "move", "mass": 99, "to": [0, 0]}', "line 2: mass 99 does not exist"),
        ('{"do": "keys", "held": "up"}', "line 1"),
        (
            '{"step": 0, "move": {"mass": 0, "to": [0, 0]}}',
            "line 1: the field `do` is missing, which says what",
        ),
    ],
)
def test_bad_inputs_are_refused(tmp_path: Path, line: str, fragment: str, softrod: Softrod) -> None:
    log = tmp_path / "log.jsonl"
    log.write_text(line)
    words = ("run", "tutorial-3.3", "--steps", "3", "--inputs", log, "--out", tmp_path / "o.csv")
    refused(softrod(*words), fragment)
    assert not (tmp_path / "o.csv").exists()


@pytest.mark.parametrize(
    ("words", "fragment"),
    [
        (("--steps", "3"), "--out"),
        (("--out", "x.txt", "--steps", "1"), ".csv or .npz"),
        (("--out", "nowhere/x.csv", "--steps", "1"), "does not exist"),
        (("--out", "x.csv"), "--steps or --duration"),
        (("--out", "x.csv", "--steps", "1", "--duration", "1"), "--steps or --duration"),
        (("--out", "x.csv", "--steps", "-1"), "--steps"),
        (("--out", "x.csv", "--duration", "nan"), "--duration"),
        (("--out", "x.csv", "--steps", "1", "--every", "0"), "--every"),
        (("--out", "x.csv", "--steps", "3", "--every", "4"), "no row would be written"),
    ],
)
def test_bad_arguments_are_refused(words: tuple[str, ...], fragment: str, softrod: Softrod) -> None:
    refused(softrod("run", "ring", *words), fragment)


def test_a_run_that_ends_before_its_first_row_has_a_table_without_rows(
    tmp_path: Path, softrod: Softrod
) -> None:
    out = tmp_path / "o.csv"
    words = ("--set", "dt=0.5", "--set", "method=symplectic_euler", "--steps", "5000", "--every", "5000")
    refused(softrod("run", "ring", *words, "--out", str(out)), "the 0 rows before it")
    assert out.read_text().startswith("step,time,x0,y0")
    assert len(out.read_text().splitlines()) == 1


def test_a_scene_is_needed_and_an_unknown_one_names_those_there_are(softrod: Softrod) -> None:
    refused(softrod("run", "--steps", "3", "--out", "x.csv"), "name a scene")
    refused(softrod("run", "no-such", "--steps", "1", "--out", "x.csv"), "no-such", "tutorial-3.3")


def test_scenes_are_listed_with_descriptions(softrod: Softrod) -> None:
    result = softrod("scenes")
    assert result.returncode == 0
    for info in sim.list_scenes():
        if info.built_in:
            assert info.name in result.stdout
            assert info.description.split()[0] in result.stdout
    assert "scenes of `softrod study`" in result.stdout


def test_check_tells_good_from_bad(tmp_path: Path, softrod: Softrod) -> None:
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    sim.save_scene(sim.rope(), good)
    bad.write_text('{"name": "x", "rope": {"mass": -1}}')
    assert softrod("check", good).returncode == 0
    result = softrod("check", good, bad, tmp_path / "missing.json")
    assert result.returncode == 1
    assert "good.json: rope, 12 masses, is valid" in result.stdout
    assert "bad.json: rope.mass: -1 is not in the range 1e-06..1e+06 kg" in result.stderr
    assert "missing.json" in result.stderr
    assert "Traceback" not in result.stderr


@pytest.mark.parametrize("encoding", ["cp1252", "ascii"])
def test_letters_that_the_terminal_lacks_are_no_error(
    encoding: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, softrod: Softrod
) -> None:
    path = tmp_path / "Маятник.json"
    sim.save_scene(sim.rope(name="Маятник"), path)

    def said(*words: str | Path) -> tuple[str, Result]:
        terminal = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
        with monkeypatch.context() as patch:
            patch.setattr(sys, "stdout", terminal)
            result = softrod(*words)
        terminal.flush()
        return terminal.buffer.getvalue().decode(encoding), result  # type: ignore[attr-defined]

    text, result = said("check", path)
    assert result.returncode == 0, result.stderr
    assert "12 masses, is valid" in text
    text, result = said("link", path, "--qr")
    assert text.startswith("http://")
    refused(result, f"--qr: the terminal's encoding, {encoding}, lacks the blocks of a QR code")


def test_inputs_of_other_programs(tmp_path: Path) -> None:
    line = '{"do": "keys", "held": ["left"]}'
    path, scene = tmp_path / "inputs.jsonl", sim.rope()
    for mark, encoding in ((b"\xef\xbb\xbf", "utf-8"), (b"\xff\xfe", "utf-16-le")):
        path.write_bytes(mark + f"{line}\r\n{line}\r\n".encode(encoding))
        assert read_log(path, scene).entries == [Keys(held=("left",))] * 2
    path.write_bytes(b'\n{"do": "keys", "held": [], "do": "keys"}')
    with pytest.raises(InputError, match=r"line 2: the key 'do' stands twice"):
        read_log(path, scene)
    path.write_bytes(b'{"do": "step", "n": 3}\n{"do": "keys", "held": ["\xe4"]}')
    with pytest.raises(InputError, match=r"inputs.jsonl: line 2: the text is not in UTF-8"):
        read_log(path, scene)


def test_a_log_that_was_written_by_hand_needs_a_scene_and_ends_where_it_ends(
    tmp_path: Path, softrod: Softrod
) -> None:
    log, out = tmp_path / "log.jsonl", tmp_path / "o.csv"
    log.write_text('{"do": "step", "n": 1, "times": 7}\n{"do": "step", "n": 5}')
    words = ("--inputs", log, "--out", out, "--every", "3")
    refused(softrod("run", *words), "line 1")
    result = softrod("run", "ring", *words)
    assert (result.returncode, result.stdout) == (0, "")
    # The last five steps are one call.
    assert [row[0] for row in rows_of(out)[1:]] == ["3", "6", "12"]
    assert softrod("run", "ring", *words, "--steps", "20").returncode == 0
    assert [row[0] for row in rows_of(out)[1:]] == ["3", "6", "12", "15", "18"]
    refused(softrod("run", "ring", "--inputs", log), "--out")


def test_a_cache_folder_that_cannot_be_written_is_said_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, softrod: Softrod
) -> None:
    (tmp_path / "file").write_bytes(b"")
    monkeypatch.setattr(platformdirs, "user_cache_path", lambda *_, **__: tmp_path / "file")
    trouble = f"compiled anew at every start, since the folder {tmp_path / 'file'} cannot be written"
    result = softrod("run", "ring", "--steps", "3", "--out", tmp_path / "ring.csv")
    assert result.returncode == 0
    assert result.stderr == f"softrod: the solver is {trouble}\n"
    assert softrod("check", tmp_path / "file").stderr.count("anew") == 0
    # The page says it in the line that tells how far the compiler is.
    assert compile_status(3, 19, "forces", "") == f"preparing forces: 3 of 19 parts ready; {trouble}"
    assert compile_status(19, 19, "", "") == ""


def test_check_notes_a_tolerance_that_is_coarse_for_its_body(tmp_path: Path, softrod: Softrod) -> None:
    metres = sim.rope(length=1.0, view=sim.View(unit="m"))
    sim.save_scene(metres, path := tmp_path / "metres.json")
    result = softrod("check", path)
    assert result.returncode == 0
    note = "integrator.tolerance: 0.1 m is coarse for a body of 1 m; 0.001 m is a thousandth of it"
    assert result.stdout.splitlines()[1] == f"{path}: note: {note}"
    fine = msgspec.structs.replace(metres, integrator=sim.Integrator(tolerance=1e-3))
    euler = msgspec.structs.replace(metres, integrator=sim.Integrator(method="symplectic_euler"))
    alone = sim.Scene(name="alone", masses=(sim.Mass(position=(0.0, 0.0)),))
    for scene in (fine, euler, alone, *map(sim.load_scene, ("tutorial-3.3", "pile"))):
        sim.save_scene(scene, path)
        assert ": note: " not in softrod("check", path).stdout


def test_help_lists_every_command(softrod: Softrod) -> None:
    result = softrod("--help")
    assert result.returncode == 0
    for command in ("run", "scenes", "check", "bench"):
        assert f"softrod {command}" in result.stdout


@contextmanager
def serving(*words: str) -> Iterator[tuple[subprocess.Popen[str], str, list[str]]]:
    """A process that serves, the address that it prints, and, once it has ended by itself, the rest."""
    process = subprocess.Popen(
        [sys.executable, "-m", "app", *words, "--port", "0", "--no-open"],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    assert process.stdout is not None
    output: list[str] = []
    try:
        line = process.stdout.readline()
        yield process, next(word for word in line.split() if word.startswith("http://")), output
        process.wait(timeout=30)
        # Not by `communicate`, which would miss what came in together with the first line.
        output.append(process.stdout.read())
    finally:
        process.kill()
    assert process.returncode == 0
    assert "Traceback" not in output[0]


def test_serving_ends_cleanly() -> None:
    with serving("ring") as (process, address, _):
        with urllib.request.urlopen(address, timeout=30) as page:
            assert page.status == 200
        # More than once: whoever wraps the command may pass on a signal that it got as well.
        for _ in range(5):
            process.send_signal(signal.SIGINT)


def test_a_busy_port_names_the_next_free_one(softrod: Softrod) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        refused(softrod("ring", "--port", str(port), "--no-open"), f"{port}", "free")


def test_a_scene_that_is_not_valid_is_not_served(tmp_path: Path, softrod: Softrod) -> None:
    bad = tmp_path / "bad.json"
    bad.write_text('{"name": "x"}')
    refused(softrod(bad, "--port", "0", "--no-open"), "bad.json", "masses")


def test_an_open_address_says_what_it_exposes_and_its_server_ends_when_it_is_told() -> None:
    with serving("ring", "--host", "0.0.0.0") as (process, address, output):
        # Who comes by a name that it does not know is told the option, and so is the terminal.
        strange = urllib.request.Request(address.partition("#")[0], headers={"Host": "school.example"})
        for _ in range(2):
            with pytest.raises(urllib.error.HTTPError, match="421"):
                urllib.request.urlopen(strange, timeout=30)
        for _ in range(5):
            process.send_signal(signal.SIGTERM)
    (printed,) = output
    assert "password" in printed
    assert printed.count("A page was refused. softrod does not answer to the address school.example.") == 1
    assert "start it with --allow-host school.example" in printed


def test_run_records_quantities_with_units_instead_of_positions(tmp_path: Path, softrod: Softrod) -> None:
    out = tmp_path / "swing.csv"
    words = ("run", "tutorial-3.3", "--steps", "100", "--every", "25", "--out", out)
    asked = ("--record", "mass11.y", "--record", "energy.residual", "--record", "joint3.angle")
    assert softrod(*words, *asked).returncode == 0
    header, *rows = rows_of(out)
    assert header == ["time [s]", "mass11.y [px]", "energy.residual [kg px^2/s^2]", "joint3.angle [deg]"]
    simulation = sim.Simulation(sim.load_scene("tutorial-3.3"))
    simulation.track_energy(True)
    simulation.step(100)
    row = [simulation.time, simulation.positions[11, 1], simulation.energy().residual, simulation.angles[3]]
    assert [float(value) for value in rows[-1]] == row
    assert len(rows) == 4
    refused(softrod(*words, "--record", "joint99.angle"), "joint 99 does not exist (0..9)")


def test_run_records_formulas_and_refuses_them_before_it_computes(tmp_path: Path, softrod: Softrod) -> None:
    out = tmp_path / "swing.csv"
    words = ("run", "tutorial-3.3", "--steps", "50", "--every", "50", "--out", out)
    asked = ("--record", "energy.residual / mass1.mass", "--record=-mass11.y", "--record", "body[0..3].vy")
    assert softrod(*words, *asked).returncode == 0
    header, row = rows_of(out)
    assert header == [
        "time [s]", "energy.residual / mass1.mass [px^2/s^2]", "'-mass11.y [px]", "body[0..3].vy [px/s]",
    ]  # fmt: skip
    simulation = sim.Simulation(sim.load_scene("tutorial-3.3"))
    simulation.track_energy(True)  # from the start
    simulation.step(50)
    assert float(row[1]) == simulation.energy().residual / simulation.scene.masses[1].mass != 0.0
    assert float(row[2]) == -simulation.positions[11, 1]
    refused(
        softrod(*words, "--record", "mass1.x + mass1.vx"), "'mass1.x' (px) and 'mass1.vx' (px/s) cannot be"
    )


def test_a_run_says_where_its_method_softens_springs(tmp_path: Path, softrod: Softrod) -> None:
    words = ("run", "rope", "--steps", 2, "--out", tmp_path / "a.csv", "--set", "method=stable_spring")
    soft = softrod(*words, "--set", "dt=0.0166")
    assert soft.returncode == 0
    assert (
        "the method Stable spring makes springs up to 22 times as soft at a time step of 0.0166 s"
        in soft.stderr
    )
    assert "soft" not in softrod(*words, "--set", "dt=0.0001").stderr
