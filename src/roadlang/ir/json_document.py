"""Values of the IR as the text of JSON documents: one member a line, lists of numbers on one line.

Scenes of one run have roads, networks and options in common, as the same objects. Their text is
written once: what the last document was made of is known by identity. That is sound because only
parts that cannot change are remembered, and bounded because only the last document is known.
"""

from __future__ import annotations

import dataclasses
import itertools
import operator
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, lru_cache
from typing import Any

from .json_leaves import LEAVES, finite_floats_text, json_text, leaf_texts
from .number_text import is_floats
from .read_only import Floats, FrozenDict, FrozenList, is_unchangeable
from .scene import SceneNetwork, SceneRoad, Verdict
from .scene_actor import Call

_SHARED = frozenset((FrozenDict, SceneRoad, SceneNetwork, Verdict, Call))
"""Unchanging types that several scenes have the same instance of."""
_FEW = 8
"""Numbers that are written as soon as looked up."""
_MANY = 8
"""Records from which on it is quicker to write them member by member."""

Texts = dict[tuple[int, int], tuple[Any, str | None]]
"""By the identity of a part and its depth: the part, so that no other gets its identity, and its
text, once a second document has it."""
_last: list[Texts] = [{}]
"""Those of the last document."""


def document(value: Any) -> str:
    """The text of a dataclass or map. Raises `ValueError` for a number that is not finite."""
    writer = _Writer(_last[0])
    text = writer.top(value)
    _last[0] = writer.texts
    return text


class _Writer:
    """Writes one document; `known` are the texts of another."""

    def __init__(self, known: Texts) -> None:
        self.known = known
        self.texts: Texts = {}
        self.unchangeable: set[int] = set()
        """The identities of the parts in `texts`."""

    def top(self, value: Any) -> str:
        """A record with `schema` first, so that a reader sees at once what it has."""
        kind: Any = type(value)
        if not hasattr(kind, "__dataclass_fields__"):
            return self.written(plain(value), 0)
        names, _, members = _form(kind, 0)
        values = dict(zip(names, members(value), strict=True))
        if "schema" in values:
            values = {"schema": values["schema"], **values}
        return self._members(tuple(map(_prefix, values, [0] * len(values))), values.values(), 0)

    def written(self, value: Any, depth: int) -> str:
        kind = type(value)
        leaf = LEAVES.get(kind)
        if leaf is not None:
            return leaf(value)
        if kind is Floats:
            return self._numbers(value)
        if kind in _SEQUENCES:
            return self._sequence(value, depth)
        if kind in _SHARED:
            return self._known(value, depth, self._mapping if kind is FrozenDict else self._record)
        if kind is dict:
            return self._mapping(value, depth)
        if dataclasses.is_dataclass(value):
            return self._record(value, depth)
        return self.written(plain(value), depth)

    def _known(
        self, value: Any, depth: int, write: Callable[[Any, int], str], *, certain: bool = False
    ) -> str:
        """`certain`: it is known that the value is unchangeable."""
        key = id(value), depth
        found = self.texts.get(key) or self.known.get(key)
        if found is not None and found[1] is not None:
            text = found[1]
        else:
            text = write(value, depth)
            # What one document alone has need not be looked through.
            if not certain and (found is None or not is_unchangeable(value, self.unchangeable)):
                self.texts[key] = value, None
                return text
        self.texts[key] = value, text
        self.unchangeable.add(key[0])
        return text

    def _record(self, value: Any, depth: int) -> str:
        kind: Any = type(value)
        _, prefixes, members = _form(kind, depth)
        return self._members(prefixes, members(value), depth)

    def _mapping(self, value: Mapping[Any, Any], depth: int) -> str:
        if not value:
            return "{}"
        names, prefixes = _sorted(tuple(value), depth)
        values = [value[name] for name in names]
        if len(names) < _MANY or not LEAVES.keys() >= set(map(type, values)):
            return self._members(prefixes, values, depth)
        return _object(map(operator.add, prefixes, leaf_texts(values)), depth)

    def _members(self, prefixes: tuple[str, ...], values: Any, depth: int) -> str:
        leaves, written = LEAVES, self.written
        lines = [
            prefix
            + (leaf(value) if (leaf := leaves.get(type(value))) else written(value, depth + 1))
            for prefix, value in zip(prefixes, values, strict=True)
        ]
        return _object(lines, depth)

    def _sequence(self, value: Any, depth: int) -> str:
        if not value:
            return "[]"
        kind = type(value)
        if _FLOATS.issuperset(map(type, value)):
            return _floats(value, 0) if kind is list else self._numbers(value)
        kinds = set(map(type, value))
        if kinds <= LEAVES.keys():
            return json_text(value)
        if any(map(_is_spread, kinds)):
            return (
                self._lines(value, depth)
                if kind is list
                else self._known(value, depth, self._lines)
            )
        converted = plain(value)
        spread = any(isinstance(item, dict | list) for item in converted)
        return (
            self._sequence(converted, depth)
            if spread or is_floats(converted)
            else json_text(converted)
        )

    def _numbers(self, value: tuple[float, ...]) -> str:
        if len(value) <= _FEW:
            return _floats(value, 0)
        return self._known(value, 0, _floats, certain=True)

    def _lines(self, values: Any, depth: int) -> str:
        kind = type(values[0])
        if (
            len(values) >= _MANY
            and kind not in _SHARED
            and dataclasses.is_dataclass(kind)
            and set(map(type, values)) == {kind}
        ):
            items: Iterable[str] = self._records(values, depth + 1)
        else:
            items = [self.written(item, depth + 1) for item in values]
        inner = "  " * (depth + 1)
        inside = f",\n{inner}".join(items)
        return f"[\n{inner}{inside}\n{'  ' * depth}]"

    def _records(self, values: Any, depth: int) -> Iterable[str]:
        """Many of one type: a member of all of them at a time."""
        kind: Any = type(values[0])
        _, prefixes, members = _form(kind, depth)
        lines, columns = [], []
        for prefix, column in zip(prefixes, zip(*map(members, values), strict=True), strict=True):
            if all(map(operator.is_, column, itertools.repeat(column[0]))):
                lines.append((prefix + self.written(column[0], depth + 1)).replace("%", "%%"))
            else:
                lines.append(prefix.replace("%", "%%") + "%s")
                columns.append(self._column(column, depth + 1))
        record = _object(lines, depth)
        rows = zip(*columns, strict=True) if columns else itertools.repeat((), len(values))
        return map(record.__mod__, rows)

    def _column(self, values: Sequence[Any], depth: int) -> Iterable[str]:
        if LEAVES.keys() >= set(map(type, values)):
            return leaf_texts(values)
        distinct = {id(value): value for value in values}
        many = len(distinct) >= _MANY and set(map(type, values)) == {FrozenDict}
        texts = self._mappings(distinct, depth) if many else self._each(distinct, depth)
        return [texts[id(value)] for value in values]

    def _each(self, values: Mapping[int, Any], depth: int) -> dict[int, str]:
        return {key: self.written(value, depth) for key, value in values.items()}

    def _mappings(self, maps: Mapping[int, Mapping[Any, Any]], depth: int) -> dict[int, str]:
        """Many maps by their identities: of those with the same names a member at a time."""
        alike: dict[tuple[Any, ...], list[int]] = {}
        for key, value in maps.items():
            alike.setdefault(tuple(value), []).append(key)
        texts: dict[int, str] = {}
        for names, keys in alike.items():
            ordered, prefixes = _sorted(names, depth)
            values = [[maps[key][name] for name in ordered] for key in keys]
            kinds = set(map(type, itertools.chain.from_iterable(values)))
            if len(keys) < _MANY or not names or not LEAVES.keys() >= kinds:
                texts |= self._each({key: maps[key] for key in keys}, depth)
                continue
            shape = _object([prefix.replace("%", "%%") + "%s" for prefix in prefixes], depth)
            rows = zip(*map(leaf_texts, zip(*values, strict=True)), strict=True)
            texts |= zip(keys, map(shape.__mod__, rows), strict=True)
        return texts


def plain(value: Any) -> Any:
    """Maps, lists, words and numbers. Raises `TypeError` for what JSON cannot hold."""
    import msgspec

    return msgspec.to_builtins(value, enc_hook=plain_number, order="deterministic")


def plain_number(value: Any) -> Any:
    """A number or array of numpy as Python has it. Raises `TypeError` for anything else."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} cannot be written as JSON")


@lru_cache(maxsize=256)
def _form(
    kind: Any, depth: int
) -> tuple[tuple[str, ...], tuple[str, ...], Callable[[Any], tuple[Any, ...]]]:
    """The names of the members of a dataclass, as they begin a line, and what reads them."""
    names = tuple(field.name for field in dataclasses.fields(kind))
    read = operator.attrgetter(*names)
    one = len(names) == 1
    return (
        names,
        tuple(_prefix(name, depth) for name in names),
        ((lambda value: (read(value),)) if one else read),
    )


@lru_cache(maxsize=64)
def _sorted(names: tuple[Any, ...], depth: int) -> tuple[list[Any], tuple[str, ...]]:
    """The names of a map in order, and as they begin a line."""
    ordered = sorted(names)
    return ordered, tuple([_prefix(name, depth) for name in ordered])


@lru_cache(maxsize=8192)
def _prefix(name: Any, depth: int) -> str:
    return "  " * (depth + 1) + json_text(name) + ": "


@cache
def _is_spread(kind: Any) -> bool:
    """Whether what holds a value of this type has a line for each of its items."""
    return issubclass(kind, dict | list) or dataclasses.is_dataclass(kind)


def _floats(values: Any, depth: int) -> str:
    return f"[{finite_floats_text(values)}]"


def _object(lines: Iterable[str], depth: int) -> str:
    inside = ",\n".join(lines)
    return f"{{\n{inside}\n{'  ' * depth}}}"


_SEQUENCES = frozenset((tuple, list, FrozenList))
_FLOATS = frozenset((float,))
