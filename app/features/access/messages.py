"""Messages about how somebody uses the page."""

from __future__ import annotations

from ...wire.messages import OwnBody


class Still(OwnBody, frozen=True):
    """Whether less motion is wished: a body that is opened then stands until it is played."""

    on: bool
