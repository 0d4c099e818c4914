"""Networks are cut where they leave a region: what is left lies where it was."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roadlang.geometry import (
    Booleans,
    CrossSection,
    Curve,
    Edge,
    Floats,
    Lane,
    MapControl,
    MapJunction,
    MapTurn,
    Node,
    RoadNetwork,
    WidthProfile,
)
from roadlang.geometry.networks.clipping import clipped
from roadlang.geometry.networks.junction_model import LaneEnd
from tests.geometry.geometry_shapes import circle


def west_of(x: float) -> Any:
    def contains(points: Floats) -> Booleans:
        return np.asarray(points[:, 0] <= x)

    return contains


def within(west: float, east: float) -> Any:
    return lambda points: (points[:, 0] >= west) & (points[:, 0] <= east)


def taper() -> CrossSection:
    """A lane 3.5 m wide, and one that begins at 100 m and is 3 m wide at 160 m."""
    second = WidthProfile(np.array([0.0, 100.0, 160.0]), np.array([0.0, 0.0, 3.0]))
    return CrossSection(
        (Lane(1, "drive", WidthProfile.constant(3.5), "backward"), Lane(-1, "bus", second),
         Lane(-2, "drive", WidthProfile.constant(3.5))), "broken",
    )  # fmt: skip


def street() -> RoadNetwork:
    """200 m to the east, rising 1 m in 10 m, and 100 m to the north from its end."""
    nodes = tuple(Node(id, at) for id, at in ((1, (0.0, 0.0)), (2, (200.0, 0.0)), (3, (200, 100))))
    east = Edge.of(7, 1, 2, Curve.through([(0, 0), (200, 0)]), taper())
    east = replace(east, elevations=np.linspace(0.0, 20.0, 9), no_turns=(("end", 8, "start"),))
    north = Edge(8, 2, 3, Curve.through([(200, 0), (200, 100)]), np.array([7.0]))
    turn = MapTurn(LaneEnd(7, "end", -2), LaneEnd(8, "start", -1))
    junctions = (MapJunction(5, ((7, "end"), (8, "start")), (turn,)),)
    controls = (MapControl("stop", ((7, "end"),)), MapControl("yield", ((7, "start"),)))
    return RoadNetwork(nodes, (east, north), (48.0, 11.0), junctions, controls)


def test_what_lies_inside_altogether_stays_the_same_network() -> None:
    network = street()
    assert clipped(network, west_of(1000.0)) is network
    assert clipped(network, west_of(-1.0)).edges == ()


def test_a_road_keeps_its_lanes_and_heights_where_it_is_cut() -> None:
    found = clipped(street(), within(50.0, 130.0))
    (edge,) = found.edges
    assert (edge.id, edge.no_turns, found.junctions, found.controls) == (7, (), (), ())
    assert found.origin == (48.0, 11.0)
    np.testing.assert_allclose(edge.curve.at([0.0, edge.length]), [[50, 0], [130, 0]], atol=1e-3)
    assert edge.cross_section is not None
    for at in (0.0, 40.0, 65.0, 80.0):
        expected = taper().border_offsets(at + 50.0)
        np.testing.assert_allclose(edge.cross_section.border_offsets(at), expected, atol=1e-3)
    assert edge.elevations is not None
    np.testing.assert_allclose(edge.elevations[[0, -1]], [5.0, 13.0], atol=1e-3)


def test_lanes_without_width_are_left_out_and_turns_name_the_others() -> None:
    """West of 90 m there is no second lane, but the turn of the third is at the other end."""
    (edge,) = clipped(street(), west_of(90.0)).edges
    assert edge.cross_section is not None
    assert [(lane.id, lane.kind) for lane in edge.cross_section.lanes] == [
        (1, "drive"), (-1, "drive")]  # fmt: skip
    backward = street()
    edge = backward.edges[0]
    assert edge.cross_section is not None
    turned = replace(edge, curve=edge.curve.reversed(), start=2, end=1, no_turns=())
    turn = MapTurn(LaneEnd(7, "start", -2), LaneEnd(8, "start", -1))
    junction = MapJunction(5, ((7, "start"), (8, "start")), (turn,))
    network = replace(backward, edges=(turned, backward.edges[1]), junctions=(junction,))
    found = clipped(replace(network, controls=()), lambda points: points[:, 0] > 110.0)
    assert found.junctions is not None
    assert found.junctions[0].turns[0].source == LaneEnd(7, "start", -1)


def test_junctions_and_signs_keep_the_ends_that_are_left() -> None:
    found = clipped(street(), lambda points: (points[:, 0] > 20.0) & (points[:, 1] < 60.0))
    assert [edge.id for edge in found.edges] == [7, 8]
    assert found.edges[0].no_turns == (("end", 8, "start"),)
    assert found.junctions is not None
    assert found.junctions[0].arms == ((7, "end"), (8, "start"))
    assert [control.rule for control in found.controls] == ["stop"]
    assert found.degree(2) == 2


def test_parts_of_a_road_have_ids_of_their_own_and_stubs_go() -> None:
    def contains(points: Floats) -> Booleans:
        x, y = points.T
        return np.asarray((y == 0) & ((x < 40) | ((x > 60) & (x < 150)) | (x > 195)))

    found = clipped(street(), contains)
    lengths = {edge.id: edge.length for edge in found.edges}
    assert lengths == pytest.approx({7: 90.0, 9: 40.0}, abs=1e-3)
    assert len(found.nodes) == 4


@pytest.mark.parametrize(("west", "east"), [(-100.0, 20.0), (-20.0, 100.0)])
def test_a_ring_is_cut_round_its_seam(west: float, east: float) -> None:
    """The seam of the circle is in the east."""
    node = Node(1, (50.0, 0.0))
    ring = Edge(1, 1, 1, circle(50.0), np.array([6.0, 8.0]))
    (edge,) = clipped(RoadNetwork((node,), (ring,)), within(west, east)).edges
    assert not edge.curve.closed
    assert edge.length == pytest.approx(100.0 * (np.pi - np.arccos(0.4)), rel=1e-4)
    ends = edge.curve.at([0.0, edge.length])
    np.testing.assert_allclose(ends[:, 0], 20.0 if west < -50 else -20.0, atol=1e-3)


def test_turns_that_are_forbidden_are_forgotten_with_one_of_their_ends() -> None:
    """From the end of 7 to the start of 8, both at 200 m: what is cut elsewhere does not matter."""
    for region, left in (
        (west_of(190.0), ()),
        (lambda points: (points[:, 0] < 150.0) | (points[:, 1] > 20.0), ()),
        (lambda points: (points[:, 0] > 150.0) & (points[:, 1] < 20.0), (("end", 8, "start"),)),
    ):
        found = {edge.id: edge for edge in clipped(street(), region).edges}
        assert found[7].no_turns == left
