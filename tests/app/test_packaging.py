"""What is built has all that runs and nothing else; installed, it runs without a checkout and a network."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
import tarfile
import tomllib
import urllib.request
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import platformdirs
import pytest
from packaging.metadata import Metadata
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import sim
from sim.compiling.compiler import ENTRY_POINTS, fetch
from studies.bench.client import FRAME_TIME, Page, is_frame

ROOT = Path(__file__).parents[2]
PACKAGES = ("app", "sim", "studies")

OFFLINE = """
import sys

def refuse(event, args):
    if event in ("socket.connect", "socket.sendto", "socket.getaddrinfo"):
        address = args[0] if event == "socket.getaddrinfo" else args[1]
        host = address if isinstance(address, str | None) else address[0]
        if host not in (None, "", "localhost", "127.0.0.1", "::1"):
            raise PermissionError(f"{host} is outside")

sys.addaudithook(refuse)
"""
"""What every Python of the installed environment does first: it reaches nothing but this machine."""


def run(*words: str | Path, **options) -> str:
    done = subprocess.run(
        list(map(str, words)), capture_output=True, text=True, timeout=300, check=False, **options
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def tracked() -> set[str]:
    """The files of the checkout, but for those that git is told to ignore."""
    listed = run("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", cwd=ROOT)
    return {name for name in listed.split("\0") if name and (ROOT / name).exists()}


@pytest.fixture(scope="module")
def uv() -> str:
    found = os.environ.get("UV") or shutil.which("uv")  # `uv run` says where it is
    assert found is not None, "uv is needed to build and install the package"
    return found


@pytest.fixture(scope="module")
def built(uv: str, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The wheel and the sdist, as they are published: the wheel is made from the sdist."""
    out = tmp_path_factory.mktemp("dist")
    run(uv, "build", "--quiet", "--out-dir", out, ROOT)
    return next(out.glob("*.whl")), next(out.glob("*.tar.gz"))


@dataclass
class Installed:
    """The wheel in an environment of its own, for a user of its own.

    Attributes:
        environment: where it is installed.
        home: the user's folder, where the programs run.
        env: variables of their environment, no more.
    """

    environment: Path
    home: Path
    env: dict[str, str]

    def command(self, *words: str | Path) -> list[str]:
        return [str(self.environment / "bin" / "softrod"), *map(str, words)]

    def softrod(self, *words: str | Path) -> str:
        """What a command prints."""
        return run(*self.command(*words), cwd=self.home, env=self.env)

    def python(self, code: str) -> str:
        """What a program prints."""
        return run(self.environment / "bin" / "python", "-c", code, cwd=self.home, env=self.env)


@pytest.fixture(scope="module")
def installed(uv: str, built: tuple[Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Installed:
    folder = tmp_path_factory.mktemp("installed")
    environment, home, constraints = folder / "environment", folder / "home", folder / "constraints.txt"
    home.mkdir()
    # What `uv sync` has fetched, so that nothing else is.
    constraints.write_text("\n".join(map(str, declared()["constraints"])))
    run(uv, "venv", "--quiet", "--python", sys.executable, environment)
    python = environment / "bin" / "python"
    run(
        uv, "pip", "install", "--quiet", "--python", python, "--constraint", constraints, built[0], cwd=folder
    )
    packages = Path(run(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip())
    (packages / "offline.py").write_text(OFFLINE)
    (packages / "offline.pth").write_text("import offline\n")
    # The user's machine code is the one thing that both have.
    fetch(ENTRY_POINTS)
    caches = platformdirs.user_cache_path("softrod", appauthor=False).parent
    env = {"HOME": str(home), "XDG_DATA_HOME": str(home / "data"), "XDG_CACHE_HOME": str(caches)}
    return Installed(environment, home, env | {"PATH": os.defpath, "MPLCONFIGDIR": str(home / "matplotlib")})


# ------------------------------------------------------------------------- what is built
def test_the_wheel_is_the_packages_and_the_presets(built: tuple[Path, Path]) -> None:
    names = {name for name in zipfile.ZipFile(built[0]).namelist() if ".dist-info/" not in name}
    expected = {name for name in tracked() if name.startswith(tuple(f"{one}/" for one in PACKAGES))}
    expected |= {f"sim/{name}" for name in tracked() if name.startswith("presets/")}
    assert names == expected
    assert {
        "sim/py.typed",
        "app/pages/sandbox/main.js",
        "app/ui/page.css",
        "sim/presets/rope.json",
    } <= names


def test_a_wheel_made_from_the_sdist_is_that_made_from_the_checkout(
    uv: str, built: tuple[Path, Path], tmp_path: Path
) -> None:
    run(uv, "build", "--wheel", "--quiet", "--out-dir", tmp_path, ROOT)
    there, here = (zipfile.ZipFile(path) for path in (built[0], next(tmp_path.glob("*.whl"))))
    assert {one.filename: one.CRC for one in there.infolist()} == {
        one.filename: one.CRC for one in here.infolist()
    }


def test_the_sdist_has_what_tests_it_and_nothing_of_this_place(built: tuple[Path, Path]) -> None:
    with tarfile.open(built[1]) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    assert names <= tracked() | {"PKG-INFO"}
    tops = {name.partition("/")[0] for name in names}
    assert {*PACKAGES, "presets", "schema", "tests", "docs", "examples"} <= tops
    assert not tops & {".ci", "uv.lock"}


def test_an_index_takes_its_metadata(built: tuple[Path, Path]) -> None:
    wheel = zipfile.ZipFile(built[0])
    text = wheel.read(next(name for name in wheel.namelist() if name.endswith("/METADATA")))
    metadata = Metadata.from_email(text, validate=True)  # hatchling has looked at the classifiers
    assert metadata.description == (ROOT / "README.md").read_text(encoding="utf-8")
    assert metadata.description_content_type == "text/markdown"
    assert str(metadata.requires_python) == ">=3.11"
    assert not any(one.startswith("Private ::") for one in metadata.classifiers or ())


# ------------------------------------------------------------------------- what is installed
def test_it_reaches_nothing_outside_and_finds_what_another_environment_compiled(installed: Installed) -> None:
    code = """
import urllib.request
import sim
from sim.compiling.compiler import ENTRY_POINTS
try:
    urllib.request.urlopen("http://192.0.2.1/", timeout=1)
except OSError as error:
    print(error.reason)
print(sum(point.file.exists() for point in ENTRY_POINTS.values()))
print(sim.__file__)
"""
    refused, compiled, where = installed.python(code).splitlines()
    assert refused == "192.0.2.1 is outside"
    assert compiled == f"{len(ENTRY_POINTS)}"
    assert Path(where).is_relative_to(installed.environment)


def test_its_commands_work(installed: Installed) -> None:
    presets = {info.name for info in sim.list_scenes() if info.built_in}
    (folder,) = installed.environment.glob("lib/*/site-packages/sim/presets")
    files = [*map(str, sorted(folder.rglob("*.json")))]
    code = f"""
from app.cli.main import main
for words in (["scenes"], ["schema"], ["check", *{files}]):
    try:
        main(words)
    except SystemExit as ended:
        print("=", ended.code)
"""
    scenes, schema, checked, _ = installed.python(code).split("= 0\n")
    assert presets <= {line.split()[0] for line in scenes.splitlines() if line.strip()}
    assert schema == (ROOT / "schema" / "scene-4.schema.json").read_text(encoding="utf-8")
    assert len(files) == len(presets)
    assert checked.count("is valid") == len(files)


def test_it_exports_everything(installed: Installed) -> None:
    kinds = {
        "html": "html",
        "png": "png",
        "glb": "glb",
        "json": "json",
        "csv": "zip",
        "python": "py",
        "c": "c",
    }
    files = {kind: installed.home / f"{kind}.{ending}" for kind, ending in {**kinds, "live": "html"}.items()}
    words = [word for kind, file in files.items() for word in (f"--{kind}", file)]
    installed.softrod("export", "ring", "--seconds", "0.2", *words)
    assert all(file.stat().st_size > 1000 for file in files.values())


@pytest.fixture
def served(installed: Installed) -> Iterator[str]:
    """The address of its page."""
    words = installed.command("tree", "--port", "0", "--no-open")
    with subprocess.Popen(
        words, cwd=installed.home, env=installed.env, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        try:
            said = process.stdout.readline()
            yield said.split()[3]
        finally:
            process.send_signal(signal.SIGINT)
            rest = process.stdout.read()
    assert process.returncode == 0
    assert "softrod has ended." in rest


def test_its_page_comes_and_moves(served: str) -> None:
    def read(address: str) -> bytes:
        with urllib.request.urlopen(address, timeout=30) as answer:
            return answer.read()

    page = read(f"{served}/").decode()
    scripts = re.findall(r'(?:src|href)="(softrod/[^"]+)"', page)
    assert any(script.endswith("/pages/sandbox/main.js") for script in scripts)
    for script in scripts:
        assert len(read(f"{served}/{script}")) > 100
    with Page(int(served.rpartition(":")[2])) as moving:
        first = moving.wait_for(is_frame)["numbers"]
        moving.wait_for(
            lambda message: is_frame(message) and message["numbers"][FRAME_TIME] > first[FRAME_TIME]
        )


def test_the_solver_is_tested_without_the_page() -> None:
    for path in (ROOT / "tests" / "sim").rglob("*.py"):
        imports = re.findall(r"^\s*(?:from|import)\s+(\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)
        assert "app" not in imports, path


def test_no_file_names_a_registry_or_a_lock() -> None:
    tracked = run("git", "ls-files", cwd=ROOT).split()
    assert "uv.lock" not in tracked


def declared() -> dict[str, list[Requirement]]:
    """What pyproject.toml asks for by name of the list, and its constraints."""
    content = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    project, uv = content["project"], content["tool"]["uv"]
    lists = {
        "asked": [
            *project["dependencies"],
            *(word for extra in project["optional-dependencies"].values() for word in extra),
            *(word for group in content["dependency-groups"].values() for word in group),
        ],
        "build": content["build-system"]["requires"],
        "constraints": uv["constraint-dependencies"],
        "build constraints": uv["build-constraint-dependencies"],
    }
    return {name: [Requirement(word) for word in words] for name, words in lists.items()}


def test_every_dependency_is_bounded_and_constrained() -> None:
    lists = declared()
    for asked, constraints in (("asked", "constraints"), ("build", "build constraints")):
        named = {canonicalize_name(constraint.name) for constraint in lists[constraints]}
        for wanted in lists[asked]:
            assert {s.operator for s in wanted.specifier} & {"<", "=="}, f"{wanted} has no upper bound"
            assert canonicalize_name(wanted.name) in named, f"{wanted}: run: python tests/constrain.py"


def test_what_is_installed_is_what_the_constraints_say() -> None:
    checked = 0
    for constraint in declared()["constraints"]:
        if constraint.marker is not None and not constraint.marker.evaluate():
            continue
        try:
            found = version(constraint.name)
        except PackageNotFoundError:
            continue  # of an extra that is not installed
        assert constraint.specifier.contains(found), f"{constraint}, but {found} is installed; run: uv sync"
        checked += 1
    assert checked >= 30


def test_the_schema_is_that_of_the_types() -> None:
    from sim.store.schema import SCHEMA_PATH, schema_bytes

    assert SCHEMA_PATH.read_bytes() == schema_bytes(), "run: python -m sim.store.schema"
