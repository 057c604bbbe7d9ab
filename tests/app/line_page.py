"""A page of a class, without a browser, as its script speaks to the server."""

from __future__ import annotations

import secrets
import socket
import ssl
import threading
from typing import Any

import msgspec
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect
from websockets.typing import Origin

from app.wire.carrier import Letter
from app.wire.line import unbatched
from tests.app.hostile import PATIENCE, eventually


class LinePage:
    """A connection, and what the server has sent by it.

    Args:
        port: of the server.
        query: of the page's address.
        host: by whose name and port it is reached.
        name: of the page.
        folder: of the server.
        tls: with it, the connection is by TLS.

    Attributes:
        letters: all of them.
        signs: how many signs of life.
    """

    def __init__(
        self,
        port: int,
        query: str,
        host: str = "",
        name: str = "",
        folder: str = "/",
        tls: ssl.SSLContext | None = None,
    ) -> None:
        host = host or f"127.0.0.1:{port}"
        self.letters: list[Letter] = []
        self.signs = 0
        scheme = "ws" if tls is None else "wss"
        self.socket = connect(
            f"{scheme}://{host}{folder}line/{name or secrets.token_hex(16)}?{query}",
            sock=socket.create_connection(("127.0.0.1", port)),
            origin=Origin(f"{scheme.replace('ws', 'http')}://{host}"),
            compression=None,
            max_size=None,
            open_timeout=60.0,  # a machine may be busy
            ssl=tls,
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        try:
            for data in self.socket:
                assert isinstance(data, bytes)
                self.letters += unbatched(data)
                self.signs += not data
        except (ConnectionClosed, OSError):
            pass

    def begin(self) -> LinePage:
        """Wait until it is there."""
        assert eventually(lambda: self.told("pageState"))
        return self

    def say(self, *texts: str | bytes) -> None:
        """Say something."""
        for text in texts:
            self.socket.send(text)

    def told(self, tell: str) -> list[dict[str, Any]]:
        """All of a kind that it was told."""
        texts = [letter.text for letter in list(self.letters)]
        return [msgspec.json.decode(text) for text in texts if text.startswith(f'{{"tell":"{tell}"')]

    def is_cut(self) -> bool:
        """Whether the connection comes to its end."""
        self._reader.join(PATIENCE)
        return not self._reader.is_alive()

    def close(self) -> None:
        """Leave."""
        self.socket.close()
