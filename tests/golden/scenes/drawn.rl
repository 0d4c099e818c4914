# Lanes, widths, markings, perturbations and places that are drawn, of roads open and closed.
scenario drawn "Drawn"

param lanes = integer(1, 4)
param side = choice(-1, 1)

road base {
  draw with waypoints { points: [(0m, 0m), (50m, 10m), (100m, -10m), (150m, 20m)] }
  lanes: lanes
  width: 4m..13m
}
road loop {
  draw with waypoints { points: [(0m, 200m), (60m, 190m), (70m, 245m), (5m, 250m)] }
  closed: true
  right: [drive(3m..4m), bike(1.2m..2m)]
  left: [drive(3m), choice(bike, parking, sidewalk)]
}
road moved from base {
  perturb with shift { at: 30m, offset: side * 2m, length: 25m }
  perturb with harmonics { amplitude: 0.5m..1m, modes: 3, over: [80m, 130m], taper: 10m }
}
road grown from loop { perturb with scale { factor: 0.9..1.2 }, perturb with random_walk { amplitude: 1m, correlation: 25m } }
road seam from loop { perturb with bump { at: 5m, height: 1m..3m, length: 30m, over: [0m, 60m], taper: 8m } }

let off = deviation(moved, base)
let gone = distance(grown, loop)
require near: always[10m, 140m] (abs(off) < 4m)
require soft: sup_distance(grown, loop) < 12m
require fits: frechet(seam, loop) < 5m and lp_distance(moved, base, p: 3) < 40m^(4/3)
expect some: eventually (gone > 0.5m)
expect bends: always (abs(curvature(moved)) < 0.2/m)

agent ego is choice(car, bus) on moved at 10%..30% { start_speed: choice(5m/s, 9m/s), drive with lane_follow { speed: 9m/s } }
agent others is car on grown at random { count: integer(0, 3), apart: 4m, drive with car_follow { speed: 8m/s } }
object things is choice(cone, rock, box) on seam at 20m..60m { count: 3, offset: -2m..2m, overlap: true }
object shed is building at (20m..40m, 60m) { heading: 0deg..90deg, width: 3m..5m, length: 6m }
require clear: others.start > 3m or ego.start > 20m
expect quick: always (ego.speed < 12m/s)
sample with random { attempts: 400 }
simulate with builtin { duration: 5s, step: 0.25s, control_step: 0.1s }
