"""`emit gltf`, read again by a reader that is written from the standard alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import CURB_HEIGHT
from roadlang.ir.scene import Scene
from roadlang_formats.emit_gltf import GltfBackend
from roadlang_formats.surfaces.prisms import road_prisms
from roadlang_formats.surfaces.road_surface import road_surfaces
from tests.formats.glb_reader import ReadGlb

STREET = """
road main { draw with segments { pieces: [straight(40m), arc(30m, 90deg), straight(20m)] },
  left: [drive, sidewalk(2m)], right: [drive, parking(2m), sidewalk(2m)] }
agent ego is car on main at 10m { lane: -1 }
object oak is tree on main at 60m { side: left, offset: 3m }
"""
LOOP = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m), (80m, 60m), (0m, 60m)] },
  closed: true, width: 8m }
"""
TOWN = '''
world { traffic: left }
image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 4, sidewalks: 2m, control with signals }
agent cars is choice(car, bus, bicycle, pedestrian, dog) on town at random { count: 5 }
object things is choice(building, cone, lamp, bush, bench) on town at random {
  count: 10, side: left, offset: 1m }
'''
TEXTS = {"street": STREET, "loop": LOOP, "town": TOWN}


@pytest.fixture(scope="module", params=TEXTS)
def scene(request: pytest.FixtureRequest) -> Scene:
    found: Scene = testing.sample(TEXTS[request.param])[0].record
    return found


@pytest.fixture(scope="module")
def file(scene: Scene) -> ReadGlb:
    content = GltfBackend().files(scene)["glb"]
    assert GltfBackend().files(scene)["glb"] == content
    return ReadGlb.of(content)


def test_a_file_bears_the_title_of_its_scene_or_its_name() -> None:
    scene = testing.sample("road main { draw with waypoints { points: [(0m, 0m), (9m, 0m)] } }")[0]
    for title in ("A street", ""):
        content = GltfBackend().files(replace(scene.record, title=title))["glb"]
        said = ReadGlb.of(content).document["asset"]["extras"]
        assert said == {"title": title or scene.name, "scene": scene.index}


def area(triangles: np.ndarray) -> float:
    """Of triangles (t, 3, 3), seen from above."""
    a, b = (triangles[:, i, :2] - triangles[:, 0, :2] for i in (1, 2))
    return float(0.5 * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum())


def test_lanes_are_as_large_as_in_the_scene_and_lie_within_its_bounds(
    scene: Scene, file: ReadGlb
) -> None:
    for road in scene.roads:
        section, s = (
            road.cross_section(),
            np.linspace(road.trim[0], road.length - road.trim[1], 400),
        )
        for lane in section.lanes:
            shape = file.triangles(f"{road.name} lane {lane.id} {lane.kind}-col")
            offset, curvature = (
                section.offset(lane.id, s),
                np.interp(s, road.stations, road.curvature),
            )
            widths = section.lane_width(lane.id, s) * (1.0 - offset * curvature)
            assert area(shape) == pytest.approx(np.trapezoid(widths, s), rel=5e-3)
            assert shape[..., 2] == pytest.approx(CURB_HEIGHT if lane.raised else 0.0)


def test_a_road_is_where_the_scene_has_it(scene: Scene, file: ReadGlb) -> None:
    for road in scene.roads:
        names = [name for name in file.nodes if name.startswith(f"{road.name} lane")]
        shape = np.concatenate([file.triangles(name).reshape(-1, 3) for name in names])
        stations, heading = np.array(road.stations), np.array(road.heading)
        inside = (stations >= road.trim[0]) & (stations <= road.length - road.trim[1])
        borders = road.cross_section().border_offsets(stations)
        sides = [
            np.column_stack((road.x - away * np.sin(heading), road.y + away * np.cos(heading)))
            for away in (borders[0], borders[-1])
        ]
        points = np.concatenate([side[inside] for side in sides])
        np.testing.assert_allclose(shape[:, :2].min(axis=0), points.min(axis=0), atol=0.01)
        np.testing.assert_allclose(shape[:, :2].max(axis=0), points.max(axis=0), atol=0.01)


def test_agents_and_objects_have_their_sizes_and_poses(scene: Scene, file: ReadGlb) -> None:
    for actor in (*scene.agents, *scene.objects):
        shape = file.triangles(f"{actor.name}-convcol").reshape(-1, 3)
        cos, sin = np.cos(actor.heading), np.sin(actor.heading)
        local = (shape - (actor.x, actor.y, 0.0)) @ np.array(
            [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]]
        )
        half = actor.length / 2, actor.width / 2
        np.testing.assert_allclose(local.min(axis=0), (-half[0], -half[1], 0.0), atol=1e-3)
        np.testing.assert_allclose(local.max(axis=0), (*half, actor.height), atol=1e-3)


def test_all_accessors_are_sound_and_all_faces_look_outward(file: ReadGlb) -> None:
    for name, node in file.nodes.items():
        if "mesh" in node:
            assert len(file.triangles(name)) > 0
    used = set(range(len(file.document["bufferViews"])))
    assert used == {accessor["bufferView"] for accessor in file.document["accessors"]}


def test_a_drive_moves_its_agents() -> None:
    scenes = testing.sample(
        STREET + "agent lead is van on main at 40m { drive with lane_follow }\n"
        "simulate with builtin { duration: 2s }"
    )
    drive = scenes[0].run()
    trace = drive.trace
    file = ReadGlb.of(GltfBackend().drive_files(scenes[0].record, trace)["drive.glb"])
    (animation,) = file.document["animations"]
    names = {file.document["nodes"][c["target"]["node"]]["name"] for c in animation["channels"]}
    assert names == {"ego-convcol", "lead-convcol"}
    samplers = {
        (file.document["nodes"][channel["target"]["node"]]["name"], channel["target"]["path"]): (
            animation["samplers"][channel["sampler"]]
        )
        for channel in animation["channels"]
    }
    places = samplers["lead-convcol", "translation"]
    times = file.values(places["input"])[:, 0]
    np.testing.assert_allclose(times, trace.time, atol=1e-6)
    east, _, south = file.values(places["output"]).T
    np.testing.assert_allclose(east, trace.agents["lead"].x, atol=1e-4)
    np.testing.assert_allclose(-south, trace.agents["lead"].y, atol=1e-4)
    turns = file.values(samplers["lead-convcol", "rotation"]["output"])
    np.testing.assert_allclose(
        2.0 * np.arctan2(turns[:, 1], turns[:, 3]), trace.agents["lead"].heading, atol=1e-5
    )


def test_convex_meshes_for_unreal_cover_what_is_solid(scene: Scene) -> None:
    file = ReadGlb.of(GltfBackend(collision="unreal").files(scene)["glb"])
    convex = {name: file.triangles(name) for name in file.nodes if name.startswith("UCX_")}
    meshes = {mesh["name"] for mesh in file.document["meshes"]}
    assert {name[4:].rpartition("_")[0] for name in convex} <= meshes
    for actor in (*scene.agents, *scene.objects):
        shape, seen = convex[f"UCX_{actor.name}_00"], file.triangles(actor.name)
        for side in (np.min, np.max):
            limits = [side(rows.reshape(-1, 3), axis=0) for rows in (shape, seen)]
            np.testing.assert_allclose(limits[0][2], limits[1][2], atol=1e-3)
    tops = [area(shape[(shape[:, :, 2] > -0.01).all(axis=1)]) for shape in convex.values()]
    ground = sum(tops)  # tops and bottoms of boxes cancel out
    lanes = [name for name in file.nodes if " lane " in name or name.endswith(" area")]
    lanes = [name for name in lanes if not name.startswith("UCX_")]
    assert ground == pytest.approx(sum(area(file.triangles(name)) for name in lanes), rel=0.01)


def test_a_road_that_is_all_junction_has_no_surface() -> None:
    text = "road main { draw with waypoints { points: [(0m, 0m), (50m, 0m)] } }\n"
    scene = testing.sample(text)[0].record
    (road,) = scene.roads
    for trim, count in (((20.0, 20.0), 1), ((20.0, 30.0), 0), ((50.0, 0.0), 0)):
        trimmed = replace(scene, roads=(replace(road, trim=trim),))
        assert len(list(road_surfaces(trimmed, 0.1))) == count
        for surface in road_surfaces(trimmed, 0.1):
            assert (surface.stations[0], surface.stations[-1]) == pytest.approx((20.0, 30.0))


def test_neighboring_lanes_of_one_height_are_one_prism() -> None:
    """Two sidewalks and the roadway between them: three for each span, as wide as their lanes."""
    text = "road main { draw with waypoints { points: [(0m, 0m), (50m, 0m)] }, left: [drive(3m), "
    text += "bike(1m), sidewalk(2m)], right: [drive(3.5m), sidewalk(1.5m)] }\n"
    (surface,) = road_surfaces(testing.sample(text)[0].record, 0.1)
    found = [(round(np.ptp(p[:, 1]), 6), raised) for p, raised in road_prisms(surface, 0.5)]
    spans = len(surface.stations) - 1
    assert sorted(found) == sorted([(2.0, True), (7.5, False), (1.5, True)] * spans)


def test_the_ground_lies_under_all_that_there_is_and_far_around_it(
    scene: Scene, file: ReadGlb
) -> None:
    ground = file.triangles("ground-col").reshape(-1, 3)
    corners = ground[:, :2].min(axis=0), ground[:, :2].max(axis=0)
    x, y = (np.concatenate([getattr(road, axis) for road in scene.roads]) for axis in "xy")
    for low, high, along in zip(*corners, (x, y), strict=True):
        assert (low < along.min() - 100.0) & (low > along.min() - 250.0)
        assert (high > along.max() + 100.0) & (high < along.max() + 250.0)
    assert (ground[:, 2] < 0.0).all()
