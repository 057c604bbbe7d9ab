"""Keeps track of the kernels that are compiled, and compiles them in the background, in other processes.

Every kernel that is called from Python, or through its address, is an entry point with one signature. Entry
points are compiled and cached on disk separately. One is ready when its machine code is loaded in this
process, whatever files there are.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from numba import types

from ..engine.addresses import ADDRESSES, address_of
from ..engine.calls import FLOATS, INDIRECT_CALLS
from ..engine.kept import file_of, trouble
from ..engine.tables import Body, PrescribedMotion, Problem, State
from ..forces.all import (
    PARTS,
    accelerations,
    add_damping_product,
    any_accelerations,
    kink_fraction,
    parts_of,
    paths_of,
)
from ..forces.plasticity import commit_plasticity, event_fraction, yielding_accelerations
from ..forces.touch.contact import no_tunnelling
from ..forces.touch.friction_history import slip_fraction, update_friction_history
from ..solve.balance.energies import energies
from ..solve.balance.work import accumulate_work
from ..solve.linear.implicit import factorise_matrix, solve_matrix
from ..solve.registry import AUTO_METHODS, METHODS
from ..solve.steps.auto import next_turn
from ..solve.steps.fallback import run_fallback
from ..text import Text

_FLOAT, _INT = types.float64, types.int64

_CALLED = {
    **INDIRECT_CALLS,
    "yielding_accelerations": INDIRECT_CALLS["accelerations"],
    **{part.name: part.signature for part in PARTS},
}
"""Signatures of the kernels that are called through their addresses."""

# Unless noted, doubling or halving one of these numbers fails no test.
_MAX_HELPERS = 2
"""Number of processes that compile at a time: with two cores, two are nearly twice as fast as one."""

_PATIENCE = 5.0
"""Seconds for which `stop` waits for what is being loaded."""


@dataclass(frozen=True)
class EntryPoint:
    """A kernel that is called from Python or through its address.

    Attributes:
        name: name of the kernel.
        label: what it is, for people.
        kernel: numba's dispatcher of the kernel.
        signature: the types of its arguments.
        number: in `ADDRESSES`, of a kernel of forces; else -1.
    """

    name: str
    label: str
    kernel: Any
    signature: tuple[types.Type, ...]
    number: int = -1

    @property
    def ready(self) -> bool:
        """Whether its machine code is loaded."""
        is_loaded = self.signature in self.kernel.overloads
        # A body that is moved by another thread calls a kernel of forces by its address.
        return is_loaded and (self.number < 0 or bool(ADDRESSES[self.number]))

    def load(self) -> None:
        """Load its machine code from the disk, or compile it."""
        self.kernel.compile(self.signature)
        if self.number >= 0:
            ADDRESSES[self.number] = self.address

    @cached_property
    def call(self) -> Callable[..., Any]:
        """Its machine code, which is loaded by now, as a function for Python.

        It takes arguments of exactly its signature. The kernel itself would look up their types in every
        call, in more time than a step of a short body takes.
        """
        return self.kernel.overloads[self.signature].entry_point

    @cached_property
    def address(self) -> int:
        """The address of its machine code, if it is called through that."""
        return address_of(self.kernel, _CALLED[self.name])

    @property
    def file(self) -> Path | None:
        """The file that has its machine code, once that was compiled; None where nothing can be kept."""
        return file_of(self.kernel, self.signature)


def _entry_points() -> dict[str, EntryPoint]:
    problem, drive = Problem.numba_type, PrescribedMotion.numba_type
    run = (problem, drive, _FLOAT, _FLOAT, _INT)
    # In the order in which they are needed: those that `auto` uses come first.
    methods = sorted(METHODS.values(), key=lambda method: method not in AUTO_METHODS)

    def by_address(label: str, kernel: Any) -> tuple[str, Any, tuple[types.Type, ...]]:
        return label, kernel, INDIRECT_CALLS[kernel.py_func.__name__].args

    points = [
        by_address(Text("the choice among forces"), accelerations),
        (Text("the choice of methods"), next_turn, (problem, _FLOAT, _FLOAT, _INT)),
        by_address(Text("matrices"), factorise_matrix),
        by_address(Text("linear systems"), solve_matrix),
        by_address(Text("damping in linear systems"), add_damping_product),
        (Text("the fallback step"), run_fallback, (problem, drive, *[_FLOAT] * 3)),
        *((method.label, method.kernel, run) for method in methods if method.kernel is not None),
        by_address(Text("the work done in a step"), accumulate_work),
        (Text("energies"), energies, (Body.numba_type, State.numba_type, *[FLOATS] * 4)),
        by_address(Text("steps with contact"), no_tunnelling),
        (Text("forces that yield"), yielding_accelerations, INDIRECT_CALLS["accelerations"].args),
        by_address(Text("limits of springs"), event_fraction),
        by_address(Text("where forces have kinks"), kink_fraction),
        by_address(Text("where friction begins to slide"), slip_fraction),
        by_address(Text("friction that holds"), update_friction_history),
        by_address(Text("yielding and breaking"), commit_plasticity),
    ]
    parts = [EntryPoint(p.name, p.label, p.kernel, p.signature.args, p.number) for p in PARTS]
    found = {point.name: point for point in parts}
    for label, kernel, signature in points:
        name = kernel.py_func.__name__
        found.setdefault(name, EntryPoint(name, label, kernel, signature))
    return found


ENTRY_POINTS = _entry_points()
"""The entry points, by name."""

FOR_MATRICES = ("factorise_matrix", "solve_matrix", "add_damping_product")
"""Entry points that linear systems need, besides those of a body's forces."""

FOR_STICKING = ("slip_fraction", "update_friction_history")
"""Entry points that a body with tangential springs needs."""

FOR_DAMAGE = ("yielding_accelerations", "event_fraction", "commit_plasticity")
"""Entry points that a body needs which breaks or yields."""


def for_events(body: Body) -> tuple[str, ...]:
    """Names of the entry points that find, and carry out, what ends a body's steps."""
    kinks = parts_of(body, "kink_fraction")
    return (
        *(("no_tunnelling",) if body.environment.contact.present else ()),
        *(("kink_fraction", *kinks) if kinks else ()),
        *(FOR_STICKING if body.environment.sticks else ()),
        *(FOR_DAMAGE if body.limits.present else ()),
    )


def for_forces(body: Body) -> tuple[str, ...]:
    """Names of the entry points that compute a body's accelerations."""
    paths = paths_of(body)
    parts = parts_of(body, "add_forces") if paths[-1].kernel is any_accelerations else ()
    return *(path.name for path in paths), *parts


def for_matrices(body: Body) -> tuple[str, ...]:
    """Names of the entry points that its linear systems need."""
    return *FOR_MATRICES, *parts_of(body, "add_derivatives", "add_damping", "impact_time")


def for_balance(body: Body) -> tuple[str, ...]:
    """Names of the entry points that a search for an equilibrium needs."""
    return *for_forces(body), "accelerations", *for_matrices(body)


def for_fallback(body: Body) -> tuple[str, ...]:
    """Names of the entry points that a fallback step needs."""
    return *for_forces(body), *for_matrices(body), "run_fallback"


def for_energy(body: Body) -> tuple[str, ...]:
    """Names of the entry points that the energy balance needs."""
    return "energies", "accumulate_work", *parts_of(body, "add_forces", "energy", "add_power")


def needed_by(method: str, body: Body) -> tuple[str, ...]:
    """Names of the entry points by which a method moves a body; for `auto`, those that it needs to start."""
    info, forces = METHODS[method], (*for_forces(body), *for_events(body))
    if info.kernel is None:
        return *forces, AUTO_METHODS[0].kernel.py_func.__name__, "next_turn"
    return *forces, *(for_fallback(body) if info.implicit else ()), info.kernel.py_func.__name__


def all_of(method: str, body: Body, *others: str) -> tuple[str, ...]:
    """Names of all entry points that a run by a method, and then by others, may come to, with the energy
    balance."""
    chosen = [one.name for one in AUTO_METHODS] if METHODS[method].kernel is None else []
    needed = [name for one in (method, *chosen) for name in needed_by(one, body)]
    rest = [name for one in others for name in needed_by(one, body)]
    return tuple(dict.fromkeys((*needed, *for_balance(body), *for_fallback(body), *for_energy(body), *rest)))


def kept() -> tuple[str, ...]:
    """Names of the entry points that need not be compiled, as the disk has them."""
    return tuple(n for n, point in ENTRY_POINTS.items() if (file := point.file) and file.exists())


def fetch(names: Iterable[str]) -> None:
    """Make entry points ready, and wait until they are.

    What is not on the disk is compiled by another process, and loaded from there: LLVM may order the sums of
    a kernel in another way where its callees have just been compiled in the same process, and the bits of a
    run must not depend on that.
    """
    wanted = [ENTRY_POINTS[name] for name in names if not ENTRY_POINTS[name].ready]
    missing = [point.name for point in wanted if point.file is not None and not point.file.exists()]
    if missing:
        words = [sys.executable, "-m", "sim.compiling.precompile", *missing]
        # If it fails, this process compiles.
        subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    for point in wanted:
        point.load()


def cache_trouble() -> str:
    """Why machine code cannot be kept from one start to the next, in words; empty where it can."""
    reason = trouble()
    return reason and f"compiled anew at every start, since {reason}"


def is_ready(names: Iterable[str]) -> bool:
    """Whether all these entry points can be called without waiting for a compilation."""
    return all(ENTRY_POINTS[name].ready for name in names)


class Compiler:
    """Makes all entry points ready, one after another, in the background.

    What is on the disk is loaded. The rest is compiled by helper processes, which write their results to the
    disk, so that compiling does not block the interpreter of this process.

    Args:
        names: of the entry points to make ready, in that order, besides those that `want` adds.

    Attributes:
        compiles: whether anything had to be compiled, and not only loaded.
    """

    def __init__(self, names: Iterable[str] = tuple(ENTRY_POINTS)) -> None:
        self._lock = threading.Lock()
        self._waiting = list(names)
        self._names = set(self._waiting)
        self._busy: list[str] = []
        self._helpers: list[subprocess.Popen[str]] = []
        self._threads: list[threading.Thread] = []
        self._started = self._stopped = False
        self.compiles = False

    @property
    def progress(self) -> tuple[int, int]:
        """(number of entry points that are ready, number of those that are to be)."""
        with self._lock:
            names = tuple(self._names)
        return sum(ENTRY_POINTS[name].ready for name in names), len(names)

    @property
    def busy_with(self) -> str:
        """Label of what is being compiled; empty if nothing is."""
        busy = self._busy[:1]
        return ENTRY_POINTS[busy[0]].label if busy else ""

    def want(self, first: Iterable[str], then: Iterable[str] = ()) -> None:
        """Make entry points ready before all others; those in `then` after the others."""
        first, then = list(first), list(then)
        with self._lock:
            waiting = [name for name in self._waiting if name not in first]
            new = [name for name in dict.fromkeys((*first, *then)) if name not in self._names]
            self._names.update(new)
            front = [name for name in first if name in new or name in self._waiting]
            self._waiting = [*front, *waiting, *(name for name in new if name not in first)]
        if self._started:
            self._run_threads()

    def want_for(self, method: str, body: Body) -> None:
        """Make ready what moves a body by a method, and then what it may come to by any method."""
        self.want(needed_by(method, body), all_of(method, body, *METHODS))

    def start(self) -> None:
        """Start making entry points ready."""
        self._started = True
        self._run_threads()

    def _run_threads(self) -> None:
        """Have as many threads at work as there is use for."""
        with self._lock:
            at_work = [thread for thread in self._threads if thread.is_alive()]
            helpers = min(_MAX_HELPERS, os.cpu_count() or 1, len(at_work) + len(self._waiting))
            new = [threading.Thread(target=self._run, daemon=True) for _ in range(helpers - len(at_work))]
            self._threads = [*at_work, *new]
            for thread in new:
                thread.start()

    def wait(self, timeout: float | None = None) -> None:
        """Wait until everything is ready or `stop` is called, at most for a timeout (s)."""
        end = None if timeout is None else time.monotonic() + timeout
        for thread in tuple(self._threads):
            thread.join(None if end is None else max(0.0, end - time.monotonic()))

    def stop(self) -> None:
        """Stop compiling."""
        self._stopped = True
        for helper in self._helpers:
            helper.terminate()
        self.wait(timeout=_PATIENCE)  # a thread in the middle of LLVM would not survive the interpreter

    def _run(self) -> None:
        """Make one entry point after another ready, with a helper where something has to be compiled."""
        helper: subprocess.Popen[str] | None = None
        while not self._stopped and (name := self._take()) is not None:
            point = ENTRY_POINTS[name]
            file = point.file
            if file is None:
                self.compiles = True  # here, since a helper could not hand it over
            elif not file.exists():
                self.compiles = True
                helper = helper or self._new_helper()
                _ask(helper, name)
            if not self._stopped:
                point.load()
            with self._lock:
                self._busy.remove(name)
        if helper is not None and helper.stdin is not None:
            with contextlib.suppress(OSError):
                helper.stdin.close()
            helper.wait()

    def _take(self) -> str | None:
        with self._lock:
            if not self._waiting:
                return None
            name = self._waiting.pop(0)
            self._busy.append(name)
            return name

    def _new_helper(self) -> subprocess.Popen[str]:
        words = [sys.executable, "-m", "sim.compiling.precompile"]
        helper = subprocess.Popen(
            words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        self._helpers.append(helper)
        return helper


def _ask(helper: subprocess.Popen[str], name: str) -> None:
    """Let a helper compile an entry point, and wait until it is done or the helper has ended."""
    assert helper.stdin is not None and helper.stdout is not None
    with contextlib.suppress(OSError):  # if the helper has ended, this process compiles
        helper.stdin.write(f"{name}\n")
        helper.stdin.flush()
        helper.stdout.readline()
