"""The role of a page in a class, by its address: ``?room=ABCD`` and ``&as=desk`` or ``&as=wall``."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sim
from app.classroom.live import Class, Classes
from sim.errors import SettingError

from ...gate.address import page_query
from ...gate.gate import Visit
from ...wire.carrier import Mail
from ...words import say
from .desk import DeskRole
from .role import Entrance, Role
from .seat import SeatRole
from .wall import WallRole

TEACHER = "#teacher="
"""Before a class's secret in the address of a teacher's page; browsers do not send what follows a #."""


def desk_address(base: str, classroom: Class) -> str:
    """Return the address of a teacher's page.

    Args:
        base: of the server's page, with a slash at its end.
    """
    return f"{base}?room={classroom.room.code}&as=desk{TEACHER}{classroom.room.key}"


def wall_address(base: str, code: str) -> str:
    """Return the address of the window for a projector; `base` as for `desk_address`."""
    return f"{base}?room={code}&as=wall"


def seat_address(base: str, code: str) -> str:
    """Return the address by which a pupil comes in; `base` as for `desk_address`."""
    return f"{base}?room={code}"


def class_of_query(query: str, classes: Classes) -> Class | None:
    """Return the running class that the query of a page's address names."""
    return classes.find((page_query(query) or {}).get("room", "").upper())


def is_class_page(query: str, classes: Classes, owned: bool) -> bool:
    """Whether a page is a pupil's, a wall's, or of somebody who has named no class; else it is viser's.

    Args:
        query: of the page's address.
        classes: of the server.
        owned: it is known to be the page of this computer's owner, who comes to no class by chance.
    """
    fields = page_query(query) or {}
    code = fields.get("room", "")
    if not code:
        return classes.alone and not owned
    return fields.get("as") != "desk" or classes.find(code.upper()) is None


def desk_of_query(
    visit: Visit,
    mail: Mail,
    classes: Classes,
    base: str,
    download: Callable[[str, bytes], None],
    networks: Sequence[str] = (),
) -> Role | None:
    """Return the role of a page of viser's on a server that has classes; None for an ordinary page.

    Args:
        visit: of the page.
        mail: to the page's script.
        classes: of the server.
        base: the address by which others reach the server, with a slash at its end.
        download: has the page's browser save a file of that name.
        networks: addresses of the server in several networks, of which the teacher may choose one.
    """
    if is_class_page(visit.query, classes, visit.is_local):
        return Entrance(mail, "")  # its own script would not have connected here
    classroom = class_of_query(visit.query, classes)
    if classroom is None:
        return None
    return DeskRole(classroom, mail, base, download, networks)


def role_of_query(visit: Visit, mail: Mail, classes: Classes, base: str) -> Role:
    """Return the role of a page of a class; arguments as of `desk_of_query`."""
    fields = page_query(visit.query) or {}
    code = fields.get("room", "").upper()
    classroom = classes.find(code)
    if classroom is None:
        return Entrance(mail, say("class-refuse-code", code=code) if code else "")
    if fields.get("as", "") == "wall":
        return WallRole(classroom, mail, base)
    return SeatRole(classroom, mail, visit.visitor)


def first_scene(classroom: Class) -> sim.Scene | None:
    """Return what a page of the class shows first; None if the class's present step cannot begin."""
    try:
        return classroom.scene(classroom.room.at)
    except SettingError:
        return None
