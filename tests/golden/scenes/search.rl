# A car that is too fast for its bend, and one that brakes in front of it.
scenario search "Search"
param bump = 0m..1.5m
road main {
  draw with segments { pieces: [straight(40m), arc(25m, 80deg), straight(40m)] }
  lanes: 2
  width: 7m
}
road bent from main { perturb with sine { amplitude: bump, wavelength: 40m } }
require tight: always (abs(curvature(bent)) < 0.09/m)
agent ego is car on bent at 5m {
  drive with pure_pursuit { speed: 7m/s..15m/s, lookahead: 5m, lateral_acceleration: 9m/s^2 }
}
agent lead is choice(car, van) on bent at 30m..40m {
  drive with lane_follow { speed: 6m/s..9m/s }
  drive with brake { deceleration: 3m/s^2..7m/s^2, speed: 2m/s..7m/s, when: time > 2s }
}
expect in_lane: always (abs(ego.cross_track_error) < 1m)
expect apart: always (gap(ego, lead) > 0.5m)
simulate with builtin { duration: 6s, step: 0.2s, control_step: 0.1s }
falsify with cma { expects: [in_lane, apart], random: 10% }
