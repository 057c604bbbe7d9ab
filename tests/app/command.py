"""The command line, as a user runs it; the fixture `softrod` runs it in a test."""

from __future__ import annotations

import csv
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from app.cli.main import main

Result = subprocess.CompletedProcess[str]
Softrod = Callable[..., Result]


def softrod_here(capsys: pytest.CaptureFixture[str], *words: object) -> Result:
    """Run the command to its end, in this process, without the second that a new one takes to start."""
    capsys.readouterr()
    with pytest.raises(SystemExit) as ended:
        main([*map(str, words)])
    said = capsys.readouterr()
    assert isinstance(ended.value.code, int)
    return Result([*map(str, words)], ended.value.code, said.out, said.err)


def refused(result: Result, *fragments: str) -> None:
    """One clear sentence on the error stream, no traceback, status 1."""
    assert result.returncode == 1
    assert "Traceback" not in result.stderr
    assert result.stderr.startswith("softrod: ")
    assert result.stderr.count("\n") == 1
    for fragment in fragments:
        assert fragment in result.stderr


def rows_of(path: Path) -> list[list[str]]:
    with path.open(newline="") as file:
        return list(csv.reader(file))
