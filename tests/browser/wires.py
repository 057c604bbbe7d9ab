"""What may stand between a page and its server: a wire that can die, and a proxy that speaks TLS."""

from __future__ import annotations

import contextlib
import select
import socket
import ssl
import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

CHUNK = 65536

FORBIDDEN = b"HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"
"""What a web filter answers to what it does not let through."""


class Wire:
    """Leads TCP connections on to a server.

    Args:
        port: the server's, on this machine.
        tls: with it, the wire's own end speaks TLS.
        folder: with it, HTTP requests have this path in front, which is taken away.

    Attributes:
        to: the server's port; connections that begin later go there.
        port: where the wire begins.
        mute: nothing is led on, and neither end is told. What was swallowed does not come back: connections
            of that time stay mute, as where a router has forgotten them.
        held: nothing is led on for now; it comes late, as after a stall of the network.
        upgrades: what becomes of WebSockets: they are "led" on, "refused" as by a web filter, or "swallowed".
    """

    def __init__(self, port: int, tls: ssl.SSLContext | None = None, folder: str = "/") -> None:
        self.mute = self.held = False
        self.upgrades: Literal["led", "refused", "swallowed"] = "led"
        self.to, self._tls, self._folder = port, tls, folder.encode()
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listener.getsockname()[1]
        self._ends: list[socket.socket] = []
        threading.Thread(target=self._accept, daemon=True).start()

    @property
    def open(self) -> int:
        """Connections that are led on now."""
        return sum(end.fileno() != -1 for end in self._ends) // 2

    def close(self) -> None:
        """Cut everything."""
        for end in (self._listener, *self._ends):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            while True:
                end, _ = self._listener.accept()
                threading.Thread(target=self._lead, args=(end,), daemon=True).start()

    def _lead(self, here: socket.socket) -> None:
        with contextlib.suppress(OSError, ValueError):
            if self._tls is not None:
                here = self._tls.wrap_socket(here, server_side=True)
            there = socket.create_connection(("127.0.0.1", self.to))
            self._ends += (here, there)
            first = True
            forgotten = False
            with here, there:
                while True:
                    waiting = isinstance(here, ssl.SSLSocket) and here.pending()
                    ready = [here] if waiting else select.select([here, there], [], [], 0.05)[0]
                    if self.held:
                        continue
                    for end in ready:
                        data = end.recv(CHUNK)
                        if not data:
                            return
                        forgotten = forgotten or self.mute
                        if forgotten:
                            continue
                        if end is here and first:
                            first = False
                            data = data.replace(b" " + self._folder, b" /", 1)
                            if self.upgrades != "led" and b"\r\nupgrade:" in data.lower():
                                if self.upgrades == "refused":
                                    here.sendall(FORBIDDEN)
                                    return
                                forgotten = True
                                continue
                        (there if end is here else here).sendall(data)


@contextlib.contextmanager
def wire(port: int, tls: ssl.SSLContext | None = None, folder: str = "/") -> Iterator[Wire]:
    """A wire, for as long as the context lasts."""
    made = Wire(port, tls, folder)
    try:
        yield made
    finally:
        made.close()


def certified(folder: Path) -> tuple[Path, Path]:
    """The files of a certificate for `localhost` and `school.example`, signed by nobody, and of its key."""
    key, certificate = folder / "key.pem", folder / "certificate.pem"
    command = [
        "openssl",
        "req",
        "-x509",
        "-newkey",
        "rsa:2048",
        "-nodes",
        "-days",
        "2",
        "-subj",
        "/CN=localhost",
    ]
    names = "subjectAltName=DNS:localhost,DNS:school.example"
    command += ["-addext", names, "-keyout", str(key), "-out", str(certificate)]
    subprocess.run(command, check=True, capture_output=True)
    return certificate, key


def self_signed(folder: Path) -> ssl.SSLContext:
    """TLS by a certificate that nobody has signed."""
    certificate, key = certified(folder)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(certificate, key)
    return context
