"""`stop_at` and `speed_profile`: how fast, by where one is; `when:` and `while:` on them."""

from __future__ import annotations

import numpy as np
import pytest

from .driven_roads import drive, driven, straight


@pytest.mark.parametrize("deceleration", [2.0, 6.0])
def test_stopping_takes_the_distance_of_a_constant_deceleration(deceleration: float) -> None:
    ego = driven(
        straight(
            f"""start_speed: 20m/s
                drive with lane_follow {{ speed: 20m/s }}
                drive with stop_at {{ station: 200m, deceleration: {deceleration}m/s^2 }}"""
        ),
        duration=40,
    )
    assert ego.station[-1] == pytest.approx(200.0, abs=0.2)
    assert ego.speed[-1] == 0.0
    begins = ego.station[ego.speed < 19.5][0]
    assert 200.0 - begins == pytest.approx(19.5**2 / (2 * deceleration), rel=0.05)
    braking = ego.acceleration[(ego.speed < 18) & (ego.speed > 2)]
    assert braking == pytest.approx(np.full(len(braking), -deceleration), rel=0.1)


def test_a_distance_counts_from_where_the_controller_took_over() -> None:
    ego = driven(
        straight(
            """start_speed: 10m/s
               drive with lane_follow { speed: 10m/s }
               drive with stop_at { distance: 50m, when: ego.station > 100m }"""
        ),
        duration=40,
    )
    assert ego.station[-1] == pytest.approx(150.5, abs=0.5)


def test_who_comes_the_other_way_stops_at_the_same_station() -> None:
    text = """
    road main { draw with segments { pieces: [straight(300m)] }, lanes: 2, width: 7m }
    agent ego is car on main at 250m {
      lane: 1, start_speed: 15m/s
      drive with lane_follow { speed: 15m/s }
      drive with stop_at { station: 100m }
    }
    """
    assert driven(text, duration=40).station[-1] == pytest.approx(100.0, abs=0.2)


def test_while_lets_it_go_on() -> None:
    ego = driven(
        straight(
            """start_speed: 10m/s
               drive with lane_follow { speed: 10m/s }
               drive with stop_at { station: 60m, while: time < 20s }"""
        ),
        duration=40,
    )
    assert ego.speed[(ego.time > 15) & (ego.time < 20)].max() == 0.0
    assert ego.speed[-1] == pytest.approx(10.0, abs=0.2)


def test_a_profile_is_met_at_its_points_with_constant_acceleration_between() -> None:
    ego = driven(
        straight(
            """start_speed: 50km/h
               drive with lane_follow { speed: 90km/h }
               drive with speed_profile {
                 points: [(180m, 36km/h), (0m, 50km/h), (80m, 20km/h), (230m, 0km/h)]
               }"""
        ),
        duration=60,
    )
    gone = ego.station - ego.station[0]
    for distance, speed in ((0.0, 50 / 3.6), (80.0, 20 / 3.6), (180.0, 10.0)):
        assert np.interp(distance, gone, ego.speed) == pytest.approx(speed, abs=0.35)
    assert gone[-1] == pytest.approx(230.0, abs=0.5)
    first = ego.acceleration[(gone > 10) & (gone < 70)]
    by_hand = ((20 / 3.6) ** 2 - (50 / 3.6) ** 2) / (2 * 80)
    assert first == pytest.approx(np.full(len(first), by_hand), abs=0.15)


def test_profiles_that_are_drawn_drive_the_same_alone_and_together() -> None:
    text = straight(
        """drive with lane_follow { speed: 10m/s }
           drive with speed_profile { points: [(0m, (5m/s)..(15m/s)), (100m, (5m/s)..(15m/s))] }"""
    )
    many = [one.agents["ego"] for one in drive(text, 4, duration=15)]
    (alone,) = drive(text, 1, duration=15)
    assert alone.agents["ego"].speed.tobytes() == many[0].speed.tobytes()
    assert len({float(one.speed[-1]) for one in many}) == 4
