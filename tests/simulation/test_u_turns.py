"""Vehicles that turn around on the road."""

from __future__ import annotations

import numpy as np

from .driven_roads import drive, drive_together

STREET = """
road street {{ draw with segments {{ pieces: [straight(200m)] }}, lanes: {lanes}, width: {width}m }}
agent ego is car on street at 100m {{
  lane: {lane}, drive with lane_follow {{ speed: 20km/h }}, drive with u_turn {{ {options} }}
}}
"""


def test_it_turns_in_as_many_moves_as_the_width_takes_and_goes_back_in_the_other_side() -> None:
    cases = [(2, 7, -1, 5), (2, 7, 1, 5), (4, 14, -2, 1), (2, 16, -1, 1)]
    texts = (
        STREET.format(lanes=lanes, width=width, lane=lane, options="when: time > 1s")
        for lanes, width, lane, _ in cases
    )
    for case, trace in zip(cases, drive_together(texts, duration=20.0), strict=True):
        _, _, lane, moves = case
        ego = trace.agents["ego"]
        backward = ego.speed < -0.1
        assert 1 + 2 * int((np.diff(backward.astype(int)) == 1).sum()) == moves, case
        assert ego.off_road.max() <= 0.0, case
        assert abs(abs(np.degrees(ego.heading[-1] - ego.heading[0])) - 180.0) < 2.0, case
        assert np.sign(ego.lane[-1]) == -np.sign(lane), case
        assert abs(ego.lane_offset[-1]) < 0.2, case
        assert (ego.station[-1] - 100.0) * np.sign(lane) > 10.0, case


def test_it_waits_for_a_gap_if_it_says_so() -> None:
    text = STREET.format(lanes=2, width=7, lane=-1, options="wait_for: gap")
    oncoming = """
    agent oncoming is car on street at 150m {
      facing: back, count: 2, spacing: 20m, drive with lane_follow { speed: 10m/s }
    }
    """
    (trace,) = drive(text + oncoming, duration=30.0)
    ego = trace.agents["ego"]
    turns = ego.time[np.abs(ego.heading) > 0.3][0]
    assert trace.agents["oncoming[1]"].station[np.searchsorted(ego.time, turns)] < 100.0
    assert trace.events == ()


def test_where_it_could_hardly_move_across_the_road_it_drives_on() -> None:
    text = STREET.format(lanes=2, width=7, lane=-1, options="when: time > 1s")
    (trace,) = drive(text.replace("ego is car", "ego is van"), duration=12.0)
    ego = trace.agents["ego"]
    assert np.abs(ego.heading).max() < 0.05
    assert ego.station[-1] > 150.0
