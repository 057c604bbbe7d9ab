"""Tables and records: groups of arrays and numbers that are passed to a kernel as one pointer.

A kernel needs about a hundred arrays. As separate arguments they would take seven machine words each at every
call, which takes longer than a step of a short rope, and compiling that takes longer than compiling the
arithmetic. A table is an object with typed, read-only attributes: numbers, arrays and other tables. Its
values are stored in a block of memory, from which compiled code loads only those that it uses.
`body.stiffness` is the array both in Python and in a kernel.

A record is a table whose numbers change: Python and kernels read `run.time` and write `run.time = 0.0`.
"""

from __future__ import annotations

import ctypes
import inspect
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Self, dataclass_transform

import numpy as np
from llvmlite import ir
from numba import types
from numba.core.errors import TypingError
from numba.core.imputils import lower_setattr_generic
from numba.core.typing.templates import AttributeTemplate
from numba.extending import (
    NativeValue,
    infer_getattr,
    lower_getattr_generic,
    models,
    register_model,
    typeof_impl,
    unbox,
)
from numba.np.arrayobj import populate_array
from numpy.typing import NDArray

Floats = NDArray[np.float64]
"""A one-dimensional array of floats."""
Rows = NDArray[np.float64]
"""A two-dimensional array of floats."""
Indices = NDArray[np.int64]
"""A one-dimensional array of integers."""

# By the name of a field's annotation: numba's type of a number, or item type and dimensions of an array.
_NUMBERS = {"int": types.int64, "bool": types.boolean, "float": types.float64}
_ARRAYS = {"Floats": (types.float64, 1), "Rows": (types.float64, 2), "Indices": (types.int64, 1)}
_WORD, _DOUBLE = ir.IntType(64), ir.DoubleType()  # LLVM's types
_ITEM = 8
"""Size of a float, an integer and a pointer, bytes."""
_AT: Any = (ctypes.c_char * 0).from_buffer  # zero bytes at the start of any writable buffer


class _Field(NamedTuple):
    """One field of a table."""

    start: int  # offset of its value, in words from the start of the block
    type: types.Type  # numba's type
    dtype: np.dtype[Any] | None = None  # for an array
    dimensions: int = 0  # for an array
    is_float: bool = False


class TableType(types.Type):
    """numba's type of the tables of one class; `mutable`: whether their numbers change."""

    def __init__(self, name: str, mutable: bool) -> None:
        super().__init__(f"{'Record' if mutable else 'Table'}({name})")
        self.class_name, self.mutable = name, mutable

    @property
    def fields(self) -> dict[str, _Field]:
        """The fields of a table of this type, by name."""
        return _CLASSES[self.class_name].fields


_CLASSES: dict[str, type[_Block]] = {}
"""All tables and records, by name."""


class _Block:
    """Base of tables and records; a subclass declares its fields as annotated attributes.

    Raises:
        TypeError: a field is missing or unknown, or an array does not have the type that the kernels expect.
    """

    mutable: ClassVar[bool] = False
    changing: ClassVar[frozenset[str]] = frozenset()  # fields of a table whose arrays change nevertheless
    _bytes: ClassVar[int]  # size of the block
    numbers: ClassVar[tuple[str, ...]]  # for a record: names of the number fields
    _starts: ClassVar[list[int]]  # offsets of these, as in `_Field`
    _others: ClassVar[set[str]]  # names of all other fields
    fields: ClassVar[dict[str, _Field]]
    tables: ClassVar[frozenset[str]]  # names of the table fields
    numba_type: ClassVar[TableType]
    _numba_type_: ClassVar[TableType]

    def __init_subclass__(cls) -> None:
        cls.fields, start = {}, 0
        for name, kind in inspect.get_annotations(cls).items():
            if kind in _ARRAYS:
                item, dimensions = _ARRAYS[kind]
                dtype = np.dtype(float if item == types.float64 else np.int64)
                cls.fields[name] = _Field(start, types.Array(item, dimensions, "C"), dtype, dimensions)
                start += 1 + dimensions
            else:
                # A field's table may be declared later, but not its subclass.
                table = _CLASSES[kind].numba_type if kind in _CLASSES else TableType(kind, False)
                type_ = _NUMBERS.get(kind, table)
                cls.fields[name] = _Field(start, type_, is_float=kind == "float")
                start += 1
        cls.tables = frozenset(n for n, f in cls.fields.items() if isinstance(f.type, TableType))
        cls._bytes = _ITEM * start
        cls.numba_type = TableType(cls.__name__, cls.mutable)
        cls._numba_type_ = cls.numba_type  # numba checks this attribute before it calls `typeof_impl`
        _CLASSES[cls.__name__] = cls

    def __init__(self, **values: Any) -> None:
        if values.keys() != self.fields.keys():
            raise TypeError(f"{type(self).__name__}: {sorted(values.keys() ^ self.fields.keys())}")
        self._fill(bytearray(self._bytes), values)

    def _fill(self, block: bytearray, values: dict[str, Any]) -> None:
        """Store values, and write them into a block that contains all others."""
        wholes, floats = memoryview(block).cast("q"), memoryview(block).cast("d")
        self.__dict__.update(_wholes=wholes, _floats=floats, _address=ctypes.addressof(_AT(block)))
        self._write(values)

    def _write(self, values: dict[str, Any]) -> None:
        """Store values, and write them into the block."""
        wholes, floats, fields = self.__dict__["_wholes"], self.__dict__["_floats"], self.fields
        for name, value in values.items():
            start, _, dtype, dimensions, is_float = fields[name]
            if dtype is not None:
                if value.dtype != dtype or value.ndim != dimensions or not value.flags.c_contiguous:
                    raise TypeError(f"{type(self).__name__}.{name}: {value.dtype}, {value.shape}")
                wholes[start], wholes[start + 1] = address_of(value), len(value)
                if dimensions == 2:
                    wholes[start + 2] = value.shape[1]
            elif is_float:
                floats[start] = value
            else:
                wholes[start] = value.address() if isinstance(value, _Block) else int(value)
        self.__dict__.update(values)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """Return an array or a table from a `Memory`, made on first use."""
            memory, part = self.__dict__.get("_made_of", (None, None))
            if memory is None or name not in part.fields:
                raise AttributeError(f"{type(self).__name__} has no {name}")
            value = self.__dict__[name] = memory.of(part.fields[name])
            return value

    @property
    def memory(self) -> Memory:
        """The memory of a table made by a `Layout`."""
        return self.__dict__["_made_of"][0]

    def address(self) -> int:
        """The address of the block."""
        return self.__dict__["_address"]

    def words(self) -> list[int]:
        """Return the contents of the block, as integers."""
        return self.__dict__["_wholes"].tolist()

    def fill_in(self, **values: Any) -> None:
        """Set values in a table that has not been used yet."""
        self._write(values)

    @classmethod
    def empty(cls) -> Self:
        """Return a table with empty arrays and zero numbers, and the same for nested tables."""

        def nothing(field: _Field) -> Any:
            if field.dtype is not None:
                return np.zeros((0,) * field.dimensions, field.dtype)
            return _CLASSES[field.type.class_name].empty() if isinstance(field.type, TableType) else 0

        return cls(**{name: nothing(field) for name, field in cls.fields.items()})

    def read_only(self) -> Self:
        """Make all arrays read-only, nested tables included, except for `changing`; return the table."""
        known = self.__dict__
        if "_is_read_only" not in known:
            for name, field in self.fields.items():
                if name not in self.changing and (field.dtype is not None or name in self.tables):
                    part = known[name]
                    part.setflags(write=False) if field.dtype is not None else part.read_only()
            known["_is_read_only"] = True
        return self

    def arrays(self) -> Iterator[tuple[str, NDArray[Any]]]:
        """Yield the names and values of the array fields."""
        for name in self.fields:
            if isinstance(value := getattr(self, name), np.ndarray):
                yield name, value


class Part(NamedTuple):
    """A table in a `Memory`.

    Attributes:
        kind: its class.
        begin, end: range of its words among all words.
        same: values that all copies of the memory share, by name.
        fields: by name, for each array the start and end of its numbers in `Memory.room` and the length of
            its rows, or 0; for each table, its index among all tables.
    """

    kind: type[_Block]
    begin: int
    end: int
    same: dict[str, Any]
    fields: dict[str, tuple[int, int, int] | int]


class Memory:
    """Storage of tables that are copied together; each is made on first use.

    Args:
        room: the arrays of all of them.
        words: the words of all of them.
        parts: the tables.

    Attributes:
        room, words: as above.
    """

    def __init__(self, room: Floats, words: Indices, parts: list[Part]) -> None:
        self.room, self.words, self._parts = room, words, parts
        self._wholes, self._address = words.data, address_of(words)
        self._floats = self._wholes.cast("B").cast("d")

    def of(self, field: tuple[int, int, int] | int) -> Any:
        """Return an array or a table, see `Part.fields`."""
        if isinstance(field, int):
            part = self._parts[field]
            kind, begin, end, same, _ = part
            table = object.__new__(kind)
            table.__dict__.update(
                same,
                _wholes=self._wholes[begin:end],
                _floats=self._floats[begin:end],
                _address=self._address + _ITEM * begin,
                _made_of=(self, part),
            )
            return table
        begin, end, width = field
        return self.room[begin:end].reshape(-1, width) if width else self.room[begin:end]


def address_of(array: NDArray[Any]) -> int:
    """Return the address of an array's elements."""
    try:
        return ctypes.addressof(_AT(array))  # in a fifth of the time that numpy takes
    except TypeError:  # it is read-only
        return array.__array_interface__["data"][0]


@dataclass_transform(kw_only_default=True, frozen_default=True)
class Table(_Block):
    """The base of all tables."""

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__}.{name}: a table is read-only; see `replaced`")

    def replaced(self, **changes: Any) -> Self:
        """Return a copy of the table with other values in some fields; arrays are not copied."""
        copy = object.__new__(type(self))
        copy.__dict__.update(self.__dict__)
        copy.__dict__.pop("_is_read_only", None)
        copy._fill(bytearray(self.__dict__["_wholes"]), changes)
        return copy

    def copied(self) -> Self:
        """Return a copy of the table with copies of all its arrays."""
        return self.replaced(**{name: array.copy() for name, array in self.arrays()})


class Record(_Block):
    """The base of all records: their numbers can be set and are initially zero; their arrays are fixed."""

    mutable = True

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.numbers = tuple(
            n for n, f in cls.fields.items() if isinstance(f.type, (types.Number, types.Boolean))
        )
        cls._starts = [cls.fields[name].start for name in cls.numbers]
        cls._others = cls.fields.keys() - set(cls.numbers)
        for name, field in cls.fields.items():
            setattr(cls, name, _number(field) if name in cls.numbers else _unchanging(name))

    def __init__(self, **values: Any) -> None:
        if not self._others <= values.keys() <= self.fields.keys():
            super().__init__(**values)  # which raises the right error
        self._fill(bytearray(self._bytes), values)

    @classmethod
    def place(cls, name: str) -> int:
        """Return the index of a number in `wholes` and `floats`."""
        return cls.fields[name].start

    @property
    def wholes(self) -> memoryview:
        """All words of the record, as integers.

        Reading one takes a third of the time of an attribute, so this is for values read after each step of a
        short body.
        """
        return self.__dict__["_wholes"]

    @property
    def floats(self) -> memoryview:
        """All words of the record, as floats."""
        return self.__dict__["_floats"]

    def clear(self) -> None:
        """Set all numbers to zero."""
        words = self.__dict__["_wholes"]
        for start in self._starts:
            words[start] = 0

    def contents(self) -> tuple[int, ...]:
        """Return all numbers, as words."""
        words = self.__dict__["_wholes"]
        return tuple([words[start] for start in self._starts])

    def put(self, contents: tuple[int, ...]) -> None:
        """Set all numbers to what `contents` has returned."""
        words = self.__dict__["_wholes"]
        for start, word in zip(self._starts, contents, strict=True):
            words[start] = word

    def take_over(self, other: Self) -> None:
        """Copy all numbers from another record."""
        words, others = self.__dict__["_wholes"], other.__dict__["_wholes"]
        for start in self._starts:
            words[start] = others[start]


def _unchanging(name: str) -> property:
    """Return an array or a table of a record as a Python property."""

    def value(record: Any) -> Any:
        values = record.__dict__
        return values[name] if name in values else record.__getattr__(name)

    return property(value)


def _number(field: _Field) -> property:
    """Return a number of a record as a Python property."""
    start, view = field.start, "_floats" if field.is_float else "_wholes"

    def value(record: Any) -> Any:
        return record.__dict__[view][start]

    def is_set(record: Any) -> bool:
        return record.__dict__[view][start] != 0

    def set_value(record: Any, value: float) -> None:
        record.__dict__[view][start] = value

    return property(is_set if field.type == types.boolean else value, set_value)


# ------------------------------------------------------------------------- registration with numba
@register_model(TableType)
class _TableModel(models.OpaqueModel):
    """In compiled code, a table is a pointer to its block."""


@typeof_impl.register(Table)
def _typeof(table: Table, _context: Any) -> TableType:
    return table.numba_type


@unbox(TableType)
def _unbox(kind: TableType, table: Any, c: Any) -> NativeValue:
    boxed = c.pyapi.object_getattr_string(table, "_address")
    address = c.pyapi.long_as_longlong(boxed)
    c.pyapi.decref(boxed)
    return NativeValue(c.builder.inttoptr(address, c.context.get_value_type(kind)))


@infer_getattr
class _TableAttributes(AttributeTemplate):
    key = TableType

    def generic_resolve(self, kind: TableType, name: str) -> types.Type | None:
        field = kind.fields.get(name)
        return field.type if field is not None else None


@lower_getattr_generic(TableType)
def _load_field(context: Any, builder: Any, kind: TableType, table: Any, name: str) -> Any:
    start, type_ = kind.fields[name][:2]
    changes = kind.mutable and not isinstance(type_, (types.Array, TableType))

    def load(offset: int, as_type: ir.Type = _WORD) -> Any:
        words = builder.bitcast(table, _WORD.as_pointer())
        index = builder.gep(words, [ir.Constant(ir.IntType(32), start + offset)])
        loaded = builder.load(builder.bitcast(index, as_type.as_pointer()))
        if not changes:
            # It never changes, whatever a kernel writes elsewhere, so the load may be moved out of loops.
            loaded.set_metadata("invariant.load", builder.module.add_metadata([]))
        return loaded

    if isinstance(type_, types.Array):
        array = context.make_array(type_)(context, builder)
        shape = [load(1 + axis) for axis in range(type_.ndim)]
        item = ir.Constant(_WORD, _ITEM)
        strides = [item] if type_.ndim == 1 else [builder.mul(item, shape[1]), item]
        data = load(0, context.get_data_type(type_.dtype).as_pointer())
        populate_array(array, data=data, shape=shape, strides=strides, itemsize=_ITEM, meminfo=None)
        return array._getvalue()
    if isinstance(type_, TableType):
        return load(0, context.get_value_type(type_))
    if type_ == types.boolean:
        return builder.icmp_unsigned("!=", load(0), ir.Constant(_WORD, 0))
    return load(0, _DOUBLE if type_ == types.float64 else _WORD)


@lower_setattr_generic(TableType)
def _store_field(context: Any, builder: Any, signature: Any, arguments: Any, name: str) -> None:
    kind, given = signature.args
    field = kind.fields[name]
    if not kind.mutable or isinstance(field.type, (types.Array, TableType)):
        raise TypingError(f"{kind.class_name}.{name} cannot be set")
    value = context.cast(builder, arguments[1], given, field.type)
    if field.type == types.boolean:
        value = builder.zext(value, _WORD)
    index = builder.gep(
        builder.bitcast(arguments[0], _WORD.as_pointer()), [ir.Constant(ir.IntType(32), field.start)]
    )
    builder.store(value, builder.bitcast(index, (_DOUBLE if field.is_float else _WORD).as_pointer()))
