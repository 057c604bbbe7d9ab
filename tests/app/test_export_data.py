"""Bodies as data: the numbers of JSON and of tables are the scene's."""

from __future__ import annotations

import csv
import io
import json
import zipfile

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace as changed

import sim
from app.export.body.body import Body
from app.export.body.data import body_csv, body_json
from app.export.body.program import c_program, python_program
from app.export.live.program import javascript_program
from tests.app.exported import CLOSE, DAMPED, EULER, LOADED, LOOSE, MUSCULAR, ONE_SIDED_GIRDER, STEPS, body_of


def test_motors_and_rails_are_in_json_and_tables_as_in_the_scene() -> None:
    buggy, cart = sim.load_scene("buggy"), sim.load_scene("cart")
    motors = [motor for motor in json.loads(body_json(body_of(buggy)))["joints"]["motor"] if motor]
    assert [motor["keys"] for motor in motors] == ["left-right", "left-right"]
    turned = [row for row in tables(buggy)["joints"] if row["motor_speed [deg/s]"]]
    assert {(row["motor_speed [deg/s]"], row["motor_keys"]) for row in turned} == {("600.0", "left-right")}
    assert json.loads(body_json(body_of(cart)))["masses"]["rail"] == [[1.0, 0.0], [0.0, 0.0]]
    rails = [(row["rail_x"], row["rail_y"]) for row in tables(cart)["masses"]]
    assert rails == [("1.0", "0.0"), ("0.0", "0.0")]


def test_belts_are_in_tables_also_beside_walls_at_rest() -> None:
    walls = (LOOSE.walls[0], changed(LOOSE.walls[0], speed=40.0))
    rows = tables(changed(LOOSE, walls=walls))["walls"]
    assert [row["speed [px/s]"] for row in rows] == ["", "40.0"]


def test_how_bodies_bounce_is_in_json() -> None:
    scene = sim.load_scene("jelly")
    walls = tuple(changed(wall, restitution="constant") for wall in scene.walls)
    data = json.loads(body_json(body_of(changed(scene, walls=walls))))
    assert {wall["restitution"] for wall in data["walls"]} == {"constant"}


def test_a_medium_and_the_ground_are_in_json_and_tables_as_in_the_scene() -> None:
    resisted = changed(sim.load_scene("rope"), medium=sim.Medium(), ground=sim.Ground())
    data = json.loads(body_json(body_of(resisted)))
    assert data["medium"] == {"across": 1.0, "along": 0.5}
    assert data["ground"]["sideways"] == 0.4
    settings = {row["setting"]: row["value"] for row in tables(resisted)["settings"]}
    assert settings["medium_across [kg/(px s)]"] == "1.0"
    assert settings["ground_slip_speed [px/s]"] == "10.0"


def test_a_scene_can_be_made_of_the_json() -> None:
    simulation = sim.Simulation(changed(sim.load_scene("tutorial-3.2"), integrator=EULER))
    simulation.step(100)
    data = json.loads(body_json(Body.of(simulation.capture())))
    masses, springs, joints = data["masses"], data["springs"], data["joints"]

    def rows(columns: dict[str, list]) -> list[dict]:
        return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]

    for name in ("position", "velocity"):
        masses[name] = [tuple(pair) for pair in masses[name]]
    made = sim.Scene(
        name="made",
        masses=tuple(sim.Mass(**row) for row in rows(masses)),
        linear_springs=tuple(sim.LinearSpring(**row) for row in rows(springs)),
        angular_springs=tuple(sim.AngularSpring(**row) for row in rows(joints)),
        anchors=tuple(sim.Anchor(**anchor) for anchor in data["anchors"]),
        gravity=tuple(data["gravity"]),
        air_friction=data["air_friction"],
        air_law=data["air_law"],
        force_law=data["force_law"],
        integrator=sim.Integrator(method=data["method"], dt=data["time_step"]),
    )
    other = sim.Simulation(made)
    assert (other.positions == simulation.positions).all()
    simulation.step(STEPS)
    other.step(STEPS)
    assert other.positions == pytest.approx(simulation.positions, abs=CLOSE, rel=0.0)


def test_muscles_are_in_json_and_tables_as_in_the_scene() -> None:
    data = json.loads(body_json(body_of(MUSCULAR)))
    assert msgspec.convert(data["beat"], sim.Beat) == MUSCULAR.beat
    for name, parts in (
        ("springs", MUSCULAR.linear_springs),
        ("joints", MUSCULAR.angular_springs),
    ):
        muscles = [part.muscle or None for part in parts]
        assert data[name]["muscle"] == [muscle and msgspec.to_builtins(muscle) for muscle in muscles]
        assert None in muscles
        assert any(muscles)
        rows = tables(MUSCULAR)[name]
        amplitude = {"springs": "muscle_amplitude", "joints": "muscle_angle [deg]"}[name]
        for muscle, row in zip(muscles, rows, strict=True):
            wanted = muscle and (muscle.amplitude, muscle.phase, muscle.wave, muscle.per_beat)
            columns = amplitude, "muscle_phase [deg]", "muscle_wave", "muscle_waves_per_beat"
            a, phase, wave, per_beat = (row[column] for column in columns)
            assert wanted == (muscle and (float(a), float(phase), wave, int(per_beat)))
    settings = {row["setting"]: row["value"] for row in tables(MUSCULAR)["settings"]}
    assert float(settings["beat_frequency [Hz]"]) == MUSCULAR.beat.frequency  # type: ignore[union-attr]
    plain = body_of(DAMPED)
    assert b"muscle" not in body_json(plain)
    assert "beat_frequency [Hz]" not in {row["setting"] for row in tables(DAMPED)["settings"]}
    for write in (python_program, c_program):
        assert b"uscle" not in write(plain)[0]
    assert '"muscles": null' in javascript_program(plain.moment)[0].decode()


def test_the_sides_of_parts_are_in_json_and_tables_as_in_the_scene() -> None:
    scene = ONE_SIDED_GIRDER
    data, rows = json.loads(body_json(body_of(scene))), tables(scene)
    for name, parts in (("springs", scene.linear_springs), ("joints", scene.angular_springs)):
        sides = [part.only or None for part in parts]
        assert len(set(sides)) == 3
        assert data[name]["only"] == sides
        assert [row["only"] or None for row in rows[name]] == sides
    assert b"only" not in body_json(body_of(DAMPED))


def test_json_has_all_that_a_scene_has_with_units() -> None:
    pile = json.loads(body_json(body_of(sim.load_scene("pile"))))
    assert len(pile["walls"]) == 3
    assert pile["contact"]["distance"] == sim.load_scene("pile").contact.distance  # type: ignore[union-attr]
    assert {filling["kind"] for filling in pile["fillings"]} <= {"gas", "liquid"}
    assert all(filling["area"] > 0.0 for filling in pile["fillings"])
    flag = json.loads(body_json(body_of(sim.load_scene("flag-pole"))))
    assert flag["wind"]["turbulence"] == 0.9
    assert "contact" not in flag
    girder = json.loads(body_json(body_of(sim.load_scene("girder"))))
    assert girder["springs"]["strength"] == [s.strength for s in sim.load_scene("girder").linear_springs]
    assert pile["units"]["velocity"] == "px/s"
    loaded = json.loads(body_json(body_of(LOADED)))
    assert loaded["masses"]["force"][1:3] == [[0.0, 0.0], [600.0, -4000.0]]
    assert loaded["units"]["force"] == "kg px/s^2"
    assert "force" not in pile["masses"]
    metres = changed(LOOSE, view=sim.View(unit="m"))
    assert json.loads(body_json(body_of(metres)))["units"]["gravity"] == "m/s^2"


def tables(scene: sim.Scene) -> dict[str, list[dict[str, str]]]:
    archive = zipfile.ZipFile(io.BytesIO(body_csv(body_of(scene))))
    assert archive.testzip() is None
    return {
        name.removesuffix(".csv"): list(csv.DictReader(io.StringIO(archive.read(name).decode())))
        for name in archive.namelist()
    }


def test_tables_have_every_number_with_its_unit() -> None:
    scene = sim.load_scene("air-balloon")
    found = tables(scene)
    assert set(found) == {"masses", "springs", "joints", "settings", "walls", "fillings"}
    body = body_of(scene)
    assert [float(row["x [px]"]) for row in found["masses"]] == body.positions[:, 0].tolist()
    assert [float(row["rest_length [px]"]) for row in found["springs"]] == body.rest_length.tolist()
    assert [int(row["b"]) for row in found["springs"]] == body.ends[:, 1].tolist()
    assert [float(row["stiffness [kg/s^2]"]) for row in found["joints"]] == body.joint_stiffness.tolist()
    assert [float(row["rest_angle [deg]"]) for row in found["joints"]] == body.rest_angle.tolist()
    settings = {row["setting"]: row["value"] for row in found["settings"]}
    assert float(settings["gravity_y [px/s^2]"]) == scene.gravity[1]
    assert settings["force_law"] == scene.force_law
    assert float(found["walls"][0]["hardness [1/(px s^2)]"]) == scene.walls[0].hardness
    assert found["fillings"][0]["masses"].split() == [str(m) for m in body.loops[0].masses]
    circles = tables(sim.load_scene("lesson-resonance"))["masses"]
    assert circles[0]["circle_radius [px]"] == "5.0"
    assert circles[1]["circle_radius [px]"] == ""
    assert "force_x [kg px/s^2]" not in circles[0]
    forces = [(row["force_x [kg px/s^2]"], row["force_y [kg px/s^2]"]) for row in tables(LOADED)["masses"]]
    assert forces[1:3] == [("0.0", "0.0"), ("600.0", "-4000.0")]
    contact = {row["setting"]: row["value"] for row in tables(sim.load_scene("pile"))["settings"]}
    assert float(contact["contact_distance [px]"]) > 0.0
    assert body_csv(body) == body_csv(body_of(scene))


def test_tables_have_decimal_commas_if_they_are_to() -> None:
    body = body_of(sim.load_scene("air-balloon"))
    with_commas = zipfile.ZipFile(io.BytesIO(body_csv(body, decimal_comma=True)))
    for name in (plain := zipfile.ZipFile(io.BytesIO(body_csv(body)))).namelist():
        head, *rows = csv.reader(io.StringIO(plain.read(name).decode()))
        found = list(csv.reader(io.StringIO(with_commas.read(name).decode()), delimiter=";"))
        assert found[0] == head
        for row, other in zip(rows, found[1:], strict=True):
            numbers = [cell.replace(".", ",") if cell[-1:].isdigit() else cell for cell in row]
            assert [*map(str.strip, other)] == numbers


def test_numpy_reads_a_table() -> None:
    archive = zipfile.ZipFile(io.BytesIO(body_csv(body_of(sim.load_scene("girder")))))
    for name, count in (("masses", 17), ("springs", 31)):
        table = np.genfromtxt(io.StringIO(archive.read(f"{name}.csv").decode()), delimiter=",", names=True)
        assert table.shape == (count,)
        assert table.dtype.names is not None
        assert all(np.isfinite(table[column]).all() for column in table.dtype.names)


@pytest.mark.parametrize("text", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1", "=HYPERLINK(A1)"])
def test_no_text_is_a_formula_in_a_table(text: str) -> None:
    scene = changed(LOOSE, name=text, title=text, view=sim.View(unit=text[:8]))
    archive = zipfile.ZipFile(io.BytesIO(body_csv(body_of(scene))))
    for name in archive.namelist():
        for row in csv.reader(io.StringIO(archive.read(name).decode())):
            for cell in row:
                is_number = cell.replace(".", "").replace("-", "").isdigit()
                assert is_number or not cell.startswith(("=", "+", "-", "@", "\t"))


def test_keys_of_forces_and_muscles_are_in_json_and_tables() -> None:
    hopper = sim.load_scene("hopper")
    masses = json.loads(body_json(body_of(hopper)))["masses"]
    assert [(tuple(f), k) for f, k in zip(masses["force"], masses["keys"], strict=True) if k] == [
        (mass.force, mass.keys) for mass in hopper.masses if mass.keys
    ]
    for name, parts in (("springs", hopper.linear_springs), ("joints", hopper.angular_springs)):
        if any(part.muscle for part in parts):
            told = [row["muscle_keys"] for row in tables(hopper)[name]]
            assert told == [(part.muscle and part.muscle.keys) or "" for part in parts]
    assert "muscle_keys" not in tables(MUSCULAR)["springs"][0]
