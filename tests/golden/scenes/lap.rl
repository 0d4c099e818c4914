# Cars that drive round a closed road, past where it begins; traffic on a road of its own.
scenario lap "Lap"

road ring {
  draw with waypoints { points: [(0m, 0m), (60m, -5m), (70m, 45m), (5m, 50m)] }
  closed: true
  oneway: true
  lanes: 2
  width: 7m
  speed_limit: 50km/h
}
road track { draw with waypoints { points: [(0m, 100m), (40m, 95m), (45m, 135m), (0m, 140m)] }, closed: true, lanes: 2 }

agent first is car on ring at 190m { lane: -1, drive with car_follow { speed: 12m/s } }
agent second is car on ring at 175m { lane: -1, drive with car_follow { speed: 14m/s } }
agent slow is truck on ring at 10m { lane: -1, drive with lane_follow { speed: 4m/s } }
agent passer is van on ring at 160m { lane: -2, drive with traffic { speed_factor: 1.1 } }
agent opposite is car on track at 20m { facing: back, drive with pure_pursuit { speed: 7m/s } }
agent behind is car on track at 45m { facing: back, drive with traffic }
agent walker is pedestrian on ring at 100m { side: right, offset: 1m, drive with walk { along: edge } }
agent steerer is car on track at 100m { drive with stanley { speed: 8m/s, gain: 3/s } }

expect apart: always (gap(first, slow) > 1m)
expect headway: always (time_headway(second, first) > 0.4s)
expect round: eventually (first.route_progress > 60m)
expect within: always (passer.off_road < 0m)
simulate with builtin { duration: 14s, step: 0.25s, control_step: 0.1s }
