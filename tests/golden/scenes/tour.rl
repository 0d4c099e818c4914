# Agents on roads that are selected from a network, and beside routes in it.
scenario tour "Tour"

image plan from """
  ....#......
  ....#......
  ###########
  ....#...#..
  ....#...#..
  ....#####..
""" { scale: 14m/px, legend: { "#": road } }
network town from plan {
  lanes: 4
  sidewalks: 1.8m
  speed_limit: 45km/h
  control with yield
}
road tour from town { select: route((10m, 49m), (70m, 80m)) }
road back from town { select: route((147m, 49m), (60m, 5m)) }
road copy from tour { perturb with bump { at: 60m, height: 0.5m, length: 20m } }
road short from town { select: road(1) }

agent ego is car on tour at 10m { lane: -1, drive with traffic }
agent follower is car on tour at 1m { lane: -2, drive with traffic { aggression: 0.9 } }
agent other is van on back at 20m { drive with traffic { politeness: 0.1 } }
agent contrary is car on tour at 90% { facing: back, drive with lane_follow { speed: 8m/s } }
agent changer is car on town { route: [(20m, 45m), (100m, 20m)], lane: outer, drive with traffic }
agent free is car on town at (62m, 25m) { drive with stanley { speed: 9m/s } }
agent guests is choice(car, motorcycle) on town at random { count: 4, apart: 3m, route_length: 120m, drive with traffic }
agent walker is pedestrian on town at (100m, 49m) { side: right, offset: 0.5m, drive with crossing { when: time > 1s } }
agent stroller is pedestrian on town at (30m, 49m) { side: left, offset: 0.5m, drive with walk }
object blocked is parked_car on town at (62m, 70m) { lane: outer }

expect safe: always (ego.contacts == 0)
expect far: eventually (ego.route_progress > 40m)
expect within: always (changer.off_road < 0.1m)
simulate with builtin { duration: 12s, step: 0.3s, control_step: 0.1s }
