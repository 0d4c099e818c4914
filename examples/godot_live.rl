# A scene to edit while a car drives in it: save this file, or drag its points and objects.
#   roadlang watch examples/godot_live.rl --save
scenario godot_live "A scene to edit while a car drives"

road loop {
  draw with waypoints {
    points: [(0m, 0m), (70m, -6m), (130m, 20m), (140m, 80m), (80m, 110m), (20m, 90m), (-20m, 40m)]
  }
  closed: true
  width: 8m
}

object oak is tree at (60m, 45m)
object house is building at (85m, 60m) { heading: 20deg }

agent ego is car on loop at 5m { drive with pure_pursuit { speed: 9m/s, lookahead: 6m } }

expect in_lane: always (abs(ego.cross_track_error) < 1m)

simulate with godot { duration: 60s }
emit json
