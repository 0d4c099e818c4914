"""What a scene file need not say, and what that means: readers of older files depend on it."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from roadlang.api import Scene
from roadlang.drive.standing import with_objects, without_objects
from roadlang.ir.encoding import scene_from_json
from roadlang.ir.scene import SceneActor
from roadlang.ir.scene_junctions import SceneControl, SignalPhase
from roadlang.ir.scene_road import SpeedZone
from roadlang.ir.trace import AgentTrace, Trace

ROAD = {
    "name": "main", "stations": [0, 10], "reference_stations": [0, 10], "x": [0, 10], "y": [0, 0],
    "heading": [0, 0], "curvature": [0, 0], "width": [6, 6], "lanes": 2, "closed": False,
    "length": 10, "root": "main",
}  # fmt: skip
CAR = {
    "name": "ego", "group": "ego", "kind": "car", "x": 1, "y": 2, "heading": 0.5, "length": 4,
    "width": 2, "height": 1.5,
}  # fmt: skip
LEAST = {
    "schema": "roadlang.scene/2", "name": "least", "title": "", "index": 0,
    "provenance": {"roadlang": "0.1.0", "seed": 0, "scene": 0, "attempt": 0},
    "networks": [{"name": "town", "nodes": [], "roads": ["main"]}],
    "roads": [ROAD],
    "agents": [CAR],
    "requirements": [{"name": "r", "text": "", "domain": "road", "robustness": 1.0,
                      "satisfied": True}],
}  # fmt: skip


def least() -> Scene:
    return scene_from_json(json.dumps(LEAST))


def test_a_network_is_certain_has_no_mask_and_lies_at_the_origin() -> None:
    (town,) = least().networks
    assert (town.confidence, town.mask, town.mask_scale) == (1, None, None)
    assert (town.mask_origin, town.junctions, town.origin) == ((0, 0), (), None)


def test_a_road_is_its_own_reaches_to_its_ends_and_has_a_broken_middle_line() -> None:
    (road,) = least().roads
    assert (road.network, road.edge, road.derived, road.trim) == (None, None, False, (0, 0))
    assert (road.lane_list, road.center_marking, road.center_offset) == ((), "broken", ())
    assert (road.speed_limit, road.street, road.elevation) == (None, "", ())


def test_an_agent_stands_free_looks_forward_and_waits() -> None:
    (car,) = least().agents
    assert (car.road, car.start, car.offset, car.lane, car.facing) == (None,) * 4 + ("forward",)
    assert (dict(car.options), car.drive, car.start_speed, car.route) == ({}, (), None, None)


def test_a_route_ends_and_its_steps_lead_into_each_other() -> None:
    steps = [{"road": "main", "lane": -1, "start": 0, "stop": 10}]
    agents = [{**CAR, "route": {"steps": steps}}]
    (car,) = scene_from_json(json.dumps({**LEAST, "agents": agents})).agents
    assert car.route is not None
    assert not car.route.closed
    (step,) = car.route.steps
    assert (step.lane, step.start, step.stop, step.turn) == (-1, 0, 10, None)


def test_a_verdict_has_no_places() -> None:
    (verdict,) = least().requirements
    assert (verdict.violated, verdict.formula, verdict.profiles, verdict.tightest) == (
        (), None, (), None
    )  # fmt: skip


def test_a_scene_draws_nothing_and_is_driven_nowhere() -> None:
    scene = least()
    assert (dict(scene.values), dict(scene.draws), dict(scene.units), dict(scene.world)) == (
        {}, {}, {}, {}
    )  # fmt: skip
    assert (scene.objects, scene.signals, scene.expectations, scene.simulate) == ((), (), (), None)
    assert (dict(scene.provenance.inputs), scene.provenance.source) == ({}, "")
    assert (dict(scene.provenance.plugins), dict(scene.provenance.overrides)) == ({}, {})


def test_a_cycle_of_signals_is_all_of_its_phases() -> None:
    """10 + 3 + 2 s and 5 + 3 + 2 s."""
    phases = (SignalPhase((1,), 10.0, 3.0, 2.0), SignalPhase((2,), 5.0, 3.0, 2.0))
    assert SceneControl("signals", phases=phases).cycle == 25.0
    assert SceneControl().cycle == 0.0


def test_what_stands_still_is_where_the_scene_has_it_at_all_times() -> None:
    """A thing beside all roads has no station: 0, as has its distance from a center line."""
    time = np.array([0.0, 0.5, 1.0])
    free = SceneActor("ego", "ego", "car", 1.0, 2.0, 0.5, 4.0, 2.0, 1.5)
    placed = SceneActor("ego", "ego", "car", 1.0, 2.0, 0.5, 4.0, 2.0, 1.5, "main", 7.0, -1.5)
    for actor, station, offset in ((free, 0.0, 0.0), (placed, 7.0, -1.5)):
        trace = AgentTrace.standing(actor, time)
        for column, value in (
            (trace.x, 1.0), (trace.y, 2.0), (trace.heading, 0.5), (trace.station, station),
            (trace.cross_track_error, offset), (trace.speed, 0.0), (trace.acceleration, 0.0),
            (trace.steering, 0.0), (trace.progress, 0.0), (trace.contacts, 0.0),
        ):  # fmt: skip
            assert column.tolist() == [value] * 3
        assert (trace.length, trace.width) == (4.0, 2.0)
        assert math.isclose(trace.time[-1], 1.0)


@pytest.mark.parametrize(
    ("kind", "sizes", "category"),
    [
        ("car", (4.0, 2.0, 1.5), "car"),
        ("acme.coach", (12.0, 2.5, 3.2), "bus"),
        ("acme.lorry", (8.0, 2.5, 3.2), "truck"),
        ("acme.scooter", (1.9, 0.7, 1.3), "bicycle"),
        ("acme.chopper", (2.4, 0.9, 1.3), "motorcycle"),
        ("acme.box", (5.0, 2.0, 2.2), "van"),
    ],
)
def test_agents_of_the_first_format_are_what_their_sizes_say(
    kind: str, sizes: tuple[float, float, float], category: str
) -> None:
    length, width, height = sizes
    agent = {**CAR, "kind": kind, "length": length, "width": width, "height": height}
    document = {**LEAST, "schema": "roadlang.scene/1", "agents": [agent]}
    (found,) = scene_from_json(json.dumps(document)).agents
    assert found.category == category


def test_what_turns_or_moves_is_no_object_that_stands() -> None:
    """A door that turns on the spot is in the trace of a drive; a hut is in the scene alone."""
    time = np.array([0.0, 0.5, 1.0])
    hut, door, gate = (SceneActor(n, n, "box", 1.0, 2.0, 0.5, 4.0, 2.0, 1.5) for n in "hdg")
    scene = replace(least(), agents=(), objects=(hut, door, gate))
    still = {one.name: AgentTrace.standing(one, time) for one in (hut, door, gate)}
    agents = {**still, "d": replace(still["d"], heading=time), "g": replace(still["g"], y=time)}
    kept = without_objects(Trace(time, agents), scene)
    assert set(kept.agents) == {"d", "g"}
    again = with_objects(kept, scene)
    assert set(again.agents) == {"h", "d", "g"}
    assert again.agents["h"].x.tolist() == [1.0, 1.0, 1.0]
    assert again.agents["d"].heading.tolist() == time.tolist()


def test_the_limit_of_a_lane_counts_before_those_of_the_zones_of_its_road() -> None:
    road = replace(least().roads[0], speed_limit=9.0)
    assert [road.limit_at(station) for station in (-1.0, 0.0, 99.0)] == [9.0] * 3
    assert road.limit_at(0.0, 5.0) == 5.0
    zones = (SpeedZone(0.0, None), SpeedZone(20.0, 8.0), SpeedZone(50.0, None))
    zoned = replace(road, speed_limit=None, speed_zones=zones)
    found = [zoned.limit_at(station) for station in (-1.0, 0.0, 19.9, 20.0, 49.0, 50.0)]
    assert found == [None, None, None, 8.0, 8.0, None]
    assert zoned.limit_at(30.0, 5.0) == 5.0
