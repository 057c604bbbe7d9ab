"""nginx and Caddy, as installed from packages, with the configurations of `docs/hosting`."""

from __future__ import annotations

import contextlib
import os
import shutil
import socket
import subprocess
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import pytest

CONFIGURATIONS = Path(__file__).parents[1] / "docs" / "hosting"
FOLDERS = ("/a/", "/b/")
"""Folders of the two servers that are behind them."""

PATIENCE = 30.0
"""Seconds within which a proxy must be there; only one that does not start makes a test wait this long."""

_NGINX = """
{user}
pid nginx.pid;
events {{}}
http {{
  access_log access.log combined;
  client_body_temp_path body;
  proxy_temp_path proxy;
  fastcgi_temp_path fastcgi;
  uwsgi_temp_path uwsgi;
  scgi_temp_path scgi;
  include school.conf;
}}
"""
_CADDY = """{
  admin off
  auto_https disable_redirects
  log default {
    output file access.log
    level DEBUG
  }
}
"""

Kind = Literal["nginx", "caddy"]


@dataclass
class Proxy:
    """What leads from one address by https to two servers.

    Args:
        kind: which program.
        folder: where it has its files.
        certificate, key: files of its certificate for `localhost`.

    Attributes:
        port: where it listens.
    """

    kind: Kind
    folder: Path
    certificate: Path
    key: Path
    port: int = field(default_factory=lambda: _free_port())

    def url(self, folder: str, name: str = "localhost") -> str:
        """The address of one of the two servers, in one of `FOLDERS`; the other name is `school.example`."""
        return f"https://{name}:{self.port}{folder}"

    def access_log(self) -> str:
        """What it has written of the requests that it led on."""
        return (self.folder / "access.log").read_text(encoding="utf-8")

    @contextlib.contextmanager
    def leading(self, *ports: int) -> Iterator[None]:
        """It runs, and leads to servers at these ports, for as long as the context lasts."""
        command = self._configured(*ports)
        environment = {**os.environ, "XDG_DATA_HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder)}
        said = self.folder / "said.txt"
        with said.open("w") as text:
            process = subprocess.Popen(command, cwd=self.folder, env=environment, stdout=text, stderr=text)
        try:
            self._wait_for(process, said)
            yield
        finally:
            process.terminate()
            process.wait()

    def _wait_for(self, process: subprocess.Popen[bytes], said: Path) -> None:
        deadline = time.monotonic() + PATIENCE
        while process.poll() is None and time.monotonic() < deadline:
            with contextlib.suppress(OSError):
                socket.create_connection(("127.0.0.1", self.port), timeout=1.0).close()
                return
            time.sleep(0.02)
        process.kill()
        pytest.fail(f"{self.kind} did not start: {said.read_text()}", pytrace=False)

    def _configured(self, *ports: int) -> list[str]:
        """Its command, with the configuration of the documents but for addresses and files."""
        program = shutil.which(self.kind, path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")
        if program is None:
            pytest.fail(
                f"This test needs {self.kind}: install it, as by apt-get install {self.kind}.", pytrace=False
            )
        known = {"127.0.0.1:8081": f"127.0.0.1:{ports[0]}", "127.0.0.1:8082": f"127.0.0.1:{ports[1]}"}
        if self.kind == "nginx":
            known |= {
                "listen 443 ssl": f"listen 127.0.0.1:{self.port} ssl",
                "server_name school.example": "server_name localhost school.example",
                "/etc/ssl/school.pem": str(self.certificate),
                "/etc/ssl/school.key": str(self.key),
            }
            (self.folder / "school.conf").write_text(_replaced("nginx.conf", known))
            # Its workers are somebody else, if it is started by root, who could not write what they must.
            user = "user root;" if os.geteuid() == 0 else ""
            (self.folder / "nginx.conf").write_text(_NGINX.format(user=user))
            prefix = f"{self.folder}/"
            return [program, "-p", prefix, "-c", "nginx.conf", "-e", "error.log", "-g", "daemon off;"]
        names = f"https://localhost:{self.port}, https://school.example:{self.port}"
        tls = f"{names} {{\n  bind 127.0.0.1\n  log\n  tls {self.certificate} {self.key}"
        known["school.example {"] = tls
        (self.folder / "Caddyfile").write_text(_CADDY + _replaced("Caddyfile", known))
        return [program, "run", "--config", "Caddyfile", "--adapter", "caddyfile"]


def _replaced(name: str, known: dict[str, str]) -> str:
    """A configuration of the documents, with other places."""
    text = (CONFIGURATIONS / name).read_text(encoding="utf-8")
    for what, instead in known.items():
        assert text.count(what) == 1, f"{name}: {what}"
        text = text.replace(what, instead)
    return text


def _free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]
