"""`softrod [SCENE]`: serves the page until a signal stops it."""

from __future__ import annotations

import asyncio
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
from sim.compiling.compiler import Compiler, cache_trouble, kept
from sim.model.system import build_system

from ..classroom.live import Classes
from ..features.classroom.check_role import CheckRole, is_check
from ..features.classroom.role import Role
from ..features.classroom.roles import (
    class_of_query,
    desk_address,
    desk_of_query,
    first_scene,
    is_class_page,
    role_of_query,
    seat_address,
    wall_address,
)
from ..gate.address import (
    PublicAddress,
    address_for_others,
    class_exposure,
    interfaces,
    is_virtual,
    local_addresses,
    public_address,
)
from ..gate.gate import CLASS, Connection, GatedServer, Visit, exposure, open_server, page_addresses
from ..linking import print_qr_code
from ..pages.check.page import check_address
from ..pages.classroom.tab import ClassTab
from ..pages.sandbox.assets import page_files, translated
from ..pages.sandbox.tab import Tab
from ..stage.colors import LIGHT_GAIN
from ..ui import owner
from ..ui.panel import set_theme
from ..wire.carrier import Mail
from ..wire.line import Line, flush
from ..words import speaking
from .ticker import Ticker

PAGES_OF_CLASS = 40
"""Pages by which the limit rises for each class after the first."""


class _Tabs:
    """Makes the tab of each page that connects; arguments as of `serving`.

    Attributes:
        server: set before the first page connects.
        ticker: of all tabs.
    """

    server: GatedServer

    def __init__(
        self, scene: sim.Scene, host: str, public: PublicAddress | None, classes: Classes, compiler: Compiler
    ) -> None:
        self._scene, self._host, self._public = scene, host, public
        self._classes, self._compiler = classes, compiler
        self._letters: set[Line] = set()
        self.ticker = Ticker(self.make, self.send_letters)

    def _for_others(self, page: str) -> str:
        """The address by which others reach a page."""
        return address_for_others(page, self._host, self.server.get_port(), self._public)

    def _begin_class(self, scene: sim.Scene) -> str:
        """Begin a class with a scene; the address of its desk."""
        return desk_address("", self._classes.begin((scene,)))

    def make(self, client: viser.ClientHandle) -> Tab:
        """The tab of a page of viser's: a sandbox, or a teacher's, as its address says."""
        visit = self.server.gate.visit(client.client_id)
        with speaking(visit.language):
            return self._tab(client, visit)

    def _tab(self, client: viser.ClientHandle, visit: Visit) -> Tab:
        gate = self.server.gate
        classroom = class_of_query(visit.query, self._classes)

        def role(mail: Mail) -> Role | None:
            download = partial(client.send_file_download, save_immediately=True)
            return desk_of_query(visit, mail, self._classes, self._base(visit), download, self._networks())

        first = (classroom and first_scene(classroom)) or self._scene
        begin = None if gate.loopback and self._public is None else self._begin_class
        return Tab(
            client, first, self._compiler, visit.query, visit.is_local, self._for_others, role, begin,
            self._classes.teach, visit.still,
        )  # fmt: skip

    def _base(self, visit: Visit) -> str:
        """The address by which others reach the server.

        With several networks, pupils are in the one that the teacher's page was opened in.
        """
        return self._for_others(f"http://{visit.host}/")

    def _networks(self) -> list[str]:
        """The addresses by which others may reach the server, if there are several."""
        if self._public is not None or self._host != "0.0.0.0":
            return []
        names = interfaces()
        port = self.server.get_port()
        real = [address for address in local_addresses() if not is_virtual(names.get(address, ""))]
        return [f"http://{address}:{port}/" for address in real] if len(real) > 1 else []

    def make_class_tab(self, line: Line, visit: Visit) -> ClassTab:
        """The tab of a page of a class, which is no teacher's."""
        with speaking(visit.language):
            return self._class_tab(line, visit)

    def _class_tab(self, line: Line, visit: Visit) -> ClassTab:
        classroom = class_of_query(visit.query, self._classes)
        if is_check(visit.query):
            check, rope = CheckRole(classroom), sim.load_scene("rope")
            return ClassTab(line, rope, self._compiler, lambda _: check, self._letters.add)

        def role(mail: Mail) -> Role:
            return role_of_query(visit, mail, self._classes, self._base(visit))

        first = (classroom and first_scene(classroom)) or self._scene
        return ClassTab(line, first, self._compiler, role, self._letters.add)

    def choose_page(self, path: str, query: str, is_local: bool) -> str:
        """Which page is sent: a class's to whoever is no teacher."""
        return CLASS if is_class_page(query, self._classes, is_local) else path

    def send_letters(self) -> None:
        """Send what waits for the pages of classes."""
        self._letters.difference_update([line for line in self._letters if not line.waits])
        flush(tuple(self._letters))

    async def hold(self, connection: Connection) -> None:
        """Talk with a page of a class until its connection ends."""
        line = Line(connection, asyncio.get_running_loop())
        visit = self.server.gate.visit_by(connection)
        self.ticker.come(line.number, lambda: self.make_class_tab(line, visit))
        try:
            await line.listen(lambda: self.ticker.hear(line.number))
        finally:
            self.ticker.go(line.number)


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
    """Run the server behind its gate, with its ticker, within a context; the compiler is not started.

    Args:
        scene: what a page shows first.
        host, port: where to listen; port 0 for any free one.
        embed: origins of the sites that may show the page in a frame, as in "https://school.example".
        allow_hosts: further names by which a browser may reach the server, as in "laptop.local".
        public_url: the address by which others reach the page, as in "https://school.example/lab/".
        classes: those that pages may come to. Without them every page stands alone until the owner begins a
            class in the gallery.

    Raises:
        GateError: the gate could not be installed, or an origin or address is none; nothing is served.
        PortBusy: another program listens on the port.
    """
    compiler = Compiler(kept())
    public = None if public_url is None else public_address(public_url)
    held = Classes(alone=False) if classes is None else classes
    tabs = _Tabs(scene, host, public, held, compiler)
    ticker = tabs.ticker
    # A page may leave in the middle of a frame; the rest of the frame then has no receiver.
    warnings.filterwarnings("ignore", message="Queued a .* on a closed connection")
    with _viser_is_quiet():
        server = tabs.server = open_server(
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
        gate = server.gate
        gate.heard, gate.choose, gate.hold = ticker.hear, tabs.choose_page, tabs.hold
        gate.translate = translated
        yield server, ticker, compiler
    finally:
        compiler.stop()
        ticker.stop()
        held.close()
        with _viser_is_quiet():
            server.stop()


@contextlib.contextmanager
def _viser_is_quiet() -> Iterator[None]:
    """Keep viser from printing its own panel of addresses."""
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
        scene, host, port, embed, allow_hosts, public_url, classes: see `serving`.

    Raises:
        GateError, PortBusy: see `serving`.
        InputError: the terminal cannot show a QR code.
    """
    console = Console()
    signals: list[int] = []
    for number in (signal.SIGINT, signal.SIGTERM):
        # Appends only: a second signal can arrive within this handler, and must find no lock.
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
        printed = 0
        while True:
            for sentence in server.gate.advice[printed:]:
                printed += 1
                text = f"A page was refused. {' '.join(sentence.split())}"
                console.print(text, style="yellow", highlight=False, markup=False, soft_wrap=True)
            if signals:
                break
            time.sleep(0.1)
    console.print("softrod has ended.")


def start_compiling(scene: sim.Scene, ticker: Ticker, compiler: Compiler) -> None:
    """Start to compile in the background what a scene needs; pages ask for more as they need it."""
    # A page that comes soon is drawn first: both need the interpreter.
    ticker.drawn.wait(timeout=0.5)
    compiler.want_for(scene.integrator.method, build_system(scene).body)
    compiler.start()
    threading.Thread(target=_freeze_loaded_objects, args=(compiler,), daemon=True).start()


def _freeze_loaded_objects(compiler: Compiler) -> None:
    """Exempt modules and kernels from garbage collection once all are loaded.

    A collection over all of them takes a tenth of a second, during which every page stands still.
    """
    compiler.wait()
    gc.collect()
    gc.freeze()


def _set_stage(server: viser.ViserServer) -> None:
    """Set what all pages have: flat light, a distant camera, no axes."""
    scene = server.scene
    with server.atomic():
        scene.set_up_direction("+y")
        scene.world_axes.visible = False
        scene.configure_default_lights(enabled=False, cast_shadow=False)
        scene.configure_environment_map(None)
        scene.add_light_ambient("/light", intensity=math.pi * LIGHT_GAIN)
    # There is no orthographic camera; the page's script fits the distance to the window.
    camera = server.initial_camera
    camera.fov, camera.near, camera.far, camera.up = 0.1, 1.0, 2000.0, (0.0, 1.0, 0.0)
    camera.position, camera.look_at = (0.0, 0.0, 62.0), (0.0, 0.0, 0.0)
    set_theme(server.gui, dark=False)


def print_addresses(
    server: GatedServer, host: str, public_url: str | None, qr: bool, console: Console
) -> str:
    """Print where the page is; returns the owner's address, which is for nobody else."""
    port = server.get_port()
    address, *others = page_addresses(host, port)
    public = None if public_url is None else public_address(public_url)
    for_others = address_for_others(f"{address}/", host, port, public)
    if not server.gate.loopback:
        address = f"{address}/{owner.FRAGMENT}{owner.key()}"
    lines = [f"softrod is at [bold]{address}[/bold]  (Ctrl-C ends it)"]
    lines += [f"and, from other machines, at [bold]{other}[/bold]" for other in others]
    if public is not None:
        lines.append(f"and, for others, at [bold]{public.url}[/bold]")
    for line in lines:
        console.print(line, highlight=False)
    if qr:
        print_qr_code(for_others)
    if warning := exposure(host, public):
        console.print(f"[yellow]{warning}[/yellow]", highlight=False)
    return address


def print_class_addresses(
    server: GatedServer, host: str, public_url: str | None, classes: Classes, console: Console
) -> str:
    """Print how teachers and pupils come to each class; returns the first teacher's address."""
    port = server.get_port()
    public = None if public_url is None else public_address(public_url)
    own = f"{page_addresses(host, port)[0]}/"
    base = address_for_others(own, host, port, public)
    teachers = own if public is None else base
    for classroom in classes:
        code = classroom.room.code
        console.print(f"Class [bold]{code}[/bold]", highlight=False)
        for label, address in (
            ("the teacher, and nobody else", desk_address(teachers, classroom)),
            ("the wall", wall_address(teachers, code)),
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
    """The addresses besides `base` that other machines can reach, with the names of their interfaces."""
    names = interfaces()
    others = []
    for address in addresses[1:]:
        name = names.get(address.removeprefix("http://").rpartition(":")[0], "")
        if f"{address}/" != base and not is_virtual(name):
            others.append(f"{address} ({name})" if name else address)
    return " and ".join(others)


def _show_progress(compiler: Compiler, console: Console) -> None:
    """Show a progress bar if anything has to be compiled."""
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
