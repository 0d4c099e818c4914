# A street, driven with physics in Godot: queue, oncoming traffic, parked van, pedestrian.
#   roadlang run examples/godot_street.rl
#   roadlang render examples/godot_street.rl -o street.png --at 6
scenario godot_street "A tree-lined street at a quarter past nine"

param limit = 40km/h

road street {
  draw with segments {
    pieces: [
      straight(90m),
      clothoid(25m, to: 0.018/m),
      arc(55m, 60deg),
      straight(60m),
      arc(45m, -70deg),
      straight(120m)
    ]
  }
  width: 7.5m
}

agent ego is car on street at 10m { lane: -1, drive with car_follow { speed: limit } }
agent lead is van on street at 35m {
  lane: -1
  drive with lane_follow { speed: 30km/h }
}
agent oncoming is choice(car, truck) on street at 60%..90% {
  lane: 1
  count: 2
  drive with lane_follow { speed: limit }
}
agent walker is pedestrian on street at 150m {
  side: right
  offset: 1.2m
  drive with crossing { speed: 1.4m/s, when: distance(ego, walker) < 20m }
}

object parked is parked_van on street at 66m { side: right, offset: 0.5m }
object left_trees is tree on street at 0%..100% { count: 45, side: left, offset: 3m..16m }
object right_trees is tree on street at 0%..100% { count: 40, side: right, offset: 4m..18m }
object houses is building on street at 5%..95% { count: 9, side: left, offset: 14m..22m }

world { time_of_day: 9.25h, weather: clear, friction: 0.85 }

expect in_lane: always (abs(ego.cross_track_error) < 1m)
expect safe: always (gap(ego, lead) > 1m)
expect arrives: eventually[0s, 90s] (ego.progress > 90%)

simulate with godot { duration: 90s, step: 20ms }
emit json
