"""What an option may be: the types that plugin authors annotate their fields with."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, TypeAlias

from ..ir import dimension as dim
from ..ir.dimension import Dimension


@dataclass(frozen=True, slots=True)
class QuantityType:
    """A number of one dimension; `whole`: an integer."""

    dimension: Dimension
    whole: bool = False


@dataclass(frozen=True, slots=True)
class LikeType:
    """A number whose dimension is that of all other `LikeType` options of the kind."""


@dataclass(frozen=True, slots=True)
class FlagType:
    """`true` or `false`."""


@dataclass(frozen=True, slots=True)
class TextType:
    """A string."""


@dataclass(frozen=True, slots=True)
class FileType:
    """A string naming a file, relative to the scene file; it must exist when the scene is made."""


@dataclass(frozen=True, slots=True)
class WordType:
    """One of the words of the option (`option(words=...)`)."""


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
    """`(x, y)`."""

    dimension: Dimension


@dataclass(frozen=True, slots=True)
class EntityType:
    """The name of a declared thing: "image", "network", "road", "agent", "object" or several."""

    roles: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class NamesType:
    """The name of one or of a list of declared constraints (`target: in_lane`)."""


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


@dataclass(frozen=True, slots=True)
class ConditionType:
    """A drive formula with past operators only (`when:`)."""


@dataclass(frozen=True, slots=True)
class AnyType:
    """Anything."""


@dataclass(frozen=True, slots=True)
class UnionType:
    """One of several."""

    alternatives: tuple[OptionType, ...]


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

# Quantities: SI units and radians inside, any fitting unit outside.
Number = Annotated[float, QuantityType(dim.PURE)]
Whole = Annotated[int, QuantityType(dim.PURE, whole=True)]
Length = Annotated[float, QuantityType(dim.LENGTH)]
Angle = Annotated[float, QuantityType(dim.ANGLE)]
Duration = Annotated[float, QuantityType(dim.TIME)]
Speed = Annotated[float, QuantityType(dim.SPEED)]
Acceleration = Annotated[float, QuantityType(dim.ACCELERATION)]
Jerk = Annotated[float, QuantityType(dim.JERK)]
Curvature = Annotated[float, QuantityType(dim.CURVATURE)]
Mass = Annotated[float, QuantityType(dim.MASS)]
Pixels = Annotated[float, QuantityType(dim.PIXELS)]
Scale = Annotated[float, QuantityType(dim.SCALE)]
Like = Annotated[Any, LikeType()]
Between = Annotated[tuple[Any, Any], IntervalType(LikeType())]

Flag = Annotated[bool, FlagType()]
String = Annotated[str, TextType()]
File = Annotated[str, FileType()]
Word = Annotated[str, WordType()]
Point = Annotated[tuple[float, float], PointType(dim.LENGTH)]
PixelPoint = Annotated[tuple[float, float], PointType(dim.PIXELS)]
Stretch = Annotated[tuple[float, float], IntervalType(QuantityType(dim.LENGTH))]
RoadName = Annotated[Any, EntityType(("road",))]
RoadOrNetwork = Annotated[Any, EntityType(("road", "network"))]
ImageName = Annotated[Any, EntityType(("image",))]
AgentName = Annotated[Any, EntityType(("agent",))]
AgentOrObject = Annotated[Any, EntityType(("agent", "object"))]
ConstraintNames = Annotated[tuple[str, ...], NamesType()]
Condition = Annotated[Any, ConditionType()]
Anything = Annotated[Any, AnyType()]


def quantity(dimension: Dimension) -> Any:
    """The annotation of a number of any other dimension."""
    return Annotated[float, QuantityType(dimension)]


def list_of(item: Any, at_least: int = 0) -> Any:
    """The annotation of a list of `item` (an annotation from this module)."""
    return Annotated[tuple[Any, ...], ListType(type_of(item), at_least)]


def map_of(item: Any) -> Any:
    """The annotation of a map with values of `item`."""
    return Annotated[dict[str, Any], MapType(type_of(item))]


def call_of(verb: str) -> Any:
    """The annotation of a call such as `straight(80m)`, a kind of `verb`."""
    return Annotated[Any, CallType(verb)]


def kind_of(verb: str) -> Any:
    """The annotation of the name of a kind of `verb`."""
    return Annotated[str, KindNameType(verb)]


def record_of(record: type) -> Any:
    """The annotation of a map whose keys are the options of the dataclass `record`."""
    return Annotated[dict[str, Any], RecordType(record)]


def one_of(*items: Any) -> Any:
    """The annotation of a value that may have one of several types."""
    return Annotated[Any, UnionType(tuple(type_of(item) for item in items))]


def type_of(annotation: Any) -> OptionType:
    """The option type in an annotation; plain `float`, `int`, `bool`, `str` are understood.

    Raises `TypeError` when the annotation says nothing about an option.
    """
    plain: dict[Any, OptionType] = {
        float: QuantityType(dim.PURE),
        int: QuantityType(dim.PURE, whole=True),
        bool: FlagType(),
        str: TextType(),
    }
    if annotation in plain:
        return plain[annotation]
    for extra in getattr(annotation, "__metadata__", ()):
        if isinstance(extra, OptionType):
            return extra
    raise TypeError(f"{annotation!r} is not the type of an option")
