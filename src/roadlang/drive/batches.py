"""Driving as work that can be handed out: what each worker holds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from ..ir.scene import Scene
from ..plugins.registry import Registry
from .simulators import Driven, drive_scenes

AT_ONCE = 64
"""Scenes that are driven together: a simulator drives many in little more time than one."""


@dataclass(frozen=True)
class DriveTask:
    """A simulator, as `drive_scenes` takes it."""

    registry: Registry
    engine: str | None = None
    options: Mapping[str, Any] = field(default_factory=dict)

    def drive(self, scenes: Sequence[Scene]) -> tuple[Driven, ...]:
        """Drive some scenes."""
        return drive_scenes(scenes, self.registry, self.engine, self.options)


def parts_of(count: int, workers: int) -> list[range]:
    """The numbers of `count` scenes in parts, each driven together."""
    size = max(1, min(AT_ONCE, -(-count // max(workers, 1))))
    return [range(start, min(start + size, count)) for start in range(0, count, size)]
