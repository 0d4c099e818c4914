# A road taken from a picture beside this file, then bent. Put your own picture and scale here.
scenario picture "A road from a picture, bent"

image photo from "photo.png" { scale: 0.35m/px }    # meters per pixel
network town from photo
road main from town { select: longest, lanes: 2 }
road bent from main {
  perturb with sine { amplitude: 0m..8m, wavelength: 60m..200m, phase: 0deg..360deg }
}

require near: always (deviation(bent, main) < 10m)
require drivable: always (abs(curvature(bent)) < 0.1/m)

agent ego is car on bent at 5m { drive with pure_pursuit { speed: 12m/s, lookahead: 6m } }

emit json
emit svg
