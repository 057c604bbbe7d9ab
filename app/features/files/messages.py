"""Messages about links."""

from __future__ import annotations

from typing import Annotated, Literal

from msgspec import Meta

from ...wire.messages import Ask, Event


class Share(Ask, frozen=True):
    """A link to the scene, with the present pose or without.

    Attributes:
        page: the page's own address, without what stands after its folder.
        short: whether as an address whose scene the server stores, instead of a link that holds the scene.
        controls: which there are for whoever opens it: as they are anyway, the bar of time alone, or that and
            the sliders that make most of the scene.
    """

    pose: bool
    page: Annotated[
        str, Meta(pattern=r"^https?://[A-Za-z0-9._\[\]:-]{1,250}/([A-Za-z0-9._~-]{1,80}/){0,20}$")
    ]
    short: bool = False
    controls: Literal["all", "play", "sliders"] = "all"


class Link(Event, frozen=True, kw_only=True):
    """A link to the scene.

    Attributes:
        qr: a picture of its QR code, as an address; empty if it is too long for one.
        problem: why there is none.
    """

    link: str = ""
    qr: str = ""
    problem: str = ""
