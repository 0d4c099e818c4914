# A queue, oncoming traffic, a parked van, trees, and a pedestrian who steps out behind the van.
include "street.rl" { first_bend: 60m }

scenario traffic "Traffic on one street"

param gap = 10m..30m

agent ego is car on street at 20m { drive with pure_pursuit { speed: speed_limit } }
agent lead is car on street at ego.start + gap {
  drive with lane_follow { speed: 45km/h }
  drive with brake { deceleration: 4m/s^2..8m/s^2, when: time > 3s }
}
agent oncoming is choice(car, truck, weights: [3, 1]) on street at 80%..100% {
  lane: 1
  count: integer(0, 3)
  drive with lane_follow { speed: 40km/h }
}
agent walker is pedestrian on street at van.start + 4m {
  side: right
  offset: 1m
  drive with crossing { speed: 1.4m/s, when: distance(ego, walker) < 25m }
}
object van is parked_van on street at 90m { side: right, offset: 0.4m }
object trees is tree on street at 0%..100% { count: 40, side: left, offset: 2m..8m }
object kiosk is building at (40m, 32m) { heading: 30deg }

require apart: oncoming.start - ego.start > 60m

expect safe: always (distance(ego, walker) > 1m and distance(ego, lead) > 2m)
