"""Kinds of sensors of agents."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...ir.readings import SensorRecord
    from ...ir.sensed_batch import SensedBatch


@dataclass(frozen=True)
class ReadingArray:
    """One array of the readings of a sensor."""

    shape: tuple[int, ...] = ()
    """of one reading; () of a number"""
    dtype: str = "float64"
    """of numpy"""
    low: float = float("-inf")
    """the least value"""
    high: float = float("inf")
    """the greatest value"""
    unit: str = ""
    """SI unit; empty of dimensionless numbers, colors and ids"""


class Sensor(Kind):
    """`sense with`: a sensor of an agent. Its readings reach the controllers of the agent.

    A kind that implements `readings` works in every engine that offers such sensors, including the
    embedded one and Godot. A kind without it, such as a camera, is measured by the engine. roadlang
    handles measuring times, delays and lost readings (`every`, `delay`, `dropout`).
    """

    verb: ClassVar[str] = "sense"
    replaces: ClassVar[tuple[str, ...]] = ()
    """names of its arrays that are columns of `ObservationBatch` too: controllers of the agent get
    these in place of the true ones"""

    def arrays(self) -> Mapping[str, ReadingArray]:
        """The arrays of a reading, by name: `{"distances": ReadingArray((72,), unit="m")}`."""
        return {}

    @classmethod
    def is_computed(cls) -> bool:
        """Whether the kind measures by itself (it implements `readings`)."""
        return cls.readings is not Sensor.readings

    def readings(self, sensed: SensedBatch, state: Any) -> Mapping[str, NDArray[Any]]:
        """Measure at N agents: arrays (N, ...) by name, as `arrays` describes them.

        Options that are numbers are columns (N,) here, points (N, 2) or (N, 3); integers, words and
        flags are the same for all N agents. The measurement for an agent must depend on its row
        alone. `state` has a row for each agent, as returned by `start`; the method changes it in
        place. Anything else than these arrays, of real numbers that are not NaN, is RL474.
        """
        raise NotImplementedError

    def files(self, record: SensorRecord) -> Mapping[str, bytes]:
        """Files of the readings of a drive, which `roadlang run` writes beside the trace and the
        arrays (`npz`), by the ends of their names: `{"mp4": ...}` for `scene-0000.ego.front.mp4`.
        By default none. Here the options are those of one agent.
        """
        return {}

    def start(self, count: int) -> NDArray[Any] | None:
        """The state of `readings` for `count` agents at the start of a drive: an array (count, ...)
        that is kept from measurement to measurement. By default None."""
        return None
