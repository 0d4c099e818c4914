"""What one drives through a node of netconvert counts for the road on whose side it lies."""

from __future__ import annotations

from xml.etree.ElementTree import fromstring

import pytest

from benchmarks.formats.judges import Line, part_inside
from tests.formats.small_maps import straight

ROAD = fromstring(straight(1, 10.0, 0.0))


@pytest.mark.parametrize(
    ("end", "lane", "meters"),
    [
        ("successor", [(69.0, -2.0), (70.0, -2.0)], 1.0),  # all of the node is cut off this road
        ("successor", [(70.0, -2.0), (71.0, -2.0)], 0.0),  # or off the next one
        ("successor", [(69.5, -2.0), (70.5, -2.0)], 0.5),
        ("predecessor", [(9.0, 2.0), (10.4, 2.0)], 0.4),
        ("predecessor", [(10.0, 2.0), (10.0, 2.0)], 0.0),  # netconvert calls it 0.1 m long
    ],
)
def test_a_road_has_the_part_of_a_node_before_its_end(end: str, lane: Line, meters: float) -> None:
    assert part_inside(ROAD, end, [lane]) == pytest.approx(meters)
    assert part_inside(ROAD, end, [lane, lane[::-1]]) == pytest.approx(meters)
