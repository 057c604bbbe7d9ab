"""What is answered to plain requests: files, and why something is refused."""

import dataclasses
import gzip
import re
from collections.abc import Sequence
from http import HTTPStatus

from websockets.datastructures import Headers
from websockets.http11 import Request, Response


@dataclasses.dataclass(frozen=True)
class StaticFile:
    """A file that is served in place of viser's.

    Attributes:
        content: compressed with gzip.
        content_type: MIME type.
        cache_control: the header of that name.
    """

    content: bytes
    content_type: str
    cache_control: str


def safety_headers(embed: Sequence[str]) -> dict[str, str]:
    """What every answer has besides.

    Args:
        embed: origins of sites that may show the page in a frame, as `origin` gives them. No other site may,
            since it could steer clicks on the page.
    """
    headers = {
        "Content-Security-Policy": "frame-ancestors " + (" ".join(embed) or "'none'"),
        "X-Content-Type-Options": "nosniff",
        # The address of a class's page has its letters.
        "Referrer-Policy": "no-referrer",
        "Cross-Origin-Resource-Policy": "same-origin",
    }
    # The older header knows no list of sites, and would turn all of them away.
    return headers if embed else {**headers, "X-Frame-Options": "DENY"}


_SHOWN = re.compile(r"(https?://)?[\w.\[\]:-]{1,250}", re.ASCII)


def not_this_host(host: str = "") -> str:
    """What to do about a Host that is not this server's."""
    if not _SHOWN.fullmatch(host):
        return "softrod does not answer to this address."
    return (
        f"softrod does not answer to the address {host}.\n\nIf that is to be its address, start it with "
        f"--allow-host {host}, or, behind a proxy that speaks TLS, with --public-url https://{host}/ (and "
        "the folder, if the page is in one)."
    )


def not_this_origin(origin: str = "") -> str:
    """What to do about an Origin whose pages may not connect."""
    said = "Only this server's own page may connect."
    if not _SHOWN.fullmatch(origin):
        return said
    return (
        f"{said} If a proxy leads from {origin} to this server, start softrod with --public-url {origin}/ "
        "(and the folder, if the page is in one)."
    )


def respond(file: StaticFile, request: Request) -> Response:
    compressed = "gzip" in request.headers.get("Accept-Encoding", "")
    body = file.content if compressed else gzip.decompress(file.content)
    headers = Headers(
        {
            "Content-Type": f"{file.content_type}; charset=utf-8",
            "Content-Length": str(len(body)),
            "Content-Encoding": "gzip" if compressed else "identity",
            "Cache-Control": file.cache_control,
            "Connection": "close",
        }
    )
    return Response(HTTPStatus.OK.value, HTTPStatus.OK.phrase, headers, body)
