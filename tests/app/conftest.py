"""What tests of the page and the command line have in common."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from app.classroom import kept
from sim.store import files
from tests.app.command import Softrod, softrod_here
from tests.app.hostile import Sandbox


@pytest.fixture
def softrod(capsys: pytest.CaptureFixture[str]) -> Softrod:
    """The command, which runs in this process."""
    return partial(softrod_here, capsys)


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of a user's own scenes, in which there are none yet."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    folder = files.user_folder()
    folder.mkdir(parents=True)
    return folder


@pytest.fixture
def class_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of classes, in which there are none yet."""
    monkeypatch.setattr(kept, "classes_folder", lambda: tmp_path / "classes")
    return tmp_path / "classes"


@pytest.fixture
def sandbox() -> Iterator[Sandbox]:
    """A server behind its gate, and its users."""
    sandbox = Sandbox()
    yield sandbox
    sandbox.close()
