"""What Docker does with a Dockerfile, without Docker: its steps run in a folder that is their root.

The base image is this machine's `/usr`, with the Python of the tests at `/usr/local`, where Python's own
images have theirs. Each step has mounts and processes of its own, by `unshare`; what the finished image runs
has a network of its own, too, and a read-only root.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]

_ETC = ("hosts", "ld.so.cache", "localtime", "login.defs", "nsswitch.conf", "pip.conf", "resolv.conf", "ssl")
"""What the steps need of this machine's `/etc`; its users stay outside."""

PATIENCE = 120.0
"""Seconds within which an image must do as it is told; only one that does not lets a test wait."""

_PATH = "/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin"

_LO_UP = (
    "import fcntl, socket, struct; "
    "fcntl.ioctl(socket.socket(), 0x8914, struct.pack('16sh', b'lo', 0x41))  # SIOCSIFFLAGS: up, running"
)


def permitted() -> bool:
    """Whether this user may make what a container needs."""
    # Where this machine is a container itself, some of it may be refused.
    mounts = "mount --make-rprivate / && mount -t tmpfs tmpfs /tmp && mount -t proc proc /proc"
    words = ["unshare", "--mount", "--pid", "--net", "--fork", "/bin/sh", "-c", mounts]
    try:
        return os.geteuid() == 0 and subprocess.run(words, capture_output=True, check=False).returncode == 0
    except OSError:  # there is no such program
        return False


def instructions(text: str) -> list[tuple[str, str]]:
    """The instructions of a Dockerfile, as (word, rest)."""
    lines = re.sub(r"\\\n", " ", re.sub(r"^\s*#.*\n", "", text, flags=re.MULTILINE)).splitlines()
    pairs = [line.strip().partition(" ") for line in lines if line.strip()]
    return [(word.upper(), " ".join(rest.split())) for word, _, rest in pairs]


@dataclass
class Image:
    """What the steps have made so far.

    Attributes:
        folder: its root.
        env: its environment variables.
        user: who runs what comes, by number.
        workdir: where.
        rest: the instructions that say how it is run, by their words.
    """

    folder: Path
    env: dict[str, str] = field(default_factory=lambda: {"PATH": _PATH})
    user: int = 0
    workdir: str = "/"
    rest: dict[str, str] = field(default_factory=dict)

    def command(self, *words: str) -> list[str]:
        """What it does when it is started, or with other words for those of CMD."""
        return [*json.loads(self.rest["ENTRYPOINT"]), *(words or json.loads(self.rest["CMD"]))]

    @property
    def health(self) -> list[str]:
        """What tells whether it is well."""
        return json.loads(self.rest["HEALTHCHECK"].partition("CMD ")[2])

    @property
    def volume(self) -> Path:
        """Where the volume is outside."""
        return self.folder / self.rest["VOLUME"].strip("/")


class Builder:
    """Follows a Dockerfile.

    Args:
        text: the Dockerfile.
        folder: for the images; others must be able to look into it.
        caches: folders of this machine that steps find at another place, so that they need not fetch again.
        env: variables that steps have besides.
    """

    def __init__(self, text: str, folder: Path, caches: dict[Path, str], env: dict[str, str]) -> None:
        self._text, self._folder, self._caches, self._env = text, folder, caches, env
        self._stages: dict[str, Image] = {}

    def build(self, before: Any = lambda image, command: None) -> Image:
        """The last image. `before` is told of each RUN."""
        image: Image | None = None
        for word, rest in instructions(self._text):
            if word == "FROM":
                name = rest.partition(" AS ")[2] or "last"
                image = self._stages[name] = Image(_base(self._folder / name))
                continue
            assert image is not None
            if word == "RUN":
                before(image, rest)
                self._run(image, rest)
            elif word == "COPY":
                self._copy(image, shlex.split(rest))
            elif word == "ENV":
                for pair in shlex.split(rest):
                    name, _, value = pair.partition("=")
                    image.env[name] = value.replace("$PATH", image.env["PATH"])
            elif word == "WORKDIR":
                image.workdir = rest
                (image.folder / rest.strip("/")).mkdir(exist_ok=True)
            elif word == "USER":
                image.user = _users(image)[rest]
            else:
                assert word in ("VOLUME", "EXPOSE", "HEALTHCHECK", "ENTRYPOINT", "CMD"), word
                image.rest[word] = rest
        assert image is not None
        return image

    def _run(self, image: Image, command: str) -> None:
        places = ((here, f"{image.folder}{place}") for here, place in self._caches.items())
        mounts = [f"mkdir -p {place}; mount --bind {here} {place}" for here, place in places]
        words = _inside(image, ["/bin/sh", "-c", command], mounts, {**self._env, **image.env})
        done = subprocess.run(words, capture_output=True, text=True, timeout=1800, check=False)
        assert done.returncode == 0, f"RUN {command}\n{done.stdout}{done.stderr}"

    def _copy(self, image: Image, words: list[str]) -> None:
        source, target = words[-2:]
        there = image.folder / (target if target.startswith("/") else f"{image.workdir}/{target}").strip("/")
        if words[0].startswith("--from="):
            origin = self._stages[words[0].removeprefix("--from=")].folder / source.strip("/")
            subprocess.run(["cp", "-al", origin, there], check=True)
            return
        assert source == "."
        for name in allowed():
            copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
            copy(ROOT / name, there / name)


def allowed() -> list[str]:
    """What `.dockerignore` lets in."""
    lines = (ROOT / ".dockerignore").read_text(encoding="utf-8").splitlines()
    assert "*" in lines
    return [line[1:] for line in lines if line.startswith("!")]


def _base(folder: Path) -> Path:
    """The root of a new image."""
    for name in ("etc", "usr", "proc", "dev", "tmp", "var/tmp", "root", "opt", "local/bin"):
        (folder / name).mkdir(parents=True)
    (folder / "tmp").chmod(0o1777)
    for name in ("bin", "sbin", "lib", "lib64"):
        if Path("/", name).is_symlink():
            (folder / name).symlink_to(Path("/", name).readlink())
    for name in _ETC:
        here = Path("/etc", name)
        if here.is_dir():
            public = shutil.ignore_patterns("private")
            shutil.copytree(here, folder / "etc" / name, symlinks=True, ignore=public)
        elif here.exists():
            shutil.copy(here, folder / "etc" / name)
    (folder / "etc" / "passwd").write_text("root:x:0:0:root:/root:/bin/sh\n")
    (folder / "etc" / "group").write_text("root:x:0:\n")
    # Where this Python is the system's own, it is not called as in Python's images.
    (folder / "local" / "bin" / "python").symlink_to(Path(sys.executable).resolve())
    return folder


def _users(image: Image) -> dict[str, int]:
    lines = (image.folder / "etc" / "passwd").read_text().splitlines()
    return {line.split(":")[0]: int(line.split(":")[2]) for line in lines}


def _inside(
    image: Image, words: list[str], mounts: list[str], env: dict[str, str], *namespaces: str
) -> list[str]:
    """The command that runs another one in an image, as its user."""
    root, prefix = image.folder, sys.base_prefix
    variables = [f"{name}={value}" for name, value in env.items()]
    user = [f"--reuid={image.user}", f"--regid={image.user}", "--clear-groups", "--no-new-privs"]
    begin = ["chroot", str(root), "/usr/bin/env", "-i", "-C", image.workdir, *variables]
    script = [
        "set -e",
        "mount --make-rprivate /",
        f"mount --bind {root} {root}",
        f"mount --rbind /usr {root}/usr",
        f"mount --bind {f'{root}/local' if prefix == '/usr' else prefix} {root}/usr/local",
        # It may look for its own library where it was built to be.
        f"mkdir -p {root}{prefix}; mount --bind {prefix} {root}{prefix}",
        f"mount --rbind /dev {root}/dev",
        f"mount -t proc proc {root}/proc",
        *mounts,
        f"exec {shlex.join([*begin, 'setpriv', *user, *words])}",
    ]
    unshare = ["unshare", "--mount", "--pid", "--fork", "--kill-child", *namespaces]
    return [*unshare, "/bin/sh", "-c", "\n".join(script)]


class Running:
    """An image that runs, with a read-only root, a writable volume, and a network in which nobody else is."""

    def __init__(self, process: subprocess.Popen[str], image: Image) -> None:
        self.process, self._image = process, image

    def ask(self, words: list[str]) -> subprocess.CompletedProcess[str]:
        """Run something beside it, as `docker exec` does."""
        user = str(self._image.user)
        env = [f"{name}={value}" for name, value in self._image.env.items()]
        enter = ["nsenter", "--target", str(self.first), "--mount", "--net", "--pid", "--root"]
        who = [
            "/usr/bin/env",
            "-i",
            "-C",
            self._image.workdir,
            *env,
            "setpriv",
            f"--reuid={user}",
            f"--regid={user}",
            "--clear-groups",
        ]
        return subprocess.run(
            [*enter, *who, *words], capture_output=True, text=True, timeout=PATIENCE, check=False
        )

    @property
    def first(self) -> int:
        """Its process number 1, as it is numbered outside."""
        children = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children")
        deadline = time.monotonic() + PATIENCE
        while not (numbers := children.read_text().split()):
            assert time.monotonic() < deadline, "it does not start"
            time.sleep(0.01)
        return int(numbers[0])

    def wait_until_well(self) -> None:
        """Ask for its health until it is well, as Docker does."""
        deadline = time.monotonic() + PATIENCE
        while (said := self.ask(self._image.health)).returncode != 0:
            assert self.process.poll() is None, f"it has ended with {self.process.returncode}"
            assert time.monotonic() < deadline, said.stderr
            time.sleep(0.2)

    def stop(self) -> int:
        """Tell it to end, as `docker stop` does; its exit status."""
        os.kill(self.first, signal.SIGTERM)
        return self.process.wait(timeout=PATIENCE)


@contextmanager
def running(image: Image, *words: str) -> Iterator[Running]:
    """An image that runs for as long as the context lasts, as by `docker run --read-only --tmpfs /tmp`."""
    root = image.folder
    mounts = [
        f"{sys.executable} -c {shlex.quote(_LO_UP)}",
        f"mount -o remount,ro,bind {root}",
        f"mount -o remount,ro,bind {root}/usr",
        f"mount -t tmpfs tmpfs {root}/tmp",
        f"mount --bind {image.volume} {image.volume}",
        f"mount -o remount,rw,bind {image.volume}",
    ]
    command = _inside(image, image.command(*words), mounts, image.env, "--net")
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        try:
            yield Running(process, image)
        finally:
            if process.poll() is None:
                process.kill()
