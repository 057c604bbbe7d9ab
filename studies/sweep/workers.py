"""Workers: this process, others of this machine or a cluster, all with the interface of
`concurrent.futures`."""

from __future__ import annotations

import concurrent.futures
import logging
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from sim.errors import InputError

MAX_AHEAD = 1000
"""Calls submitted at a time: more than there are workers, and no more than fit in memory."""

CONNECT_TIMEOUT = 10
"""Seconds in which a scheduler must answer."""


class Call(NamedTuple):
    """Something to compute elsewhere.

    Attributes:
        key: known only here; comes back with the result.
        function, arguments: what is computed.
    """

    key: Any
    function: Callable[..., Any]
    arguments: tuple[Any, ...]


@dataclass(frozen=True)
class Workers:
    """A pool of workers.

    Attributes:
        executor: takes the calls.
        ahead: calls to submit at a time.
        failures: exceptions after which no more results can come, and what they mean.
    """

    executor: concurrent.futures.Executor
    ahead: int = MAX_AHEAD
    failures: Mapping[type[BaseException], str] = field(
        default_factory=lambda: {concurrent.futures.BrokenExecutor: "a worker was lost"}
    )

    def compute(self, next_call: Callable[[], Call | None]) -> Iterator[tuple[Any, Any]]:
        """Do calls as long as there are any, several at a time.

        Args:
            next_call: returns the next call, or None where there is none until others are done.

        Yields:
            Key and result of each call, in the order in which they are done.
        """
        running: dict[concurrent.futures.Future[Any], Any] = {}
        while True:
            while len(running) < self.ahead and (call := next_call()) is not None:
                running[self.executor.submit(call.function, *call.arguments)] = call.key
            if not running:
                return
            done, _ = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for future in done:
                yield running.pop(future), future.result()

    @contextmanager
    def losing(self, command: str) -> Iterator[None]:
        """Turn the loss of workers into an error of one sentence.

        Raises:
            InputError: no more results can come.
        """
        try:
            yield
        except tuple(self.failures) as error:
            what = next(text for kind, text in self.failures.items() if isinstance(error, kind))
            if reason := " ".join(str(error).split()):
                what += f" ({reason})"
            raise InputError(
                f"{command}: {what}; what is done is kept, and the same command goes on"
            ) from None


MakeWorkers = Callable[[], AbstractContextManager[Workers]]


class _Here(concurrent.futures.Executor):
    """Does each call at once, in this thread."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> concurrent.futures.Future[Any]:
        done: concurrent.futures.Future[Any] = concurrent.futures.Future()
        try:
            done.set_result(fn(*args, **kwargs))
        except Exception as error:
            done.set_exception(error)
        return done


@contextmanager
def this_process() -> Iterator[Workers]:
    """Yield this process as the only worker: each call is done before the next is submitted."""
    yield Workers(_Here(), ahead=1)


@contextmanager
def processes(jobs: int) -> Iterator[Workers]:
    """Yield processes of this machine, which end with this context, whatever they are doing."""
    others = set(multiprocessing.active_children())
    # Not by fork, which is not safe while the progress bar has a thread.
    pool = concurrent.futures.ProcessPoolExecutor(
        jobs, multiprocessing.get_context("spawn"), initializer=_begin
    )
    try:
        yield Workers(pool)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in set(multiprocessing.active_children()) - others:
            process.terminate()


def _begin() -> None:
    """Ignore Ctrl-C, which the parent handles, and end when the parent ends, for whatever reason."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    assert parent is not None
    threading.Thread(target=lambda: (parent.join(), os._exit(1)), daemon=True).start()


@contextmanager
def cluster(address: str) -> Iterator[Workers]:
    """Yield the workers of a Dask scheduler.

    They may come and go: the scheduler gives the work of a lost one to others.

    Raises:
        InputError: Dask is not installed, or no scheduler answers at the address.
    """
    try:
        from distributed import Client, KilledWorker
        from distributed.client import ClosedClientError
    except ImportError:
        raise InputError(
            "--cluster needs Dask; uv sync --extra cluster, or pip install 'softrod[cluster]', installs it"
        ) from None
    try:
        client = Client(address, timeout=CONNECT_TIMEOUT, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        reason = str(error).partition("\n")[0]
        raise InputError(f"--cluster {address}: no scheduler answers ({reason})") from None
    gone = "the connection to the scheduler is lost"
    unfit = "a worker cannot do it"
    failures = {
        concurrent.futures.CancelledError: gone,
        ClosedClientError: gone,
        KilledWorker: "several workers were lost over the same run",
        ImportError: unfit,
        OSError: unfit,
    }
    # They would write tracebacks of their own when the scheduler goes.
    for name in ("distributed.client", "distributed", "tornado.application", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    with client:
        yield Workers(client.get_executor(pure=False), failures=failures)
