# One agent of every kind on a street, for pictures.
#   roadlang render examples/pictures/vehicles.rl --view free -o vehicles.png
scenario vehicles "One of each kind"

param hour = 9.5h

road street {
  draw with segments { pieces: [straight(120m)] }
  left: [drive(3.5m), sidewalk(2m)]
  right: [drive(3.5m), parking(2.2m), sidewalk(2m)]
}

agent ego is car on street at 12m { lane: -1, drive with lane_follow { speed: 5m/s } }
agent van1 is van on street at 22m { lane: -1, drive with lane_follow { speed: 5m/s } }
agent truck1 is truck on street at 34m { lane: -1, drive with lane_follow { speed: 5m/s } }
agent bus1 is bus on street at 49m { lane: -1, drive with lane_follow { speed: 5m/s } }
agent tractor1 is tractor on street at 62m { lane: -1, drive with lane_follow { speed: 5m/s } }
agent scooter1 is scooter on street at 8m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent bicycle1 is bicycle on street at 13m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent motorcycle1 is motorcycle on street at 20m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent car1 is car on street at 27m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent taxi1 is taxi on street at 34m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent police1 is police_car on street at 42m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent ambulance1 is ambulance on street at 50m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent fire1 is fire_truck on street at 60m { lane: 1, drive with lane_follow { speed: 5m/s } }
agent walker is pedestrian on street at 16m {
  side: right
  offset: 1m
  drive with crossing { speed: 1.4m/s }
}
agent child1 is child on street at 18m {
  side: right
  offset: 1.2m
  drive with crossing { speed: 1.4m/s }
}
agent dog1 is dog on street at 21m {
  side: right
  offset: 1m
  drive with crossing { speed: 1.4m/s }
}

object houses is building on street at 5m..100m { count: 5, side: left, offset: 5m..8m }
object trees is tree on street at 5m..110m { count: 9, side: left, offset: 2m..14m, height: 6m..9m }
object lamps is lamp on street at 15m { count: 5, spacing: 20m, side: left, offset: 0.5m }
object stop is bus_stop on street at 26m { side: right, offset: 1.2m }
object limit is sign on street at 34m { side: right, offset: 0.5m }
object parked is choice(parked_car, parked_van) on street at 40m {
  lane: parking
  count: 4
  spacing: 9m
}

world { time_of_day: hour }
simulate with builtin { duration: 10s }
