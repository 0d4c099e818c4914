"""Networks from maps: the lanes, names, heights and place on Earth that they bring."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest

from roadlang.api import Reader
from roadlang.geometry import CrossSection, Curve, Edge, Lane, Node, RoadNetwork, WidthProfile
from roadlang.geometry.networks.path_sections import section_of_path
from roadlang.ir.encoding import scene_from_json, to_json
from roadlang.scenes.sampling import SamplingResult

Sample = Callable[..., SamplingResult]


def lane(id: int, widths: list[float], kind: str = "drive") -> Lane:
    profile = WidthProfile(np.linspace(0.0, 100.0, len(widths)), np.array(widths))
    drivable = kind == "drive"
    direction = "none" if not drivable else "backward" if id > 0 else "forward"
    return Lane(id, kind, profile, direction, drivable, 10.0 if drivable else None)  # type: ignore[arg-type]


WIDENING = CrossSection((lane(1, [3.0]), lane(-1, [3.0, 4.0]), lane(-2, [2.0], "parking")))
TURNED = CrossSection((lane(2, [2.0], "parking"), lane(1, [4.0]), lane(-1, [3.0])))
NARROW = CrossSection((lane(-1, [3.5]),))


def street(second: CrossSection, *, backward: bool = False) -> RoadNetwork:
    """Two roads of 100 m in line; the second may be stored from its far end."""
    nodes = (Node(1, (0.0, 0.0)), Node(2, (100.0, 0.0)), Node(3, (200.0, 0.0)))
    ends = [(100.0, 0.0), (200.0, 0.0)]
    far = Curve.through(ends[::-1] if backward else ends)
    first = Edge.of(1, 1, 2, Curve.through([(0.0, 0.0), (100.0, 0.0)]), WIDENING)
    start, end = (3, 2) if backward else (2, 3)
    return RoadNetwork(nodes, (first, Edge.of(2, start, end, far, second)), (52.5, 13.4))


@dataclass(frozen=True)
class MapReader(Reader):
    """A map of a street."""

    name: ClassVar[str] = "street_map"
    reads: ClassVar[tuple[str, ...]] = ("network",)
    suffixes: ClassVar[tuple[str, ...]] = (".street",)

    def read(self, path: Path) -> RoadNetwork:
        nodes = (Node(1, (0.0, 0.0)), Node(2, (100.0, 0.0)))
        curve = Curve.through([(0.0, 0.0), (100.0, 0.0)])
        widths = np.array([7.0])
        heights = np.array([30.0, 40.0])
        edge = Edge(1, 1, 2, curve, widths, 1.0, WIDENING, "Main Street", heights)
        return RoadNetwork(nodes, (edge,), (52.5, 13.4))


def test_a_scene_has_what_the_map_says(sample: Sample, tmp_path: Path) -> None:
    (tmp_path / "a.street").write_text("a map")
    text = 'network town from "a.street" { read with acme.street_map }\nroad main from town'
    (scene,) = sample(text, kinds=[MapReader]).scenes
    (network,) = scene.networks
    assert network.origin == (52.5, 13.4)
    main, edge = scene.roads
    assert edge.street == "Main Street"
    assert edge.elevation[0] == 30.0
    assert edge.elevation[-1] == 40.0
    for road in (main, edge):
        assert [one.kind for one in road.lane_list] == ["drive", "drive", "parking"]
        assert road.lane_list[1].width[0] == pytest.approx(3.0)
        assert road.lane_list[1].width[-1] == pytest.approx(4.0)
        assert road.lane_list[1].speed_limit == 10.0
        assert road.lane_list[2].width == (2.0,)
        assert road.width[-1] == pytest.approx(7.0)
    assert scene_from_json(to_json(scene)) == scene


def test_lanes_that_are_written_replace_those_of_the_map(sample: Sample, tmp_path: Path) -> None:
    (tmp_path / "a.street").write_text("a map")
    text = 'network town from "a.street" { read with acme.street_map, lanes: 1 }'
    (scene,) = sample(text, kinds=[MapReader]).scenes
    (edge,) = scene.roads
    assert [one.kind for one in edge.lane_list] == ["drive"]
    assert edge.width[-1] == pytest.approx(7.0)


@pytest.mark.parametrize("backward", [False, True])
def test_a_path_has_the_lanes_of_its_roads(backward: bool) -> None:
    network = street(TURNED if backward else WIDENING, backward=backward)
    path = network.route((0.0, 0.0), (200.0, 0.0))
    section = section_of_path(path)
    assert section is not None
    assert section.ids == (1, -1, -2)
    if backward:
        # The far road widens seen from its own start, at the far end.
        np.testing.assert_allclose(section.lane_width(-1, [50.0, 150.0]), [3.5, 4.0], atol=0.01)
    else:
        np.testing.assert_allclose(section.lane_width(-1, [50.0, 150.0]), [3.5, 3.5], atol=0.01)


def test_a_path_through_other_lanes_has_those_of_its_longest_part() -> None:
    path = street(NARROW).route((0.0, 0.0), (160.0, 0.0))
    section = section_of_path(path)
    assert section is not None
    assert section.ids == (1, -1, -2)
    np.testing.assert_allclose(section.drivable_width(140.0), 3.5, atol=0.01)
    np.testing.assert_allclose(section.lane_width(-2, 140.0), 2.0)


def test_the_origin_is_lost_where_it_moves() -> None:
    network = street(WIDENING)
    assert network.scaled(2.0).origin == (52.5, 13.4)
    assert network.transformed(np.eye(2), (1.0, 0.0)).origin is None
