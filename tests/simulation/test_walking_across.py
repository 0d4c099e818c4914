"""`walk` along a route waits at junctions, `crossing` at the curb if it is told to."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.trace import Trace

TOWN = """
image plan from \"\"\"
...#.....
...#.....
#########
...#.....
...#.....
\"\"\" {{ scale: 20m/px, legend: {{ "#": road }} }}
network town from plan {{ lanes: 2, sidewalks: 2m, speed_limit: 50km/h, {control} }}
agent ped is pedestrian on town at (57m, 44m) {{
  lane: sidewalk, route: [(120m, 46m)]
  drive with walk {{ {wait} }}
}}
{more}
"""
CURB = 61.3
"""Meters east: where it waits before the road that runs north."""
GREEN = "control with signals { green: 10s, yellow: 0s, all_red: 0s, offset: "


@cache
def walked(control: str, wait: str = "", more: str = "") -> Trace:
    text = TOWN.format(control=control, wait=wait, more=more)
    ((one,)) = testing.sample(text, 1).run("builtin", duration=20.0, control_step=0.1)
    return one.trace


def crosses_at(trace: Trace) -> float:
    """Seconds until it has left the curb."""
    ped = trace.agents["ped"]
    return float(ped.time[np.argmax(ped.x > CURB + 0.2)])


def test_with_a_route_it_begins_on_the_sidewalk_and_keeps_to_its_side() -> None:
    ped = walked("control with yield").agents["ped"]
    assert ped.y == pytest.approx(np.full(len(ped.y), 45.5), abs=0.1)
    assert ped.x[-1] > 75.0


@pytest.mark.parametrize("offset", [4, 16])
def test_it_crosses_while_those_beside_it_have_green(offset: int) -> None:
    trace = walked(f"{GREEN}{offset}s }}", more="agent car is car on town at (20m, 46m) "
                   "{ route: [(150m, 46m)], drive with traffic }")  # fmt: skip
    begins = crosses_at(trace)
    car = trace.agents["car"]
    over = float(car.time[np.argmax(car.x > 62.0)])
    phase = [(time + offset) % 20.0 < 10.0 for time in (begins, over)]
    assert phase[0] == phase[1]


def test_whoever_does_not_wait_walks_on() -> None:
    freely = crosses_at(walked("control with yield"))
    for wait in ("wait_for: nothing", "wait_for: gap"):
        assert crosses_at(walked(f"{GREEN}4s }}", wait)) == pytest.approx(freely)
    assert crosses_at(walked(f"{GREEN}4s }}")) != pytest.approx(freely, abs=2.0) or (
        crosses_at(walked(f"{GREEN}14s }}")) > freely + 2.0
    )


def test_without_signals_it_waits_for_a_gap() -> None:
    crossing = "agent car is car on town at (68m, 90m) { route: [(68m, 10m)], "
    fast = crossing + "drive with lane_follow { speed: 5m/s } }"
    freely = crosses_at(walked("control with yield"))
    trace = walked("control with yield", more=fast)
    car = trace.agents["car"]
    assert car.y[np.searchsorted(car.time, crosses_at(trace))] < 62
    assert crosses_at(trace) > freely
    assert not trace.events


STREET = """
road street {{ draw with segments {{ pieces: [straight(200m)] }}, lanes: 2, width: 7m }}
agent car is car on street at 45m {{ drive with lane_follow {{ speed: 12m/s }} }}
agent ped is pedestrian on street at 80m {{
  side: right, offset: 0.5m, drive with crossing {{ {} }}
}}
"""


def test_crossing_waits_for_a_gap_if_it_is_told_to() -> None:
    for wait, later in (("", False), ("wait_for: gap", True)):
        ((one,)) = testing.sample(STREET.format(wait), 1).run(
            "builtin", duration=20.0, control_step=0.1
        )
        ped, car = one.trace.agents["ped"], one.trace.agents["car"]
        starts = float(ped.time[np.argmax(ped.y > ped.y[0] + 0.5)])
        passes = float(car.time[np.argmax(car.x > 80.0)])
        assert (starts > passes) == later
        assert later or starts < 1.0
        assert ped.y[-1] > 3.5 or not later


COW = """
road street {{ draw with segments {{ pieces: [straight(200m)] }}, lanes: 2, width: 7m }}
agent ped is pedestrian on street at 80m {{
  side: right, offset: 0.5m, drive with crossing {{ {} }}
}}
agent other is {}
"""


@pytest.mark.parametrize(
    ("wait", "other", "waits"),
    [
        ("", "animal at (80m, 0m) { length: 2.4m }", False),
        (
            "wait_for: gap",
            "animal on street at 76m { length: 2.4m, lane: -1, drive with walk { speed: 2m/s } }",
            False,
        ),
        (
            "wait_for: gap",
            "scooter on street at 70m { drive with lane_follow { speed: 5m/s } }",
            True,
        ),
    ],
    ids=["a cow that stands", "a cow that walks", "a scooter"],
)
def test_crossing_waits_for_vehicles_however_short_and_for_nobody_on_foot(
    wait: str, other: str, waits: bool
) -> None:
    ((one,)) = testing.sample(COW.format(wait, other), 1).run(
        "builtin", duration=12.0, control_step=0.1
    )
    ped = one.trace.agents["ped"]
    starts = float(ped.time[np.argmax(ped.y > ped.y[0] + 0.5)])
    assert (starts > 1.0) == waits
    across = np.flatnonzero(ped.y > 3.5)
    assert len(across)
    if not waits:
        assert np.ptp(ped.x[: across[0]]) < 0.1
        assert ped.time[across[0]] < 7.0


def test_traffic_in_some_scenes_alone() -> None:
    text = TOWN.format(control="control with yield", wait="", more="")
    text += "param n = choice(0, 3)\nagent cars is car on town at random { count: n, drive with "
    driven = testing.sample(text + "traffic }", 6, seed=3).run("builtin", duration=2.0)
    counts = [len(one.trace.agents) - 1 for one in driven]
    assert {0, 3} == set(counts)
    assert counts[-1] == 3
