# A queue, oncoming traffic, a parked van, trees, and a pedestrian who steps out behind the van.
include "street.rl" { first_bend: 60m }

scenario traffic "Traffic on one street"

agent ego is car on street at 30m..60m {
  drive with car_follow { speed: speed_limit }
  drive with brake {
    deceleration: 5m/s^2
    when: distance(ego, walker) < 22m and walker.speed > 0m/s
  }
}
agent queue is choice(car, van, weights: [3, 1]) on street at ego.start + (25m..40m) {
  count: integer(1, 3)
  spacing: 18m..28m
  start_speed: 40km/h
  drive with car_follow { speed: 40km/h }
}
agent oncoming is choice(car, truck, weights: [3, 1]) on street at random {
  facing: back
  count: integer(1, 3)
  apart: 12m
  drive with car_follow { speed: 40km/h }
}
agent walker is pedestrian on street at van.start + 6m {
  side: right
  offset: 1m
  drive with crossing { speed: 1.4m/s, when: distance(ego, walker) < 35m }
}
object van is parked_van on street at 215m { side: right, offset: 0.4m }
object trees is tree on street at random { count: 40, side: left, offset: 2m..8m }
object kiosk is building at (40m, 32m) { heading: 30deg }

expect calm: always (ego.contacts == 0 and queue.contacts == 0 and oncoming.contacts == 0)
expect safe: always (gap(ego, walker) > 1m and gap(ego, queue) > 2m)
expect flows: eventually[0s, 30s] (ego.progress > 60%)

simulate with builtin { duration: 40s }
