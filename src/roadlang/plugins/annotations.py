"""The types of options by the names that authors of plugins annotate their fields with.

For a type checker each is the Python type that the field holds for one variant. In batch methods a
number that is random is a column (variants, 1).
"""

from __future__ import annotations

import types
import typing
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar

from ..ir import dimension as dim
from ..ir.dimension import Dimension
from .kinds.base import Kind
from .option_types import (
    AnyType,
    CallType,
    ConditionType,
    EntityType,
    FileType,
    FlagType,
    IntervalType,
    KindNameType,
    LikeType,
    ListType,
    MapType,
    NamesType,
    OptionType,
    PointType,
    QuantityType,
    RecordType,
    TextType,
    UnionType,
    WordType,
)

if TYPE_CHECKING:
    from ..ir.batch import RoadBatch
    from ..ir.picture import Picture
    from ..ir.trace import AgentTrace
else:
    RoadBatch = AgentTrace = Picture = Any

Item = TypeVar("Item")

# Quantities: SI units and radians inside, any fitting unit outside.
Number = Annotated[float, QuantityType(dim.PURE)]
Integer = Annotated[int, QuantityType(dim.PURE, is_integer=True)]
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
Like = Annotated[float, LikeType()]
Between = Annotated[tuple[float, float], IntervalType(LikeType())]

Flag = Annotated[bool, FlagType()]
String = Annotated[str, TextType()]
File = Annotated[str, FileType()]
Word = Annotated[str, WordType()]
Point = Annotated[tuple[float, float], PointType(dim.LENGTH)]
PointInSpace = Annotated[tuple[float, float, float], PointType(dim.LENGTH, in_space=True)]
PixelPoint = Annotated[tuple[float, float], PointType(dim.PIXELS)]
LengthInterval = Annotated[tuple[float, float], IntervalType(QuantityType(dim.LENGTH))]
ListOf = tuple[Item, ...]

# Names of declared things. In signals, numbers and monitors the field holds the thing itself; in
# other kinds its name, which `Annotated[str, RoadName]` tells a type checker.
RoadName = Annotated[RoadBatch, EntityType(("road",))]
RoadOrNetwork = Annotated[RoadBatch, EntityType(("road", "network"))]
AgentName = Annotated[AgentTrace, EntityType(("agent",))]
AgentOrObject = Annotated[Any, EntityType(("agent", "object"))]
ImageName = Annotated[Picture, EntityType(("image",))]
ConstraintNames = Annotated[tuple[str, ...], NamesType()]
ExpectationNames = Annotated[tuple[str, ...], NamesType("expect")]
Condition = Annotated[Any, ConditionType()]
Anything = Annotated[Any, AnyType()]


def quantity(dimension: Dimension) -> Any:
    """A number of any other dimension.

    For a type checker: `Annotated[float, quantity(FREQUENCY)]`.
    """
    return Annotated[float, QuantityType(dimension)]


def pair_of(first: Dimension, second: Dimension) -> Any:
    """Two numbers of two dimensions, `(80m, 20km/h)`.

    For a type checker: `Annotated[tuple[float, float], pair_of(LENGTH, SPEED)]`.
    """
    return Annotated[tuple[float, float], PointType(first, second)]


def list_of(item: Any, at_least: int = 0) -> Any:
    """A list of `item`, which is an annotation too.

    For a type checker: `ListOf[Length]` with `option(at_least=2)`.
    """
    return Annotated[tuple[Any, ...], ListType(type_of(item), at_least)]


def map_of(item: Any) -> Any:
    """A map with values of `item` and keys of any text.

    For a type checker: `dict[str, Length]`.
    """
    return Annotated[dict[str, Any], MapType(type_of(item))]


def call_of(verb: str) -> Any:
    """A call such as `straight(80m)`, a kind of `verb`, which the field then holds.

    For a type checker: the base class of the verb, such as `Piece`.
    """
    return Annotated[Any, CallType(verb)]


def kind_of(verb: str) -> Any:
    """The name of a kind of `verb`, without options.

    For a type checker: `Annotated[str, kind_of("object")]`.
    """
    return Annotated[str, KindNameType(verb)]


def record_of(record: type) -> Any:
    """A map whose keys are the options of the dataclass `record`.

    For a type checker: `Annotated[dict[str, Any], record_of(Sun)]`.
    """
    return Annotated[dict[str, Any], RecordType(record)]


def one_of(*items: Any) -> Any:
    """A value of one of several types.

    For a type checker: `Length | Angle`.
    """
    return Annotated[Any, UnionType(tuple(type_of(item) for item in items))]


@dataclass(frozen=True)
class Annotation:
    """What an annotation says of an option: its type, and words that it may be instead."""

    type: OptionType
    words: tuple[str, ...] = ()


_PLAIN: dict[Any, OptionType] = {
    float: QuantityType(dim.PURE),
    int: QuantityType(dim.PURE, is_integer=True),
    bool: FlagType(),
    str: TextType(),
}


def type_of(annotation: Any) -> OptionType:
    """The option type in an annotation. Raises `TypeError` when it says nothing of an option."""
    return read_annotation(annotation).type


def read_annotation(annotation: Any) -> Annotation:
    """What an annotation says, in any of the forms that a type checker understands as well.

    Raises `TypeError` when it says nothing of an option.
    """
    for extra in getattr(annotation, "__metadata__", ()):
        if isinstance(extra, OptionType):
            return Annotation(extra)
        if hasattr(extra, "__metadata__"):
            return read_annotation(extra)
    if isinstance(annotation, type) and issubclass(annotation, Kind) and annotation.verb:
        return Annotation(CallType(annotation.verb))
    if annotation in _PLAIN:
        return Annotation(_PLAIN[annotation])
    origin, parts = typing.get_origin(annotation), typing.get_args(annotation)
    if origin is Literal and all(isinstance(part, str) for part in parts):
        return Annotation(WordType(), parts)
    if origin in (typing.Union, types.UnionType):
        return _union(annotation, parts)
    if origin is tuple and len(parts) == 2 and parts[1] is Ellipsis:
        item = read_annotation(parts[0])
        return Annotation(ListType(item.type), item.words)
    if origin in (dict, Mapping) and parts[0] is str:
        item = read_annotation(parts[1])
        return Annotation(MapType(item.type), item.words)
    raise TypeError(_refusal(annotation, origin))


def _union(annotation: Any, parts: tuple[Any, ...]) -> Annotation:
    """`Length | Literal["auto"] | None`: None is what an option is that was not given."""
    found = [read_annotation(part) for part in parts if part is not type(None)]
    types_ = list(dict.fromkeys(part.type for part in found if part.type != WordType()))
    words = tuple(word for part in found for word in part.words)
    if len(types_) > 1:
        return Annotation(UnionType(tuple(types_)), words)
    return Annotation(types_[0] if types_ else WordType(), words)


def _refusal(annotation: Any, origin: Any) -> str:
    if origin is tuple or annotation is tuple:
        return f"{annotation!r} is not the type of an option: `Point`, or `tuple[Length, ...]`"
    if origin in (list, set) or annotation in (list, set):
        return f"{annotation!r} could be changed in place: write `tuple[Length, ...]`"
    return f"{annotation!r} is not the type of an option"
