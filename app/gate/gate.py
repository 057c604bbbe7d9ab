"""The security gate in front of viser.

viser itself accepts connections from any web page, lets a client set any attribute of the handles it knows,
stores uploads of any size, and opens a public tunnel on request. The gate stands between viser and the
network: it checks the Host and Origin of every request, serves nothing but the page, and passes only messages
that the page has a reason to send. Messages that come too fast are delayed, not lost.

It remains to the caller to give each client its own handles (``client.gui``, ``client.scene``), which other
clients cannot reach, and to clamp every value, since the limits of a slider exist in the browser only.
"""

import asyncio
import dataclasses
import functools
import ipaddress
import logging
import re
import time
from collections import Counter
from collections.abc import Awaitable, Callable, Mapping, Sequence
from http import HTTPStatus
from typing import Any

import viser
from websockets.asyncio.server import Server, ServerConnection
from websockets.frames import Frame, Opcode
from websockets.http11 import Request, Response
from websockets.protocol import Event
from websockets.server import ServerProtocol

# viser reads messages of the kinds that exist when the first one comes, so this is imported before.
from .. import viser_inside as viser_inside
from .. import words
from . import messages as gate_messages
from .address import (
    GateError,
    PortBusy,
    PublicAddress,
    authorities,
    exposure,
    host_name,
    is_line,
    is_loopback,
    listen,
    origin,
    own_authorities,
    page_addresses,
    page_name,
    page_query,
    public_address,
    visitor,
)
from .messages import BEAT, MAX_FRAME_BYTES, MAX_MESSAGE_BYTES, GuiUpdateMessage, Reason, Refused, is_alike
from .replies import StaticFile, not_this_host, not_this_origin, respond, safety_headers

__all__ = ["Gate", "GateError", "GatedServer", "PortBusy", "exposure", "open_server", "page_addresses"]

MAX_TABS = 64
"""Pages at once. Each has a simulation with its past, of up to some hundred MB, and a share of one thread. A
class of 60 seats fits, with its teacher and its wall."""

CONNECTIONS_PER_SECOND = 5.0
"""Of all pages. Trying all letters of a class then takes half a day."""
CONNECTION_BURST = 200.0
"""All pages of a full server may come back at once, three times."""

VISITOR_CONNECTIONS_PER_SECOND = 2.5
"""Of one visitor: half of what there is."""
VISITOR_CONNECTION_BURST = 100.0
"""As above; enough for a class behind a school's one address."""

MAX_KNOCKING = 500
"""Open connections of one address that are no pages yet: each page of a class behind one address fetches six
files at a time. The operating system allows a program a thousand or more."""

MESSAGES_PER_SECOND = 1000.0
"""Of one page. It sends at most some 300: the pointer at 240 Hz, the camera and each slider at 20 Hz."""
MESSAGE_BURST = 2000.0
"""Two seconds of the above, saved up."""
BYTES_PER_MESSAGE = 64 * 1024
"""Every started piece of so many counts as a message, so that large ones are paced by size."""

EXTRA_FRAMES_PER_SECOND = 200.0
"""Pings, pongs and continuation frames, which never reach recv(), where messages are paced. A browser sends
one pong every 20 s, and may cut a message into a handful of frames."""
EXTRA_FRAME_BURST = 2000.0
"""Ten seconds of the above, saved up."""

MAX_QUEUED_FRAMES = 4
"""Frames that wait for viser in memory."""

_HERE = ("127.0.0.1", "::1")
"""This machine: its owner, or anybody for whom a proxy speaks without saying so."""

MAX_ADVICE = 5
"""Different refusals that are reported to whoever started the server."""

PAGE_PATHS = ("/", "/index.html", "/s")
"""Where the page is; /s in links to scenes."""

CHECK = "/check"
"""The page on which a device checks whether it can take part in a class."""

CLASS = "/class"
"""The page of a pupil, and of the wall; it is sent at the paths of the page, see `Gate.choose`."""

VIDEO = "/video"
"""The page that tracks positions in a video."""

REACH = "/reach"
"""Where a page asks why it gets no connection, which browsers do not say."""

PROXY_HEADERS = ("Forwarded", "X-Forwarded-For", "X-Forwarded-Host", "X-Forwarded-Proto", "X-Real-IP", "Via")
"""What proxies add to the requests that they pass on."""


_STILL = re.compile(r"(?:^|;)\s*softrod-still=1\s*(?:;|$)", re.ASCII)
_CHOSEN = re.compile(r"(?:^|;)\s*softrod-lang=([A-Za-z-]{1,20})\s*(?:;|$)", re.ASCII)


def language_of(request: Request) -> str:
    """The language of a page: that of its address, else the one chosen on this device, else the browser's."""
    asked = (page_query(request.path.partition("?")[2]) or {}).get("lang", "")
    chosen = next(filter(None, map(_CHOSEN.search, request.headers.get_all("Cookie"))), None)
    accepted = ",".join(request.headers.get_all("Accept-Language"))
    return words.choose(asked or (chosen[1] if chosen else ""), accepted)


class Budget:
    """A token bucket: `burst` at first, then `rate` a second."""

    def __init__(self, rate: float, burst: float) -> None:
        self._rate = rate
        self._burst = burst
        self._left = burst
        self._updated = time.monotonic()

    @property
    def left(self) -> float:
        """Tokens that can be spent now."""
        now = time.monotonic()
        self._left = min(self._burst, self._left + (now - self._updated) * self._rate)
        self._updated = now
        return self._left

    @property
    def is_full(self) -> bool:
        """Whether nothing of the burst is missing."""
        return self.left >= self._burst

    def spend(self, amount: float) -> float:
        """Spend `amount`; the seconds until the budget is no longer overdrawn."""
        self._left = self.left - amount
        return max(0.0, -self._left / self._rate)


@dataclasses.dataclass(frozen=True)
class Visit:
    """A page that has connected.

    Attributes:
        query: with which it did, which may be anything.
        language: that it is to be spoken to in.
        host: the name and port by which it reached the server.
        visitor: whose share of the server it takes.
        still: whether less motion is wished on its device.
        is_local: whether it is certainly of this machine: nobody else can connect, and no proxy passed it on.
            Behind a proxy every connection comes from this machine, so its address alone proves nothing.
    """

    query: str = ""
    language: str = words.ENGLISH
    host: str = ""
    visitor: str = ""
    is_local: bool = False
    still: bool = False


class Connection(ServerConnection):
    """A page's connection, of which only what the gate admits is received.

    Attributes:
        is_line: whether the page is one of softrod's own, instead of viser's.
        path: at which it connected, with its query and without the folder of the public address.
    """

    def __init__(self, gate: "Gate", protocol: ServerProtocol, server: Server, **options: Any) -> None:
        super().__init__(protocol, server, **options)
        self.client: viser.ClientHandle | None = None
        self.page = self.path = ""
        self.is_line = False
        self.visitor = ""
        self.number: int | None = None
        self.since = time.monotonic()
        self._gate = gate
        self._messages = Budget(MESSAGES_PER_SECOND, MESSAGE_BURST)
        self._extra_frames = Budget(EXTRA_FRAMES_PER_SECOND, EXTRA_FRAME_BURST)
        self._pause = 0.0

    async def recv(self, decode: bool | None = None) -> Any:
        """The next message that the gate admits."""
        while True:
            # Pause before the read, not after it: a cancelled recv() must not lose a message.
            if self._pause:
                await asyncio.sleep(self._pause)
            data = await super().recv(decode)
            self._pause = self._messages.spend(1 + len(data) // BYTES_PER_MESSAGE)
            if self.is_line:
                if data == "":
                    await self._answer_beat(b"")
                elif isinstance(data, str) and len(data) <= MAX_MESSAGE_BYTES:
                    return data
                else:
                    self._gate.refused["text" if isinstance(data, bytes) else "size"] += 1
                continue
            admitted = self._gate.admit(self, data)
            if admitted == BEAT:
                await self._answer_beat(viser_inside.no_messages())
            elif admitted is not None:
                self._gate.report_activity(self)
                return admitted

    async def _answer_beat(self, sign: bytes) -> None:
        # Data on their way are a sign of life, too; waiting behind them would delay the page's messages.
        if not self.transport.get_write_buffer_size():
            await self.send(sign)

    def process_event(self, event: Event) -> None:
        """Cut the connection if it keeps sending frames that are no messages."""
        super().process_event(event)
        if not isinstance(event, Frame) or event.opcode in (Opcode.TEXT, Opcode.BINARY):
            return
        if self._extra_frames.spend(1) and not self.transport.is_closing():
            self._gate.refused["frames"] += 1
            self.transport.abort()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Cut the connection if its address has too many that request nothing."""
        super().connection_made(transport)
        if not self._gate.knock(self):
            self.transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the tab."""
        super().connection_lost(exc)
        self._gate.forget(self)


async def _refuse_lines(connection: Connection) -> None:
    """Hold no page of softrod's own: the server has none."""


class Gate:
    """Decides what reaches a viser server, and counts what does not.

    Attributes:
        loopback: whether only this machine can connect, and no proxy is known.
        heard: called with the number of a page that has sent something, before viser reads it.
        choose: the path of the file that is sent for a page, by the page's own path, its query, and whether
            it is certainly of this machine.
        translate: the file at a page's path in a language; None if it has no other than the usual.
        hold: talks with a page of softrod's own until its connection ends.
        advice: for whoever started the server, why pages were refused, and which option admits them. Anybody
            can cause some, so there are never more than `MAX_ADVICE`.
    """

    def __init__(
        self,
        hosts: frozenset[str],
        files: Mapping[str, StaticFile],
        embed: Sequence[str] = (),
        public: PublicAddress | None = None,
        loopback: bool = False,
        more_tabs: int = 0,
    ) -> None:
        self.refused: Counter[Reason] = Counter()
        self.loopback = loopback
        self.advice: list[str] = []
        self.heard: Callable[[int], None] = lambda _: None
        self.choose: Callable[[str, str, bool], str] = lambda path, query, is_local: path
        self.translate: Callable[[str, str], StaticFile | None] = lambda path, language: None
        self.hold: Callable[[Connection], Awaitable[None]] = _refuse_lines
        self._more_tabs = more_tabs
        self._public = public
        self._files = files
        self._headers = safety_headers(embed)
        self._hosts = hosts
        self._server: viser.ViserServer | None = None
        self._tabs: set[Connection] = set()
        self._connections = Budget(CONNECTIONS_PER_SECOND, CONNECTION_BURST)
        self._visitors: dict[str, Budget] = {}  # that have connected lately
        self._knocking: set[Connection] = set()  # connections that are no pages, or not yet

    def open(self, server: viser.ViserServer) -> None:
        """Begin to admit requests; until now all are refused."""
        self._server = server

    def answer(
        self, viser_answer: Callable[..., Response | None], connection: Connection, request: Request
    ) -> Response | None:
        """Answer an HTTP request; None accepts a WebSocket connection."""
        request = self._without_folder(request)
        connection.visitor = self._visitor(connection, request)
        refusal = self._refusal(connection, request)
        if refusal is not None:
            reason, status, sentence = refusal
            self.refused[reason] += 1
            if reason in ("host", "origin") and sentence not in self.advice and len(self.advice) < MAX_ADVICE:
                self.advice.append(sentence)
            response = connection.respond(status, sentence + "\n")
            if status is HTTPStatus.TEMPORARY_REDIRECT:
                response.headers["Location"] = "./"
        elif "Upgrade" not in request.headers and request.path == REACH:
            response = connection.respond(HTTPStatus.OK, "")
            response.headers["Cache-Control"] = "no-store"
        elif "Upgrade" not in request.headers and (file := self._file(request)):
            response = respond(file, request)
        elif is_line(request.path.partition("?")[0]):
            response = None
        else:
            response = viser_answer(connection, request)
        if response is None:
            self._admit_page(connection, request)
        else:
            response.headers.update(self._headers)
        return response

    def _file(self, request: Request) -> StaticFile | None:
        """The file that is requested; which page, may depend on who requests it."""
        path, _, query = request.path.partition("?")
        if path in PAGE_PATHS:
            path = self.choose(path, query, self._is_local(request))
        return self.translate(path, language_of(request)) or self._files.get(path)

    def _admit_page(self, connection: Connection, request: Request) -> None:
        """Count a page, in place of its former connections, or of another's page if the server is full."""
        for former in self._former(request):
            former.transport.abort()
        others = self._others(request)
        if len(others) >= self._max_tabs and (crowd := _crowd(others, connection.visitor)) is not None:
            crowd.transport.abort()
        path = request.path.partition("?")[0]
        connection.page, connection.is_line, connection.path = page_name(path), is_line(path), request.path
        self._tabs.add(connection)
        self._knocking.discard(connection)
        self._connections.spend(1)
        self._budget(connection.visitor).spend(1)

    def _refusal(self, connection: Connection, request: Request) -> tuple[Reason, HTTPStatus, str] | None:
        if self._server is None:
            return "starting", HTTPStatus.SERVICE_UNAVAILABLE, "The server is starting."
        hosts = [host.lower() for host in request.headers.get_all("Host")]
        # A page of another site whose name points to this machine sends that name.
        behind = self._public.hosts if self._public else frozenset()
        own = len(hosts) == 1 and self._is_own(hosts[0], connection)
        if not own and (len(hosts) != 1 or hosts[0] not in behind):
            return "host", HTTPStatus.MISDIRECTED_REQUEST, not_this_host(*hosts[:1])
        upgrade = request.headers.get_all("Upgrade")
        if not upgrade:
            if request.path == REACH:
                return self._refusal_of_page(hosts[0], own, connection, request, "X-Softrod-Origin")
            path, _, query = request.path.partition("?")
            # viser's page would connect to any server that a query names, and run its scripts.
            if query and (path not in (*PAGE_PATHS, CHECK, VIDEO) or page_query(query) is None):
                return "path", HTTPStatus.TEMPORARY_REDIRECT, "This page takes no such parameters."
            if path not in PAGE_PATHS and path not in self._files:
                return "path", HTTPStatus.NOT_FOUND, "There is no such page."
            return None
        if upgrade != ["websocket"]:
            return "upgrade", HTTPStatus.BAD_REQUEST, "Only a WebSocket is served here."
        return self._refusal_of_page(hosts[0], own, connection, request, "Origin")

    def _refusal_of_page(
        self, host: str, own: bool, connection: Connection, request: Request, header: str
    ) -> tuple[Reason, HTTPStatus, str] | None:
        """Why a page that names its origin in a header may not connect; `own`: the host needs no proxy."""
        origins = [origin.lower() for origin in request.headers.get_all(header)]
        # The public address counts only with its scheme: a page at http:// must not pass for one at https://.
        known = {f"http://{host}"} if own else set()
        if self._public is not None:
            known.add(self._public.origin)
        if len(origins) != 1 or origins[0] not in known:
            return "origin", HTTPStatus.FORBIDDEN, not_this_origin(*origins[:1])
        most, who, others = self._max_tabs, connection.visitor, self._others(request)
        if len(others) >= most and _crowd(others, who) is None:
            sentence = f"This server is full: it has room for {most} pages. Close one that nobody needs."
            return "tabs", HTTPStatus.SERVICE_UNAVAILABLE, sentence
        if self._connections.left < 1 or (who not in _HERE and self._budget(who).left < 1):
            return "rate", HTTPStatus.TOO_MANY_REQUESTS, "Too many pages connect at once. Wait for a minute."
        return None

    @property
    def _max_tabs(self) -> int:
        """Pages at once, at most."""
        return MAX_TABS + self._more_tabs

    def _others(self, request: Request) -> set[Connection]:
        """The pages besides the one that connects."""
        return {tab for tab in self._tabs if not tab.transport.is_closing()} - self._former(request)

    def _budget(self, visitor: str) -> Budget:
        """A visitor's budget of connections; budgets that are full again are forgotten."""
        if visitor not in self._visitors:
            left = ((who, budget) for who, budget in self._visitors.items() if not budget.is_full)
            self._visitors = dict(left)
            self._visitors[visitor] = Budget(VISITOR_CONNECTIONS_PER_SECOND, VISITOR_CONNECTION_BURST)
        return self._visitors[visitor]

    def _visitor(self, connection: Connection, request: Request) -> str:
        """Whose share of the server a connection takes."""
        peer, own = str(connection.remote_address[0]), str(connection.local_address[0])
        return visitor(peer, own, request.headers.get_all("X-Forwarded-For"), self._public is not None)

    def _former(self, request: Request) -> set[Connection]:
        """Earlier connections of the page that connects, which are lost without this end having noticed."""
        name = page_name(request.path.partition("?")[0])
        return {tab for tab in self._tabs if name and tab.page == name}

    def visit(self, client_id: int) -> Visit:
        """Who a page of viser's is; one that is gone is nobody's."""
        assert self._server is not None
        connection = viser_inside.connections(self._server).get(client_id)
        return Visit() if connection is None else self.visit_by(connection)

    def visit_by(self, connection: Connection) -> Visit:
        """Who a page is that has connected."""
        request = connection.request
        assert request is not None
        query = request.path.partition("?")[2]
        host, still = request.headers["Host"], any(map(_STILL.search, request.headers.get_all("Cookie")))
        return Visit(query, language_of(request), host, connection.visitor, self._is_local(request), still)

    def _is_local(self, request: Request) -> bool:
        return self.loopback and not any(map(request.headers.get_all, PROXY_HEADERS))

    def _is_own(self, host: str, connection: Connection) -> bool:
        # The address at which the request arrived is this machine's, in whichever network.
        address, port, *_ = connection.local_address
        return host in self._hosts or is_loopback(host) or host in authorities(address, port)

    def _without_folder(self, request: Request) -> Request:
        """The request without the folder of the public address, which proxies may remove or leave."""
        folder = self._public.folder if self._public else "/"
        if folder == "/" or not request.path.startswith(folder):
            return request
        return dataclasses.replace(request, path=request.path[len(folder) - 1 :])

    def knock(self, connection: Connection) -> bool:
        """Whether a new connection may send its request.

        Otherwise anybody could use up all connections of the system by opening them silently.
        """
        if not connection.remote_address:
            return False
        peer = connection.remote_address[0]
        if sum(other.remote_address[0] == peer for other in self._knocking) >= MAX_KNOCKING:
            self.refused["knocking"] += 1
            return False
        self._knocking.add(connection)
        return True

    def forget(self, tab: Connection) -> None:
        """Forget a tab that is gone."""
        self._tabs.discard(tab)
        self._knocking.discard(tab)

    def admit(self, tab: Connection, data: str | bytes) -> bytes | None:
        """The message for viser, or None if it must not see it."""
        try:
            if isinstance(data, str):
                raise Refused("text")
            message = gate_messages.read(data)
            if isinstance(message, GuiUpdateMessage):
                handle = self._input_handle(tab, message.uuid)
                if handle is None or not is_alike(handle.value, message.updates.value):
                    raise Refused("handle")
        except Refused as refusal:
            self.refused[refusal.reason] += 1
            return None
        return gate_messages.write(message)

    def report_activity(self, tab: Connection) -> None:
        """Report that a page has sent something."""
        if tab.number is None:
            assert self._server is not None
            live = viser_inside.connections(self._server)
            tab.number = next((number for number, one in live.items() if one is tab), None)
        if tab.number is not None:
            self.heard(tab.number)

    def _input_handle(self, tab: Connection, uuid: str) -> Any:
        """The GUI element of a tab's message: its own, or one shared by all."""
        assert self._server is not None
        if tab.client is None:
            live = viser_inside.connections(self._server)
            clients = self._server.get_clients().items()
            tab.client = next((client for key, client in clients if live.get(key) is tab), None)
        handle = viser_inside.input_handle(self._server, uuid)
        if handle is None and tab.client is not None:
            handle = viser_inside.input_handle(tab.client, uuid)
        return handle


def _crowd(tabs: set[Connection], visitor: str) -> Connection | None:
    """The page that a visitor's replaces in a full server: the newest of the visitor with the most pages.

    So nobody can keep others out by opening page after page. The other visitor has at least as many pages
    left as the newcomer, and cannot replace it in turn.

    Returns:
        None if the visitor would have as many as anybody.
    """
    counts = Counter(tab.visitor for tab in tabs)
    largest, count = max(counts.items(), key=lambda item: item[1], default=("", 0))
    if counts[visitor] + 1 >= count:
        return None
    return max((tab for tab in tabs if tab.visitor == largest), key=lambda tab: tab.since)


class GatedServer(viser.ViserServer):
    """A viser server behind its gate."""

    def __init__(self, gate: Gate, host: str, port: int, label: str | None) -> None:
        self.gate = gate
        super().__init__(host=host, port=port, label=label, verbose=False)


def open_server(
    host: str,
    port: int,
    *,
    label: str | None = None,
    extra_hosts: Sequence[str] = (),
    files: Mapping[str, StaticFile] | None = None,
    embed: Sequence[str] = (),
    public_url: str | None = None,
    more_tabs: int = 0,
) -> GatedServer:
    """Serve viser's page behind the gate.

    Args:
        host, port: where to listen; port 0 for any free one.
        label: of the page's title.
        extra_hosts: further names of the server, with their port if it is not `port`, as in "localhost:9000".
        files: served by their paths, before viser's own.
        embed: origins of the sites that may show the page in a frame, as in "https://school.example".
        public_url: the address by which others reach the page through a proxy, with its folder.
        more_tabs: pages beyond MAX_TABS.

    Raises:
        PortBusy: another program listens on the port.
        GateError: the gate cannot be installed, or an origin, a name or an address makes no sense.
    """
    if viser.__version__ != viser_inside.VERSION:
        raise GateError(f"viser {viser_inside.VERSION} is needed, but {viser.__version__} is installed.")
    embed = [origin(site) for site in embed]
    extra_hosts = [host_name(name) for name in extra_hosts]
    public = None if public_url is None else public_address(public_url)
    listener = listen(host, port)
    address, port = listener.getsockname()[:2]
    hosts = own_authorities(address, host, port, extra_hosts)
    loopback = ipaddress.ip_address(address).is_loopback and not extra_hosts and public is None
    gate = Gate(hosts, files or {}, embed, public, loopback, more_tabs)

    def options_of(viser_answer: Callable[..., Response | None]) -> dict[str, Any]:
        return {
            # The listener itself holds the port until then, and is closed in any case.
            "sock": listener.dup(),
            "process_request": functools.partial(gate.answer, viser_answer),
            "create_connection": functools.partial(Connection, gate),
            "max_size": MAX_FRAME_BYTES,
            "max_queue": MAX_QUEUED_FRAMES,
            "logger": _logger,
        }

    def handler_of(
        of_viser: Callable[[Connection], Awaitable[None]],
    ) -> Callable[[Connection], Awaitable[None]]:
        return lambda connection: gate.hold(connection) if connection.is_line else of_viser(connection)

    with listener, viser_inside.served_by(options_of, handler_of) as calls:
        server = GatedServer(gate, host, port, label)
        if len(calls) != 1:
            server.stop()
            raise GateError("viser did not start its server by way of the gate.")
    gate.open(server)
    return server


_logger = logging.getLogger(__name__)
# websockets logs a traceback for every request that it cannot parse.
_logger.addFilter(lambda record: record.getMessage() != "opening handshake failed")
