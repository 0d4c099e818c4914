# Two perturbed versions of one road that stay near each other, but are not the same.
scenario two_versions "Two versions of one road, close to each other"

image photo from "hairpin.jpg" { scale: 0.5m/px }
network town from photo
road main from town { select: longest, width: 7m }

param amplitude = 0m..8m

road left from main { perturb with sine { amplitude: amplitude, wavelength: 60m..200m } }
road right from main { perturb with sine { amplitude: fresh(amplitude), wavelength: 60m..200m } }

let d1 = distance(left, right)

require phi2: always (d1 < 10m)
require differ: eventually (d1 > 2m)
require near: sup_distance(left, right) < 10m and lp_distance(left, right, 1) < 900m^2

emit json
emit svg
