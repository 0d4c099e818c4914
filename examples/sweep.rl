# A parameter sweep: every combination of three radii, two speeds and four lookaheads.
#   roadlang compile examples/sweep.rl -o out -n 24
scenario sweep "Radius, speed and lookahead"

param radius = choice(30m, 45m, 60m)
param speed = choice(8m/s, 12m/s)                   # --set speed=12m/s fixes one
param lookahead = 4m..12m

road street {
  draw with segments { pieces: [straight(60m), arc(radius, 90deg), straight(60m)] }
  width: 7m
  lanes: 2
}

agent ego is car on street at 5m { drive with pure_pursuit { speed: speed, lookahead: lookahead } }
expect in_lane: always (abs(ego.cross_track_error) < 1m)

sample with grid { steps: 4 }                       # also: random, halton, guided

emit json
emit svg
