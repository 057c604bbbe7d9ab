"""The table of contact between masses and linear springs, and of the pairs that may touch."""

from __future__ import annotations

from .table import Floats, Indices, Table


class Contacts(Table):
    """S springs, B buckets. The arrays from `number` on change while a body moves; the others are read-only.

    The pairs that may touch are listed spring by spring, with the masses of each in ascending order. So sums
    over them do not depend, even by rounding, on where the masses were when the list was made.
    """

    present: bool
    distance: float  # px
    stiffness: float  # kg/(px s²)
    friction: float
    slip: float  # px/s
    loss: float  # s/px, the factor of the speed in the damping
    margin: float  # px, by which pairs that are listed may be farther apart than `distance`
    cell: float  # px, width of a cell of the grid
    apart_start: Indices  # (S + 1,) where the masses of each spring start in `apart`
    apart: Indices  # slots of the masses that never touch a spring, ascending
    broken: Floats  # (S,) 1 for a spring that is broken and touches nothing any more, else 0
    # The list
    number: Floats  # (1,) the margin with which it was made, px; negative if there is none
    crowded: Indices  # (1,) 1 if it has no room for all pairs: those of a spring are then found when needed
    at: Floats  # (2 slots) positions for which it was made, px
    start: Indices  # (S + 1,) where the masses of each spring start in `member`
    member: Indices  # slots of masses
    # A grid of square cells in a hash table
    bucket_start: Indices  # (B + 1,) where the masses of each bucket start in `bucket`; B is a power of two
    bucket: Indices  # (n,) slots of masses
    column: Indices  # (slots,) the cell of each mass
    row: Indices
