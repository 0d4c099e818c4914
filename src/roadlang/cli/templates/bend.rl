# A drawn road, bent at random within limits. Try: roadlang compile THIS_FILE -o out -n 4
scenario bend "A road, bent"

param reach = 6m                                    # command line: --set reach=9m

road main {
  draw with waypoints { points: [(0m, 0m), (80m, 10m), (160m, -10m), (240m, 30m)] }
  width: 7m
  lanes: 2
}
road bent from main {
  perturb with sine { amplitude: 0m..reach, wavelength: 80m..200m, phase: 0deg..360deg }
}

let e1 = deviation(bent, main)                      # how far the road was moved

require near: always (e1 < 5m)
require drivable: always (abs(curvature(bent)) < 0.1/m)

agent ego is car on bent at 10m { drive with pure_pursuit { speed: 12m/s, lookahead: 6m } }

expect in_lane: always (abs(ego.cross_track_error) < 1.5m)

emit json
emit svg
