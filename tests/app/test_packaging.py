"""Presets are found from a checkout, from a wheel and from an installed tool; the package is what it says."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[2]
LIST = "import sim; print(*(info.name for info in sim.list_scenes() if info.built_in)); print(sim.__file__)"


def run(*words: str | Path, **options) -> str:
    done = subprocess.run(
        list(map(str, words)), capture_output=True, text=True, timeout=300, check=False, **options
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def uv() -> str:
    found = os.environ.get("UV") or shutil.which("uv")  # `uv run` says where it is
    assert found is not None, "uv is needed to build and install the package"
    return found


@pytest.fixture(scope="module")
def wheel(uv: str, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("dist")
    run(uv, "build", "--wheel", "--quiet", "--out-dir", out, ROOT)
    return next(out.glob("*.whl"))


def test_the_wheel_has_everything_that_runs(wheel: Path) -> None:
    names = set(zipfile.ZipFile(wheel).namelist())
    folder = ROOT / "presets"
    presets = {f"sim/presets/{path.relative_to(folder).as_posix()}" for path in folder.glob("**/*.json")}
    assert len(presets) >= 15
    assert presets <= names
    assert {
        "sim/py.typed",
        "app/py.typed",
        "app/drawing/static/draw.js",
        "app/page/main.js",
        "app/page/page.css",
        "app/export/body/templates/program.c",
        "studies/bench/fused.c",
        "studies/py.typed",
    } <= names
    assert not any(name.startswith("tests/") for name in names)
    metadata = next(name for name in names if name.endswith("METADATA"))
    assert "Private :: Do Not Upload" in zipfile.ZipFile(wheel).read(metadata).decode()


def test_presets_are_found_from_a_wheel(wheel: Path, tmp_path: Path) -> None:
    """Unpacked as an installer does, away from the checkout."""
    site = tmp_path / "site"
    zipfile.ZipFile(wheel).extractall(site)
    names, where = run(sys.executable, "-c", LIST, cwd=tmp_path, env={"PYTHONPATH": str(site)}).splitlines()
    assert Path(where).is_relative_to(site)
    assert {"tutorial-3.1", "tutorial-3.2", "tutorial-3.3", "ring", "box", "flag-pole", "hair-tuft"} <= set(
        names.split()
    )


def test_presets_are_found_from_a_checkout(tmp_path: Path) -> None:
    names, where = run(sys.executable, "-c", LIST, cwd=tmp_path, env={"PYTHONPATH": str(ROOT)}).splitlines()
    assert Path(where).is_relative_to(ROOT)
    assert "tutorial-3.3" in names.split()


def test_presets_are_found_from_an_installed_tool(uv: str, tmp_path: Path) -> None:
    places = {"UV_TOOL_DIR": tmp_path / "tools", "UV_TOOL_BIN_DIR": tmp_path / "bin"}
    env = {**os.environ, **{name: str(path) for name, path in places.items()}}
    env.pop("VIRTUAL_ENV", None)
    run(uv, "tool", "install", "--quiet", "--python", sys.executable, ROOT, env=env, cwd=tmp_path)
    listed = run(tmp_path / "bin" / "softrod", "scenes", env=env, cwd=tmp_path)
    assert "tutorial-3.3" in listed
    assert "hair-tuft" in listed


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
