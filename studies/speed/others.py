"""What a user would take instead of softrod: SciPy's solvers and CVODE, on the same equations.

They are given the best that they can use: equations in machine code, the analytic Jacobian, and its narrow
band or sparse pattern.
"""

from __future__ import annotations

import importlib.util
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np

from .equations import Equations, Floats

SCIPY = {f"scipy_{name.lower()}": name for name in ("RK45", "DOP853", "Radau", "BDF", "LSODA")}
CVODE = {f"cvode_{name.lower()}": name for name in ("BDF", "Adams")}
"""The names that the solvers have here, and those that they have there."""

RELATIVE = 1e-3
"""Relative tolerance for an absolute one of 1 px and 1 px/s: positions and speeds are in the hundreds."""

LARGE = 60
"""Unknowns from which on SciPy's implicit methods are faster with a sparse Jacobian than with a dense one."""

Derivative = Callable[[float, Floats, Floats], None]
Solve = Callable[[float, Floats, Derivative], Floats]
"""(tolerance, times, derivative) -> (times, N); the derivative is that of `Equations`, perhaps watched."""


class Failed(Exception):
    """A solver gave up; the text says why."""


def has_cvode() -> bool:
    """Whether scikit-sundae is installed."""
    return importlib.util.find_spec("sksundae") is not None


def label(name: str) -> str:
    """A solver's name for people."""
    return f"SciPy {SCIPY[name]}" if name in SCIPY else f"CVODE {CVODE[name]}"


def solver(name: str, equations: Equations) -> Solve:
    """A solver, ready for a scene's equations; what it raises beside `Failed` is a failure, too."""
    if name in SCIPY:
        return _scipy(SCIPY[name], equations)
    return _cvode(CVODE[name], equations)


def _scipy(method: str, equations: Equations) -> Solve:
    from scipy.integrate import solve_ivp

    size = equations.start.size
    options: dict[str, Any] = {}
    if method in ("Radau", "BDF"):
        options["jac"] = _sparse(equations) if size > LARGE else _array(equations, "dense", (size, size))
    elif method == "LSODA":
        options = {"lband": equations.below, "uband": equations.above}
        rows = equations.below + equations.above + 1
        options["jac"] = _array(equations, "banded", (rows, size))

    def solve(tolerance: float, times: Floats, derivative: Derivative) -> Floats:
        def function(t: float, y: Any) -> Floats:
            out = np.empty(size)
            derivative(t, y, out)
            return out

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = solve_ivp(
                function,
                (0.0, times[-1]),
                equations.start,
                method,
                t_eval=times,
                rtol=RELATIVE * tolerance,
                atol=tolerance,
                **options,
            )
        if not found.success:
            raise Failed(str(found.message))
        return found.y.T

    return solve


def _array(equations: Equations, layout: Any, shape: tuple[int, int]) -> Callable[[float, Floats], Floats]:
    jacobian = equations.jacobian_into(layout)

    def function(t: float, y: Floats) -> Floats:
        out = np.zeros(shape)
        jacobian(t, y, out.reshape(-1))
        return out

    return function


def _sparse(equations: Equations) -> Callable[[float, Floats], Any]:
    from scipy.sparse import csc_matrix

    jacobian, (index, first) = equations.jacobian_into("sparse"), equations.pattern()
    size = equations.start.size
    matrix: Any = csc_matrix((np.zeros(index.size), index, first), (size, size))

    def function(t: float, y: Floats) -> Any:
        jacobian(t, y, matrix.data)
        return matrix  # SciPy makes a copy

    return function


def _cvode(method: str, equations: Equations) -> Solve:
    from sksundae.cvode import CVODE as Solver  # pyright: ignore[reportMissingImports]

    jacobian = equations.jacobian_into("dense")  # of which CVODE takes the band

    def fill(t: float, y: Floats, _: Floats, out: Floats) -> None:
        jacobian(t, y, out.reshape(-1))

    # CVODE's arrays must not be written to, which takes machine code of its own; before any clock starts.
    start = equations.start.copy()
    start.setflags(write=False)
    equations.derivative_into()(0.0, start, np.empty(start.size))
    jacobian(0.0, start, np.empty(start.size**2))

    def solve(tolerance: float, times: Floats, derivative: Derivative) -> Floats:
        cvode = Solver(
            lambda t, y, out: derivative(t, y, out),
            method=method,
            rtol=RELATIVE * tolerance,
            atol=tolerance,
            linsolver="band",
            lband=equations.below,
            uband=equations.above,
            jacfn=fill,
            max_num_steps=10_000_000,
        )
        # Of two times alone it would keep all steps between them.
        whole: Any = np.array([0.0, *([0.5 * times[0]] if times.size == 1 else []), *times])
        found: Any = cvode.solve(whole, equations.start)
        if not found.success:
            raise Failed(str(found.message))
        return found.y[-times.size :]

    return solve
