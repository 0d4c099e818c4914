"""`traffic` and people on foot: it stops for who steps toward its lane, and at zebra crossings."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest

from roadlang import testing
from roadlang.ir.scene import Scene

from .crossing_traffic import before_junction, contacts, entries
from .driven_roads import drive_together
from .routed_scenes import CROSSING, call, car, drive_scenes, network_scene, route

STREET = """
road street {{
  draw with segments {{ pieces: [straight(200m)] }}
  lanes: 2, sidewalks: 2m, width: 7m, speed_limit: 50km/h
}}
agent ego is car on street at 20m {{ drive with traffic }}
agent child is pedestrian on street at 110m {{ side: {side}, offset: {offset}, {drives} }}
"""


def street(drives: str, side: str = "right", offset: str = "1m") -> str:
    return STREET.format(side=side, offset=offset, drives=drives)


def driven(drives: str, side: str = "right", offset: str = "1m", **options: Any) -> Any:
    (trace,) = drive_together([street(drives, side, offset)], duration=30.0, **options)
    return trace


def least_speed(trace: Any) -> float:
    """m/s, of the car until it leaves."""
    ego = trace.agents["ego"]
    return float(ego.speed[ego.present > 0.0].min())


def test_it_stops_for_a_child_who_steps_out() -> None:
    cases = list(product(("right", "left"), (1.0, 1.5, 2.5), (22, 45)))
    drives = "drive with crossing {{ speed: {}m/s, when: distance(ego, child) < {}m }}"
    texts = (street(drives.format(speed, distance), side) for side, speed, distance in cases)
    for case, trace in zip(cases, drive_together(texts, duration=30.0), strict=True):
        assert contacts(trace) == [], case
        assert trace.agents["ego"].progress[-1] == 1.0, case


def test_it_does_not_slow_down_for_who_stays_out_of_its_way() -> None:
    cases = {
        "along the road": "drive with walk",
        "behind the car": "drive with crossing { speed: 1m/s, when: ego.x > child.x + 5m }",
        "too late": "drive with crossing { speed: 1.5m/s, when: distance(ego, child) < 7m }",
    }
    texts = (street(drives, offset="2.5m") for drives in cases.values())
    traces = drive_together(texts, duration=30.0, control_step=0.04)
    for case, trace in zip(cases, traces, strict=True):
        assert contacts(trace) == [], case
        assert least_speed(trace) > 12.0, case


def test_it_goes_on_before_who_is_still_far_from_its_lane() -> None:
    trace = driven("drive with crossing { speed: 1m/s, when: distance(ego, child) < 60m }", "left")
    assert contacts(trace) == []
    assert least_speed(trace) > 4.0


def at_the_zebra(rule: str, turned: float, aside: float = 0.0) -> Scene:
    """A car before a crossing and somebody who stands beside its lane at the stop line."""
    options = f"lanes: 2, speed_limit: 50km/h, sidewalks: 2m\n{rule}"
    scene = network_scene(CROSSING, options)
    road, lane = entries(scene)[0]
    path = route(scene, road, lane, before_junction(scene, road, lane, 60.0), ["straight"])
    ego = car(scene, "ego", path, drive=call("traffic"), speed=8.0)
    ahead, right = 62.0, 3.2 + aside
    cosine, sine = np.cos(ego.heading), np.sin(ego.heading)
    child = replace(
        ego, name="child", group="child", kind="pedestrian", length=0.5, width=0.5, drive=(),
        x=ego.x + ahead * cosine + right * sine, y=ego.y + ahead * sine - right * cosine,
        heading=ego.heading + turned, road=None, start=None, lane=None, route=None,
        start_speed=0.0, options={},
    )  # fmt: skip
    return replace(scene, agents=(ego, child))


def slowest(scene: Scene) -> tuple[float, float]:
    """Speed of the car, m/s, and for how many seconds it stands."""
    (trace,) = drive_scenes([scene], duration=30.0)
    ego = trace.agents["ego"]
    there = (ego.present > 0.0) & (ego.time > 1.0)
    assert contacts(trace) == []
    assert ego.progress[-1] == 1.0
    return float(ego.speed[there].min()), 0.1 * float((ego.speed[there] < 0.3).sum())


def test_it_waits_a_while_for_who_stands_at_a_zebra_crossing() -> None:
    speed, stood = slowest(at_the_zebra("", np.pi / 2))
    assert speed < 0.1
    assert 3.0 < stood < 8.0


@pytest.mark.parametrize(
    ("turned", "aside"), [(0.0, 0.0), (-np.pi / 2, 0.0), (np.pi / 2, 4.0)],
    ids=["along the road", "turned away", "far from the lane"],
)  # fmt: skip
def test_it_does_not_wait_for_who_does_not_want_to_cross(turned: float, aside: float) -> None:
    assert slowest(at_the_zebra("", turned, aside))[0] > 4.0


def test_at_signals_those_on_foot_wait() -> None:
    green = "control with signals { green: 40s }"
    scenes = [at_the_zebra(green, turned) for turned in (np.pi / 2, 0.0)]
    wants, passes = drive_scenes(scenes, duration=10.0)
    assert (wants.agents["ego"].speed == passes.agents["ego"].speed).all()


def test_who_crosses_goes_round_a_parked_car() -> None:
    parked = "object parked is parked_car on street at 108m { lane: 1, offset: 1m }"
    text = STREET.format(
        side="right", offset="1m", facing="", drives="drive with crossing { speed: 1.4m/s }"
    )
    ((one,)) = testing.sample(text.replace("at 20m", "at 2m") + parked, 1).run(
        "builtin", duration=25.0
    )
    child = one.trace.agents["child"]
    assert child.y[-1] > 4.0
    assert one.trace.agents["ego"].progress[-1] > 0.9
    assert contacts(one.trace) == []


AT_A_SLANT = """
road street {
  draw with segments { pieces: [straight(100m)] }
  lanes: 2, width: 7m, speed_limit: 50km/h
}
param far = 6m..14m
param aside = 2m..4m
param turned = choice(20deg, 30deg, 45deg, 60deg)
agent ego is car on street at 20m { start_speed: 0m/s..6m/s, drive with traffic }
agent child is child at (24m + far, -1.75m + aside) {
  heading: 180deg + turned, drive with crossing { speed: 1m/s..2.5m/s }
}
"""


def test_it_does_not_drive_into_who_walks_toward_it_at_a_slant() -> None:
    for number, one in enumerate(testing.sample(AT_A_SLANT, 20).run("builtin", duration=8.0)):
        ego = one.trace.agents["ego"]
        for event in one.trace.events:
            before = ego.speed[ego.time < event["time"] - 0.1]
            assert before[-1] < 0.3, number
