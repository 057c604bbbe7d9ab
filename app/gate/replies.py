"""Answers to plain requests: files, and reasons for a refusal."""

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
    """The headers of every answer.

    Args:
        embed: origins of sites that may show the page in a frame, see `origin`. Any other site could trick
            users into clicks on the page.
    """
    headers = {
        "Content-Security-Policy": "frame-ancestors " + (" ".join(embed) or "'none'"),
        "X-Content-Type-Options": "nosniff",
        # The address of a class's page has its letters.
        "Referrer-Policy": "no-referrer",
        "Cross-Origin-Resource-Policy": "same-origin",
    }
    # The older header allows no list of sites, and would block all of them.
    return headers if embed else {**headers, "X-Frame-Options": "DENY"}


_SHOWN = re.compile(r"(https?://)?[\w.\[\]:-]{1,250}", re.ASCII)


def not_this_host(host: str = "") -> str:
    """A sentence on a Host that is not this server's, with the remedy."""
    if not _SHOWN.fullmatch(host):
        return "softrod does not answer to this address."
    return (
        f"softrod does not answer to the address {host}.\n\nIf that is to be its address, start it with "
        f"--allow-host {host}, or, behind a proxy that speaks TLS, with --public-url https://{host}/ (and "
        "the folder, if the page is in one)."
    )


def not_this_origin(origin: str = "") -> str:
    """A sentence on an Origin whose pages may not connect, with the remedy."""
    said = "Only this server's own page may connect."
    if not _SHOWN.fullmatch(origin):
        return said
    return (
        f"{said} If a proxy leads from {origin} to this server, start softrod with --public-url {origin}/ "
        "(and the folder, if the page is in one)."
    )


def respond(file: StaticFile, request: Request) -> Response:
    """Answer with a file, compressed if the browser accepts that."""
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
