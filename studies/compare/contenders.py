"""Who takes part in `softrod bench peers`."""

from __future__ import annotations

from .engine import Engine
from .engines import box2d, c_loop, chipmunk, jax_loops, lanes, mujoco_tendons, softrod, solvers

_ALL = (
    Engine("softrod", softrod.paths, softrod.heaps, lanes.by_softrod),
    Engine("C loop", c_loop.paths, many=lanes.by_c, programs=("gcc",)),
    Engine("NumPy", many=lanes.by_numpy),
    Engine("SciPy", solvers.scipy_paths, many=lanes.by_scipy),
    Engine("CVODE", solvers.cvode_paths, packages=("scikit-sundae",)),
    Engine("JAX", jax_loops.jax_paths, many=lanes.by_jax, packages=("jax",)),
    Engine("diffrax", jax_loops.diffrax_paths, packages=("jax", "diffrax")),
    Engine("Box2D", box2d.paths, box2d.heaps, packages=("pyb2d3",)),
    Engine("Chipmunk", chipmunk.paths, chipmunk.heaps, packages=("pymunk",)),
    Engine("MuJoCo", mujoco_tendons.paths, packages=("mujoco",)),
)

ENGINES: dict[str, Engine] = {engine.name: engine for engine in _ALL}
"""The engines and solvers by name, in the order of the report."""
