"""Formulas of quantities, such as `sqrt(mass0.vx^2 + mass0.vy^2)`: text to a tree, and a tree to numbers.

A formula is data. Its grammar, in which `name` is that of a quantity:

    sum      = product {("+" | "-") product}
    product  = signed {("*" | "/") signed}
    signed   = "-" signed | power
    power    = single ["^" signed]
    single   = number ["[" unit "]"] | name | function "(" sum {"," sum} ")" | "(" sum ")"

An exponent has no quantity in it, and is a multiple of 1/2. Units are checked and derived while a text is
read.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from ..errors import InputError
from ..text import Text
from .dimensions import DEGREES, PURE, Dimension, read_unit

MAX_LENGTH = 200
"""Letters of a formula, at most."""

MAX_DEPTH = 20
"""Brackets, functions, signs and exponents inside each other, at most."""

MAX_EXPONENT = 99
"""Largest magnitude of an exponent; larger ones are refused."""

_SHOWN = 40
"""Letters of a part of a formula that a message shows."""

NAME = r"[a-z]+(?:\d{1,9}|\[[\d., ]{1,190}\])?\.[a-z_]+"
"""What looks like the name of a quantity."""

_TOKEN = re.compile(
    rf" *(?:(?P<name>{NAME})|(?P<word>[A-Za-z_][A-Za-z0-9_]*)"
    r"|(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?)"
    r"|\[(?P<unit>[^\]]*)\]|(?P<sign>[-+*/^(),]))",
    re.ASCII,
)

_DECIMALS = re.compile(r",\d+", re.ASCII)
"""What stands after a number that is written with a decimal comma."""

_DO: dict[str, Callable[..., float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "^": math.pow,
    "negative": lambda value: -value,
    "abs": math.fabs,
    "sqrt": math.sqrt,
    "sin": lambda angle: math.sin(math.radians(angle)),
    "cos": lambda angle: math.cos(math.radians(angle)),
    "atan2": lambda y, x: math.degrees(math.atan2(y, x)),
}

_ARGUMENTS = {"abs": 1, "atan2": 2, "cos": 1, "sin": 1, "sqrt": 1}
"""The functions, and of how many values each is."""


@dataclass(frozen=True)
class Number:
    """A number, in the unit that softrod has for its dimension."""

    value: float


@dataclass(frozen=True)
class Measured:
    """The value of the quantity at a place in `Formula.names`."""

    index: int


@dataclass(frozen=True)
class Call:
    """An operation, a key of `_DO`, and what it is done with."""

    do: str
    of: tuple[Node, ...]


Node = Number | Measured | Call


@dataclass(frozen=True)
class Formula:
    """A formula that was read.

    Attributes:
        tree: what is computed.
        names: of its quantities, each once.
        dimension: of its value.
        unwrapped: whether its value is defined but for whole turns: a sum of angles that go on beyond half a
            turn.
    """

    tree: Node
    names: tuple[str, ...]
    dimension: Dimension
    unwrapped: bool

    def value(self, values: Sequence[float]) -> float:
        """Its value for those of its `names`; NaN where it has none, as after a division by zero."""
        try:
            found = float(_value(self.tree, values))
        except (ArithmeticError, ValueError):
            return math.nan
        return found if math.isfinite(found) else math.nan


def _value(node: Node, values: Sequence[float]) -> float:
    if isinstance(node, Number):
        return node.value
    if isinstance(node, Measured):
        return values[node.index]
    return _DO[node.do](*(_value(each, values) for each in node.of))


class Leaf(Protocol):
    """What has to be known of a quantity in a formula."""

    @property
    def dimension(self) -> Dimension: ...
    @property
    def unwrapped(self) -> bool: ...


def read_formula(text: str, find: Callable[[str], Leaf], length: str) -> Formula:
    """Read a formula.

    Args:
        text: the formula, of at most `MAX_LENGTH` letters.
        find: returns a quantity by its name; raises `InputError`.
        length: the scene's unit of length.

    Raises:
        InputError: it is not a formula, has no quantity in it, or its units do not fit.
    """
    return _Reader(text, find, length).read()


class _Token(NamedTuple):
    kind: str  # a group of `_TOKEN`; "end" after the last
    text: str
    begin: int
    end: int


class _Part(NamedTuple):
    """A part of a formula that was read.

    Attributes:
        node, dimension: what it is.
        begin, end: where it stands in the text.
        measured: whether there is a quantity in it.
        turns: whether there is an angle in it that goes on beyond half a turn.
        unwrapped: whether it is defined but for whole turns, see `Formula`.
    """

    node: Node
    dimension: Dimension
    begin: int
    end: int
    measured: bool = False
    turns: bool = False
    unwrapped: bool = False


class _Reader:
    """Reads one formula, from left to right."""

    def __init__(self, text: str, find: Callable[[str], Leaf], length: str) -> None:
        self._text, self._find, self._length = text, find, length
        self._tokens = self._split()
        self._at = self._depth = self._pairs = (
            0  # the last: functions around it whose values a comma separates
        )
        self._names: dict[str, int] = {}

    def read(self) -> Formula:
        part = self._sum()
        if self._next.kind != "end":
            raise self._unexpected()
        if not part.measured:
            raise InputError(
                Text(
                    "{formula}: a formula has at least one quantity, such as mass0.x",
                    formula=_short(self._text),
                )
            )
        return Formula(part.node, tuple(self._names), part.dimension, part.unwrapped)

    # --------------------------------------------------------------------- tokens
    def _split(self) -> list[_Token]:
        found, at, end = [], 0, len(self._text.rstrip(" "))
        while at < end:
            match = _TOKEN.match(self._text, at)
            if match is None:
                sign = self._text[at:].lstrip(" ")[0]
                raise InputError(
                    Text(
                        "{formula}: {sign!r} has no place in a formula", formula=_short(self._text), sign=sign
                    )
                )
            kind = match.lastgroup or ""
            found.append(_Token(kind, match[kind], match.end() - len(match[0].lstrip(" ")), match.end()))
            at = match.end()
        return [*found, _Token("end", "", end, end)]

    @property
    def _next(self) -> _Token:
        return self._tokens[self._at]

    def _takes(self, *signs: str) -> str:
        """Go on beyond one of some signs, and return it; empty if another token is next."""
        token = self._next
        if token.kind != "sign" or token.text not in signs:
            return ""
        self._at += 1
        return token.text

    def _unexpected(self) -> InputError:
        token = self._next
        before = self._text[: token.begin].rstrip(" ")
        if token.kind == "end":
            return InputError(Text("{formula}: something is missing at the end", formula=_short(self._text)))
        found = _short(self._text[token.begin : token.end])
        if not before:
            return InputError(Text("{found} is not expected at the beginning", found=found))
        return InputError(
            Text("{found} is not expected after {before}", found=found, before=_short(before, last=True))
        )

    def _told(self, part: _Part) -> str:
        """A part, and its unit."""
        unit = part.dimension.unit.format(unit=self._length) or Text("a pure number")
        return Text("{part} ({unit})", part=_short(self._text[part.begin : part.end]), unit=unit)

    def _fails(self, begin: int, error: InputError) -> InputError:
        """The error of a dimension, told of what was read last."""
        said = str(error)
        assert isinstance(said, Text), "it has a place for it"
        return InputError(said.with_parts(of=_short(self._text[begin : self._tokens[self._at - 1].end])))

    # --------------------------------------------------------------------- the grammar
    def _sum(self) -> _Part:
        left = self._product()
        while sign := self._takes("+", "-"):
            right = self._product()
            if left.dimension != right.dimension:
                one, other = self._told(left), self._told(right)
                if sign == "+":
                    why = Text("{one} and {other} cannot be added: their units differ", one=one, other=other)
                else:
                    why = Text(
                        "{one} and {other} cannot be subtracted: their units differ", one=one, other=other
                    )
                if PURE in (left.dimension, right.dimension):
                    unit = (left if right.dimension == PURE else right).dimension.unit
                    why = Text(
                        "{error}; a number has a unit as in 5 [{unit}]",
                        error=why,
                        unit=unit.format(unit=self._length),
                    )
                raise InputError(why)
            left = self._joined(sign, left.dimension, left, right)._replace(
                unwrapped=all(part.unwrapped or not part.turns for part in (left, right))
                and (left.turns or right.turns)
            )
        return left

    def _product(self) -> _Part:
        left = self._signed()
        while sign := self._takes("*", "/"):
            right = self._signed()
            try:
                dimension = left.dimension.times(right.dimension, 1.0 if sign == "*" else -1.0)
            except InputError as error:
                raise self._fails(left.begin, error) from None
            left = self._joined(sign, dimension, left, right)
        return left

    def _signed(self) -> _Part:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise InputError(
                Text(
                    "{formula}: there are more than {most} brackets, signs or exponents inside each other",
                    formula=_short(self._text),
                    most=MAX_DEPTH,
                )
            )
        begin = self._next.begin
        if self._takes("-"):
            part = self._signed()
            part = part._replace(node=Call("negative", (part.node,)), begin=begin)
        else:
            part = self._power()
        self._depth -= 1
        return part

    def _power(self) -> _Part:
        base = self._single()
        if not self._takes("^"):
            return base
        exponent = self._signed()
        shown = _short(self._text[exponent.begin : exponent.end])
        if exponent.measured or exponent.dimension != PURE:
            raise InputError(
                Text("the exponent {shown} is not a pure number without a quantity", shown=shown)
            )
        power = Formula(exponent.node, (), PURE, False).value(())
        if not abs(power) <= MAX_EXPONENT or 2.0 * power != round(2.0 * power):
            raise InputError(
                Text(
                    "the exponent {shown} is not a multiple of 1/2 up to {most}",
                    shown=shown,
                    most=MAX_EXPONENT,
                )
            )
        try:
            dimension = PURE.times(base.dimension, power)
        except InputError as error:
            raise self._fails(base.begin, error) from None
        return self._joined("^", dimension, base, exponent)._replace(
            node=Call("^", (base.node, Number(power)))
        )

    def _single(self) -> _Part:
        token = self._next
        self._at += 1
        if token.kind == "number":
            return self._number(token)
        if token.kind == "name" or (token.kind == "word" and self._next.text != "("):
            leaf = self._find(token.text)
            index = self._names.setdefault(token.text, len(self._names))
            return _Part(
                Measured(index), leaf.dimension, token.begin, token.end, True, leaf.unwrapped, leaf.unwrapped
            )
        if token.kind == "word":
            return self._function(token)
        if (token.kind, token.text) == ("sign", "("):
            part = self._sum()
            self._close()
            return part._replace(begin=token.begin, end=self._tokens[self._at - 1].end)
        self._at -= 1
        raise self._unexpected()

    def _number(self, token: _Token) -> _Part:
        if not self._pairs and (decimals := _DECIMALS.match(self._text, token.end)):
            found = token.text + decimals[0]
            raise InputError(
                Text(
                    "{found} has a comma: in a formula a number is written with a point, as {better}",
                    found=_short(found),
                    better=found.replace(",", "."),
                )
            )
        value, end, dimension = float(token.text), token.end, PURE
        if self._next.kind == "unit":
            factor, dimension = read_unit(self._next.text, self._length)
            value, end = value * factor, self._next.end
            self._at += 1
        if not math.isfinite(value):
            raise InputError(Text("{number} is not a finite number", number=token.text))
        return _Part(Number(value), dimension, token.begin, end)

    def _function(self, token: _Token) -> _Part:
        if token.text not in _ARGUMENTS:
            raise InputError(
                Text(
                    "{name!r} is not a function: there are {known}",
                    name=token.text,
                    known=", ".join(_ARGUMENTS),
                )
            )
        self._at += 1
        has_pair = _ARGUMENTS[token.text] > 1
        self._pairs += has_pair
        parts = [self._sum()]
        while self._takes(","):
            parts.append(self._sum())
        self._close()
        self._pairs -= has_pair
        name, count = token.text, _ARGUMENTS[token.text]
        if len(parts) != count:
            given = len(parts)
            raise InputError(
                Text("{name} is of one value, and not of {count}", name=name, count=given)
                if count == 1
                else Text("{name} is of two values, and not of {count}", name=name, count=given)
            )
        dimension = parts[0].dimension
        if name in ("sin", "cos"):
            if dimension != DEGREES:
                raise InputError(
                    Text(
                        "{name} is of an angle, and not of {value}; a number is one as in 30 [°]",
                        name=name,
                        value=self._told(parts[0]),
                    )
                )
            dimension = PURE
        elif name == "atan2":
            if dimension != parts[1].dimension:
                one, other = map(self._told, parts)
                raise InputError(
                    Text(
                        "atan2 is of two values in the same unit, and not of {one} and {other}",
                        one=one,
                        other=other,
                    )
                )
            dimension = DEGREES
        elif name == "sqrt":
            try:
                dimension = PURE.times(dimension, 0.5)
            except InputError as error:
                raise self._fails(token.begin, error) from None
        return self._joined(name, dimension, *parts)._replace(
            begin=token.begin, end=self._tokens[self._at - 1].end
        )

    def _close(self) -> None:
        if not self._takes(")"):
            raise self._unexpected()

    @staticmethod
    def _joined(do: str, dimension: Dimension, *parts: _Part) -> _Part:
        return _Part(
            Call(do, tuple(part.node for part in parts)),
            dimension,
            parts[0].begin,
            parts[-1].end,
            any(part.measured for part in parts),
            any(part.turns for part in parts),
        )


def _short(text: str, last: bool = False) -> Text:
    """A part of a formula for a message, with quotes: its beginning, or its last letters, if it is long."""
    if len(text) > _SHOWN:
        text = f"…{text[1 - _SHOWN :]}" if last else f"{text[: _SHOWN - 1]}…"
    return Text("{text!r}", text=text)
