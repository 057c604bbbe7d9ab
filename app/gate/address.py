"""Addresses: the socket to listen on, and the names by which browsers may reach the page."""

import contextlib
import errno
import ipaddress
import re
import socket
import struct
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

_FIELDS = {
    "controls": re.compile(r"[\w.,%\[\]-]{0,2000}", re.ASCII),
    "scene": re.compile(r"[!-%'-~]{0,300}"),
    "s": re.compile(r"[!-%'-~]{0,40}"),
    "room": re.compile(r"[A-Za-z]{0,4}", re.ASCII),
    "as": re.compile(r"(desk|wall|seat|check)?", re.ASCII),
    "lang": re.compile(r"[A-Za-z-]{0,20}", re.ASCII),
}
"""Fields of the query of a page's address: controls (`app.ui.controls`), scene (`app.ui.opening`), class and
role in it (`app.features.classroom`), and language (`app.words`)."""

_PAGE = re.compile(r".*/(?:at|line)/([0-9a-f]{32})", re.ASCII)
_LINE = re.compile(r".*/line/[0-9a-f]{32}", re.ASCII)


def page_query(query: str) -> dict[str, str] | None:
    """The fields of the query of a page's address, undecoded; None if it is not such a query."""
    fields: dict[str, str] = {}
    for field in query.split("&") if query else ():
        name, _, text = field.partition("=")
        if name in fields or name not in _FIELDS or not _FIELDS[name].fullmatch(text):
            return None
        fields[name] = text
    return fields


def page_name(path: str) -> str:
    """The name that a page has chosen for itself, from the path at which it connects; empty if none."""
    match = _PAGE.fullmatch(path)
    return match[1] if match else ""


def is_line(path: str) -> bool:
    """Whether a page that connects at a path is one of softrod's own, instead of viser's."""
    return _LINE.fullmatch(path) is not None


def visitor(peer: str, own: str, forwarded: Sequence[str], public: bool) -> str:
    """The key of a visitor, for shares of the server: an address, or the network of one customer.

    Args:
        peer: address at the other end of the connection.
        own: the server's address at this end.
        forwarded: the values of ``X-Forwarded-For``, in order.
        public: whether the page is reached through a proxy. It appends the address for which it speaks to the
            last of these; anything before that anybody may have claimed.
    """
    addresses = ",".join(forwarded).split(",") if public else []
    try:
        address = ipaddress.ip_address(addresses[-1].strip() if addresses else peer)
    except ValueError:
        return peer
    if isinstance(address, ipaddress.IPv6Address):
        if address.ipv4_mapped is not None:
            return str(address.ipv4_mapped)
        network = ipaddress.ip_network((address, 64), strict=False)
        # A customer has a whole network of addresses, but the server's own network has many people's.
        if not addresses and ipaddress.ip_address(own) in network:
            return str(address)
        return str(network)
    return str(address)


class GateError(RuntimeError):
    """The gate could not be installed, so nothing is served."""


class PortBusy(OSError):
    """The port is in use by another program."""

    def __init__(self, port: int, next_free: int) -> None:
        super().__init__(f"Port {port} is already in use; the next free one is {next_free}.")
        self.errno = errno.EADDRINUSE
        self.port = port
        self.next_free = next_free


def own_authorities(bound: str, host: str, port: int, extra_hosts: Sequence[str]) -> frozenset[str]:
    """The values of Host that browsers send to a server for `host` that is bound to the address `bound`."""
    names = {*extra_hosts, "localhost", "127.0.0.1", "::1"}
    names |= _machine_names() if ipaddress.ip_address(bound).is_unspecified else {host, bound}
    return frozenset(authority for name in names for authority in authorities(name, port))


def authorities(name: str, port: int) -> set[str]:
    """The values of Host that browsers send for a name or address, which may have a port of its own."""
    name = name.lower()
    if own := re.fullmatch(r"(\[.+\]|[^:]+):(\d+)", name):
        return {name, own[1]} if own[2] == "80" else {name}
    if ":" in name and not name.startswith("["):
        name = f"[{name}]"
    # Browsers omit the default port of HTTP.
    return {name, f"{name}:80"} if port == 80 else {f"{name}:{port}"}


_ORIGIN = re.compile(r"(https?)://([a-z0-9.-]+|\[[0-9a-f:.]+\])(?::(\d{1,5}))?/?")
_OWN_PORTS = {"http": 80, "https": 443}


_HOST = r"[a-z0-9_.-]+|\[[0-9a-f:.]+\]"
_AUTHORITY = re.compile(rf"({_HOST})(?::(\d{{1,5}}))?")
_PUBLIC = re.compile(rf"(https?)://({_HOST})(?::(\d{{1,5}}))?((?:/[A-Za-z0-9_~-][A-Za-z0-9._~-]*)*)/?")
_LOOPBACK = re.compile(r"(localhost|127\.0\.0\.1|\[::1\])(:\d{1,5})?")


def is_loopback(host: str) -> bool:
    """Whether a Host is this machine's name for itself, with any port.

    Any port is safe, and tunnels need it (``ssh -L 9000:localhost:8080``). A DNS rebinding attack uses a name
    of its own that points here, and sends that: nobody can own `localhost` or 127.0.0.1. A page of another
    program on this machine sends our port as Host and its own as Origin, and the gate requires both to be
    equal."""
    return _LOOPBACK.fullmatch(host) is not None


def host_name(text: str) -> str:
    """Check a further name of this server, with or without a port.

    Raises:
        GateError: it is no such name.
    """
    match = _AUTHORITY.fullmatch(text.strip().lower())
    if match is None or not match[1].strip(".-") or not 1 <= int(match[2] or 1) <= 65535:
        raise GateError(
            f"--allow-host: {text!r} is not a name of this server; one is written as laptop.local or "
            "laptop.local:9000, without http:// and without a path."
        )
    return match[0]


@dataclass(frozen=True)
class PublicAddress:
    """The address by which others reach the page through a proxy.

    Attributes:
        url: with a slash at its end.
        origin: that browsers send.
        hosts: values of Host that a proxy may pass on.
        folder: path of the page, with a slash at either end.
    """

    url: str
    origin: str
    hosts: frozenset[str]
    folder: str


def public_address(text: str) -> PublicAddress:
    """Read the address by which others reach the page.

    Raises:
        GateError: it is not the address of a page.
    """
    scheme, separator, rest = text.strip().partition("://")
    host, slash, path = rest.partition("/")
    match = _PUBLIC.fullmatch(f"{scheme.lower()}{separator}{host.lower()}{slash}{path}")
    if match is None or not match[2].strip(".-") or not 1 <= int(match[3] or 1) <= 65535:
        raise GateError(
            f"--public-url: {text!r} is not the address of a page; one is written as "
            "https://school.example/lab/, without ? and #."
        )
    site = origin(match[0].removesuffix("/").removesuffix(match[4]))
    folder = f"{match[4]}/"
    # Some proxies pass the name on without its port.
    hosts = frozenset((match[2], f"{match[2]}:{match[3] or _OWN_PORTS[match[1]]}"))
    return PublicAddress(site + folder, site, hosts, folder)


OF_THIS_MACHINE = ("http://localhost:*", "http://127.0.0.1:*")
"""Origins of all sites on this machine, for a Content Security Policy."""


def origin(text: str) -> str:
    """Normalize a site's origin, given with capitals, its default port or a slash; or one of
    `OF_THIS_MACHINE`.

    Raises:
        GateError: it is not the origin of a site.
    """
    if text in OF_THIS_MACHINE:
        return text
    match = _ORIGIN.fullmatch(text.strip().lower())
    if match is None or not match[2].strip(".-"):
        raise GateError(
            f"{text!r} is not the origin of a site; one is written as https://school.example or "
            "http://localhost:8888, without a path and without *."
        )
    scheme, host, port = match[1], match[2], int(match[3] or _OWN_PORTS[match[1]])
    if not 1 <= port <= 65535:
        raise GateError(f"{text!r} is not the origin of a site: {port} is not a port from 1 to 65535.")
    return f"{scheme}://{host}" if port == _OWN_PORTS[scheme] else f"{scheme}://{host}:{port}"


_OWNER_ALONE = "Only pages with #owner= in their address can change your scenes."


def exposure(host: str, public: PublicAddress | None = None) -> str | None:
    """A warning on what serving on `host` exposes; None if only this machine can connect.

    Args:
        public: the address by which others reach it through a proxy, if any.
    """
    if public is not None:
        return (
            f"Anyone who can open {public.url} can run simulations on this machine, open your saved scenes, "
            "and save scenes of their own here. There is no password, unless the proxy asks for one. "
            f"{_OWNER_ALONE}"
        )
    if _is_this_machine(host):
        return None
    return (
        f"With host {host}, anyone who can reach this machine can open the page, run simulations on this "
        "machine, open your saved scenes, and save scenes of their own here. There is no password, and the "
        f"traffic is not encrypted. {_OWNER_ALONE}"
    )


def class_exposure(host: str, public: PublicAddress | None = None) -> str:
    """A warning on what a class served on `host` exposes.

    Args:
        public: the address by which others reach it through a proxy, if any.
    """
    said = "Nothing but the teacher's address leads a class: keep it to yourself."
    if public is not None and public.url.startswith("https:"):
        return f"Anyone who can open {public.url} and has a class's four letters can take a seat. {said}"
    if public is None and _is_this_machine(host):
        return "Only this computer reaches these; --host 0.0.0.0 lets others in."
    return (
        "Anyone in the same network who has a class's four letters can take a seat, and the traffic is not "
        f"encrypted: others in the network can read along. {said}"
    )


def _is_this_machine(host: str) -> bool:
    """Whether only this machine can reach a server for `host`."""
    with contextlib.suppress(OSError):
        return ipaddress.ip_address(_resolve(host, 0)[1][0]).is_loopback
    return False


def listen(host: str, port: int) -> socket.socket:
    """Open the socket to serve from; unlike viser, do not silently take the next port if this one is busy."""
    if not 0 <= port <= 65535:
        raise GateError(f"Port {port} is not a number from 0 to 65535.")
    try:
        family, address = _resolve(host, port)
        return socket.create_server(address, family=family)
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            raise PortBusy(port, _next_free(host, port)) from None
        reason = str(error.strerror).partition(" (")[0]
        raise GateError(f"Cannot listen on {host} port {port}: {reason}.") from None


def _next_free(host: str, port: int) -> int:
    # The last resort is port 0, any free port.
    for candidate in (*range(port + 1, 65536), 0):
        with contextlib.suppress(OSError):
            family, address = _resolve(host, candidate)
            with socket.create_server(address, family=family) as listener:
                return listener.getsockname()[1]
    return 0


def _resolve(host: str, port: int) -> tuple[socket.AddressFamily, Any]:
    """The address to bind for a host, IPv4 if there is a choice."""
    found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)
    family, _, _, _, address = min(found, key=lambda info: info[0] != socket.AF_INET)
    return family, address


_PROBES = ("192.0.2.1", "10.255.255.254", "172.31.255.254", "192.168.255.254")
"""Addresses in networks that this machine may be part of; nothing is sent to them."""


_VIRTUAL = re.compile(
    r"(docker|podman|cni|br-|virbr|veth|lxc|lxd|vbox|vmnet|vEthernet|tun|tap|utun|wg|ppp|tailscale|zt)"
)
"""Prefixes of the names of interfaces to virtual machines, containers and tunnels."""


def is_virtual(name: str) -> bool:
    """Whether a network interface, by its name, reaches no other machine."""
    return _VIRTUAL.match(name) is not None


_ASK_ADDRESS = {"linux": 0x8915, "darwin": 0xC0206921}
"""SIOCGIFADDR, the request for the IPv4 address of a network interface."""


def interfaces() -> dict[str, str]:
    """The names of this machine's network interfaces by their IPv4 addresses, if the system tells them."""
    found: dict[str, str] = {}
    request = _ASK_ADDRESS.get(sys.platform)
    if request is None:
        return found
    import fcntl  # not on Windows

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
        for _, name in socket.if_nameindex():
            # An interface that is down, or has no IPv4 address, raises.
            with contextlib.suppress(OSError):
                answer = fcntl.ioctl(asking, request, struct.pack("256s", name.encode()[:15]))
                found[socket.inet_ntoa(answer[20:24])] = name
    return found


def local_addresses() -> list[str]:
    """The IPv4 addresses by which others may reach this machine.

    The one towards the internet comes first; networks that only this machine is in come last. The hotspot of
    a laptop is no route to anywhere: its address is known from its interface alone."""
    names = interfaces()
    found: list[str] = []
    for towards in _PROBES:
        # The system reports from which address it would send, without sending.
        with contextlib.suppress(OSError), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.connect((towards, 9))
            found.append(probe.getsockname()[0])
    with contextlib.suppress(OSError):
        found += [str(i[4][0]) for i in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)]
    others = [a for a in dict.fromkeys((*found, *names)) if not ipaddress.ip_address(a).is_loopback]
    return sorted(others, key=lambda address: is_virtual(names.get(address, "")))


def address_for_others(page: str, host: str, port: int, public: PublicAddress | None) -> str:
    """The address by which others reach a page that was itself reached by the address `page`.

    Args:
        page: with a slash at its end.
        host, port: where the server listens.
        public: the address of a proxy, if any.
    """
    if public is not None:
        return public.url
    # On "::" the socket is IPv6 only, and local addresses are IPv4.
    if not is_loopback(page.split("/")[2].lower()) or host != "0.0.0.0":
        return page
    return next((f"http://{address}:{port}/" for address in local_addresses()), page)


def page_addresses(host: str, port: int) -> list[str]:
    """Addresses of the page, that on this machine first."""
    # On "::" the socket is IPv6 only.
    names = ["127.0.0.1", *local_addresses()] if host == "0.0.0.0" else ["::1" if host == "::" else host]
    return [f"http://[{name}]:{port}" if ":" in name else f"http://{name}:{port}" for name in names]


def _machine_names() -> set[str]:
    name = socket.gethostname()
    names = {name, socket.getfqdn(), *local_addresses()}
    with contextlib.suppress(OSError):
        names |= {str(info[4][0]) for info in socket.getaddrinfo(name, None)}
    return names
