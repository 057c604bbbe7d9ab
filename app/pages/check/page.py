"""The page that checks whether a device can take part: small, and without any of viser's scripts."""

from __future__ import annotations

from pathlib import Path

from ...gate.gate import CHECK
from ...stage.looks import BY_SYSTEM, style_rules


def check_address(base: str, code: str) -> str:
    """The address of the page, for a class.

    Args:
        base: of the server's page, with a slash at its end.
        code: the class's.
    """
    return f"{base}{CHECK[1:]}?room={code}"


def check_page(folder: str) -> str:
    """The page's text.

    Args:
        folder: where the page's scripts are, with a slash at its end.
    """
    text = (Path(__file__).parent / "check.html").read_text(encoding="utf-8")
    return text.replace("{looks}", style_rules(BY_SYSTEM)).replace("{folder}", folder)
