"""The image for a school's server: who it runs as, what it writes, how it ends."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from sim.compiling.compiler import ENTRY_POINTS, fetch
from tests.amount import NIGHT
from tests.container import ROOT, Builder, Image, instructions, permitted, running

TEXT = (ROOT / "Dockerfile").read_text(encoding="utf-8")
_CACHE = "/fetched"
"""Where the steps find what uv has fetched on this machine."""

_FILES = (
    "Dockerfile",
    ".dockerignore",
    "pyproject.toml",
    "tests/container.py",
    "tests/app/test_container.py",
)
"""What the image is made of, beside the packages."""


def changed() -> bool:
    """Whether one of the files differs from the last commit but one, or git cannot tell."""
    words = ["git", "diff", "--quiet", "HEAD~1", "--", *_FILES]
    return subprocess.run(words, cwd=ROOT, capture_output=True, check=False).returncode != 0


def test_it_has_one_port_one_volume_and_nobodys_rights() -> None:
    _, *_, last = TEXT.split("\nFROM ")
    found = instructions(f"FROM {last}")
    words = [word for word, _ in found]
    said = dict(found)
    assert words.count("EXPOSE") == words.count("VOLUME") == 1
    assert said["USER"] not in ("root", "0")
    assert words.index("USER") < words.index("ENTRYPOINT")
    # Without a shell in between, which would keep the signals for itself.
    assert json.loads(said["ENTRYPOINT"]) == ["softrod"]
    assert json.loads(said["CMD"]) == ["--host", "0.0.0.0", "--no-open"]
    assert f"127.0.0.1:{said['EXPOSE']}/" in said["HEALTHCHECK"]


@pytest.fixture(scope="module")
def image() -> Iterator[Image]:
    """The image, but that by day less is compiled."""
    if not (NIGHT or changed()):
        pytest.skip("the image is built by night, and after an edit of its files")
    if not permitted():
        pytest.skip("the steps of a Dockerfile need namespaces, which this user may not make")
    uv = os.environ.get("UV") or shutil.which("uv")
    assert uv is not None
    cache = subprocess.run([uv, "cache", "dir"], capture_output=True, text=True, check=True).stdout.strip()
    # How packages are fetched on this machine.
    fetching = re.compile(r"(PIP|UV|SSL|HTTPS?|NO)_(?!CACHE_DIR)", re.IGNORECASE)
    env = {name: value for name, value in os.environ.items() if fetching.match(name)}
    env["UV_CACHE_DIR"] = _CACHE
    folder = Path(tempfile.mkdtemp(prefix="softrod-"))
    folder.chmod(0o755)

    def before(image: Image, command: str) -> None:
        if "precompile" in command and not NIGHT:
            fetch(ENTRY_POINTS)
            there = image.folder / "data" / ".cache" / "softrod" / "kernels"
            for point in ENTRY_POINTS.values():
                file = point.file
                assert file is not None
                shutil.copytree(file.parent, there / file.parent.name, dirs_exist_ok=True)
            owner = f"{image.user}:{image.user}"
            subprocess.run(["chown", "-R", owner, image.folder / "data" / ".cache"], check=True)
            there.chmod(0o700)

    quick = TEXT
    if not NIGHT:
        # The bytecode of all packages takes a minute, of what is imported some seconds.
        imported = "RUN python -c 'import app.cli.main, app.server.serve'\nWORKDIR /data"
        quick = TEXT.replace("UV_COMPILE_BYTECODE=1 ", "").replace("WORKDIR /data", imported)
    try:
        yield Builder(quick, folder, {Path(cache): _CACHE}, env).build(before)
    finally:
        shutil.rmtree(folder)


def kept(image: Image) -> set[str]:
    return {file.name for file in image.volume.rglob("*.nbc")}


def test_it_serves_from_a_read_only_root_and_ends_when_it_is_told(image: Image) -> None:
    compiled = kept(image)
    assert len(compiled) >= len(ENTRY_POINTS)
    with running(image) as container:
        container.wait_until_well()
        # It listens at every address, of which this is another one.
        other = [word.replace("127.0.0.1", "127.0.0.2") for word in image.health]
        assert container.ask(other).returncode == 0
        status = Path(f"/proc/{container.first}/status").read_text()
        assert f"Uid:\t{image.user}\t" in status
        for place in ("/opt/softrod/x", "/x", "/usr/x"):
            assert "Read-only" in container.ask(["sh", "-c", f"echo x >> {place}"]).stderr, place
        done = container.ask(["softrod", "run", "rope", "--steps", "5", "--out", "/data/rope.csv"])
        assert done.returncode == 0, done.stderr
        assert container.stop() == 0
    assert (image.volume / "rope.csv").exists()
    assert kept(image) == compiled, "what the image had compiled was not found"


def test_it_holds_a_class_and_keeps_it_in_the_volume(image: Image) -> None:
    with running(image, "class", "lesson-hooke", "--host", "0.0.0.0", "--no-open") as container:
        container.wait_until_well()
        assert container.stop() == 0
        assert container.process.stdout is not None
        code = re.search(r"Class ([A-Z]{4})", container.process.stdout.read())
    assert code is not None
    assert list(image.volume.rglob(f"*{code[1]}*")), "the class is in the volume"
