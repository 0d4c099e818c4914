"""Kinds that measure and judge: signals over roads and drives, numbers of roads, monitors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from ...ir.dimension import Dimension
from .base import Kind

if TYPE_CHECKING:
    from ...geometry.arrays import Floats
    from ...ir.trace import Trace


class Signal(Kind):
    """A road signal over arc length, written as a call: `curvature(bent)`.

    A field that names a road holds a `RoadBatch` of all variants.
    """

    verb: ClassVar[str] = "signal"
    required_methods: ClassVar[tuple[str, ...]] = ("values",)
    unit: ClassVar[str] = ""
    """of the values, in SI units: `1/m`, `m/s^2`; empty for pure numbers. Where it depends on the
    options, override `dimension_of` instead"""
    cost: ClassVar[float] = 20.0
    on_connections: ClassVar[bool] = False
    """for networks, also evaluate it on the connections of the junctions"""

    def values(self) -> Floats:
        """The values in SI units.

        Returns (variants, stations) finite numbers, or (1, stations) or (stations,) where all
        variants are equal; anything else is RL474.
        """
        raise NotImplementedError

    @classmethod
    def range(cls, options: Mapping[str, Any]) -> tuple[Floats | float, Floats | float]:
        """Least and greatest value that the options allow: numbers, or (variants, 1) columns.

        Requirements that they decide need no geometry; without them nothing is known. `options`
        holds all options by name: a `RoadBounds` for each road, and numbers, or columns
        (variants, 1). It must be monotonic in every number. A value beyond the range is RL474.
        """
        return float("-inf"), float("inf")

    @classmethod
    def reached(cls, options: Mapping[str, Any]) -> float:
        """A value that the signal reaches or exceeds at some station, whatever is drawn, from the
        `reach` of roads; `options` holds a `RoadBounds` for each road. 0 or less says nothing."""
        return 0.0

    @classmethod
    def dimension_of(cls, options: Mapping[str, Any]) -> Dimension:
        """The `Dimension` of the values; `options` has the constant options by name. By default
        that of `unit`."""
        from ...ir.units import parse_unit

        return parse_unit(cls.unit).dimension


class RoadNumber(Signal):
    """A number of a road, written as a call: `length(bent)`.

    `values` returns (variants, 1) or (1, 1). `member`: a number of an agent or object on a road,
    written `ego.start`. A field that names a network holds the whole of it, one that names an agent
    or object a `PlacedBatch` of arrays (variants, 1).
    """

    verb: ClassVar[str] = "number"
    of_groups: ClassVar[bool] = False
    """a field that names a group holds all of its copies, (variants, copies), instead of the one
    that a formula is judged for; those that another field names by itself are not `present`"""


class DriveSignal(Signal):
    """A drive signal over time, written `ego.speed`; as a call, `gap(ego, lead)`, if `member` is
    False.

    A field that names an agent holds its `AgentTrace`; if the signal is written as a call, a tuple
    of them, because the name may be that of a group.
    """

    verb: ClassVar[str] = "drive_signal"
    required_methods: ClassVar[tuple[str, ...]] = ("values", "values_in")
    domain: ClassVar[str] = "drive"
    member: ClassVar[bool] = True
    looks_back: ClassVar[float] = float("inf")
    """the number of earlier samples that a value depends on; infinite: all of them. In `when:` and
    `while:` a signal is asked for its value now. If this is finite, `values` gets columns (samples,
    agents) of many agents at once, whose `length` and `width` are (agents,), and must return such
    columns; else all samples up to now of one agent after another"""

    def values(self) -> Floats:
        """The values in SI units.

        Returns (steps,) finite numbers, one for each time of the trace; another shape is RL474. NaN
        means that the engine did not record the value; a formula that needs it is RL701.
        """
        raise NotImplementedError

    def values_in(self, trace: Trace) -> Floats:
        """As `values`, for a signal that needs more of the drive than the agents in its fields,
        such as the time axis; `values` is then not called."""
        return self.values()


class Monitor(Kind):
    """`require N with` or `expect N with`: evaluates roads or drives in Python, instead of a
    formula."""

    verb: ClassVar[str] = "monitor"
    domain: ClassVar[str] = "road"
    """ "road": `robustness` judges candidates; "drive": `judge` judges a drive"""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.required_methods = ("judge",) if cls.domain == "drive" else ("robustness",)

    def robustness(self) -> Floats:
        """If `domain` is "road": how well each candidate satisfies the monitor.

        Returns (variants,) or (1,) numbers: positive or 0 if satisfied, negative if not; the
        magnitude grows with the distance to the limit. NaN, True and False are RL474.
        """
        raise NotImplementedError

    def reason(self) -> str | None:
        """If `domain` is "road": why the first candidate, which has a negative robustness, is
        rejected, in words such as "the road is 4 m too long"; help where no scene is found."""
        return None

    def judge(self, trace: Trace) -> float:
        """If `domain` is "drive": how well the drive satisfies the monitor.

        Returns a number as `robustness` does. A field that names an agent holds its `AgentTrace`.
        """
        raise NotImplementedError
