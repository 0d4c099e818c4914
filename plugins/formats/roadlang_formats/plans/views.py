"""Which files are drawn as they are, and which name a map that is drawn."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from roadlang.api import read_input

from ..map_xml import LARGEST, MapFile, fault_at, read_map_xml
from . import commonroad_scenario, gltf_scene, lanelet2_map, mujoco_model, sumo_net
from .shapes import PlanShape

_ROOTS: Mapping[str, Callable[[MapFile], Iterator[PlanShape]]] = {
    "net": sumo_net.shapes,
    "commonRoad": commonroad_scenario.shapes,
    "mujoco": mujoco_model.shapes,
}
"""By the outermost element of an `.xml` file."""
_LOCAL_PATH = re.compile(r"^param map = localPath\(['\"]([^'\"]+)['\"]\)", re.MULTILINE)


def shapes_of(path: Path) -> list[PlanShape] | None:
    """What a file looks like from above, if it is one that is drawn as it is. Raises RL479."""
    found = _shapes(path)
    if found is None:
        return None
    shapes = [shape for shape in found if any(len(line) for line in shape.outlines)]
    if not shapes:
        raise fault_at(path, "", 0, "there is nothing to draw in it")
    return shapes


def map_named_in(path: Path) -> Path | None:
    """The map of a `.xosc` or `.scenic` file, beside it. Raises RL479 where it names none."""
    suffix = path.suffix.lower()
    if suffix == ".xosc":
        file = read_map_xml(path, "OpenSCENARIO")
        roads = file.root.first("RoadNetwork", "LogicFile")
        if roads is None:
            raise file.fault(file.root, "it names no roads: it has no `LogicFile`")
        return path.parent / file.attribute(roads, "filepath")
    if suffix == ".scenic":
        text = read_input(path, LARGEST).decode("utf-8", errors="replace")
        found = _LOCAL_PATH.search(text)
        if found is None:
            raise fault_at(path, text, 0, "it has no line `param map = localPath('...')`")
        return path.parent / found[1]
    return None


def _shapes(path: Path) -> Iterator[PlanShape] | None:
    suffix = path.suffix.lower()
    if suffix == ".glb":
        return gltf_scene.shapes(path)
    if suffix == ".xml":
        file = read_map_xml(path, *_ROOTS)
        return _ROOTS[file.root.tag](file)
    if suffix == ".osm" and b"lanelet" in read_input(path, LARGEST):
        file = read_map_xml(path, "osm")
        return lanelet2_map.shapes(file) if lanelet2_map.is_lanelet_map(file) else None
    return None
