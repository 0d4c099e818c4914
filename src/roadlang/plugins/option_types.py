"""What an option may be; `annotations` has the names by which authors of plugins choose one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from ..ir.dimension import Dimension


@dataclass(frozen=True, slots=True)
class QuantityType:
    """A number of one dimension; `whole`: an integer."""

    dimension: Dimension
    is_integer: bool = False


@dataclass(frozen=True, slots=True)
class PlainOptionType:
    """A type of which nothing more is to be said; those that derive from it add no fields."""


class LikeType(PlainOptionType):
    """A number whose dimension is that of all other `LikeType` options of the kind."""

    __slots__ = ()


class FlagType(PlainOptionType):
    """`true` or `false`."""

    __slots__ = ()


class TextType(PlainOptionType):
    """A string."""

    __slots__ = ()


class FileType(PlainOptionType):
    """A string naming a file, relative to the scene file; it must exist when the scene is made."""

    __slots__ = ()


class WordType(PlainOptionType):
    """One of the words of the option (`option(words=...)`)."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class ListType:
    """`[a, b, ...]`."""

    item: OptionType
    at_least: int = 0


@dataclass(frozen=True, slots=True)
class IntervalType:
    """`[low, high]`, low <= high; `inf` is allowed above."""

    item: OptionType


@dataclass(frozen=True, slots=True)
class PointType:
    """`(x, y)`; a pair of two dimensions, such as `(80m, 20km/h)`; or `(x, y, z)`."""

    dimension: Dimension
    second: Dimension | None = None
    in_space: bool = False

    @property
    def parts(self) -> tuple[QuantityType, ...]:
        """The types of its two or three numbers."""
        first = QuantityType(self.dimension)
        return (
            (first,) * 3 if self.in_space else (first, QuantityType(self.second or self.dimension))
        )


@dataclass(frozen=True, slots=True)
class EntityType:
    """The name of a declared thing: "image", "network", "road", "agent", "object" or several."""

    roles: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class NamesType:
    """The name of one or of a list of declared constraints (`expects: in_lane`); of those that are
    declared with `word`, where it is not empty."""

    word: str = ""


@dataclass(frozen=True, slots=True)
class CallType:
    """A call of a kind of another verb: `straight(80m)` is a call of verb "piece"."""

    verb: str


@dataclass(frozen=True, slots=True)
class KindNameType:
    """The name of a kind of another verb, without options: `tree` in a legend."""

    verb: str


@dataclass(frozen=True, slots=True)
class RecordType:
    """`{ key: value }` with the keys that a dataclass has as options."""

    record: type


@dataclass(frozen=True, slots=True)
class MapType:
    """`{ key: value }` with keys of any text."""

    item: OptionType


class ConditionType(PlainOptionType):
    """A drive formula with past operators only (`when:`)."""

    __slots__ = ()


class AnyType(PlainOptionType):
    """Anything."""

    __slots__ = ()


def is_of_anything(option: OptionType) -> bool:
    """Whether an option takes values of any type, or lists of them: a distribution chooses among
    those."""
    return isinstance(option.item if isinstance(option, ListType) else option, AnyType)


def is_list_of_words(option: OptionType) -> bool:
    """Whether the words of an option are the items of a list, rather than instead of one."""
    return isinstance(option, ListType) and isinstance(option.item, WordType)


@dataclass(frozen=True, slots=True)
class UnionType:
    """One of several."""

    alternatives: tuple[OptionType, ...]


def takes_words(item: OptionType) -> bool:
    """Whether an item of a list may be one of the words of the option."""
    return WordType() in (item.alternatives if isinstance(item, UnionType) else (item,))


OptionType: TypeAlias = (
    QuantityType
    | LikeType
    | FlagType
    | TextType
    | FileType
    | WordType
    | ListType
    | IntervalType
    | PointType
    | EntityType
    | NamesType
    | CallType
    | KindNameType
    | RecordType
    | MapType
    | ConditionType
    | AnyType
    | UnionType
)
