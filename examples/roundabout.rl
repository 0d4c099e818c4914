# Ten cars at a roundabout drawn with a mouse: vehicles in the ring have priority.
scenario roundabout "Traffic at a drawn roundabout"

image sketch from "roundabout.png" {
  scale: 1m/px
  legend: { "white": road, "#2e7d32": tree, "#b71c1c": building }
}
network town from sketch {
  extract with pixels
  lanes: 2
  speed_limit: 40km/h
}

agent ego is car on town { route: [(4m, 88m), (236m, 110m)], drive with traffic }
agent cars is choice(car, van, weights: [3, 1]) on town at random {
  count: 9
  apart: 8m
  drive with traffic { speed_factor: 0.85..1.1 }
}

expect untouched: always (ego.contacts == 0 and cars.contacts == 0)
expect through: eventually (ego.route_progress > 200m)
expect slows: eventually (ego.speed < 30km/h)
expect on_road: always (ego.off_road < 0m)

simulate with builtin { duration: 60s }

emit json
emit svg
