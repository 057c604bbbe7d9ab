"""What the server sends to the page's script beside the body."""

from __future__ import annotations

import itertools
from typing import Any

import msgspec
import numpy as np
import viser

MAIL = "/softrod/mail/"
"""Beginning of the names of the nodes that carry it; the rest is the kind."""


class Mail:
    """Sends JSON to one page's script; any thread may send.

    Of two letters of one kind that follow each other within a frame only the second arrives: what must not be
    lost has a kind of its own.
    """

    def __init__(self, client: viser.ClientHandle) -> None:
        self._client = client
        self._nodes: dict[str, Any] = {}
        self._numbers = itertools.count(1)

    def send(self, kind: str, **content: Any) -> None:
        """Send a letter of a kind."""
        # The number has two equal letters differ: viser would drop the second.
        data = msgspec.json.encode({"number": next(self._numbers), **content})
        with self._client.atomic():
            if kind not in self._nodes:
                self._nodes[kind] = self._client.scene.add_point_cloud(
                    MAIL + kind, np.zeros((1, 3)), (0, 0, 0), precision="float32", visible=False
                )
            self._nodes[kind].colors = np.frombuffer(data, np.uint8)
