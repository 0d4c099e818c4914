"""The base classes of kinds. A kind is a frozen dataclass; its fields are its options.

A kind of a verb derives from the verb's base class, sets `name`, declares its options as
fields and implements one method. Random options reach batch methods as columns (variants, 1),
so that numpy broadcasting over (variants, stations) just works.
"""

from __future__ import annotations

from .base import Kind
from .drives import LANE_END_GAP, STANDING_GAP, Controller, InitialSpeed, Simulator
from .junctions import JunctionControl, RightOfWay
from .lanes import LaneDirection, LaneKind, LaneMarking
from .outputs import AgentKind, Backend, ObjectKind
from .pictures import Adjuster, Extractor, Reader
from .placing import Position, Standing
from .roads import Drawer, Perturber, Piece, Region, Selector
from .sampling import Distribution, DrawnValue, Sampler
from .searching import ROAD_PLACES, Axis, Search, Searcher
from .sensing import ReadingArray, Sensor
from .signals import DriveSignal, Monitor, RoadNumber, Signal

BASES: tuple[type[Kind], ...] = (
    Adjuster, Extractor, Reader, Drawer, Piece, Selector, Region, Perturber,
    JunctionControl,
    LaneKind, Position, Controller, Sensor, Signal, RoadNumber, DriveSignal, Monitor,
    Distribution, Sampler, Simulator, Searcher, Backend, AgentKind, ObjectKind,
)  # fmt: skip
VERBS: tuple[str, ...] = tuple(base.verb for base in BASES)
_BASE_OF = {base.verb: base for base in BASES}


def base_of(verb: str) -> type[Kind]:
    """The base class of the kinds of a verb."""
    return _BASE_OF[verb]


def implements(kind: type[Kind], method: str) -> bool:
    """Whether a kind implements a method of its base, rather than inheriting it."""
    method_of_kind, inherited = getattr(kind, method), getattr(base_of(kind.verb), method)
    return getattr(method_of_kind, "__func__", method_of_kind) is not getattr(
        inherited, "__func__", inherited
    )


__all__ = [
    "BASES",
    "LANE_END_GAP",
    "ROAD_PLACES",
    "STANDING_GAP",
    "VERBS",
    "Adjuster",
    "AgentKind",
    "Axis",
    "Backend",
    "Controller",
    "Distribution",
    "Drawer",
    "DrawnValue",
    "DriveSignal",
    "Extractor",
    "InitialSpeed",
    "JunctionControl",
    "Kind",
    "LaneDirection",
    "LaneKind",
    "LaneMarking",
    "Monitor",
    "ObjectKind",
    "Perturber",
    "Piece",
    "Position",
    "Reader",
    "ReadingArray",
    "Region",
    "RightOfWay",
    "RoadNumber",
    "Sampler",
    "Search",
    "Searcher",
    "Selector",
    "Sensor",
    "Signal",
    "Simulator",
    "Standing",
    "base_of",
    "implements",
]
