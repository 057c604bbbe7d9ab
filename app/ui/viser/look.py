"""What viser's messages lack of a control: its unit, its bounds, the law of its slider, its place."""

from __future__ import annotations

from typing import Any

from ...viser_inside import element_id
from ...wire.carrier import Mail
from ...wire.to_page import ControlLook


def describe_control(mail: Mail, handle: Any, **look: Any) -> None:
    """Tell the page's script how a control looks.

    Args:
        mail: of the page.
        handle: viser's handle of the control.
        look: the attributes of `ControlLook`.
    """
    mail.send(ControlLook(id=element_id(handle), **look))
