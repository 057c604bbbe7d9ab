"""Tables of what was measured, as programs write them, and which quantities their columns are."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from sim.design.grid import MAX_ROWS
from sim.design.matching import guesses, matched
from sim.design.measurements import MAX_BYTES, parse_measurements
from tests.amount import examples
from tests.sim.measured import spring_pendulum, swing
from tests.sim.written_tables import TABLES, Written

NAN = float("nan")


def runs(text: str | bytes) -> tuple[sim.Measurement, ...]:
    return parse_measurements(text if isinstance(text, bytes) else text.encode(), "a.csv")


def table(text: str | bytes) -> sim.Measurement:
    (found,) = runs(text)
    return found


@pytest.mark.parametrize("written", [pytest.param(each, id=each.by) for each in TABLES])
def test_a_table_is_read_right_or_refused_with_the_place(written: Written) -> None:
    if written.refused:
        with pytest.raises(sim.InputError) as said:
            runs(written.file)
        assert re.sub(r"^a\.csv(: |, )", "", str(said.value)) == written.refused
        return
    found = runs(written.file)
    assert len(found) == len(written.runs)
    for each, (time, columns) in zip(found, written.runs, strict=True):
        assert each.time == pytest.approx(time, rel=1e-15)
        assert [f"{c.name} [{c.unit}]" if c.unit else c.name for c in each.columns] == [*columns]
        for column, values in zip(each.columns, columns.values(), strict=True):
            assert column.values == pytest.approx(values, nan_ok=True)
        assert len(each.remarks) == written.remarks


@pytest.mark.parametrize(
    ("text", "columns", "match"),
    [
        pytest.param(
            "mass A\t\t\nt\tx\ty\n0,000E0\t1,234E-1\t-2,000E-2\n3,333E-2\t1,300E-1\t\n",
            {"mass A x": ("", [0.1234, 0.13]), "mass A y": ("", [-0.02, NAN])},
            {"mass A x": "mass1.x", "mass A y": "-mass1.y"},
            id="Tracker",
        ),
        pytest.param(
            '"Time (s)","Acceleration x (m/s^2)","Absolute (m/s^2)"\n0.0,1.0E-1,9.8\n3.333E-2,2.0E-1,9.7\n',
            {"Acceleration x": ("m/s^2", [0.1, 0.2]), "Absolute": ("m/s^2", [9.8, 9.7])},
            {"Acceleration x": "mass1.ax", "Absolute": ""},
            id="phyphox",
        ),
        pytest.param(
            '"Time (s)";"Linear Acceleration y (m/s^2)"\r\n0,0E0;1,0E-1\r\n3,333E-2;2,0E-1\r\n',
            {"Linear Acceleration y": ("m/s^2", [0.1, 0.2])},
            {"Linear Acceleration y": "-mass1.ay"},
            id="phyphox with decimal commas",
        ),
        pytest.param(
            "step,time,x0,y0,x1,y1\n1,0,1,2,3,4\n2,0.03333,1,2,5,6\n",
            {"x1": ("", [3.0, 5.0]), "y1": ("", [4.0, 6.0])},
            {"step": "", "x0": "", "y0": "", "x1": "mass1.x", "y1": "mass1.y"},
            id="places of softrod run",
        ),
        pytest.param(
            "# by hand\nZeit / s;Höhe / cm;Winkel / °\n0,0;1,5;30\n% later\n\n0,03333;1,6;\n".encode(
                "cp1252"
            ),
            {"Höhe": ("cm", [1.5, 1.6]), "Winkel": ("°", [30.0, NAN])},
            {"Höhe": "-mass1.y", "Winkel": "90 - spring0.direction"},
            id="a spreadsheet",
        ),
        pytest.param(
            "t;x;y\nms;cm;cm\n0;1;2\n33,33;2;3\n",
            {"x": ("cm", [1.0, 2.0]), "y": ("cm", [2.0, 3.0])},
            {"x": "mass1.x", "y": "-mass1.y"},
            id="a line of units",
        ),
        pytest.param(
            "time\tx [cm]\n0\t1\n0.03333\t2\n".encode("utf-16"),
            {"x": ("cm", [1.0, 2.0])},
            {"x": "mass1.x"},
            id="UTF-16",
        ),
        pytest.param(
            "% time and place\n0.0   1.0\n0.03333   2.0\n",
            {"column 2": ("", [1.0, 2.0])},
            {"column 2": ""},
            id="spaces",
        ),
    ],
)
def test_tables_are_read_as_programs_write_them(
    text: str | bytes, columns: dict[str, tuple[str, list[float]]], match: dict[str, str]
) -> None:
    found = table(text)
    assert found.time == pytest.approx([0.0, 0.03333])
    for name, (unit, values) in columns.items():
        assert found.column(name).unit == unit
        assert found.column(name).values == pytest.approx(values, nan_ok=True)
    assert guesses(found, spring_pendulum()) == match


@pytest.mark.parametrize("comma", [False, True])
def test_softrods_own_table_comes_back_bit_for_bit(comma: bool, tmp_path: Path) -> None:
    names = ("mass1.x", "mass1.vy", "spring0.force", "spring0.direction", "mass1.ay")
    recording = sim.Simulation(spring_pendulum()).record(0.5, *names)
    recording.to_csv(tmp_path / "own.csv", comma)
    (found,) = sim.read_measurements(tmp_path / "own.csv")
    assert (found.time == recording.time).all()
    assert [match.quantity.name for match in matched(found, spring_pendulum())] == list(names)
    for match in matched(found, spring_pendulum()):
        assert (match.column.values == recording[match.quantity.name]).all()
        assert (match.sign, match.offset, match.scale, match.unit.factor) == (1.0, 0.0, 1.0, 1.0)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("t,x\n0,1\n1,oops\n", r"a\.csv, line 3, column 'x': 'oops' is not a finite number"),
        ("t,x\n0,1\n1,-Infinity\n", r"a\.csv, line 3, column 'x': '-Infinity' is not a finite number"),
        ("t,x\n0,1\n1,1e999\n", r"a\.csv, line 3, column 'x': '1e999' is not a finite number"),
        ("t,x\n0,1\n2,2\n1,3\n", r"a\.csv, line 4, column 't': the time 1 s does not come after 2 s"),
        ("t,x\n0,1\n1,2\n1,3\n", r"a\.csv, line 4, column 't': the time 1 s does not come after 1 s"),
        ("hello\nworld\n", r"a\.csv: no line of it has a time and a number"),
        ("", r"a\.csv: no line of it has a time and a number"),
        (b"\x00\x01\x02", r"a\.csv: it is not a text"),
        (b"0,1\n" * (MAX_ROWS + 1), r"a\.csv: it has 20001 rows, more than 20000"),
        (b"1," * 300, r"a\.csv: it has 301 columns, more than 200"),
        (b" " * (MAX_BYTES + 1), r"a\.csv: it is larger than 5 MB"),
    ],
)
def test_what_is_no_table_is_refused_in_a_sentence_that_names_the_place(text: str | bytes, said: str) -> None:
    with pytest.raises(sim.InputError, match=said):
        table(text)


@settings(max_examples=examples(400), deadline=None)
@given(
    st.one_of(
        st.binary(max_size=200), st.text("0123456789.,;\t \n\"e-tx()[]/°'nan", max_size=120).map(str.encode)
    )
)
def test_whatever_a_file_is_it_is_read_as_finite_numbers_or_refused(data: bytes) -> None:
    try:
        several = runs(data)
    except sim.InputError as error:
        assert str(error).isprintable()
        return
    for found in several:
        assert np.isfinite(found.time).all()
        assert (np.diff(found.time) > 0.0).all()
        for column in found.columns:
            assert column.values.shape == found.time.shape
            assert not np.isinf(column.values).any()


def test_units_are_those_of_the_quantity() -> None:
    found = table("t,x (cm),F (N),w (rad),other (cm)\n0,1,2,3,4\n1,2,3,4,5\n")
    match = {"x": "mass1.x", "F": "spring0.force", "w": "spring0.direction"}
    by_name = {each.column.name: each for each in matched(found, swing(), match)}
    assert by_name["x"].scale is None  # a scene in px does not say what a metre is
    assert by_name["w"].unit.factor == pytest.approx(57.29578)
    for column, text, said in (
        ("F", "mass1.x", "column 'F': 'N' is not a unit of it, as m is"),
        ("x", "mass0.x", "column 'x': mass 0 is held, so that it tells nothing"),
        ("x", "mass7.x", "column 'x': mass7.x: mass 7 does not exist"),
        ("x", "sideways", "column 'x': 'sideways' is not a quantity"),
        ("z", "mass1.x", "there is no column 'z'; there are x, F, w, other"),
    ):
        with pytest.raises(sim.InputError, match=said):
            matched(found, swing(), {column: text})
    with pytest.raises(sim.InputError, match="say which quantity each column is"):
        matched(found, swing(), {})
