"""Turns back into the road that one comes from."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from benchmarks.junctions.checks import check_junction, effective_sections
from roadlang.geometry import RoadNetwork
from roadlang.geometry.junctions.plan import PlanOptions, plan_junctions
from roadlang.geometry.networks.junction_model import Connection, Junction
from tests.geometry.junctions.crossings_of_roads import only, plan_of, sections_of, star

WITH = PlanOptions(u_turns=True)


def u_turns(junction: Junction) -> list[Connection]:
    return [one for one in junction.connections if one.turn == "u"]


@pytest.mark.parametrize(
    ("degrees", "lanes"), [((0, 90, 180, 270), 2), ((0, 90, 180), 4), ((10, 130, 250), 2)]
)
def test_every_road_has_one_that_can_be_driven_and_stays_in_the_junction(
    degrees: tuple[float, ...], lanes: int
) -> None:
    network = star(*degrees, width=3.5 * lanes)
    plan = plan_of(network, lanes, options=WITH)
    found = u_turns(only(plan))
    assert {one.source.edge for one in found} == {edge.id for edge in network.edges}
    assert all(one.source.edge == one.target.edge for one in found)
    assert all((one.source.lane, one.target.lane) == (1, -1) for one in found)
    assert max(one.curvature for one in found) <= 0.25 + 1e-9
    turned = [sum(length * bend for length, bend in one.pieces) for one in found]
    assert turned == pytest.approx([math.pi] * len(found))
    sections = effective_sections(plan, sections_of(network, lanes))
    assert check_junction(only(plan), plan, network, sections).faults == {}


def test_the_other_turns_stay_as_they_are_and_keep_their_ids() -> None:
    network = star(0, 90, 180, 270)
    without, with_them = only(plan_of(network)), only(plan_of(network, options=WITH))
    assert with_them.connections[:12] == without.connections
    assert len(with_them.connections) == 16
    lost = shapely.Polygon(without.area).difference(shapely.Polygon(with_them.area))
    assert lost.area < 0.02


def test_who_turns_around_yields_to_oncoming_traffic() -> None:
    junction = only(plan_of(star(0, 90, 180, 270), options=WITH))
    (around,) = (one for one in u_turns(junction) if one.source.edge == 1)
    oncoming = next(
        one for one in junction.connections if one.source.edge == 3 and one.turn == "straight"
    )
    assert (around.id, oncoming.id) in junction.yields


def test_one_way_roads_and_joints_have_none() -> None:
    assert {one.source.edge for one in u_turns(
        only(plan_of(star(0, 90, 180), one_way=[3], options=WITH))
    )} == {1, 2}  # fmt: skip
    assert not u_turns(only(plan_of(star(0, 170), options=WITH)))


def test_left_hand_traffic_turns_the_other_way() -> None:
    network = star(0, 90, 180, 270)
    sections = {id: section.mirrored() for id, section in sections_of(network).items()}
    flipped: RoadNetwork = network.transformed(np.diag([1.0, -1.0]))
    plan = plan_junctions(flipped, sections, PlanOptions(left_hand=True, u_turns=True))
    turned = [sum(length * bend for length, bend in one.pieces) for one in u_turns(only(plan))]
    assert turned == pytest.approx([-math.pi] * 4)
