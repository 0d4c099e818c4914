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

    def parts(self, scenes: Sequence[Scene], workers: int) -> list[range]:
        """The places of scenes in parts, each of which a worker drives together."""
        if not scenes:
            return []
        _, simulator = simulator_of(scenes[0], self.registry, self.engine, self.options)
        share = -(-len(scenes) // max(workers, 1))
        size = max(1, min(simulator.at_once, share))
        starts = range(0, len(scenes), size)
        return [range(start, min(start + size, len(scenes))) for start in starts]
