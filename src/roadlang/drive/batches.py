"""Driving as work that can be handed out: what each worker holds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from ..ir.scene import Scene
from ..plugins.registry import Registry
from .simulators import Driven, drive_scenes, simulator_of
from .written_places import UNKNOWN, WrittenPlaces


@dataclass(frozen=True)
class DriveTask:
    """What drives scenes: a simulator, with its options."""

    registry: Registry
    engine: str | None = None
    options: Mapping[str, Any] = field(default_factory=dict)
    record_sensors: bool = False
    places: WrittenPlaces = UNKNOWN

    def drive(self, scenes: Sequence[Scene]) -> tuple[Driven, ...]:
        """Drive some scenes."""
        return drive_scenes(
            scenes,
            self.registry,
            self.engine,
            self.options,
            record_sensors=self.record_sensors,
            places=self.places,
        )

    def first_part(self, scenes: Sequence[Scene], few: int) -> range:
        """The places of the first `few` scenes, where there are more and the simulator drives more
        than those in one call; else none."""
        if not scenes:
            return range(0)
        _, simulator = simulator_of(scenes[0], self.registry, self.engine, self.options)
        return range(few if few < min(simulator.at_once, len(scenes)) else 0)

    def parts(self, scenes: Sequence[Scene], workers: int, start: int = 0) -> list[range]:
        """The places of scenes from `start` on in parts, each of which a worker drives together."""
        if not scenes[start:]:
            return []
        _, simulator = simulator_of(scenes[0], self.registry, self.engine, self.options)
        share = -(-(len(scenes) - start) // max(workers, 1))
        size = max(1, min(simulator.at_once, share))
        starts = range(start, len(scenes), size)
        return [range(first, min(first + size, len(scenes))) for first in starts]
