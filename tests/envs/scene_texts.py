"""Scene files that environments are tested on."""

from __future__ import annotations

ROAD = """
road main {
  draw with waypoints { points: [(0m, 0m), (60m, 0m), (120m, 25m), (180m, 25m)] }
  width: 8m, lanes: 2
}
road bent from main { perturb with sine { amplitude: -3m..3m, wavelength: 80m..120m } }
"""
ALONE = f"""{ROAD}
agent ego is car on bent at 5m {{ lane: -1 }}
expect in_lane: always (abs(ego.cross_track_error) < 2m)
"""
CUT_IN = f"""{ALONE}
agent rival is car on bent at 20m {{
  lane: -1
  drive with stanley {{ speed: 5m/s..8m/s }}
  drive with brake {{ deceleration: 3m/s^2, when: gap(ego, rival) < 8m }}
}}
"""
FOLLOWED = f"""{ALONE}
agent lead is car on bent at 25m {{ lane: -1, drive with car_follow {{ speed: 6m/s..9m/s }} }}
agent oncoming is car on bent at 150m {{
  lane: 1, facing: back, drive with stanley {{ speed: 9m/s }}
}}
expect calm: always (abs(ego.lateral_acceleration) < 3m/s^2 and abs(ego.jerk) < 5m/s^3)
object box is barrier on bent at 90m..120m {{ offset: -2m..-1m }}
"""
STRAIGHT = """
road main { draw with waypoints { points: [(0m, 0m), (300m, 0m)] }, width: 8m, lanes: 1 }
agent ego is car on main at 5m
"""
