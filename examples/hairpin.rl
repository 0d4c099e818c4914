# The example of the paper: a bend in an aerial photo, perturbed within the paper's three
# specifications, and a car that must stay in its lane. Compile 8 scenes of it:
#   roadlang compile examples/hairpin.rl -o out -n 8
scenario hairpin "A bend from an aerial photo, bent further"

param reach = 8m                                    # command line: --set reach=12m

image photo from "hairpin.jpg" { scale: 0.5m/px }
network town from photo                             # extract with auto
road main from town { select: longest, width: 7m, lanes: 2 }
road bent from main {
  perturb with sine { amplitude: 0m..reach, wavelength: 60m..200m, phase: 0deg..360deg }
}

let e1 = deviation(bent, main)                      # the error added along the spline
let d1 = distance(bent, main)                       # between the splines, point by point

require phi1: always (e1 < 10m)
require phi2: always (d1 < 10m)
require phi3: always (e1 > 6m implies eventually[20m, 60m] always[0m, 15m] (d1 < 6m and e1 < 6m))
require drivable: always (abs(curvature(bent)) < 0.1/m)
require near: lp_distance(bent, main, 2) < 90m^1.5

agent ego is car on bent at 5m { drive with pure_pursuit { speed: 12m/s, lookahead: 6m } }

expect in_lane: always (abs(ego.cross_track_error) < 1.5m)    # judged when the scene is driven
expect arrives: eventually[0s, 90s] (ego.progress > 95%)

emit json
emit svg { size: 1024px }
