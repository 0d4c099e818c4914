# A road that bends differently in each scene.
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m), (240m, 40m), (340m, 0m)] }
  width: 8m
  lanes: 2
}
road bent from main {
  perturb with sine {
    amplitude: -6m..6m
    wavelength: 90m..150m
    phase: 0deg..360deg
    over: [20m, 340m]
    taper: 30m
  }
  perturb with sine {
    amplitude: -3m..3m
    wavelength: 55m..90m
    phase: 0deg..360deg
    over: [20m, 340m]
    taper: 30m
  }
}
require drivable: always (abs(curvature(bent)) < 1 / 18m)
