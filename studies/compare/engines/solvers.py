"""SciPy's solvers and CVODE on a scene's equations.

They get the best that they can use: derivatives in machine code, and the analytic Jacobian with its narrow
band or its sparse pattern.
"""

from __future__ import annotations

import contextlib
import importlib.util
import time
import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from sim import Scene

from ..engine import package, tolerance_text
from ..equations import Equations, Layout
from ..measure import Contender, Settings, ladder, tolerances
from ..runs import FAILURES, FRAME, PATIENCE, SECONDS, Failed, Floats, Runner

SCIPY = ("RK45", "DOP853", "Radau", "BDF", "LSODA")
CVODE = ("BDF", "Adams")

TOLERANCES = tuple(10.0 ** (half / 2) for half in range(2, -11, -1))
"""px and px/s."""

RELATIVE = 1e-3
"""Relative tolerance for an absolute one of 1 px and 1 px/s: positions and speeds are in the hundreds."""

MIN_RELATIVE = 1e-12
"""The smallest relative tolerance, a few times what SciPy accepts."""

SPARSE_FROM = 60
"""Unknowns from which on SciPy's implicit methods are faster with a sparse Jacobian than with a dense one."""

MAX_UNKNOWNS = 1200
"""Unknowns up to which solvers with a dense or banded Jacobian take part in `softrod bench peers`."""

LONGEST = 2.0
"""Seconds of a run beyond which `softrod study` tries no finer tolerances."""

Derivative = Callable[[float, Floats, Floats], None]
Solve = Callable[[float, Floats, Derivative], Floats]
"""(tolerance, times, derivative) -> (times, N)."""


def has_cvode() -> bool:
    """Whether scikit-sundae is installed."""
    return importlib.util.find_spec("sksundae") is not None


class SolverRun(Runner):
    """A solver on a scene's equations.

    Args:
        equations: of the scene.
        engine, method: "SciPy" or "CVODE", and one of its methods.
        tolerance: absolute, px and px/s.
        frames: times at which the path is looked at; the solver goes to the end in one call.
        patience: seconds of processor time after which it is given up; reading the clock takes time, too.
    """

    def __init__(
        self,
        equations: Equations,
        engine: str,
        method: str,
        tolerance: float,
        frames: int = 1,
        patience: float | None = None,
    ) -> None:
        self._equations, self._tolerance, self.frames = equations, tolerance, frames
        self.solve = (_scipy if engine == "SciPy" else _cvode)(method, equations)
        self._times = np.linspace(0.0, SECONDS, frames + 1)[1:]
        self._plain = equations.derivative_into()
        with contextlib.suppress(*FAILURES):  # loads machine code, and what is imported late
            self.solve(1.0, np.array([1e-4]), self._plain)
        self._patience, self._deadline = patience, np.inf
        self._found = np.empty((0, 0))
        self._frame = -1

    def restart(self) -> None:
        """Forget the solution."""
        self._frame = -1
        if self._patience is not None:
            self._deadline = time.process_time() + self._patience

    def advance(self) -> None:
        """Solve up to the end in the first frame, and go on to the next one in the others."""
        if self._frame < 0:
            derivative = self._plain if self._patience is None else self._watched
            self._found = self.solve(self._tolerance, self._times, derivative)
        self._frame += 1

    def positions(self) -> Floats:
        """Return the positions after a frame."""
        return self._equations.positions(float(self._times[self._frame]), self._found[self._frame])

    def _watched(self, t: float, y: Floats, out: Floats) -> None:
        if time.process_time() > self._deadline:
            raise Failed(f"not done after {self._patience:g} s")
        self._plain(t, y, out)


def studied(scene: Scene, engine: str, method: str, errors: Sequence[float]) -> Contender:
    """Return a solver as `softrod study` tries it."""
    equations = Equations(scene)
    frames = round(SECONDS / FRAME)
    return Contender(
        engine,
        method,
        tolerances(errors, LONGEST),
        tolerance_text,
        lambda value: SolverRun(equations, engine, method, value),
        lambda value: SolverRun(equations, engine, method, value, frames, PATIENCE),
    )


def scipy_paths(scene: Scene) -> list[Contender]:
    """SciPy's solvers on a rope or a net."""
    return _paths(scene, "SciPy", SCIPY, unbounded=SCIPY[:-1])


def cvode_paths(scene: Scene) -> list[Contender]:
    """CVODE on a rope or a net."""
    return _paths(scene, "CVODE", CVODE, unbounded=())


def _paths(scene: Scene, engine: str, methods: Sequence[str], unbounded: Sequence[str]) -> list[Contender]:
    """Methods of a solver; those that are not `unbounded` only where there are not too many unknowns."""
    equations = Equations(scene)
    settings: Callable[[], Settings] = ladder(TOLERANCES)
    return [
        Contender(
            engine,
            method,
            settings,
            tolerance_text,
            lambda value, m=method: SolverRun(equations, engine, m, value, patience=PATIENCE),
        )
        for method in methods
        if method in unbounded or equations.start.size <= MAX_UNKNOWNS
    ]


def _relative(tolerance: float) -> float:
    return max(RELATIVE * tolerance, MIN_RELATIVE)


def _scipy(method: str, equations: Equations) -> Solve:
    from scipy.integrate import solve_ivp

    size = equations.start.size
    options: dict[str, Any] = {}
    if method in ("Radau", "BDF"):
        dense = size <= SPARSE_FROM
        options["jac"] = _array(equations, "dense", (size, size)) if dense else _sparse(equations)
    elif method == "LSODA":
        rows = equations.below + equations.above + 1
        options = {"lband": equations.below, "uband": equations.above}
        options["jac"] = _array(equations, "banded", (rows, size))
    if "jac" in options:
        options["jac"](0.0, equations.start)  # loads machine code

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
                rtol=_relative(tolerance),
                atol=tolerance,
                **options,
            )
        if not found.success:
            raise Failed(str(found.message))
        return found.y.T

    return solve


def _array(equations: Equations, layout: Layout, shape: tuple[int, int]) -> Callable[[float, Floats], Floats]:
    jacobian = equations.jacobian_into(layout)

    def function(t: float, y: Floats) -> Floats:
        out = np.zeros(shape)
        jacobian(t, y, out.reshape(-1))
        return out

    return function


def _sparse(equations: Equations) -> Callable[[float, Floats], Any]:
    from scipy.sparse import csc_matrix

    jacobian = equations.jacobian_into("sparse")
    index, first = equations.pattern()
    size = equations.start.size
    matrix: Any = csc_matrix((np.zeros(index.size), index, first), (size, size))

    def function(t: float, y: Floats) -> Any:
        jacobian(t, y, matrix.data)
        return matrix  # SciPy makes a copy

    return function


def _cvode(method: str, equations: Equations) -> Solve:
    cvode = package("sksundae.cvode").CVODE
    jacobian = equations.jacobian_into("dense")  # CVODE takes the band from it

    def fill(t: float, y: Floats, _: Floats, out: Floats) -> None:
        jacobian(t, y, out.reshape(-1))

    def solve(tolerance: float, times: Floats, derivative: Derivative) -> Floats:
        solver = cvode(
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
        # Given only two times, it would store all steps between them.
        whole = np.array([0.0, *([0.5 * times[0]] if times.size == 1 else []), *times])
        found: Any = solver.solve(whole, equations.start)
        if not found.success:
            raise Failed(str(found.message))
        return found.y[-times.size :]

    return solve
