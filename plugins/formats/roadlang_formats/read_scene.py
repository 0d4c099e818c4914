"""`read with scene`: the roads of a scene that roadlang has written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import Reader

if TYPE_CHECKING:
    from pathlib import Path

    import roadlang


@dataclass(frozen=True)
class SceneMap(Reader):
    """The roads, lanes and junctions of a scene in roadlang's JSON. Agents and objects are
    ignored."""

    name: ClassVar[str] = "scene"
    suffixes: ClassVar[tuple[str, ...]] = (".json",)
    reads: ClassVar[tuple[str, ...]] = ("network",)

    def read(self, path: Path) -> Any:
        """A `RoadNetwork`. Raises RL479."""
        from roadlang.geometry import GeometryError

        from .json_maps import read_json
        from .map_xml import fault_at
        from .scene_network import network_of

        text, _ = read_json(path)
        scene = scene_in(path, text)
        if not scene.record.roads:
            raise fault_at(path, text, 0, "it has no roads")
        try:
            return network_of(scene.record)
        except (GeometryError, ArithmeticError) as error:
            raise fault_at(path, text, 0, f"its roads cannot be built: {error}") from None


def scene_in(path: Path, text: str) -> roadlang.Scene:
    """The scene in the text of a file. Raises RL479."""
    import roadlang

    from .map_xml import fault_at

    try:
        return roadlang.Scene.from_json(text)
    except roadlang.DiagnosticError as error:
        raise fault_at(path, text, 0, error.diagnostics[0].message) from None
