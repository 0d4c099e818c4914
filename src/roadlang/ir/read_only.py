"""Values with several readers, none of whom can change what the others see."""

from __future__ import annotations

import operator
import struct
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from functools import cache
from types import FunctionType, MethodType
from typing import Any, NoReturn, TypeVar

K = TypeVar("K")
V = TypeVar("V")


def _refuse(self: object, *arguments: object, **named: object) -> NoReturn:
    kind = "map" if isinstance(self, dict) else "list"
    raise TypeError(f"this {kind} is read-only: change a copy of it")


class FrozenDict(dict[K, V]):
    """A `dict` that cannot be changed; `dict(it)` is a copy that can. It pickles and encodes, and
    may be a key where its values may."""

    __slots__ = ()

    def __hash__(self) -> int:  # type: ignore[override]  # a dict has none, as it may change
        return hash(frozenset(self.items()))

    __setitem__ = __delitem__ = _refuse
    __ior__ = _refuse
    update = setdefault = pop = popitem = clear = _refuse

    def __reduce__(self) -> tuple[Any, ...]:
        return FrozenDict, (dict(self),)


class FrozenList(list[V]):
    """A `list` that cannot be changed; `list(it)` is a copy that can. It pickles and encodes."""

    __slots__ = ()

    __setitem__ = __delitem__ = _refuse
    __iadd__ = __imul__ = _refuse
    append = extend = insert = pop = remove = clear = sort = reverse = _refuse

    def __reduce__(self) -> tuple[Any, ...]:
        return FrozenList, (list(self),)


class ReadOnlyMapping(Mapping[K, V]):
    """A mapping that works out its values when they are looked up, and offers no way to change."""

    __slots__ = ()


class Floats(tuple[float, ...]):
    """Numbers that are known to be floating point numbers: nobody has to look at each. Arrays of
    them, which are new ones, are made without a look at each too."""

    _row: Any = None

    @classmethod
    def of_row(cls, numbers: Iterable[float], row: Any) -> Floats:
        """`row`: the same numbers as a read-only array, of which arrays are then copied."""
        found = cls(numbers)
        found._row = row
        return found

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        import numpy as np

        if self._row is not None:
            return np.array(self._row, dtype)
        packed = struct.pack(f"{len(self)}d", *self)  # a third of the time of `numpy.fromiter`
        return np.array(np.frombuffer(packed) if self else (), dtype)

    def __reduce__(self) -> tuple[Any, ...]:
        # As bytes: one by one they take three times as long.
        return _unpacked, (struct.pack(f"{len(self)}d", *self), self._row is not None)


def _unpacked(content: bytes, has_row: bool) -> Floats:
    if not has_row:
        return Floats(struct.unpack(f"{len(content) // struct.calcsize('d')}d", content))
    row = unpacked_row(content)
    return Floats.of_row(row.tolist(), row)


def packed_row(row: Any) -> bytes:
    """An array (n,) of floating point numbers, to be sent to another process."""
    content: bytes = row.tobytes()
    return content


def unpacked_row(content: bytes) -> Any:
    """The read-only array (n,) of `packed_row`."""
    import numpy as np

    return np.frombuffer(content)


def row_of(numbers: Sequence[float]) -> Any:
    """The same numbers (n,) as an array to read: not a copy where they know one."""
    row = getattr(numbers, "_row", None)
    if row is not None:
        return row
    import numpy as np

    return np.asarray(numbers, np.float64)


_LEAVES = frozenset((float, int, str, bool, type(None)))
_FIXED = _LEAVES | {Floats}
_READ_ONLY = _FIXED | {FrozenDict, FrozenList, FunctionType, MethodType}
_NOTHING: tuple[Any, ...] = ()


_FROZEN_RECORDS: set[type] = set()
"""Frozen dataclasses and read-only mappings that were met, which `frozen` returns as they are."""


def frozen(value: Any) -> Any:
    """Maps, lists and arrays, also inside one another, as values that cannot be changed.

    Other values are returned as they are.
    """
    if type(value) in _READ_ONLY:
        return value
    if type(value) in _FROZEN_RECORDS:
        return value
    if type(value) is list or type(value) is tuple:
        return _frozen_items(value)
    if type(value) is dict:
        return _frozen_map(value)
    flags = getattr(value, "flags", None)
    if flags is not None:
        return _read_only()(value) if flags.writeable else value
    if isinstance(value, ReadOnlyMapping):
        _FROZEN_RECORDS.add(type(value))
        return value
    if isinstance(value, Mapping):
        return _frozen_map(value)
    parameters = getattr(type(value), "__dataclass_params__", None)
    if parameters is not None and parameters.frozen:
        _FROZEN_RECORDS.add(type(value))
    return value


def _frozen_map(value: Mapping[Any, Any]) -> FrozenDict[Any, Any]:
    if _READ_ONLY.issuperset(map(type, value.values())):
        return FrozenDict(value)
    return FrozenDict({key: frozen(item) for key, item in value.items()})


def _frozen_items(value: list[Any] | tuple[Any, ...]) -> Any:
    kinds = set(map(type, value))
    plain = kinds <= _READ_ONLY or kinds <= _FROZEN_RECORDS
    if type(value) is list:
        return FrozenList(value if plain else [frozen(item) for item in value])
    items = value if plain else tuple([frozen(item) for item in value])
    is_same = plain or all(map(operator.is_, items, value))
    return value if is_same else items


def is_unchangeable(value: Any, known: Container[int] = ()) -> bool:
    """Whether nothing in a value can be changed, however deep. False also of types that nothing is
    known of. `known`: the identities of objects of which it is known already."""
    kind: Any = type(value)
    if kind in _FIXED or id(value) in known:
        return True
    if kind is tuple or kind is FrozenList:
        return _LEAVES.issuperset(map(type, value)) or _are_unchangeable(value, known)
    if kind is FrozenDict:
        items = value.values()
        return _LEAVES.issuperset(map(type, items)) or _are_unchangeable(items, known)
    flags = getattr(value, "flags", None)
    if flags is not None:
        return not getattr(flags, "writeable", True)
    parameters = getattr(kind, "__dataclass_params__", None)
    if parameters is None or not parameters.frozen:
        return False
    return _are_unchangeable([getattr(value, name) for name in changeable_fields(kind)], known)


def _are_unchangeable(values: Iterable[Any], known: Container[int]) -> bool:
    for value in values:
        if type(value) in _FIXED or id(value) in known:
            continue
        if not is_unchangeable(value, known):
            return False
    return True


@cache
def _read_only() -> Callable[[Any], Any]:
    from ..geometry.arrays import read_only  # numpy: only where there are arrays

    return read_only


_PLAIN = frozenset(
    f"{kind}{rest}" for kind in ("bool", "float", "int", "str") for rest in ("", " | None")
)


@cache
def changeable_fields(kind: Any) -> tuple[str, ...]:
    """The fields of a dataclass whose values may be changeable."""
    return tuple(f.name for f in kind.__dataclass_fields__.values() if f.type not in _PLAIN)


class Frozen:
    """Of a frozen dataclass: its maps, lists and arrays cannot be changed either."""

    __slots__ = ()

    def __post_init__(self) -> None:
        kind: Any = type(self)
        for name in changeable_fields(kind):
            value = getattr(self, name)
            if type(value) not in _READ_ONLY and value is not _NOTHING:
                unchangeable = frozen(value)
                if unchangeable is not value:
                    object.__setattr__(self, name, unchangeable)

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        Frozen.__post_init__(self)  # pickled arrays come back writable
