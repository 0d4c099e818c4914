"""Random scenes on bends: a car alone that may be too fast, and one in traffic that may brake too
late."""

from __future__ import annotations

from collections.abc import Iterator

from roadlang import testing
from roadlang.api import Scene

BENDS = """
road main {
  draw with segments {
    pieces: [
      straight(40m..80m), arc(25m..70m, 40deg..100deg), straight(20m..60m),
      arc(25m..70m, -100deg..-40deg), straight(20m..60m), arc(25m..70m, 40deg..90deg),
      straight(60m..100m)
    ]
  }
  lanes: 2
  width: 7.4m
}
"""

ALONE = (
    BENDS
    + """
param speed = 11m/s..19m/s
agent ego is car on main at 6m {
  lane: -1, start_speed: speed
  drive with KEEPER { speed: speed, lateral_acceleration: 30m/s^2 }
}
world { friction: 0.55..1.0 }
"""
)

TRAFFIC = (
    BENDS
    + """
param speed = 9m/s..14m/s
agent lead is car on main at 44m {
  lane: -1, start_speed: speed
  drive with traffic { speed: speed }
  drive with brake { deceleration: 3m/s^2..8m/s^2, when: lead.route_progress > 50m..120m }
}
agent ego is car on main at START {
  lane: -1, start_speed: speed
  drive with KEEPER { speed: speed, lateral_acceleration: 30m/s^2 }
  drive with brake { deceleration: 4m/s^2..9m/s^2, when: lead.speed < 3m/s..7m/s }
}
agent oncoming is van on main at 200m { lane: 1, facing: back, drive with traffic { speed: 9m/s } }
world { friction: 0.3..0.9 }
"""
)

KEEPERS = ("lane_follow", "stanley", "pure_pursuit")
GAPS = ("14m", "22m", "30m")
"""Where the car behind the other begins."""


def random_scenes(count: int, first: int = 0) -> Iterator[Scene]:
    """Scenes in turn alone and in traffic; the same numbers give the same scenes."""
    for number in range(first, first + count):
        keeper = KEEPERS[number // 2 % len(KEEPERS)]
        text = TRAFFIC if number % 2 else ALONE
        text = text.replace("KEEPER", keeper).replace("START", GAPS[number // 2 % len(GAPS)])
        yield testing.sample(text, 1, seed=number)[0].record
