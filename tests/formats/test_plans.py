"""`roadlang view` of files that are no networks: what is drawn is where the scene has it."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import numpy as np
import pytest
import shapely

from roadlang import testing
from roadlang.api import Backend, DiagnosticError, Scene
from roadlang_formats.emit_commonroad import CommonRoadBackend
from roadlang_formats.emit_gltf import GltfBackend
from roadlang_formats.emit_lanelet2 import Lanelet2Backend
from roadlang_formats.emit_mujoco import MujocoBackend
from roadlang_formats.emit_openscenario import OpenScenarioBackend
from roadlang_formats.emit_scenic import ScenicBackend
from roadlang_formats.emit_sumo import SumoBackend
from roadlang_formats.plans.drawing import drawn
from roadlang_formats.plans.views import map_named_in, shapes_of

TEXT = """
road main { draw with segments { pieces: [straight(60m), arc(40m, 60deg)] }, lanes: 2,
  width: 7m }
agent ego is car on main at 10m
object shed is building at (30m, 40m) { heading: 30deg, length: 8m, width: 4m }
"""
BACKENDS: dict[str, Backend] = {
    "net.xml": SumoBackend(),
    "lanelet2.osm": Lanelet2Backend(),
    "cr.xml": CommonRoadBackend(),
    "mjcf.xml": MujocoBackend(),
    "glb": GltfBackend(),
}
WITHOUT_OBJECTS = ("net.xml", "lanelet2.osm")


@pytest.fixture(scope="module")
def scene() -> Scene:
    return testing.sample(TEXT)[0].record


def written(scene: Scene, backend: Backend, folder: Path) -> None:
    for ending, content in backend.files(scene).items():
        data = content if isinstance(content, bytes) else content.encode()
        (folder / f"scene.{ending}").write_bytes(data)


@pytest.mark.parametrize("ending", BACKENDS)
def test_what_is_drawn_lies_where_the_scene_has_it(
    scene: Scene, tmp_path: Path, ending: str
) -> None:
    written(scene, BACKENDS[ending], tmp_path)
    path = tmp_path / f"scene.{ending}"
    shapes = shapes_of(path)
    assert shapes is not None
    parts = []
    for shape in shapes:
        for line in shape.outlines:
            ribbon = shape.width and shapely.LineString(line).buffer(shape.width / 2.0)
            parts.append(ribbon or shapely.Polygon(line).buffer(0.01))
    covered = shapely.union_all(parts)
    (road,) = scene.roads
    points = np.column_stack((road.x, road.y))[2:-2]
    left = np.column_stack((-np.sin(road.heading), np.cos(road.heading)))[2:-2]
    for offset, inside in ((3.2, True), (-3.2, True), (5.0, False), (-5.0, False)):
        found = shapely.contains_xy(covered, *(points + offset * left).T)
        assert found.all() if inside else not found.any(), offset
    (shed,) = scene.objects
    assert shapely.contains_xy(covered, shed.x, shed.y) == (ending not in WITHOUT_OBJECTS)
    assert drawn(shapes, path.name, 400.0).rstrip().endswith("</svg>")


@pytest.mark.parametrize(
    ("backend", "ending", "named"),
    [
        (OpenScenarioBackend(), "xosc", "scene-0000.road.xodr"),
        (ScenicBackend(), "scenic", "scene-0000.scenic.xodr"),
    ],
)
def test_scenarios_name_their_map(
    scene: Scene, tmp_path: Path, backend: Backend, ending: str, named: str
) -> None:
    written(scene, backend, tmp_path)
    assert shapes_of(tmp_path / f"scene.{ending}") is None
    assert map_named_in(tmp_path / f"scene.{ending}") == tmp_path / named


def test_lanelets_without_local_coordinates_are_projected(tmp_path: Path) -> None:
    nodes = [(48.1, 11.5), (48.101, 11.5), (48.1, 11.5001), (48.101, 11.5001)]
    text = "".join(
        f'<node id="{k}" lat="{latitude}" lon="{longitude}"/>'
        for k, (latitude, longitude) in enumerate(nodes)
    )
    # The right border runs the other way.
    text += (
        '<way id="9"><nd ref="0"/><nd ref="1"/></way><way id="8"><nd ref="3"/><nd ref="2"/></way>'
    )
    text += '<relation id="7"><member type="way" ref="9" role="left"/><member type="way" ref="8"'
    text += ' role="right"/><tag k="type" v="lanelet"/></relation>'
    path = tmp_path / "map.osm"
    path.write_text(f"<osm>{text}</osm>")
    (shape,) = shapes_of(path) or []
    area = shapely.Polygon(shape.outlines[0]).area
    assert area == pytest.approx(111.2 * 7.44, rel=0.01)


BROKEN = {
    "a.net.xml": '<net><edge id="e"><lane id="l" shape="0,0 nan,1"/></edge></net>',
    "b.net.xml": "<net><edge>",
    "c.net.xml": "<net/>",
    "d.xml": '<commonRoad><lanelet id="1"><leftBound/></lanelet></commonRoad>',
    "e.xml": "<routes/>",
    "f.xml": '<mujoco><worldbody><geom type="box" size="x"/></worldbody></mujoco>',
    "g.osm": '<osm><relation id="1"><tag k="type" v="lanelet"/></relation></osm>',
    "h.glb": "glTF",
    "i.glb": "x" * 40,
}


@pytest.mark.parametrize("name", BROKEN)
def test_broken_files_are_explained(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text(BROKEN[name])
    with pytest.raises(DiagnosticError) as caught:
        shapes_of(path)
    assert [diagnostic.code for diagnostic in caught.value.diagnostics] == ["RL479"]


@pytest.mark.parametrize(
    "document",
    [
        {"scenes": [{"nodes": [0]}], "nodes": [{"children": [0]}]},
        {"scenes": [{"nodes": [0]}], "nodes": []},
        {"scenes": 3},
    ],
)
def test_absurd_nodes_are_explained(tmp_path: Path, document: object) -> None:
    text = json.dumps(document).encode()
    chunk = struct.pack("<I4s", len(text), b"JSON") + text
    path = tmp_path / "scene.glb"
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunk)) + chunk)
    with pytest.raises(DiagnosticError):
        shapes_of(path)
