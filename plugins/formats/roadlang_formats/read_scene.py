"""`read with scene`: the roads of a scene that roadlang has written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Reader

if TYPE_CHECKING:
    from pathlib import Path


@dataclass(frozen=True)
class SceneMap(Reader):
    """The roads, lanes and junctions of a scene in roadlang's JSON. Agents and objects are
    ignored."""

    name: ClassVar[str] = "scene"
    suffixes: ClassVar[tuple[str, ...]] = (".json",)
    reads: ClassVar[tuple[str, ...]] = ("network",)

    def read(self, path: Path) -> Any:
        """A `RoadNetwork`. Raises RL479."""
        import roadlang
        from roadlang.geometry import GeometryError

        from .json_maps import read_json
        from .map_xml import fault_at
        from .scene_network import network_of

        text, _ = read_json(path)
        try:
            scene = roadlang.Scene.from_json(text)
        except (ValueError, roadlang.DiagnosticError) as error:
            raise fault_at(path, text, 0, f"it is not a scene: {error}") from None
        if not scene.record.roads:
            raise fault_at(path, text, 0, "it has no roads")
        try:
            return network_of(scene.record)
        except (GeometryError, ArithmeticError) as error:
            raise fault_at(path, text, 0, f"its roads cannot be built: {error}") from None
