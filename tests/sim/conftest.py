"""Fixtures that several test files need."""

from __future__ import annotations

from pathlib import Path

import pytest

from sim import Simulation
from sim.store.files import user_folder
from tests.sim.builders import askew


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the user's scenes, in a data folder of the test's own."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    if tmp_path not in user_folder().parents:
        pytest.skip("this platform keeps data elsewhere than XDG_DATA_HOME says")
    return user_folder()


@pytest.fixture
def rope() -> Simulation:
    """A rope in which everything moves."""
    return Simulation(askew())
