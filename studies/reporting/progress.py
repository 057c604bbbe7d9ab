"""A progress bar around something long, which Ctrl-C ends without an error."""

from __future__ import annotations

from types import TracebackType

from rich.console import Console, RenderableType
from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn


class ProgressBar:
    """A progress bar; a context manager.

    Args:
        console: where it is shown.
        total: parts of the work.

    Attributes:
        interrupted: whether Ctrl-C ended it.
    """

    def __init__(self, console: Console, total: float) -> None:
        columns = (SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
        self._bar = Progress(*columns, console=console, transient=True)
        self._task = self._bar.add_task("", total=total)
        self.interrupted = False

    def __enter__(self) -> ProgressBar:
        self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        self._bar.stop()
        self.interrupted = isinstance(error, KeyboardInterrupt)
        return self.interrupted

    def say(self, what: str, done: float | None = None, total: float | None = None) -> None:
        """Show what is being done and, if given, how many parts of how many are done."""
        self._bar.update(self._task, description=what, completed=done, total=total)

    def advance(self, parts: float = 1.0) -> None:
        """Count more parts as done."""
        self._bar.advance(self._task, parts)

    def print(self, shown: RenderableType) -> None:
        """Print something above the bar, and an empty line."""
        self._bar.console.print(shown)
        self._bar.console.print()
