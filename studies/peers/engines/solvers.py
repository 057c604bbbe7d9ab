"""SciPy's solvers and CVODE on the plain equations, which numba compiles; implicit ones get the Jacobian."""

from __future__ import annotations

import time
import warnings
from typing import Any

import numpy as np

from ..plain import Equations, Floats
from ..runs import PATIENCE, Failed, Ladder, Runner
from ..scenes import MANY, PATHS, SECONDS
from . import lacking, package

TOLERANCES = tuple(10.0 ** (half / 2) for half in range(2, -11, -1))
"""px and px/s."""

RELATIVE = 1e-3
"""Relative tolerance for an absolute one of 1 px: positions and speeds are in the hundreds."""

MOST = 1200
"""Unknowns up to which CVODE is asked: its Jacobian is a dense array here."""


class SciPy:
    """See `engines`."""

    NAME = "SciPy"

    @staticmethod
    def missing() -> str:
        return ""

    @staticmethod
    def ladders(name: str) -> list[Ladder]:
        if name == MANY:
            from . import many

            return many.ladders_of_scipy()
        if name not in PATHS:
            return []
        equations = Equations(PATHS[name].make())
        return [
            Ladder("SciPy", method, TOLERANCES, _text, lambda value, m=method: SciPyRun(equations, m, value))
            for method in ("RK45", "DOP853", "Radau", "BDF", "LSODA")
            if method != "LSODA" or equations.start.size <= MOST
        ]


class Cvode:
    """See `engines`."""

    NAME = "CVODE"

    @staticmethod
    def missing() -> str:
        return "scikit-sundae is not installed" if lacking("sksundae") else ""

    @staticmethod
    def ladders(name: str) -> list[Ladder]:
        if name not in PATHS:
            return []
        equations = Equations(PATHS[name].make())
        if equations.start.size > MOST:
            return []
        return [
            Ladder("CVODE", method, TOLERANCES, _text, lambda value, m=method: _CvodeRun(equations, m, value))
            for method in ("BDF", "Adams")
        ]


def _text(tolerance: float) -> str:
    return f"tolerance {tolerance:.2g}"


class _Run(Runner):
    """What both have in common: a derivative that gives up."""

    def __init__(self, equations: Equations) -> None:
        self._equations = equations
        self._deadline = np.inf
        equations.derivative(0.0, equations.start)  # machine code
        self._end = equations.start

    def restart(self) -> None:
        self._deadline = time.process_time() + PATIENCE

    def _derivative(self, t: float, y: Floats) -> Floats:
        if time.process_time() > self._deadline:
            raise Failed(f"not done after {PATIENCE:g} s")
        return self._equations.derivative(t, y)

    def positions(self) -> Floats:
        return self._equations.positions(SECONDS, self._end)


class SciPyRun(_Run):
    def __init__(self, equations: Equations, method: str, tolerance: float) -> None:
        super().__init__(equations)
        self._method, self._tolerance, self._options = method, tolerance, {}
        if method in ("Radau", "BDF"):
            self._options["jac"] = equations.jacobian()
            self._options["jac"](0.0, equations.start)
        elif method == "LSODA":
            reach = _reach(equations)
            self._options |= {"lband": reach, "uband": reach}

    def advance(self) -> None:
        from scipy.integrate import solve_ivp

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found: Any = solve_ivp(
                self._derivative, (0.0, SECONDS), self._equations.start, self._method, t_eval=[SECONDS],
                rtol=max(RELATIVE * self._tolerance, 1e-12), atol=self._tolerance, **self._options,
            )  # fmt: skip
        if not found.success:
            raise Failed(str(found.message))
        self._end = found.y[:, -1]


class _CvodeRun(_Run):
    def __init__(self, equations: Equations, method: str, tolerance: float) -> None:
        CVODE = package("sksundae.cvode").CVODE
        super().__init__(equations)
        reach, jacobian = _reach(equations), equations.jacobian()

        def derivative(t: float, y: Floats, out: Floats) -> None:
            out[:] = self._derivative(t, np.array(y))

        def fill(t: float, y: Floats, _: Floats, out: Floats) -> None:
            matrix: Any = jacobian(t, np.array(y))
            column = np.repeat(np.arange(y.size), np.diff(matrix.indptr))
            out[matrix.indices, column] = matrix.data

        self._solver: Any = CVODE(
            derivative, method=method, rtol=RELATIVE * tolerance, atol=tolerance, linsolver="band",
            lband=reach, uband=reach, jacfn=fill, max_num_steps=10_000_000,
        )  # fmt: skip

    def advance(self) -> None:
        # Of two times alone it would keep all steps between them.
        found: Any = self._solver.solve(np.array([0.0, 0.5 * SECONDS, SECONDS]), self._equations.start)
        if not found.success:
            raise Failed(str(found.message))
        self._end = found.y[-1]


def _reach(equations: Equations) -> int:
    """How many diagonals the Jacobian has at most on either side."""
    return 4 * int(np.abs(np.diff(equations.springs, axis=1)).max()) + 3
