# A closed track read from CSV, with several perturbations, the last one on an interval.
scenario composed "A race track: swayed, roughened, flattened in one section"

road main from "track.csv" { width: 12m, closed: true }
road bent from main {
  perturb with sine { amplitude: 0m..4m, wavelength: 80m..160m }
  perturb with random_walk { amplitude: normal(1m, 0.5m, within: [0m, 2m]), correlation: 30m }
  perturb with scale { factor: 0.7..1.4, over: [50m, 120m], taper: 15m }
}

let e1 = deviation(bent, main)
let calm = abs(curvature(bent)) < 1 / 12m and e1 < 9m       # a formula can have a name

require phi1: always calm
require clear: always (clearance(bent) > 2m)

emit json
emit svg
