# Every combination of some values, instead of random draws: roadlang compile THIS_FILE -o out
scenario sweep "Radius and speed"

param radius = choice(30m, 45m, 60m)
param speed = choice(8m/s, 12m/s)

road street {
  draw with segments { pieces: [straight(60m), arc(radius, 90deg), straight(60m)] }
  width: 7m
  lanes: 2
}

agent ego is car on street at 5m { drive with pure_pursuit { speed: speed, lookahead: 6m } }

expect in_lane: always (abs(ego.cross_track_error) < 1m)

sample with grid

emit json
emit svg
