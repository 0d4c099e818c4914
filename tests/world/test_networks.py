"""Networks: every road bent, junctions joined, requirements held on each road."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar

import cv2
import numpy as np
import pytest

from roadlang.api import Extraction, Extractor, Picture
from roadlang.diagnostics import DiagnosticError
from roadlang.geometry import RoadNetwork
from roadlang.ir.scenario import FileSource
from roadlang.scenes.sampling import SamplingResult
from roadlang.world.sources.roadless_sources import advice_without_roads

Sample = Callable[..., SamplingResult]
TOWN = '''
image plan from """
  ...#....T
  ...#.....
  #########
  ...#...B.
  ...#.....
""" { scale: 12m/px, legend: { "#": road, "T": tree, "B": building } }
network town from plan { extract with pixels }
'''
BENT = (
    TOWN
    + "network bent from town { perturb with random_walk { amplitude: 2m, correlation: 20m } }\n"
)


def test_junctions_stay_joined(sample: Sample) -> None:
    (scene,) = sample(BENT).scenes
    roads = {road.name: road for road in scene.roads}
    bent = next(network for network in scene.networks if network.name == "bent")
    (junction,) = [node for node in bent.nodes if len(node.roads) == 4]
    for name in junction.roads:
        road = roads[name]
        ends = [(road.x[0], road.y[0]), (road.x[-1], road.y[-1])]
        gap = min(np.hypot(x - junction.x, y - junction.y) for x, y in ends)
        assert gap < 1e-6
        assert max(np.abs(np.subtract(road.y, roads[road.root].y))) > 0.05 or (
            max(np.abs(np.subtract(road.x, roads[road.root].x))) > 0.05
        )


def test_an_unnamed_draw_is_made_for_each_road_and_a_named_one_once(sample: Sample) -> None:
    own = sample(
        TOWN + "network bent from town { \n"
        "perturb with bump { at: 15m, length: 20m, height: 0m..3m } }\n"
    )
    draws = own.scenes[0].draws
    assert len(set(draws.values())) == len(draws) == 4
    text = (
        TOWN + "param h = 0m..3m\nnetwork bent from town { \n"
        "perturb with bump { at: 15m, length: 20m, height: h } }\n"
    )
    assert list(sample(text).scenes[0].draws) == ["h"]


def test_a_requirement_on_a_network_holds_on_its_worst_road(sample: Sample) -> None:
    text = BENT + "require near: always (deviation(bent, town) < 1m)\n"
    for scene in sample(text, 4).scenes:
        roads = {road.name: road for road in scene.roads}
        worst = max(
            np.hypot(np.subtract(r.x, roads[r.root].x), np.subtract(r.y, roads[r.root].y)).max()
            for r in scene.roads
            if r.network == "bent"
        )
        assert worst < 1
        assert scene.requirements[0].robustness == pytest.approx(1 - worst, abs=1e-9)


def test_only_the_roads_named_are_bent(sample: Sample) -> None:
    text = (
        TOWN + "network bent from town { \n"
        "perturb with bump { at: 15m, length: 20m, height: 2m, roads: [2] } }\n"
    )
    (scene,) = sample(text).scenes
    roads = {road.name: road for road in scene.roads}
    moved = [
        road.edge
        for road in scene.roads
        if road.network == "bent" and road.x + road.y != roads[road.root].x + roads[road.root].y
    ]
    assert moved == [2]


def test_a_road_of_a_bent_network_is_bent_as_its_edges_are(sample: Sample) -> None:
    text = (
        BENT
        + "road street from bent { select: road(1) }\nroad before from town { select: road(1) }\n"
    )
    (scene,) = sample(text + "require near: always (deviation(street, before) < 2.5m)\n").scenes
    roads = {road.name: road for road in scene.roads}
    assert roads["street"].x == pytest.approx(roads["bent/1"].x)
    assert roads["before"].x == pytest.approx(roads["town/1"].x)
    robustness = scene.requirements[0].robustness
    assert robustness is not None
    assert robustness < 2.5


def test_a_route_goes_through_the_junction(sample: Sample) -> None:
    text = TOWN + "road tour from town { select: route((6m, 30m), (42m, 54m)) }\n"
    (scene,) = sample(text).scenes
    (tour,) = [road for road in scene.roads if road.name == "tour"]
    assert tour.length == pytest.approx(36 + 24, rel=0.1)
    assert np.hypot(tour.x[0] - 6, tour.y[0] - 30) < 6


def test_any_road_is_drawn_for_each_scene(sample: Sample) -> None:
    scenes = sample(TOWN + "road street from town { select: any }\n", 12).scenes
    firsts = {next(r for r in scene.roads if r.name == "street").x[0:2] for scene in scenes}
    assert len(firsts) >= 3


def test_the_legend_places_what_it_names(sample: Sample) -> None:
    (scene,) = sample(TOWN).scenes
    things = {thing.kind: (thing.x, thing.y) for thing in scene.objects}
    assert things == {"tree": (8.5 * 12, 4.5 * 12), "building": (7.5 * 12, 1.5 * 12)}


def test_a_road_that_is_not_there_is_refused(sample: Sample) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sample(TOWN + "network bent from town { perturb with scale { factor: 2, roads: [99] } }\n")
    assert caught.value.diagnostics[0].code == "RL411"


def test_a_picture_without_a_road_says_so(sample: Sample, tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "flat.png"), np.full((80, 80, 3), 90, np.uint8))
    with pytest.raises(DiagnosticError) as caught:
        sample('image a from "flat.png" { scale: 1m/px }\nnetwork town from a\n')
    (found,) = caught.value.diagnostics
    assert found.code == "RL412"
    assert "`extract with aerial` for a photo" in found.help[-1]


def test_who_gets_no_road_from_a_file_is_told_to_view_it() -> None:
    """As from the reader of a plugin; those of maps say it themselves (RL479)."""
    source = FileSource("town.osm", "/maps/town.osm")
    network: Any = SimpleNamespace(source=source)
    candidates: Any = None
    assert advice_without_roads(network, candidates).startswith("`roadlang view town.osm` shows")


def test_a_typed_picture_without_a_road_says_how_one_is_drawn(sample: Sample) -> None:
    with pytest.raises(DiagnosticError) as caught:
        sample(TOWN.replace("#", ".").replace('".": road', '"#": road'))
    (found,) = caught.value.diagnostics
    assert found.help[-1] == "draw some with the character that the `legend` calls `road`"


def test_a_typed_picture_without_a_legend_is_told_to_say_what_is_a_road(sample: Sample) -> None:
    text = re.sub("legend: {.*?}", "", TOWN.replace("#", "|"))
    with pytest.raises(DiagnosticError) as caught:
        sample(text)
    (found,) = caught.value.diagnostics
    assert found.code == "RL412"
    assert found.help[-1] == 'say which characters are roads: `legend: { "#": road }`'


def test_an_image_needs_a_scale(sample: Sample, tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "flat.png"), np.full((80, 80, 3), 90, np.uint8))
    with pytest.raises(DiagnosticError) as caught:
        sample('image a from "flat.png"\nnetwork town from a\n')
    assert caught.value.diagnostics[0].code == "RL406"
    span = caught.value.diagnostics[0].span
    assert span is not None
    assert span.line == 1


def test_an_adjusted_picture_with_noise_is_one_of_its_scene(sample: Sample, tmp_path: Path) -> None:
    pixels = np.full((120, 120, 3), 230, np.uint8)
    cv2.line(pixels, (10, 60), (110, 50), (60, 60, 60), 8)
    cv2.imwrite(str(tmp_path / "road.png"), pixels)
    text = """
image photo from "road.png" { scale: 0.5m/px }
image worse from photo { adjust with noise { sigma: 12% } }
network seen from worse { extract with contour }
road found from seen { select: longest }
"""
    scenes = sample(text, 3).scenes
    lines = [scene.roads[0].y for scene in scenes]
    assert all(a != b for a, b in itertools.combinations(lines, 2))
    assert sample(text, 1).scenes[0] == scenes[0]


@dataclass(frozen=True)
class Unsure(Extractor):
    """Two roads that meet, one of them doubtful."""

    name: ClassVar[str] = "unsure"

    def extract(self, picture: Picture) -> Extraction:
        found = picture.network([np.array([(0.0, 0.0), (9.0, 0.0)])])
        (edge,) = found.network.edges
        network = RoadNetwork(found.network.nodes, (replace(edge, confidence=0.9),))
        return replace(found, network=network, confidence=0.6)


def test_a_road_of_a_network_is_as_sure_as_the_network(sample: Sample) -> None:
    text = (
        'image plan from """\n##########\n""" { scale: 10m/px }\n'
        "network lane from plan { extract with acme.unsure }\n"
        "road main from lane\n"
        "road wavy from main { perturb with sine { amplitude: 0m..2m, wavelength: 40m } }\n"
        "expect of_network: confidence(lane) > 0.5\n"
        "expect of_road: confidence(main) > 0.5\n"
        "expect of_perturbed: confidence(wavy) > 0.5\n"
    )
    (scene,) = sample(text, kinds=(Unsure,)).scenes
    for verdict in scene.expectations:
        assert verdict.robustness == pytest.approx(0.1)


def test_a_road_that_runs_against_an_edge_is_displaced_to_the_side_of_the_edge(
    sample: Sample,
) -> None:
    text = (
        'image plan from """\n####################\n""" { scale: 10m/px }\n'
        "network lane from plan\n"
        "network wavy from lane { perturb with bump { at: 60m, length: 60m, height: 3m } }\n"
        "road there from wavy { select: route((5m, 5m), (195m, 5m)) }\n"
        "road back from wavy { select: route((195m, 5m), (5m, 5m)) }\n"
    )
    roads = {road.name: road for road in sample(text).scenes[0].roads}
    edge, there, back = roads["wavy/1"], roads["there"], roads["back"]
    assert max(abs(y - 5.0) for y in edge.y) > 2.5
    for road in (there, back):
        lateral = np.interp(road.x, *sorted_by_first(edge.x, edge.y))
        assert np.abs(lateral - road.y).max() < 0.02


def sorted_by_first(
    x: tuple[float, ...], y: tuple[float, ...]
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    order = np.argsort(x)
    return tuple(np.array(x)[order]), tuple(np.array(y)[order])


def test_things_of_one_kind_are_numbered_from_zero(sample: Sample) -> None:
    (scene,) = sample(TOWN.replace("....T", "T...T").replace("...#...B.", "...#..TB.")).scenes
    names = sorted(thing.name for thing in scene.objects)
    assert names == ["town/building[0]", "town/tree[0]", "town/tree[1]", "town/tree[2]"]
    assert {thing.group for thing in scene.objects} == {"town/building", "town/tree"}


def test_things_of_a_picture_are_as_large_as_they_are_drawn_with_defaults_for_the_rest(
    sample: Sample,
) -> None:
    (scene,) = sample(TOWN).scenes
    options = {thing.kind: dict(thing.options) for thing in scene.objects}
    assert options == {
        "tree": {"length": 12.0, "width": 12.0, "height": 8.0, "color": "#2e7d32"},
        "building": {"length": 12.0, "width": 12.0, "height": 7.0, "color": "#b71c1c"},
    }
    sizes = [(thing.length, thing.width, thing.height) for thing in scene.objects]
    assert sorted(sizes) == [(12.0, 12.0, 7.0), (12.0, 12.0, 8.0)]
    (painted,) = sample(TOWN.replace('"B": building', '"B": crosswalk')).scenes
    assert [thing.height for thing in painted.standing if thing.kind == "crosswalk"] == [0.0]


def test_any_road_of_the_network_may_be_drawn(sample: Sample) -> None:
    text = TOWN + "road street from town { select: any }\n"
    scenes = sample(text, 60).scenes
    edges = {road.name for road in scenes[0].roads if road.network == "town"}
    streets = [next(r for r in scene.roads if r.name == "street") for scene in scenes]
    assert len({(street.x, street.y) for street in streets}) == len(edges) == 4
