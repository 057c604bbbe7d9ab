"""Which sites may show the page in a frame."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from app.gate.address import GateError, origin
from app.gate.gate import GatedServer, open_server
from tests.app.hostile import HANDSHAKE, answer, status

SITES = ("https://school.example", "http://LOCALHOST:8888/")


@pytest.fixture(scope="module")
def server() -> Iterator[GatedServer]:
    server = open_server("127.0.0.1", 0, embed=SITES)
    yield server
    server.stop()


@pytest.mark.parametrize("path", ["/", "/nothing"])
def test_the_named_sites_alone_may_frame_the_page(server: GatedServer, path: str) -> None:
    port = server.get_port()
    _, headers = answer(port, [("Host", f"127.0.0.1:{port}")], path)
    allowed = "frame-ancestors https://school.example http://localhost:8888"
    assert headers["Content-Security-Policy"] == allowed
    # A browser that knows it would turn the named sites away, too.
    assert "X-Frame-Options" not in headers


@pytest.mark.parametrize("site", [*SITES, "http://localhost:8888"])
def test_a_site_that_may_frame_the_page_may_still_not_connect(server: GatedServer, site: str) -> None:
    port = server.get_port()
    host = ("Host", f"127.0.0.1:{port}")
    assert status(port, [host, ("Origin", site), *HANDSHAKE]) == 403
    # The framed page is of the server's own origin.
    assert status(port, [host, ("Origin", f"http://127.0.0.1:{port}"), *HANDSHAKE]) == 101


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("https://school.example", "https://school.example"),
        ("HTTPS://School.Example:443/", "https://school.example"),
        ("http://localhost:80", "http://localhost"),
        ("http://[::1]:8888", "http://[::1]:8888"),
    ],
)
def test_an_origin_is_written_as_browsers_do(text: str, written: str) -> None:
    assert origin(text) == written


@pytest.mark.parametrize(
    "text",
    [
        "", "*", "null", "'self'", "school.example", "https://", "https://.",
        "https://*.school.example", "https://school.example/moodle",
        "https://school.example https://evil.example", "https://school.example; script-src *",
        "https://school.example\r\nX-Evil: 1", "https://user@school.example",
        "https://school.example:0", "https://school.example:65536", "ftp://school.example",
        "javascript:alert(1)",
    ],
)  # fmt: skip
def test_what_is_no_origin_is_refused_before_anything_is_served(text: str) -> None:
    with pytest.raises(GateError, match=r"^[^\n]+ is not the origin of a site[^\n]+\.$"):
        open_server("127.0.0.1", 0, embed=[text])
