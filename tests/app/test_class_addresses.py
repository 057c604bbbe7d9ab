"""The addresses of a class: what the terminal names, and what the QR codes do."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import pytest
from rich.console import Console
from websockets.exceptions import InvalidStatus

import sim
from app.classroom.live import Classes
from app.gate import address, gate
from app.gate.gate import GatedServer
from app.server import serve as serve_module
from app.server.serve import serving
from tests.app.hostile import HostilePage, eventually
from tests.app.line_page import LinePage

NAMES = {"127.0.0.1": "lo", "192.168.1.7": "wlan0", "10.42.0.1": "ap0", "172.17.0.1": "docker0"}


@pytest.fixture
def classes(class_folder: Path) -> Classes:
    made = Classes()
    made.begin((sim.rope(),))
    return made


@pytest.fixture
def server(classes: Classes) -> Iterator[GatedServer]:
    with serving(sim.rope(), "127.0.0.1", 0, allow_hosts=("laptop.local",), classes=classes) as (made, *_):
        yield made


@pytest.mark.parametrize("name", ["127.0.0.1", "laptop.local"])
def test_the_wall_names_the_address_that_it_was_opened_at(
    server: GatedServer, classes: Classes, name: str
) -> None:
    (classroom,), port = classes, server.get_port()
    host = f"{name}:{port}"
    page = LinePage(port, f"room={classroom.room.code}&as=wall", host)
    assert eventually(lambda: page.told("wall"))[0]["address"] == f"http://{host}/"
    page.close()


def test_a_page_that_only_tries_gets_pictures_whatever_the_class_looks_at(
    server: GatedServer, classes: Classes
) -> None:
    (classroom,) = classes
    device = LinePage(server.get_port(), f"as=check&room={classroom.room.code}")
    assert eventually(lambda: len(device.told("frame")) >= 5)
    device.say("")
    assert eventually(lambda: device.signs)
    device.say('{"do":"checked","trip":23,"rate":58,"works":true,"doubts":false}')
    eventually(lambda: classroom.checks)
    device.close()
    assert [(one.trip, one.rate, one.works) for one in classroom.checks] == [(23, 58, True)]
    assert not classroom.room.seats


def test_the_terminal_names_the_networks_that_pupils_may_be_in(
    classes: Classes, server: GatedServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (address, serve_module):
        monkeypatch.setattr(module, "interfaces", lambda: NAMES)
    monkeypatch.setattr(address, "local_addresses", lambda: ["192.168.1.7", "10.42.0.1", "172.17.0.1"])
    shown: list[str] = []
    monkeypatch.setattr(serve_module, "print_qr_code", shown.append)
    (classroom,), port, text = classes, server.get_port(), io.StringIO()
    serve_module.print_class_addresses(server, "0.0.0.0", None, classes, Console(file=text, width=500))
    said = text.getvalue()
    base = f"http://192.168.1.7:{port}/"
    assert shown == [f"{base}?room={classroom.room.code}"]
    assert f"your phone: {base}check?room={classroom.room.code}\n" in said
    assert f"in other networks, too, as http://10.42.0.1:{port} (ap0). " in said
    assert "docker0" not in said
    assert "not encrypted" in said
    # The teacher's secret is said once, and goes into no QR code.
    assert said.count(classroom.room.key) == 1


def test_each_further_class_makes_room_for_its_pages(
    classes: Classes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gate, "MAX_TABS", 1)
    monkeypatch.setattr(serve_module, "PAGES_OF_CLASS", 1)
    classes.begin((sim.rope(),))
    with serving(sim.rope(), "127.0.0.1", 0, classes=classes) as (made, *_):
        pages = [HostilePage(made.get_port()) for _ in range(2)]
        with pytest.raises(InvalidStatus, match="503"):
            HostilePage(made.get_port())
        for page in pages:
            page.close()
