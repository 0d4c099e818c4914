# A car on its own road. two_actors.rl includes this file twice, with different params.
param y = 0m
param speed = 40km/h

road lane {
  draw with waypoints { points: [(0m, y), (200m, y)] }
  width: 4m
  lanes: 1
  speed_limit: 50km/h
}
agent driver is car on lane at 10m { drive with lane_follow { speed: speed } }
