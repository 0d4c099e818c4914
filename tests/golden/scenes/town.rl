# A typed town: junctions, selected roads, a network that is bent, routes, all four kinds of stop.
scenario town "Town"

image plan from """
  ..#########..
  ..#..T.T.#BB.
  ..#......#BB.
  ###########..
  ..#.TTT..#...
  ..#......####
""" {
  scale: 9m/px
  legend: { "#": road, "T": tree, "B": building }
}
network town from plan {
  lanes: 2
  speed_limit: 40km/h
  control with yield { junctions: [0, 3] }
  control with stop { junctions: [2] }
}
network bent from town {
  perturb with random_walk { amplitude: 0.3m..1m, correlation: 20m..40m, roads: [1, 2, 5] }
}
road tour from town { select: route((20m, 5m), (85m, 50m)) }
road first from town { select: road(2) }
road largest from bent { select: longest }
road chance from town { select: any }

agent ego is car on town {
  route: [(30m, 22m), (85m, 40m)]
  drive with traffic
}
agent other is van on town at random {
  count: 2
  apart: 5m
  route_length: 80m
  drive with traffic { speed_factor: 0.9 }
}

let off = deviation(bent, town)
require near: always (abs(off) < 2m)
expect sure: confidence(town) > 0.5
expect size: length(largest) < length(tour)
expect bends: always (abs(curvature(bent)) < 0.5/m)
expect safe: always (ego.contacts == 0)
expect far: eventually (ego.route_progress > 40m)

simulate with builtin { duration: 9s, step: 0.3s, control_step: 0.1s }
emit json
emit svg
