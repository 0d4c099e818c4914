# Places on roads that are one-way, closed, or bent, and on roads of a network.
scenario right_places "Places on roads"

image plan from """
  ######
  #....#
  ######
  ...#..
  ...#..
""" { scale: 14m/px, legend: { "#": road } }
network town from plan { lanes: 3 }
road tour from town { select: route((10m, 60m), (45m, 5m)) }
road bent from tour { perturb with sine { amplitude: 0m..2m, wavelength: 40m } }
road ring { draw with waypoints { points: [(120m, 0m), (180m, 0m), (180m, 60m), (120m, 60m)] }, closed: true, oneway: true, lanes: 2 }

agent ego is car on bent at 20% { lane: -1 }
agent back is car on bent at 70% { facing: back, lane: 1 }
agent row is van on bent at 10m { lane: -1, count: 2, spacing: 11m, facing: forward, overlap: true }
agent rings is car on ring at 90% { count: 4, spacing: 14m..20m, lane: outer }
agent beside_ring is bicycle on ring at beside(rings, left) { overlap: true }
agent sideways is animal on ring at 30m { heading: 70deg, offset: 2m }
object trees is tree on ring at random { count: 5, side: right, offset: 1m..3m, apart: 1m }
object bins is bin on ring at 170m { count: 3, spacing: 12m, side: left, offset: 0.4m }
object house is building at (90m, 90m) { heading: 10deg }
object sheds is building at (60m..100m, 120m) { count: 2, length: 4m, width: 3m, heading: 0deg..90deg }
object behind_house is bench at (90m, 99m)

require apart: distance(ego, back) > 10m
expect start: ego.start < 60m
expect gap_of_group: gap(rings, trees) > 0.2m
