# Guided sampling of roads that bend without touching themselves.
scenario guided "Guided"
road main { draw with waypoints { points: [(0m, 0m), (60m, 10m), (120m, 0m)] } width: 6m }
road bent from main {
  perturb with sine { amplitude: 0m..8m, wavelength: 30m..80m }
  perturb with bump { at: 60m, height: -6m..6m, length: 50m }
}
let e = deviation(bent, main)
require near: always (abs(e) < 5m)
require bends: eventually (e > 3m)
require tight: always (abs(curvature(bent)) < 0.06/m)
sample with guided { pilot: 2000 }
emit json
