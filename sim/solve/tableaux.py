"""Coefficients of the Runge-Kutta and Rosenbrock methods, as published.

Explicit methods are given by their rows a, weights b and times c; for q'' = f(t, q, q') the coefficients of
positions follow as abar = a a. Rosenbrock methods are given in the form in which each stage is one linear
solve.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..engine.tables import Rosenbrock, Tableau

Row = Sequence[float]
"""A row of coefficients."""


def explicit(rows: Sequence[Row], weights: Row, times: Row) -> Tableau:
    """The table of an explicit method of s stages.

    Args:
        rows: a, s rows; the first is empty.
        weights: b.
        times: c.
    """
    stages = len(weights)
    a = np.zeros((stages + 1, stages + 1))
    for i, row in enumerate([*rows, weights]):
        a[i, : len(row)] = row
    return Tableau(stages=stages, c=np.array([*times, 1.0]), a=a, abar=a @ a)


def rosenbrock(
    gamma: float,
    rows: Sequence[Row],
    coupling: Sequence[Row],
    times: Row,
    time_weights: Row,
    weights: Row,
    error: Row,
    order: int,
) -> Rosenbrock:
    """The table of a Rosenbrock method; `weights` and `error` apply to the solutions of the stages."""
    stages = len(weights)
    padded = -(-stages // 4) * 4
    a, c = np.zeros((2, stages + 1, padded))
    for i, row in enumerate([*rows, weights]):
        a[i, : len(row)] = row
    for i, row in enumerate(coupling):
        c[i, : len(row)] = row
    return Rosenbrock(
        stages=stages,
        order=order,
        gamma=gamma,
        c=np.array([*times, 1.0]),
        time_weights=np.array(time_weights, float),
        a=a,
        coupling=c,
        error=np.array([*error, *(0.0 for _ in range(padded - stages))]),
    )


RK4 = explicit(
    rows=((), (0.5,), (0.0, 0.5), (0.0, 0.0, 1.0)),
    weights=(1 / 6, 1 / 3, 1 / 3, 1 / 6),
    times=(0.0, 0.5, 0.5, 1.0),
)
"""Kutta 1901: the classical method."""

_LAST = (1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950)
"""Coefficients a of the last stage of RODAS, which are repeated in the weights."""

RODAS4 = rosenbrock(
    gamma=0.25,
    rows=(
        (),
        (1.544,),
        (0.9466785280815826, 0.2557011698983284),
        (3.314825187068521, 2.896124015972201, 0.9986419139977817),
        _LAST,
        (*_LAST, 1.0),
    ),
    coupling=(
        (),
        (-5.6688,),
        (-2.430093356833875, -0.2063599157091915),
        (-0.1073529058151375, -9.594562251023355, -20.47028614809616),
        (7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160),
        (8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054),
    ),
    times=(0.0, 0.386, 0.21, 0.63, 1.0, 1.0),
    time_weights=(0.25, -0.1043, 0.1035, -0.03620000000000023, 0.0, 0.0),
    weights=(*_LAST, 1.0, 1.0),
    error=(0.0, 0.0, 0.0, 0.0, 0.0, 1.0),
    order=4,
)
"""Hairer & Wanner 1996: order 4 with an error estimate of order 3, stiffly accurate (code RODAS)."""

_LAST5 = (
    -7.502846399306121,
    2.561846144803919,
    -11.627539656261098,
    -0.18268767659942256,
    0.030198172008377946,
)
"""The same for RODAS 5P."""

RODAS5P = rosenbrock(
    gamma=0.21193756319429014,
    rows=(
        (),
        (3.0,),
        (2.849394379747939, 0.45842242204463923),
        (-6.954028509809101, 2.489845061869568, -10.358996098473584),
        (2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641),
        _LAST5,
        (*_LAST5, 1.0),
        (*_LAST5, 1.0, 1.0),
    ),
    coupling=(
        (),
        (-14.155112264123755,),
        (-17.97296035885952, -2.859693295451294),
        (147.12150275711716, -1.41221402718213, 71.68940251302358),
        (165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306),
        (24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125, -0.6610691825249471),
        (
            30.91273214028599,
            -3.1208243349937974,
            77.79954646070892,
            34.28646028294783,
            -19.097331116725623,
            -28.087943162872662,
        ),
        (
            37.80277123390563,
            -3.2571969029072276,
            112.26918849496327,
            66.9347231244047,
            -40.06618937091002,
            -54.66780262877968,
            -9.48861652309627,
        ),
    ),
    times=(
        0.0,
        0.6358126895828704,
        0.4095798393397535,
        0.9769306725060716,
        0.4288403609558664,
        1.0,
        1.0,
        1.0,
    ),
    time_weights=(
        0.21193756319429014,
        -0.42387512638858027,
        -0.3384627126235924,
        1.8046452872882734,
        2.325825639765069,
        0.0,
        0.0,
        0.0,
    ),
    weights=(*_LAST5, 1.0, 1.0, 1.0),
    error=(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0),
    order=5,
)
"""Steinebach 2023: order 5 with an error estimate of order 4, stiffly accurate."""
