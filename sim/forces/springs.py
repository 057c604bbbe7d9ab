"""Linear springs: force, energy, derivatives; `runs` has the sum of the forces of springs and joints.

A spring with the vector L = b - a, px, the stiffness k, kg/s², and the damping c, kg/s, has the tension
T = (R / |L| - k - c (L . L') / |L|²) L on its b end, and -T acts on a. R = k times the rest length, kg px/s²,
is its rest tension. Its energy is k (|L| - rest length)² / 2.

Let L be the vector of a spring and perp(L) = (L.y, -L.x). A joint that holds springs A and B has a torque G
and, under a law with an energy, the energy U. Its force on the b end of its first spring is -dU/dA, which is
-G perp(A) / |A|² and a part along A; that on the b end of its second spring +G perp(B) / |B|² and a part
along B. With V the angle from A to B and r the rest angle, the laws are

- tutorial: G = K |A||B| sin(V - r), without the parts along the springs;
- conservative: the same G, U = K |A||B| (1 - cos(V - r)) = K (|A||B| - A . R(-r) B);
- angle: G = K |A||B| (V - r), U = K |A||B| (V - r)² / 2;

and only the last needs trigonometric functions beyond cos r and sin r, which are in the tables. Angular
damping adds C |A||B| dV/dt to G.

The force of a spring that shrinks to a point would jump there, and a body may tend to exactly that point. So
the length of a spring is computed as sqrt(L² + softening), also in energies, with a softening far too small
to be seen and practically none for methods with a fixed step. A . R(-r) B is not softened, and in the angle
law |L| becomes L² / sqrt(L² + softening), since V is undefined at a point.
"""

from __future__ import annotations

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.lanes import eight_at_a_time
from ..engine.numerics.blocks import add_block
from ..engine.numerics.vectors import from_to, inverse_of, length_of
from ..engine.table import Floats, Indices
from ..engine.tables import Body, State
from .term import Vectors, summed


@kernel(inline="always")
def tension(x, y, inv, u, v, rest_tension, stiffness, damping):
    """The force on the b end of a spring per vector, kg/s²; x, y: its vector, u, v: the rate of that."""
    return rest_tension * inv - stiffness - damping * (x * u + y * v) * (inv * inv)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def accelerations_by(body, state, scratch, vx, vy, a):
    """Accelerations by the forces in `scratch.fx` and `scratch.fy`, gravity, and the tutorial's still air."""
    eight_at_a_time()
    slots = vx.size
    fx, fy, ax, ay = scratch.fx, scratch.fy, a[:slots], a[slots:]
    w, air, gx, gy = state.inverse_mass, state.air, state.gx, state.gy
    for i in range(1, body.masses + 1):
        ax[i] = fx[i] * w[i] - air[i] * (vx[i] * abs(vx[i])) + gx[i]
    for i in range(1, body.masses + 1):
        ay[i] = fy[i] * w[i] - air[i] * (vy[i] * abs(vy[i])) + gy[i]


@kernel(forceinline=True, fastmath=FAST)
def spring_force(body, state, q, s):
    """The force of a spring without its damping, k (|L| - rest length), kg px/s²; positive where it pulls.

    Zero where a spring that acts on one side only does not act.
    """
    x, y = from_to(q, body.spring_a[s], body.spring_b[s])
    force = body.stiffness[s] * length_of(x, y, body.softening) - state.rest_tension[s]
    sides = body.environment.one_sided.spring_side
    return 0.0 if sides.size > 0 and sides[s] * force < 0.0 else force


@kernel(fastmath=FAST)
def spring_energies(body, state, q):
    """The energy of all springs, the sum of k (|L| - rest length)² / 2, kg px²/s²."""
    energy = 0.0
    for s in range(body.springs):
        if body.stiffness[s] > 0.0:
            force = spring_force(body, state, q, s)
            energy += 0.5 * force * force / body.stiffness[s]
    return energy


@kernel(fastmath=FAST)
def spring_power_of_keys(body, state, growth, q):
    """The power of keys that let all rest lengths grow at the rate `growth`, 1/s; kg px²/s³."""
    power = 0.0
    for s in range(body.springs):
        if body.stiffness[s] > 0.0:
            rest = state.rest_tension[s] / body.stiffness[s]
            if body.limits.present:  # what has yielded does not grow
                rest = state.trial_tension[s] / body.stiffness[s] - state.set_length[s]
            power -= spring_force(body, state, q, s) * growth * rest
    return power


@kernel(forceinline=True, fastmath=FAST)
def spring_block(stiffness, damping, rest_tension, inv, vector, rate, g, definite):
    """The derivative of a spring's tension by its vector, plus g times that by its rate, kg/s².

    With T = e L and e = R / |L| - k - c (L . L') / |L|², it is e I + L (de/dL)ᵀ, where

        de/dL = (-R / |L|³ + 2 c (L . L') / |L|⁴) L - c L' / |L|²,

    and the derivative by L' is -c L Lᵀ / |L|². `inv` is 1 / |L|. With `definite`, what could make the matrix
    of an implicit step indefinite is left out: the sideways push of a compressed spring, and the turning of
    the damping force.
    """
    x, y = vector
    inv2 = inv * inv
    if definite:
        taut = max(stiffness - rest_tension * inv, 0.0)
        along = (stiffness - taut + g * damping) * inv2
        return -taut - along * x * x, -along * x * y, -along * x * y, -taut - along * y * y
    speed = x * rate[0] + y * rate[1]
    e = rest_tension * inv - stiffness - damping * speed * inv2
    radial = -rest_tension * inv * inv2 + 2.0 * damping * speed * inv2 * inv2 - g * damping * inv2
    ex = radial * x - damping * inv2 * rate[0]
    ey = radial * y - damping * inv2 * rate[1]
    return e + x * ex, x * ey, y * ex, e + y * ey


@kernel(fastmath=FAST)
def add_spring_derivatives(body, state, matrix, q, v, g, definite):
    """Add the derivatives of all springs' forces to `matrix.blocks`; see `term.Term.add_derivatives`.

    The force T(L) of a spring acts on its b end and -T on a. With L = b - a, a block dT/dL belongs at row and
    column bb and aa, and minus it at ba and ab.
    """
    for s in range(body.springs):
        a, b = body.spring_a[s], body.spring_b[s]
        vector, rate = from_to(q, a, b), from_to(v, a, b)
        inverse = inverse_of(vector[0], vector[1], body.softening)
        block = spring_block(
            body.stiffness[s], body.damping[s], state.rest_tension[s], inverse, vector, rate, g, definite
        )
        for k, sign in enumerate((1.0, -1.0, -1.0, 1.0)):
            add_block(matrix.blocks, matrix.spring_target[4 * s + k], sign, block)


@kernel(fastmath=FAST)
def add_spring_damping(body, state, q, v, z, factor, out):
    """A damper's force on its b end is -c u (u . L'), with the unit vector u and the rate L' of a spring."""
    w, slots = state.inverse_mass, z.size // 2
    for s in range(body.springs if body.damped else 0):
        a, b = body.spring_a[s], body.spring_b[s]
        (x, y), (zx, zy) = from_to(q, a, b), from_to(z, a, b)
        inverse = inverse_of(x, y, body.softening)
        along = -factor * body.damping[s] * (x * zx + y * zy) * (inverse * inverse)
        out[b] += w[b] * along * x
        out[slots + b] += w[b] * along * y
        out[a] -= w[a] * along * x
        out[slots + a] -= w[a] * along * y


# ------------------------------------------------------------------------- in NumPy
class SpringsReference:
    """Springs in NumPy; see `Reference`.

    Args:
        body, state: the tables.
        rows: indices of springs in the tables; without it, all of them.

    Attributes:
        stiffness, damping: (k,) kg/s², kg/s; may be replaced.
        rest_tension: (k,) stiffness times rest length, kg px/s².
    """

    def __init__(self, body: Body, state: State, rows: Indices | slice = slice(None)) -> None:
        self._a, self._b, self._softening = body.spring_a[rows], body.spring_b[rows], body.softening
        sides = body.environment.one_sided.spring_side
        self._sides = sides[rows] if sides.size else np.zeros(self._a.size)
        self.stiffness, self.damping, self.rest_tension = (
            numbers[: body.springs][rows] for numbers in (body.stiffness, body.damping, state.rest_tension)
        )
        self._ends = np.concatenate((self._b, self._a))

    def forces(self, x: Vectors, v: Vectors, only: np.ndarray | None = None) -> Vectors:
        """See `Reference`; as if all acted on both sides. `only`: (k,) those that are wanted, or all."""
        spring, per_length = self._tensions(x, v)
        tension = per_length * spring if only is None else per_length * spring * only
        return summed(self._ends, np.concatenate((tension, -tension)), x.size)

    def acting(self, x: Vectors, v: Vectors) -> np.ndarray:
        """(k,) whether each spring acts; those that act on one side do not turn their force round."""
        elastic, whole = self._pulls(x, np.zeros_like(x)), self._pulls(x, v)
        return (self._sides == 0.0) | ((self._sides * elastic > 0.0) & (self._sides * whole > 0.0))

    def pulls(self, x: Vectors, v: Vectors) -> Floats:
        """(k,) the force of each spring along itself, kg px/s²; positive where it pulls."""
        return np.where(self.acting(x, v), self._pulls(x, v), 0.0)

    def brace(self, x: Vectors) -> None:
        """See `Bracing`."""
        slack = self._sides * self._pulls(x, np.zeros_like(x)) < 0.0
        length = np.sqrt(abs(x[self._b] - x[self._a]) ** 2 + self._softening)
        self.rest_tension = np.where(slack, self.stiffness * length, self.rest_tension)
        self._sides = np.zeros_like(self._sides)

    def _pulls(self, x: Vectors, v: Vectors) -> Floats:
        """As `pulls`, as if all acted at both sides."""
        spring, per_length = self._tensions(x, v)
        return -per_length * np.hypot(spring.real, spring.imag)

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        pulls = (self.stiffness > 0.0) & ~(self._sides * self._pulls(x, np.zeros_like(x)) < 0.0)
        rest = self.rest_tension[pulls] / self.stiffness[pulls]
        length = abs(x[self._b] - x[self._a])[pulls]
        return 0.5 * float((self.stiffness[pulls] * (length - rest) ** 2).sum())

    def _tensions(self, x: Vectors, v: Vectors) -> tuple[Vectors, Floats]:
        """(k,) vectors of the springs, px, and the force on the b end of each per length, kg/s²."""
        spring, rate = x[self._b] - x[self._a], v[self._b] - v[self._a]
        square = spring.real**2 + spring.imag**2 + self._softening
        along = (rate * spring.conj()).real / square
        return spring, self.rest_tension / np.sqrt(square) - self.stiffness - self.damping * along
