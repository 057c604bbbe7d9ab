"""`softrod [SCENE]`: serves the page until it is told to stop."""

from __future__ import annotations

import contextlib
import gc
import math
import signal
import threading
import time
import warnings
import webbrowser
from collections.abc import Iterator, Sequence
from functools import partial

import rich
import viser
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

import sim
from sim.compiling.compiler import Compiler, cache_trouble, needed_by

from ..classroom.live import Classes
from ..features.classroom.check_role import CheckRole, is_check
from ..features.classroom.role import Role
from ..features.classroom.roles import (
    class_of_query,
    desk_address,
    first_scene,
    role_of_query,
    seat_address,
    wall_address,
)
from ..gate.address import address_for_others, class_exposure, interfaces, is_virtual, public_address
from ..gate.gate import GatedServer, exposure, open_server, page_addresses
from ..linking import print_qr_code
from ..pages.check.page import check_address
from ..pages.sandbox.assets import page_files
from ..pages.sandbox.tab import Tab
from ..stage.colors import LIGHT_GAIN
from ..ui import owner
from ..ui.panel import set_theme
from ..wire.carrier import Mail
from .ticker import Ticker

PAGES_OF_CLASS = 40
"""Pages for which there is room beside the others, for each class after the first."""


@contextlib.contextmanager
def serving(
    scene: sim.Scene,
    host: str,
    port: int,
    embed: Sequence[str] = (),
    allow_hosts: Sequence[str] = (),
    public_url: str | None = None,
    classes: Classes | None = None,
) -> Iterator[tuple[GatedServer, Ticker, Compiler]]:
    """The server behind its gate, ticking, for as long as the context lasts; the compiler is not started.

    Args:
        scene: what a page shows first.
        host, port: where to listen; port 0 for any free one.
        embed: origins of the sites that may show the page in a frame, as in "https://school.example".
        allow_hosts: further names by which a browser may reach the server, as in "laptop.local".
        public_url: the address by which others reach the page, as in "https://school.example/lab/".
        classes: those that others may come to; without these, every page is one of its own until the owner
            begins a class in the gallery.

    Raises:
        GateError: the gate could not be put in place, or an origin or address is none; nothing is served.
        PortBusy: something else listens on the port.
    """
    compiler = Compiler()
    held = Classes(alone=False) if classes is None else classes

    public = None if public_url is None else public_address(public_url)

    def for_others(page: str) -> str:
        return address_for_others(page, host, server.get_port(), public)

    def make_tab(client: viser.ClientHandle) -> Tab:
        gate, client_id = server.gate, client.client_id
        query, owned = gate.query_of(client_id), gate.is_local(client_id)
        klass = class_of_query(query, held)
        if is_check(query):
            check = CheckRole(klass)
            return Tab(client, sim.load_scene("rope"), compiler, "", owned, for_others, lambda _: check)
        # What the teacher's page is in is the pupils' network, where there are several.
        base = for_others(f"http://{gate.host_of(client_id)}/")

        def role(mail: Mail) -> Role | None:
            download = partial(client.send_file_download, save_immediately=True)
            return role_of_query(query, mail, held, base, owned, gate.visitor_of(client_id), download)

        def begin_class(scene: sim.Scene) -> str:
            return desk_address("", held.begin((scene,)))

        first = (klass and first_scene(klass)) or scene
        begin = None if gate.loopback and public is None else begin_class
        return Tab(client, first, compiler, query, owned, for_others, role, begin, held.go_through)

    ticker = Ticker(make_tab)

    # A page can go away in the middle of a frame; the rest of that frame has nobody to go to.
    warnings.filterwarnings("ignore", message="Queued a .* on a closed connection")
    with _viser_is_quiet():
        server = open_server(
            host,
            port,
            label="softrod",
            extra_hosts=allow_hosts,
            files=page_files(),
            embed=embed,
            public_url=public_url,
            more_tabs=0 if classes is None else PAGES_OF_CLASS * max(0, len(list(classes)) - 1),
        )
    try:
        _set_stage(server)
        ticker.attach(server)
        server.gate.heard = ticker.hear
        yield server, ticker, compiler
    finally:
        compiler.stop()
        ticker.stop()
        held.close()
        with _viser_is_quiet():
            server.stop()


@contextlib.contextmanager
def _viser_is_quiet() -> Iterator[None]:
    """Keep viser from printing an address panel of its own, in a terminal or in a notebook."""
    console = rich.get_console()
    before, console.quiet = console.quiet, True
    try:
        yield
    finally:
        console.quiet = before


def serve(
    scene: sim.Scene,
    host: str,
    port: int,
    open_browser: bool,
    embed: Sequence[str] = (),
    allow_hosts: Sequence[str] = (),
    public_url: str | None = None,
    qr: bool = False,
    classes: Classes | None = None,
) -> None:
    """Serve until Ctrl-C or SIGTERM.

    Args:
        open_browser: whether to open the page in a browser.
        qr: whether to print the QR code of the address by which others reach the page.
        scene, host, port, embed, allow_hosts, public_url, classes: as of `serving`.

    Raises:
        GateError, PortBusy: as `serving`.
        InputError: the terminal cannot show a QR code.
    """
    console = Console()
    signals: list[int] = []
    for number in (signal.SIGINT, signal.SIGTERM):
        # Only an append: a second signal can come in the middle of this handler, and must find no lock.
        signal.signal(number, lambda number, _: signals.append(number))
    with serving(scene, host, port, embed, allow_hosts, public_url, classes) as (server, ticker, compiler):
        if classes is None:
            address = print_addresses(server, host, public_url, qr, console)
        else:
            address = print_class_addresses(server, host, public_url, classes, console)
        if open_browser:
            webbrowser.open(address)
        start_compiling(scene, ticker, compiler)
        threading.Thread(target=_show_progress, args=(compiler, console), daemon=True).start()
        told = 0
        while True:
            for sentence in server.gate.advice[told:]:
                told += 1
                said = f"A page was refused. {' '.join(sentence.split())}"
                console.print(said, style="yellow", highlight=False, markup=False, soft_wrap=True)
            if signals:
                break
            time.sleep(0.1)
    console.print("softrod has ended.")


def start_compiling(scene: sim.Scene, ticker: Ticker, compiler: Compiler) -> None:
    """Have everything compiled, what a scene needs first; returns when that has begun."""
    # The first page is drawn first, if it comes soon: both want the interpreter.
    ticker.drawn.wait(timeout=0.5)
    compiler.want(needed_by(scene.integrator.method))
    compiler.start()
    threading.Thread(target=_keep_what_is_loaded, args=(compiler,), daemon=True).start()


def _keep_what_is_loaded(compiler: Compiler) -> None:
    """Spare the garbage collector what stays until the end: modules and kernels.

    A look over all of them takes a tenth of a second, in which every page stands still.
    """
    compiler.wait()
    gc.collect()
    gc.freeze()


def _set_stage(server: viser.ViserServer) -> None:
    """What every page has: flat light, a flat camera far away, no axes."""
    scene = server.scene
    with server.atomic():
        scene.set_up_direction("+y")
        scene.world_axes.visible = False
        scene.configure_default_lights(enabled=False, cast_shadow=False)
        scene.configure_environment_map(None)
        scene.add_light_ambient("/light", intensity=math.pi * LIGHT_GAIN)
    # The page's script fits the distance to the window; there is no orthographic camera.
    camera = server.initial_camera
    camera.fov, camera.near, camera.far, camera.up = 0.1, 1.0, 2000.0, (0.0, 1.0, 0.0)
    camera.position, camera.look_at = (0.0, 0.0, 62.0), (0.0, 0.0, 0.0)
    set_theme(server.gui, dark=False)


def print_addresses(
    server: GatedServer, host: str, public_url: str | None, qr: bool, console: Console
) -> str:
    """Say where the page is; returns the owner's address, which is for nobody else."""
    port = server.get_port()
    address, *others = page_addresses(host, port)
    public = None if public_url is None else public_address(public_url)
    for_others = address_for_others(f"{address}/", host, port, public)
    if not server.gate.loopback:
        address = f"{address}/{owner.FRAGMENT}{owner.key()}"
    console.print(f"softrod is at [bold]{address}[/bold]  (Ctrl-C ends it)", highlight=False)
    for other in others:
        console.print(f"and, from other machines, at [bold]{other}[/bold]", highlight=False)
    if public is not None:
        console.print(f"and, for others, at [bold]{public.url}[/bold]", highlight=False)
    if qr:
        print_qr_code(for_others)
    warning = exposure(host, public)
    if warning:
        console.print(f"[yellow]{warning}[/yellow]", highlight=False)
    return address


def print_class_addresses(
    server: GatedServer, host: str, public_url: str | None, classes: Classes, console: Console
) -> str:
    """Say how teachers and pupils come to each class; returns the first teacher's address."""
    port = server.get_port()
    public = None if public_url is None else public_address(public_url)
    own = f"{page_addresses(host, port)[0]}/"
    base = address_for_others(own, host, port, public)
    for klass in classes:
        code = klass.room.code
        console.print(f"Class [bold]{code}[/bold]", highlight=False)
        for label, address in (
            ("the teacher, and nobody else", desk_address(own if public is None else base, klass)),
            ("the wall", wall_address(own if public is None else base, code)),
            ("pupils", seat_address(base, code)),
            ("before the class, your phone", check_address(base, code)),
        ):
            console.print(f"  {label}: [bold]{address}[/bold]", highlight=False, soft_wrap=True)
        if base != own or public is not None:
            print_qr_code(seat_address(base, code))
    if public is None and (others := _other_networks(base, page_addresses(host, port))):
        console.print(
            f"This computer is in other networks, too, as {others}. If pupils are in one of those, open the "
            "teacher's page and the wall there: their QR codes name the address that they were opened at.",
            highlight=False,
        )
    console.print(f"[yellow]{class_exposure(host, public)}[/yellow]", highlight=False)
    return desk_address(own, next(iter(classes)))


def _other_networks(base: str, addresses: Sequence[str]) -> str:
    """What can be typed besides `base` from other machines, with the names of the networks' interfaces."""
    names = interfaces()
    others = []
    for address in addresses[1:]:
        name = names.get(address.removeprefix("http://").rpartition(":")[0], "")
        if f"{address}/" != base and not is_virtual(name):
            others.append(f"{address} ({name})" if name else address)
    return " and ".join(others)


def _show_progress(compiler: Compiler, console: Console) -> None:
    """A progress bar, where anything has to be compiled."""
    compiler.wait(timeout=2.0)
    ready, of = compiler.progress
    if ready == of or not compiler.compiles:
        return
    if trouble := cache_trouble():
        console.print(f"[yellow]The solver is {trouble}.[/yellow]", highlight=False, soft_wrap=True)
    columns = (TextColumn("compiling {task.description}"), BarColumn(), TimeElapsedColumn())
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("the solver (once)", total=of)
        while ready < of and compiler.busy_with:
            progress.update(task, completed=ready, description=compiler.busy_with)
            compiler.wait(timeout=0.5)
            ready, of = compiler.progress
