"""How the parts may depend on each other."""

from __future__ import annotations

import ast
import graphlib
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import TypeGuard

import pytest

import sim

ROOT = Path(sim.__file__).parent.parent
SOURCES = sorted((ROOT / "sim").rglob("*.py"))


@cache
def parsed(path: Path) -> ast.Module:
    """A module's code."""
    return ast.parse(path.read_text(encoding="utf-8"))


def imported(tree: ast.AST) -> set[str]:
    """The top-level packages that are imported anywhere in a piece of code."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            found.add(node.module.split(".")[0])
    return found


def test_the_solver_loads_without_the_page() -> None:
    script = "import sim, sys; print(sorted(sys.modules))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True, cwd=ROOT)
    modules = set(ast.literal_eval(run.stdout))
    loaded = {name.split(".")[0] for name in modules}
    assert {"sim", "numba"} <= loaded
    assert not loaded & {"app", "viser", "websockets", "trimesh", "tyro", "rich", "matplotlib"}
    # numba looks for SciPy, but the parts that take long are left for when they are needed.
    assert not modules & {"scipy.sparse", "scipy.integrate"}


def test_the_solver_imports_only_what_it_needs() -> None:
    allowed = {"sim", "numpy", "numba", "llvmlite", "msgspec", "platformdirs"} | sys.stdlib_module_names
    for path in SOURCES:
        # SciPy takes long to load, and few bodies need it: it is loaded when it is needed.
        lazily = set() if {"engine", "forces", "steps", "linear", "balance"} & set(path.parts) else {"scipy"}
        for node in parsed(path).body:
            if not is_for_types(node):
                is_late = isinstance(node, ast.FunctionDef | ast.ClassDef)
                assert imported(node) <= allowed | (lazily if is_late else set()), path


def test_kernels_know_nothing_of_scenes_and_files() -> None:
    paths = [
        path
        for folder in ("engine", "solve/steps", "solve/linear", "solve/balance")
        for path in (ROOT / "sim" / folder).rglob("*.py")
    ]
    assert len(paths) > 30
    for path in paths:
        for node in ast.walk(parsed(path)):
            if isinstance(node, ast.ImportFrom):
                assert not {"sim", "msgspec", "scene", "store"} & set((node.module or "").split(".")), path


def is_for_types(node: ast.AST) -> TypeGuard[ast.If]:
    """Whether it is for types only, and not loaded when the module runs."""
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def loaded_by(tree: ast.Module) -> Iterator[ast.AST]:
    """All of a module but what is for types only, and not loaded when it runs."""
    for node in tree.body:
        if not is_for_types(node):
            yield from ast.walk(node)


def folder_of(words: list[str]) -> str:
    """The folder of a module, or a module that is in none but the package's.

    A folder within one that has modules of its own, as `sim/scene/recipes`, counts as a part of that.
    """
    is_module = (ROOT / "/".join(words)).with_suffix(".py").exists()
    words = words[:-1] if is_module and len(words) > 2 else words
    while len(words) > 2 and len(list((ROOT / "/".join(words[:-1])).glob("*.py"))) > 1:
        words = words[:-1]
    return ".".join(words)


@pytest.mark.parametrize("package", ["sim", "app"])
def test_modules_import_each_other_in_one_direction_only(package: str) -> None:
    users: dict[str, set[str]] = {}
    for path in (ROOT / package).rglob("*.py"):
        words = list(path.relative_to(ROOT).with_suffix("").parts)
        tree = parsed(path).body
        # Imports for types count, too: modules that know each other cannot be read one after the other.
        for node in [*tree, *(inside for block in tree if is_for_types(block) for inside in block.body)]:
            if isinstance(node, ast.ImportFrom) and node.level:
                base = words[: -node.level] + (node.module.split(".") if node.module else [])
                targets = [base] if node.module else [[*base, alias.name] for alias in node.names]
                for target in targets:
                    users.setdefault(".".join(target), set()).add(".".join(words))
    assert len(users) > 10
    graphlib.TopologicalSorter(users).prepare()  # raises where there is a circle


@pytest.mark.parametrize("package", ["sim", "app"])
def test_folders_import_each_other_in_one_direction_only(package: str) -> None:
    users: dict[str, set[str]] = {}
    for path in (ROOT / package).rglob("*.py"):
        words = list(path.relative_to(ROOT).with_suffix("").parts)
        if words[-1] == "__init__":
            continue
        for node in loaded_by(parsed(path)):
            if isinstance(node, ast.ImportFrom) and (node.level or (node.module or "").startswith(package)):
                base = words[: -node.level] if node.level else []
                target = folder_of(base + (node.module.split(".") if node.module else []))
                if target != folder_of(words):
                    users.setdefault(target, set()).add(folder_of(words))
    assert len(users) > 3
    order = graphlib.TopologicalSorter(users)
    order.prepare()  # raises where there is a circle


# ------------------------------------------------------------------------- what tests look at
TESTS = sorted((ROOT / "tests").rglob("*.py"))
GATHERED = ("tests/sim/inside.py", "tests/app/inside.py", "tests/app/test_viser_inside.py")
"""The only files of tests that look at an inside: all other tests go on when that changes."""
PUBLIC = ("_replace", "_repr_html_")
"""Names that begin with an underscore and are for everybody: of named tuples, and of notebooks."""


def is_private(name: str) -> bool:
    """Whether a name, or the last part of a path to one, is nobody else's business."""
    last = name.split(".")[-1]
    return last.startswith("_") and not last.startswith("__") and last not in PUBLIC


def private_looks(tree: ast.AST) -> list[tuple[int, str]]:
    """Where a piece of code looks at what belongs to another one: line and name."""
    found = []
    for node in ast.walk(tree):
        match node:
            case ast.Attribute(value=ast.Name(id="self" | "cls")):
                pass
            case ast.Call(args=[ast.Name(id="self" | "cls"), *_]):
                pass
            case ast.Attribute(attr=name) if is_private(name):
                found.append((node.lineno, name))
            case ast.Import(names=names) | ast.ImportFrom(names=names):
                module = "" if isinstance(node, ast.Import) else f"{node.module}."
                paths = [f"{module}{alias.name}" for alias in names]
                parts = [(path, part) for path in paths for part in path.split(".")]
                found += [(node.lineno, path) for path, part in parts if is_private(part)]
            case ast.Call(func=ast.Attribute(attr="setattr") | ast.Name(id="getattr" | "setattr")):
                texts = [each.value for each in node.args if isinstance(each, ast.Constant)]
                found += [(node.lineno, name) for name in texts if isinstance(name, str) and is_private(name)]
    return found


@pytest.mark.parametrize(
    "code",
    [
        "tab._session", "tab.probe()._x", "self.tab._view = 1", "from sim.scene import _kept",
        "import viser._messages", "from viser.infra._infra import x", "getattr(tab, '_session')",
        "monkeypatch.setattr(Tab, '_prepare', f)", "monkeypatch.setattr('sim.model.sparsity._KRYLOV', 1)",
    ],
)  # fmt: skip
def test_a_private_look_is_seen(code: str) -> None:
    assert private_looks(ast.parse(code))


@pytest.mark.parametrize(
    "code",
    [
        "self._mine", "cls._mine", "setattr(self, '_mine', 1)", "selection._replace(a=1)",
        "viser.__version__", "for _ in some: pass",
    ],
)  # fmt: skip
def test_what_is_ones_own_or_for_everybody_is_no_private_look(code: str) -> None:
    assert not private_looks(ast.parse(code))


def test_tests_look_at_private_state_only_where_such_looks_are_gathered() -> None:
    assert len(TESTS) > 100
    for path in TESTS:
        if path.relative_to(ROOT).as_posix() not in GATHERED:
            looks = private_looks(ast.parse(path.read_text(encoding="utf-8")))
            assert not looks, f"{path}: {looks}"


def test_browser_tests_know_of_viser_by_the_page_s_own_script_only() -> None:
    """`app/ui/viser/seen.js` says what is seen; one test puts another viser in the place of the page's."""
    for path in (ROOT / "tests" / "browser").glob("*.py"):
        text = path.read_text(encoding="utf-8")
        assert "__viser" not in text.replace("Object.defineProperty(window, '__viserMutable'", ""), path
