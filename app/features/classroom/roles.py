"""The role of a page in a class, by its address: ``?room=ABCD`` and ``&as=desk`` or ``&as=wall``."""

from __future__ import annotations

from collections.abc import Callable

import sim
from app.classroom.live import Class, Classes
from sim.errors import SettingError

from ...gate.address import page_query
from ...wire.carrier import Mail
from ..files.sharing import qr_code
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


def role_of_query(
    query: str,
    mail: Mail,
    classes: Classes,
    base: str,
    owned: bool,
    visitor: str,
    download: Callable[[str, bytes], None],
) -> Role | None:
    """Return the role of a page on a server that has classes; None for an ordinary page.

    Args:
        query: of the page's address.
        mail: to the page's script.
        base: the address by which others reach the server, with a slash at its end.
        owned: whether it is known to be the page of this computer's owner, who comes to no class by chance.
        visitor: whose page it is; see `SeatRole`.
        download: has the page's browser save a file of that name.
    """
    fields = page_query(query) or {}
    code = fields.get("room", "").upper()
    classroom = classes.find(code)
    if classroom is None:
        if code:
            return Entrance(mail, f"There is no class {code} here now.")
        return None if owned or not classes.alone else Entrance(mail, "")
    kind = fields.get("as", "")
    if kind not in ("desk", "wall"):
        return SeatRole(classroom, mail, visitor)
    qr = qr_code(seat_address(base, code))
    if kind == "wall":
        return WallRole(classroom, mail, base, qr)
    return DeskRole(classroom, mail, base, qr, download)


def first_scene(classroom: Class) -> sim.Scene | None:
    """Return what a page of the class shows first; None if the class's present step cannot begin."""
    try:
        return classroom.scene(classroom.room.at)
    except SettingError:
        return None
