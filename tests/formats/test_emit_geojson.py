"""`emit geojson`: where things are on Earth, and what `read with geojson` makes of it."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from scipy.spatial import cKDTree

from roadlang import DiagnosticError, testing
from roadlang.api import Scene
from roadlang.cli.main import run
from roadlang.geometry import Curve, Floats
from roadlang.geometry.earth.local_projection import LocalProjection
from roadlang_formats.emit_geojson import GeoJsonBackend
from roadlang_formats.read_geojson import GeoJson
from roadlang_formats.road_mask import road_mask
from tests.formats.test_read_osm import osm, way
from tests.geometry.test_local_projection import kruger

ORIGIN = (math.radians(48.1), math.radians(11.6))
TOWN = '''image plan from """
....#....
#########
....#....
....#....
""" { scale: 40m/px }
network plain from plan { lanes: 2, sidewalks: 2m, speed_limit: 50km/h }
network town from plain { perturb with sine { amplitude: 4m, wavelength: 90m } }
object home is building at (30m, 30m) { heading: 30deg }
agent ego is car on town at random { drive with car_follow { speed: 8m/s } }
'''
LOOP = """road loop {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (80m, 60m), (0m, 60m)] }
  closed: true, lanes: 2, oneway: true
}
"""


@cache
def scene_of(text: str) -> Scene:
    return testing.sample(text)[0].record


def features(scene: Scene, **options: Any) -> list[dict[str, Any]]:
    found = json.loads(GeoJsonBackend(**{"origin": ORIGIN, **options}).files(scene)["geojson"])
    assert found["type"] == "FeatureCollection"
    return list(found["features"])


def of_type(found: list[dict[str, Any]], type: str) -> list[dict[str, Any]]:
    return [feature for feature in found if feature["properties"]["type"] == type]


def meters(line: list[list[float]]) -> Floats:
    projection = LocalProjection(*map(math.degrees, ORIGIN))
    return np.array([projection.point(latitude, longitude) for longitude, latitude in line])


def area(ring: Floats) -> float:
    (x, y) = (ring - ring[0]).T
    return float(x[:-1] @ y[1:] - x[1:] @ y[:-1]) / 2


def test_longitude_is_first_and_places_are_those_of_the_exact_projection() -> None:
    road = "road main { draw with waypoints { points: [(-400m, 300m), (900m, 300m)] } }"
    (found,) = features(scene_of(road), lanes=False)
    ends = []
    for longitude, latitude in found["geometry"]["coordinates"][::-1]:
        x, y = kruger(latitude, longitude, 11.6)
        ends.append((x, y - kruger(48.1, 11.6, 11.6)[1]))
    assert np.array(ends[-1]) == pytest.approx((-400, 300), abs=1e-3)
    assert np.array(ends[0]) == pytest.approx((900, 300), abs=1e-3)


def test_roads_and_buildings_are_read_back_within_a_centimeter(tmp_path: Path) -> None:
    scene = scene_of(TOWN)
    path = tmp_path / "town.geojson"
    path.write_text(GeoJsonBackend(origin=ORIGIN).files(scene)["geojson"])
    again = GeoJson(origin=ORIGIN, buildings=True).read(path)
    written = [road for road in scene.roads if road.derived]
    assert len(again.network.edges) == len(written) == 4
    assert sorted(again.network.degree(node.id) for node in again.network.nodes) == [1, 1, 1, 1, 4]
    for road, edge in zip(written, again.network.edges, strict=True):
        curve = Curve.hermite(np.column_stack((road.x, road.y)), road.heading)
        for one, other in ((curve, edge.curve), (edge.curve, curve)):
            points = one.at(np.linspace(0, one.length, 200))
            assert np.abs(other.project(points)[1]).max() < 0.01
        assert edge.cross_section is not None
        lanes = edge.cross_section.lanes
        assert [(lane.id, lane.speed_limit) for lane in lanes] == [
            (id, pytest.approx(50 / 3.6, abs=1e-4)) for id in (1, -1)
        ]
    (home,), (place,) = again.objects, scene.objects
    assert (home.x, home.y) == pytest.approx((place.x, place.y), abs=0.01)
    sizes = sorted((home.length, home.width)), sorted((place.length, place.width))
    assert sizes[0] == pytest.approx(sizes[1], abs=0.02)


def test_areas_are_closed_run_counterclockwise_and_cover_the_road() -> None:
    scene = scene_of(TOWN)
    found = features(scene)
    assert len({feature["id"] for feature in found}) == len(found)
    rings = {
        feature["id"]: meters(feature["geometry"]["coordinates"][0])
        for feature in found
        if feature["geometry"]["type"] == "Polygon"
    }
    for ring in rings.values():
        assert (ring[0] == ring[-1]).all()
        assert area(ring) > 0
    for road in (road for road in scene.roads if road.derived):
        names = [f"road {road.name}, lane {id}" for id in (1, -1)]
        full = (road.length - sum(road.trim)) * road.width[0]
        assert sum(area(rings[name]) for name in names) == pytest.approx(full, rel=0.01)
    (ego,) = scene.agents
    assert rings["agent ego"][:4].mean(axis=0) == pytest.approx((ego.x, ego.y), abs=1e-3)
    front = rings["agent ego"][[0, 3]].mean(axis=0) - (ego.x, ego.y)
    (properties,) = (item["properties"] for item in of_type(found, "agent"))
    bearing = math.degrees(math.atan2(front[0], front[1])) % 360
    assert properties["bearing"] == pytest.approx(bearing, abs=0.05)
    assert properties["speed"] == 8.0


@pytest.mark.parametrize(
    ("lanes", "limit"),
    [
        ("lanes: 2", None),
        ("lanes: 2, speed_limit: 50km/h", 50.0),
        ("left: [drive], right: [drive], speed_limit: 50km/h", 50.0),
        ("left: [drive(speed_limit: 30km/h)], right: [drive], speed_limit: 30km/h", 30.0),
        ("left: [drive(speed_limit: 30km/h)], right: [drive], speed_limit: 50km/h", None),
        ("right: [drive(speed_limit: 30km/h), sidewalk], speed_limit: 50km/h", 30.0),
    ],
)
def test_a_speed_limit_is_said_where_one_holds_in_all_lanes(
    lanes: str, limit: float | None
) -> None:
    text = f"road main {{ draw with segments {{ pieces: [straight(80m)] }}, {lanes} }}"
    (road,) = of_type(features(scene_of(text)), "road")
    assert road["properties"].get("maxspeed") == limit


def test_limits_that_differ_are_said_by_direction() -> None:
    lanes = "left: [drive(speed_limit: 30km/h)], right: [drive], speed_limit: 50km/h"
    text = f"road main {{ draw with segments {{ pieces: [straight(80m)] }}, {lanes} }}"
    (road,) = of_type(features(scene_of(text)), "road")
    found = {key: value for key, value in road["properties"].items() if "maxspeed" in key}
    assert found == {"maxspeed:backward": 30.0, "maxspeed:forward": 50.0}


def test_lanes_of_a_loop_are_rings_with_a_hole() -> None:
    scene = scene_of(LOOP)
    found = features(scene)
    (line,) = of_type(found, "road")
    assert line["geometry"]["coordinates"][0] == line["geometry"]["coordinates"][-1]
    assert line["properties"]["oneway"] == "yes"
    total = 0.0
    for lane in of_type(found, "lane"):
        outer, inner = (area(meters(ring)) for ring in lane["geometry"]["coordinates"])
        assert outer > 0 > inner
        total += outer + inner
    (road,) = scene.roads
    assert total == pytest.approx(road.length * road.width[0], rel=0.01)


def test_a_picture_that_has_no_place_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    picture = np.full((60, 90, 3), 255, np.uint8)
    picture[28:34] = 60
    cv2.imwrite("a.png", picture)
    Path("a.pgw").write_text("0.5\n0\n0\n-0.5\n690000\n5335000\n")
    Path("a.rl").write_text('image photo from "a.png"\nnetwork town from photo\nemit geojson\n')
    assert run(["compile", "a.rl", "-n", "1"]) == 1
    shown = capsys.readouterr().err
    assert shown.index("RL439") < shown.index("RL480")


def test_the_origin_is_that_of_the_map(tmp_path: Path) -> None:
    path = tmp_path / "town.osm"
    path.write_text(osm(way(1, "31 33 35", name="Main"), way(2, "13 33 53")))
    scene = scene_of(f'network town from "{path}"\n')
    roads = of_type(features(scene, origin=None), "road")
    ends = {tuple(np.round(road["geometry"]["coordinates"][0], 7)) for road in roads}
    assert ends == {(11.001, 48.003), (11.003, 48.003), (11.003, 48.001)}
    assert [road["properties"].get("name") for road in roads] == ["Main", "Main", None, None]


def test_roads_of_a_picture_are_where_its_lower_left_corner_says(tmp_path: Path) -> None:
    truth = scene_of(TOWN)
    mask = road_mask(truth, 0.5, 10.0)
    (tmp_path / "top.png").write_bytes(mask.png())
    (tmp_path / "top.pgw").write_text(mask.world_file())
    found = scene_of(
        f'image top from "{tmp_path}/top.png" {{ legend: {{ "white": road }} }}\n'
        "network town from top { extract with pixels }\n"
    )
    corner = LocalProjection(*map(math.degrees, ORIGIN)).place(mask.left, mask.bottom)
    again = features(found, origin=tuple(map(math.radians, corner)))
    places = [[meters(road["geometry"]["coordinates"]) for road in of_type(all, "road")]
              for all in (features(truth), again)]  # fmt: skip
    all_curves = [[Curve.through(line) for line in lines] for lines in places]
    there, back = (
        np.vstack([curve.at(np.linspace(0, curve.length, 200)) for curve in curves])
        for curves in all_curves
    )
    for one, other in ((there, back), (back, there)):
        assert np.median(cKDTree(one).query(other)[0]) < 0.5


def test_longitudes_stay_within_half_a_turn() -> None:
    road = "road main { draw with waypoints { points: [(500m, 0m), (900m, 0m)] } }"
    (found,) = features(scene_of(road), origin=(0.2, math.radians(179.999)), lanes=False)
    assert all(-180 <= x < -179 for x, _ in found["geometry"]["coordinates"])


def test_a_scene_that_is_nowhere_is_refused() -> None:
    with pytest.raises(DiagnosticError, match="the scene has no location from a map") as caught:
        features(scene_of("road main { draw with segments { pieces: [straight(50m)] } }"),
                 origin=None)  # fmt: skip
    assert caught.value.diagnostics[0].code == "RL480"


@pytest.mark.parametrize("kind", ["geojson", "lanelet2"])
@pytest.mark.parametrize(
    ("origin", "word"), [("(148deg, 11deg)", "poles"), ("(1deg, 200deg)", "beyond 180")]
)
def test_origins_that_are_not_on_earth_are_reported(kind: str, origin: str, word: str) -> None:
    road = "road main { draw with segments { pieces: [straight(50m)] } }\n"
    with pytest.raises(DiagnosticError, match=word):
        testing.sample(f"{road}emit {kind} {{ origin: {origin} }}")


@pytest.mark.parametrize("longitude", [179.9995, 179.9975])
def test_what_crosses_the_antimeridian_is_cut_there(longitude: float, tmp_path: Path) -> None:
    """RFC 7946, section 3.1.9: lines and areas in parts, none of which crosses it, and the streets
    are those of a town elsewhere when they are read."""
    found = features(scene_of(TOWN), origin=(ORIGIN[0], math.radians(longitude)))
    cut = [feature for feature in found if feature["geometry"]["type"].startswith("Multi")]
    assert {feature["properties"]["type"] for feature in cut} >= {"road", "lane"}
    for feature in found:
        assert np.abs(_longitudes(feature["geometry"])).max() <= 180.0
    path = tmp_path / "town.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": found}))
    elsewhere = tmp_path / "elsewhere.geojson"
    usual = {"type": "FeatureCollection", "features": features(scene_of(TOWN))}
    elsewhere.write_text(json.dumps(usual))
    here, there = GeoJson().read(path), GeoJson().read(elsewhere)
    assert abs(here.network.origin[1]) == pytest.approx(180.0, abs=0.01)
    lengths = [sorted(edge.curve.length for edge in one.network.edges) for one in (here, there)]
    assert lengths[0] == pytest.approx(lengths[1], abs=0.05)


def _longitudes(geometry: dict[str, Any]) -> Floats:
    numbers = json.loads(json.dumps(geometry["coordinates"]))
    flat: list[float] = []
    pending = [numbers]
    while pending:
        part = pending.pop()
        if isinstance(part[0], float):
            flat.append(part[0])
        else:
            pending.extend(part)
    return np.array(flat)
