# Every perturbation, on open and closed roads, over a part or the whole.
scenario bent "Bent"

road main {
  draw with waypoints { points: [(0m, 0m), (70m, 12m), (140m, -8m), (210m, 0m)] }
  width: 7m
}
road loop {
  draw with waypoints { points: [(0m, 60m), (80m, 70m), (90m, 130m), (5m, 120m)] }
  closed: true
  width: 8m
}
road waves from main {
  perturb with sine { amplitude: 1m..3m, wavelength: 60m..90m, phase: 30deg }
  perturb with harmonics { amplitude: 0.5m..1.5m, modes: 4 }
}
road walked from main { perturb with random_walk { amplitude: 2m, correlation: 25m..40m } }
road pushed from main {
  perturb with bump { at: 50m, height: -2m, length: 40m }
  perturb with shift { at: 120m, offset: 3m, length: 30m }
}
road scaled from main { perturb with scale { factor: 0.5, over: [40m, 160m], taper: 20m } }
road round from loop {
  perturb with sine { amplitude: 1.5m, wavelength: 50m }
  perturb with scale { factor: 1.1 }
  perturb with random_walk { amplitude: 0.8m, correlation: 20m, over: [30m, 90m], taper: 10m }
}
road rough from loop { perturb with harmonics { amplitude: 1m, modes: 3 } }

param limit = normal(4m, 1m, within: [3m, 5m])

let e1 = deviation(waves, main)
let apart = distance(walked, main)
require near: always (abs(e1) < limit)
require again: historically[0m, 30m] (e1 > -4m) or once (e1 > 1m)
require path: (abs(apart) < 3m) until[0m, 150m] (abs(apart) < 2m)
require clear: always (clearance(round) > 4m)
require back: (e1 < 5m) since (e1 < 4m)
expect rises: eventually (e1 > 0.5m implies always[0m, 20m] (e1 > -1m))
expect sup: sup_distance(pushed, main) < 4m
expect lp: lp_distance(scaled, main, 1) < 900m^2
expect curve: frechet(rough, loop) < 2m
expect sharp: always (abs(curvature(round)) < 0.2/m)

emit json
emit svg { ghost: false, size: 700px }
