"""Statements that habits of users are written next to."""

from __future__ import annotations

ROAD = (
    "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] }, lanes: 2 }\n"
)
EGO = "agent ego is car on main at 5m { drive with pure_pursuit { speed: 12m/s } }\n"
LEAD = "agent lead is car on main at 25m { drive with lane_follow { speed: 9m/s } }\n"
PLAN = 'image plan from "town.png" { scale: 1m/px }\n'
BARE = "road other { draw with waypoints { points: [(0m, 0m), (80m, 20m)] }"
BENT = "road bent from main { perturb with bump { at: 50m, height: 1m, length: 9m } }"
GENTLE = "(curvature(main) < 1/m)"
