"""Kernels are compiled one by one, kept on the disk, and ready only once their machine code is loaded."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import sim
from sim.analysis.equilibrium import StaticModel
from sim.compiling.compiler import ENTRY_POINTS, Compiler, EntryPoint, is_ready, needed_by
from sim.engine import kept
from sim.engine.addresses import ADDRESSES
from sim.model.system import build_system
from sim.solve.registry import METHODS
from tests.amount import at_night, part_of
from tests.sim.builders import built
from tests.sim.inside import hash_from

ROOT = Path(sim.__file__).parent.parent
BODY = build_system(sim.rope(5)).body
QUICK = "next_turn"
"""The entry point that is compiled the soonest of those that call no other."""


def python(code: str, cache: Path, root: Path = ROOT) -> str:
    """What a new process prints, whose machine code is kept in a folder."""
    environment = {**os.environ, "XDG_CACHE_HOME": str(cache), "PYTHONPATH": str(root)}
    words = [sys.executable, "-c", code]
    return subprocess.run(
        words, env=environment, capture_output=True, text=True, check=True, cwd=root
    ).stdout.strip()


# ------------------------------------------------------------------------- what is ready
def test_every_method_has_an_entry_point_of_its_own() -> None:
    kernels = {info.kernel for info in METHODS.values() if info.kernel is not None}
    assert kernels == {point.kernel for point in ENTRY_POINTS.values() if point.name.startswith("run_")} - {
        ENTRY_POINTS["run_fallback"].kernel
    }
    for method in METHODS:
        assert set(needed_by(method, BODY)) <= set(ENTRY_POINTS)


@pytest.mark.parametrize("method", part_of([*METHODS], 9))
def test_what_a_method_needs_is_all_that_its_first_step_calls(method: str, tmp_path: Path) -> None:
    # In a process in which those are loaded, a step compiles nothing.
    code = f"""
import sim
from sim.model.system import build_system
from numba.core import event
from sim.model.system import build_system
from sim.compiling.compiler import (ENTRY_POINTS, needed_by)
for name in needed_by({method!r}, build_system(sim.rope(5)).body):
    ENTRY_POINTS[name].load()
with event.install_recorder("numba:compile") as compiled:
    simulation = sim.Simulation(sim.rope(5), integrator={method!r}, wait=False)
    assert not simulation.plain
    assert simulation.step(3) == 3
print(len(compiled.buffer))
"""
    words = [sys.executable, "-c", code]
    run = subprocess.run(words, capture_output=True, text=True, cwd=ROOT, check=False)
    assert run.stdout.strip() == "0", run.stderr


def test_a_simulation_that_does_not_wait_moves_by_numpy_and_then_goes_on(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(EntryPoint, "ready", property(lambda _: False))
        simulation = sim.Simulation(sim.load_scene("tutorial-3.3"), wait=False)
        assert simulation.plain
        assert simulation.step(100) == 100
        assert simulation.plain
        assert simulation.stats().steps == 100
        with pytest.raises(sim.InputError, match="energy: its kernels are still being compiled"):
            simulation.energy()
        assert not sim.Simulation(sim.load_scene("tutorial-3.3")).plain
    for name in needed_by(simulation.method, simulation.tables[0].body):
        ENTRY_POINTS[name].load()
    assert simulation.step(100) == 100
    assert not simulation.plain
    whole = sim.Simulation(sim.load_scene("tutorial-3.3"))
    whole.step(200)
    assert simulation.positions == pytest.approx(whole.positions, abs=1e-8)
    assert (simulation.time, simulation.step_count) == (whole.time, whole.step_count)


@pytest.mark.parametrize("hardness", [1e3, 1e6, 1e9])
def test_meanwhile_a_hard_wall_throws_nothing_higher_than_it_fell_from(
    monkeypatch: pytest.MonkeyPatch, hardness: float
) -> None:
    monkeypatch.setattr(EntryPoint, "ready", property(lambda _: False))
    floor = sim.Wall(point=(0.0, 400.0), normal=(0.0, -1.0), hardness=hardness)
    pair = built(
        [(0.0, 300.0), (30.0, 300.0)], stiffness=1e3, damping=1.0, gravity=(0.0, 1000.0), walls=(floor,)
    )
    simulation = sim.Simulation(pair, wait=False)
    assert simulation.plain
    places = []
    while simulation.time < 2.0:
        simulation.advance(1.0 / 60.0)
        places.append(simulation.positions[:, 1])
    assert np.min(places) >= 300.0 and np.max(places) < 450.0
    assert np.min(places[36:60]) < 390.0  # it bounces


def test_auto_begins_with_what_is_there_and_takes_the_others_in(monkeypatch: pytest.MonkeyPatch) -> None:
    # A stiff rope, for which `auto` takes an implicit method as soon as it can.
    scene = sim.load_scene("study-w4")
    body = build_system(scene).body
    ready = set(needed_by("auto", body))
    monkeypatch.setattr(EntryPoint, "ready", property(lambda point: point.name in ready))
    for name in (*needed_by("auto", body), *needed_by("rodas4", body)):
        ENTRY_POINTS[name].load()
    simulation = sim.Simulation(scene, wait=False)
    simulation.step(10)
    assert not simulation.plain
    assert simulation.stats().matrices == 0
    ready |= set(needed_by("rodas4", body))
    simulation.step(40)
    assert simulation.stats().matrices > 0
    whole = sim.Simulation(scene)
    whole.step(50)
    assert simulation.positions == pytest.approx(whole.positions, abs=2.0 * scene.integrator.tolerance)


# ------------------------------------------------------------------------- helpers
def test_the_compiler_loads_what_was_wanted_first(monkeypatch: pytest.MonkeyPatch) -> None:
    for point in ENTRY_POINTS.values():
        point.load()  # so that the disk has it, or nothing can be kept there
    loaded: list[str] = []
    load = EntryPoint.load
    monkeypatch.setattr(EntryPoint, "load", lambda point: (loaded.append(point.name), load(point))[1])
    monkeypatch.setattr("sim.compiling.compiler.os.cpu_count", lambda: 1)
    compiler = Compiler()
    compiler.want(["run_alpha", "energies"])
    compiler.start()
    compiler.wait()
    assert loaded[:2] == ["run_alpha", "energies"]
    assert compiler.progress == (len(ENTRY_POINTS), len(ENTRY_POINTS))
    assert is_ready(ENTRY_POINTS)


def test_a_compiler_makes_ready_what_a_scene_may_need_and_more_when_asked_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    loaded: list[str] = []
    monkeypatch.setattr(EntryPoint, "ready", property(lambda point: point.name in loaded))
    monkeypatch.setattr(EntryPoint, "load", lambda point: loaded.append(point.name))
    monkeypatch.setattr(EntryPoint, "file", None)
    compiler = Compiler(())
    compiler.start()
    compiler.wait()
    scene = sim.load_scene("tutorial-3.3")
    compiler.want_for("auto", build_system(scene).body)
    compiler.wait()
    first = len(loaded)
    assert set(loaded[: len(needed_by("auto", build_system(scene).body))]) >= {"chain_accelerations"}
    assert {"run_euler", "energies"} < set(loaded)
    assert not any(name.startswith(("walls", "contact", "motors")) or "yield" in name for name in loaded)
    assert compiler.progress == (first, first)
    body = build_system(sim.load_scene("lesson-worm")).body
    compiler.want_for("auto", body)
    compiler.wait()
    assert is_ready(needed_by("auto", body))
    assert "walls.add_forces" in loaded[first:]
    assert len(set(loaded)) == len(loaded)


COMPILE_ONE = f"""
from sim.compiling.compiler import ENTRY_POINTS, Compiler
compiler = Compiler([{QUICK!r}])
print(ENTRY_POINTS[{QUICK!r}].ready, end=" ")
compiler.start()
compiler.wait()
point = ENTRY_POINTS[{QUICK!r}]
print(point.ready, compiler.compiles, point.kernel.stats.cache_hits != {{}})
"""


@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which two processes have compiled one entry point at the same time; tests use a copy.

    One of them has a helper that ends too soon, which is no harm.
    """
    cache = tmp_path_factory.mktemp("compiled")
    environment = {**os.environ, "XDG_CACHE_HOME": str(cache), "PYTHONPATH": str(ROOT)}
    words = [sys.executable, "-m", "sim.compiling.precompile", QUICK]
    with subprocess.Popen(words, env=environment, stdout=subprocess.PIPE, text=True, cwd=ROOT) as other:
        broken = COMPILE_ONE.replace("compiler.start()", "sys.executable = '/bin/false'\ncompiler.start()")
        assert python(f"import sys\n{broken}", cache).startswith("False True True")
        assert other.communicate()[0] == f"{QUICK}\n"
    assert {file.suffix for file in cache.rglob("*") if file.is_file()} == {".nbc"}
    return cache


def test_what_is_compiled_once_is_there_for_all_later_starts(compiled: Path) -> None:
    assert python(COMPILE_ONE, compiled) == "False True False True"


def test_a_broken_file_is_compiled_again(compiled: Path, tmp_path: Path) -> None:
    shutil.copytree(compiled, tmp_path, dirs_exist_ok=True)
    for file in tmp_path.rglob("*.nbc"):
        file.write_bytes(file.read_bytes()[:1000])
    # Here, since nobody sees it before it is read.
    assert python(COMPILE_ONE, tmp_path) == "False True False False"
    assert python(COMPILE_ONE, tmp_path) == "False True False True"


@at_night
def test_a_second_environment_finds_what_the_first_has_compiled(compiled: Path, tmp_path: Path) -> None:
    cache, other = tmp_path / "cache", tmp_path / "environment"
    shutil.copytree(compiled, cache)
    shutil.copytree(ROOT / "sim", other / "sim", ignore=shutil.ignore_patterns("__pycache__"))
    for file in other.rglob("*.py"):
        os.utime(file, (0, 0))  # as packages are unpacked
    before = {file: file.read_bytes() for file in cache.rglob("*.nbc")}
    assert python(f"{COMPILE_ONE}import sim; print(sim.__file__)", cache, other).split() == [
        *["False", "True", "False", "True"],
        str(other / "sim" / "__init__.py"),
    ]
    assert {file: file.read_bytes() for file in cache.rglob("*.nbc")} == before
    # But not what was compiled from another text: the entry point calls what is edited.
    edited = other / "sim" / "engine" / "numerics" / "vectors.py"
    edited.write_text(f"{edited.read_text()}\n")
    assert python(COMPILE_ONE, cache, other) == "False True True True"


# ------------------------------------------------------------------------- the cache of machine code
@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A copy of the kernels' sources, which the hashes are made of."""
    kept.source_hash.cache_clear()
    copy = tmp_path / "sim"
    shutil.copytree(ROOT / "sim", copy, ignore=shutil.ignore_patterns("__pycache__"))
    before = kept.source_hash("solve.steps.verlet")
    hash_from(copy, monkeypatch)
    assert kept.source_hash("solve.steps.verlet") == before
    yield copy
    kept.source_hash.cache_clear()


def hashes(sources: Path) -> dict[str, str]:
    kept.source_hash.cache_clear()
    paths = [path for folder in ("engine", "forces", "solve") for path in (sources / folder).rglob("*.py")]
    modules = [path.relative_to(sources).with_suffix("") for path in paths]
    names = [".".join(module.parts) for module in modules if module.name != "__init__"]
    return {name: kept.source_hash(name) for name in names}


def test_an_edit_changes_the_hash_of_what_it_can_change_and_of_nothing_else(sources: Path) -> None:
    before = hashes(sources)
    for edited, users, others in (
        (
            "solve.steps.verlet",
            {"solve.steps.verlet"},
            {"solve.steps.adams", "solve.steps.euler", "forces.all"},
        ),
        (
            "solve.steps.common",
            {f"solve.steps.{name}" for name in ("common", "verlet", "adams")},
            {"forces.all", "engine.numerics.blocks", "forces.drive"},
        ),
        (
            "forces.touch.walls",
            {"forces.touch.walls", "forces.all", "solve.linear.implicit", "solve.balance.work"},
            {"solve.steps.verlet", "solve.steps.adams", "forces.air"},
        ),
        ("engine.tables", {"solve.steps.verlet", "forces.all", "forces.air"}, set[str]()),
    ):
        path = sources / f"{edited.replace('.', '/')}.py"
        text = path.read_bytes()
        path.write_bytes(text + b"\n# changed\n")
        after = hashes(sources)
        changed = {name for name in after if after[name] != before[name]}
        assert users <= changed
        assert not others & changed
        path.write_bytes(text)
    # But what the tables are is part of all kernels.
    path = sources / "forces" / "touch" / "walls.py"
    path.write_text(path.read_text().replace("    rows: Rows", "    more: Rows\n    rows: Rows"))
    assert all(changed != before[name] for name, changed in hashes(sources).items())


def test_the_hash_follows_the_versions_of_the_compiler(
    sources: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = hashes(sources)
    monkeypatch.setattr(kept.numba, "__version__", "0.0.0")
    after = hashes(sources)
    assert all(after[name] != before[name] for name in before)


def test_what_nobody_used_for_a_month_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept.platformdirs, "user_cache_path", lambda *_, **__: tmp_path)
    root = tmp_path / "kernels"
    old, young = root / "old", root / "young"
    for folder in (old, young):
        folder.mkdir(parents=True)
    month = 31 * 86400.0
    os.utime(old, (time.time() - month, time.time() - month))
    assert kept.cache_root.__wrapped__() == root
    assert not old.exists()
    assert young.exists()


@pytest.fixture
def caches(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The user's folder for caches."""
    monkeypatch.setattr(kept.platformdirs, "user_cache_path", lambda *_, **__: tmp_path / "softrod")
    return tmp_path / "softrod"


def test_no_cache_where_nothing_can_be_written(caches: Path) -> None:
    caches.write_bytes(b"")
    assert kept.cache_root.__wrapped__() is None
    assert kept.trouble() == f"the folder {caches} cannot be written"


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="Windows has no such owners and modes")
def test_what_others_could_have_written_is_not_run(caches: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    root = caches / "kernels"
    assert kept.cache_root.__wrapped__() == root
    assert root.stat().st_mode & 0o777 == 0o700
    for mode in (0o770, 0o702):
        root.chmod(mode)
        assert kept.cache_root.__wrapped__() is None
        assert kept.trouble() == f"others can write into the folder {root}"
    root.chmod(0o755)
    assert kept.trouble() == ""
    monkeypatch.setattr(os, "geteuid", lambda: root.stat().st_uid + 1)
    assert kept.cache_root.__wrapped__() is None
    assert kept.trouble() == f"the folder {root} is another user's"


# ------------------------------------------------------------------------- parts of the forces
def test_a_scene_waits_for_no_kernel_of_what_it_does_not_have() -> None:
    def parts(scene: sim.Scene) -> set[str]:
        return {name for name in needed_by("rk4", build_system(scene).body) if name != "run_runge_kutta"}

    floor = (sim.Wall(point=(0.0, 500.0), normal=(0.0, -1.0)),)
    assert parts(sim.rope(5)) == {"chain_accelerations"}
    assert parts(sim.rope(5, walls=floor)) == {"any_accelerations", "linear.add_forces", "walls.add_forces"}
    assert parts(sim.load_scene("study-cloth")) == {"any_accelerations", "linear.add_forces"}
    assert "contact.add_forces" in parts(sim.rope(5, contact=sim.Contact(distance=5.0)))


@pytest.mark.parametrize("kind", ["walls.add_forces", "any_accelerations", "linear.add_forces"])
def test_forces_with_a_part_that_is_not_loaded_are_no_numbers(kind: str) -> None:
    floor = (sim.Wall(point=(0.0, 500.0), normal=(0.0, -1.0)),)
    body = StaticModel(sim.rope(5, walls=floor), balanced=False)
    assert np.isfinite(body.accelerations(body.start)).all()
    number = ENTRY_POINTS[kind].number
    loaded = ADDRESSES[number]
    ADDRESSES[number] = 0
    try:
        assert np.isnan(body.accelerations(body.start)).any()
    finally:
        ADDRESSES[number] = loaded
