"""Types of the options that kinds have without declaring them: lanes, junctions, routes."""

from __future__ import annotations

from typing import Annotated, Any

from ..ir.dimension import LENGTH, PURE
from .option_types import (
    CallType,
    KindNameType,
    ListType,
    PointType,
    QuantityType,
    UnionType,
    WordType,
)

JunctionNumbers = Annotated[tuple[int, ...], ListType(QuantityType(PURE, is_integer=True))]
LaneChoice = Annotated[Any, UnionType((QuantityType(PURE, is_integer=True), KindNameType("lane")))]
_RoutePoint = UnionType((PointType(LENGTH), CallType("position"), WordType()))
RoutePoints = Annotated[Any, ListType(_RoutePoint, at_least=1)]
Points = Annotated[Any, ListType(PointType(LENGTH), at_least=1)]
RoadNumbers = Annotated[tuple[int, ...], ListType(QuantityType(PURE, is_integer=True))]
