"""`read with scene` and `read with geojson`: networks from JSON."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

import roadlang
from roadlang import testing
from roadlang.geometry import Curve
from roadlang.ir.scene import Scene
from roadlang_formats.read_geojson import GeoJson
from roadlang_formats.read_scene import SceneMap
from tests.formats.read_maps import CROSSING_TURNS, turns_of
from tests.formats.small_maps import crossing, straight, xodr

DRAWN = '''image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 2, sidewalks: 2m }
'''


def sampled(text: str) -> Scene:
    return testing.sample(text)[0].record


def read_again(scene: Scene, folder: Path, block: str = "") -> Scene:
    path = folder / "first.json"
    path.write_text(roadlang.Scene(scene).to_json())
    return sampled(f'network town from "{path}" {block}\n')


def line(*points: tuple[float, float], **properties: object) -> dict[str, object]:
    """A street through points of thousandths of degrees east and north of 48 N, 11 E."""
    coordinates = [[11 + x / 1000, 48 + y / 1000] for x, y in points]
    return {
        "type": "Feature",
        "properties": properties,
        "geometry": {"type": "LineString", "coordinates": coordinates},
    }


def geojson(folder: Path, *features: object) -> Path:
    path = folder / "town.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    return path


def test_a_scene_of_a_map_has_the_same_roads_and_turns(tmp_path: Path) -> None:
    (tmp_path / "town.xodr").write_text(crossing())
    scene = sampled(f'network town from "{tmp_path}/town.xodr"\n')
    again = read_again(scene, tmp_path)
    assert turns_of(again) == CROSSING_TURNS
    for one, other in zip(scene.roads, again.roads, strict=True):
        assert one.name == other.name
        curve = Curve.hermite(np.column_stack((other.x, other.y)), other.heading)
        assert np.abs(curve.project(np.column_stack((one.x, one.y)))[1]).max() < 1e-6


def test_roads_of_a_drawn_town_begin_at_their_junction(tmp_path: Path) -> None:
    scene = sampled(DRAWN)
    again = read_again(scene, tmp_path)
    assert turns_of(again) == turns_of(scene)
    for one, other in zip(scene.roads, again.roads, strict=True):
        assert other.length == pytest.approx(one.length - sum(one.trim), abs=1e-3)
        assert [lane.kind for lane in other.lane_list] == [lane.kind for lane in one.lane_list]
    lengths = [
        sum(c.length for c in scene_.networks[0].junctions[0].connections)
        for scene_ in (scene, again)
    ]
    assert lengths[0] == pytest.approx(lengths[1], rel=1e-3)


def test_what_was_read_may_be_perturbed(tmp_path: Path) -> None:
    block = "{ perturb with sine { amplitude: 3m, wavelength: 30m } }"
    again = read_again(sampled(DRAWN), tmp_path, block)
    assert turns_of(again) == turns_of(sampled(DRAWN))
    assert max(np.abs(road.curvature).max() for road in again.roads) > 0.01


@pytest.mark.parametrize("ids", [(0, 5), (5, 0), (1, 3)])
def test_roads_of_one_network_keep_their_numbers(tmp_path: Path, ids: tuple[int, int]) -> None:
    path = tmp_path / "town.xodr"
    path.write_text(xodr(*(straight(id, 0, 90 * id) for id in ids)))
    again = read_again(sampled(f'network town from "{path}"\n'), tmp_path)
    assert [found.edge for found in again.roads] == list(ids)


def test_roads_of_two_networks_are_numbered_anew(tmp_path: Path) -> None:
    path = tmp_path / "town.xodr"
    path.write_text(xodr(straight(4, 0, 0)))
    both = sampled(f'network one from "{path}"\nnetwork two from "{path}"\n')
    assert [found.edge for found in read_again(both, tmp_path).roads] == [0, 1]


def test_declared_roads_are_numbered(tmp_path: Path) -> None:
    road = "road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (110m, 50m)] } }\n"
    again = read_again(sampled(road), tmp_path)
    assert [found.name for found in again.roads] == ["town/0"]


def test_heights_and_the_origin_stay(tmp_path: Path) -> None:
    profile = '<elevationProfile><elevation s="0" a="5" b="0.1" c="0" d="0"/></elevationProfile>'
    header = "<geoReference>+proj=tmerc +lat_0=48 +lon_0=11</geoReference>"
    path = tmp_path / "town.xodr"
    path.write_text(xodr(straight(1, 0, 0, inside=profile), header=header))
    again = read_again(sampled(f'network town from "{path}"\n'), tmp_path)
    assert again.roads[0].elevation[-1] == pytest.approx(11.0)
    assert again.networks[0].origin == (48.0, 11.0)


@pytest.mark.parametrize("text", ["{", "[]", '{"schema": "roadlang.scene/2"}', "[" * 10_000])
def test_what_is_no_scene_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "first.json"
    path.write_text(text)
    with pytest.raises(roadlang.DiagnosticError) as caught:
        SceneMap().read(path)
    assert caught.value.diagnostics[0].code == "RL479"


@pytest.mark.parametrize(("member", "value"), [(0, 1e9), (0, 1e308), (1, 1e6), (1, -1e300)])
def test_turns_of_impossible_lengths_or_curvatures_are_refused(
    tmp_path: Path, member: int, value: float
) -> None:
    """Without hanging, and without a fault of the reader."""
    (tmp_path / "town.xodr").write_text(crossing())
    text = testing.sample(f'network town from "{tmp_path}/town.xodr"')[0].to_json()
    content = json.loads(text)
    content["networks"][0]["junctions"][0]["connections"][0]["pieces"][0][member] = value
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(content))
    with pytest.raises(roadlang.DiagnosticError, match="a turn has a piece") as caught:
        testing.sample(f'network town from "{path}"')
    assert caught.value.diagnostics[0].code == "RL479"


def test_lines_meet_where_they_share_a_point(tmp_path: Path) -> None:
    path = geojson(tmp_path, line((0, 0), (1, 0), (2, 0)), line((1, -1), (1, 0), oneway=True))
    network = GeoJson().read(path).network
    assert sorted(network.degree(node.id) for node in network.nodes) == [1, 1, 1, 3]


def test_properties_say_lanes_names_and_limits(tmp_path: Path) -> None:
    path = geojson(tmp_path, line((0, 0), (1, 0), lanes=3, name="Main", maxspeed=36))
    (edge,) = GeoJson().read(path).network.edges
    assert edge.name == "Main"
    found = [(lane.id, lane.speed_limit) for lane in edge.cross_section.lanes]
    assert found == [(1, 10.0), (-1, 10.0), (-2, 10.0)]


def test_the_origin_of_lines_is_latitude_first(tmp_path: Path) -> None:
    path = geojson(tmp_path, line((0, 0), (1, 0)))
    network = GeoJson(origin=(math.radians(48), math.radians(11))).read(path).network
    assert network.nodes[0].position == pytest.approx((0.0, 0.0), abs=1e-6)
    assert network.nodes[1].position == pytest.approx((74.6, 0.0), abs=0.1)


def test_polygons_may_be_buildings(tmp_path: Path) -> None:
    house = line((0, 1), (1, 1), (1, 2), (0, 2), (0, 1), building=True)
    geometry = {"type": "Polygon", "coordinates": [house["geometry"]["coordinates"]]}  # type: ignore[index]
    path = geojson(tmp_path, line((0, 0), (1, 0)), {**house, "geometry": geometry})
    assert len(GeoJson(buildings=True).read(path).objects) == 1
    assert GeoJson().read(path).objects == ()


@pytest.mark.parametrize("kind", ["Polygon", "MultiPolygon"])
def test_courtyards_are_no_buildings(tmp_path: Path, kind: str) -> None:
    rings = [[(x, y), (-x, y), (-x, -y), (x, -y), (x, y)] for x, y in ((0.3, 0.3), (0.1, 0.1))]
    house = [line(*ring)["geometry"]["coordinates"] for ring in rings]  # type: ignore[index]
    geometry = {"type": kind, "coordinates": house if kind == "Polygon" else [house, house]}
    feature = {"type": "Feature", "properties": {"building": "yes"}, "geometry": geometry}
    path = geojson(tmp_path, line((0, 1), (1, 1)), feature)
    objects = GeoJson(buildings=True).read(path).objects
    assert len(objects) == (1 if kind == "Polygon" else 2)
    assert min(found.length for found in objects) > 40.0


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ('{"type": "FeatureCollection", "features": [', "invalid JSON"),
        ("[]", "not a GeoJSON FeatureCollection"),
        ('{"type": "FeatureCollection", "features": [3]}', "feature 1"),
        ('{"type": "FeatureCollection", "features": []}', "no way"),
        (
            '{"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, "x"]]}}',
            "not a pair of numbers",
        ),
        (
            '{"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 99]]}}',
            "is not a place on Earth",
        ),
        ('{"type": "Feature", "geometry": {"type": ["LineString"]}}', "not a string"),
        (
            '{"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[true, 0]]}}',
            "not a pair of numbers",
        ),
        (
            '{"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 1%s]]}}'
            % ("0" * 400),
            "not a pair of numbers",
        ),
    ],
)
def test_faults_of_geojson_are_reported(tmp_path: Path, text: str, word: str) -> None:
    path = tmp_path / "town.geojson"
    path.write_text(text)
    with pytest.raises(roadlang.DiagnosticError, match=word) as caught:
        GeoJson().read(path)
    assert caught.value.diagnostics[0].code == "RL479"


def test_properties_that_are_no_words_or_numbers_are_no_tags(tmp_path: Path) -> None:
    """A null is what GIS programs write where a column has no value."""
    file = geojson(
        tmp_path,
        line((0, 0), (3, 0), highway="residential", name=None, lanes=2, oneway=False),
        line((0, 2), (3, 2), highway="residential", name="Elm St", lanes=["2"], oneway=True),
    )
    first, second = sampled(f'network town from "{file}"\n').roads
    assert (first.street, second.street) == ("", "Elm St")
    assert {lane.direction for lane in first.lane_list if lane.drivable} == {"forward", "backward"}
    assert {lane.direction for lane in second.lane_list if lane.drivable} == {"forward"}
