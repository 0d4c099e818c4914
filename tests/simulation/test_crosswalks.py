"""`traffic` at crosswalks between junctions: it yields to who waits there, in every lane."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from roadlang import testing
from roadlang.simulation.traffic.crosswalks import Crosswalks

from .crossing_traffic import contacts
from .driven_roads import drive_together
from .test_pedestrians import least_speed

STREET = """
road street {{
  draw with segments {{ pieces: [straight(220m)] }}, lanes: {lanes}, sidewalks: 2m
  speed_limit: 50km/h
}}
{zebra}
agent walker is pedestrian on street at 120m {{ side: {side}, offset: -1m, {wants} }}
agent ego is car on street at {start} {{ facing: {facing}, lane: {lane}, drive with traffic }}
"""
ZEBRA = "object zebra is crosswalk on street at {at}"


def street(
    zebra: str = "120m", side: str = "right", lane: int = -1, wants: str = "", lanes: int = 2
) -> str:
    facing, start = ("forward", "20m") if lane < 0 else ("back", "210m")
    toward = "90deg" if side == "right" else "-90deg"
    return STREET.format(
        zebra=ZEBRA.format(at=zebra) if zebra else "",
        wants=wants or f"heading: {toward}, drive with stop_at",
        side=side, lane=lane, lanes=lanes, facing=facing, start=start,
    )  # fmt: skip


def test_it_yields_to_who_waits_on_either_side_in_every_lane() -> None:
    lanes = ((2, -1), (2, 1), (4, -2), (4, -1), (4, 1), (4, 2))
    cases = list(product(("right", "left"), lanes))
    texts = [street(side=side, lane=lane, lanes=lanes) for side, (lanes, lane) in cases]
    for case, trace in zip(cases, drive_together(texts, duration=40.0), strict=True):
        assert least_speed(trace) < 0.5, case
        assert trace.agents["ego"].progress[-1] == 1.0, case  # its patience ends


def test_it_does_not_wait_for_others() -> None:
    others = {
        "no crosswalk": street(zebra=""),
        "beside it": street(zebra="110m"),
        "along the road": street(wants="drive with stop_at"),
        "away from it": street(wants="heading: -90deg, drive with stop_at"),
    }
    for who, trace in zip(others, drive_together(others.values(), duration=30.0), strict=True):
        assert least_speed(trace) > 12.0, who


def test_nobody_who_crosses_is_hit_and_all_get_across() -> None:
    crosses = "drive with crossing {{ speed: {}m/s, wait_for: gap, when: ego.station > {}m }}"
    cases = list(product(("right", "left"), (0.8, 2.5), (25, 60, 80)))
    texts = [street(side=side, wants=crosses.format(v, at)) for side, v, at in cases]
    for case, trace in zip(cases, drive_together(texts, duration=40.0), strict=True):
        walker = trace.agents["walker"]
        assert contacts(trace) == [], case
        assert walker.y[0] * walker.y[-1] < 0.0, case
        assert trace.agents["ego"].progress[-1] == 1.0, case


def test_a_car_stops_for_people_and_not_for_the_paint() -> None:
    text = street().replace("agent walker", "agent other").replace("at 120m {", "at 5m {")
    (trace,) = drive_together([text], duration=30.0)
    assert least_speed(trace) > 12.0
    assert trace.agents["zebra"].x.tolist() == [120.0] * len(trace.time)


def test_formulas_of_drives_measure_crosswalks() -> None:
    braking = "drive with brake { when: distance(ego, zebra) < 30m }"
    text = street().replace("drive with traffic", f"drive with lane_follow, {braking}")
    (trace,) = drive_together([text], duration=30.0)
    ego = trace.agents["ego"]
    began = int(np.flatnonzero(ego.acceleration < -5.0)[0])
    assert ego.x[began] == pytest.approx(90.0, abs=2.0)


def test_who_is_at_a_crosswalk() -> None:
    """Against plain arithmetic."""
    scene = testing.sample(street())[0].record
    crosswalks = Crosswalks.of([scene, scene])
    half = scene.markings[0].width / 2
    rng = np.random.default_rng(5)
    x, y = 120 + rng.uniform(-6, 6, 500), rng.uniform(-9, 9, 500)
    at = crosswalks.at(np.ones(500, np.int64), x, y)
    near = (abs(x - 120) < 2.5) & (abs(y) < half + 3.0)
    assert at.tolist() == np.where(near, 1, -1).tolist()
    on = crosswalks.covers(at, x, y)
    assert on.tolist() == (near & (abs(y) < half)).tolist()
