# A scene to be driven by actions: a rival that slows down, oncoming traffic, a barrier.
scenario rival "Rival"
road main {
  draw with waypoints { points: [(0m, 0m), (60m, 0m), (120m, 25m), (180m, 25m)] }
  width: 8m
  lanes: 2
  speed_limit: 50km/h
}
road bent from main { perturb with sine { amplitude: -2m..2m, wavelength: 80m..120m } }
agent ego is car on bent at 5m { lane: -1 }
agent rival is car on bent at 22m {
  lane: -1
  drive with stanley { speed: 5m/s..8m/s }
}
agent oncoming is car on bent at 150m { lane: 1, facing: back, drive with stanley { speed: 9m/s } }
object box is barrier on bent at 90m..120m { offset: -2m..-1m }
expect in_lane: always (abs(ego.cross_track_error) < 2m)
expect calm: always (abs(ego.lateral_acceleration) < 3m/s^2 and abs(ego.jerk) < 5m/s^3)
